package robosim.geometry.world;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Path;
import java.util.Locale;
import robosim.geometry.exact.Checks;
import robosim.geometry.model.MeshObject;

/** What the readers of meshes share: how a file is opened, what a scale may be, and which reader a file's name asks for. */
final class MeshFiles {
    private MeshFiles() {}

    /** A reader of one format: of a stream, which it leaves open. */
    @FunctionalInterface
    interface Format {
        MeshObject read(InputStream in, String source, double scale) throws WorldException;
    }

    /** Whether a name ends as those of the formats do that are read: .obj and .stl. */
    static boolean isNamed(String file) {
        return isStl(file) || file.toLowerCase(Locale.ROOT).endsWith(".obj");
    }

    private static boolean isStl(String file) {
        return file.toLowerCase(Locale.ROOT).endsWith(".stl");
    }

    /** The surface of a file, in the format that its name ends in; OBJ where that tells nothing. */
    static MeshObject read(Path file, double scale) throws WorldException {
        return read(file, scale, isStl(file.toString()) ? StlReader::read : ObjReader::read);
    }

    static MeshObject read(Path file, double scale, Format format) throws WorldException {
        Checks.present("file", file);
        try (InputStream in = RegularFile.open(file)) {
            return format.read(in, file.toString(), scale);
        } catch (IOException e) {
            throw WorldException.unreadable(file, e);
        }
    }

    static void checkScale(double scale) {
        if (!(scale > 0 && scale <= 0x1p100)) { // written so that NaN fails it
            throw new IllegalArgumentException("scale must be a number above 0, up to 2^100 (got: " + scale + ")");
        }
    }
}
