package robosim.geometry.viewer.playback;

import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.LongConsumer;
import org.jspecify.annotations.Nullable;
import robosim.geometry.Geometry;
import robosim.geometry.MoveResult;
import robosim.geometry.check.NumberText;
import robosim.geometry.check.Text;
import robosim.geometry.exact.Degrees;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.net.Session;
import robosim.geometry.net.SessionListener;
import robosim.geometry.net.SessionOptions;
import robosim.geometry.protocol.BatchAnswerBundle;
import robosim.geometry.protocol.BatchRequestBundle;
import robosim.geometry.protocol.Beam;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.DistanceBundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.MoveRequest;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.SonarRequest;
import robosim.geometry.protocol.SonarRequestBundle;
import robosim.geometry.protocol.StepBundle;
import robosim.geometry.protocol.batch.BatchAnswer;
import robosim.geometry.protocol.batch.BatchRequest;
import robosim.geometry.protocol.batch.SenseAnswer;
import robosim.geometry.protocol.batch.SenseRequest;
import robosim.geometry.protocol.batch.WorldRequest;
import robosim.geometry.protocol.motion.BodyAnswer;
import robosim.geometry.protocol.motion.ContactAnswer;
import robosim.geometry.scenario.Scenario;
import robosim.geometry.scenario.Step;
import robosim.geometry.scenario.recording.QuietLog;
import robosim.geometry.scenario.source.StepReader;
import robosim.geometry.viewer.scene.Scene;
import robosim.geometry.world.shared.ObjectNames;

/**
 * Replays a recorded conversation to find what the record does not contain: the places of the robots, and what blocked
 * them. If the two differ, as for a record by another version, the record is shown.
 */
public final class Replayer {
    private final SessionOptions options;
    private final Colours colours;
    private final Session session;
    private @Nullable MoveResult tried;

    public Replayer(SessionOptions options) {
        this(options, Colours.NONE);
    }

    /** A replayer with the colours of a world file's objects. */
    public Replayer(SessionOptions options, Colours colours) {
        this.options = options;
        this.colours = colours;
        SessionListener listener = new SessionListener() {
            @Override
            public void tried(MoveRequest request, MoveResult result) {
                tried = result;
            }
        };
        this.session = new Session(options, listener, "viewer", new QuietLog());
    }

    /** The history of a conversation, in the colours of a world file's objects. */
    public static StateHistory film(Scenario scenario, Colours colours) {
        StateHistory film = new StateHistory();
        Replayer stage = new Replayer(scenario.header().options(), colours);
        for (Step step : scenario.steps()) {
            film.add(stage.play(step));
        }
        return film;
    }

    /**
     * That of a recorded conversation, of which the oldest part may be dropped where it is very long.
     *
     * @param progress called with the number of steps so far
     */
    public static StateHistory film(StepReader conversation, Colours colours, LongConsumer progress)
            throws IOException {
        StateHistory film = new StateHistory();
        Replayer stage = new Replayer(conversation.header().options(), colours);
        for (Step step = conversation.next(); step != null; step = conversation.next()) {
            film.add(stage.play(step));
            progress.accept(film.size());
        }
        return film;
    }

    /** Carries out a step and returns what it changed. */
    public Frame play(Step step) {
        try {
            if (step.request() instanceof InitBundle init) {
                return open(step, init);
            }
            if (step.request() instanceof BatchRequestBundle batch) {
                return batch(step, batch);
            }
            if (step.request() instanceof StepBundle stepped) {
                return step(step, stepped);
            }
            return step.request() instanceof MoveBundle moves
                    ? move(step, moves.moves())
                    : measure(step, (SonarRequestBundle) step.request());
        } catch (RuntimeException | StackOverflowError e) { // the recording may be of exactly such a failure
            return frame(step, null, Map.of(), List.of(), Map.of(), "the module failed at this: " + e);
        }
    }

    private static Frame frame(
            Step step,
            Frame.@Nullable Setting opening,
            Map<String, Pose> placed,
            List<Frame.Bump> bumps,
            Map<String, List<Scene.Ping>> heard,
            String words) {
        return new Frame(opening, placed, bumps, heard, words, step.notes(), step.timing());
    }

    private Frame open(Step step, InitBundle init) {
        Geometry before = session.world();
        session.reply(init);
        Geometry world = session.world();
        if (world == null || world == before) {
            return frame(step, null, Map.of(), List.of(), Map.of(), "a world that cannot be");
        }
        Frame.Setting setting = Frame.Setting.of(world, colours);
        String words = "a new world of " + NumberText.count(setting.things().size(), "object");
        return frame(step, setting, Map.of(), List.of(), Map.of(), words);
    }

