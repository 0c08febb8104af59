package robosim.geometry.narrow.mesh;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.exact.BeamAxis;
import robosim.geometry.exact.VectorMath;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.MeshObject;
import robosim.geometry.narrow.Cast;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.cone.PlanarCone;
import robosim.geometry.narrow.cone.SpatialCone;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.leaf.LocalLeaves;
import robosim.geometry.narrow.leaf.UnderflowScaling;
import robosim.geometry.narrow.ray.PlanarRay;

/** Planar rays and cones through a mesh's tree against every triangle of it, one by one. */
class MeshBeamSearchTest {
    private static final int BEAMS = 40;
    private static final double INFINITE = Double.POSITIVE_INFINITY;

    private final Scratch scratch = new Scratch();
    private final Cast cast = new Cast(scratch);

    @ParameterizedTest
    @EnumSource
    void planarRaysFindWhatTheListFinds(MeshRayTest.Family family) {
        compare(family, Dimension.PLANAR, false);
    }

    @ParameterizedTest
    @EnumSource
    void planarConesFindWhatTheListFinds(MeshRayTest.Family family) {
        compare(family, Dimension.PLANAR, true);
    }

    @ParameterizedTest
    @EnumSource
    void conesFindWhatTheListFinds(MeshRayTest.Family family) {
        compare(family, Dimension.SPATIAL, true);
    }

    private void compare(MeshRayTest.Family family, Dimension dimension, boolean isCone) {
        SplittableRandom random = new SplittableRandom(719 + family.ordinal());
        int hits = 0;
        int beams = 0;
        for (int trial = 0; trial < 10; trial++) {
            MeshObject mesh = MeshRayTest.placed(family.mesh(random), trial % 5, family.size(), random);
            if (trial == 6) {
                double cos = StrictMath.cos(trial);
                double sin = StrictMath.sin(trial);
                mesh = mesh.oriented(new double[] {cos, 0, sin, 0, 1, 0, -sin, 0, cos}); // upright
            }
            LeafColumn column = LocalLeaves.placed(mesh);
            double[][] rows = MeshRayTest.rows(column);
            for (int k = 0; k < BEAMS; k++) {
                double[] ray = beam(rows, k, dimension, family.size(), random);
                cast.line(dimension, ray[0], ray[1], ray[2], ray[3], ray[4], ray[5]);
                double half = StrictMath.toRadians(half(k, random));
                if (isCone) {
                    if (random.nextBoolean()) {
                        tilt(ray, half, dimension);
                        cast.line(dimension, ray[0], ray[1], ray[2], ray[3], ray[4], ray[5]);
                    }
                    cast.beam.widen(StrictMath.cos(half), StrictMath.sin(half));
                }
                String what = mesh + " seen along " + Arrays.toString(ray) + (isCone ? ", half " + half : "");
                int nearest = -1;
                double least = INFINITE;
                for (int t = 0; t < rows.length; t++) {
                    double distance = alone(rows[t], ray, dimension, isCone, half);
                    if (distance < least) {
                        least = distance;
                        nearest = t;
                    }
                }
                assertThat(cast.distance(column, 0, INFINITE)).as(what).isEqualTo(least);
                assertThat(cast.face(column, 0, cast.piece())).as(what).isEqualTo(nearest);
                if (nearest >= 0) {
                    // What is as near as the limit still counts; beyond it nothing has to.
                    assertThat(cast.distance(column, 0, least)).as(what).isEqualTo(least);
                    assertThat(cast.face(column, 0, cast.piece())).as(what).isEqualTo(nearest);
                    assertThat(cast.distance(column, 0, least / 2)).as(what).isGreaterThanOrEqualTo(least);
                    hits++;
                }
                beams++;
            }
        }
        assertThat(hits).isBetween(beams / 20, beams - 1);
    }

    /** From all but nothing to all but a right angle. */
    private static double half(int way, SplittableRandom random) {
        return switch (way % 6) {
            case 0 -> random.nextDouble(1, 20);
            case 1 -> 45;
            case 2 -> random.nextDouble(20, 90);
            case 3 -> 1e-6 * random.nextDouble(0.1, 1);
            case 4 -> 0.1;
            default -> 90 - 1e-7;
        };
    }

    private static double[] beam(double[][] rows, int way, Dimension dimension, double size, SplittableRandom random) {
        double[] ray = MeshRayTest.ray(rows, way, size, random);
        if (way % 4 == 0) { // anywhere about, so that some miss
            for (int axis = 0; axis < 3; axis++) {
                ray[axis] += random.nextDouble(-30, 30) * size;
                ray[3 + axis] = random.nextDouble(-1, 1);
            }
        }
        if (dimension == Dimension.PLANAR && ray[3] == 0 && ray[5] == 0) {
            ray[3] = 1;
        }
        return ray;
    }

    /** Turns the axis by the half angle, so that what it was aimed at lies on the border, but for rounding. */
    private static void tilt(double[] ray, double half, Dimension dimension) {
        double level = dimension == Dimension.PLANAR ? 0 : ray[4];
        double length = Math.sqrt(ray[3] * ray[3] + level * level + ray[5] * ray[5]);
        double x = ray[3] / length;
        double y = level / length;
        double z = ray[5] / length;
        double across = Math.sqrt(x * x + z * z);
        if (!(across > 0)) {
            return;
        }
        double sin = StrictMath.sin(half);
        double cos = StrictMath.cos(half);
        ray[3] = x * cos - z / across * sin;
        ray[4] = y * cos;
        ray[5] = z * cos + x / across * sin;
    }

    /** The triangle through the kernel alone. */
    private double alone(double[] row, double[] ray, Dimension dimension, boolean isCone, double half) {
        UnderflowScaling m = new UnderflowScaling();
        double height = dimension == Dimension.PLANAR ? 0 : ray[1];
        if (!m.take(dimension, VectorMath.largest(ray[0], height, ray[2]), LeafKind.TRIANGLE, row, 0)) {
            return kernel(row, ray[0], ray[1], ray[2], dimension, isCone, half);
        }
        return m.down(kernel(m.a, m.up(ray[0]), m.up(ray[1]), m.up(ray[2]), dimension, isCone, half));
    }

    private double kernel(
            double[] row, double x, double y, double z, Dimension dimension, boolean isCone, double half) {
        double cos = StrictMath.cos(half);
        double sin = StrictMath.sin(half);
        BeamAxis beam = new BeamAxis();
        if (dimension == Dimension.SPATIAL) {
            beam.from(cast.beam, x, y, z).widen(cos, sin);
            return SpatialCone.distance(beam, LeafKind.TRIANGLE, row, 0, Double.POSITIVE_INFINITY, scratch.cone);
        }
        beam.from(cast.beam, x, 0, z);
        return isCone
                ? PlanarCone.distance(
                        beam.widen(cos, sin), LeafKind.TRIANGLE, row, 0, Double.POSITIVE_INFINITY, scratch.cone)
                : PlanarRay.distance(beam, LeafKind.TRIANGLE, row, 0, scratch.ray);
    }
}
