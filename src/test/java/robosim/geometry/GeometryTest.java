package robosim.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;
import robosim.geometry.model.SphereObject;

class GeometryTest {
    private static final Point FORWARD = new Point(1, 0, 0);
    private static final double INFINITE = Double.POSITIVE_INFINITY;

    private static CylinderObject robot(double x, double z) {
        return new CylinderObject(new Point(x, 0, z), 0.5, 1).moveable("robot");
    }

    private static BoxObject wall(double x) {
        return new BoxObject(new Point(x, 0, 0), 0.25, 10, 10);
    }

    private static Geometry world(Dimension dimension, GeometryObject... objects) {
        Geometry geometry = new Geometry(100, 100, 100, dimension, Accuracy.EXACT);
        for (GeometryObject object : objects) {
            assertThat(geometry.addObjectUnchecked(object)).isTrue();
        }
        return geometry;
    }

    @ParameterizedTest
    @EnumSource(Dimension.class)
    void touchingIsColliding(Dimension dimension) {
        Geometry geometry = world(dimension, new BoxObject(new Point(), 2, 2, 2));
        BoxObject beside = new BoxObject(new Point(2, 0, 0), 2, 2, 2);
        assertThat(geometry.testObject(beside)).isTrue();
        assertThat(geometry.addObject(beside)).isFalse();
        assertThat(geometry.addObject(beside.movedTo(new Point(Math.nextUp(2.0), 0, 0))))
                .isTrue();
        assertThat(geometry.objects()).hasSize(2);
    }

    @Test
    void heightsCountInSpaceOnly() {
        BoxObject low = new BoxObject(new Point(), 2, 2, 2);
        BoxObject high = new BoxObject(new Point(0, 3, 0), 2, 2, 2);
        assertThat(world(Dimension.SPATIAL, low).testObject(high)).isFalse();
        assertThat(world(Dimension.PLANAR, low).testObject(high)).isTrue();
    }

    @Test
    void theBorderIsClosedAndJudgedOnTheExactShape() {
        Geometry geometry = new Geometry(10, 10, 10);
        assertThat(geometry.addObject(new BoxObject(new Point(4.5, -4.5, 0), 1, 1, 1)))
                .isTrue();
        assertThat(geometry.addObject(new BoxObject(new Point(Math.nextUp(4.5), 4.5, 0), 1, 1, 1)))
                .isFalse();
        // A square on its corner needs the root of two.
        BoxObject turned = new BoxObject(new Point(0, 4, 4.3), 1, 1, 1).turned(0, 45);
        assertThat(geometry.addObject(turned)).isFalse();
        assertThat(geometry.addObject(turned.movedTo(new Point(0, 4, 4.29)))).isTrue();
        assertThat(new Geometry(10, 10, 10, Dimension.PLANAR, Accuracy.EXACT)
                        .addObject(new SphereObject(new Point(0, 90, 0), 1)))
                .isTrue();
    }

    @Test
    void aNameIsUniqueAndWhatIsRefusedChangesNothing() {
        Geometry geometry = world(Dimension.SPATIAL, robot(0, 0));
        assertThatIllegalArgumentException()
                .isThrownBy(() -> geometry.addObject(robot(5, 5)))
                .withMessageContaining("robot");
        assertThat(geometry.objects()).containsExactly(robot(0, 0));
        assertThat(geometry.removeObject("nobody")).isFalse();
        assertThat(geometry.removeObject("robot")).isTrue();
        assertThat(geometry.objects()).isEmpty();
        assertThat(geometry.addObject(robot(5, 5))).isTrue();
        assertThatIllegalArgumentException()
                .isThrownBy(() -> geometry.getObject("nobody"))
                .withMessageContaining("nobody");
        geometry.addObject(wall(20).named("wall"));
        assertThatIllegalArgumentException()
                .isThrownBy(() -> geometry.simpleMove("wall", 1, 0, 0))
                .withMessageContaining("static");
    }

