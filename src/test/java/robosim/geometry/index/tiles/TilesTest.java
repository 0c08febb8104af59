package robosim.geometry.index.tiles;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.BitSet;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tiles with and without quantized bounds against a list of boxes. */
class TilesTest {
    private static final int COUNT = 400;
    private static final double SIDE = 40;

    private final SplittableRandom random = new SplittableRandom(3);
    private final double[] boxes = new double[6 * COUNT];
    private final double[] outlines = OrientedRectangle.rows(COUNT, 0);
    private final BitSet listed = new BitSet();

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void aProbeFindsWhatTheListFinds(boolean hasQuantizedBounds) {
        Tiles tiles = Tiles.over(0, 0, SIDE, SIDE, 300, new TileLists(hasQuantizedBounds));
        TileProbe probe = new TileProbe();
        int found = 0;
        int moved = 0;
        int halfWay = 0;
        for (int step = 0; step < 20_000; step++) {
            halfWay = step == 10_000 ? tiles.store.data.length : halfWay;
            moved += churn(tiles, random.nextInt(COUNT)) ? 1 : 0;
            if (step == 3000) {
                tiles.divideCrowded(boxes);
            }
            if (step % 8 == 0) {
                found += assertFinds(tiles, probe);
            }
        }
        assertThat(moved).isGreaterThan(4000);
        assertThat(found).isGreaterThan(1000);
        assertThat(tiles.objects()).isEqualTo(listed.cardinality());
        // Runs that are given up are used again.
        assertThat(tiles.store.data.length).isLessThanOrEqualTo(halfWay + (halfWay >> 3));
    }

    /** A long list of objects in one place is not read by those who ask elsewhere. */
    @Test
    void aListIsReadOnlyWhereItsObjectsAre() {
        Tiles tiles = Tiles.single();
        for (int id = 0; id < COUNT; id++) {
            box(id, 3 + id * 1e-6, 7);
            tiles.add(id, boxes, 6 * id);
        }
        assertThat(tiles.mayMeetAny(5, 7, 0.5, 0.5)).isFalse();
        assertThat(tiles.mayMeetAny(3, 5, 0.5, 0.5)).isFalse();
        assertThat(tiles.mayMeetAny(4.5, 7, 1, 0)).isTrue();
        double[] before = boxes.clone();
        box(5, 9, 7);
        tiles.move(5, before, 30, boxes, 30);
        assertThat(tiles.mayMeetAny(8.9, 7, 0.5, 0.5)).isTrue();
    }

    private void box(int id, double x, double z) {
        boxes[6 * id] = x - 0.5;
        boxes[6 * id + 2] = z - 0.5;
        boxes[6 * id + 3] = x + 0.5;
        boxes[6 * id + 5] = z + 0.5;
    }

    /** One comes, goes or moves, a little or anywhere; answers whether it moved. */
    private boolean churn(Tiles tiles, int id) {
        int at = 6 * id;
        if (!listed.get(id)) {
            place(id, false);
            tiles.add(id, boxes, at);
            listed.set(id);
        } else if (random.nextInt(3) == 0) {
            tiles.remove(id, boxes, at);
            listed.clear(id);
        } else {
            double[] before = boxes.clone();
            place(id, random.nextBoolean());
            tiles.move(id, before, at, boxes, at);
            return true;
        }
        return false;
    }

    private void place(int id, boolean isNear) {
        int at = 6 * id;
        // Half of them in a crowd, on lines between tiles many of them.
        double spread = id % 2 == 0 ? SIDE - 6 : 4;
        double x = isNear ? boxes[at] + random.nextDouble(-0.1, 0.1) : random.nextDouble(spread);
        double z = isNear ? boxes[at + 2] + random.nextDouble(-0.1, 0.1) : random.nextDouble(spread);
        boolean isRound = random.nextInt(3) == 0;
        boxes[at] = Math.max(0, isRound ? Math.rint(x) : x);
        boxes[at + 2] = Math.max(0, isRound ? Math.rint(z) : z);
        boxes[at + 3] = Math.min(SIDE, boxes[at] + (random.nextInt(20) == 0 ? 5 : random.nextInt(3) * 0.5));
        boxes[at + 5] = Math.min(SIDE, boxes[at + 2] + random.nextInt(3) * 0.5);
        OrientedRectangle.write(outlines, id, boxes[at], boxes[at + 2], boxes[at + 3], boxes[at + 5]);
    }

