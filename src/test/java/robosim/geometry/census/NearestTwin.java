package robosim.geometry.census;

import java.util.ArrayList;
import java.util.List;

/**
 * The least distance of two convex bodies from their features: every corner, edge and rim of the one against the other in
 * closed form or by halving, and then the slab whose normal is square to what goes on at the nearest points. Both ends are
 * proven but for rounding: {@link #low} by the slab, {@link #high} by two points, whatever was found first. Where the two
 * overlap, an edge that pierces the other or projections to and fro find a point of both. A capsule is its segment, and all is
 * nearer by its radius.
 */
final class NearestTwin {
    private static final int SAMPLES = 24;
    private static final int HALVINGS = 52;
    private static final int ROUNDS = 300;

    /** The distance is at least this; negative where the two overlap along every direction that was tried. */
    double low;

    /** The distance is at most this. */
    double high;

    /** From the first to the second. */
    double[] n = new double[3];

    private Body a;
    private Body b;
    private double[] pA = new double[3];
    private double[] pB = new double[3];

    /** Both ends hold but for so much of rounding. */
    static double rounding(Body a, Body b) {
        return 0x1p-49 * (a.size() + b.size() + Vec.length(Vec.minus(a.c, b.c)));
    }

    void find(Body first, Body second) {
        findOfCores(first.core(), second.core());
        low -= first.around() + second.around();
        high = Math.max(0, high - first.around() - second.around());
    }

    private void findOfCores(Body first, Body second) {
        a = first;
        b = second;
        low = Double.NEGATIVE_INFINITY;
        high = Double.POSITIVE_INFINITY;
        corners(a, b, false);
        corners(b, a, true);
        if (a.edges.length > 0 && b.edges.length > 0) {
            edges();
        }
        edgesAndRims(a, b, false);
        edgesAndRims(b, a, true);
        if (a.type == Body.Type.CYLINDER && b.type == Body.Type.CYLINDER) {
            rims(a, b, false);
            rims(b, a, true);
            axes();
        }
        slabs();
        if (!(low > 0)) {
            toAndFro();
        }
    }

    private void offer(double[] p, double[] q, boolean swapped) {
        double away = Vec.length(Vec.minus(p, q));
        if (away < high) {
            high = away;
            pA = swapped ? q : p;
            pB = swapped ? p : q;
        }
    }

    private void corners(Body p, Body q, boolean swapped) {
        for (double[] corner : p.corners) {
            offer(corner, q.project(corner), swapped);
        }
        if (p.type == Body.Type.SPHERE) {
            double[] at = q.type == Body.Type.SPHERE ? q.c : q.project(p.c);
            double away = Vec.length(Vec.minus(at, p.c));
            if (q.type == Body.Type.SPHERE) {
                at = Vec.plus(p.c, Math.max(0, away - q.row[3]) / away, Vec.minus(at, p.c));
                away = Math.max(0, away - q.row[3]);
            }
            double[] from = Vec.plus(p.c, away > 0 ? Math.min(1, p.row[3] / away) : 0, Vec.minus(at, p.c));
            offer(from, at, swapped);
        }
    }

    private void edges() {
        double near = 0x1p-30 * (a.size() + b.size());
        for (double[] e : a.edges) {
            for (double[] f : b.edges) {
                double s = share(e, 0, f, 0, false);
                double t = share(e, 0, f, 0, true);
                if (isWithin(s) && isWithin(t)) {
                    double away = Vec.length(Vec.minus(at(e, s), at(f, t)));
                    // Where the two are nearly parallel, what rounding left is taken up once more.
                    for (int k = 0; k < 2 && away < high + near; k++) {
                        double ds = share(e, s, f, t, false);
                        t += share(e, s, f, t, true);
                        s += ds;
                    }
                    if (away < high + near) {
                        offer(at(e, Math.max(0, Math.min(1, s))), at(f, Math.max(0, Math.min(1, t))), false);
                    }
                }
            }
        }
    }

    private static boolean isWithin(double share) {
        return share > -0x1p-20 && share < 1 + 0x1p-20;
    }

    /** How far the place nearest to the other edge's line is from one place of an edge, seen from one of both; NaN for parallels. */
    private static double share(double[] e, double s, double[] f, double t, boolean ofSecond) {
        double wx = f[0] + t * f[3] - (e[0] + s * e[3]);
        double wy = f[1] + t * f[4] - (e[1] + s * e[4]);
        double wz = f[2] + t * f[5] - (e[2] + s * e[5]);
        double cx = e[4] * f[5] - e[5] * f[4];
        double cy = e[5] * f[3] - e[3] * f[5];
        double cz = e[3] * f[4] - e[4] * f[3];
        double[] way = ofSecond ? e : f;
        double volume =
                cx * (wy * way[5] - wz * way[4]) + cy * (wz * way[3] - wx * way[5]) + cz * (wx * way[4] - wy * way[3]);
        return volume / (cx * cx + cy * cy + cz * cz);
    }

