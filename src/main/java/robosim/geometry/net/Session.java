package robosim.geometry.net;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import robosim.geometry.Geometry;
import robosim.geometry.MoveResult;
import robosim.geometry.WorkLimit;
import robosim.geometry.check.Checks;
import robosim.geometry.check.Text;
import robosim.geometry.exact.Degrees;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Move;
import robosim.geometry.net.session.Batches;
import robosim.geometry.net.session.BodyStepper;
import robosim.geometry.net.session.LargeTurnWarning;
import robosim.geometry.net.session.LogBudget;
import robosim.geometry.net.session.Reasons;
import robosim.geometry.net.session.WarningLog;
import robosim.geometry.net.session.WorldCopies;
import robosim.geometry.net.session.WorldExtent;
import robosim.geometry.net.session.WorldRequests;
import robosim.geometry.protocol.BatchAnswerBundle;
import robosim.geometry.protocol.BatchRequestBundle;
import robosim.geometry.protocol.Beam;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.DistanceBundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.MoveRequest;
import robosim.geometry.protocol.Problem;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.SonarRequest;
import robosim.geometry.protocol.SonarRequestBundle;
import robosim.geometry.protocol.StepBundle;
import robosim.geometry.protocol.WorldSettings;
import robosim.geometry.protocol.batch.BatchAnswer;
import robosim.geometry.protocol.batch.BatchRequest;
import robosim.geometry.protocol.batch.CopyRequest;
import robosim.geometry.protocol.batch.NoAnswer;
import robosim.geometry.protocol.batch.WorldRequest;

/**
 * A conversation about one world at a time: takes a request bundle and returns an answer bundle or nothing. It is
 * independent of encodings and sockets, and may be used by one thread at a time.
 *
 * <ul>
 *   <li>An {@link InitBundle} makes a new world, which replaces the previous one once it is complete; if it cannot be
 *       made, the previous one stays. Objects are added unchecked and may overlap. An object that cannot be added,
 *       because its name is taken or it would leave the world, is left out and logged by name.
 *   <li>An {@link InitBundle.Answered} is an InitBundle and the question what became of it, and observed as these two.
 *   <li>A {@link MoveBundle} is answered by the moves that were made, in order, each tried in the world as the earlier
 *       ones left it. The answer contains the requests themselves, unchanged to the bit.
 *   <li>A {@link SonarRequestBundle} is answered by one distance for each request, in order.
 *   <li>A {@link BatchRequestBundle} is answered by one answer for each request, in order, with the bits of the single
 *       calls.
 *   <li>A {@link CopyRequest} in a batch makes copies of the world and lets time pass in them. They stay when a new world comes.
 *   <li>A {@link StepBundle} gives bodies and commands to objects, lets time pass, and is answered by where all bodies are and
 *       what they met. A body or command that cannot be given is left out and logged.
 *   <li>A request with a name that is unknown, missing or of a static object, or that its world refuses (in a planar
 *       world, a sonar pointing straight up), is logged: a move is left out of the answer, a distance is NaN, a request of
 *       a batch has a {@link NoAnswer}. Before the first InitBundle every name is unknown. The session goes on.
 * </ul>
 *
 * <p>Angles come in radians and are converted here: the double nearest to k pi / 2 becomes exactly 90 k degrees. Each
 * warning is logged once per world.
 */
public final class Session {
    private static final System.Logger LOG = System.getLogger(Session.class.getPackageName());

    private static final int MOST_TO_SUGGEST = 100;

    private final SessionOptions options;
    private final SessionListener listener;
    private final WarningLog complaints;
    private final LargeTurnWarning angles;

    /** Runs between two parts of the work. */
    private Runnable breath = () -> {};

    private final Batches batches = new Batches();
    private final WorldCopies copies = new WorldCopies(batches);
    private WorldRequests about = new WorldRequests();

    /** What limits a request; null for nothing. */
    private @Nullable WorkLimit limit;

    private @Nullable Geometry world;

    /** The bodies of the world; null before the first step. */
    private @Nullable BodyStepper motion;

    /** The bodies of which the log has told that one was stopped. */
    private @Nullable BodyStepper stopping;

    private Set<String> moveable = new HashSet<>();
    private double radians;
    private double degrees;

    /** A session with RoboSim's options. */
    public Session() {
        this(SessionOptions.ROBOSIM, SessionListener.NONE, "session");
    }

