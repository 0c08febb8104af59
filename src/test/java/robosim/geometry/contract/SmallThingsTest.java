package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import robosim.geometry.Effort;
import robosim.geometry.Geometry;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;
import robosim.geometry.model.SphereObject;

/** What is no larger than a spot or a thread is where it is, and nowhere else. */
class SmallThingsTest {
    private static final double INFINITE = Double.POSITIVE_INFINITY;

    private static Geometry planar(GeometryObject... objects) {
        Geometry world = new Geometry(64, 64, 64, Dimension.PLANAR, Accuracy.EXACT);
        for (GeometryObject object : objects) {
            assertThat(world.addObjectUnchecked(object)).isTrue();
        }
        return world;
    }

    @Test
    void aSpotFarAwayIsNotAtTheBeginningOfACone() {
        Geometry world = planar(new CylinderObject(new Point(-2.25, 0, 1.25), 0, 0.5));
        Ray ray = new Ray(new Point(-0.625, -0.875, -1), new Point(0, 1, 1));
        double far = Math.hypot(1.625, 2.25);
        assertThat(world.getRayDistance(ray, 0, INFINITE, 116.2, Accuracy.DOP)).isBetween(far - 1e-9, far);
        assertThat(world.getRayDistance(ray, 0, INFINITE, 116.2)).isBetween(far - 1e-9, far + 1e-9);
    }

    /** A box on edge, of which the plane shows a thread whose ends are shorter than rounding. */
    @Test
    void aConeDoesNotBeginOnTheContinuationOfAThread() {
        BoxObject thread = new BoxObject(new Point(3, 0, 3), 2, 1e-17, 1e-17).turned(30, 40);
        for (double along : new double[] {-4, -2, 2, 4}) {
            Point start = new Point(3 + along * thread.rotation()[0], 0, 3 + along * thread.rotation()[6]);
            Ray back = new Ray(start, new Point(3 - start.x(), 0, 3 - start.z()));
            assertThat(planar(thread).getRayDistance(back, 0, INFINITE, 20))
                    .isBetween(Math.abs(along) - 1 - 1e-9, Math.abs(along) - 1 + 1e-9);
        }
    }

    /** So near the origin that squares vanish: the answers are those of the same scene at a size that is usual, to the bit. */
    @Test
    void raysInAFlatWorldShrinkWithTheScene() {
        for (double size : new double[] {1, 0x1p-250, 0x1p-530}) {
            Ray ray = new Ray(new Point(), new Point(1, 0, 0));
            assertThat(planar(disc(size)).getRayDistance(ray, 0, INFINITE, 0) / size)
                    .isEqualTo(planar(disc(1)).getRayDistance(ray, 0, INFINITE, 0));
        }
    }

    private static CylinderObject disc(double size) {
        return new CylinderObject(new Point(3.1 * size, 0, 0.37 * size), 1.07 * size, size);
    }

    @Test
    void aDiscDoesNotTouchASpotElsewhere() {
        MeshObject spot = new MeshObject(
                List.of(new Point(0, 0, 0), new Point(1e-16, 0, 0), new Point(0, 0, 1e-16)), new int[][] {{0, 1, 2}});
        Geometry world = planar(spot);
        assertThat(world.testObject(new SphereObject(new Point(0.9, 0, 0.9), 1)))
                .isFalse();
        assertThat(world.testObject(new SphereObject(new Point(0.9, 0, 0.9), 1.3)))
                .isTrue();
        BoxObject speck = new BoxObject(new Point(), 1e-17, 1e-17, 1e-17).turned(30, 40);
        assertThat(planar(speck).testObject(new SphereObject(new Point(0.9, 0, 0.9), 1)))
                .isFalse();
    }

    /** The top of a rod that tips over is flat; a search for it must not take all afternoon: the time guards against that alone. */
    @Tag("slow")
    @Test
    @Timeout(60)
    void aRodTipsWithoutALongSearch() {
        Geometry world = planar(new CylinderObject(new Point(-9, 1.5, -2.6), 0, 0.55).moveable("rod"));
        for (int k = 0; k < Effort.cases(10_000); k++) {
            assertThat(world.move("rod", new Move(0, 0, 0, 28.3, 17.4)).allowed())
                    .isTrue();
        }
    }

    /** All of it is more than 144 degrees from the axis, on all sides of the axis's continuation backwards. */
    @Test
    void aCylinderBehindIsNotHeard() {
        double[] rotation = {
            -0.5895188045535283,
            -0.33365351401683097,
            0.7356241646805788,
            -0.6401989055738964,
            -0.36233723651314764,
            -0.677389908647893,
            0.49255755032256315,
            -0.8702798743049478,
            0.0
        };
        Point centre = new Point(2.422318507825363, -0.34606560067240727, -3.75);
        Geometry world = new Geometry(64, 64, 64);
        assertThat(world.addObject(new CylinderObject(centre, 0.625, 0.5).oriented(rotation)))
                .isTrue();
        Ray ray = new Ray(
                new Point(2.75, 0.125, -2.2031182566277385),
                new Point(0.057194729939018085, 0.3733787970343072, 0.7973270868496163));
        for (double width : new double[] {1, 5, 14.46, 25, 30, 90, 179}) {
            assertThat(world.getRayDistance(ray, 0, INFINITE, width))
                    .as(width + " degrees")
                    .isEqualTo(INFINITE);
        }
    }

