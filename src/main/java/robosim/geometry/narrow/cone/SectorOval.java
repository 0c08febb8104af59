package robosim.geometry.narrow.cone;

import robosim.geometry.exact.BeamAxis;
import robosim.geometry.exact.DoubleDoubles;
import robosim.geometry.narrow.planar.PlanarShape;

/**
 * A sector and the oval projection of a turned cylinder, for an apex outside the oval.
 *
 * <p>As the oval is convex, the distance of its outline seen from the apex falls towards the nearest point and rises
 * beyond it, as the direction turns. So the nearest point within the sector is the nearest of all, unless an edge of
 * the sector meets the oval where the outline still comes nearer outwards: then it is where that edge enters. If no
 * edge meets the oval, all of it is within, or none.
 *
 * <p>The oval is enlarged by its rounding error, then everything is decided in pairs of doubles: as the enlarged oval
 * is wider than 2^-50 of the coordinates in every direction, the rounding of pairs, about 2^-95 of them, is negligible.
 */
final class SectorOval {
    private static final int AXIS_X = 0;
    private static final int AXIS_Z = 1;
    private static final int COS = 2;
    private static final int SIN = 3;
    private static final int OVAL_X = 4;
    private static final int OVAL_Z = 5;
    private static final int ALONG = 6;
    private static final int ACROSS = 7;
    private static final int EDGE_X = 8;
    private static final int EDGE_Z = 9;
    private static final int WAY_ALONG = 10;
    private static final int WAY_ACROSS = 11;
    private static final int CENTER_X = 12;
    private static final int CENTER_Z = 13;
    private static final int FREE = 14;

    /**
     * A smaller part of a normal across an edge counts as 0: the nearest point is nearer by half its square at most.
     */
    private static final double LEVEL = 0x1p-40;

    private final DoubleDoubles p = new DoubleDoubles(32);
    private double radius;
    private double minor;
    private double reach;

    /** Where the last edge enters; +Infinity on a miss. */
    private double entry;

    private double exit;

    /** The normal's part there across the edge, counter-clockwise, as a share of its length. */
    private double lean;

    /**
     * The distance to the nearest point within the sector, +Infinity where there is none.
     *
     * @param nearest the distance to the nearest point of all, or a certified lower bound
     */
    double distance(BeamAxis beam, double[] row, int at, PlanarShape q, double nearest) {
        aim(beam.dx, beam.dz, beam.cos);
        take(beam, row, at, q);
        edge(1);
        double left = entry;
        boolean isPast = entry < Double.POSITIVE_INFINITY && lean < -LEVEL;
        edge(-1);
        double right = entry;
        isPast |= entry < Double.POSITIVE_INFINITY && lean > LEVEL;
        double edges = Math.min(left, right);
        if (isPast) {
            return Math.max(nearest, edges * (1 - 0x1p-52));
        }
        return edges < Double.POSITIVE_INFINITY || isCenterWithin() ? nearest : Double.POSITIVE_INFINITY;
    }

    private void aim(double dx, double dz, double halfCos) {
        p.set(AXIS_X, dx);
        p.set(AXIS_Z, dz);
        unit(AXIS_X, AXIS_Z);
        p.set(COS, halfCos);
        p.difference(FREE, 1, halfCos);
        p.difference(FREE + 1, 1, -halfCos);
        p.multiply(FREE, FREE, FREE + 1);
        p.root(SIN, FREE);
    }

    private void unit(int x, int z) {
        p.multiply(FREE, x, x);
        p.multiply(FREE + 1, z, z);
        p.add(FREE, FREE, FREE + 1);
        p.root(FREE, FREE);
        p.divide(x, x, FREE);
        p.divide(z, z, FREE);
    }

    private void take(BeamAxis beam, double[] row, int at, PlanarShape q) {
        radius = q.radius + q.error;
        minor = q.minor + q.error;
        reach = q.reach + q.error;
        p.set(OVAL_X, q.axisX);
        p.set(OVAL_Z, q.axisZ);
        unit(OVAL_X, OVAL_Z);
        p.difference(CENTER_X, row[at], beam.ox);
        p.difference(CENTER_Z, row[at + 2], beam.oz);
        turn(ALONG, ACROSS, CENTER_X, CENTER_Z);
        p.negate(ALONG); // the apex relative to the centre
        p.negate(ACROSS);
    }

    // Transforms a vector into the oval's own frame.
    private void turn(int along, int across, int x, int z) {
        p.multiply(along, x, OVAL_X);
        p.multiply(FREE, z, OVAL_Z);
        p.add(along, along, FREE);
        p.multiply(across, z, OVAL_X);
        p.multiply(FREE, x, OVAL_Z);
        p.subtract(across, across, FREE);
    }

