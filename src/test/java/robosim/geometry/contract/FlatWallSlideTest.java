package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import robosim.geometry.Effort;
import robosim.geometry.Geometry;
import robosim.geometry.SlideResult;
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

/**
 * Robots that are driven into a flat wall of any heading, step by step: whatever pieces the wall consists of, they cover the
 * whole distance along it, keep their clearance once they have it, and keep their height.
 *
 * <p>{@code -Dslide.headings=360 -Dslide.steps=10000} drives for as long at as many headings.
 */
class FlatWallSlideTest {
    private static final int HEADINGS = Integer.getInteger("slide.headings", Effort.cases(12));
    private static final int STEPS = Integer.getInteger("slide.steps", 120);
    private static final double STEP = 0.01;
    private static final double TILE = 0.25;

    /** The distance of the wall's face from the origin, in its own frame along Z. */
    private static final double FACE = 1;

    /** What a wall consists of. */
    enum Wall {
        BOXES,
        QUADS,
        GRID,
        GROUP;

        /** A wall from the origin of its own frame along X, with its face at {@link #FACE}. */
        List<GeometryObject> built(int tiles, double heading) {
            List<GeometryObject> boxes = new ArrayList<>();
            for (int k = 0; k < tiles; k++) {
                boxes.add(new BoxObject(new Point(TILE * (k + 0.5), 1, FACE + 0.25), TILE, 3, 0.5));
            }
            return switch (this) {
                case BOXES ->
                    boxes.stream()
                            .map(box ->
                                    box.movedTo(turned(box.center(), heading)).turned(0, heading))
                            .toList();
                case QUADS -> List.of(quads(tiles).turned(0, heading));
                case GROUP -> List.of(new ObjectGroup(boxes).turned(0, heading));
                case GRID -> {
                    BitSet cells = new BitSet();
                    cells.set(0, 2 * tiles);
                    Point middle = turned(new Point(TILE * tiles / 2, 1, FACE + TILE), heading);
                    yield List.of(new GridObject(middle, TILE, 3, tiles, 2, cells).turned(0, heading));
                }
            };
        }
    }

    /** What is driven: a name and a shape whose middle is half a metre from its outermost point along Z at most. */
    enum Mover {
        BOX,
        PARALLEL_BOX,
        CYLINDER,
        SPHERE,
        CAPSULE,
        HUMANOID,
        MESH;

        GeometryObject at(Point place, double heading) {
            return switch (this) {
                case BOX -> new BoxObject(place, 0.4, 1, 0.4).moveable("robot");
                case PARALLEL_BOX ->
                    new BoxObject(place, 0.6, 1, 0.4).turned(0, heading).moveable("robot");
                case CYLINDER -> new CylinderObject(place, 0.3, 1).moveable("robot");
                case SPHERE -> new SphereObject(place, 0.3).moveable("robot");
                case CAPSULE -> new CapsuleObject(place, 0.3, 0.4).moveable("robot");
                case HUMANOID -> humanoid().movedTo(place).moveable("robot");
                case MESH -> hull().movedTo(place).moveable("robot");
            };
        }
    }

    private static ObjectGroup humanoid() {
        return new ObjectGroup(List.of(
                new SphereObject(new Point(0, 0.35, 0), 0.12),
                new CapsuleObject(new Point(0, 0, 0), 0.16, 0.4),
                new CapsuleObject(new Point(0, 0, 0.27), 0.05, 0.5),
                new CapsuleObject(new Point(0, 0, -0.27), 0.05, 0.5)));
    }

