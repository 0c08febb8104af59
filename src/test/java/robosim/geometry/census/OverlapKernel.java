package robosim.geometry.census;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import org.jspecify.annotations.Nullable;
import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.overlap.SpatialOverlap;
import robosim.geometry.proof.Witnesses;

/**
 * Whether two convex bodies touch in space, where the twin is sure: apart by a slab wider than its rounding, or with a point
 * in common that is deeper in a solid than that. What is nearer to contact is counted, and asked both ways round only.
 */
final class OverlapKernel implements Kernel {
    private static final String NEARER = "nearer to contact than the twin can tell";

    /** How much deeper than its own rounding a common point has to be for the twin. */
    private static final double DEEPER = 8;

    private final Body.Type typeA;
    private final List<Body.Type> others;
    private final Scratch scratch = new Scratch();
    private final NearestTwin twin = new NearestTwin();
    private Body a = Body.sphere(new double[3], 0);
    private Body b = a;
    private boolean touch;
    private boolean doubtful;

    private OverlapKernel(Body.Type typeA, List<Body.Type> others) {
        this.typeA = typeA;
        this.others = others;
    }

    static List<Kernel> all() {
        List<Body.Type> types = List.of(Body.Type.values());
        List<Kernel> kernels = new ArrayList<>();
        for (Body.Type type : types) {
            kernels.add(new OverlapKernel(type, types.subList(type.ordinal(), types.size())));
        }
        return kernels;
    }

    @Override
    public String name() {
        return "overlap in space, " + lower(typeA) + " and others";
    }

    private static String lower(Body.Type type) {
        return type.name().toLowerCase(Locale.ROOT);
    }

    @Override
    public List<String> regimes() {
        List<String> regimes = new ArrayList<>();
        for (Body.Type other : others) {
            regimes.add("apart, " + lower(other));
            regimes.add("overlapping, " + lower(other));
        }
        regimes.add(NEARER);
        return regimes;
    }

    @Override
    public Visit ask(SplittableRandom random, boolean adversarial) {
        SpacePairs pairs = new SpacePairs(random, adversarial);
        Body.Type other = others.get(random.nextInt(others.size()));
        int state = random.nextInt(16);
        double least = adversarial ? -13 : -6;
        double gap = StrictMath.pow(10, random.nextDouble(least, -0.5));
        double signed = state == 0 ? 0 : state < 7 ? gap : -gap;
        pairs.facing(typeA, random.nextInt(3), other, random.nextInt(3), signed);
        a = pairs.a;
        b = pairs.b;
        scratch.overlap.uncertain = false;
        touch = SpatialOverlap.test(new Leaf(a.kind, a.row, 0), new Leaf(b.kind, b.row, 0), scratch.overlap);
        doubtful = scratch.overlap.uncertain;
        boolean swapped = SpatialOverlap.test(new Leaf(b.kind, b.row, 0), new Leaf(a.kind, a.row, 0), scratch.overlap);
        twin.find(a, b);
        double rounding = NearestTwin.rounding(a, b);
        Boolean truth = twin.low > rounding ? Boolean.FALSE : surelyMeet(a, b, DEEPER * rounding) ? Boolean.TRUE : null;
        String regime = truth == null ? NEARER : (truth ? "overlapping, " : "apart, ") + lower(other);
        boolean far = twin.low > 0x1p-40 * (a.size() + b.size() + Vec.length(Vec.minus(a.c, b.c)));
        boolean right = touch == swapped && (truth == null || truth == touch || (doubtful && !far && touch));
        return right ? Visit.right(regime) : Visit.wrong(regime, touch + ", swapped " + swapped + ": " + a + ", " + b);
    }

    @Override
    public @Nullable String proof(Witnesses witnesses) {
        return witnesses.overlap(
                Witnesses.object(a.kind, a.row), Witnesses.object(b.kind, b.row), Dimension.SPATIAL, touch, !doubtful);
    }

    private boolean surelyMeet(Body a, Body b, double margin) {
        boolean flatA = a.type == Body.Type.TRIANGLE;
        boolean flatB = b.type == Body.Type.TRIANGLE;
        if (flatA && flatB) {
            return pierces(a, b, margin) || pierces(b, a, margin);
        }
        @Nullable Body p = flatA ? a : a.shrunkBy(margin);
        @Nullable Body q = flatB ? b : b.shrunkBy(margin);
        if (p == null || q == null) {
            return false;
        }
        twin.find(p, q);
        return twin.high <= margin / 4;
    }

    /** Whether an edge of the one goes through the other, clear of its edges. */
    private static boolean pierces(Body a, Body b, double margin) {
        double[] normal = Vec.cross(Vec.minus(b.corners[1], b.corners[0]), Vec.minus(b.corners[2], b.corners[0]));
        if (!(Vec.length(normal) > 0x1p-20 * b.size() * b.size())) {
            return false;
        }
        double[] n = Vec.unit(normal);
        for (double[] edge : a.edges) {
            double[] from = {edge[0], edge[1], edge[2]};
            double[] way = {edge[3], edge[4], edge[5]};
            double start = Vec.dot(Vec.minus(from, b.c), n);
            double end = start + Vec.dot(way, n);
            if (start * end >= 0 || Math.min(Math.abs(start), Math.abs(end)) < margin) {
                continue;
            }
            double[] q = Vec.plus(from, start / (start - end), way);
            double clear = margin * (1 + Vec.length(way) / Math.abs(start - end)) * 0x1p20;
            boolean inside = true;
            for (double[] side : b.edges) {
                double[] along = {side[3], side[4], side[5]};
                double[] inward = Vec.unit(Vec.cross(n, along));
                inside &= Vec.dot(Vec.minus(q, new double[] {side[0], side[1], side[2]}), inward) > clear;
            }
            if (inside) {
                return true;
            }
        }
        return false;
    }
}
