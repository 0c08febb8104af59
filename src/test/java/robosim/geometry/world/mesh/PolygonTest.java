package robosim.geometry.world.mesh;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.model.Point;

class PolygonTest {
    private static List<int[]> cut(List<Point> corners) {
        int[] polygon = new int[corners.size()];
        Arrays.setAll(polygon, k -> k);
        List<int[]> faces = new ArrayList<>();
        Polygon.cut(corners, polygon, faces);
        return faces;
    }

    /** Twice the area vector of a polygon, by the cross products about the origin. */
    private static double[] areaVector(List<Point> corners, int[] polygon) {
        double[] sum = new double[3];
        for (int k = 0; k < polygon.length; k++) {
            Point a = corners.get(polygon[k]);
            Point b = corners.get(polygon[(k + 1) % polygon.length]);
            sum[0] += a.y() * b.z() - a.z() * b.y();
            sum[1] += a.z() * b.x() - a.x() * b.z();
            sum[2] += a.x() * b.y() - a.y() * b.x();
        }
        return sum;
    }

    private static double length(double[] v) {
        return Math.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    }

    @Test
    void tilesStarsOfAnyShapeAndAttitude() {
        SplittableRandom random = new SplittableRandom(5);
        int concave = 0;
        for (int run = 0; run < 500; run++) {
            int n = 4 + random.nextInt(30);
            double[] u = {random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1)};
            double[] v = {random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1)};
            List<Point> corners = new ArrayList<>();
            for (int k = 0; k < n; k++) {
                double angle = 2 * Math.PI * k / n;
                double r = random.nextDouble(0.2, 2);
                double a = r * Math.cos(angle);
                double b = r * Math.sin(angle);
                corners.add(new Point(a * u[0] + b * v[0] + 3, a * u[1] + b * v[1], a * u[2] + b * v[2]));
            }
            int[] all = new int[n];
            Arrays.setAll(all, k -> k);
            double whole = length(areaVector(corners, all));
            double sum = 0;
            List<int[]> faces = cut(corners);
            for (int[] face : faces) {
                // With the signs lost, areas add up only where no piece lies over another.
                sum += length(areaVector(corners, face));
            }
            assertThat(sum).as("polygon %d of %s", run, corners).isCloseTo(whole, within(1e-9 * (1 + whole)));
            concave += sum > 0 && !isFan(faces) ? 1 : 0;
        }
        assertThat(concave).isBetween(250, 499);
    }

    private static boolean isFan(List<int[]> faces) {
        return faces.stream().allMatch(face -> Arrays.stream(face).anyMatch(index -> index == 0));
    }

    @Test
    void keepsAHoleThatABridgeJoinsToTheOutline() {
        // A square of side 4 with a square hole of side 2: 16 - 4.
        List<Point> corners = List.of(
                new Point(0, 0, 0),
                new Point(4, 0, 0),
                new Point(4, 0, 4),
                new Point(0, 0, 4),
                new Point(0, 0, 0),
                new Point(1, 0, 1),
                new Point(1, 0, 3),
                new Point(3, 0, 3),
                new Point(3, 0, 1),
                new Point(1, 0, 1));
        double sum = 0;
        for (int[] face : cut(corners)) {
            sum += length(areaVector(corners, face)) / 2;
            double x = Arrays.stream(face).mapToDouble(c -> corners.get(c).x()).sum() / 3;
            double z = Arrays.stream(face).mapToDouble(c -> corners.get(c).z()).sum() / 3;
            assertThat(x > 1 && x < 3 && z > 1 && z < 3)
                    .as("centre %s %s in the hole", x, z)
                    .isFalse();
        }
        assertThat(sum).isEqualTo(12);
    }

    @Test
    void keepsTrianglesAndQuadsAsTheyAre() {
        Point a = new Point();
        assertThat(cut(List.of(a, a, a))).containsExactly(new int[] {0, 1, 2});
        List<Point> square = List.of(a, new Point(1, 0, 0), new Point(1, 0, 1), new Point(0, 0, 1));
        assertThat(cut(square)).containsExactly(new int[] {0, 1, 2, 3});
    }

    @Test
    void turnsAQuadWhoseDiagonalLiesOutside() {
        List<Point> dart = List.of(new Point(0, 0, 0), new Point(1, 0, 1), new Point(2, 0, 0), new Point(1, 0, 3));
        assertThat(cut(dart)).containsExactly(new int[] {1, 2, 3, 0});
    }

    @Test
    void leavesFlatTrianglesWhereCornersAreInLine() {
        List<Point> corners = List.of(
                new Point(0, 0, 0), new Point(1, 0, 0), new Point(2, 0, 0), new Point(2, 1, 0), new Point(0, 1, 0));
        double sum = 0;
        List<int[]> faces = cut(corners);
        for (int[] face : faces) {
            sum += length(areaVector(corners, face)) / 2;
        }
        assertThat(sum).isEqualTo(2);
        assertThat(faces).hasSize(3);
        List<Point> line = List.of(
                new Point(0, 0, 0),
                new Point(1, 1, 1),
                new Point(2, 2, 2),
                new Point(3, 3, 3),
                new Point(1.5, 1.5, 1.5));
        assertThat(cut(line)).hasSize(3);
    }

    @Test
    void refusesAPolygonThatCrossesItself() {
        List<Point> star = new ArrayList<>();
        for (int k = 0; k < 5; k++) {
            star.add(new Point(Math.cos(4 * Math.PI * k / 5), 0, Math.sin(4 * Math.PI * k / 5)));
        }
        List<Point> eight = List.of(
                new Point(0, 0, 0), new Point(4, 0, 4), new Point(4, 0, 0), new Point(0, 0, 4), new Point(-1, 0, 2));
        assertThatIllegalArgumentException()
                .isThrownBy(() -> cut(eight))
                .withMessageContaining("must not cross itself")
                .withMessageContaining("(got: one of 5 corners)");
    }
}
