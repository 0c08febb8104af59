package robosim.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
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
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;
import robosim.geometry.model.SphereObject;

/** Where angles wrap, where they are huge, and that no answer is ever NaN. */
@Tag("slow")
class WrapTest {
    private static final double NONE = Double.POSITIVE_INFINITY;

    private static BoxObject robot() {
        return new BoxObject(new Point(), 1, 1, 0.5).moveable("robot");
    }

    private static Geometry world(Dimension dimension, GeometryObject... objects) {
        Geometry world = new Geometry(100, 100, 100, dimension, Accuracy.EXACT);
        for (GeometryObject object : objects) {
            assertThat(world.addObjectUnchecked(object)).isTrue();
        }
        return world;
    }

    /** netbots 36, gmapping 25: headings and scans that lose the sector beside 0 or 180 degrees. */
    @ParameterizedTest
    @EnumSource(Dimension.class)
    void aScanSeesTheSameOnBothSidesOfTheSeam(Dimension dimension) {
        GeometryObject[] posts = new GeometryObject[12];
        for (int k = 0; k < posts.length; k++) {
            double angle = StrictMath.toRadians(30 * k);
            Point at = new Point(10 * StrictMath.cos(angle), 0, -10 * StrictMath.sin(angle));
            posts[k] = new CylinderObject(at, 0.5 + 0.1 * k, 1);
        }
        Geometry world = world(dimension, posts);
        assertThat(world.addObjectUnchecked(robot())).isTrue();
        double[] whole = world.scan("robot", 0, 0.25, 1441, 0, NONE);
        assertThat(whole[1440]).as("360 is 0").isEqualTo(whole[0]);
        assertThat(whole).doesNotContain(Double.NaN).contains(NONE);
        for (double first : new double[] {-180, -360, -179.75, 180, 540, -0.0, 360_000}) {
            double[] scan = world.scan("robot", first, 0.25, 1440, 0, NONE);
            for (int k = 0; k < scan.length; k++) {
                int same = Math.floorMod((int) (4 * first) + k, 1440);
                assertThat(scan[k]).as("from " + first + ", ray " + k).isEqualTo(whole[same]);
            }
        }
        // Turned by whole rays, half a turn first: the seam is now behind.
        for (double heading : new double[] {180, -90, 359.75, 0.25}) {
            assertThat(world.placeObject("robot", new Point(), heading)).isTrue();
            double[] scan = world.scan("robot", -heading, 0.25, 1440, 0, NONE);
            for (int k = 0; k < scan.length; k += 360) {
                assertThat(scan[k])
                        .as("heading " + heading)
                        .isCloseTo(whole[k], org.assertj.core.api.Assertions.within(1e-12));
            }
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {360, -360, 720, 3.6e9, -3.6e15, 0x1.68p+80})
    void wholeTurnsChangeNothing(double degrees) {
        for (Dimension dimension : Dimension.values()) {
            for (double heading : new double[] {0, 180, -179.9, 33.3, 1e-17, 90}) {
                Geometry world = world(dimension, robot().turned(0, heading));
                GeometryObject before = world.getObject("robot");
                assertThat(world.simpleTurn("robot", degrees)).isTrue();
                assertThat(world.getObject("robot")).isEqualTo(before);
                assertThat(world.getObject("robot").heading()).isEqualTo(before.heading());
            }
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e9, -1e9, 1e9 + 0.1, 123_456_789_012.3, 1e22, -1e300})
    void hugeAnglesAreReducedExactly(double degrees) {
        BigDecimal exact = new BigDecimal(degrees).remainder(new BigDecimal(360));
        double reduced = Math.IEEEremainder(degrees, 360);
        assertThat(Math.IEEEremainder(exact.doubleValue() - reduced, 360)).isZero();
        for (Dimension dimension : Dimension.values()) {
            Geometry world = world(dimension, robot());
            assertThat(world.placeObject("robot", new Point(), degrees)).isTrue();
            assertThat(world.getObject("robot").heading()).isEqualTo(reduced);
            GeometryObject placed = world.getObject("robot");
            assertThat(world.placeObject("robot", new Point(), 0)).isTrue();
            assertThat(world.simpleTurn("robot", degrees)).isTrue();
            assertThat(world.getObject("robot")).isEqualTo(placed);
            assertThat(world.move("robot", new Move(0, 0, 0, 0, -degrees)).allowed())
                    .isTrue();
            assertThat(world.getObject("robot").heading()).isZero();
        }
    }

    /** A whole turn and more is swept: what stands in the way blocks it, though the end is as free as the start. */
    @ParameterizedTest
    @EnumSource(Dimension.class)
    void moreThanAWholeTurnIsStillSwept(Dimension dimension) {
        BoxObject bar = new BoxObject(new Point(), 4, 1, 0.5).moveable("robot");
        Geometry world = world(dimension, bar, new CylinderObject(new Point(0, 0, 1.5), 0.25, 1));
        for (double degrees : new double[] {180, 360, -360, 3600, 1e9, -1e300}) {
            assertThat(world.simpleTurn("robot", degrees)).as("" + degrees).isFalse();
            assertThat(world.getObject("robot")).isEqualTo(bar);
        }
        assertThat(world.simpleTurn("robot", 45)).isTrue();
    }

    /** JTS on 2^521 and 2^-538: what is too large is refused, what is tiny is as right as what is not. */
    @ParameterizedTest
    @EnumSource(Dimension.class)
    void tinyWorldsAreAsRightAsOthers(Dimension dimension) {
        for (int power : new int[] {0, -40, -300, -450, -538, -900}) {
            double unit = Math.scalb(1.0, power);
            Geometry world = new Geometry(100 * unit, 100 * unit, 100 * unit, dimension, Accuracy.EXACT);
            for (GeometryObject object : scaled(unit)) {
                assertThat(world.addObject(object))
                        .as(object + " at 2^" + power)
                        .isTrue();
            }
            assertThat(world.testObject(new CylinderObject(new Point(12 * unit, 0, 0), unit, 2 * unit)))
                    .isTrue();
            assertThat(world.testObject(new CylinderObject(new Point(12.0625 * unit, 0, 0), unit, 2 * unit)))
                    .isFalse();
            Ray ray = new Ray(new Point(), new Point(1, 0, 0));
            assertThat(world.getRayDistance(ray, 0, NONE, 0, "robot"))
                    .as("ray at 2^" + power)
                    .isEqualTo(9 * unit);
            assertThat(world.getRayDistance(ray, 0, NONE, 30, "robot"))
                    .as("cone at 2^" + power)
                    .isBetween(9 * unit * (1 - 0x1p-40), 9 * unit);
            assertThat(world.getProximity("robot", NONE)).as("2^" + power).isEqualTo(8.5 * unit);
            assertThat(world.simpleMove("robot", 8.5 * unit, 0, 0)).isFalse();
            assertThat(world.simpleMove("robot", 8 * unit, 0, 0)).isTrue();
            assertThat(world.simpleTurn("robot", 90)).isTrue();
        }
        assertThatIllegalArgumentException().isThrownBy(() -> new Point(0x1p521, 0, 0));
        assertThatIllegalArgumentException().isThrownBy(() -> new SphereObject(new Point(), 0x1p521));
    }

    /** Every question about every shape in a tiny world: the answer of the ordinary one, made smaller. */
    @ParameterizedTest
    @EnumSource(Dimension.class)
    void tinyAnswersAreOthersMadeSmaller(Dimension dimension) {
        for (int which = 0; which < shapes(1).size(); which++) {
            double[] ordinary = answers(dimension, which, 1);
            assertThat(ordinary[3]).as("meets").isOne();
            assertThat(ordinary[4]).as("is free").isZero();
            for (int power = -200; power > -1060; power -= 50) {
                double[] tiny = answers(dimension, which, Math.scalb(1.0, power));
                String what = shapes(1).get(which) + " in " + dimension + " at 2^" + power;
                for (int k = 0; k < tiny.length; k++) {
                    double slack = 0x1p-40 * Math.abs(ordinary[k]) + Double.MIN_VALUE / Math.scalb(1.0, power);
                    assertThat(tiny[k]).as(what + ", answer " + k).isBetween(ordinary[k] - slack, ordinary[k] + slack);
                }
            }
        }
    }

    private static List<GeometryObject> shapes(double unit) {
        Point at = new Point(10 * unit, 0, 0);
        List<Point> corners = List.of(
                new Point(9 * unit, -unit, -unit), new Point(9 * unit, unit, -unit), new Point(9 * unit, 0, unit));
        return List.of(
                new SphereObject(at, unit),
                new CylinderObject(at, unit, 2 * unit),
                new CylinderObject(at, unit, 2 * unit).turned(10, 0),
                new BoxObject(at, 2 * unit, 2 * unit, 2 * unit),
                new BoxObject(at, 2 * unit, 2 * unit, 2 * unit).turned(0, 30),
                new BoxObject(at, 2 * unit, 2 * unit, 2 * unit).turned(10, 20),
                new MeshObject(corners, new int[][] {{0, 1, 2}}));
    }

    /** Lengths as multiples of the unit. */
    private static double[] answers(Dimension dimension, int which, double unit) {
        Geometry world = new Geometry(100 * unit, 100 * unit, 100 * unit, dimension, Accuracy.EXACT);
        GeometryObject shape = shapes(unit).get(which);
        assertThat(world.addObject(shape)).isTrue();
        BoxObject box = new BoxObject(new Point(), unit, unit, 0.5 * unit).moveable("robot");
        assertThat(world.addObject(box)).isTrue();
        Ray ray = new Ray(new Point(0, unit / 64, 0), new Point(1, 0, 0));
        double[] answers = {
            world.getRayDistance(ray, 0, NONE, 0, "robot") / unit,
            world.getRayDistance(ray, 0, NONE, 20, "robot") / unit,
            world.getProximity("robot", NONE) / unit,
            world.testObject(new SphereObject(new Point(9 * unit, 0, 0), unit / 2)) ? 1 : 0,
            world.testObject(new SphereObject(new Point(5 * unit, 0, 0), unit)) ? 1 : 0,
            0,
            0
        };
        MoveResult result = world.move("robot", new Move(20 * unit, 0, 0, 0, 0));
        answers[5] = result.fraction();
        answers[6] = result.normal() == null ? 2 : result.normal().x();
        return answers;
    }

    /** A direction from centre to centre whose square underflows has no unit vector. */
    @Test
    void aSpeckInTheMiddleOfSomethingIsMet() {
        for (double offset : new double[] {0, Double.MIN_VALUE, 1e-318, 1e-200, 1e-160, 1e-150, 1e-20}) {
            Point at = new Point(offset, -offset, offset / 3);
            for (GeometryObject speck : List.of(
                    new CylinderObject(at, offset / 2, offset).turned(20, 30),
                    new SphereObject(at, offset / 2),
                    new BoxObject(at, offset, offset, offset).turned(20, 30))) {
                CylinderObject tipped = new CylinderObject(new Point(), 1, 2).turned(40, 10);
                assertThat(world(Dimension.SPATIAL, tipped).testObject(speck))
                        .as("" + speck)
                        .isTrue();
                BoxObject box = robot();
                Geometry world = world(Dimension.SPATIAL, speck, box);
                assertThat(world.getProximity("robot", NONE)).as("" + speck).isZero();
                MoveResult result = world.moveToContact("robot", new Move(0, 0, 0.125, 0, 0), 1);
                assertThat(result.contact() == null || Math.abs(result.contact().x()) < 1)
                        .isTrue();
            }
        }
    }

    private static List<GeometryObject> scaled(double unit) {
        return List.of(
                new BoxObject(new Point(), unit, unit, 0.5 * unit).moveable("robot"),
                new CylinderObject(new Point(10 * unit, 0, 0), unit, 2 * unit),
                new BoxObject(new Point(0, 0, 20 * unit), 2 * unit, 2 * unit, 2 * unit));
    }

    /** openGJK 41: a distance that was NaN; here of round meshes, apart and as near as they get. */
    @ParameterizedTest
    @EnumSource(Dimension.class)
    void theDistanceOfManyCornersIsFinite(Dimension dimension) {
        for (double gap : new double[] {1, 1e-3, 1e-9, 0x1p-52}) {
            MeshObject one = ball().moveable("robot");
            MeshObject other = ball().movedTo(new Point(2 + gap, 0, 0));
            double distance = world(dimension, one, other).getProximity("robot", NONE);
            double exact = other.center().x() - 2; // both reach one unit towards each other
            assertThat(distance).isBetween(exact * (1 - 1e-9) - 0x1p-50, exact * (1 + 1e-9));
        }
    }

    /** 26 corners: of two poles and three rings of eight. */
    private static MeshObject ball() {
        List<Point> corners = new ArrayList<>(List.of(new Point(0, 1, 0), new Point(0, -1, 0)));
        List<int[]> faces = new ArrayList<>();
        for (int ring = 0; ring < 3; ring++) {
            double height = (1 - ring) * Math.sqrt(0.5);
            double radius = Math.sqrt(1 - height * height);
            for (int k = 0; k < 8; k++) {
                double angle = k * Math.PI / 4;
                corners.add(new Point(
                        radius * round(StrictMath.cos(angle)), height, radius * round(StrictMath.sin(angle))));
                int here = 2 + 8 * ring + k;
                int next = 2 + 8 * ring + (k + 1) % 8;
                if (ring == 0) {
                    faces.add(new int[] {0, here, next});
                } else {
                    faces.add(new int[] {here - 8, next - 8, next, here});
                }
                if (ring == 2) {
                    faces.add(new int[] {1, here, next});
                }
            }
        }
        return new MeshObject(corners, faces.toArray(int[][]::new));
    }

    private static double round(double value) {
        return Math.rint(value * 0x1p40) * 0x1p-40;
    }

    /** Calls of every kind with numbers of every kind: an answer is a number, or the call is refused. */
    @Test
    void noAnswerIsNaN() {
        SplittableRandom random = new SplittableRandom(2);
        int answers = 0;
        int echoes = 0;
        int count = Effort.cases(1600);
        for (int k = 0; k < count; k++) {
            Dimension dimension = Dimension.values()[k % 2];
            Geometry world = new Geometry(0x1p90, 0x1p90, 0x1p90, dimension, Accuracy.EXACT);
            double scale = k % 4 < 2 ? 1 : Math.scalb(1.0, random.nextInt(-1060, 80));
            world.addObjectUnchecked(robot().movedTo(point(random, scale)));
            for (int each = 0; each < 3; each++) {
                world.addObjectUnchecked(object(random, scale));
            }
            if (!world.hasObject("robot")) {
                continue;
            }
            answers++;
            double width = k % 3 == 0 ? 0 : random.nextDouble(179.9);
            Ray ray = new Ray(point(random, scale), direction(random));
            double distance = world.getRayDistance(ray, 0, NONE, width);
            echoes += distance < NONE ? 1 : 0;
            assertThat(distance).isBetween(0.0, NONE);
            assertThat(world.getProximity("robot", NONE)).isBetween(0.0, NONE);
            assertThat(world.getSonarDistance("robot", 1, random.nextDouble(), 0, NONE, width))
                    .isBetween(0.0, NONE);
            Point way = point(random, scale);
            Move move = new Move(way.x(), way.y(), way.z(), 0, angle(random));
            double clearance = random.nextDouble() * scale;
            MoveResult moved = world.moveToContact("robot", move, clearance);
            assertThat(moved.fraction()).isBetween(0.0, 1.0);
            assertThat(moved.turnFraction()).isBetween(0.0, 1.0);
            Point centre = world.getObject("robot").center();
            assertThat(centre.x() + centre.y() + centre.z()).isNotNaN();
            assertThat(world.getObject("robot").heading()).isBetween(-180.0, 180.0);
        }
        assertThat(answers).isGreaterThan(count * 3 / 4);
        assertThat(echoes).isBetween(answers / 10, answers * 9 / 10);
    }

    private static GeometryObject object(SplittableRandom random, double scale) {
        Point at = point(random, scale);
        double size = random.nextInt(5) == 0 ? 0 : random.nextDouble() * scale;
        return switch (random.nextInt(4)) {
            case 0 -> new SphereObject(at, size);
            case 1 -> new CylinderObject(at, size, random.nextDouble() * scale).turned(angle(random), 0);
            case 2 -> new BoxObject(at, size, random.nextDouble() * scale, 0).turned(0, angle(random));
            default -> new MeshObject(List.of(at, point(random, scale), point(random, scale)), new int[][] {{0, 1, 2}});
        };
    }

    private static double angle(SplittableRandom random) {
        return switch (random.nextInt(4)) {
            case 0 -> 90 * random.nextInt(-4, 5);
            case 1 -> random.nextDouble(-1e9, 1e9);
            case 2 -> random.nextDouble(-1e-9, 1e-9);
            default -> random.nextDouble(-180, 180);
        };
    }

    private static Point point(SplittableRandom random, double scale) {
        return new Point(coordinate(random) * scale, coordinate(random) * scale, coordinate(random) * scale);
    }

    private static double coordinate(SplittableRandom random) {
        return random.nextInt(3) == 0 ? random.nextInt(-2, 3) : random.nextDouble(-3, 3);
    }

    private static Point direction(SplittableRandom random) {
        double length = Math.scalb(1.0, random.nextInt(-1000, 99));
        double x = coordinate(random) * length;
        return new Point(x == 0 ? length : x, coordinate(random) * length, coordinate(random) * length);
    }
}
