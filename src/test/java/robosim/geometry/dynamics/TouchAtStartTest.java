package robosim.geometry.dynamics;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import robosim.geometry.Geometry;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CapsuleObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;

/** Bodies in space that begin in exact contact, as files and programs put them: half their height above the floor. */
class TouchAtStartTest {
    private static final double STEP = 0.05;

    private static Geometry floor() {
        Geometry world = new Geometry(20, 6, 20);
        world.addObject(new BoxObject(new Point(0, -0.5, 0), 19, 1, 19).named("floor"));
        return world;
    }

    private static StepResult run(Dynamics dynamics, int steps) {
        StepResult last = dynamics.step(STEP);
        for (int k = 1; k < steps; k++) {
            last = dynamics.step(STEP);
        }
        return last;
    }

    static List<GeometryObject> shapes() {
        return List.of(
                new CylinderObject(new Point(0, 0.25, 0), 0.25, 0.5),
                new CylinderObject(new Point(0, 0.25, 0), 0.25, 0.5).turned(0, 89.9544),
                new BoxObject(new Point(0, 0.25, 0), 0.5, 0.5, 0.375),
                new SphereObject(new Point(0, 0.25, 0), 0.25),
                new CapsuleObject(new Point(0, 0.5, 0), 0.25, 0.5));
    }

    @ParameterizedTest
    @MethodSource("shapes")
    void aRobotDrivesOnTheFloorThatItTouches(GeometryObject shape) {
        Geometry world = floor();
        assertThat(world.addObject(shape.moveable("cart"))).as("it touches").isFalse();
        assertThat(world.addObjectUnchecked(shape.moveable("cart"))).isTrue();
        Dynamics dynamics = new Dynamics(world, new Surface(0, 0.5, 0.5));
        dynamics.add("cart", Body.of(20, 1).withFloorFriction(0.5));
        dynamics.drive("cart", new OmnidirectionalDrive(1, 10, 90, 900).driving(0.5, 0, 0));
        StepResult last = run(dynamics, 40);
        assertThat(last.stopped()).isEmpty();
        Point center = world.getObject("cart").center();
        assertThat(Math.hypot(center.x(), center.z())).isBetween(0.95, 1.0);
        assertThat(world.getProximity("cart", 1)).isPositive();
    }

    /** In a corner, against two walls and the floor, all touched exactly. */
    @Test
    void itDrivesOutOfACorner() {
        Geometry world = floor();
        world.addObjectUnchecked(new BoxObject(new Point(0.5, 1, 0), 0.5, 2, 4).named("ahead"));
        world.addObjectUnchecked(new BoxObject(new Point(0, 1, 0.5), 4, 2, 0.5).named("right"));
        world.addObjectUnchecked(new BoxObject(new Point(0, 0.25, 0), 0.5, 0.5, 0.5).moveable("cart"));
        Dynamics dynamics = new Dynamics(world, new Surface(0, 0.5, 0.5));
        dynamics.add("cart", Body.of(20, 1).withFloorFriction(0.5));
        dynamics.drive("cart", new OmnidirectionalDrive(1, 10, 90, 900).driving(-0.5, -0.5, 0));
        assertThat(run(dynamics, 20).stopped()).isEmpty();
        assertThat(world.getObject("cart").center().x()).isLessThan(-0.3);
        assertThat(world.getObject("cart").center().z()).isLessThan(-0.3);
    }

    /** What overlaps stays where it is, and is told. */
    @Test
    void whatOverlapsIsStopped() {
        Geometry world = floor();
        world.addObjectUnchecked(new BoxObject(new Point(0, 0.125, 0), 0.5, 0.5, 0.5).moveable("cart"));
        Dynamics dynamics = new Dynamics(world, new Surface(0, 0.5, 0.5));
        dynamics.add("cart", Body.of(20, 1));
        StepResult last = run(dynamics, 3);
        assertThat(last.stopped()).containsExactly("cart");
        assertThat(last.stops()).containsExactly(new StepResult.Stop("cart", StepResult.Reason.OVERLAP, "floor"));
        assertThat(world.getObject("cart").center().y()).isBetween(0.125, 0.1250001);
    }

