package robosim.geometry.census;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.leaf.PivotTurn;
import robosim.geometry.narrow.sweep.PlanarSweep;
import robosim.geometry.narrow.sweep.SpatialSweep;

/**
 * Motions from a gap too small to resolve: away from an obstacle, along it, or turning away from it. All are free.
 *
 * <p>The twin knows a direction n along which the mover begins strictly beyond the obstacle, from decimals of 60 digits, and
 * draws motions along which no point of the mover gets less far along n. The mover stands near the origin, so that gaps down to
 * 10^-17 of its size can be stored. The obstacle is up to 10^4 times as large as the mover.
 */
final class NearStart implements Kernel {
    private static final MathContext DIGITS = new MathContext(60);
    private static final LeafKind[] KINDS = {
        LeafKind.UPRIGHT_BOX,
        LeafKind.BOX,
        LeafKind.TRIANGLE,
        LeafKind.UPRIGHT_CYLINDER,
        LeafKind.CYLINDER,
        LeafKind.SPHERE,
        LeafKind.UPRIGHT_CAPSULE,
        LeafKind.CAPSULE
    };
    private static final String[] FAMILIES = {"box", "triangle", "cylinder", "sphere", "capsule"};
    private static final String[] MOTIONS = {
        "away", "along", "away by little", "turning away", "turning about the normal"
    };
    private static final String[] GAPS = {"10^-17 to 10^-15", "10^-15 to 10^-13", "10^-13 to 10^-11", "10^-11 to 10^-9"
    };

    private final Dimension dimension;
    private final boolean isByPair;
    private final Scratch scratch = new Scratch();
    private final double[] a = new double[Leaf.STRIDE];
    private final double[] b = new double[Leaf.STRIDE];

    NearStart(Dimension dimension, boolean isByPair) {
        this.dimension = dimension;
        this.isByPair = isByPair;
    }

    @Override
    public String name() {
        return "motion from a tiny gap, by %s, %s"
                .formatted(isByPair ? "pair" : "gap", dimension.name().toLowerCase(Locale.ROOT));
    }

    @Override
    public List<String> regimes() {
        List<String> regimes = new ArrayList<>();
        for (int k = 0; isByPair && k < FAMILIES.length; k++) {
            for (int m = k; m < FAMILIES.length; m++) {
                regimes.add(FAMILIES[k] + ", " + FAMILIES[m]);
            }
        }
        for (int k = 0; !isByPair && k < MOTIONS.length; k++) {
            for (String gap : GAPS) {
                regimes.add(MOTIONS[k] + ", gap " + gap);
            }
        }
        return regimes;
    }

    @Override
    public double effort() {
        return 2;
    }

    @Override
    public Visit ask(SplittableRandom random, boolean adversarial) {
        while (true) {
            Visit visit = tryOne(random, adversarial);
            if (visit != null) {
                return visit;
            }
        }
    }

    private @org.jspecify.annotations.Nullable Visit tryOne(SplittableRandom random, boolean adversarial) {
        int first = random.nextInt(FAMILIES.length);
        int second = random.nextInt(FAMILIES.length);
        LeafKind kindA = kind(first, random);
        LeafKind kindB = kind(second, random);
        int motion = random.nextInt(MOTIONS.length);
        double larger = StrictMath.pow(10, adversarial ? random.nextDouble(0, 4) : random.nextDouble(-0.5, 0.5));
        draw(kindA, a, 1, random, adversarial);
        draw(kindB, b, larger, random, adversarial);
        double[] n = normal(kindA, kindB, motion, random, adversarial);
        if (n[0] == 0 && n[1] == 0 && n[2] == 0) {
            return null;
        }
        double exponent = random.nextDouble(-17, -9);
        BigDecimal gap = place(kindA, kindB, n, StrictMath.pow(10, exponent));
        int decade = (int) Math.floor((Math.log10(gap.doubleValue() / Vec.length(n)) + 17) / 2);
        if (gap.signum() <= 0 || decade < 0 || decade > 3) {
            return null;
        }
        String regime = isByPair
                ? FAMILIES[Math.min(first, second)] + ", " + FAMILIES[Math.max(first, second)]
                : MOTIONS[motion] + ", gap " + GAPS[decade];
        String moved = motion < 3 ? translate(kindA, kindB, n, motion, random) : turn(kindA, kindB, n, motion, random);
        if (moved == null) {
            return Visit.right(regime);
        }
        return moved.isEmpty()
                ? null
                : Visit.wrong(
                        regime,
                        "%s %s beside %s %s, apart by %.3g along %s, %s"
                                .formatted(
                                        kindA,
                                        Arrays.toString(a),
                                        kindB,
                                        Arrays.toString(b),
                                        gap.doubleValue() / Vec.length(n),
                                        Arrays.toString(n),
                                        moved));
    }

