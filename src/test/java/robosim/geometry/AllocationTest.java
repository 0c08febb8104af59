package robosim.geometry;

import static org.assertj.core.api.Assertions.assertThat;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;

/**
 * The calls of every simulated step allocate nothing of their own. From JDK 21 on StrictMath, which is written in Java
 * there, makes an array of two doubles a call: what asks for a sine is allowed that much.
 */
class AllocationTest {
    private static final int CALLS = 20_000;

    private final SplittableRandom random = new SplittableRandom(5);
    private final Geometry geometry = world();
    private final double[] out = new double[16];
    private double sum;

    private Geometry world() {
        Geometry made = new Geometry(100, 10, 100, Dimension.PLANAR, Accuracy.EXACT);
        for (int k = 0; k < 60; k++) {
            Point center = new Point(random.nextDouble(-45, 45), 0, random.nextDouble(-45, 45));
            made.addObject(new BoxObject(center, 3, 2, 1).turned(0, random.nextDouble(360)));
        }
        for (int k = 0; k < 5; k++) {
            Point center = new Point(random.nextDouble(-45, 45), 0, random.nextDouble(-45, 45));
            made.addObjectUnchecked(new CylinderObject(center, 0.5, 1).moveable("r" + k));
        }
        return made;
    }

    /** One byte a call, and on newer JDKs the arrays of so many sines and angles. */
    private static double nothingBut(int sines) {
        return Runtime.version().feature() < 21 ? 1 : 1 + 40 * sines;
    }

    /** Bytes a call, after the calls that warm it up. */
    private static double bytesPerCall(Runnable call) {
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        for (int k = 0; k < CALLS; k++) {
            call.run();
        }
        long before = threads.getCurrentThreadAllocatedBytes();
        for (int k = 0; k < CALLS; k++) {
            call.run();
        }
        return (threads.getCurrentThreadAllocatedBytes() - before) / (double) CALLS;
    }

    @Test
    void beamsAllocateNothing() {
        Ray ray = new Ray(new Point(1, 0, 2), new Point(3, 0, 1));
        assertThat(bytesPerCall(() -> sum += geometry.getRayDistance(ray, 0, 50, 0)))
                .isLessThan(1);
        assertThat(bytesPerCall(() -> sum += geometry.getSonarDistance("r1", 1, 0.5, 0, 50, 20)))
                .isLessThan(nothingBut(2));
        assertThat(bytesPerCall(() -> geometry.scan("r2", -80, 10, 0, 50, out))).isLessThan(nothingBut(2 * out.length));
    }

    @Test
    void movesAllocateNothing() {
        int[] made = new int[2];
        assertThat(bytesPerCall(() -> made[geometry.simpleMove("r3", 0.07, 0, 0.01) ? 1 : 0]++))
                .isLessThan(1);
        assertThat(bytesPerCall(() -> made[geometry.simpleTurn("r3", 13) ? 1 : 0]++))
                .isLessThan(nothingBut(12));
        assertThat(made[1]).as("moves made").isPositive();
    }
}
