package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.Effort;
import robosim.geometry.Geometry;
import robosim.geometry.NearObject;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;

/** No coarser level answers a longer distance to another object, whatever its rounding, and none finds nothing where EXACT does. */
class CoarseDistancesTest {
    private static final double FAR = Double.POSITIVE_INFINITY;

    @ParameterizedTest
    @EnumSource(Dimension.class)
    void noLevelAnswersALongerDistance(Dimension dimension) {
        SplittableRandom random = new SplittableRandom(360658);
        int[] shorter = new int[Accuracy.values().length];
        int[] equal = new int[shorter.length];
        int cases = Effort.cases(4_000, 1_000);
        for (int k = 0; k < cases; k++) {
            RandomObjects objects = new RandomObjects(random, k % 3 == 0 ? 30 : 3);
            GeometryObject a = (k % 2 == 0 ? objects.upright() : objects.next()).moveable("a");
            GeometryObject b = (k % 2 == 0 ? objects.upright() : objects.next()).moveable("b");
            double exact = world(dimension, Accuracy.EXACT, a, b).getProximity("a", FAR);
            for (Accuracy accuracy : Accuracy.values()) {
                Geometry world = world(dimension, accuracy, a, b);
                double coarse = world.getProximity("a", FAR);
                String what = dimension + " " + accuracy + " " + Paste.of(a) + "\n" + Paste.of(b);
                assertThat(coarse).as(what).isBetween(0.0, exact);
                assertThat(world.getProximity("b", FAR)).as(what).isEqualTo(coarse);
                assertThat(world.getProximity("a", exact)).as(what).isEqualTo(coarse);
                NearObject near = world.search().nearest("a", 1, exact).get(0);
                assertThat(near.distance()).as(what).isEqualTo(coarse);
                shorter[accuracy.ordinal()] += coarse < exact * (1 - 1e-9) ? 1 : 0;
                equal[accuracy.ordinal()] += coarse > 0 && coarse >= exact * (1 - 1e-9) ? 1 : 0;
            }
        }
        for (Accuracy accuracy : Accuracy.values()) {
            int k = accuracy.ordinal();
            assertThat(shorter[k]).isEqualTo(accuracy == Accuracy.EXACT ? 0 : shorter[k]);
            assertThat(equal[k]).as(accuracy + " as near as EXACT").isGreaterThan(cases / 200);
        }
        assertThat(shorter[Accuracy.SPHERE.ordinal()]).isGreaterThan(cases / 4);
    }

    private static Geometry world(Dimension dimension, Accuracy accuracy, GeometryObject a, GeometryObject b) {
        Geometry world = new Geometry(1e3, 1e3, 1e3, dimension, accuracy);
        assertThat(world.addObjectUnchecked(a) && world.addObjectUnchecked(b)).isTrue();
        return world;
    }
}
