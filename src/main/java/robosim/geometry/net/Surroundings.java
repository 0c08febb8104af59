package robosim.geometry.net;

/** What the connections of one end share. */
record Surroundings(NetOptions options, Figures figures, Watchdog watchdog) {}
