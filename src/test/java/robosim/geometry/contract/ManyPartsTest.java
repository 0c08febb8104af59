package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.Effort;
import robosim.geometry.Geometry;
import robosim.geometry.WorkLimit;
import robosim.geometry.collision.CollisionDetection;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;
import robosim.geometry.model.SphereObject;

/** Groups of many parts, and many grids, answer as their parts do one by one. */
class ManyPartsTest {
    private static final double SIZE = 60;

    private static Geometry world(Dimension dimension) {
        return new Geometry(SIZE, SIZE, SIZE, dimension, Accuracy.EXACT);
    }

    private static List<GeometryObject> parts(SplittableRandom random, int count, double spread) {
        RandomObjects objects = new RandomObjects(random, spread);
        List<GeometryObject> parts = new ArrayList<>();
        for (int k = 0; k < count; k++) {
            parts.add(objects.next());
        }
        return parts;
    }

    private static ObjectGroup small(SplittableRandom random, int count) {
        List<GeometryObject> members = new ArrayList<>();
        for (int k = 0; k < count; k++) {
            Point at = new Point(random.nextDouble(-3, 3), random.nextDouble(-3, 3), random.nextDouble(-3, 3));
            members.add(
                    random.nextBoolean()
                            ? new SphereObject(at, random.nextDouble(0.1, 0.4))
                            : new BoxObject(at, 0.3, random.nextDouble(0.1, 0.6), 0.2)
                                    .turned(0, random.nextDouble(360)));
        }
        return new ObjectGroup(members);
    }

    @ParameterizedTest
    @EnumSource
    void aGroupIsItsParts(Dimension dimension) {
        SplittableRandom random = new SplittableRandom(8201 + dimension.ordinal());
        int blocked = 0;
        int moves = 0;
        for (int trial = 0; trial < Effort.cases(60); trial++) {
            Geometry whole = world(dimension);
            Geometry apart = world(dimension);
            List<GeometryObject> parts = parts(random, random.nextInt(2, 40), 12);
            whole.addObjectUnchecked(new ObjectGroup(parts));
            parts.forEach(apart::addObjectUnchecked);
            ObjectGroup robot = small(random, random.nextInt(2, 40))
                    .movedTo(new Point(random.nextDouble(-8, 8), random.nextDouble(-8, 8), random.nextDouble(-8, 8)));
            boolean meets = false;
            for (GeometryObject part : parts) {
                meets |= apartTest(dimension, robot, part);
            }
            assertThat(whole.testObject(robot)).as("%s in %s", robot, parts).isEqualTo(meets);
            assertThat(apart.testObject(robot)).isEqualTo(meets);
            whole.addObjectUnchecked(robot.moveable("robot"));
            apart.addObjectUnchecked(robot.moveable("robot"));
            // Parts of a group are placed by other sums than objects of their own.
            assertThat(whole.getProximity("robot", 100)).isCloseTo(apart.getProximity("robot", 100), within(1e-12));
            for (int move = 0; move < 8; move++) {
                double x = random.nextDouble(-2, 2);
                double z = random.nextDouble(-2, 2);
                double degrees = random.nextDouble(-90, 90);
                boolean turns = move % 2 == 1;
                boolean free = turns ? whole.simpleTurn("robot", degrees) : whole.simpleMove("robot", x, 0, z);
                boolean isFree = turns ? apart.simpleTurn("robot", degrees) : apart.simpleMove("robot", x, 0, z);
                assertThat(free).as("%s among %s", robot, parts).isEqualTo(isFree);
                blocked += free ? 0 : 1;
                moves++;
            }
        }
        assertThat(blocked).isBetween(moves / 10, moves * 9 / 10);
    }

    private static boolean apartTest(Dimension dimension, ObjectGroup robot, GeometryObject part) {
        for (GeometryObject member : members(robot)) {
            Geometry world = world(dimension);
            world.addObjectUnchecked(part);
            if (world.testObject(member)) {
                return true;
            }
        }
        return dimension == Dimension.SPATIAL && CollisionDetection.intersects(robot, part);
    }

