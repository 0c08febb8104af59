package robosim.geometry.cli.worlds;

import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import robosim.geometry.check.NumberText;
import robosim.geometry.cli.terminal.Arguments;
import robosim.geometry.cli.terminal.ExitCodes;
import robosim.geometry.cli.terminal.Progress;
import robosim.geometry.cli.terminal.UsageException;
import robosim.geometry.cli.terminal.WorldFiles;
import robosim.geometry.export.GlbWriter;
import robosim.geometry.export.RosRecording;
import robosim.geometry.model.Bounds;
import robosim.geometry.model.Dimension;
import robosim.geometry.viewer.playback.Pictures;
import robosim.geometry.world.ImportOptions;
import robosim.geometry.world.World;
import robosim.geometry.world.WorldImport;
import robosim.geometry.world.WorldWriter;

/** Converts a file of another format to a world file. */
@Command(
        name = "convert",
        description = "Reads a world, a ROS map, an SDFormat file or a mesh, and writes it as a world, or as a mesh for"
                + " other viewers. Reports what was read, what was left out and why, and what was written.",
        exitCodeList = {
            ExitCodes.DONE,
            ExitCodes.FINDINGS + ":with --strict: something of IN would be left out, and OUT was not written",
            ExitCodes.REFUSED,
            ExitCodes.PARTIAL + ":OUT was written, without the parts of IN that were left out"
        },
        footer = {
            "  robosim-geometry convert map.yaml --wall-height 0.5 map.xml",
            "  robosim-geometry convert map.yaml world.xml --robot disc:0.3@1,2 --unknown edge",
            "  robosim-geometry convert arena.world --models ~/.gazebo/models arena.xml",
            "  robosim-geometry convert part.stl --scale 0.001 --up z part.xml",
            "  robosim-geometry convert worlds/rooms.xml rooms.glb",
            "  robosim-geometry convert recordings/session.scenario.jsonl session.mcap"
        })
public final class ConvertCommand implements Callable<Integer> {
    private static final int MOST_LINES = 20;

    private static final Set<String> MESHES = Set.of("Wavefront OBJ", "STL", "COLLADA", "PLY", "glTF");
    private static final List<String> OPTIONS_OF_MAPS = List.of("--wall-height", "--unknown", "--centred");
    private static final List<String> OPTIONS_OF_MESHES = List.of("--scale", "--up");

    private static final int DIGITS = 6;

    @Spec
    private CommandSpec spec;

    @Parameters(
            index = "0",
            paramLabel = "IN",
            description =
                    "a world (.xml), a ROS map (.yaml), SDFormat (.sdf, .world, or a model's folder), Stage (.world), a robot (.urdf),"
                            + " a mesh (.obj, .stl, .dae, .ply, .glb, .gltf), or a recording (*.jsonl"
                            + ")")
    private Path in = Path.of("");

    @Parameters(
            index = "1",
            paramLabel = "OUT",
            description =
                    "the file to write: a world (.xml), or for other viewers glTF (.glb) or the triangles of all its"
                            + " objects (.obj); of a recording ROS 2 messages (.mcap) or a log for AdvantageScope (.wpilog)")
    private Path out = Path.of("");

    @Option(
            names = "--wall-height",
            paramLabel = "METRES",
            defaultValue = "2",
            description = "height of a map's walls (default: ${DEFAULT-VALUE})")
    private double wallHeight;

    @Option(
            names = "--scale",
            paramLabel = "UNITS",
            defaultValue = "1",
            description = "world units per mesh unit: 0.001 for a mesh in millimetres and a world in metres (default:"
                    + " ${DEFAULT-VALUE})")
    private double scale;

    @Option(
            names = "--up",
            paramLabel = "AXIS",
            defaultValue = "y",
            description = "which axis of an OBJ, STL or PLY mesh points up: y or z (default: ${DEFAULT-VALUE})")
    private ImportOptions.Up up = ImportOptions.Up.Y;

    @Mixin
    private WorldFiles files;

    @Option(
            names = "--unknown",
            paramLabel = "KIND",
            defaultValue = "free",
            description =
                    "what a map's unknown cells are: free, occupied, or edge, an object of their own that ends the"
                            + " map (default: ${DEFAULT-VALUE})")
    private ImportOptions.Unknown unknown = ImportOptions.Unknown.FREE;

    @Option(
            names = "--centred",
            description = "the middle of a map's image is the world's centre, so that the world is as large as the map;"
                    + " else the origin of the map's frame is")
    private boolean centred;

    @Option(
            names = "--dimension",
            paramLabel = "KIND",
            description = "planar, where heights do not count, or spatial (default: as in IN; a ROS map is planar)")
    private @Nullable Dimension dimension;

    @Option(
            names = "--robot",
            paramLabel = "ROBOT",
            description = "a robot on the floor: " + RobotSpec.FORM + "; may be repeated")
    private List<String> robots = new ArrayList<>();

