package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import robosim.geometry.Geometry;
import robosim.geometry.Rulings;
import robosim.geometry.SenseBuffer;
import robosim.geometry.WorkLimit;
import robosim.geometry.WorkLimitException;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.render.ColorCamera;
import robosim.geometry.render.ColorFrame;
import robosim.geometry.sweep.Outcome;
import robosim.geometry.sweep.ParameterSweep;
import robosim.geometry.sweep.Result;
import robosim.geometry.sweep.SweepWorld;
import robosim.geometry.world.World;
import robosim.geometry.world.WorldObject;
import robosim.geometry.world.WorldReader;
import robosim.geometry.world.check.WorldCheck;

/** Calls that are made of many others, under a limit of work. */
class LimitedWorkTest {
    private interface Call {
        Object on(Geometry world);
    }

    /** Ends a call a unit before it is done, and lets it be done with that unit. */
    private static void endsAtItsLast(Call call, String name) {
        Geometry world = Rulings.world(40);
        Object whole = call.on(world);
        world.limitWork(WorkLimit.none());
        assertThat(call.on(world)).isEqualTo(whole);
        long units = world.workDone();
        assertThat(units).as(name).isGreaterThan(10);
        List<?> before = world.objects();
        for (int time = 0; time < 2; time++) {
            world.limitWork(WorkLimit.of(units - 1));
            assertThat(catchThrowableOfType(WorkLimitException.class, () -> call.on(world)))
                    .hasMessageStartingWith(name + " must take at most " + (units - 1) + " units of work");
            assertThat(world.objects()).isEqualTo(before);
            world.limitWork(WorkLimit.of(units));
            assertThat(call.on(world)).isEqualTo(whole);
        }
    }

    @Test
    void batchesOfQuestionsEndAtTheirLastUnit() {
        endsAtItsLast(world -> Arrays.toString(world.scan("m", 0, 10, 36, 0, 5)), "scan");
        double[] numbers = new double[8 * 16];
        for (int k = 0; k < numbers.length; k++) {
            numbers[k] = k % 4 == 3 ? k : 0.01 * (k % 7) + (k % 4 == 1 ? 1 : 0);
        }
        endsAtItsLast(world -> world.freePoses("m", numbers, new long[1]), "freePoses");
        endsAtItsLast(world -> world.freeEdges("m", numbers, new long[1]), "freeEdges");
        double[] rays = new double[7 * 30];
        for (int k = 0; k < rays.length; k++) {
            rays[k] = k % 7 == 6 ? 5 : Math.cos(k);
        }
        endsAtItsLast(world -> world.freeRays(rays, 30, new long[1]), "freeRays");
        SenseBuffer out = new SenseBuffer();
        endsAtItsLast(
                world -> {
                    world.castRays(rays, 30, out);
                    return Arrays.toString(Arrays.copyOf(out.distances(), 30));
                },
                "castRays");
    }

    @Test
    void aPictureEndsAtItsLastUnitAndIsNoneThen() {
        ColorCamera camera = ColorCamera.of(24, 16, 60).at(Pose.lookAt(new Point(3, 3, 3), new Point(0, 0, 0)));
        ColorFrame frame = new ColorFrame();
        endsAtItsLast(
                world -> {
                    camera.render(world, frame);
                    return Arrays.toString(frame.pixels());
                },
                "a picture");
        Geometry world = Rulings.world(40);
        world.limitWork(WorkLimit.of(50));
        assertThatThrownBy(() -> camera.render(world, frame)).isInstanceOf(WorkLimitException.class);
        assertThat(frame.width()).isZero();
    }

    @Test
    void aCheckEndsAtItsLimit() throws Exception {
        World world = WorldReader.read(Path.of("worlds/rooms.xml"));
        List<Long> all = new ArrayList<>();
        for (long units : new long[] {100, 5000, 5000}) {
            long[] reports = new long[1];
            assertThatThrownBy(() -> WorldCheck.of(world, (work, done, total) -> reports[0]++, WorkLimit.of(units)))
                    .isInstanceOf(WorkLimitException.class)
                    .hasMessageStartingWith("a check must take at most " + units + " units of work");
            assertThat(reports[0]).isBetween(1L, units);
            all.add(reports[0]);
        }
        assertThat(all.get(1)).isEqualTo(all.get(2)).isGreaterThan(all.get(0));
    }

