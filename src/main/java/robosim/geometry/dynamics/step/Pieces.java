package robosim.geometry.dynamics.step;

import java.util.Arrays;

/**
 * The convex pieces of everything as seen from above: each a few corners, counter-clockwise or not but in order, with a radius
 * around them. A disc is one corner with a radius. The corners of a body are told from its centre: in its own axes, and as it
 * stands at the beginning of a step.
 */
final class Pieces {
    private static final int FIRST = 16;

    /** Whose each piece is: a body, or -1 for what stands still. */
    int[] body = new int[FIRST];

    /** The id of the object of each piece in its world; -1 for the border. */
    int[] object = new int[FIRST];

    int[] firstCorner = new int[FIRST + 1];
    double[] radius = new double[FIRST];

    /** The greatest distance of a corner from the centre of the body; radii not included. */
    double[] reach = new double[FIRST];

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
        }
        body[count] = ofBody;
        object[count] = ofObject;
        radius[count] = withRadius;
        reach[count] = 0;
        firstCorner[count] = corners;
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
        reach[count - 1] = Math.max(reach[count - 1], Math.sqrt(cx * cx + cz * cz));
    }

    int corners(int piece) {
        return firstCorner[piece + 1] - firstCorner[piece];
    }

    /** Turns the corners of a piece from the axes of its body to those of the world. */
    void turn(int piece, double cos, double sin) {
        for (int k = firstCorner[piece]; k < firstCorner[piece + 1]; k++) {
            x[k] = ownX[k] * cos + ownZ[k] * sin;
            z[k] = ownZ[k] * cos - ownX[k] * sin;
        }
    }
}