    private static LeafKind kind(int family, SplittableRandom random) {
        LeafKind[] kinds =
                Arrays.stream(KINDS).filter(kind -> family(kind) == family).toArray(LeafKind[]::new);
        return kinds[random.nextInt(kinds.length)];
    }

    private static int family(LeafKind kind) {
        return switch (kind) {
            case UPRIGHT_BOX, BOX -> 0;
            case TRIANGLE -> 1;
            case UPRIGHT_CYLINDER, CYLINDER -> 2;
            case SPHERE -> 3;
            case UPRIGHT_CAPSULE, CAPSULE -> 4;
            case PRISM, MESH, SOLID_MESH, GRID -> throw kind.refused();
        };
    }

    /** A shape of about a size, at the origin. */
    private static void draw(LeafKind kind, double[] row, double size, SplittableRandom random, boolean adversarial) {
        Arrays.fill(row, 0);
        if (kind == LeafKind.TRIANGLE) {
            for (int k = 0; k < 9; k++) {
                row[k] = random.nextDouble(-size, size);
            }
            if (adversarial && random.nextBoolean()) {
                row[3] = row[0];
                row[4] = row[1];
            }
            return;
        }
        for (int k = 3; k < 6; k++) {
            row[k] = size * random.nextDouble(0.1, 1);
        }
        if (kind == LeafKind.UPRIGHT_BOX) {
            double heading = adversarial ? 90 * random.nextInt(4) : random.nextDouble(-180, 180);
            row[6] = heading % 90 == 0 ? Math.rint(StrictMath.cos(Math.toRadians(heading))) : 0.6;
            row[8] = heading % 90 == 0 ? Math.rint(StrictMath.sin(Math.toRadians(heading))) : 0.8;
            if (heading % 90 != 0) {
                row[6] = StrictMath.cos(Math.toRadians(heading));
                row[8] = StrictMath.sin(Math.toRadians(heading));
            }
            row[10] = 1;
            row[12] = -row[8];
            row[14] = row[6];
        } else if (kind.isTurned()) {
            double[] u = Vec.direction(random);
            double[] towards = Vec.direction(random);
            if (adversarial && random.nextBoolean()) {
                u = new double[] {0, 0, 1};
                towards = new double[] {1, 0, 0};
            }
            System.arraycopy(Vec.turnedRound(Vec.rotation(u, towards), random.nextInt(3)), 0, row, 6, 9);
        }
    }

    private double[] normal(LeafKind kindA, LeafKind kindB, int motion, SplittableRandom random, boolean adversarial) {
        boolean flat = dimension == Dimension.PLANAR;
        double[] n = Vec.direction(random);
        if (motion == 4) {
            n = flat || random.nextBoolean() ? new double[] {0, flat ? 0 : 1, flat ? 1 : 0} : new double[] {1, 0, 0};
            return Vec.plus(new double[3], random.nextBoolean() ? 1 : -1, n);
        }
        double[][] features = {feature(kindA, a, random), feature(kindB, b, random)};
        int mode = random.nextInt(4);
        if (mode == 1) {
            n = features[random.nextInt(2)];
        } else if (mode == 2) {
            double[] edge = features[random.nextInt(2)];
            n = Vec.length(edge) == 0 ? n : Vec.squareTo(Vec.unit(edge), n);
        } else if (mode == 3) {
            n = Vec.cross(features[0], features[1]);
        }
        if (random.nextBoolean()) {
            n = Vec.plus(new double[3], -1, n);
        }
        if (flat) {
            n[1] = 0;
        }
        return Vec.length(n) < 1e-3 ? new double[3] : n;
    }

    /** An edge, an axis, or the normal of a side. */
    private static double[] feature(LeafKind kind, double[] row, SplittableRandom random) {
        if (kind == LeafKind.TRIANGLE) {
            double[] e = {row[3] - row[0], row[4] - row[1], row[5] - row[2]};
            double[] f = {row[6] - row[0], row[7] - row[1], row[8] - row[2]};
            return Vec.unit(random.nextBoolean() ? e : Vec.cross(e, f));
        }
        if (kind.isBox()) {
            int k = 6 + random.nextInt(3);
            return new double[] {row[k], row[k + 3], row[k + 6]};
        }
        return kind == LeafKind.SPHERE
                ? new double[3]
                : kind.isTurned() ? new double[] {row[7], row[10], row[13]} : new double[] {0, 1, 0};
    }

