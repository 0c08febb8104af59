package robosim.geometry.narrow;

import java.util.Arrays;
import java.util.SplittableRandom;
import robosim.geometry.exact.Rotations;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;

/** Random leaves and rays: general ones, and ones on a small grid where everything ties. */
public final class Leaves {
    /** The convex kinds. */
    public static final LeafKind[] KINDS = Arrays.stream(LeafKind.values())
            .filter(kind -> !kind.isMesh() && !kind.isGrid())
            .toArray(LeafKind[]::new);

    private Leaves() {}

    public static double[] random(LeafKind kind, SplittableRandom random, double size) {
        double[] row = new double[Leaf.STRIDE];
        for (int i = 0; i < 3; i++) {
            row[i] = random.nextDouble(-size, size);
            row[3 + i] = random.nextDouble(0.01, 1) * size;
        }
        switch (kind) {
            case UPRIGHT_BOX -> Rotations.yaw(random.nextDouble(-180, 180), 0, row, Leaf.ROTATION);
            case BOX, CYLINDER, CAPSULE -> turn(row, random.nextDouble(-180, 180), random.nextDouble(-180, 180));
            case TRIANGLE -> {
                for (int i = 3; i < 9; i++) {
                    row[i] = random.nextDouble(-size, size);
                }
            }
            case PRISM -> prism(row, random.nextDouble(0, 0.3) * size);
            default -> {}
        }
        return row;
    }

    /** Whole coordinates, turns by quarters and by the angle of the 3-4-5 triangle: nothing is rounded. */
    public static double[] grid(LeafKind kind, SplittableRandom random) {
        double[] row = new double[Leaf.STRIDE];
        for (int i = 0; i < 3; i++) {
            row[i] = random.nextInt(-3, 4);
            row[3 + i] = random.nextInt(0, 4);
        }
        switch (kind) {
            case UPRIGHT_BOX -> Rotations.yaw(90.0 * random.nextInt(4), 0, row, Leaf.ROTATION);
            case BOX, CYLINDER, CAPSULE -> turn(row, 90.0 * random.nextInt(4), 45.0 * random.nextInt(8));
            case TRIANGLE -> {
                for (int i = 3; i < 9; i++) {
                    row[i] = random.nextInt(-3, 4);
                }
            }
            case PRISM -> prism(row, random.nextInt(0, 3));
            default -> {}
        }
        return row;
    }

    private static void turn(double[] row, double ry, double rx) {
        Rotations.yaw(ry, 0, row, Leaf.ROTATION);
        Rotations.turnOwnX(row, Leaf.ROTATION, rx);
    }

    /** The octagon about the centre and half sizes that the row holds, its corners cut off by some length. */
    static void prism(double[] row, double cut) {
        double x = row[0];
        double y = row[1];
        double z = row[2];
        double w = row[3];
        double h = row[4];
        double l = row[5];
        double limit = w + l - Math.min(cut, Math.min(w, l));
        double[] numbers = {
            x - w, x + w, z - l, z + l, x + z - limit, x + z + limit, x - z - limit, x - z + limit, y - h, y + h
        };
        System.arraycopy(numbers, 0, row, 0, 10);
    }

    public static double[] vector(SplittableRandom random, double size) {
        return new double[] {
            random.nextDouble(-size, size), random.nextDouble(-size, size), random.nextDouble(-size, size)
        };
    }

    public static double[] gridVector(SplittableRandom random, int size) {
        return new double[] {
            random.nextInt(-size, size + 1), random.nextInt(-size, size + 1), random.nextInt(-size, size + 1)
        };
    }

    /** The largest coordinate or size in a row. */
    public static double extent(LeafKind kind, double[] row) {
        int numbers = kind == LeafKind.PRISM ? 10 : kind == LeafKind.TRIANGLE ? 9 : 6;
        double extent = 0;
        for (int i = 0; i < numbers; i++) {
            extent = Math.max(extent, Math.abs(row[i]));
        }
        return extent;
    }

    /** The row with all lengths times a power of two. */
    public static double[] scaled(LeafKind kind, double[] row, int power) {
        double[] copy = row.clone();
        int numbers = kind == LeafKind.PRISM ? 10 : kind == LeafKind.TRIANGLE ? 9 : 6;
        for (int i = 0; i < numbers; i++) {
            copy[i] = Math.scalb(row[i], power);
        }
        return copy;
    }
}
