package robosim.geometry.census;

import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.overlap.SpatialOverlap;

/**
 * A motion in space of a box, triangle, cylinder, sphere or capsule against another, of which the twin follows the distance by pairs
 * of features: nothing is met earlier than told, and where something is, the two are as close as the claim says.
 *
 * <p>Half of the cases are aimed: at a share of the way two features are put so that they meet there, or pass each other by
 * a gap or a depth of 10^-3 to 10^-12 of the size, head on or tangent.
 */
abstract class SpatialMotion implements Kernel {
    // Pairs of kinds, and for each the ways to aim, as often as it takes to meet every regime often enough.
    private static final LeafKind[][] PAIRS = {
        {LeafKind.BOX, LeafKind.BOX},
        {LeafKind.BOX, LeafKind.TRIANGLE},
        {LeafKind.TRIANGLE, LeafKind.BOX},
        {LeafKind.TRIANGLE, LeafKind.TRIANGLE},
        {LeafKind.BOX, LeafKind.TRIANGLE},
        {LeafKind.TRIANGLE, LeafKind.BOX},
        {LeafKind.BOX, LeafKind.BOX},
        {LeafKind.TRIANGLE, LeafKind.TRIANGLE},
        {LeafKind.CYLINDER, LeafKind.BOX},
        {LeafKind.BOX, LeafKind.CYLINDER},
        {LeafKind.CYLINDER, LeafKind.TRIANGLE},
        {LeafKind.TRIANGLE, LeafKind.CYLINDER},
        {LeafKind.CYLINDER, LeafKind.BOX},
        {LeafKind.BOX, LeafKind.CYLINDER},
        {LeafKind.CYLINDER, LeafKind.CYLINDER},
        {LeafKind.CYLINDER, LeafKind.CYLINDER},
        {LeafKind.CYLINDER, LeafKind.CYLINDER},
        {LeafKind.CYLINDER, LeafKind.TRIANGLE},
        {LeafKind.TRIANGLE, LeafKind.CYLINDER},
        {LeafKind.CYLINDER, LeafKind.BOX},
        {LeafKind.CYLINDER, LeafKind.CYLINDER},
        {LeafKind.CYLINDER, LeafKind.CYLINDER},
        {LeafKind.CYLINDER, LeafKind.CYLINDER},
        {LeafKind.SPHERE, LeafKind.SPHERE},
        {LeafKind.SPHERE, LeafKind.BOX},
        {LeafKind.TRIANGLE, LeafKind.BOX},
        {LeafKind.TRIANGLE, LeafKind.SPHERE},
        {LeafKind.SPHERE, LeafKind.CYLINDER},
        {LeafKind.CAPSULE, LeafKind.BOX},
        {LeafKind.TRIANGLE, LeafKind.CAPSULE},
        {LeafKind.CAPSULE, LeafKind.CYLINDER},
        {LeafKind.CAPSULE, LeafKind.CAPSULE},
        {LeafKind.SPHERE, LeafKind.CAPSULE}
    };

    private static final int[] FLAT = {0, 0, 0, 1, 1, 1, 2, 5};
    private static final int[] ROUND = {0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 2, 3, 4};
    private static final int[] BOTH_ROUND = {0, 1, 2, 2, 2, 2, 2, 2, 3, 4, 5};
    private static final String FREE = "free by more than 10^-3";
    private static final String CLOSE = "passes by 10^-3 to 10^-7";
    private static final String CLOSER = "passes by less than 10^-7";
    private static final String INTO = "starts in contact, into";
    private static final String AWAY = "starts in contact, away";

    /** The twin's own doubles: distances are off by no more of the sizes than this. */
    private static final double TWIN = 0x1p-48;

    /** The same where a search in one variable ends short of a sharp valley's floor. */
    private static final double SEARCHED = 0x1p-44;

    /** So far from contact, features that are nearest to each other are inside the other solid, or beyond it. */
    private static final double INSIDE = 0x1p-38;

    private static final double GOLDEN = 0.6180339887498949;
    private static final int TRIES = 20;

    final Scratch scratch = new Scratch();
    private final SolidGap gap = new SolidGap();

    // One case: rows, with everything seen from the origin, and where the features were put.
    LeafKind kindA;
    LeafKind kindB;
    final double[] a = new double[Leaf.STRIDE];
    final double[] b = new double[Leaf.STRIDE];
    final double[] origin = new double[3];
    private Solid mover = Solid.of(LeafKind.SPHERE, a, origin);
    private Solid rest = mover;
    double[] normal = new double[3];
    double[] point = new double[3];

    @Override
    public double effort() {
        return 1.2;
    }

    @Override
    public List<String> regimes() {
        return List.of(
                "CORNER_ON_SIDE",
                "SIDE_ON_CORNER",
                "EDGES",
                "RIM_ON_SIDE",
                "RIM_ON_EDGE",
                "RIM_ON_ROUND",
                "MANTLE_ON_EDGE",
                "MANTLES",
                "SPHERE",
                "CAPSULE",
                FREE,
                CLOSE,
                CLOSER,
                INTO,
                AWAY);
    }

