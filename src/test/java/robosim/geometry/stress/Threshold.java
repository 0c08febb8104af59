package robosim.geometry.stress;

import java.util.SplittableRandom;
import java.util.function.DoublePredicate;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.reference.Truth.Form;

/**
 * The last place among the doubles at which the product says yes, by bisection, and the places next to it, one ulp apart:
 * where it would be wrong if anywhere.
 */
final class Threshold {
    private static final int CASES = 24;

    private final Family family;
    private final SplittableRandom random;
    private final Scratch scratch;
    private final Case base = new Case();
    private final double[] way = new double[3];
    private double share;
    private int left;

    Threshold(Family family, SplittableRandom random, Scratch scratch) {
        this.family = family;
        this.random = random;
        this.scratch = scratch;
    }

    boolean isGoing() {
        return left > 0;
    }

    /** From now on b moves in some direction from where its middle is on a's, at a random scale. */
    void begin(Case c) {
        base.copyFrom(c);
        Form a = base.formA;
        Form b = base.formB;
        Forms.move(
                b,
                base.b,
                Forms.middle(a, base.a, 0) - Forms.middle(b, base.b, 0),
                Forms.middle(a, base.a, 1) - Forms.middle(b, base.b, 1),
                Forms.middle(a, base.a, 2) - Forms.middle(b, base.b, 2));
        boolean along = random.nextInt(3) == 0;
        int only = random.nextInt(3);
        double far = 4 * (Forms.reach(a, base.a) + Forms.reach(b, base.b));
        for (int k = 0; k < 3; k++) {
            way[k] = along && k != only ? 0 : far * Forms.between(random, 1);
        }
        int scale = random.nextInt(8);
        int power = scale == 0 ? 40 : scale == 1 ? -40 : scale == 2 ? -300 : 0;
        Mutations.scale(base, power);
        for (int k = 0; k < 3; k++) {
            way[k] = Math.scalb(way[k], power);
        }
        share = Threshold.lastYes(t -> {
            at(c, t);
            return family.product(c, scratch) > 0;
        });
        left = CASES;
    }

    /** The greatest share from 0 to 1 that halving finds to be a yes, next to a no. */
    static double lastYes(DoublePredicate isYes) {
        double yes = 0;
        double no = 1;
        for (int k = 0; k < 60 && Math.nextUp(yes) < no; k++) {
            double middle = yes + (no - yes) / 2;
            if (isYes.test(middle)) {
                yes = middle;
            } else {
                no = middle;
            }
        }
        return yes;
    }

    private void at(Case c, double t) {
        c.copyFrom(base);
        Forms.move(base.formB, c.b, t * way[0], t * way[1], t * way[2]);
    }

    void next(Case c) {
        left--;
        int steps = random.nextInt(-3, 4);
        at(c, Math.max(0, Forms.step(share, steps)));
        if (random.nextInt(2) == 0) {
            int coordinate = random.nextInt(base.formB == Form.TRIANGLE ? 9 : 3);
            c.b[coordinate] = Forms.step(c.b[coordinate], random.nextInt(-2, 3));
        }
        if (random.nextInt(4) == 0) {
            Mutations.swap(c);
        }
    }
}
