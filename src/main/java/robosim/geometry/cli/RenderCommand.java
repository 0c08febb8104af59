package robosim.geometry.cli;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import robosim.geometry.viewer.Painter;
import robosim.geometry.viewer.Pictures;
import robosim.geometry.viewer.Theme;
import robosim.geometry.world.WorldReader;

/** Draws a world file. */
@Command(name = "render", description = "Draws a world from above.", mixinStandardHelpOptions = true)
final class RenderCommand implements Callable<Integer> {
    @Spec
    @SuppressWarnings("NullAway.Init") // set by picocli before call()
    private CommandSpec spec;

    @Parameters(paramLabel = "WORLD", description = "a world file, as in worlds/")
    private Path world = Path.of("worlds/rooms.xml");

    @Option(
            names = {"-o", "--output"},
            paramLabel = "FILE",
            required = true,
            description = "the picture to write: .svg or .png")
    private Path output = Path.of("world.svg");

    @Option(names = "--dark", description = "a .png on dark paper; an .svg follows its reader")
    private boolean dark;

    private RenderCommand() {}

    @Override
    public Integer call() throws Exception {
        String name = output.toString().toLowerCase(Locale.ROOT);
        if (!name.endsWith(".svg") && !name.endsWith(".png")) {
            throw new ParameterException(spec.commandLine(), "FILE must end in .svg or .png (got: " + output + ")");
        }
        if (!Files.isRegularFile(world)) {
            throw new ParameterException(spec.commandLine(), "WORLD must be a file (got: " + world + ")");
        }
        Painter.write(Pictures.of(WorldReader.read(world), Pictures.title(world)), theme(), output);
        spec.commandLine().getOut().println("Wrote " + output);
        return 0;
    }

    private Theme theme() {
        return dark ? Theme.DARK : Theme.LIGHT;
    }
}
