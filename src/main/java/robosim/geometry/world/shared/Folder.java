package robosim.geometry.world.shared;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
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

    /** A path whose special characters are written as {@code %} and two digits for each of their bytes. */
    public static String decoded(String uri) {
        if (uri.indexOf('%') < 0) {
            return uri;
        }
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        byte[] given = uri.getBytes(StandardCharsets.UTF_8);
        for (int k = 0; k < given.length; k++) {
            int high = given[k] == '%' && k + 2 < given.length ? Character.digit(given[k + 1], 16) : -1;
            int low = high < 0 ? -1 : Character.digit(given[k + 2], 16);
            if (given[k] == '%' && low < 0) {
                throw new IllegalArgumentException("% must be followed by two hexadecimal digits (got: " + uri + ")");
            }
            bytes.write(low < 0 ? given[k] : 16 * high + low);
            k += low < 0 ? 0 : 2;
        }
        return bytes.toString(StandardCharsets.UTF_8);
    }
}