    /** Puts the obstacle so that both touch along n, and then the mover a gap away; answers the gap times the length of n. */
    private BigDecimal place(LeafKind kindA, LeafKind kindB, double[] n, double gap) {
        double[] back = Vec.plus(new double[3], -1, n);
        double[] p = support(kindA, a, back);
        double[] q = support(kindB, b, n);
        shift(kindB, b, p[0] - q[0], p[1] - q[1], p[2] - q[2]);
        BigDecimal apart = gap(kindA, kindB, n);
        double square = Vec.dot(n, n);
        for (int k = 0; k < 3; k++) {
            double by = (gap * Math.sqrt(square) - apart.doubleValue()) / square;
            shift(kindA, a, by * n[0], by * n[1], by * n[2]);
            apart = gap(kindA, kindB, n);
            if (apart.signum() > 0) {
                return apart;
            }
        }
        return apart;
    }

    private static void shift(LeafKind kind, double[] row, double x, double y, double z) {
        for (int k = 0; k < (kind == LeafKind.TRIANGLE ? 9 : 3); k += 3) {
            row[k] += x;
            row[k + 1] += y;
            row[k + 2] += z;
        }
    }

    /** A point of a shape that is farthest in a direction. */
    private double[] support(LeafKind kind, double[] row, double[] n) {
        double[] up = {0, 1, 0};
        return switch (kind) {
            case TRIANGLE -> {
                int best = 0;
                for (int k = 3; k < 9; k += 3) {
                    best = along(row, k, n) > along(row, best, n) ? k : best;
                }
                yield new double[] {row[best], row[best + 1], row[best + 2]};
            }
            case UPRIGHT_BOX, BOX -> {
                double[] point = {row[0], row[1], row[2]};
                for (int k = 0; k < 3; k++) {
                    double[] column = {row[6 + k], row[9 + k], row[12 + k]};
                    point = Vec.plus(point, Math.signum(Vec.dot(column, n)) * row[3 + k], column);
                }
                yield point;
            }
            case SPHERE -> Vec.plus(new double[] {row[0], row[1], row[2]}, row[3], Vec.unit(n));
            case UPRIGHT_CAPSULE, CAPSULE -> {
                double[] axis = kind.isTurned() ? new double[] {row[7], row[10], row[13]} : up;
                double[] end =
                        Vec.plus(new double[] {row[0], row[1], row[2]}, Math.signum(Vec.dot(axis, n)) * row[4], axis);
                yield Vec.plus(end, row[3], Vec.unit(n));
            }
            case UPRIGHT_CYLINDER, CYLINDER -> {
                double[] axis = kind.isTurned() ? new double[] {row[7], row[10], row[13]} : up;
                double[] end =
                        Vec.plus(new double[] {row[0], row[1], row[2]}, Math.signum(Vec.dot(axis, n)) * row[4], axis);
                double[] radial = Vec.squareTo(axis, n);
                yield Vec.length(radial) > 1e-12 ? Vec.plus(end, row[3], Vec.unit(radial)) : end;
            }
            case PRISM, MESH, SOLID_MESH, GRID -> throw kind.refused();
        };
    }

    private static double along(double[] row, int at, double[] n) {
        return row[at] * n[0] + row[at + 1] * n[1] + row[at + 2] * n[2];
    }

    private BigDecimal gap(LeafKind kindA, LeafKind kindB, double[] n) {
        return reach(kindA, a, n, -1).negate().subtract(reach(kindB, b, n, 1));
    }

    /** How far a shape reaches along n, or (side -1) against it. */
    private static BigDecimal reach(LeafKind kind, double[] row, double[] n, int side) {
        if (kind == LeafKind.TRIANGLE) {
            BigDecimal most = dot(row, 0, 1, n).multiply(BigDecimal.valueOf(side));
            for (int k = 3; k < 9; k += 3) {
                most = most.max(dot(row, k, 1, n).multiply(BigDecimal.valueOf(side)));
            }
            return most;
        }
        BigDecimal reach = dot(row, 0, 1, n).multiply(BigDecimal.valueOf(side));
        BigDecimal square = dot(n, 0, 1, n);
        if (kind.isBox()) {
            for (int k = 0; k < 3; k++) {
                reach = reach.add(dot(row, 6 + k, 3, n).abs().multiply(new BigDecimal(row[3 + k])));
            }
            return reach;
        }
        BigDecimal radius = new BigDecimal(row[3]);
        if (kind == LeafKind.SPHERE) {
            return reach.add(square.sqrt(DIGITS).multiply(radius));
        }
        BigDecimal along = kind.isTurned() ? dot(row, 7, 3, n) : new BigDecimal(n[1]);
        reach = reach.add(along.abs().multiply(new BigDecimal(row[4])));
        if (kind.isCapsule()) {
            return reach.add(square.sqrt(DIGITS).multiply(radius));
        }
        double[] axis = kind.isTurned() ? new double[] {row[7], row[10], row[13]} : new double[] {0, 1, 0};
        BigDecimal across = square.subtract(along.multiply(along).divide(dot(axis, 0, 1, axis), DIGITS));
        return reach.add(across.max(BigDecimal.ZERO).sqrt(DIGITS).multiply(radius));
    }

