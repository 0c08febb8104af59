package robosim.geometry.render;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import robosim.geometry.Effort;
import robosim.geometry.Geometry;
import robosim.geometry.SenseBuffer;
import robosim.geometry.SenseBuffer.Extra;
import robosim.geometry.material.Color;
import robosim.geometry.material.Material;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CapsuleObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.RayPattern;
import robosim.geometry.model.SenseOptions;
import robosim.geometry.model.SphereObject;

/** Neither acne nor leaks, however flat the light and however far from the origin. */
@Tag("slow")
class ShadowsTest {
    private static final Material WHITE = Material.of(Color.WHITE).withSpecular(0);

    private final SplittableRandom random = new SplittableRandom(7);

    private static Geometry world(List<GeometryObject> objects) {
        Geometry world = new Geometry(0x1p23, 0x1p23, 0x1p23);
        objects.forEach(object -> assertThat(world.addObjectUnchecked(object)).isTrue());
        return world;
    }

    private static ColorFrame picture(Geometry world, Pose pose, Lighting lighting, int skyRays) {
        ColorFrame frame = new ColorFrame();
        ColorCamera.of(120, 90, 80)
                .at(pose)
                .withLighting(lighting)
                .withSkyRays(skyRays, Double.POSITIVE_INFINITY)
                .render(world, frame);
        return frame;
    }

    private static Lighting sun(double x, double y, double z, double strength) {
        return Lighting.NONE.withLight(new Light.Sun(new Point(x, y, z), Color.WHITE, strength));
    }

    /** A floor through a point, by kind: a box, tiles, a mesh of quads, a tilted mesh. */
    private static List<GeometryObject> floor(int kind, double x, double y, double z) {
        List<GeometryObject> floor = new ArrayList<>();
        switch (kind) {
            case 0 -> floor.add(new BoxObject(new Point(x, y - 0.7, z), 60, 1.4, 60));
            case 1 -> {
                for (int k = 0; k < 400; k++) {
                    floor.add(new BoxObject(
                            new Point(x + k % 20 * 3 - 28.5, y - 0.75, z + k / 20 * 3 - 28.5), 3, 1.5, 3));
                }
            }
            default -> {
                List<Point> corners = new ArrayList<>();
                List<int[]> faces = new ArrayList<>();
                for (int k = 0; k <= 20; k++) {
                    for (int j = 0; j <= 20; j++) {
                        corners.add(new Point(3 * j - 30, 0, 3 * k - 30));
                        if (j < 20 && k < 20) {
                            int at = 21 * k + j;
                            faces.add(new int[] {at, at + 1, at + 22, at + 21});
                        }
                    }
                }
                MeshObject mesh = new MeshObject(corners, faces.toArray(int[][]::new));
                floor.add(mesh.movedTo(new Point(x, y, z)));
            }
        }
        return floor.stream().map(object -> object.withMaterial(WHITE)).toList();
    }

    /** The light is so strong that a lit pixel is white, and one that shadows itself would be black. */
    @ParameterizedTest
    @CsvSource({
        "0, 0.3, 0.2, 0.1",
        "0, 1e6, 1e6, -1e6",
        "1, 0.25, 0.5, 0.75",
        "1, 1e6, -1e6, 1e6",
        "2, 0.1, 0.7, 0.3",
        "2, 1e6, 1e6, 1e6"
    })
    void noAcneOnAFloorInGrazingLight(int kind, double x, double y, double z) {
        Geometry world = world(floor(kind, x, y, z));
        int white = 0;
        for (double slope : new double[] {1, 0.1, 1e-2, 1e-4, 1e-6}) {
            for (int turn = 0; turn < 3; turn++) {
                Pose pose =
                        Pose.lookAt(new Point(x + 0.1, y + 4 - turn * 1.3, z), new Point(x + 5, y + 0.1, z + turn - 1));
                Lighting lighting = sun(0.3 + turn, -slope, turn - 0.7, 100 / slope);
                ColorFrame frame = picture(world, pose, lighting, 0);
                for (int row = 45 + 15 * turn; row < 90; row++) {
                    for (int column = 0; column < 120; column++) {
                        int pixel = frame.pixel(column, row);
                        assertThat(pixel == 0xffffff || isBehindTheFloor(pose, column, row, y, 30))
                                .as(
                                        "floor %d, slope %s, turn %d, pixel %d, %d: %x",
                                        kind, slope, turn, column, row, pixel)
                                .isTrue();
                        white += pixel & 1;
                    }
                }
            }
        }
        assertThat(white).isGreaterThan(5 * 3 * 120 * 15);
    }

