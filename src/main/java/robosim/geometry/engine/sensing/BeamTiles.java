package robosim.geometry.engine.sensing;

import robosim.geometry.exact.VectorMath;
import robosim.geometry.model.RayPattern;

/**
 * Cuts the beams of a pattern into tiles of neighbours: into patches that are about as wide as they are high, of the pixels of
 * a camera or of the layers of a lidar, and into stretches of a single row.
 */
final class BeamTiles {
    /** The most beams in a tile; a power of two. */
    static final int MOST = 64;

    /** Beams of a tile along a row, but for the last ones; and rows. */
    private int width;

    private int height;

    /** The tiles along a row. */
    private int across;

    /**
     * Takes a pattern; answers the number of its tiles, which is always the same.
     *
     * @param isMoving whether the sensor moves, so that only beams fired at the same time begin at one place
     */
    int cut(RayPattern of, boolean isMoving) {
        if (isMoving && of.rows() > 1 && of.hasColumnTimes()) {
            height = MOST;
            width = 1;
        } else {
            height = of.rows() == 1 ? 1 : height(of);
            width = MOST / height;
        }
        across = parts(of.columns(), width);
        return across * parts(of.rows(), height);
    }

    private static int parts(int count, int each) {
        return count / each + (count % each > 0 ? 1 : 0);
    }

    /** The number of rows for which tiles spread least, by beams in the middle of the pattern. */
    private static int height(RayPattern of) {
        int row = (of.rows() - 2) / 2;
        int column = Math.max(0, (of.columns() - 2) / 2);
        double down = angle(of, row * of.columns() + column, (row + 1) * of.columns() + column);
        double along = of.columns() == 1
                ? Double.POSITIVE_INFINITY
                : angle(of, row * of.columns() + column, row * of.columns() + column + 1);
        int best = 1;
        double least = Double.POSITIVE_INFINITY;
        for (int high = 1; high <= MOST && high < 2 * of.rows(); high *= 2) {
            double spread = (high - 1) * down + (MOST > high ? (MOST / high - 1) * along : 0);
            if (spread < least) {
                least = spread;
                best = high;
            }
        }
        return best;
    }

    /** About the angle between two beams, if it is small. */
    private static double angle(RayPattern of, int a, int b) {
        double lengthA = VectorMath.length(of.x(a), of.y(a), of.z(a));
        double lengthB = VectorMath.length(of.x(b), of.y(b), of.z(b));
        return VectorMath.length(
                of.x(a) / lengthA - of.x(b) / lengthB,
                of.y(a) / lengthA - of.y(b) / lengthB,
                of.z(a) / lengthA - of.z(b) / lengthB);
    }

    /** Writes the directions of the beams of a tile and their numbers in the pattern, row by row; answers how many there are. */
    int take(RayPattern of, int tile, double[] directions, int[] beams) {
        int row = tile / across * height;
        int column = tile % across * width;
        int rows = Math.min(height, of.rows() - row);
        int columns = Math.min(width, of.columns() - column);
        int count = 0;
        for (int k = 0; k < rows; k++) {
            int first = (row + k) * of.columns() + column;
            of.directions(first, columns, directions, 3 * count);
            for (int beam = first; beam < first + columns; beam++) {
                beams[count++] = beam;
            }
        }
        return count;
    }
}
