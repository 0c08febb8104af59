package robosim.geometry.census;

import robosim.geometry.narrow.leaf.LeafKind;

/**
 * The distance of two solids from one pair of features after the other, in closed form or by a bracketed search in one
 * variable. Where the two overlap it means nothing, but that it is 0 where they begin to.
 */
final class SolidGap {
    /** Which features are nearest, of the first and of the second solid. */
    enum Meeting {
        CORNER_ON_SIDE,
        SIDE_ON_CORNER,
        EDGES,
        RIM_ON_SIDE,
        RIM_ON_EDGE,
        RIM_ON_ROUND,
        MANTLE_ON_EDGE,
        MANTLES,
        SPHERE,
        CAPSULE
    }

    private static final int SPREAD = 24;
    private static final double GOLDEN = 0.6180339887498949;

    double distance;
    Meeting meeting = Meeting.EDGES;

    double between(Solid a, Solid b) {
        distance = Double.POSITIVE_INFINITY;
        if (a.kind == LeafKind.SPHERE) {
            take(fromPoint(b, a.centre) - a.radius - (b.kind == LeafKind.SPHERE ? b.radius : 0), Meeting.SPHERE);
        } else if (b.kind == LeafKind.SPHERE) {
            take(fromPoint(a, b.centre) - b.radius, Meeting.SPHERE);
        } else if (a.isPolytope() && b.isPolytope()) {
            sides(a, b, Meeting.CORNER_ON_SIDE);
            sides(b, a, Meeting.SIDE_ON_CORNER);
            edges(a, b);
        } else if (a.isPolytope()) {
            roundAndFlat(b, a);
        } else if (b.isPolytope()) {
            roundAndFlat(a, b);
        } else {
            mantles(a, b);
            rims(a, b);
            rims(b, a);
        }
        if (a.kind == LeafKind.CAPSULE || b.kind == LeafKind.CAPSULE) {
            distance -= a.around() + b.around();
            meeting = Meeting.CAPSULE;
        }
        return distance;
    }

    private void take(double found, Meeting how) {
        if (found < distance) {
            distance = found;
            meeting = how;
        }
    }

    private void sides(Solid of, Solid on, Meeting how) {
        for (int k = 0; k < on.sides.length; k++) {
            for (double[] corner : of.corners) {
                if (Vec.between(corner, on.sideMiddles[k]) - on.sideReaches[k] < distance) {
                    take(aboveSide(corner, on, on.sides[k]), how);
                }
            }
        }
    }

    private void edges(Solid a, Solid b) {
        for (int k = 0; k < a.edges.length; k++) {
            int[] e = a.edges[k];
            for (int m = 0; m < b.edges.length; m++) {
                int[] f = b.edges[m];
                double reaches = a.edgeReaches[k] + b.edgeReaches[m];
                if (Vec.between(a.edgeMiddles[k], b.edgeMiddles[m]) - reaches < distance) {
                    take(segments(a.corners[e[0]], a.corners[e[1]], b.corners[f[0]], b.corners[f[1]]), Meeting.EDGES);
                }
            }
        }
    }

    /** How far a point is from a side's plane, infinite where its foot is not on the side. */
    private static double aboveSide(double[] p, Solid on, int[] side) {
        double[] u = Vec.plus(on.corners[side[1]], -1, on.corners[side[0]]);
        double[] v = Vec.plus(on.corners[side[2]], -1, on.corners[side[0]]);
        double[] n = Vec.cross(u, v);
        double square = Vec.dot(n, n);
        double[] w = Vec.plus(p, -1, on.corners[side[0]]);
        double s = Vec.dot(Vec.cross(w, v), n);
        double t = Vec.dot(Vec.cross(u, w), n);
        boolean inside = s >= 0
                && t >= 0
                && (on.kind == LeafKind.BOX ? s <= square && t <= square : s + t <= square)
                && square > 0;
        return inside ? Math.abs(Vec.dot(w, n)) / Math.sqrt(square) : Double.POSITIVE_INFINITY;
    }

