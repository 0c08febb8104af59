package robosim.geometry.narrow.sweep;

import robosim.geometry.exact.Radians;
import robosim.geometry.narrow.leaf.PivotTurn;
import robosim.geometry.narrow.sat.AxisBody;

/**
 * Two edges, one of which turns: how long the direction perpendicular to both separates their leaves.
 *
 * <p>With an edge e1 at rest and an edge e2 of the mover that direction is {@code n(t) = e1 x Re2}; while one edge
 * passes another it follows them, whereas a fixed direction would be perpendicular to both only for an instant. For a
 * point p of the mover and a point q at rest {@code n.Rp = e1.R(e2 x p)} and {@code n.q = (q x e1).Re2}: sinusoids, of
 * degree one, as all that {@link TurningLeaf} asks. A cylinder's or capsule's edge is its axis; it reaches |n|
 * times its radius, of which {@link RimBound} has bounds of the same form.
 *
 * <p>Edges that are nearly along the turn's axis w make a short n, of the size of d1 and d2 in {@code e1 = c1 w + d1} and
 * {@code e2 = c2 w + d2}. So {@code n = c1 w x Rd2 + c2 d1 x w + d1 x Rd2} is taken in these parts, of which
 * {@code n.Rp = c1 (w x d2).p + d1.R(e2 x p)} and {@code n.q = c2 (d1 x w).q + (q x e1).Rd2}, and all roundings, at most
 * 64 units of roundoff for each side, are shares of {@code |c1| |d2| + |c2| |d1| + |d1| |d2|} and not of 1.
 */
final class TurningEdgePair {
    private static final double ROUNDOFF = 128 * 0x1p-53;
    private static final int MOST_STEPS = 12;

    private final RimBound reach = new RimBound();
    private final Sinusoids first = new Sinusoids();
    private final Sinusoids second = new Sinusoids();
    private final TurningLeaf rest;
    private final TurningLeaf mover;
    private double wx;
    private double wy;
    private double wz;
    private double limit;
    private double radius;

    /** For two bodies, to be loaded before anything is asked. */
    TurningEdgePair(TurningLeaf rest, TurningLeaf mover) {
        this.rest = rest;
        this.mover = mover;
    }

    /** Takes the axis of the turn that both are loaded for. */
    void about(PivotTurn turn) {
        wx = turn.wx;
        wy = turn.wy;
        wz = turn.wz;
    }

    /**
     * Takes two edges' unit directions, (fx, fy, fz) at rest and (mx, my, mz) as the mover stands at the start, so that the
     * direction across both, or (way -1) against it, leads from the leaf at rest to the mover.
     */
    void aim(double fx, double fy, double fz, double mx, double my, double mz, double way) {
        double c1 = fx * wx + fy * wy + fz * wz;
        double c2 = mx * wx + my * wy + mz * wz;
        double ax = fx - c1 * wx;
        double ay = fy - c1 * wy;
        double az = fz - c1 * wz;
        double bx = mx - c2 * wx;
        double by = my - c2 * wy;
        double bz = mz - c2 * wz;
        double aa = Math.sqrt(ax * ax + ay * ay + az * az);
        double bb = Math.sqrt(bx * bx + by * by + bz * bz);
        reach.axes(mx, my, mz, wx, wy, wz);
        reach.aim(fx, fy, fz, 1);
        radius = mover.aside() + rest.aside();
        double most = Math.abs(c1) * bb + Math.abs(c2) * aa + aa * bb;
        limit = ROUNDOFF * most * (mover.extent + rest.extent) + AxisBody.TINY;

        // The mover's points: c1 (w x d2).p + d1.R(e2 x p).
        double sx = way * c1 * (wy * bz - wz * by);
        double sy = way * c1 * (wz * bx - wx * bz);
        double sz = way * c1 * (wx * by - wy * bx);
        first.clear(wx, wy, wz);
        for (int m = 0; m < mover.points; m++) {
            double px = mover.x[m];
            double py = mover.y[m];
            double pz = mover.z[m];
            first.add(
                    sx * px + sy * py + sz * pz,
                    way * ax,
                    way * ay,
                    way * az,
                    my * pz - mz * py,
                    mz * px - mx * pz,
                    mx * py - my * px);
        }
        // The other's: c2 (d1 x w).q + (q x e1).Rd2, taken off.
        sx = -way * c2 * (ay * wz - az * wy);
        sy = -way * c2 * (az * wx - ax * wz);
        sz = -way * c2 * (ax * wy - ay * wx);
        second.clear(wx, wy, wz);
        for (int m = 0; m < rest.points; m++) {
            double qx = rest.x[m];
            double qy = rest.y[m];
            double qz = rest.z[m];
            second.add(
                    sx * qx + sy * qy + sz * qz,
                    -way * (qy * fz - qz * fy),
                    -way * (qz * fx - qx * fz),
                    -way * (qx * fy - qy * fx),
                    bx,
                    by,
                    bz);
        }
    }

