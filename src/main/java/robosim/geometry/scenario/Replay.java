package robosim.geometry.scenario;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import robosim.geometry.Geometry;
import robosim.geometry.exact.Checks;
import robosim.geometry.net.Session;
import robosim.geometry.net.SessionListener;
import robosim.geometry.net.SessionOptions;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.SonarRequestBundle;

/**
 * Carries out a conversation anew, without sockets, and compares the answers bit for bit. Whoever plays, watches or varies
 * a scenario does it step by step; {@link #of} does it at once.
 */
public final class Replay {
    private final Session session;
    private @Nullable Reply reply;
    private long steps;
    private long compared;
    private long mismatches;

    /** With the options that a scenario's header tells. */
    public Replay(SessionOptions options) {
        this(options, SessionListener.NONE);
    }

    /** With somebody who sees what the session does, such as a {@link Recorder}. */
    public Replay(SessionOptions options, SessionListener listener) {
        this.session = new Session(options, listener, "replay", new QuietLog());
    }

    /**
     * In a world that is there already, until an init comes.
     *
     * @param world the replay's own from now on
     */
    public Replay(Geometry world, SessionOptions options, SessionListener listener) {
        this.session = new Session(world, options, listener, "replay", new QuietLog());
    }

    /** Replays a scenario and answers what is other than it expects; empty is good. */
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
     * Replays what is left of a scenario, reading as it goes.
     *
     * @param found told each mismatch
     * @return the replay at its end
     * @throws ScenarioException where the file turns out to be no scenario; it has been replayed up to there
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
     * @return null where the answer is the one expected, or none is expected. A request that the module fails at is a
     *     mismatch in any case
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
        compared += step.expected() == null ? 0 : requests(step.request());
        mismatches += mismatch == null ? 0 : 1;
        return mismatch;
    }

    /** How many questions a request asks. */
    private static long requests(Bundle request) {
        if (request instanceof MoveBundle moves) {
            return moves.moves().size();
        }
        return request instanceof SonarRequestBundle sonars ? sonars.requests().size() : 0;
    }

    /** The answer to the last step; null where it has none. */
    public @Nullable Reply reply() {
        return reply;
    }

    /** Steps that were carried out. */
    public long steps() {
        return steps;
    }

    /** Moves and distances that were compared with what was expected. */
    public long compared() {
        return compared;
    }

    /** Steps that were answered otherwise. */
    public long mismatches() {
        return mismatches;
    }
}