    /**
     * A session with given options.
     *
     * @param name the beginning of its log lines
     */
    public Session(SessionOptions options, SessionListener listener, String name) {
        this(options, listener, name, LOG);
    }

    /**
     * A session with a given log.
     *
     * @param log takes the session's warnings
     */
    public Session(SessionOptions options, SessionListener listener, String name, System.Logger log) {
        this.options = Checks.present("options", options);
        this.listener = Checks.present("listener", listener);
        this.complaints = new WarningLog(Checks.present("log", log), Checks.present("name", name));
        this.angles = new LargeTurnWarning(complaints);
        listener.opened(this);
    }

    /**
     * A session that begins with an existing world.
     *
     * @param world belongs to the session from now on
     * @param log   takes the session's warnings
     */
    public Session(Geometry world, SessionOptions options, SessionListener listener, String name, System.Logger log) {
        this(options, listener, name, log);
        this.world = Checks.present("world", world);
        List<GeometryObject> objects = world.objects();
        about.beginWith(objects);
        objects.forEach(object -> WorldRequests.addMovers(object, moveable));
    }

    /**
     * Makes this session call {@code between} between two parts of its work: objects, moves, distances.
     *
     * @param between may throw, which aborts the request and makes the session unusable
     */
    Session pausing(Runnable between, LogBudget budget) {
        breath = between;
        complaints.within(budget);
        return this;
    }

    /** Makes this session call its messages in the log by the numbers that they have for its peer. */
    Session numbered(LongSupplier message) {
        complaints.numbered(message);
        return this;
    }

    /**
     * Limits the work of each request: one that would exceed it throws a {@link robosim.geometry.WorkLimitException}, and so does
     * one in which what the limit runs throws; the session, its world and its bodies are then as before.
     */
    Session within(WorkLimit most) {
        limit = most;
        limitWorld(world);
        return this;
    }

    private void limitWorld(@Nullable Geometry of) {
        if (of != null && limit != null) {
            of.limitWork(limit);
        }
    }

    /** Carries out a part of a request as a whole, or leaves the world as it was. */
    private <T> T together(Supplier<T> work) {
        Geometry geometry = limit == null ? null : world();
        return geometry == null ? work.get() : geometry.together("a request", work);
    }

    /**
     * Carries out a request; the short form of {@link #reply}.
     *
     * @return the answer; null after an {@link InitBundle}
     * @throws IllegalArgumentException if it {@linkplain Bundle#isAnswer is an answer}
     */
    public @Nullable Bundle answer(Bundle request) {
        Reply reply = reply(request);
        return reply == null ? null : reply.bundle();
    }

    /**
     * Carries out a request, and reports what was refused and why.
     *
     * @return the answer, with a problem for each move that is left out, each distance that is NaN, each
     *     {@link NoAnswer} and each body or command that is left out; null after an {@link InitBundle}
     * @throws IllegalArgumentException if it {@linkplain Bundle#isAnswer is an answer}
     */
    public @Nullable Reply reply(Bundle request) {
        if (request instanceof InitBundle.Answered asked) {
            complaints.next();
            observed(asked.init());
            return observed(InitBundle.Answered.QUESTION);
        }
        if (request == null || request.isAnswer()) {
            throw new IllegalArgumentException(
                    "request must be an InitBundle, an InitBundle.Answered, a MoveBundle, a SonarRequestBundle, a"
                            + " BatchRequestBundle or a StepBundle (got: "
                            + (request == null ? "null" : request.getClass().getSimpleName()) + ")");
        }
        complaints.next();
        angles.look(request);
        return observed(request);
    }

    private @Nullable Reply observed(Bundle request) {
        listener.requested(request);
        long start = System.nanoTime();
        Reply reply = carryOut(request);
        listener.replied(request, reply, System.nanoTime() - start);
        return reply;
    }

    /**
     * The current world, for observers; null before the first {@link InitBundle}. It may be used on the session's
     * thread only, and changes to it affect the session.
     */
    public @Nullable Geometry world() {
        return world;
    }

    private @Nullable Reply carryOut(Bundle request) {
        if (request instanceof InitBundle init) {
            replaceWorld(init);
            return null;
        }
        if (request instanceof BatchRequestBundle batch) {
            about.keep();
            return limit == null ? answer(batch) : answerOrNot(batch);
        }
        if (request instanceof StepBundle step) {
            return step(step);
        }
        return together(
                () -> request instanceof MoveBundle moves ? move(moves) : measure((SonarRequestBundle) request));
    }

