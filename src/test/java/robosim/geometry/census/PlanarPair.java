package robosim.geometry.census;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.jspecify.annotations.Nullable;
import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.distance.PlanarDistance;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.overlap.PlanarOverlap;
import robosim.geometry.proof.Witnesses;
import robosim.geometry.reference.PlanarTwin;
import robosim.geometry.reference.Truth;
import robosim.geometry.reference.Truth.Form;
import robosim.geometry.reference.Twofold;

/** Whether two projections touch, and how far apart they are. */
final class PlanarPair implements Kernel {
    private static final double CLOSE = 0x1p-40;

    private final String name;
    private final Form[] first;
    private final Form[] second;
    private final Scratch scratch = new Scratch();
    private double[] a = {};
    private double[] b = {};
    private boolean touch;
    private final DistanceProbe probe = new DistanceProbe();
    private final LeafColumn columnA = new LeafColumn(1);
    private final LeafColumn columnB = new LeafColumn(1);
    private Form formA = Form.SPHERE;
    private Form formB = Form.SPHERE;

    PlanarPair(String name, Form[] first, Form[] second) {
        this.name = "overlap and distance of " + name + ", PLANAR";
        this.first = first;
        this.second = second;
    }

    @Override
    public String name() {
        return name;
    }

    private boolean hasOval() {
        return PlanarCases.isOval(first[0]);
    }

    private boolean hasSides() {
        return !hasOval() && second[0] != Form.SPHERE;
    }

    @Override
    public double effort() {
        return hasOval() || second[0] == Form.SPHERE ? 0.5 : hasSides() && first[0] != Form.SPHERE ? 1 : 0.75;
    }

    @Override
    public List<String> regimes() {
        List<String> all = new ArrayList<>();
        for (String feature : hasSides() ? new String[] {", a corner", ", a side"} : new String[] {""}) {
            all.add("apart" + feature);
        }
        all.add("all but touching");
        all.add("overlapping");
        all.add("all but apart");
        return all;
    }

    @Override
    public Visit ask(SplittableRandom random, boolean adversarial) {
        formA = first[random.nextInt(first.length)];
        formB = second[random.nextInt(second.length)];
        a = PlanarCases.row(formA, random, adversarial);
        b = PlanarCases.row(formB, random, adversarial);
        PlanarTwin one = PlanarTwin.of(formA, a);
        PlanarTwin two = PlanarTwin.of(formB, b);
        PlanarTwin of = random.nextBoolean() ? one : two;
        double[] n = PlanarCases.direction(of, random, adversarial);
        double[] p = one.foremost(n[0], n[1]);
        double[] q = two.foremost(-n[0], -n[1]);
        double gap = gap(random, adversarial);
        PlanarCases.move(formB, b, p[0] - q[0] + gap * n[0], p[1] - q[1] + gap * n[1]);
        boolean hasSide = hasSides() && of.x.length > 1;
        if (hasSide && random.nextInt(3) != 0) { // along the line between the two, past a side
            double aside = random.nextDouble(-0.4, 0.4);
            PlanarCases.move(formB, b, -aside * n[1], aside * n[0]);
        }
        two = PlanarTwin.of(formB, b);
        return compare(one, two);
    }

    private static double gap(SplittableRandom random, boolean adversarial) {
        if (!adversarial) {
            return random.nextDouble(-0.5, 1);
        }
        double size = StrictMath.pow(10, -random.nextDouble(4, 17));
        return random.nextInt(12) == 0 ? 0 : random.nextBoolean() ? size : -size;
    }

    @Override
    public @Nullable String proof(Witnesses witnesses) {
        return witnesses.overlap(
                Witnesses.object(PlanarCases.kind(formA), a),
                Witnesses.object(PlanarCases.kind(formB), b),
                Dimension.PLANAR,
                touch,
                !hasOval());
    }

