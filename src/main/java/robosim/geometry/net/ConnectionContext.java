package robosim.geometry.net;

import robosim.geometry.net.pace.Room;
import robosim.geometry.net.pace.Turns;
import robosim.geometry.net.pace.Watchdog;
import robosim.geometry.net.pace.Worlds;
import robosim.geometry.net.session.LogBudget;

/** What all connections of one server or client share. */
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
