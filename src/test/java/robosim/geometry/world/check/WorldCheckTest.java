package robosim.geometry.world.check;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import robosim.geometry.Geometry;
import robosim.geometry.MoveResult;
import robosim.geometry.WorkLimit;
import robosim.geometry.collision.ContactQuery;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;
import robosim.geometry.world.Skipped;
import robosim.geometry.world.Unit;
import robosim.geometry.world.World;
import robosim.geometry.world.WorldImport;
import robosim.geometry.world.WorldObject;
import robosim.geometry.world.WorldReader;

@Tag("slow")
class WorldCheckTest {
    private static World world(Dimension dimension, GeometryObject... objects) {
        List<WorldObject> all = new ArrayList<>();
        for (GeometryObject object : objects) {
            all.add(new WorldObject(object));
        }
        return new World(20, 4, 20.25, null, dimension, Accuracy.EXACT, all);
    }

    private static GeometryObject wall(double x, double z, double width, double length) {
        return new BoxObject(new Point(x, 0, z), width, 2, length);
    }

    private static GeometryObject drum(String name, double x, double z, double radius) {
        return new CylinderObject(new Point(x, 0, z), radius, 1).moveable(name);
    }

    /** Two rooms with a wall between them at x = 0 that has a door of that width at z = 3.3. */
    private static List<GeometryObject> rooms(double door) {
        double middle = 3.3;
        double north = 10 + middle - door / 2;
        double south = 10 - middle - door / 2;
        return new ArrayList<>(List.of(wall(0, -10 + north / 2, 0.2, north), wall(0, 10 - south / 2, 0.2, south)));
    }

    private static WorldCheck check(double door, GeometryObject... robots) {
        List<GeometryObject> objects = rooms(door);
        objects.addAll(List.of(robots));
        return WorldCheck.of(world(Dimension.PLANAR, objects.toArray(GeometryObject[]::new)));
    }

    @Test
    void aWorldThatIsFineSaysSo() {
        WorldCheck check = check(2, drum("a", -5, 0, 0.5), drum("b", 5, 0, 0.5));
        assertThat(check.isFine()).isTrue();
        assertThat(check.rooms()).singleElement().satisfies(room -> {
            assertThat(room.robots()).containsExactly("a", "b");
            // All of the floor that the centre of a disc of radius 0.5 may be on: 2 * 8.9 * 19, and the door.
            assertThat(room.area()).isBetween(0.9 * 2 * 8.9 * 19, 1.1 * 2 * 8.9 * 19);
            assertThat(room.minX()).isBetween(-10.0, -9.4);
            assertThat(room.maxZ()).isBetween(9.4, 10.0);
        });
    }

    @Test
    void whoCannotPassADoorIsShutIn() {
        WorldCheck check = check(0.9, drum("a", -5, 0, 0.5), drum("b", 5, 0, 0.5), drum("c", 5, 5, 0.5));
        assertThat(check.isFine()).isFalse();
        assertThat(check.rooms()).extracting(Room::robots).containsExactly(List.of("b", "c"), List.of("a"));
        Room shut = check.shutIn().get(0);
        assertThat(shut.minX()).isBetween(-10.0, -9.7);
        assertThat(shut.maxX()).isBetween(-0.125, 0.25); // it reaches into the door
        assertThat(shut.area()).isCloseTo(8.9 * 19, within(8.9));
        assertThat(shut.step()).isEqualTo(0.125);
    }

    @Test
    void aNarrowDoorIsFoundByAFinerStep() {
        // The centre of a disc has a way of 0.2 through the door. The first grid, of 0.5 from z = 0, passes it by.
        WorldCheck check = check(1.2, drum("a", -5, 0, 0.5), drum("b", 5, 0, 0.5));
        assertThat(check.shutIn()).isEmpty();
        assertThat(check.rooms().get(0).step()).isLessThan(0.5);
    }

    @Test
    void theNarrowRobotMakesTheRoomOneForTheWideOne() {
        WorldCheck check = check(1, drum("wide", -5, 0, 0.8), drum("narrow", 5, 0, 0.2));
        assertThat(check.shutIn()).isEmpty();
        assertThat(check(1, drum("wide", -5, 0, 0.8), drum("as wide", 5, 0, 0.8))
                        .shutIn())
                .hasSize(1);
    }

    @Test
    void aLongRobotTurnsToPass() {
        // 3 long and 0.6 wide, across the door at first: it passes only along X, at a heading of 0.
        GeometryObject cart =
                new BoxObject(new Point(-5, 0, 0), 3, 1, 0.6).turned(0, 90).moveable("cart");
        assertThat(check(1, cart, drum("a", 5, 0, 0.2)).shutIn()).isEmpty();
        assertThat(check(0.5, cart, drum("a", 5, 0, 0.3)).shutIn()).hasSize(1);
        GeometryObject crooked =
                new BoxObject(new Point(-5, 0, 0), 3, 1, 0.6).turned(0, 31).moveable("cart");
        assertThat(check(1, crooked, drum("a", 5, 0, 0.4)).shutIn()).isEmpty();
    }

