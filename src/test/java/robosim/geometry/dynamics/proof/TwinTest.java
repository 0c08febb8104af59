package robosim.geometry.dynamics.proof;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.Effort;
import robosim.geometry.dynamics.Body;
import robosim.geometry.dynamics.StepResult;
import robosim.geometry.dynamics.StopCount;
import robosim.geometry.dynamics.Surface;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Twist;

/**
 * Steps beside their slow twin, until a few collisions have been made: each multiplies what was off before by the ratio of the
 * way to the size, some 10 here, so that 1e-10 metres are below 1e-6 after three or four.
 */
class TwinTest {
    private static final double BOUND = 1e-6;
    private static final int MOST_COLLISIONS = 4;

    private double worst;
    private int collisions;
    private int compared;
    private final StopCount stops = new StopCount();

    /** Discs with spin, restitution and friction, which also hit boxes that stand still. */
    @Test
    void discsAreWhereTheTwinHasThem() {
        SplittableRandom random = new SplittableRandom(11);
        for (int run = 0; run < Effort.cases(40); run++) {
            double friction = run % 2 == 0 ? 0 : random.nextDouble(0.1, 0.6);
            compare(random, new Surface(random.nextDouble(0.3, 1), friction, 0.8 * friction), 5, 0);
        }
        told(40);
    }

    /** Boxes and discs that turn, without friction. */
    @Test
    void boxesAreWhereTheTwinHasThem() {
        SplittableRandom random = new SplittableRandom(12);
        for (int run = 0; run < Effort.cases(40); run++) {
            compare(random, new Surface(random.nextDouble(0.3, 1), 0, 0), 4, 3);
        }
        told(40);
    }

    private void told(int runs) {
        assertThat(collisions).isGreaterThan(Effort.cases(runs));
        stops.assertAtMost(0);
        // A bound is not idle: something comes near it.
        assertThat(worst).isGreaterThan(1e-14);
    }

    private void compare(SplittableRandom random, Surface surface, int movers, int boxes) {
        StepScene scene = new StepScene(100, 100, surface);
        Twin twin = new Twin(movers + 1, surface);
        BoxObject block = new BoxObject(new Point(0, 0, 0), 1.5, 1, 1).turned(0, random.nextDouble(360));
        scene.wall(block);
        put(twin, movers, block, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY);
        for (int k = 0; k < movers; ) {
            double angle = random.nextDouble(2 * Math.PI);
            double far = random.nextDouble(2, 4);
            Point c = new Point(far * StrictMath.cos(angle), 0, far * StrictMath.sin(angle));
            GeometryObject shape = k < boxes
                    ? new BoxObject(c, random.nextDouble(0.4, 1), 1, random.nextDouble(0.4, 1))
                            .turned(0, random.nextDouble(360))
                    : new CylinderObject(c, random.nextDouble(0.2, 0.5), 1);
            Body body = Body.ofMass(shape, random.nextDouble(0.5, 4)).withSurface(surface);
            if (scene.body(shape, body) == null) {
                continue;
            }
            double ahead = random.nextDouble(0.5, 2);
            double turn = random.nextDouble(-100, 100);
            scene.velocity("b" + k, -ahead * c.x() + random.nextDouble(), -ahead * c.z() + random.nextDouble(), turn);
            put(twin, k, shape, body.mass(), body.inertia());
            twin.vx[k] = velocity(scene, k)[0];
            twin.vz[k] = velocity(scene, k)[1];
            twin.w[k] = StrictMath.toRadians(turn);
            k++;
        }
        for (int step = 0; step < 40 && twin.collisions <= MOST_COLLISIONS; step++) {
            double seconds = random.nextDouble(0.1);
            twin.run(seconds, MOST_COLLISIONS);
            scene.dynamics.advance(seconds);
            StepResult result = scene.dynamics.last();
            stops.add(result, movers, "step " + step);
            if (!result.stops().isEmpty()) {
                break; // the twin does not know of that
            }
            if (twin.collisions > MOST_COLLISIONS) {
                break;
            }
            for (int k = 0; k < movers; k++) {
                String what = "run with " + surface + ", step " + step + ", body " + k + " after " + twin.collisions;
                Point c = scene.center("b" + k);
                double off = Math.hypot(c.x() - twin.x[k], c.z() - twin.z[k]);
                assertThat(off).as(what).isLessThan(BOUND);
                double[] v = velocity(scene, k);
                assertThat(v[0]).as(what).isCloseTo(twin.vx[k], within(10 * BOUND));
                assertThat(v[1]).as(what).isCloseTo(twin.vz[k], within(10 * BOUND));
                assertThat(v[2]).as(what).isCloseTo(twin.w[k], within(20 * BOUND));
                worst = Math.max(worst, off);
                compared++;
            }
        }
        collisions += twin.collisions;
    }

    private static void put(Twin twin, int k, GeometryObject shape, double mass, double inertia) {
        twin.x[k] = shape.center().x();
        twin.z[k] = shape.center().z();
        twin.angle[k] = StrictMath.toRadians(shape.heading());
        if (shape instanceof BoxObject box) {
            double u = box.width() / 2;
            double v = box.length() / 2;
            twin.set(k, new double[] {u, v, -u, v, -u, -v, u, -v}, 0, mass, inertia);
        } else {
            twin.set(k, new double[] {0, 0}, ((CylinderObject) shape).radius(), mass, inertia);
        }
    }

    /** Along the world's axes, metres and radians a second. */
    private static double[] velocity(StepScene scene, int k) {
        Twist v = scene.dynamics.velocity("b" + k);
        double[] r = scene.world.getObject("b" + k).rotation();
        return new double[] {r[0] * v.x() + r[2] * v.z(), r[6] * v.x() + r[8] * v.z(), StrictMath.toRadians(v.ry())};
    }
}
