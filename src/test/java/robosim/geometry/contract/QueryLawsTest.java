package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.Geometry;
import robosim.geometry.MoveResult;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CapsuleObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;
import robosim.geometry.model.SphereObject;

/** Laws that answers obey whatever they are. */
class QueryLawsTest {
    private static final double SIZE = 64;
    private static final double INFINITE = Double.POSITIVE_INFINITY;

    private static Geometry world(Dimension dimension, double size, List<GeometryObject> objects) {
        Geometry world = new Geometry(size, size, size, dimension, Accuracy.EXACT);
        objects.forEach(object -> assertThat(world.addObjectUnchecked(object)).isTrue());
        return world;
    }

    private static Geometry pair(Dimension dimension, GeometryObject a, GeometryObject b) {
        return world(dimension, SIZE, List.of(a.moveable("a"), b.moveable("b")));
    }

    private static List<GeometryObject> some(RandomObjects objects, int count) {
        List<GeometryObject> some = new ArrayList<>();
        for (int k = 0; k < count; k++) {
            some.add(objects.next());
        }
        return some;
    }

    @ParameterizedTest
    @EnumSource(Dimension.class)
    void theOrderOfTwoMakesNoDifference(Dimension dimension) {
        RandomObjects objects = new RandomObjects(new SplittableRandom(41), 1.5);
        int hits = 0;
        for (int k = 0; k < 600; k++) {
            GeometryObject a = objects.next();
            GeometryObject b = objects.next();
            Geometry world = pair(dimension, a, b);
            double distance = world.getProximity("a", INFINITE);
            String what = dimension + " " + a + " | " + b;
            assertThat(world.getProximity("b", INFINITE)).as(what).isEqualTo(distance);
            boolean collide = world(dimension, SIZE, List.of(a)).testObject(b);
            assertThat(world(dimension, SIZE, List.of(b)).testObject(a))
                    .as(what)
                    .isEqualTo(collide);
            assertThat(distance == 0).as(what + " at " + distance).isEqualTo(collide);
            hits += collide ? 1 : 0;
        }
        assertThat(hits).isBetween(150, 500);
    }

    /** By a quarter turn about Y, which no number is rounded by. */
    private static Point quarter(Point p) {
        return new Point(p.z(), p.y(), -p.x());
    }

    private static GeometryObject quarter(GeometryObject object) {
        double[] r = object.rotation();
        double[] turned = {r[6], r[7], r[8], r[3], r[4], r[5], -r[0], -r[1], -r[2]};
        return object.movedTo(quarter(object.center())).oriented(turned);
    }

    /** In the plane x = 0; every shape but a mesh or a group is its own mirror image. */
    private static Point mirror(Point p) {
        return new Point(-p.x(), p.y(), p.z());
    }

    private static GeometryObject mirror(GeometryObject object) {
        double[] r = object.rotation();
        double[] turned = {r[0], -r[1], -r[2], -r[3], r[4], r[5], -r[6], r[7], r[8]};
        GeometryObject shape = object;
        if (object instanceof MeshObject mesh) {
            MeshObject image = new MeshObject(
                    mesh.vertices().stream().map(QueryLawsTest::mirror).toList(), mesh.faces());
            shape = mesh.isSolid() ? image.solid() : image;
        } else if (object instanceof ObjectGroup group) {
            shape = new ObjectGroup(
                    group.members().stream().map(QueryLawsTest::mirror).toList());
        }
        return shape.movedTo(mirror(object.center())).oriented(turned);
    }

    @ParameterizedTest
    @EnumSource(Dimension.class)
    void aQuarterTurnOfAllChangesNothing(Dimension dimension) {
        unchanged(dimension, QueryLawsTest::quarter, QueryLawsTest::quarter, 42);
    }

    @ParameterizedTest
    @EnumSource(Dimension.class)
    void aMirrorChangesNothing(Dimension dimension) {
        unchanged(dimension, QueryLawsTest::mirror, QueryLawsTest::mirror, 43);
    }

