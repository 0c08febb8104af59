package robosim.geometry.net;

import java.util.concurrent.TimeUnit;
import robosim.geometry.net.pace.CpuTurns;
import robosim.geometry.net.pace.MessageMemory;
import robosim.geometry.net.pace.Watchdog;
import robosim.geometry.net.pace.WorldMemory;
import robosim.geometry.net.session.LogBudget;
import robosim.geometry.net.session.SessionStart;

/** What all connections of one server or client share. */
record ConnectionContext(
        NetOptions options,
        Figures figures,
        Watchdog watchdog,
        CpuTurns turns,
        MessageMemory messageMemory,
        WorldMemory worldMemory,
        LogBudget log,
        SessionStart opening,
        KeptSessions kept) {
    // The deadlines for closing a server or client, counted from the call.

    /** Requests already read are answered until then, and cut off afterwards. */
    static final long ANSWERS_NANOS = TimeUnit.MILLISECONDS.toNanos(1500);

    /** Peers that were cut off are told until then. */
    static final long WORDS_NANOS = TimeUnit.MILLISECONDS.toNanos(1650);

    /** Before the promised two seconds, as the process has to end as well, perhaps on a busy machine. */
    static final long ALL_NANOS = TimeUnit.MILLISECONDS.toNanos(1750);

    ConnectionContext(NetOptions options, Figures figures, Watchdog watchdog) {
        this(
                options,
                figures,
                watchdog,
                CpuTurns.ofThisMachine(),
                MessageMemory.ofThisProcess(),
                WorldMemory.ofThisProcess(),
                new LogBudget(System::nanoTime),
                SessionStart.of(options.opening()),
                new KeptSessions(options.timeouts().resume(), watchdog));
    }

    /** The same for connections from now on, which need other keys or another secret. */
    ConnectionContext with(Access access) {
        return new ConnectionContext(
                options.withAccess(access), figures, watchdog, turns, messageMemory, worldMemory, log, opening, kept);
    }
}
