package robosim.geometry.census;

import java.util.SplittableRandom;
import robosim.geometry.reference.PlanarTwin;
import robosim.geometry.reference.Truth.Form;

/** Two forms in the plane, put so that they touch, or nearly, before the first is moved back to where it starts. */
final class PlanarPlaces {
    private final Form[] first;
    private final Form[] second;
    Form formA = Form.SPHERE;
    Form formB = Form.SPHERE;
    double[] a = new double[0];
    double[] b = new double[0];

    /** From the first to the second, where they touch. */
    double[] normal = {1, 0};

    /** A point of the first there. */
    double[] point = {0, 0};

    PlanarPlaces(Form[] first, Form[] second) {
        this.first = first;
        this.second = second;
    }

    /** Draws the forms; either of the two kinds is the mover. */
    void draw(SplittableRandom random, boolean adversarial) {
        forms(random);
        a = PlanarCases.row(formA, random, adversarial);
        b = PlanarCases.row(formB, random, adversarial);
    }

    private void forms(SplittableRandom random) {
        boolean swap = random.nextBoolean();
        formA = (swap ? second : first)[random.nextInt((swap ? second : first).length)];
        formB = (swap ? first : second)[random.nextInt((swap ? first : second).length)];
    }

    /** Puts the second beside the first, with a gap or, below 0, a depth; if wanted, now and then not at its foremost point. */
    void touch(SplittableRandom random, boolean adversarial, boolean shifted, double gap) {
        PlanarTwin one = PlanarTwin.of(formA, a);
        PlanarTwin two = PlanarTwin.of(formB, b);
        boolean ofFirst = random.nextBoolean();
        double[] n = PlanarCases.direction(ofFirst ? one : two, random, adversarial);
        if (!ofFirst) {
            n = new double[] {-n[0], -n[1]};
        }
        double[] p = one.foremost(n[0], n[1]);
        double[] q = two.foremost(-n[0], -n[1]);
        PlanarTwin sided = ofFirst ? one : two;
        double aside = shifted && sided.x.length > 1 && random.nextInt(3) == 0 ? random.nextDouble(-0.4, 0.4) : 0;
        PlanarCases.move(formB, b, p[0] - q[0] + gap * n[0] - aside * n[1], p[1] - q[1] + gap * n[1] + aside * n[0]);
        normal = n;
        point = p;
    }

    /** Both on quarters, with sides along the axes where they have any: what touches does so exactly. */
    void onGrid(SplittableRandom random) {
        forms(random);
        a = gridRow(formA, random);
        b = gridRow(formB, random);
        normal = new double[] {1, 0};
        point = new double[] {a[0], a[2]};
    }

    /** The same, touching exactly where one is foremost along an axis, or deeper by so much. */
    void touchOnGrid(SplittableRandom random, double depth) {
        onGrid(random);
        double[][] axes = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
        normal = axes[random.nextInt(4)];
        PlanarTwin one = PlanarTwin.of(formA, a);
        PlanarTwin two = PlanarTwin.of(formB, b);
        double[] p = one.foremost(normal[0], normal[1]);
        double[] q = two.foremost(-normal[0], -normal[1]);
        PlanarCases.move(formB, b, p[0] - q[0] - depth * normal[0], p[1] - q[1] - depth * normal[1]);
        boolean isSided = one.x.length > 1 && two.x.length > 1;
        if (isSided && depth == 0 && random.nextBoolean()) {
            double aside = quarter(random, -1, 2);
            PlanarCases.move(formB, b, -aside * normal[1], aside * normal[0]);
        }
        point = p;
    }

    /** On quarters: against the normal where the sign is below 0, along it above, else square to it. */
    double[] gridWay(SplittableRandom random, int sign) {
        double along = sign * quarter(random, 1, 8);
        double across = sign == 0 ? (random.nextBoolean() ? 1 : -1) * quarter(random, 1, 8) : quarter(random, -4, 5);
        return new double[] {along * normal[0] - across * normal[1], along * normal[1] + across * normal[0]};
    }

    private static double[] gridRow(Form form, SplittableRandom random) {
        double[] row = PlanarCases.row(form, random, false);
        for (int k = 0; k < (form == Form.TRIANGLE ? 9 : 3); k++) {
            row[k] = quarter(random, -8, 9);
        }
        if (form == Form.TRIANGLE) {
            if (random.nextInt(4) > 0) { // with two sides along the axes
                row[5] = row[2];
                row[6] = row[0];
            }
            return row;
        }
        for (int k = 3; k < 6; k++) {
            row[k] = quarter(random, random.nextInt(8) == 0 ? 0 : 1, 5);
        }
        int turn = form == Form.UPRIGHT_BOX ? 1 : random.nextInt(3);
        boolean quarter = random.nextBoolean();
        for (int k = 0; k < 9; k++) {
            row[6 + k] = 0;
        }
        for (int k = 0; k < 3; k++) {
            row[6 + 3 * k + (k + turn + 2) % 3] = 1; // a cycle of the axes
        }
        if (form == Form.UPRIGHT_BOX && quarter) {
            row[6] = 0;
            row[14] = 0;
            row[8] = 1;
            row[12] = -1;
        }
        return row;
    }

    private static double quarter(SplittableRandom random, int from, int until) {
        return 0.25 * random.nextInt(from, until);
    }

    /** A corner or centre of each this far, and their radii, from one of the other. */
    void cornerOnCorner(SplittableRandom random, double gap) {
        PlanarTwin one = PlanarTwin.of(formA, a);
        PlanarTwin two = PlanarTwin.of(formB, b);
        int k = random.nextInt(one.x.length);
        int m = random.nextInt(two.x.length);
        double rOne = one.radius.head();
        double rTwo = two.radius.head();
        PlanarCases.move(
                formB,
                b,
                one.x[k].head() - two.x[m].head() + (rOne + rTwo + gap) * normal[0],
                one.z[k].head() - two.z[m].head() + (rOne + rTwo + gap) * normal[1]);
    }

    String paste() {
        return PlanarCases.paste(formA, a) + " and " + PlanarCases.paste(formB, b);
    }
}
