package robosim.geometry.census;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.PivotTurn;
import robosim.geometry.narrow.sweep.PlanarSweep;
import robosim.geometry.reference.PlanarTwin;
import robosim.geometry.reference.Truth;
import robosim.geometry.reference.Truth.Form;
import robosim.geometry.reference.Twofold;

/** A turn of one projection about a vertical, against another: no later than circles cut sides, and as close as claimed. */
final class PlanarSpin implements Kernel {
    private static final double CLOSE = PlanarMeeting.CLOSE;
    private static final String GRAZED = "grazed, or met where a side ends";
    private static final String ALONG = "in contact at the start: along";
    private static final String FREE = "free all round";
    private static final int LOOKS = 12;
    /** What starts nearer than this share of the size may count as in contact: it gets no deeper than that. */
    private static final double AS_CONTACT = 0x1p-44;

    private static final double PLAIN = 0x1p-10;

    private final String name;
    private final Form[] first;
    private final Form[] second;
    private final PlanarPlaces places;
    private final Scratch scratch = new Scratch();
    private double px;
    private double pz;
    private double degrees;
    private double share;

    PlanarSpin(String name, Form[] first, Form[] second) {
        this.name = "turn of " + name + ", PLANAR";
        this.first = first;
        this.second = second;
        places = new PlanarPlaces(first, second);
    }

    @Override
    public String name() {
        return name;
    }

    @Override
    public double effort() {
        return first[0] != Form.SPHERE ? 1.5 : second[0] != Form.SPHERE ? 1.4 : 1.1;
    }

    @Override
    public List<String> regimes() {
        List<String> all = new ArrayList<>();
        if (second[0] == Form.SPHERE) {
            all.add("met");
        } else if (first[0] == Form.SPHERE) {
            all.addAll(List.of("met at a corner", "met at a side"));
        } else {
            all.addAll(List.of("met, its corner on a side", "met, its side on a corner"));
        }
        all.addAll(List.of(GRAZED, PlanarWay.CLOSELY, PlanarWay.JUST, PlanarWay.END, PlanarWay.SHORT, FREE));
        all.addAll(List.of(PlanarWay.NEAR, ALONG));
        for (String start : List.of(PlanarWay.TOUCHING, PlanarWay.INSIDE)) {
            all.addAll(List.of(start + "into", start + "away"));
        }
        return all;
    }

    @Override
    public Visit ask(SplittableRandom random, boolean adversarial) {
        draw(random, adversarial);
        share = PlanarSweep.turn(
                new Leaf(PlanarCases.kind(places.formA), places.a, 0),
                new PivotTurn().about(px, 17, pz).by(0, 1, 0, degrees),
                new Leaf(PlanarCases.kind(places.formB), places.b, 0),
                scratch.sweep);
        return compare(PlanarTwin.of(places.formA, places.a), PlanarTwin.of(places.formB, places.b));
    }

    private void draw(SplittableRandom random, boolean adversarial) {
        degrees = (random.nextBoolean() ? 1 : -1) * random.nextDouble(5, random.nextInt(4) == 0 ? 800 : 200);
        int state =
                adversarial ? random.nextInt(second[0] == Form.SPHERE ? 37 : first[0] == Form.SPHERE ? 38 : 32) : 40;
        if (adversarial ? state < 3 : random.nextInt(5) == 0) {
            exact(random);
            return;
        }
        places.draw(random, adversarial);
        double small = random.nextInt(12) == 0 ? 0 : StrictMath.pow(10, -random.nextDouble(11.5, 17));
        double sign = random.nextBoolean() ? 1 : -1;
        boolean isEnd = state >= 14 && state < 23;
        boolean isPast = adversarial && (state >= 32 || (state >= 23 && state < 29));
        double gap = !adversarial
                ? random.nextDouble(-0.4, 0.4)
                : state < 8 ? -small : state < 9 ? -0.05 : isEnd ? 0 : state < 14 ? small : sign * small;
        places.touch(random, adversarial, !isEnd && state > 6, gap);
        if (state >= 29 && state < 32) {
            places.cornerOnCorner(random, sign * small);
        }
        px = random.nextInt(4) == 0 ? places.a[0] : random.nextDouble(-2, 2);
        pz = random.nextInt(4) == 0 ? places.a[2] : random.nextDouble(-2, 2);
        if (isPast || (state >= 6 && state < 9)) { // the way at the contact is square to the normal
            double far = random.nextDouble(-2, 2);
            px = places.point[0] + far * places.normal[0];
            pz = places.point[1] + far * places.normal[1];
        }
        double at = !adversarial ? random.nextDouble(-0.5, 2) : state < 14 ? 0 : random.nextDouble(0.05, 0.95);
        if (isEnd) {
            at = 1 + sign * small;
            degrees = Math.signum(degrees) * Math.min(Math.abs(degrees), 15);
            into();
        }
        PlanarCases.turn(places.formA, places.a, px, pz, at * Math.toRadians(degrees));
    }

    // In contact at the start without any rounding.
    private void exact(SplittableRandom random) {
        places.touchOnGrid(random, 0);
        double far = random.nextInt(3) == 0 ? 0 : 0.25 * random.nextInt(-8, 9);
        double deep = 0.25 * random.nextInt(-8, 9);
        px = places.point[0] + deep * places.normal[0] - far * places.normal[1];
        pz = places.point[1] + deep * places.normal[1] + far * places.normal[0];
        degrees = 15 * random.nextInt(1, 25) * (random.nextBoolean() ? 1 : -1);
    }