    @ParameterizedTest
    @EnumSource(Dimension.class)
    void aMoveIsSweptAndAllOrNothing(Dimension dimension) {
        Geometry geometry = world(dimension, robot(0, 0), wall(5));
        assertThat(geometry.simpleMove("robot", 4, 0, 0)).isTrue();
        assertThat(geometry.simpleMove("robot", 20, 0, 0))
                .as("through the wall")
                .isFalse();
        assertThat(geometry.getObject("robot").center()).isEqualTo(new Point(4, 0, 0));
        MoveResult result = geometry.move("robot", new Move(20, 0, 0, 0, 0));
        assertThat(result.allowed()).isFalse();
        assertThat(result.fraction()).isLessThan(0.375 / 20).isCloseTo(0.375 / 20, within(1e-12));
        assertThat(result.obstacle()).isEqualTo(wall(5));
        assertThat(result.normal()).isEqualTo(new Point(-1, 0, 0));
        assertThat(result.contact().x()).isCloseTo(4.875, within(1e-9));
        assertThat(geometry.getObject("robot").center()).isEqualTo(new Point(4, 0, 0));
        // Exactly up to the wall is contact already.
        assertThat(geometry.simpleMove("robot", 0.375, 0, 0)).isFalse();
        assertThat(geometry.simpleMove("robot", 0.375 - 0x1p-50, 0, 0)).isTrue();
    }

    @Test
    void aMoveIsRelativeAndItsTwinIsGlobal() {
        Geometry geometry = world(Dimension.SPATIAL, robot(0, 0));
        assertThat(geometry.simpleTurn("robot", 90)).isTrue();
        assertThat(geometry.simpleMove("robot", 2, 0, 1)).isTrue();
        assertThat(geometry.getObject("robot").center()).isEqualTo(new Point(1, 0, -2));
        assertThat(geometry.moveGlobal("robot", new Move(2, 0, 1, 0, 90)).allowed())
                .isTrue();
        assertThat(geometry.getObject("robot").center()).isEqualTo(new Point(3, 0, -1));
        assertThat(geometry.getObject("robot").heading()).isEqualTo(180);
    }

    @ParameterizedTest
    @EnumSource(Dimension.class)
    void whatIsTouchedAtTheStartBlocksOnlyWhatGoesDeeper(Dimension dimension) {
        Geometry geometry = world(dimension, robot(0, 0), new BoxObject(new Point(1, 0, 0), 1, 4, 4));
        assertThat(geometry.move("robot", new Move(0.1, 0, 0, 0, 0)).fraction())
                .as("into")
                .isZero();
        assertThat(geometry.simpleMove("robot", 0, 0, 0)).as("nothing").isTrue();
        assertThat(geometry.simpleMove("robot", 0, 0, 0.5)).as("along").isTrue();
        assertThat(geometry.simpleTurn("robot", 77)).as("a disc turns in place").isTrue();
        assertThat(geometry.placeObject("robot", new Point(-0.5, 0, 0), 0)).isTrue();
        assertThat(geometry.simpleMove("robot", 0.5, 0, 0)).as("up to it").isFalse();
    }

    @ParameterizedTest
    @EnumSource(Dimension.class)
    void anOverlapCanBeLeftAndNotDeepened(Dimension dimension) {
        Geometry geometry = world(dimension, robot(0, 0), new BoxObject(new Point(1.25, 0, 0), 2, 4, 40));
        assertThat(geometry.simpleMove("robot", 0.01, 0, 0)).isFalse();
        assertThat(geometry.simpleMove("robot", -0.5, 0, 0)).as("partly out").isTrue();
        assertThat(geometry.simpleMove("robot", 0, 0, 3)).as("along").isTrue();
        assertThat(geometry.simpleMove("robot", -5, 0, 0)).as("out").isTrue();
        assertThat(geometry.simpleMove("robot", 6, 0, 0)).as("in again").isFalse();
    }

    @ParameterizedTest
    @EnumSource(Dimension.class)
    void aTurnIsSwept(Dimension dimension) {
        BoxObject bar = new BoxObject(new Point(), 4, 1, 0.5).moveable("bar");
        Geometry geometry = world(dimension, bar, new SphereObject(new Point(0, 0, -1.5), 0.1));
        assertThat(geometry.simpleTurn("bar", 180)).as("the post is in the way").isFalse();
        MoveResult result = geometry.move("bar", new Move(0, 0, 0, 0, 180));
        assertThat(result.fraction()).isEqualTo(1);
        assertThat(result.turnFraction()).isBetween(0.3, 0.5);
        assertThat(geometry.simpleTurn("bar", -60)).isTrue();
        assertThat(geometry.getObject("bar").heading()).isEqualTo(-60);
        assertThat(geometry.simpleTurn("bar", 360))
                .as("a full circle is no zero turn")
                .isFalse();
    }

