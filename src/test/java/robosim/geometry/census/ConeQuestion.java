package robosim.geometry.census;

import java.util.Arrays;
import java.util.SplittableRandom;
import robosim.geometry.exact.BeamAxis;
import robosim.geometry.exact.Rotations;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.cone.SpatialCone;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.ray.SpatialRay;

/** A cone in space and a leaf, made up so that the cone's border comes near some place of the leaf. */
final class ConeQuestion {
    LeafKind kind;
    final double[] row = new double[Leaf.STRIDE];
    final double[] apex = new double[3];
    double[] way = new double[3];
    double half;
    double cos;

    private final Scratch scratch = new Scratch();

    ConeQuestion(LeafKind kind) {
        this.kind = kind;
    }

    /** What the product answers. */
    double ask() {
        return SpatialCone.distance(
                new BeamAxis()
                        .line(apex[0], apex[1], apex[2], way[0], way[1], way[2])
                        .widen(cos, StrictMath.sin(half)),
                kind,
                row,
                0,
                Double.POSITIVE_INFINITY,
                scratch.cone);
    }

    /** What the product answers for the ray along the cone's axis. */
    double ray() {
        return SpatialRay.distance(
                new BeamAxis().line(apex[0], apex[1], apex[2], way[0], way[1], way[2]), kind, row, 0, scratch.ray);
    }

    /** The upper end of the product's bracket. */
    double upper() {
        return SpatialCone.upperEnd(scratch.cone);
    }

    /** To paste into a test. */
    String paste(double answer, String truth) {
        return "kind %s, apex %s, way %s, half %s, row %s: %s, truth %s"
                .formatted(
                        kind, Arrays.toString(apex), Arrays.toString(way), half, Arrays.toString(row), answer, truth);
    }

    /** The largest coordinate or size. */
    double extent() {
        double largest = 0;
        for (int k = 0; k < 9; k++) {
            largest = Math.max(largest, k < 6 || kind == LeafKind.TRIANGLE ? Math.abs(row[k]) : 0);
        }
        for (double x : apex) {
            largest = Math.max(largest, Math.abs(x));
        }
        return largest;
    }

    void widen(double radians) {
        half = radians;
        cos = StrictMath.cos(half);
    }

    /** Takes the border to within a share of the half angle of a point, on a side chosen at random; off by 0 puts it there. */
    void aim(double[] point, double off, SplittableRandom random) {
        aim(point, off, direction(random), random);
    }

    /** The same on the side of a vector. */
    void aim(double[] point, double off, double[] side, SplittableRandom random) {
        double[] to = unit(point[0] - apex[0], point[1] - apex[1], point[2] - apex[2]);
        double[] aside = across(to, side);
        double angle = half * (1 + off);
        double length = random.nextBoolean() ? 1 : random.nextDouble(0.1, 10);
        for (int k = 0; k < 3; k++) {
            way[k] = length * (StrictMath.cos(angle) * to[k] + StrictMath.sin(angle) * aside[k]);
        }
    }

    /** Turns leaf, apex and way by one rotation, so that nothing is along the axes of space. */
    void turn(SplittableRandom random) {
        double[] r = new double[9];
        double[] work = new double[Leaf.STRIDE];
        Rotations.yaw(random.nextDouble(-180, 180), 0, work, 0);
        Rotations.turnOwnX(work, 0, random.nextInt(3) == 0 ? 90.0 * random.nextInt(4) : random.nextDouble(-180, 180));
        System.arraycopy(work, 0, r, 0, 9);
        rotate(r, apex, 0);
        rotate(r, way, 0);
        if (kind == LeafKind.TRIANGLE) {
            for (int k = 0; k < 9; k += 3) {
                rotate(r, row, k);
            }
        } else {
            rotate(r, row, 0);
            System.arraycopy(r, 0, row, Leaf.ROTATION, 9);
        }
    }

    private static void rotate(double[] r, double[] v, int at) {
        double x = v[at];
        double y = v[at + 1];
        double z = v[at + 2];
        for (int k = 0; k < 3; k++) {
            v[at + k] = r[3 * k] * x + r[3 * k + 1] * y + r[3 * k + 2] * z;
        }
    }

    private static double[] across(double[] u, double[] v) {
        double along = u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
        return unit(v[0] - along * u[0], v[1] - along * u[1], v[2] - along * u[2]);
    }

    static double[] direction(SplittableRandom random) {
        return unit(random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1));
    }

    static double[] unit(double x, double y, double z) {
        double length = Math.sqrt(x * x + y * y + z * z);
        return length > 0 ? new double[] {x / length, y / length, z / length} : new double[] {1, 0, 0};
    }
}
