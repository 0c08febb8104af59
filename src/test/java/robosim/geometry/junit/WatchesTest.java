package robosim.geometry.junit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.opentest4j.AssertionFailedError;
import robosim.geometry.Geometry;
import robosim.geometry.dynamics.VelocityDrive;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.Point;
import robosim.geometry.model.Twist;

/** A robot that must touch nothing at all, or nothing but some objects. */
class WatchesTest {
    private final RobotWorld world = RobotWorld.of(Worlds.wallAhead());
    private final Robot r1 = world.robot("r1");

    @Test
    void whatStopsItIsTold() {
        r1.neverTouchesAnything().drives(2).turns(90).turns(-90);
        world.clock().advance(30);
        assertThatThrownBy(() -> r1.triesToDrive(2))
                .isInstanceOf(AssertionFailedError.class)
                .hasMessage(
                        "robot \"r1\" must never touch anything, but robot \"r1\" was to drive 2 in step 30 (after 3 s)"
                                + " and was blocked after 1 of 2 by box \"wall\" at (4, 0, 0), where it touches (3.5, 0, 0); it"
                                + " stands at (2, 0, 0), heading 0");
        assertThatThrownBy(r1::neverTouchesAnything)
                .as("what happened before counts")
                .isInstanceOf(AssertionFailedError.class);
        r1.neverTouchesAnythingBut("wall");
    }

    @Test
    void theBorderOfTheWorldIsSomething() {
        r1.neverTouchesAnything();
        assertThatThrownBy(() -> r1.triesToDrive(-30)).hasMessageContaining("by the border of the world");
    }

    @Test
    void whatHasNoNameIsSomething() {
        world.geometry().addObject(new BoxObject(new Point(-3, 0, 0), 1, 1, 1));
        r1.neverTouchesAnythingBut("wall", "r2");
        assertThatThrownBy(() -> r1.triesToDrive(-4)).hasMessageContaining("by box without a name at (-3, 0, 0)");
    }

    @Test
    void whatTouchesWithoutAMoveIsSeen() {
        world.geometry().addObjectUnchecked(new BoxObject(new Point(0.5, 0, 0), 0.5, 1, 0.1).named("thing"));
        assertThatThrownBy(r1::neverTouchesAnything)
                .isInstanceOf(AssertionFailedError.class)
                .hasMessageMatching(
                        "robot \"r1\" must never touch anything, but it touches box \"thing\" at \\(0.5, 0, 0\\),"
                                + " at \\(0\\.[0-9]+, [-.0-9]+, [-.0-9]+\\); it stands at \\(0, 0, 0\\), heading 0");
        r1.neverTouchesAnythingBut("thing").turns(30);
    }

    @Test
    void anotherRobotThatRunsIntoItIsSeen() {
        r1.neverTouchesAnything();
        Robot r2 = world.robot("r2");
        double x = r1.center().x() - r2.center().x();
        double z = r1.center().z() - r2.center().z();
        r2.turns(Math.toDegrees(Math.atan2(-z, x)));
        assertThatThrownBy(() -> r2.triesToDrive(Math.hypot(x, z)))
                .isInstanceOf(AssertionFailedError.class)
                .hasMessageContaining("robot \"r1\" must never touch anything, but robot \"r2\" was to drive");
    }

    @Test
    void aMistypedExceptionIsAnError() {
        assertThatThrownBy(() -> r1.neverTouchesAnythingBut("wal"))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("name must be that of an object, one of [")
                .hasMessageContaining("\"wal\"");
    }

    private static Geometry arena(Dimension dimension) {
        Geometry arena = new Geometry(20, 4, 20, dimension, Accuracy.EXACT);
        arena.addObject(new BoxObject(new Point(6, 0, 0), 1, 2, 8));
        arena.addObject(new BoxObject(new Point(2, -1.5, 0), 1, 1, 1).moveable("crate"));
        arena.addObject(new BoxObject(new Point(0, dimension == Dimension.SPATIAL ? -1.45 : -1.5, 0), 1, 1, 1)
                .moveable("cart"));
        return arena;
    }

    @Test
    void whatADrivenRobotMeetsIsTold() {
        RobotWorld arena = RobotWorld.of(arena(Dimension.PLANAR));
        Robot cart = arena.robot("cart").neverTouchesAnything();
        assertThatThrownBy(() -> cart.drives(1, 0).forSeconds(3))
                .isInstanceOf(AssertionFailedError.class)
                .hasMessageContaining(
                        "robot \"cart\" must never touch anything, but it met box \"crate\" in step 10 (after 1 s)"
                                + " at (1.5, -1.5, ");
    }

