package robosim.geometry.cli.network;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Option;
import robosim.geometry.cli.terminal.Arguments;
import robosim.geometry.cli.terminal.UsageException;
import robosim.geometry.net.NetOptions;
import robosim.geometry.scenario.Recordings;

/** How {@code serve} and {@code connect} record their sessions. */
public final class RecordOptions {
    @Option(
            names = "--record",
            paramLabel = "PLACE",
            description = "record each session as a scenario for `replay`: serve takes a folder and writes a"
                    + " file for each connection; connect takes a file, and numbers those of further connections")
    private @Nullable Path place;

    @Option(
            names = "--record-bytes",
            paramLabel = "N",
            description =
                    "largest size of a file; at that size recording stops and the session goes on (default: 1 GiB)")
    private long bytes = Recordings.DEFAULT_BYTES;

    /** Records into a folder, which is created if it does not exist. */
    NetOptions inFolder(NetOptions options) {
        Path folder = place;
        if (folder == null) {
            return options;
        }
        try {
            Files.createDirectories(folder);
        } catch (IOException e) {
            throw new UsageException(
                    "--record must be a folder, or a path where one can be created (got: " + folder + ")");
        }
        if (!Files.isWritable(folder)) {
            throw new UsageException("--record must be a folder that can be written to (got: " + folder + ")");
        }
        return options.withListeners(limited(Recordings.inFolder(folder, options.session())));
    }

    /** Records into a new file in an existing folder. */
    NetOptions inFile(NetOptions options) {
        Path file = place;
        if (file == null) {
            return options;
        }
        return options.withListeners(
                limited(Recordings.inFile(Arguments.newFile("--record", file), options.session())));
    }

    private Recordings limited(Recordings recordings) {
        if (bytes < 1) {
            throw new UsageException("--record-bytes must be at least 1 (got: " + bytes + ")");
        }
        return recordings.atMost(bytes);
    }
}
