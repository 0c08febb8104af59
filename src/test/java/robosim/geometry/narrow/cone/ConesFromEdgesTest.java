package robosim.geometry.narrow.cone;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.TreeMap;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.Effort;
import robosim.geometry.Geometry;
import robosim.geometry.exact.Degrees;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;

/**
 * Cones in space whose apex is as near to an edge, a corner or the plane of a triangle as doubles come, against decimals: whether
 * the triangle echoes is exact, and the distance within 8 ulp of the largest coordinate.
 */
@Tag("slow")
class ConesFromEdgesTest {
    private static final double ULPS = 8;

    /** Where the apex is, but for the rounding of its coordinates. */
    enum Place {
        EDGE,
        CORNER,
        FACE,
        BESIDE_AN_EDGE,
        PLANE
    }

    @ParameterizedTest
    @EnumSource(Place.class)
    void asNearAsDoublesCome(Place place) {
        SplittableRandom random = new SplittableRandom(3606 + place.ordinal());
        Map<String, Integer> regimes = new TreeMap<>();
        int cases = Effort.cases(2_400, 500);
        for (int k = 0; k < cases; k++) {
            double[] corners = triangle(random, k % 3 == 2);
            double[] apex = apex(random, corners, place);
            double[] way = {random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1)};
            if (k % 4 == 3) { // along the edge, or nearly
                for (int i = 0; i < 3; i++) {
                    way[i] = corners[3 + i] - corners[i] + random.nextDouble(-0.2, 0.2);
                }
            }
            double width = k % 5 == 0 ? random.nextDouble(0.5, 5) : random.nextDouble(5, 178);
            regimes.merge(check(corners, apex, way, width), 1, Integer::sum);
        }
        assertThat(regimes.get("silent")).isGreaterThan(cases / 20);
        assertThat(regimes.values().stream().mapToInt(Integer::intValue).sum() - regimes.get("silent"))
                .isGreaterThan(cases / 4);
    }

    /** Whether it echoes, and how far away; the feature that holds the nearest point. */
    private String check(double[] corners, double[] apex, double[] way, double width) {
        DecimalCone decimal = new DecimalCone(way, Degrees.cos(width / 2));
        double truth = decimal.distance(corners, apex);
        double distance = heard(corners, apex, way, width);
        String what = Arrays.toString(corners) + " " + Arrays.toString(apex) + " " + Arrays.toString(way) + " " + width;
        if (decimal.feature == null) {
            assertThat(distance).as(what).isInfinite();
            return "silent";
        }
        double largest = truth;
        for (double number : corners) {
            largest = Math.max(largest, Math.abs(number));
        }
        double off = Math.abs(distance - truth) / Math.ulp(largest);
        assertThat(off).as(what + ": " + distance + " for " + truth).isLessThanOrEqualTo(ULPS);
        return decimal.feature;
    }

    private static double[] triangle(SplittableRandom random, boolean isSliver) {
        double[] corners = new double[9];
        for (int k = 0; k < 9; k++) {
            corners[k] = random.nextDouble(-3, 3);
        }
        if (isSliver) {
            double t = random.nextDouble(-0.5, 1.5);
            double thin = StrictMath.pow(10, random.nextDouble(-14, -3));
            for (int k = 0; k < 3; k++) {
                corners[6 + k] = corners[k] + t * (corners[3 + k] - corners[k]) + thin * corners[6 + k];
            }
        }
        return corners;
    }

    private static double[] apex(SplittableRandom random, double[] corners, Place place) {
        double s = place == Place.CORNER ? 0 : random.nextDouble();
        double t = place == Place.FACE ? random.nextDouble(1 - s) : place == Place.PLANE ? random.nextDouble(-1, 1) : 0;
        int shift = place == Place.BESIDE_AN_EDGE ? random.nextInt(-50, 0) : -60;
        double[] apex = new double[3];
        for (int k = 0; k < 3; k++) {
            apex[k] = corners[k]
                    + s * (corners[3 + k] - corners[k])
                    + t * (corners[6 + k] - corners[k])
                    + Math.scalb(random.nextDouble(-1, 1), shift);
            if (place == Place.CORNER) {
                apex[k] += random.nextInt(-1, 2) * Math.ulp(apex[k]);
            }
        }
        return apex;
    }

    /** Boxes whose corners are doubles, as the triangles of their faces. */
    @Test
    void boxesAsNearAsDoublesCome() {
        SplittableRandom random = new SplittableRandom(36061);
        int[] counts = new int[3];
        int cases = Effort.cases(600, 150);
        for (int k = 0; k < cases; k++) {
            double[] center = new double[3];
            double[] half = new double[3];
            double[] apex = new double[3];
            boolean isInside = true;
            int free = random.nextInt(3);
            for (int i = 0; i < 3; i++) {
                center[i] = random.nextInt(-32, 33) / 16.0;
                half[i] = random.nextInt(1, 17) / 16.0;
                double side = i == free ? random.nextDouble(-1, 1) : random.nextBoolean() ? 1 : -1;
                apex[i] = center[i] + side * half[i];
                apex[i] += random.nextInt(-1, 2) * Math.ulp(apex[i]);
                isInside &= apex[i] <= center[i] + half[i] && apex[i] >= center[i] - half[i];
            }
            double[] way = {random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1)};
            double width = random.nextDouble(5, 178);
            DecimalCone decimal = new DecimalCone(way, Degrees.cos(width / 2));
            double truth = isInside ? 0 : Double.POSITIVE_INFINITY;
            for (int face = 0; face < 12 && !isInside; face++) {
                truth = Math.min(truth, decimal.distance(faceOfBox(center, half, face), apex));
            }
            double distance =
                    heard(new BoxObject(point(center, 0), 2 * half[0], 2 * half[1], 2 * half[2]), apex, way, width);
            String what = Arrays.toString(center) + Arrays.toString(half) + Arrays.toString(apex) + Arrays.toString(way)
                    + width + ": " + distance + " for " + truth;
            assertThat(distance < Double.POSITIVE_INFINITY).as(what).isEqualTo(truth < Double.POSITIVE_INFINITY);
            if (truth < Double.POSITIVE_INFINITY) {
                assertThat(distance).as(what).isCloseTo(truth, within(ULPS * Math.ulp(4.0)));
            }
            counts[truth == 0 ? 0 : truth < Double.POSITIVE_INFINITY ? 1 : 2]++;
        }
        assertThat(counts[0]).isGreaterThan(cases / 10);
        assertThat(counts[1]).isGreaterThan(cases / 10);
        assertThat(counts[2]).isGreaterThan(cases / 20);
    }

    /** One of two triangles of each face of a box, nine numbers. */
    private static double[] faceOfBox(double[] center, double[] half, int face) {
        int axis = face / 4;
        double[] corners = new double[9];
        for (int k = 0; k < 3; k++) {
            int corner = face % 2 == 0 ? k : k + 1; // 0 1 2 and 1 2 3, as bits
            corners[3 * k + axis] = center[axis] + (face / 2 % 2 == 0 ? half[axis] : -half[axis]);
            for (int bit = 0; bit < 2; bit++) {
                int other = (axis + 1 + bit) % 3;
                corners[3 * k + other] = center[other] + ((corner >> bit & 1) == 0 ? -half[other] : half[other]);
            }
        }
        return corners;
    }

    /** The edge passes the apex at 10^-17, inside the cone. */
    @Test
    void anEdgeAsNearToTheApexAsAFractionOfAnUlp() {
        double[] triangle = {
            1.0193884152773656,
            -1.2189359778849305,
            -0.21542028824241494,
            -0.5456733478099882,
            0.8212359056290761,
            -0.40502257616236487,
            4.138394044565828,
            -6.228264207293549,
            3.0716966914951818
        };
        double[] way = {0.8061344840070944, -0.4887653662019993, -0.582679189209772};
        for (double width : new double[] {90, 100, 101.52176626774181, 110}) {
            check(triangle, new double[3], way, width);
            assertThat(heard(triangle, new double[3], way, width)).isLessThan(1e-16);
        }
    }

    @Test
    void aSliverAtTheApex() {
        double[] sliver = {
            -0.5211450056034367,
            -0.8855827968799123,
            -1.5572237330154188,
            0.13364683651271747,
            0.22710634895431633,
            0.39934763571294996,
            0.13364683679312073,
            0.22710634899851087,
            0.3993476361837236
        };
        double[] way = {-0.8831775380789649, 0.01661029938425083, -0.30239269068348895};
        assertThat(heard(sliver, new double[3], way, 67.55370551714971)).isCloseTo(1.1060738897617E-14, within(1e-26));
    }

    @Test
    void aSliverInANarrowCone() {
        double[] sliver = {
            1.9752685873301965E-9,
            388.95282617423436,
            -4.193483299816692E-9,
            1.9752685873301965E-9,
            -1385.5786017658904,
            -4.193483299816692E-9,
            -7.033809590714822E-9,
            -1385.578601850621,
            1.4938115991738486E-8
        };
        double[] way = {3.6251127853923126E-14, -1.0000000000000049, -2.316061465653011E-14};
        assertThat(heard(sliver, new double[3], way, 0.08066344440074072))
                .isCloseTo(8.6822360969940877E-10, within(1e-21));
    }

    private static double heard(double[] corners, double[] apex, double[] way, double width) {
        List<Point> vertices = List.of(point(corners, 0), point(corners, 3), point(corners, 6));
        return heard(new MeshObject(vertices, new int[][] {{0, 1, 2}}), apex, way, width);
    }

    private static double heard(GeometryObject object, double[] apex, double[] way, double width) {
        Geometry geometry = new Geometry(1e9, 1e9, 1e9);
        assertThat(geometry.addObjectUnchecked(object)).isTrue();
        return geometry.getRayDistance(new Ray(point(apex, 0), point(way, 0)), 0, Double.POSITIVE_INFINITY, width);
    }

    private static Point point(double[] numbers, int at) {
        return new Point(numbers[at], numbers[at + 1], numbers[at + 2]);
    }
}
