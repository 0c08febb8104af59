package robosim.geometry.cli.studies;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import robosim.geometry.check.NumberText;
import robosim.geometry.check.Text;
import robosim.geometry.cli.terminal.Arguments;
import robosim.geometry.cli.terminal.ExitCodes;
import robosim.geometry.cli.terminal.Progress;
import robosim.geometry.cli.terminal.UsageException;
import robosim.geometry.cli.terminal.WorldFiles;
import robosim.geometry.exact.Degrees;
import robosim.geometry.model.Bounds;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.net.SessionOptions;
import robosim.geometry.protocol.motion.BodyAnswer;
import robosim.geometry.protocol.motion.BodyRequest;
import robosim.geometry.protocol.motion.DriveCommand;
import robosim.geometry.protocol.motion.DriveSettings;
import robosim.geometry.protocol.motion.DriveSettings.Kind;
import robosim.geometry.protocol.motion.StopAnswer;
import robosim.geometry.scenario.ScenarioHeader;
import robosim.geometry.scenario.ScenarioWriter;
import robosim.geometry.scenario.drive.DriveRun;
import robosim.geometry.scenario.drive.WorldBodies;
import robosim.geometry.world.World;
import robosim.geometry.world.WorldObject;

/** Drives robots through a world. */
@Command(
        name = "drive",
        description =
                "Drives robots through a world for a time: they slide, push and bounce, and never overlap anything.",
        exitCodeList = {
            ExitCodes.DONE,
            ExitCodes.FINDINGS + ":a body was stopped because its motion could not be decided",
            ExitCodes.REFUSED
        },
        footer = {
            "  robosim-geometry drive worlds/pushing.xml --robot cart --speed 0.5 --turn 10 --seconds 10",
            "  robosim-geometry drive worlds/pushing.xml --tell cart=0.8,5 --tell mule=0.5 --record out.scenario.jsonl",
            "  robosim-geometry replay out.scenario.jsonl",
            "  robosim-geometry view out.scenario.jsonl"
        })
public final class DrivingCommand implements Callable<Integer> {
    private static final int DIGITS = 6;
    private static final int MOST_STEPS = 10_000_000;
    private static final double MOST = 1e9;
    private static final String TOLD = "NAME=SPEED[,TURN], as in cart=0.5,10";
    private static final String ATTACHED = "NAME=CARRIER, as in trailer=tractor";
    private static final String WEIGHED = "NAME=KG, as in crate=8";

    @Spec
    private CommandSpec spec;

    @Parameters(paramLabel = "WORLD", description = "a world in any format that convert reads")
    private Path world = Path.of("");

    @Mixin
    private WorldFiles files;

    @Option(
            names = "--robot",
            paramLabel = "NAME",
            description = "a moveable object that drives as --speed and --turn say; may be repeated (default: the first"
                    + " that has a drive, or the first of all)")
    private List<String> robots = new ArrayList<>();

    @Option(names = "--speed", paramLabel = "M/S", description = "its speed (default: ${DEFAULT-VALUE})")
    private double speed = 0.5;

    @Option(
            names = "--turn",
            paramLabel = "DEGREES",
            description =
                    "degrees a second, counter-clockwise; of a car the angle of its front wheels, of a force newton"
                            + " metres (default: 0)")
    private double turn;

    @Option(
            names = "--tell",
            paramLabel = "NAME=SPEED[,TURN]",
            description = "a robot with a speed and a turn of its own, which is 0 if it is left out; may be repeated")
    private List<String> told = new ArrayList<>();

    @Option(names = "--seconds", paramLabel = "S", description = "how long (default: ${DEFAULT-VALUE})")
    private double seconds = 10;

    @Option(names = "--step", paramLabel = "S", description = "length of a step (default: ${DEFAULT-VALUE})")
    private double step = 0.05;

    @Option(
            names = "--mass",
            paramLabel = "NAME=KG",
            description = "gives a moveable object a mass, so that robots push it; may be repeated")
    private List<String> masses = new ArrayList<>();

    @Option(
            names = "--push",
            description = "lets robots push every moveable object; those without a body in the file weigh 200 kg/m^3")
    private boolean push;

    @Option(
            names = "--attach",
            paramLabel = "NAME=CARRIER",
            description = "attaches a moveable object to another one where it stands, as a trailer or a load; may be"
                    + " repeated")
    private List<String> attached = new ArrayList<>();

    @Option(names = "--planar", description = "drives a world in which heights count as one in which they do not")
    private boolean planar;

    @Option(
            names = "--record",
            paramLabel = "FILE",
            description = "a new scenario that repeats the drive: for replay, view, export and sweep")
    private @Nullable Path record;

