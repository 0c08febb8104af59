package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.util.BitSet;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import robosim.geometry.Geometry;
import robosim.geometry.RayHit;
import robosim.geometry.SenseBuffer;
import robosim.geometry.SenseBuffer.Extra;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;
import robosim.geometry.model.SphereObject;

/** Batches of rays answer to the bit as {@code castRay} does one by one. */
class RaysAnywhereTest {
    private static final double SIZE = 64;

    private final SplittableRandom random = new SplittableRandom(20);

    private Geometry filled(Dimension dimension, Accuracy accuracy, int count, double spread, double rise, int oneIn) {
        Geometry world = new Geometry(SIZE, SIZE, SIZE, dimension, accuracy);
        RandomObjects objects = new RandomObjects(random, spread, rise);
        for (int k = 0; k < count; k++) {
            GeometryObject object = objects.next();
            String name = "object " + k;
            boolean moves = random.nextInt(oneIn) == 0;
            world.addObjectUnchecked(moves ? object.moveable(name) : object.named(name));
        }
        Script.run(world, 100, random.nextLong(), spread, rise); // off their first places
        return world;
    }

    private double[] rays(RandomObjects objects, int count) {
        double[] rays = new double[7 * count];
        for (int k = 0; k < count; k++) {
            Point start = objects.place();
            Point way = objects.direction();
            double range = k % 4 == 0 ? Double.POSITIVE_INFINITY : k % 5 == 0 ? 0 : random.nextDouble(8);
            if (k % 9 == 0) { // to a place, as a shadow is asked
                Point to = objects.place();
                way = new Point(to.x() - start.x(), to.y() - start.y(), to.z() - start.z() + 1e-9);
            }
            double[] numbers = {start.x(), start.y(), start.z(), way.x(), way.y(), way.z(), range};
            System.arraycopy(numbers, 0, rays, 7 * k, 7);
        }
        return rays;
    }

    private static Ray ray(double[] rays, int k) {
        int at = 7 * k;
        return new Ray(
                new Point(rays[at], rays[at + 1], rays[at + 2]), new Point(rays[at + 3], rays[at + 4], rays[at + 5]));
    }

    @ParameterizedTest
    @CsvSource({
        "PLANAR, EXACT, 300, 14, 0.25, 40",
        "SPATIAL, EXACT, 300, 10, 0.25, 40",
        "PLANAR, EXACT, 200, 10, 0.25, 4",
        "SPATIAL, EXACT, 200, 9, 0.25, 4",
        "SPATIAL, EXACT, 250, 3, 4, 12",
        "SPATIAL, EXACT, 20, 3, 2, 2",
        "PLANAR, DOP, 80, 18, 0.1, 4",
        "SPATIAL, OBB, 80, 12, 0.25, 12",
        "SPATIAL, SPHERE, 60, 12, 0.25, 4"
    })
    void asOneByOne(Dimension dimension, Accuracy accuracy, int count, double spread, double rise, int oneIn) {
        Geometry world = filled(dimension, accuracy, count, spread, rise, oneIn);
        Geometry copy = world.snapshot().toGeometry();
        RandomObjects objects = new RandomObjects(random, spread, rise);
        SenseBuffer out = new SenseBuffer(Extra.OBJECTS, Extra.NORMALS);
        SenseBuffer plain = new SenseBuffer();
        int hits = 0;
        int all = 0;
        for (int round = 0; round < 12; round++) {
            int some = 1 + random.nextInt(200);
            double[] rays = rays(objects, some + 3);
            long[] free = new long[5];
            free[4] = -1;
            long[] ofCopy = new long[4];
            String ignored = "object " + random.nextInt(count);
            Geometry without = world.snapshot().toGeometry();
            without.removeObject(ignored);
            long[] others = new long[4];
            long[] ignoring = new long[4];
            int found = world.freeRays(rays, some, free);
            assertThat(copy.freeRays(rays, some, ofCopy)).isEqualTo(found);
            assertThat(world.freeRays(rays, some, ignored, ignoring)).isEqualTo(without.freeRays(rays, some, others));
            assertThat(ignoring).isEqualTo(others);
            assertThat(BitSet.valueOf(new long[] {free[0], free[1], free[2], free[3]}))
                    .isEqualTo(BitSet.valueOf(ofCopy));
            assertThat(free[4]).isEqualTo(-1); // not its own
            world.castRays(rays, some, out);
            copy.castRays(rays, some, plain);
            assertThat(out.size()).isEqualTo(some);
            for (int k = 0; k < some; k++) {
                RayHit hit = world.castRay(ray(rays, k), rays[7 * k + 6]);
                all++;
                hits += hit == null ? 0 : 1;
                assertThat((free[k / 64] >> k & 1) == 1)
                        .as("%s to %s", ray(rays, k), rays[7 * k + 6])
                        .isEqualTo(hit == null);
                found -= (int) (free[k / 64] >> k & 1);
                assertThat(out.distance(k)).isEqualTo(hit == null ? Double.POSITIVE_INFINITY : hit.distance());
                assertThat(plain.distance(k)).isEqualTo(out.distance(k));
                GeometryObject met = out.object(k);
                if (hit == null) {
                    assertThat(met).isNull();
                    assertThat(out.normalX(k)).isEqualTo(0);
                } else {
                    assertThat(met).isNotNull();
                    assertThat(met.name()).isEqualTo(hit.object().name());
                    assertThat(new Point(out.normalX(k), out.normalY(k), out.normalZ(k)))
                            .isEqualTo(hit.normal());
                }
            }
            assertThat(found).isZero();
        }
        assertThat(hits).isBetween(all / 10, all * 9 / 10);
    }

