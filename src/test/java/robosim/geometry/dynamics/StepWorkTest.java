package robosim.geometry.dynamics;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.Geometry;
import robosim.geometry.collision.CollisionDetection;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.Twist;

/** How much work steps are, in parts between which they can be ended: no clock is read. */
class StepWorkTest {
    private static final Surface BALL = new Surface(0.3, 0.3, 0.2);

    private final Geometry world = new Geometry(1.4, 3, 1.4, Dimension.PLANAR, Accuracy.EXACT);
    private final Dynamics dynamics = new Dynamics(world, BALL);
    private long parts;

    private void add(GeometryObject object, Body body) {
        assertThat(world.addObject(object)).isTrue();
        dynamics.add(object.name(), body.withSurface(BALL));
    }

    private static CylinderObject ball(String name, double x, double z) {
        return new CylinderObject(new Point(x, 0, z), 0.075, 0.15).moveable(name);
    }

    /** Six balls are caught in a robot shaped like a U and jam between it and the walls: those that wait try a few times only. */
    @Test
    void aHookThatTurnsOverBallsHasLittleWork() {
        add(
                new ObjectGroup(List.of(
                                new BoxObject(new Point(-0.4, 0, 0), 0.1, 0.5, 0.9),
                                new BoxObject(new Point(0.05, 0, -0.4), 0.8, 0.5, 0.1),
                                new BoxObject(new Point(0.05, 0, 0.4), 0.8, 0.5, 0.1)))
                        .moveable("robot"),
                Body.of(50, 6.75));
        SplittableRandom random = new SplittableRandom(5);
        for (int balls = 0; balls < 6; ) {
            GeometryObject ball = ball("ball" + balls, random.nextDouble(-0.6, 0.6), random.nextDouble(-0.6, 0.6));
            if (world.addObject(ball)) {
                dynamics.add(
                        ball.name(), Body.ofMass(ball, 0.2).withSurface(BALL).withDamping(0.5, 0.5));
                balls++;
            }
        }
        dynamics.pausing(() -> parts++);
        long most = 0;
        for (int step = 0; step < 300; step++) {
            double turn = step / 100 % 2 == 0 ? 180 : -180;
            dynamics.drive("robot", new OmnidirectionalDrive(5, 8, 360, 1500).driving(0, 0, turn));
            long before = parts;
            dynamics.advance(0.02);
            most = Math.max(most, parts - before);
        }
        assertThat(most).isBetween(100L, 8000L); // 6,752; without that limit 11,146
        assertThat(parts).isLessThan(200_000); // 154,778; 373,817
        List<GeometryObject> all = world.objects();
        for (int i = 0; i < all.size(); i++) {
            for (int j = 0; j < i; j++) {
                assertThat(CollisionDetection.intersects(all.get(i), all.get(j)))
                        .isFalse();
            }
        }
    }

    /** A ball that rolls along the side of a robot which turns meets it once or twice a step, not at every small angle. */
    @Test
    void aBallAlongATurningSideMeetsItOnce() {
        GeometryObject robot = new BoxObject(new Point(-0.5, 0, 0), 0.3, 0.5, 0.9).moveable("robot");
        world.addObject(robot);
        dynamics.add("robot", Body.of(50, 6.75));
        world.addObject(ball("ball", -0.27, 0.1));
        dynamics.add("ball", Body.of(0.2, 0.001).withDamping(5, 5));
        dynamics.pausing(() -> parts++);
        for (int step = 0; step < 30; step++) {
            dynamics.drive("robot", new OmnidirectionalDrive(5, 80, 360, 15000).driving(0.5, 0, 60));
            dynamics.advance(0.02);
        }
        assertThat(dynamics.last().contacts()).hasSize(1);
        assertThat(parts).isBetween(300L, 1800L); // 1,209; where each collision only ends the approach, 2,689
    }

    /** A ball that is pressed against a wall does not bounce between it and the robot for ever faster. */
    @Test
    void aBallBetweenARobotAndAWallComesToRest() {
        add(new BoxObject(new Point(-0.2, 0, 0), 0.3, 0.5, 0.9).moveable("robot"), Body.of(50, 6.75));
        add(ball("ball", 0.5, 0), Body.of(0.2, 0.001));
        dynamics.setVelocity("ball", new Twist(0.1, 0, 0, 0));
        dynamics.pausing(() -> parts++);
        for (int step = 0; step < 50; step++) {
            dynamics.drive("robot", new OmnidirectionalDrive(5, 8, 360, 1500).driving(1, 0, 0));
            dynamics.advance(0.02);
        }
        assertThat(parts).isBetween(300L, 1800L); // 925; where it bounces each time, 2,817
        assertThat(Math.abs(dynamics.velocity("ball").x())).isLessThan(1e-6);
    }
}
