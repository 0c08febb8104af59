package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.Geometry;
import robosim.geometry.SlideOptions;
import robosim.geometry.SlideResult;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CapsuleObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;

/** Objects that walk on ground: over sills, up and down slopes and steps, and not up what is too steep. */
class WalkerTest {
    /** What walks; each is 1 high and 0.3 to each side, but for the sphere. */
    enum Walker {
        BOX,
        CYLINDER,
        CAPSULE,
        SPHERE,
        ROVER;

        GeometryObject on(double x, double floor, double gap) {
            Point at = new Point(x, floor + gap + (this == SPHERE ? 0.3 : 0.5), 0);
            return switch (this) {
                case BOX -> new BoxObject(at, 0.6, 1, 0.6).moveable("robot");
                case CYLINDER -> new CylinderObject(at, 0.3, 1).moveable("robot");
                case CAPSULE -> new CapsuleObject(at, 0.3, 0.4).moveable("robot");
                case SPHERE -> new SphereObject(at, 0.3).moveable("robot");
                case ROVER ->
                    new ObjectGroup(List.of(
                                    new BoxObject(new Point(0, 0.1, 0), 0.5, 0.8, 0.4),
                                    new BoxObject(new Point(0, -0.4, 0.25), 0.6, 0.2, 0.1),
                                    new BoxObject(new Point(0, -0.4, -0.25), 0.6, 0.2, 0.1)))
                            .movedTo(at)
                            .moveable("robot");
            };
        }

        double height(Geometry world, double floor) {
            return world.getObject("robot").center().y() - floor - (this == SPHERE ? 0.3 : 0.5);
        }
    }

    private static Geometry floor() {
        Geometry world = new Geometry(60, 20, 60);
        world.addObject(new BoxObject(new Point(0, -0.5, 0), 50, 1, 50).named("floor"));
        return world;
    }

    private static SlideResult walk(Geometry world, int steps, double step, SlideOptions options) {
        SlideResult result = world.moveAndSlide("robot", new Move(), options);
        for (int k = 0; k < steps; k++) {
            result = world.moveAndSlide("robot", new Move(step, 0, 0, 0, 0), options);
        }
        return result;
    }

    @ParameterizedTest
    @EnumSource(Walker.class)
    void itCrossesASillAndComesBackToTheFloor(Walker walker) {
        for (double clearance : new double[] {0, 0.02}) {
            for (double step : new double[] {0.01, 0.05, 0.4}) {
                Geometry world = floor();
                world.addObjectUnchecked(new BoxObject(new Point(2, 0.05, 0), 0.2, 0.1, 10).named("sill"));
                assertThat(world.addObject(walker.on(0, 0, clearance + 1e-6))).isTrue();
                SlideOptions options = SlideOptions.clearance(clearance)
                        .stepHeight(0.15)
                        .maxSlope(30)
                        .snap(0.2);

                SlideResult last = walk(world, (int) Math.round(4 / step), step, options);

                String what = "%s clearance %s step %s: %s".formatted(walker, clearance, step, last);
                assertThat(world.getObject("robot").center().x()).as(what).isGreaterThan(3.8);
                assertThat(walker.height(world, 0)).as(what).isCloseTo(clearance, within(1e-3));
            }
        }
    }

    @ParameterizedTest
    @EnumSource(Walker.class)
    void aSillThatIsTooHighStopsIt(Walker walker) {
        Geometry world = floor();
        world.addObjectUnchecked(new BoxObject(new Point(2, 0.1, 0), 0.2, 0.2, 10).named("sill"));
        assertThat(world.addObject(walker.on(0, 0, 1e-6))).isTrue();
        SlideOptions options =
                SlideOptions.clearance(0).stepHeight(0.15).maxSlope(30).snap(0.2);

        SlideResult last = walk(world, 300, 0.02, options);

        assertThat(world.getObject("robot").center().x())
                .as(walker + ": " + last)
                .isLessThan(1.8);
        assertThat(walker.height(world, 0)).as(walker + ": " + last).isCloseTo(0, within(1e-3));
        assertThat(last.contacts().get(0).obstacle().name()).isEqualTo("sill");
    }