    private static void unchanged(
            Dimension dimension, UnaryOperator<GeometryObject> image, UnaryOperator<Point> point, long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        RandomObjects objects = new RandomObjects(random, 3);
        int hits = 0;
        for (int k = 0; k < 300; k++) {
            List<GeometryObject> some = some(objects, 4);
            GeometryObject asked = objects.next();
            Geometry one = world(dimension, SIZE, some);
            Geometry two = world(dimension, SIZE, some.stream().map(image).toList());
            String what = dimension + " " + asked + " in " + some;
            boolean collide = one.testObject(asked);
            hits += collide ? 1 : 0;
            assertThat(two.testObject(image.apply(asked))).as(what).isEqualTo(collide);
            Ray ray = new Ray(objects.place(), objects.direction());
            Ray other = new Ray(point.apply(ray.start()), point.apply(ray.direction()));
            same(two.getRayDistance(other, 0, INFINITE, 0), one.getRayDistance(ray, 0, INFINITE, 0), 4, ray + what);
            double width = random.nextDouble(170);
            double bracket = dimension == Dimension.SPATIAL ? 0x1p14 : 64;
            same(
                    two.getRayDistance(other, 0, INFINITE, width),
                    one.getRayDistance(ray, 0, INFINITE, width),
                    bracket,
                    width + " degrees " + ray + what);
            one.addObjectUnchecked(asked.named("asked"));
            two.addObjectUnchecked(image.apply(asked).named("asked"));
            double near = one.getProximity("asked", INFINITE);
            same(two.getProximity("asked", INFINITE), near, bracket, what);
        }
        assertThat(hits).isBetween(60, 240);
    }

    private static void same(double answer, double expected, double ulps, String what) {
        if (answer != expected) {
            assertThat(answer).as(what).isFinite();
            assertThat(Math.abs(answer - expected))
                    .as("%s and %s: %s", answer, expected, what)
                    .isLessThanOrEqualTo(ulps * Math.ulp(8));
        }
    }

    private static GeometryObject scaled(GeometryObject object, double by) {
        GeometryObject shape = switch (object.kind()) {
            case BOX -> {
                BoxObject box = (BoxObject) object;
                yield new BoxObject(new Point(), by * box.width(), by * box.height(), by * box.length());
            }
            case CYLINDER -> {
                CylinderObject cylinder = (CylinderObject) object;
                yield new CylinderObject(new Point(), by * cylinder.radius(), by * cylinder.height());
            }
            case SPHERE -> new SphereObject(new Point(), by * ((SphereObject) object).radius());
            case CAPSULE -> {
                CapsuleObject capsule = (CapsuleObject) object;
                yield new CapsuleObject(new Point(), by * capsule.radius(), by * capsule.segment());
            }
            case MESH -> {
                MeshObject mesh = (MeshObject) object;
                MeshObject image = new MeshObject(
                        mesh.vertices().stream().map(p -> scaled(p, by)).toList(), mesh.faces());
                yield mesh.isSolid() ? image.solid() : image;
            }
            case GROUP ->
                new ObjectGroup(((ObjectGroup) object)
                        .members().stream().map(member -> scaled(member, by)).toList());
            case GRID -> throw new IllegalArgumentException("no grids here (got: " + object + ")");
        };
        GeometryObject there = shape.at(object.pose()).movedTo(scaled(object.center(), by));
        return object.isMoveable() ? there.moveable(String.valueOf(object.name())) : there;
    }

    private static Point scaled(Point p, double by) {
        return new Point(by * p.x(), by * p.y(), by * p.z());
    }