    @Test
    void aThinWallIsNoMeeting() {
        // As near as can be, and a sheet between them.
        WorldCheck check = WorldCheck.of(world(
                Dimension.SPATIAL,
                new BoxObject(new Point(), 0.001, 4, 20.25),
                drum("a", -0.6, 0, 0.5),
                drum("b", 0.6, 0, 0.5)));
        assertThat(check.shutIn()).hasSize(1);
        // In space a robot is met over what is lower.
        WorldCheck over = WorldCheck.of(world(
                Dimension.SPATIAL,
                new BoxObject(new Point(0, -1.9, 0), 0.001, 0.1, 20),
                drum("a", -0.6, 0, 0.5),
                drum("b", 0.6, 0, 0.5)));
        assertThat(over.shutIn()).isEmpty();
    }

    private static WorldCheck large(Dimension dimension, double side, GeometryObject... objects) {
        List<WorldObject> all = new ArrayList<>();
        for (GeometryObject object : objects) {
            all.add(new WorldObject(object));
        }
        return WorldCheck.of(new World(side, 6, side, null, dimension, Accuracy.EXACT, all));
    }

    private static GeometryObject crate(String name, double x, double y, double z, double side) {
        return new BoxObject(new Point(x, y, z), side, 1, side).moveable(name);
    }

    /** What lies between the two centres is free, and no room for the bodies. */
    @Test
    void aSlitIsNoWayAndAKerbBelowTheCentresIsNone() {
        WorldCheck slit = large(
                Dimension.PLANAR,
                20,
                new BoxObject(new Point(0, 0, -5.01), 0.2, 6, 9.98),
                new BoxObject(new Point(0, 0, 5.01), 0.2, 6, 9.98),
                crate("a", -0.9, 0, 0, 0.9),
                crate("b", 0.9, 0, 0, 0.9));
        assertThat(slit.shutIn()).hasSize(1);
        WorldCheck kerb = large(
                Dimension.SPATIAL,
                20,
                new BoxObject(new Point(0, -2.9, 0), 0.2, 0.2, 20),
                crate("a", -0.9, -2.5, 0, 0.9),
                crate("b", 0.9, -2.5, 0, 0.9));
        assertThat(kerb.shutIn()).hasSize(1);
        WorldCheck free = large(
                Dimension.SPATIAL,
                20,
                new BoxObject(new Point(0, -2.9, 0), 0.2, 0.2, 20),
                crate("a", -0.9, -2.2, 0, 0.9),
                crate("b", 0.9, -2.2, 0, 0.9));
        assertThat(free.rooms()).hasSize(1);
    }

    @Test
    void whoIsHigherMeetsByGoingDown() {
        GeometryObject drone = crate("drone", -3, 1.5, 0, 0.5);
        GeometryObject cart = crate("cart", 3, -1.5, 0, 0.5);
        assertThat(large(Dimension.SPATIAL, 20, drone, cart).rooms()).hasSize(1);
        // Two floors with a hole that is too narrow, through which each sees the other.
        WorldCheck floors = large(
                Dimension.SPATIAL,
                20,
                new BoxObject(new Point(-5.02, 0, 0), 9.96, 0.1, 20),
                new BoxObject(new Point(5.02, 0, 0), 9.96, 0.1, 20),
                crate("drone", 0, 1.5, 0, 0.5),
                crate("cart", 0, -1.5, 0, 0.5));
        assertThat(floors.shutIn()).hasSize(1);
    }

    /** 200 m, a door of 1.5 m, and robots of 0.4 m: the step that can be afforded is 2.3 m. */
    @Test
    void whatTooCoarseAStepDoesNotReachIsNoFinding() {
        WorldCheck check = large(
                Dimension.PLANAR,
                200,
                new BoxObject(new Point(0, 0, -49.5), 0.2, 6, 101),
                new BoxObject(new Point(0, 0, 51.25), 0.2, 6, 97.5),
                crate("a", -50, 0, 0.2, 0.4),
                crate("b", 50, 0, 0.2, 0.4));
        assertThat(check.isFine()).isTrue();
        assertThat(check.shutIn()).isEmpty();
        assertThat(check.untold()).singleElement().satisfies(room -> {
            assertThat(room.isTold()).isFalse();
            assertThat(room.step()).isGreaterThan(2);
        });
    }

    /** No step is as fine as what has no extent; a wall without a door is told all the same. */
    @Test
    void aPointIsShutInByAWall() {
        WorldCheck check = large(
                Dimension.PLANAR, 20, new BoxObject(new Point(), 0.2, 6, 20), drum("a", -5, 0, 0), drum("b", 5, 0, 0));
        assertThat(check.shutIn()).hasSize(1);
        assertThat(check.untold()).isEmpty();
    }