    private void replaceWorld(InitBundle init) {
        complaints.forget();
        angles.forget();
        WorldSettings settings = WorldExtent.settings(init, options.dimension(), options.accuracy());
        Geometry made = new Geometry(
                settings.width(),
                settings.height(),
                settings.length(),
                Checks.present("dimension", settings.dimension()),
                Checks.present("accuracy", settings.accuracy()));
        limitWorld(made);
        WorldRequests aboutMade = new WorldRequests();
        aboutMade.begin(init.objects());
        Set<String> names = new HashSet<>();
        Set<String> movers = new HashSet<>();
        int index = 0;
        for (GeometryObject object : init.objects()) {
            breath.run();
            if (add(made, aboutMade, object, index++, names)) {
                WorldRequests.addMovers(object, movers);
            }
        }
        world = made;
        about = aboutMade;
        moveable = movers;
        batches.forget();
        motion = null;
    }

    private boolean add(Geometry made, WorldRequests aboutMade, GeometryObject object, int index, Set<String> names) {
        String reason = refusal(made, object, names);
        String name = object.name();
        if (reason != null) {
            String label = name == null ? "objects[" + index + "]" : "object " + Text.quoted(name);
            complaints.warn(label + " was not added: " + reason);
            aboutMade.leftOut(index, name, reason);
            return false;
        }
        aboutMade.added(object);
        if (name != null) {
            names.add(name);
        }
        return true;
    }

    /** Adds an object, or returns why it was not added. */
    private static @Nullable String refusal(Geometry made, GeometryObject object, Set<String> earlier) {
        String name = object.name();
        if (name != null && earlier.contains(name)) {
            return "an earlier object has its name";
        }
        try {
            return made.addObjectUnchecked(object) ? null : "it would leave the world";
        } catch (IllegalArgumentException e) {
            return Reasons.of(e); // a load has a name that is taken
        }
    }

    private Reply move(MoveBundle bundle) {
        List<MoveRequest> made = new ArrayList<>();
        List<Problem> problems = new ArrayList<>();
        int index = 0;
        for (MoveRequest request : bundle.moves()) {
            breath.run();
            Problem problem = move(request, index++);
            if (problem == null) {
                made.add(request);
            } else {
                problems.add(problem);
            }
        }
        return new Reply(new MoveBundle(made), problems);
    }

    /** Makes a move; returns null if it was made. */
    private @Nullable Problem move(MoveRequest request, int index) {
        String name = request.objectName();
        if (world == null || !moveable.contains(name)) {
            return unknown(name, index, "its moves are left out");
        }
        MoveResult result;
        try {
            double rx = Degrees.toDegrees(request.rx());
            double ry = Degrees.toDegrees(request.ry());
            result = world.move(name, new Move(request.x(), request.y(), request.z(), rx, ry));
        } catch (IllegalArgumentException e) {
            return logged(index, "a move of object " + Text.quoted(name) + " is left out", Reasons.of(e));
        }
        listener.tried(request, result);
        return result.allowed() ? null : Problem.of(index, () -> Reasons.of(result));
    }

    private Reply measure(SonarRequestBundle bundle) {
        List<Double> distances = new ArrayList<>(bundle.requests().size());
        List<Problem> problems = new ArrayList<>();
        for (SonarRequest request : bundle.requests()) {
            breath.run();
            distances.add(measure(request, distances.size(), problems));
        }
        return new Reply(new DistanceBundle(distances), problems);
    }

    private double measure(SonarRequest request, int index, List<Problem> problems) {
        String name = request.objectName();
        if (world == null || !moveable.contains(name)) {
            problems.add(unknown(name, index, "its distances are NaN"));
            return Double.NaN;
        }
        Beam beam = request.beam() == null ? options.beam() : request.beam();
        try {
            return world.getSonarDistance(
                    name, request.xOffset(), request.zOffset(), beam.min(), beam.max(), degrees(beam));
        } catch (IllegalArgumentException e) {
            problems.add(logged(index, "a distance of object " + Text.quoted(name) + " is NaN", Reasons.of(e)));
            return Double.NaN;
        }
    }

    private Reply answerOrNot(BatchRequestBundle batch) {
        boolean isMade = false;
        try {
            Reply reply = together(() -> answer(batch));
            isMade = true;
            return reply;
        } finally {
            if (!isMade) {
                about.undo(moveable);
                batches.rest();
            }
        }
    }