    private static double segments(double[] p, double[] q, double[] r, double[] s) {
        double[] u = Vec.plus(q, -1, p);
        double[] v = Vec.plus(s, -1, r);
        double[] w = Vec.plus(p, -1, r);
        double[] n = Vec.cross(u, v);
        double nn = Vec.dot(n, n);
        double best = Double.POSITIVE_INFINITY;
        if (nn > 0) {
            double i = Vec.dot(Vec.cross(v, w), n);
            double j = Vec.dot(Vec.cross(u, w), n);
            if (i >= 0 && i <= nn && j >= 0 && j <= nn) {
                best = Math.abs(Vec.dot(w, n)) / Math.sqrt(nn);
            }
        }
        best = Math.min(best, Math.min(fromSegment(p, r, s), fromSegment(q, r, s)));
        return Math.min(best, Math.min(fromSegment(r, p, q), fromSegment(s, p, q)));
    }

    private static double fromSegment(double[] p, double[] q, double[] r) {
        double[] u = Vec.plus(r, -1, q);
        double[] w = Vec.plus(p, -1, q);
        double uu = Vec.dot(u, u);
        double share = uu > 0 ? Math.max(0, Math.min(1, Vec.dot(u, w) / uu)) : 0;
        return Vec.length(Vec.plus(w, -share, u));
    }

    /** From a point to a solid, 0 inside; a sphere counts as its centre. */
    private static double fromPoint(Solid to, double[] p) {
        double[] w = Vec.plus(p, -1, to.centre);
        if (to.kind == LeafKind.CYLINDER) {
            double along = Vec.dot(w, to.axis);
            double out = Math.max(0, Vec.length(Vec.plus(w, -along, to.axis)) - to.radius);
            double up = Math.max(0, Math.abs(along) - to.half);
            return up == 0 ? out : out == 0 ? up : Math.sqrt(up * up + out * out);
        }
        if (to.kind == LeafKind.SPHERE) {
            return Vec.length(w);
        }
        double best = Double.POSITIVE_INFINITY;
        boolean inside = to.kind == LeafKind.BOX;
        for (int k = 0; k < 3 && inside; k++) {
            double[] e = Vec.plus(to.corners[1 << k], -1, to.corners[0]);
            double along = Vec.dot(Vec.plus(p, -1, to.corners[0]), e);
            double square = Vec.dot(e, e);
            inside = square > 0 && along >= 0 && along <= square;
        }
        if (inside) {
            return 0;
        }
        for (int[] side : to.sides) {
            best = Math.min(best, aboveSide(p, to, side));
        }
        for (int[] e : to.edges) {
            best = Math.min(best, fromSegment(p, to.corners[e[0]], to.corners[e[1]]));
        }
        return best;
    }

    private void roundAndFlat(Solid round, Solid flat) {
        for (int[] side : flat.sides) {
            double[] u = Vec.plus(flat.corners[side[1]], -1, flat.corners[side[0]]);
            double[] v = Vec.plus(flat.corners[side[2]], -1, flat.corners[side[0]]);
            double[] n = Vec.unit(Vec.cross(u, v));
            if (Vec.dot(n, Vec.plus(round.centre, -1, flat.corners[side[0]])) < 0) {
                n = Vec.plus(new double[3], -1, n);
            }
            double along = Vec.dot(n, round.axis);
            double[] across = Vec.plus(n, -along, round.axis);
            double[] p = Vec.plus(round.centre, along > 0 ? -round.half : round.half, round.axis);
            double length = Vec.length(across);
            take(
                    aboveSide(length > 0 ? Vec.plus(p, -round.radius / length, across) : p, flat, side),
                    Meeting.RIM_ON_SIDE);
            take(
                    aboveSide(p, flat, side) == Double.POSITIVE_INFINITY || length > 1e-12
                            ? Double.POSITIVE_INFINITY
                            : aboveSide(p, flat, side),
                    Meeting.RIM_ON_SIDE);
        }
        for (int[] e : flat.edges) {
            double[] p = flat.corners[e[0]];
            double[] way = Vec.plus(flat.corners[e[1]], -1, p);
            double far = fromPoint(round, Vec.plus(p, 0.5, way)) - 0.5 * Vec.length(way);
            if (far >= distance) {
                continue;
            }
            // A convex function along the edge.
            double low = 0;
            double high = 1;
            double s = 1 - GOLDEN;
            double t = GOLDEN;
            double atS = fromPoint(round, Vec.plus(p, s, way));
            double atT = fromPoint(round, Vec.plus(p, t, way));
            for (int k = 0; k < 60; k++) {
                if (atS <= atT) {
                    high = t;
                    t = s;
                    atT = atS;
                    s = high - GOLDEN * (high - low);
                    atS = fromPoint(round, Vec.plus(p, s, way));
                } else {
                    low = s;
                    s = t;
                    atS = atT;
                    t = low + GOLDEN * (high - low);
                    atT = fromPoint(round, Vec.plus(p, t, way));
                }
            }
            double[] foot = Vec.plus(p, 0.5 * (low + high), way);
            double found = Math.min(
                    fromPoint(round, foot), Math.min(fromPoint(round, p), fromPoint(round, flat.corners[e[1]])));
            double up = Math.abs(Vec.dot(Vec.plus(foot, -1, round.centre), round.axis));
            take(found, up < round.half ? Meeting.MANTLE_ON_EDGE : Meeting.RIM_ON_EDGE);
        }
    }