    @Test
    void aCellInALargeWorldIsFoundByAFinerStepNearTheStart() {
        List<GeometryObject> objects = new ArrayList<>(List.of(
                new BoxObject(new Point(-2, 0, 0), 0.2, 6, 4),
                new BoxObject(new Point(2, 0, 0), 0.2, 6, 4),
                new BoxObject(new Point(0, 0, -2), 4, 6, 0.2),
                new BoxObject(new Point(0, 0, 2), 4, 6, 0.2),
                crate("a", 0, 0, 0, 0.4)));
        // Alone it gets about, in steps finer than the cell.
        WorldCheck alone = large(Dimension.PLANAR, 200, objects.toArray(GeometryObject[]::new));
        assertThat(alone.isFine()).isTrue();
        assertThat(alone.rooms()).singleElement().satisfies(room -> {
            assertThat(room.isTold()).isTrue();
            assertThat(room.area()).isBetween(9.0, 14.0);
        });
        objects.add(crate("b", 50, 0, 0, 0.4));
        objects.add(crate("c", 60, 0, 0, 0.4));
        WorldCheck check = large(Dimension.PLANAR, 200, objects.toArray(GeometryObject[]::new));
        assertThat(check.shutIn()).extracting(Room::robots).containsExactly(List.of("a"));
        assertThat(check.isFine()).isFalse();
    }

    @Test
    void whereNobodyHasRoomNothingIsRecommended() {
        // It is in the floor, deeper than what stands on it.
        WorldCheck check = large(
                Dimension.SPATIAL,
                20,
                new BoxObject(new Point(0, -1.0625, 0), 20, 0.125, 20),
                new BoxObject(new Point(3, -0.5, 0), 0.25, 1, 10).turned(0, 30),
                new BoxObject(new Point(0, -0.76, 0), 0.5, 0.5, 0.5).moveable("robot"));
        assertThat(check.needs().isTold()).isFalse();
        assertThat(check.needs().dimension()).isEqualTo(Dimension.SPATIAL);
        assertThat(check.needs().accuracy()).isEqualTo(Accuracy.EXACT);
        assertThat(check.needs().settings()).noneMatch(SettingComparison::isSame);
    }

    /** Without a robot a stand-in is asked, on the floor and not in the air, and it meets what is there. */
    @Test
    void aStandInIsAskedWhereThereIsNoRobot() {
        // A room of 10 x 8 with a floor of its own at -0.5, walls, a table and a roof, in a world of 30 x 30 x 12.
        List<GeometryObject> objects = List.of(
                new BoxObject(new Point(0, -0.55, 0), 10, 0.1, 8),
                new BoxObject(new Point(0, 2.55, 0), 10, 0.1, 8),
                new BoxObject(new Point(0, 1, 4), 10, 3, 0.2),
                new BoxObject(new Point(0, 1, -4), 10, 3, 0.2),
                new BoxObject(new Point(5, 1, 0), 0.2, 3, 8),
                new BoxObject(new Point(-5, 1, 0), 0.2, 3, 8),
                new BoxObject(new Point(1, 0.3, 1), 1, 1.6, 2).turned(0, 30));
        List<WorldObject> all = objects.stream().map(WorldObject::new).toList();
        WorldCheck check = WorldCheck.of(new World(30, 12, 30, Unit.METRE, Dimension.SPATIAL, Accuracy.EXACT, all));
        assertThat(check.robots()).isEmpty();
        SubstituteRobot standIn = check.needs().standIn();
        assertThat(standIn).isNotNull();
        assertThat(standIn.floor()).isEqualTo(-0.5);
        assertThat(standIn.body().radius()).isEqualTo(0.2);
        assertThat(standIn.body().center().y()).isBetween(-0.3, -0.25);
        assertThat(check.needs().isTold()).isTrue();
        assertThat(check.needs().met()).isGreaterThanOrEqualTo(SettingComparison.MIN_ANSWERS);
        assertThat(check.needs().accuracy()).isNotIn(Accuracy.SPHERE, Accuracy.AABB);
        // The roof covers all in the plane.
        assertThat(check.needs().dimension()).isEqualTo(Dimension.SPATIAL);
        assertThat(SubstituteRobot.floorOf(check.world())).isEqualTo(-0.5);
    }

    /** Where nothing is met all settings answer alike, and none was tried. */
    @Test
    void whereNothingIsMetNothingIsRecommended() {
        WorldCheck check = large(Dimension.SPATIAL, 1e6, crate("robot", 0, 0, 0, 0.5));
        assertThat(check.needs().met()).isZero();
        assertThat(check.needs().setting(Dimension.SPATIAL, Accuracy.SPHERE).moves())
                .isGreaterThan(500);
        assertThat(check.needs().isTold()).isFalse();
        assertThat(check.needs().accuracy()).isEqualTo(Accuracy.EXACT);
    }