    /** Draws the motion, once it is known what is to meet, so that the mover comes from before the contact if it can. */
    abstract void draw(SplittableRandom random, boolean aimed, double contact);

    /** The turn and the shift of the mover at a share of the motion. */
    abstract double[] turn(double share);

    abstract double[] shift(double share);

    /** How fast a point of the mover may move, for each unit of the share. */
    abstract double speed(double reach);

    /** The product's answer. */
    abstract double free();

    /** Up to which share of the time that is told nothing can be met: 1 where there is always a gap left. */
    abstract double before();

    /** The widest gap that is claimed to be left. */
    abstract double bound(double reach, double sizes);

    abstract String paste();

    @Override
    public Visit ask(SplittableRandom random, boolean adversarial) {
        double contact = 0;
        int start = adversarial ? random.nextInt(9) : 2;
        for (int t = 0; ; t++) {
            LeafKind[] kinds = PAIRS[random.nextInt(PAIRS.length)];
            kindA = kinds[0];
            kindB = kinds[1];
            shape(kindA, a, random, adversarial && start > 1);
            shape(kindB, b, random, adversarial && start > 1);
            if (kindA == LeafKind.CYLINDER && kindB == LeafKind.CYLINDER && random.nextInt(4) > 0) {
                // Rods, whose mantles meet.
                a[3] *= 0.1;
                b[3] *= 0.1;
                a[4] = random.nextDouble(0.3, 1);
                b[4] = random.nextDouble(0.3, 1);
            }
            contact = start <= 1 ? 0 : random.nextDouble(0.05, 0.95);
            place(random, adversarial, start <= 1, contact, start == 0);
            if (start <= 1
                    || t == TRIES
                    || !SpatialOverlap.test(new Leaf(kindA, a, 0), new Leaf(kindB, b, 0), scratch.overlap)) {
                break;
            }
        }
        double share = free();
        if (start <= 1) {
            return fromContact(share, start == 0);
        }
        mover = Solid.of(kindA, a, origin);
        rest = Solid.of(kindB, b, origin);
        double reach = mover.reach();
        double sizes = reach + rest.reach();
        if (SpatialOverlap.test(new Leaf(kindA, a, 0), new Leaf(kindB, b, 0), scratch.overlap)) {
            return Visit.right(FREE); // no such luck in any of the tries; a handful
        }
        double end = Math.min(1, share);
        double least = least(share > 1 ? 1 : end * before(), reach);
        // Where a time is told to rounding, what is met at the last moment is met there.
        boolean met = !(least > TWIN * sizes) && (share > 1 || before() == 1 || at(end) > INSIDE * sizes);
        double late = met || (share <= 1 && recedes(end * before(), reach, sizes)) ? 2 : 0;
        if (share > 1) {
            String regime = least > 1e-3 * reach ? FREE : least > 1e-7 * reach ? CLOSE : CLOSER;
            return Visit.number(regime, 0, late, 0, this::told);
        }
        double left = at(end);
        String regime = gap.meeting.name();
        return Visit.number(regime, left / bound(reach, sizes), late, 0, () -> told() + ", gap " + left);
    }

    private Visit fromContact(double share, boolean into) {
        if (into) {
            return share < 1e-9 ? Visit.right(INTO) : Visit.wrong(INTO, told());
        }
        return share > 0 ? Visit.right(AWAY) : Visit.wrong(AWAY, told());
    }

    private String told() {
        return "kind %s %s, kind %s %s from %s, %s: %s"
                .formatted(
                        kindA, Arrays.toString(a), kindB, Arrays.toString(b), Arrays.toString(origin), paste(), free());
    }

    /** Whether the two are farther apart at the end than shortly before: something has been gone through. */
    private boolean recedes(double end, double reach, double sizes) {
        double here = at(end);
        double before = end - here / speed(reach);
        return here > 0 && before > 0 && at(before) < here - SEARCHED * sizes;
    }

    private double at(double share) {
        return gap.between(mover.placed(turn(share), shift(share)), rest);
    }

    /** The least distance up to a share: no step is so long that contact fits in, but where it is looked for at once. */
    private double least(double end, double reach) {
        double fast = speed(reach);
        double longest = end / 48;
        double before = Double.POSITIVE_INFINITY;
        double here = at(0);
        double least = here;
        double t = 0;
        double last = 0;
        while (t < end) {
            double step = Math.max(0.9 * here / fast, longest);
            double next = Math.min(end, t + step);
            double then = at(next);
            if (here <= before && here <= then && here - fast * Math.max(t - last, next - t) < 1e-3 * reach) {
                least = Math.min(least, search(last, next));
            }
            least = Math.min(least, then);
            before = here;
            here = then;
            last = t;
            t = next;
        }
        return least;
    }

