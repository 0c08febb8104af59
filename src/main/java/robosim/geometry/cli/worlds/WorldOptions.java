package robosim.geometry.cli.worlds;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import robosim.geometry.check.Text;
import robosim.geometry.cli.terminal.Arguments;
import robosim.geometry.cli.terminal.UsageException;
import robosim.geometry.cli.terminal.WorldFiles;
import robosim.geometry.world.SdfSensor;
import robosim.geometry.world.World;
import robosim.geometry.world.WorldException;

/** Which world a command looks at. */
public final class WorldOptions {
    @Spec(Spec.Target.MIXEE)
    @SuppressWarnings("NullAway.Init") // set by picocli before call()
    private CommandSpec spec;

    @Parameters(paramLabel = "WORLD", description = "a world in any format that convert reads")
    private Path world = Path.of("");

    @Mixin
    @SuppressWarnings("NullAway.Init") // set by picocli before call()
    private WorldFiles files;

    private WorldOptions() {}

    Path file() {
        return world;
    }

    World read() throws WorldException {
        Arguments.input("WORLD", world);
        return files.world(world);
    }

    /** Reads another world, given for the parameter. */
    World other(String parameter, Path file) throws WorldException {
        return files.world(Arguments.input(parameter, file));
    }

    /** Refuses a file to write that is one of those that the world was read from. */
    void keep(String parameter, Path output) throws IOException {
        files.output(parameter, output);
    }

    /**
     * A sensor that the world's file describes; warns of what is not applied.
     *
     * @param option that names it, for messages
     * @param name   in full, or what follows the last {@code ::} of one sensor only
     */
    SdfSensor sensor(String option, String name) throws WorldException {
        String file = world.toString().toLowerCase(Locale.ROOT);
        Arguments.refuse(
                !file.endsWith(".sdf") && !file.endsWith(".world"), option + " must be for a WORLD in SDFormat", world);
        List<SdfSensor> all = SdfSensor.read(world, files.folders());
        List<SdfSensor> found = all.stream()
                .filter(each -> each.name().equals(name) || each.name().endsWith("::" + name))
                .toList();
        for (SdfSensor each : found) {
            if (each.name().equals(name)) {
                return warned(each);
            }
        }
        if (found.size() != 1) {
            List<String> names = (found.isEmpty() ? all : found)
                    .stream().map(SdfSensor::name).toList();
            throw new UsageException(option + " must name a sensor of WORLD, "
                    + (names.isEmpty() ? "which has none" : Text.choice(name, names)) + " (got: " + name
                    + ")");
        }
        return warned(found.get(0));
    }

    private SdfSensor warned(SdfSensor found) {
        found.ignored().ifPresent(what -> spec.commandLine().getErr().println("warning: " + what));
        return found;
    }
}
