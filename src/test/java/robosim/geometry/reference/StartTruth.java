package robosim.geometry.reference;

import static robosim.geometry.reference.Vectors.cross;
import static robosim.geometry.reference.Vectors.dot;
import static robosim.geometry.reference.Vectors.minus;

import java.util.ArrayList;
import java.util.List;
import robosim.geometry.reference.Quantity.Arithmetic;
import robosim.geometry.reference.Quantity.Doubt;
import robosim.geometry.reference.Truth.Form;

/**
 * Of two projections that touch or overlap, whether a straight motion of the first goes deeper, exactly: rounds and polygons.
 *
 * <p>Of two polygons, or a polygon and a centre in it, each direction of least depth is the normal of a side. From a centre
 * outside a polygon there is one, from the nearest point.
 */
public final class StartTruth {
    private StartTruth() {}

    /** -1 where the motion is against all directions of least depth, 0 where it is along one and out by none, else 1. */
    public static int out(Form formA, double[] a, double dx, double dz, Form formB, double[] b) {
        try {
            return out(Truth.COARSE, formA, a, dx, dz, formB, b);
        } catch (Doubt doubt) {
            return out(Truth.EXACT, formA, a, dx, dz, formB, b);
        }
    }

    private static int out(Arithmetic n, Form formA, double[] a, double dx, double dz, Form formB, double[] b) {
        if (!formA.isRound() && formB.isRound()) {
            return out(n, formB, b, -dx, -dz, formA, a);
        }
        Quantity[] way = Vectors.of(n, dx, 0, dz);
        if (!formA.isRound()) {
            Hull mover = Truth.outline(n, formA, a);
            Hull rest = Truth.outline(n, formB, b);
            List<Hull.Slab> slabs = new ArrayList<>(mover.slabs);
            slabs.addAll(rest.slabs);
            return leastWays(n, mover.corners, rest.corners, slabs, way);
        }
        Quantity[] centre = Truth.flat(n, a);
        if (formB.isRound()) {
            Quantity[] offset = minus(centre, Truth.flat(n, b));
            return Vectors.isZero(offset) ? 1 : dot(offset, way).signum(); // about one centre: any way is out
        }
        Hull rest = Truth.outline(n, formB, b);
        return rest.holds(centre)
                ? leastWays(n, List.<Quantity[]>of(centre), rest.corners, rest.slabs, way)
                : dot(fromNearest(n, rest, centre), way).signum();
    }

    private static int leastWays(
            Arithmetic n, List<Quantity[]> mover, List<Quantity[]> rest, List<Hull.Slab> slabs, Quantity[] way) {
        Quantity least = n.of(-1);
        Quantity leastLength = n.of(1);
        int out = 1;
        for (Hull.Slab slab : slabs) {
            Quantity length = dot(slab.normal(), slab.normal()).minus(slab.normal()[1].times(slab.normal()[1]));
            if (length.signum() == 0) {
                continue; // upright
            }
            for (int side = -1; side <= 1; side += 2) {
                Quantity[] normal = side < 0 ? Vectors.negate(slab.normal()) : slab.normal();
                Quantity depth = greatest(rest, normal).plus(greatest(mover, Vectors.negate(normal)));
                int more = least.signum() < 0
                        ? -1
                        : depth.times(depth)
                                .times(leastLength)
                                .minus(least.times(least).times(length))
                                .signum();
                int sign = dot(normal, way).signum();
                if (more < 0) {
                    least = depth;
                    leastLength = length;
                    out = sign;
                } else if (more == 0) {
                    out = Math.max(out, sign);
                }
            }
        }
        return out;
    }

    private static Quantity greatest(List<Quantity[]> points, Quantity[] normal) {
        Quantity most = dot(points.get(0), normal);
        for (Quantity[] point : points) {
            Quantity here = dot(point, normal);
            most = Vectors.atMost(here, most) ? most : here;
        }
        return most;
    }

    /** A multiple of what leads from the nearest point of a polygon to a point outside. */
    private static Quantity[] fromNearest(Arithmetic n, Hull polygon, Quantity[] point) {
        Quantity[] best = minus(point, polygon.corners.get(0));
        Quantity over = dot(best, best);
        Quantity under = n.of(1);
        for (Quantity[] corner : polygon.corners) {
            Quantity[] w = minus(point, corner);
            Quantity square = dot(w, w);
            if (square.times(under).minus(over).signum() < 0) {
                best = w;
                over = square;
                under = n.of(1);
            }
        }
        for (int k = 0; k < polygon.edges.size(); k++) {
            Quantity[] e = polygon.edge(k);
            Quantity[] w = minus(point, polygon.corners.get(polygon.edges.get(k)[0]));
            Quantity along = dot(w, e);
            Quantity length = dot(e, e);
            if (along.signum() > 0 && length.minus(along).signum() > 0) {
                Quantity[] across = cross(w, e);
                Quantity square = dot(across, across);
                if (square.times(under).minus(over.times(length)).signum() < 0) {
                    best = minus(Vectors.times(w, length), Vectors.times(e, along));
                    over = square;
                    under = length;
                }
            }
        }
        return best;
    }
}
