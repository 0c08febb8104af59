package robosim.geometry.census;

import java.util.List;
import java.util.SplittableRandom;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.sweep.PlanarSweep;
import robosim.geometry.reference.PlanarTwin;
import robosim.geometry.reference.Truth.Form;
import robosim.geometry.reference.Twofold;

/**
 * A straight translation in the plane with a tipped cylinder or capsule: all places up to the time told are one shape, which lines part
 * from the other for certain, and at that time the gap is as small as is claimed.
 */
final class PlanarOvalWay implements Kernel {
    private static final double CLOSE = PlanarMeeting.CLOSE;
    private static final String BETWEEN = "overlapping at the start: about along a way out, or between two";

    // How far to move to see whether two get deeper, as shares of the size: beyond ties to rounding, and at once.
    private static final double FAR = 0x1p-20;
    private static final double AT_ONCE = 0x1p-50;
    private static final double ALONG = 0x1p-12;

    private final String name;
    private final PlanarPlaces places;
    private final Scratch scratch = new Scratch();
    private double dx;
    private double dz;
    private double time;

    PlanarOvalWay(String name, Form[] first, Form[] second) {
        this.name = name;
        places = new PlanarPlaces(first, second);
    }

    @Override
    public String name() {
        return "translation of " + name + ", PLANAR";
    }

    @Override
    public double effort() {
        return 1.3;
    }

    @Override
    public List<String> regimes() {
        return List.of(
                "met",
                PlanarWay.GRAZED,
                PlanarWay.END,
                PlanarWay.CLOSELY,
                PlanarWay.PASSED,
                PlanarWay.JUST,
                PlanarWay.SHORT,
                PlanarWay.TOUCHING + "into",
                PlanarWay.TOUCHING + "along",
                PlanarWay.TOUCHING + "away",
                PlanarWay.INSIDE + "into",
                PlanarWay.INSIDE + "away",
                BETWEEN);
    }

    @Override
    public Visit ask(SplittableRandom random, boolean adversarial) {
        double[] way;
        if (adversarial && random.nextInt(9) == 0) {
            places.touchOnGrid(random, 0.125);
            way = places.gridWay(random, 0);
        } else {
            way = PlanarWay.draw(places, random, adversarial, 6);
        }
        dx = way[0];
        dz = way[1];
        time = PlanarSweep.translation(
                new Leaf(PlanarCases.kind(places.formA), places.a, 0),
                dx,
                17,
                dz,
                new Leaf(PlanarCases.kind(places.formB), places.b, 0),
                scratch.sweep);
        PlanarTwin one = PlanarTwin.of(places.formA, places.a);
        PlanarTwin two = PlanarTwin.of(places.formB, places.b);
        double size = one.size() + two.size();
        double bound = 0x1p-42 * (size + Math.hypot(dx, dz));
        double start = one.parted(two).head();
        if (!(time >= 0)) {
            return Visit.wrong("met", told());
        }
        if (start > CLOSE * size) {
            double most = one.swept(dx, dz, 1).parted(two).head();
            return way(one, two, most, bound, 0, regime(one, two, most, size));
        }
        int out = out(one, two, start, size);
        String ending = out < 0 ? "into" : out > 0 ? "away" : "along";
        if (start < -CLOSE * size) {
            return contact(out == 0 ? BETWEEN : PlanarWay.INSIDE + ending, out);
        }
        // What is as close as the bound counts as in contact, or does not.
        if (start <= 0 || (out > 0 && start < bound)) {
            return contact(PlanarWay.TOUCHING + ending, out);
        }
        double most = one.swept(dx, dz, 1).parted(two).head();
        return way(one, two, most, bound, start < bound ? bound : 0, PlanarWay.TOUCHING + ending);
    }

    private Visit contact(String regime, int out) {
        boolean isRight = time == 0 ? out <= 0 : time == Double.POSITIVE_INFINITY && out >= 0;
        return isRight ? Visit.right(regime) : Visit.wrong(regime, told());
    }

    // Positive where the motion leads out, negative where in, 0 where that is not plain.
    private int out(PlanarTwin one, PlanarTwin two, double start, double size) {
        int sign = 2;
        for (double by : new double[] {FAR, AT_ONCE}) {
            double share = by * size / Math.hypot(dx, dz);
            Twofold then = one.moved(dx, dz, share).parted(two);
            double change = then.minus(one.parted(two)).head() / (by * size);
            int here = change > ALONG ? 1 : change < -ALONG ? -1 : 0;
            sign = sign == 2 || sign == here ? here : 0;
        }
        return sign;
    }

    private Visit way(PlanarTwin one, PlanarTwin two, double most, double bound, double slack, String regime) {
        double rounding = 0x1p-85 * (one.size() + two.size()) + slack;
        if (time > 1) {
            return Visit.number(regime, 0, most < -rounding ? 2 : 0, 0, this::told);
        }
        double before = one.swept(dx, dz, time).parted(two).head();
        double left = one.moved(dx, dz, time).parted(two).head();
        return Visit.number(
                regime, Math.max(0, left) / bound, before < -rounding ? 2 : 0, 0, () -> told() + ", gap " + left);
    }

    private String regime(PlanarTwin one, PlanarTwin two, double most, double size) {
        double aside = PlanarWay.aside(one, two, dx, dz);
        if (Math.abs(aside) <= CLOSE * size) {
            return most <= 0 ? PlanarWay.GRAZED : PlanarWay.CLOSELY;
        }
        if (aside > 0) {
            return PlanarWay.PASSED;
        }
        double end = one.moved(dx, dz, 1).parted(two).head();
        if (most <= 0) {
            boolean isEnd = end > -CLOSE * size
                    && one.swept(dx, dz, 1 - CLOSE).parted(two).head() > -CLOSE * size;
            return isEnd ? PlanarWay.END : "met";
        }
        return end < CLOSE * size ? PlanarWay.JUST : PlanarWay.SHORT;
    }

    private String told() {
        return places.paste() + " by " + PlanarCases.paste(dx, dz) + " (got: " + time + ")";
    }
}