    private static double[] at(double[] edge, double share) {
        return new double[] {edge[0] + share * edge[3], edge[1] + share * edge[4], edge[2] + share * edge[5]};
    }

    /** Every edge of a polytope against a cylinder, by halving where the distance falls, and its faces. */
    private void edgesAndRims(Body polytope, Body cylinder, boolean swapped) {
        if (cylinder.type != Body.Type.CYLINDER || polytope.edges.length == 0) {
            return;
        }
        halve(polytope, cylinder, swapped);
        for (double[] normal : normals(polytope)) {
            for (int side = -1; side <= 1; side += 2) {
                for (int end = -1; end <= 1; end++) {
                    double[] q = rim(cylinder, normal, side, end);
                    offer(polytope.project(q), q, swapped);
                }
            }
        }
    }

    private void halve(Body polytope, Body body, boolean swapped) {
        for (double[] edge : polytope.edges) {
            double from = 0;
            double to = 1;
            if (slope(edge, 0, body) >= 0 || slope(edge, 1, body) <= 0) {
                continue; // an end is nearest: it is a corner
            }
            for (int k = 0; k < HALVINGS; k++) {
                double middle = 0.5 * (from + to);
                double slope = slope(edge, middle, body);
                if (slope <= 0) {
                    from = middle;
                }
                if (slope >= 0) {
                    to = middle;
                }
            }
            double[] p = at(edge, 0.5 * (from + to));
            offer(p, body.project(p), swapped);
        }
    }

    /** How the distance from a body changes along an edge; 0 inside. */
    private static double slope(double[] edge, double share, Body body) {
        double[] p = at(edge, share);
        double[] away = body.outward(p);
        return away[0] * edge[3] + away[1] * edge[4] + away[2] * edge[5];
    }

    /** The point of an end's rim, or of the middle, that is furthest along a direction. */
    private static double[] rim(Body cylinder, double[] direction, int side, int end) {
        double[] axis = cylinder.axes[1];
        double[] aside = Vec.squareTo(axis, direction);
        double[] centre = Vec.plus(cylinder.c, end * cylinder.row[4], axis);
        if (Vec.length(aside) < 1e-12) {
            return centre;
        }
        double[] across = Vec.unit(Vec.squareTo(axis, Vec.unit(aside)));
        return Vec.plus(centre, side * cylinder.row[3], across);
    }

    private static List<double[]> normals(Body body) {
        return switch (body.type) {
            case BOX -> List.of(body.axes);
            case CYLINDER -> List.of(body.axes[1]);
            case SPHERE, CAPSULE -> List.of();
            case TRIANGLE -> {
                double[] n = Vec.cross(Vec.minus(body.corners[1], body.c), Vec.minus(body.corners[2], body.c));
                yield Vec.length(n) > 0 ? List.of(Vec.unit(n)) : List.of();
            }
        };
    }

    /** Both rims of a cylinder against another: the best of some places, and between its neighbours by golden sections. */
    private void rims(Body p, Body q, boolean swapped) {
        double[] u = Vec.unit(
                Vec.cross(p.axes[1], Math.abs(p.axes[1][0]) < 0.5 ? new double[] {1, 0, 0} : new double[] {0, 1, 0}));
        double[] v = Vec.cross(p.axes[1], u);
        for (int end = -1; end <= 1; end += 2) {
            double[] centre = Vec.plus(p.c, end * p.row[4], p.axes[1]);
            double[] away = new double[SAMPLES];
            for (int k = 0; k < SAMPLES; k++) {
                away[k] = away(onRim(centre, u, v, p.row[3], k * 2 * Math.PI / SAMPLES), q);
            }
            for (int k = 0; k < SAMPLES; k++) {
                double before = away[(k + SAMPLES - 1) % SAMPLES];
                double after = away[(k + 1) % SAMPLES];
                if (away[k] <= before && away[k] <= after) {
                    double angle = golden(centre, u, v, p.row[3], k * 2 * Math.PI / SAMPLES, q);
                    double[] at = onRim(centre, u, v, p.row[3], angle);
                    offer(at, q.project(at), swapped);
                }
            }
        }
    }

    private static double[] onRim(double[] centre, double[] u, double[] v, double radius, double angle) {
        return Vec.plus(Vec.plus(centre, radius * StrictMath.cos(angle), u), radius * StrictMath.sin(angle), v);
    }

    private static double away(double[] p, Body q) {
        return Vec.length(Vec.minus(p, q.project(p)));
    }

