package robosim.geometry.dynamics.proof;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import robosim.geometry.Geometry;
import robosim.geometry.dynamics.Body;
import robosim.geometry.dynamics.Dynamics;
import robosim.geometry.dynamics.Surface;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Twist;

/** Bodies that collide with nothing else around keep both momenta, however long they slide along each other. */
class FreePairTest {
    private final Geometry world = new Geometry(400, 5, 400, Dimension.PLANAR, Accuracy.EXACT);

    @ParameterizedTest
    @ValueSource(doubles = {0.001, 0.01, 0.02, 0.05, 0.1, 0.5})
    void keepsMomentumAndAngularMomentum(double seconds) {
        SplittableRandom random = new SplittableRandom(9);
        int met = 0;
        int runs = 40;
        for (int run = 0; run < runs; run++) {
            GeometryObject a = new BoxObject(new Point(-1, 0, 0), 0.6, 1, 0.4)
                    .turned(0, random.nextInt(360))
                    .moveable("a");
            GeometryObject b = new BoxObject(new Point(1, 0, random.nextInt(-60, 60) / 100.0), 0.5, 1, 0.5)
                    .turned(0, random.nextInt(360))
                    .moveable("b");
            assertThat(world.addObject(a) && world.addObject(b)).isTrue();
            double friction = random.nextInt(11) / 10.0;
            Surface surface = new Surface(random.nextInt(6) / 10.0, friction, friction);
            Dynamics dynamics = new Dynamics(world, surface);
            dynamics.add("a", Body.ofMass(a, 10).withSurface(surface));
            dynamics.add("b", Body.ofMass(b, 2).withSurface(surface));
            double heading = Math.toRadians(a.heading());
            dynamics.setVelocity("a", new Twist(Math.cos(heading), 0, Math.sin(heading), 0));
            double[] before = momenta(dynamics, List.of("a", "b"));
            boolean isMet = false;
            for (double time = 0; time < 4; time += seconds) {
                isMet |= !dynamics.step(seconds).contacts().isEmpty();
                assertThat(dynamics.last().stopped()).isEmpty();
            }
            met += isMet ? 1 : 0;
            double[] after = momenta(dynamics, List.of("a", "b"));
            for (int k = 0; k < 3; k++) {
                assertThat(Math.abs(after[k] - before[k]) / 10)
                        .as("run %d, %d of momentum along X, along Z, angular momentum", run, k)
                        .isLessThan(1e-12);
            }
            assertThat(after[3]).as("energy").isLessThan(before[3] * (1 + 1e-9));
            world.removeObject("a");
            world.removeObject("b");
        }
        assertThat(met).isGreaterThan(runs / 2);
    }

    /** Spinning boxes and discs that collide in a crowd, where ends of paths have to be put apart and bodies are delayed. */
    @ParameterizedTest
    @ValueSource(doubles = {0.02, 0.1, 0.5})
    void aCrowdKeepsMomentumAndAngularMomentum(double seconds) {
        SplittableRandom random = new SplittableRandom(1);
        int stopped = 0;
        int met = 0;
        int runs = 60;
        for (int run = 0; run < runs; run++) {
            double friction = random.nextInt(11) / 10.0;
            Surface surface = new Surface(random.nextInt(3) * random.nextInt(6) / 10.0, friction, 0.9 * friction);
            Dynamics dynamics = new Dynamics(world, surface);
            List<String> names = List.of("a", "b", "c", "d", "e").subList(0, 2 + run % 4);
            double mass = 0;
            for (String name : names) {
                GeometryObject object = add(random, name);
                Body body = Body.ofMass(object, Math.exp(random.nextDouble(-1, 2)));
                dynamics.add(name, body.withSurface(surface));
                mass += body.mass();
                double heading = Math.toRadians(object.heading());
                double vx = random.nextDouble(-0.5, 0.5) - object.center().x();
                double vz = random.nextDouble(-0.5, 0.5) - object.center().z();
                double ahead = vx * Math.cos(heading) - vz * Math.sin(heading);
                double aside = vz * Math.cos(heading) + vx * Math.sin(heading);
                dynamics.setVelocity(name, new Twist(ahead, 0, aside, random.nextDouble(-300, 300)));
            }
            double[] before = momenta(dynamics, names);
            boolean isMet = false;
            boolean isStopped = false;
            for (double time = 0; time < 3; time += seconds) {
                isMet |= !dynamics.step(seconds).contacts().isEmpty();
                isStopped |= !dynamics.last().stopped().isEmpty();
            }
            met += isMet ? 1 : 0;
            stopped += isStopped ? 1 : 0;
            double[] after = momenta(dynamics, names);
            for (int k = 0; k < 3 && !isStopped; k++) {
                assertThat(Math.abs(after[k] - before[k]) / mass)
                        .as("run %d, %d of momentum along X, along Z, angular momentum", run, k)
                        .isLessThan(1e-13);
            }
            assertThat(after[3]).as("energy").isLessThan(before[3] * (1 + 1e-12));
            names.forEach(world::removeObject);
        }
        assertThat(met).isGreaterThan(runs / 2);
        assertThat(stopped).isLessThanOrEqualTo(runs / 50); // these lose what they had, and are reported
    }

    private GeometryObject add(SplittableRandom random, String name) {
        while (true) {
            Point at = new Point(random.nextDouble(-1.5, 1.5), 0, random.nextDouble(-1.5, 1.5));
            double size = random.nextDouble(0.1, 0.3);
            GeometryObject shape = random.nextInt(4) == 0
                    ? new CylinderObject(at, size, 1)
                    : new BoxObject(at, 2 * size, 1, random.nextDouble(0.2, 1));
            GeometryObject object = shape.turned(0, random.nextDouble(360)).moveable(name);
            if (world.addObject(object)) {
                return object;
            }
        }
    }

    /** Momentum along X and Z, angular momentum about the origin, and energy. */
    private double[] momenta(Dynamics dynamics, List<String> names) {
        double[] sum = new double[4];
        for (String name : names) {
            Twist own = dynamics.velocity(name);
            GeometryObject object = world.getObject(name);
            double heading = Math.toRadians(object.heading());
            double vx = own.x() * Math.cos(heading) + own.z() * Math.sin(heading);
            double vz = own.z() * Math.cos(heading) - own.x() * Math.sin(heading);
            double w = Math.toRadians(own.ry());
            double m = dynamics.body(name).mass();
            double inertia = dynamics.body(name).inertia();
            sum[0] += m * vx;
            sum[1] += m * vz;
            sum[2] += inertia * w
                    + m * (object.center().z() * vx - object.center().x() * vz);
            sum[3] += 0.5 * m * (vx * vx + vz * vz) + 0.5 * inertia * w * w;
        }
        return sum;
    }
}
