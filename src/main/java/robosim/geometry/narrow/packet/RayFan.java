package robosim.geometry.narrow.packet;

import robosim.geometry.exact.BeamAxis;
import robosim.geometry.exact.VectorMath;

/**
 * Up to 64 rays in the plane that begin at one place, in the order of their directions. So those that may meet a box are
 * neighbours, of which the first and the last are found by halving.
 *
 * <p>Boxes are widened by a share of all coordinates: by more than what is rounded here and by kernels. An instance belongs to
 * one owner of queries and allocates nothing.
 */
public final class RayFan {
    /** Rays farther than 20 degrees from their middle share too little. */
    private static final double NARROW = 0.94;

    /** More than what is rounded as the sector of the rays is found. */
    private static final double WIDER = 0x1p-40;

    /** The share of the coordinates by which boxes are widened, and more than what may be lost by underflow. */
    private static final double PAD = 0x1p-40;

    private static final double UNDERFLOW = 0x1p-1000;

    /** The unit directions, and their magnitudes along the axes. */
    private final double[] x = new double[Lanes.COUNT];

    private final double[] z = new double[Lanes.COUNT];
    private final double[] wideX = new double[Lanes.COUNT];
    private final double[] wideZ = new double[Lanes.COUNT];
    private final BeamAxis sector = new BeamAxis();

    /** 1 where the rays turn from +X to +Z, else -1. */
    private double turn = 1;

    private int count;
    private int first;
    private int last;
    private double nearest;

    /**
     * Sets the rays.
     *
     * @param directions three numbers each, of which the second does not count, from an index on
     * @param number how many rays, 1 to 64
     * @return false where they are not in order, or spread too far
     */
    public boolean aim(double ox, double oz, double[] directions, int at, int number) {
        count = number;
        double sumX = 0;
        double sumZ = 0;
        for (int i = 0, k = at; i < number; i++, k += 3) {
            double scale = 1 / VectorMath.largest(directions[k], 0, directions[k + 2]);
            double dx = directions[k] * scale;
            double dz = directions[k + 2] * scale;
            double inverse = 1 / Math.sqrt(dx * dx + dz * dz);
            x[i] = dx * inverse;
            z[i] = dz * inverse;
            wideX[i] = Math.abs(x[i]);
            wideZ[i] = Math.abs(z[i]);
            sumX += x[i];
            sumZ += z[i];
        }
        double length = Math.sqrt(sumX * sumX + sumZ * sumZ);
        if (!(length >= NARROW * number)) { // written so that NaN fails it
            return false;
        }
        double least = 1;
        for (int i = 0; i < number; i++) {
            least = Math.min(least, (x[i] * sumX + z[i] * sumZ) / length);
        }
        double cos = least - WIDER;
        sector.line(ox, 0, oz, sumX, 0, sumZ).widen(cos, Math.sqrt((1 - cos) * (1 + cos)) + WIDER);
        return cos >= NARROW && isInOrder();
    }

    private boolean isInOrder() {
        turn = x[0] * z[count - 1] - z[0] * x[count - 1] < 0 ? -1 : 1;
        for (int i = 1; i < count; i++) {
            if (!(turn * (x[i - 1] * z[i] - z[i - 1] * x[i]) >= 0)) {
                return false;
            }
        }
        return true;
    }

    /** The number of rays. */
    public int count() {
        return count;
    }

    /** The sector of the rays. */
    public BeamAxis sector() {
        return sector;
    }

    /**
     * Finds the rays that may meet a box of six numbers, of which the heights do not count.
     *
     * @param isDisc whether the box is that of a disc, which is all that is there
     * @return false where there are none
     */
    public boolean find(double[] b, int at, boolean isDisc) {
        double mx = b[at] / 2 + b[at + 3] / 2 - sector.ox;
        double mz = b[at + 2] / 2 + b[at + 5] / 2 - sector.oz;
        double hx = b[at + 3] / 2 - b[at] / 2;
        double hz = b[at + 5] / 2 - b[at + 2] / 2;
        double pad =
                PAD * (Math.abs(mx) + Math.abs(mz) + Math.abs(sector.ox) + Math.abs(sector.oz) + hx + hz) + UNDERFLOW;
        double beyondX = Math.max(0, Math.abs(mx) - hx);
        double beyondZ = Math.max(0, Math.abs(mz) - hz);
        nearest = Math.sqrt(beyondX * beyondX + beyondZ * beyondZ) * (1 - PAD) - pad;
        double ux = sector.ux();
        double uz = sector.uz();
        first = 0;
        last = count - 1;
        if (mx * ux + mz * uz - (hx * Math.abs(ux) + hz * Math.abs(uz)) > pad) {
            // All of it is ahead, so that it is beside a line only where it is beside the ray.
            double round = isDisc ? Math.max(hx, hz) + pad : Double.POSITIVE_INFINITY;
            first = before(turn * mx, turn * mz, hx, hz, round, pad);
            last = count - 1 - after(turn * mx, turn * mz, hx, hz, round, pad);
        }
        return first <= last;
    }

    /** How many rays there are before those that may meet a box, which is on the far side of their turn. */
    private int before(double mx, double mz, double hx, double hz, double round, double pad) {
        int found = 0;
        for (int step = Lanes.COUNT / 2; step > 0; step /= 2) {
            int i = Math.min(found + step, count) - 1;
            double wide = Math.min(round, hx * wideZ[i] + hz * wideX[i] + pad);
            found = x[i] * mz - z[i] * mx > wide ? i + 1 : found;
        }
        return found;
    }

    /** How many rays there are after them. */
    private int after(double mx, double mz, double hx, double hz, double round, double pad) {
        int found = 0;
        for (int step = Lanes.COUNT / 2; step > 0; step /= 2) {
            int i = count - Math.min(found + step, count);
            double wide = Math.min(round, hx * wideZ[i] + hz * wideX[i] + pad);
            found = z[i] * mx - x[i] * mz > wide ? count - i : found;
        }
        return found;
    }

    /** The first ray that may meet the last box. */
    public int first() {
        return first;
    }

    /** The last ray that may meet it. */
    public int last() {
        return last;
    }

    /** A lower bound of how far it is; may be below 0. */
    public double nearest() {
        return nearest;
    }
}