    private static BigDecimal dot(double[] row, int at, int step, double[] n) {
        BigDecimal sum = BigDecimal.ZERO;
        for (int k = 0; k < 3; k++) {
            sum = sum.add(new BigDecimal(row[at + k * step]).multiply(new BigDecimal(n[k])));
        }
        return sum;
    }

    /** Null where the translation is free, empty where none was drawn, else how it came out. */
    private @org.jspecify.annotations.Nullable String translate(
            LeafKind kindA, LeafKind kindB, double[] n, int motion, SplittableRandom random) {
        boolean flat = dimension == Dimension.PLANAR;
        double length = StrictMath.pow(10, random.nextDouble(-3, 3));
        int k = flat ? 1 : random.nextInt(3);
        double[] d = new double[3];
        // Two components exchanged, and one negated, are square to n without rounding.
        d[(k + 1) % 3] = -n[(k + 2) % 3];
        d[(k + 2) % 3] = n[(k + 1) % 3];
        double side = random.nextBoolean() ? 1 : -1;
        double power = Math.scalb(side, Math.getExponent(length));
        d = new double[] {power * d[0], power * d[1], power * d[2]};
        if (motion != 1) {
            double away = motion == 0 ? random.nextDouble(0.05, 3) : StrictMath.pow(10, random.nextDouble(-14, -2));
            d = Vec.plus(d, away * length, n);
        }
        if (dot(d, 0, 1, n).signum() < 0 || Vec.length(d) == 0) {
            return "";
        }
        double share = flat
                ? PlanarSweep.translation(new Leaf(kindA, a, 0), d[0], d[1], d[2], new Leaf(kindB, b, 0), scratch.sweep)
                : SpatialSweep.translation(
                        new Leaf(kindA, a, 0), d[0], d[1], d[2], new Leaf(kindB, b, 0), scratch.sweep);
        return share > 1 ? null : "moved by " + Arrays.toString(d) + ": " + share;
    }

    private @org.jspecify.annotations.Nullable String turn(
            LeafKind kindA, LeafKind kindB, double[] n, int motion, SplittableRandom random) {
        boolean flat = dimension == Dimension.PLANAR;
        double[] w = {0, flat || random.nextBoolean() ? 1 : 0, 0};
        w[2] = w[1] == 0 ? 1 : 0;
        double degrees = random.nextDouble(1, 30);
        double[] pivot = {a[0], a[1], a[2]};
        if (motion == 4) {
            w = flat ? new double[] {0, 1, 0} : n;
            if (flat && kindA != LeafKind.SPHERE && !(kindA.isDisc())) {
                return "";
            }
            degrees = random.nextDouble(-180, 180);
        } else {
            double[] level = flat ? w : Vec.squareTo(w, n);
            if (!flat && Vec.length(level) < 0.05) {
                return "";
            }
            // Every point is less than 45 degrees off the level through the pivot, and rises for the 30 degrees of the
            // turn.
            double[] ahead = Vec.unit(Vec.cross(Vec.unit(n), w));
            double far = kindA == LeafKind.TRIANGLE ? 8 : 5;
            pivot = Vec.plus(pivot, -far, ahead);
        }
        double share = flat
                ? PlanarSweep.turn(
                        new Leaf(kindA, a, 0),
                        new PivotTurn().about(pivot[0], pivot[1], pivot[2]).by(w[0], w[1], w[2], degrees),
                        new Leaf(kindB, b, 0),
                        scratch.sweep)
                : SpatialSweep.turn(
                        new Leaf(kindA, a, 0),
                        new PivotTurn().about(pivot[0], pivot[1], pivot[2]).by(w[0], w[1], w[2], degrees),
                        new Leaf(kindB, b, 0),
                        scratch.sweep);
        return share > 1
                ? null
                : "turned about %s through %s by %s: %s"
                        .formatted(Arrays.toString(w), Arrays.toString(pivot), degrees, share);
    }
}
