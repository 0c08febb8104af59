package robosim.geometry.narrow.sweep;

import robosim.geometry.exact.Radians;
import robosim.geometry.exact.VectorMath;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.PivotTurn;
import robosim.geometry.narrow.sat.AxisBody;

/**
 * A leaf relative to the pivot of a turn; computes how long the leaf stays beyond a plane.
 *
 * <p>A point q at angle t lies {@code k + a cos t + b sin t} along a direction n, with k = (n.w)(w.q), a = n.q - k and
 * b = n.(w x q). Corners and centres are such points; a cylinder is its two caps' centres with rims, which reach
 * {@code r sqrt(1 - s^2)} further, s being the direction's cosine with the cylinder's axis, a sinusoid too.
 */
final class TurningLeaf {
    private static final double FULL = 2 * Math.PI;
    private static final double ROUNDOFF = 128 * 0x1p-53;
    static final int MOST_POINTS = 8;
    private static final int MOST_STEPS = 12;
    private static final int MOST_SHORTER = 6;

    /** An arc, and the fraction of it that is tried next, for rims that lie almost flat. */
    private static final double SOON = 0x1p-6;

    /** The error of sqrt(1 - s^2) if s is 1 to within rounding. */
    private static final double LOST = 0x1p-25;

    /** The least square that has all its digits, with some to spare. */
    private static final double LEAST_SQUARE = 0x1p-900;

    /** Whether heights are ignored, for turns about the vertical in the plane. */
    boolean level;

    /** An upper bound of the distance of every point from the pivot, and of the terms of coordinates. */
    double extent;

    /** Corners, or the centres of a sphere or of two caps. */
    int points;

    final double[] x = new double[MOST_POINTS];
    final double[] y = new double[MOST_POINTS];
    final double[] z = new double[MOST_POINTS];
    private double margin;

    /** Radius of the rims around the points; 0 if there are none. */
    double radius;

    // A cylinder's unit axis.
    private boolean rims;
    private double ux;
    private double uy;
    private double uz;

    // The turn's pivot and axis, and the direction of the last question with what its points do.
    private double px;
    private double py;
    private double pz;
    private double wx;
    private double wy;
    private double wz;
    private final double[] k = new double[MOST_POINTS];
    private final double[] a = new double[MOST_POINTS];
    private final double[] b = new double[MOST_POINTS];
    private double sk;
    private double sa;
    private double sb;
    private double nx;
    private double ny;
    private double nz;
    private double sign;
    private final RimBound rim = new RimBound();

    /** Loads a leaf, relative to the pivot of a turn. */
    void load(Leaf leaf, PivotTurn turn) {
        px = turn.px;
        py = turn.py;
        pz = turn.pz;
        wx = turn.wx;
        wy = turn.wy;
        wz = turn.wz;
        points = 0;
        margin = 0;
        rims = false;
        radius = 0;
        switch (leaf.kind) {
            case TRIANGLE -> {
                for (int m = leaf.at; m < leaf.at + 9; m += 3) {
                    add(leaf.row[m] - px, leaf.row[m + 1] - py, leaf.row[m + 2] - pz);
                }
            }
            case UPRIGHT_CAPSULE -> capsule(leaf.row, leaf.at, 0, 1, 0);
            case CAPSULE -> capsule(leaf.row, leaf.at, leaf.get(7), leaf.get(10), leaf.get(13));
            case SPHERE -> {
                add(leaf.get(0) - px, leaf.get(1) - py, leaf.get(2) - pz);
                margin = leaf.get(3);
            }
            case CYLINDER -> cylinder(leaf.row, leaf.at, leaf.get(7), leaf.get(10), leaf.get(13));
            case UPRIGHT_CYLINDER -> cylinder(leaf.row, leaf.at, 0, 1, 0);
            case UPRIGHT_BOX, BOX -> box(leaf.row, leaf.at);
            case PRISM, MESH, SOLID_MESH, GRID -> throw leaf.kind.refused();
        }
        measure();
    }

    private void capsule(double[] row, int at, double ax, double ay, double az) {
        double h = row[at + 4];
        add(row[at] - px + h * ax, row[at + 1] - py + h * ay, row[at + 2] - pz + h * az);
        add(row[at] - px - h * ax, row[at + 1] - py - h * ay, row[at + 2] - pz - h * az);
        margin = row[at + 3];
    }

    private void box(double[] row, int at) {
        for (int m = 0; m < 8; m++) {
            double p = (m & 1) == 0 ? row[at + 3] : -row[at + 3];
            double q = (m & 2) == 0 ? row[at + 4] : -row[at + 4];
            double r = (m & 4) == 0 ? row[at + 5] : -row[at + 5];
            add(
                    row[at] - px + p * row[at + 6] + q * row[at + 7] + r * row[at + 8],
                    row[at + 1] - py + p * row[at + 9] + q * row[at + 10] + r * row[at + 11],
                    row[at + 2] - pz + p * row[at + 12] + q * row[at + 13] + r * row[at + 14]);
        }
    }

