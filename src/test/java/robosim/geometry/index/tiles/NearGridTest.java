package robosim.geometry.index.tiles;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.BitSet;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.index.QuadCursor;
import robosim.geometry.index.QuadTree;
import robosim.geometry.index.QuadTreeTest;

/** Objects that come, go and move, asked for in all ways in turn: a grid and tiles that lag behind, or either alone. */
class NearGridTest {
    private static final double WORLD = 500;
    private static final int OBJECTS = 200;

    private final QuadTree tree = new QuadTree(-WORLD, -WORLD, WORLD, WORLD);
    private final QuadCursor cursor = tree.cursor();
    private final double[][] boxes = new double[OBJECTS][];

    @ParameterizedTest
    @EnumSource
    void findsWhatTheListFinds(QuadTreeTest.Scene scene) {
        SplittableRandom random = new SplittableRandom(131 + scene.ordinal());
        int found = 0;
        int asked = 0;
        for (int step = 0; step < 6000; step++) {
            change(random.nextInt(OBJECTS), scene, random, step);
            double[] query = random.nextInt(3) == 0 ? beside(random) : scene.box(random);
            int but = random.nextInt(-1, OBJECTS);
            // Long spells of moves that only ask who is near, then of other questions among them.
            boolean isOnlyNear = step / 300 % 2 == 0;
            BitSet truth = meeting(query, but);
            int way = isOnlyNear ? 0 : random.nextInt(4);
            BitSet answer = way == 0 ? gathered(query, but) : asked(way, query, but);
            BitSet missed = (BitSet) truth.clone();
            missed.andNot(answer);
            assertThat(missed.isEmpty())
                    .as("step %d way %d box %s misses %s", step, way, Arrays.toString(query), missed)
                    .isTrue();
            found += truth.cardinality();
            asked += tree.size();
        }
        assertThat(found).isBetween(1, asked - 1);
    }

    private void change(int id, QuadTreeTest.Scene scene, SplittableRandom random, int step) {
        double[] box = boxes[id];
        int kind = random.nextInt(10);
        if (box == null) {
            box = scene.box(random);
            tree.add(id, box[0], box[1], box[2], box[3]);
        } else if (kind == 0 && step > OBJECTS) {
            tree.remove(id);
            box = null;
        } else {
            box = kind == 1 ? scene.box(random) : shifted(box, random.nextDouble(-5, 5), random.nextDouble(-5, 5));
            tree.move(id, new double[] {box[0], 0, box[1], box[2], 0, box[3]});
        }
        boxes[id] = box;
    }

    private static double[] shifted(double[] box, double x, double z) {
        return new double[] {box[0] + x, box[1] + z, box[2] + x, box[3] + z};
    }

    /** A box that just touches another, or just does not. */
    private double[] beside(SplittableRandom random) {
        double[] box = boxes[random.nextInt(OBJECTS)];
        if (box == null) {
            return new double[4];
        }
        double x = random.nextBoolean() ? box[2] : Math.nextUp(box[2]);
        double z = random.nextBoolean() ? box[1] : Math.nextDown(box[1]);
        return new double[] {x, z - 3, x + 3, z};
    }

    private BitSet meeting(double[] query, int but) {
        BitSet ids = new BitSet();
        for (int id = 0; id < OBJECTS; id++) {
            double[] b = boxes[id];
            if (b != null
                    && id != but
                    && b[0] <= query[2]
                    && query[0] <= b[2]
                    && b[1] <= query[3]
                    && query[1] <= b[3]) {
                ids.set(id);
            }
        }
        return ids;
    }

    private BitSet gathered(double[] query, int but) {
        BitSet ids = new BitSet();
        int count = cursor.gather(query[0], query[1], query[2], query[3], but, QuadTreeTest.outlines(cursor));
        for (int k = 0; k < count; k++) {
            assertThat(boxes[cursor.gathered(k)]).as("one that is gone").isNotNull();
            ids.set(cursor.gathered(k));
        }
        assertThat(ids.get(but < 0 ? OBJECTS : but)).isFalse();
        return ids;
    }

    private BitSet asked(int way, double[] query, int but) {
        BitSet ids = new BitSet();
        double reach = Math.hypot(query[2] - query[0], query[3] - query[1]);
        if (way == 1) {
            cursor.startBox(query[0], query[1], query[2], query[3]);
        } else if (way == 2) {
            cursor.startPoint(query[0], query[1]);
        } else {
            BitSet near = QuadTreeTest.near(cursor, QuadTreeTest.outlines(cursor), query);
            return near == null ? gathered(query, but) : near;
        }
        int id = next(way, reach);
        while (id >= 0) {
            ids.set(id);
            id = next(way, reach);
        }
        return ids;
    }

    private int next(int way, double reach) {
        return way == 1 ? cursor.next() : cursor.next(reach);
    }

    @Test
    void isFitForWhatIsOfOneSize() {
        SplittableRandom random = new SplittableRandom(7);
        double[] even = new double[6 * 500];
        double[] crowd = new double[6 * 500];
        double[] walls = new double[6 * 500];
        for (int at = 0; at < even.length; at += 6) {
            put(even, at, random.nextDouble(100), random.nextDouble(100), 1);
            put(crowd, at, random.nextDouble(1e-3), random.nextDouble(1e-3), 1e-6);
            put(walls, at, random.nextDouble(100), random.nextDouble(100), at % 120 == 0 ? 60 : 0.1);
        }
        put(crowd, 0, 1e6, 1e6, 1);
        assertThat(asked(grid(even), even).isUnfit()).isFalse();
        assertThat(asked(grid(crowd), crowd).isUnfit()).isTrue();
        assertThat(grid(walls).isUnfit()).isTrue();
    }

    private static void put(double[] boxes, int at, double x, double z, double size) {
        boxes[at] = x;
        boxes[at + 2] = z;
        boxes[at + 3] = x + size;
        boxes[at + 5] = z + size;
    }

    private static NearGrid grid(double[] boxes) {
        boolean[] listed = new boolean[500];
        Arrays.fill(listed, true);
        return new NearGrid(boxes, listed, 500);
    }

    private static NearGrid asked(NearGrid grid, double[] boxes) {
        TileGathering gathering = new TileGathering();
        for (int id = 0; id < 500; id++) {
            gathering.start(boxes[6 * id], boxes[6 * id + 2], boxes[6 * id + 3], boxes[6 * id + 5], id);
            gathering.gather(grid, boxes);
        }
        return grid;
    }
}