    @Override
    public Integer call() throws Exception {
        check();
        World read = files.world(Arguments.input("WORLD", world));
        if (planar) {
            read = read.planar();
        }
        read = attached(read);
        List<DriveCommand> commands = commands(read);
        DriveRun run;
        Path file = record;
        if (file == null) {
            run = drive(read, commands, null);
        } else {
            try (OutputStream out = Files.newOutputStream(file);
                    ScenarioWriter writer = ScenarioWriter.recording(
                            out,
                            new ScenarioHeader("drive " + world.getFileName(), SessionOptions.ROBOSIM),
                            Long.MAX_VALUE)) {
                run = drive(read, commands, writer);
                writer.end();
            }
        }
        print(run, read);
        return run.stopped().isEmpty() ? 0 : ExitCodes.FINDINGS;
    }

    private World attached(World read) {
        Map<String, String> carriers = new LinkedHashMap<>();
        for (String text : attached) {
            String[] pair = pair("--attach", ATTACHED, text);
            known(read, "--attach", pair[0]);
            known(read, "--attach", pair[1]);
            carriers.put(pair[0], pair[1]);
        }
        try {
            return read.withObjects(read.objects().stream()
                    .map(each -> {
                        String carrier =
                                carriers.get(String.valueOf(each.object().name()));
                        return carrier == null
                                ? each
                                : new WorldObject(each.object(), each.color(), each.sonars(), each.body(), carrier);
                    })
                    .toList());
        } catch (IllegalArgumentException e) {
            throw new UsageException("--attach: " + e.getMessage());
        }
    }

    private void check() {
        if (!(seconds > 0 && step > 0 && step <= 3600 && seconds / step <= MOST_STEPS)) {
            throw new UsageException(
                    "--seconds and --step must be above 0, a step at most an hour, and there must be at most "
                            + MOST_STEPS + " steps (got: " + seconds + " in steps of " + step + ")");
        }
        if (record != null) {
            Arguments.newFile("--record", record);
        }
    }

    private DriveRun drive(World read, List<DriveCommand> commands, @Nullable ScenarioWriter writer)
            throws IOException {
        DriveRun run;
        try {
            run = new DriveRun(read, bodies(read), commands, writer);
        } catch (IllegalArgumentException e) {
            throw new UsageException(String.valueOf(e.getMessage()));
        }
        long whole = (long) Math.floor(seconds / step * (1 + 1e-12));
        try (Progress progress = Progress.of(spec.commandLine(), "driving", whole)) {
            for (long k = 0; k < whole; k++) {
                run.step(step);
                progress.at(k + 1);
            }
            double rest = seconds - whole * step;
            if (rest > 1e-9 * step) {
                run.step(rest);
            }
        }
        return run;
    }

    private List<DriveCommand> commands(World read) {
        List<DriveCommand> commands = new ArrayList<>();
        List<String> names = new ArrayList<>(robots);
        if (names.isEmpty() && told.isEmpty()) {
            names.add(first(read));
        }
        Set<String> named = new HashSet<>();
        for (String name : names) {
            known(read, "--robot", name);
            once(named, name, "--robot=" + name);
            commands.add(new DriveCommand(
                    name, quantity("--speed", speed), kind(read, name).turn(quantity("--turn", turn))));
        }
        for (String text : told) {
            String[] pair = pair("--tell", TOLD, text);
            known(read, "--tell", pair[0]);
            once(named, pair[0], "--tell=" + text);
            String[] numbers = pair[1].split(",", -1);
            Arguments.refuse(numbers.length > 2, "--tell must be " + TOLD, text);
            double forward = number("--tell", TOLD, text, numbers[0]);
            double turns = numbers.length == 1 ? 0 : number("--tell", TOLD, text, numbers[1]);
            commands.add(new DriveCommand(
                    pair[0], quantity("--tell", forward), kind(read, pair[0]).turn(quantity("--tell", turns))));
        }
        return commands;
    }

    /** What drives a robot, which says what the turn of a command is. */
    private static Kind kind(World read, String name) {
        for (BodyRequest body : WorldBodies.of(read)) {
            DriveSettings drive = body.drive();
            if (drive != null && name.equals(body.objectName())) {
                return drive.kind();
            }
        }
        return DriveSettings.DEFAULT.kind();
    }

    private static String first(World read) {
        String first = "";
        for (WorldObject object : read.objects()) {
            String name = object.object().name();
            if (name != null && object.object().isMoveable()) {
                if (object.body() != null && object.body().drive() != null) {
                    return name;
                }
                first = first.isEmpty() ? name : first;
            }
        }
        return first;
    }

    /** Refuses a robot that is given two commands, of which only one could hold. */
    private void once(Set<String> named, String name, String given) {
        if (!named.add(name)) {
            throw new UsageException("--robot and --tell must name each robot once; " + Text.quoted(name)
                    + " has a command already (got: " + given + ")");
        }
    }

    /** A name and what is given to it, which has no equals sign. */
    private String[] pair(String option, String form, String text) {
        int equals = text.lastIndexOf('=');
        Arguments.refuse(equals < 1, option + " must be " + form, text);
        return new String[] {text.substring(0, equals), text.substring(equals + 1)};
    }

