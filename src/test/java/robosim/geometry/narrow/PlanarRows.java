package robosim.geometry.narrow;

import java.util.Arrays;
import java.util.SplittableRandom;
import robosim.geometry.exact.Degrees;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.reference.PlanarTwin;
import robosim.geometry.reference.Truth.Form;

/** Rows of leaves for the tests of the planar kernels: of any kind, and of the awkward sort. */
public final class PlanarRows {
    public static final LeafKind[] EXACT_KINDS = {
        LeafKind.UPRIGHT_BOX, LeafKind.UPRIGHT_CYLINDER, LeafKind.SPHERE, LeafKind.BOX, LeafKind.TRIANGLE
    };

    private final SplittableRandom random;

    public PlanarRows(long seed) {
        random = new SplittableRandom(seed);
    }

    public SplittableRandom random() {
        return random;
    }

    public LeafKind exactKind() {
        return EXACT_KINDS[random.nextInt(EXACT_KINDS.length)];
    }

    /** A row with its middle within {@code spread} of the origin and sizes up to {@code size}. */
    public double[] row(LeafKind kind, double spread, double size) {
        double[] row = new double[Leaf.STRIDE];
        for (int k = 0; k < 3; k++) {
            row[k] = between(spread);
        }
        switch (kind) {
            case TRIANGLE -> {
                double[] middle = Arrays.copyOf(row, 3);
                for (int k = 0; k < 9; k++) {
                    row[k] = middle[k % 3] + between(size);
                }
                if (random.nextInt(8) == 0) {
                    System.arraycopy(row, 0, row, 3, 3);
                }
            }
            case PRISM -> prism(row, size);
            default -> {
                for (int k = 3; k < 6; k++) {
                    row[k] = random.nextInt(12) == 0 ? 0 : random.nextDouble() * size;
                }
                rotation(kind, row);
            }
        }
        return row;
    }

    private void prism(double[] row, double size) {
        double cx = row[0];
        double cz = row[2];
        Arrays.fill(row, 0);
        for (int k = 0; k < 10; k += 2) {
            row[k] = Double.POSITIVE_INFINITY;
            row[k + 1] = Double.NEGATIVE_INFINITY;
        }
        for (int k = 0; k < 6; k++) {
            double x = cx + between(size);
            double z = cz + between(size);
            double y = between(size);
            extend(row, 0, x);
            extend(row, 2, z);
            extend(row, 4, x + z);
            extend(row, 6, x - z);
            extend(row, 8, y);
        }
    }

    private static void extend(double[] row, int at, double value) {
        row[at] = Math.min(row[at], Math.nextDown(value));
        row[at + 1] = Math.max(row[at + 1], Math.nextUp(value));
    }

    private void rotation(LeafKind kind, double[] row) {
        if (kind == LeafKind.UPRIGHT_BOX || kind.isDisc()) {
            upright(row, random.nextInt(3) == 0 ? 90 * random.nextInt(4) : between(360));
            return;
        }
        System.arraycopy(Rows.rotation(random), 0, row, Leaf.ROTATION, 9);
    }

    public static void upright(double[] row, double heading) {
        double c = Degrees.cos(heading);
        double s = Degrees.sin(heading);
        double[] r = {c, 0, s, 0, 1, 0, -s, 0, c};
        System.arraycopy(r, 0, row, Leaf.ROTATION, 9);
    }

    /** On a grid of small integers, where touching is frequent and exact. */
    public double[] gridRow(LeafKind kind) {
        double[] row = new double[Leaf.STRIDE];
        for (int k = 0; k < 9; k++) {
            row[k] = random.nextInt(-4, 5);
        }
        if (kind == LeafKind.TRIANGLE) {
            return row;
        }
        for (int k = 3; k < 6; k++) {
            row[k] = random.nextInt(0, 4);
        }
        Arrays.fill(row, 6, 16, 0);
        if (kind == LeafKind.BOX && random.nextBoolean()) {
            rotation(kind, row);
        } else {
            upright(row, 90 * random.nextInt(4));
        }
        return row;
    }

    /** The same leaf, shifted. */
    public static double[] moved(LeafKind kind, double[] row, double x, double z) {
        double[] moved = row.clone();
        if (kind == LeafKind.PRISM) {
            throw new IllegalArgumentException("kind must not be an octagon (got: " + kind + ")");
        }
        int corners = kind == LeafKind.TRIANGLE ? 3 : 1;
        for (int k = 0; k < corners; k++) {
            moved[3 * k] += x;
            moved[3 * k + 2] += z;
        }
        return moved;
    }

    /** The same leaf in a world scaled by a power of two. */
    public static double[] scaled(LeafKind kind, double[] row, double factor) {
        double[] scaled = row.clone();
        int lengths = kind == LeafKind.TRIANGLE ? 9 : kind == LeafKind.PRISM ? 10 : 6;
        for (int k = 0; k < lengths; k++) {
            scaled[k] *= factor;
        }
        return scaled;
    }

    public double between(double size) {
        return (2 * random.nextDouble() - 1) * size;
    }

    /** The oracle's word for a kind. */
    public static Form form(LeafKind kind) {
        return Form.valueOf(kind.name());
    }

    /** The slow twin of any row. */
    public static PlanarTwin twin(LeafKind kind, double[] row) {
        return kind == LeafKind.PRISM ? PlanarTwin.octagon(row) : PlanarTwin.of(form(kind), row);
    }

    /** The twin of a point. */
    public static PlanarTwin point(double x, double z) {
        double[] row = new double[Leaf.STRIDE];
        row[0] = x;
        row[2] = z;
        return twin(LeafKind.SPHERE, row);
    }

    /** Whether two projections touch, by exact arithmetic. */
    public static boolean touch(LeafKind kindA, double[] a, LeafKind kindB, double[] b) {
        return PlanarTwin.touch(form(kindA), a, form(kindB), b);
    }
}
