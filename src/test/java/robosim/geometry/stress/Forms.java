package robosim.geometry.stress;

import java.util.Arrays;
import java.util.SplittableRandom;
import robosim.geometry.reference.Truth.Form;

/** Rows of forms made up at random. */
final class Forms {
    private static final int[][] TRIPLES = {{3, 4, 5}, {5, 12, 13}, {8, 15, 17}, {7, 24, 25}, {20, 21, 29}};
    private static final int[][] QUADRUPLES = {{1, 2, 2, 3}, {2, 3, 6, 7}, {1, 4, 8, 9}, {4, 4, 7, 9}, {2, 6, 9, 11}};

    private Forms() {}

    /** Of size about 1 about the origin, in general position. */
    static void random(Form form, SplittableRandom random, double[] row) {
        Arrays.fill(row, 0);
        if (form == Form.TRIANGLE) {
            for (int k = 0; k < 9; k++) {
                row[k] = between(random, 1);
            }
            return;
        }
        for (int k = 3; k < 6; k++) {
            row[k] = 0.2 + 0.8 * random.nextDouble();
        }
        if (isTurned(form)) {
            turn(random, row);
        } else {
            yaw(row, between(random, Math.PI));
        }
    }

    /** On whole numbers, where much touches and ties; sizes of zero included. */
    static void grid(Form form, SplittableRandom random, double[] row) {
        Arrays.fill(row, 0);
        if (form == Form.TRIANGLE) {
            for (int k = 0; k < 9; k++) {
                row[k] = random.nextInt(-3, 4);
            }
            return;
        }
        for (int k = 0; k < 3; k++) {
            row[k] = random.nextInt(-3, 4);
            row[3 + k] = random.nextInt(0, 4) * (random.nextInt(4) == 0 ? 0.5 : 1);
        }
        if (isTurned(form)) {
            switch (random.nextInt(3)) {
                case 0 -> turn(random, row);
                case 1 -> tilted(random, row);
                default -> quarters(random, row);
            }
        } else if (random.nextInt(4) == 0) {
            upright(row, 0.6, 0.8);
        } else {
            int turn = random.nextInt(4);
            upright(row, turn == 0 ? 1 : turn == 2 ? -1 : 0, turn == 1 ? 1 : turn == 3 ? -1 : 0);
        }
    }

    /** Two touching to the last bit at whole numbers times a power of two: (dx, dy, dz, length). */
    static int[] pythagorean(SplittableRandom random, boolean flat) {
        int[] lengths = flat ? TRIPLES[random.nextInt(TRIPLES.length)] : QUADRUPLES[random.nextInt(QUADRUPLES.length)];
        int[] out = flat ? new int[] {lengths[0], 0, lengths[1], lengths[2]} : lengths.clone();
        for (int k = 0; k < 3; k++) {
            int other = flat ? 2 * random.nextInt(2) : random.nextInt(3);
            int from = flat ? 0 : k;
            int swap = out[from];
            out[from] = out[other];
            out[other] = swap;
        }
        for (int k = 0; k < 3; k++) {
            out[k] *= random.nextBoolean() ? 1 : -1;
        }
        return out;
    }

    /** A turn by a random amount about a random axis, or about the vertical and then an own axis. */
    static void turn(SplittableRandom random, double[] row) {
        if (random.nextInt(4) == 0) {
            pitched(random, row);
            return;
        }
        double w = between(random, 1);
        double x = between(random, 1);
        double y = between(random, 1);
        double z = between(random, 1);
        double n = w * w + x * x + y * y + z * z;
        if (n < 0.01) {
            quarters(random, row);
            return;
        }
        quaternion(row, w, x, y, z);
    }

    /** One own axis stays level: the two others throw segments that are parallel, but for their rounding. */
    private static void pitched(SplittableRandom random, double[] row) {
        double yaw = between(random, Math.PI);
        double pitch = between(random, Math.PI) * (random.nextBoolean() ? 1 : tiny(random));
        double c = StrictMath.cos(yaw);
        double s = StrictMath.sin(yaw);
        double level = StrictMath.cos(pitch);
        double rise = StrictMath.sin(pitch);
        double[][] axes = {{c, 0, -s}, {s * rise, level, c * rise}, {s * level, -rise, c * level}};
        int first = random.nextInt(3);
        for (int k = 0; k < 3; k++) {
            for (int axis = 0; axis < 3; axis++) {
                row[6 + 3 * k + (axis + first) % 3] = axes[axis][k];
            }
        }
    }