    @Test
    void touchingBlocks() {
        Geometry world = new Geometry(40, 40, 40);
        world.addObject(new BoxObject(new Point(5, 0, 0), 2, 2, 2));
        double[] rays = {
            0, 0, 0, 2, 0, 0, 4, 0, 0, 0, 2, 0, 0, Math.nextDown(4.0), 0, 1, 0, 1, 0, 0, 9, 5, 0, 0, 0, 1, 0, 0
        };
        long[] free = new long[1];
        assertThat(world.freeRays(rays, 4, free)).isEqualTo(1);
        assertThat(free[0]).isEqualTo(0b0010);
    }

    @Test
    void refusesWhatIsNoRay() {
        Geometry world = new Geometry(40, 40, 40);
        world.addObject(new SphereObject(new Point(), 1).moveable("r"));
        double[] good = {5, 0, 0, 1, 0, 0, 9};
        long[] free = new long[1];
        assertThat(world.freeRays(good, 0, free)).isZero();
        refused(good, 2, free, "count must be from 0 to 1, as rays has 7 numbers for each (got: 2)");
        refused(good, -1, free, "count must be from 0 to 1, as rays has 7 numbers for each (got: -1)");
        refused(good, 1, new long[0], "free must have at least 1 elements for 1 bits (got: 0)");
        refused(with(2, Double.NaN), 1, free, "rays[2] must be");
        refused(with(4, 0x1p101), 1, free, "rays[4] must be");
        refused(with(3, 0), 1, free, "direction of ray 0 must not be zero (got: (0.0, 0.0, 0.0))");
        refused(with(6, -1), 1, free, "range of ray 0 must be at least 0 (got: -1.0)");
        refused(with(6, Double.NaN), 1, free, "range of ray 0 must be at least 0 (got: NaN)");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> world.freeRays(good, 1, "nobody", free))
                .withMessageContaining("nobody");
        Geometry flat = new Geometry(40, 40, 40, Dimension.PLANAR, Accuracy.EXACT);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> flat.freeRays(new double[] {0, 0, 0, 0, 1, 0, 9}, 1, free))
                .withMessageContaining("must not be vertical");
    }

    private static double[] with(int place, double number) {
        double[] rays = {5, 0, 0, 1, 0, 0, 9};
        rays[place] = number;
        return rays;
    }

    private static void refused(double[] rays, int count, long[] free, String because) {
        Geometry world = new Geometry(40, 40, 40);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> world.freeRays(rays, count, free))
                .withMessageStartingWith(because);
        if (!because.startsWith("free")) {
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> world.castRays(rays, count, new SenseBuffer()))
                    .withMessageStartingWith(because);
        }
    }
}
