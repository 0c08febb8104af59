package robosim.geometry.narrow;

import robosim.geometry.exact.Degrees;
import robosim.geometry.exact.Radians;

/**
 * A leaf of any kind turned about any axis, against one at rest: held axes.
 *
 * <p>At an angle an axis that tells the two apart is found, and held, once in the world, where the mover's points run on
 * sinusoids, and once in the mover, where the other's do. The turn is free for as long as the better of the two goes on
 * telling them apart; there the next axis is looked for. Only these axes prove anything, with all rounding counted; how
 * they are found does not matter. From contact the same is done with the depth at the start allowed for.
 */
final class HeldTurn {
    private static final double FULL = 2 * Math.PI;
    private static final int MOST_STEPS = 400;

    /** A gap of this share of the mover's size that hardly lets it go on counts as contact. */
    private static final double CLOSE = 0x1p-34;

    private static final double STALLED = 0x1p-16;

    private final TurnBody mover = new TurnBody();
    private final TurnBody rest = new TurnBody();
    private final double[] pose = new double[Leaf.STRIDE];
    private final double[] box = new double[Leaf.STRIDE];

    private boolean planar;
    private double wx;
    private double wy;
    private double wz;

    /** As {@link SpatialSweep#turn} and {@link PlanarSweep#turn}. */
    double free(
            boolean inPlane,
            int kindA,
            double[] a,
            int i,
            double px,
            double py,
            double pz,
            double axisX,
            double axisY,
            double axisZ,
            double degrees,
            int kindB,
            double[] b,
            int j,
            Scratch s) {
        Gjk gjk = s.gjk;
        Penetration ways = s.penetration();
        double way = degrees < 0 ? -1 : 1;
        planar = inPlane;
        wx = way * axisX;
        wy = way * axisY;
        wz = way * axisZ;
        mover.level = planar && wx == 0 && wz == 0;
        rest.level = mover.level;
        mover.load(kindA, a, i, px, py, pz, wx, wy, wz);
        rest.load(kindB, b, j, px, py, pz, wx, wy, wz);
        double angle = Degrees.toRadians(Math.abs(degrees));
        double wanted = angle * (1 + 0x1p-50) + TurnOutline.MARGIN;
        double t = 0;
        double depth = 0;
        ask(gjk, kindA, a, i, kindB, b, j);
        if (!(gjk.lower() > 0)) {
            depth = Math.max(0, depth(ways, kindA, a, i, kindB, b, j));
            t = fromContact(ways);
            if (t == 0) {
                return 0;
            }
        }
        int kind = Poses.turnedKind(kindA);
        for (int step = 0; step < MOST_STEPS; step++) {
            if (t >= wanted || t >= FULL) {
                return Double.POSITIVE_INFINITY;
            }
            pose(kindA, a, i, px, py, pz, t);
            ask(gjk, kind, pose, 0, kindB, b, j);
            double gap = gjk.lower() > 0 ? gjk.upper() : 0;
            double next = t;
            if (gjk.lower() > 0) {
                next = hold(gjk.nx(), gjk.ny(), gjk.nz(), t, depth);
            } else if (depth > 0) {
                depth(ways, kind, pose, 0, kindB, b, j);
                for (int k = 0; k < ways.count(); k++) {
                    next = Math.max(next, hold(ways.nx(k), ways.ny(k), ways.nz(k), t, depth));
                }
            }
            if (!(next > t) || (gap + depth < CLOSE * mover.extent && next - t < STALLED)) {
                break;
            }
            t = next;
        }
        return Math.min(Math.nextDown(1.0), Math.max(0, t / angle * (1 - 0x1p-50)));
    }

    private void ask(Gjk gjk, int kindA, double[] a, int i, int kindB, double[] b, int j) {
        if (planar) {
            gjk.planar(kindA, a, i, kindB, b, j);
        } else {
            gjk.spatial(kindA, a, i, kindB, b, j);
        }
    }

    private double depth(Penetration ways, int kindA, double[] a, int i, int kindB, double[] b, int j) {
        return planar ? ways.planar(kindA, a, i, kindB, b, j) : ways.spatial(kindA, a, i, kindB, b, j);
    }

    private void pose(int kind, double[] row, int at, double px, double py, double pz, double t) {
        double cos = Radians.cos(t);
        double sin = Radians.sin(t);
        if (kind == Leaf.PRISM) {
            // Its box, which is good enough to find axes by.
            boxOf(row, at);
            Poses.turned(Leaf.UPRIGHT_BOX, box, 0, px, py, pz, wx, wy, wz, cos, sin, pose);
        } else {
            Poses.turned(kind, row, at, px, py, pz, wx, wy, wz, cos, sin, pose);
        }
    }

    /** The angle until which a direction from the other to the mover, found at t, tells of no more than a depth. */
    private double hold(double nx, double ny, double nz, double t, double depth) {
        rest.aim(-nx, -ny, -nz, 1);
        double place = -rest.least(0) + rest.error() - depth;
        mover.aim(nx, ny, nz, 1);
        double end = mover.until(place, t);
        if (!planar || mover.level) {
            // The direction in the mover as it stood at the start.
            double cos = Radians.cos(t);
            double sin = -Radians.sin(t);
            double along = (wx * nx + wy * ny + wz * nz) * (1 - cos);
            double mx = nx * cos + (wy * nz - wz * ny) * sin + wx * along;
            double my = ny * cos + (wz * nx - wx * nz) * sin + wy * along;
            double mz = nz * cos + (wx * ny - wy * nx) * sin + wz * along;
            mover.aim(mx, my, mz, 1);
            place = -mover.least(0) + mover.error() - depth;
            rest.aim(-mx, -my, -mz, -1);
            end = Math.max(end, rest.until(place, t));
        }
        return end;
    }

    private double fromContact(Penetration ways) {
        double best = 0;
        for (int k = 0; k < ways.count(); k++) {
            mover.aim(ways.nx(k), ways.ny(k), ways.nz(k), 1);
            best = Math.max(best, mover.notFurtherBack());
            if (!planar || mover.level) {
                rest.aim(-ways.nx(k), -ways.ny(k), -ways.nz(k), -1);
                best = Math.max(best, rest.notFurtherBack());
            }
        }
        return best;
    }

    /** The upright box around a prism. */
    private void boxOf(double[] prism, int at) {
        for (int k = 0; k < 3; k++) {
            int from = at + (k == 0 ? 0 : k == 1 ? 8 : 2);
            box[k] = 0.5 * (prism[from] + prism[from + 1]);
            box[k + 3] = 0.5 * (prism[from + 1] - prism[from]);
        }
        java.util.Arrays.fill(box, Leaf.ROTATION, Leaf.STRIDE, 0);
        box[6] = 1;
        box[10] = 1;
        box[14] = 1;
    }
}
