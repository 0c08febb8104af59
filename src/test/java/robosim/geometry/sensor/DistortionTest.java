package robosim.geometry.sensor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.Geometry;
import robosim.geometry.material.Color;
import robosim.geometry.material.Material;
import robosim.geometry.model.Point;
import robosim.geometry.model.RayPattern;
import robosim.geometry.model.SphereObject;
import robosim.geometry.render.ColorCamera;
import robosim.geometry.render.ColorFrame;
import robosim.geometry.render.Light;
import robosim.geometry.render.Lighting;
import robosim.geometry.render.Sky;
import robosim.geometry.sensor.Intrinsics.Distortion;

class DistortionTest {
    /** Where a lens shows a direction, forward, up and to the right, as OpenCV computes it: column and row. */
    private static double[] project(Intrinsics camera, double forward, double up, double right) {
        double[] k = camera.distortion().coefficients();
        double seenX;
        double seenY;
        if (camera.distortion().isFisheye()) {
            double aside = Math.hypot(up, right);
            double t = Math.atan2(aside, forward);
            double d = t * (1 + k[0] * t * t + k[1] * Math.pow(t, 4) + k[2] * Math.pow(t, 6) + k[3] * Math.pow(t, 8));
            seenX = aside == 0 ? 0 : d * right / aside;
            seenY = aside == 0 ? 0 : -d * up / aside;
        } else {
            double x = right / forward;
            double y = -up / forward;
            double r2 = x * x + y * y;
            double radial = 1 + k[0] * r2 + k[1] * r2 * r2 + k[4] * r2 * r2 * r2;
            seenX = x * radial + 2 * k[2] * x * y + k[3] * (r2 + 2 * x * x);
            seenY = y * radial + k[2] * (r2 + 2 * y * y) + 2 * k[3] * x * y;
        }
        return new double[] {camera.fx() * seenX + camera.cx(), camera.fy() * seenY + camera.cy()};
    }

    @Test
    void everyPixelLooksWhereOpenCvShowsIt() {
        SplittableRandom random = new SplittableRandom(5);
        int bent = 0;
        for (int round = 0; round < 40; round++) {
            boolean isFisheye = round % 2 == 1;
            Distortion lens = isFisheye
                    ? Distortion.fisheye(
                            random.nextDouble(-0.02, 0.05),
                            random.nextDouble(-0.003, 0.003),
                            random.nextDouble(-0.0005, 0.0005),
                            random.nextDouble(-0.0002, 0.0002))
                    : Distortion.brownConrady(
                            random.nextDouble(-0.3, 0.3),
                            random.nextDouble(-0.02, 0.1),
                            random.nextDouble(-0.005, 0.005),
                            random.nextDouble(-0.005, 0.005),
                            random.nextDouble(0, 0.02));
            double focal = isFisheye ? random.nextDouble(24, 34) : random.nextDouble(55, 80);
            Intrinsics camera = new Intrinsics(
                    40,
                    30,
                    focal,
                    focal * random.nextDouble(0.9, 1.1),
                    random.nextDouble(15, 25),
                    random.nextDouble(12, 18),
                    lens);
            RayPattern pattern = camera.pattern();
            assertThat(pattern.rows()).isEqualTo(30);
            for (int k = 0; k < pattern.size(); k++) {
                double[] seen = project(camera, pattern.x(k), pattern.y(k), pattern.z(k));
                assertThat(seen[0]).as("%s, %d", camera, k).isCloseTo(k % 40, within(1e-9));
                assertThat(seen[1]).as("%s, %d", camera, k).isCloseTo(k / 40, within(1e-9));
            }
            double[] straight = project(
                    camera.withDistortion(Distortion.NONE), Math.max(0.1, pattern.x(0)), pattern.y(0), pattern.z(0));
            bent += Math.hypot(straight[0], straight[1]) > 0.5 ? 1 : 0;
        }
        assertThat(bent).as("lenses that bend the corner by half a pixel").isGreaterThan(20);
    }

    @Test
    void withoutDistortionNothingChanges() {
        Intrinsics camera = new Intrinsics(31, 21, 20, 25, 11, 5);
        assertThat(camera.withDistortion(Distortion.NONE).pattern())
                .isEqualTo(RayPattern.pinhole(31, 21, 20, 25, 11, 5));
    }

    @Test
    void coloursAreSeenThroughTheSameLensAsDepths() {
        Geometry world = new Geometry(20, 20, 20);
        world.addObject(new SphereObject(new Point(4, 0.9, 1.1), 0.5)
                .withMaterial(Material.of(Color.BLACK).withSpecular(0).withEmission(Color.WHITE)));
        Lighting dark = new Lighting(Sky.NONE, List.<Light>of());
        for (Distortion lens : new Distortion[] {
            Distortion.NONE, Distortion.brownConrady(-0.3, 0.1, 0.01, -0.01, 0), Distortion.fisheye(0.03, 0, 0, 0)
        }) {
            Intrinsics camera = new Intrinsics(64, 48, 50, 52, 28, 25, lens);
            ColorFrame colours = new ColorFrame();
            ColorCamera.of(camera).withLighting(dark).render(world, colours);
            DepthFrame depths = new DepthFrame();
            DepthCamera.of(camera).read(world, depths);
            int seen = 0;
            for (int k = 0; k < 64 * 48; k++) {
                boolean isBall = Double.isFinite(depths.depths()[k]);
                assertThat(colours.pixels()[k] != 0).as("%s, %d", lens, k).isEqualTo(isBall);
                seen += isBall ? 1 : 0;
            }
            assertThat(seen).isBetween(30, 600);
        }
    }

    @Test
    void refusesALensThatShowsNothingInItsCorners() {
        Intrinsics folded = new Intrinsics(64, 48, 30, 30, 31.5, 23.5, Distortion.brownConrady(-0.5, 0, 0, 0, 0));
        assertThatIllegalArgumentException()
                .isThrownBy(folded::pattern)
                .withMessageContaining("distortion must show something in every pixel")
                .withMessageContaining("column 0");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Distortion.fisheye(Double.NaN, 0, 0, 0))
                .withMessageContaining("first");
    }
}