    @Test
    void aTurnAboutTheOwnXIsSweptToo() {
        BoxObject plank = new BoxObject(new Point(), 1, 0.5, 4).moveable("plank");
        Geometry geometry = world(Dimension.SPATIAL, plank, new BoxObject(new Point(0, 1.5, 0), 1, 0.2, 0.2));
        assertThat(geometry.move("plank", new Move(0, 0, 0, 180, 0)).allowed()).isFalse();
        assertThat(geometry.move("plank", new Move(0, 0, 0, 60, 0)).allowed()).isTrue();
        assertThat(geometry.move("plank", new Move(0, 0, 0, 60, 0)).allowed()).isFalse();
    }

    @Test
    void aMoveToContactStopsShort() {
        Geometry geometry = world(Dimension.SPATIAL, robot(0, 0), wall(5));
        MoveResult result = geometry.moveToContact("robot", new Move(20, 0, 0, 0, 0), 0.125);
        assertThat(result.allowed()).isFalse();
        assertThat(geometry.getObject("robot").center().x())
                .isLessThanOrEqualTo(4.25)
                .isCloseTo(4.25, within(1e-9));
        assertThat(geometry.getProximity("robot", 10)).isCloseTo(0.125, within(1e-9));
        assertThat(geometry.moveToContact("robot", new Move(1, 0, 0, 0, 0), 0).allowed())
                .isFalse();
        assertThat(geometry.getProximity("robot", 10)).isPositive().isLessThan(1e-9);
        assertThat(geometry.moveToContact("robot", new Move(-1, 0, 0, 0, 0), 0.125)
                        .allowed())
                .isTrue();
    }

    @ParameterizedTest
    @EnumSource(Dimension.class)
    void aMeshTurnsAsFarAsItsCornersAllow(Dimension dimension) {
        List<Point> corners =
                List.of(new Point(1, 0, 1), new Point(-1, 0, 1), new Point(-1, 0, -1), new Point(1, 0, -1));
        MeshObject tile = new MeshObject(corners, new int[][] {{0, 1, 2, 3}}).moveable("tile");
        // The corners are 1.415 from the centre; those of the bounds at 45 degrees are 2.
        Geometry wide = new Geometry(2.9, 1, 2.9, dimension, Accuracy.EXACT);
        assertThat(wide.addObject(tile.turned(0, 45))).isTrue();
        assertThat(wide.simpleTurn("tile", 100)).isTrue();
        Geometry narrow = new Geometry(2.7, 1, 2.7, dimension, Accuracy.EXACT);
        assertThat(narrow.addObject(tile)).isTrue();
        MoveResult result = narrow.move("tile", new Move(0, 0, 0, 0, 90));
        double free = Math.toDegrees(Math.acos(1.35 / Math.sqrt(2)));
        assertThat(result.turnFraction()).isCloseTo((45 - free) / 90, within(1e-9));
        assertThat(result.obstacle()).isNull();
    }

    @Test
    void theBorderBlocksWithoutAnObstacle() {
        Geometry geometry = world(Dimension.SPATIAL, robot(0, 0));
        MoveResult result = geometry.move("robot", new Move(60, 0, 0, 0, 0));
        assertThat(result.allowed()).isFalse();
        assertThat(result.obstacle()).isNull();
        assertThat(result.normal()).isEqualTo(new Point(-1, 0, 0));
        assertThat(result.contact().x()).isEqualTo(50);
        assertThat(result.fraction()).isCloseTo(49.5 / 60, within(1e-12));
        assertThat(geometry.simpleMove("robot", 49.5, 0, 0))
                .as("touching the border is inside")
                .isTrue();
        assertThat(geometry.simpleTurn("robot", 33)).isTrue();
    }

