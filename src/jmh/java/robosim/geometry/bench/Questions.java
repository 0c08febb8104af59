package robosim.geometry.bench;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import robosim.geometry.engine.objects.WorldBounds;
import robosim.geometry.exact.BeamAxis;
import robosim.geometry.exact.Orientation;
import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.cone.PlanarCone;
import robosim.geometry.narrow.cone.SpatialCone;
import robosim.geometry.narrow.distance.PlanarDistance;
import robosim.geometry.narrow.distance.SpatialDistance;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.leaf.PivotTurn;
import robosim.geometry.narrow.overlap.PlanarOverlap;
import robosim.geometry.narrow.overlap.SpatialOverlap;
import robosim.geometry.narrow.ray.PlanarRay;
import robosim.geometry.narrow.ray.SpatialRay;
import robosim.geometry.narrow.sweep.PlanarSweep;
import robosim.geometry.narrow.sweep.SpatialSweep;

/**
 * Questions to every kernel, the same for the same seed on every machine: {@link NearContacts} at random and as near to contact
 * as rounding lets them be. An instance holds one question at a time.
 */
public final class Questions {
    /** What is asked. */
    public enum Subject {
        OVERLAP,
        RAY,
        CONE,
        DISTANCE,
        TRANSLATION,
        TURN,
        SIDE,
        VOLUME,
        PRODUCTS,
        BORDER
    }

    /**
     * Questions of one sort.
     *
     * @param planar whether they are about projections
     * @param kindA  the first leaf's kind; the only one of a ray or a cone
     */
    public record Family(Subject subject, boolean planar, LeafKind kindA, LeafKind kindB) {
        @Override
        public String toString() {
            return (planar ? "planar " : "spatial ") + subject + " " + name(kindA) + " " + name(kindB);
        }

        private static String name(LeafKind kind) {
            return kind.name().toLowerCase(Locale.ROOT).replace('_', ' ');
        }
    }

    private static final LeafKind[] KINDS =
            Arrays.stream(LeafKind.values()).filter(kind -> !kind.hasPieces()).toArray(LeafKind[]::new);

    private final Scratch scratch = new Scratch();
    private final BeamAxis beam = new BeamAxis();
    private final NearContacts pairs = new NearContacts();
    private final double[] numbers = new double[12];
    private Family family = new Family(Subject.SIDE, true, LeafKind.UPRIGHT_BOX, LeafKind.UPRIGHT_BOX);
    private double angle;

    /** All families of some subjects, each unordered pair of kinds once but for motions. */
    public static List<Family> families(Subject... subjects) {
        List<Family> families = new ArrayList<>();
        for (Subject subject : subjects) {
            for (boolean planar : new boolean[] {true, false}) {
                addFamilies(subject, planar, families);
            }
        }
        return families;
    }

    private static void addFamilies(Subject subject, boolean planar, List<Family> families) {
        switch (subject) {
            case SIDE, PRODUCTS -> {
                if (planar) {
                    families.add(new Family(subject, true, LeafKind.UPRIGHT_BOX, LeafKind.UPRIGHT_BOX));
                }
            }
            case VOLUME -> {
                if (!planar) {
                    families.add(new Family(subject, false, LeafKind.UPRIGHT_BOX, LeafKind.UPRIGHT_BOX));
                }
            }
            case BORDER -> {
                for (LeafKind kind : KINDS) {
                    if (!planar && kind.compareTo(LeafKind.CYLINDER) <= 0) {
                        families.add(new Family(subject, false, kind, kind));
                    }
                }
            }
            case RAY, CONE -> {
                for (LeafKind kind : KINDS) {
                    families.add(new Family(subject, planar, kind, kind));
                }
            }
            default -> {
                boolean ordered = subject == Subject.TRANSLATION || subject == Subject.TURN;
                for (LeafKind a : KINDS) {
                    for (LeafKind b : KINDS) {
                        // An enclosure that turns becomes another one.
                        boolean isAsked = subject != Subject.TURN || !(a.isEnclosure() || b.isEnclosure());
                        if (isAsked && (ordered || a.compareTo(b) <= 0)) {
                            families.add(new Family(subject, planar, a, b));
                        }
                    }
                }
            }
        }
    }

