package robosim.geometry.dynamics.proof;

import robosim.geometry.dynamics.Surface;

/**
 * Bodies in the plane, one obvious step after the other: all are advanced by a little; where two have come nearer than the
 * gap, the time at which they did is found by halving, and the one impulse of that collision by a formula. No queue, no
 * neighbours, one collision at a time; nothing of it is shared with the step. Outlines are corners with a radius, so that a
 * disc is one corner and a box four without a radius.
 */
final class Twin {
    private static final double LITTLE = 1e-4;

    /** How far apart bodies stop in the step. */
    private static final double GAP = 1e-10;

    final int count;
    final double[] x;
    final double[] z;
    final double[] angle;
    final double[] vx;
    final double[] vz;
    final double[] w;
    private final double[] mass;
    private final double[] inertia;
    private final double[] radius;
    private final double[][] corners;
    private final Surface surface;
    int collisions;

    // The last separation: its distance, direction from b to a, and the point nearest to both.
    private double distance;
    private double nx;
    private double nz;
    private double px;
    private double pz;
    private boolean isOfA;

    Twin(int count, Surface surface) {
        this.count = count;
        this.surface = surface;
        x = new double[count];
        z = new double[count];
        angle = new double[count];
        vx = new double[count];
        vz = new double[count];
        w = new double[count];
        mass = new double[count];
        inertia = new double[count];
        radius = new double[count];
        corners = new double[count][];
    }

    /** A body; of infinite mass for what stands still. */
    void set(int k, double[] itsCorners, double itsRadius, double itsMass, double itsInertia) {
        corners[k] = itsCorners;
        radius[k] = itsRadius;
        mass[k] = itsMass;
        inertia[k] = itsInertia;
    }

    /** Lets time pass, up to so many collisions in all. */
    void run(double seconds, int most) {
        int steps = (int) Math.ceil(seconds / LITTLE);
        for (int step = 0; step < steps; step++) {
            double left = seconds / steps;
            while (left > 0 && collisions <= most) {
                int pair = firstPair(left);
                if (pair < 0) {
                    advance(left);
                    break;
                }
                int a = pair / count;
                int b = pair % count;
                double low = 0;
                double high = left;
                for (int k = 0; k < 60; k++) {
                    double mid = 0.5 * (low + high);
                    if (isNear(a, b, mid)) {
                        high = mid;
                    } else {
                        low = mid;
                    }
                }
                advance(low);
                left -= low;
                collide(a, b);
                if (low == 0) {
                    // They part now; those that are still near do not meet again in no time.
                    double by = Math.min(left, 1e-12);
                    advance(by);
                    left -= by;
                }
            }
        }
    }

    private void advance(double by) {
        for (int k = 0; k < count; k++) {
            x[k] += vx[k] * by;
            z[k] += vz[k] * by;
            angle[k] += w[k] * by;
        }
    }

    /** The pair that is near within a time and was the first to be, by halving; -1 if none is. */
    private int firstPair(double within) {
        int first = -1;
        double until = within;
        for (int a = 0; a < count; a++) {
            for (int b = 0; b < a; b++) {
                if ((mass[a] == Double.POSITIVE_INFINITY && mass[b] == Double.POSITIVE_INFINITY)
                        || !isNear(a, b, until)) {
                    continue;
                }
                double low = 0;
                double high = until;
                for (int k = 0; k < 50; k++) {
                    double mid = 0.5 * (low + high);
                    if (isNear(a, b, mid)) {
                        high = mid;
                    } else {
                        low = mid;
                    }
                }
                until = high;
                first = a * count + b;
            }
        }
        return first;
    }

    /** Whether two are nearer than the gap after a time, and approach. */
    private boolean isNear(int a, int b, double after) {
        separate(a, b, after);
        return distance < GAP && approach(a, b) < 0;
    }

    private double approach(int a, int b) {
        double ax = px - x[a];
        double az = pz - z[a];
        double bx = px - x[b];
        double bz = pz - z[b];
        double ux = vx[a] + w[a] * az - vx[b] - w[b] * bz;
        double uz = vz[a] - w[a] * ax - vz[b] + w[b] * bx;
        return ux * nx + uz * nz;
    }

