package robosim.geometry.world;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.Point;
import robosim.geometry.world.rosmap.MapFiles;
import robosim.geometry.world.rosmap.MapSettings;
import robosim.geometry.world.rosmap.MapWalls;
import robosim.geometry.world.rosmap.OccupancyGrid;
import robosim.geometry.world.shared.FileProblem;

/**
 * Reads a ROS occupancy map: a YAML file and the PGM (P2, P5) or PNG image that it names, in modes trinary, scale and
 * raw.
 *
 * <p>The occupied cells become one {@link GridObject}, as high as the walls, which covers the whole image: its column i and
 * row j are those of the pixels, from the image's upper left corner. It is named {@code map}, so that {@code getObject} and
 * {@code removeObject} find it and a robot's own map can take its place; a map without an occupied cell has none. A point (x,
 * y, z) of the map's frame, with z up from the floor, is (x, z - height / 2, -y) in the world, in metres. The world is centred at
 * the origin of the map's frame, is as high as its walls, and extends one cell beyond its contents on all sides. These
 * are the whole image, free cells included, and its edges. Yaw is a heading.
 *
 * <p>The world is PLANAR, since a map has no heights: motion on it is much faster there. For one where heights count, use
 * {@link World#spatial} or {@link ImportOptions#withDimension}.
 *
 * <p>The map ends where its image does: four more walls stand along its edges outside the image, so that no robot that
 * starts in the map leaves it, and no ray. They fill the world, unless the image stands at an angle to it: then they are one
 * cell thick. They are named {@code left}, {@code right}, {@code upper}
 * and {@code lower edge of the map} and can be removed with {@code removeObject}.
 *
 * <p>In modes trinary and scale a cell is a wall if ROS gives it the value 100; in mode raw if its value is above 100
 * times {@code occupied_thresh}. The edges of the grid's cells are those of the map's, to within rounding.
 *
 * <p>Requires snakeyaml-engine on the class path.
 */
final class RosMapReader {
    private RosMapReader() {}

    /** Reads a map, with a report of what was read. */
    static WorldImport readImport(Path yaml, ImportOptions options) throws WorldException {
        try {
            MapSettings settings = MapFiles.settings(yaml);
            List<String> remarks = new ArrayList<>(settings.remarks());
            OccupancyGrid grid = MapFiles.grid(yaml, settings, remarks);
            int unknown = grid.unknown();
            if (options.unknown() == ImportOptions.Unknown.OCCUPIED) {
                grid.occupied.or(grid.unknown);
            }
            double height = options.wallHeight();
            MapWalls map = new MapWalls(settings, grid, height, options.isMapCentred());
            double width = 2 * map.extent(0);
            double length = 2 * map.extent(2);
            List<BoxObject> edges = map.edges();
            List<GeometryObject> all = new ArrayList<>();
            map.walls().ifPresent(all::add);
            if (options.unknown() == ImportOptions.Unknown.EDGE) {
                map.unknown().ifPresent(all::add);
            }
            all.addAll(edges);
            List<WorldObject> objects = all.stream().map(WorldObject::new).toList();
            addRemarks(yaml, settings, map, options, remarks);
            World world = new World(width, height, length, Unit.METRE, Dimension.PLANAR, Accuracy.EXACT, objects);
            return new WorldImport(
                    world,
                    "ROS map",
                    Map.of(
                            "cell",
                            grid.width * grid.height,
                            "occupied cell",
                            grid.occupied.cardinality(),
                            "unknown cell",
                            unknown,
                            "edge",
                            edges.size()),
                    Map.of(),
                    List.of(),
                    remarks);
        } catch (FileProblem e) {
            throw new WorldException(e);
        } catch (IllegalArgumentException e) {
            throw new WorldException(new FileProblem(yaml.toString(), String.valueOf(e.getMessage()), e));
        }
    }

    private static void addRemarks(
            Path yaml, MapSettings settings, MapWalls map, ImportOptions options, List<String> remarks) {
        if (settings.free() > settings.occupied()) {
            remarks.add(yaml + ":" + settings.freeLine() + ": free_thresh should be at most occupied_thresh, "
                    + settings.occupied()
                    + "; as in the map server of ROS 2, each cell above occupied_thresh is a wall and no"
                    + " cell is unknown (got: " + settings.free() + ")");
        }
        if (options.isMapCentred()) {
            Point origin = map.origin();
            remarks.add(yaml + ": the middle of the image is the world's centre; the origin of the map's frame is at X "
                    + origin.x() + ", Z " + origin.z());
        }
    }
}
