package robosim.geometry.world.rosmap;

import java.util.ArrayList;
import java.util.List;
import robosim.geometry.exact.Degrees;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.world.shared.Limits;

/** The occupied cells of a map as boxes, placed in the world. */
public final class MapWalls {
    /** Height in metres of the walls of a map, which does not specify it: that of a door. */
    public static final double HEIGHT = 2;

    /** Cells must be far larger than the rounding of their coordinates. */
    private static final double LEAST_ULPS = 0x1p20;

    /** Boxes around the image. */
    private static final int EDGES = 4;

    private final MapSettings settings;
    private final OccupancyGrid grid;
    private final double height;

    /** @param height height of the walls in metres; above 0 */
    public MapWalls(MapSettings settings, OccupancyGrid grid, double height) {
        this.settings = settings;
        this.grid = grid;
        this.height = height;
    }

    /** Boxes that cover the occupied cells. */
    public List<BoxObject> walls() {
        List<BoxObject> walls = new ArrayList<>();
        for (Rectangles.Rectangle cells :
                Rectangles.cover(grid.occupied, grid.width, grid.height, Limits.MAX_OBJECTS - EDGES)) {
            walls.add(box(cells));
        }
        return walls;
    }

    /** A wall one cell thick around the image, since the map ends there although the world may not. */
    public List<BoxObject> edges() {
        int width = grid.width;
        int rows = grid.height;
        return List.of(
                edge("left", new Rectangles.Rectangle(-1, 0, 0, rows)),
                edge("right", new Rectangles.Rectangle(width, 0, width + 1, rows)),
                edge("upper", new Rectangles.Rectangle(-1, -1, width + 1, 0)),
                edge("lower", new Rectangles.Rectangle(-1, rows, width + 1, rows + 1)));
    }

    private BoxObject edge(String side, Rectangles.Rectangle cells) {
        return box(cells).named(side + " edge of the map");
    }

    private BoxObject box(Rectangles.Rectangle cells) {
        BoxObject box = new BoxObject(
                new Point(),
                (cells.toX() - cells.fromX()) * settings.resolution(),
                height,
                (cells.toRow() - cells.fromRow()) * settings.resolution());
        Point center = place(
                (cells.fromX() + cells.toX()) / 2.0 * settings.resolution(),
                (grid.height - (cells.fromRow() + cells.toRow()) / 2.0) * settings.resolution());
        return box.at(Pose.of(center, heading()));
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
