package robosim.geometry.cases;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import robosim.geometry.Geometry;
import robosim.geometry.cases.HardCase.Question;
import robosim.geometry.collision.CollisionDetection;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;
import robosim.geometry.proof.Witnesses;
import robosim.geometry.reference.Gaps;

/** Asks the module the questions of a case in all their variants, and holds each answer against the truth. */
public final class Trial {
    private static final double NEVER = Double.POSITIVE_INFINITY;

    private final HardCase hard;
    private final List<Finding> findings = new ArrayList<>();
    private final Witnesses witnesses;

    /** Of the questions as given. */
    private final Map<String, Object> truths = new HashMap<>();

    /** Of the turns as given, by question and dimension. */
    private final Map<String, double[]> turns = new HashMap<>();

    private Trial(HardCase hard) {
        this.hard = hard;
        witnesses = new Witnesses(hard.id().hashCode());
    }

    /** All findings about a case. */
    public static List<Finding> run(HardCase hard) {
        Trial trial = new Trial(hard);
        for (int k = 0; k < hard.questions().size(); k++) {
            trial.ask(k, hard.questions().get(k));
        }
        return trial.findings;
    }

    private void ask(int index, Question question) {
        if (question instanceof HardCase.Refusal refusal) {
            stated(index, asGiven(), refusal.truth(), Oddities.refusal(refusal), Oddities.refuses(refusal));
            return;
        }
        if (question instanceof HardCase.Spin spin) {
            double heading = Oddities.heading(spin);
            boolean right = Math.abs(heading - Double.parseDouble(spin.truth())) <= spin.within();
            stated(index, asGiven(), spin.truth(), Double.toString(heading), right);
            return;
        }
        Map<Dimension, Double> given = new LinkedHashMap<>();
        for (Variant variant : Variant.of(hard, hard.objects(), places(question))) {
            if (variant.dimension() == Dimension.PLANAR && "no".equals(question.planar())) {
                continue;
            }
            try {
                ask(index, question, variant, given);
            } catch (UnknownTruthException e) {
                // The reference does not know this variant; that it knows the case as given is a test of its own.
                continue;
            }
        }
    }

    private void ask(int index, Question question, Variant variant, Map<Dimension, Double> given) {
        if (question instanceof HardCase.Overlap overlap) {
            overlap(index, overlap, variant);
        } else if (question instanceof HardCase.Beam beam) {
            beam(index, beam, variant, given);
        } else if (question instanceof HardCase.Gap gap) {
            gap(index, gap, variant, given);
        } else if (question instanceof HardCase.Drive drive) {
            new DriveTrial(hard, drive, variant, turns)
                    .run((truth, isStated, ours, right) ->
                            findings.add(new Finding(hard, index, variant, truth, isStated, ours, right)));
        } else if (question instanceof HardCase.Scan scan) {
            String ours = Oddities.scan(hard, scan, variant);
            stated(index, variant, scan.truth(), ours, Oddities.sees(scan, variant, ours));
        }
    }

    private static Variant asGiven() {
        return new Variant("as given", Dimension.SPATIAL, 1, new Point(), true, false);
    }

    private void find(int index, Variant variant, String truth, String ours, boolean right) {
        findings.add(new Finding(hard, index, variant, truth, false, ours, right));
    }

    private void stated(int index, Variant variant, String truth, String ours, boolean right) {
        findings.add(new Finding(hard, index, variant, truth, true, ours, right));
    }

    /** Points of a question that must move with the objects. */
    private static double[] places(Question question) {
        return question instanceof HardCase.Beam beam ? beam.from() : new double[0];
    }

    /** An empty world with room for all of a case. */
    static Geometry world(Dimension dimension, List<GeometryObject> objects, double more) {
        double size = more;
        for (GeometryObject object : objects) {
            size = Math.max(size, Truth.size(object));
        }
        double side = Math.scalb(1.0, Math.getExponent(size) + 4);
        return new Geometry(side, side, side, dimension, Accuracy.EXACT);
    }

    /** What scaling and order leave as it is, but for the scale, is worked out once. */
    @SuppressWarnings("unchecked")
    private <T> T once(int index, Variant variant, Supplier<T> truth) {
        if (!variant.isScaled() && !variant.swapped()) {
            T found = known(truth);
            if (variant.name().endsWith("as given")) {
                truths.put(index + " " + variant.dimension(), found);
            }
            return found;
        }
        T given = (T) truths.get(index + " " + variant.dimension());
        if (given == null) {
            throw new UnknownTruthException(new IllegalArgumentException("the truth as given"));
        }
        return given;
    }

    private void overlap(int index, HardCase.Overlap question, Variant variant) {
        GeometryObject first = variant.place(hard.object(question.a()));
        GeometryObject second = variant.place(hard.object(question.b()));
        GeometryObject a = variant.swapped() ? second : first;
        GeometryObject b = variant.swapped() ? first : second;
        boolean truth = once(index, variant, () -> Gaps.overlap(a, b, variant.dimension()));
        Geometry tested = world(variant.dimension(), List.of(a, b), 0);
        tested.addObjectUnchecked(a);
        boolean collides = tested.testObject(b);
        boolean same = tested.addObject(b) != collides;
        if (variant.dimension() == Dimension.SPATIAL) {
            same &= CollisionDetection.intersects(a, b) == collides;
        }
        if (variant.swapped()) {
            same &= Corners.allOrders(a, b, variant.dimension(), collides);
        }
        // The points of contacts are held against the reference where something is rounded anew.
        boolean points = !variant.isScaled() && !variant.swapped();
        String complaint = Contacts.complaint(a, b, variant.dimension(), truth, points);
        String wrongProof = witnesses.overlap(a, b, variant.dimension(), collides, true);
        String ours = !complaint.isEmpty()
                ? complaint
                : wrongProof != null
                        ? wrongProof
                        : !same ? "its own ways to ask disagree" : collides ? "collide" : "apart";
        find(
                index,
                variant,
                truth ? "collide" : "apart",
                ours,
                complaint.isEmpty() && wrongProof == null && same && collides == truth);
    }

