package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import robosim.geometry.Geometry;
import robosim.geometry.MoveResult;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;

/** Robots among robots, few and many: each is let go as far as beside every other one alone, and blames the first. */
class SwarmTest {
    private static final double WORLD = 40;

    @ParameterizedTest
    @CsvSource({"PLANAR, 12", "PLANAR, 100", "SPATIAL, 16", "SPATIAL, 17", "SPATIAL, 60"})
    void movesAsAPlainListAllows(Dimension dimension, int count) {
        SplittableRandom random = new SplittableRandom(count);
        Geometry world = new Geometry(WORLD, WORLD, WORLD, dimension, Accuracy.EXACT);
        PlainList list = new PlainList(WORLD, dimension, Accuracy.EXACT);
        int side = (int) Math.ceil(Math.sqrt(count));
        for (int k = 0; k < count; k++) {
            // On a lattice, so that many things are met at once.
            Point at = new Point(k % side - side / 2, 0, k / side - side / 2);
            GeometryObject robot = (k % 3 == 0 ? new BoxObject(at, 0.5, 1, 0.5) : new CylinderObject(at, 0.25, 1))
                    .moveable("robot " + k);
            assertThat(world.addObject(robot)).isTrue();
            list.add(robot);
        }
        int made = 0;
        int blamed = 0;
        int heard = 0;
        for (int step = 0; step < 2 * count; step++) {
            int own = random.nextInt(count);
            String name = "robot " + own;
            Move move =
                    new Move(random.nextInt(-2, 3) * 0.5, 0, random.nextInt(-2, 3) * 0.5, 0, step % 3 == 0 ? 90 : 0);
            String what = "%s by %s".formatted(list.objects().get(own), move);
            PlainList.Free truth = list.move(own, move);
            Ray mount = new Ray(new Point(), new Point(random.nextInt(-3, 4), 0, 1));
            double sound = list.sonar(own, mount, 0, 5, 0);
            assertThat(world.getSonarDistance(name, mount, 0, 5, 0)).as(what).isEqualTo(sound);
            heard += sound < Double.POSITIVE_INFINITY ? 1 : 0;
            assertThat(world.getProximity(name, 3)).as(what).isEqualTo(list.proximity(own, 3));
            MoveResult result = world.move(name, move);
            assertThat(result.allowed()).as(what).isEqualTo(truth.allowed());
            assertThat(result.fraction()).as(what).isEqualTo(truth.fraction());
            assertThat(result.turnFraction()).as(what).isEqualTo(truth.turnFraction());
            assertThat(result.obstacle()).as(what).isEqualTo(truth.obstacle());
            if (result.allowed()) {
                list.replace(own, world.getObject(name));
                made++;
            } else {
                blamed++;
            }
        }
        assertThat(made).isPositive();
        assertThat(blamed).isPositive();
        assertThat(heard).isPositive();
        assertThat(world.objects()).containsExactlyElementsOf(list.objects());
    }
}
