package robosim.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Function;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
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
import robosim.geometry.model.Pose;
import robosim.geometry.model.Ray;
import robosim.geometry.model.RayPattern;
import robosim.geometry.model.SenseOptions;
import robosim.geometry.model.SphereObject;

/** Calls end at their limit of work, always at the same one, and leave the world and its later answers as they were. */
@Tag("slow")
class WorkLimitTest {
    private static final Move UP = new Move(0, 1e-5, 0, 0, 0);

    /** All that a world is: its objects in order, and the places of those that move, with their rounding errors. */
    private static String state(Geometry world) {
        int movers = world.engine().objects.moverCount();
        double[] places = new double[movers * Pose.PLACE];
        int[] ids = world.engine().objects.moverIds().toArray();
        for (int k = 0; k < movers; k++) {
            System.arraycopy(
                    world.engine().objects.places(),
                    world.engine().objects.place(ids[k]),
                    places,
                    k * Pose.PLACE,
                    Pose.PLACE);
        }
        long[] bits =
                Arrays.stream(places).mapToLong(Double::doubleToRawLongBits).toArray();
        return world.objects() + Arrays.toString(bits);
    }

    private static WorkLimitException refused(Runnable call) {
        return catchThrowableOfType(WorkLimitException.class, call::run);
    }

    @Test
    void aMoveAmongAllPairsEndsAtTheSameUnitEachTime() {
        long[] done = new long[2];
        for (int run = 0; run < done.length; run++) {
            Geometry world = Rulings.world(5000);
            String before = state(world);
            world.limitWork(WorkLimit.of(200_000));
            assertThat(refused(() -> world.move("m", UP)))
                    .hasMessageStartingWith("move must take at most 200000 units of work")
                    .hasMessageEndingWith("(got: more)")
                    .returns(false, WorkLimitException::isCancelled);
            assertThat(state(world)).isEqualTo(before);
            done[run] = world.workDone();
        }
        assertThat(done[0]).isEqualTo(200_000).isEqualTo(done[1]);
    }

    @Test
    void turnsSlidesAndDocksAmongAllPairsEndToo() {
        Geometry world = Rulings.world(5000);
        String before = state(world);
        world.limitWork(WorkLimit.of(100_000));
        assertThat(refused(() -> world.move("m", new Move(0, 0, 0, 0, 1e-4)))).isNotNull();
        assertThat(refused(() -> world.simpleTurn("m", 1e-4))).isNotNull();
        assertThat(refused(() -> world.moveAndSlide("m", new Move(1e-3, 1e-5, 0, 0, 0), 1e-5, 3)))
                .isNotNull();
        assertThat(refused(() -> world.moveToContact("m", UP, 1e-5))).isNotNull();
        assertThat(refused(() -> world.separate("m", 1e-2))).isNotNull();
        assertThat(refused(() -> world.placeObject("m", new Point(0, 1e-5, 0), 0)))
                .isNotNull();
        assertThat(refused(() -> world.testObject(Rulings.mesh(5000, false, 2e-3))))
                .isNotNull();
        assertThat(refused(() -> world.addObject(Rulings.mesh(5000, false, 2e-3))))
                .isNotNull();
        assertThat(refused(() -> world.search().touching(Rulings.mesh(5000, false, 2e-3))))
                .isNotNull();
        assertThat(state(world)).isEqualTo(before);
    }

    @Test
    void theLeastLimitThatIsEnoughIsWhatTheCallTakes() {
        Geometry world = Rulings.world(60);
        world.limitWork(WorkLimit.none());
        MoveResult free = world.move("m", UP);
        long units = world.workDone();
        assertThat(units).isBetween(3000L, 1_000_000L);

        Geometry same = Rulings.world(60);
        same.limitWork(WorkLimit.of(units - 1));
        assertThat(refused(() -> same.move("m", UP))).isNotNull();
        same.limitWork(WorkLimit.of(units));
        assertThat(same.move("m", UP)).isEqualTo(free);
        assertThat(same.workDone()).isEqualTo(units);
        assertThat(state(same)).isEqualTo(state(world));
    }

