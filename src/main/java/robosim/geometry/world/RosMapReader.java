package robosim.geometry.world;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import robosim.geometry.exact.Checks;
import robosim.geometry.exact.Degrees;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;

/**
 * Reads a ROS occupancy map: a YAML file and the PGM (P2, P5) or PNG image that it names, in modes trinary, scale and
 * raw.
 *
 * <p>Occupied cells become walls: a small number of boxes that cover exactly these cells. A place (x, y, z) of the
 * map's frame, with z up from the floor, is (x, z - height / 2, -y) in the world, which is centred at the origin of the
 * map's frame, in metres, as high as its walls, and one cell wider all round than its contents: the whole image, free
 * cells included, and its edges. Yaw is a heading.
 *
 * <p>The map ends where its image does: four more walls, one cell thick, stand along its edges outside the image, so
 * that no robot that starts in the map leaves it, and no ray. They are named {@code left}, {@code right}, {@code upper}
 * and {@code lower edge of the map} and can be removed with {@code removeObject}.
 *
 * <p>In modes trinary and scale a cell is a wall if ROS gives it the value 100; in mode raw if its value is above 100
 * times {@code occupied_thresh}. The edges of the boxes are those of the cells, to within rounding.
 *
 * <p>Requires snakeyaml-engine on the class path, and the module java.desktop for PNG.
 */
public final class RosMapReader {
    /** Height in metres of the walls of a map, which does not specify it: that of a door. */
    public static final double WALL_HEIGHT = 2;

    /** Cells must be far larger than the rounding of their coordinates. */
    private static final double LEAST_ULPS = 0x1p20;

    /** Boxes around the image. */
    private static final int EDGES = 4;

    private RosMapReader() {}

    /**
     * Reads a map with walls of {@link #WALL_HEIGHT}.
     *
     * @throws WorldException naming file and line, where the map or its image cannot be read
     */
    public static World read(Path yaml) throws WorldException {
        return read(yaml, WALL_HEIGHT);
    }

    /**
     * Reads a map with walls of a given height.
     *
     * @param height height of the walls and the world in metres; above 0
     * @throws WorldException naming file and line, where the map or its image cannot be read
     */
    public static World read(Path yaml, double height) throws WorldException {
        return readImport(yaml, height).world();
    }

    /** Reads a map, with a report of what was read. */
    static WorldImport readImport(Path yaml, double height) throws WorldException {
        Checks.present("yaml", yaml);
        if (!(height > 0 && height <= 0x1p100)) {
            throw new IllegalArgumentException("height must be above 0 and at most 2^100 (got: " + height + ")");
        }
        MapSettings settings = settings(yaml);
        OccupancyGrid grid = grid(yaml, settings);
        try {
            List<WorldObject> objects = walls(settings, grid, height);
            int walls = objects.size();
            objects.addAll(edges(settings, grid, height));
            World world = new World(
                    2 * extent(settings, grid, 0),
                    height,
                    2 * extent(settings, grid, 2),
                    Unit.METRE,
                    Dimension.SPATIAL,
                    Accuracy.EXACT,
                    objects);
            return new WorldImport(
                    world,
                    "ROS map",
                    Map.of("wall", walls, "edge", objects.size() - walls),
                    Map.of(),
                    List.of(),
                    remarks(yaml, settings));
        } catch (IllegalArgumentException e) {
            throw new WorldException(yaml.toString(), 0, 0, String.valueOf(e.getMessage()), e);
        }
    }

    static MapSettings settings(Path yaml) throws WorldException {
        byte[] bytes = bytes(yaml, Limits.MAX_SETTINGS);
        try {
            return MapSettings.parse(new String(bytes, StandardCharsets.UTF_8), yaml.toString());
        } catch (NoClassDefFoundError e) {
            throw new WorldException(
                    yaml.toString(),
                    0,
                    0,
                    "maps of ROS need snakeyaml-engine, which is not on the class path: add"
                            + " org.snakeyaml:snakeyaml-engine:3.0.1 or newer (missing: " + e.getMessage() + ")",
                    e);
        }
    }

    static OccupancyGrid grid(Path yaml, MapSettings settings) throws WorldException {
        Path image;
        try {
            image = Folder.locate(yaml.toAbsolutePath().resolveSibling(""), settings.image(), "map", "image");
        } catch (IllegalArgumentException e) {
            throw new WorldException(yaml.toString(), settings.imageLine(), 0, String.valueOf(e.getMessage()), e);
        } catch (IOException e) {
            throw new WorldException(yaml.toString(), settings.imageLine(), 0, "the image could not be read: " + e, e);
        }
        byte[] bytes = bytes(image, Limits.MAX_BYTES);
        return PngReader.isPng(bytes)
                ? PngReader.read(bytes, image.toString(), settings)
                : PgmReader.read(bytes, image.toString(), settings);
    }