    /** It crosses the axis's continuation backwards and reaches forward to 71 degrees from the axis. */
    @Test
    void aCylinderBesideAndBehindIsHeardFromItsOwnAngleOn() {
        double[] rotation = {
            0.701619025739367, 0.7125522736757925, 0, 0, 0, -1, -0.7125522736757925, 0.701619025739367, 0
        };
        Geometry world = new Geometry(64, 64, 64);
        assertThat(world.addObject(
                        new CylinderObject(new Point(2.75, 0, 2.375), 1, 1.963499513604216).oriented(rotation)))
                .isTrue();
        Ray ray = new Ray(
                new Point(2.277777512391883, -0.11019926407329872, 1.3292865702013472),
                new Point(-0.6713798257557437, -0.16985117840209352, -0.3150485499640949));
        for (double width : new double[] {1, 5, 31.3, 60, 100, 141}) {
            assertThat(world.getRayDistance(ray, 0, INFINITE, width))
                    .as(width + " degrees")
                    .isEqualTo(INFINITE);
        }
        assertThat(world.getRayDistance(ray, 0, INFINITE, 150)).isBetween(0.6215, 0.6226);
    }

    /** On its way the ball is seen along a cylinder's axis, up to rounding that must not show a point beyond the caps. */
    @Test
    void aBallThatPassesACapIsApartAllTheWay() {
        double half = 0.7071067811865476;
        Geometry world = new Geometry(64, 64, 64);
        assertThat(world.addObject(new CylinderObject(
                                new Point(-0.9141236174918203, 0.9132202173842221, 2.0605702268985464),
                                0.9994648512364057,
                                0.7015093347692214)
                        .oriented(new double[] {-half, half, 0, 0, 0, 1, half, half, 0})))
                .isTrue();
        SphereObject ball = new SphereObject(new Point(), 0.626468752210691);
        for (int k = 0; k <= 37_000; k++) {
            double share = k * 1e-5;
            Point place = new Point(
                    0.7902184407612634 - 0.9240577927005654 * share,
                    0.625 + 0.42266543782080596 * share,
                    2.559481481946456 - 1.2535363134608983 * share);
            if (world.testObject(ball.movedTo(place))) {
                assertThat(share).as("touches at").isGreaterThan(0.377);
            }
        }
    }

    @Test
    void aFlatCylinderIsAsFarFromATriangleAsItIs() {
        double x = 1.8115048755807353 / 2;
        double y = 1.0589823113556835 / 2;
        double z = 0.8291242457730184 / 2;
        GeometryObject triangle = new MeshObject(
                        List.of(new Point(x, -y, -z), new Point(x, y, z), new Point(x, -y, z)), new int[][] {{0, 1, 2}})
                .oriented(new double[] {
                    -0.8242187848838144,
                    -0.5198784991312185,
                    -0.22447659295730626,
                    0.0,
                    0.3964116133891461,
                    -0.9180728907718679,
                    0.5662714849298423,
                    -0.7566929224667599,
                    -0.3267298983014344
                })
                .movedTo(new Point(0.9755319522062047, 0.18984585170458013, 0.09416918266285901));
        GeometryObject disc = new CylinderObject(
                        new Point(-0.762529912636146, 0.29082760926728024, 0.05090955591578883), 0.9662174341916427, 0)
                .turned(90, 45);
        Geometry world = new Geometry(64, 64, 64);
        assertThat(world.addObject(triangle)).isTrue();
        assertThat(world.addObject(disc.moveable("disc"))).isTrue();
        assertThat(world.getProximity("disc", INFINITE)).isBetween(0.454841, 0.454842);
    }

    @Test
    void aStaticObjectIsNotNearItself() {
        Geometry world = planar(new SphereObject(new Point(), 1).named("a"), new SphereObject(new Point(5, 0, 0), 1));
        assertThat(world.getProximity("a", INFINITE)).isEqualTo(3);
        assertThat(world.getProximity("a", 2)).isEqualTo(INFINITE);
    }

    /** The side of a box without thickness is 2.4e-19 farther away than the ball is thick, and has edges without length. */
    @Test
    void aFlatBoxIsNoNearerThanItsSide() {
        BoxObject flat = new BoxObject(
                        new Point(0.09478078590787249, -0.06377673465265199, 0.125), 0, 0.75, 0.5425716702258296)
                .oriented(new double[] {
                    0.9843967256175623, -0.1759633103616258, 0, 0, 0, -1, 0.1759633103616258, 0.9843967256175623, 0
                });
        Geometry world = new Geometry(64, 64, 64);
        assertThat(world.addObject(flat)).isTrue();
        double radius = 0.5958046947776636;
        Point place = new Point(-0.5104677681279863, 0, 0.125);
        assertThat(world.testObject(new SphereObject(place, radius))).isFalse();
        assertThat(world.testObject(new SphereObject(place, Math.nextUp(radius))))
                .isTrue();
    }
}
