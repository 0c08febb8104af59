package robosim.geometry.census;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import robosim.geometry.narrow.leaf.LeafColumn;

/**
 * The least distance of two convex bodies in space, as worlds ask it, and the bracket of {@code ContactQuery.distance}: both
 * within 2^-44 of the distance and the sizes, the bracket's ends on their sides of the truth.
 */
final class DistanceKernel implements Kernel {
    /** A gap below this share of the size is near contact. */
    private static final double NEAR = 1e-3;

    private static final String TOUCHING = "touching";
    private static final String OVERLAPPING = "overlapping";

    private final Body.Type typeA;
    private final Body.Type typeB;
    private final Set<String> regimes = new LinkedHashSet<>();
    private final DistanceProbe probe = new DistanceProbe();
    private final LeafColumn columnA = new LeafColumn(1);
    private final LeafColumn columnB = new LeafColumn(1);
    private final NearestTwin twin = new NearestTwin();

    DistanceKernel(Body.Type typeA, Body.Type typeB) {
        this.typeA = typeA;
        this.typeB = typeB;
        for (String p : features(typeA)) {
            regimes.add("far, " + p);
            for (String q : features(typeB)) {
                regimes.add("near, " + both(p, q));
            }
        }
        regimes.add(TOUCHING);
        regimes.add(OVERLAPPING);
    }

    static List<Kernel> all() {
        List<Kernel> kernels = new ArrayList<>();
        Body.Type[] types = Body.Type.values();
        for (int i = 0; i < types.length; i++) {
            for (int j = i; j < types.length; j++) {
                kernels.add(new DistanceKernel(types[i], types[j]));
            }
        }
        kernels.add(new MeshDistanceKernel());
        return kernels;
    }

    private static List<String> features(Body.Type type) {
        return switch (type) {
            case BOX, TRIANGLE -> List.of("corner", "edge", "face");
            case CYLINDER -> List.of("rim", "mantle", "cap");
            case SPHERE -> List.of("sphere");
            case CAPSULE -> List.of("end", "side");
        };
    }

    /** Of two bodies of a type it does not matter which one has which feature. */
    private String both(String p, String q) {
        boolean swapped = typeA == typeB && p.compareTo(q) > 0;
        return swapped ? q + "-" + p : p + "-" + q;
    }

    @Override
    public String name() {
        return "distance in space, %s and %s".formatted(typeA, typeB).toLowerCase(java.util.Locale.ROOT);
    }

    @Override
    public List<String> regimes() {
        return List.copyOf(regimes);
    }

    @Override
    public Visit ask(SplittableRandom random, boolean adversarial) {
        SpacePairs pairs = new SpacePairs(random, adversarial);
        int most = typeA == Body.Type.SPHERE && typeB == Body.Type.SPHERE ? 1 : 3;
        int featureA = random.nextInt(most);
        int featureB = random.nextInt(most);
        int state = random.nextInt(100);
        if (state < 12 && !adversarial) {
            pairs.apart(typeA, typeB);
        } else {
            pairs.facing(typeA, featureA, typeB, featureB, gap(random, state, adversarial));
        }
        return compare(pairs.a, pairs.b);
    }

    /** As a share of the sizes; plain gaps and depths are those of robots, adversarial ones leave little to doubles. */
    static double gap(SplittableRandom random, int state, boolean adversarial) {
        if (state < 22) {
            return StrictMath.pow(10, random.nextDouble(-2, 0));
        }
        if (state < 85) {
            return StrictMath.pow(10, adversarial ? random.nextDouble(-13, -6) : random.nextDouble(-6, -3.2));
        }
        if (state < 91) {
            return 0;
        }
        return -StrictMath.pow(10, adversarial ? random.nextDouble(-8, -4) : random.nextDouble(-4, -1));
    }

    private Visit compare(Body a, Body b) {
        twin.find(a, b);
        double rounding = NearestTwin.rounding(a, b);
        a.writeTo(columnA);
        b.writeTo(columnB);
        return probe.compare(
                regime(a, b, rounding),
                columnA,
                columnB,
                Math.max(0, twin.low) - rounding,
                twin.high + rounding,
                a.size() + b.size() + Vec.length(Vec.minus(a.c, b.c)),
                rounding,
                () -> a + ", " + b);
    }

    private String regime(Body a, Body b, double rounding) {
        if (!(twin.low > 2 * rounding)) {
            return twin.low > -rounding ? TOUCHING : OVERLAPPING;
        }
        String ahead = BodyFeatures.feature(a, twin.n);
        if (twin.low > NEAR * (a.size() + b.size())) {
            return "far, " + ahead;
        }
        return "near, " + both(ahead, BodyFeatures.feature(b, Vec.plus(new double[3], -1, twin.n)));
    }
}
