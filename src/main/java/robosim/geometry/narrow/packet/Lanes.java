package robosim.geometry.narrow.packet;

/**
 * Loops over one number of each ray of a packet. Each is short and always of one length, so that the compiler turns it into
 * vector instructions; a longer one it would leave as it is.
 */
final class Lanes {
    /** The number of rays in a packet: one for each bit of a long. */
    static final int COUNT = Long.SIZE;

    /** Added to a slope, so that none is 0: far below what the slack of a leaf allows for. */
    private static final double LEVEL = 0x1p-60;

    /** What makes the least shortfall of a chord longer than any way; less of one does not matter. */
    private static final double FAR = 0x1p400;

    private Lanes() {}

    /** The reciprocals of the slopes along a direction. */
    static void inverses(double[] x, double[] y, double[] z, double ax, double ay, double az, double[] out) {
        for (int i = 0; i < COUNT; i++) {
            out[i] = 1 / (x[i] * ax + y[i] * ay + z[i] * az + LEVEL);
        }
    }

    /** The slopes along a direction. */
    static void slopes(double[] x, double[] y, double[] z, double ax, double ay, double az, double[] out) {
        for (int i = 0; i < COUNT; i++) {
            out[i] = x[i] * ax + y[i] * ay + z[i] * az;
        }
    }

    /** Begins with what is within a slab about 0, which a ray from a height crosses: where it enters, at least 0, and leaves. */
    static void slab(double[] inverses, double height, double half, double[] enter, double[] leave) {
        for (int i = 0; i < COUNT; i++) {
            double middle = -height * inverses[i];
            double wide = half * Math.abs(inverses[i]);
            enter[i] = Math.max(0, middle - wide);
            leave[i] = middle + wide;
        }
    }

    /** Keeps what is within one more slab. */
    static void clip(double[] inverses, double height, double half, double[] enter, double[] leave) {
        for (int i = 0; i < COUNT; i++) {
            double middle = -height * inverses[i];
            double wide = half * Math.abs(inverses[i]);
            enter[i] = Math.max(enter[i], middle - wide);
            leave[i] = Math.min(leave[i], middle + wide);
        }
    }

    /** The rays that leave, or end, no sooner than they enter; also where a number is none. */
    static long hits(double[] enter, double[] leave, double[] near) {
        long met = 0;
        for (int i = 0; i < COUNT; i++) {
            met |= (enter[i] > leave[i] || enter[i] > near[i] ? 0L : 1L) << i;
        }
        return met;
    }

    /** The rays that enter above 0, and what is smaller no later than they leave that; not where a number is none. */
    static long sure(double[] enter, double[] late, double[] leave) {
        long sure = 0;
        for (int i = 0; i < COUNT; i++) {
            sure |= (enter[i] > 0 && late[i] <= leave[i] ? 1L : 0L) << i;
        }
        return sure;
    }

    /** How far ahead a point is along each ray, which begins at 0. */
    static void ahead(
            double[] x, double[] y, double[] z, double mx, double my, double mz, double[] ahead, double[] aside) {
        for (int i = 0; i < COUNT; i++) {
            double along = x[i] * mx + y[i] * my + z[i] * mz;
            double ex = mx - along * x[i];
            double ey = my - along * y[i];
            double ez = mz - along * z[i];
            ahead[i] = along;
            aside[i] = ex * ex + ey * ey + ez * ez;
        }
    }

    /** The rays for which a number is not above a limit; also where it is none. */
    static long within(double[] numbers, double limit) {
        long met = 0;
        for (int i = 0; i < COUNT; i++) {
            met |= (numbers[i] > limit ? 0L : 1L) << i;
        }
        return met;
    }

    /** The squared lengths, the products with an offset and the cross products with it, of slopes along two directions. */
    static void across(
            double[] x, double[] z, double mx, double mz, double[] square, double[] product, double[] cross) {
        for (int i = 0; i < COUNT; i++) {
            square[i] = x[i] * x[i] + z[i] * z[i];
            product[i] = x[i] * mx + z[i] * mz;
            cross[i] = mx * z[i] - mz * x[i];
        }
    }

    /**
     * Keeps what is within a circle of a squared radius, given what {@link #across} tells. A ray that passes it by enters
     * much later than it leaves.
     */
    static void circle(
            double[] square, double[] product, double[] cross, double squareRadius, double[] enter, double[] leave) {
        for (int i = 0; i < COUNT; i++) {
            double inverse = 1 / square[i];
            double chord = squareRadius * square[i] - cross[i] * cross[i];
            double middle = -product[i] * inverse;
            double half = Math.sqrt(Math.max(chord, 0)) * inverse;
            enter[i] = Math.max(enter[i], middle - half - Math.min(chord, 0) * FAR);
            leave[i] = Math.min(leave[i], middle + half);
        }
    }

    /** The greatest number. */
    static double most(double[] numbers) {
        double a = numbers[0];
        double b = numbers[1];
        double c = numbers[2];
        double d = numbers[3];
        for (int i = 4; i < COUNT; i += 4) {
            a = a > numbers[i] ? a : numbers[i];
            b = b > numbers[i + 1] ? b : numbers[i + 1];
            c = c > numbers[i + 2] ? c : numbers[i + 2];
            d = d > numbers[i + 3] ? d : numbers[i + 3];
        }
        return Math.max(Math.max(a, b), Math.max(c, d));
    }
}
