package robosim.geometry.stress;

import robosim.geometry.reference.Truth.Form;

/** Changes of a question that round nothing and leave its answer as it was, or lead it one way only. */
final class Changes {
    private Changes() {}

    /** All a quarter turn about the vertical: x' = z, z' = -x. */
    static void quarterTurn(Case c) {
        for (double[] row : new double[][] {c.a, c.b}) {
            Form form = row == c.a ? c.formA : c.formB;
            for (int k = 0; k < (form == Form.TRIANGLE ? 9 : 3); k += 3) {
                turn(row, k, k + 2);
            }
            if (form != Form.TRIANGLE) {
                for (int k = 6; k < 9; k++) {
                    turn(row, k, k + 6);
                }
            }
        }
        turn(c.ray, 0, 2);
        turn(c.ray, 3, 5);
    }

    private static void turn(double[] row, int x, int z) {
        double was = row[x];
        row[x] = row[z];
        row[z] = 0 - was;
    }

    /** All as a mirror shows it: x' = -x; an own axis is turned about, so that attitudes stay right-handed. */
    static void mirror(Case c) {
        for (double[] row : new double[][] {c.a, c.b}) {
            Form form = row == c.a ? c.formA : c.formB;
            if (form == Form.TRIANGLE) {
                negate(row, 0, 3, 6);
            } else {
                negate(row, 0, 7, 8, 9, 12);
            }
        }
        negate(c.ray, 0, 3);
    }

    private static void negate(double[] row, int... at) {
        for (int k : at) {
            row[k] = 0 - row[k];
        }
    }

    /** All lengths times a power of two. */
    static void scale(Case c, int power) {
        Mutations.scale(c, power);
        for (int k = 0; k < 3; k++) {
            c.ray[k] = Math.scalb(c.ray[k], power);
        }
    }

    /** Other orders of the corners of triangles. */
    static void permute(Case c) {
        if (c.formA == Form.TRIANGLE) {
            swapCorners(c.a, 0, 3);
        }
        if (c.formB == Form.TRIANGLE) {
            swapCorners(c.b, 0, 6);
            swapCorners(c.b, 3, 6);
        }
    }

    private static void swapCorners(double[] row, int p, int q) {
        for (int k = 0; k < 3; k++) {
            double was = row[p + k];
            row[p + k] = row[q + k];
            row[q + k] = was;
        }
    }

    /** Sizes grow by an ulp each; false where there are none. */
    static boolean grow(Case c) {
        boolean any = false;
        for (double[] row : new double[][] {c.a, c.b}) {
            Form form = row == c.a ? c.formA : c.formB;
            if (form == Form.TRIANGLE) {
                continue;
            }
            any = true;
            for (int k = 3; k < 6; k++) {
                row[k] = Math.nextUp(row[k]);
            }
        }
        return any;
    }

    /** Keeps one half of the triangle b, cut at the middle of a side; false where that would be rounded. */
    static boolean halve(Case c, boolean second) {
        for (int k = 0; k < 3; k++) {
            double sum = c.b[k] + c.b[3 + k];
            boolean isWhole = Math.rint(c.b[k]) == c.b[k] && Math.rint(c.b[3 + k]) == c.b[3 + k];
            if (!isWhole || Math.abs(sum) > 0x1p40) {
                return false;
            }
            c.b[second ? k : 3 + k] = sum / 2;
        }
        return true;
    }
}