    /** Whether a pixel's ray passes the rim of the floor. */
    private static boolean isBehindTheFloor(Pose pose, int column, int row, double y, double half) {
        double[] r = pose.rotation();
        double tangent = Math.tan(Math.toRadians(40));
        double up = (90 - 1 - 2 * row) / 120.0 * tangent;
        double right = (2 * column + 1 - 120) / 120.0 * tangent;
        double dy = r[3] + r[4] * up + r[5] * right;
        double t = (y - pose.center().y()) / dy;
        double x = t * (r[0] + r[1] * up + r[2] * right);
        double z = t * (r[6] + r[7] * up + r[8] * right);
        return !(dy < 0) || Math.max(Math.abs(x), Math.abs(z)) > half - 1;
    }

    /** All that faces the sun is lit, on every convex shape alone, whatever its attitude and its place. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 1e3, 1e6})
    void noAcneOnShapes(double far) {
        int lit = 0;
        int shapes = Effort.cases(60, 20);
        for (int k = 0; k < shapes; k++) {
            Point place =
                    new Point(far + random.nextDouble(), random.nextDouble() - far, far * random.nextDouble(-1, 1));
            GeometryObject object = switch (k % 5) {
                case 0 -> new BoxObject(place, 2, 1.2, 1.7);
                case 1 -> new CylinderObject(place, 0.8, 1.4);
                case 2 -> new SphereObject(place, 1);
                case 3 -> new CapsuleObject(place, 0.6, 1.1);
                default ->
                    new ObjectGroup(List.of(new SphereObject(new Point(), 1), new SphereObject(new Point(), 0.4)))
                            .movedTo(place);
            };
            object = object.turned(random.nextDouble(-90, 90), random.nextDouble(-180, 180));
            double angle = random.nextDouble(6.28);
            Point eye = new Point(
                    place.x() + 4 * StrictMath.cos(angle),
                    place.y() + random.nextDouble(-2, 2),
                    place.z() + 4 * StrictMath.sin(angle));
            Pose pose = Pose.lookAt(eye, place);
            Point sun = new Point(random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1));
            Geometry world = world(List.of(object.withMaterial(WHITE)));
            // So strong that whatever faces it at all is white: a step from black to white, no black within.
            ColorFrame frame = picture(world, pose, sun(sun.x(), sun.y(), sun.z(), 1e12), 0);
            ColorFrame shape = picture(world, pose, new Lighting(Sky.of(Color.WHITE, 0), List.of()), 0);
            SenseBuffer met = new SenseBuffer(Extra.OBJECTS, Extra.NORMALS);
            world.sense(pose, RayPattern.pinhole(120, 90, 80), SenseOptions.range(0, 100), met);
            for (int p = 0; p < 120 * 90; p++) {
                if (met.object(p) == null) {
                    assertThat(shape.pixels()[p]).isEqualTo(0xffffff); // the sky
                    continue;
                }
                double facing = -(met.normalX(p) * sun.x() + met.normalY(p) * sun.y() + met.normalZ(p) * sun.z());
                if (Math.abs(facing) > 1e-9) {
                    lit += facing > 0 ? 1 : 0;
                    assertThat(frame.pixels()[p])
                            .as("%s in the sun of %s, pixel %d, facing %s", object, sun, p, facing)
                            .isEqualTo(facing > 0 ? 0xffffff : 0);
                }
            }
        }
        assertThat(lit).isGreaterThan(shapes * 150);
    }

    /**
     * A room of six walls around a point; by kind of boxes that overlap or only touch, of a mesh without inside, of solid
     * meshes in groups in groups, of the cells of a grid between two boxes, or of triangles in a group each.
     */
    private static List<GeometryObject> room(int kind, Point middle, double heading) {
        double thick = 0.1;
        double half = 2;
        List<GeometryObject> walls = new ArrayList<>();
        if (kind == 4) {
            // The cells around 40 x 40 free ones, which are the walls; grids stand upright and are in no group.
            BitSet cells = new BitSet();
            for (int k = 0; k < 42 * 42; k++) {
                cells.set(k, k % 42 == 0 || k % 42 == 41 || k < 42 || k >= 41 * 42);
            }
            GridObject grid = new GridObject(new Point(), thick, 2 * half, 42, 42, cells);
            Pose place = Pose.of(middle, heading);
            List<GeometryObject> room = new ArrayList<>();
            room.add(grid.at(place));
            for (int side = -1; side <= 1; side += 2) {
                room.add(new BoxObject(new Point(0, side * (half + thick / 2), 0), 5, thick, 5)
                        .at(Pose.of(new Point(0, side * (half + thick / 2), 0), 0)
                                .within(place)));
            }
            return room.stream()
                    .map(object -> object.withMaterial(WHITE.withMirror(0.3)))
                    .toList();
        }
        if (kind == 3) {
            for (int side = -1; side <= 1; side += 2) {
                double at = side * (half + thick / 2);
                double wide = 2 * half + 2 * thick;
                walls.add(new ObjectGroup(
                        List.of(solid(at, 0, 0, thick, wide, wide), solid(0, at, 0, wide, thick, wide))));
                walls.add(new ObjectGroup(List.of(
                        new ObjectGroup(List.of(solid(0, 0, 0, wide, wide, thick))).movedTo(new Point(0, 0, at)))));
            }
        } else if (kind == 5) {
            int[][] sides = {{0, 1, 2, 3}, {4, 5, 6, 7}, {0, 1, 5, 4}, {3, 2, 6, 7}, {0, 3, 7, 4}, {1, 2, 6, 5}};
            for (int[] side : sides) {
                for (int k = 2; k < 4; k++) {
                    walls.add(new ObjectGroup(List.of(new MeshObject(
                            List.of(corner(side[0], half), corner(side[k - 1], half), corner(side[k], half)),
                            new int[][] {{0, 1, 2}}))));
                }
            }
        } else if (kind == 2) {
            walls.add(new MeshObject(
                    List.of(
                            new Point(-half, -half, -half),
                            new Point(half, -half, -half),
                            new Point(half, half, -half),
                            new Point(-half, half, -half),
                            new Point(-half, -half, half),
                            new Point(half, -half, half),
                            new Point(half, half, half),
                            new Point(-half, half, half)),
                    new int[][] {{0, 1, 2, 3}, {4, 5, 6, 7}, {0, 1, 5, 4}, {3, 2, 6, 7}, {0, 3, 7, 4}, {1, 2, 6, 5}}));
        } else {
            double wide = kind == 0 ? 2 * half + 2 * thick : 2 * half;
            for (int side = -1; side <= 1; side += 2) {
                double at = side * (half + thick / 2);
                walls.add(new BoxObject(new Point(at, 0, 0), thick, wide, wide));
                walls.add(new BoxObject(new Point(0, at, 0), 2 * half + 2 * thick, thick, 2 * half + 2 * thick));
                walls.add(new BoxObject(new Point(0, 0, at), 2 * half + 2 * thick, wide, thick));
            }
        }
        return List.of(new ObjectGroup(walls)
                .movedTo(middle)
                .turned(heading / 3, heading)
                .withMaterial(WHITE.withMirror(0.3)));
    }

