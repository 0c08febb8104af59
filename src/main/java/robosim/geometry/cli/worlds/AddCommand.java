package robosim.geometry.cli.worlds;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import robosim.geometry.cli.terminal.Arguments;
import robosim.geometry.cli.terminal.ExitCodes;
import robosim.geometry.cli.terminal.UsageException;
import robosim.geometry.cli.terminal.WorldFiles;
import robosim.geometry.world.World;
import robosim.geometry.world.WorldObject;
import robosim.geometry.world.WorldWriter;
import robosim.geometry.world.shared.AtomicFileWriter;

/** Puts robots into a world, into a new file. */
@Command(
        name = "add",
        description = {
            "Writes a copy of a world file with one more robot, or several, on the floor of the scene. A world of this"
                    + " module keeps its text, comments included; a map, SDFormat or a mesh is included by a small new"
                    + " world, and stays the file that it is; if OUT is not in its folder or in one around it, OUT has a"
                    + " copy of it.",
            "",
            "X and Z are those of the world; a point (x, y) of a ROS map is X = x, Z = -y."
        },
        footer = {
            "  robosim-geometry add arena.xml with-robots.xml disc:0.3@1,2 box:0.6x0.4@-2,0,90",
            "  robosim-geometry add map.yaml world.xml disc:0.3@1,2#ff8000 --sonars 16",
            "  robosim-geometry add map.yaml world.xml scout=disc:0.2x0.5@0,0 --sonars 16"
        })
public final class AddCommand implements Callable<Integer> {
    private static final String END = "</world>";

    /** As many as a ring may have. */
    private static final int MOST_SONARS = 10_000;

    @Spec
    private CommandSpec spec;

    @Parameters(index = "0", paramLabel = "IN", description = "a world, or any file that convert reads")
    private Path in = Path.of("");

    @Parameters(
            index = "1",
            paramLabel = "OUT",
            description = "the world file to write (.xml), none of those that are read")
    private Path out = Path.of("");

    @Parameters(index = "2..*", arity = "1..*", paramLabel = "ROBOT", description = RobotSpec.FORM)
    private List<String> robots = new ArrayList<>();

    @Option(
            names = "--sonars",
            paramLabel = "COUNT",
            defaultValue = "0",
            description =
                    "sonars around each robot, cones of 15 degrees with a range of 6 m (6 units in a world without a"
                            + " unit); 0 for none (default: ${DEFAULT-VALUE})")
    private int sonars;

    @Mixin
    private WorldFiles files;

    private String note = "";

    @Override
    public Integer call() throws IOException {
        Arguments.input("IN", in);
        Arguments.output("OUT", out, ".xml");
        if (sonars < 0 || sonars > MOST_SONARS) {
            throw new UsageException("--sonars must be from 0 to " + MOST_SONARS + " (got: " + sonars + ")", null);
        }
        World world = files.world(in);
        files.output("OUT", out);
        int before = world.objects().size();
        try {
            for (String robot : robots) {
                world = RobotSpec.add(world, robot, sonars);
                RobotSpec.warn(world, spec.commandLine().getErr());
            }
        } catch (IllegalArgumentException e) {
            throw new UsageException(String.valueOf(e.getMessage()), e);
        }
        List<WorldObject> added =
                world.objects().subList(before, world.objects().size());
        String text = text(world, added);
        AtomicFileWriter.write(out, stream -> stream.write(text.getBytes(StandardCharsets.UTF_8)));
        PrintWriter printer = spec.commandLine().getOut();
        added.forEach(each -> printer.println("Added " + each.object()));
        printer.println("Wrote " + out + note);
        return ExitCodes.FINE;
    }

    private String text(World world, List<WorldObject> added) throws IOException {
        String own = WorldWriter.toXml(world.withObjects(added));
        String elements = own.substring(own.indexOf('\n', own.indexOf("<world ")) + 1, own.lastIndexOf(END));
        if (in.toString().toLowerCase(Locale.ROOT).endsWith(".xml")) {
            String given = Files.readString(in);
            int end = given.lastIndexOf(END);
            boolean isBeside = in.toAbsolutePath()
                    .resolveSibling("")
                    .equals(out.toAbsolutePath().resolveSibling(""));
            boolean hasFiles = given.contains("file=");
            if (end >= 0 && (isBeside || !hasFiles)) {
                return given.substring(0, end) + elements + given.substring(end);
            }
            return WorldWriter.toXml(world);
        }
        Path folder = out.toAbsolutePath().normalize().resolveSibling("");
        Path file = in.toAbsolutePath().normalize();
        if (!file.startsWith(folder)) { // which an include could not name
            note = ", with a copy of what is in " + in + ", which is not in its folder or in one below";
            return WorldWriter.toXml(world);
        }
        String name = folder.relativize(file).toString().replace('\\', '/');
        String begin = own.substring(0, own.length() - elements.length() - END.length() - 1);
        return begin + "  <include file=\"" + escaped(name) + "\"/>\n" + elements + END + "\n";
    }

    private static String escaped(String name) {
        return name.replace("&", "&amp;").replace("<", "&lt;").replace("\"", "&quot;");
    }
}
