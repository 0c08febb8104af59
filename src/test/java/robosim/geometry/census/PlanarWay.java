package robosim.geometry.census;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.jspecify.annotations.Nullable;
import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.overlap.PlanarOverlap;
import robosim.geometry.narrow.sweep.PlanarSweep;
import robosim.geometry.proof.Witnesses;
import robosim.geometry.reference.PlanarTwin;
import robosim.geometry.reference.StartTruth;
import robosim.geometry.reference.Truth;
import robosim.geometry.reference.Truth.Form;
import robosim.geometry.reference.Twofold;
import robosim.geometry.reference.WayTruth;

/**
 * A straight translation of one projection against another: whether it meets, and whether it goes deeper from contact, by exact
 * arithmetic; when, to rounding.
 */
final class PlanarWay implements Kernel {
    static final double CLOSE = PlanarMeeting.CLOSE;
    static final String GRAZED = "grazed";
    static final String CLOSELY = "passed closely";
    static final String PASSED = "passed";
    static final String END = "met at the very end";
    static final String JUST = "stops just short";
    static final String SHORT = "stops short, or goes away";
    static final String NEAR = "all but touching at the start";
    static final String TOUCHING = "touching at the start: ";
    static final String INSIDE = "overlapping at the start: ";

    private final String name;
    private final Form[] first;
    private final Form[] second;
    private final PlanarPlaces places;
    private final Scratch scratch = new Scratch();
    private double dx;
    private double dz;
    private double time;

    PlanarWay(String name, Form[] first, Form[] second) {
        this.name = "translation of " + name + ", PLANAR";
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
        return first[0] != Form.SPHERE ? 1.5 : second[0] != Form.SPHERE ? 1.6 : 1.2;
    }

    @Override
    public List<String> regimes() {
        List<String> all = new ArrayList<>();
        if (second[0] == Form.SPHERE) {
            all.add("met");
        } else if (first[0] == Form.SPHERE) {
            all.addAll(List.of("met at a corner", "met at a side", "met where a side ends"));
        } else {
            all.addAll(List.of(
                    "met, its corner on a side", "met, its side on a corner", "met, corner on corner or side on side"));
        }
        all.addAll(List.of(GRAZED, END, CLOSELY, PASSED, JUST, SHORT, NEAR));
        all.addAll(List.of(TOUCHING + "into", TOUCHING + "along", TOUCHING + "away"));
        all.addAll(List.of(INSIDE + "into", INSIDE + "away"));
        return all;
    }

    @Override
    public Visit ask(SplittableRandom random, boolean adversarial) {
        double[] way = draw(places, random, adversarial, first[0] == Form.SPHERE ? 3 : 0);
        dx = way[0];
        dz = way[1];
        time = PlanarSweep.translation(
                new Leaf(PlanarCases.kind(places.formA), places.a, 0),
                dx,
                17,
                dz,
                new Leaf(PlanarCases.kind(places.formB), places.b, 0),
                scratch.sweep);
        return compare(PlanarTwin.of(places.formA, places.a), PlanarTwin.of(places.formB, places.b));
    }

    /** Fills the places with a case, the mover where it starts, and answers the way; so many more of 32 pass closely. */
    static double[] draw(PlanarPlaces places, SplittableRandom random, boolean adversarial, int more) {
        return adversarial ? adversarial(places, random, more) : plain(places, random);
    }

    @Override
    public @Nullable String proof(Witnesses witnesses) {
        Leaf a = new Leaf(PlanarCases.kind(places.formA), places.a, 0);
        Leaf b = new Leaf(PlanarCases.kind(places.formB), places.b, 0);
        return PlanarOverlap.test(a, b, scratch.overlap)
                ? null
                : witnesses.translation(
                        Witnesses.object(PlanarCases.kind(places.formA), places.a),
                        new double[] {dx, 17, dz},
                        Witnesses.object(PlanarCases.kind(places.formB), places.b),
                        Dimension.PLANAR,
                        time);
    }

    private static double[] plain(PlanarPlaces places, SplittableRandom random) {
        if (random.nextInt(5) == 0) {
            return exact(places, random, 0);
        }
        places.draw(random, false);
        places.touch(random, false, true, random.nextDouble(-0.5, 0.4));
        double angle = random.nextDouble(-3.2, 3.2);
        return back(places, StrictMath.cos(angle), StrictMath.sin(angle), length(random), random.nextDouble(-0.5, 2));
    }

    private static double[] adversarial(PlanarPlaces places, SplittableRandom random, int more) {
        int state = random.nextInt(32 + more);
        if (state < 12) {
            return exact(places, random, state < 8 ? 0 : random.nextDouble() < 0.2 ? 1 : 0.5);
        }
        places.draw(random, true);
        double small = random.nextInt(12) == 0 ? 0 : StrictMath.pow(10, -random.nextDouble(11.5, 17));
        double sign = random.nextBoolean() ? 1 : -1;
        boolean isEnd = state < 20;
        boolean isNear = !isEnd && state < 24;
        places.touch(random, true, !isEnd, isEnd ? 0 : isNear ? small : sign * small);
        if (state >= 29 && state < 32) {
            places.cornerOnCorner(random, sign * small);
        }
        double[] n = places.normal;
        if (state >= 32 || (state >= 24 && state < 29)) { // past each other, now and then not quite along
            double off = random.nextInt(3) == 0 ? small : 0;
            return back(places, off * n[0] - sign * n[1], off * n[1] + sign * n[0], length(random), between(random));
        }
        double across = random.nextDouble(-2, 2);
        double length = length(random) / Math.hypot(1, across);
        double share = isEnd ? 1 + sign * small : isNear ? 0 : between(random);
        double into = isNear ? sign : 1;
        return back(places, into * n[0] - across * n[1], into * n[1] + across * n[0], length, share);
    }