    private int assertFinds(Tiles tiles, TileProbe probe) {
        double x0 = random.nextInt(-2, 42) + (random.nextBoolean() ? 0 : random.nextDouble());
        double z0 = random.nextInt(-2, 42) + (random.nextBoolean() ? 0 : random.nextDouble());
        double x1 = x0 + random.nextInt(4) * 0.75;
        double z1 = z0 + random.nextInt(4) * 0.75;
        BitSet ids = new BitSet();
        probe.start((x0 + x1) / 2, (z0 + z1) / 2, (x1 - x0) / 2, (z1 - z0) / 2, SIDE);
        int asked = probe.query(tiles, Integer.MAX_VALUE, outlines, id -> {
            assertThat(listed.get(id)).isTrue();
            ids.set(id);
            return false;
        });
        assertThat(asked).isEqualTo(TileProbe.ALL);
        double steps = 3 / Math.min(tiles.stepsX, tiles.stepsZ);
        int found = 0;
        for (int id = listed.nextSetBit(0); id >= 0; id = listed.nextSetBit(id + 1)) {
            int at = 6 * id;
            double gapX = gap(boxes[at], boxes[at + 3], x0, x1);
            double gapZ = gap(boxes[at + 2], boxes[at + 5], z0, z1);
            assertThat(Math.max(gapX, gapZ) < steps || !ids.get(id))
                    .as("%d far from %s to %s, %s to %s", id, x0, x1, z0, z1)
                    .isTrue();
            if (boxes[at] <= x1 && x0 <= boxes[at + 3] && boxes[at + 2] <= z1 && z0 <= boxes[at + 5]) {
                assertThat(ids.get(id))
                        .as("%d near %s to %s, %s to %s", id, x0, x1, z0, z1)
                        .isTrue();
                found++;
            }
        }
        return found;
    }

    /** How far two ranges are apart, of which the second is cut at the ends of the world. */
    private static double gap(double min, double max, double low, double high) {
        return Math.max(min - Math.max(0, Math.min(high, SIDE)), Math.max(0, Math.min(low, SIDE)) - max);
    }

    /** The quantized bounds of boxes that meet may meet; those of boxes two steps apart may not. */
    @Test
    void quantizedBoundsTellBoxesApart() {
        int met = 0;
        int toldApart = 0;
        for (int k = 0; k < 100_000; k++) {
            int column = random.nextInt(-1, 5);
            int row = random.nextInt(-1, 5);
            double[] a = box(column, row);
            double[] b = box(column, row);
            boolean meet = a[0] <= b[2] && b[0] <= a[2] && a[1] <= b[3] && b[1] <= a[3];
            int question = QuantizedBounds.question(
                    QuantizedBounds.low(a[0]),
                    QuantizedBounds.low(a[1]),
                    QuantizedBounds.high(a[2]),
                    QuantizedBounds.high(a[3]),
                    column,
                    row);
            int quantized = QuantizedBounds.of(
                    QuantizedBounds.low(b[0]),
                    QuantizedBounds.low(b[1]),
                    QuantizedBounds.high(b[2]),
                    QuantizedBounds.high(b[3]),
                    column,
                    row);
            assertThat(QuantizedBounds.mayTouch(question, QuantizedBounds.ANYWHERE))
                    .isTrue();
            assertThat(QuantizedBounds.mayTouch(question, QuantizedBounds.NOWHERE))
                    .isFalse();
            boolean mayMeet = QuantizedBounds.mayTouch(question, quantized);
            boolean isOnTile = b[0] < column + 1 && column < b[2] && b[1] < row + 1 && row < b[3];
            if (meet && isOnTile) {
                assertThat(mayMeet).isTrue();
                met++;
            }
            double gap = Math.max(Math.max(a[0] - b[2], b[0] - a[2]), Math.max(a[1] - b[3], b[1] - a[3]));
            boolean isAbout = Math.min(a[0], b[0]) > column - 1.5
                    && Math.max(a[2], b[2]) < column + 2.5
                    && Math.min(a[1], b[1]) > row - 1.5
                    && Math.max(a[3], b[3]) < row + 2.5;
            if (isAbout && gap > 2.0 / 32) {
                assertThat(mayMeet).isFalse();
                toldApart++;
            }
        }
        assertThat(met).isGreaterThan(1000);
        assertThat(toldApart).isGreaterThan(3000);
    }

    @Test
    void questionsAboutOneTileAreTheSame() {
        for (int k = 0; k < 10_000; k++) {
            int column = random.nextInt(100);
            int row = random.nextInt(100);
            int lowX = 32 * column + random.nextInt(32);
            int lowZ = 32 * row + random.nextInt(32);
            int highX = random.nextInt(lowX, 32 * column + 32);
            int highZ = random.nextInt(lowZ, 32 * row + 32);
            assertThat(QuantizedBounds.question(lowX, lowZ, highX, highZ))
                    .isEqualTo(QuantizedBounds.question(lowX, lowZ, highX, highZ, column, row));
        }
    }

    /** In tiles, about one of them; sometimes far from it, and then as far as numbers go. */
    private double[] box(int column, int row) {
        double reach = random.nextInt(10) == 0 ? random.nextInt(3) == 0 ? 1e300 : 100 : 1.5;
        double x = column + random.nextDouble(-reach, reach);
        double z = row + random.nextDouble(-reach, reach);
        double width = random.nextInt(4) == 0 ? reach : random.nextDouble(0.5);
        return new double[] {x, z, x + width, z + random.nextDouble(0.5)};
    }
}
