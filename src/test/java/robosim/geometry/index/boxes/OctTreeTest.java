package robosim.geometry.index.boxes;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;

class OctTreeTest {
    private static final int MOST = 3000;
    private static final double INFINITE = Double.POSITIVE_INFINITY;

    private final SplittableRandom random = new SplittableRandom(51);
    private final double[] boxes = new double[6 * MOST];
    private final OctTree tree = new OctTree(new double[] {-1, -1, -1, 1, 1, 1});
    private final OctTree.Cursor cursor = tree.cursor();
    private final SpaceKeys keys = new SpaceKeys();
    private final TreeSet<Integer> in = new TreeSet<>();
    private int coneLeftOut;

    /** Stacked on a few columns, at one place, and far outside of where the tree began. */
    private void change(int id) {
        if (in.remove(id)) {
            tree.remove(id, boxes);
            return;
        }
        double spread = id % 7 == 0 ? 500 : 20;
        for (int axis = 0; axis < 3; axis++) {
            double center = random.nextDouble(-spread, spread);
            if (axis != 1) {
                center = id % 3 == 0 ? Math.rint(center / 10) * 10 : id % 3 == 1 ? 5 : center;
            }
            double half = random.nextInt(5) == 0 ? 0 : random.nextDouble(1);
            boxes[6 * id + axis] = center - half;
            boxes[6 * id + 3 + axis] = center + half;
        }
        tree.add(id, boxes);
        in.add(id);
    }

    @Test
    void findsWhatAListFinds() {
        int found = 0;
        int asked = 0;
        for (int round = 0; round < 60; round++) {
            for (int k = 0; k < 80; k++) {
                change(random.nextInt(round < 50 ? MOST : 40));
            }
            for (int k = 0; k < 8; k++) {
                asked += 4 * in.size();
                found += box() + ray() + point() + cone();
            }
        }
        assertThat(found).isBetween(asked / 200, asked / 2);
        assertThat(coneLeftOut).isGreaterThan(1000);
    }

    @Test
    void emptiesAndFillsAgain() {
        for (int k = 0; k < 2; k++) {
            for (int id = 0; id < 200; id++) {
                change(id);
            }
            keys.startPoint(0, 0, 0);
            cursor.start(boxes, keys);
            assertThat(take(INFINITE)).hasSize(k == 0 ? 200 : 0);
        }
        change(3);
        keys.startPoint(0, 0, 0);
        cursor.start(boxes, keys);
        assertThat(take(INFINITE)).containsExactly(3);
    }

    /** Where centres lie on the borders of regions, and rounding moves these as the tree grows. */
    @Test
    void letsGoOfWhatStandsOnALattice() {
        for (int round = 0; round < 200; round++) {
            OctTree widened = new OctTree(new double[] {0, 0, 0, 0.2, 0.2, 0.2});
            for (int id = 0; id < 140; id++) {
                int most = id < 100 ? 100 : 900;
                for (int axis = 0; axis < 3; axis++) {
                    double center = 0.1 * random.nextInt(-most, most + 1);
                    boxes[6 * id + axis] = center - 0.1;
                    boxes[6 * id + 3 + axis] = center + 0.1;
                }
                widened.add(id, boxes);
            }
            OctTree.Cursor left = widened.cursor();
            for (int id = 0; id < 140; id++) {
                widened.remove(id, boxes);
                keys.startPoint(0, 0, 0);
                left.start(boxes, keys);
                int count = 0;
                for (int other = left.next(INFINITE); other >= 0; other = left.next(INFINITE)) {
                    assertThat(other).isGreaterThan(id);
                    count++;
                }
                assertThat(count).isEqualTo(139 - id);
            }
        }
    }

    private int box() {
        double[] box = new double[6];
        for (int axis = 0; axis < 3; axis++) {
            box[axis] = random.nextDouble(-25, 20);
            box[3 + axis] = box[axis] + random.nextDouble(12);
        }
        keys.startBox(box);
        cursor.start(boxes, keys);
        List<Integer> truth = new ArrayList<>();
        for (int id : in) {
            boolean meets = true;
            for (int axis = 0; axis < 3; axis++) {
                meets &= boxes[6 * id + axis] <= box[3 + axis] && box[axis] <= boxes[6 * id + 3 + axis];
            }
            if (meets) {
                truth.add(id);
            }
            assertThat(keys.key(boxes, 6 * id) == 0).isEqualTo(meets);
        }
        assertThat(take(0)).containsExactlyInAnyOrderElementsOf(truth);
        return truth.size();
    }