    private double search(double from, double until) {
        double low = from;
        double high = until;
        double s = high - GOLDEN * (high - low);
        double t = low + GOLDEN * (high - low);
        double atS = at(s);
        double atT = at(t);
        double best = Math.min(atS, atT);
        for (int k = 0; k < 40 && best > 0; k++) {
            if (atS <= atT) {
                high = t;
                t = s;
                atT = atS;
                s = high - GOLDEN * (high - low);
                atS = at(s);
            } else {
                low = s;
                s = t;
                atS = atT;
                t = low + GOLDEN * (high - low);
                atT = at(t);
            }
            best = Math.min(best, Math.min(atS, atT));
        }
        return best;
    }

    private static void shape(LeafKind kind, double[] row, SplittableRandom random, boolean adversarial) {
        Arrays.fill(row, 0);
        double[] turn = Vec.turn(Vec.direction(random), random.nextDouble(-180, 180));
        for (int k = 0; k < 3; k++) {
            double low = adversarial ? -3 : -1;
            row[3 + k] = adversarial && random.nextInt(24) == 0 ? 0 : StrictMath.pow(10, random.nextDouble(low, 0));
        }
        if (kind == LeafKind.TRIANGLE) {
            double[] sizes = {row[3], row[4], row[5]};
            for (int m = 0; m < 9; m++) {
                row[m] = sizes[m / 3] * random.nextDouble(-1, 1);
            }
            if (adversarial && random.nextInt(24) == 0) {
                System.arraycopy(row, 0, row, 6, 3); // a segment
            }
        } else if (kind == LeafKind.SPHERE) {
            row[4] = 0;
            row[5] = 0;
        } else {
            System.arraycopy(turn, 0, row, Leaf.ROTATION, 9);
        }
    }

    /** Puts both rows where features meet at a share; both come as drawn, at the origin. */
    private void place(SplittableRandom random, boolean aimed, boolean touching, double contact, boolean into) {
        Arrays.fill(origin, 0);
        move(kindA, a, Vec.plus(new double[3], random.nextDouble(0, 1.5), Vec.direction(random)));
        Solid first = Solid.of(kindA, a, origin);
        Solid second = Solid.of(kindB, b, origin);
        normal = Vec.direction(random);
        // What starts in contact has one way out: where a side, or something round, is met.
        int[] ways = first.isPolytope() && second.isPolytope()
                ? FLAT
                : first.isPolytope() || second.isPolytope() ? ROUND : BOTH_ROUND;
        switch (touching ? random.nextInt(2) : ways[random.nextInt(ways.length)]) {
            case 0 -> normal = second.normal(random);
            case 1 -> normal = first.normal(random);
            case 2 -> normal = Vec.unit(Vec.cross(first.edge(random), second.edge(random)));
            case 3 -> normal = Vec.unit(Vec.cross(first.edge(random), normal));
            case 4 -> normal = Vec.unit(Vec.cross(second.edge(random), normal));
            default -> {}
        }
        double[] against = Vec.plus(new double[3], -1, normal);
        point = first.furthest(against, random);
        double size = first.reach() + second.reach();
        double apart = touching
                ? 0
                : aimed
                        ? (random.nextInt(3) == 0 ? -1 : 1) * size * StrictMath.pow(10, random.nextDouble(-12, -3))
                        : size * random.nextDouble(-0.4, 0);
        double[] q = second.furthest(normal, random);
        move(kindB, b, Vec.plus(Vec.plus(point, -1, q), -apart, normal));
        draw(random, aimed, into || !touching ? contact : -1);
        double[] back = turn(-contact);
        double[] shift = shift(-contact);
        Solid unturned = Solid.of(kindA, a, origin);
        if (kindA == LeafKind.TRIANGLE) {
            for (int m = 0; m < 3; m++) {
                System.arraycopy(Vec.plus(Vec.times(back, unturned.corners[m]), 1, shift), 0, a, 3 * m, 3);
            }
        } else {
            System.arraycopy(Vec.plus(Vec.times(back, unturned.centre), 1, shift), 0, a, 0, 3);
            for (int k = 0; k < 3 && kindA != LeafKind.SPHERE; k++) {
                double[] column = Vec.times(back, new double[] {a[6 + k], a[9 + k], a[12 + k]});
                for (int m = 0; m < 3; m++) {
                    a[6 + 3 * m + k] = column[m];
                }
            }
        }
        if (aimed && !touching && random.nextInt(8) == 0) {
            double[] far = Vec.plus(new double[3], 1e3, Vec.direction(random));
            move(kindA, a, far);
            move(kindB, b, far);
            System.arraycopy(far, 0, origin, 0, 3);
        }
    }

    private static void move(LeafKind kind, double[] row, double[] by) {
        for (int m = 0; m < (kind == LeafKind.TRIANGLE ? 9 : 3); m++) {
            row[m] += by[m % 3];
        }
    }
}
