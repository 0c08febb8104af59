package robosim.geometry.narrow;

import java.util.SplittableRandom;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.reference.PlanarTwin;
import robosim.geometry.reference.Truth;
import robosim.geometry.reference.Truth.Form;
import robosim.geometry.reference.Vectors;

/** Rows of leaves for tests. */
public final class Rows {
    private Rows() {}

    public static double[] box(double x, double y, double z, double hx, double hy, double hz, double[] r) {
        double[] row = new double[Leaf.STRIDE];
        row[0] = x;
        row[1] = y;
        row[2] = z;
        row[3] = hx;
        row[4] = hy;
        row[5] = hz;
        System.arraycopy(r, 0, row, Leaf.ROTATION, 9);
        return row;
    }

    public static double[] cylinder(double x, double y, double z, double radius, double halfHeight, double[] r) {
        double[] row = new double[Leaf.STRIDE];
        row[0] = x;
        row[1] = y;
        row[2] = z;
        row[3] = radius;
        row[4] = halfHeight;
        System.arraycopy(r, 0, row, Leaf.ROTATION, 9);
        return row;
    }

    public static double[] sphere(double x, double y, double z, double radius) {
        return new double[] {x, y, z, radius, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
    }

    public static double[] triangle(double... corners) {
        double[] row = new double[Leaf.STRIDE];
        System.arraycopy(corners, 0, row, 0, 9);
        return row;
    }

    public static double[] identity() {
        return new double[] {1, 0, 0, 0, 1, 0, 0, 0, 1};
    }

    /** The matrix of an upright attitude. */
    public static double[] yaw(double radians) {
        double c = StrictMath.cos(radians);
        double s = StrictMath.sin(radians);
        return new double[] {c, 0, s, 0, 1, 0, -s, 0, c};
    }

    /** A random rotation, from a quaternion. */
    public static double[] rotation(SplittableRandom random) {
        double a = random.nextDouble(-1, 1);
        double b = random.nextDouble(-1, 1);
        double c = random.nextDouble(-1, 1);
        double d = random.nextDouble(-1, 1);
        double n = Math.sqrt(a * a + b * b + c * c + d * d);
        if (n < 0.1) {
            return identity();
        }
        return Vectors.rotation(2, a / n, b / n, c / n, d / n);
    }

    /** A random leaf of a kind, of size about 1, with its centre in a cube of the given half width. */
    public static double[] random(LeafKind kind, SplittableRandom random, double spread) {
        double x = random.nextDouble(-spread, spread);
        double y = random.nextDouble(-spread, spread);
        double z = random.nextDouble(-spread, spread);
        double p = random.nextDouble(0.2, 1);
        double q = random.nextDouble(0.2, 1);
        double r = random.nextDouble(0.2, 1);
        return switch (kind) {
            case UPRIGHT_BOX -> box(x, y, z, p, q, r, yaw(random.nextDouble(-3, 3)));
            case BOX -> box(x, y, z, p, q, r, rotation(random));
            case UPRIGHT_CYLINDER, UPRIGHT_CAPSULE -> cylinder(x, y, z, p, q, identity());
            case CYLINDER, CAPSULE -> cylinder(x, y, z, p, q, rotation(random));
            case SPHERE -> sphere(x, y, z, p);
            case PRISM -> prism(x, y, z, p, q, r, random);
            case TRIANGLE -> {
                double[] corners = new double[9];
                for (int k = 0; k < 9; k += 3) {
                    corners[k] = x + random.nextDouble(-1, 1);
                    corners[k + 1] = y + random.nextDouble(-1, 1);
                    corners[k + 2] = z + random.nextDouble(-1, 1);
                }
                yield triangle(corners);
            }
            case MESH, SOLID_MESH, GRID -> throw kind.refused();
        };
    }

    private static double[] prism(double x, double y, double z, double p, double q, double r, SplittableRandom random) {
        double[] row = new double[Leaf.STRIDE];
        double s = random.nextDouble(Math.max(p, r), p + r);
        double d = random.nextDouble(Math.max(p, r), p + r);
        row[0] = x - p;
        row[1] = x + p;
        row[2] = z - r;
        row[3] = z + r;
        row[4] = x + z - s;
        row[5] = x + z + s;
        row[6] = x - z - d;
        row[7] = x - z + d;
        row[8] = y - q;
        row[9] = y + q;
        return row;
    }

    /** Whether two leaves have a point in common, by exact arithmetic. */
    public static boolean touch(LeafKind kindA, double[] a, LeafKind kindB, double[] b) {
        Form formA = Form.valueOf(kindA.name());
        Form formB = Form.valueOf(kindB.name());
        return PlanarTwin.exactly(number -> Truth.spatial(number, formA, a, formB, b));
    }
}