    private Reply answer(BatchRequestBundle batch) {
        List<BatchAnswer> answers = new ArrayList<>(batch.requests().size());
        List<Problem> problems = new ArrayList<>();
        for (BatchRequest request : batch.requests()) {
            breath.run();
            answers.add(answer(request, answers.size(), problems));
        }
        batches.rest();
        return new Reply(new BatchAnswerBundle(answers), problems);
    }

    private BatchAnswer answer(BatchRequest request, int index, List<Problem> problems) {
        String name = request.objectName();
        boolean isOfMover = request.isAboutMover();
        if (world == null || (isOfMover && !moveable.contains(name))) {
            problems.add(unknown(name, index, "its batches have no answer"));
            return new NoAnswer();
        }
        try {
            if (request instanceof CopyRequest.Make make) {
                return copies.make(make, world, motion, moveable, limit, () -> breath.run());
            }
            if (request instanceof CopyRequest.Tick tick) {
                return copies.tick(tick, breath);
            }
            return request instanceof WorldRequest asked
                    ? about.answer(world, asked, moveable, this::tried)
                    : batches.answer(world, request, breath);
        } catch (IllegalArgumentException e) {
            problems.add(logged(index, "a batch of object " + Text.quoted(name) + " has no answer", Reasons.of(e)));
            return new NoAnswer();
        }
    }

    private Reply step(StepBundle step) {
        List<Problem> problems = new ArrayList<>();
        StepBundle.Answer nothing = new StepBundle.Answer(List.of(), List.of(), List.of());
        Geometry geometry = world();
        if (geometry == null) {
            return new Reply(nothing, List.of(notStepped("there is no world yet")));
        }
        breath.run();
        try {
            BodyStepper moving = motion == null ? new BodyStepper(geometry, () -> breath.run()) : motion;
            motion = moving;
            StepBundle.Answer answer = moving.step(step, (index, reason) -> problems.add(leftOut(index, reason)));
            angles.look(step, moving);
            moving.falls().forEach((name, fall) -> {
                if (fall.isBorder()) {
                    complaints.warn(Reasons.ofFall(name, fall.drop()));
                }
            });
            if (stopping != moving && !answer.stops().isEmpty()) {
                stopping = moving; // a crowd may stop in every step, so only the first is logged
                complaints.warn(
                        answer.stops().get(0).text() + " was stopped in a step; others in this world are not logged");
            }
            return new Reply(answer, problems);
        } catch (IllegalArgumentException e) {
            return new Reply(nothing, List.of(notStepped(Reasons.of(e))));
        }
    }

    private Problem leftOut(int index, String reason) {
        return logged(index, "body, command or push " + index + " of a step is left out", reason);
    }

    private Problem notStepped(String reason) {
        return logged(0, "a step moves nothing", reason);
    }

    private Problem logged(int index, String what, String reason) {
        complaints.warn(what + ": " + reason);
        return Problem.of(index, reason);
    }

    private void tried(WorldRequest.Go go, MoveResult result) {
        listener.tried(new MoveRequest(go.objectName(), go.x(), go.y(), go.z(), go.rx(), go.ry()), result);
    }

    /** How many objects the world has, of groups their members. */
    int objectCount() {
        return about.present();
    }

    /** The width of a beam in degrees; cached, since most beams are as wide as the last. */
    private double degrees(Beam beam) {
        if (beam.width() != radians) {
            radians = beam.width();
            degrees = Degrees.toDegrees(radians);
        }
        return degrees;
    }

    /** The closest names of moveable objects, if there are so few that a bundle of wrong names costs next to nothing. */
    private String closest(String name) {
        return moveable.size() > MOST_TO_SUGGEST ? "" : Text.closest(name, new TreeSet<>(moveable));
    }

    /** A problem that is logged and part of the reply. */
    private Problem unknown(String name, int index, String consequence) {
        String rest = world == null ? ", there is no world yet" : "";
        Supplier<String> words = () -> name.isEmpty() && world == null
                ? "there is no world yet"
                : "no moveable object " + Text.quoted(name) + closest(name) + rest;
        complaints.warn(words.get() + ": " + consequence);
        return Problem.of(index, words); // reasons may be much larger than the bundle, so their text is not kept
    }
}
