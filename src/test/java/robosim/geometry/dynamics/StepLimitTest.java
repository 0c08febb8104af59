package robosim.geometry.dynamics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import robosim.geometry.Effort;
import robosim.geometry.Geometry;
import robosim.geometry.WorkLimit;
import robosim.geometry.WorkLimitException;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;
import robosim.geometry.model.Twist;

/** A step that is ended by its limit of work, or by whatever runs between its parts, leaves no trace. */
class StepLimitTest {
    private static final int BODIES = 9;

    private static Geometry room(boolean isFlat) {
        return new Geometry(8, 6, 8, isFlat ? Dimension.PLANAR : Dimension.SPATIAL, Accuracy.EXACT);
    }

    private static Dynamics crowd(Geometry world) {
        boolean isFlat = world.dimension() == Dimension.PLANAR;
        world.addObject(new BoxObject(new Point(0, -2, 0), isFlat ? 0.2 : 8, 1, isFlat ? 2 : 8).named("floor"));
        Dynamics dynamics = new Dynamics(world, new Surface(0.3, 0.4, 0.3));
        for (int k = 0; k < BODIES; k++) {
            String name = "body " + k;
            Point at = new Point(k % 3 - 1.2, isFlat ? 0 : -1.2 + 0.5 * (k / 3), k / 3 - 1);
            world.addObjectUnchecked(
                    k % 2 == 0
                            ? new BoxObject(at, 0.5, 0.4, 0.6).moveable(name)
                            : isFlat
                                    ? new CylinderObject(at, 0.3, 0.5).moveable(name)
                                    : new SphereObject(at, 0.25).moveable(name));
            dynamics.add(name, Body.ofMass(world.getObject(name), 1 + k).withFloorFriction(k % 4 == 0 ? 0.1 : 0));
            dynamics.setVelocity(name, new Twist(2 - k % 3, 0, 1 - k % 4, 20 * k));
        }
        dynamics.drive("body 4", new ForceDrive(30, 0, 2));
        dynamics.drive("body 8", new DifferentialDrive(0.5, 2, 3).driving(1, 20));
        return dynamics;
    }

    /** All that can be asked about a world and its bodies. */
    private static String state(Dynamics dynamics, Geometry world) {
        StringBuilder all = new StringBuilder(dynamics.last().toString());
        for (String name : dynamics.names()) {
            all.append(world.getObject(name))
                    .append(world.getObject(name).pose())
                    .append(dynamics.velocity(name));
        }
        return all.toString();
    }

    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void aStepThatIsEndedAnywhereLeavesNoTrace(boolean isFlat) {
        Geometry world = room(isFlat);
        Geometry other = room(isFlat);
        Dynamics dynamics = crowd(world);
        Dynamics twin = crowd(other);
        int ended = 0;
        for (int k = 0; k < Effort.cases(12, 6); k++) {
            long limit = k;
            boolean isMade = false;
            while (!isMade) {
                world.limitWork(WorkLimit.none());
                String before = state(dynamics, world);
                world.limitWork(WorkLimit.of(limit));
                WorkLimitException refused = catchThrowableOfType(WorkLimitException.class, () -> dynamics.step(0.07));
                world.limitWork(WorkLimit.none());
                isMade = refused == null;
                if (!isMade) {
                    ended++;
                    assertThat(refused).hasMessageStartingWith("a step must take at most " + limit + " units");
                    assertThat(state(dynamics, world)).isEqualTo(before);
                }
                limit = 5 * limit + 40;
            }
            twin.step(0.07);
            assertThat(state(dynamics, world)).isEqualTo(state(twin, other));
        }
        assertThat(ended).isGreaterThan(10);
    }

    @Test
    void whatRunsBetweenPartsMayEndAStep() {
        Geometry world = room(false);
        Dynamics dynamics = crowd(world);
        dynamics.step(0.1);
        String before = state(dynamics, world);
        int[] left = {100};
        dynamics.pausing(() -> {
            if (left[0]-- == 0) {
                throw new IllegalStateException("enough");
            }
        });
        assertThat(catchThrowableOfType(IllegalStateException.class, () -> dynamics.step(1)))
                .hasMessage("enough");
        dynamics.pausing(() -> {});
        assertThat(state(dynamics, world)).isEqualTo(before);
    }
}
