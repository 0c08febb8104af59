package robosim.geometry.report.speed;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;
import robosim.geometry.reference.Gaps;
import robosim.geometry.report.speed.PairMaker.Family;
import robosim.geometry.report.speed.PairMaker.Pair;

class GapTest {
    private static double gap(GeometryObject a, GeometryObject b, Dimension dimension) {
        return Gap.truth(a, b, dimension).doubleValue();
    }

    @Test
    void gapsAndDepthsThatAreKnown() {
        BoxObject box = new BoxObject(new Point(), 2, 2, 2);
        CylinderObject disc = new CylinderObject(new Point(4, 0, 5), 1, 2);
        assertThat(gap(box, disc, Dimension.PLANAR))
                .as("3, 4, 5 from the corner")
                .isEqualTo(4);
        assertThat(gap(disc, box.movedTo(new Point(1.5, 0, 5)), Dimension.PLANAR))
                .isEqualTo(0.5);
        assertThat(gap(box, box.movedTo(new Point(1.5, 0, 0.25)), Dimension.PLANAR))
                .isEqualTo(-0.5);
        assertThat(gap(box, disc.movedTo(new Point(0.5, 0, 0)), Dimension.PLANAR))
                .as("inside")
                .isEqualTo(-1.5);
        assertThat(gap(box, disc.movedTo(new Point(0, 5, 0)), Dimension.SPATIAL))
                .isEqualTo(3);
        assertThat(gap(box, box.movedTo(new Point(5, 6, 2)), Dimension.SPATIAL)).isEqualTo(5);
        SphereObject ball = new SphereObject(new Point(), 1);
        assertThat(gap(ball, ball.movedTo(new Point(1, 2, 2)), Dimension.SPATIAL))
                .isEqualTo(1);
    }

    @Test
    void pairsAreAsFarApartAsAskedAndTheSignIsThatOfTheOracle() {
        for (Family family : Family.values()) {
            PairMaker maker = new PairMaker(family, new SplittableRandom(3));
            int collide = 0;
            for (int k = 0; k < 10; k++) {
                double asked = (k % 2 == 0 ? 1 : -1) * Math.pow(10, -k);
                Pair pair = maker.near(asked);
                String text = family + ": " + pair;
                boolean overlaps = Gaps.overlap(pair.a(), pair.b(), family.dimension);
                assertThat(overlaps).as(text).isEqualTo(pair.gap().signum() <= 0);
                collide += overlaps ? 1 : 0;
                if (family != Family.TURNED_TURNED && asked > -0.05) {
                    assertThat(pair.gap().doubleValue()).as(text).isCloseTo(asked, within(0.05 * Math.abs(asked)));
                }
            }
            assertThat(collide).as("%s that collide", family).isBetween(3, 7);
        }
    }

    @Test
    void pairsThatTouchDoSoToTheLastBit() {
        for (Family family : Family.values()) {
            PairMaker maker = new PairMaker(family, new SplittableRandom(4));
            int made = 0;
            for (int k = 0; k < 40; k++) {
                Pair pair = maker.touching();
                if (pair != null) {
                    made++;
                    assertThat(Gaps.overlap(pair.a(), pair.b(), family.dimension))
                            .isTrue();
                }
            }
            assertThat(made).as("%s that touch, of 40", family).isGreaterThan(4);
        }
    }
}
