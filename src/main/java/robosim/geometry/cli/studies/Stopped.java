package robosim.geometry.cli.studies;

import java.util.function.LongConsumer;

/** Says something when the process is ended by a signal, such as Ctrl-C, while this is open. */
final class Stopped implements AutoCloseable {
    private final Thread hook;
    private volatile long done;

    private Stopped(LongConsumer sentence) {
        hook = new Thread(() -> sentence.accept(done), "stopped");
    }

    /** Says a sentence about how much was done if the process ends before this is closed. */
    static Stopped tell(LongConsumer sentence) {
        Stopped stopped = new Stopped(sentence);
        Runtime.getRuntime().addShutdownHook(stopped.hook);
        return stopped;
    }

    /** Notes how much is done. */
    void at(long count) {
        done = count;
    }

    @Override
    public void close() {
        try {
            Runtime.getRuntime().removeShutdownHook(hook);
        } catch (IllegalStateException ending) {
            // The process is ending, and the sentence is being said.
        }
    }
}
