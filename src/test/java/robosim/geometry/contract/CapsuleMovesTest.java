package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigDecimal;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.Effort;
import robosim.geometry.Geometry;
import robosim.geometry.MoveResult;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CapsuleObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;
import robosim.geometry.reference.Gaps;

/** A capsule that moves: never through anything, up to contact, along a floor, and about its own axis. */
class CapsuleMovesTest {
    private static Geometry world(Dimension dimension, GeometryObject... objects) {
        Geometry world = new Geometry(1000, 1000, 1000, dimension, Accuracy.EXACT);
        for (GeometryObject object : objects) {
            assertThat(world.addObjectUnchecked(object)).isTrue();
        }
        return world;
    }

    @ParameterizedTest
    @EnumSource(Dimension.class)
    void goesUpToContactAndNoFurther(Dimension dimension) {
        SplittableRandom random = new SplittableRandom(71 + dimension.ordinal());
        RandomObjects objects = new RandomObjects(random, 3);
        int met = 0;
        int free = 0;
        int count = Effort.cases(20, dimension == Dimension.PLANAR ? 14 : 8);
        for (int k = 0; k < count; k++) {
            GeometryObject still = objects.plain();
            if (still.kind() == GeometryObject.Kind.GROUP || still.kind() == GeometryObject.Kind.CYLINDER) {
                continue;
            }
            CapsuleObject mover = new CapsuleObject(new Point(), random.nextDouble(0.01, 0.6), random.nextDouble(2))
                    .turned(k % 3 == 0 ? 0 : random.nextDouble(-180, 180), objects.heading())
                    .movedTo(objects.place())
                    .moveable("mover");
            if (Gaps.overlap(mover, still, dimension)) {
                continue;
            }
            Point to = still.center();
            Point way = new Point(
                    to.x() - mover.center().x() + random.nextDouble(-0.7, 0.7),
                    to.y() - mover.center().y() + random.nextDouble(-0.7, 0.7),
                    to.z() - mover.center().z() + random.nextDouble(-0.7, 0.7));
            MoveResult result =
                    world(dimension, still, mover).moveGlobal("mover", new Move(way.x(), way.y(), way.z(), 0, 0));
            BigDecimal truth = Gaps.touch(mover, way, still, dimension);
            String what = mover + " by " + way + " at " + still;
            if (truth == null) {
                free++;
                assertThat(result.allowed()).as(what).isTrue();
                continue;
            }
            met++;
            assertThat(result.allowed()).as(what).isFalse();
            assertThat(result.fraction())
                    .as(what)
                    .isLessThanOrEqualTo(truth.doubleValue())
                    .isGreaterThan(truth.doubleValue() - 1e-7);
        }
        assertThat(met).isGreaterThan(count / 5);
        assertThat(free).isPositive();
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