    /** The surface of a wedge. */
    private static MeshObject hull() {
        return new MeshObject(
                List.of(
                        new Point(0.4, -0.4, 0),
                        new Point(-0.3, -0.4, 0.3),
                        new Point(-0.3, -0.4, -0.3),
                        new Point(0.4, 0.4, 0),
                        new Point(-0.3, 0.4, 0.3),
                        new Point(-0.3, 0.4, -0.3)),
                new int[][] {{0, 1, 2}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}});
    }

    private static MeshObject quads(int tiles) {
        List<Point> corners = new ArrayList<>();
        int[][] faces = new int[2 * tiles][];
        for (int k = 0; k <= tiles; k++) {
            for (int row = 0; row < 3; row++) {
                corners.add(new Point(TILE * k, row * 1.1 - 0.6, FACE));
            }
        }
        for (int k = 0; k < tiles; k++) {
            for (int row = 0; row < 2; row++) {
                int at = 3 * k + row;
                faces[2 * k + row] = new int[] {at, at + 3, at + 4, at + 1};
            }
        }
        return new MeshObject(corners, faces);
    }

    private static Point turned(Point p, double heading) {
        double c = StrictMath.cos(StrictMath.toRadians(heading));
        double s = StrictMath.sin(StrictMath.toRadians(heading));
        return new Point(p.x() * c + p.z() * s, p.y(), p.z() * c - p.x() * s);
    }

    static Stream<Arguments> drives() {
        return Stream.of(Dimension.values())
                .flatMap(dimension -> Stream.of(Wall.values())
                        .flatMap(wall -> Stream.of(Mover.values()).map(mover -> Arguments.of(dimension, wall, mover))));
    }

    @ParameterizedTest
    @MethodSource("drives")
    void allOfTheDistanceAlongTheWallIsCovered(Dimension dimension, Wall wall, Mover mover) {
        SplittableRandom random = new SplittableRandom(20261126);
        int reaching = 0;
        int reached = 0;
        for (int k = 0; k < HEADINGS; k++) {
            double heading = HEADINGS >= 360 ? k + 0.3 * (k % 2) : random.nextDouble(360);
            double[] clearances = {0, 0.001, 0.05};
            double angle = 1 + random.nextInt(89);
            boolean isToReach = STEPS * STEP * StrictMath.sin(StrictMath.toRadians(angle)) > 0.3;
            reaching += isToReach ? 1 : 0;
            boolean isReached = drive(dimension, wall, mover, heading, angle, clearances[k % 3]);
            reached += isToReach && isReached ? 1 : 0;
        }
        assertThat(reaching).isPositive();
        assertThat(reached).isEqualTo(reaching);
    }

    /** Drives into a wall at an angle and returns whether it came to it. */
    private static boolean drive(
            Dimension dimension, Wall wall, Mover mover, double heading, double angle, double clearance) {
        double along = STEP * StrictMath.cos(StrictMath.toRadians(angle));
        double into = STEP * StrictMath.sin(StrictMath.toRadians(angle));
        double length = STEPS * along;
        Geometry world = new Geometry(2 * length + 40, 20, 2 * length + 40, dimension, Accuracy.EXACT);
        wall.built((int) Math.ceil((length + 2) / TILE), heading)
                .forEach(o -> assertThat(world.addObjectUnchecked(o)).isTrue());
        Point start = turned(new Point(1, 0.5, FACE - 0.45), heading);
        assertThat(world.addObject(mover.at(start, heading))).isTrue();
        Point tangent = turned(new Point(1, 0, 0), heading);
        Point way = turned(new Point(along, 0, into), heading);
        // In the robot's own frame.
        double[] r = world.getObject("robot").rotation();
        Move step = new Move(r[0] * way.x() + r[6] * way.z(), 0, r[2] * way.x() + r[8] * way.z(), 0, 0);
        String what = "%s %s %s heading %s angle %s clearance %s"
                .formatted(dimension, wall, mover, heading, angle, clearance);
        boolean wasClear = false;
        int contacts = 0;
        for (int k = 0; k < STEPS; k++) {
            SlideResult result = world.moveAndSlide("robot", step, clearance, 4);
            contacts += result.contacts().isEmpty() ? 0 : 1;
            double gap = world.getProximity("robot", 10);
            boolean isClear = gap >= clearance;
            assertThat(isClear || !wasClear)
                    .as("%s step %d gap %s", what, k, gap)
                    .isTrue();
            wasClear = isClear;
            assertThat(world.getObject("robot").center().y()).as(what).isEqualTo(0.5);
        }
        Point end = world.getObject("robot").center();
        double covered = (end.x() - start.x()) * tangent.x() + (end.z() - start.z()) * tangent.z();
        assertThat(covered).as(what).isBetween(0.999 * length, 1.001 * length);
        assertThat(wasClear).as(what).isTrue();
        return contacts > 0;
    }
}
