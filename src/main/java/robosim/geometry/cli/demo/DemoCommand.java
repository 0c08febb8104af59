package robosim.geometry.cli.demo;

import java.io.IOException;
import java.io.PrintWriter;
import java.net.InetAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;
import robosim.geometry.cli.terminal.Arguments;
import robosim.geometry.cli.terminal.ExitCodes;
import robosim.geometry.cli.terminal.Terminal;
import robosim.geometry.cli.terminal.UsageException;
import robosim.geometry.cli.terminal.WireFiles;
import robosim.geometry.cli.terminal.WorldFiles;
import robosim.geometry.net.GeometryClient;
import robosim.geometry.net.GeometryServer;
import robosim.geometry.net.NetOptions;
import robosim.geometry.scenario.source.WireReader;
import robosim.geometry.viewer.draw.Painter;
import robosim.geometry.viewer.draw.Theme;
import robosim.geometry.viewer.playback.Pictures;
import robosim.geometry.viewer.scene.Scene;
import robosim.geometry.world.World;
import robosim.geometry.world.WorldWriter;

/**
 * Shows the module at work in one command: a world, two processes, a conversation, an audit, a picture and a summary.
 */
@Command(
        name = "demo",
        description =
                "Lets the robots of a world wander. The reference environment and this module run as two processes"
                        + " over TCP. Writes a picture, the recording and a summary, and fails if the audit of the"
                        + " recording finds anything wrong.",
        showDefaultValues = true,
        exitCodeList = {
            ExitCodes.FINE + ":the audit found nothing wrong",
            ExitCodes.FINDINGS + ":the audit found something wrong",
            ExitCodes.REFUSED
        },
        footer = {
            "  robosim-geometry demo",
            "  robosim-geometry demo --world worlds/warehouse.xml --steps 500 --seed 7 -o warehouse",
            "  robosim-geometry demo --drive --steps 1000"
        })
public final class DemoCommand implements Callable<Integer> {
    @Spec
    private CommandSpec spec;

    @Option(
            names = "--world",
            paramLabel = "FILE",
            defaultValue = Option.NULL_VALUE,
            description = "a world with moveable objects, in any format that convert reads (default: worlds/rooms.xml,"
                    + " which the jar contains)")
    private @Nullable Path world;

    @Option(names = "--steps", paramLabel = "N", description = "rounds of sonar and moves")
    private int steps = 3000;

    @Option(
            names = "--seed",
            paramLabel = "S",
            description = "seed of the robots' random choices; the same seed gives the same conversation")
    private long seed = 1;

    @Option(names = "--speed", paramLabel = "V", description = "world units that a robot advances in a step")
    private double speed = 0.05;

    @Option(
            names = {"-o", "--output"},
            paramLabel = "DIR",
            defaultValue = Option.NULL_VALUE,
            description =
                    "folder for the results (default: target/demo if there is a folder target, else robosim-demo)")
    private @Nullable Path place;

    @Option(
            names = "--drive",
            description =
                    "hands the movement over: in steps of 0.1 s the robots are driven, slide, push and bump, instead of"
                            + " asking for moves of which some are refused")
    private boolean drive;

    @Option(names = "--dial", description = "the environment listens and this module dials, as in RoboSim")
    private boolean dial;

    @Option(
            names = "--examples",
            paramLabel = "DIR",
            defaultValue = Option.NULL_VALUE,
            description = "folder of the two programs' sources (default: the jar contains both; without a jar,"
                    + " the project's folder examples)")
    private @Nullable Path examples;

    @Mixin
    private WorldFiles files;

    private final Timings timings = new Timings();
    private Path output = Path.of("");

