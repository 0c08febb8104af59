package robosim.geometry.world.rosmap;

import java.util.BitSet;
import robosim.geometry.world.shared.Limits;

/** The cells of a ROS map, row by row from the top of its image. */
public final class OccupancyGrid {
    /** The ROS value of a cell that is certainly a wall; 0 is free. */
    private static final int CERTAIN = 100;

    private static final int UNKNOWN = -1;

    public final int width;
    public final int height;

    /** The walls: cell {@code x} of row {@code row} is bit {@code row * width + x}. */
    public final BitSet occupied;

    /** The cells of which nothing is known; one that is a wall with some probability is known, and free. */
    public final BitSet unknown;

    private final MapSettings settings;

    /** A grid of free cells; the size must have passed {@link #checkSize}. */
    OccupancyGrid(int width, int height, MapSettings settings) {
        this.width = width;
        this.height = height;
        this.settings = settings;
        this.occupied = new BitSet(width * height);
        this.unknown = new BitSet(width * height);
    }

    /** Refuses an image with no or too many cells, before memory is allocated. */
    static void checkSize(int width, int height) {
        if (width < 1 || height < 1 || (long) width * height > Limits.MAX_MAP_CELLS) {
            throw new IllegalArgumentException("an image must have 1 to " + Limits.MAX_MAP_CELLS + " pixels (got: "
                    + width + " x " + height + ")");
        }
    }

    /** Of how many cells nothing is known. */
    public int unknown() {
        return unknown.cardinality();
    }

    /** What a cell is. */
    enum Cell {
        FREE,
        WALL,
        UNKNOWN
    }

    /** Sets the next cell of a row; each is set once. */
    void set(int x, int row, Cell cell) {
        if (cell == Cell.WALL) {
            occupied.set(row * width + x);
        } else if (cell == Cell.UNKNOWN) {
            unknown.set(row * width + x);
        }
    }

    /**
     * Converts a pixel to a cell.
     *
     * @param sum      the sum of its colour values
     * @param whole    that sum for white
     * @param alpha    its opacity, 0 to {@code opaque}
     * @param opaque   the value of full opacity; 0 if the image has no alpha channel
     */
    Cell cell(long sum, long whole, int alpha, int opaque) {
        int value = value(sum, whole, alpha, opaque);
        return value == UNKNOWN ? Cell.UNKNOWN : isWall(value) ? Cell.WALL : Cell.FREE;
    }

    private boolean isWall(int value) {
        return settings.mode() == MapSettings.Mode.RAW ? value > CERTAIN * settings.occupied() : value == CERTAIN;
    }

    // As nav2_map_server's map_io.cpp documents and does, loadMapFromFile.
    private int value(long sum, long whole, int alpha, int opaque) {
        boolean isTrinary = settings.mode() == MapSettings.Mode.TRINARY;
        // In mode trinary the opacity counts as a fourth colour.
        double shade = isTrinary && opaque > 0
                ? (sum + alpha * (whole / 3.0) / opaque) / (whole + whole / 3.0)
                : (double) sum / whole;
        if (settings.mode() == MapSettings.Mode.RAW) {
            long raw = Math.round(shade * 255);
            return raw <= CERTAIN ? (int) raw : UNKNOWN;
        }
        if (settings.mode() == MapSettings.Mode.SCALE && alpha < opaque) {
            return UNKNOWN;
        }
        double share = settings.isNegated() ? shade : 1 - shade;
        if (share > settings.occupied()) {
            return CERTAIN;
        }
        if (share < settings.free()) {
            return 0;
        }
        return isTrinary
                ? UNKNOWN
                : (int) Math.rint(CERTAIN * (share - settings.free()) / (settings.occupied() - settings.free()));
    }
}
