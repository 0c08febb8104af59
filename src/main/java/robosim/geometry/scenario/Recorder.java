package robosim.geometry.scenario;

import java.io.IOException;
import java.util.function.LongSupplier;
import org.jspecify.annotations.Nullable;
import robosim.geometry.exact.Checks;
import robosim.geometry.net.SessionListener;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.Text;

/**
 * Writes down a session as it goes: each request before it is carried out, so that one that the module does not survive
 * stands in the file, and each answer before it is sent. Whoever kills the process loses at most the message under way.
 *
 * <p>Recording never harms the session: where it cannot go on, for want of room or any other reason, it stops with a line
 * in the log, and what has been written stays. It belongs to one thread at a time.
 */
public final class Recorder implements SessionListener, AutoCloseable {
    private static final System.Logger LOG = System.getLogger(Recorder.class.getPackageName());

    private final String name;
    private final Opening opening;
    private final @Nullable LongSupplier nanoClock;
    private final long beginning;

    private @Nullable ScenarioWriter writer;
    private long askedAt;
    private boolean stopped;

    /** Opens what is recorded into, when the first request comes. */
    @FunctionalInterface
    public interface Opening {
        /** Once; the recorder closes it. */
        ScenarioWriter open() throws IOException;
    }

    /**
     * Nothing is opened yet.
     *
     * @param name      of the session, in the log
     * @param nanoClock tells nanoseconds that only go on, as {@link System#nanoTime} does; null for a recording without
     *                  times
     */
    public Recorder(String name, Opening opening, @Nullable LongSupplier nanoClock) {
        this.name = Checks.present("name", name);
        this.opening = Checks.present("opening", opening);
        this.nanoClock = nanoClock;
        this.beginning = now();
    }

    private long now() {
        return nanoClock == null ? 0 : nanoClock.getAsLong();
    }

    @Override
    public void asked(Bundle request) {
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

    /** A note for people, before the next request. */
    public void note(String text) {
        Checks.present("text", text);
        record(to -> to.note(text));
    }

    /** Writes something. */
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
                writer = opening.open();
            }
            writing.write(writer);
        } catch (IOException | RuntimeException | LinkageError | VirtualMachineError e) {
            LOG.log(
                    System.Logger.Level.WARNING,
                    name + ": is no longer recorded, after " + bytes() + " bytes: " + Text.line(String.valueOf(e)));
            giveUp(Text.line(e.getMessage() == null ? e.toString() : e.getMessage()));
            close();
        }
    }

    private void giveUp(String reason) {
        try {
            if (writer != null) {
                writer.giveUp(reason);
            }
        } catch (IOException | RuntimeException | LinkageError | VirtualMachineError e) {
            LOG.log(System.Logger.Level.DEBUG, name + ": nor is there room to say so in its file", e);
        }
    }

    /** Whether it still records, or will when there is something. */
    public boolean isRecording() {
        return !stopped;
    }

    /** How many bytes have been written. */
    public long bytes() {
        return writer == null ? 0 : writer.bytes();
    }

    @Override
    public void ended() {
        close();
    }

    /** Records no more. Nothing is thrown. */
    @Override
    public void close() {
        if (stopped) {
            return;
        }
        stopped = true;
        try {
            if (writer != null) {
                writer.close();
            }
        } catch (IOException | RuntimeException e) {
            LOG.log(
                    System.Logger.Level.WARNING,
                    name + ": its recording could not be closed: " + Text.line(String.valueOf(e)));
        }
    }
}
