package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
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

/** A robot that stands on a floor of many pieces, or leans against a wall of many, goes along it. */
@Tag("slow")
class StandingTest {
    private static final double SIZE = 64;

    /** What a floor at height 0 is made of. */
    enum Floor {
        TILES {
            @Override
            void build(Geometry world) {
                for (int x = -8; x < 8; x++) {
                    for (int z = -8; z < 8; z++) {
                        add(world, new BoxObject(new Point(x + 0.5, -0.25, z + 0.5), 1, 0.5, 1));
                    }
                }
            }
        },
        UNEVEN_TILES {
            @Override
            void build(Geometry world) {
                for (int x = -8; x < 8; x++) {
                    for (int z = -8; z < 8; z++) {
                        double half = 0.125 * (1 + (x + 8) % 3);
                        add(world, new BoxObject(new Point(x + 0.5, -half, z + 0.5), 1, 2 * half, 1));
                    }
                }
            }
        },
        MESH {
            @Override
            void build(Geometry world) {
                add(world, mesh(false));
            }
        },
        SOLID_MESH {
            @Override
            void build(Geometry world) {
                double[][] p = {{-8, -8}, {8, -8}, {8, 8}, {-8, 8}};
                List<Point> corners = new ArrayList<>();
                for (int k = 0; k < 8; k++) {
                    corners.add(new Point(p[k % 4][0], k < 4 ? -1 : 0, p[k % 4][1]));
                }
                int[][] faces = {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
                add(world, new MeshObject(corners, faces).solid());
            }
        },
        MESHES {
            @Override
            void build(Geometry world) {
                for (int x = -8; x < 8; x += 2) {
                    for (int z = -8; z < 8; z += 2) {
                        List<Point> p = List.of(
                                new Point(x, 0, z),
                                new Point(x + 2, 0, z),
                                new Point(x + 2, 0, z + 2),
                                new Point(x, 0, z + 2));
                        add(world, new MeshObject(p, new int[][] {{3, 2, 1, 0}}));
                    }
                }
            }
        },
        COLUMNS {
            @Override
            void build(Geometry world) {
                for (int x = -8; x <= 8; x++) {
                    for (int z = -8; z <= 8; z++) {
                        add(world, new CylinderObject(new Point(x, -0.5, z), 0.75, 1));
                    }
                }
            }
        };

        abstract void build(Geometry world);
    }

    private static void add(Geometry world, GeometryObject object) {
        assertThat(world.addObjectUnchecked(object)).isTrue();
    }

    /** A floor of small triangles, and if so a wall along x = 4. */
    private static MeshObject mesh(boolean withWall) {
        List<Point> points = new ArrayList<>();
        List<int[]> faces = new ArrayList<>();
        for (int x = -8; x <= 8; x++) {
            for (int z = -8; z <= 8; z++) {
                points.add(new Point(x, 0, z));
            }
        }
        for (int x = 0; x < 16; x++) {
            for (int z = 0; z < 16; z++) {
                int a = 17 * x + z;
                faces.add(
                        (x + z) % 2 == 0 ? new int[] {a, a + 1, a + 18, a + 17} : new int[] {a + 1, a + 18, a + 17, a});
            }
        }
        if (withWall) {
            int first = points.size();
            for (int z = -8; z <= 8; z++) {
                points.add(new Point(4, 0, z));
                points.add(new Point(4, 2, z));
            }
            for (int z = 0; z < 16; z++) {
                int a = first + 2 * z;
                faces.add(new int[] {a, a + 1, a + 3, a + 2});
            }
        }
        return new MeshObject(points, faces.toArray(new int[0][]));
    }

    /** What stands on the floor. */
    enum Mover {
        BOX,
        TURNED_BOX,
        CYLINDER,
        SPHERE,
        WHEEL,
        GROUP,
        BOX_MESH;