    /** Carries out what a batch changes, one item after the other, and shows what carried sensors measured. */
    private Frame batch(Step step, BatchRequestBundle batch) {
        Reply expected = step.expected();
        List<BatchAnswer> told = expected != null && expected.bundle() instanceof BatchAnswerBundle answers
                ? answers.answers()
                : List.of();
        Frame.Setting setting = null;
        Map<String, Pose> placed = new LinkedHashMap<>();
        Map<String, List<Scene.Ping>> heard = new LinkedHashMap<>();
        List<Frame.Bump> bumps = new ArrayList<>();
        for (int k = 0; k < batch.requests().size(); k++) {
            BatchRequest request = batch.requests().get(k);
            if (request instanceof SenseRequest sense && sense.isCarried()) {
                sense(sense, k < told.size() ? told.get(k) : answer(sense), heard);
            } else if (request instanceof WorldRequest about) {
                GeometryObject before = about.isAboutMover() ? mover(about.objectName()) : null;
                tried = null;
                answer(about);
                if (before != null && tried != null && !tried.allowed() && about instanceof WorldRequest.Go go) {
                    MoveRequest move = new MoveRequest(go.objectName(), go.x(), go.y(), go.z(), go.rx(), go.ry());
                    double heading = direction(before.pose(), move);
                    Pose aim = went(before.pose(), move);
                    bumps.add(new Frame.Bump(before, heading, tried, aim, Scene.Refusal.Kind.MOVE));
                }
                Geometry world = session.world();
                setting = about.isAboutObjects() && world != null ? Frame.Setting.of(world, colours) : setting;
                GeometryObject mover = about.isAboutMover() ? mover(about.objectName()) : null;
                if (mover != null) {
                    placed.put(about.objectName(), mover.pose());
                }
            }
        }
        boolean isSensing = batch.requests().stream().allMatch(SenseRequest.class::isInstance);
        String words = isSensing
                ? NumberText.count(batch.size(), "distance")
                : "a batch of " + NumberText.count(batch.size(), "item");
        return frame(step, setting, placed, bumps, heard, words);
    }

    private @Nullable BatchAnswer answer(BatchRequest request) {
        Reply reply = session.reply(new BatchRequestBundle(List.of(request)));
        return reply != null && reply.bundle() instanceof BatchAnswerBundle answers
                ? answers.answers().get(0)
                : null;
    }

    private void sense(SenseRequest request, @Nullable BatchAnswer answer, Map<String, List<Scene.Ping>> heard) {
        GeometryObject carrier = mover(request.objectName());
        if (carrier != null && answer instanceof SenseAnswer sensed) {
            heard.computeIfAbsent(request.objectName(), unseen -> new ArrayList<>())
                    .addAll(Lasers.of(carrier, request, sensed.distances()));
        }
    }

    private Frame move(Step step, List<MoveRequest> asked) {
        Reply expected = step.expected();
        List<MoveRequest> made = expected == null ? null : ((MoveBundle) expected.bundle()).moves();
        Map<String, Pose> placed = new LinkedHashMap<>();
        List<Frame.Bump> bumps = new ArrayList<>();
        int next = 0;
        for (MoveRequest request : asked) {
            GeometryObject mover = mover(request.objectName());
            boolean recorded =
                    made != null && next < made.size() && made.get(next).equals(request);
            next += recorded ? 1 : 0;
            if (mover == null) {
                continue;
            }
            tried = null;
            boolean allowed = isMade(session.answer(new MoveBundle(List.of(request))));
            boolean shown = made == null ? allowed : recorded;
            Pose went = went(mover.pose(), request);
            if (shown != allowed) {
                put(mover.at(shown ? went : mover.pose()));
            }
            if (shown) {
                placed.put(request.objectName(), present(request.objectName()).pose());
            } else {
                MoveResult result = tried != null && !tried.allowed() ? tried : null;
                bumps.add(
                        new Frame.Bump(mover, direction(mover.pose(), request), result, went, Scene.Refusal.Kind.MOVE));
            }
        }
        return frame(step, null, placed, bumps, Map.of(), moved(asked.size(), bumps));
    }

    private static boolean isMade(@Nullable Bundle answer) {
        return answer instanceof MoveBundle made && !made.moves().isEmpty();
    }

    /** Where a move leads, without checking for obstacles. */
    private static Pose went(Pose pose, MoveRequest move) {
        Point c = pose.center();
        Point place =
                new Point(c.x() + along(pose, 0, move), c.y() + along(pose, 3, move), c.z() + along(pose, 6, move));
        return pose.movedTo(place).turned(Degrees.toDegrees(move.rx()), Degrees.toDegrees(move.ry()));
    }

    private static double along(Pose pose, int row, MoveRequest move) {
        return pose.rotation(row) * move.x() + pose.rotation(row + 1) * move.y() + pose.rotation(row + 2) * move.z();
    }

    /** The direction of a move; for a pure turn, the heading. */
    private static double direction(Pose pose, MoveRequest move) {
        double dx = along(pose, 0, move);
        double dz = along(pose, 6, move);
        return dx == 0 && dz == 0 ? pose.heading() : degrees(dx, dz);
    }

    /** The heading of a direction in the world. */
    private static double degrees(double dx, double dz) {
        return StrictMath.toDegrees(StrictMath.atan2(0 - dz, dx));
    }

