package robosim.geometry.sweep;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.SortedMap;
import java.util.function.Function;
import java.util.random.RandomGenerator;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import robosim.geometry.Geometry;
import robosim.geometry.check.Checks;
import robosim.geometry.check.Text;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.net.Session;
import robosim.geometry.net.SessionListener;
import robosim.geometry.net.SessionOptions;
import robosim.geometry.protocol.BatchRequestBundle;
import robosim.geometry.protocol.Beam;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.MoveRequest;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.SonarRequest;
import robosim.geometry.protocol.SonarRequestBundle;
import robosim.geometry.protocol.StepBundle;
import robosim.geometry.protocol.motion.BodyRequest;
import robosim.geometry.protocol.motion.DriveCommand;
import robosim.geometry.scenario.Replay;
import robosim.geometry.scenario.Scenario;
import robosim.geometry.scenario.ScenarioException;
import robosim.geometry.scenario.Step;
import robosim.geometry.sweep.lines.Fingerprint;
import robosim.geometry.sweep.lines.Names;
import robosim.geometry.sweep.lines.ScenarioPrint;

/**
 * Replays a recorded conversation with random disturbances: robots that start elsewhere, moves that slip, misaligned
 * beams, noisy distances. The amount of each is a parameter, 0 by default. All draws come from {@link
 * Replicate#pairedRandom()}, so replicates of the same number differ only by their parameters.
 */
public final class ScenarioSweep implements SweepScenario {
    /**
     * Radius in world units: every moveable object starts at a free point in a disc of this radius around its place.
     */
    public static final String PLACE = "place";

    /** Degrees by which its heading is turned at most, to either side. */
    public static final String HEADING = "heading";

    /** Standard deviation of the length of a move and of its turn, as a fraction of each. */
    public static final String SLIP = "slip";

    /** Standard deviation of a beam's direction about the vertical, degrees. */
    public static final String AIM = "aim";

    /** Standard deviation of the error added to a distance, world units. */
    public static final String RANGE = "range";

    /** Factor of the speeds that robots are told to drive at; 1 if it is left out. */
    public static final String SPEED = "speed";

    /** Factor of the turns that robots are told to drive with; 1 if it is left out. */
    public static final String TURN = "turn";

    /** Factor of the masses that bodies are given; 1 if it is left out. */
    public static final String MASS = "mass";

    private static final List<String> PARAMETERS = List.of(PLACE, HEADING, SLIP, AIM, RANGE, SPEED, TURN, MASS);

    private static final long serialVersionUID = 1;

    /** Number of attempts to find a free place before an object stays where it is. */
    private static final int TRIES = 100;

    private final String name;
    private final Dimension dimension;
    private final Accuracy accuracy;
    private final Beam beam;
    private final InitBundle init;
    private String print = "";

    /** The requests after the world is made. */
    private final ArrayList<Bundle> requests = new ArrayList<>();

    /** The first robots that are moved or driven, in the order of the requests. */
    private final ArrayList<String> movers = new ArrayList<>();

    private final ArrayList<RobotArrivals.Goal> goals = new ArrayList<>();

    /** The recorded answers; null if unknown. */
    private final ArrayList<@Nullable Bundle> answers = new ArrayList<>();

    private Function<String, SessionListener> listeners = session -> SessionListener.NONE;

    private ScenarioSweep(String name, SessionOptions options, InitBundle init) {
        this.name = Names.check("name of a scenario", name);
        this.dimension = options.dimension();
        this.accuracy = options.accuracy();
        this.beam = options.beam();
        this.init = init;
    }