    private void beam(int index, HardCase.Beam question, Variant variant, Map<Dimension, Double> given) {
        double[] d = question.direction();
        if (variant.dimension() == Dimension.PLANAR && d[0] == 0 && d[2] == 0) {
            return; // refused by contract
        }
        double[] f = question.from();
        Ray ray = new Ray(variant.place(new Point(f[0], f[1], f[2])), new Point(d[0], d[1], d[2]));
        List<GeometryObject> objects = inOrder(question.of(), variant);
        double min = question.min() * variant.scale();
        double max = question.max() * variant.scale();
        BigDecimal exact = known(() -> Truth.beam(ray, question.width(), objects, variant.dimension()));
        boolean echoes = exact != null && exact.compareTo(bound(max)) <= 0;
        Geometry world = world(variant.dimension(), objects, Truth.size(point(ray.start())));
        objects.forEach(world::addObjectUnchecked);
        double ours = world.getRayDistance(ray, min, max, question.width());
        String truth = "miss";
        boolean right = ours == NEVER;
        if (echoes) {
            BigDecimal answer = exact.max(BigDecimal.valueOf(min));
            truth = Double.toString(answer.doubleValue());
            double size = Math.max(answer.doubleValue(), Truth.size(point(ray.start())));
            for (GeometryObject object : objects) {
                size = Math.max(size, Truth.size(object));
            }
            // A line: 4 ulp of the largest number that it was computed from; a cone: 8, or a cylinder's bracket.
            double off = far(answer, ours);
            boolean bracket = question.width() > 0
                    && variant.dimension() == Dimension.SPATIAL
                    && objects.stream().anyMatch(object -> object.kind() == GeometryObject.Kind.CYLINDER)
                    && off <= answer.doubleValue() * 0x1p-40
                    && answer.compareTo(new BigDecimal(ours)) >= 0;
            right = (off <= (question.width() == 0 ? 4 : 8) * Math.ulp(size) || bracket)
                    && (answer.signum() != 0 || ours == 0);
        }
        String wrongProof = question.width() == 0 && objects.size() == 1
                ? witnesses.ray(
                        numbers(ray.start()), numbers(ray.direction()), objects.get(0), variant.dimension(), ours)
                : null;
        right &= wrongProof == null;
        find(
                index,
                variant,
                truth,
                wrongProof == null ? text(ours) : wrongProof,
                right && scales(variant, ours, given));
    }

    private static double[] numbers(Point p) {
        return new double[] {p.x(), p.y(), p.z()};
    }

    /** Times a power of two, an answer is the same bits times that power. */
    private static boolean scales(Variant variant, double ours, Map<Dimension, Double> given) {
        if (variant.name().endsWith("as given")) {
            given.put(variant.dimension(), ours);
        }
        return !variant.isScaled() || ours == given.getOrDefault(variant.dimension(), Double.NaN) * variant.scale();
    }

    private void gap(int index, HardCase.Gap question, Variant variant, Map<Dimension, Double> given) {
        GeometryObject first = variant.place(hard.object(question.a()));
        GeometryObject second = variant.place(hard.object(question.b()));
        BigDecimal truth = once(index, variant, () -> Gaps.distance(first, second, variant.dimension()))
                .multiply(new BigDecimal(variant.scale()));
        Geometry world = world(variant.dimension(), List.of(first, second), 0);
        world.addObjectUnchecked((variant.swapped() ? second : first).moveable("one"));
        world.addObjectUnchecked((variant.swapped() ? first : second).named("other"));
        double ours = world.getProximity("one", NEVER);
        double size = Math.max(truth.doubleValue(), Math.max(Truth.size(first), Truth.size(second)));
        boolean right = far(truth, ours) <= size * 0x1p-43 && (truth.signum() != 0 || ours == 0);
        right &= Contacts.brackets(first, second, variant.dimension(), truth);
        find(index, variant, Double.toString(truth.doubleValue()), text(ours), right && scales(variant, ours, given));
    }

    /** The objects of some names, where a variant has them, and in its order. */
    private List<GeometryObject> inOrder(List<String> names, Variant variant) {
        List<GeometryObject> placed = new ArrayList<>();
        for (GeometryObject object : hard.objects(names)) {
            placed.add(variant.swapped() ? 0 : placed.size(), variant.place(object));
        }
        return placed;
    }

    static GeometryObject point(Point p) {
        return new robosim.geometry.model.SphereObject(p, 0);
    }

    static double far(BigDecimal truth, double answer) {
        return Double.isFinite(answer)
                ? truth.subtract(new BigDecimal(answer)).abs().doubleValue()
                : NEVER;
    }

    private static BigDecimal bound(double max) {
        return max == NEVER ? new BigDecimal("1e999") : new BigDecimal(max);
    }

    static String text(double distance) {
        return distance == NEVER ? "miss" : Double.toString(distance);
    }

    /** A truth that the exact reference does not know. */
    static final class UnknownTruthException extends RuntimeException {
        private static final long serialVersionUID = 1;

        UnknownTruthException(Throwable cause) {
            super(cause);
        }
    }

    static <T extends @Nullable Object> T known(Supplier<T> truth) {
        try {
            return truth.get();
        } catch (IllegalArgumentException e) {
            throw new UnknownTruthException(e);
        }
    }
}
