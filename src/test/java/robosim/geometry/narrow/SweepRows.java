package robosim.geometry.narrow;

import java.util.SplittableRandom;
import robosim.geometry.exact.Rotations;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;

/** Rows for the tests: leaves of every kind, random and given. */
public final class SweepRows {
    private SweepRows() {}

    public static double[] uprightBox(double x, double y, double z, double hx, double hy, double hz, double yaw) {
        double[] row = new double[Leaf.STRIDE];
        fill(row, x, y, z, hx, hy, hz);
        Rotations.yaw(yaw, 0, row, Leaf.ROTATION);
        return row;
    }

    public static double[] box(
            double x, double y, double z, double hx, double hy, double hz, double yaw, double pitch, double more) {
        double[] row = uprightBox(x, y, z, hx, hy, hz, yaw);
        Rotations.turnOwnX(row, Leaf.ROTATION, pitch);
        Rotations.turnOwnY(row, Leaf.ROTATION, more);
        return row;
    }

    public static double[] cylinder(
            double x, double y, double z, double r, double h, double yaw, double pitch, double more) {
        double[] row = box(x, y, z, r, h, 0, yaw, pitch, more);
        return row;
    }

    public static double[] disc(double x, double y, double z, double r, double h) {
        double[] row = new double[Leaf.STRIDE];
        fill(row, x, y, z, r, h, 0);
        return row;
    }

    public static double[] triangle(double... corners) {
        double[] row = new double[Leaf.STRIDE];
        System.arraycopy(corners, 0, row, 0, 9);
        return row;
    }

    /** The prism around a few points. */
    static double[] prism(double... points) {
        double[] row = new double[Leaf.STRIDE];
        for (int k = 0; k < 10; k += 2) {
            row[k] = Double.POSITIVE_INFINITY;
            row[k + 1] = Double.NEGATIVE_INFINITY;
        }
        for (int k = 0; k < points.length; k += 3) {
            double[] reach = {
                points[k], points[k + 2], points[k] + points[k + 2], points[k] - points[k + 2], points[k + 1]
            };
            for (int m = 0; m < 5; m++) {
                row[2 * m] = Math.min(row[2 * m], Math.nextDown(reach[m]));
                row[2 * m + 1] = Math.max(row[2 * m + 1], Math.nextUp(reach[m]));
            }
        }
        return row;
    }

    /** A leaf of a kind, of sizes up to 1, its centre within {@code spread} of the origin. */
    public static double[] random(LeafKind kind, double spread, SplittableRandom random) {
        double x = random.nextDouble(-spread, spread);
        double y = random.nextDouble(-spread, spread);
        double z = random.nextDouble(-spread, spread);
        double p = random.nextDouble(0.05, 1);
        double q = random.nextDouble(0.05, 1);
        double r = random.nextDouble(0.05, 1);
        double yaw = random.nextDouble(-180, 180);
        double pitch = random.nextDouble(-180, 180);
        double more = random.nextDouble(-180, 180);
        return switch (kind) {
            case UPRIGHT_BOX -> uprightBox(x, y, z, p, q, r, yaw);
            case BOX -> box(x, y, z, p, q, r, yaw, pitch, more);
            case UPRIGHT_CYLINDER, UPRIGHT_CAPSULE, SPHERE -> disc(x, y, z, p, kind == LeafKind.SPHERE ? 0 : q);
            case CYLINDER, CAPSULE -> cylinder(x, y, z, p, q, yaw, pitch, more);
            case TRIANGLE -> triangle(points(x, y, z, 3, random));
            case PRISM -> prism(points(x, y, z, 6, random));
            case MESH, SOLID_MESH, GRID -> throw kind.refused();
        };
    }

    private static double[] points(double x, double y, double z, int count, SplittableRandom random) {
        double[] points = new double[3 * count];
        for (int k = 0; k < points.length; k += 3) {
            points[k] = x + random.nextDouble(-1, 1);
            points[k + 1] = y + random.nextDouble(-1, 1);
            points[k + 2] = z + random.nextDouble(-1, 1);
        }
        return points;
    }

    private static void fill(double[] row, double... values) {
        System.arraycopy(values, 0, row, 0, 6);
    }
}