    @Test
    void whatIsMetWithoutANameIsFound() {
        RobotWorld arena = RobotWorld.of(arena(Dimension.PLANAR));
        arena.geometry().removeObject("crate");
        Robot cart = arena.robot("cart").neverTouchesAnything();
        assertThatThrownBy(() -> cart.drives(1, 0).forSeconds(6))
                .hasMessageContaining("it met box without a name at (6, 0, 0) in step ")
                .hasMessageContaining(" at (5.5, ");
        RobotWorld other = RobotWorld.of(arena(Dimension.PLANAR));
        Robot back = other.robot("cart").neverTouchesAnything();
        assertThatThrownBy(() -> back.drives(-1, 0).forSeconds(12))
                .hasMessageContaining("it met the border of the world in step ");
    }

    /** It falls onto the lower border of the world, and stands there. */
    @Test
    void theGroundIsNothing() {
        RobotWorld arena = RobotWorld.of(arena(Dimension.SPATIAL));
        Robot cart = arena.robot("cart").neverTouchesAnything();
        cart.drives(0.5, 0).forSeconds(1);
        cart.hitsNothing();
        assertThatThrownBy(() -> cart.hits("crate")).hasMessageContaining(", but has met nothing; it stands ");
        assertThatThrownBy(() -> cart.drives(0.5, 0).forSeconds(3))
                .hasMessageContaining("it met box \"crate\" in step ");
        assertThatThrownBy(cart::hitsNothing)
                .hasMessageContaining(" was to hit nothing, but has met box \"crate\" in step ");
    }

    /** The border is no ground where it stands upright, and what has no name is told by where it is. */
    @Test
    void theBorderAndWhatHasNoNameAreMet() {
        Geometry world = new Geometry(10, 4, 10);
        world.addObject(new CylinderObject(new Point(-3, -1.7, 0), 0.3, 0.5).moveable("left"));
        world.addObject(new CylinderObject(new Point(-3, -1.7, 3), 0.3, 0.5).moveable("right"));
        world.addObject(new BoxObject(new Point(0, -1, 3), 1, 2, 1));
        RobotWorld arena = RobotWorld.of(world);
        Robot left = arena.robot("left").drives(-1, 0).forSeconds(3);
        assertThatThrownBy(left::hitsNothing).hasMessageContaining("has met the border of the world in step ");
        Robot right = arena.robot("right").drives(1, 0).forSeconds(3);
        assertThatThrownBy(right::hitsNothing)
                .hasMessageContaining("has met box without a name at (0, -1, 3) in step ");
    }

    @Test
    void aFloorDoesNotCount() {
        Geometry hall = new Geometry(20, 4, 20, Dimension.SPATIAL, Accuracy.EXACT);
        hall.addObject(new BoxObject(new Point(0, -1, 0), 10, 1, 10).named("floor"));
        hall.addObject(new CylinderObject(new Point(0, 0.01, 0), 0.3, 1).moveable("drum"));
        RobotWorld world = RobotWorld.of(hall);
        Robot drum = world.robot("drum")
                .hasDrive(new VelocityDrive(new Twist(0, 0, 0, 0)))
                .neverTouchesAnythingBut("floor");
        drum.drives(0.5, 0, 0).forSeconds(2).hits("floor");
        assertThat(drum.center().x()).isGreaterThan(0.5);
        drum.neverTouchesAnything();
        hall.addObjectUnchecked(new BoxObject(drum.center(), 0.1, 0.1, 0.1).named("thorn"));
        assertThatThrownBy(drum::neverTouchesAnything).hasMessageContaining("it touches box \"thorn\"");
    }

    /** What carries a robot does not count; what it is sunk in, leans on or stands beside does. */
    @Test
    void whatItIsSunkInDoesCount() {
        for (double y : new double[] {0, -0.01}) {
            Geometry hall = new Geometry(20, 4, 20, Dimension.SPATIAL, Accuracy.EXACT);
            hall.addObject(new BoxObject(new Point(0, -1, 0), 10, 1, 10).named("floor"));
            hall.addObjectUnchecked(new CylinderObject(new Point(0, y, 0), 0.3, 1).moveable("drum"));
            Robot drum = RobotWorld.of(hall).robot("drum");
            if (y == 0) {
                drum.neverTouchesAnything();
            } else {
                assertThatThrownBy(drum::neverTouchesAnything).hasMessageContaining("box \"floor\"");
            }
        }
    }
}
