package robosim.geometry.model;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.math.BigDecimal;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.function.DoubleSupplier;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import robosim.geometry.collision.CollisionDetection;

/** Hulls, checked with exact arithmetic of its own. */
class ConvexHullTest {
    private final SplittableRandom random = new SplittableRandom(77);

    private static BigDecimal[] minus(Point a, Point b) {
        return new BigDecimal[] {
            new BigDecimal(a.x()).subtract(new BigDecimal(b.x())),
            new BigDecimal(a.y()).subtract(new BigDecimal(b.y())),
            new BigDecimal(a.z()).subtract(new BigDecimal(b.z()))
        };
    }

    private static BigDecimal[] cross(BigDecimal[] u, BigDecimal[] v) {
        BigDecimal[] out = new BigDecimal[3];
        for (int k = 0; k < 3; k++) {
            int i = (k + 1) % 3;
            int j = (k + 2) % 3;
            out[k] = u[i].multiply(v[j]).subtract(u[j].multiply(v[i]));
        }
        return out;
    }

    private static int side(Point a, Point b, Point c, Point p) {
        BigDecimal[] normal = cross(minus(b, a), minus(c, a));
        BigDecimal[] to = minus(p, a);
        return normal[0]
                .multiply(to[0])
                .add(normal[1].multiply(to[1]))
                .add(normal[2].multiply(to[2]))
                .signum();
    }

    /** No point above a face, no face without area, each edge once in either direction, and its corners among the points. */
    private static void check(List<Point> points, MeshObject hull) {
        List<Point> corners = hull.vertices();
        assertThat(new HashSet<>(points)).containsAll(corners);
        Map<List<Integer>, Integer> edges = new HashMap<>();
        for (int[] face : hull.faces()) {
            Point a = corners.get(face[0]);
            Point b = corners.get(face[1]);
            Point c = corners.get(face[2]);
            assertThat(Stream.of(cross(minus(b, a), minus(c, a))).anyMatch(each -> each.signum() != 0))
                    .as("area of %s %s %s", a, b, c)
                    .isTrue();
            for (Point point : points) {
                assertThat(side(a, b, c, point))
                        .as("%s above %s %s %s", point, a, b, c)
                        .isLessThanOrEqualTo(0);
            }
            for (int k = 0; k < 3; k++) {
                edges.merge(List.of(face[k], face[(k + 1) % 3]), 1, Integer::sum);
            }
        }
        edges.forEach((edge, uses) -> {
            assertThat(uses).as("uses of edge %s", edge).isEqualTo(1);
            assertThat(edges).containsKey(List.of(edge.get(1), edge.get(0)));
        });
        assertThat(corners.size() - edges.size() / 2 + hull.faces().length)
                .as("Euler")
                .isEqualTo(2);
        assertThat(hull.isSolid()).isTrue();
        assertThat(hull.faces().length).isGreaterThanOrEqualTo(4);
    }

    private List<Point> points(int count, DoubleSupplier coordinate) {
        return Stream.generate(
                        () -> new Point(coordinate.getAsDouble(), coordinate.getAsDouble(), coordinate.getAsDouble()))
                .limit(count)
                .toList();
    }

    @Test
    void random() {
        for (int k = 0; k < 30; k++) {
            List<Point> points = points(4 + random.nextInt(60), () -> random.nextDouble(-1, 1));
            check(points, MeshObject.hull(points));
        }
    }

    /** Whether all points are in one plane. */
    private static boolean isFlat(List<Point> points) {
        Point a = points.get(0);
        for (Point b : points) {
            for (Point c : points) {
                if (Stream.of(cross(minus(b, a), minus(c, a))).anyMatch(each -> each.signum() != 0)) {
                    return points.stream().allMatch(d -> side(a, b, c, d) == 0);
                }
            }
        }
        return true;
    }

