package robosim.geometry.engine.sensing;

import java.util.Arrays;
import robosim.geometry.check.Checks;
import robosim.geometry.exact.Degrees;

/**
 * The directions of the rays of a scan in the sensor's own XZ plane. Those of the last scan are kept: a scanner
 * looks in the same directions again and again.
 */
final class ScanDirections {
    /** More rays than these are aimed anew each time. */
    private static final int MOST = 1 << 12;

    private double[] ways = new double[0];

    /** How many rays of this first direction and step are kept. */
    private int count;

    private double first;
    private double step;
    private double x;
    private double z;

    /** Aims at the direction of a ray of a scan: counter-clockwise seen from above, in degrees. */
    void aim(double firstDegrees, double stepDegrees, int ray) {
        if (firstDegrees != first || stepDegrees != step) {
            first = firstDegrees;
            step = stepDegrees;
            count = 0;
        }
        if (ray < count) {
            x = ways[2 * ray];
            z = ways[2 * ray + 1];
            return;
        }
        double degrees = Checks.angle("angle of the last ray", first + ray * step);
        x = Degrees.cos(degrees);
        z = -Degrees.sin(degrees);
        if (ray == count && count < MOST) {
            keep();
        }
    }

    private void keep() {
        if (2 * count == ways.length) {
            ways = Arrays.copyOf(ways, Math.max(16, 4 * count));
        }
        ways[2 * count] = x;
        ways[2 * count + 1] = z;
        count++;
    }

    /** How far the direction goes forward. */
    double x() {
        return x;
    }

    /** How far it goes to the right. */
    double z() {
        return z;
    }
}