    /** The rotation of a quaternion of any length. */
    static void quaternion(double[] row, double w, double x, double y, double z) {
        double k = 2 / (w * w + x * x + y * y + z * z);
        row[6] = 1 - k * (y * y + z * z);
        row[7] = k * (x * y - z * w);
        row[8] = k * (x * z + y * w);
        row[9] = k * (x * y + z * w);
        row[10] = 1 - k * (x * x + z * z);
        row[11] = k * (y * z - x * w);
        row[12] = k * (x * z - y * w);
        row[13] = k * (y * z + x * w);
        row[14] = 1 - k * (x * x + y * y);
    }

    /** Turns by the angle of the 3-4-5 triangle and by quarters: as good as dyadic to the eye, and not to the bit. */
    private static void tilted(SplittableRandom random, double[] row) {
        quaternion(row, 2, random.nextInt(2), random.nextInt(2), random.nextInt(2));
    }

    /** One of the 24 attitudes with all axes along the world's. */
    static void quarters(SplittableRandom random, double[] row) {
        int first = random.nextInt(3);
        int second = (first + 1 + random.nextInt(2)) % 3;
        int third = 3 - first - second;
        Arrays.fill(row, 6, 15, 0);
        double s = random.nextBoolean() ? 1 : -1;
        double t = random.nextBoolean() ? 1 : -1;
        boolean even = (second - first + 3) % 3 == 1;
        row[6 + 3 * first] = s;
        row[7 + 3 * second] = t;
        row[8 + 3 * third] = even ? s * t : -s * t;
    }

    static void yaw(double[] row, double radians) {
        upright(row, StrictMath.cos(radians), StrictMath.sin(radians));
    }

    static void upright(double[] row, double cos, double sin) {
        row[6] = cos;
        row[7] = 0;
        row[8] = sin;
        row[9] = 0;
        row[10] = 1;
        row[11] = 0;
        row[12] = 0.0 - sin;
        row[13] = 0;
        row[14] = cos;
    }

    /** Turns the columns of a rotation a little about each other, as stored and without setting them right. */
    static void disturb(Form form, SplittableRandom random, double[] row, double angle) {
        if (form == Form.UPRIGHT_BOX) {
            double c = row[6] - angle * row[8];
            double s = row[8] + angle * row[6];
            double n = Math.sqrt(c * c + s * s);
            upright(row, c / n, s / n);
            return;
        }
        double[] q = {between(random, 1), between(random, 1), between(random, 1)};
        double[] small = new double[Case.ROW];
        quaternion(small, 2, angle * q[0], angle * q[1], angle * q[2]);
        double[] r = Arrays.copyOfRange(row, 6, 15);
        for (int i = 0; i < 3; i++) {
            for (int j = 0; j < 3; j++) {
                row[6 + 3 * i + j] =
                        r[3 * i] * small[6 + j] + r[3 * i + 1] * small[9 + j] + r[3 * i + 2] * small[12 + j];
            }
        }
    }

    /** Moves a form. */
    static void move(Form form, double[] row, double x, double y, double z) {
        int points = form == Form.TRIANGLE ? 9 : 3;
        for (int k = 0; k < points; k += 3) {
            row[k] += x;
            row[k + 1] += y;
            row[k + 2] += z;
        }
    }

    /** Its lengths times a power of two; rounded where that is subnormal. */
    static void scale(Form form, double[] row, int power) {
        int lengths = form == Form.TRIANGLE ? 9 : 6;
        for (int k = 0; k < lengths; k++) {
            row[k] = Math.scalb(row[k], power);
        }
    }

    /** A radius that holds it, roughly, about its middle. */
    static double reach(Form form, double[] row) {
        return switch (form) {
            case SPHERE -> row[3];
            case UPRIGHT_CYLINDER, CYLINDER -> Math.hypot(row[3], row[4]);
            case UPRIGHT_CAPSULE, CAPSULE -> row[3] + row[4];
            case UPRIGHT_BOX, BOX -> Math.sqrt(row[3] * row[3] + row[4] * row[4] + row[5] * row[5]);
            case TRIANGLE -> {
                double most = 0;
                for (int k = 0; k < 9; k += 3) {
                    double x = row[k] - middle(form, row, 0);
                    double y = row[k + 1] - middle(form, row, 1);
                    double z = row[k + 2] - middle(form, row, 2);
                    most = Math.max(most, Math.sqrt(x * x + y * y + z * z));
                }
                yield most;
            }
        };
    }

