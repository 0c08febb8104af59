package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import robosim.geometry.Geometry;
import robosim.geometry.Rulings;
import robosim.geometry.SenseBuffer;
import robosim.geometry.WorkLimit;
import robosim.geometry.WorkLimitException;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;
import robosim.geometry.render.ColorCamera;
import robosim.geometry.render.ColorFrame;
import robosim.geometry.render.Viewpoints;
import robosim.geometry.sweep.Outcome;
import robosim.geometry.sweep.Result;
import robosim.geometry.sweep.Sweep;
import robosim.geometry.sweep.SweepWorld;
import robosim.geometry.world.World;
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
        ColorCamera camera = ColorCamera.of(24, 16, 60).at(Viewpoints.lookAt(new Point(3, 3, 3), new Point(0, 0, 0)));
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
        for (int time = 0; time < 2; time++) {
            long[] reports = new long[1];
            assertThatThrownBy(() -> WorldCheck.of(world, (work, done, total) -> reports[0]++, WorkLimit.of(100)))
                    .isInstanceOf(WorkLimitException.class)
                    .hasMessageStartingWith("a check must take at most 100 units of work");
            assertThat(reports[0]).isEqualTo(100);
        }
    }

    @Test
    void aReplicateThatWouldTakeMoreFailsAndTheOthersDoNot() {
        Sweep sweep = Sweep.of("moves", replicate -> {
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
        WorkLimit.Meter meter = WorkLimit.of(10).meter("a search");
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
