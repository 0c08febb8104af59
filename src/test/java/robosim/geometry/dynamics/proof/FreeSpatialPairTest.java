package robosim.geometry.dynamics.proof;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import robosim.geometry.Effort;
import robosim.geometry.Geometry;
import robosim.geometry.dynamics.Body;
import robosim.geometry.dynamics.Dynamics;
import robosim.geometry.dynamics.SpatialVelocity;
import robosim.geometry.dynamics.Surface;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CapsuleObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;

/** Two bodies of any shape that spin and collide in space, with no gravity and nothing else around, keep both momenta. */
@Tag("slow")
class FreeSpatialPairTest {
    /** Momentum, angular momentum about the origin, energy. */
    private static final int NUMBERS = 7;

    private static final double MASS_A = 3;
    private static final double MASS_B = 1;

    private final SplittableRandom random = new SplittableRandom(90);

    private GeometryObject any(int kind, Point at, String name) {
        double size = random.nextDouble(0.15, 0.5);
        double height = random.nextDouble(0.3, 1.2);
        GeometryObject shape = switch (kind) {
            case 0 -> new SphereObject(at, size);
            case 1 -> new BoxObject(at, 2 * size, height, random.nextDouble(0.3, 1));
            case 2 -> new CylinderObject(at, size, height);
            default -> new CapsuleObject(at, size / 2, height);
        };
        return shape.turned(random.nextDouble(90), random.nextDouble(360)).moveable(name);
    }

    private static double[] moments(GeometryObject object, double mass) {
        double x = object instanceof SphereObject ? 0.06 : 0.05;
        double z = object instanceof BoxObject ? 0.07 : x;
        return new double[] {mass * x, mass * 0.06, mass * z};
    }

    private SpatialVelocity velocity(double ahead) {
        return new SpatialVelocity(
                ahead, 0, 0, random.nextDouble(-120, 120), random.nextDouble(-120, 120), random.nextDouble(-120, 120));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.05, 0.5})
    void keepsMomentumAndAngularMomentum(double seconds) {
        int met = 0;
        int runs = Effort.cases(16, 5);
        for (int run = 0; run < runs; run++) {
            Geometry world = new Geometry(400, 400, 400);
            GeometryObject a = any(run % 4, new Point(-1.5, 0, 0), "a");
            GeometryObject b = any(
                    (run + run / 4) % 4, new Point(0, random.nextDouble(-0.3, 0.3), random.nextDouble(-0.3, 0.3)), "b");
            assertThat(world.addObject(a) && world.addObject(b)).isTrue();
            double friction = random.nextInt(11) / 10.0;
            Surface surface = new Surface(random.nextInt(6) / 5.0, friction, friction);
            Dynamics dynamics = new Dynamics(world, surface, new Point(0, 0, 0));
            add(dynamics, a, MASS_A, surface);
            add(dynamics, b, MASS_B, surface);
            dynamics.setSpatialVelocity("a", velocity(2));
            dynamics.setSpatialVelocity("b", velocity(0));
            double[] before = momenta(world, dynamics);
            boolean isMet = false;
            for (double time = 0; time < 1; time += seconds) {
                isMet |= !dynamics.step(seconds).contacts().isEmpty();
                assertThat(dynamics.last().stopped()).isEmpty();
            }
            met += isMet ? 1 : 0;
            double[] after = momenta(world, dynamics);
            for (int k = 0; k < 6; k++) {
                assertThat(Math.abs(after[k] - before[k]) / MASS_A)
                        .as("run %d, number %d: momentum, then angular momentum", run, k)
                        .isLessThan(1e-12);
            }
            assertThat(after[6]).as("energy, run %d", run).isLessThan(before[6] * (1 + 1e-7));
        }
        assertThat(met).isGreaterThan(runs / 2);
    }

    private static void add(Dynamics dynamics, GeometryObject object, double mass, Surface surface) {
        double[] own = moments(object, mass);
        Body body = Body.of(mass, own[1]).withInertia(own[0], own[1], own[2]);
        dynamics.add(object.name(), body.withSurface(surface));
    }

    private static double[] momenta(Geometry world, Dynamics dynamics) {
        double[] sum = new double[NUMBERS];
        for (String name : List.of("a", "b")) {
            GeometryObject object = world.getObject(name);
            double mass = dynamics.body(name).mass();
            SpatialVelocity velocity = dynamics.spatialVelocity(name);
            double[] v = {velocity.x(), velocity.y(), velocity.z()};
            double[] w = {Math.toRadians(velocity.rx()), Math.toRadians(velocity.ry()), Math.toRadians(velocity.rz())};
            double[] at = {
                object.center().x(), object.center().y(), object.center().z()
            };
            double[] own = moments(object, mass);
            double[] r = object.rotation();
            for (int k = 0; k < 3; k++) {
                int next = (k + 1) % 3;
                int last = (k + 2) % 3;
                sum[k] += mass * v[k];
                sum[3 + k] += mass * (at[next] * v[last] - at[last] * v[next]);
                double along = r[k] * w[0] + r[3 + k] * w[1] + r[6 + k] * w[2];
                for (int row = 0; row < 3; row++) {
                    sum[3 + row] += r[3 * row + k] * own[k] * along;
                }
                sum[6] += 0.5 * (own[k] * along * along + mass * v[k] * v[k]);
            }
        }
        return sum;
    }
}
