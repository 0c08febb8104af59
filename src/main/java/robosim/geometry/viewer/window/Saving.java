package robosim.geometry.viewer.window;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import robosim.geometry.image.PngWriter;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.viewer.playback.Frame;
import robosim.geometry.viewer.playback.Pictures;
import robosim.geometry.viewer.scene.Scene;
import robosim.geometry.world.World;
import robosim.geometry.world.WorldObject;
import robosim.geometry.world.WorldWriter;
import robosim.geometry.world.shared.AtomicFileWriter;

/** Saves what a window shows, in a folder, under a name that no file has yet. */
final class Saving {
    private static final int MOST = 10_000;

    private final Path folder;

    Saving(Path folder) {
        this.folder = folder;
    }

    Path picture(BufferedImage image, String title) throws IOException {
        int width = image.getWidth();
        int height = image.getHeight();
        int[] pixels = image.getRGB(0, 0, width, height, null, 0, width);
        Path file = free(title, ".png");
        AtomicFileWriter.write(file, out -> PngWriter.writeColour(out, width, height, pixels));
        return file;
    }

    /**
     * Saves a world with its robots at their present places, and returns its file.
     *
     * @param file   the world that is shown, as it was read; null if it is of a conversation
     * @param movers the moveable objects at their present places
     */
    Path world(@Nullable World file, Frame.Setting setting, List<Scene.Thing> movers, String title) throws IOException {
        World world = file == null ? Pictures.world(setting, movers) : moved(file, movers);
        Path to = free(title, ".xml");
        WorldWriter.write(world, to);
        return to;
    }

    private static World moved(World file, List<Scene.Thing> movers) {
        Map<String, GeometryObject> places = new HashMap<>();
        movers.forEach(each -> places.put(String.valueOf(each.object().name()), each.object()));
        List<WorldObject> objects = new ArrayList<>();
        for (WorldObject each : file.objects()) {
            String name = each.object().name();
            GeometryObject now = name == null || !each.object().isMoveable() ? null : places.get(name);
            objects.add(
                    now == null ? each : new WorldObject(each.object().at(now.pose()), each.color(), each.sonars()));
        }
        return new World(
                file.width(), file.height(), file.length(), file.unit(), file.dimension(), file.accuracy(), objects);
    }

    /** A file that does not exist: the title, with a number from 2 on where there is one already. */
    private Path free(String title, String ending) throws IOException {
        String name = title.replaceAll("[^\\p{L}\\p{N}._-]+", "-");
        for (int k = 1; k <= MOST; k++) {
            Path file = folder.resolve((name.isBlank() ? "world" : name) + (k == 1 ? "" : "-" + k) + ending);
            if (!Files.exists(file)) {
                return file;
            }
        }
        throw new IOException(folder.toAbsolutePath() + ": it must have fewer files of this name (got: " + MOST + ")");
    }
}