    /** Newton's restitution and Coulomb's friction at one point; of boxes without friction. */
    private void collide(int a, int b) {
        separate(a, b, 0);
        collisions++;
        double ax = px - x[a];
        double az = pz - z[a];
        double bx = px - x[b];
        double bz = pz - z[b];
        double approach = approach(a, b);
        double light = 1 / mass[a] + 1 / mass[b];
        double leverA = az * nx - ax * nz;
        double leverB = bz * nx - bx * nz;
        double push = -(1 + surface.restitution())
                * approach
                / (light + leverA * leverA / inertia[a] + leverB * leverB / inertia[b]);
        give(a, push * nx, push * nz, push * leverA);
        give(b, -push * nx, -push * nz, -push * leverB);
        if (surface.staticFriction() > 0) {
            // Of discs the push does not change the speed along the contact.
            double tx = -nz;
            double tz = nx;
            double sideA = az * tx - ax * tz;
            double sideB = bz * tx - bx * tz;
            double aside = (vx[a] - vx[b]) * tx + (vz[a] - vz[b]) * tz + w[a] * sideA - w[b] * sideB;
            double rub = -aside / (light + sideA * sideA / inertia[a] + sideB * sideB / inertia[b]);
            if (Math.abs(rub) > surface.staticFriction() * push) {
                rub = Math.copySign(surface.slidingFriction() * push, rub);
            }
            give(a, rub * tx, rub * tz, rub * sideA);
            give(b, -rub * tx, -rub * tz, -rub * sideB);
        }
    }

    private void give(int k, double jx, double jz, double torque) {
        vx[k] += jx / mass[k];
        vz[k] += jz / mass[k];
        w[k] += torque / inertia[k];
    }

    /** Finds how far two are apart after a time: across a side of one of them, or between two corners. */
    private void separate(int a, int b, double after) {
        double[] p = placed(a, after);
        double[] q = placed(b, after);
        distance = Double.NEGATIVE_INFINITY;
        acrossSides(q, p, 1);
        acrossSides(p, q, -1);
        // Between corners, where these are nearer to each other than any side tells.
        double least = Double.POSITIVE_INFINITY;
        int i = 0;
        int j = 0;
        for (int k = 0; k < p.length; k += 2) {
            for (int m = 0; m < q.length; m += 2) {
                double d = Math.hypot(p[k] - q[m], p[k + 1] - q[m + 1]);
                if (d < least) {
                    least = d;
                    i = k;
                    j = m;
                }
            }
        }
        double ux = (p[i] - q[j]) / least;
        double uz = (p[i + 1] - q[j + 1]) / least;
        double along = lowest(p, ux, uz) - highest(q, ux, uz);
        if (along > distance) {
            distance = along;
            nx = ux;
            nz = uz;
            px = q[j] + radius[b] * ux;
            pz = q[j + 1] + radius[b] * uz;
        } else {
            // A corner of the one beside a side of the other: of a disc, the point of its rim.
            px += isOfA ? -radius[a] * nx : radius[b] * nx;
            pz += isOfA ? -radius[a] * nz : radius[b] * nz;
        }
        distance -= radius[a] + radius[b];
    }

    private void acrossSides(double[] of, double[] other, int sign) {
        for (int k = 0; k < of.length && of.length > 2; k += 2) {
            double sx = of[(k + 2) % of.length] - of[k];
            double sz = of[(k + 3) % of.length] - of[k + 1];
            double length = Math.sqrt(sx * sx + sz * sz);
            double ux = sz / length;
            double uz = -sx / length;
            double at = of[k] * ux + of[k + 1] * uz;
            double along = lowest(other, ux, uz) - at;
            if (along > distance) {
                distance = along;
                nx = sign * ux;
                nz = sign * uz;
                isOfA = sign > 0;
                double low = Double.POSITIVE_INFINITY;
                for (int m = 0; m < other.length; m += 2) {
                    if (other[m] * ux + other[m + 1] * uz < low) {
                        low = other[m] * ux + other[m + 1] * uz;
                        px = other[m];
                        pz = other[m + 1];
                    }
                }
            }
        }
    }

    private static double lowest(double[] of, double ux, double uz) {
        double low = Double.POSITIVE_INFINITY;
        for (int k = 0; k < of.length; k += 2) {
            low = Math.min(low, of[k] * ux + of[k + 1] * uz);
        }
        return low;
    }

    private static double highest(double[] of, double ux, double uz) {
        return -lowest(of, -ux, -uz);
    }

    /** The corners of a body after a time. */
    private double[] placed(int k, double after) {
        double cos = Math.cos(angle[k] + w[k] * after);
        double sin = Math.sin(angle[k] + w[k] * after);
        double[] own = corners[k];
        double[] all = new double[own.length];
        for (int c = 0; c < own.length; c += 2) {
            all[c] = x[k] + vx[k] * after + cos * own[c] + sin * own[c + 1];
            all[c + 1] = z[k] + vz[k] * after - sin * own[c] + cos * own[c + 1];
        }
        return all;
    }
}
