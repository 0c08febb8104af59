package robosim.geometry.stress;

import java.util.SplittableRandom;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.reference.Truth.Form;

/** Rays at forms: in general position, and those that graze, pass through corners and along edges, or nearly. */
final class Rays implements Family.Source {
    private static final int THRESHOLD_CASES = 24;

    private final Family family;
    private final boolean planar;
    private final Form[] forms;
    private final double spread;
    private final SplittableRandom random;
    private final Scratch scratch = new Scratch();
    private final double[] p = new double[3];
    private final double[] q = new double[3];

    // A bisection between a hit and a miss, and what is left of the cases about it.
    private final Case base = new Case();
    private final double[] way = new double[3];
    private double share;
    private int left;

    /**
     * @param spread how far from the middle the random ones aim, in reaches, for a mix of hits and misses
     */
    Rays(Family family, boolean planar, Form[] forms, double spread, SplittableRandom random) {
        this.family = family;
        this.planar = planar;
        this.forms = forms;
        this.spread = spread;
        this.random = random;
    }

    @Override
    public void random(Case c) {
        c.formB = forms[random.nextInt(forms.length)];
        Forms.random(c.formB, random, c.b);
        if (Mixed.isDue(random)) {
            Mixed.aimable(c.formB, random, c.b);
            start(c);
            Mixed.about(c.formB, random, c.b, p);
            towards(c, p);
            return;
        }
        Forms.move(c.formB, c.b, Forms.between(random, 2), Forms.between(random, 2), Forms.between(random, 2));
        double reach = Forms.reach(c.formB, c.b);
        aim(c, reach * (random.nextInt(10) == 0 ? random.nextDouble() : 1 + 4 * random.nextDouble()), reach * spread);
    }

    /** Starts the ray from about as far away as the form was wide, or from much farther. */
    private void start(Case c) {
        double away = random.nextBoolean() ? 3 : Mixed.far(random);
        for (int k = 0; k < 3; k++) {
            c.ray[k] = Forms.between(random, away);
        }
    }

    /** From a point so far away to one so near the middle. */
    private void aim(Case c, double away, double aside) {
        double x = Forms.between(random, 1);
        double y = planar ? 0 : Forms.between(random, 1);
        double z = Forms.between(random, 1);
        double n = away / Math.sqrt(x * x + y * y + z * z);
        for (int k = 0; k < 3; k++) {
            double middle = Forms.middle(c.formB, c.b, k);
            c.ray[k] = middle + n * (k == 0 ? x : k == 1 ? y : z);
            p[k] = middle + Forms.between(random, aside);
        }
        towards(c, p);
    }

    private static void towards(Case c, double[] point) {
        for (int k = 0; k < 3; k++) {
            c.ray[3 + k] = point[k] - c.ray[k];
        }
    }

    @Override
    public void adversarial(Case c) {
        if (left > 0) {
            nextAtThreshold(c);
            return;
        }
        c.formB = forms[random.nextInt(forms.length)];
        switch (random.nextInt(14)) {
            case 0 -> {
                beginThreshold(c);
                nextAtThreshold(c);
                return;
            }
            case 1, 2, 3 -> {
                Forms.grid(c.formB, random, c.b);
                flatten(c);
                atPoint(c);
            }
            case 4, 5 -> {
                Forms.grid(c.formB, random, c.b);
                flatten(c);
                along(c);
            }
            case 6, 7 -> tangent(c);
            case 8 -> {
                Forms.grid(c.formB, random, c.b);
                flatten(c);
                parallelToAxis(c);
            }
            case 9 -> {
                Forms.random(c.formB, random, c.b);
                flatten(c);
                along(c);
                c.ray[3 + random.nextInt(3)] += Forms.tiny(random);
            }
            case 10, 11 -> {
                Forms.random(c.formB, random, c.b);
                Mixed.sizes(c.formB, random, c.b);
                if (random.nextBoolean()) {
                    Forms.move(
                            c.formB, c.b, Forms.between(random, 2), Forms.between(random, 2), Forms.between(random, 2));
                }
                start(c);
                if (random.nextBoolean()) {
                    Forms.point(c.formB, random, c.b, p);
                    towards(c, p);
                } else {
                    along(c);
                }
            }
            default -> {
                Forms.random(c.formB, random, c.b);
                flatten(c);
                atPoint(c);
                c.ray[3 + random.nextInt(3)] += random.nextBoolean() ? 0 : Forms.tiny(random);
            }
        }
        place(c);
    }

    private void flatten(Case c) {
        if (random.nextInt(5) == 0) {
            Mutations.flatten(c.formB, c.b, random);
        }
    }

    private void gridStart(Case c, int size) {
        for (int k = 0; k < 3; k++) {
            c.ray[k] = random.nextInt(-size, size + 1);
        }
    }

    /** From a whole point to a corner, a point of an edge or of a side; or away from it. */
    private void atPoint(Case c) {
        gridStart(c, 8);
        Forms.point(c.formB, random, c.b, p);
        if (random.nextInt(12) == 0) {
            System.arraycopy(p, 0, c.ray, 0, 3); // starts on it
            gridStart(c, 3);
        }
        towards(c, p);
        if (random.nextInt(6) == 0) {
            for (int k = 3; k < 6; k++) {
                c.ray[k] = -c.ray[k];
            }
        }
    }

