package robosim.geometry.dynamics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import robosim.geometry.Geometry;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;

/** A cart of 20 kg drives on a slab of 100 kg, which slides on a floor without friction: together they keep their momentum. */
@Tag("slow")
class CarriedDriveTest {
    private static final double GAP = 2e-8;

    private static final DifferentialDrive DRIVE = new DifferentialDrive(0.4, 1, 3);

    private Geometry world;
    private Dynamics dynamics;
    private final List<String> all = new ArrayList<>();

    @BeforeEach
    void build() {
        world = new Geometry(80, 40, 80, Dimension.SPATIAL, Accuracy.EXACT);
        world.addObject(new BoxObject(new Point(0, -0.5, 0), 60, 1, 60).named("floor"));
        dynamics = new Dynamics(world, new Surface(0, 0, 0));
    }

    private void add(GeometryObject object, Body body) {
        assertThat(world.addObject(object)).isTrue();
        dynamics.add(object.name(), body);
        all.add(object.name());
    }

    private void slabAndCart(double lift, double restitution, double z, double heading) {
        Surface surface = new Surface(restitution, 0.8, 0.7);
        add(
                new BoxObject(new Point(0, 0.1 + GAP + lift, 0), 6, 0.2, 4).moveable("slab"),
                Body.of(100, 433).withSurface(surface));
        add(
                new BoxObject(new Point(-1, 0.45 + 2 * GAP + lift, z), 0.6, 0.5, 0.4)
                        .turned(0, heading)
                        .moveable("cart"),
                Body.of(20, 1).withSurface(surface).withFloorFriction(0.8));
    }

    private double momentum(int axis) {
        double sum = 0;
        for (String name : all) {
            SpatialVelocity velocity = dynamics.spatialVelocity(name);
            sum += dynamics.body(name).mass() * (axis == 0 ? velocity.x() : velocity.z());
        }
        return sum;
    }

    private void assertKept(int steps) {
        double x = momentum(0);
        double z = momentum(2);
        double fastest = 0;
        for (int step = 0; step < steps; step++) {
            dynamics.advance(0.01);
            assertThat(momentum(0)).as("step " + step).isCloseTo(x, within(1e-9));
            assertThat(momentum(2)).as("step " + step).isCloseTo(z, within(1e-9));
            fastest =
                    Math.max(fastest, Math.abs(dynamics.spatialVelocity("slab").x()));
        }
        assertThat(fastest).isGreaterThan(0.05);
    }

    /** The slab goes back by a fifth of the way of the cart. */
    @ParameterizedTest
    @ValueSource(doubles = {0.7, 0.05, 0.0013})
    void theSlabGoesBackByTheRatioOfTheMasses(double seconds) {
        slabAndCart(0, 0, 0, 0);
        dynamics.drive("cart", DRIVE.driving(0.6, 0));
        for (int step = 0; step < 1.4 / seconds; step++) {
            dynamics.advance(seconds);
        }
        double goes = dynamics.spatialVelocity("cart").x();
        assertThat(goes).isCloseTo(0.5, within(1e-9)); // 0.6 as seen from the slab
        assertThat(dynamics.spatialVelocity("slab").x()).isCloseTo(-0.2 * goes, within(1e-9));
        double way = world.getObject("cart").center().x() + 1;
        assertThat(way).isGreaterThan(0.4);
        assertThat(world.getObject("slab").center().x()).isCloseTo(-0.2 * way, within(1e-9));
    }

    /** Each time it bounces it is given what is left of the reaction, and no more. */
    @ParameterizedTest
    @ValueSource(doubles = {0.011, 0.037, 0.06, 0.083})
    void alsoWhereTheSlabBounces(double lift) {
        slabAndCart(lift, 0.5, 0.2, 25);
        dynamics.drive("cart", DRIVE.driving(0.7, 10));
        assertKept(40);
    }

    @ParameterizedTest
    @ValueSource(doubles = {4.1, 5.3, 6.7})
    void alsoWhereBallsHitTheSlabAndTheCart(double speed) {
        slabAndCart(0, 0.5, 0.2, 15);
        Body ball = Body.of(5, 0.1).withSurface(new Surface(0.5, 0, 0));
        add(new SphereObject(new Point(-3.5, 0.15 + GAP, 0), 0.15).moveable("low"), ball);
        add(new SphereObject(new Point(1.5, 0.35 + 2 * GAP, 0.2), 0.15).moveable("high"), ball);
        dynamics.setSpatialVelocity("low", new SpatialVelocity(speed, 0, 0, 0, 0, 0));
        dynamics.setSpatialVelocity("high", new SpatialVelocity(-speed / 2, 0, 0, 0, 0, 0));
        dynamics.drive("cart", DRIVE.driving(0.7, 5));
        assertKept(40);
    }

    @Test
    void aSlabOnSomethingThatStandsStillStays() {
        slabAndCart(0, 0, 0, 0);
        dynamics.surface("floor", new Surface(0, 0.8, 0.8));
        dynamics.drive("cart", DRIVE.driving(0.6, 0));
        dynamics.step(1);
        assertThat(dynamics.spatialVelocity("cart").x()).isCloseTo(0.6, within(1e-6));
        assertThat(world.getObject("slab").center().x()).isCloseTo(0, within(1e-6));
    }
}
