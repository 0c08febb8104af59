package robosim.geometry.world.shared;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;

/** Opens regular files only: reading a pipe may block forever, and a device may never end. */
public final class RegularFile {
    private RegularFile() {}

    /** Opens a file after following all links. */
    public static InputStream open(Path file) throws IOException {
        if (Files.exists(file) && !Files.isRegularFile(file)) {
            throw new FileProblem(
                    file.toString(),
                    0,
                    0,
                    Files.isDirectory(file)
                            ? "the path must be that of a file; name one in this folder (got: a folder)"
                            : "the file must be a regular one; save the output of a pipe or device to one (got: a pipe,"
                                    + " a socket or a device)");
        }
        return Files.newInputStream(file);
    }
}
