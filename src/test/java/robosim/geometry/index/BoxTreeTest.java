package robosim.geometry.index;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Arrays;
import java.util.BitSet;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class BoxTreeTest {
    enum Scene {
        SPREAD,
        FLAT,
        ON_A_LATTICE,
        ONE_PLACE,
        HUGE_AMONG_TINY,
        HALVING,
        FEW;

        double[] boxes(SplittableRandom random) {
            int n = this == FEW ? random.nextInt(1, 8) : 500;
            double[] boxes = new double[6 * n];
            for (int item = 0; item < n; item++) {
                for (int axis = 0; axis < 3; axis++) {
                    double centre = switch (this) {
                        case ON_A_LATTICE -> random.nextInt(-10, 11) * 0.5;
                        case ONE_PLACE -> 5;
                        case HALVING -> StrictMath.scalb(1.0, -(item * 2));
                        case FLAT -> axis == 1 ? 2 : random.nextDouble(-10, 10);
                        default -> random.nextDouble(-10, 10);
                    };
                    double half = switch (this) {
                        case ON_A_LATTICE -> random.nextInt(3) * 0.25;
                        case HUGE_AMONG_TINY -> random.nextInt(20) == 0 ? 10 : 0x1p-9;
                        case HALVING -> 0;
                        case FLAT -> axis == 1 ? 0 : random.nextDouble(1);
                        default -> random.nextInt(6) == 0 ? 0 : random.nextDouble(1);
                    };
                    boxes[6 * item + axis] = centre - half;
                    boxes[6 * item + 3 + axis] = centre + half;
                }
            }
            return boxes;
        }
    }

    @ParameterizedTest
    @EnumSource
    void boxesFindWhatTheListFinds(Scene scene) {
        SplittableRandom random = new SplittableRandom(151 + scene.ordinal());
        int found = 0;
        int asked = 0;
        for (int trial = 0; trial < 12; trial++) {
            double[] boxes = scene.boxes(random);
            BoxTree tree = new BoxTree(boxes);
            BoxTree.Cursor cursor = tree.cursor();
            for (int i = 0; i < 40; i++) {
                double[] query = query(boxes, random);
                BitSet expected = new BitSet();
                for (int item = 0; item < tree.size(); item++) {
                    expected.set(item, meet(boxes, 6 * item, query));
                }
                BitSet items = new BitSet();
                cursor.startBox(query[0], query[1], query[2], query[3], query[4], query[5]);
                for (int item = cursor.next(); item >= 0; item = cursor.next()) {
                    assertThat(items.get(item)).as("once only").isFalse();
                    items.set(item);
                }
                assertThat(items).isEqualTo(expected);
                found += items.cardinality();
                asked += tree.size();
            }
        }
        assertThat(found).isBetween(40, asked * 9 / 10);
    }

    @ParameterizedTest
    @EnumSource
    void raysFindWhatTheListFinds(Scene scene) {
        SplittableRandom random = new SplittableRandom(171 + scene.ordinal());
        int hits = 0;
        int misses = 0;
        for (int trial = 0; trial < 6; trial++) {
            double[] boxes = scene.boxes(random);
            BoxTree tree = new BoxTree(boxes);
            BoxTree.Cursor cursor = tree.cursor();
            for (int i = 0; i < 40; i++) {
                // Small whole directions and quarters of a unit: box corners and borders are met exactly.
                int target = random.nextInt(tree.size());
                double[] direction = {random.nextInt(-2, 3), random.nextInt(-2, 3), random.nextInt(-2, 3)};
                if (direction[0] == 0 && direction[1] == 0 && direction[2] == 0) {
                    direction[random.nextInt(3)] = -1;
                }
                double back = random.nextInt(5);
                double[] from = new double[3];
                for (int axis = 0; axis < 3; axis++) {
                    from[axis] = boxes[6 * target + axis + 3 * random.nextInt(2)] - back * direction[axis];
                }
                BitSet items = new BitSet();
                double last = 0;
                double limit = random.nextBoolean() ? Double.POSITIVE_INFINITY : 6;
                cursor.startRay(from[0], from[1], from[2], direction[0], direction[1], direction[2], limit);
                for (int item = cursor.next(limit); item >= 0; item = cursor.next(limit)) {
                    assertThat(items.get(item)).as("once only").isFalse();
                    items.set(item);
                    assertThat(cursor.entry()).isBetween(last, limit);
                    last = cursor.entry();
                }
                for (int item = 0; item < tree.size(); item++) {
                    if (meetsExactly(from, direction, boxes, 6 * item, limit)) {
                        assertThat(items.get(item)).isTrue();
                        hits++;
                    } else if (!meetsExactly(from, direction, grown(boxes, item), 0, limit + 1e-12)) {
                        assertThat(items.get(item)).isFalse();
                        misses++;
                    }
                }
            }
        }
        assertThat(hits).isGreaterThan(50);
        assertThat(misses).isGreaterThan(50);
    }

    @ParameterizedTest
    @EnumSource
    void nodesHoldTheirPartsTightly(Scene scene) {
        double[] boxes = scene.boxes(new SplittableRandom(191));
        BoxTree tree = new BoxTree(boxes);
        int[] places = new int[tree.size()];
        for (int node = 0; node < tree.nodes(); node++) {
            double[] union = new double[6];
            Arrays.fill(union, 0, 3, Double.POSITIVE_INFINITY);
            Arrays.fill(union, 3, 6, Double.NEGATIVE_INFINITY);
            if (tree.isLeaf(node)) {
                assertThat(tree.count(node)).isBetween(1, BoxTree.LEAF);
                for (int place = tree.first(node); place < tree.first(node) + tree.count(node); place++) {
                    places[tree.item(place)]++;
                    grow(union, boxes, 6 * tree.item(place));
                    assertThat(Arrays.copyOfRange(tree.itemBounds(), 6 * place, 6 * place + 6))
                            .isEqualTo(Arrays.copyOfRange(boxes, 6 * tree.item(place), 6 * tree.item(place) + 6));
                }
            } else {
                assertThat(tree.count(node)).isZero();
                grow(union, tree.bounds(), 6 * tree.left(node));
                grow(union, tree.bounds(), 6 * tree.right(node));
            }
            assertThat(Arrays.copyOfRange(tree.bounds(), 6 * node, 6 * node + 6))
                    .isEqualTo(union);
        }
        assertThat(places).containsOnly(1);
        assertThat(depth(tree, tree.root())).isLessThanOrEqualTo(BoxTreeBuilder.MAX_DEPTH);
    }

    @Test
    void raysLookIntoFewNodes() {
        SplittableRandom random = new SplittableRandom(181);
        int n = 20_000;
        double[] boxes = new double[6 * n];
        for (int item = 0; item < n; item++) {
            for (int axis = 0; axis < 3; axis++) {
                boxes[6 * item + axis] = random.nextDouble(100);
                boxes[6 * item + 3 + axis] = boxes[6 * item + axis] + 1;
            }
        }
        BoxTree.Cursor cursor = new BoxTree(boxes).cursor();
        for (int i = 0; i < 1000; i++) {
            cursor.startRay(
                    random.nextDouble(100),
                    random.nextDouble(100),
                    random.nextDouble(100),
                    random.nextDouble(-1, 1),
                    random.nextDouble(-1, 1),
                    random.nextDouble(-1, 1),
                    Double.POSITIVE_INFINITY);
            cursor.next(Double.POSITIVE_INFINITY);
        }
        assertThat(cursor.visited() / 1000).isBetween(5L, 150L);
        BoxTree other = new BoxTree(new double[] {0, 0, 0, 1, 1, 1});
        cursor.over(other);
        assertThat(cursor.next()).isEqualTo(-1);
        cursor.startBox(1, 1, 1, 2, 2, 2);
        assertThat(cursor.next()).isZero();
        assertThat(cursor.next()).isEqualTo(-1);
    }

    @Test
    void refusesWhatItCannotHold() {
        assertThatThrownBy(() -> new BoxTree(new double[0])).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> new BoxTree(new double[7])).hasMessageContaining("got: 7");
        assertThatThrownBy(() -> new BoxTree(new double[] {0, 0, 0, 1, Double.NaN, 1}))
                .hasMessageContaining("got: NaN");
        assertThatThrownBy(() -> new BoxTree(new double[] {0, 2, 0, 1, 1, 1})).hasMessageContaining("box 0");
        BoxTree.Cursor cursor = new BoxTree(new double[6]).cursor();
        assertThatThrownBy(() -> cursor.startRay(0, 0, 0, 0, 0, 0, 1)).isInstanceOf(IllegalArgumentException.class);
    }

    private static double[] query(double[] boxes, SplittableRandom random) {
        int at = 6 * random.nextInt(boxes.length / 6);
        double[] query = new double[6];
        for (int axis = 0; axis < 3; axis++) {
            // Half of them touch a box at its very corner, or miss it by an ulp.
            double low = random.nextBoolean() ? boxes[at + 3 + axis] : random.nextDouble(-12, 12);
            query[axis] = random.nextInt(8) == 0 ? Math.nextUp(low) : low;
            query[axis + 3] = query[axis] + random.nextInt(3);
        }
        return query;
    }

    private static boolean meet(double[] boxes, int at, double[] query) {
        boolean meet = true;
        for (int axis = 0; axis < 3; axis++) {
            meet &= boxes[at + axis] <= query[axis + 3] && query[axis] <= boxes[at + 3 + axis];
        }
        return meet;
    }

    // Directions are whole and at most 2: dividing by them is exact, and so nearly is the rest, which the caller allows
    // for.
    private static boolean meetsExactly(double[] from, double[] direction, double[] boxes, int at, double limit) {
        double enter = 0;
        double leave = limit;
        for (int axis = 0; axis < 3; axis++) {
            double low = boxes[at + axis] - from[axis];
            double high = boxes[at + 3 + axis] - from[axis];
            if (direction[axis] == 0) {
                if (low > 0 || high < 0) {
                    return false;
                }
                continue;
            }
            boolean back = direction[axis] < 0;
            enter = Math.max(enter, (back ? high : low) / direction[axis]);
            leave = Math.min(leave, (back ? low : high) / direction[axis]);
        }
        return enter <= leave;
    }

    private static double[] grown(double[] boxes, int item) {
        double[] grown = Arrays.copyOfRange(boxes, 6 * item, 6 * item + 6);
        for (int i = 0; i < 6; i++) {
            grown[i] += i < 3 ? -1e-12 : 1e-12;
        }
        return grown;
    }

    private static void grow(double[] union, double[] by, int at) {
        for (int i = 0; i < 3; i++) {
            union[i] = Math.min(union[i], by[at + i]);
            union[i + 3] = Math.max(union[i + 3], by[at + i + 3]);
        }
    }

    private static int depth(BoxTree tree, int node) {
        return tree.isLeaf(node) ? 1 : 1 + Math.max(depth(tree, tree.left(node)), depth(tree, tree.right(node)));
    }
}