    @ParameterizedTest
    @EnumSource(Dimension.class)
    void answersScaleByPowersOfTwoBitForBit(Dimension dimension) {
        SplittableRandom random = new SplittableRandom(44);
        RandomObjects objects = new RandomObjects(random, 3);
        for (int k = 0; k < 250; k++) {
            double by = new double[] {0x1p-40, 0x1p-7, 0.5, 2, 0x1p9, 0x1p40}[k % 6];
            List<GeometryObject> some = some(objects, 4);
            GeometryObject mover = objects.next().moveable("mover");
            Geometry one = world(dimension, SIZE, some);
            Geometry two = world(
                    dimension,
                    SIZE * by,
                    some.stream().map(each -> scaled(each, by)).toList());
            String what = dimension + " times " + by + ": " + mover + " in " + some;
            assertThat(two.testObject(scaled(mover, by))).as(what).isEqualTo(one.testObject(mover));
            Ray ray = new Ray(objects.place(), objects.direction());
            Ray other = new Ray(scaled(ray.start(), by), k % 2 == 0 ? ray.direction() : scaled(ray.direction(), by));
            double width = k % 3 == 0 ? 0 : random.nextDouble(170);
            assertThat(two.getRayDistance(other, 0, INFINITE, width))
                    .as(ray + " " + width + " degrees " + what)
                    .isEqualTo(by * one.getRayDistance(ray, 0, INFINITE, width));
            one.addObjectUnchecked(mover);
            two.addObjectUnchecked(scaled(mover, by));
            assertThat(two.getProximity("mover", INFINITE))
                    .as(what)
                    .isEqualTo(by * one.getProximity("mover", INFINITE));
            Point way = objects.direction();
            double ry = k % 2 == 0 ? 0 : random.nextDouble(-90, 90);
            MoveResult result = one.moveGlobal("mover", new Move(way.x(), way.y(), way.z(), 0, ry));
            MoveResult twin = two.moveGlobal("mover", new Move(by * way.x(), by * way.y(), by * way.z(), 0, ry));
            assertThat(twin.allowed()).as(way + what).isEqualTo(result.allowed());
            assertThat(twin.fraction()).as(way + what).isEqualTo(result.fraction());
            assertThat(twin.turnFraction()).as(ry + what).isEqualTo(result.turnFraction());
        }
    }

    /** Upright things of one height are what the plane shows of them. */
    @Test
    void aPlaneStretchedUpIsItsSpace() {
        SplittableRandom random = new SplittableRandom(45);
        RandomObjects objects = new RandomObjects(random, 4);
        int moved = 0;
        for (int k = 0; k < 300; k++) {
            List<GeometryObject> some = new ArrayList<>();
            while (some.size() < 8) {
                GeometryObject object = objects.upright();
                if (object instanceof BoxObject || object instanceof CylinderObject) {
                    some.add(prism(object));
                }
            }
            GeometryObject mover = some.remove(0).moveable("mover");
            some.removeIf(other -> world(Dimension.PLANAR, SIZE, List.of(other)).testObject(mover));
            Geometry plane = world(Dimension.PLANAR, SIZE, some);
            Geometry space = world(Dimension.SPATIAL, SIZE, some);
            GeometryObject asked = prism(new BoxObject(objects.place(), 0.5, 1, 0.7).turned(0, objects.heading()));
            String what = asked + " in " + some;
            assertThat(space.testObject(asked)).as(what).isEqualTo(plane.testObject(asked));
            Ray ray = new Ray(level(objects.place()), level(objects.direction()));
            same(space.getRayDistance(ray, 0, INFINITE, 0), plane.getRayDistance(ray, 0, INFINITE, 0), 4, ray + what);
            plane.addObject(mover);
            space.addObject(mover);
            Point way = objects.direction();
            Move move = new Move(way.x(), 0, way.z(), 0, k % 2 == 0 ? 0 : random.nextDouble(-180, 180));
            MoveResult result = space.move("mover", move);
            MoveResult flat = plane.move("mover", move);
            assertThat(result.allowed()).as(mover + " " + move + what).isEqualTo(flat.allowed());
            assertThat(result.fraction()).as(mover + " " + move + what).isEqualTo(flat.fraction());
            assertThat(result.turnFraction()).as(mover + " " + move + what).isEqualTo(flat.turnFraction());
            moved += result.allowed() ? 1 : 0;
        }
        assertThat(moved).isBetween(60, 270);
    }

    private static Point level(Point p) {
        return new Point(p.x(), 0, p.z());
    }

    private static GeometryObject prism(GeometryObject object) {
        return object instanceof CylinderObject cylinder
                ? new CylinderObject(level(cylinder.center()), cylinder.radius(), 20)
                : new BoxObject(level(object.center()), ((BoxObject) object).width(), 20, ((BoxObject) object).length())
                        .turned(0, object.heading());
    }