    /** Makes the question of this number. */
    public void make(Family asked, long seed, int number) {
        family = asked;
        SplittableRandom random = new SplittableRandom(seed * 0x9E3779B97F4A7C15L
                + 1_000_003L * number
                + 31L * asked.subject().ordinal()
                + 1009L * asked.kindA().ordinal()
                + 10_007L * asked.kindB().ordinal()
                + (asked.planar() ? 1 : 0));
        angle = random.nextDouble();
        switch (asked.subject()) {
            case OVERLAP, DISTANCE, TURN -> pairs.pair(asked.kindA(), asked.kindB(), asked.planar(), random);
            case TRANSLATION -> pairs.motion(asked.kindA(), asked.kindB(), asked.planar(), random);
            case BORDER -> pairs.border(asked.kindA(), random);
            case RAY, CONE -> pairs.ray(asked.kindA(), asked.planar(), random);
            default -> points(asked.planar() ? 2 : 3, random);
        }
    }

    // As many points as the determinant takes, the last on the line or plane of the others but for rounding.
    private void points(int dimensions, SplittableRandom random) {
        double size = Math.scalb(1.0, random.nextInt(-40, 41));
        boolean coarse = random.nextInt(4) == 0;
        int last = dimensions * dimensions;
        for (int k = 0; k < last; k++) {
            numbers[k] = size * (coarse ? random.nextInt(-8, 9) : random.nextDouble(-1, 1));
        }
        double s = random.nextDouble(-2, 2);
        double t = dimensions == 2 ? 0 : random.nextDouble(-2, 2);
        for (int k = 0; k < dimensions; k++) {
            double a = numbers[k];
            double along = a + s * (numbers[dimensions + k] - a);
            numbers[last + k] = dimensions == 2 ? along : along + t * (numbers[2 * dimensions + k] - a);
        }
        int k = random.nextInt(last + dimensions);
        numbers[k] += random.nextInt(-3, 4) * Math.ulp(numbers[k]);
    }

    /** Answers the question: a verdict as 0 or 1, a sign, a distance, a share of a motion. */
    public double ask() {
        double[] a = pairs.a;
        double[] b = pairs.b;
        LeafKind kindA = family.kindA();
        LeafKind kindB = family.kindB();
        boolean planar = family.planar();
        double[] n = numbers;
        return switch (family.subject()) {
            case OVERLAP ->
                (planar
                                ? PlanarOverlap.test(new Leaf(kindA, a, 0), new Leaf(kindB, b, 0), scratch.overlap)
                                : SpatialOverlap.test(new Leaf(kindA, a, 0), new Leaf(kindB, b, 0), scratch.overlap))
                        ? 1
                        : 0;
            case DISTANCE ->
                planar
                        ? PlanarDistance.between(new Leaf(kindA, a, 0), new Leaf(kindB, b, 0), scratch.distance)
                        : SpatialDistance.between(new Leaf(kindA, a, 0), new Leaf(kindB, b, 0), scratch.distance);
            case RAY -> ray(pairs.start, pairs.way, kindA, a);
            case CONE -> cone(pairs.start, pairs.way, kindA, a);
            case TRANSLATION -> translation(pairs.way, kindA, a, kindB, b);
            case TURN -> turn(kindA, a, kindB, b);
            case SIDE -> Orientation.side(n[0], n[1], n[2], n[3], n[4], n[5]);
            case VOLUME -> Orientation.volume(n, n[9], n[10], n[11]);
            case BORDER -> border(kindA, a) ? 1 : 0;
            case PRODUCTS -> Orientation.compareProducts(n[0], n[1], n[2], n[3]);
        };
    }

