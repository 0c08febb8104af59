package robosim.geometry.stress;

import java.util.SplittableRandom;
import robosim.geometry.reference.Truth.Form;

/** Thin beside wide and huge beside tiny: sizes of one case that differ by 10^3 to 10^20. */
final class Mixed {
    /** One random case in so many. */
    static final int ONE_IN = 8;

    private Mixed() {}

    /** One of so many random cases. */
    static boolean isDue(SplittableRandom random) {
        return random.nextInt(ONE_IN) == 0;
    }

    static double factor(SplittableRandom random) {
        return StrictMath.pow(10, -3 - 17 * random.nextDouble());
    }

    /** A distance from which what is of size 1 is still aimed at. */
    static double far(SplittableRandom random) {
        return StrictMath.pow(10, 3 + 9 * random.nextDouble());
    }

    /** Makes two forms of size about 1 thin, or one of them tiny, or both; never none. */
    static void sizes(Case c, SplittableRandom random) {
        int which = random.nextInt(1, 8);
        if ((which & 1) != 0) {
            thin(c.formA, random, c.a);
        }
        if ((which & 2) != 0) {
            thin(c.formB, random, c.b);
        }
        if ((which & 4) != 0) {
            boolean first = random.nextBoolean();
            shrink(first ? c.formA : c.formB, first ? c.a : c.b, factor(random));
        }
    }

    /** Makes one form thin, or tiny, or both. */
    static void sizes(Form form, SplittableRandom random, double[] row) {
        int which = random.nextInt(1, 4);
        if ((which & 1) != 0) {
            thin(form, random, row);
        }
        if ((which & 2) != 0) {
            shrink(form, row, factor(random));
        }
    }

    /** Makes one form thin or tiny, but not so much that a direction's rounding leads past it. */
    static void aimable(Form form, SplittableRandom random, double[] row) {
        double factor = StrictMath.pow(10, -3 - 9 * random.nextDouble());
        if (random.nextBoolean()) {
            thin(form, random, row, factor);
        } else {
            shrink(form, row, factor);
        }
    }

    /** Takes nearly all of one or two of its sizes; a triangle becomes a needle. */
    static void thin(Form form, SplittableRandom random, double[] row) {
        thin(form, random, row, factor(random));
    }

    private static void thin(Form form, SplittableRandom random, double[] row, double factor) {
        if (form != Form.TRIANGLE) {
            row[3 + random.nextInt(3)] *= factor;
            if (random.nextInt(3) == 0) {
                row[3 + random.nextInt(3)] *= factor;
            }
            return;
        }
        int corner = 3 * random.nextInt(3);
        if (random.nextBoolean()) { // along an axis, so that nothing is rounded away
            int axis = random.nextInt(3);
            for (int k = axis; k < 9; k += 3) {
                row[k] *= factor;
            }
            return;
        }
        for (int k = 0; k < 3; k++) {
            double foot = (row[(corner + 3) % 9 + k] + row[(corner + 6) % 9 + k]) / 2;
            row[corner + k] = foot + factor * (row[corner + k] - foot);
        }
    }

    /** Makes all of it smaller, about its middle. */
    static void shrink(Form form, double[] row, double factor) {
        if (form != Form.TRIANGLE) {
            for (int k = 3; k < 6; k++) {
                row[k] *= factor;
            }
            return;
        }
        for (int k = 0; k < 9; k++) {
            row[k] *= factor;
        }
    }

    /** A point in general position in the form, or beside it by up to a third of its sizes. */
    static void about(Form form, SplittableRandom random, double[] row, double[] out) {
        if (form == Form.TRIANGLE) {
            double s = Forms.between(random, 0.8) + 0.5;
            double t = Forms.between(random, 0.8) + 0.5;
            for (int k = 0; k < 3; k++) {
                out[k] = row[k] + s * (row[3 + k] - row[k]) + t * (row[6 + k] - row[3 + k]);
            }
            return;
        }
        boolean round = form == Form.SPHERE;
        double x = row[3] * Forms.between(random, 1.3);
        double y = (form.isCapsule() ? row[3] + row[4] : row[round ? 3 : 4]) * Forms.between(random, 1.3);
        double z = row[form == Form.UPRIGHT_BOX || form == Form.BOX ? 5 : 3] * Forms.between(random, 1.3);
        for (int k = 0; k < 3; k++) {
            out[k] = Forms.hasAxes(form)
                    ? row[k] + x * row[6 + 3 * k] + y * row[7 + 3 * k] + z * row[8 + 3 * k]
                    : row[k] + (k == 0 ? x : k == 1 ? y : z);
        }
    }

    /** Puts two forms together, each with a point about it at the origin: about as often touching as not. */
    static void meet(Case c, SplittableRandom random) {
        double[] p = new double[3];
        about(c.formA, random, c.a, p);
        Forms.move(c.formA, c.a, -p[0], -p[1], -p[2]);
        about(c.formB, random, c.b, p);
        if (c.formA == Form.TRIANGLE || c.formB == Form.TRIANGLE) { // which is flat: a general point is off its plane
            double off = 0.3 * Math.min(Forms.reach(c.formA, c.a), Forms.reach(c.formB, c.b));
            for (int k = 0; k < 3; k++) {
                p[k] += Forms.between(random, off);
            }
        }
        Forms.move(c.formB, c.b, -p[0], -p[1], -p[2]);
    }

    /** Puts two forms together, a corner or an edge or a side of each at the origin, or off by a share of the smaller. */
    static void touch(Case c, SplittableRandom random) {
        double[] p = new double[3];
        Forms.point(c.formA, random, c.a, p);
        Forms.move(c.formA, c.a, -p[0], -p[1], -p[2]);
        Forms.point(c.formB, random, c.b, p);
        Forms.move(c.formB, c.b, -p[0], -p[1], -p[2]);
        if (random.nextInt(3) != 0) {
            double off = Math.min(Forms.reach(c.formA, c.a), Forms.reach(c.formB, c.b))
                    * (random.nextBoolean() ? 1 : Forms.tiny(random));
            Forms.move(
                    c.formB, c.b, Forms.between(random, off), Forms.between(random, off), Forms.between(random, off));
        }
    }
}