    @ParameterizedTest
    @EnumSource(Dimension.class)
    void aBoxIsItsTwelveTriangles(Dimension dimension) {
        SplittableRandom random = new SplittableRandom(46);
        RandomObjects objects = new RandomObjects(random, 2);
        int hits = 0;
        for (int k = 0; k < 400; k++) {
            BoxObject box = new BoxObject(
                            objects.place(), random.nextDouble(2), random.nextDouble(2), random.nextDouble(2))
                    .turned(k % 2 == 0 ? 0 : random.nextDouble(360), random.nextDouble(360));
            MeshObject mesh = RandomObjects.meshOf(box);
            GeometryObject other = objects.next();
            Geometry solid = world(dimension, SIZE, List.of(box));
            Geometry triangles = world(dimension, SIZE, List.of(mesh));
            String what = dimension + " " + box + " | " + other;
            boolean collide = solid.testObject(other);
            hits += collide ? 1 : 0;
            Ray ray = new Ray(objects.place(), objects.direction());
            for (double width : new double[] {0, 5, 90}) {
                same(
                        triangles.getRayDistance(ray, 0, INFINITE, width),
                        solid.getRayDistance(ray, 0, INFINITE, width),
                        0x1p16,
                        ray + " " + width + what);
            }
            double near = pair(dimension, mesh, other).getProximity("b", INFINITE);
            double distance = pair(dimension, box, other).getProximity("b", INFINITE);
            same(near, distance, 0x1p14, what);
            assertThat(triangles.testObject(other)).as(what).isEqualTo(collide);
        }
        assertThat(hits).isBetween(60, 300);
    }

    @ParameterizedTest
    @EnumSource(Dimension.class)
    void toGrowNeverPartsTwo(Dimension dimension) {
        RandomObjects objects = new RandomObjects(new SplittableRandom(47), 1);
        int hits = 0;
        for (int k = 0; k < 500; k++) {
            GeometryObject a = objects.primitive();
            GeometryObject b = objects.next();
            if (!world(dimension, SIZE, List.of(b)).testObject(a)) {
                continue;
            }
            hits++;
            for (double by : new double[] {Math.nextUp(1.0), 1.5}) {
                GeometryObject grown = scaled(a, by).at(a.pose());
                assertThat(world(dimension, SIZE, List.of(b)).testObject(grown))
                        .as("%s %s grown by %s | %s", dimension, a, by, b)
                        .isTrue();
            }
        }
        assertThat(hits).isGreaterThan(150);
    }

    @ParameterizedTest
    @EnumSource(Dimension.class)
    void aConeIsNoLongerThanARayInIt(Dimension dimension) {
        SplittableRandom random = new SplittableRandom(48);
        RandomObjects objects = new RandomObjects(random, 4);
        int heard = 0;
        for (int k = 0; k < 300; k++) {
            Geometry world = world(dimension, SIZE, some(objects, 6));
            Point d = objects.direction();
            Ray axis = new Ray(objects.place(), dimension == Dimension.PLANAR ? level(d) : d);
            double width = random.nextDouble(1, 170);
            double cone = world.getRayDistance(axis, 0, INFINITE, width);
            String what = dimension + " " + axis + " " + width + " degrees in " + world.objects();
            double before = INFINITE;
            for (double part : new double[] {0, 1e-9, 0.1, 0.5, 0.9, 1}) {
                double narrower = world.getRayDistance(axis, 0, INFINITE, part * width);
                assertThat(narrower).as(part + " of " + what).isLessThanOrEqualTo(before * (1 + 0x1p-38) + 0x1p-40);
                before = narrower;
            }
            for (int n = 0; n < 20; n++) {
                Ray within = within(axis, width / 2 * random.nextDouble(0.999), dimension, random);
                double ray = world.getRayDistance(within, 0, INFINITE, 0);
                assertThat(cone).as(within + " " + what).isLessThanOrEqualTo(ray * (1 + 0x1p-40) + 0x1p-45);
            }
            heard += cone < INFINITE ? 1 : 0;
            double max = random.nextDouble(6);
            double min = random.nextDouble(max);
            double expected = cone > max ? INFINITE : Math.max(cone, min);
            assertThat(world.getRayDistance(axis, min, max, width))
                    .as(min + " " + max + what)
                    .isEqualTo(expected);
            if (cone < INFINITE) {
                // What is answered may be the lower end of a bracket, and the truth a little beyond it.
                assertThat(world.getRayDistance(axis, 0, cone * (1 + 0x1p-38), width))
                        .as(what)
                        .isEqualTo(cone);
            }
        }
        assertThat(heard).isBetween(150, 300);
    }