    @Test
    void inATightAisleItsOwnPlacesAreAsked() {
        WorldCheck check = large(
                Dimension.PLANAR,
                100,
                new BoxObject(new Point(-25.5, 0, 0), 48.9, 6, 100),
                new BoxObject(new Point(25.5, 0, 0), 48.9, 6, 100),
                crate("robot", 0, 0, 0, 2));
        assertThat(check.needs().isTold()).isTrue();
        SettingComparison sphere = check.needs().setting(Dimension.PLANAR, Accuracy.SPHERE);
        assertThat(sphere.moves()).isGreaterThanOrEqualTo(SettingComparison.MIN_ANSWERS);
        assertThat(check.needs().setting(Dimension.PLANAR, Accuracy.EXACT).moves())
                .isGreaterThan(500);
        assertThat(check.needs().accuracy()).isNotEqualTo(Accuracy.SPHERE);
    }

    @Test
    void whoCannotMakeAStepIsTold() {
        List<GeometryObject> cell = List.of(
                wall(-1.01, 0, 1, 3),
                wall(1.01, 0, 1, 3),
                wall(0, -1.01, 1, 1),
                wall(0, 1.01, 1, 1),
                drum("a", 0, 0, 0.5));
        WorldCheck check = WorldCheck.of(world(Dimension.PLANAR, cell.toArray(GeometryObject[]::new)));
        assertThat(check.isFine()).isFalse();
        assertThat(check.rooms()).singleElement().extracting(Room::places).isEqualTo(1);
    }

    @Test
    void contactsComeWithAPointAndADepth() {
        WorldCheck check = WorldCheck.of(world(
                Dimension.SPATIAL,
                wall(0, 0, 2, 2),
                drum("deep", 1.3, 0, 0.5),
                drum("touching", 0, 1.5, 0.5),
                drum("free", 5, 5, 0.5),
                new SphereObject(new Point(-9.9, 0, 0), 0.5).named("outside"),
                wall(8, 8, 1, 1),
                wall(8.5, 8, 1, 1)));
        assertThat(check.outside()).extracting(o -> o.object().name()).containsExactly("outside");
        assertThat(check.startingContacts())
                .extracting(o -> o.first().object().name())
                .containsExactly("deep", "touching");
        Overlap deep = check.startingContacts().get(0);
        assertThat(deep.depth()).isBetween(0.2, 0.2 * 1.01);
        assertThat(deep.normal().x()).isEqualTo(1);
        assertThat(deep.contact().x()).isBetween(0.8, 1.0);
        assertThat(check.startingContacts().get(1).depth()).isZero();
        assertThat(check.staticOverlaps()).isEqualTo(1);
        assertThat(check.overlaps()).hasSize(3);
        // Who starts in contact is not asked for its ways.
        assertThat(check.rooms())
                .singleElement()
                .satisfies(room -> assertThat(room.robots()).containsExactly("free"));
        assertThat(check.isFine()).isFalse();
    }

    /** The same wall with a door, as boxes and as cells of a quarter. */
    @Test
    void aGridIsCheckedAsItsCellsAreAsBoxes() {
        BitSet cells = new BitSet();
        for (int row = 0; row < 80; row++) {
            cells.set(row, row < 48 || row > 55);
        }
        GridObject grid = new GridObject(new Point(0, 0, 0), 0.25, 2, 1, 80, cells).named("map");
        List<GeometryObject> boxes = new ArrayList<>();
        cells.stream().mapToObj(cell -> grid.box(0, cell)).forEach(boxes::add);
        List<GeometryObject> robots =
                List.of(drum("a", -5, 0, 0.5), drum("b", 5, 0, 0.5), drum("in the wall", 0.25, -3, 0.25));
        List<GeometryObject> one = new ArrayList<>(robots);
        one.add(grid);
        List<GeometryObject> many = new ArrayList<>(robots);
        many.addAll(boxes);
        WorldCheck ofGrid = WorldCheck.of(world(Dimension.SPATIAL, one.toArray(GeometryObject[]::new)));
        WorldCheck ofBoxes = WorldCheck.of(world(Dimension.SPATIAL, many.toArray(GeometryObject[]::new)));
        assertThat(ofGrid.rooms()).isEqualTo(ofBoxes.rooms());
        assertThat(ofGrid.shutIn()).isEmpty();
        assertThat(ofGrid.staticOverlaps()).isZero();
        assertThat(ofGrid.startingContacts()).singleElement().satisfies(overlap -> {
            assertThat(overlap.first().object().name()).isEqualTo("in the wall");
            assertThat(overlap.second().object()).isEqualTo(grid);
            assertThat(overlap.depth()).isGreaterThan(0.1);
        });
        RecommendedSetting needs = ofGrid.needs();
        assertThat(needs.isProven()).isEqualTo(ofBoxes.needs().isProven()).isTrue();
        // Places near objects are drawn by object, and so differ; what is met does not, but for chance.
        assertThat(needs.met())
                .isBetween(ofBoxes.needs().met() * 9 / 10, ofBoxes.needs().met() * 11 / 10);
        assertThat(needs.met()).isGreaterThan(100);
    }

