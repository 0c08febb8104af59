package robosim.geometry.scenario;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import robosim.geometry.Geometry;
import robosim.geometry.check.Checks;
import robosim.geometry.net.Session;
import robosim.geometry.net.SessionListener;
import robosim.geometry.net.SessionOptions;
import robosim.geometry.protocol.BatchAnswerBundle;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.DistanceBundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.StepBundle;
import robosim.geometry.protocol.batch.BatchAnswer;
import robosim.geometry.protocol.batch.FreeAnswer;
import robosim.geometry.protocol.batch.MeasureRequest;
import robosim.geometry.protocol.batch.PictureAnswer;
import robosim.geometry.protocol.batch.SenseAnswer;
import robosim.geometry.protocol.batch.TickAnswer;
import robosim.geometry.scenario.recording.QuietLog;

/**
 * Replays a conversation without sockets and compares the answers bit for bit. Players, watchers and sweeps do it step
 * by step; {@link #of} does it at once.
 */
public final class Replay {
    private final Session session;
    private @Nullable Reply reply;
    private long steps;
    private long compared;
    private long unanswered;
    private long mismatches;

    /** A replay with the options of a scenario's header. */
    public Replay(SessionOptions options) {
        this(options, SessionListener.NONE);
    }

    /** A replay with a listener, such as a {@link Recorder}. */
    public Replay(SessionOptions options, SessionListener listener) {
        this.session = new Session(options, listener, "replay", new QuietLog());
    }

    /**
     * A replay that begins with an existing world.
     *
     * @param world belongs to the replay from now on
     */
    public Replay(Geometry world, SessionOptions options, SessionListener listener) {
        this.session = new Session(world, options, listener, "replay", new QuietLog());
    }

    /** Replays a scenario and returns what differs from its expected answers; empty if nothing does. */
    public static List<Mismatch> of(Scenario scenario) {
        Replay replay = new Replay(Checks.present("scenario", scenario).header().options());
        List<Mismatch> found = new ArrayList<>();
        for (Step step : scenario.steps()) {
            Mismatch mismatch = replay.step(step);
            if (mismatch != null) {
                found.add(mismatch);
            }
        }
        return found;
    }

    /**
     * Replays the remaining steps of a scenario while reading them.
     *
     * @param found called with each mismatch
     * @return the replay at its end
     * @throws ScenarioException if the file turns out not to be a scenario; it has been replayed up to there
     */
    public static Replay of(ScenarioReader scenario, Consumer<Mismatch> found) throws ScenarioException {
        Checks.present("found", found);
        Replay replay = new Replay(Checks.present("scenario", scenario).header().options());
        for (Step step = scenario.next(); step != null; step = scenario.next()) {
            Mismatch mismatch = replay.step(step);
            if (mismatch != null) {
                found.accept(mismatch);
            }
        }
        return replay;
    }

    /**
     * Carries out the next step.
     *
     * @return null if the answer is as expected, or none is expected. A request in which the module itself fails is
     *     always a mismatch
     */
    public @Nullable Mismatch step(Step step) {
        Checks.present("step", step);
        steps++;
        reply = null;
        Mismatch mismatch;
        try {
            reply = session.reply(step.request());
            mismatch = Mismatch.of(steps, step, reply);
        } catch (RuntimeException | StackOverflowError e) {
            mismatch = Mismatch.whole(steps, step, "an answer", "a failure of the module itself: " + e);
        }
        unanswered += step.expected() == null && !(step.request() instanceof InitBundle) ? 1 : 0;
        compared += step.expected() == null || reply == null ? 0 : answers(step.request(), step.expected());
        mismatches += mismatch == null ? 0 : 1;
        return mismatch;
    }

    /** The number of answers in a reply, as {@link #compared} counts them. */
    private static long answers(Bundle request, Reply expected) {
        if (request instanceof MoveBundle moves) {
            return moves.moves().size(); // of a refused one it is compared that it was refused
        }
        if (expected.bundle() instanceof BatchAnswerBundle batch) {
            return batch.answers().stream().mapToLong(Replay::answers).sum();
        }
        if (expected.bundle() instanceof StepBundle.Answer step) {
            return (long) step.bodies().size()
                    + step.contacts().size()
                    + step.stopped().size();
        }
        return ((DistanceBundle) expected.bundle()).distances().size();
    }

    private static long answers(BatchAnswer answer) {
        if (answer instanceof SenseAnswer sense) {
            return sense.distances().size();
        }
        if (answer instanceof FreeAnswer free) {
            return free.count();
        }
        if (answer instanceof MeasureRequest.Answer measure) {
            return measure.numbers().size();
        }
        if (answer instanceof TickAnswer tick) {
            return (long) tick.touches().size()
                    + tick.distances().size()
                    + tick.singles().size();
        }
        return answer instanceof PictureAnswer picture ? (long) picture.width() * picture.height() : 1;
    }

    /** The answer to the last step; null if it has none. */
    public @Nullable Reply reply() {
        return reply;
    }

    /** The number of steps carried out. */
    public long steps() {
        return steps;
    }

    /**
     * The number of answers that were compared with expected ones: moves, distances, the beams, poses, edges and pixels of
     * batches, their answers about the world, and the bodies, contacts and stopped bodies after steps.
     */
    public long compared() {
        return compared;
    }

    /** The number of requests, other than those for a new world, without an expected answer, which were not compared. */
    public long unanswered() {
        return unanswered;
    }

    /** The number of steps whose answers differed. */
    public long mismatches() {
        return mismatches;
    }
}
