package robosim.geometry.stress;

import java.util.SplittableRandom;
import robosim.geometry.reference.Truth.Form;

/** What makes a pair of forms awkward. */
final class Mutations {
    private Mutations() {}

    /** Makes some lengths longer or shorter by up to 10^8. */
    static void elongate(Case c, SplittableRandom random) {
        for (double[] row : new double[][] {c.a, c.b}) {
            Form form = row == c.a ? c.formA : c.formB;
            if (random.nextInt(3) != 0) {
                continue;
            }
            double factor = StrictMath.pow(10, random.nextInt(-8, 9));
            int from = form == Form.TRIANGLE ? random.nextInt(9) : 3 + random.nextInt(3);
            row[from] *= factor;
            if (form == Form.TRIANGLE && random.nextBoolean()) {
                row[(from + 3) % 9] *= factor;
            }
        }
    }

    /** Sometimes takes away a dimension: a size of zero, corners doubled or in line. */
    static void flatten(Case c, SplittableRandom random) {
        if (random.nextInt(4) == 0) {
            flatten(c.formA, c.a, random);
        }
        if (random.nextInt(4) == 0) {
            flatten(c.formB, c.b, random);
        }
    }

    static void flatten(Form form, double[] row, SplittableRandom random) {
        if (form != Form.TRIANGLE) {
            row[3 + random.nextInt(3)] = switch (random.nextInt(6)) {
                case 0 -> Double.MIN_VALUE;
                case 1 -> minute(random);
                default -> 0;
            };
            return;
        }
        int corner = 3 * random.nextInt(3);
        int other = (corner + 3) % 9;
        int third = (corner + 6) % 9;
        int sort = random.nextInt(5);
        double share = random.nextInt(0, 9) / 8.0;
        if (sort == 4) {
            shrink(row, corner, other, third, random);
            return;
        }
        for (int k = 0; k < 3; k++) {
            switch (sort) {
                case 0 -> row[corner + k] = row[other + k];
                case 1 -> row[corner + k] = row[other + k] + share * (row[third + k] - row[other + k]);
                case 2 -> row[corner + k] = row[other + k] + 1e-9 * (row[third + k] - row[other + k]);
                default -> {
                    row[corner + k] = row[other + k];
                    row[third + k] = random.nextInt(8) == 0 ? row[third + k] : row[other + k];
                }
            }
        }
    }

    /** Makes a side so short that its square underflows, at a place where that is not lost. */
    private static void shrink(double[] row, int corner, int other, int third, SplittableRandom random) {
        int axis = random.nextInt(3);
        boolean both = random.nextBoolean();
        for (int k = 0; k < 3; k++) {
            row[corner + k] = row[other + k];
            if (both) {
                row[third + k] = row[other + k];
            }
        }
        row[other + axis] = random.nextBoolean() ? 0 : -minute(random);
        row[corner + axis] = minute(random);
        if (both) {
            row[third + axis] = -minute(random);
        }
    }

    private static double minute(SplittableRandom random) {
        return Math.scalb(1 + random.nextDouble(), -random.nextInt(100, 1074));
    }

    /** Steps a number by an ulp or two, and moves or scales the pair. */
    static void place(Case c, SplittableRandom random) {
        int nudges = random.nextInt(3) == 0 ? random.nextInt(1, 3) : 0;
        for (int k = 0; k < nudges; k++) {
            boolean first = random.nextBoolean();
            double[] row = first ? c.a : c.b;
            Form form = first ? c.formA : c.formB;
            int at = random.nextInt(form == Form.TRIANGLE ? 9 : form == Form.SPHERE ? 4 : 6);
            double stepped = Forms.step(row[at], random.nextInt(-2, 3));
            row[at] = form != Form.TRIANGLE && at >= 3 ? Math.max(0, stepped) : stepped;
        }
        switch (random.nextInt(14)) {
            case 0 -> scale(c, 40);
            case 1 -> scale(c, -40);
            case 2 -> scale(c, -300);
            case 3 -> scale(c, -random.nextInt(1030, 1074));
            case 4 -> move(c, 1e6, random);
            case 5 -> move(c, 1e9, random);
            case 6 -> negateZeros(c);
            case 7 -> scale(c, 60);
            case 8 -> swap(c);
            default -> {}
        }
    }

    static void scale(Case c, int power) {
        Forms.scale(c.formA, c.a, power);
        Forms.scale(c.formB, c.b, power);
        for (int k = 3; k < 6; k++) {
            c.ray[k] = Math.scalb(c.ray[k], power);
        }
    }

    private static void move(Case c, double far, SplittableRandom random) {
        double x = far * random.nextInt(-1, 2);
        double y = far * random.nextInt(-1, 2);
        double z = far * (1 + random.nextInt(2));
        Forms.move(c.formA, c.a, x, y, z);
        Forms.move(c.formB, c.b, x, y, z);
    }

