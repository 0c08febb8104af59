package robosim.geometry.dynamics;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import robosim.geometry.Geometry;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Twist;

/** Where bodies come to rest that the floor slows and that collide on the way, with steps of a second and of a millisecond. */
class RestTest {
    /** Metres: the floor acts in parts of 1/16 s, and a collision within one sees the mean speed; 0.027 is the most here. */
    private static final double BOUND = 0.05;

    /** A disc bounces off walls; a disc, a box and another disc hit each other as well. */
    @ParameterizedTest
    @ValueSource(ints = {1, 3})
    void bodiesThatMeetRestAtTheSamePlaces(int count) {
        double worst = 0;
        for (int run = 0; run < 20; run++) {
            worst = Math.max(worst, apart(rest(run, 1, count), rest(run, 1e-3, count)));
        }
        assertThat(worst).isBetween(BOUND / 10, BOUND);
    }

    private static double apart(List<Point> a, List<Point> b) {
        double most = 0;
        for (int k = 0; k < a.size(); k++) {
            most = Math.max(
                    most,
                    Math.hypot(
                            a.get(k).x() - b.get(k).x(), a.get(k).z() - b.get(k).z()));
        }
        return most;
    }

    private static List<Point> rest(int run, double seconds, int count) {
        SplittableRandom random = new SplittableRandom(run);
        Geometry world = new Geometry(4, 2, 4, Dimension.PLANAR, Accuracy.EXACT);
        Surface surface = new Surface(0.5, 0.2, 0.2);
        Dynamics dynamics = new Dynamics(world, surface);
        for (int k = 0; k < count; k++) {
            Point c = new Point(k - 1 + random.nextDouble(-0.1, 0.1), 0, random.nextDouble(-1, 1));
            GeometryObject shape = k % 2 == 0
                    ? new CylinderObject(c, 0.2, 1)
                    : new BoxObject(c, 0.4, 1, 0.3).turned(0, random.nextDouble(90));
            world.addObject(shape.moveable("b" + k));
            dynamics.add("b" + k, Body.ofMass(shape, 2).withSurface(surface).withFloorFriction(0.4));
            dynamics.setVelocity("b" + k, new Twist(random.nextDouble(-4, 4), 0, random.nextDouble(-4, 4), 0));
        }
        boolean isMoving = true;
        for (double time = 0; time < 20 && isMoving; time += seconds) {
            dynamics.advance(seconds);
            isMoving = dynamics.names().stream()
                    .anyMatch(name -> !dynamics.velocity(name).equals(new Twist(0, 0, 0, 0)));
        }
        assertThat(isMoving).isFalse();
        List<Point> places = new ArrayList<>();
        dynamics.names().forEach(name -> places.add(world.getObject(name).center()));
        return places;
    }
}
