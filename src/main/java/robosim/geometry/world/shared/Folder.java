package robosim.geometry.world.shared;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;

/** Locates files that another file names: only within the tree of its folder. */
public final class Folder {
    private Folder() {}

    /**
     * Locates a file that exists and is within the tree of a folder, also after following links.
     *
     * @param owner what kind of file names it, for messages
     * @param kind  what kind of file it is, for messages
     * @throws IllegalArgumentException saying what is wrong with the name
     */
    public static Path locate(Path base, String file, String owner, String kind) throws IOException {
        try {
            if (file.indexOf('\\') >= 0) {
                throw outside(file, owner);
            }
            Path path = base.resolve(file).normalize();
            if (Path.of(file).isAbsolute() || !path.startsWith(base.normalize())) {
                throw outside(file, owner);
            }
            if (!Files.isRegularFile(path)) {
                throw new IllegalArgumentException(
                        "there is no such " + kind + " file in " + base + "; check the path (got: " + file + ")");
            }
            Path real = path.toRealPath();
            if (!real.startsWith(base.toRealPath())) {
                throw outside(file, owner);
            }
            return real;
        } catch (InvalidPathException e) {
            throw new IllegalArgumentException("file must be a path (got: " + file + ")", e);
        }
    }

    private static IllegalArgumentException outside(String file, String owner) {
        return new IllegalArgumentException("file must be a path with / relative to the " + owner
                + " file's folder, and stay inside it (got: " + file + ")");
    }
}