    /** The angle until which the direction continues to separate the two; t if it does not at t. */
    double until(double t) {
        double cos = Radians.cos(t);
        double sin = Radians.sin(t);
        double gap = first.least(cos, sin) + second.least(cos, sin) - limit;
        if (!(gap - (radius == 0 ? 0 : radius * reach.at(cos, sin)) > 0)) {
            return t;
        }
        return radius == 0 ? pairsUntil(limit, 0, 0, t) : rimsUntil(t);
    }

    /**
     * From angle 0, where the two are apart by hardly more than rounding: the angle until which they come no nearer along the
     * direction; 0 where they do at once.
     */
    double notNearer() {
        double end = 0;
        for (int bound = 0; bound < (radius == 0 ? 1 : RimBound.BOUNDS); bound++) {
            reach.bound(bound, 0);
            double constant = radius == 0 ? 0 : radius * reach.constant;
            double cosine = radius == 0 ? 0 : radius * reach.cosine;
            double sine = radius == 0 ? 0 : radius * reach.sine;
            double gap = first.least(1, 0) + second.least(1, 0) - constant - cosine;
            if (gap > -limit) {
                end = Math.max(end, notNearer(gap + constant, cosine, sine));
            }
        }
        return end;
    }

    private double notNearer(double place, double cosine, double sine) {
        double end = Double.POSITIVE_INFINITY;
        for (int m = 0; m < first.count; m++) {
            for (int n = 0; n < second.count; n++) {
                double p = first.a[m] + second.a[n] - cosine;
                double q = first.b[m] + second.b[n] - sine;
                double c = place - first.k[m] - second.k[n];
                double free = p - c <= 2 * limit
                        ? TurningPolygon.rising(p, q, limit)
                        : TurningPolygon.beyond(p, q, c + limit, 0);
                end = Math.min(end, free);
            }
        }
        return end;
    }

    private double rimsUntil(double from) {
        double t = from;
        for (int step = 0; step < MOST_STEPS && t - from < 2 * Math.PI; step++) {
            double end = t;
            for (int bound = 0; bound < RimBound.BOUNDS; bound++) {
                reach.bound(bound, t);
                double constant = limit + radius * reach.constant;
                end = Math.max(end, pairsUntil(constant, radius * reach.cosine, radius * reach.sine, t));
            }
            if (!(end - t > TurningPolygon.MARGIN)) {
                break;
            }
            t = end;
        }
        return t;
    }

    private double pairsUntil(double constant, double cosine, double sine, double t) {
        double cos = Radians.cos(t);
        double sin = Radians.sin(t);
        double end = Double.POSITIVE_INFINITY;
        for (int m = 0; m < first.count; m++) {
            for (int n = 0; n < second.count; n++) {
                double p = first.a[m] + second.a[n] - cosine;
                double q = first.b[m] + second.b[n] - sine;
                double c = constant - first.k[m] - second.k[n];
                double above = p * cos + q * sin - c;
                if (!(above > 0)) {
                    return t;
                }
                if (!(t + 0.5 * above / (Math.abs(p) + Math.abs(q)) > end)) {
                    end = Math.min(end, t + TurningPolygon.beyond(p, q, c, t));
                }
            }
        }
        return end;
    }

    /** Sinusoids {@code k + a cos t + b sin t}, one for each point of a leaf. */
    private static final class Sinusoids {
        int count;
        private double wx;
        private double wy;
        private double wz;
        final double[] k = new double[TurningLeaf.MOST_POINTS];
        final double[] a = new double[TurningLeaf.MOST_POINTS];
        final double[] b = new double[TurningLeaf.MOST_POINTS];

        /** Begins with sinusoids of turns about a unit axis. */
        void clear(double axisX, double axisY, double axisZ) {
            wx = axisX;
            wy = axisY;
            wz = axisZ;
            count = 0;
        }

        /** Adds {@code constant + u.Rv}, R being the turn by t about the unit axis w. */
        void add(double constant, double ux, double uy, double uz, double vx, double vy, double vz) {
            double along = (ux * wx + uy * wy + uz * wz) * (wx * vx + wy * vy + wz * vz);
            k[count] = constant + along;
            a[count] = ux * vx + uy * vy + uz * vz - along;
            b[count] = ux * (wy * vz - wz * vy) + uy * (wz * vx - wx * vz) + uz * (wx * vy - wy * vx);
            count++;
        }

        /** The least of them at the angle of this cosine and sine. */
        double least(double cos, double sin) {
            double least = Double.POSITIVE_INFINITY;
            for (int m = 0; m < count; m++) {
                least = Math.min(least, k[m] + a[m] * cos + b[m] * sin);
            }
            return least;
        }
    }
}
