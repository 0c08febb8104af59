package robosim.geometry.world.shared;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;

class PlacementTest {
    private static Point point(SplittableRandom random) {
        return new Point(random.nextDouble(-9, 9), random.nextDouble(-9, 9), random.nextDouble(-9, 9));
    }

    /** Headings are kept with what their sums have lost: there and back again is no turn at all, to the bit. */
    @Test
    void upWithoutADrift() {
        SplittableRandom random = new SplittableRandom(71);
        int lost = 0;
        for (int k = 0; k < 2000; k++) {
            Placement way = Placement.NONE;
            for (int step = random.nextInt(1, 9); step > 0; step--) {
                way = way.then(
                        Placement.upright(point(random), random.nextDouble(-400, 400) * (step % 2 == 0 ? 1 : 1e-3), 0));
            }
            lost += way.pose().lostHeading() != 0 ? 1 : 0;
            for (Placement back :
                    new Placement[] {way.then(way.inverse()), way.inverse().then(way)}) {
                assertThat(back.pose().rotation()).containsExactly(Pose.ORIGIN.rotation());
                assertThat(back.pose().lostHeading()).isZero();
                near(back.origin(), new Point(), 1e-13);
            }
        }
        assertThat(lost).isBetween(500, 1999);
    }

    @Test
    void tippedThereAndBack() {
        SplittableRandom random = new SplittableRandom(72);
        for (int k = 0; k < 2000; k++) {
            Placement way = Placement.NONE;
            for (int step = random.nextInt(1, 9); step > 0; step--) {
                Pose pose = Pose.of(point(random), random.nextDouble(360))
                        .turned(random.nextDouble(360), random.nextDouble(360));
                way = way.then(Placement.turned(pose.center(), pose.rotation()));
            }
            Point place = point(random);
            near(way.inverse().apply(way.apply(place)), place, 1e-12);
            near(way.then(way.inverse()).apply(place), place, 1e-12);
        }
    }

    private static void near(Point place, Point expected, double tolerance) {
        assertThat(place.x()).isCloseTo(expected.x(), within(tolerance));
        assertThat(place.y()).isCloseTo(expected.y(), within(tolerance));
        assertThat(place.z()).isCloseTo(expected.z(), within(tolerance));
    }
}
