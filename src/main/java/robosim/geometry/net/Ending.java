package robosim.geometry.net;

import java.util.concurrent.TimeUnit;

/** The deadlines for closing a server or client, counted from the call. */
final class Ending {
    /** Requests already read are answered until then, and cut off afterwards. */
    static final long ANSWERS_NANOS = TimeUnit.MILLISECONDS.toNanos(1500);

    /** Peers that were cut off are told until then. */
    static final long WORDS_NANOS = TimeUnit.MILLISECONDS.toNanos(1650);

    /** Before the promised two seconds, as the process has to end as well, perhaps on a busy machine. */
    static final long ALL_NANOS = TimeUnit.MILLISECONDS.toNanos(1750);

    private Ending() {}
}
