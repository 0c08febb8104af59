package robosim.geometry.world.rosmap;

import java.util.BitSet;
import java.util.List;
import java.util.Optional;
import robosim.geometry.exact.Degrees;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.world.shared.FileWork;

/** The occupied cells of a map as a grid, and boxes along its edges, placed in the world. */
public final class MapWalls {
    /** Height in metres of the walls of a map, which does not specify it: that of a door. */
    public static final double HEIGHT = 2;

    /** The name of the grid. */
    private static final String NAME = "map";

    /** The name of the grid of what is unknown. */
    private static final String UNKNOWN = "unknown part of the map";

    /** Cells must be far larger than the rounding of their coordinates, and not more than 2^30 of them from the origin. */
    private static final double LEAST_ULPS = 0x1p25;

    private final MapSettings settings;
    private final OccupancyGrid grid;
    private final double height;

    /** The point of the map's frame at the world's centre. */
    private final double originX;

    private final double originY;

    /**
     * The walls of a map.
     *
     * @param height    height of the walls in metres; above 0
     * @param isCentred whether the world's centre is the middle of the image, instead of the origin of the map's frame
     */
    public MapWalls(MapSettings settings, OccupancyGrid grid, double height, boolean isCentred) {
        this.settings = settings;
        this.grid = grid;
        this.height = height;
        double right = grid.width / 2.0 * settings.resolution();
        double up = grid.height / 2.0 * settings.resolution();
        originX = isCentred ? x(right, up) : 0;
        originY = isCentred ? y(right, up) : 0;
    }

    /** Where the origin of the map's frame is in the world. */
    public Point origin() {
        return new Point(0 - originX, 0, originY);
    }

    /** The occupied cells; empty if there are none. */
    public Optional<GridObject> walls() {
        return grid(grid.occupied, NAME);
    }

    /** The cells of which nothing is known; empty if there are none. */
    public Optional<GridObject> unknown() {
        return grid(grid.unknown, UNKNOWN);
    }

    private Optional<GridObject> grid(BitSet cells, String name) {
        if (cells.isEmpty()) {
            return Optional.empty();
        }
        FileWork.take((long) grid.width * grid.height / FileWork.PIXELS); // each is looked at again
        // Rows of the image, from its top, are rows of the grid, whose own Z is down in the image.
        GridObject walls = new GridObject(new Point(), settings.resolution(), height, grid.width, grid.height, cells);
        Point center = place(grid.width / 2.0 * settings.resolution(), grid.height / 2.0 * settings.resolution());
        return Optional.of(walls.at(Pose.of(center, heading())).named(name));
    }

    /**
     * Walls around the image, since the map ends there although the world may not. They fill the world to half a cell from its
     * border, or are one cell thick if the image stands at an angle to it.
     */
    public List<BoxObject> edges() {
        int width = grid.width;
        int rows = grid.height;
        double left = thickness(0, rows / 2.0, -1, 0);
        double right = thickness(width, rows / 2.0, 1, 0);
        double upper = thickness(width / 2.0, rows, 0, 1);
        double lower = thickness(width / 2.0, 0, 0, -1);
        return List.of(
                edge("left", -left, 0, 0, rows),
                edge("right", width, 0, width + right, rows),
                edge("upper", -left, -upper, width + right, 0),
                edge("lower", -left, rows, width + right, rows + lower));
    }

    /**
     * How many cells there are from the middle of a side of the image to half a cell from the world's border.
     *
     * @param right that middle, in cells from the lower left corner
     * @param outX  the direction out of the image
     */
    private double thickness(double right, double up, int outX, int outY) {
        double cos = Degrees.cos(heading());
        double sin = Degrees.sin(heading());
        if (cos != 0 && sin != 0) {
            return 1;
        }
        double x = outX * cos - outY * sin;
        double y = outX * sin + outY * cos;
        Point middle = place(right * settings.resolution(), up * settings.resolution());
        double free = extent(x != 0 ? 0 : 2) - (middle.x() * x - middle.z() * y);
        return Math.max(1, free / settings.resolution() - 0.5);
    }

    /** A box in the place of the cells of columns {@code [fromX, toX)} in rows {@code [fromRow, toRow)}. */
    private BoxObject edge(String side, double fromX, double fromRow, double toX, double toRow) {
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
        return new Point(x(right, up) - originX, 0, -(y(right, up) - originY));
    }

    private double x(double right, double up) {
        return settings.x() + (right * Degrees.cos(heading()) - up * Degrees.sin(heading()));
    }

    private double y(double right, double up) {
        return settings.y() + (right * Degrees.sin(heading()) + up * Degrees.cos(heading()));
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
