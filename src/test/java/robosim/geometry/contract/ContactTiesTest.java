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
import robosim.geometry.SlideResult;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;

/** Which contact is reported where several things are hit at once. */
class ContactTiesTest {
    /** Two walls of a corner, at x = 4 and at z = 4, hit at the same fraction. */
    @ParameterizedTest
    @EnumSource
    void inACornerTheWallAheadIsReported(Dimension dimension) {
        for (int order = 0; order < 2; order++) {
            for (int steep = 0; steep < 2; steep++) {
                BoxObject east = new BoxObject(new Point(4.5, 0, 0), 1, 2, 8).named("east");
                BoxObject south = new BoxObject(new Point(0, 0, 4.5), 8, 2, 1).named("south");
                Geometry world = world(dimension);
                world.addObjectUnchecked(order == 0 ? east : south);
                world.addObjectUnchecked(order == 0 ? south : east);
                // Gaps as the way: both walls are reached after half of it.
                Point at = steep == 0 ? new Point(1, 0, 2.5) : new Point(2.5, 0, 1);
                world.addObject(new BoxObject(at, 1, 1, 1).moveable("robot"));
                Move move = new Move(2 * (3.5 - at.x()), 0, 2 * (3.5 - at.z()), 0, 0);
                MoveResult result = world.move("robot", move);
                assertThat(result.normal()).isEqualTo(steep == 0 ? new Point(-1, 0, 0) : new Point(0, 0, -1));
                // Either is named: their fractions differ by what a caller rounds.
                assertThat(result.obstacle().name()).isIn("east", "south");
                SlideResult slide = world.moveAndSlide("robot", move, 0, 8);
                assertThat(slide.contacts())
                        .extracting(contact -> contact.obstacle().name())
                        .containsExactlyInAnyOrder("east", "south");
                for (SlideResult.SlideContact contact : slide.contacts()) {
                    assertThat(contact.normal().x() != 0)
                            .isEqualTo("east".equals(contact.obstacle().name()));
                }
            }
        }
    }

    /**
     * At a seam of a flat wall made of tiles, at any heading, a corner or an edge of the mover hits two tiles at once: the
     * normal is that of the wall, not that of a tile's side.
     */
    @Test
    void atASeamTheNormalOfTheWallIsReported() {
        SplittableRandom random = new SplittableRandom(36);
        int blocked = 0;
        int bySide = 0;
        for (int k = 0; k < Effort.cases(6000, 1500); k++) {
            Dimension dimension = Dimension.values()[k % 2];
            double heading = k % 5 == 0 ? 90 * random.nextInt(4) : random.nextDouble(-180, 180);
            List<GeometryObject> tiles = tiles(k / 2 % 4, heading);
            Geometry world = world(dimension);
            tiles.forEach(world::addObjectUnchecked);
            // The corner that goes ahead is at a seam when it hits the wall.
            double ahead = random.nextInt(-2, 3) + random.nextInt(-1, 2) * 0x1p-52;
            double slope = random.nextDouble(-4, 4);
            Point corner = new Point(ahead - slope, 0, -1);
            double side = k % 3 == 0 ? 0.5 : -0.5;
            Point centre = new Point(corner.x() + side, 0, corner.z() - 0.5);
            GeometryObject robot = k / 8 % 2 == 0
                    ? new BoxObject(along(heading, centre), 1, 1, 1).turned(0, heading)
                    : new CylinderObject(along(heading, new Point(corner.x(), 0, -1.5)), 0.5, 1);
            assertThat(world.addObject(robot.moveable("robot"))).isTrue();
            Point way = along(heading, new Point(1.5 * slope, 0, 1.5));
            MoveResult result = world.moveGlobal("robot", new Move(way.x(), way.y(), way.z(), 0, 0));
            if (!result.allowed()) {
                blocked++;
                Point out = along(heading, new Point(0, 0, -1));
                Point n = result.normal();
                bySide += n.x() * out.x() + n.z() * out.z() > 1 - 1e-9 ? 0 : 1;
            }
        }
        assertThat(blocked).isGreaterThan(1000);
        // A tile that rounding puts before its neighbour may be hit on its side.
        assertThat(bySide).isLessThanOrEqualTo(1 + blocked / 500);
    }

    /** The wall is at z = 0, from x = -8 to 8, in tiles of 1, before it is turned. */
    private static List<GeometryObject> tiles(int kind, double heading) {
        List<GeometryObject> tiles = new ArrayList<>();
        List<Point> vertices = new ArrayList<>();
        List<int[]> faces = new ArrayList<>();
        for (int x = -8; x < 8; x++) {
            BoxObject box = new BoxObject(new Point(x + 0.5, 0, 0.5), 1, 2, 1);
            tiles.add(kind == 0 ? box.movedTo(along(heading, box.center())).turned(0, heading) : box);
            int first = vertices.size();
            vertices.addAll(
                    List.of(new Point(x, -1, 0), new Point(x + 1, -1, 0), new Point(x + 1, 1, 0), new Point(x, 1, 0)));
            faces.add(new int[] {first, first + 1, first + 2, first + 3});
        }
        return switch (kind) {
            case 0 -> tiles;
            case 1 -> List.of(new ObjectGroup(tiles).turned(0, heading));
            case 2 -> List.of(new MeshObject(vertices, faces.toArray(new int[0][])).turned(0, heading));
            default ->
                faces.stream()
                        .<GeometryObject>map(face -> new MeshObject(vertices, new int[][] {face}).turned(0, heading))
                        .toList();
        };
    }

    private static Geometry world(Dimension dimension) {
        return new Geometry(100, 100, 100, dimension, Accuracy.EXACT);
    }

    private static Point along(double heading, Point p) {
        double c = Math.cos(Math.toRadians(heading));
        double s = Math.sin(Math.toRadians(heading));
        double cos = heading % 90 == 0 ? Math.rint(c) : c;
        double sin = heading % 90 == 0 ? Math.rint(s) : s;
        return new Point(cos * p.x() + sin * p.z(), p.y(), cos * p.z() - sin * p.x());
    }
}
