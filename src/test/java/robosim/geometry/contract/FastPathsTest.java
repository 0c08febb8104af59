package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.Effort;
import robosim.geometry.Geometry;
import robosim.geometry.engine.World;
import robosim.geometry.engine.objects.ObjectTable;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;

/** The short way to the verdict about a straight move or a turn finds what the whole sweep finds, and the same end. */
class FastPathsTest {
    private static final int OBSTACLES = 5;

    @ParameterizedTest
    @EnumSource(Accuracy.class)
    void theFastPathAgreesWithTheSweep(Accuracy accuracy) {
        SplittableRandom random = new SplittableRandom(2026);
        int count = Effort.cases(400);
        int free = 0;
        int turns = 0;
        for (int k = 0; k < count; k++) {
            RandomObjects objects = new RandomObjects(random, k % 4 < 2 ? 2.5 : 6);
            Dimension dimension = Dimension.values()[k & 1];
            double side = k % 8 == 0 ? 6.5 : 40; // now and then the border is near
            Geometry geometry = new Geometry(side, side, side, dimension, accuracy);
            StringBuilder scene = new StringBuilder(accuracy + " " + dimension + " side " + side);
            for (int other = 0; other < OBSTACLES; other++) {
                GeometryObject obstacle = objects.next();
                geometry.addObjectUnchecked(obstacle);
                scene.append("; ").append(obstacle);
            }
            GeometryObject mover = objects.next().moveable("mover");
            if (!geometry.addObjectUnchecked(mover)) {
                continue;
            }
            for (int way = 0; way < 4; way++) {
                double length = way == 0 ? 0.01 : way == 1 ? 0.3 : 3;
                double x = random.nextDouble(-length, length);
                double y = random.nextInt(3) == 0 ? random.nextDouble(-length, length) : 0;
                double z = random.nextInt(4) == 0 ? 0 : random.nextDouble(-length, length);
                free += agree(geometry, x, y, z, scene + "; " + mover + " by " + new Point(x, y, z)) ? 1 : 0;
            }
            double degrees = k % 5 == 0 ? 90 : random.nextDouble(-200, 200);
            turns += agree(geometry, degrees, scene + "; " + mover + " by " + degrees) ? 1 : 0;
        }
        assertThat(free).isBetween(count / 2, 4 * count - count / 2);
        assertThat(turns).isBetween(count / 4, count - count / 20);
    }

    /** Whether both allow a move. */
    private static boolean agree(Geometry geometry, double x, double y, double z, String what) {
        World world = geometry.engine();
        int id = world.registry.mover("mover");
        boolean quick = world.motion.allows(world.view, id, x, y, z);
        double[] end = Arrays.copyOf(world.motion.end(), ObjectTable.PLACE);
        boolean whole = world.motion.attemptBeside(world.view, id, x, y, z, 0, 0);
        assertThat(quick).as(what).isEqualTo(whole);
        if (whole) {
            assertThat(end).as(what).isEqualTo(Arrays.copyOf(world.motion.end(), ObjectTable.PLACE));
        }
        return whole;
    }

    /** Whether both allow a turn. */
    private static boolean agree(Geometry geometry, double degrees, String what) {
        World world = geometry.engine();
        int id = world.registry.mover("mover");
        boolean quick = world.motion.allowsTurn(world.view, id, degrees);
        double[] end = Arrays.copyOf(world.motion.end(), ObjectTable.PLACE);
        boolean whole = world.motion.attempt(world.view, id, 0, 0, 0, 0, degrees, 0);
        assertThat(quick).as(what).isEqualTo(whole);
        if (whole) {
            assertThat(end).as(what).isEqualTo(Arrays.copyOf(world.motion.end(), ObjectTable.PLACE));
        }
        return whole;
    }
}
