package robosim.geometry.cli.terminal;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import robosim.geometry.scenario.ScenarioReader;
import robosim.geometry.scenario.source.StepReader;
import robosim.geometry.scenario.source.WireReader;

/** The two files in which the demo records its conversation: the bytes sent to the module, and those it sent. */
public final class WireFiles {
    public static final String TO_MODULE = "to-module.bin";

    public static final String FROM_MODULE = "from-module.bin";

    private WireFiles() {}

    /** The first of the two files, given their folder or either file; null if the place is neither. */
    public static @Nullable Path at(Path place) {
        if (Files.isDirectory(place)) {
            Path toModule = place.resolve(TO_MODULE);
            return Files.isRegularFile(toModule) ? toModule : null;
        }
        String name = String.valueOf(place.getFileName());
        return name.equals(TO_MODULE) || name.equals(FROM_MODULE) ? place.resolveSibling(TO_MODULE) : null;
    }

    public static WireReader open(Path toModule) throws IOException {
        return WireReader.open(toModule, toModule.resolveSibling(FROM_MODULE));
    }

    /** Opens a recording: the two files, given as to {@link #at}, or a scenario. */
    public static StepReader recording(Path place) throws IOException {
        Path toModule = at(place);
        return toModule == null ? StepReader.of(ScenarioReader.open(place)) : open(toModule);
    }
}
