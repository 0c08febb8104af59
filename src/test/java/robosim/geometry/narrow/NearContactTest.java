package robosim.geometry.narrow;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigDecimal;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.Effort;
import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.distance.SpatialDistance;
import robosim.geometry.narrow.gjk.Gjk;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.mesh.NearestPairs;

/** Distances of pairs of every kind that are nearly in contact: brackets that hold, and are as narrow as they are said to be. */
class NearContactTest {
    private static final int PAIRS = Integer.getInteger("near.pairs", Effort.cases(400));

    private final Scratch scratch = new Scratch();
    private final NearestPairs nearest = new NearestPairs(scratch.overlap);
    private final LeafColumn columnA = new LeafColumn(1);
    private final LeafColumn columnB = new LeafColumn(1);

    /**
     * A slab is empty by exact arithmetic: so wide is the gap at least. The bracket is not below it, and no wider than
     * 2^-44 of the distance and the size, so that it is not far above either.
     */
    @Test
    void bracketsHoldAndClose() {
        bracketsHoldAndClose(Dimension.SPATIAL, 24);
    }

    @Test
    void bracketsOfProjectionsHoldAndClose() {
        bracketsHoldAndClose(Dimension.PLANAR, 26);
    }

    private void bracketsHoldAndClose(Dimension dimension, long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        NearPairs pairs = new NearPairs(random);
        Gjk gjk = new Gjk();
        int apart = 0;
        int count = 0;
        for (LeafKind kindA : NearPairs.KINDS) {
            for (LeafKind kindB : NearPairs.KINDS) {
                for (int n = 0; n < PAIRS; n++) {
                    pairs.make(kindA, kindB, pairs.gap());
                    measure(dimension, pairs);
                    double low = nearest.low();
                    double high = nearest.high();
                    String what = "%s: [%s, %s]".formatted(pairs, low, high);
                    count++;
                    assertThat(high - low).as(what).isBetween(0.0, 0x1p-44 * (high + pairs.size));
                    if (dimension == Dimension.PLANAR) {
                        gjk.planar(new Leaf(kindA, pairs.a, 0), new Leaf(kindB, pairs.b, 0));
                    } else {
                        gjk.spatial(new Leaf(kindA, pairs.a, 0), new Leaf(kindB, pairs.b, 0));
                    }
                    if (gjk.lower() > 0) {
                        apart++;
                        assertThat(nearest.touches()).as(what).isFalse();
                        assertThat(new BigDecimal(high)).as(what).isGreaterThanOrEqualTo(slab(pairs, gjk));
                    }
                }
            }
        }
        assertThat(apart).isBetween(count / 4, count * 98 / 100);
    }

    /** The least distance, as worlds ask it, is the bracket's, to what is said of each pair. */
    @Test
    void distancesAreWithinTheirBounds() {
        SplittableRandom random = new SplittableRandom(25);
        NearPairs pairs = new NearPairs(random);
        for (LeafKind kindA : NearPairs.KINDS) {
            for (LeafKind kindB : NearPairs.KINDS) {
                for (int n = 0; n < PAIRS; n++) {
                    pairs.make(kindA, kindB, pairs.gap());
                    measure(Dimension.SPATIAL, pairs);
                    double distance = SpatialDistance.between(
                            new Leaf(kindA, pairs.a, 0), new Leaf(kindB, pairs.b, 0), scratch.distance);
                    double bound = 0x1p-44 * (nearest.high() + pairs.size);
                    // Of what is flat all around the answer is not the lower end of a bracket but its middle.
                    double above = isFlat(kindA) && isFlat(kindB) ? bound : 0;
                    String what = "%s: %s of [%s, %s]".formatted(pairs, distance, nearest.low(), nearest.high());
                    assertThat(distance).as(what).isBetween(nearest.low() - bound, nearest.high() + above);
                }
            }
        }
    }

    private void measure(Dimension dimension, NearPairs pairs) {
        put(pairs.kindA, pairs.a, columnA);
        put(pairs.kindB, pairs.b, columnB);
        nearest.start(dimension, columnA, columnB);
        while (!nearest.isMeasured()) {
            nearest.step();
        }
        nearest.close();
    }

    private static void put(LeafKind kind, double[] row, LeafColumn column) {
        column.clear();
        column.append(1);
        column.setKind(0, kind);
        System.arraycopy(row, 0, column.rows(0), column.at(0), Leaf.STRIDE);
    }

    private static BigDecimal slab(NearPairs pairs, Gjk gjk) {
        BigDecimal[] n = CylinderTwin.decimals(gjk.nx(), gjk.ny(), gjk.nz());
        return new SupportTwin(pairs.kindA, pairs.a).gap(new SupportTwin(pairs.kindB, pairs.b), n);
    }

    private static boolean isFlat(LeafKind kind) {
        return kind == LeafKind.UPRIGHT_BOX || kind == LeafKind.BOX || kind == LeafKind.TRIANGLE;
    }
}