    /** The trees over an object are counted when it is added, whoever has built them: so later calls take the same units. */
    @Test
    void addingCountsWhatTreesAreBuiltOf() {
        List<Point> vertices = new ArrayList<>();
        int[][] faces = new int[700][];
        for (int k = 0; k < 702; k++) {
            vertices.add(new Point(k / 100.0, k % 2, k % 3));
        }
        Arrays.setAll(faces, k -> new int[] {k, k + 1, k + 2});
        MeshObject mesh = new MeshObject(vertices, faces);
        BitSet cells = new BitSet();
        cells.set(0, 64 * 100);
        for (GeometryObject object : List.of(
                mesh,
                new ObjectGroup(List.of(mesh, new SphereObject(new Point(), 1))),
                new GridObject(new Point(), 0.05, 1, 64, 100, cells))) {
            long parts = object instanceof GridObject ? 200 : object instanceof ObjectGroup ? 701 : 700;
            for (int run = 0; run < 2; run++) {
                Geometry world = new Geometry(40, 10, 40);
                world.limitWork(WorkLimit.of(parts - 1));
                assertThat(refused(() -> world.addObjectUnchecked(object)))
                        .hasMessageStartingWith("addObjectUnchecked must take at most " + (parts - 1));
                assertThat(world.objects()).isEmpty();
                world.limitWork(WorkLimit.of(parts));
                assertThat(world.addObjectUnchecked(object)).isTrue();
                assertThat(world.workDone()).isEqualTo(parts);
                world.testObject(new BoxObject(new Point(0, 3, 0), 1, 1, 1)); // builds the trees
            }
        }
    }

    @Test
    void cancellingFromAnotherThreadEndsTheCallAtTheNextLook() {
        Geometry world = Rulings.world(3000);
        String before = state(world);
        AtomicInteger looks = new AtomicInteger();
        WorkLimit[] limit = new WorkLimit[1];
        limit[0] = WorkLimit.none().pausing(() -> {
            if (looks.incrementAndGet() == 5) {
                Thread other = new Thread(limit[0]::cancel);
                other.start();
                join(other);
            }
        });
        world.limitWork(limit[0]);
        assertThat(refused(() -> world.move("m", UP)))
                .hasMessageStartingWith("move was cancelled by WorkLimit.cancel")
                .returns(true, WorkLimitException::isCancelled);
        assertThat(looks).hasValue(5);
        assertThat(state(world)).isEqualTo(before);
        assertThat(refused(() -> world.getProximity("m", 1))).returns(true, WorkLimitException::isCancelled);
        limit[0].reset();
        assertThat(world.getRayDistance(new Ray(new Point(4, 4, 4), new Point(0, 1, 0)), 0, 9, 0))
                .isInfinite();
    }

    private static void join(Thread other) {
        try {
            other.join();
        } catch (InterruptedException e) {
            throw new AssertionError(e);
        }
    }

    @Test
    void whatAPauseThrowsEndsTheCallAndLeavesTheWorld() {
        Geometry world = Rulings.world(500);
        String before = state(world);
        world.limitWork(WorkLimit.none().pausing(() -> {
            throw new IllegalStateException("enough");
        }));
        assertThatThrownBy(() -> world.move("m", UP))
                .isInstanceOf(IllegalStateException.class)
                .hasMessage("enough");
        assertThat(state(world)).isEqualTo(before);
    }

    @Test
    void callsTogetherHaveOneBudgetAndAreAllTakenBack() {
        Geometry world = Rulings.world(60);
        world.addObject(new BoxObject(new Point(4, 4, 4), 1, 1, 1).named("wall"));
        world.addObject(new SphereObject(new Point(-4, 4, 4), 0.5).moveable("ball"));
        world.removeObject("wall");
        world.addObject(new BoxObject(new Point(4, 4, 4), 1, 1, 1).named("wall"));
        world.addObject(new SphereObject(new Point(-4, -4, 4), 0.5).moveable("late"));
        String before = state(world);
        world.limitWork(WorkLimit.of(30_000));
        List<Boolean> made = new ArrayList<>();
        assertThat(refused(() -> world.together("a round", () -> {
                    made.add(world.move("ball", new Move(0.1, 0, 0, 30, 40)).allowed());
                    made.add(world.addObject(new BoxObject(new Point(0, -4, -4), 1, 1, 1).named("new")));
                    made.add(world.addObjectUnchecked(new SphereObject(new Point(0, -4, -4), 1)));
                    made.add(world.removeObject("ball"));
                    made.add(world.addObject(new SphereObject(new Point(1, 4, 4), 0.5).moveable("ball")));
                    made.add(world.move("ball", new Move(0.1, 0, 0, 0, 0)).allowed());
                    made.add(world.removeObject("wall"));
                    made.add(world.removeObject("new"));
                    made.add(world.removeObject("m"));
                    made.add(world.addObjectUnchecked(
                            Rulings.mesh(60, false, 1e-3).moveable("m")));
                    for (int k = 0; k < 1000; k++) {
                        world.move("m", new Move(0, 0, 0, 0, 1e-6));
                    }
                    return made;
                })))
                .hasMessageStartingWith("a round must take at most 30000 units");
        assertThat(made).hasSize(10).doesNotContain(false);
        assertThat(state(world)).isEqualTo(before);
        assertThat(world.search().inBox(new Point(0, 0, 0), 10, 10, 10)).isEqualTo(world.objects());
        assertThat(world.simpleMove("ball", 0.1, 0, 0)).isTrue();
    }