    /**
     * Reads a scenario; its name is that of its file without the ending.
     *
     * @throws ScenarioException if it cannot be read, or does not have exactly one world, at its beginning
     */
    public static ScenarioSweep read(Path file) throws IOException {
        Checks.present("file", file);
        Scenario scenario = Scenario.read(file);
        List<Step> steps = scenario.steps();
        if (steps.isEmpty() || !(steps.get(0).request() instanceof InitBundle first)) {
            throw new SweepException(file + ": a scenario that is swept must begin with its world (got: "
                    + (steps.isEmpty() ? "no step" : "another step") + ")");
        }
        ScenarioSweep sweep =
                new ScenarioSweep(Names.of(file), scenario.header().options(), first);
        for (Step step : steps.subList(1, steps.size())) {
            if (step.request() instanceof InitBundle) {
                throw new SweepException(file + " line " + step.line()
                        + ": a scenario that is swept must have one world (got: another)");
            }
            if (step.request() instanceof BatchRequestBundle) {
                throw new SweepException(file + " line " + step.line()
                        + ": a scenario that is swept must have moves and sonars (got: a batch, for which a sweep"
                        + " knows no noise)");
            }
            Reply expected = step.expected();
            sweep.requests.add(step.request());
            sweep.answers.add(expected == null ? null : expected.bundle());
        }
        sweep.print = ScenarioPrint.of(scenario.header().options(), first, sweep.requests, sweep.answers);
        sweep.requests.stream()
                .flatMap(ScenarioSweep::moved)
                .distinct()
                .limit(RobotArrivals.MOST_ROBOTS)
                .forEach(sweep.movers::add);
        return sweep;
    }

    private static Stream<String> moved(Bundle request) {
        return request instanceof MoveBundle moves
                ? moves.moves().stream().map(MoveRequest::objectName)
                : request instanceof StepBundle step
                        ? step.commands().stream().map(DriveCommand::objectName)
                        : Stream.of();
    }