    /** A ray that leaves the axis by so many degrees, to some side. */
    private static Ray within(Ray axis, double degrees, Dimension dimension, SplittableRandom random) {
        Point d = axis.direction();
        double length = Math.sqrt(d.x() * d.x() + d.y() * d.y() + d.z() * d.z());
        double[] u = {d.x() / length, d.y() / length, d.z() / length};
        boolean planar = dimension == Dimension.PLANAR;
        double[] any = planar
                ? new double[] {-u[2], 0, u[0]}
                : new double[] {random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1)};
        double along = any[0] * u[0] + any[1] * u[1] + any[2] * u[2];
        double square = 0;
        for (int k = 0; k < 3; k++) {
            any[k] -= along * u[k];
            square += any[k] * any[k];
        }
        double cos = StrictMath.cos(Math.toRadians(degrees));
        double sin = (random.nextBoolean() ? 1 : -1) * StrictMath.sin(Math.toRadians(degrees)) / Math.sqrt(square);
        return new Ray(
                axis.start(),
                new Point(cos * u[0] + sin * any[0], cos * u[1] + sin * any[1], cos * u[2] + sin * any[2]));
    }

    @ParameterizedTest
    @EnumSource(Dimension.class)
    void everyLevelEncloses(Dimension dimension) {
        SplittableRandom random = new SplittableRandom(49);
        RandomObjects objects = new RandomObjects(random, 3);
        int coarser = 0;
        for (int k = 0; k < 250; k++) {
            List<GeometryObject> some = some(objects, 4);
            GeometryObject mover = objects.next().moveable("mover");
            Geometry exact = world(dimension, SIZE, some);
            boolean collide = exact.testObject(mover);
            Ray ray = new Ray(objects.place(), objects.direction());
            double width = k % 2 == 0 ? 0 : random.nextDouble(120);
            double distance = exact.getRayDistance(ray, 0, INFINITE, width);
            exact.addObjectUnchecked(mover);
            double near = exact.getProximity("mover", INFINITE);
            Point way = objects.direction();
            double turn = k % 3 == 0 ? 0 : random.nextDouble(-90, 90);
            Move move = new Move(way.x(), way.y(), way.z(), k % 7 == 0 ? turn : 0, turn);
            boolean free = exact.moveGlobal("mover", move).allowed();
            for (Accuracy level : Accuracy.values()) {
                String what = dimension + " " + level + " " + mover + " by " + move + " among " + some;
                Geometry coarse = new Geometry(SIZE, SIZE, SIZE, dimension, level);
                some.forEach(each -> assertThat(coarse.addObjectUnchecked(each)).isTrue());
                boolean maybe = coarse.testObject(mover);
                coarser += maybe != collide ? 1 : 0;
                assertThat(maybe || !collide).as(what).isTrue();
                assertThat(coarse.getRayDistance(ray, 0, INFINITE, width))
                        .as(ray + " " + width + " " + what)
                        .isLessThanOrEqualTo(distance * (1 + 0x1p-40));
                coarse.addObjectUnchecked(mover);
                assertThat(coarse.getProximity("mover", INFINITE))
                        .as(what)
                        .isLessThanOrEqualTo(near * (1 + 0x1p-40) + 0x1p-44);
                if (!maybe && coarse.moveGlobal("mover", move).allowed()) {
                    assertThat(free).as(what).isTrue();
                }
            }
        }
        assertThat(coarser).isGreaterThan(50);
    }
}
