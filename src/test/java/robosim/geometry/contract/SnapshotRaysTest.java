package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import robosim.geometry.Geometry;
import robosim.geometry.SenseBuffer;
import robosim.geometry.SenseBuffer.Extra;
import robosim.geometry.Snapshot;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;

/** Rays that begin anywhere, asked of a snapshot from many threads, as of the world. */
class SnapshotRaysTest {
    private static final int RAYS = 500;

    private final SplittableRandom random = new SplittableRandom(33);

    private double between(double from, double to) {
        return random.nextDouble(from, to);
    }

    private double[] rays() {
        double[] rays = new double[7 * RAYS];
        for (int k = 0; k < RAYS; k++) {
            for (int j = 0; j < 3; j++) {
                rays[7 * k + j] = between(-9, 9);
                rays[7 * k + 3 + j] = between(-1, 1);
            }
            rays[7 * k + 6] = k % 5 == 0 ? Double.POSITIVE_INFINITY : between(0, 15);
        }
        return rays;
    }

    @Test
    void snapshotsAnswerLikeTheirWorld() {
        Geometry world = new Geometry(40, 40, 40);
        for (int k = 0; k < 400; k++) {
            Point at = new Point(between(-9, 9), between(-9, 9), between(-9, 9));
            world.addObjectUnchecked(
                    k % 2 == 0
                            ? new BoxObject(at, 1, 1.5, 0.7).turned(0, between(-180, 180))
                            : new SphereObject(at, between(0.3, 1)));
        }
        world.addObjectUnchecked(new CylinderObject(new Point(), 2, 3).moveable("r"));
        Snapshot snapshot = world.snapshot();
        int[] hits = new int[1];
        double[][] all = IntStream.range(0, 12).mapToObj(k -> rays()).toArray(double[][]::new);
        SenseBuffer[] expected = new SenseBuffer[all.length];
        long[][][] free = new long[all.length][2][(RAYS + 63) / 64];
        int[][] counts = new int[all.length][2];
        for (int k = 0; k < all.length; k++) {
            expected[k] = new SenseBuffer(Extra.OBJECTS, Extra.NORMALS);
            world.castRays(all[k], RAYS, expected[k]);
            counts[k][0] = world.freeRays(all[k], RAYS, free[k][0]);
            counts[k][1] = world.freeRays(all[k], RAYS, "r", free[k][1]);
            hits[0] += RAYS - counts[k][0];
            assertThat(counts[k][1]).isGreaterThan(counts[k][0]);
        }
        assertThat(hits[0]).isBetween(all.length * RAYS / 5, all.length * RAYS * 4 / 5);
        IntStream.range(0, all.length).parallel().forEach(k -> {
            SenseBuffer out = new SenseBuffer(Extra.OBJECTS, Extra.NORMALS);
            long[] some = new long[(RAYS + 63) / 64];
            snapshot.castRays(all[k], RAYS, out);
            for (int ray = 0; ray < RAYS; ray++) {
                assertThat(out.distance(ray)).isEqualTo(expected[k].distance(ray));
                assertThat(out.object(ray)).isEqualTo(expected[k].object(ray));
                assertThat(out.normalX(ray)).isEqualTo(expected[k].normalX(ray));
            }
            assertThat(snapshot.freeRays(all[k], RAYS, some)).isEqualTo(counts[k][0]);
            assertThat(some).isEqualTo(free[k][0]);
            assertThat(snapshot.freeRays(all[k], RAYS, "r", some)).isEqualTo(counts[k][1]);
            assertThat(some).isEqualTo(free[k][1]);
        });
        assertThatThrownBy(() -> snapshot.freeRays(all[0], RAYS, "nobody", free[0][0]))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("nobody");
        assertThat(snapshot.freeRays(all[0], RAYS, free[0][0])).isEqualTo(counts[0][0]); // its copies are as before
    }
}
