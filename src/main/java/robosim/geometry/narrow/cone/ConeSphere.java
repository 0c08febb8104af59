package robosim.geometry.narrow.cone;

import robosim.geometry.exact.DoubleDoubles;
import robosim.geometry.exact.Dyadic;
import robosim.geometry.exact.ExactVector;
import robosim.geometry.exact.FilterBound;
import robosim.geometry.exact.StageCounters;
import robosim.geometry.exact.VectorMath;
import robosim.geometry.narrow.ray.ExactRay;

/**
 * The distance from a cone's apex, outside a sphere, to the part of the sphere inside the cone. The distance to the
 * sphere grows with the angle from the centre's direction, so the cone's direction nearest to the centre's decides.
 *
 * <p>In pairs of doubles, off by less than 2^-90 of the coordinates; whether it is a hit is exact for the stored
 * cosine.
 */
final class ConeSphere {
    /**
     * Roundoff of a distance from the border, about ten steps of 2^-100, as a share of the coordinates and the radius.
     * No input was found for which a tenth of it gives a wrong decision. The sine is irrational, so a stored radius
     * comes within 2^-93 of the border only by chance, once in 2^40; where it touches the border exactly, pairs give
     * that exactly.
     */
    private static final double FILTER = FilterBound.bound(0x1p-90);

    private static final StageCounters.Counter EXACT = StageCounters.counter("ConeSphere");

    private static final int CENTER = Cone.FREE;
    private static final int CROSS = CENTER + 3;
    private static final int AHEAD = CROSS + 3;
    private static final int ASIDE = AHEAD + 1;
    private static final int ALONG = ASIDE + 1;
    private static final int PAST = ALONG + 1;
    private static final int RADIUS = PAST + 1;
    private static final int TEMPORARY = RADIUS + 1;

    private ConeSphere() {}

    static double distance(Cone cone, double[] b, int j) {
        DoubleDoubles p = cone.pairs;
        p.difference(CENTER, b[j], cone.ox);
        p.difference(CENTER + 1, b[j + 1], cone.oy);
        p.difference(CENTER + 2, b[j + 2], cone.oz);
        p.set(RADIUS, b[j + 3]);
        p.dot(AHEAD, CENTER, Cone.AXIS, TEMPORARY);
        p.cross(CROSS, CENTER, Cone.AXIS, TEMPORARY);
        p.dot(ASIDE, CROSS, CROSS, TEMPORARY);
        p.root(ASIDE, ASIDE);
        // Past the border of the cone, and ahead along it.
        p.multiply(PAST, ASIDE, Cone.COS);
        p.multiply(TEMPORARY, AHEAD, Cone.SIN);
        p.subtract(PAST, PAST, TEMPORARY);
        if (p.get(PAST) <= 0) {
            p.dot(ALONG, CENTER, CENTER, TEMPORARY);
            p.root(ALONG, ALONG);
            p.subtract(ALONG, ALONG, RADIUS);
            return Math.max(0, p.get(ALONG));
        }
        p.multiply(ALONG, AHEAD, Cone.COS);
        p.multiply(TEMPORARY, ASIDE, Cone.SIN);
        p.add(ALONG, ALONG, TEMPORARY);
        double extent =
                VectorMath.largest(cone.ox, cone.oy, cone.oz) + VectorMath.largest(b[j], b[j + 1], b[j + 2]) + b[j + 3];
        p.subtract(TEMPORARY, RADIUS, PAST);
        double doubt = FILTER * extent;
        if (p.get(ALONG) < -doubt || p.get(TEMPORARY) < -doubt) {
            return Double.POSITIVE_INFINITY;
        }
        if (!(p.get(ALONG) > doubt && p.get(TEMPORARY) > doubt) && !isHeard(cone, b, j, extent)) {
            return Double.POSITIVE_INFINITY;
        }
        p.add(TEMPORARY + 1, RADIUS, PAST);
        p.multiply(TEMPORARY, TEMPORARY, TEMPORARY + 1);
        p.root(TEMPORARY, TEMPORARY);
        p.subtract(ALONG, ALONG, TEMPORARY);
        return Math.max(0, p.get(ALONG));
    }

    private static boolean isHeard(Cone cone, double[] b, int j, double extent) {
        EXACT.count();
        ExactRay ray = new ExactRay(cone.ox, cone.oy, cone.oz, cone.dx, cone.dy, cone.dz, extent);
        ExactVector m = ray.point(b, j).minus(ray.start);
        return Cone.meetsSphere(
                m, ray.length(b[j + 3]), ray.direction, Dyadic.of(cone.cos).square());
    }
}
