package robosim.geometry.cli.worlds;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import robosim.geometry.cli.terminal.ExitCodes;
import robosim.geometry.cli.terminal.Inputs;
import robosim.geometry.cli.terminal.Version;
import robosim.geometry.viewer.draw.Painter;
import robosim.geometry.viewer.draw.Theme;
import robosim.geometry.viewer.playback.Pictures;

/** Draws a world file. */
@Command(
        name = "render",
        description = "Draws a world from above.",
        mixinStandardHelpOptions = true,
        versionProvider = Version.class,
        exitCodeListHeading = ExitCodes.HEADING,
        exitCodeList = {ExitCodes.DONE, ExitCodes.REFUSED},
        footerHeading = "%nExamples:%n",
        footer = {
            "  robosim-geometry render worlds/rooms.xml -o rooms.svg",
            "  robosim-geometry render worlds/maze.xml --dark -o maze.png",
            "  robosim-geometry render arena.world --models ~/.gazebo/models -o arena.svg"
        })
public final class RenderCommand implements Callable<Integer> {
    @Spec
    @SuppressWarnings("NullAway.Init") // set by picocli before call()
    private CommandSpec spec;

    @Parameters(paramLabel = "WORLD", description = "a world file, as in worlds/")
    private Path world = Path.of("");

    @Option(
            names = {"-o", "--output"},
            paramLabel = "FILE",
            required = true,
            description = "the picture to write: .svg or .png")
    private Path output = Path.of("world.svg");

    @Option(
            names = "--models",
            paramLabel = "DIR",
            description = "a folder of models for SDFormat's model://, in addition to WORLD's own; may be repeated")
    private List<Path> models = new ArrayList<>();

    @Option(names = "--dark", description = "draw a .png on a dark background; an .svg follows its viewer's theme")
    private boolean dark;

    private RenderCommand() {}

    @Override
    public Integer call() throws Exception {
        String name = output.toString().toLowerCase(Locale.ROOT);
        if (!name.endsWith(".svg") && !name.endsWith(".png")) {
            throw new ParameterException(spec.commandLine(), "FILE must end in .svg or .png (got: " + output + ")");
        }
        Inputs.file(spec, "WORLD", world);
        Painter.write(Pictures.of(Inputs.world(spec, world, models), Pictures.title(world)), theme(), output);
        spec.commandLine().getOut().println("Wrote " + output);
        return 0;
    }

    private Theme theme() {
        return dark ? Theme.DARK : Theme.LIGHT;
    }
}