    @ParameterizedTest
    @EnumSource(Dimension.class)
    void rangesAreMeasuredFromTheStart(Dimension dimension) {
        Geometry geometry = world(dimension, wall(5.125), robot(0, 0));
        Ray ray = new Ray(new Point(-1, 0, 0), new Point(3, 0, 0));
        assertThat(geometry.getRayDistance(ray, 0, INFINITE, 0)).isEqualTo(0.5);
        assertThat(geometry.getRayDistance(ray, 0, INFINITE, 0, "robot")).isEqualTo(6);
        assertThat(geometry.getSonarDistance("robot", 1, 0, 0, INFINITE, 0)).isEqualTo(5);
        assertThat(geometry.getSonarDistance("robot", 1, 0, 0, 5, 0)).isEqualTo(5);
        assertThat(geometry.getSonarDistance("robot", 1, 0, 0, Math.nextDown(5.0), 0))
                .isEqualTo(INFINITE);
        assertThat(geometry.getSonarDistance("robot", 1, 0, 5.5, 10, 0))
                .as("hidden by what is too near")
                .isEqualTo(5.5);
        assertThat(geometry.getSonarDistance("robot", -1, 0, 0, 10, 0)).isEqualTo(INFINITE);
        assertThat(geometry.getRayDistance(new Ray(new Point(5, 0, 0), FORWARD), 0.25, 9, 0))
                .isEqualTo(0.25);
        Ray mount = new Ray(new Point(1, 0, 0), new Point(0, 0, 1));
        assertThat(geometry.getSonarDistance("robot", mount, 0, 9, 0)).isEqualTo(INFINITE);
        assertThat(geometry.getSonarDistance("robot", new Ray(new Point(1, 0, 0), FORWARD), 0, 9, 0))
                .isEqualTo(4);
    }

    @ParameterizedTest
    @EnumSource(Dimension.class)
    void aConeHearsAPoleThatRaysMiss(Dimension dimension) {
        CylinderObject pole = new CylinderObject(new Point(10, 0, 0.4), 1e-4, 2);
        Geometry geometry = world(dimension, robot(0, 0), pole);
        double nearest = Math.hypot(10, 0.4) - 1e-4;
        assertThat(geometry.getSonarDistance("robot", 1, 0, 0, 20, 15)).isCloseTo(nearest, within(1e-9));
        assertThat(geometry.getSonarDistance("robot", 1, 0, 0, 20, 4))
                .as("too narrow")
                .isEqualTo(INFINITE);
        double[] fan = geometry.scan("robot", -7.5, 15.0 / 180, 181, 0, 20);
        assertThat(fan).containsOnly(INFINITE);
    }

    @Test
    void aScanGoesCounterClockwise() {
        Geometry geometry =
                world(Dimension.PLANAR, robot(0, 0), new BoxObject(new Point(0, 0, -5), 2, 2, 2), wall(8.125));
        assertThat(geometry.scan("robot", 0, 90, 4, 0, 20)).containsExactly(8, 4, INFINITE, INFINITE);
        geometry.simpleTurn("robot", 90);
        assertThat(geometry.scan("robot", 0, 90, 4, 0, 20)).containsExactly(4, INFINITE, INFINITE, 8);
    }

    @Test
    void aCastTellsWhatItMet() {
        SphereObject ball = new SphereObject(new Point(0, 5, 0), 1);
        Geometry geometry = world(Dimension.SPATIAL, ball, new SphereObject(new Point(0, 5, 0), 1));
        RayHit hit = geometry.castRay(new Ray(new Point(0, -3, 0), new Point(0, 2, 0)), INFINITE);
        assertThat(hit).isEqualTo(new RayHit(7, new Point(0, 4, 0), new Point(0, -1, 0), ball));
        assertThat(geometry.castRay(new Ray(new Point(0, -3, 0), new Point(0, 2, 0)), 6.9))
                .isNull();
        assertThat(geometry.castRay(new Ray(new Point(0, 5, 0), FORWARD), 9).distance())
                .isZero();
    }

    @ParameterizedTest
    @EnumSource(Dimension.class)
    void proximityIsTheLeastDistanceToAnyOther(Dimension dimension) {
        Geometry geometry = world(dimension, robot(0, 0), wall(5.125), new SphereObject(new Point(0, 0, 3), 1));
        assertThat(geometry.getProximity("robot", INFINITE)).isCloseTo(1.5, within(1e-12));
        assertThat(geometry.getProximity("robot", 1.4)).isEqualTo(INFINITE);
        geometry.addObjectUnchecked(new SphereObject(new Point(-1, 0, 0), 0.5));
        assertThat(geometry.getProximity("robot", INFINITE)).isZero();
    }

