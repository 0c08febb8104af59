package robosim.geometry.narrow.sat;

import robosim.geometry.narrow.gjk.Support;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;

/**
 * A polytope in straight motion against another at rest: the method of separating axes with a velocity.
 *
 * <p>Along each axis the two overlap during an interval of times. The shapes touch while they overlap along every axis,
 * from the latest entry to the earliest exit. The plain doubles come with error bounds:
 *
 * <p>A coordinate carries at most 8 units of roundoff u = 2^-53 (see {@link AxisBody}), a cross product of two edges 4,
 * a dot product 3, the sum over half vectors 3, the difference of the two ends 1, and the later quotient 3: 22 u of the
 * sum of magnitudes, taken as 32 u. Cases left in doubt go to {@link ExactAxes}. With a tenth of the bound no input was
 * found that gives a wrong answer. A box or a triangle has only the roundings of its own coordinates, 1 to 5 of the 22
 * and not the 8 of an octagon, and no more than one or two of the terms are as large as their sum of magnitudes at
 * once. Times are always computed in pairs of doubles, so the bound only costs calls of the next stage.
 */
public final class MovingAxes {
    private static final double SMALL = 0x1p-900;
    private static final int MOST = 96;

    /** Takes more off a time than its rounding. */
    private static final double SURE = 1 - 0x1p-48;

    /** Below this, the squares of normals would underflow. */
    private static final double MINUTE = 0x1p-200;

    private final AxisBody first = new AxisBody();
    private final AxisBody second = new AxisBody();
    private final DoubleDoubleAxes fine = new DoubleDoubleAxes();

    // One entry for each direction (both ways along each axis) in which the mover may lie beyond the other.
    private int count;
    private final double[] gap = new double[MOST];
    private final double[] gapError = new double[MOST];
    private final double[] speed = new double[MOST];
    private final double[] speedError = new double[MOST];
    private final double[] length = new double[MOST];
    private final double[] lengthError = new double[MOST];

    /** The axis of each two entries; see {@link DoubleDoubleAxes}. */
    private final int[] axis = new int[MOST / 2];

    private double dx;
    private double dy;
    private double dz;
    private double mx;
    private double my;
    private double mz;

    /** A contact after this does not matter and counts as none. */
    private double latest = Double.POSITIVE_INFINITY;

    /** Whether it only matters that two meet, not when. */
    private boolean isVerdictEnough;

    /**
     * Sets what matters of the next times.
     *
     * @param isVerdict whether any time will do where the two meet
     * @param until a contact after this counts as none
     */
    public MovingAxes needing(boolean isVerdict, double until) {
        isVerdictEnough = isVerdict;
        latest = until;
        return this;
    }

    /** As {@code PlanarSweep.translation}; NaN where pairs of doubles cannot tell. */
    public double time(AxisBody.Mode mode, Leaf a, double moveX, double moveY, double moveZ, Leaf b) {
        double ox = Support.originX(a.kind, a.row, a.at);
        double oy = Support.originY(a.kind, a.row, a.at);
        double oz = Support.originZ(a.kind, a.row, a.at);
        dx = moveX;
        dy = mode == AxisBody.Mode.PLANAR ? 0 : moveY;
        dz = moveZ;
        load(first, mode, a, ox, oy, oz);
        load(second, mode, b, ox, oy, oz);
        mx = first.mx + second.mx;
        my = mode == AxisBody.Mode.PLANAR ? 0 : first.my + second.my;
        mz = first.mz + second.mz;
        count = 0;
        if (mx + my + mz < MINUTE) {
            return Double.NaN;
        }
        if (separatesByNormal(first, DoubleDoubleAxes.FIRST) || separatesByNormal(second, DoubleDoubleAxes.SECOND)) {
            return Double.POSITIVE_INFINITY;
        }
        if (mode == AxisBody.Mode.SPATIAL) {
            if (first.doubtful || second.doubtful) {
                return Double.NaN;
            }
            boolean triangles = a.kind == LeafKind.TRIANGLE && b.kind == LeafKind.TRIANGLE;
            if (separatesByEdges() || (triangles && separatesInPlane())) {
                return Double.POSITIVE_INFINITY;
            }
        }
        if (!decide()) {
            return verdict;
        }
        if (isVerdictEnough) {
            return Math.min(1, earliest);
        }
        fine.load(mode, a, b, ox, oy, oz);
        fine.move(dx, dy, dz, mx + my + mz);
        return enter();
    }