        GeometryObject at(double x, double y, double z) {
            return switch (this) {
                case BOX -> new BoxObject(new Point(x, y + 0.25, z), 1, 0.5, 0.75).moveable("robot");
                case TURNED_BOX ->
                    new BoxObject(new Point(x, y + 0.25, z), 1, 0.5, 0.75)
                            .turned(0, 37)
                            .moveable("robot");
                case CYLINDER -> new CylinderObject(new Point(x, y + 0.5, z), 0.375, 1).moveable("robot");
                case SPHERE -> new SphereObject(new Point(x, y + 0.375, z), 0.375).moveable("robot");
                case WHEEL ->
                    new CylinderObject(new Point(x, y + 0.375, z), 0.375, 0.25)
                            .turned(90, 0)
                            .moveable("robot");
                case GROUP ->
                    new ObjectGroup(List.of(
                                    new BoxObject(new Point(0, 0.5, 0), 1, 0.25, 1),
                                    new SphereObject(new Point(0.25, 0.125, 0), 0.125),
                                    new CylinderObject(new Point(-0.25, 0.25, 0.25), 0.125, 0.5),
                                    new CylinderObject(new Point(-0.25, 0.25, -0.25), 0.25, 0.125).turned(90, 0)))
                            .movedTo(new Point(x, y, z))
                            .moveable("robot");
                case BOX_MESH -> boxMesh().movedTo(new Point(x, y + 0.5, z)).moveable("robot");
            };
        }
    }

    private static MeshObject boxMesh() {
        List<Point> corners = new ArrayList<>();
        for (int k = 0; k < 8; k++) {
            corners.add(new Point((k & 1) - 0.5, (k >> 1 & 1) - 0.5, (k >> 2 & 1) - 0.5));
        }
        int[][] faces = {{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}};
        return new MeshObject(corners, faces);
    }

    private static Geometry world(Floor floor, GeometryObject robot) {
        Geometry world = new Geometry(SIZE, SIZE, SIZE);
        floor.build(world);
        add(world, robot);
        return world;
    }

    @ParameterizedTest
    @EnumSource(Floor.class)
    void aRobotDrivesAcrossTheSeams(Floor floor) {
        SplittableRandom random = new SplittableRandom(11);
        for (Mover mover : Mover.values()) {
            Geometry world = world(floor, mover.at(0.125, 0, 0.25));
            for (int step = 0; step < Effort.cases(30, 15); step++) {
                Point c = world.getObject("robot").center();
                double x = random.nextDouble(-6, 6) - c.x();
                double z = random.nextDouble(-6, 6) - c.z();
                double share = random.nextInt(3) == 0 ? 1 : random.nextDouble(0.01, 0.5);
                Move move = new Move(share * x, 0, share * z, 0, 0);
                MoveResult result = world.moveGlobal("robot", move);
                assertThat(result.allowed())
                        .as("%s on %s from %s by %s: %s", mover, floor, c, move, result)
                        .isTrue();
                if (mover != Mover.WHEEL) {
                    Move turn = new Move(0, 0, 0, 0, random.nextDouble(-200, 200));
                    result = world.move("robot", turn);
                    assertThat(result.allowed())
                            .as("%s on %s by %s: %s", mover, floor, turn, result)
                            .isTrue();
                }
            }
        }
    }

    @ParameterizedTest
    @EnumSource(Floor.class)
    void simpleMovesDoLikewise(Floor floor) {
        SplittableRandom random = new SplittableRandom(12);
        for (Mover mover : Mover.values()) {
            Geometry world = world(floor, mover.at(0.125, 0, 0.25));
            int made = 0;
            for (int step = 0; step < Effort.cases(30, 15); step++) {
                Point before = world.getObject("robot").center();
                double x = random.nextDouble(-1, 1);
                double z = mover == Mover.WHEEL ? 0 : random.nextDouble(-1, 1);
                if (Math.hypot(before.x(), before.z()) < 5) {
                    assertThat(world.simpleMove("robot", x, 0, z))
                            .as("%s on %s", mover, floor)
                            .isTrue();
                    made++;
                }
                assertThat(world.simpleTurn("robot", random.nextDouble(-90, 90)))
                        .as("%s on %s", mover, floor)
                        .isTrue();
            }
            assertThat(made).isGreaterThan(5);
        }
    }

    @ParameterizedTest
    @EnumSource(Floor.class)
    void downIsRefusedAndUpIsFree(Floor floor) {
        for (Mover mover : Mover.values()) {
            Geometry world = world(floor, mover.at(0.125, 0, 0.25));
            MoveResult down = world.moveGlobal("robot", new Move(3, -Math.ulp(1.0), 0, 0, 0));
            assertThat(down.allowed()).as("%s on %s", mover, floor).isFalse();
            assertThat(down.fraction()).as("%s on %s", mover, floor).isZero();
            assertThat(world.moveGlobal("robot", new Move(3, Math.ulp(1.0), 0, 0, 0))
                            .allowed())
                    .as("%s on %s", mover, floor)
                    .isTrue();
        }
    }

