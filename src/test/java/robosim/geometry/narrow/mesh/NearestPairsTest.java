package robosim.geometry.narrow.mesh;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import robosim.geometry.Allocated;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.leaf.LocalLeaves;
import robosim.geometry.narrow.overlap.SpatialOverlap;

class NearestPairsTest {

    /** So many triangles in a cube about the origin, each of about a third of its side. */
    private static MeshObject crowd(int count, long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        List<Point> corners = new ArrayList<>();
        int[][] faces = new int[count][];
        for (int k = 0; k < count; k++) {
            double x = random.nextDouble(-1, 1);
            double y = random.nextDouble(-1, 1);
            double z = random.nextDouble(-1, 1);
            for (int corner = 0; corner < 3; corner++) {
                corners.add(new Point(
                        x + random.nextDouble(-0.3, 0.3),
                        y + random.nextDouble(-0.3, 0.3),
                        z + random.nextDouble(-0.3, 0.3)));
            }
            faces[k] = new int[] {3 * k, 3 * k + 1, 3 * k + 2};
        }
        return new MeshObject(corners, faces);
    }

    private static long steps(NearestPairs pairs, LeafColumn a, LeafColumn b) {
        pairs.start(Dimension.SPATIAL, a, b);
        while (!pairs.isMeasured()) {
            pairs.step();
        }
        return pairs.steps();
    }

    @Test
    void stepsAllocateNothingOnceTheQueueHasGrown() {
        LeafColumn a = LocalLeaves.placed(crowd(500, 1).turned(10, 20));
        LeafColumn b = LocalLeaves.placed(crowd(500, 2).movedTo(new Point(2.9, 0.2, 0.1)));
        NearestPairs pairs = new NearestPairs(new Scratch().overlap);
        long steps = steps(pairs, a, b);
        assertThat(pairs.touches()).isFalse();
        assertThat(steps).isGreaterThan(100);
        assertThat(Allocated.everyTime(() -> steps(pairs, a, b))).isLessThan(steps);
    }

    @Test
    void findingContactsAllocatesNothingOnceThereIsRoom() {
        LeafColumn a = LocalLeaves.placed(crowd(500, 3).turned(10, 20));
        LeafColumn b = LocalLeaves.placed(crowd(500, 4).movedTo(new Point(1, 0.2, 0.1)));
        ContactPairs pairs = new ContactPairs(new Scratch().distance);
        pairs.find(Dimension.SPATIAL, a, b, Integer.MAX_VALUE);
        assertThat(pairs.count()).isGreaterThan(50);
        assertThat(Allocated.everyTime(() -> pairs.find(Dimension.SPATIAL, a, b, Integer.MAX_VALUE)))
                .isLessThan(pairs.count());
    }

    @Test
    void contactsAreThoseThatAllPairsGive() {
        MeshObject first = crowd(150, 5).turned(30, 40);
        MeshObject second = crowd(150, 6).movedTo(new Point(0.5, 0.2, 0.1));
        LeafColumn a = LocalLeaves.placed(first);
        LeafColumn b = LocalLeaves.placed(second);
        ContactPairs pairs = new ContactPairs(new Scratch().distance);
        pairs.find(Dimension.SPATIAL, a, b, Integer.MAX_VALUE);
        List<String> found = new ArrayList<>();
        for (int k = 0; k < pairs.count(); k++) {
            found.add(pairs.faceA(k) + " " + pairs.faceB(k));
        }
        List<String> truth = new ArrayList<>();
        Scratch scratch = new Scratch();
        double[] p = new double[Leaf.STRIDE];
        double[] q = new double[Leaf.STRIDE];
        for (int t = 0; t < 150; t++) {
            for (int u = 0; u < 150; u++) {
                scratch.leaf.outer.open(a, 0);
                scratch.leaf.outer.corners(t, p, 0);
                scratch.leaf.inner.open(b, 0);
                scratch.leaf.inner.corners(u, q, 0);
                if (SpatialOverlap.test(
                        new Leaf(LeafKind.TRIANGLE, p, 0), new Leaf(LeafKind.TRIANGLE, q, 0), scratch.overlap)) {
                    truth.add(scratch.leaf.outer.triangle(t) + " " + scratch.leaf.inner.triangle(u));
                }
            }
        }
        assertThat(found).containsExactlyInAnyOrderElementsOf(truth);
        assertThat(truth).hasSizeBetween(10, 1000);
    }

    @Test
    void theQueueGivesTheLeastKeyAndOfEqualsTheLatest() {
        PairQueue queue = new PairQueue();
        SplittableRandom random = new SplittableRandom(7);
        TreeMap<Double, List<Long>> twin = new TreeMap<>();
        long turn = 0;
        for (int k = 0; k < 5000; k++) {
            if (twin.isEmpty() || random.nextInt(5) < 3) {
                double key = random.nextInt(20);
                queue.push(key, turn, -turn, (int) turn);
                twin.computeIfAbsent(key, x -> new ArrayList<>()).add(turn++);
                continue;
            }
            assertThat(queue.leastKey()).isEqualTo(twin.firstKey());
            List<Long> latest = twin.firstEntry().getValue();
            long expected = latest.remove(latest.size() - 1);
            if (latest.isEmpty()) {
                twin.remove(twin.firstKey());
            }
            queue.take();
            assertThat(queue.first).isEqualTo(expected);
            assertThat(queue.second).isEqualTo(-expected);
            assertThat(queue.task).isEqualTo((int) expected);
        }
        queue.clear();
        assertThat(queue.leastKey()).isEqualTo(Double.POSITIVE_INFINITY);
    }
}