    /** All pairs, found by asking every one. */
    @ParameterizedTest
    @CsvSource({"PLANAR, 1", "PLANAR, 2", "SPATIAL, 3", "SPATIAL, 4"})
    void noContactIsMissed(Dimension dimension, long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        GeometryObject[] objects = new GeometryObject[60];
        for (int k = 0; k < objects.length; k++) {
            Point at = new Point(random.nextDouble(-8, 8), random.nextDouble(-1, 1), random.nextDouble(-8, 8));
            double size = random.nextDouble(0.1, 4);
            GeometryObject shape = switch (random.nextInt(3)) {
                case 0 -> new BoxObject(at, size, 0.5, 1).turned(0, random.nextDouble(360));
                case 1 -> new CylinderObject(at, size / 2, 1).turned(random.nextInt(2) * 30.0, 10);
                default -> new SphereObject(at, size / 2);
            };
            objects[k] = k % 6 == 0 ? shape.moveable("r" + k) : shape.named("s" + k);
        }
        Set<Set<String>> truth = new HashSet<>();
        for (int a = 0; a < objects.length; a++) {
            for (int b = 0; b < a; b++) {
                if (!ContactQuery.contacts(objects[a], objects[b], dimension, 1).isEmpty()) {
                    truth.add(Set.of(String.valueOf(objects[a].name()), String.valueOf(objects[b].name())));
                }
            }
        }
        Overlaps overlaps = new Overlaps(
                world(dimension, objects),
                (work, done, total) -> {},
                WorkLimit.none().meter("a check"));
        Set<Set<String>> found = new HashSet<>();
        for (Overlap overlap : overlaps.found()) {
            GeometryObject first = overlap.first().object();
            GeometryObject second = overlap.second().object();
            found.add(Set.of(String.valueOf(first.name()), String.valueOf(second.name())));
            // The depth is a way out.
            if (overlap.depth() > 0 && Double.isFinite(overlap.depth())) {
                Point c = first.center();
                Point n = overlap.normal();
                double way = overlap.depth();
                GeometryObject out =
                        first.movedTo(new Point(c.x() + way * n.x(), c.y() + way * n.y(), c.z() + way * n.z()));
                assertThat(ContactQuery.contacts(out, second, dimension, 1)).isEmpty();
            }
        }
        assertThat(found).isEqualTo(truth);
        assertThat(found.size()).isBetween(20, 400);
        assertThat(overlaps.staticCount()).isEqualTo((int)
                overlaps.found().stream().filter(o -> !o.isStart()).count());
    }

    /** Of static objects in one place, whose pairs grow with the square of their number, so many are counted and no more. */
    @Test
    void ofManyStaticObjectsInOnePlaceNotAllPairsAreCounted() {
        GeometryObject[] objects = new GeometryObject[20_002];
        objects[0] = new CylinderObject(new Point(6, 0, 6), 0.3, 1).moveable("first");
        for (int k = 1; k <= 20_000; k++) {
            objects[k] = new BoxObject(new Point(k * 1e-6, 0, 0), 1, 1, 1);
        }
        objects[20_001] = new CylinderObject(new Point(6, 0, 6.5), 0.3, 1).moveable("second");
        Overlaps overlaps = new Overlaps(
                world(Dimension.PLANAR, objects),
                (work, done, total) -> {},
                WorkLimit.none().meter("a check"));
        assertThat(overlaps.staticCount()).isEqualTo(WorldCheck.MOST_COUNTED);
        assertThat(overlaps.found()).hasSize(WorldCheck.MAX_STATIC_OVERLAPS + 1);
        assertThat(overlaps.found().stream().filter(Overlap::isStart)).hasSize(1);
        assertThat(overlaps.pile()).isNotNull().extracting(Pile::objects).isEqualTo(20_000);
    }

    /** Of robots in one place all are found to be in contact, by far fewer comparisons than there are pairs. */
    @ParameterizedTest
    @CsvSource({"0, 1", "1000, 1", "1000, 2"})
    void manyRobotsInOnePlaceAreComparedWithFewOfThem(int fixed, int each) {
        int count = 2000;
        GeometryObject[] objects = new GeometryObject[fixed + count];
        for (int k = 0; k < objects.length; k++) {
            BoxObject box = new BoxObject(new Point(k * 1e-6, 0, 0), 1, 1, 1);
            objects[k] = k % each == 0 && k / each < fixed ? box : box.moveable("robot " + k);
        }
        Overlaps overlaps = new Overlaps(
                world(Dimension.PLANAR, objects),
                (work, done, total) -> {},
                WorkLimit.none().meter("check"));
        Set<GeometryObject> touching = new HashSet<>();
        for (Overlap overlap : overlaps.found()) {
            touching.add(overlap.first().object());
            touching.add(overlap.second().object());
        }
        for (GeometryObject object : objects) {
            assertThat(!object.isMoveable() || touching.contains(object))
                    .as("%s", object.name())
                    .isTrue();
        }
        // There are 2 million pairs of 2,000 robots.
        assertThat(overlaps.compared()).isBetween((long) count, 200_000L);
        assertThat(overlaps.found()).hasSizeLessThan(5000);
        assertThat(overlaps.pile()).isNotNull().extracting(Pile::objects).isEqualTo(objects.length);
    }