    private static byte[] bytes(Path file, long most) throws WorldException {
        try (InputStream in = RegularFile.open(file)) {
            byte[] bytes = in.readNBytes((int) most + 1);
            if (bytes.length > most) {
                throw new WorldException(
                        file.toString(), 0, 0, "the file must have at most " + most + " bytes (got: more)");
            }
            return bytes;
        } catch (IOException e) {
            throw WorldException.unreadable(file, e);
        }
    }

    private static List<String> remarks(Path yaml, MapSettings settings) {
        if (!(settings.free() > settings.occupied())) {
            return List.of();
        }
        return List.of(yaml + ":" + settings.freeLine() + ": free_thresh should be at most occupied_thresh, "
                + settings.occupied()
                + "; as in the map server of ROS 2, what is above occupied_thresh is a wall, and no"
                + " cell is unknown (got: " + settings.free() + ")");
    }

    private static List<WorldObject> walls(MapSettings settings, OccupancyGrid grid, double height) {
        List<WorldObject> walls = new ArrayList<>();
        for (Rectangles.Rectangle cells :
                Rectangles.cover(grid.occupied, grid.width, grid.height, Limits.MAX_OBJECTS - EDGES)) {
            walls.add(new WorldObject(box(settings, grid, height, cells)));
        }
        return walls;
    }

    /** A wall one cell thick around the image, since the map ends there although the world may not. */
    private static List<WorldObject> edges(MapSettings settings, OccupancyGrid grid, double height) {
        int width = grid.width;
        int rows = grid.height;
        return List.of(
                edge(settings, grid, height, "left", new Rectangles.Rectangle(-1, 0, 0, rows)),
                edge(settings, grid, height, "right", new Rectangles.Rectangle(width, 0, width + 1, rows)),
                edge(settings, grid, height, "upper", new Rectangles.Rectangle(-1, -1, width + 1, 0)),
                edge(settings, grid, height, "lower", new Rectangles.Rectangle(-1, rows, width + 1, rows + 1)));
    }

    private static WorldObject edge(
            MapSettings settings, OccupancyGrid grid, double height, String side, Rectangles.Rectangle cells) {
        return new WorldObject(box(settings, grid, height, cells).named(side + " edge of the map"));
    }

    private static BoxObject box(MapSettings settings, OccupancyGrid grid, double height, Rectangles.Rectangle cells) {
        BoxObject box = new BoxObject(
                new Point(),
                (cells.toX() - cells.fromX()) * settings.resolution(),
                height,
                (cells.toRow() - cells.fromRow()) * settings.resolution());
        Point center = place(
                settings,
                (cells.fromX() + cells.toX()) / 2.0 * settings.resolution(),
                (grid.height - (cells.fromRow() + cells.toRow()) / 2.0) * settings.resolution());
        return box.at(Pose.of(center, heading(settings)));
    }

    private static double heading(MapSettings settings) {
        return Degrees.toDegrees(settings.yaw());
    }

    /** The world coordinates of a point of the image, given in metres right and up from its lower left corner. */
    private static Point place(MapSettings settings, double right, double up) {
        double cos = Degrees.cos(heading(settings));
        double sin = Degrees.sin(heading(settings));
        double x = settings.x() + (right * cos - up * sin);
        double y = settings.y() + (right * sin + up * cos);
        return new Point(x, 0, -y);
    }

    /** How far the image with its edges extends from the origin along X (0) or Z (2), plus one cell. */
    private static double extent(MapSettings settings, OccupancyGrid grid, int axis) {
        double farthest = 0;
        for (int corner = 0; corner < 4; corner++) {
            Point place = place(
                    settings,
                    ((corner & 1) == 0 ? -1 : grid.width + 1) * settings.resolution(),
                    (corner < 2 ? -1 : grid.height + 1) * settings.resolution());
            farthest = Math.max(farthest, Math.abs(axis == 0 ? place.x() : place.z()));
        }
        if (settings.resolution() < LEAST_ULPS * Math.ulp(farthest)) {
            throw new IllegalArgumentException("resolution must be far above the rounding of coordinates at the map's"
                    + " place; bring origin nearer to 0 (got: " + settings.resolution() + " at " + farthest + ")");
        }
        return farthest + settings.resolution();
    }
}
