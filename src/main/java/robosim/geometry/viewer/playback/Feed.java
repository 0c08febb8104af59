package robosim.geometry.viewer.playback;

import java.io.IOException;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.Semaphore;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import robosim.geometry.scenario.ScenarioHeader;
import robosim.geometry.scenario.Step;
import robosim.geometry.scenario.source.StepReader;

/** Reads a conversation on a thread of its own. */
public final class Feed implements AutoCloseable {
    private static final int QUEUE = 2048;

    /** Maximum total weight of waiting frames; a single frame may have more. */
    private static final int ROOM = 1_000_000;

    private final StepReader reader;
    private final Colours colours;
    private final Supplier<String> state;
    private final BlockingQueue<Frame> queue = new ArrayBlockingQueue<>(QUEUE);
    private final Semaphore room = new Semaphore(ROOM);
    private final Thread thread;
    private volatile boolean ended;
    private volatile @Nullable String problem;

    /** Begins to read; closes the reader at its end. */
    public Feed(StepReader reader) {
        this(reader, Colours.NONE, () -> "");
    }

    /**
     * Begins to read; closes the reader at its end.
     *
     * @param colours the colours of a world file's objects
     * @param state what is currently wrong with the reader, as text for people; empty if nothing is
     */
    public Feed(StepReader reader, Colours colours, Supplier<String> state) {
        this.reader = reader;
        this.colours = colours;
        this.state = state;
        this.thread = new Thread(this::read, "viewer-feed");
        thread.setDaemon(true);
        thread.start();
    }

    private void read() {
        try (reader) {
            ScenarioHeader header = reader.header();
            Replayer stage = new Replayer(header.options(), colours);
            for (Step step = reader.next(); step != null; step = reader.next()) {
                if (!header.equals(reader.header())) { // another server, with other defaults
                    header = reader.header();
                    stage = new Replayer(header.options(), colours);
                }
                Frame frame = stage.play(step);
                room.acquire(room(frame));
                queue.put(frame);
            }
        } catch (IOException | RuntimeException e) {
            problem = String.valueOf(e.getMessage());
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        } finally {
            ended = true;
        }
    }

    private static int room(Frame frame) {
        return (int) Math.min(ROOM, frame.weight());
    }

    /**
     * Moves what was read so far to a history, at most the given number of messages; several may be one frame of it.
     *
     * @return the number of messages moved
     */
    public int drain(StateHistory film, int most) {
        int drained = 0;
        for (Frame frame = queue.poll(); frame != null; frame = queue.poll()) {
            room.release(room(frame));
            film.add(frame);
            drained++;
            if (drained == most) {
                break;
            }
        }
        return drained;
    }

    /** Whether nothing more will come. */
    public boolean isEnded() {
        return ended && queue.isEmpty();
    }

    /** Why reading ended or is interrupted; empty if nothing is wrong. */
    public String problem() {
        String end = problem;
        return end != null ? end : state.get();
    }

    /** Stops reading. */
    @Override
    public void close() {
        thread.interrupt();
        try {
            reader.close();
        } catch (IOException e) {
            problem = String.valueOf(e.getMessage());
        }
    }
}