    private Visit compare(PlanarTwin one, PlanarTwin two) {
        LeafKind kindA = PlanarCases.kind(formA);
        LeafKind kindB = PlanarCases.kind(formB);
        touch = PlanarOverlap.test(new Leaf(kindA, a, 0), new Leaf(kindB, b, 0), scratch.overlap);
        double distance = PlanarDistance.between(new Leaf(kindA, a, 0), new Leaf(kindB, b, 0), scratch.distance);
        String text = PlanarCases.paste(formA, a) + " and " + PlanarCases.paste(formB, b);
        double size = one.size() + two.size();
        Visit visit = hasOval() ? oval(one.parted(two), distance, size, text) : exact(one, two, distance, size, text);
        if (visit.failure() != null) {
            return visit;
        }
        double far = hasOval() // these touch, to the test, where they are apart by less than its bound
                ? Math.max(0, one.parted(two).head())
                : touch ? 0 : one.gap(two).distance().head();
        String wrong = bracket(far, size);
        return wrong == null ? visit : Visit.wrong(visit.regime(), text + ": " + wrong);
    }

    /** What is wrong with the bracket of {@code ContactQuery.distance}, which holds the truth and is as narrow as is said. */
    private @Nullable String bracket(double truth, double size) {
        probe.measure(Dimension.PLANAR, column(formA, a, columnA), column(formB, b, columnB));
        double low = probe.low();
        double high = probe.high();
        double rounding = 0x1p-52 * truth + 0x1p-80 * size;
        boolean holds = low <= truth + rounding && high >= truth - rounding;
        return holds && high - low <= 0x1p-44 * (high + size) && low <= high
                ? null
                : "the distance is " + truth + " (got: " + low + " to " + high + ")";
    }

    private static LeafColumn column(Form form, double[] row, LeafColumn column) {
        column.clear();
        column.append(1);
        column.setKind(0, PlanarCases.kind(form));
        System.arraycopy(row, 0, column.rows(0), column.at(0), Leaf.STRIDE);
        return column;
    }

    private Visit exact(PlanarTwin one, PlanarTwin two, double distance, double size, String text) {
        boolean truth = PlanarTwin.exactly(number -> Truth.planar(number, formA, a, formB, b));
        if (truth) {
            double deep = one.parted(two).head();
            String regime = deep > -CLOSE * size ? "all but apart" : "overlapping";
            return touch && distance == 0
                    ? Visit.right(regime)
                    : Visit.wrong(regime, text + ": they touch (got: " + touch + ", " + distance + ")");
        }
        PlanarTwin.Gap gap = one.gap(two);
        String regime = gap.distance().head() > CLOSE * size ? "apart" : "all but touching";
        if (hasSides() && regime.equals("apart")) {
            regime += gap.isSide() ? ", a side" : ", a corner";
        }
        double far = gap.distance().head();
        if (touch || (distance == 0 && far > Double.MIN_NORMAL && far > 64 * 0x1p-53 * size)) {
            return Visit.wrong(regime, text + ": they are " + far + " apart (got: " + touch + ", " + distance + ")");
        }
        boolean isRound = (formA == Form.SPHERE && (formB == Form.SPHERE || formB == Form.UPRIGHT_BOX));
        double bound = isRound ? 3 * Math.ulp(far) + 0x1p-98 * size : 16 * 0x1p-53 * size;
        return Visit.number(
                regime,
                Math.max(0, far - distance) / bound,
                Math.max(0, distance - far) / bound,
                0,
                () -> text + ": " + far + " apart (got: " + distance + ")");
    }

    private Visit oval(Twofold parted, double distance, double size, String text) {
        double far = parted.head();
        String regime = far > CLOSE * size
                ? "apart"
                : far > 0 ? "all but touching" : far > -CLOSE * size ? "all but apart" : "overlapping";
        double bound = 0x1p-45 * size;
        if (touch ? far > bound || distance != 0 : far < 0) {
            return Visit.wrong(regime, text + ": " + far + " apart (got: " + touch + ", " + distance + ")");
        }
        double truth = Math.max(0, far);
        return Visit.number(
                regime,
                Math.max(0, truth - distance) / bound,
                distance > truth ? (distance - truth) / Math.ulp(truth) : 0,
                0,
                () -> text + ": " + far + " apart (got: " + distance + ")");
    }
}