    private double[] direction() {
        double[] d = {random.nextDouble(-1, 1), random.nextInt(3) == 0 ? 0 : random.nextDouble(-1, 1), 1};
        double length = Math.sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
        return new double[] {d[0] / length, d[1] / length, d[2] / length};
    }

    /** Points along the ray are in no box that is left out. */
    private int ray() {
        double[] d = direction();
        double[] o = {5, random.nextDouble(-20, 20), random.nextDouble(-30, 0)};
        double limit = random.nextDouble(60);
        keys.startRay(o[0], o[1], o[2], d[0], d[1], d[2]);
        cursor.start(boxes, keys);
        List<Integer> taken = take(limit);
        for (int id : in) {
            if (!taken.contains(id)) {
                for (int k = 0; k <= 200; k++) {
                    double t = limit * k / 200;
                    assertThat(isIn(id, o[0] + t * d[0], o[1] + t * d[1], o[2] + t * d[2]))
                            .isFalse();
                }
            }
        }
        return taken.size();
    }

    private boolean isIn(int id, double x, double y, double z) {
        double[] p = {x, y, z};
        for (int axis = 0; axis < 3; axis++) {
            if (!(boxes[6 * id + axis] + 1e-9 < p[axis] && p[axis] < boxes[6 * id + 3 + axis] - 1e-9)) {
                return false;
            }
        }
        return true;
    }

    private int point() {
        double[] p = {random.nextDouble(-20, 20), random.nextDouble(-20, 20), random.nextDouble(-20, 20)};
        double limit = random.nextDouble(15);
        keys.startPoint(p[0], p[1], p[2]);
        cursor.start(boxes, keys);
        List<Integer> taken = take(limit);
        for (int id : in) {
            double distance = distance(id, p);
            if (distance < limit * (1 - 1e-12)) {
                assertThat(taken).contains(id);
            } else if (distance > limit * (1 + 1e-12)) {
                assertThat(taken).doesNotContain(id);
            }
        }
        return taken.size();
    }

    private double distance(int id, double[] p) {
        double square = 0;
        for (int axis = 0; axis < 3; axis++) {
            double d = Math.max(0, Math.max(boxes[6 * id + axis] - p[axis], p[axis] - boxes[6 * id + 3 + axis]));
            square += d * d;
        }
        return Math.sqrt(square);
    }

    /** Points of a box that is left out are not in the cone. */
    private int cone() {
        double[] d = direction();
        double half = random.nextDouble(1, 89);
        double limit = random.nextDouble(40);
        double[] o = {5, random.nextDouble(-20, 20), 5};
        double cos = StrictMath.cos(StrictMath.toRadians(half));
        double sin = StrictMath.sin(StrictMath.toRadians(half));
        keys.startCone(o[0], o[1], o[2], d[0], d[1], d[2], cos, sin);
        cursor.start(boxes, keys);
        List<Integer> taken = take(limit);
        int leftOut = 0;
        for (int id : in) {
            if (!taken.contains(id) && distance(id, o) < limit * (1 - 1e-12)) {
                leftOut++;
                for (int k = 0; k < 20; k++) {
                    double[] p = new double[3];
                    double ahead = 0;
                    double square = 0;
                    for (int axis = 0; axis < 3; axis++) {
                        double share = random.nextInt(3) / 2.0;
                        p[axis] = boxes[6 * id + axis] * (1 - share) + boxes[6 * id + 3 + axis] * share - o[axis];
                        ahead += p[axis] * d[axis];
                        square += p[axis] * p[axis];
                    }
                    assertThat(ahead >= cos * Math.sqrt(square) * (1 + 1e-9)).isFalse();
                }
            }
        }
        coneLeftOut += leftOut;
        return taken.size();
    }

    private List<Integer> take(double limit) {
        List<Integer> taken = new ArrayList<>();
        for (int id = cursor.next(limit); id >= 0; id = cursor.next(limit)) {
            taken.add(id);
        }
        assertThat(taken).doesNotHaveDuplicates();
        return taken;
    }

    @Test
    void aStackIsAskedAtTheHeightOfTheBox() {
        for (int id = 0; id < 1000; id++) {
            for (int axis = 0; axis < 3; axis++) {
                boxes[6 * id + axis] = axis == 1 ? id : 0;
                boxes[6 * id + 3 + axis] = axis == 1 ? id + 0.5 : 2;
            }
            tree.add(id, boxes);
        }
        long before = cursor.visited();
        keys.startBox(new double[] {0, 700.2, 0, 1, 700.4, 1});
        cursor.start(boxes, keys);
        assertThat(take(0)).containsExactly(700);
        assertThat(cursor.visited() - before).isLessThan(20);
    }
}