    private boolean border(LeafKind kind, double[] row) {
        LeafColumn column = new LeafColumn(1);
        column.append(1);
        System.arraycopy(row, 0, column.rows(), 0, Leaf.STRIDE);
        column.setKind(0, kind);
        double[] size = pairs.way;
        return new WorldBounds(size[0], size[1], size[2], Dimension.SPATIAL).holds(column, 0, 1);
    }

    private double ray(double[] o, double[] d, LeafKind kind, double[] row) {
        return family.planar()
                ? PlanarRay.distance(beam.line(o[0], 0, o[2], d[0], 0, d[2]), kind, row, 0, scratch.ray)
                : SpatialRay.distance(beam.line(o[0], o[1], o[2], d[0], d[1], d[2]), kind, row, 0, scratch.ray);
    }

    private double cone(double[] o, double[] d, LeafKind kind, double[] row) {
        double half = 0.01 + 1.5 * angle;
        double cos = StrictMath.cos(half);
        double sin = StrictMath.sin(half);
        return family.planar()
                ? PlanarCone.distance(
                        beam.line(o[0], 0, o[2], d[0], 0, d[2]).widen(cos, sin),
                        kind,
                        row,
                        0,
                        Double.POSITIVE_INFINITY,
                        scratch.cone)
                : SpatialCone.distance(
                        beam.line(o[0], o[1], o[2], d[0], d[1], d[2]).widen(cos, sin),
                        kind,
                        row,
                        0,
                        Double.POSITIVE_INFINITY,
                        scratch.cone);
    }

    private double translation(double[] d, LeafKind kindA, double[] a, LeafKind kindB, double[] b) {
        return family.planar()
                ? PlanarSweep.translation(new Leaf(kindA, a, 0), d[0], d[1], d[2], new Leaf(kindB, b, 0), scratch.sweep)
                : SpatialSweep.translation(
                        new Leaf(kindA, a, 0), d[0], d[1], d[2], new Leaf(kindB, b, 0), scratch.sweep);
    }

    private double turn(LeafKind kindA, double[] a, LeafKind kindB, double[] b) {
        double degrees = 720 * angle - 360;
        return family.planar()
                ? PlanarSweep.turn(
                        new Leaf(kindA, a, 0),
                        new PivotTurn().about(a[0], a[1], a[2]).by(0, 1, 0, degrees),
                        new Leaf(kindB, b, 0),
                        scratch.sweep)
                : SpatialSweep.turn(
                        new Leaf(kindA, a, 0),
                        new PivotTurn().about(a[0], a[1], a[2]).by(0, 1, 0, degrees),
                        new Leaf(kindB, b, 0),
                        scratch.sweep);
    }

    /** The largest of the numbers that a distance is computed from. */
    public double size() {
        boolean isBeam = family.subject() == Subject.RAY || family.subject() == Subject.CONE;
        return pairs.size(family.kindA(), family.kindB(), isBeam);
    }

    /** Of a translation: the sum of the magnitudes of all coordinates and sizes, and of the way. */
    public double sum() {
        return pairs.sum(family.kindA(), family.kindB());
    }

    /** Of a translation: how far apart the two are after a share of it. */
    public double gap(double share) {
        return pairs.gap(family.kindA(), family.kindB(), share, scratch);
    }

    /** The question in numbers. */
    @Override
    public String toString() {
        return switch (family.subject()) {
            case SIDE, VOLUME, PRODUCTS -> family + " " + Arrays.toString(numbers);
            case RAY, CONE ->
                "%s %s from %s along %s"
                        .formatted(
                                family,
                                Arrays.toString(pairs.a),
                                Arrays.toString(pairs.start),
                                Arrays.toString(pairs.way));
            default ->
                "%s %s and %s by %s"
                        .formatted(
                                family, Arrays.toString(pairs.a), Arrays.toString(pairs.b), Arrays.toString(pairs.way));
        };
    }
}
