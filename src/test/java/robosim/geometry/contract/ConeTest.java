package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import robosim.geometry.Geometry;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;

/** What a cone in space must not hear, and what it must. */
class ConeTest {
    private static final double INFINITE = Double.POSITIVE_INFINITY;

    /** The foot on the cap is outside the cone: the border that leans most towards the cap tells. */
    @Test
    void aCapOutsideTheConeIsNotHeard() {
        GeometryObject floor = new CylinderObject(new Point(0, -0.5, 0), 1, 1);
        double truth = 0.0625 / Math.sin(Math.PI / 4 - Math.asin(1 / Math.sqrt(3)));
        assertThat(heard(floor, new Point(0.5, 0.0625, 0), new Point(1, 1, 1), 90))
                .isCloseTo(truth, within(truth * 0x1p-40));
    }

    @Test
    void aMantleOutsideTheConeIsNotHeard() {
        GeometryObject bar = new CylinderObject(new Point(0, 0, 0), 0.1, 2);
        assertThat(heard(bar, new Point(0, -0.3, 0.11), new Point(-0.75, 0.5, 0.433), 90))
                .isCloseTo(0.05817, within(1e-5));
        assertThat(heard(bar.turned(90, 0), new Point(0.6, 0, -0.7), new Point(-0.837, -0.5, 0.224), 30))
                .isInfinite();
    }

    private static double heard(GeometryObject object, Point from, Point to, double width) {
        Geometry geometry = new Geometry(100, 100, 100);
        assertThat(geometry.addObjectUnchecked(object)).isTrue();
        return geometry.getRayDistance(new Ray(from, to), 0, INFINITE, width);
    }
}