    @Override
    public Integer call() throws Exception {
        Arguments.refuse(steps < 1, "--steps must be at least 1", steps);
        Arguments.refuse(seed < 0, "--seed must be at least 0", seed);
        Arguments.refuse(!(speed > 0 && speed < 1e9), "--speed must be above 0", speed);
        List<String> environment = program("ReferenceEnvironment");
        List<String> audit = program("ConversationAudit");
        output = place != null ? place : Path.of(Files.isDirectory(Path.of("target")) ? "target/demo" : "robosim-demo");
        Path given = world == null ? null : Arguments.input("--world", world);
        Files.createDirectories(output);
        Path worldFile = given != null ? given : rooms();
        World loaded = files.world(worldFile);
        if (!String.valueOf(worldFile.getFileName()).endsWith(".xml")) {
            worldFile = files.output("--output", output.resolve("world.xml"));
            WorldWriter.write(loaded, worldFile);
        }
        PrintWriter out = spec.commandLine().getOut();

        int code = converse(environment, worldFile);
        if (code != 0) {
            return code;
        }
        String verdict;
        int audited;
        try (Program auditor = Program.start(audit, false, List.of(output.toString()))) {
            audited = auditor.end();
            verdict = auditor.text();
        }
        Summary summary = new Summary(output, timings);
        Scene scene = Pictures.of(loaded, Pictures.title(worldFile));
        scene = scene.described(summary.line(audited == 0), Pictures.unit(loaded));
        try (WireReader talk = WireFiles.open(output.resolve(WireFiles.TO_MODULE))) {
            scene = Pictures.whole(talk, scene);
        }
        Painter.write(scene, Theme.LIGHT, output.resolve("world.svg"));
        Painter.write(scene, Theme.LIGHT, output.resolve("world.png"));
        String text = summary.text(verdict);
        Files.writeString(output.resolve("summary.txt"), text);
        out.print(text);
        out.println("Picture and recording: " + output.resolve("world.svg") + ", world.png, to-module.bin,"
                + " from-module.bin, summary.txt");
        out.flush();
        return audited == 0 ? 0 : ExitCodes.FINDINGS;
    }

    /** What to start: a class of the jar, or a source file. */
    private List<String> program(String name) {
        if (examples == null && Program.isInJar() && DemoProgram.find(name) != null) {
            return List.of(DemoProgram.class.getName(), name);
        }
        String folder = examples == null ? "examples" : examples.toString();
        return List.of(projectFile("--examples", folder + "/" + name + ".java").toString());
    }

    /** The demo's world: the copy in the jar, or else the project's file. */
    private Path rooms() throws IOException {
        return Program.isInJar() ? DemoProgram.world("rooms.xml", output) : projectFile("--world", "worlds/rooms.xml");
    }

    private Path projectFile(String option, String name) {
        Path file = Program.projectFile(name);
        if (file == null || !Files.isRegularFile(file)) {
            throw new UsageException(
                    option + " must name a file that exists; start this in the project's folder, or name another (got: "
                            + name + ")");
        }
        return file;
    }

    /** Runs the environment against this process and returns the exit code. */
    private int converse(List<String> environment, Path worldFile) throws IOException, InterruptedException {
        NetOptions options = NetOptions.defaults().withListeners(connection -> timings);
        boolean watched = Terminal.isPresent();
        if (dial) {
            try (Program program =
                    Program.start(environment, watched, arguments(worldFile, watched, "--listen", "0"))) {
                String line = program.line();
                if (line != null && line.matches("Listening on port \\d+")) {
                    int port = Integer.parseInt(line.substring(line.lastIndexOf(' ') + 1));
                    new GeometryClient("localhost", port, options).run();
                }
                return end(program);
            }
        }
        try (GeometryServer server = new GeometryServer(InetAddress.getLoopbackAddress(), 0, options)) {
            String place = InetAddress.getLoopbackAddress().getHostAddress() + ":" + server.port();
            try (Program program =
                    Program.start(environment, watched, arguments(worldFile, watched, "--connect", place))) {
                return end(program);
            }
        }
    }

    private int end(Program program) throws IOException, InterruptedException {
        int code = program.end();
        if (code != 0) {
            spec.commandLine().getErr().print(program.text());
            spec.commandLine().getErr().println("The environment exited with code " + code);
        }
        return code;
    }

    private List<String> arguments(Path worldFile, boolean watched, String... place) {
        List<String> arguments = new ArrayList<>(List.of(place));
        arguments.addAll(List.of("--world", worldFile.toString(), "--record", output.toString()));
        arguments.addAll(List.of("--steps", String.valueOf(steps), "--seed", String.valueOf(seed)));
        arguments.addAll(List.of("--speed", String.valueOf(speed), watched ? "--progress" : "--quiet"));
        if (drive) {
            arguments.add("--drive");
        }
        return arguments;
    }
}
