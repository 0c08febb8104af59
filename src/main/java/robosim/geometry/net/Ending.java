package robosim.geometry.net;

import java.util.concurrent.TimeUnit;

/** How long an end takes to close, from the call on. */
final class Ending {
    /** What has been read is answered until then, and cut off afterwards. */
    static final long ANSWERS_NANOS = TimeUnit.MILLISECONDS.toNanos(1500);

    /** Whoever was cut off is told so until then. */
    static final long WORDS_NANOS = TimeUnit.MILLISECONDS.toNanos(1800);

    static final long ALL_NANOS = TimeUnit.SECONDS.toNanos(2);

    private Ending() {}
}