    /** A step up by the last bit of a height blocks, one down by it does not. */
    @ParameterizedTest
    @ValueSource(doubles = {0x1p-52, 0x1p-40, 1e-9, 0.1})
    void theLeastStepBlocks(double step) {
        for (Mover mover : Mover.values()) {
            for (int sign = -1; sign <= 1; sign += 2) {
                for (boolean isMesh : new boolean[] {false, true}) {
                    Geometry world = new Geometry(SIZE, SIZE, SIZE);
                    double top = 1 + sign * step;
                    add(world, new BoxObject(new Point(0, 0.5, 0), 4, 1, 8));
                    if (isMesh) {
                        List<Point> p = List.of(
                                new Point(2, top, -4),
                                new Point(6, top, -4),
                                new Point(6, top, 4),
                                new Point(2, top, 4));
                        add(world, new MeshObject(p, new int[][] {{0, 1, 2, 3}}).named("step"));
                    } else {
                        add(world, new BoxObject(new Point(4, top / 2, 0), 4, top, 8).named("step"));
                    }
                    GeometryObject robot = mover.at(0, 1, 0);
                    add(world, robot);
                    MoveResult result = world.moveGlobal("robot", new Move(4, 0, 0, 0, 0));
                    String what = "%s over %s, %s: %s".formatted(mover, sign * step, isMesh, result);
                    assertThat(result.allowed()).as(what).isEqualTo(sign < 0);
                    if (sign > 0) {
                        assertThat(result.obstacle()).as(what).isNotNull();
                        assertThat(result.obstacle().name()).as(what).isEqualTo("step");
                        assertThat(result.fraction()).as(what).isLessThan(1);
                        assertThat(world.getObject("robot")).isEqualTo(robot);
                    }
                }
            }
        }
    }

    /** Driven at the wall of a mesh that is floor and wall in one, it stops before the wall, which is what is named. */
    @ParameterizedTest
    @EnumSource(Mover.class)
    void aRobotOnAMeshStopsBeforeItsWall(Mover mover) {
        SplittableRandom random = new SplittableRandom(13);
        for (int k = 0; k < Effort.cases(40); k++) {
            Geometry world = new Geometry(SIZE, SIZE, SIZE);
            add(world, mesh(true));
            add(world, mover.at(random.nextDouble(-3, 3), 0, random.nextDouble(-3, 3)));
            Move move = new Move(random.nextDouble(8, 12), 0, random.nextDouble(-2, 2), 0, 0);
            GeometryObject before = world.getObject("robot");
            MoveResult result = world.moveGlobal("robot", move);
            assertThat(result.allowed()).isFalse();
            assertThat(result.fraction()).isGreaterThan(0).isLessThan(1);
            assertThat(result.contact().x()).as("" + result).isBetween(4 - 1e-9, 4 + 1e-9);
            assertThat(result.normal().x()).as("" + result).isLessThan(-0.99);
            double clearance = k % 2 == 0 ? 0 : 0.125;
            double[] r = before.rotation();
            Move own = new Move(
                    r[0] * move.x() + r[6] * move.z(),
                    r[1] * move.x() + r[7] * move.z(),
                    r[2] * move.x() + r[8] * move.z(),
                    0,
                    0);
            MoveResult docked = world.moveToContact("robot", own, clearance);
            String what = mover + " at " + before + ": " + docked;
            assertThat(docked.allowed()).as(what).isFalse();
            assertThat(docked.fraction()).as(what).isGreaterThan(0).isLessThan(1);
            GeometryObject there = world.getObject("robot");
            Geometry rest = new Geometry(SIZE, SIZE, SIZE);
            add(rest, new BoxObject(new Point(4, 1, 0), 0, 2, 16));
            assertThat(rest.testObject(there)).as(what).isFalse();
            add(rest, there);
            assertThat(rest.getProximity("robot", 100)).as(what).isBetween(clearance * (1 - 1e-9), clearance + 1e-9);
        }
    }

