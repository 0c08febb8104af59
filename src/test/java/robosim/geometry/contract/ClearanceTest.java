package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.Effort;
import robosim.geometry.Geometry;
import robosim.geometry.MoveResult;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;

/** Moves to contact of robots of several parts: all of them stay away from what one of them would meet. */
class ClearanceTest {
    private static final int DRIVES = Effort.cases(500);

    @Test
    void aPartThatWouldPassByStaysAwayToo() {
        Geometry world = new Geometry(20, 20, 20);
        world.addObject(new ObjectGroup(List.of(
                        new BoxObject(new Point(0, 0, 0), 1, 1, 1), new BoxObject(new Point(-0.1, 0, 1.05), 1, 1, 1)))
                .moveable("robot"));
        world.addObject(new SphereObject(new Point(3, 0, 0.55), 0));

        MoveResult result = world.moveToContact("robot", new Move(5, 0, 0, 0, 0), 0.2);

        assertThat(result.allowed()).isFalse();
        assertThat(world.getProximity("robot", 10)).isGreaterThanOrEqualTo(0.2 * (1 - 1e-12));
    }

    /** Against the gap at two hundred places of the way, each asked of a world of its own. */
    @ParameterizedTest
    @EnumSource(Dimension.class)
    void theWayEndsWhereTheFirstPartComesNearerThanTheClearance(Dimension dimension) {
        SplittableRandom random = new SplittableRandom(20261122);
        int stopped = 0;
        for (int drive = 0; drive < DRIVES; drive++) {
            GeometryObject robot = robot(random, drive);
            GeometryObject post = drive % 3 == 0
                    ? new SphereObject(new Point(3, 0, random.nextDouble(-2, 2)), random.nextDouble(0.3))
                    : new BoxObject(new Point(3, 0, random.nextDouble(-2, 2)), 0.3, 3, 0.3)
                            .turned(0, random.nextDouble(90));
            double clearance = random.nextDouble(0.05, 0.4);
            Move move = drive % 4 == 3
                    ? new Move(0, 0, 0, 0, random.nextDouble(20, 120))
                    : new Move(random.nextDouble(2, 6), 0, 0, 0, 0);
            if (drive % 4 == 3) {
                robot = robot.movedTo(new Point(1.4, 0, 0));
            }
            Geometry world = world(dimension, robot, post);
            if (world.getProximity("robot", 10) < clearance
                    || world(dimension, robot, post).move("robot", move).allowed()) {
                continue;
            }
            String what = "drive %d: %s by %s, %s clear of %s".formatted(drive, robot, move, clearance, post);
            MoveResult result = world.moveToContact("robot", move, clearance);
            double gap = world.getProximity("robot", 10);
            double share = result.fraction();
            stopped++;
            assertThat(result.allowed()).as(what).isFalse();
            assertThat(gap).as(what).isBetween(clearance * (1 - 1e-9), clearance + 1e-3);
            for (int k = 0; k < 200 && move.ry() == 0; k++) {
                Geometry there = world(dimension, robot, post);
                there.move("robot", new Move(share * k / 200 * move.x(), 0, 0, 0, 0));
                assertThat(there.getProximity("robot", 10)).as(what).isGreaterThanOrEqualTo(clearance * (1 - 1e-9));
            }
        }
        assertThat(stopped).isGreaterThan(DRIVES / 4);
    }

    /** One drive after another around one obstacle: what one part slides along says nothing about the others. */
    @ParameterizedTest
    @EnumSource(Dimension.class)
    void everyPartKeepsTheClearanceFromDriveToDrive(Dimension dimension) {
        SplittableRandom random = new SplittableRandom(31 + dimension.ordinal());
        int kept = 0;
        int close = 0;
        for (int world = 0; world < Effort.cases(160, 40); world++) {
            GeometryObject robot = world % 4 == 0
                    ? robot(random, world)
                    : new ObjectGroup(List.of(
                                    new CylinderObject(new Point(0.21, 0, 0), 0.15, 0.5),
                                    new CylinderObject(new Point(-0.21, 0, 0), 0.15, 0.5)))
                            .turned(0, random.nextDouble(360))
                            .moveable("robot");
            GeometryObject post = world % 3 == 0
                    ? new CylinderObject(new Point(), 0.4, 2)
                    : new BoxObject(new Point(), 0.6, 2, 0.8).turned(0, random.nextDouble(360));
            Geometry around = world(dimension, robot.movedTo(new Point(3, 0, 0)), post);
            double clearance = 0.02;
            for (int drive = 0; drive < 30; drive++) {
                double before = around.getProximity("robot", 99);
                Point from = around.getObject("robot").center();
                double x = random.nextDouble(-0.5, 0.5) - random.nextDouble() * from.x();
                double z = random.nextDouble(-0.5, 0.5) - random.nextDouble() * from.z();
                double[] axes = robot.rotation();
                Move move = new Move(axes[0] * x + axes[6] * z, 0, axes[2] * x + axes[8] * z, 0, 0);
                if (drive % 3 == 0) {
                    around.moveToContact("robot", move, clearance);
                } else {
                    around.moveAndSlide("robot", move, clearance, 4);
                }
                double after = around.getProximity("robot", 99);
                kept += before >= clearance ? 1 : 0;
                close += after < 1.001 * clearance ? 1 : 0;
                assertThat(after)
                        .as("%s beside %s, drive %s from %s by %s, %s before", robot, post, drive, from, move, before)
                        .isGreaterThanOrEqualTo(Math.min(before, clearance * (1 - 1e-12)));
            }
        }
        assertThat(kept).isGreaterThan(Effort.cases(3000, 750));
        assertThat(close).isGreaterThan(kept / 10);
    }

