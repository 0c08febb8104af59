package robosim.geometry.net;

/** What the connections of one end share. */
record ConnectionContext(
        NetOptions options, Figures figures, Watchdog watchdog, Turns turns, Room room, Worlds worlds, LogBudget log) {
    ConnectionContext(NetOptions options, Figures figures, Watchdog watchdog) {
        this(
                options,
                figures,
                watchdog,
                Turns.ofThisMachine(),
                Room.ofThisProcess(),
                Worlds.ofThisProcess(),
                new LogBudget(System::nanoTime));
    }
}
