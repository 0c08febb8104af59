package robosim.geometry.world.rosmap;

import java.util.List;
import java.util.Optional;
import robosim.geometry.exact.Degrees;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;

/** The occupied cells of a map as a grid, and boxes along its edges, placed in the world. */
public final class MapWalls {
    /** Height in metres of the walls of a map, which does not specify it: that of a door. */
    public static final double HEIGHT = 2;

    /** The name of the grid. */
    private static final String NAME = "map";

    /** Cells must be far larger than the rounding of their coordinates, and not more than 2^30 of them from the origin. */
    private static final double LEAST_ULPS = 0x1p25;

    private final MapSettings settings;
    private final OccupancyGrid grid;
    private final double height;

    /** @param height height of the walls in metres; above 0 */
    public MapWalls(MapSettings settings, OccupancyGrid grid, double height) {
        this.settings = settings;
        this.grid = grid;
        this.height = height;
    }

    /** The occupied cells; empty if there are none. */
    public Optional<GridObject> walls() {
        if (grid.occupied.isEmpty()) {
            return Optional.empty();
        }
        // Rows of the image, from its top, are rows of the grid, whose own Z is down in the image.
        GridObject walls =
                new GridObject(new Point(), settings.resolution(), height, grid.width, grid.height, grid.occupied);
        Point center = place(grid.width / 2.0 * settings.resolution(), grid.height / 2.0 * settings.resolution());
        return Optional.of(walls.at(Pose.of(center, heading())).named(NAME));
    }

    /** A wall one cell thick around the image, since the map ends there although the world may not. */
    public List<BoxObject> edges() {
        int width = grid.width;
        int rows = grid.height;
        return List.of(
                edge("left", -1, 0, 0, rows),
                edge("right", width, 0, width + 1, rows),
                edge("upper", -1, -1, width + 1, 0),
                edge("lower", -1, rows, width + 1, rows + 1));
    }

    /** A box in the place of the cells of columns {@code [fromX, toX)} in rows {@code [fromRow, toRow)}. */
    private BoxObject edge(String side, int fromX, int fromRow, int toX, int toRow) {
        BoxObject box = new BoxObject(
                new Point(), (toX - fromX) * settings.resolution(), height, (toRow - fromRow) * settings.resolution());
        Point center = place(
                (fromX + toX) / 2.0 * settings.resolution(),
                (grid.height - (fromRow + toRow) / 2.0) * settings.resolution());
        return box.at(Pose.of(center, heading())).named(side + " edge of the map");
    }

    private double heading() {
        return Degrees.toDegrees(settings.yaw());
    }

    /** The world coordinates of a point of the image, given in metres right and up from its lower left corner. */
    private Point place(double right, double up) {
        double cos = Degrees.cos(heading());
        double sin = Degrees.sin(heading());
        double x = settings.x() + (right * cos - up * sin);
        double y = settings.y() + (right * sin + up * cos);
        return new Point(x, 0, -y);
    }

    /** How far the image with its edges extends from the origin along X (0) or Z (2), plus one cell. */
    public double extent(int axis) {
        double farthest = 0;
        for (int corner = 0; corner < 4; corner++) {
            Point place = place(
                    ((corner & 1) == 0 ? -1 : grid.width + 1) * settings.resolution(),
                    (corner < 2 ? -1 : grid.height + 1) * settings.resolution());
            farthest = Math.max(farthest, Math.abs(axis == 0 ? place.x() : place.z()));
        }
        if (settings.resolution() < LEAST_ULPS * Math.ulp(farthest)) {
            throw new IllegalArgumentException("resolution must be far above the rounding of coordinates at the map's"
                    + " position; move origin closer to 0 (got: " + settings.resolution() + " at " + farthest + ")");
        }
        return farthest + settings.resolution();
    }
}
