package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.Effort;
import robosim.geometry.Geometry;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;
import robosim.geometry.model.SphereObject;

/** What a cone in space must not hear, and what it must. */
class ConeTest {
    private static final double INFINITE = Double.POSITIVE_INFINITY;

    /** The foot on the cap is outside the cone: the border that leans most towards the cap tells. */
    @Test
    void aCapOutsideTheConeIsNotHeard() {
        GeometryObject floor = new CylinderObject(new Point(0, -0.5, 0), 1, 1);
        double truth = 0.0625 / Math.sin(Math.PI / 4 - Math.asin(1 / Math.sqrt(3)));
        assertThat(heard(floor, new Point(0.5, 0.0625, 0), new Point(1, 1, 1), 90))
                .isCloseTo(truth, within(truth * 0x1p-40));
    }

    @Test
    void aMantleOutsideTheConeIsNotHeard() {
        GeometryObject bar = new CylinderObject(new Point(0, 0, 0), 0.1, 2);
        assertThat(heard(bar, new Point(0, -0.3, 0.11), new Point(-0.75, 0.5, 0.433), 90))
                .isCloseTo(0.05817, within(1e-5));
        assertThat(heard(bar.turned(90, 0), new Point(0.6, 0, -0.7), new Point(-0.837, -0.5, 0.224), 30))
                .isInfinite();
    }

    /** A line through a point hears it; a cone of however little width about that line does too. */
    @Test
    void aConeHearsWhatItsAxisHits() {
        GeometryObject point = new SphereObject(new Point(1, 3, 0), 0);
        for (double width : new double[] {0, 1e-300, 1e-9, 1e-6, 2e-6, 1e-3, 1}) {
            assertThat(heard(point, new Point(), new Point(1, 3, 0), width))
                    .as("width %s", width)
                    .isCloseTo(Math.sqrt(10), within(1e-15));
        }
        SplittableRandom random = new SplittableRandom(241);
        for (int k = 0; k < Effort.cases(2_000); k++) {
            Point way = new Point(random.nextInt(-9, 10), random.nextInt(1, 10), random.nextInt(-9, 10));
            double x = way.x() * 2;
            double y = way.y() * 2;
            double z = way.z() * 2;
            GeometryObject target = switch (k % 5) {
                case 0 -> new SphereObject(new Point(x, y, z), 0);
                case 1 -> new BoxObject(new Point(x, y, z), 0, 0, 0);
                case 2 -> new CylinderObject(new Point(x, y, z), 0, 0);
                case 3 -> new CylinderObject(new Point(x, y, z), 0, 1).turned(90.0 * (k % 4), 90.0 * (k % 3));
                default ->
                    new MeshObject(
                            List.of(new Point(x, y, z), new Point(x, y, z), new Point(x, y, z)),
                            new int[][] {{0, 1, 2}});
            };
            double line = heard(target, new Point(), way, 0);
            double cone = heard(target, new Point(), way, StrictMath.pow(10, -random.nextDouble(2, 8)));
            assertThat(line).isFinite();
            assertThat(cone)
                    .as(target + " towards " + way)
                    .isBetween(k % 5 == 3 ? 0.9 * line : line * (1 - 0x1p-40), line);
        }
    }

    /**
     * Whole directions and corners exactly 60 degrees apart, so that the corner is on the border of a cone of 120 degrees:
     * it is heard, whichever way the axes are named and pointed. A cone an ulp narrower does not hear it.
     */
    @Test
    void whatIsOnTheBorderIsHeardFromEverySide() {
        int found = 0;
        int[][] whole = new int[9261][];
        Arrays.setAll(whole, n -> new int[] {n % 21 - 10, n / 21 % 21 - 10, n / 441 - 10});
        int[] square = Arrays.stream(whole)
                .mapToInt(v -> v[0] * v[0] + v[1] * v[1] + v[2] * v[2])
                .toArray();
        int every = 53 * Effort.stride(4);
        for (int n = 0; n < 9261 * 9261; n++) {
            int[] p = whole[n / 9261];
            int[] d = whole[n % 9261];
            int dp = d[0] * p[0] + d[1] * p[1] + d[2] * p[2];
            if (dp <= 0 || 4 * dp * dp != square[n / 9261] * square[n % 9261] || found++ % every > 0) {
                continue;
            }
            Point way = new Point(d[0], d[1], d[2]);
            Point corner = new Point(p[0], p[1], p[2]);
            double distance = Math.sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
            // The triangle's other corners are farther from the axis.
            Point far = new Point(3.0 * p[0] - d[0], 3.0 * p[1] - d[1], 3.0 * p[2] - d[2]);
            for (GeometryObject target : List.of(
                    new SphereObject(corner, 0),
                    new BoxObject(corner, 0, 0, 0),
                    new MeshObject(List.of(corner, corner, far), new int[][] {{0, 1, 2}}))) {
                String name = target + " towards " + way;
                assertThat(heard(target, new Point(), way, 120))
                        .as(name)
                        .isCloseTo(distance, within(4 * Math.ulp(distance)));
                assertThat(heard(target, new Point(), way, Math.nextDown(119.99999999999999)))
                        .as(name)
                        .isInfinite();
            }
        }
        assertThat(found).isGreaterThan(10_000);
    }

    private static double heard(GeometryObject object, Point from, Point to, double width) {
        Geometry geometry = new Geometry(100, 100, 100);
        assertThat(geometry.addObjectUnchecked(object)).isTrue();
        return geometry.getRayDistance(new Ray(from, to), 0, INFINITE, width);
    }
}