    /** Where others put it in contact between two steps. */
    @Test
    void itGoesOnWhereItIsPut() {
        Geometry world = floor();
        world.addObject(new BoxObject(new Point(0, 1, 0), 0.5, 0.5, 0.5).moveable("crate"));
        Dynamics dynamics = new Dynamics(world, new Surface(0, 0.5, 0.5));
        dynamics.add("crate", Body.of(20, 1));
        run(dynamics, 20);
        world.removeObject("crate");
        world.addObjectUnchecked(new BoxObject(new Point(1, 0.25, 0), 0.5, 0.5, 0.5).moveable("crate"));
        dynamics.add("crate", Body.of(20, 1));
        dynamics.setSpatialVelocity("crate", new SpatialVelocity(1, 0, 0, 0, 0, 0));
        assertThat(run(dynamics, 10).stopped()).isEmpty();
        assertThat(world.getObject("crate").center().x()).isGreaterThan(1.05);
    }

    /** A shape packed in exact contact; where one is, in the middle of a layer. */
    private record Packed(GeometryObject shape, double size, boolean isHexagonal, double turned) {
        GeometryObject at(int i, int j) {
            double x = size * (i + (isHexagonal ? 0.5 * (j % 2) : 0));
            double z = size * j * (isHexagonal ? Math.sqrt(0.75) : 1);
            double cos = Math.cos(Math.toRadians(turned));
            double sin = Math.sin(Math.toRadians(turned));
            return shape.movedTo(new Point(x * cos + z * sin, shape.center().y(), z * cos - x * sin));
        }
    }

    private static final Point LOW = new Point(0, 0.5, 0);

    static List<Packed> packs() {
        List<Packed> all = new ArrayList<>();
        for (boolean isHexagonal : new boolean[] {false, true}) {
            for (double r : new double[] {0.5, 0.3}) {
                all.add(new Packed(new SphereObject(new Point(0, r, 0), r), 2 * r, isHexagonal, 0));
                all.add(new Packed(new SphereObject(new Point(0, r, 0), r), 2 * r, isHexagonal, 20));
            }
            all.add(new Packed(new CylinderObject(LOW, 0.5, 1), 1, isHexagonal, 0));
            all.add(new Packed(new CapsuleObject(new Point(0, 1, 0), 0.5, 1), 1, isHexagonal, 10));
        }
        all.add(new Packed(new CylinderObject(LOW, 0.5, 1).turned(90, 0), 1, false, 0));
        all.add(new Packed(new BoxObject(LOW, 1, 1, 1), 1, false, 0));
        all.add(new Packed(new BoxObject(LOW, 1, 1, 1).turned(0, 30), 1, false, 30));
        all.add(new Packed(new BoxObject(new Point(0, 0.05, 0), 1, 0.1, 1), 1, false, 0));
        return all;
    }

    /** In a corner, too, nobody has to make room by more than a few gaps: that is no reason to stop anybody. */
    @ParameterizedTest
    @MethodSource("packs")
    void whatIsPackedInExactContactIsAtRest(Packed pack) {
        int[] sizes = pack.shape instanceof SphereObject ? new int[] {3, 4, 8} : new int[] {4};
        for (int columns : sizes) {
            Geometry world = floor();
            if (columns == 3 && pack.turned == 0) { // in a corner
                double side = -pack.size / 2 - 0.5;
                world.addObjectUnchecked(new BoxObject(new Point(side, 1, 0), 1, 1.9, 8));
                world.addObjectUnchecked(new BoxObject(new Point(1, 1, side), 8, 1.9, 1));
            }
            Dynamics dynamics = new Dynamics(world, new Surface(0.2, 0.5, 0.4));
            for (int k = 0; k < 4 * columns; k++) {
                GeometryObject body = pack.at(k / 4, k % 4).moveable("b" + k);
                assertThat(world.addObjectUnchecked(body)).isTrue();
                dynamics.add("b" + k, Body.ofMass(body, 2));
            }
            for (int step = 0; step < 2; step++) {
                assertThat(dynamics.step(0.001).stops())
                        .as("%d columns", columns)
                        .isEmpty();
            }
            for (int k = 0; k < 4 * columns; k++) {
                Point was = pack.at(k / 4, k % 4).center();
                Point is = world.getObject("b" + k).center();
                double moved = Math.max(Math.abs(is.y() - was.y()), Math.hypot(is.x() - was.x(), is.z() - was.z()));
                assertThat(moved).isLessThan(1e-6);
            }
        }
    }
}