    /** Through two points of it, of which each may be a corner: along an edge, in a side, or across. */
    private void along(Case c) {
        Forms.point(c.formB, random, c.b, p);
        Forms.point(c.formB, random, c.b, q);
        int back = random.nextInt(-2, 5);
        double aside = random.nextInt(4) == 0 ? Forms.tiny(random) : 0;
        for (int k = 0; k < 3; k++) {
            c.ray[3 + k] = q[k] - p[k];
            c.ray[k] = p[k] - back * c.ray[3 + k] + aside;
        }
    }

    private void parallelToAxis(Case c) {
        gridStart(c, 6);
        int axis = random.nextInt(3);
        for (int k = 0; k < 3; k++) {
            c.ray[3 + k] = random.nextBoolean() ? 0.0 : -0.0;
        }
        c.ray[3 + axis] = random.nextBoolean() ? 1 : -3;
        if (random.nextBoolean()) {
            Forms.point(c.formB, random, c.b, p);
            for (int k = 0; k < 3; k++) {
                if (k != axis) {
                    c.ray[k] = p[k];
                }
            }
        }
    }

    /** A round thing as far from the line as its radius, to the last bit; of others, one with a corner on the line. */
    private void tangent(Case c) {
        Forms.grid(c.formB, random, c.b);
        gridStart(c, 4);
        int[] step = Forms.pythagorean(random, true);
        int times = random.nextInt(0, 4);
        int ahead = random.nextInt(-2, 6);
        boolean level = planar || random.nextBoolean();
        c.ray[3] = step[0];
        c.ray[4] = level ? 0 : random.nextInt(-3, 4);
        c.ray[5] = step[2];
        boolean sphere = c.formB == Form.SPHERE;
        c.b[0] = c.ray[0] + ahead * c.ray[3] - times * step[2];
        c.b[1] = c.ray[1] + (sphere && !level ? ahead * c.ray[4] : random.nextInt(-2, 3));
        c.b[2] = c.ray[2] + ahead * c.ray[5] + times * step[0];
        if (sphere && level && !planar) {
            c.b[1] = c.ray[1];
        }
        if (c.formB != Form.TRIANGLE) {
            c.b[3] = times * step[3];
        }
        if (!sphere && c.formB != Form.TRIANGLE) {
            c.b[4] = random.nextInt(0, 12);
        }
        if (random.nextInt(3) == 0 && !planar) {
            turnAxes(c);
        }
    }

    /** Gives a sphere and its ray other axes. */
    private void turnAxes(Case c) {
        if (c.formB != Form.SPHERE) {
            return;
        }
        for (double[] row : new double[][] {c.ray, c.b}) {
            double x = row[0];
            row[0] = row[1];
            row[1] = row[2];
            row[2] = x;
        }
        double x = c.ray[3];
        c.ray[3] = c.ray[4];
        c.ray[4] = c.ray[5];
        c.ray[5] = x;
    }

    private void place(Case c) {
        if (random.nextInt(3) == 0) {
            int at = random.nextInt(6);
            c.ray[at] = Forms.step(c.ray[at], random.nextInt(-2, 3));
        }
        switch (random.nextInt(12)) {
            case 0 -> scale(c, 40);
            case 1 -> scale(c, -40);
            case 2 -> scale(c, -300);
            case 3 -> scale(c, -random.nextInt(1030, 1074));
            case 4 -> move(c, 1e6);
            case 5 -> move(c, 1e9);
            case 6 -> speed(c, random.nextInt(-90, 90));
            default -> {}
        }
        if (isStill(c)) {
            c.ray[3] = 1;
        }
    }

    private boolean isStill(Case c) {
        return c.ray[3] == 0 && c.ray[5] == 0 && (planar || c.ray[4] == 0);
    }

    private static void scale(Case c, int power) {
        Forms.scale(c.formB, c.b, power);
        for (int k = 0; k < 6; k++) {
            c.ray[k] = Math.scalb(c.ray[k], power);
        }
    }

    private static void speed(Case c, int power) {
        for (int k = 3; k < 6; k++) {
            c.ray[k] = Math.scalb(c.ray[k], power);
        }
    }

    private void move(Case c, double far) {
        double[] by = {far * random.nextInt(-1, 2), far * random.nextInt(-1, 2), far};
        Forms.move(c.formB, c.b, by[0], by[1], by[2]);
        for (int k = 0; k < 3; k++) {
            c.ray[k] += by[k];
        }
    }

    private void beginThreshold(Case c) {
        Forms.random(c.formB, random, c.b);
        if (random.nextInt(3) == 0) {
            Mixed.sizes(c.formB, random, c.b);
        }
        flatten(c);
        double reach = Forms.reach(c.formB, c.b);
        aim(c, reach * (1.5 + random.nextInt(3) * random.nextDouble() * 1000), 0);
        if (isStill(c)) {
            c.ray[5] = 1;
        }
        base.copyFrom(c);
        for (int k = 0; k < 3; k++) {
            way[k] = 3 * Forms.between(random, reach);
        }
        share = Threshold.lastYes(t -> {
            at(c, t);
            return family.product(c, scratch) > 0;
        });
        left = THRESHOLD_CASES;
    }

    private void at(Case c, double t) {
        c.copyFrom(base);
        for (int k = 0; k < 3; k++) {
            c.ray[3 + k] += t * way[k];
        }
    }

    private void nextAtThreshold(Case c) {
        left--;
        at(c, Math.max(0, Forms.step(share, random.nextInt(-3, 4))));
        if (random.nextBoolean()) {
            int at = random.nextInt(6);
            c.ray[at] = Forms.step(c.ray[at], random.nextInt(-2, 3));
        }
        if (isStill(c)) {
            c.ray[3] = 1;
        }
    }
}
