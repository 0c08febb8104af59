package robosim.geometry.proof;

import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import org.jspecify.annotations.Nullable;
import robosim.geometry.Geometry;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CapsuleObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.SphereObject;
import robosim.geometry.narrow.leaf.LeafKind;

/**
 * Proofs of a seeded share of the answers that tests ask for. Each proof that is found must hold, and no answer may have its
 * opposite proved. The share is {@code -Dtest.proofs}; without it, all in a full run and few in an ordinary build.
 *
 * <p>For one thread at a time. Which answers are drawn depends on the seed and their order alone.
 */
public final class Witnesses {
    private static final double SHARE = Double.parseDouble(System.getProperty("test.proofs", share()));

    /** A kernel tells a time to rounding, so that freedom is claimed up to slightly before it. */
    private static final double BEFORE = 1 - 0x1p-42;

    private final SplittableRandom random;

    private Counts counts = Counts.NONE;

    /**
     * What came of the answers drawn.
     *
     * @param proved     so many proofs were found and hold
     * @param unprovable so many answers have no proof: they are certain to a bound only, or nothing was found
     * @param failed     so many proofs do not hold, or show the opposite of an answer
     */
    public record Counts(long proved, long unprovable, long failed) {
        /** Of no answer. */
        public static final Counts NONE = new Counts(0, 0, 0);

        /** The sums. */
        public Counts plus(Counts that) {
            return new Counts(proved + that.proved, unprovable + that.unprovable, failed + that.failed);
        }

        @Override
        public String toString() {
            return String.format(
                    Locale.ROOT, "%,d are proved, %,d have no proof, %,d proofs failed", proved, unprovable, failed);
        }
    }

    /** Draws from a seed. */
    public Witnesses(long seed) {
        random = new SplittableRandom(seed);
    }

    private static String share() {
        return Double.parseDouble(System.getProperty("test.effort", "1")) >= 1 ? "1" : "0.02";
    }

    /** Whether the next answer is to be proved. */
    public boolean isDue() {
        return random.nextDouble() < SHARE;
    }

    /** What came of the answers drawn so far. */
    public Counts counts() {
        return counts;
    }

    /** Draws, and proves whether two objects touch; tells what is wrong. {@code isCertain} is whether the answer is not to a bound only. */
    public @Nullable String overlap(
            @Nullable GeometryObject a,
            @Nullable GeometryObject b,
            Dimension dimension,
            boolean touches,
            boolean isCertain) {
        if (!isDue()) {
            return null;
        }
        if (a == null || b == null) {
            return unproved();
        }
        Prover prover = new Prover(new Scene(List.of(b), dimension, null));
        Attempt apart = prover.apart(a, Claim.ALL, 0);
        if (touches && !isCertain && apart.isProved()) {
            return unproved(); // the bound is wider than the gap, as such an answer says
        }
        return check(prover, touches ? prover.touching(a, 0) : apart, touches ? apart : prover.touching(a, 0));
    }

    /** Draws, and proves the distance along a ray, infinite for a miss; tells what is wrong. */
    public @Nullable String ray(
            double[] start, double[] way, @Nullable GeometryObject target, Dimension dimension, double distance) {
        if (!isDue()) {
            return null;
        }
        if (target == null) {
            return unproved();
        }
        Prover prover = new Prover(new Scene(List.of(target), dimension, null));
        Point from = new Point(start[0], start[1], start[2]);
        Point along = new Point(way[0], way[1], way[2]);
        boolean hits = distance < Double.POSITIVE_INFINITY;
        double size = target.bounds().size() + Math.abs(start[0]) + Math.abs(start[1]) + Math.abs(start[2]);
        double beyond = 1 + 4 * (size + length(target.center()));
        Attempt attempt = prover.ray(from, along, Claim.ALL, hits ? distance : beyond, hits ? 0 : Claim.ALL);
        return check(prover, attempt, hits ? prover.ray(from, along, Claim.ALL, beyond, Claim.ALL) : null);
    }

