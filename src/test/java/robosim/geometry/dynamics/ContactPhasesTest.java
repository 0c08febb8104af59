package robosim.geometry.dynamics;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.Geometry;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;

/** The phases of a cart's contact with the crate that it pushes, while the world changes between two steps. */
@Tag("slow")
class ContactPhasesTest {
    private static final Body CRATE = Body.of(5, 0.2).withFloorFriction(0.3);

    private Geometry world;
    private Dynamics dynamics;

    private static GeometryObject box(double x, double z) {
        return new BoxObject(new Point(x, 1e-7, z), 0.6, 1, 0.6);
    }

    private void pushing(Dimension dimension) {
        world = new Geometry(60, 5, 60, dimension, Accuracy.EXACT);
        if (dimension == Dimension.SPATIAL) {
            world.addObject(new BoxObject(new Point(0, -1, 0), 58, 1, 58).named("floor"));
        }
        world.addObject(box(0, 0).moveable("cart"));
        world.addObject(box(1, 0).moveable("crate"));
        world.addObject(box(20, 20).moveable("far"));
        world.addObject(box(-20, 20).named("post"));
        dynamics = new Dynamics(world, new Surface(0, 0.3, 0.3));
        dynamics.add("cart", Body.of(20, 1).withFloorFriction(0.9));
        dynamics.add("crate", CRATE);
        dynamics.drive("cart", new DifferentialDrive(0.5, 1, 5).driving(0.5, 0));
        for (int step = 0; step < 40; step++) {
            dynamics.step(0.05);
        }
        assertThat(phases(dynamics.last())).containsExactly("cart-crate LAST");
    }

    private static List<String> phases(StepResult step) {
        List<BodyContact> all = new ArrayList<>(step.contacts());
        all.addAll(step.ended());
        return all.stream()
                .filter(each -> !"floor".equals(each.other()))
                .map(each -> each.body() + "-" + each.other() + " " + each.phase())
                .toList();
    }

    private void assertNext(String... expected) {
        assertThat(phases(dynamics.step(0.05))).containsExactly(expected);
    }

    @ParameterizedTest
    @EnumSource
    void goesOnWhatTheChangeDoesNotConcern(Dimension dimension) {
        pushing(dimension);
        world.addObject(box(20, -20).named("new"));
        assertNext("cart-crate LAST");
        world.removeObject("post");
        assertNext("cart-crate LAST");
        dynamics.add("far", CRATE);
        assertNext("cart-crate LAST");
        dynamics.add("crate", CRATE);
        assertNext("cart-crate LAST");
        dynamics.remove("far");
        assertNext("cart-crate LAST");
    }

    @ParameterizedTest
    @EnumSource
    void goesOnWithWhatLosesItsBody(Dimension dimension) {
        pushing(dimension);
        dynamics.remove("crate");
        assertNext("cart-crate LAST");
    }

    @ParameterizedTest
    @EnumSource
    void endsOnceWhereTheOtherIsRemoved(Dimension dimension) {
        pushing(dimension);
        world.removeObject("crate");
        assertThat(phases(dynamics.last())).containsExactly("cart-crate LAST");
        assertNext("cart-crate END");
        assertNext();
    }

    @ParameterizedTest
    @EnumSource
    void endsWhereTheOtherIsPlacedAway(Dimension dimension) {
        pushing(dimension);
        world.placeObject("crate", new Point(10, 1e-7, 0), 0);
        assertNext("cart-crate END");
        assertNext();
    }

    /** Its id may be that of the one before. */
    @ParameterizedTest
    @EnumSource
    void beginsWithAnotherOfTheSameNameInItsPlace(Dimension dimension) {
        pushing(dimension);
        GeometryObject crate = world.getObject("crate");
        world.removeObject("crate");
        world.addObject(crate);
        dynamics.add("crate", CRATE);
        List<String> phases = phases(dynamics.step(0.05));
        assertThat(phases).contains("cart-crate BEGIN");
    }

    @ParameterizedTest
    @EnumSource
    void endsOnceWhereNoBodyIsLeft(Dimension dimension) {
        pushing(dimension);
        world.removeObject("cart");
        world.removeObject("crate");
        assertNext("cart-crate END");
        assertNext();
        assertNext();
    }
}
