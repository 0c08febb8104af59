package robosim.geometry.model;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.util.List;
import org.junit.jupiter.api.Test;
import robosim.geometry.Geometry;
import robosim.geometry.collision.CollisionDetection;
import robosim.geometry.exact.Attitude;

/** What no question could go down to the end of, and what is no rotation, is refused where it is made. */
class DeepGroupsTest {
    private static GeometryObject nested(int deep) {
        GeometryObject object = new SphereObject(new Point(), 1);
        for (int k = 0; k < deep; k++) {
            object = new ObjectGroup(List.of(new SphereObject(new Point(k % 3, 0, 0), 0.5), object)).turned(0, 1);
        }
        return object;
    }

    @Test
    void groupsAreNestedAHundredDeepAtMost() {
        GeometryObject deepest = nested(ObjectGroup.MAX_DEPTH);
        Geometry geometry = new Geometry(1000, 10, 1000);
        assertThat(geometry.addObject(deepest.moveable("r"))).isTrue();
        assertThat(geometry.simpleMove("r", 1, 0, 0)).isTrue();
        assertThat(CollisionDetection.intersects(deepest, deepest)).isTrue();
        assertThat(deepest).isEqualTo(nested(ObjectGroup.MAX_DEPTH)).hasSameHashCodeAs(nested(ObjectGroup.MAX_DEPTH));
        for (int beyond : new int[] {ObjectGroup.MAX_DEPTH + 1, 10_000}) {
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> nested(beyond))
                    .withMessage("groups must be at most 100 within each other (got: one more)");
        }
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new ObjectGroup(List.of(deepest), new SphereObject(new Point(), 900)));
    }

    @Test
    void aPoseIsMadeOfNoRotationThatIsNone() {
        double[] attitude = Attitude.identity();
        assertThat(Pose.of(new Point(), attitude, 0)).isEqualTo(Pose.ORIGIN);
        for (double wrong : new double[] {1.0001, 0, -1, Double.NaN, Double.POSITIVE_INFINITY}) {
            double[] none = attitude.clone();
            none[4] = wrong;
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> Pose.of(new Point(), none, 0))
                    .withMessageStartingWith("attitude must hold a rotation: 9 numbers")
                    .withMessageContaining("(got: [1.0, 0.0, 0.0, 0.0, " + wrong);
            double[] place = new double[Pose.PLACE];
            System.arraycopy(none, 0, place, 3, none.length);
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> Pose.of(place, 0))
                    .withMessageStartingWith("places must hold a rotation: 9 numbers");
        }
        double[] lost = attitude.clone();
        lost[9] = Double.NaN;
        assertThatIllegalArgumentException().isThrownBy(() -> Pose.of(new Point(), lost, 0));
        for (int at : new int[] {-1, 1, Integer.MAX_VALUE, Integer.MIN_VALUE}) {
            assertThatIllegalArgumentException().isThrownBy(() -> Pose.of(new Point(), attitude, at));
            assertThatIllegalArgumentException().isThrownBy(() -> Pose.of(new double[Pose.PLACE], at));
        }
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Pose.of(new Point(), null, 0))
                .withMessage("attitude must be given (got: null)");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Pose.of((double[]) null, 0))
                .withMessage("places must be given (got: null)");
    }
}