    @Test
    void callsTogetherAreTakenBackInAWorldThatSharesItsObjects() {
        Geometry original = new Geometry(20, 20, 20);
        for (int k = 0; k < 20; k++) {
            original.addObject(new BoxObject(new Point(k - 9.5, 5, 0), 0.5, 1, 1).named("box " + k));
        }
        original.addObject(new SphereObject(new Point(0, 0, 0), 0.5).moveable("ball"));
        Geometry world = original.snapshot().toGeometry();
        String before = state(world);
        assertThatThrownBy(() -> world.together("a round", () -> {
                    world.removeObject("ball");
                    world.removeObject("box 3");
                    world.addObject(new SphereObject(new Point(0, 1, 0), 0.5).moveable("ball"));
                    world.removeObject("box 5");
                    throw new IllegalStateException();
                }))
                .isInstanceOf(IllegalStateException.class);
        assertThat(state(world)).isEqualTo(before);
        assertThat(world.together("a round", () -> world.removeObject("box 3"))).isTrue();
        assertThat(world.objects()).hasSize(20);
    }

    // ---- any call, ended anywhere, leaves no trace ----

    private enum Kind {
        SPACE(Dimension.SPATIAL, Accuracy.EXACT),
        PLANE(Dimension.PLANAR, Accuracy.EXACT),
        BOXES(Dimension.SPATIAL, Accuracy.AABB),
        DOP(Dimension.PLANAR, Accuracy.DOP);

        private final Dimension dimension;
        private final Accuracy accuracy;

        Kind(Dimension dimension, Accuracy accuracy) {
            this.dimension = dimension;
            this.accuracy = accuracy;
        }
    }

    private static MeshObject rock(SplittableRandom random, double size) {
        List<Point> corners = new ArrayList<>();
        for (int k = 0; k < 12; k++) {
            corners.add(new Point(
                    random.nextDouble(-size, size), random.nextDouble(-size, size), random.nextDouble(-size, size)));
        }
        int[][] faces = new int[30][];
        for (int k = 0; k < faces.length; k++) {
            int first = random.nextInt(12);
            faces[k] = new int[] {first, (first + 1 + random.nextInt(5)) % 12, (first + 6 + random.nextInt(5)) % 12};
        }
        return new MeshObject(corners, faces);
    }

    private static Geometry crowd(Kind kind, long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        Geometry world = new Geometry(12, 6, 12, kind.dimension, kind.accuracy);
        world.addObjectUnchecked(new BoxObject(new Point(0, -2, 0), 11, 1, 11).named("floor"));
        BitSet cells = new BitSet();
        for (int k = 0; k < 400; k++) {
            cells.set(k, random.nextInt(12) == 0);
        }
        world.addObjectUnchecked(new GridObject(new Point(0, 0, 0), 0.5, 2, 20, 20, cells).named("map"));
        world.addObjectUnchecked(rock(random, 3).named("rock"));
        for (int k = 0; k < 12; k++) {
            Point at = new Point(random.nextDouble(-4, 4), random.nextDouble(-1, 1), random.nextDouble(-4, 4));
            world.addObjectUnchecked(
                    k % 3 == 0
                            ? new BoxObject(at, 0.5, 0.6, 0.7).turned(random.nextDouble(90), random.nextDouble(90))
                            : k % 3 == 1 ? new CapsuleObject(at, 0.2, 0.8) : new CylinderObject(at, 0.3, 0.8));
        }
        world.addObjectUnchecked(new CylinderObject(new Point(0, -1, 0), 0.3, 1).moveable("disc"));
        world.addObjectUnchecked(rock(random, 0.6).movedTo(new Point(1, 0, 1)).moveable("stone"));
        world.addObjectUnchecked(new ObjectGroup(List.of(
                        new BoxObject(new Point(0, 0, 0), 0.4, 0.4, 0.4),
                        new SphereObject(new Point(0.3, 0, 0), 0.2),
                        rock(random, 0.4).movedTo(new Point(0, 0.3, 0))))
                .movedTo(new Point(-1, 0, -1))
                .moveable("group"));
        return world;
    }

