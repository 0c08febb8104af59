package robosim.geometry.dynamics;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import robosim.geometry.Geometry;
import robosim.geometry.collision.CollisionDetection;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Twist;

/** Robots in a small cell that press against its walls, pillars, crates and each other: they slide on, and seldom stop. */
class PressTest {
    private static final int STEPS = 400;
    private static final double SQUARE = 1e-9;

    private final StopCount stops = new StopCount();
    private int contacts;

    @Test
    void robotsThatPressSlideOn() {
        for (long seed = 1; seed <= 5; seed++) {
            run(new SplittableRandom(seed));
        }
        assertThat(contacts).isGreaterThan(50 * STEPS);
        stops.assertAtMost(100);
    }

    /** Thrown or driven, square on to what is wider, narrower or beside its middle: it keeps its heading. */
    @ParameterizedTest
    @CsvSource({"0, 40", "0, 0.1", "0.1, 40", "0.15, 0.3", "-0.037, 0.5", "19.9, 40"})
    void aBoxThatMeetsAWallSquarelyDoesNotTurn(double aside, double width) {
        for (boolean driven : new boolean[] {true, false}) {
            for (double restitution : new double[] {0, 0.5}) {
                Geometry world = new Geometry(100, 2, 100, Dimension.PLANAR, Accuracy.EXACT);
                world.addObject(new BoxObject(new Point(5.1, 0, aside), 0.2, 1, width));
                GeometryObject box = new BoxObject(new Point(-2, 0, 0), 0.6, 0.4, 0.4).moveable("box");
                assertThat(world.addObject(box)).isTrue();
                Surface surface = new Surface(restitution, 0.5, 0.4);
                Dynamics dynamics = new Dynamics(world, surface);
                dynamics.add("box", Body.ofMass(box, 20).withSurface(surface));
                if (driven) {
                    dynamics.drive("box", new DifferentialDrive(0.4, 2, 3).driving(1.3, 0));
                } else {
                    dynamics.setVelocity("box", new Twist(2.7, 0, 0, 0));
                }
                double turned = 0;
                double strayed = 0;
                for (int step = 0; step < 300; step++) {
                    dynamics.step(0.05);
                    GeometryObject now = Objects.requireNonNull(world.getObject("box"));
                    turned = Math.max(turned, Math.abs(now.heading()));
                    strayed = Math.max(strayed, Math.abs(now.center().z()));
                }
                String what = "driven " + driven + ", restitution " + restitution;
                assertThat(turned).as(what).isLessThan(SQUARE);
                assertThat(strayed).as(what).isLessThan(SQUARE);
            }
        }
    }

    private void run(SplittableRandom random) {
        Geometry world = new Geometry(6, 2, 6, Dimension.PLANAR, Accuracy.EXACT);
        world.addObject(new BoxObject(new Point(1, 0, 1), 1.5, 1, 0.2).turned(0, 30));
        world.addObject(new CylinderObject(new Point(-1, 0, -1), 0.4, 1));
        Surface surface = new Surface(0.2, 0.3, 0.2);
        Dynamics dynamics = new Dynamics(world, surface);
        List<String> robots = new ArrayList<>();
        for (int k = 0; robots.size() < 16; k++) {
            Point c = new Point(random.nextDouble(-2.7, 2.7), 0, random.nextDouble(-2.7, 2.7));
            GeometryObject robot = k % 3 == 0
                    ? new CylinderObject(c, 0.2, 0.4).moveable("r" + k)
                    : new BoxObject(c, 0.45, 0.4, 0.35)
                            .turned(0, random.nextDouble(360))
                            .moveable("r" + k);
            if (world.addObject(robot)) {
                robots.add("r" + k);
                Body body = Body.ofMass(robot, 20).withSurface(surface);
                dynamics.add("r" + k, robots.size() > 12 ? body.withFloorFriction(0.3) : body);
            }
        }
        for (int step = 0; step < STEPS; step++) {
            for (int k = 0; step % 40 == 0 && k < 12; k++) {
                dynamics.drive(
                        robots.get(k),
                        new DifferentialDrive(0.3, 1.5, 3)
                                .driving(random.nextDouble(0.2, 1), random.nextDouble(-60, 60)));
            }
            StepResult result = dynamics.step(0.05);
            stops.add(result, robots.size(), "step " + step);
            contacts += result.contacts().size();
            assertApart(world, step);
        }
    }

    private static void assertApart(Geometry world, int step) {
        List<GeometryObject> all = world.objects();
        for (int i = 0; i < all.size(); i++) {
            for (int j = 0; j < i; j++) {
                assertThat(CollisionDetection.intersects(all.get(i), all.get(j)))
                        .as(
                                "step %d: %s, %s",
                                step, all.get(i).name(), all.get(j).name())
                        .isFalse();
            }
        }
    }
}
