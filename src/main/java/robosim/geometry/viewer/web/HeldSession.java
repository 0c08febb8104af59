package robosim.geometry.viewer.web;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.atomic.AtomicInteger;
import org.jspecify.annotations.Nullable;
import robosim.geometry.Geometry;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.net.Session;
import robosim.geometry.net.SessionListener;
import robosim.geometry.protocol.BatchAnswerBundle;
import robosim.geometry.protocol.BatchRequestBundle;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.Problem;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.StepBundle;
import robosim.geometry.protocol.batch.BatchAnswer;
import robosim.geometry.protocol.batch.BatchRequest;
import robosim.geometry.protocol.batch.WorldAnswer;
import robosim.geometry.protocol.batch.WorldRequest;

/** One session under a {@link SessionControl}. Its methods are called on the session's thread, except where they say otherwise. */
final class HeldSession implements SessionListener {
    private static final int MOST_COMMANDS = 16;

    private final SessionControl control;
    private final String connection;
    private final ConcurrentLinkedQueue<Command> commands = new ConcurrentLinkedQueue<>();
    private final AtomicInteger waiting = new AtomicInteger();
    private @Nullable Session session;

    /** Whether it carries out a request of its own, which is not held. */
    private boolean inside;

    /** The world whose first places are known. */
    private @Nullable Geometry known;

    private final Map<String, Pose> starts = new LinkedHashMap<>();
    private long movedAt = System.nanoTime();

    private record Command(Map<?, ?> fields, CompletableFuture<String> answer) {}

    HeldSession(SessionControl control, String connection) {
        this.control = control;
        this.connection = connection;
    }

    boolean isCalled(String name) {
        return connection.equals(name);
    }

    /** When it last carried out a request that moves something, by {@link System#nanoTime}. */
    long movedAt() {
        return movedAt;
    }

    /** Adds a command; called by any thread. */
    CompletableFuture<String> add(Map<?, ?> fields) {
        CompletableFuture<String> answer = new CompletableFuture<>();
        if (waiting.incrementAndGet() > MOST_COMMANDS) {
            waiting.decrementAndGet();
            answer.complete("too many commands wait for the environment's next request");
        } else {
            commands.add(new Command(fields, answer));
        }
        return answer;
    }

    boolean hasCommands() {
        return !commands.isEmpty();
    }

    @Override
    public void opened(Session opened) {
        session = opened;
    }

    @Override
    public void requested(Bundle request) {
        if (inside) {
            return;
        }
        remember();
        if (isMoving(request)) {
            control.await(this);
        } else {
            carryOut();
        }
    }

    @Override
    public void replied(Bundle request, @Nullable Reply reply, long nanoseconds) {
        if (!inside && isMoving(request)) {
            movedAt = System.nanoTime();
        }
    }

    @Override
    public void ended() {
        control.ended(connection, this);
        for (Command command = commands.poll(); command != null; command = commands.poll()) {
            command.answer.complete("the session is over");
        }
    }

    private static boolean isMoving(Bundle request) {
        return request instanceof MoveBundle
                || request instanceof StepBundle
                || (request instanceof BatchRequestBundle batch
                        && batch.requests().stream().anyMatch(HeldSession::isMoving));
    }

    private static boolean isMoving(BatchRequest request) {
        return request instanceof WorldRequest && request.isAboutMover();
    }

    /** Keeps where the moveable objects of a new world are. */
    private void remember() {
        Geometry world = session == null ? null : session.world();
        if (world != null && world != known) {
            known = world;
            starts.clear();
            for (GeometryObject object : world.objects()) {
                if (object.isMoveable()) {
                    starts.put(String.valueOf(object.name()), object.pose());
                }
            }
        }
    }

    /** Carries out what waits. */
    void carryOut() {
        for (Command command = commands.poll(); command != null; command = commands.poll()) {
            waiting.decrementAndGet();
            if (command.answer.isDone()) {
                continue; // nobody waits for it any more
            }
            inside = true;
            try {
                command.answer.complete(carryOut(command.fields));
            } catch (RuntimeException e) { // among them one beyond a limit of the session
                command.answer.completeExceptionally(e);
            } finally {
                inside = false;
            }
        }
    }

    private String carryOut(Map<?, ?> fields) {
        Session of = session;
        Geometry world = of == null ? null : of.world();
        if (of == null || world == null) {
            return "there is no world yet";
        }
        remember();
        String what = Control.text(fields, "do");
        if (what.equals("reset")) {
            return reset(of, world);
        }
        String name = Control.text(fields, "name");
        if (!starts.containsKey(name)
                && !(world.hasObject(name) && world.getObject(name).isMoveable())) {
            throw new IllegalArgumentException("name must be of a moveable object (got: " + name + ")");
        }
        Pose pose = world.getObject(name).pose();
        if (what.equals("turn")) {
            double radians = StrictMath.toRadians(Control.number(fields, "degrees"));
            return ask(of, new WorldRequest.Go(name, 0, 0, 0, 0, radians));
        }
        Point from = pose.center();
        Point to = new Point(Control.number(fields, "x"), from.y(), Control.number(fields, "z"));
        if (Boolean.TRUE.equals(fields.get("lift")) && pose.isUpright()) {
            return ask(of, new WorldRequest.Place(name, to, StrictMath.toRadians(pose.heading())));
        }
        double dx = to.x() - from.x();
        double dz = to.z() - from.z();
        return ask(
                of, new WorldRequest.Go(name, own(pose, 0, dx, dz), own(pose, 1, dx, dz), own(pose, 2, dx, dz), 0, 0));
    }

    /** A horizontal displacement along an axis of the object's own. */
    private static double own(Pose pose, int axis, double dx, double dz) {
        return pose.rotation(axis) * dx + pose.rotation(6 + axis) * dz;
    }

    /** Puts all moveable objects where they began: in rounds, as one may stand where another one began. */
    private String reset(Session of, Geometry world) {
        Map<String, Pose> left = new LinkedHashMap<>(starts);
        left.entrySet()
                .removeIf(start -> !world.hasObject(start.getKey())
                        || world.getObject(start.getKey()).pose().equals(start.getValue()));
        boolean isMoved = true;
        while (isMoved && !left.isEmpty()) {
            isMoved = left.entrySet()
                    .removeIf(start -> start.getValue().isUpright()
                            && ask(
                                            of,
                                            new WorldRequest.Place(
                                                    start.getKey(),
                                                    start.getValue().center(),
                                                    StrictMath.toRadians(
                                                            start.getValue().heading())))
                                    .isEmpty());
        }
        List<String> names = new ArrayList<>(left.keySet());
        return names.isEmpty() ? "" : "no free place where they began: " + String.join(", ", names);
    }

    /** Asks for a change as a peer does; returns why it was not made, or nothing. */
    private static String ask(Session of, WorldRequest request) {
        Reply reply = of.reply(new BatchRequestBundle(List.of(request)));
        if (reply == null || !(reply.bundle() instanceof BatchAnswerBundle answers)) {
            return "not carried out";
        }
        List<Problem> problems = reply.problems();
        if (!problems.isEmpty()) {
            return problems.get(0).reason();
        }
        BatchAnswer answer = answers.answers().get(0);
        if (answer instanceof WorldAnswer.Changed changed && !changed.done()) {
            return "blocked by " + (changed.obstacle() == null ? "the border of the world" : changed.obstacle());
        }
        if (answer instanceof WorldAnswer.Went went && !went.made()) {
            return "blocked by " + (went.obstacle() == null ? "the border of the world" : went.obstacle());
        }
        return "";
    }
}