    private void mantles(Solid a, Solid b) {
        double[] n = Vec.cross(a.axis, b.axis);
        double nn = Vec.dot(n, n);
        double[] w = Vec.plus(a.centre, -1, b.centre);
        double i = Vec.dot(Vec.cross(b.axis, w), n);
        double j = Vec.dot(Vec.cross(a.axis, w), n);
        if (nn > 1e-24 && Math.abs(i) <= a.half * nn && Math.abs(j) <= b.half * nn) {
            take(Math.abs(Vec.dot(w, n)) / Math.sqrt(nn) - a.radius - b.radius, Meeting.MANTLES);
        }
    }

    /** The rims of one, as circles, against the other. */
    private void rims(Solid of, Solid to) {
        double[] u = Vec.unit(
                Vec.cross(of.axis, Math.abs(of.axis[0]) < 0.8 ? new double[] {1, 0, 0} : new double[] {0, 1, 0}));
        double[] v = Vec.cross(of.axis, u);
        for (int way = -1; way <= 1; way += 2) {
            double[] c = Vec.plus(of.centre, way * of.half, of.axis);
            if (fromPoint(to, c) - of.radius >= distance) {
                continue;
            }
            double[] at = new double[SPREAD];
            for (int k = 0; k < SPREAD; k++) {
                at[k] = fromRim(to, c, u, v, of.radius, 2 * Math.PI * k / SPREAD);
            }
            for (int k = 0; k < SPREAD; k++) {
                if (at[k] <= at[(k + 1) % SPREAD] && at[k] <= at[(k + SPREAD - 1) % SPREAD]) {
                    lowest(of, to, c, u, v, 2 * Math.PI * (k - 1) / SPREAD, 2 * Math.PI * (k + 1) / SPREAD);
                }
            }
            take(cap(of, to, c, way), Meeting.RIM_ON_SIDE);
        }
    }

    private void lowest(Solid of, Solid to, double[] c, double[] u, double[] v, double from, double until) {
        double low = from;
        double high = until;
        for (int k = 0; k < 60; k++) {
            double s = high - GOLDEN * (high - low);
            double t = low + GOLDEN * (high - low);
            if (fromRim(to, c, u, v, of.radius, s) <= fromRim(to, c, u, v, of.radius, t)) {
                high = t;
            } else {
                low = s;
            }
        }
        take(fromRim(to, c, u, v, of.radius, 0.5 * (low + high)), Meeting.RIM_ON_ROUND);
    }

    private static double fromRim(Solid to, double[] c, double[] u, double[] v, double r, double angle) {
        double x = r * Math.cos(angle);
        double y = r * Math.sin(angle);
        double[] p = {c[0] + x * u[0] + y * v[0], c[1] + x * u[1] + y * v[1], c[2] + x * u[2] + y * v[2]};
        return fromPoint(to, p);
    }

    /** How far the other is above a cap, where its nearest point to the cap's plane is over the cap. */
    private static double cap(Solid of, Solid to, double[] c, int way) {
        double[] n = Vec.plus(new double[3], way, of.axis);
        double along = Vec.dot(n, to.axis);
        double[] across = Vec.plus(n, -along, to.axis);
        double length = Vec.length(across);
        double[] p = Vec.plus(to.centre, along > 0 ? -to.half : to.half, to.axis);
        p = length > 0 ? Vec.plus(p, -to.radius / length, across) : p;
        double[] w = Vec.plus(p, -1, c);
        double up = Vec.dot(w, n);
        boolean over = up >= 0 && Vec.length(Vec.plus(w, -up, n)) <= of.radius;
        return over ? up : Double.POSITIVE_INFINITY;
    }
}