    @Option(names = "--strict", description = "if anything would be left out, write nothing and exit with 1")
    private boolean strict;

    @Option(names = "--all", description = "list everything that is left out, instead of the first " + MOST_LINES)
    private boolean all;

    @Override
    public Integer call() throws Exception {
        if (RecordingOptions.isRecording(in)) {
            if (!Files.isDirectory(in)) {
                Arguments.input("IN", in);
            }
            Arguments.output("OUT, of a recording,", out, RosRecording.MCAP, RosRecording.WPILOG);
            ExportCommand.writeMessages(spec, in, out, RosRecording.TICK);
            return ExitCodes.FINE;
        }
        String ending = ending();
        if (!Files.isDirectory(in)) {
            Arguments.input("IN", in);
        }
        WorldImport read = files.read(in, options());
        files.output("OUT", out);
        PrintWriter printer = spec.commandLine().getOut();
        read.lines(all ? Integer.MAX_VALUE : MOST_LINES).forEach(printer::println);
        tellUnused(read.format());
        if (strict && !read.isWhole()) {
            printer.println(
                    "Wrote nothing: --strict was given, and " + read.skipped().size() + " would be left out");
            return ExitCodes.FINDINGS;
        }
        World world = withRobots(read.world());
        try (Progress progress =
                Progress.of(spec.commandLine(), "objects", world.objects().size())) {
            switch (ending) {
                case ".obj" -> WorldWriter.writeObj(world, out, progress::at);
                case ".glb" -> GlbWriter.write(world, Pictures.title(in), out, progress::at);
                default -> WorldWriter.write(world, out);
            }
        }
        printer.println(written(world));
        return read.isWhole() ? ExitCodes.FINE : ExitCodes.PARTIAL;
    }

    /** Warns of options that mean nothing to a file of this format; a world file may include any of them. */
    private void tellUnused(String format) {
        boolean mayInclude = format.equals("world") && files.areSeveral();
        boolean isMap = format.equals("ROS map") || mayInclude;
        boolean isMesh = MESHES.contains(format) || mayInclude;
        for (String option : OPTIONS_OF_MAPS) {
            warn(option, !isMap, "maps", format);
        }
        for (String option : OPTIONS_OF_MESHES) {
            warn(option, !isMesh, "meshes that are read by themselves", format);
        }
    }

    private void warn(String option, boolean isUnused, String use, String format) {
        if (isUnused && spec.commandLine().getParseResult().hasMatchedOption(option)) {
            spec.commandLine()
                    .getErr()
                    .println("warning: " + option + " is for " + use + " and changes nothing here (got: " + format
                            + ")");
        }
    }

    private World withRobots(World read) {
        World world = read;
        try {
            for (String robot : robots) {
                world = RobotSpec.add(world, robot, 0);
                RobotSpec.warn(world, spec.commandLine().getErr());
            }
            return world;
        } catch (IllegalArgumentException e) {
            throw new UsageException("--robot: " + e.getMessage(), e);
        }
    }

    /** How OUT ends. */
    private String ending() {
        String name = out.toString().toLowerCase(Locale.ROOT);
        Arguments.output("OUT", out, ".xml", ".glb", ".obj");
        return name.substring(name.length() - 4);
    }

    private ImportOptions options() {
        try {
            return new ImportOptions(wallHeight, scale, up, List.of(), unknown, centred, dimension);
        } catch (IllegalArgumentException e) {
            throw new UsageException(String.valueOf(e.getMessage()), e);
        }
    }

    private String written(World world) {
        int objects = world.objects().size();
        StringBuilder line = new StringBuilder("Wrote " + out + ": " + NumberText.count(objects, "object"));
        long moveable = world.objects().stream()
                .filter(each -> each.object().isMoveable())
                .count();
        line.append(moveable == 0 ? "" : ", " + moveable + " of them moveable");
        String unit = Pictures.unit(world);
        line.append(String.format(
                Locale.ROOT,
                "; the world is %s x %s x %s%s",
                NumberText.digits(world.width(), DIGITS),
                NumberText.digits(world.height(), DIGITS),
                NumberText.digits(world.length(), DIGITS),
                unit.isEmpty() ? "" : " " + unit));
        world.objects().stream()
                .map(each -> each.object().bounds())
                .reduce(Bounds::and)
                .ifPresent(all -> line.append(", the objects reach ")
                        .append(reach("X", all.minX(), all.maxX()))
                        .append(reach(", Y", all.minY(), all.maxY()))
                        .append(reach(", Z", all.minZ(), all.maxZ())));
        return line.toString();
    }

    private static String reach(String axis, double least, double most) {
        return axis + " " + NumberText.digits(least, DIGITS) + " to " + NumberText.digits(most, DIGITS);
    }
}