    private static Point corner(int k, double half) {
        return new Point(k % 4 == 1 || k % 4 == 2 ? half : -half, k % 4 > 1 ? half : -half, k > 3 ? half : -half);
    }

    /** A box as a closed mesh that counts its inside. */
    private static GeometryObject solid(double x, double y, double z, double width, double height, double length) {
        List<Point> corners = new ArrayList<>();
        for (int k = 0; k < 8; k++) {
            Point unit = corner(k, 0.5);
            corners.add(new Point(x + unit.x() * width, y + unit.y() * height, z + unit.z() * length));
        }
        return new MeshObject(corners, new int[][] {
                    {0, 1, 2, 3}, {4, 5, 6, 7}, {0, 1, 5, 4}, {3, 2, 6, 7}, {0, 3, 7, 4}, {1, 2, 6, 5}
                })
                .solid();
    }

    @ParameterizedTest
    @CsvSource({
        "0, 0, 0",
        "1, 0, 0",
        "2, 0, 0",
        "3, 0, 0",
        "3, 0, 33",
        "3, 1e6, 71",
        "4, 0, 0",
        "4, 0, 33",
        "4, 1e6, 90",
        "5, 0, 0",
        "5, 1e6, 0",
        "0, 0, 33",
        "2, 0, 33",
        "0, 1e6, 0",
        "1, 1e6, 0",
        "2, 1e6, 0",
        "2, 1e6, 71"
    })
    void aClosedRoomStaysDark(int kind, double far, double heading) {
        Point middle = new Point(far, -far / 2, far / 3);
        Geometry world = world(room(kind, middle, heading));
        Lighting lighting = new Lighting(Sky.of(Color.WHITE, 1), List.of());
        for (int k = 0; k < 4; k++) {
            Point way = new Point(random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1));
            lighting = lighting.withLight(new Light.Sun(way, Color.WHITE, 1e30));
            Point lamp = new Point(middle.x() + 4 * way.x(), middle.y() + 4 + way.y(), middle.z() + 4 * way.z());
            lighting = lighting.withLight(new Light.Lamp(lamp, Color.WHITE, 1e30));
        }
        for (int k = 0; k < 12; k += Effort.stride(12)) {
            // Into the corners, from the middle and from close to them.
            double near = k < 4 ? 0 : k < 8 ? 1.2 : 1.99;
            Point corner = placed(world, middle, (k & 1) * 4 - 2, (k & 2) * 2 - 2, (k & 4) - 2);
            Point eye = placed(world, middle, ((k & 1) - 0.5) * 2 * near, ((k >> 1 & 1) - 0.5) * 2 * near, 0.1);
            ColorFrame frame = new ColorFrame();
            ColorCamera.of(40, 30, 80)
                    .at(Pose.lookAt(eye, corner))
                    .withLighting(lighting)
                    .withSkyRays(2, Double.POSITIVE_INFINITY)
                    .render(world, frame);
            assertThat(frame.pixels()).as("eye %s, corner %s", eye, corner).containsOnly(0);
        }
    }

    private static Point placed(Geometry world, Point middle, double x, double y, double z) {
        double[] r = world.objects().get(0).rotation();
        return new Point(
                middle.x() + r[0] * x + r[1] * y + r[2] * z,
                middle.y() + r[3] * x + r[4] * y + r[5] * z,
                middle.z() + r[6] * x + r[7] * y + r[8] * z);
    }

    @Test
    void aRoomWithAHoleIsLitThroughIt() {
        Geometry world = world(List.of(
                new BoxObject(new Point(0, 2.05, -1.01), 4.2, 0.1, 2).withMaterial(WHITE),
                new BoxObject(new Point(0, 2.05, 1.01), 4.2, 0.1, 2).withMaterial(WHITE),
                new BoxObject(new Point(0, -2.05, 0), 4.2, 0.1, 4.2).withMaterial(WHITE)));
        Pose pose = Pose.lookAt(new Point(0, 1.5, 0), new Point(0.001, -2, 0));
        // The slit in the ceiling is 0.02 wide, a third of a pixel, and lights a line from side to side.
        ColorFrame fine = new ColorFrame();
        ColorCamera.of(120, 90, 80)
                .at(pose)
                .withLighting(sun(0, -1, 0, 1))
                .withSamples(16)
                .render(world, fine);
        // The slit runs from below to above in the picture. To both sides of it, beyond 2.01, the floor is no longer
        // below the
        // ceiling.
        long within = 0;
        for (int row = 10; row < 80; row++) {
            for (int column = 25; column < 95; column++) {
                within += fine.pixel(column, row) == 0 ? 0 : 1;
            }
        }
        assertThat(within).isBetween(100L, 240L);
        assertThat(fine.pixel(60, 44) + fine.pixel(60, 45)).isPositive();
    }

    @Test
    void aShadowEndsWhereItShould() {
        Geometry world = world(List.of(
                new BoxObject(new Point(0, -0.5, 0), 20, 1, 20).withMaterial(WHITE),
                new BoxObject(new Point(0, 1, 0), 1, 2, 1).withMaterial(WHITE)));
        // From straight above: a shadow of the box's height to the right, at 45 degrees.
        Pose pose = Pose.lookAt(new Point(0, 100, 0), new Point());
        ColorFrame frame = new ColorFrame();
        ColorCamera.of(400, 400, 2 * Math.toDegrees(StrictMath.atan(0.1)))
                .at(pose)
                .withLighting(sun(1, -1, 0, 1))
                .render(world, frame);
        int dark = 0;
        for (int column = 0; column < 400; column++) {
            double x = (column + 0.5) / 20 - 10;
            boolean isDark = frame.pixel(column, 200) == 0;
            dark += isDark ? 1 : 0;
            if (Math.abs(x) > 0.52 && Math.abs(x - 2.5) > 0.03) {
                assertThat(isDark).as("x %s", x).isEqualTo(x > 0.5 && x < 2.5);
            }
        }
        assertThat(dark).isBetween(38, 42);
    }
}