    private static final List<String> NAMES = List.of("disc", "stone", "group");

    /** A random call, which returns all that it tells, as text to the bit. */
    private static Function<Geometry, String> call(SplittableRandom random, boolean isFlat) {
        String name = NAMES.get(random.nextInt(3));
        Move move = new Move(
                random.nextDouble(-1, 1),
                random.nextInt(3) == 0 ? random.nextDouble(-0.2, 0.2) : 0,
                random.nextDouble(-1, 1),
                random.nextInt(4) == 0 ? random.nextDouble(-30, 30) : 0,
                random.nextInt(2) == 0 ? random.nextDouble(-90, 90) : 0);
        Point at = new Point(random.nextDouble(-4, 4), random.nextDouble(-1, 1), random.nextDouble(-4, 4));
        double angle = random.nextDouble(360);
        double width = random.nextInt(2) * random.nextDouble(40);
        double[] numbers = random.doubles(80, -3, 3).toArray();
        return switch (random.nextInt(13)) {
            case 0 -> world -> world.move(name, move).toString();
            case 1 -> world -> world.moveGlobal(name, move).toString();
            case 2 -> world -> world.moveToContact(name, move, 0.01).toString();
            case 3, 4 -> world -> world.moveAndSlide(name, move, 0.01, 4).toString();
            case 5 -> world -> "" + world.separate(name, 2);
            case 6 ->
                world -> ""
                        + (angle < 180 ? world.simpleMove(name, move.x(), 0, move.z()) : world.simpleTurn(name, angle));
            case 7 -> world -> "" + world.placeObject(name, at, angle);
            case 8 ->
                world -> world.getRayDistance(new Ray(at, new Point(1, 0, move.z())), 0, 9, width) + " "
                        + world.getProximity(name, 2)
                        + world.search().nearest(at, 3, 5);
            case 9 -> world -> Arrays.toString(world.scan(name, angle, 5, 30, 0, 9));
            case 10 ->
                world -> {
                    SenseBuffer out = new SenseBuffer();
                    RayPattern pattern = isFlat ? RayPattern.fan(0, 6, 40) : RayPattern.pinhole(8, 6, 60);
                    world.sense(
                            name, Pose.ORIGIN, pattern, SenseOptions.range(0, 8).withWidth(width), out);
                    return Arrays.toString(Arrays.copyOf(out.distances(), pattern.size()));
                };
            case 11 ->
                world -> {
                    long[] free = new long[1];
                    world.freePoses(name, numbers, free);
                    long[] edges = new long[1];
                    world.freeEdges(name, numbers, edges);
                    return free[0] + " " + edges[0];
                };
            default ->
                world -> world.castRay(new Ray(at, new Point(1, 0, move.z())), 9) + " "
                        + world.testObject(new BoxObject(at, 1, 1, 1))
                        + world.search().touching(new BoxObject(at, 2, 2, 2));
        };
    }

    @ParameterizedTest
    @EnumSource(Kind.class)
    void aCallThatIsEndedAnywhereLeavesNoTrace(Kind kind) {
        int ended = 0;
        for (int seed = 0; seed < Effort.cases(2); seed++) {
            SplittableRandom random = new SplittableRandom(seed);
            Geometry world = crowd(kind, seed);
            Geometry twin = crowd(kind, seed);
            for (int k = 0; k < 9; k++) {
                Function<Geometry, String> call = call(random, kind.dimension == Dimension.PLANAR);
                String before = state(world);
                long limit = random.nextInt(4);
                boolean isMade = false;
                while (!isMade) {
                    world.limitWork(WorkLimit.of(limit));
                    String[] told = new String[1];
                    WorkLimitException refused = refused(() -> told[0] = call.apply(world));
                    isMade = refused == null;
                    if (isMade) {
                        assertThat(told[0]).isEqualTo(call.apply(twin));
                    } else {
                        ended++;
                        assertThat(state(world)).isEqualTo(before);
                    }
                    limit = 3 * limit + 1;
                }
                assertThat(state(world)).isEqualTo(state(twin));
            }
        }
        assertThat(ended).isGreaterThan(30);
    }
}
