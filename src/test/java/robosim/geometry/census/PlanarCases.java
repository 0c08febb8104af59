package robosim.geometry.census;

import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.stream.Collectors;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.reference.PlanarTwin;
import robosim.geometry.reference.Truth.Form;

/** Rows of forms for kernels in the plane, and what a failure prints of them. */
final class PlanarCases {
    private PlanarCases() {}

    static LeafKind kind(Form form) {
        return LeafKind.valueOf(form.name());
    }

    /** Whether its projection is an oval. */
    static boolean isOval(Form form) {
        return form == Form.CYLINDER || form == Form.CAPSULE;
    }

    /** Of a size of about 1, now and then thin or small; adversarial ones oftener, and by more. */
    static double[] row(Form form, SplittableRandom random, boolean adversarial) {
        double[] row = new double[Leaf.STRIDE];
        for (int k = 0; k < (form == Form.TRIANGLE ? 9 : 3); k++) {
            row[k] = random.nextDouble(-1, 1);
        }
        if (form != Form.TRIANGLE) {
            for (int k = 3; k < 6; k++) {
                row[k] = random.nextDouble(0.2, 1) * share(random, adversarial);
            }
            turn(form, random, row);
        } else if (random.nextInt(4) == 0) {
            double thin = share(random, adversarial);
            for (int k = 0; k < 9; k += 3) {
                row[k] *= thin;
            }
        }
        return row;
    }

    private static double share(SplittableRandom random, boolean adversarial) {
        return random.nextInt(adversarial ? 3 : 8) != 0
                ? 1
                : StrictMath.pow(10, -random.nextDouble(adversarial ? 12 : 3));
    }

    private static void turn(Form form, SplittableRandom random, double[] row) {
        double yaw = random.nextDouble(-3.2, 3.2);
        double pitch = form == Form.UPRIGHT_BOX ? 0 : random.nextDouble(-3.2, 3.2);
        double roll = form == Form.UPRIGHT_BOX || random.nextInt(3) == 0 ? 0 : random.nextDouble(-3.2, 3.2);
        double[] m = {1, 0, 0, 0, 1, 0, 0, 0, 1};
        m = about(m, 0, 2, yaw);
        m = about(m, 1, 2, pitch);
        m = about(m, 0, 1, roll);
        System.arraycopy(m, 0, row, 6, 9);
        if (form == Form.UPRIGHT_BOX) {
            double c = StrictMath.cos(yaw);
            double s = StrictMath.sin(yaw);
            System.arraycopy(new double[] {c, 0, s, 0, 1, 0, -s, 0, c}, 0, row, 6, 9);
        }
    }

    // Times a turn in the plane of two of its columns.
    private static double[] about(double[] m, int first, int second, double angle) {
        double[] out = m.clone();
        double c = StrictMath.cos(angle);
        double s = StrictMath.sin(angle);
        for (int k = 0; k < 9; k += 3) {
            out[k + first] = c * m[k + first] - s * m[k + second];
            out[k + second] = s * m[k + first] + c * m[k + second];
        }
        return out;
    }

    static void move(Form form, double[] row, double x, double z) {
        for (int k = 0; k < (form == Form.TRIANGLE ? 9 : 3); k += 3) {
            row[k] += x;
            row[k + 2] += z;
        }
    }

    /** Turns a row about a point, from x towards z. */
    static void turn(Form form, double[] row, double px, double pz, double angle) {
        double c = StrictMath.cos(angle);
        double s = StrictMath.sin(angle);
        for (int k = 0; k < (form == Form.TRIANGLE ? 9 : 3); k += 3) {
            double x = row[k] - px;
            double z = row[k + 2] - pz;
            row[k] = px + (c * x - s * z);
            row[k + 2] = pz + (s * x + c * z);
        }
        if (form == Form.TRIANGLE || form == Form.SPHERE) {
            return;
        }
        for (int k = 6; k < 9; k++) {
            double x = row[k];
            row[k] = c * x - s * row[k + 6];
            row[k + 6] = s * x + c * row[k + 6];
        }
        if (form == Form.UPRIGHT_BOX) {
            row[12] = -row[8];
            row[14] = row[6];
        }
    }

    /** A direction: anywhere, or square to a side of the form, or nearly. */
    static double[] direction(PlanarTwin twin, SplittableRandom random, boolean adversarial) {
        int side = random.nextInt(twin.x.length);
        int next = (side + 1) % twin.x.length;
        double ex = twin.isOval ? twin.axisX.head() : twin.x[next].head() - twin.x[side].head();
        double ez = twin.isOval ? twin.axisZ.head() : twin.z[next].head() - twin.z[side].head();
        if (random.nextInt(adversarial ? 4 : 2) == 0 || (ex == 0 && ez == 0)) {
            double angle = random.nextDouble(-3.2, 3.2);
            return new double[] {StrictMath.cos(angle), StrictMath.sin(angle)};
        }
        double length = Math.hypot(ex, ez);
        return new double[] {ez / length, -ex / length};
    }

    static String paste(Form form, double[] row) {
        return form + " " + paste(row);
    }

    static String paste(double... numbers) {
        return Arrays.stream(numbers).mapToObj(Double::toString).collect(Collectors.joining(", ", "{", "}"));
    }
}