    private static void load(AxisBody body, AxisBody.Mode mode, Leaf leaf, double ox, double oy, double oz) {
        switch (mode) {
            case PLANAR -> body.planar(leaf, ox, oz);
            case UPRIGHT -> body.upright(leaf, ox, oy, oz);
            case SPATIAL -> body.spatial(leaf, ox, oy, oz);
        }
    }

    private boolean separatesByNormal(AxisBody body, int which) {
        double[] n = body.normal;
        double[] size = body.normalSize;
        for (int k = 0; k < 3 * body.normals; k += 3) {
            axis[count / 2] = which + k / 3;
            if (separates(n[k], n[k + 1], n[k + 2], size[k], size[k + 1], size[k + 2])) {
                return true;
            }
        }
        return false;
    }

    private boolean separatesByEdges() {
        for (int k = 0; k < 3 * first.edges; k += 3) {
            for (int m = 0; m < 3 * second.edges; m += 3) {
                axis[count / 2] = DoubleDoubleAxes.ACROSS_BOTH + 8 * (k / 3) + m / 3;
                if (separatesAcross(first.edge, k, second.edge, m, second.edge)) {
                    return true;
                }
            }
        }
        return false;
    }

    // Two triangles in one plane: the normals of their edges in that plane.
    private boolean separatesInPlane() {
        for (int k = 0; k < 9; k += 3) {
            axis[count / 2] = DoubleDoubleAxes.FIRST + DoubleDoubleAxes.IN_PLANE + k / 3;
            if (separatesAcross(first.edge, k, first.normal, 0, first.normalSize)) {
                return true;
            }
            axis[count / 2] = DoubleDoubleAxes.SECOND + DoubleDoubleAxes.IN_PLANE + k / 3;
            if (separatesAcross(second.edge, k, second.normal, 0, second.normalSize)) {
                return true;
            }
        }
        return false;
    }

    private boolean separatesAcross(double[] a, int i, double[] b, int j, double[] sizeOfB) {
        double ax = a[i];
        double ay = a[i + 1];
        double az = a[i + 2];
        double sx = Math.abs(sizeOfB[j]);
        double sy = Math.abs(sizeOfB[j + 1]);
        double sz = Math.abs(sizeOfB[j + 2]);
        double sizeX = Math.abs(ay) * sz + Math.abs(az) * sy;
        double sizeY = Math.abs(az) * sx + Math.abs(ax) * sz;
        double sizeZ = Math.abs(ax) * sy + Math.abs(ay) * sx;
        return sizeX + sizeY + sizeZ > 0
                && separates(
                        ay * b[j + 2] - az * b[j + 1],
                        az * b[j] - ax * b[j + 2],
                        ax * b[j + 1] - ay * b[j],
                        sizeX,
                        sizeY,
                        sizeZ);
    }

    /** Records both directions of an axis; answers whether one of them proves the whole motion free. */
    private boolean separates(double nx, double ny, double nz, double sizeX, double sizeY, double sizeZ) {
        first.project(nx, ny, nz);
        second.project(nx, ny, nz);
        double v = nx * dx + ny * dy + nz * dz;
        double size = sizeX * mx + sizeY * my + sizeZ * mz;
        double speedSize = sizeX * Math.abs(dx) + sizeY * Math.abs(dy) + sizeZ * Math.abs(dz);
        double e = AxisBody.ROUNDOFF * size + AxisBody.TINY;
        double ev = AxisBody.ROUNDOFF * speedSize;
        if (speedSize < SMALL && !(isNone(sizeX, dx) && isNone(sizeY, dy) && isNone(sizeZ, dz))) {
            ev += AxisBody.TINY;
        }
        double ahead = first.lo - second.hi;
        double behind = second.lo - first.hi;
        if ((ahead > e && ahead + v > e + ev) || (behind > e && behind - v > e + ev)) {
            return true;
        }
        double sizes = sizeX + sizeY + sizeZ;
        double length = Math.sqrt(nx * nx + ny * ny + nz * nz);
        note(ahead, e, v, ev, length, AxisBody.ROUNDOFF * sizes);
        note(behind, e, -v, ev, length, AxisBody.ROUNDOFF * sizes);
        return false;
    }