    // In contact without any rounding, at the start or after a share of the way.
    private static double[] exact(PlanarPlaces places, SplittableRandom random, double share) {
        places.touchOnGrid(random, share == 0 && random.nextInt(12) == 0 ? 0.125 : 0);
        double[] way = places.gridWay(random, share == 0 ? random.nextInt(3) - 1 : random.nextInt(6) == 0 ? 0 : 1);
        PlanarCases.move(places.formA, places.a, -share * way[0], -share * way[1]);
        return way;
    }

    private static double length(SplittableRandom random) {
        return StrictMath.pow(10, random.nextDouble(-1, 1));
    }

    private static double between(SplittableRandom random) {
        return random.nextDouble(0.05, 0.95);
    }

    private static double[] back(PlanarPlaces places, double ux, double uz, double length, double share) {
        PlanarCases.move(places.formA, places.a, -share * length * ux, -share * length * uz);
        return new double[] {length * ux, length * uz};
    }

    private Visit compare(PlanarTwin one, PlanarTwin two) {
        Form formA = places.formA;
        Form formB = places.formB;
        double[] a = places.a;
        double[] b = places.b;
        double size = one.size() + two.size();
        if (PlanarTwin.exactly(number -> Truth.planar(number, formA, a, formB, b))) {
            int out = StartTruth.out(formA, a, dx, dz, formB, b);
            boolean deep = one.partedRoughly(two) < -CLOSE * size;
            String regime = (deep ? INSIDE : TOUCHING) + (out < 0 ? "into" : out > 0 || deep ? "away" : "along");
            boolean isRight = time == (out < 0 ? 0 : Double.POSITIVE_INFINITY);
            return isRight ? Visit.right(regime) : Visit.wrong(regime, told());
        }
        boolean meets = PlanarTwin.exactly(number -> WayTruth.planar(number, formA, a, dx, dz, formB, b));
        PlanarMeeting meeting = PlanarMeeting.of(formA == Form.SPHERE, one, formB == Form.SPHERE, two, dx, dz);
        double aside = aside(one, two, dx, dz);
        String regime = regime(meeting, meets, one, two, aside, size);
        if (meets != time <= 1 || time < 0) {
            return Visit.wrong(regime, told());
        }
        return meets ? met(meeting, regime) : Visit.right(regime);
    }

    // Rounded down, and to nothing but the next double; where the rays are not that sure, exactly.
    private Visit met(PlanarMeeting meeting, String regime) {
        Twofold rest = meeting.time.minus(Twofold.of(time));
        double step = Math.nextUp(time) - time;
        double sure = step * 0x1p-20;
        if (meeting.error <= sure && rest.head() >= 0 && rest.head() <= step) {
            return Visit.number(regime, rest.head() / step, 0, 0, this::told);
        }
        Form formA = places.formA;
        Form formB = places.formB;
        double less = time * 0x1p-200;
        boolean late = PlanarTwin.exactly(
                number -> WayTruth.planarBy(number, formA, places.a, dx, dz, time, less, formB, places.b));
        double next = Math.nextUp(time);
        boolean early = !PlanarTwin.exactly(
                number -> WayTruth.planarBy(number, formA, places.a, dx, dz, next, 0, formB, places.b));
        return Visit.number(regime, early ? 2 : 0, late ? 2 : 0, 0, this::told);
    }

    /** How far beside each other the two pass if the way goes on for ever, below 0 where they do not; in plain doubles. */
    static double aside(PlanarTwin one, PlanarTwin two, double dx, double dz) {
        double length = Math.hypot(dx, dz);
        double aside = Double.NEGATIVE_INFINITY;
        for (int side = -1; side <= 1; side += 2) {
            double nx = -side * dz / length;
            double nz = side * dx / length;
            double[] p = one.foremost(nx, nz);
            double[] q = two.foremost(-nx, -nz);
            aside = Math.max(aside, nx * (q[0] - p[0]) + nz * (q[1] - p[1]));
        }
        return aside;
    }

    private String regime(
            PlanarMeeting meeting, boolean meets, PlanarTwin one, PlanarTwin two, double aside, double size) {
        double length = Math.hypot(dx, dz);
        double left = (meeting.time.head() - 1) * length;
        if (meets) {
            if (aside > -CLOSE * size) {
                return GRAZED;
            }
            if (meeting.time.head() * length < CLOSE * size) {
                return NEAR;
            }
            return left > -CLOSE * size
                    ? END
                    : meeting.feature.isEmpty()
                            ? "met"
                            : (first[0] == Form.SPHERE ? "met " : "met, ") + meeting.feature;
        }
        if (Math.abs(aside) <= CLOSE * size) {
            return one.partedRoughly(two) < CLOSE * size ? NEAR : CLOSELY;
        }
        if (aside > 0) {
            return one.partedRoughly(two) < CLOSE * size ? NEAR : PASSED;
        }
        if (left < Double.POSITIVE_INFINITY) {
            return left < CLOSE * size ? JUST : SHORT;
        }
        return one.partedRoughly(two) < CLOSE * size ? NEAR : SHORT;
    }

    private String told() {
        return places.paste() + " by " + PlanarCases.paste(dx, dz) + " (got: " + time + ")";
    }
}