    /** A robot with a round nose at the clearance before a wall may turn: the nose only recedes. */
    @ParameterizedTest
    @EnumSource(Dimension.class)
    void aNoseAtTheClearanceMayTurnAway(Dimension dimension) {
        SplittableRandom random = new SplittableRandom(53 + dimension.ordinal());
        int turned = 0;
        for (int k = 0; k < Effort.cases(200, 50); k++) {
            double heading = random.nextInt(3) == 0 ? 90 * random.nextInt(4) : random.nextDouble(360);
            GeometryObject nose = k % 2 == 0
                    ? new CylinderObject(new Point(0.2, 0, 0), 0.2, 0.4)
                    : new SphereObject(new Point(0.2, 0, 0), 0.2);
            GeometryObject robot = new ObjectGroup(List.of(new BoxObject(new Point(-0.1, 0, 0), 0.3, 0.4, 0.3), nose))
                    .turned(0, heading)
                    .moveable("robot");
            double[] axes = robot.rotation();
            Point wall = new Point(2 * axes[0], 0, 2 * axes[6]);
            Geometry world = world(dimension, robot, new BoxObject(wall, 1, 4, 8).turned(0, heading));
            double clearance = random.nextDouble(1e-3, 0.1);
            world.moveToContact("robot", new Move(3, 0, 0, 0, 0), clearance);
            assertThat(world.getProximity("robot", 9)).isBetween(clearance, clearance * 1.001);
            double degrees = random.nextDouble(-60, 60);
            double free = world.moveAndSlide("robot", new Move(0, 0, 0, 0, degrees), clearance, 4)
                    .turnFraction();
            assertThat(free)
                    .as("%s turned by %s, %s before a wall", robot, degrees, clearance)
                    .isEqualTo(1);
            assertThat(world.getProximity("robot", 9)).isGreaterThanOrEqualTo(clearance);
            turned++;
        }
        assertThat(turned).isGreaterThan(40);
    }

    private static Geometry world(Dimension dimension, GeometryObject robot, GeometryObject post) {
        Geometry world = new Geometry(20, 20, 20, dimension, Accuracy.EXACT);
        assertThat(world.addObjectUnchecked(robot)).isTrue();
        assertThat(world.addObjectUnchecked(post)).isTrue();
        return world;
    }

    /** A group of up to four parts beside each other, or a mesh of a prow with two horns. */
    private static GeometryObject robot(SplittableRandom random, int drive) {
        if (drive % 5 == 4) {
            double prow = random.nextDouble(0.2, 1);
            return new MeshObject(
                            List.of(
                                    new Point(prow, 0, 0),
                                    new Point(-1, -0.5, -1),
                                    new Point(-1, -0.5, 1),
                                    new Point(random.nextDouble(), 0.5, -1),
                                    new Point(random.nextDouble(), 0.5, 1)),
                            new int[][] {{0, 1, 2}, {0, 1, 3}, {0, 2, 4}})
                    .moveable("robot");
        }
        List<GeometryObject> parts = new ArrayList<>();
        for (int k = 0; k < 2 + drive % 3; k++) {
            Point at = new Point(random.nextDouble(-0.3, 0.3), 0, 1.1 * k - 1);
            parts.add(
                    switch (random.nextInt(3)) {
                        case 0 -> new BoxObject(at, 1, 1, 1);
                        case 1 -> new CylinderObject(at, 0.5, 1);
                        default -> new SphereObject(at, 0.5);
                    });
        }
        return new ObjectGroup(parts).moveable("robot");
    }
}
