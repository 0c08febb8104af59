package robosim.geometry.index.hierarchy;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashSet;
import java.util.Set;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The objects that many rays visit together against a list of the same boxes, ray by ray. */
@Tag("slow")
class FrustumCursorTest {
    private static final int BOXES = 400;
    private static final double NARROW = 0.866;

    private final SplittableRandom random = new SplittableRandom(77);
    private final double[] boxes = new double[6 * BOXES];
    private final Hierarchy tree = new Hierarchy(() -> {});
    private final FrustumCursor cursor = new FrustumCursor();
    private final double[] x = new double[FrustumCursor.MOST];
    private final double[] y = new double[FrustumCursor.MOST];
    private final double[] z = new double[FrustumCursor.MOST];

    private void fill(double scale, double spread, boolean isOnGrid) {
        for (int id = 0; id < BOXES; id++) {
            for (int axis = 0; axis < 3; axis++) {
                double middle = random.nextDouble(-spread, spread);
                double half = random.nextDouble(1.5);
                double low = isOnGrid ? Math.rint(middle) : middle - half;
                double high = isOnGrid ? low + random.nextInt(3) : middle + half;
                boxes[6 * id + axis] = scale * low;
                boxes[6 * id + 3 + axis] = scale * high;
            }
            if (tree.contains(id)) {
                tree.remove(id);
            }
            tree.add(id, boxes);
        }
    }

    /** Unit vectors about one; the first so many count. */
    private int aim(double spread, boolean isOnGrid) {
        int count = random.nextInt(1, FrustumCursor.MOST + 1);
        double ax = isOnGrid ? random.nextInt(-1, 2) : random.nextDouble(-1, 1);
        double ay = isOnGrid ? random.nextInt(-1, 2) : random.nextDouble(-1, 1);
        double az = isOnGrid ? 1 : random.nextDouble(-1, 1);
        for (int k = 0; k < FrustumCursor.MOST; k++) {
            double dx = ax + spread * (isOnGrid ? k % 8 - 4 : random.nextDouble(-4, 4));
            double dy = ay + spread * (isOnGrid ? k / 8 - 4 : random.nextDouble(-4, 4));
            double dz = az + spread * (isOnGrid ? 0 : random.nextDouble(-4, 4));
            double length = Math.sqrt(dx * dx + dy * dy + dz * dz);
            x[k] = dx / length;
            y[k] = dy / length;
            z[k] = dz / length;
        }
        return count;
    }

    /** Where a ray enters a box, in doubles; infinite where it clearly misses. */
    private double enter(int id, double ox, double oy, double oz, int ray) {
        double[] from = {ox, oy, oz};
        double[] way = {x[ray], y[ray], z[ray]};
        double enter = 0;
        double leave = Double.POSITIVE_INFINITY;
        for (int axis = 0; axis < 3; axis++) {
            double low = boxes[6 * id + axis] - from[axis];
            double high = boxes[6 * id + 3 + axis] - from[axis];
            if (way[axis] == 0) {
                if (low > 0 || high < 0) {
                    return Double.POSITIVE_INFINITY;
                }
                continue;
            }
            double a = low / way[axis];
            double b = high / way[axis];
            enter = Math.max(enter, Math.min(a, b));
            leave = Math.min(leave, Math.max(a, b));
        }
        return enter <= leave ? enter : Double.POSITIVE_INFINITY;
    }

    @ParameterizedTest
    @CsvSource({"0, 20, false", "0, 8, true", "-70, 8, false", "70, 12, true", "0, 3, false"})
    void visitsWhatAnyRayMeets(int power, double spread, boolean isOnGrid) {
        double scale = Math.scalb(1.0, power);
        int met = 0;
        int visited = 0;
        int asked = 0;
        int wide = 0;
        for (int round = 0; round < 400; round++) {
            if (round % 20 == 0) {
                fill(scale, spread, isOnGrid);
            }
            int count = aim(random.nextInt(8) == 0 ? 1 : random.nextDouble(0.05), isOnGrid);
            if (!cursor.enclose(x, y, z, count, NARROW)) {
                wide++;
                assertThat(isWide(count)).isTrue();
                continue;
            }
            double ox = scale * (isOnGrid ? random.nextInt(-8, 8) : random.nextDouble(-spread, spread));
            double oy = scale * (isOnGrid ? random.nextInt(-8, 8) : random.nextDouble(-spread, spread));
            double oz = scale * (isOnGrid ? random.nextInt(-8, 8) : random.nextDouble(-spread, spread));
            double limit = round % 3 == 0 ? Double.POSITIVE_INFINITY : scale * random.nextDouble(2 * spread);
            cursor.aim(ox, oy, oz, tree.most());
            cursor.start(tree);
            Set<Integer> found = new HashSet<>();
            for (int id = cursor.next(limit); id >= 0; id = cursor.next(limit)) {
                assertThat(found.add(id)).as("once").isTrue();
            }
            asked++;
            visited += found.size();
            for (int id = 0; id < BOXES; id++) {
                for (int ray = 0; ray < count; ray++) {
                    if (enter(id, ox, oy, oz, ray) <= limit && enter(id, ox, oy, oz, ray) < Double.POSITIVE_INFINITY) {
                        met++;
                        assertThat(found).contains(id);
                        break;
                    }
                }
            }
        }
        assertThat(met).isGreaterThan(asked);
        assertThat(wide).isBetween(10, 100);
        if (Math.abs(power) < 60) {
            assertThat(visited).isBetween(met, 3 * met);
        } else { // beyond what floats can tell apart, all are visited
            assertThat(visited).isEqualTo(asked * BOXES);
        }
    }

    /** Whether a ray is clearly far from the middle, or there is none. */
    private boolean isWide(int count) {
        double ax = 0;
        double ay = 0;
        double az = 0;
        for (int k = 0; k < count; k++) {
            ax += x[k];
            ay += y[k];
            az += z[k];
        }
        double length = Math.sqrt(ax * ax + ay * ay + az * az);
        double least = 1;
        for (int k = 0; k < count; k++) {
            least = Math.min(least, (x[k] * ax + y[k] * ay + z[k] * az) / length);
        }
        return !(least > NARROW + 1e-9);
    }
}
