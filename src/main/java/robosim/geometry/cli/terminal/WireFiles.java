package robosim.geometry.cli.terminal;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import robosim.geometry.scenario.WireReader;

/** The two files that the demonstration leaves of its conversation: the bytes to the module, and those from it. */
public final class WireFiles {
    public static final String TO_MODULE = "to-module.bin";

    public static final String FROM_MODULE = "from-module.bin";

    private WireFiles() {}

    /** The first of the two where a place is their folder or either of them; null where it is not. */
    public static @Nullable Path at(Path place) {
        if (Files.isDirectory(place)) {
            Path toModule = place.resolve(TO_MODULE);
            return Files.isRegularFile(toModule) ? toModule : null;
        }
        String name = String.valueOf(place.getFileName());
        return name.equals(TO_MODULE) || name.equals(FROM_MODULE) ? place.resolveSibling(TO_MODULE) : null;
    }

    /** Opens the conversation of which a file is the first. */
    public static WireReader open(Path toModule) throws IOException {
        return WireReader.open(toModule, toModule.resolveSibling(FROM_MODULE));
    }
}
