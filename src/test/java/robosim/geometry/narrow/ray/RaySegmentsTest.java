package robosim.geometry.narrow.ray;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import robosim.geometry.exact.BeamAxis;
import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.normal.Normals;

/** Triangles that are segments, and rays along their own lines: whichever corners coincide, at any magnitude. */
class RaySegmentsTest {
    private final Scratch scratch = new Scratch();
    private final double[] normal = new double[3];

    /** A segment from a to b as each of the triangles that it can be. */
    private static double[][] triangles(double[] a, double[] b) {
        double[] middle = {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
        double[][][] corners = {{a, b, b}, {a, a, b}, {b, a, b}, {a, middle, b}, {b, a, middle}};
        double[][] rows = new double[corners.length][16];
        for (int k = 0; k < corners.length; k++) {
            for (int corner = 0; corner < 3; corner++) {
                System.arraycopy(corners[k][corner], 0, rows[k], 3 * corner, 3);
            }
        }
        return rows;
    }

    private double ray(double[] from, double[] way, double[] row) {
        return SpatialRay.distance(
                new BeamAxis().line(from[0], from[1], from[2], way[0], way[1], way[2]),
                LeafKind.TRIANGLE,
                row,
                0,
                scratch.ray);
    }

    private static double[] at(double unit, double share) {
        return new double[] {2 * share * unit, 3 * share * unit, 6 * share * unit};
    }

    /** The direction is (2, 3, 6), 7 long; the segment goes from once to three times that. */
    @ParameterizedTest
    @ValueSource(doubles = {1, 0x1p-300, 0x1p-520, 0x1p90})
    void alongTheSegmentItsNearerEndIsMet(double unit) {
        double[] there = at(unit, 1);
        double[] back = at(unit, -1);
        for (double[] row : triangles(at(unit, 1), at(unit, 3))) {
            assertThat(ray(at(unit, 0), there, row)).isEqualTo(7 * unit);
            assertThat(ray(at(unit, 8), back, row)).isEqualTo(35 * unit);
            assertThat(ray(at(unit, 0), back, row)).isInfinite();
            assertThat(ray(at(unit, 4), there, row)).isInfinite();
            for (double inside : new double[] {1, 1.5, 3}) {
                assertThat(ray(at(unit, inside), there, row)).isZero();
                assertThat(ray(at(unit, inside), back, row)).isZero();
            }
            // Beside the line by the least that there is, and parallel to it.
            double[] beside = at(unit, 0);
            beside[0] = unit * 0x1p-50;
            assertThat(ray(beside, there, row)).isInfinite();
            // Across it, from one side.
            double[] across = at(unit, 2);
            across[1] -= unit;
            assertThat(ray(across, new double[] {0, unit, 0}, row)).isEqualTo(unit);
        }
    }

    /** Seen from above too; an end faces along the segment, a side across it. */
    @ParameterizedTest
    @ValueSource(doubles = {1, 0x1p-100, 0x1p60})
    void aSegmentsEndsFaceAlongIt(double unit) {
        double[] a = {unit, 0, unit};
        double[] b = {unit, 0, 5 * unit};
        for (double[] row : triangles(a, b)) {
            facing(a, new double[] {0, 0, 4}, row, 0, -1);
            facing(b, new double[] {0, 0, -4}, row, 0, 1);
            double[] middle = {unit, 0, 3 * unit};
            facing(middle, new double[] {4, 0, 0}, row, -1, 0);
            facing(middle, new double[] {-4, 0, 1}, row, 1, 0);
        }
        double[] c = {7 * unit, 0, unit};
        for (double[] row : triangles(a, c)) {
            facing(a, new double[] {2, 0, 0}, row, -1, 0);
            facing(c, new double[] {-2, 0, 0}, row, 1, 0);
        }
    }

    private void facing(double[] p, double[] way, double[] row, double x, double z) {
        new Normals()
                .at(
                        new BeamAxis().line(p[0], p[1], p[2], way[0], way[1], way[2]),
                        0,
                        LeafKind.TRIANGLE,
                        row,
                        0,
                        normal,
                        Dimension.PLANAR);
        assertThat(normal).containsExactly(new double[] {x, 0, z}, within(1e-15));
    }

    /** A capsule that lies along Z at (1, 2, 3), seen from above: its side, its end, and 3, 4, 5 past its end. */
    @ParameterizedTest
    @ValueSource(doubles = {1, 0x1p-300, 0x1p60})
    void aLyingCapsuleIsMetFromAbove(double unit) {
        double[] row = {unit, 2 * unit, 3 * unit, unit, 2 * unit, 0, 1, 0, 0, 0, 0, -1, 0, 1, 0, 0};
        assertThat(level(5 * unit, 4 * unit, -1, 0, row)).isEqualTo(3 * unit);
        assertThat(level(unit, 10 * unit, 0, -2, row)).isEqualTo(4 * unit);
        assertThat(level(5 * unit, 5.6 * unit, -1, 0, row)).isCloseTo(3.2 * unit, within(0x1p-50 * unit));
        assertThat(level(5 * unit, 6 * unit, -1, 0, row)).as("tangent").isEqualTo(4 * unit);
        assertThat(level(5 * unit, Math.nextUp(6 * unit), -1, 0, row)).isInfinite();
        assertThat(level(5 * unit, 4 * unit, 1, 0, row)).isInfinite();
        assertThat(level(1.5 * unit, 1.5 * unit, 1, 0, row)).isZero();
    }

    private double level(double x, double z, double wayX, double wayZ, double[] row) {
        return PlanarRay.distance(new BeamAxis().line(x, 0, z, wayX, 0, wayZ), LeafKind.CAPSULE, row, 0, scratch.ray);
    }

    /** A capsule that happens to stand upright is a disc as seen from above. */
    @ParameterizedTest
    @ValueSource(doubles = {1, -1})
    void aCapsuleOnEndHasADiscsNormals(double up) {
        double[] row = {1, 2, 3, 5, 2, 0, 1, 0, 0, 0, up, 0, 0, 0, up, 0};
        new Normals()
                .at(new BeamAxis().line(4, 9, 7, -3, 0, -4), 0, LeafKind.CAPSULE, row, 0, normal, Dimension.PLANAR);
        assertThat(normal).containsExactly(new double[] {0.6, 0, 0.8}, within(1e-15));
    }
}
