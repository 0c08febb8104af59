package robosim.geometry.scenario;

import java.io.IOException;
import java.util.concurrent.Callable;
import java.util.function.LongSupplier;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.check.Text;
import robosim.geometry.net.SessionListener;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.Reply;

/**
 * Records a session as it happens: each request before it is carried out, so that even a request that crashes the
 * module is in the file, and each answer before it is sent. If the process is killed, at most the message being written
 * is lost.
 *
 * <p>Recording never disturbs the session: if it cannot go on, because the disk is full or for any other reason, it
 * stops with a line in the log, and what has been written stays. It may be used by one thread at a time.
 */
final class Recorder implements SessionListener, AutoCloseable {
    private static final System.Logger LOG = System.getLogger(Recorder.class.getPackageName());

    private final String name;
    private final Callable<ScenarioWriter> opening;
    private final @Nullable LongSupplier nanoClock;
    private final long beginning;

    private @Nullable ScenarioWriter writer;
    private long askedAt;
    private boolean stopped;
    private boolean gaveUp;

    /**
     * A recorder that has not opened its recording yet.
     *
     * @param name      the session's name in the log
     * @param opening   opens the recording when the first request comes; called once, and the recorder closes the result
     * @param nanoClock a monotonic clock in nanoseconds, like {@link System#nanoTime}; null for a recording without
     *                  times
     */
    public Recorder(String name, Callable<ScenarioWriter> opening, @Nullable LongSupplier nanoClock) {
        this.name = Checks.present("name", name);
        this.opening = Checks.present("opening", opening);
        this.nanoClock = nanoClock;
        this.beginning = now();
    }

    private long now() {
        return nanoClock == null ? 0 : nanoClock.getAsLong();
    }

    @Override
    public void requested(Bundle request) {
        askedAt = now();
        record(to -> to.request(request));
    }

    @Override
    public void replied(Bundle request, @Nullable Reply reply, long nanoseconds) {
        record(to -> to.answer(reply, nanoClock == null ? null : timing(nanoseconds)));
    }

    private Timing timing(long took) {
        return new Timing(
                Math.max(0, Math.min(Timing.MOST, askedAt - beginning)), Math.max(0, Math.min(Timing.MOST, took)));
    }

    /** Writes a note for people before the next request. */
    public void note(String text) {
        Checks.present("text", text);
        record(to -> to.note(text));
    }

    /** Something that is written. */
    @FunctionalInterface
    private interface Writing {
        void write(ScenarioWriter to) throws IOException;
    }

    private void record(Writing writing) {
        if (stopped) {
            return;
        }
        try {
            if (writer == null) {
                writer = opening.call();
            }
            writing.write(writer);
        } catch (Exception | LinkageError | VirtualMachineError e) {
            LOG.log(
                    System.Logger.Level.WARNING,
                    name + ": recording stopped after " + bytes() + " bytes: " + Text.line(String.valueOf(e)));
            giveUp(Text.line(e.getMessage() == null ? e.toString() : e.getMessage()));
            close();
        }
    }

    private void giveUp(String reason) {
        gaveUp = true;
        try {
            if (writer != null) {
                writer.giveUp(reason);
            }
        } catch (IOException | RuntimeException | LinkageError | VirtualMachineError e) {
            LOG.log(System.Logger.Level.DEBUG, name + ": nor is there room to say so in its file", e);
        }
    }

    /** Marks the end, unless the session goes on without being recorded. */
    private void end(ScenarioWriter to) {
        if (gaveUp) {
            return;
        }
        try {
            to.end();
        } catch (IOException e) {
            LOG.log(
                    System.Logger.Level.WARNING,
                    name + ": the end of its recording could not be written: " + Text.line(String.valueOf(e)));
        }
    }

    /** Whether it is recording, or will when the first request comes. */
    public boolean isRecording() {
        return !stopped;
    }

    /** The number of bytes written. */
    public long bytes() {
        return writer == null ? 0 : writer.bytes();
    }

    @Override
    public void ended() {
        close();
    }

    /** Stops recording. Throws nothing. */
    @Override
    public void close() {
        if (stopped) {
            return;
        }
        stopped = true;
        try {
            if (writer != null) {
                end(writer);
                writer.close();
            }
        } catch (IOException | RuntimeException e) {
            LOG.log(
                    System.Logger.Level.WARNING,
                    name + ": its recording could not be closed: " + Text.line(String.valueOf(e)));
        }
    }
}
