package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.Geometry;
import robosim.geometry.MoveResult;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;

/** What a share means where a move is of the size of an ulp of the coordinates. */
class UlpMovesTest {
    private static final double FAR = 0x1p40;
    private static final double ULP = Math.ulp(FAR);

    private static Geometry world(Dimension dimension, double gap) {
        Geometry world = new Geometry(0x1p42, 0x1p42, 0x1p42, dimension, Accuracy.EXACT);
        assertThat(world.addObject(new BoxObject(new Point(FAR + 4 + gap, 0, 0), 4, 4, 4).named("wall")))
                .isTrue();
        assertThat(world.addObject(new BoxObject(new Point(FAR, 0, 0), 4, 4, 4).moveable("robot")))
                .isTrue();
        return world;
    }

    /** Two ulps from a wall, a move by three: only one ulp is free, though two thirds of the way are before contact. */
    @ParameterizedTest
    @EnumSource(Dimension.class)
    void theShareLeadsToTheLastFreeStoredPlace(Dimension dimension) {
        Geometry world = world(dimension, 2 * ULP);
        MoveResult result = world.move("robot", new Move(3 * ULP, 0, 0, 0, 0));
        assertThat(result.allowed()).isFalse();
        assertThat(result.fraction()).isGreaterThan(1 / 6.0).isLessThan(0.5); // rounded, one ulp
        assertThat(FAR + result.fraction() * 3 * ULP).isEqualTo(FAR + ULP);
        assertThat(world.moveToContact("robot", new Move(3 * ULP, 0, 0, 0, 0), 0)
                        .allowed())
                .isFalse();
        assertThat(world.getObject("robot").center().x()).isEqualTo(FAR + ULP);
    }

    /** One ulp from a wall no other stored place is free; what is less than half an ulp is kept, and not seen. */
    @ParameterizedTest
    @EnumSource(Dimension.class)
    void whatNoCoordinateCanTellIsNoWay(Dimension dimension) {
        Geometry world = world(dimension, ULP);
        MoveResult result = world.move("robot", new Move(ULP, 0, 0, 0, 0));
        assertThat(result.allowed()).isFalse();
        assertThat(result.fraction()).isLessThan(1);
        assertThat(FAR + result.fraction() * ULP).isEqualTo(FAR);
        assertThat(world.move("robot", new Move(ULP / 4, 0, 0, 0, 0)).allowed()).isTrue();
        assertThat(world.getObject("robot").center().x()).isEqualTo(FAR);
        assertThat(world.move("robot", new Move(ULP / 2, 0, 0, 0, 0)).allowed()).isFalse();
    }

    /** Moves that end in touch or just short of it: refused with a share below 1, whose place is free as stored, or made. */
    @Test
    void whatIsRefusedHasAShareBelowOne() {
        SplittableRandom random = new SplittableRandom(91);
        int refused = 0;
        for (int k = 0; k < 3000; k++) {
            Dimension dimension = Dimension.values()[k % 2];
            Geometry world = new Geometry(64, 64, 64, dimension, Accuracy.EXACT);
            Geometry rest = new Geometry(64, 64, 64, dimension, Accuracy.EXACT);
            BoxObject wall = new BoxObject(new Point(5, 0, 0), 2, 4, 4);
            world.addObject(wall);
            rest.addObject(wall);
            double radius = random.nextDouble(0.1, 1);
            Point at = new Point(random.nextDouble(-3, 2.9), 0, random.nextDouble(-1, 1));
            GeometryObject robot = switch (k % 3) {
                case 0 -> new SphereObject(at, radius);
                case 1 -> new CylinderObject(at, radius, 1);
                default -> new BoxObject(at, 2 * radius, 1, 1).turned(k % 2 == 0 ? 0 : 33, k % 5 == 0 ? 0 : 20);
            };
            robot = robot.moveable("robot");
            if (!world.addObject(robot)) {
                continue;
            }
            double way = world.getProximity("robot", 10);
            for (int n = random.nextInt(-3, 4); n != 0; n -= Integer.signum(n)) {
                way = n > 0 ? Math.nextUp(way) : Math.nextDown(way);
            }
            MoveResult result = world.moveGlobal("robot", new Move(way, 0, 0, 0, 0));
            assertThat(rest.testObject(world.getObject("robot"))).isFalse();
            if (!result.allowed()) {
                refused++;
                assertThat(result.fraction())
                        .as("%s by %s: %s", robot, way, result)
                        .isLessThan(1);
                assertThat(result.obstacle()).isEqualTo(wall);
                Point end = new Point(at.x() + result.fraction() * way, at.y(), at.z());
                assertThat(rest.testObject(robot.movedTo(end)))
                        .as("%s by %s: %s", robot, way, result)
                        .isFalse();
            }
        }
        assertThat(refused).isBetween(300, 2700);
    }

    @Test
    void aRefusedTurnHasAShareBelowOne() {
        Geometry world = new Geometry(64, 64, 64);
        world.addObject(new BoxObject(new Point(0, 0, 2), 1, 1, 1).named("post"));
        world.addObject(new BoxObject(new Point(), 5, 0.5, 0.5).moveable("robot"));
        MoveResult result = world.move("robot", new Move(0, 0, 0, 20, 180));
        assertThat(result.allowed()).isFalse();
        assertThat(result.fraction()).isEqualTo(1);
        assertThat(result.turnFraction()).isGreaterThan(0).isLessThan(1);
    }
}
