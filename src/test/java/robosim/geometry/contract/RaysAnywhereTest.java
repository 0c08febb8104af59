package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import org.junit.jupiter.api.Test;
import robosim.geometry.Geometry;
import robosim.geometry.SenseBuffer;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;

/** What batches of rays refuse, and that touching blocks; {@link WorldFuzz} compares their answers with those of single rays. */
class RaysAnywhereTest {
    @Test
    void touchingBlocks() {
        Geometry world = new Geometry(40, 40, 40);
        world.addObject(new BoxObject(new Point(5, 0, 0), 2, 2, 2));
        double[] rays = {
            0, 0, 0, 2, 0, 0, 4, 0, 0, 0, 2, 0, 0, Math.nextDown(4.0), 0, 1, 0, 1, 0, 0, 9, 5, 0, 0, 0, 1, 0, 0
        };
        long[] free = new long[1];
        assertThat(world.freeRays(rays, 4, free)).isEqualTo(1);
        assertThat(free[0]).isEqualTo(0b0010);
    }

    @Test
    void refusesWhatIsNoRay() {
        Geometry world = new Geometry(40, 40, 40);
        world.addObject(new SphereObject(new Point(), 1).moveable("r"));
        double[] good = {5, 0, 0, 1, 0, 0, 9};
        long[] free = new long[1];
        assertThat(world.freeRays(good, 0, free)).isZero();
        refused(good, 2, free, "count must be from 0 to 1, as rays has 7 numbers for each (got: 2)");
        refused(good, -1, free, "count must be from 0 to 1, as rays has 7 numbers for each (got: -1)");
        refused(good, 1, new long[0], "free must have at least 1 elements for 1 bits (got: 0)");
        refused(with(2, Double.NaN), 1, free, "rays[2] must be");
        refused(with(4, 0x1p101), 1, free, "rays[4] must be");
        refused(with(3, 0), 1, free, "direction of ray 0 must not be zero (got: (0.0, 0.0, 0.0))");
        refused(with(6, -1), 1, free, "range of ray 0 must be at least 0 (got: -1.0)");
        refused(with(6, Double.NaN), 1, free, "range of ray 0 must be at least 0 (got: NaN)");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> world.freeRays(good, 1, "nobody", free))
                .withMessageContaining("nobody");
        Geometry flat = new Geometry(40, 40, 40, Dimension.PLANAR, Accuracy.EXACT);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> flat.freeRays(new double[] {0, 0, 0, 0, 1, 0, 9}, 1, free))
                .withMessageContaining("must not be vertical");
    }

    private static double[] with(int place, double number) {
        double[] rays = {5, 0, 0, 1, 0, 0, 9};
        rays[place] = number;
        return rays;
    }

    private static void refused(double[] rays, int count, long[] free, String because) {
        Geometry world = new Geometry(40, 40, 40);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> world.freeRays(rays, count, free))
                .withMessageStartingWith(because);
        if (!because.startsWith("free")) {
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> world.castRays(rays, count, new SenseBuffer()))
                    .withMessageStartingWith(because);
        }
    }
}
