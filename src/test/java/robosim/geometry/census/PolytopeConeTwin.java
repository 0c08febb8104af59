package robosim.geometry.census;

import robosim.geometry.reference.Twofold;
import robosim.geometry.reference.Twofold.Vector;

/**
 * The nearest point of polygons in a cone, by all places where it can be: corners, an edge's foot and where its line crosses
 * the cone, and a plane's nearest point in the cone where the polygon holds it. In {@link Twofold}s.
 */
final class PolytopeConeTwin {
    /** What holds the nearest point. */
    enum Feature {
        NONE,
        CORNER,
        EDGE_FOOT,
        EDGE_BORDER,
        FACE_FOOT,
        FACE_BORDER
    }

    private final Vector u;
    private final Twofold cos;
    private final Twofold square;
    private final Twofold sin;

    Feature feature = Feature.NONE;
    Twofold least = Twofold.of(Double.MAX_VALUE);

    PolytopeConeTwin(double[] way, Twofold cos) {
        u = Vector.of(way[0], way[1], way[2]).unit();
        this.cos = cos;
        square = cos.times(cos);
        sin = Twofold.ONE.minus(cos).times(Twofold.ONE.plus(cos)).root();
    }

    /** The distance; infinite where nothing is in the cone. */
    double distance() {
        return feature == Feature.NONE ? Double.POSITIVE_INFINITY : least.head();
    }

    /** Takes a convex polygon into account, its corners seen from the apex. */
    void add(Vector... corners) {
        for (int k = 0; k < corners.length; k++) {
            edge(corners[k], corners[(k + 1) % corners.length]);
        }
        face(corners);
    }

    private boolean holds(Vector x) {
        Twofold ahead = x.dot(u);
        return ahead.signum() >= 0
                && ahead.times(ahead).minus(square.times(x.dot(x))).signum() >= 0;
    }

    private void take(Vector x, Feature where) {
        Twofold length = x.length();
        if (length.isBelow(least)) {
            least = length;
            feature = where;
        }
    }

    private void edge(Vector p, Vector q) {
        if (holds(p)) {
            take(p, Feature.CORNER);
        }
        Vector e = q.minus(p);
        Twofold ee = e.dot(e);
        if (ee.signum() == 0) {
            return;
        }
        Twofold foot = p.dot(e).negated().over(ee);
        if (isShare(foot)) {
            Vector x = p.plus(e.times(foot));
            if (holds(x)) {
                take(x, Feature.EDGE_FOOT);
            }
        }
        // (p + t e) crosses the cone where a t^2 + 2 b t + c is 0
        Twofold pu = p.dot(u);
        Twofold eu = e.dot(u);
        Twofold a = eu.times(eu).minus(square.times(ee));
        Twofold b = pu.times(eu).minus(square.times(p.dot(e)));
        Twofold c = pu.times(pu).minus(square.times(p.dot(p)));
        Twofold under = b.times(b).minus(a.times(c));
        if (under.signum() < 0 || a.signum() == 0) {
            return;
        }
        Twofold root = under.root();
        Twofold sum = b.signum() > 0 ? b.plus(root).negated() : root.minus(b);
        for (Twofold t : new Twofold[] {sum.over(a), c.over(sum)}) {
            if (isShare(t)) {
                Vector x = p.plus(e.times(t));
                if (x.dot(u).signum() >= 0) {
                    take(x, Feature.EDGE_BORDER);
                }
            }
        }
    }

    private static boolean isShare(Twofold t) {
        return t.signum() >= 0 && t.minus(Twofold.ONE).signum() <= 0;
    }

    private void face(Vector[] corners) {
        Vector normal = corners[1].minus(corners[0]).cross(corners[2].minus(corners[0]));
        Twofold height = normal.dot(corners[0]);
        if (height.signum() == 0) {
            return;
        }
        Vector n = (height.signum() < 0 ? normal.times(Twofold.of(-1)) : normal).unit();
        Twofold ahead = n.dot(u);
        boolean isFoot = !ahead.isBelow(cos);
        Vector way =
                isFoot ? n : u.times(cos).plus(n.minus(u.times(ahead)).unit().times(sin));
        Twofold rate = n.dot(way);
        if (rate.signum() <= 0) {
            return;
        }
        Vector x = way.times(n.dot(corners[0]).over(rate));
        for (int k = 0; k < corners.length; k++) {
            Vector along = corners[(k + 1) % corners.length].minus(corners[k]);
            if (along.cross(x.minus(corners[k])).dot(normal).signum() < 0) {
                return;
            }
        }
        take(x, isFoot ? Feature.FACE_FOOT : Feature.FACE_BORDER);
    }
}