    @Test
    void meshesAndGroupsTakePartLikeAnyShape() {
        MeshObject floor = new MeshObject(
                List.of(new Point(-5, 0, -5), new Point(-5, 0, 5), new Point(5, 0, 5), new Point(5, 0, -5)),
                new int[][] {{0, 1, 2, 3}});
        ObjectGroup table = new ObjectGroup(List.of(
                        new BoxObject(new Point(0, 1, 0), 2, 0.1, 2),
                        new CylinderObject(new Point(0, 0.5, 0), 0.1, 0.9)))
                .movedTo(new Point(3, 0, 0));
        Geometry geometry = world(Dimension.SPATIAL, floor, table, robot(-3, 0).movedTo(new Point(-3, 0.6, 0)));
        assertThat(geometry.simpleMove("robot", 0, -0.2, 0))
                .as("into the floor")
                .isFalse();
        assertThat(geometry.simpleMove("robot", 5, 0, 0))
                .as("under the table top, and against it")
                .isFalse();
        assertThat(geometry.simpleMove("robot", 0, -0.0999, 0)).isTrue();
        Ray down = new Ray(new Point(1, 5, 1), new Point(0, -1, 0));
        assertThat(geometry.getRayDistance(down, 0, INFINITE, 0)).isEqualTo(5);
        assertThat(geometry.getRayDistance(new Ray(new Point(3, 5, 0), new Point(0, -1, 0)), 0, 9, 0))
                .isCloseTo(3.95, within(1e-12));
    }

    @ParameterizedTest
    @EnumSource(Accuracy.class)
    void aCoarserLevelMissesNothing(Accuracy accuracy) {
        Geometry geometry = new Geometry(100, 100, 100, Dimension.SPATIAL, accuracy);
        BoxObject slanted = new BoxObject(new Point(5, 0, 0), 4, 1, 0.2).turned(20, 30);
        geometry.addObject(slanted);
        assertThat(geometry.testObject(new SphereObject(new Point(5, 0, 0), 0.1)))
                .isTrue();
        Ray ray = new Ray(new Point(), FORWARD);
        double distance = geometry.getRayDistance(ray, 0, INFINITE, 0);
        assertThat(distance).isLessThanOrEqualTo(geometry.getRayDistance(ray, 0, INFINITE, 0, Accuracy.EXACT));
        assertThat(geometry.testObject(new SphereObject(new Point(50, 0, 0), 0.1), Accuracy.SPHERE))
                .isFalse();
    }

    @ParameterizedTest
    @ValueSource(doubles = {Double.NaN, -1})
    void rangesThatCanNotBeAreRefusedByName(double bad) {
        Geometry geometry = world(Dimension.PLANAR, robot(0, 0));
        Ray ray = new Ray(new Point(), FORWARD);
        String text = String.valueOf(bad);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> geometry.getRayDistance(ray, bad, 9, 0))
                .withMessageContaining("min")
                .withMessageContaining(text);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> geometry.getRayDistance(ray, 0, bad, 0))
                .withMessageContaining("max");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> geometry.getRayDistance(ray, 0, 9, bad))
                .withMessageContaining("width");
        assertThatIllegalArgumentException().isThrownBy(() -> geometry.getProximity("robot", bad));
        assertThatIllegalArgumentException().isThrownBy(() -> geometry.getRayDistance(ray, 0, 9, 180));
        assertThatIllegalArgumentException().isThrownBy(() -> geometry.getRayDistance(ray, 5, 4, 0));
        assertThatIllegalArgumentException().isThrownBy(() -> geometry.getRayDistance(ray, INFINITE, INFINITE, 0));
        assertThatIllegalArgumentException()
                .isThrownBy(() -> geometry.getRayDistance(new Ray(new Point(), new Point(0, 1, 0)), 0, 9, 0))
                .withMessageContaining("vertical");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Geometry(bad, 1, 1))
                .withMessageContaining("width");
    }
}