    private static void negateZeros(Case c) {
        for (double[] row : new double[][] {c.a, c.b}) {
            for (int k = 0; k < 15; k++) {
                row[k] = row[k] == 0 ? -0.0 : row[k];
            }
        }
    }

    /** The other way round. */
    static void swap(Case c) {
        Form form = c.formA;
        c.formA = c.formB;
        c.formB = form;
        double[] copy = c.a.clone();
        System.arraycopy(c.b, 0, c.a, 0, Case.ROW);
        System.arraycopy(copy, 0, c.b, 0, Case.ROW);
    }

    /** Makes another corner of b one of a's, if a has corners, or puts it beside the first. */
    static void share(Case c, SplittableRandom random) {
        if (c.formA != Form.TRIANGLE || random.nextBoolean()) {
            return;
        }
        int from = 3 * random.nextInt(3);
        double share = random.nextInt(0, 3) / 2.0;
        for (int k = 0; k < 3; k++) {
            double p = c.a[from + k];
            c.b[3 + k] = p + share * (c.a[(from + 3) % 9 + k] - p);
        }
    }

    /** Puts b's corners into a's plane or just off it. */
    static void coplanar(Case c, SplittableRandom random, double gap) {
        boolean grid = random.nextBoolean();
        if (grid) {
            Forms.grid(Form.TRIANGLE, random, c.a);
        }
        for (int corner = 0; corner < 9; corner += 3) {
            double s = grid ? random.nextInt(-4, 9) / 4.0 : Forms.between(random, 1.5);
            double t = grid ? random.nextInt(-4, 9) / 4.0 : Forms.between(random, 1.5);
            for (int k = 0; k < 3; k++) {
                double p = c.a[k];
                c.b[corner + k] = p + s * (c.a[3 + k] - p) + t * (c.a[6 + k] - p) + (k == corner / 3 ? gap : 0);
            }
        }
    }

    /** Lays a triangle on a side of a form with axes, or just off it. */
    static void lay(Form form, double[] row, double[] triangle, SplittableRandom random, double gap) {
        int axis = random.nextInt(3);
        double side = random.nextBoolean() ? 1 : -1;
        int corners = random.nextInt(1, 4); // how many lie on it; the others stand off
        for (int corner = 0; corner < 3; corner++) {
            double off = corner < corners ? gap : gap + random.nextDouble();
            double[] share = {Forms.between(random, 1.6), Forms.between(random, 1.6), Forms.between(random, 1.6)};
            share[axis] = side;
            for (int k = 0; k < 3; k++) {
                double value = row[k];
                for (int j = 0; j < 3; j++) {
                    double size = form == Form.SPHERE ? row[3] : Forms.size(form, row, j);
                    double way = share[j] * size + (j == axis ? side * off : 0);
                    value += way * (Forms.hasAxes(form) ? row[6 + 3 * k + j] : j == k ? 1 : 0);
                }
                triangle[3 * corner + k] = value;
            }
        }
    }

    /** Round things that touch to the last bit, at whole numbers. */
    static void tangent(Case c, SplittableRandom random, boolean planar) {
        Forms.grid(c.formA, random, c.a);
        Forms.grid(c.formB, random, c.b);
        int[] step = Forms.pythagorean(random, planar || random.nextBoolean());
        double[] p = new double[3];
        if (c.formA == Form.TRIANGLE) {
            System.arraycopy(c.a, 3 * random.nextInt(3), p, 0, 3);
        } else {
            for (int k = 0; k < 3; k++) {
                p[k] = c.a[k];
            }
        }
        boolean bothRound = isRound(c.formA) && isRound(c.formB);
        double first = bothRound ? random.nextInt(0, step[3] + 1) : 0;
        if (bothRound) {
            c.a[3] = first;
        }
        if (!isRound(c.formB)) {
            return;
        }
        c.b[3] = step[3] - first;
        if (c.formA == Form.UPRIGHT_BOX || c.formA == Form.BOX) {
            for (int k = 0; k < 3; k++) {
                double reach = step[k] == 0 ? 0 : Math.signum(step[k]);
                for (int j = 0; j < 3; j++) {
                    p[k] += Math.abs(c.a[6 + 3 * k + j]) * c.a[3 + j] * reach;
                }
            }
        }
        double end = random.nextInt(-1, 2);
        double otherEnd = random.nextInt(-1, 2);
        for (int k = 0; k < 3; k++) {
            c.b[k] = p[k] + step[k];
            c.b[k] += c.formA.isCapsule() ? end * c.a[4] * Forms.axis(c.formA, c.a, k) : 0;
            c.b[k] -= c.formB.isCapsule() ? otherEnd * c.b[4] * Forms.axis(c.formB, c.b, k) : 0;
        }
    }

    private static boolean isRound(Form form) {
        return form == Form.SPHERE || form == Form.UPRIGHT_CYLINDER || form == Form.CYLINDER || form.isCapsule();
    }
}