    /** A robot that is found in many contacts hides none of those of others. */
    @Test
    void whoTouchesOnlyAFullRobotIsFoundToo() {
        GeometryObject[] objects = new GeometryObject[302];
        objects[0] = new BoxObject(new Point(0, 0, 0), 8, 1, 8).moveable("large");
        for (int k = 1; k <= 300; k++) {
            double x = -3.8 + k % 20 * 0.4;
            double z = -3.8 + k / 20 * 0.4;
            GeometryObject small = new BoxObject(new Point(x, 0, z), 0.1, 1, 0.1);
            objects[k] = k % 2 == 0 ? small : small.moveable("small " + k);
        }
        objects[301] = new BoxObject(new Point(4.5, 0, 0), 1, 1, 1).moveable("last");
        WorldCheck check = WorldCheck.of(world(Dimension.PLANAR, objects));
        Set<String> touching = new HashSet<>();
        for (Overlap overlap : check.startingContacts()) {
            touching.add(String.valueOf(overlap.first().object().name()));
            touching.add(String.valueOf(overlap.second().object().name()));
        }
        assertThat(touching).contains("large", "last", "small 1", "small 299");
        assertThat(touching.stream().filter(name -> name.startsWith("small"))).hasSize(150);
        assertThat(check.rooms()).isEmpty();
        assertThat(check.pile()).isNotNull();
    }

    /** A move that is refused is not compared with each of many objects as often as there are objects. */
    @Test
    void theQuestionsOfAPileTakeWorkInProportionToIt() {
        assertThat(refusedMove(8000)).isLessThan(10 * refusedMove(1000));
    }

    private static long refusedMove(int count) {
        Geometry geometry = new Geometry(20, 4, 20);
        geometry.limitWork(WorkLimit.none());
        for (int k = 0; k < count; k++) {
            geometry.addObjectUnchecked(new BoxObject(new Point(), 1, 1, 1).named("box " + k));
        }
        geometry.addObjectUnchecked(drum("robot", -3, 0, 0.3));
        MoveResult result = geometry.move("robot", new Move(5, 0, 0, 0, 0));
        assertThat(result.allowed()).isFalse();
        assertThat(result.obstacle())
                .isNotNull()
                .extracting(GeometryObject::name)
                .isEqualTo("box 0");
        assertThat(geometry.workDone()).isGreaterThan(count);
        return geometry.workDone();
    }

    @Test
    void planarIsProvenWhereAllReachTheRobotsHeight() {
        WorldCheck check = WorldCheck.of(world(Dimension.SPATIAL, wall(3, 0, 1, 8), drum("a", 0, 0, 0.5)));
        assertThat(check.needs().isProven()).isTrue();
        assertThat(check.needs().dimension()).isEqualTo(Dimension.PLANAR);
        assertThat(check.needs().setting(Dimension.PLANAR, Accuracy.EXACT).isSame())
                .isTrue();
        assertThat(check.needs().setting(Dimension.SPATIAL, Accuracy.EXACT).isSame())
                .isTrue();
    }

    @Test
    void heightsMatterUnderATable() {
        GeometryObject table = new BoxObject(new Point(3, 1.5, 0), 6, 0.2, 8);
        WorldCheck check = WorldCheck.of(world(Dimension.SPATIAL, table, drum("a", -5, 0, 0.5)));
        assertThat(check.needs().isProven()).isFalse();
        assertThat(check.needs().dimension()).isEqualTo(Dimension.SPATIAL);
        SettingComparison planar = check.needs().setting(Dimension.PLANAR, Accuracy.EXACT);
        assertThat(planar.placesOtherwise()).isBetween(planar.places() / 10, planar.places() / 2);
        assertThat(planar.distancesOtherwise()).isPositive();
        assertThat(planar.shortest()).isPositive();
    }

    @Test
    void boxesThatStandSquareNeedNoMoreThanTheirBoxes() {
        // A ball's box is larger than the ball, but a robot that does not turn and is a box is its own.
        GeometryObject robot = new CylinderObject(new Point(), 0, 1).moveable("point");
        WorldCheck check = WorldCheck.of(world(Dimension.PLANAR, wall(3, 0, 1, 8), wall(-3, 2, 4, 1), robot));
        assertThat(check.needs().accuracy()).isEqualTo(Accuracy.AABB);
        assertThat(check.needs().setting(Dimension.PLANAR, Accuracy.SPHERE).isSame())
                .isFalse();
        GeometryObject crooked = new BoxObject(new Point(3, 0, 0), 1, 2, 8).turned(0, 30);
        assertThat(WorldCheck.of(world(Dimension.PLANAR, crooked, robot))
                        .needs()
                        .accuracy())
                .isEqualTo(Accuracy.OBB);
    }