    // So that the contact is come to, not left.
    private void into() {
        double x = places.point[0] - px;
        double z = places.point[1] - pz;
        double along = z * places.normal[0] - x * places.normal[1]; // of a turn from z towards x
        degrees = along > 0 ? Math.abs(degrees) : -Math.abs(degrees);
    }

    private double radians() {
        return Math.toRadians(Math.abs(degrees));
    }

    private PlanarTwin at(PlanarTwin one, double part) {
        double angle = -Math.toRadians(degrees) * part;
        return one.turned(px, pz, StrictMath.cos(angle), StrictMath.sin(angle));
    }

    private Visit compare(PlanarTwin one, PlanarTwin two) {
        Form formA = places.formA;
        Form formB = places.formB;
        double size = one.size() + two.size() + Math.abs(px) + Math.abs(pz);
        double bound = 0x1p-30 * reach(one) + 0x1p-43 * size;
        if (PlanarTwin.exactly(number -> Truth.planar(number, formA, places.a, formB, places.b))) {
            return contact(one, two, size, bound);
        }
        PlanarArcs arcs =
                PlanarArcs.of(formA == Form.SPHERE, one, formB == Form.SPHERE, two, px, pz, degrees > 0 ? -1 : 1);
        double start = one.partedRoughly(two);
        boolean isNear = start < CLOSE * size;
        double truth = arcs.angle;
        String regime = isNear ? PlanarWay.NEAR : regime(arcs, size);
        double told = Math.min(share, 1) * radians();
        double late = Math.max(0, told - truth) / (0x1p-50 * (1 + radians()));
        if (share > 1) {
            late = truth < radians() * (1 - 0x1p-50) ? 2 : 0;
        }
        if (late > 1 && start < AS_CONTACT * size) {
            late = Math.max(0, -least(one, two, Math.min(1, share))) / (AS_CONTACT * size);
        }
        if (share > 1) {
            return Visit.number(regime, 0, late, 0, this::told);
        }
        double left = Math.max(0, at(one, share).partedRoughly(two) - 0x1p-48 * size);
        double tooLate = late;
        return Visit.number(
                regime, left / bound, tooLate, 0, () -> told() + ", contact after " + truth + ", gap " + left);
    }

    private String regime(PlanarArcs arcs, double size) {
        double angle = radians();
        double near = CLOSE * size;
        if (arcs.angle <= angle) {
            boolean isEnd = arcs.feature.equals("corner on corner") || arcs.feature.equals("where a side ends");
            return arcs.angle > angle - near
                    ? PlanarWay.END
                    : arcs.isGrazed || isEnd
                            ? GRAZED
                            : arcs.feature.isEmpty() || second[0] == Form.SPHERE
                                    ? "met"
                                    : (first[0] == Form.SPHERE ? "met " : "met, ") + arcs.feature;
        }
        if (arcs.nearly <= angle) {
            return PlanarWay.CLOSELY;
        }
        return arcs.angle - angle < near ? PlanarWay.JUST : arcs.angle > 2 * Math.PI ? FREE : PlanarWay.SHORT;
    }

    private double reach(PlanarTwin one) {
        double reach = 0;
        for (int k = 0; k < one.x.length; k++) {
            reach = Math.max(reach, Math.hypot(one.x[k].head() - px, one.z[k].head() - pz));
        }
        return reach + one.radius.head();
    }

    // No deeper than at the start anywhere before the end, and there as deep, or in contact again.
    private Visit contact(PlanarTwin one, PlanarTwin two, double size, double bound) {
        double start = one.partedRoughly(two);
        double end = Math.min(1, share);
        double least = Math.min(start, least(one, two, end));
        double left = at(one, end).partedRoughly(two);
        int out = out(one, two, size);
        boolean isOut = out <= 0 || share > 0;
        double rounding = AS_CONTACT * size;
        double late = (start - least) / rounding;
        double early = share > 1 ? 0 : Math.max(0, Math.min(left - start, Math.abs(left)) - rounding) / bound;
        String contact = start < -CLOSE * size ? PlanarWay.INSIDE : PlanarWay.TOUCHING;
        String regime = out == 0 ? ALONG : contact + (out < 0 ? "into" : "away");
        return Visit.number(regime, isOut ? early : 2, late, 0, () -> told() + ", depth " + -start + " then " + -left);
    }

    private double least(PlanarTwin one, PlanarTwin two, double end) {
        double least = Double.POSITIVE_INFINITY;
        for (int k = 1; k <= LOOKS && end > 0; k++) {
            least = Math.min(least, at(one, end * k / LOOKS).partedRoughly(two));
        }
        return least;
    }

    // Positive where the turn leads out, negative where in, 0 where that is not plain.
    private int out(PlanarTwin one, PlanarTwin two, double size) {
        int sign = 2;
        Twofold start = one.parted(two);
        for (double by : new double[] {0x1p-20, 0x1p-40, 0x1p-60}) {
            double change = at(one, by / radians()).parted(two).minus(start).head() / by;
            int here = change > PLAIN * size ? 1 : change < -PLAIN * size ? -1 : 0;
            sign = sign == 2 || sign == here ? here : 0;
        }
        return sign;
    }

    private String told() {
        return places.paste() + " about " + PlanarCases.paste(px, pz) + " by " + degrees + " (got: " + share + ")";
    }
}