    private double number(String option, String form, String text, String number) {
        try {
            return Double.parseDouble(number);
        } catch (NumberFormatException e) {
            throw new UsageException(option + " must be " + form + " (got: " + text + ")");
        }
    }

    /** What a {@link DriveCommand} takes; the message names the option. */
    private double quantity(String option, double value) {
        Arguments.refuse(
                !(Math.abs(value) <= MOST),
                option + " must be from -10^9 to 10^9",
                value); // written so that NaN fails it
        return value;
    }

    private void known(World read, String option, String name) {
        List<String> moveable = new ArrayList<>();
        for (WorldObject object : read.objects()) {
            if (object.object().isMoveable()) {
                moveable.add(String.valueOf(object.object().name()));
            }
        }
        if (!moveable.contains(name)) {
            throw new UsageException(option + " must name a moveable object of the world, "
                    + Text.choice(name, moveable) + " (got: " + Text.quoted(name) + ")");
        }
    }

    private List<BodyRequest> bodies(World read) {
        Map<String, BodyRequest> all = new LinkedHashMap<>();
        if (push) {
            for (WorldObject object : read.objects()) {
                String name = object.object().name();
                if (name != null && object.object().isMoveable() && object.body() == null) {
                    all.put(name, BodyRequest.of(name));
                }
            }
        }
        List<BodyRequest> inFile = WorldBodies.of(read);
        for (String text : masses) {
            String[] pair = pair("--mass", WEIGHED, text);
            String name = pair[0];
            known(read, "--mass", name);
            BodyRequest known = inFile.stream()
                    .filter(body -> body.objectName().equals(name))
                    .findFirst()
                    .orElse(BodyRequest.of(name));
            double mass = number("--mass", WEIGHED, text, pair[1]);
            Arguments.refuse(
                    mass == 0,
                    "--mass must be above 0; leave it out for the mass of the shape",
                    text); // which would ask for the mass of the shape
            try {
                all.put(name, known.withMass(mass));
            } catch (IllegalArgumentException e) {
                throw new UsageException("--mass: " + e.getMessage());
            }
        }
        return List.copyOf(all.values());
    }

    private void print(DriveRun run, World read) {
        boolean isSpatial = read.dimension() == Dimension.SPATIAL;
        PrintWriter out = spec.commandLine().getOut();
        run.tracks().forEach((name, track) -> out.println(Text.quoted(name) + " " + words(track, isSpatial)));
        out.printf(
                Locale.ROOT,
                "%s s in %s, %s%n",
                number(run.time()),
                NumberText.count(run.steps(), "step"),
                NumberText.count(run.contacts(), "contact"));
        if (isSpatial && !planar) {
            read.objects().forEach(object -> tellFall(run, object.object(), out));
        }
        if (!run.stopped().isEmpty()) {
            out.println("stopped, since their motion could not be decided: "
                    + run.stopped().stream().map(StopAnswer::text).collect(Collectors.joining(", ")));
        }
        if (planar || !isSpatial) {
            PlanOverlaps.of(
                            read,
                            run.tracks().keySet(),
                            planar ? "drive without --planar" : "make the world one with dimension=\"SPATIAL\"")
                    .forEach(out::println);
        }
        out.flush();
    }

    /** Below the ground plane of Gazebo, which is no object, a robot would drive under all walls. */
    private static void tellFall(DriveRun run, GeometryObject object, PrintWriter out) {
        String name = object.name();
        if (name == null) {
            return;
        }
        DriveRun.Track track = run.tracks().get(name);
        if (track == null || !track.others().contains(DriveRun.GROUND)) {
            return;
        }
        Bounds bounds = object.bounds();
        double fall = track.first().center().y() - track.last().center().y();
        if (fall > bounds.maxY() - bounds.minY()) {
            out.println(Text.quoted(name) + " has fallen " + number(fall)
                    + " m, onto the lower border of the world; if there"
                    + " should have been a floor, add one to the world, or drive with --planar");
        }
    }

    private static String words(DriveRun.Track track, boolean isSpatial) {
        BodyAnswer at = track.last();
        double vx = at.velocity().x();
        double vy = at.velocity().y();
        double vz = at.velocity().z();
        String others = String.join(", ", track.others());
        return "at (" + number(at.center().x()) + ", "
                + (isSpatial ? number(at.center().y()) + ", " : "")
                + number(at.center().z()) + "), heading "
                + number(Degrees.toDegrees(at.heading())) + ", " + number(Math.sqrt(vx * vx + vy * vy + vz * vz))
                + " m/s, after "
                + number(track.way()) + " m"
                + (track.met() == 0
                        ? ""
                        : "; met " + others + " (" + track.met() + ", first at " + number(track.firstMet()) + " s)");
    }

    private static String number(double value) {
        return NumberText.digits(Math.abs(value) < 1e-9 ? 0 : value, DIGITS);
    }
}
