package robosim.geometry.world.rosmap;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.Folder;
import robosim.geometry.world.shared.ImageFiles;
import robosim.geometry.world.shared.Limits;
import robosim.geometry.world.shared.PlainBytes;
import robosim.geometry.world.shared.RegularFile;

/** Opens the two files of a map: its settings, and the image that they name. */
public final class MapFiles {
    private MapFiles() {}

    /** The settings of a map. */
    public static MapSettings settings(Path yaml) throws FileProblem {
        byte[] bytes = PlainBytes.of(RegularFile.bytes(yaml, Limits.MAX_SETTINGS));
        try {
            return MapSettings.parse(new String(bytes, StandardCharsets.UTF_8), yaml.toString());
        } catch (NoClassDefFoundError e) {
            throw new FileProblem(
                    yaml.toString(),
                    "ROS maps need snakeyaml-engine, which is not on the class path: add"
                            + " org.snakeyaml:snakeyaml-engine:3.0.1 or newer (missing: " + e.getMessage() + ")",
                    e);
        }
    }

    /**
     * The cells of the image that the settings name.
     *
     * @param remarks receives what a user should know
     */
    public static OccupancyGrid grid(Path yaml, MapSettings settings, List<String> remarks) throws FileProblem {
        Path image;
        try {
            image = Folder.locate(
                    yaml.toAbsolutePath().resolveSibling(""), name(yaml, settings, remarks), "map", "image");
        } catch (IllegalArgumentException e) {
            throw new FileProblem(yaml.toString(), settings.imageLine(), 0, String.valueOf(e.getMessage()), e);
        } catch (IOException e) {
            throw new FileProblem(yaml.toString(), settings.imageLine(), 0, "the image could not be read: " + e, e);
        }
        MapPixels pixels = new MapPixels(settings);
        ImageFiles.read(image, pixels);
        return pixels.grid();
    }

    /** The image's name relative to the settings: of an absolute path, which ROS 1 writes, the last part. */
    private static String name(Path yaml, MapSettings settings, List<String> remarks) {
        String image = settings.image();
        if (!image.startsWith("/")) {
            return image;
        }
        String name = image.substring(image.lastIndexOf('/') + 1);
        if (name.isEmpty()) {
            throw new IllegalArgumentException("image must be the path of a file (got: " + image + ")");
        }
        remarks.add(yaml + ":" + settings.imageLine()
                + ": image should be a path relative to this file; read is the file of that name beside this one, "
                + name + " (got: " + image + ")");
        return name;
    }
}