    @Test
    void manyInOnePlaneOrLine() {
        int flat = 0;
        for (int k = 0; k < 100; k++) {
            int size = 2 + k % 3;
            double unit = k % 2 == 0 ? 1 : 0.1; // multiples of 0.1 are almost, not wholly, in planes
            List<Point> points = points(3 + random.nextInt(k % 5 == 0 ? 3 : 40), () -> unit * random.nextInt(size));
            MeshObject hull = MeshObject.hull(points);
            if (isFlat(points)) {
                flat++;
                assertThat(isFlat(hull.vertices())).isTrue();
                assertThat(hull.isSolid()).isTrue();
                for (Point point : points) {
                    assertThat(CollisionDetection.intersects(hull, new SphereObject(point, 1e-9)))
                            .isTrue();
                }
            } else {
                check(points, hull);
            }
        }
        assertThat(flat).isBetween(3, 60);
    }

    @Test
    void onASphereAndNearlyInAPlane() {
        List<Point> sphere = Stream.generate(() -> {
                    double y = random.nextDouble(-1, 1);
                    double turn = random.nextDouble(7);
                    double r = Math.sqrt(1 - y * y);
                    return new Point(r * Math.cos(turn), y, r * Math.sin(turn));
                })
                .limit(120)
                .toList();
        check(sphere, MeshObject.hull(sphere));
        List<Point> sheet = points(80, () -> random.nextDouble(1)).stream()
                .map(p -> new Point(p.x(), 1 + p.x() / 3 + p.z() / 7 + Math.ulp(1.0) * random.nextInt(3), p.z()))
                .toList();
        check(sheet, MeshObject.hull(sheet));
    }

    @Test
    void degenerate() {
        Point a = new Point(1, 2, 3);
        MeshObject point = MeshObject.hull(List.of(a, a));
        assertThat(point.vertices()).containsExactly(a);
        assertThat(CollisionDetection.intersects(point, new SphereObject(a, 0.1)))
                .isTrue();
        MeshObject line = MeshObject.hull(List.of(new Point(1, 1, 1), new Point(0, 0, 0), new Point(3, 3, 3)));
        assertThat(line.vertices()).containsExactly(new Point(0, 0, 0), new Point(3, 3, 3));
        assertThat(CollisionDetection.intersects(line, new SphereObject(new Point(2, 2, 2), 0.1)))
                .isTrue();
        MeshObject square = MeshObject.hull(List.of(
                new Point(0, 0, 0),
                new Point(2, 0, 2),
                new Point(1, 0, 1),
                new Point(2, 0, 0),
                new Point(1, 0, 0),
                new Point(0, 0, 2)));
        assertThat(square.vertices()).hasSize(4).doesNotContain(new Point(1, 0, 1), new Point(1, 0, 0));
        assertThat(CollisionDetection.intersects(square, new SphereObject(new Point(1, 0.1, 1), 0.1)))
                .isTrue();
        assertThat(CollisionDetection.intersects(square, new SphereObject(new Point(1, 0.11, 1), 0.1)))
                .isFalse();
        assertThatIllegalArgumentException()
                .isThrownBy(() -> MeshObject.hull(List.of()))
                .withMessageContaining("points");
    }

    @Test
    void ofAMesh() {
        MeshObject open = new MeshObject(
                        List.of(
                                new Point(0, 0, 0),
                                new Point(1, 0, 0),
                                new Point(0, 1, 0),
                                new Point(0, 0, 1),
                                new Point(9, 9, 9)),
                        new int[][] {{0, 1, 2}, {0, 2, 3}})
                .moveable("a")
                .movedTo(new Point(5, 5, 5));
        MeshObject hull = open.hull();
        assertThat(hull.faces()).hasDimensions(4, 3);
        assertThat(hull.name()).isEqualTo("a");
        assertThat(hull.pose()).isEqualTo(open.pose());
        assertThat(CollisionDetection.intersects(hull, new SphereObject(new Point(5.2, 5.2, 5.2), 0.01)))
                .isTrue();
        assertThat(CollisionDetection.intersects(open, new SphereObject(new Point(5.2, 5.2, 5.2), 0.01)))
                .isFalse();
    }
}