    /** Draws, and proves how far an object can be moved, a fraction of a way or infinity where nothing is met; tells what is wrong. */
    public @Nullable String translation(
            @Nullable GeometryObject a,
            double[] way,
            @Nullable GeometryObject b,
            Dimension dimension,
            double fraction) {
        if (!isDue()) {
            return null;
        }
        if (a == null || b == null) {
            return unproved();
        }
        Prover prover = new Prover(new Scene(List.of(b), dimension, null));
        Point by = new Point(way[0], way[1], way[2]);
        Attempt free = prover.translation(a, Claim.ALL, by, 1);
        if (fraction > 1) {
            return check(prover, free, null);
        }
        return check(prover, prover.blocked(a, Claim.ALL, by, fraction * BEFORE, 0), free);
    }

    /** Draws, and proves that no object of some names overlaps another one where it is; tells what is wrong. */
    public @Nullable String clear(Geometry world, List<String> names) {
        if (!isDue()) {
            return null;
        }
        String wrong = null;
        for (String name : names) {
            Attempt attempt = world.prove().clear(name);
            String found = check(world.prove().checker(), attempt, null);
            wrong = wrong == null ? found : wrong;
        }
        return wrong;
    }

    private static double length(Point p) {
        return Math.sqrt(p.x() * p.x() + p.y() * p.y() + p.z() * p.z());
    }

    private void count(long proved, long unprovable, long failed) {
        counts = counts.plus(new Counts(proved, unprovable, failed));
    }

    private @Nullable String unproved() {
        count(0, 1, 0);
        return null;
    }

    private @Nullable String check(Prover prover, Attempt attempt, @Nullable Attempt opposite) {
        return check(new ProofChecker(prover.scene()), attempt, opposite);
    }

    private @Nullable String check(ProofChecker checker, Attempt attempt, @Nullable Attempt opposite) {
        Proof against = opposite == null ? null : opposite.proof();
        if (against != null && checker.check(against).isValid()) {
            count(0, 0, 1);
            return "the opposite is proved: " + against;
        }
        Proof proof = attempt.proof();
        if (proof == null) {
            return unproved();
        }
        ProofChecker.Result result = checker.check(proof);
        if (!result.isValid()) {
            count(0, 0, 1);
            return result.reason() + ": " + proof;
        }
        count(1, 0, 0);
        return null;
    }

    /** The object that a leaf is a row of; null where none has these numbers. */
    public static @Nullable GeometryObject object(LeafKind kind, double[] row) {
        Point c = new Point(row[0], row[1], row[2]);
        try {
            GeometryObject made = switch (kind) {
                case BOX, UPRIGHT_BOX -> new BoxObject(c, 2 * row[3], 2 * row[4], 2 * row[5]);
                case CYLINDER, UPRIGHT_CYLINDER -> new CylinderObject(c, row[3], 2 * row[4]);
                case CAPSULE, UPRIGHT_CAPSULE -> new CapsuleObject(c, row[3], 2 * row[4]);
                case SPHERE -> new SphereObject(c, row[3]);
                case TRIANGLE ->
                    new MeshObject(
                            List.of(c, new Point(row[3], row[4], row[5]), new Point(row[6], row[7], row[8])),
                            new int[][] {{0, 1, 2}});
                default -> throw new IllegalArgumentException("kind must be one piece (got: " + kind + ")");
            };
            boolean isTurned = kind == LeafKind.BOX
                    || kind == LeafKind.UPRIGHT_BOX
                    || kind == LeafKind.CYLINDER
                    || kind == LeafKind.CAPSULE;
            double[] attitude = new double[11];
            System.arraycopy(row, 6, attitude, 0, 9);
            return isTurned ? made.at(Pose.of(c, attitude, 0)) : made;
        } catch (IllegalArgumentException noObject) {
            return null; // rows of tests may be smaller, larger or less of a rotation than any object
        }
    }
}