    @ParameterizedTest
    @EnumSource(Dimension.class)
    void aRobotSlidesAlongFlushWalls(Dimension dimension) {
        for (int kind = 0; kind < 4; kind++) {
            Geometry world = new Geometry(SIZE, SIZE, SIZE, dimension, Accuracy.EXACT);
            for (int x = -8; x < 8; x++) {
                add(world, new BoxObject(new Point(x + 0.5, 0, -0.25), 1, 2, 0.5));
            }
            Point at = new Point(-4, 0, 0.5);
            GeometryObject robot = switch (kind) {
                case 0 -> new BoxObject(at, 0.75, 1, 1).moveable("robot");
                case 1 -> new CylinderObject(at, 0.5, 1).moveable("robot");
                case 2 -> new SphereObject(at, 0.5).moveable("robot");
                default ->
                    new BoxObject(new Point(-4, 0, 0.5), 1, 1, 1).turned(0, 90).moveable("robot");
            };
            add(world, robot);
            assertThat(world.moveGlobal("robot", new Move(8.3, 0, 0, 0, 0)).allowed())
                    .as("kind " + kind)
                    .isTrue();
            assertThat(world.moveGlobal("robot", new Move(-1.7, 0, 0, 0, 0)).allowed())
                    .as("kind " + kind)
                    .isTrue();
            MoveResult into = world.moveGlobal("robot", new Move(-1, 0, -0x1p-53, 0, 0));
            assertThat(into.allowed()).as("kind " + kind).isFalse();
            assertThat(into.fraction()).isZero();
            if (kind == 1 || kind == 2) {
                assertThat(world.simpleTurn("robot", 77)).as("kind " + kind).isTrue();
            } else {
                assertThat(world.simpleTurn("robot", 7)).as("kind " + kind).isFalse();
            }
            // A wall that stands out by the last bit.
            add(world, new BoxObject(new Point(6, 0, -0.25), 1, 2, Math.nextUp(0.5)).named("proud"));
            MoveResult proud = world.moveGlobal("robot", new Move(8, 0, 0, 0, 0));
            assertThat(proud.allowed()).as("kind " + kind).isFalse();
            assertThat(proud.obstacle().name()).as("kind " + kind).isEqualTo("proud");
        }
    }

    /** In the plane between a robot's edge and what it touches there, whose sides lie otherwise. */
    @Test
    void aPlaneBetweenCornersCounts() {
        Geometry world = new Geometry(SIZE, SIZE, SIZE, Dimension.PLANAR, Accuracy.EXACT);
        // The robot's corner at the origin, a post's there too; the diagonal parts them, and the next wall begins on
        // it.
        add(world, new BoxObject(new Point(1, 0, -1), 2, 1, 2));
        List<Point> p = List.of(new Point(2, 0, 2), new Point(5, 0, 5), new Point(5, 0, 0));
        add(world, new MeshObject(p, new int[][] {{0, 1, 2}}).named("next"));
        add(world, new BoxObject(new Point(-0.5, 0, 0.5), 1, 1, 1).moveable("robot"));
        assertThat(world.moveGlobal("robot", new Move(3, 0, 3, 0, 0)).allowed()).isTrue();
    }

    /** What touches nothing at the start is blocked by what it would only touch, at its very level too. */
    @ParameterizedTest
    @EnumSource(Mover.class)
    void whatStandsOnNothingIsBlockedByAFlushTable(Mover mover) {
        for (boolean isMesh : new boolean[] {false, true}) {
            for (int away = 0; away < 2; away++) {
                Geometry world = new Geometry(SIZE, SIZE, SIZE);
                add(world, isMesh ? mesh(false) : new BoxObject(new Point(0, -0.5, 0), 16, 1, 16));
                add(world, mover.at(-9.5, away * 0x1p-40, 0));
                MoveResult result = world.moveGlobal("robot", new Move(4, 0, 0, 0, 0));
                assertThat(result.allowed())
                        .as("%s, %s: %s", mover, isMesh, result)
                        .isEqualTo(away > 0);
            }
        }
    }

    /** What lies in the level of a contact is on both of its sides, and so is what stands on it or hangs from it. */
    @Test
    void aSheetSlidesBetweenTwo() {
        MeshObject sheet = new MeshObject(
                List.of(new Point(-1, 0, -2), new Point(0, 0, 3), new Point(-1, 0, -1)), new int[][] {{0, 1, 2}});
        MeshObject beside = new MeshObject(
                List.of(new Point(2, 0, 2), new Point(3, 0, 3), new Point(-3, 0, -1)), new int[][] {{0, 1, 2}});
        for (int side = -1; side <= 1; side += 2) {
            Geometry world = new Geometry(SIZE, SIZE, SIZE);
            add(world, beside);
            add(world, new BoxObject(new Point(-4, side, 0), 0, 2, 2));
            add(world, sheet.moveable("robot"));
            assertThat(world.moveGlobal("robot", new Move(-6, 0, 1, 0, 0)).allowed())
                    .isTrue();
        }
    }
}