    /** Puts an object at its recorded place, even in contact. */
    private void put(GeometryObject object) {
        Geometry world = session.world();
        if (world != null && world.removeObject(String.valueOf(object.name()))) {
            world.addObjectUnchecked(object);
        }
    }

    /** Lets time pass, and then puts every body where the record says that it came to. Commands alone move nothing. */
    private Frame step(Step step, StepBundle asked) {
        Reply reply = session.reply(asked);
        Reply shown = step.expected() == null ? reply : step.expected();
        if (shown == null || !(shown.bundle() instanceof StepBundle.Answer answer)) {
            return frame(step, null, Map.of(), List.of(), Map.of(), "a step without an answer");
        }
        Map<String, Pose> placed = new LinkedHashMap<>();
        for (BodyAnswer body : answer.bodies()) {
            GeometryObject mover = mover(body.objectName());
            if (mover == null) {
                continue;
            }
            Pose there = body.pose();
            if (reply == null || !reply.bundle().equals(answer)) {
                put(mover.at(there));
            }
            if (asked.seconds() > 0) {
                placed.put(body.objectName(), present(body.objectName()).pose());
            }
        }
        List<Frame.Bump> bumps = new ArrayList<>();
        for (ContactAnswer contact : answer.contacts()) {
            GeometryObject mover = mover(contact.objectName());
            Point normal = contact.normal();
            boolean isAside = Math.abs(normal.y()) <= 0.5; // what is below it is no bump
            if (mover != null && isAside && contact.phase() == ContactAnswer.Phase.BEGIN) {
                bumps.add(new Frame.Bump(
                        mover, degrees(-normal.x(), -normal.z()), met(contact), null, Scene.Refusal.Kind.BUMP));
            }
        }
        return frame(step, null, placed, bumps, Map.of(), stepped(asked, answer));
    }

    /** What a body met, if that has a name. */
    private @Nullable MoveResult met(ContactAnswer contact) {
        Geometry world = session.world();
        String other = contact.other();
        return world == null || other == null || !world.hasObject(other)
                ? null
                : new MoveResult(false, 0, 0, world.getObject(other), contact.point(), contact.normal());
    }

    private static String stepped(StepBundle asked, StepBundle.Answer answer) {
        if (asked.seconds() == 0) {
            return NumberText.count(asked.commands().size(), "command");
        }
        int count = answer.bodies().size();
        String words = NumberText.digits(asked.seconds(), 9) + " s, " + count + (count == 1 ? " body" : " bodies");
        if (answer.contacts().isEmpty()) {
            return words;
        }
        ContactAnswer first = answer.contacts().get(0);
        String other = first.other() == null ? "an object without a name, or the border" : Text.quoted(first.other());
        return words + ", " + NumberText.count(answer.contacts().size(), "contact") + ": "
                + Text.quoted(first.objectName()) + " and " + other
                + (answer.contacts().size() > 1 ? ", ..." : "");
    }

    private static String moved(int asked, List<Frame.Bump> bumps) {
        String words = NumberText.count(asked, "move");
        if (bumps.isEmpty()) {
            return words;
        }
        Frame.Bump first = bumps.get(0);
        return words + ", " + bumps.size() + " refused: " + ObjectNames.of(first.mover()) + " by " + first.obstacle()
                + (bumps.size() > 1 ? ", ..." : "");
    }

    private Frame measure(Step step, SonarRequestBundle sonars) {
        Reply reply = step.expected() == null ? session.reply(sonars) : step.expected();
        List<Double> distances =
                reply != null && reply.bundle() instanceof DistanceBundle told ? told.distances() : List.of();
        Map<String, List<Scene.Ping>> heard = new LinkedHashMap<>();
        int k = 0;
        for (SonarRequest request : sonars.requests()) {
            double distance = k < distances.size() ? distances.get(k) : Double.NaN;
            k++;
            GeometryObject mover = mover(request.objectName());
            if (mover == null || Double.isNaN(distance)) {
                continue;
            }
            Beam beam = request.beam() == null ? options.beam() : request.beam();
            Scene.Ping ping = new Scene.Ping(
                    mover.center(),
                    mover.heading() + degrees(request.xOffset(), request.zOffset()),
                    Degrees.toDegrees(beam.width()),
                    beam.max(),
                    distance);
            heard.computeIfAbsent(request.objectName(), unseen -> new ArrayList<>())
                    .add(ping);
        }
        return frame(
                step,
                null,
                Map.of(),
                List.of(),
                heard,
                NumberText.count(sonars.requests().size(), "distance"));
    }

    private @Nullable GeometryObject mover(String name) {
        Geometry world = session.world();
        if (world == null || !world.hasObject(name)) {
            return null;
        }
        GeometryObject object = world.getObject(name);
        return object.isMoveable() ? object : null;
    }

    private GeometryObject present(String name) {
        GeometryObject object = mover(name);
        if (object == null) {
            throw new IllegalStateException("the record puts " + name + " out of the world");
        }
        return object;
    }
}
