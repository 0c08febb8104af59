package robosim.geometry.narrow;

import java.util.Arrays;
import java.util.SplittableRandom;
import robosim.geometry.exact.VectorMath;
import robosim.geometry.narrow.gjk.Gjk;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;

/**
 * Pairs of convex leaves in space that are nearly in contact, in every relation of features: boxes, cylinders, triangles
 * and spheres, some thin beside wide, some slivers, with attitudes that are the same, nearly the same, square to each
 * other or anything.
 */
public final class NearPairs {
    public static final LeafKind[] KINDS = {
        LeafKind.UPRIGHT_BOX,
        LeafKind.UPRIGHT_CYLINDER,
        LeafKind.SPHERE,
        LeafKind.BOX,
        LeafKind.CYLINDER,
        LeafKind.TRIANGLE
    };

    private final SplittableRandom random;
    private final Gjk gjk = new Gjk();

    public LeafKind kindA;
    public LeafKind kindB;
    public double[] a = {};
    public double[] b = {};

    /** The sum of the sizes of the two, centres included. */
    public double size;

    public NearPairs(SplittableRandom random) {
        this.random = random;
    }

    /** Makes a pair with a gap of about a share of their size; a few of them overlap or touch. */
    public void make(LeafKind kindOfA, LeafKind kindOfB, double gap) {
        kindA = kindOfA;
        kindB = kindOfB;
        double[] first = Rows.rotation(random);
        a = leaf(kindA, first);
        b = leaf(kindB, near(first));
        double apart = extent(kindA, a) + extent(kindB, b);
        double[] way = direction();
        // Along an axis of the first, features face each other.
        if (random.nextInt(3) == 0) {
            int axis = random.nextInt(3);
            way = new double[] {first[axis], first[3 + axis], first[6 + axis]};
        }
        shift(kindB, b, apart, way);
        if (random.nextInt(3) == 0) {
            shift(kindB, b, apart * random.nextDouble(-0.5, 0.5), direction());
        }
        for (int round = 0; round < 3; round++) {
            gjk.spatial(new Leaf(kindA, a, 0), new Leaf(kindB, b, 0));
            double[] n = {gjk.nx(), gjk.ny(), gjk.nz()};
            shift(kindB, b, gjk.reach() - gap * apart, n);
        }
        size = extent(kindA, a) + extent(kindB, b) + VectorMath.length(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
    }

    /** A gap as a share of the size, from 1e-13 to 1e-1; one in ten is none, or as deep. */
    public double gap() {
        double share = StrictMath.pow(10, random.nextDouble(-13, -1));
        return random.nextInt(10) > 0 ? share : random.nextInt(-1, 1) * share;
    }

    @Override
    public String toString() {
        return "%s %s with %s %s".formatted(kindA, Arrays.toString(a), kindB, Arrays.toString(b));
    }

    private double[] direction() {
        double[] r = Rows.rotation(random);
        return new double[] {r[0], r[3], r[6]};
    }

    /** An attitude: that of the first, a little off it, a quarter turn from it, or any. */
    private double[] near(double[] r) {
        int way = random.nextInt(4);
        if (way == 0) {
            return r.clone();
        }
        if (way == 1) {
            double angle = StrictMath.pow(10, random.nextDouble(-12, -2));
            return times(r, about(random.nextInt(3), StrictMath.cos(angle), StrictMath.sin(angle)));
        }
        if (way == 2) {
            return times(r, about(random.nextInt(3), StrictMath.cos(random.nextInt(1, 7)), StrictMath.sin(1)));
        }
        return Rows.rotation(random);
    }

    private static double[] about(int axis, double cosine, double sine) {
        double[] r = Rows.identity();
        int p = (axis + 1) % 3;
        int q = (axis + 2) % 3;
        double c = Math.sqrt(1 - sine * sine);
        r[4 * p] = Math.copySign(c, cosine);
        r[4 * q] = Math.copySign(c, cosine);
        r[3 * p + q] = -sine;
        r[3 * q + p] = sine;
        return r;
    }

    private static double[] times(double[] p, double[] q) {
        double[] out = new double[9];
        for (int i = 0; i < 3; i++) {
            for (int j = 0; j < 3; j++) {
                for (int k = 0; k < 3; k++) {
                    out[3 * i + j] += p[3 * i + k] * q[3 * k + j];
                }
            }
        }
        return out;
    }

    private double length() {
        return random.nextInt(5) == 0 ? StrictMath.pow(10, random.nextDouble(-6, 1)) : random.nextDouble(0.2, 1.5);
    }

    private double[] leaf(LeafKind kind, double[] r) {
        double p = length();
        double q = length();
        double s = length();
        return switch (kind) {
            case UPRIGHT_BOX -> Rows.box(0, 0, 0, p, q, s, Rows.yaw(random.nextInt(3) * random.nextDouble(-3, 3)));
            case BOX -> Rows.box(0, 0, 0, p, q, s, r);
            case UPRIGHT_CYLINDER -> Rows.cylinder(0, 0, 0, p, q, Rows.identity());
            case CYLINDER -> Rows.cylinder(0, 0, 0, p, q, r);
            case SPHERE -> Rows.sphere(0, 0, 0, p);
            case TRIANGLE, PRISM -> triangle(p, q, s, r);
            case UPRIGHT_CAPSULE, CAPSULE, MESH, SOLID_MESH, GRID -> throw kind.refused();
        };
    }

    /** In the plane of two columns of a rotation: a corner at the origin; a sliver where a size is small. */
    private double[] triangle(double p, double q, double s, double[] r) {
        int u = random.nextInt(3);
        int v = (u + 1) % 3;
        double[] corners = new double[9];
        for (int k = 0; k < 3; k++) {
            corners[3 + k] = p * r[3 * k + u];
            corners[6 + k] = (s - 0.5) * r[3 * k + u] + q * r[3 * k + v];
        }
        return Rows.triangle(corners);
    }

    private static double extent(LeafKind kind, double[] row) {
        if (kind == LeafKind.TRIANGLE) {
            return Math.max(
                    VectorMath.length(row[3] - row[0], row[4] - row[1], row[5] - row[2]),
                    VectorMath.length(row[6] - row[0], row[7] - row[1], row[8] - row[2]));
        }
        return switch (kind) {
            case SPHERE -> row[3];
            case CYLINDER, UPRIGHT_CYLINDER -> row[3] + row[4];
            case UPRIGHT_BOX, BOX, TRIANGLE, PRISM -> row[3] + row[4] + row[5];
            case UPRIGHT_CAPSULE, CAPSULE, MESH, SOLID_MESH, GRID -> throw kind.refused();
        };
    }

    private static void shift(LeafKind kind, double[] row, double by, double[] way) {
        for (int k = 0; k < (kind == LeafKind.TRIANGLE ? 9 : 3); k++) {
            row[k] += by * way[k % 3];
        }
    }
}
