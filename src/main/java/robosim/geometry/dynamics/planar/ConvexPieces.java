package robosim.geometry.dynamics.planar;

import java.util.Arrays;

/**
 * The convex pieces of everything as seen from above: each a few corners, counter-clockwise or not but in order, with a radius
 * around them. A disc is one corner with a radius. The corners of a body are told from its centre: in its own axes, and as it
 * stands at the beginning of a step.
 */
final class ConvexPieces {
    private static final int FIRST = 16;

    /** Whose each piece is: a body, or -1 for what stands still. */
    int[] body = new int[FIRST];

    /** The id of the object of each piece in its world; -1 for the border. */
    int[] object = new int[FIRST];

    int[] firstCorner = new int[FIRST + 1];
    double[] radius = new double[FIRST];

    /** The greatest distance of a corner from the centre of the body; radii not included. */
    double[] reach = new double[FIRST];

    /** The bounds of each piece that stands still, least X and Z and then the greatest; radii included. */
    double[] bounds = new double[4 * FIRST];

    /** The corners in the axes of the body, or of the world where it has none. */
    double[] ownX = new double[FIRST];

    double[] ownZ = new double[FIRST];

    /** The corners in the world's axes, from the centre of the body as it is turned at the beginning of the step. */
    double[] x = new double[FIRST];

    double[] z = new double[FIRST];

    int count;
    private int corners;

    void clear() {
        truncate(0);
    }

    /** Leaves only the first pieces. */
    void truncate(int pieces) {
        count = pieces;
        corners = pieces == 0 ? 0 : firstCorner[pieces];
    }

    /** Begins another piece; its corners follow. */
    void begin(int ofBody, int ofObject, double withRadius) {
        if (count + 1 == firstCorner.length) {
            body = Arrays.copyOf(body, 2 * count);
            object = Arrays.copyOf(object, 2 * count);
            firstCorner = Arrays.copyOf(firstCorner, 2 * count + 1);
            radius = Arrays.copyOf(radius, 2 * count);
            reach = Arrays.copyOf(reach, 2 * count);
            bounds = Arrays.copyOf(bounds, 8 * count);
        }
        body[count] = ofBody;
        object[count] = ofObject;
        radius[count] = withRadius;
        reach[count] = 0;
        firstCorner[count] = corners;
        Arrays.fill(bounds, 4 * count, 4 * count + 2, Double.POSITIVE_INFINITY);
        Arrays.fill(bounds, 4 * count + 2, 4 * count + 4, Double.NEGATIVE_INFINITY);
        count++;
        firstCorner[count] = corners;
    }

    /** Adds a corner to the last piece. */
    void corner(double cx, double cz) {
        if (corners == x.length) {
            ownX = Arrays.copyOf(ownX, 2 * corners);
            ownZ = Arrays.copyOf(ownZ, 2 * corners);
            x = Arrays.copyOf(x, 2 * corners);
            z = Arrays.copyOf(z, 2 * corners);
        }
        ownX[corners] = cx;
        ownZ[corners] = cz;
        x[corners] = cx;
        z[corners] = cz;
        corners++;
        firstCorner[count] = corners;
        int last = count - 1;
        reach[last] = Math.max(reach[last], Math.sqrt(cx * cx + cz * cz));
        bounds[4 * last] = Math.min(bounds[4 * last], cx - radius[last]);
        bounds[4 * last + 1] = Math.min(bounds[4 * last + 1], cz - radius[last]);
        bounds[4 * last + 2] = Math.max(bounds[4 * last + 2], cx + radius[last]);
        bounds[4 * last + 3] = Math.max(bounds[4 * last + 3], cz + radius[last]);
    }

    int corners(int piece) {
        return firstCorner[piece + 1] - firstCorner[piece];
    }

    /**
     * Whether a disc, whose centre goes straight from one point to another, stays off a piece that stands still: the line and
     * the box around the piece are apart along X, along Z or across the line.
     *
     * @param by the radius of the disc, and by how much it has to stay off
     */
    boolean isOff(int still, double x, double z, double toX, double toZ, double by) {
        int at = 4 * still;
        if (Math.max(x, toX) + by < bounds[at]
                || Math.min(x, toX) - by > bounds[at + 2]
                || Math.max(z, toZ) + by < bounds[at + 1]
                || Math.min(z, toZ) - by > bounds[at + 3]) {
            return true;
        }
        double dx = toX - x;
        double dz = toZ - z;
        double centerX = 0.5 * (bounds[at] + bounds[at + 2]);
        double centerZ = 0.5 * (bounds[at + 1] + bounds[at + 3]);
        double across = Math.abs(dx * (centerZ - z) - dz * (centerX - x));
        double half = Math.abs(dz) * (bounds[at + 2] - centerX) + Math.abs(dx) * (bounds[at + 3] - centerZ);
        return across - half > by * Math.sqrt(dx * dx + dz * dz);
    }

    /** Whether an offset, which goes straight from one to another, stays longer than a length. */
    static boolean isFar(double x, double z, double toX, double toZ, double length) {
        double dx = toX - x;
        double dz = toZ - z;
        double square = dx * dx + dz * dz;
        double s = square == 0 ? 0 : Math.max(0, Math.min(1, -(x * dx + z * dz) / square));
        double nearX = x + s * dx;
        double nearZ = z + s * dz;
        return Math.sqrt(nearX * nearX + nearZ * nearZ) > length;
    }

    /** Turns the corners of a piece from the axes of its body to those of the world. */
    void turn(int piece, double cos, double sin) {
        for (int k = firstCorner[piece]; k < firstCorner[piece + 1]; k++) {
            x[k] = ownX[k] * cos + ownZ[k] * sin;
            z[k] = ownZ[k] * cos - ownX[k] * sin;
        }
    }
}
