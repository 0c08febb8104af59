package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import robosim.geometry.Geometry;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CapsuleObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;

/** A capsule that moves along a floor, and about its own axis. The census has its straight ways at all other shapes. */
class CapsuleMovesTest {
    private static Geometry world(Dimension dimension, GeometryObject... objects) {
        Geometry world = new Geometry(1000, 1000, 1000, dimension, Accuracy.EXACT);
        for (GeometryObject object : objects) {
            assertThat(world.addObjectUnchecked(object)).isTrue();
        }
        return world;
    }

    /** It stands on a floor of tiles of equal height, and lies on it. */
    @Test
    void drivesAlongAFloor() {
        for (double rx : new double[] {0, 90}) {
            double up = rx == 0 ? 0.75 : 0.25;
            GeometryObject robot = new CapsuleObject(new Point(), 0.25, 1)
                    .turned(rx, 0)
                    .movedTo(new Point(-2, up, 0))
                    .moveable("robot");
            Geometry world = world(
                    Dimension.SPATIAL,
                    new BoxObject(new Point(-2.5, -0.5, 0), 5, 1, 8),
                    new BoxObject(new Point(2.5, -0.5, 0), 5, 1, 8),
                    robot);
            assertThat(world.moveGlobal("robot", new Move(4, 0, 0.5, 0, 0)).allowed())
                    .isTrue();
            assertThat(world.moveGlobal("robot", new Move(0, -0x1p-40, 0, 0, 0)).allowed())
                    .isFalse();
            assertThat(world.moveGlobal("robot", new Move(0, 1, 0, 0, 0)).allowed())
                    .isTrue();
        }
    }

    /** Whatever touches it, a turn about its own axis changes nothing; one across it does. */
    @Test
    void turnsAboutItsOwnAxis() {
        for (double segment : new double[] {0, 1}) {
            GeometryObject robot = new CapsuleObject(new Point(), 0.5, segment).moveable("robot");
            Geometry world = world(
                    Dimension.SPATIAL,
                    new BoxObject(new Point(1, 0, 0), 1, 1, 1),
                    new CylinderObject(new Point(-1, 0, 0), 0.5, 1),
                    new SphereObject(new Point(0, 0, 1), 0.5),
                    new CapsuleObject(new Point(0, 0, -1), 0.5, 0.75),
                    robot);
            assertThat(world.simpleTurn("robot", 123.4)).isTrue();
            assertThat(world.move("robot", new Move(0, 0, 0, 30, 0)).allowed()).isEqualTo(segment == 0);
        }
    }
}
