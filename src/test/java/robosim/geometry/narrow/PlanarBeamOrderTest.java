package robosim.geometry.narrow;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.Geometry;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;
import robosim.geometry.model.SphereObject;
import robosim.geometry.narrow.leaf.Leaf;

/** In PLANAR every sector hears what the line along its axis hits, at the line's distance at the latest, bit for bit. */
class PlanarBeamOrderTest {
    private static final double FAR = Double.POSITIVE_INFINITY;
    private final SplittableRandom random = new SplittableRandom(31);

    private static Geometry world(GeometryObject object) {
        Geometry world = new Geometry(1e9, 1e9, 1e9, Dimension.PLANAR, Accuracy.EXACT);
        assertThat(world.addObjectUnchecked(object)).isTrue();
        return world;
    }

    private static void check(GeometryObject object, Point way, double width) {
        Geometry world = world(object);
        Ray ray = new Ray(new Point(0, 0, 0), way);
        double line = world.getRayDistance(ray, 0, FAR, 0);
        assertThat(line).isFinite();
        assertThat(world.getRayDistance(ray, 0, FAR, width))
                .as("width " + width)
                .isLessThanOrEqualTo(line);
    }

    /** The margin of the line reached past the bounds of the object, which the search for sectors took for the whole. */
    @Test
    void aSectorOfCosineOneIsTheLine() {
        GeometryObject cylinder = new CylinderObject(
                        new Point(-0.500000000283789, 0.0, -1.2552014193626597), 1.2552014194410621, 1.0)
                .oriented(new double[] {0.0, 1.0, 0.0, 0.0, 0.0, -1.0, -1.0, 0.0, 0.0});
        Ray ray = new Ray(new Point(0, 0, 0), new Point(-0.2569357817305271, -0.8303942109223825, 0.07098788330043071));
        Geometry world = world(cylinder);
        double line = world.getRayDistance(ray, 0, FAR, 0);
        assertThat(line).isFinite();
        assertThat(world.getRayDistance(ray, 0, FAR, 5.109948114398358E-9)).isEqualTo(line);
    }

    @Test
    void aTippedCylinderThatTheLineHitsIsHeard() {
        check(
                new CylinderObject(
                                new Point(-0.011124607997657734, 0.0, 1.7848859117588334E-17), 0.0, 0.03146514301274349)
                        .oriented(new double[] {
                            0.0,
                            0.7071067811865475,
                            0.7071067811865475,
                            0.0,
                            0.7071067811865475,
                            -0.7071067811865475,
                            -1.0,
                            0.0,
                            0.0
                        }),
                new Point(3.0, -3.0, 2.5),
                30);
        check(
                new CylinderObject(
                                new Point(-2.232506471982826, 0.0, 940.5318271951186),
                                2.2325064672129824,
                                1881.063654397989)
                        .oriented(new double[] {1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 1.0, 0.0}),
                new Point(-0.32674436376834004, -0.883174109125858, -0.18236835103669757),
                1.3097501584226378E-4);
    }

    @Test
    void noShapeIsHeardLaterThanTheLineHitsIt() {
        check(
                new BoxObject(
                                new Point(0.6977488999071858, 0.0, -0.6913893175676024),
                                1.3954623463277454,
                                0.13447314660174128,
                                1.3827784459196557)
                        .oriented(new double[] {
                            0.9999999999999893,
                            0.0,
                            1.4621635420907098E-7,
                            0.0,
                            1.0,
                            0.0,
                            -1.4621635420907098E-7,
                            0.0,
                            0.9999999999999893
                        }),
                new Point(1, 0, 0),
                130.22246174380732);
        check(
                new SphereObject(new Point(-12.401365171272948, 0.0, 21.702389048255), 0.5458692374745685),
                new Point(-2.0, 3.0, 3.5),
                0.0022372982195203767);
        check(
                new BoxObject(new Point(-25.340367123718465, 0.0, 34.79249568214085), 1.0, 23.24762188633049, 0.0)
                        .oriented(new double[] {
                            0.9999999997527484,
                            1.1118713825122444E-5,
                            1.9258177294571586E-5,
                            0.0,
                            0.8660254037844387,
                            -0.5,
                            -2.2237427690244888E-5,
                            0.4999999998763742,
                            0.8660254035703125
                        }),
                new Point(-3.0, 2.0, 3.5),
                120);
    }

