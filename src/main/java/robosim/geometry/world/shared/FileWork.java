package robosim.geometry.world.shared;

import java.io.IOException;
import java.io.InputStream;
import java.util.function.LongConsumer;
import org.jspecify.annotations.Nullable;
import robosim.geometry.image.PixelSink;

/**
 * Counts the work of reading files: a unit is about 64 bytes or 256 pixels, or an element, a line, a vertex, a face or an object.
 * A world is read by one thread, through many readers, so the counter belongs to the thread.
 */
public final class FileWork {
    private static final int BYTES = 64;

    /** So many pixels are looked at in about the time of a unit. */
    public static final int PIXELS = 256;

    private static final ThreadLocal<@Nullable LongConsumer> COUNTER = new ThreadLocal<>();

    private FileWork() {}

    /** Ends the reading of a file because its counter threw; no reader takes it for a mistake in the file. */
    static final class Ended extends RuntimeException {
        private static final long serialVersionUID = 1;

        private final transient RuntimeException reason;

        private Ended(RuntimeException reason) {
            super(reason.getMessage(), reason, false, false);
            this.reason = reason;
        }
    }

    /**
     * Reads something, and counts the work.
     *
     * @param counter is given units as they are done; what it throws ends the reading, and is thrown here
     */
    public static <T, E extends Exception> T counted(LongConsumer counter, RegularFile.Reading<T, E> reading) throws E {
        LongConsumer before = COUNTER.get();
        COUNTER.set(counter);
        try {
            return reading.read();
        } catch (Ended e) {
            throw e.reason;
        } finally {
            if (before == null) {
                COUNTER.remove();
            } else {
                COUNTER.set(before);
            }
        }
    }

    /** Counts units of work, if this thread reads within {@link #counted}. */
    public static void take(long units) {
        LongConsumer counter = COUNTER.get();
        if (counter == null) {
            return;
        }
        try {
            counter.accept(units);
        } catch (RuntimeException e) {
            throw new Ended(e);
        }
    }

    /** A stream whose bytes are counted, if this thread reads within {@link #counted}. */
    public static InputStream watched(InputStream in) {
        long[] bytes = {0};
        return COUNTER.get() == null
                ? in
                : new CountedStream(in, more -> {
                    long before = bytes[0] / BYTES;
                    bytes[0] += more;
                    take(bytes[0] / BYTES - before);
                });
    }

    /** A sink of pixels that are counted, if this thread reads within {@link #counted}. */
    static PixelSink watched(PixelSink sink) {
        return COUNTER.get() == null ? sink : new WatchedPixels(sink);
    }

    private record WatchedPixels(PixelSink sink) implements PixelSink {
        @Override
        public void begin(Format format) throws IOException {
            sink.begin(format);
        }

        @Override
        public void pixels(int row, int first, int step, int count, int[] samples) throws IOException {
            take(1 + count / PIXELS);
            sink.pixels(row, first, step, count, samples);
        }
    }
}
