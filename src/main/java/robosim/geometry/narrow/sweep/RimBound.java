package robosim.geometry.narrow.sweep;

import robosim.geometry.exact.Radians;

/**
 * How far a rim of radius 1 extends along a direction n while its axis u turns about w: the length of n x Ru, and
 * bounds of it that are {@code constant + cosine cos t + sine sin t} themselves.
 *
 * <p>With n = c w + d and u = c' w + d', d and d' square to w, and D(t) = d.Rd', the square of that length is
 * {@code y = Q - 2 c c' D - D^2} with {@code Q = c^2 d'^2 + c'^2 d^2 + d^2 d'^2}: nothing is lost where both are nearly
 * along w. For any e above 0 and any D0 it is {@code sqrt(y) <= (e^2 + y) / (2 e)} and {@code -D^2 <= D0^2 - 2 D0 D},
 * so that {@code (e^2 + Q + D0^2 - 2 (c c' + D0) D) / (2 e)} is a bound, a touching one where e = sqrt(y) and D0 = D.
 */
final class RimBound {
    /** The number of bounds to choose from. */
    static final int BOUNDS = 4;

    /** Of the squares' sum, 16 units of roundoff and as many again for the axes' lengths; halved by the quotient. */
    private static final double ROUNDOFF = 32 * 0x1p-53;

    /** The bound computed last. */
    double constant;

    double cosine;
    double sine;

    private double nx;
    private double ny;
    private double nz;
    private double ux;
    private double uy;
    private double uz;
    private double wx;
    private double wy;
    private double wz;
    private double sign;

    // c c', most of the reach anywhere, Q, and D(t) = a cos t + b sin t.
    private double both;
    private double speed;
    private double most;
    private double square;
    private double a;
    private double b;

    /** Takes the rim's axis and the turn's, both of unit length. */
    void axes(double axisX, double axisY, double axisZ, double aboutX, double aboutY, double aboutZ) {
        ux = axisX;
        uy = axisY;
        uz = axisZ;
        wx = aboutX;
        wy = aboutY;
        wz = aboutZ;
    }

    /** Takes a unit direction, and the sense of the turn. */
    void aim(double dx, double dy, double dz, double by) {
        nx = dx;
        ny = dy;
        nz = dz;
        sign = by;
        double c = nx * wx + ny * wy + nz * wz;
        double e = ux * wx + uy * wy + uz * wz;
        double px = nx - c * wx;
        double py = ny - c * wy;
        double pz = nz - c * wz;
        double qx = ux - e * wx;
        double qy = uy - e * wy;
        double qz = uz - e * wz;
        double pp = px * px + py * py + pz * pz;
        double qq = qx * qx + qy * qy + qz * qz;
        both = c * e;
        speed = Math.sqrt(qq);
        most = Math.abs(c) * Math.sqrt(qq) + Math.abs(e) * Math.sqrt(pp) + Math.sqrt(pp * qq);
        square = c * c * qq + e * e * pp + pp * qq;
        a = px * qx + py * qy + pz * qz;
        b = sign * (px * (wy * qz - wz * qy) + py * (wz * qx - wx * qz) + pz * (wx * qy - wy * qx));
    }

    /** The reach at the angle of this cosine and sine. */
    double at(double cos, double sin) {
        double s = sign * sin;
        double along = (wx * ux + wy * uy + wz * uz) * (1 - cos);
        double vx = ux * cos + (wy * uz - wz * uy) * s + wx * along;
        double vy = uy * cos + (wz * ux - wx * uz) * s + wy * along;
        double vz = uz * cos + (wx * uy - wy * ux) * s + wz * along;
        double x = ny * vz - nz * vy;
        double y = nz * vx - nx * vz;
        double z = nx * vy - ny * vx;
        return Math.sqrt(x * x + y * y + z * z);
    }

    /**
     * At least the reach from t until {@code arc} later, and no more than grows in that time: off by a few roundings where n
     * is nearly along the axis and the bounds' squares have lost it.
     */
    double soon(double t, double arc) {
        return at(Radians.cos(t), Radians.sin(t)) + speed * arc * (1 + ROUNDOFF) + ROUNDOFF;
    }

    /** Finds a bound: constant (0), touching at t (1), or touching where it reaches further than there. */
    void bound(int which, double t) {
        double greatest = Math.min(1 + 0x1p-48, most * (1 + ROUNDOFF));
        constant = greatest;
        cosine = 0;
        sine = 0;
        if (which == 0 || most == 0) {
            return;
        }
        double cos = Radians.cos(t);
        double sin = Radians.sin(t);
        double now = at(cos, sin);
        double length = which == 1 ? now : now + (greatest - now) * (which == 2 ? 0x1p-5 : 0.3);
        length = Math.max(length, 0x1p-26 * most);
        double reached = a * cos + b * sin;
        double slope = -2 * (both + reached);
        double scale = 0.5 / length;
        constant = (length * length + square + reached * reached + ROUNDOFF * most * most) * scale;
        cosine = slope * a * scale;
        sine = slope * b * scale;
    }
}