    /** A coordinate of its middle. */
    static double middle(Form form, double[] row, int axis) {
        return form == Form.TRIANGLE ? (row[axis] + row[3 + axis] + row[6 + axis]) / 3 : row[axis];
    }

    /** A point of the form, as near as rounding allows, of one of several sorts: a corner, on an edge, on a side, within. */
    static void point(Form form, SplittableRandom random, double[] row, double[] out) {
        if (form == Form.TRIANGLE) {
            int sort = random.nextInt(4);
            double s = sort == 0 ? random.nextInt(2) : sort == 1 ? 0.5 : random.nextInt(0, 9) / 8.0;
            double t = sort < 2 ? 0 : random.nextInt(0, 9) / 8.0 * (1 - s);
            int first = 3 * random.nextInt(3);
            for (int k = 0; k < 3; k++) {
                double p = row[(first + k) % 9];
                out[k] = p + s * (row[(first + 3 + k) % 9] - p) + t * (row[(first + 6 + k) % 9] - p);
            }
            return;
        }
        double[] share = new double[3];
        for (int k = 0; k < 3; k++) {
            share[k] = random.nextInt(3) == 0 ? random.nextInt(-4, 5) / 4.0 : random.nextBoolean() ? 1 : -1;
        }
        if (form == Form.SPHERE) {
            double n = Math.max(1e-300, Math.hypot(Math.hypot(share[0], share[1]), share[2]));
            for (int k = 0; k < 3; k++) {
                out[k] = row[k] + row[3] * share[k] / n;
            }
            return;
        }
        if (form.isCapsule()) {
            onCapsule(form, row, share, out);
            return;
        }
        double x = row[3] * share[0];
        double y = row[4] * share[1];
        double z = row[form == Form.UPRIGHT_BOX || form == Form.BOX ? 5 : 3] * share[2];
        if (form == Form.UPRIGHT_CYLINDER || form == Form.CYLINDER) {
            double n = Math.max(1, Math.hypot(share[0], share[2]));
            x /= n;
            z /= n;
        }
        for (int k = 0; k < 3; k++) {
            out[k] = hasAxes(form)
                    ? row[k] + x * row[6 + 3 * k] + y * row[7 + 3 * k] + z * row[8 + 3 * k]
                    : row[k] + (k == 0 ? x : k == 1 ? y : z);
        }
    }

    /** At an end or beside the middle of the segment, as far off as the radius, or less. */
    private static void onCapsule(Form form, double[] row, double[] share, double[] out) {
        double n = Math.max(1, Math.hypot(Math.hypot(share[0], share[1]), share[2]));
        double along = row[4] * share[1];
        for (int k = 0; k < 3; k++) {
            double axis = axis(form, row, k);
            double off = form == Form.CAPSULE
                    ? share[0] * row[6 + 3 * k] + share[1] * axis + share[2] * row[8 + 3 * k]
                    : share[k];
            out[k] = row[k] + along * axis + row[3] * off / n;
        }
    }

    /** A coordinate of a capsule's own Y. */
    static double axis(Form form, double[] row, int k) {
        return form == Form.CAPSULE ? row[7 + 3 * k] : k == 1 ? 1 : 0;
    }

    /** Whether it has any attitude. */
    static boolean isTurned(Form form) {
        return form == Form.BOX || form == Form.CYLINDER || form == Form.CAPSULE;
    }

    /** Whether its row holds a rotation that counts. */
    static boolean hasAxes(Form form) {
        return isTurned(form) || form == Form.UPRIGHT_BOX;
    }

    /** About how far a form other than a triangle reaches along one of its axes. */
    static double size(Form form, double[] row, int axis) {
        return !form.isCapsule() ? row[3 + axis] : axis == 1 ? row[3] + row[4] : row[3];
    }

    static double between(SplittableRandom random, double size) {
        return (2 * random.nextDouble() - 1) * size;
    }

    /** 10^-3 to 10^-16, either way. */
    static double tiny(SplittableRandom random) {
        double size = StrictMath.pow(10, -random.nextInt(3, 17));
        return random.nextBoolean() ? size : -size;
    }

    /** A number some steps away among the doubles. */
    static double step(double value, int steps) {
        double at = value;
        for (int k = 0; k < Math.abs(steps); k++) {
            at = steps > 0 ? Math.nextUp(at) : Math.nextDown(at);
        }
        return at;
    }
}
