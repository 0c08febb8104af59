package robosim.geometry.world.rosmap;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.Folder;
import robosim.geometry.world.shared.Limits;
import robosim.geometry.world.shared.RegularFile;

/** Opens the two files of a map: its settings, and the image that they name. */
public final class MapFiles {
    private MapFiles() {}

    /** The settings of a map. */
    public static MapSettings settings(Path yaml) throws FileProblem {
        byte[] bytes = bytes(yaml, Limits.MAX_SETTINGS);
        try {
            return MapSettings.parse(new String(bytes, StandardCharsets.UTF_8), yaml.toString());
        } catch (NoClassDefFoundError e) {
            throw new FileProblem(
                    yaml.toString(),
                    0,
                    0,
                    "ROS maps need snakeyaml-engine, which is not on the class path: add"
                            + " org.snakeyaml:snakeyaml-engine:3.0.1 or newer (missing: " + e.getMessage() + ")",
                    e);
        }
    }

    /** The cells of the image that the settings name. */
    public static OccupancyGrid grid(Path yaml, MapSettings settings) throws FileProblem {
        Path image;
        try {
            image = Folder.locate(yaml.toAbsolutePath().resolveSibling(""), settings.image(), "map", "image");
        } catch (IllegalArgumentException e) {
            throw new FileProblem(yaml.toString(), settings.imageLine(), 0, String.valueOf(e.getMessage()), e);
        } catch (IOException e) {
            throw new FileProblem(yaml.toString(), settings.imageLine(), 0, "the image could not be read: " + e, e);
        }
        byte[] bytes = bytes(image, Limits.MAX_BYTES);
        return PngReader.isPng(bytes)
                ? PngReader.read(bytes, image.toString(), settings)
                : PgmReader.read(bytes, image.toString(), settings);
    }

    private static byte[] bytes(Path file, long most) throws FileProblem {
        try (InputStream in = RegularFile.open(file)) {
            byte[] bytes = in.readNBytes((int) most + 1);
            if (bytes.length > most) {
                throw new FileProblem(
                        file.toString(), 0, 0, "the file must have at most " + most + " bytes (got: more)");
            }
            return bytes;
        } catch (IOException e) {
            throw FileProblem.unreadable(file, e);
        }
    }
}