    /** The members of a group where they stand. */
    private static List<GeometryObject> members(ObjectGroup group) {
        List<GeometryObject> members = new ArrayList<>();
        for (GeometryObject member : group.members()) {
            members.add(new ObjectGroup(List.of(member)).movedTo(group.center()));
        }
        return members;
    }

    /** Bounds show that most parts are met later than the first: they are not swept. Sweeping all takes three times the work. */
    @Test
    void aRefusedMoveSweepsFewParts() {
        int count = 400;
        SplittableRandom random = new SplittableRandom(7);
        Geometry world = world(Dimension.SPATIAL);
        world.addObjectUnchecked(small(random, count));
        world.addObjectUnchecked(
                small(random, count).movedTo(new Point(7, 0, 0)).moveable("robot"));
        world.limitWork(WorkLimit.of(1L << 40));
        double free = world.moveGlobal("robot", new Move(-6, 0, 0, 0, 0)).fraction();
        assertThat(free).isBetween(0.05, 0.5);
        assertThat(world.workDone()).isBetween(count / 2L, 30L * count);
    }

    @ParameterizedTest
    @EnumSource
    void manyGridsAreTheirCells(Dimension dimension) {
        SplittableRandom random = new SplittableRandom(8211 + dimension.ordinal());
        int hits = 0;
        int rays = 0;
        for (int trial = 0; trial < Effort.cases(24); trial++) {
            Geometry grids = world(dimension);
            Geometry boxes = world(dimension);
            int count = random.nextInt(1, 12);
            for (int k = 0; k < count + 4; k++) {
                BitSet cells = BitSet.valueOf(new long[] {random.nextLong(1, 1 << 12)});
                Point at = new Point(random.nextDouble(-20, 20), random.nextDouble(-2, 2), random.nextDouble(-20, 20));
                GridObject grid = new GridObject(at, random.nextDouble(0.2, 2), 2, 4, 3, cells)
                        .turned(0, random.nextInt(4) * 30)
                        .named("grid " + k);
                assertThat(grids.addObjectUnchecked(grid)).isTrue();
                if (k % 3 == 1) { // some go again
                    assertThat(grids.removeObject("grid " + k)).isTrue();
                    continue;
                }
                for (int cell = cells.nextSetBit(0); cell >= 0; cell = cells.nextSetBit(cell + 1)) {
                    boxes.addObjectUnchecked(grid.box(cell % 4, cell / 4));
                }
            }
            for (Geometry each : List.of(grids, boxes)) {
                each.addObjectUnchecked(new SphereObject(new Point(25, 0, 25), 0.5).moveable("robot"));
            }
            assertThat(grids.getProximity("robot", 100)).isEqualTo(boxes.getProximity("robot", 100));
            for (int k = 0; k < 60; k++) {
                Point at = new Point(random.nextDouble(-25, 25), 0, random.nextDouble(-25, 25));
                double angle = random.nextDouble(7);
                Ray ray = new Ray(at, new Point(StrictMath.cos(angle), 0, StrictMath.sin(angle)));
                double width = k % 3 * 10;
                double distance = grids.getRayDistance(ray, 0, 100, width);
                assertThat(distance).isEqualTo(boxes.getRayDistance(ray, 0, 100, width));
                assertThat(grids.testObject(new SphereObject(at, 1)))
                        .isEqualTo(boxes.testObject(new SphereObject(at, 1)));
                assertThat(grids.simpleMove("robot", at.x() / 8, 0, at.z() / 8))
                        .isEqualTo(boxes.simpleMove("robot", at.x() / 8, 0, at.z() / 8));
                hits += distance <= 100 ? 1 : 0;
                rays++;
            }
        }
        assertThat(hits).isBetween(rays / 10, rays * 9 / 10);
    }
}