    @Test
    void anEmptyWorldIsAskedNothing() {
        WorldCheck check = WorldCheck.of(world(Dimension.SPATIAL));
        assertThat(check.needs().standIn()).isNull();
        assertThat(check.needs().isTold()).isFalse();
        assertThat(check.needs().dimension()).isEqualTo(Dimension.SPATIAL);
        assertThat(check.needs().accuracy()).isEqualTo(Accuracy.EXACT);
        assertThat(check.needs().setting(Dimension.PLANAR, Accuracy.SPHERE).distances())
                .isZero();
        assertThat(check.rooms()).isEmpty();
        assertThat(check.isFine()).isTrue();
        assertThat(WorldCheck.of(world(Dimension.SPATIAL)).isFine()).isTrue();
        assertThatThrownBy(() -> new RecommendedSetting(Dimension.PLANAR, Accuracy.EXACT, false, 0, 1, List.of(), null)
                        .setting(Dimension.PLANAR, Accuracy.EXACT))
                .isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    void theSameWorldHasTheSameCheck() throws IOException {
        World rooms = WorldReader.read(Path.of("worlds/rooms.xml"));
        WorldCheck check = WorldCheck.of(rooms);
        assertThat(WorldCheck.of(rooms)).isEqualTo(check);
        assertThat(check.isFine()).isTrue();
        assertThat(check.rooms())
                .singleElement()
                .satisfies(room -> assertThat(room.robots()).hasSize(8));
        assertThat(check.needs().setting(Dimension.PLANAR, Accuracy.EXACT).isSame())
                .isTrue();
        assertThat(check.staticOverlaps()).isEqualTo(29);
    }

    /** Whenever it stops asking: all that is coarser than the recommendation was seen to answer otherwise. */
    @ParameterizedTest
    @CsvSource({"rooms.xml", "cylinders.xml", "studio.xml", "pushing.xml", "maze.xml"})
    void moreQuestionsWouldRecommendTheSame(String file) throws IOException {
        RecommendedSetting needs =
                WorldCheck.of(WorldReader.read(Path.of("worlds", file))).needs();
        assertThat(needs.isTold()).isTrue();
        SettingComparison enough = needs.setting(needs.dimension(), needs.accuracy());
        assertThat(enough.isSame()).isTrue();
        assertThat(needs.settings().subList(0, needs.settings().indexOf(enough)))
                .isNotEmpty()
                .allMatch(SettingComparison::isRefuted);
    }

    /**
     * A ring 2.2 m wide: the first step, of 1.5 m, ends at the first bend. The centre of a disc of radius 0.3 has a band of
     * 1.6 m around a circle of 30 m, which is 302 m^2.
     */
    @Test
    void aRingCorridorIsReachedAllRound() {
        int count = 320;
        double cell = 0.25;
        BitSet taken = new BitSet();
        for (int i = 0; i < count; i++) {
            for (int j = 0; j < count; j++) {
                double r = Math.hypot((i + 0.5) * cell - 40, (j + 0.5) * cell - 40);
                taken.set(j * count + i, Math.abs(r - 30) > 1.1);
            }
        }
        GridObject ring = new GridObject(new Point(), cell, 2, count, count, taken);
        WorldCheck check = large(Dimension.PLANAR, 80.2, ring, drum("a", 30, 0, 0.3));
        assertThat(check.rooms()).singleElement().satisfies(room -> {
            assertThat(room.step()).isEqualTo(0.3);
            assertThat(room.isTold()).isTrue();
            // The corners of the cells take some of the band.
            assertThat(room.area()).isBetween(0.8 * 302, 302.0);
            assertThat(room.most()).isBetween(0.85 * 302, 310.0).isGreaterThanOrEqualTo(room.area());
            assertThat(room.minX()).isLessThan(-29);
        });
    }

    /** A race track of 2.2 m with bends of many widths, as the cells of a map; what is reachable is known from its middle line. */
    @Test
    void theBoundsOfARaceTrackHoldWhatIsReachable() {
        int count = 640;
        double cell = 0.125;
        double[] least = new double[count * count];
        Arrays.fill(least, Double.POSITIVE_INFINITY);
        for (int k = 0; k < 20_000; k++) {
            double angle = 2 * Math.PI * k / 20_000;
            double r = 28 + 5 * Math.sin(3 * angle) + 3 * Math.sin(7 * angle);
            double x = r * Math.cos(angle);
            double z = r * Math.sin(angle);
            for (int j = (int) ((z + 38.5) / cell); j < (z + 41.5) / cell; j++) {
                for (int i = (int) ((x + 38.5) / cell); i < (x + 41.5) / cell; i++) {
                    double d = Math.hypot((i + 0.5) * cell - 40 - x, (j + 0.5) * cell - 40 - z);
                    least[j * count + i] = Math.min(least[j * count + i], d);
                }
            }
        }
        BitSet taken = new BitSet();
        int inside = 0;
        int outside = 0;
        for (int k = 0; k < least.length; k++) {
            taken.set(k, least[k] > 1.1);
            // A cell's middle is within 0.09 of all of it.
            inside += least[k] < 1.1 - 0.3 - 2 * 0.09 ? 1 : 0;
            outside += least[k] < 1.1 - 0.3 + 0.09 ? 1 : 0;
        }
        double lower = inside * cell * cell;
        double upper = outside * cell * cell;
        assertThat(lower).isGreaterThan(250);
        GridObject track = new GridObject(new Point(), cell, 2, count, count, taken);
        WorldCheck check = large(Dimension.PLANAR, 80.2, track, drum("a", 28, 0, 0.3));
        assertThat(check.rooms()).singleElement().satisfies(room -> {
            assertThat(room.isTold()).isTrue();
            assertThat(room.area()).isBetween(0.8 * lower, upper);
            assertThat(room.most()).isBetween(lower, 1.1 * upper).isGreaterThanOrEqualTo(room.area());
        });
    }

    /** In a square room of side s, the centre of a disc of radius r reaches (s - 2 r)^2, and that of a box no more than its disc. */
    @Test
    void whatIsReachableIsWithinTheUpperBound() {
        SplittableRandom random = new SplittableRandom(7);
        for (int k = 0; k < 12; k++) {
            double side = random.nextDouble(2, 6);
            double r = random.nextDouble(0.1, 0.4);
            Point at = new Point(random.nextDouble(-0.5, 0.5), 0, random.nextDouble(-0.5, 0.5));
            GeometryObject robot = switch (k % 3) {
                case 0 -> new CylinderObject(at, r, 1);
                case 1 -> new SphereObject(at, r);
                default -> new BoxObject(at, 2 * r, 1, 2 * r).turned(0, 90 * random.nextInt(4));
            };
            double middle = side / 2 + 0.25;
            WorldCheck check = WorldCheck.of(world(
                    k % 2 == 0 ? Dimension.PLANAR : Dimension.SPATIAL,
                    wall(middle, 0, 0.5, side),
                    wall(-middle, 0, 0.5, side),
                    wall(0, middle, side + 1, 0.5),
                    wall(0, -middle, side + 1, 0.5),
                    robot.moveable("robot")));
            double truth = (side - 2 * r) * (side - 2 * r);
            assertThat(check.rooms()).singleElement().satisfies(room -> {
                assertThat(room.most()).as("side %s, r %s", side, r).isBetween(truth, 1.35 * truth);
                assertThat(room.area()).isLessThanOrEqualTo(room.most());
            });
        }
    }

    /** Who may turn passes a door that is narrower than it is long, and the bound knows it at any heading. */
    @Test
    void theUpperBoundHoldsAtAnyHeading() {
        GeometryObject cart = new BoxObject(new Point(-5, 0, 0), 3, 1, 0.6).turned(0, 90);
        assertThat(check(1, cart.moveable("cart")).rooms().get(0).most()).isGreaterThan(2 * 8.9 * 19);
        assertThat(check(0.4, cart.moveable("cart")).rooms().get(0).most()).isBetween(8.9 * 17, 9.9 * 20.25);
        // Nothing is known of a disc within a tilted robot, so the bound is the floor.
        assertThat(check(0.4, cart.turned(20, 0).moveable("cart"))
                        .rooms()
                        .get(0)
                        .most())
                .isEqualTo(20 * 20.25);
    }

    /** A hall that is too large for the desired step is searched at the finest one that can be afforded. */
    @Test
    void theStepIsRefinedAsFarAsThePlacesAllow() {
        WorldCheck check = large(Dimension.PLANAR, 200, drum("a", 0, 0, 0.1));
        assertThat(check.rooms()).singleElement().satisfies(room -> {
            assertThat(room.isTold()).isFalse();
            assertThat(room.step()).isBetween(0.8, 1.0);
            assertThat(room.area()).isBetween(199.0 * 199, 200.0 * 200);
        });
    }

    /** Walls that were dropped would have refused moves, so nothing follows for what the world needs. */
    @Test
    void noSettingIsRecommendedForAnIncompleteWorld() {
        GeometryObject wall = wall(5, 0, 0.2, 10);
        GeometryObject robot = drum("a", 0, 0, 0.5);
        assertThat(WorldCheck.of(world(Dimension.SPATIAL, wall, robot)).needs().isTold())
                .isTrue();
        WorldCheck outside = WorldCheck.of(
                world(Dimension.SPATIAL, wall, robot, new BoxObject(new Point(0, 0, 9), 2, 20, 2).named("tower")));
        assertThat(outside.outside()).hasSize(1);
        assertThat(outside.needs()).satisfies(WorldCheckTest::isUndecided);
        Skipped skipped = new Skipped("a.sdf", 7, "<heightmap>", "not supported");
        WorldImport read = new WorldImport(
                world(Dimension.SPATIAL, wall, robot), "SDFormat", Map.of(), Map.of(), List.of(skipped), List.of());
        assertThat(WorldCheck.of(read, (work, done, total) -> {}).needs()).satisfies(WorldCheckTest::isUndecided);
    }

    private static void isUndecided(RecommendedSetting needs) {
        assertThat(needs.isTold()).isFalse();
        assertThat(needs.dimension()).isEqualTo(Dimension.SPATIAL);
        assertThat(needs.accuracy()).isEqualTo(Accuracy.EXACT);
        assertThat(needs.settings()).hasSize(10).noneMatch(SettingComparison::isSame);
    }
}