    private void cylinder(double[] row, int at, double ax, double ay, double az) {
        double length = Math.sqrt(ax * ax + ay * ay + az * az);
        ux = ax / length;
        uy = ay / length;
        uz = az / length;
        rims = true;
        rim.axes(ux, uy, uz, wx, wy, wz);
        radius = row[at + 3];
        for (int sign = -1; sign <= 1; sign += 2) {
            double h = sign * row[at + 4];
            add(row[at] - px + h * ax, row[at + 1] - py + h * ay, row[at + 2] - pz + h * az);
        }
    }

    private void add(double ofX, double ofY, double ofZ) {
        x[points] = ofX;
        y[points] = level ? 0 : ofY;
        z[points] = ofZ;
        points++;
    }

    private void measure() {
        extent = 0;
        for (int m = 0; m < points; m++) {
            extent = Math.max(extent, Math.abs(x[m]) + Math.abs(y[m]) + Math.abs(z[m]));
        }
        // Coordinates of a box are sums of four numbers, of which the largest may be twice what is left.
        extent = 2 * extent + margin + (rims ? radius : 0);
    }

    /** How far it reaches from its points perpendicular to its axis: a ball's radius, or a rim's. */
    double aside() {
        return margin + radius;
    }

    /** The error of a position along a unit direction. */
    double error() {
        return ROUNDOFF * extent + AxisBody.TINY;
    }

    /** Takes a unit direction; the turn goes by the right hand about the axis, or (sign -1) against it. */
    void aim(double dx, double dy, double dz, double by) {
        nx = dx;
        ny = dy;
        nz = dz;
        sign = by;
        double across = nx * wx + ny * wy + nz * wz;
        // n.(w x q) = (n x w).q
        double cx = ny * wz - nz * wy;
        double cy = nz * wx - nx * wz;
        double cz = nx * wy - ny * wx;
        for (int m = 0; m < points; m++) {
            k[m] = across * (wx * x[m] + wy * y[m] + wz * z[m]);
            a[m] = nx * x[m] + ny * y[m] + nz * z[m] - k[m];
            b[m] = sign * (cx * x[m] + cy * y[m] + cz * z[m]);
        }
        if (rims) {
            sk = across * (wx * ux + wy * uy + wz * uz);
            sa = nx * ux + ny * uy + nz * uz - sk;
            sb = sign * (cx * ux + cy * uy + cz * uz);
            rim.aim(nx, ny, nz, sign);
        }
    }

    /** The minimum position along the direction at angle t. */
    double least(double t) {
        double cos = Radians.cos(t);
        double sin = Radians.sin(t);
        double best = Double.POSITIVE_INFINITY;
        for (int m = 0; m < points; m++) {
            best = Math.min(best, k[m] + a[m] * cos + b[m] * sin);
        }
        return best - margin - (rims ? radius * rim.at(cos, sin) : 0);
    }

    private static double across(double s) {
        return Math.sqrt(Math.max(0, (1 - s) * (1 + s)));
    }

    /** The angle until which all of the leaf stays beyond a position along the direction; t if it does not at t. */
    double until(double place, double t) {
        double limit = place + error();
        if (!(least(t) > limit)) {
            return t;
        }
        return rims ? rimsUntil(limit, t) : pointsUntil(limit + margin, 0, 0, t);
    }

    /** How long no point falls behind the limit and a reach of {@code cosine cos t + sine sin t} more. */
    private double pointsUntil(double limit, double cosine, double sine, double t) {
        double cos = Radians.cos(t);
        double sin = Radians.sin(t);
        double end = Double.POSITIVE_INFINITY;
        for (int m = 0; m < points; m++) {
            double p = a[m] - cosine;
            double q = b[m] - sine;
            double c = limit - k[m];
            double above = p * cos + q * sin - c;
            if (!(above > 0)) {
                return t;
            }
            // Whatever falls no faster than this comes later than another in any case.
            if (!(t + 0.5 * above / (Math.abs(p) + Math.abs(q)) > end)) {
                end = Math.min(end, t + TurningPolygon.beyond(p, q, c, t));
            }
        }
        return end;
    }

