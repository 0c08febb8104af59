package robosim.geometry.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.Geometry;
import robosim.geometry.RayHit;
import robosim.geometry.material.Color;
import robosim.geometry.material.Material;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.Ray;

/** Light that comes from surfaces, against a count of random paths, and that it comes through no wall. */
class IndirectLightTest {
    private static final double REACH = 4;
    private static final Point TO_SUN = new Point(-0.6, 0.8, 0);
    private static final Lighting LIGHT = new Lighting(
            Sky.of(Color.parse("#8090a0"), 0.5), List.of(new Light.Sun(new Point(0.6, -0.8, 0), Color.WHITE, 0.8)));
    private static final Material RED = Material.of(Color.parse("#d03020")).withSpecular(0);
    private static final Material PALE = Material.of(Color.parse("#d0d0d0")).withSpecular(0);

    private static BoxObject box(double x, double y, double z, double width, double height, double length) {
        return new BoxObject(new Point(x, y, z), width, height, length);
    }

    /** A floor between a wall that hides the sun and a red one that the sun lights. */
    private static Geometry gap() {
        Geometry world = new Geometry(100, 100, 100);
        world.addObjectUnchecked(box(0, -0.5, 0, 40, 1, 40).withMaterial(PALE));
        world.addObjectUnchecked(box(-1, 1.5, 0, 1, 3, 20).withMaterial(PALE));
        world.addObjectUnchecked(box(1.2, 1.75, 0, 1, 3.5, 20).withMaterial(RED));
        return world;
    }

    private static double[] seen(Geometry world, ColorCamera camera) {
        ColorFrame frame = new ColorFrame();
        camera.withLighting(LIGHT).render(world, frame);
        double[] mean = new double[3];
        for (int pixel : frame.pixels()) {
            for (int c = 0; c < 3; c++) {
                mean[c] += Color.linear(pixel >> (16 - 8 * c) & 255) / frame.pixels().length;
            }
        }
        return mean;
    }

    /** One that sees a small part of the floor from above. */
    private static ColorCamera above(double x) {
        return ColorCamera.of(32, 32, 0.5).at(Pose.lookAt(new Point(x, 3, 0), new Point(x, 0, 1e-9)));
    }

    @Test
    void isThatOfRandomPaths() {
        Geometry world = gap();
        for (double x : new double[] {-0.3, 0.1, 0.5}) {
            double[] truth = floor(world, new Point(x, 0, 0), 40_000);
            double[] indirect = seen(world, above(x).withIndirectLight(16, REACH));
            double[] direct = seen(world, above(x).withSmoothSky(16, REACH));
            for (int c = 0; c < 3; c++) {
                // Pictures have 256 levels, and their directions are fewer.
                assertThat(indirect[c]).as("%s of %s", c, x).isCloseTo(truth[c], within(0.06 * truth[c]));
            }
            assertThat(indirect[0]).isGreaterThan(1.3 * direct[0]);
            assertThat(indirect[0] / indirect[2]).isGreaterThan(1.1 * direct[0] / direct[2]); // redder
        }
    }

    /** The light of a point of the floor by counting paths; the sun does not reach it. */
    private static double[] floor(Geometry world, Point point, int paths) {
        assertThat(isFree(world, point, new Point(0, 1, 0), TO_SUN, Double.POSITIVE_INFINITY))
                .isFalse();
        SplittableRandom random = new SplittableRandom(3);
        Color sky = LIGHT.sky().zenith();
        double[] even = {sky.linearRed() / 2, sky.linearGreen() / 2, sky.linearBlue() / 2};
        double[] sum = new double[3];
        Point up = new Point(0, 1, 0);
        for (int k = 0; k < paths; k++) {
            Point way = around(up, random);
            RayHit hit = world.castRay(new Ray(raised(point, up), way), REACH);
            double sun = 0;
            double free = 1;
            Color color = Color.WHITE;
            if (hit != null) {
                Point n = hit.normal();
                color = hit.object().material().color();
                double facing = n.x() * TO_SUN.x() + n.y() * TO_SUN.y() + n.z() * TO_SUN.z();
                sun = facing > 0 && isFree(world, hit.point(), n, TO_SUN, Double.POSITIVE_INFINITY) ? 0.8 * facing : 0;
                free = isFree(world, hit.point(), n, around(n, random), REACH) ? 1 : 0;
            }
            double[] linear = {color.linearRed(), color.linearGreen(), color.linearBlue()};
            for (int c = 0; c < 3; c++) {
                sum[c] += linear[c] * (sun + free * even[c]);
            }
        }
        Color floor = PALE.color();
        return new double[] {
            sum[0] / paths * floor.linearRed(),
            sum[1] / paths * floor.linearGreen(),
            sum[2] / paths * floor.linearBlue()
        };
    }

    private static Point raised(Point point, Point n) {
        return new Point(point.x() + 1e-9 * n.x(), point.y() + 1e-9 * n.y(), point.z() + 1e-9 * n.z());
    }

    private static boolean isFree(Geometry world, Point point, Point n, Point way, double reach) {
        return world.castRay(new Ray(raised(point, n), way), reach) == null;
    }

    /** As many directions around a normal as the cosine of the angle to it: a point of the sphere that touches there. */
    private static Point around(Point n, SplittableRandom random) {
        double y = random.nextDouble(-1, 1);
        double angle = random.nextDouble(2 * Math.PI);
        double aside = Math.sqrt(1 - y * y);
        return new Point(n.x() + aside * Math.cos(angle), n.y() + y, n.z() + aside * Math.sin(angle));
    }

    @Test
    void noneComesIntoAClosedRoom() {
        Geometry world = new Geometry(100, 100, 100);
        world.addObjectUnchecked(box(0, -1.5, 0, 4, 1, 4).withMaterial(PALE));
        world.addObjectUnchecked(box(0, 1.5, 0, 4, 1, 4).withMaterial(PALE));
        for (int side = -1; side <= 1; side += 2) { // walls that touch and do not overlap
            world.addObjectUnchecked(box(1.5 * side, 0, 0, 1, 2, 4).withMaterial(RED));
            world.addObjectUnchecked(box(0, 0, 1.5 * side, 2, 2, 1).withMaterial(RED));
        }
        ColorCamera inside = ColorCamera.of(48, 48, 100).at(Pose.lookAt(new Point(), new Point(1, -1, 0.3)));
        assertThat(seen(world, inside.withIndirectLight(4, Double.POSITIVE_INFINITY)))
                .containsOnly(0);
    }

    @Test
    void isTheSameOnAnyNumberOfThreads() {
        Geometry world = gap();
        ColorCamera camera = ColorCamera.of(200, 150, 60)
                .at(Pose.lookAt(new Point(3, 4, 6), new Point()))
                .withIndirectLight(2, REACH)
                .withSmoothEdges(2);
        ColorFrame one = new ColorFrame();
        camera.render(world, one);
        ColorFrame many = new ColorFrame();
        camera.withThreads(3).render(world.snapshot(), many);
        assertThat(many.pixels()).isEqualTo(one.pixels());
    }
}