    @Test
    void noSectorOverAnyShapeIsLaterThanItsAxis() {
        int[] hits = new int[8];
        for (int n = 0; n < 8000; n++) {
            Geometry world = world(object(n % 8));
            Point way = new Point(between(1), between(1), between(1));
            for (double far : new double[] {0, 3, 100}) {
                // At the object's middle, or near its outline.
                double length = Math.sqrt(way.x() * way.x() + way.z() * way.z());
                double aside = random.nextInt(2) == 0 ? 0 : between(1);
                Point start = new Point(
                        5 - far * way.x() / length + aside * way.z(), 0, 7 - far * way.z() / length - aside * way.x());
                Ray ray = new Ray(start, way);
                double line = world.getRayDistance(ray, 0, FAR, 0);
                if (line == FAR) {
                    continue;
                }
                hits[n % 8]++;
                for (double width : new double[] {Double.MIN_VALUE, 5e-9, 1e-5, 0.01, 1, 30, 179}) {
                    double heard = world.getRayDistance(ray, 0, FAR, width);
                    assertThat(heard)
                            .as("shape %d, case %d, %s, width %s", n % 8, n, ray, width)
                            .isLessThanOrEqualTo(line);
                    if (width < 1e-8) {
                        assertThat(heard).as("the line itself").isEqualTo(line);
                    }
                }
            }
        }
        for (int kind = 0; kind < hits.length; kind++) {
            assertThat(hits[kind]).as("shape " + kind).isGreaterThan(1000);
        }
    }

    private GeometryObject object(int kind) {
        Point middle = new Point(5, 0, 7);
        double[] turn = new double[16];
        switch (kind) {
            case 0, 1, 2 -> PlanarRows.upright(turn, random.nextDouble(360));
            default -> tip(turn);
        }
        double[] rotation = Arrays.copyOfRange(turn, Leaf.ROTATION, Leaf.ROTATION + 9);
        double a = 0.2 + random.nextDouble();
        double b = 0.2 + random.nextDouble();
        return switch (kind) {
            case 0 -> new BoxObject(middle, a, 1, b).oriented(rotation);
            case 1 -> new SphereObject(middle, a);
            case 2 -> new CylinderObject(middle, a, b).oriented(rotation);
            case 3 -> new BoxObject(middle, a, b, random.nextInt(2) * 0.7).oriented(rotation);
            case 4 -> new CylinderObject(middle, a, b).oriented(rotation);
            case 5 -> new CylinderObject(middle, a, 0).oriented(rotation);
            case 6 -> new CylinderObject(middle, 1e-9 * a, b).oriented(rotation);
            default ->
                new MeshObject(
                        List.of(
                                new Point(5 + between(1), 0, 7 + between(1)),
                                new Point(5 + between(1), 1, 7 + between(1)),
                                new Point(5 + between(1), 2, 7 + between(1)),
                                new Point(5, 3, 7)),
                        new int[][] {{0, 1, 2}, {1, 2, 3}});
        };
    }

    private double between(double most) {
        return random.nextDouble(-most, most);
    }

    // A turn about two axes, by an angle that is anything or all but nothing.
    private void tip(double[] row) {
        double p = random.nextInt(3) == 0 ? 1e-7 * between(1) : between(3);
        double q = between(3);
        double cp = StrictMath.cos(p);
        double sp = StrictMath.sin(p);
        double cq = StrictMath.cos(q);
        double sq = StrictMath.sin(q);
        double[] turn = {cq, sq * sp, sq * cp, 0, cp, -sp, -sq, cq * sp, cq * cp};
        System.arraycopy(turn, 0, row, Leaf.ROTATION, 9);
    }
}