    private static double golden(double[] centre, double[] u, double[] v, double radius, double about, Body q) {
        double from = about - 2 * Math.PI / SAMPLES;
        double to = about + 2 * Math.PI / SAMPLES;
        double ratio = (Math.sqrt(5) - 1) / 2;
        double left = to - ratio * (to - from);
        double right = from + ratio * (to - from);
        double atLeft = away(onRim(centre, u, v, radius, left), q);
        double atRight = away(onRim(centre, u, v, radius, right), q);
        for (int k = 0; k < 56; k++) {
            if (atLeft <= atRight) {
                to = right;
                right = left;
                atRight = atLeft;
                left = to - ratio * (to - from);
                atLeft = away(onRim(centre, u, v, radius, left), q);
            } else {
                from = left;
                left = right;
                atLeft = atRight;
                right = from + ratio * (to - from);
                atRight = away(onRim(centre, u, v, radius, right), q);
            }
        }
        return 0.5 * (from + to);
    }

    /** Two mantles: the nearest points of the axes, and from there each as far as its radius reaches. */
    private void axes() {
        double[] p = a.axes[1];
        double[] q = b.axes[1];
        double[] cross = Vec.cross(p, q);
        double square = Vec.dot(cross, cross);
        if (!(square > 0)) {
            return;
        }
        double[] w = Vec.minus(b.c, a.c);
        double s = Math.max(-a.row[4], Math.min(a.row[4], Vec.dot(Vec.cross(w, q), cross) / square));
        double[] onA = Vec.plus(a.c, s, p);
        double t = Math.max(-b.row[4], Math.min(b.row[4], Vec.dot(Vec.minus(onA, b.c), q)));
        double[] onB = Vec.plus(b.c, t, q);
        double[] fromA = a.project(onB);
        offer(fromA, b.project(fromA), false);
        double[] normal = Vec.unit(cross);
        double side = Vec.dot(w, normal) < 0 ? -1 : 1;
        offer(Vec.plus(onA, side * a.row[3], normal), b.project(Vec.plus(onA, side * a.row[3], normal)), false);
    }

    /** Tries every normal that is square to what goes on at the nearest points, and those of all faces. */
    private void slabs() {
        double[] w = Vec.minus(pB, pA);
        if (a.type == Body.Type.SPHERE || b.type == Body.Type.SPHERE) {
            // A radius is the same all around: what matters is the way from centre to centre, or to the nearest point.
            double[] from = a.type == Body.Type.SPHERE ? a.c : b.type == Body.Type.SPHERE ? a.project(b.c) : pA;
            double[] to = b.type == Body.Type.SPHERE ? b.c : b.project(a.c);
            w = Vec.minus(to, from);
        }
        List<double[]> ways = new ArrayList<>(BodyFeatures.tangents(a, pA));
        ways.addAll(BodyFeatures.tangents(b, pB));
        slab(w);
        for (double[] way : ways) {
            slab(Vec.squareTo(way, w));
        }
        for (int i = 0; i < ways.size(); i++) {
            for (int j = 0; j < i; j++) {
                double[] cross = Vec.cross(ways.get(i), ways.get(j));
                if (Vec.length(cross) > 1e-14) {
                    slab(Vec.squareTo(ways.get(i), Vec.unit(cross)));
                }
            }
        }
        normals(a).forEach(this::slab);
        normals(b).forEach(this::slab);
    }

    private void slab(double[] direction) {
        double length = Vec.length(direction);
        if (!(length > 0)) {
            return;
        }
        double[] u = Vec.plus(new double[3], 1 / length, direction);
        double[] back = Vec.plus(new double[3], -1, u);
        for (double[] m : List.of(u, back)) {
            double[] opposite = m == u ? back : u;
            double width = -b.reach(opposite) - a.reach(m);
            if (width > low) {
                low = width;
                n = m;
            }
        }
    }

    /** A cylinder that no edge of a triangle pierces has all or nothing of what it has of the plane in the triangle. */
    private void cut(Body cylinder, Body triangle, boolean swapped) {
        if (cylinder.type != Body.Type.CYLINDER || triangle.type != Body.Type.TRIANGLE) {
            return;
        }
        for (double[] normal : normals(triangle)) {
            int end = Vec.dot(normal, cylinder.axes[1]) < 0 ? -1 : 1;
            double[] top = rim(cylinder, normal, 1, end);
            double[] bottom = rim(cylinder, normal, -1, -end);
            double above = Vec.dot(Vec.minus(top, triangle.c), normal);
            double below = Vec.dot(Vec.minus(triangle.c, bottom), normal);
            if (above > 0 && below > 0) {
                double[] q = Vec.plus(bottom, below / (above + below), Vec.minus(top, bottom));
                offer(q, triangle.project(q), swapped);
            }
        }
    }

    /** Projections to and fro end in a point of both where there is one. */
    private void toAndFro() {
        halve(a, b, false);
        halve(b, a, true);
        cut(a, b, false);
        cut(b, a, true);
        double[] p = pA;
        double enough = rounding(a, b) / 4;
        for (int k = 0; k < ROUNDS && high > enough; k++) {
            double[] q = b.project(p);
            offer(p, q, false);
            p = a.project(q);
            offer(p, q, false);
        }
    }
}