    // The left (1) or the right (-1) edge relative to the axis, seen from above with x to the right and z up.
    private void edge(int side) {
        p.multiply(EDGE_X, AXIS_X, COS);
        p.multiply(FREE, AXIS_Z, SIN);
        p.multiply(EDGE_Z, AXIS_Z, COS);
        p.multiply(FREE + 1, AXIS_X, SIN);
        if (side > 0) {
            p.subtract(EDGE_X, EDGE_X, FREE);
            p.add(EDGE_Z, EDGE_Z, FREE + 1);
        } else {
            p.add(EDGE_X, EDGE_X, FREE);
            p.subtract(EDGE_Z, EDGE_Z, FREE + 1);
        }
        turn(WAY_ALONG, WAY_ACROSS, EDGE_X, EDGE_Z);
        entry = Double.POSITIVE_INFINITY;
        exit = Double.NEGATIVE_INFINITY;
        end(reach);
        end(-reach);
        middle();
        if (!(exit >= 0)) {
            entry = Double.POSITIVE_INFINITY; // it is behind the apex
        }
    }

    // The ellipse about one end of the straight part, scaled to a circle of radius minor times radius.
    private void end(double at) {
        int x = FREE;
        int z = FREE + 1;
        int wayX = FREE + 2;
        int wayZ = FREE + 3;
        int square = FREE + 4;
        int cross = FREE + 5;
        int root = FREE + 6;
        int back = FREE + 7;
        int temporary = FREE + 8;
        p.set(temporary, at);
        p.subtract(x, ALONG, temporary);
        p.multiply(x, x, radius);
        p.multiply(z, ACROSS, minor);
        p.multiply(wayX, WAY_ALONG, radius);
        p.multiply(wayZ, WAY_ACROSS, minor);
        sumOfProducts(square, wayX, wayX, wayZ, wayZ, 1);
        sumOfProducts(cross, wayX, z, wayZ, x, -1);
        sumOfProducts(back, wayX, x, wayZ, z, 1);
        p.product(temporary, minor, radius);
        p.multiply(temporary, temporary, temporary);
        p.multiply(temporary, temporary, square);
        p.multiply(cross, cross, cross);
        p.subtract(root, temporary, cross);
        if (p.get(root) < 0) {
            return;
        }
        p.root(root, root);
        p.negate(back);
        p.subtract(temporary, back, root);
        p.divide(temporary, temporary, square);
        double first = p.get(temporary);
        p.add(root, back, root);
        p.divide(root, root, square);
        exit = Math.max(exit, p.get(root));
        if (first < entry) {
            entry = first;
            p.multiply(wayX, wayX, temporary);
            p.add(x, x, wayX);
            p.multiply(wayZ, wayZ, temporary);
            p.add(z, z, wayZ);
            normal(p.get(x) * radius, p.get(z) * minor);
        }
    }

    // The rectangle between the two ends, bounded only by its long sides.
    private void middle() {
        int in = FREE;
        int place = FREE + 1;
        double way = p.get(WAY_ACROSS);
        if (way == 0) {
            return; // parallel to the sides: it meets an end, or nothing
        }
        for (int side = -1; side <= 1; side += 2) {
            p.set(in, side * radius);
            p.subtract(in, in, ACROSS);
            p.divide(in, in, WAY_ACROSS);
            p.multiply(place, in, WAY_ALONG);
            p.add(place, place, ALONG);
            if (!(Math.abs(p.get(place)) <= reach)) {
                continue;
            }
            exit = Math.max(exit, p.get(in));
            if (p.get(in) < entry) {
                entry = p.get(in);
                normal(0, side);
            }
        }
    }

    private void normal(double along, double across) {
        double length = Math.sqrt(along * along + across * across);
        lean = (across * p.get(WAY_ALONG) - along * p.get(WAY_ACROSS)) / length;
    }

    // out = a b + sign c d
    private void sumOfProducts(int out, int a, int b, int c, int d, int sign) {
        int temporary = FREE + 9;
        p.multiply(out, a, b);
        p.multiply(temporary, c, d);
        if (sign > 0) {
            p.add(out, out, temporary);
        } else {
            p.subtract(out, out, temporary);
        }
    }

    // For an oval that no edge meets.
    private boolean isCenterWithin() {
        int across = FREE;
        int ahead = FREE + 1;
        sumOfProducts(across, CENTER_X, AXIS_Z, CENTER_Z, AXIS_X, -1);
        sumOfProducts(ahead, CENTER_X, AXIS_X, CENTER_Z, AXIS_Z, 1);
        p.multiply(ahead, ahead, SIN);
        p.multiply(across, across, COS);
        return p.get(ahead) >= Math.abs(p.get(across));
    }
}