    @ParameterizedTest
    @EnumSource(Walker.class)
    void itWalksUpAndDownASlopeThatIsNotTooSteep(Walker walker) {
        Geometry world = floor();
        double sine = StrictMath.sin(StrictMath.toRadians(20));
        // Two planks that meet at the top, above x = 3.
        for (int side = -1; side <= 1; side += 2) {
            Point middle = new Point(3 + side * 2, 2 * StrictMath.tan(StrictMath.toRadians(20)) * 1 - 0.6, 0);
            double cosine = StrictMath.cos(StrictMath.toRadians(20));
            double s = -side * sine;
            world.addObjectUnchecked(
                    new BoxObject(middle, 4.6, 1, 10).oriented(new double[] {cosine, -s, 0, s, cosine, 0, 0, 0, 1}));
        }
        assertThat(world.addObject(walker.on(-2, 0, 1e-6))).isTrue();
        SlideOptions options =
                SlideOptions.clearance(0).stepHeight(0.1).maxSlope(30).snap(0.3);
        double highest = 0;
        for (int k = 0; k < 700; k++) {
            world.moveAndSlide("robot", new Move(0.02, 0, 0, 0, 0), options);
            highest = Math.max(highest, walker.height(world, 0));
            // On the ground all the time: the least gap is small.
            assertThat(world.getProximity("robot", 1)).as(walker + " step " + k).isLessThan(0.02);
        }
        assertThat(highest).isGreaterThan(0.5);
        assertThat(world.getObject("robot").center().x()).isGreaterThan(9);
        assertThat(walker.height(world, 0)).isCloseTo(0, within(1e-3));
    }

    @ParameterizedTest
    @EnumSource(Walker.class)
    void aSteepSlopeIsAWall(Walker walker) {
        Geometry world = floor();
        double cosine = StrictMath.cos(StrictMath.toRadians(50));
        double sine = StrictMath.sin(StrictMath.toRadians(50));
        world.addObjectUnchecked(new BoxObject(new Point(4, 1, 0), 6, 1, 10)
                .named("slope")
                .oriented(new double[] {cosine, -sine, 0, sine, cosine, 0, 0, 0, 1}));
        assertThat(world.addObject(walker.on(0, 0, 1e-6))).isTrue();
        SlideOptions options =
                SlideOptions.clearance(0).stepHeight(0.1).maxSlope(30).snap(0.2);

        for (int k = 0; k < 200; k++) {
            world.moveAndSlide("robot", new Move(0.02, 0, 0.01, 0, 0), options);
        }

        assertThat(walker.height(world, 0)).isLessThan(0.11);
        // It goes on along the foot of the slope.
        assertThat(world.getObject("robot").center().z()).isCloseTo(2, within(0.02));
    }

    @ParameterizedTest
    @EnumSource(Walker.class)
    void itClimbsStairsAndDescendsThem(Walker walker) {
        Geometry world = floor();
        for (int k = 0; k < 5; k++) {
            double high = 0.12 * (k + 1);
            world.addObjectUnchecked(new BoxObject(new Point(4, high / 2, 0), 6 - k, high, 10));
        }
        assertThat(world.addObject(walker.on(-1, 0, 1e-6))).isTrue();
        SlideOptions options =
                SlideOptions.clearance(0.01).stepHeight(0.15).maxSlope(30).snap(0.2);
        double highest = 0;
        for (int k = 0; k < 450; k++) {
            world.moveAndSlide("robot", new Move(0.02, 0, 0, 0, 0), options);
            highest = Math.max(highest, walker.height(world, 0));
        }
        assertThat(highest).as(walker + "").isBetween(0.6, 0.63);
        assertThat(world.getObject("robot").center().x()).as(walker + "").isGreaterThan(7.5);
        assertThat(walker.height(world, 0)).as(walker + "").isCloseTo(0.01, within(1e-3));
    }

    @Test
    void heightsDoNotCountInThePlane() {
        Geometry world = new Geometry(20, 20, 20, Dimension.PLANAR, Accuracy.EXACT);
        world.addObject(new BoxObject(new Point(3, 0, 0), 1, 0.1, 1).named("sill"));
        world.addObject(new BoxObject(new Point(0, 3, 0), 1, 1, 1).moveable("robot"));

        SlideResult result = world.moveAndSlide(
                "robot",
                new Move(5, 0, 0, 0, 0),
                SlideOptions.clearance(0.1).stepHeight(1).snap(1));

        assertThat(result.contacts()).hasSize(1);
        assertThat(world.getObject("robot").center().y()).isEqualTo(3);
        assertThat(world.getProximity("robot", 9)).isCloseTo(0.1, within(1e-12));
    }

    @Test
    void optionsOutOfRangeAreNamed() {
        SlideOptions options = SlideOptions.clearance(0.1);
        assertThatThrownBy(() -> options.bends(65)).hasMessage("bends must be from 0 to 64 (got: 65)");
        assertThatThrownBy(() -> options.stepHeight(-1)).hasMessageStartingWith("stepHeight must");
        assertThatThrownBy(() -> options.maxSlope(90.5)).hasMessageStartingWith("maxSlope must");
        assertThatThrownBy(() -> options.snap(Double.NaN)).hasMessageStartingWith("snap must");
        assertThatThrownBy(() -> SlideOptions.clearance(-1)).hasMessageStartingWith("clearance must");
    }
}
