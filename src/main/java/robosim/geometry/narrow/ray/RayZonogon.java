package robosim.geometry.narrow.ray;

import robosim.geometry.exact.BeamAxis;
import robosim.geometry.exact.DoubleDouble;
import robosim.geometry.narrow.leaf.Leaf;

/** Where a ray enters the projection of a box at any attitude: the sum of the projections of its own axes. */
final class RayZonogon {
    private RayZonogon() {}

    /**
     * The last of the strips between opposite sides that the ray enters, in lengths of the direction, for a ray that is
     * known to hit.
     *
     * <p>Computed from the stored numbers with the tails of all products, not from corners, and so equally accurate at
     * low angles.
     */
    static double entry(BeamAxis ray, double[] row, int at) {
        double dx = ray.ox - row[at];
        double dxTail = DoubleDouble.differenceTail(ray.ox, row[at], dx);
        double dz = ray.oz - row[at + 2];
        double dzTail = DoubleDouble.differenceTail(ray.oz, row[at + 2], dz);
        double share = 0;
        for (int axis = 0; axis < 3; axis++) {
            double gx = row[at + Leaf.ROTATION + axis];
            double gz = row[at + Leaf.ROTATION + 6 + axis];
            double way = Math.abs(DoubleDouble.differenceOfProducts(ray.dx, gz, ray.dz, gx));
            if (!(way > 0)) {
                continue;
            }
            double p = dx * gz;
            double q = dz * gx;
            double offset = p - q;
            double tail = DoubleDouble.differenceTail(p, q, offset)
                    + DoubleDouble.productTail(dx, gz, p)
                    - DoubleDouble.productTail(dz, gx, q)
                    + (dxTail * gz - dzTail * gx);
            share = Math.max(share, gap(offset, tail, gx, gz, axis, row, at) / way);
        }
        return share;
    }

    private static double gap(double offset, double offsetTail, double gx, double gz, int axis, double[] row, int at) {
        // Includes the tail, which decides the sign where the difference of two products almost vanishes.
        double whole = offset + offsetTail;
        double wholeTail = DoubleDouble.sumTail(offset, offsetTail, whole);
        double gap = Math.abs(whole);
        double tail = whole < 0 ? -wholeTail : wholeTail;
        for (int other = 0; other < 3; other++) {
            if (other == axis) {
                continue;
            }
            double half = row[at + Leaf.SIZE + other];
            double p = row[at + Leaf.ROTATION + other] * gz;
            double q = row[at + Leaf.ROTATION + 6 + other] * gx;
            double rounded = p - q;
            double roundedTail = DoubleDouble.differenceTail(p, q, rounded)
                    + DoubleDouble.productTail(row[at + Leaf.ROTATION + other], gz, p)
                    - DoubleDouble.productTail(row[at + Leaf.ROTATION + 6 + other], gx, q);
            double cross = rounded + roundedTail;
            double crossTail = DoubleDouble.sumTail(rounded, roundedTail, cross);
            double reach = half * Math.abs(cross);
            double reachTail = DoubleDouble.productTail(half, Math.abs(cross), reach)
                    + half * (cross < 0 ? -crossTail : crossTail);
            double rest = gap - reach;
            tail += DoubleDouble.differenceTail(gap, reach, rest) - reachTail;
            gap = rest;
        }
        return gap + tail;
    }
}