    private static boolean isNone(double p, double q) {
        return p == 0 || q == 0;
    }

    private void note(double g, double e, double v, double ev, double norm, double normError) {
        gap[count] = g;
        gapError[count] = e;
        speed[count] = v;
        speedError[count] = ev;
        length[count] = norm;
        lengthError[count] = normError;
        count++;
    }

    // The answer if doubles determine it, otherwise NaN.
    private double verdict;

    // A lower bound of the time of contact, if the two certainly meet.
    private double earliest;

    /** Whether the two certainly meet, at a time yet to be computed; otherwise {@link #verdict} is the answer. */
    private boolean decide() {
        double enterLo = 0;
        double enterHi = 0;
        double leaveLo = Double.POSITIVE_INFINITY;
        double leaveHi = Double.POSITIVE_INFINITY;
        boolean apart = false;
        boolean doubt = false;
        for (int k = 0; k < count; k++) {
            double g = gap[k];
            double e = gapError[k];
            double v = speed[k];
            double ev = speedError[k];
            if (g > e) {
                apart = true;
                enterLo = Math.max(enterLo, (g - e) / Math.max(0, ev - v));
                enterHi = Math.max(enterHi, latest(k));
            } else if (!(g < -e)) {
                doubt = true;
                enterHi = Math.max(enterHi, -v > ev ? (g + e) / (-v - ev) : v <= ev ? Double.POSITIVE_INFINITY : 0);
                leaveLo = v > -ev ? 0 : leaveLo;
            } else if (v > -ev && v + ev > 0) {
                leaveLo = Math.min(leaveLo, (-g - e) / (v + ev));
                leaveHi = Math.min(leaveHi, v > ev ? (e - g) / (v - ev) : Double.POSITIVE_INFINITY);
            }
        }
        if (!apart) {
            verdict = doubt ? Double.NaN : fromContact();
            return false;
        }
        earliest = enterLo;
        boolean isLate = enterLo * SURE > latest;
        verdict = isLate || enterLo > 1 || enterLo > leaveHi ? Double.POSITIVE_INFINITY : Double.NaN;
        return !isLate && enterHi <= 1 && enterHi <= leaveLo;
    }

    /** The latest time at which the gap in a direction may close. */
    private double latest(int k) {
        double closing = -speed[k] - speedError[k];
        return closing > 0 ? (gap[k] + gapError[k]) / closing : Double.POSITIVE_INFINITY;
    }

    /** The time at which the last gap closes, rounded down; NaN where pairs of doubles cannot tell. */
    private double enter() {
        double time = 0;
        for (int k = 0; k < count; k++) {
            if (gap[k] > gapError[k] && latest(k) >= earliest) {
                double closes = fine.time(axis[k / 2], (k & 1) == 0, gapError[k], speedError[k], first, second);
                if (Double.isNaN(closes)) {
                    return closes;
                }
                time = Math.max(time, closes);
            }
        }
        return time;
    }

    /** Certainly overlapping at the start: blocked where the motion goes against every shortest way out. */
    private double fromContact() {
        double least = Double.POSITIVE_INFINITY;
        for (int k = 0; k < count; k++) {
            if (length[k] > lengthError[k]) {
                least = Math.min(least, (gapError[k] - gap[k]) / (length[k] - lengthError[k]));
            }
        }
        boolean into = false;
        boolean away = false;
        for (int k = 0; k < count; k++) {
            double depth = (-gap[k] - gapError[k]) / (length[k] + lengthError[k]);
            if (depth <= least * (1 + AxisBody.ROUNDOFF)) {
                if (speed[k] < -speedError[k]) {
                    into = true;
                } else if (speed[k] >= speedError[k]) {
                    away = true;
                } else {
                    return Double.NaN;
                }
            }
        }
        return into ? away ? Double.NaN : 0 : Double.POSITIVE_INFINITY;
    }
}
