package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.BitSet;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
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
import robosim.geometry.model.GridObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;

/** No stop traps the robot: wherever a motion was stopped, the same motion backwards is free. */
@Tag("slow")
class NoTrapTest {
    private enum Shape {
        BOX,
        TIPPED_BOX,
        CYLINDER,
        TIPPED_CYLINDER,
        SPHERE,
        CAPSULE,
        TIPPED_CAPSULE,
        MESH,
        GROUP,
        GRID;

        boolean isConvex() {
            return ordinal() < MESH.ordinal();
        }
    }

    /** A shorter way is below the rounding of places. */
    private static final double LEAST = 1e-13;

    private static final int[][] TETRAHEDRON = {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}};

    private int turns;
    private int stopped;

    private static GeometryObject shape(Shape shape, double size, SplittableRandom random) {
        double p = size * random.nextDouble(0.1, 0.5);
        double q = size * random.nextDouble(0.1, 1);
        GeometryObject object = switch (shape) {
            case BOX, TIPPED_BOX -> new BoxObject(new Point(), q, 2 * p, size * random.nextDouble(0.1, 1));
            case CYLINDER, TIPPED_CYLINDER -> new CylinderObject(new Point(), p, q);
            case SPHERE -> new SphereObject(new Point(), p);
            case CAPSULE, TIPPED_CAPSULE -> new CapsuleObject(new Point(), p, q);
            case MESH ->
                new MeshObject(
                        List.of(new Point(p, p, q), new Point(-p, -q, p), new Point(-q, p, -p), new Point(q, -p, -q)),
                        TETRAHEDRON);
            case GROUP ->
                new ObjectGroup(List.of(
                        new CapsuleObject(new Point(0, 0.2 * size, 0), p, q),
                        new BoxObject(new Point(q, 0, p), p, q, 0.5 * size)));
            case GRID -> new GridObject(new Point(), 0.4 * p, size, 3, 3, cells(random));
        };
        boolean isTipped = switch (shape) {
            case TIPPED_BOX, TIPPED_CYLINDER, TIPPED_CAPSULE, MESH, GROUP -> true;
            case BOX, CYLINDER, SPHERE, CAPSULE, GRID -> false;
        };
        double[] tips = {90, random.nextDouble(-180, 180)};
        double heading = random.nextInt(4) == 0 ? 90 * random.nextInt(4) : random.nextDouble(-180, 180);
        return object.turned(isTipped ? tips[random.nextInt(2)] : 0, heading);
    }

    private static BitSet cells(SplittableRandom random) {
        BitSet cells = new BitSet();
        cells.set(4);
        for (int k = 0; k < 9; k++) {
            cells.set(k, cells.get(k) || random.nextBoolean());
        }
        return cells;
    }

    private static Point direction(SplittableRandom random, Dimension dimension) {
        double x = random.nextDouble(-1, 1);
        double y = dimension == Dimension.PLANAR ? 0 : random.nextDouble(-1, 1);
        double z = random.nextDouble(-1, 1);
        double length = Math.sqrt(x * x + y * y + z * z);
        return new Point(x / length, y / length, z / length);
    }

    private static Move move(Point way, double times) {
        return new Move(times * way.x(), times * way.y(), times * way.z(), 0, 0);
    }

    /** What was made of a move, backwards but for its last thousandth, in which rounding may put the end closer than the start. */
    private static Move back(Move move, MoveResult made) {
        double times = -0.999 * made.fraction();
        return new Move(times * move.x(), times * move.y(), times * move.z(), 0, 0);
    }

    @ParameterizedTest
    @EnumSource(Dimension.class)
    void everyStopCanBeReversed(Dimension dimension) {
        SplittableRandom random = new SplittableRandom(97 + dimension.ordinal());
        int pairs = 0;
        int stops = 0;
        int close = 0;
        turns = 0;
        stopped = 0;
        for (Shape moving : Shape.values()) {
            for (Shape still : Shape.values()) {
                if (moving == Shape.GRID) {
                    continue;
                }
                int before = stops;
                for (int k = 0; k < Effort.cases(12, 3); k++) {
                    double larger = random.nextInt(3) == 0 ? StrictMath.pow(10, random.nextDouble(0, 4)) : 1;
                    Geometry world = new Geometry(1e6, 1e6, 1e6, dimension, Accuracy.EXACT);
                    GeometryObject obstacle = shape(still, larger, random);
                    Point from = direction(random, dimension);
                    GeometryObject mover = shape(moving, 1, random)
                            .movedTo(new Point(4 * larger * from.x(), 4 * larger * from.y(), 4 * larger * from.z()))
                            .moveable("m");
                    if (!world.addObject(obstacle) || !world.addObject(mover)) {
                        continue;
                    }
                    Point way = new Point(
                            larger * (random.nextDouble(-0.1, 0.1) - 4 * from.x()),
                            dimension == Dimension.PLANAR ? 0 : larger * (random.nextDouble(-0.1, 0.1) - 4 * from.y()),
                            larger * (random.nextDouble(-0.1, 0.1) - 4 * from.z()));
                    for (int approach = 0; approach < 3; approach++) {
                        Move move = own(world.getObject("m"), move(way, 1));
                        MoveResult made = world.moveToContact("m", move, 0);
                        if (made.allowed()) {
                            break;
                        }
                        stops++;
                        close += world.getProximity("m", 1e-12) < 1e-12 ? 1 : 0;
                        String what = "%s beside %s by %s, stopped at %s, %s"
                                .formatted(world.getObject("m"), obstacle, move, made.fraction(), approach);
                        if (made.fraction() * length(move) > LEAST) {
                            assertThat(copy(world).move("m", back(move, made)).allowed())
                                    .as(what)
                                    .isTrue();
                        }
                        Point normal = made.normal();
                        assertThat(normal).isNotNull();
                        if (moving.isConvex() && still.isConvex()) {
                            Move off = move(normal, random.nextBoolean() ? 0.02 : 5);
                            assertThat(copy(world).moveGlobal("m", off).allowed())
                                    .as(what + ", off along " + normal)
                                    .isTrue();
                        }
                        turnBack(copy(world), random.nextDouble(-60, 60), what);
                        Point aside = direction(random, dimension);
                        double into = random.nextDouble(0.1, 1);
                        way = new Point(
                                aside.x() - into * normal.x(),
                                dimension == Dimension.PLANAR ? 0 : aside.y() - into * normal.y(),
                                aside.z() - into * normal.z());
                    }
                }
                pairs += stops > before ? 1 : 0;
            }
        }
        assertThat(pairs).isEqualTo(9 * 10);
        assertThat(stops).isGreaterThan(Effort.cases(1800, 450));
        assertThat(close).isGreaterThan(stops / 4);
        assertThat(turns).isGreaterThan(stops / 40);
        assertThat(stopped).isLessThan(turns / 10 + 1);
    }

    /** From a stop at a flat wall, ways along it are free across the seams of its triangles. */
    @ParameterizedTest
    @EnumSource(
            value = Shape.class,
            names = {"CYLINDER", "CAPSULE", "TIPPED_CYLINDER", "TIPPED_CAPSULE", "TIPPED_BOX", "GROUP"})
    void waysAlongTheSeamsOfAWallAreFree(Shape moving) {
        SplittableRandom random = new SplittableRandom(41);
        for (int k = 0; k < Effort.cases(800, 200); k++) {
            Geometry world = new Geometry(100, 100, 100);
            world.addObject(new MeshObject(
                    List.of(new Point(0, -2, -10), new Point(0, -2, 10), new Point(0, 2, 10), new Point(0, 2, -10)),
                    new int[][] {{0, 1, 2, 3}}));
            Point start = new Point(1.5, random.nextDouble(-1, 1), random.nextDouble(-3, 3));
            world.addObject(shape(moving, 1, random).movedTo(start).moveable("m"));
            double share = world.moveGlobal("m", new Move(-2, 0, 0, 0, 0)).fraction();
            assertThat(world.moveGlobal("m", new Move(-2 * share, 0, 0, 0, 0)).allowed())
                    .isTrue();
            double up = random.nextInt(4) > 0 ? 0 : random.nextDouble(-0.5, 0.5);
            Move along = new Move(0, up, random.nextDouble(-2, 2), 0, 0);
            assertThat(world.moveGlobal("m", along).allowed())
                    .as("%s along the wall by %s", world.getObject("m"), along)
                    .isTrue();
        }
    }

    /** A lying cylinder that has stopped at a wall with a point of its rim is free to tip where that only recedes. */
    @Test
    void aRimThatOnlyRecedesIsFreeToTip() {
        SplittableRandom random = new SplittableRandom(43);
        int receding = 0;
        for (int k = 0; k < Effort.cases(400, 100); k++) {
            Geometry world = new Geometry(100, 100, 100);
            double radius = random.nextDouble(0.1, 0.4);
            double half = random.nextDouble(0.1, 0.5);
            world.addObject(new BoxObject(new Point(0, 0, 0.5), 20, 8, 1));
            world.addObject(new CylinderObject(new Point(0, 0, -1.5), radius, 2 * half)
                    .turned(90, random.nextDouble(360))
                    .moveable("m"));
            double share = world.moveGlobal("m", new Move(0, 0, 3, 0, 0)).fraction();
            assertThat(world.moveGlobal("m", new Move(0, 0, 3 * share, 0, 0)).allowed())
                    .isTrue();
            double degrees = random.nextDouble(-60, 60);
            double[] axes = world.getObject("m").rotation();
            double start = reach(radius, half, axes[7]);
            boolean recedes = true;
            for (int part = 1; part <= 100; part++) {
                double angle = Math.toRadians(0.01 * part * degrees);
                double along = StrictMath.cos(angle) * axes[7] + StrictMath.sin(angle) * axes[8];
                recedes &= reach(radius, half, along) < start;
            }
            if (recedes) {
                receding++;
                assertThat(world.move("m", new Move(0, 0, 0, degrees, 0)).allowed())
                        .as("%s tipped by %s", world.getObject("m"), degrees)
                        .isTrue();
            }
        }
        assertThat(receding).isGreaterThan(Effort.cases(100, 25));
    }

    /** How far a cylinder extends along a direction that has a cosine with its axis. */
    private static double reach(double radius, double half, double cosine) {
        return radius * Math.sqrt(Math.max(0, 1 - cosine * cosine)) + half * Math.abs(cosine);
    }

    /** Where a turn is blocked from a stop, every longer turn the same way is too: the whole arc counts, not only its end. */
    @ParameterizedTest
    @EnumSource(Dimension.class)
    void longerTurnsAreBlockedToo(Dimension dimension) {
        SplittableRandom random = new SplittableRandom(79 + dimension.ordinal());
        int blocked = 0;
        int near = 0;
        for (Shape moving : Shape.values()) {
            for (Shape still : Shape.values()) {
                for (int k = 0; k < (moving == Shape.GRID ? 0 : Effort.cases(12, 3)); k++) {
                    Geometry world = new Geometry(1e6, 1e6, 1e6, dimension, Accuracy.EXACT);
                    double larger = random.nextInt(3) == 0 ? 1 : 20;
                    GeometryObject wall = new BoxObject(new Point(), 6 * larger, larger, larger);
                    boolean isWall = random.nextBoolean();
                    Point from = direction(random, dimension);
                    GeometryObject mover = shape(moving, 1, random)
                            .movedTo(new Point(30 * from.x(), 30 * from.y(), 30 * from.z()))
                            .moveable("m");
                    if (!world.addObject(isWall ? wall : shape(still, larger, random)) || !world.addObject(mover)) {
                        continue;
                    }
                    Move way = new Move(-30 * from.x(), -30 * from.y(), -30 * from.z(), 0, 0);
                    MoveResult made = world.moveGlobal("m", way);
                    double share = made.fraction();
                    if (made.allowed()
                            || !world.moveGlobal("m", new Move(share * way.x(), share * way.y(), share * way.z(), 0, 0))
                                    .allowed()) {
                        continue;
                    }
                    near += world.getProximity("m", 1e-9) < 1e-9 ? 1 : 0;
                    boolean isBlocked = false;
                    boolean isTipped = random.nextInt(3) == 0;
                    int sign = random.nextBoolean() ? 1 : -1;
                    for (double degrees : new double[] {0.5, 3, 10, 25, 45, 90, 120, 140, 170, 180, 270, 355}) {
                        double by = sign * degrees;
                        Move turn = isTipped ? new Move(0, 0, 0, by, 0) : new Move(0, 0, 0, 0, by);
                        boolean allowed = copy(world).move("m", turn).allowed();
                        assertThat(allowed && isBlocked)
                                .as(
                                        "%s turned by %s, tipped %s, in %s",
                                        world.getObject("m"), by, isTipped, world.objects())
                                .isFalse();
                        isBlocked = !allowed;
                    }
                    blocked += isBlocked ? 1 : 0;
                }
            }
        }
        assertThat(near).isGreaterThan(Effort.cases(600, 150));
        assertThat(blocked).isGreaterThan(near / 4);
    }

    /**
     * Turns as far as possible, and back but for a tenth. A turn that passed something by less than can be resolved may stop
     * there on its way back, but not at once. A lying object that turns about its own axis stays as far from a wall as it was;
     * where that is less than its rotation is rounded by, the stored end may touch the wall.
     */
    private void turnBack(Geometry world, double degrees, String what) {
        MoveResult made = world.moveToContact("m", new Move(0, 0, 0, 0, degrees), 0);
        if (made.allowed() || made.turnFraction() == 0) {
            return;
        }
        turns++;
        double by = -0.9 * made.turnFraction() * degrees;
        MoveResult back = world.move("m", new Move(0, 0, 0, 0, by));
        stopped += back.allowed() ? 0 : 1;
        assertThat(back.allowed() ? 1 : back.turnFraction())
                .as(what + ", turned by " + degrees + " up to " + made.turnFraction())
                .isGreaterThan(1e-3);
    }

    private static double length(Move move) {
        return Math.sqrt(move.x() * move.x() + move.y() * move.y() + move.z() * move.z());
    }

    private static Geometry copy(Geometry world) {
        return world.snapshot().toGeometry();
    }

    /** A displacement in the world's axes as one in the object's own. */
    private static Move own(GeometryObject object, Move move) {
        double[] r = object.rotation();
        return new Move(
                r[0] * move.x() + r[3] * move.y() + r[6] * move.z(),
                r[1] * move.x() + r[4] * move.y() + r[7] * move.z(),
                r[2] * move.x() + r[5] * move.y() + r[8] * move.z(),
                0,
                0);
    }

    /** A capsule 1.4e-14 from a plain box: once, nothing was free there. */
    @Test
    void aCapsuleAHairFromABoxIsFree() {
        Geometry world = new Geometry(400, 40, 400);
        assertThat(world.addObject(new BoxObject(new Point(0, 1, 1.25), 4, 3, 0.5)))
                .isTrue();
        Point at = new Point(-1.4222070751067863, 0.5, 0.6999999999999861);
        assertThat(world.addObject(new CapsuleObject(at, 0.3, 0.4).moveable("m")))
                .isTrue();
        assertThat(world.getProximity("m", 9)).isBetween(1e-14, 2e-14);
        for (Move free : List.of(
                new Move(0, 0, -0.02, 0, 0),
                new Move(0, 0, -5, 0, 0),
                new Move(0.02, 0, 0, 0, 0),
                new Move(-1, 0, -1e-300, 0, 0),
                new Move(0, 0, 0, 0, 30))) {
            assertThat(copy(world).moveGlobal("m", free).allowed())
                    .as("" + free)
                    .isTrue();
        }
        assertThat(copy(world).moveGlobal("m", new Move(0, 0, 1e-3, 0, 0)).fraction())
                .isZero();
    }
}