    // Each time as long as a bound of the rims' reach lets it go on: tight where the arc begins, or further on.
    private double rimsUntil(double limit, double from) {
        double t = from;
        for (int step = 0; step < MOST_STEPS && t - from < FULL; step++) {
            double end = t;
            for (int bound = 0; bound < RimBound.BOUNDS; bound++) {
                rim.bound(bound, t);
                double constant = limit + radius * rim.constant;
                end = Math.max(end, pointsUntil(constant, radius * rim.cosine, radius * rim.sine, t));
            }
            for (double arc = SOON; arc > end - t && arc > TurningPolygon.MARGIN; arc *= SOON) {
                end = Math.max(end, Math.min(t + arc, pointsUntil(limit + radius * rim.soon(t, arc), 0, 0, t)));
            }
            if (!(end - t > TurningPolygon.MARGIN)) {
                break;
            }
            t = end;
        }
        return t;
    }

    /** The greatest sqrt(1 - s^2) from one angle to another, rounded up. */
    private double steepest(double from, double to) {
        double s0 = sk + sa * Radians.cos(from) + sb * Radians.sin(from);
        double s1 = sk + sa * Radians.cos(to) + sb * Radians.sin(to);
        double low = Math.min(s0, s1);
        double high = Math.max(s0, s1);
        double top = StrictMath.atan2(sb, sa);
        double swing = Math.sqrt(sa * sa + sb * sb);
        if (passes(top, from, to)) {
            high = sk + swing;
        }
        if (passes(top + Math.PI, from, to)) {
            low = sk - swing;
        }
        double s = low > 0 ? low : high < 0 ? high : 0;
        return Math.min(1, across(s) + 0x1p-48);
    }

    private static boolean passes(double angle, double from, double to) {
        double ahead = Math.IEEEremainder(angle - from, FULL);
        ahead = ahead < -TurningPolygon.MARGIN ? ahead + FULL : ahead;
        return ahead <= to - from + TurningPolygon.MARGIN;
    }

    /** From angle 0: how long no part of the leaf lies further back along the direction than its least does now. */
    double notFurtherBack() {
        double floor = least(0);
        double e = error();
        double end = Double.POSITIVE_INFINITY;
        double reach = rims ? radius * rim.at(1, 0) : 0;
        for (int m = 0; m < points; m++) {
            double above = k[m] + a[m] - margin - reach - floor;
            if (above > 2 * e) {
                continue;
            }
            end = Math.min(end, rims ? rimRising(m, e, floor) : TurningPolygon.rising(a[m], b[m], e));
        }
        if (!(end > 0)) {
            return 0;
        }
        double free = others(floor, e, end);
        // Over a shorter arc a rim reaches less far.
        for (int k = 0; rims && free == 0 && k < MOST_SHORTER; k++) {
            end = 0.25 * Math.min(end, FULL);
            free = others(floor, e, end);
        }
        return Math.min(end, free);
    }

    // The points that are not among the hindmost now, over the arc in question.
    private double others(double floor, double e, double end) {
        double free = Double.POSITIVE_INFINITY;
        double reach = rims ? radius * rim.at(1, 0) : 0;
        double most = rims ? radius * Math.min(1, steepest(0, Math.min(end, FULL)) + LOST) : 0;
        for (int m = 0; m < points; m++) {
            if (k[m] + a[m] - margin - reach - floor > 2 * e) {
                double limit = floor + margin + most + e - k[m];
                free = Math.min(free, a[m] > limit ? TurningPolygon.beyond(a[m], b[m], limit, 0) : 0);
            }
        }
        return free;
    }

    /**
     * The rim point that is hindmost rises at some speed v. A rim point at the angle psi from it lies r c (1 - cos psi)
     * ahead, c being the sine of the tilt, and rises slower by at most r psi; no point's path bends by more than its
     * distance d from the axis. So the least is raised by at least v t - (pi^2 r / (8 c) + d / 2) t^2. A cap that lies flat, or
     * almost, has no such point. But no rim reaches further by more than r t times the sine between its axis and the turn's.
     * Where the rim neither rises nor falls at first, a bound of its reach that touches it tells which it does then.
     */
    private double rimRising(int m, double e, double floor) {
        double tilt = rim.at(1, 0);
        double swing = Math.sqrt(a[m] * a[m] + b[m] * b[m]) + radius * Math.sqrt(sa * sa + sb * sb);
        if (swing <= e) {
            return Double.POSITIVE_INFINITY; // turns about the direction itself
        }
        double bend = 0.5 * extent;
        double end = 0;
        // The rim's reach r sqrt(1 - s^2) changes by -r s s' / tilt.
        if (tilt > 0) {
            double speed = b[m] + radius * (sk + sa) * sb / tilt;
            double least = speed - e - ROUNDOFF * radius * (1 + 1 / tilt) / tilt;
            end = sure(least, Math.PI * Math.PI * radius / (8 * tilt) + bend);
        }
        end = end > 0 ? end : sure(b[m] - e - radius * turning() * (1 + ROUNDOFF), bend);
        rim.bound(1, 0);
        if (k[m] + a[m] - radius * (rim.cosine + rim.constant) > floor - e) {
            end = Math.max(end, TurningPolygon.rising(a[m] - radius * rim.cosine, b[m] - radius * rim.sine, e));
        }
        return end;
    }