    /** Few objects and so few reports, but each question is of many pairs. */
    @Tag("slow")
    @Test
    void aCheckCountsWhatItsQuestionsTake() throws Exception {
        List<WorldObject> objects = List.of(
                new WorldObject(Rulings.mesh(400, true, 0)),
                new WorldObject(Rulings.mesh(400, false, 1e-3).moveable("m")));
        World world = new World(10, 10, 10, null, Dimension.SPATIAL, Accuracy.EXACT, objects);
        AtomicReference<WorkLimit> cancelled = new AtomicReference<>();
        int[] looks = new int[1];
        for (WorkLimit limit : List.of(WorkLimit.of(20_000), WorkLimit.none().pausing(() -> {
            if (++looks[0] == 20) {
                cancelled.get().cancel();
            }
        }))) {
            cancelled.set(limit);
            long[] reports = new long[1];
            assertThatThrownBy(() -> WorldCheck.of(world, (work, done, total) -> reports[0]++, limit))
                    .isInstanceOf(WorkLimitException.class);
            assertThat(reports[0]).isLessThan(100);
        }
        assertThat(looks[0]).isEqualTo(20);
    }

    /** The calls of two worlds together: the sum of what each takes alone, but for what is counted late. */
    @Test
    void theCallsOfWorldsCountTogether() {
        Move move = new Move(0, 1e-6, 0, 0, 0);
        long each = 0;
        List<Geometry> worlds = List.of(Rulings.world(60), Rulings.world(60));
        for (Geometry world : worlds) {
            world.limitWork(WorkLimit.none());
            world.move("m", move);
            each = world.workDone();
        }
        assertThat(each).isGreaterThan(1000);
        WorkLimit meter = WorkLimit.of(5 * each).meter("a plan");
        worlds.forEach(world -> world.limitWork(meter));
        int made = 0;
        while (made < 20) {
            Geometry world = worlds.get(made % 2);
            try {
                world.move("m", move);
            } catch (WorkLimitException e) {
                assertThat(e).hasMessageStartingWith("a plan must take at most " + 5 * each + " units of work");
                break;
            }
            made++;
        }
        assertThat(made).isIn(5, 6);
        assertThatThrownBy(() -> worlds.get(0).move("m", move)).isInstanceOf(WorkLimitException.class);
    }

    @Test
    void aReplicateThatWouldTakeMoreFailsAndTheOthersDoNot() {
        ParameterSweep sweep = ParameterSweep.of("moves", replicate -> {
                    Geometry world = replicate.world();
                    for (int k = 0; k < 3; k++) {
                        world.move("m", new Move(0, 1e-6, 0, 0, 0));
                    }
                    return Result.of("done", 1);
                })
                .over(new SweepWorld("few", Rulings.world(10).snapshot()))
                .over(new SweepWorld("many", Rulings.world(300).snapshot()))
                .limitWork(20_000)
                .replicates(2);
        for (long index = 0; index < sweep.size(); index++) {
            Outcome outcome = sweep.run(index);
            assertThat(outcome.line().contains("a replicate must take at most 20000 units of work"))
                    .as(outcome.line())
                    .isEqualTo(outcome.world().equals("many"));
        }
    }

    @Test
    void ownWorkCanBeCountedToo() {
        WorkLimit meter = WorkLimit.of(10).meter("a search");
        meter.take(10);
        assertThatThrownBy(() -> meter.take(1))
                .isInstanceOf(WorkLimitException.class)
                .hasMessageStartingWith("a search must take at most 10 units of work");
        assertThatThrownBy(() -> meter.take(-1))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("units must be at least 0 (got: -1)");
        assertThatThrownBy(() -> WorkLimit.of(-1)).hasMessage("units must be at least 0 (got: -1)");
    }
}