    /**
     * This scenario with a goal: each result has the time, in seconds of the recorded steps, after which the robot's centre
     * was first seen in a disc on the floor; without steps of time, the number of requests.
     *
     * @param robot  a moveable object of the conversation
     * @param radius above 0
     * @throws IllegalArgumentException if there is no such robot, or a number is not finite
     */
    public ScenarioSweep toGoal(String robot, double x, double z, double radius) {
        Checks.present("robot", robot);
        List<String> names = init.objects().stream()
                .filter(GeometryObject::isMoveable)
                .map(object -> String.valueOf(object.name()))
                .toList();
        if (!names.contains(robot)) {
            throw new IllegalArgumentException("robot of a goal must be a moveable object of " + name + ", "
                    + Text.choice(robot, names) + " (got: " + Text.quoted(robot) + ")");
        }
        if (!(Double.isFinite(x) && Double.isFinite(z) && radius > 0 && radius < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException("goal must be at finite x and z, with a finite radius above 0 (got: " + x
                    + ", " + z + ", radius " + radius + ")");
        }
        ScenarioSweep sweep = copy();
        sweep.goals.add(new RobotArrivals.Goal(robot, x, z, radius));
        sweep.print =
                new Fingerprint().add(print).add(sweep.goals.toString()).hex().substring(0, print.length());
        return sweep;
    }

    private ScenarioSweep copy() {
        ScenarioSweep sweep = new ScenarioSweep(name, options(), init);
        sweep.requests.addAll(requests);
        sweep.answers.addAll(answers);
        sweep.movers.addAll(movers);
        sweep.goals.addAll(goals);
        sweep.print = print;
        sweep.listeners = listeners;
        return sweep;
    }

    /** This sweep with a listener for each replicate, such as {@link robosim.geometry.scenario.AnswerProofs}; results stay the same. */
    public ScenarioSweep heardBy(Function<String, SessionListener> other) {
        ScenarioSweep sweep = copy();
        sweep.listeners = Checks.present("listeners", other);
        return sweep;
    }

    @Override
    public String name() {
        return name;
    }

    @Override
    public boolean isRandom(SortedMap<String, String> parameters) {
        boolean moves = false;
        boolean senses = false;
        for (Bundle request : requests) {
            moves |= moved(request).findAny().isPresent();
            senses |= request instanceof SonarRequestBundle;
        }
        return isAbove0(parameters, PLACE)
                || isAbove0(parameters, HEADING)
                || (moves && isAbove0(parameters, SLIP))
                || (senses && (isAbove0(parameters, AIM) || isAbove0(parameters, RANGE)));
    }

    private static boolean isAbove0(SortedMap<String, String> parameters, String parameter) {
        return Double.parseDouble(parameters.getOrDefault(parameter, "0")) > 0;
    }

    /** A digest of all steps and options of its file, and of its goals. */
    @Override
    public String fingerprint() {
        return print;
    }

    @Override
    public void check(String parameter, String value) {
        if (!PARAMETERS.contains(parameter)) {
            throw new IllegalArgumentException("a parameter of a scenario file must be one of "
                    + String.join(", ", PARAMETERS) + ", " + ParameterSweep.ACCURACY + ", " + ParameterSweep.DIMENSION
                    + " (got: "
                    + parameter + ")");
        }
        double amount;
        try {
            amount = Double.parseDouble(value);
        } catch (NumberFormatException e) {
            throw new IllegalArgumentException(parameter + " must be a number (got: " + value + ")", e);
        }
        Checks.refuse(
                !(amount >= 0 && amount < Double.POSITIVE_INFINITY),
                parameter + " must be at least 0 and finite",
                value);
        if (parameter.equals(MASS) && amount == 0) { // which would ask for the mass of the shape
            throw new IllegalArgumentException(parameter + " must be above 0 (got: " + value + ")");
        }
    }

    /** The world of the conversation, under the scenario's name. */
    public SweepWorld world() {
        Session session = new Session(options(), SessionListener.NONE, name);
        session.reply(init);
        Geometry world = session.world();
        if (world == null) {
            throw new IllegalArgumentException("the world of " + name + " cannot be; a replay tells why");
        }
        return new SweepWorld(name, world.snapshot());
    }

    /**
     * Another world for the conversation: its own objects, plus those moveable objects of the conversation that it
     * lacks.
     *
     * @throws IllegalArgumentException if one of these would be outside it
     */
    public SweepWorld in(SweepWorld other) {
        Checks.present("world", other);
        Geometry world = other.snapshot().toGeometry();
        for (GeometryObject object : init.objects()) {
            String mover = object.name();
            if (object.isMoveable() && mover != null && !world.hasObject(mover) && !world.addObjectUnchecked(object)) {
                throw new IllegalArgumentException("the robots of " + name + " must be within the world " + other.name()
                        + " (got: " + object + ")");
            }
        }
        return new SweepWorld(other.name(), world.snapshot());
    }

    /** The options of the sessions. */
    public SessionOptions options() {
        return new SessionOptions(dimension, accuracy, beam);
    }

    @Override
    public Result run(Replicate replicate) {
        double place = amount(replicate, PLACE);
        double heading = amount(replicate, HEADING);
        RandomGenerator random = replicate.pairedRandom();
        SeededRandom noise = new SeededRandom(random.nextLong());
        int stuck = place == 0 && heading == 0 ? 0 : scatter(replicate.world(), random.nextLong(), place, heading);
        Noise errors =
                new Noise(noise, amount(replicate, SLIP), amount(replicate, AIM), amount(replicate, RANGE), beam);
        Replay replay =
                new Replay(replicate.world(), options(), listeners.apply(replicate.seed() + " " + replicate.number()));
        ScenarioTally tally = new ScenarioTally();
        RobotArrivals journey = new RobotArrivals(
                replicate.world(), movers, goals, requests.stream().anyMatch(each -> each instanceof StepBundle));
        for (int k = 0; k < requests.size(); k++) {
            Bundle asked = requests.get(k);
            Bundle request;
            if (asked instanceof StepBundle step) {
                request = driven(step, replicate, errors);
            } else {
                request = asked instanceof MoveBundle moves
                        ? errors.slipped(moves)
                        : errors.askew((SonarRequestBundle) asked);
            }
            replay.step(new Step(request, null));
            Reply reply = replay.reply();
            if (reply == null) {
                throw new IllegalStateException("the module itself failed at step " + (k + 2));
            }
            tally.take(asked, request, reply, answers.get(k), errors);
            journey.after(request);
        }
        return journey.end(tally.result(stuck));
    }

    /** A step with other commands and masses; a command slips like a move. */
    private static StepBundle driven(StepBundle step, Replicate replicate, Noise errors) {
        double speed = replicate.number(SPEED, 1);
        double turn = replicate.number(TURN, 1);
        double mass = replicate.number(MASS, 1);
        List<BodyRequest> bodies = new ArrayList<>();
        for (BodyRequest body : step.bodies()) {
            bodies.add(body.withMass(body.mass() * mass));
        }
        List<DriveCommand> commands = new ArrayList<>();
        for (DriveCommand command : step.commands()) {
            commands.add(errors.slipped(command, speed, turn));
        }
        return new StepBundle(step.seconds(), bodies, commands, step.mixing(), step.pushes());
    }

    private static double amount(Replicate replicate, String parameter) {
        return replicate.number(parameter, 0); // which the sweep has checked
    }

    /**
     * Moves all upright moveable objects to random places nearby, one after the other; returns how many found no free
     * place. Each has its own random stream, by its name, so the number of attempts of one does not affect the next.
     */
    private static int scatter(Geometry world, long seed, double radius, double turn) {
        int stuck = 0;
        for (GeometryObject object : world.objects()) {
            String mover = object.name();
            if (object.isMoveable() && mover != null && object.pose().isUpright()) {
                SeededRandom random = new SeededRandom(Seeds.of(seed, mover));
                stuck += isPlaced(world, object, mover, random, radius, turn) ? 0 : 1;
            }
        }
        return stuck;
    }

    private static boolean isPlaced(
            Geometry world, GeometryObject object, String mover, SeededRandom random, double radius, double turn) {
        for (int k = 0; k < TRIES; k++) {
            double x;
            double z;
            do {
                x = 2 * random.nextDouble() - 1;
                z = 2 * random.nextDouble() - 1;
            } while (x * x + z * z > 1);
            double heading = object.heading() + turn * (2 * random.nextDouble() - 1);
            Point from = object.center();
            Point to = new Point(from.x() + radius * x, from.y(), from.z() + radius * z);
            if (world.placeObject(mover, to, heading)) {
                return true;
            }
        }
        return false;
    }

    /** The random errors of requests. */
    static final class Noise {
        private final SeededRandom random;
        private final double slip;
        private final double aim;
        private final double range;
        private final Beam beam;

        Noise(SeededRandom random, double slip, double aim, double range, Beam beam) {
            this.random = random;
            this.slip = slip;
            this.aim = aim;
            this.range = range;
            this.beam = beam;
        }

        MoveBundle slipped(MoveBundle moves) {
            List<MoveRequest> slipped = new ArrayList<>();
            for (MoveRequest move : moves.moves()) {
                double way = 1 + slip * random.nextGaussian();
                double turn = 1 + slip * random.nextGaussian();
                slipped.add(new MoveRequest(
                        move.objectName(),
                        way * move.x(),
                        way * move.y(),
                        way * move.z(),
                        turn * move.rx(),
                        turn * move.ry()));
            }
            return new MoveBundle(slipped);
        }

        DriveCommand slipped(DriveCommand command, double speed, double turn) {
            double way = speed * (1 + slip * random.nextGaussian());
            double curve = turn * (1 + slip * random.nextGaussian());
            return new DriveCommand(
                    command.objectName(), way * command.forward(), way * command.right(), curve * command.turn());
        }

        SonarRequestBundle askew(SonarRequestBundle sonars) {
            List<SonarRequest> askew = new ArrayList<>();
            for (SonarRequest sonar : sonars.requests()) {
                double by = StrictMath.toRadians(aim * random.nextGaussian());
                double cos = StrictMath.cos(by);
                double sin = StrictMath.sin(by);
                double x = sonar.xOffset() * cos + sonar.zOffset() * sin;
                double z = sonar.zOffset() * cos - sonar.xOffset() * sin;
                askew.add(by == 0 ? sonar : new SonarRequest(sonar.objectName(), x, z, sonar.beam()));
            }
            return new SonarRequestBundle(askew);
        }

        /** A distance as the noisy sensor reports it; not below its blind range. */
        double read(SonarRequest sonar, double distance) {
            double off = range * random.nextGaussian();
            Beam own = sonar.beam() == null ? beam : sonar.beam();
            return Double.isFinite(distance) ? Math.max(own.min(), distance + off) : distance;
        }
    }
}