    /** How long something rises that begins with at least a speed and slows down by at most so much. */
    private static double sure(double speed, double bend) {
        return speed > 0 ? speed / bend * (1 - 0x1p-40) : 0;
    }

    /** The sine between a cylinder's axis and the turn's, at least: at most so fast its direction changes. */
    private double turning() {
        double along = wx * ux + wy * uy + wz * uz;
        return Math.sqrt(Math.max(0, 1 - along * along + ROUNDOFF));
    }

    /**
     * How far the leaf extends along the direction anywhere from angle 0 to {@code angle}, rounded up.
     *
     * @param pivot the position of the pivot along the direction
     * @param start how far the leaf extends at angle 0, rounded up
     */
    double greatest(double angle, double pivot, double start) {
        if (rims && (sa != 0 || sb != 0)) {
            double cap = Double.NEGATIVE_INFINITY;
            for (int m = 0; m < points; m++) {
                cap = rimTop(m, 0, Math.min(angle, FULL), cap, 0);
            }
            return up(start, pivot + cap + error() + 2 * Math.ulp(pivot));
        }
        double best = start;
        double beyond = margin + (rims ? radius * across(sk) : 0);
        for (int m = 0; m < points; m++) {
            double rho = VectorMath.legs(Math.abs(a[m]), Math.abs(b[m]));
            double rise;
            double top;
            if (angle >= FULL || passes(StrictMath.atan2(b[m], a[m]), 0, angle)) {
                rise = rho == 0 ? 0 : a[m] > 0 ? squareOver(b[m], rho + a[m]) : rho - a[m];
                top = rho;
            } else {
                double sin = Radians.sin(0.5 * angle);
                double cos = Radians.cos(0.5 * angle);
                rise = 2 * sin * (b[m] * cos - a[m] * sin);
                top = a[m] + rise;
                rise += ROUNDOFF * sin * rho;
            }
            // No further than the leaf at the start and the rise from there; nor than this point by itself.
            if (rise > 0) {
                double place = pivot + (k[m] + top + beyond) + error() + 2 * Math.ulp(pivot);
                best = Math.max(best, Math.min(Math.nextUp(start + rise * (1 + ROUNDOFF)), place));
            }
        }
        return best;
    }

    /** The square of a number over another one, also if the square underflows. */
    private static double squareOver(double b, double by) {
        double square = b * b;
        return square > LEAST_SQUARE ? square / by : b * (b / by);
    }

    private static double up(double start, double place) {
        return Math.max(start, place);
    }

    /**
     * The greatest {@code k + a cos t + b sin t + r sqrt(1 - s^2)} of a rim over an arc, or {@code best} if that is more,
     * rounded up by at most a 2^-36th of the extent: arcs are halved where more might hide.
     */
    private double rimTop(int m, double from, double to, double best, int depth) {
        double middle = 0.5 * (from + to);
        double half = 0.5 * (to - from);
        double cos = Radians.cos(middle);
        double sin = Radians.sin(middle);
        double s = sk + sa * cos + sb * sin;
        double slope = sb * cos - sa * sin;
        double here = k[m] + a[m] * cos + b[m] * sin + radius * across(s);
        double found = Math.max(best, here);
        double swing = Math.sqrt(sa * sa + sb * sb);
        double rho = VectorMath.legs(Math.abs(a[m]), Math.abs(b[m]));
        // By the steepest that the rim gets, and by how fast its reach may grow from the middle.
        double rise = Math.min(rho, Math.abs(b[m] * cos - a[m] * sin) + 0.5 * rho * half) * half;
        double simple = k[m] + a[m] * cos + b[m] * sin + rise + radius * steepest(from, to);
        double flattest = flattest(Math.abs(s) + swing * half);
        double bySlope = Double.POSITIVE_INFINITY;
        if (flattest > 0) {
            double speed = Math.abs(b[m] * cos - a[m] * sin - radius * s * slope / Math.max(across(s), flattest));
            double bend = rho + radius * (swing * swing + swing) / (flattest * flattest * flattest);
            bySlope = here + (speed + 0.5 * bend * half) * half;
        }
        double most = Math.min(simple, bySlope);
        if (most <= found + 0x1p-36 * extent || depth == 48) {
            return Math.max(found, most);
        }
        found = rimTop(m, from, middle, found, depth + 1);
        return rimTop(m, middle, to, found, depth + 1);
    }

    private static double flattest(double s) {
        return s < 1 ? across(s) : 0;
    }
}
