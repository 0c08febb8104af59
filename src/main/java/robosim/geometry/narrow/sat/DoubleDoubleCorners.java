package robosim.geometry.narrow.sat;

import robosim.geometry.exact.DoubleDoubleSum;
import robosim.geometry.narrow.leaf.PrismCorners;

/** The counterpart of {@link PrismCorners} in pairs of doubles. */
public final class DoubleDoubleCorners {
    final DoubleDoubleSum[] x = sums(8);
    final DoubleDoubleSum[] z = sums(8);

    private final DoubleDoubleSum[] bound = sums(8);
    private final DoubleDoubleSum left = new DoubleDoubleSum();
    private final DoubleDoubleSum right = new DoubleDoubleSum();
    private final DoubleDoubleSum near = new DoubleDoubleSum();
    private final DoubleDoubleSum far = new DoubleDoubleSum();
    private final DoubleDoubleSum trial = new DoubleDoubleSum();

    public static DoubleDoubleSum[] sums(int count) {
        DoubleDoubleSum[] sums = new DoubleDoubleSum[count];
        for (int k = 0; k < count; k++) {
            sums[k] = new DoubleDoubleSum();
        }
        return sums;
    }

    void load(double[] row, int at, double ox, double oz) {
        for (int k = 0; k < 8; k++) {
            bound[k].clear();
            bound[k].add(row[at + k], 0);
            if (k < 2 || k > 3) {
                bound[k].add(-ox, 0);
            }
            if (k > 1) {
                bound[k].add(k > 5 ? oz : -oz, 0);
            }
        }
        DoubleDoubleSum s0 = bound[4];
        DoubleDoubleSum s1 = bound[5];
        DoubleDoubleSum d0 = bound[6];
        DoubleDoubleSum d1 = bound[7];
        left.set(bound[0]);
        atLeast(left, s0, 1, d0, 0.5);
        atLeast(left, s0, -1, bound[3], 1);
        atLeast(left, d0, 1, bound[2], 1);
        right.set(bound[1]);
        atMost(right, s1, 1, d1, 0.5);
        atMost(right, s1, -1, bound[2], 1);
        atMost(right, d1, 1, bound[3], 1);
        near.set(bound[2]);
        atLeast(near, s0, -1, d1, 0.5);
        atLeast(near, s0, -1, bound[1], 1);
        atLeast(near, bound[0], -1, d1, 1);
        far.set(bound[3]);
        atMost(far, s1, -1, d0, 0.5);
        atMost(far, s1, -1, bound[0], 1);
        atMost(far, bound[1], -1, d0, 1);
        atLeast(s0, left, 1, near, 1);
        atMost(s1, right, 1, far, 1);
        atLeast(d0, left, -1, far, 1);
        atMost(d1, right, -1, near, 1);
        write(0, right, right, d1);
        write(1, right, s1, right);
        write(4, left, left, d0);
        write(5, left, s0, left);
        cross(2, s1, -1, far);
        cross(3, d0, 1, far);
        cross(6, s0, -1, near);
        cross(7, d1, 1, near);
    }

    // x as given, z = p - q
    private void write(int k, DoubleDoubleSum along, DoubleDoubleSum p, DoubleDoubleSum q) {
        x[k].set(along);
        combine(p, -1, q, 1, z[k]);
    }

    // x = p + sign q, z = q
    private void cross(int k, DoubleDoubleSum p, int sign, DoubleDoubleSum q) {
        combine(p, sign, q, 1, x[k]);
        z[k].set(q);
    }

    private void atLeast(DoubleDoubleSum value, DoubleDoubleSum p, int sign, DoubleDoubleSum q, double factor) {
        combine(p, sign, q, factor, trial);
        if (value.isBelow(trial)) {
            value.set(trial);
        }
    }

    private void atMost(DoubleDoubleSum value, DoubleDoubleSum p, int sign, DoubleDoubleSum q, double factor) {
        combine(p, sign, q, factor, trial);
        if (trial.isBelow(value)) {
            value.set(trial);
        }
    }

    private static void combine(DoubleDoubleSum p, int sign, DoubleDoubleSum q, double factor, DoubleDoubleSum out) {
        out.clear();
        out.add(p);
        out.plain &= q.plain;
        out.add(sign * q.hi, sign * q.lo);
        out.hi *= factor;
        out.lo *= factor;
    }
}
