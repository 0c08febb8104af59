package robosim.geometry.narrow.planar;

import robosim.geometry.exact.Orientation;
import robosim.geometry.narrow.leaf.Leaf;

/**
 * The projection of a box on the XZ plane: the sum of the projections of its own axes, a zonogon with two corners for each
 * direction among them.
 */
final class BoxProjection {
    /**
     * A corner's error in terms of the magnitudes that enter it. For those of the half axes: 1u for the products, 2u for the sum
     * of three, 2u for subtracting twice; of the centre: 1u; the corner: 1u of everything; and a little more, as the sum of the
     * magnitudes is itself rounded.
     */
    private static final double ROUNDING = 6.01 * 0x1p-53;

    // By direction, in their order: the sum of the half axes that have it, and one of these axes as it is stored.
    private final double[] spanX = new double[3];
    private final double[] spanZ = new double[3];
    private final double[] wayX = new double[3];
    private final double[] wayZ = new double[3];

    /** Sets the corners and sides of a shape, which has none, relative to (ox, oz). */
    void set(PlanarShape to, double[] row, int at, double ox, double oz) {
        double cx = row[at] - ox;
        double cz = row[at + 2] - oz;
        double sizeX = Math.abs(cx);
        double sizeZ = Math.abs(cz);
        int spans = 0;
        double sumX = 0;
        double sumZ = 0;
        for (int axis = 0; axis < 3; axis++) {
            double half = row[at + Leaf.SIZE + axis];
            double ux = row[at + Leaf.ROTATION + axis];
            double uz = row[at + Leaf.ROTATION + 6 + axis];
            if (uz < 0 || (uz == 0 && ux < 0)) {
                ux = -ux;
                uz = -uz;
            }
            double gx = half * ux;
            double gz = half * uz;
            if (gx == 0 && gz == 0) {
                continue;
            }
            sizeX += Math.abs(gx);
            sizeZ += gz;
            sumX += gx;
            sumZ += gz;
            spans = insert(spans, ux, uz, gx, gz);
        }
        to.size = Math.max(sizeX, sizeZ);
        to.error = PlanarShape.bound(to.size, ROUNDING);
        double px = -sumX;
        double pz = -sumZ;
        if (spans == 0) {
            to.corner(cx, cz);
            return;
        }
        for (int k = 0; k < spans; k++) {
            to.x[k] = cx + px;
            to.z[k] = cz + pz;
            to.x[k + spans] = cx - px;
            to.z[k + spans] = cz - pz;
            to.tailX[k] = 0;
            to.tailZ[k] = 0;
            to.tailX[k + spans] = 0;
            to.tailZ[k + spans] = 0;
            px += 2 * spanX[k];
            pz += 2 * spanZ[k];
            int next = k + 1;
            to.sideX[next] = wayX[k];
            to.sideZ[next] = wayZ[k];
            next = next == spans ? 0 : next + spans;
            to.sideX[next] = -wayX[k];
            to.sideZ[next] = -wayZ[k];
        }
        to.count = 2 * spans;
    }

    // Sorts the spans by direction and merges those of equal direction. The comparison is exact and uses the stored
    // numbers: if a long span were taken for parallel to a tiny one, it would be out of order among the others, and a
    // corner between two spans in the wrong order would be no real corner.
    private int insert(int spans, double ux, double uz, double gx, double gz) {
        int to = 0;
        while (to < spans && turn(to, ux, uz) > 0) {
            to++;
        }
        if (to < spans && turn(to, ux, uz) == 0) {
            spanX[to] += gx;
            spanZ[to] += gz;
            return spans;
        }
        for (int k = spans; k > to; k--) {
            spanX[k] = spanX[k - 1];
            spanZ[k] = spanZ[k - 1];
            wayX[k] = wayX[k - 1];
            wayZ[k] = wayZ[k - 1];
        }
        wayX[to] = ux;
        wayZ[to] = uz;
        spanX[to] = gx;
        spanZ[to] = gz;
        return spans + 1;
    }

    private int turn(int span, double ux, double uz) {
        return Orientation.compareProducts(wayX[span], uz, wayZ[span], ux);
    }
}
