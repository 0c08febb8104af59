package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.function.Supplier;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.Effort;
import robosim.geometry.Geometry;
import robosim.geometry.NearObject;
import robosim.geometry.RayHit;
import robosim.geometry.SenseBuffer;
import robosim.geometry.SenseBuffer.Extra;
import robosim.geometry.Snapshot;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.Ray;
import robosim.geometry.model.RayPattern;
import robosim.geometry.model.SenseOptions;
import robosim.geometry.model.SphereObject;

/**
 * Rays that start within a few ulp of a surface. No distance is negative, not even -0.0; every entry point returns the bits of
 * {@code getRayDistance}; and of two objects that contain the start, the one added first is named.
 */
class RaysFromSurfacesTest {
    private static final double FAR = Double.POSITIVE_INFINITY;
    private static final int RAYS = 9;

    private final SplittableRandom random = new SplittableRandom(360701);
    private final RandomObjects objects = new RandomObjects(random, 3);
    private final SenseBuffer batch = new SenseBuffer(Extra.OBJECTS);
    private final SenseBuffer sensed = new SenseBuffer(Extra.OBJECTS);
    private int inside;
    private int outside;
    private int missed;

    @ParameterizedTest
    @EnumSource(Dimension.class)
    void noDistanceIsNegativeAndTheFirstObjectIsNamed(Dimension dimension) {
        Map<GeometryObject.Kind, Integer> starts = new EnumMap<>(GeometryObject.Kind.class);
        int cases = Effort.cases(3_000, 700);
        for (int k = 0; k < cases; k++) {
            GeometryObject object = object(k);
            Accuracy accuracy = k % 8 < 6 ? Accuracy.EXACT : Accuracy.values()[random.nextInt(4)];
            Geometry alone = world(dimension, accuracy, List.of(object));
            Point start = nearSurface(alone, object);
            if (start == null) {
                continue;
            }
            starts.merge(object.kind(), 1, Integer::sum);
            Geometry two = world(dimension, accuracy, List.of(new SphereObject(start, 0.05).moveable("first"), object));
            double[] directions = directions(object, start);
            one(alone, start, directions, false);
            one(two, start, directions, true);
            if (k % 4 == 0) {
                others(alone, start, false);
                others(two, start, true);
            }
        }
        assertThat(starts).hasSize(GeometryObject.Kind.values().length);
        assertThat(starts.values()).allSatisfy(count -> assertThat(count).isGreaterThan(cases / 50));
        assertThat(inside).isGreaterThan(2 * cases);
        assertThat(outside).isGreaterThan(cases / 10);
        assertThat(missed).isGreaterThan(cases / 2);
    }

    private GeometryObject object(int k) {
        if (k % 8 == 7) {
            BitSet cells = BitSet.valueOf(new long[] {1 << 5 | random.nextLong() & 0xFFF});
            return new GridObject(objects.place(), 0.37, 1 + random.nextDouble(), 4, 3, cells)
                    .turned(0, objects.heading());
        }
        return k % 2 == 0 ? objects.upright() : objects.next();
    }

    private static Geometry world(Dimension dimension, Accuracy accuracy, List<GeometryObject> things) {
        Geometry world = new Geometry(100, 100, 100, dimension, accuracy);
        for (GeometryObject thing : things) {
            assertThat(world.addObjectUnchecked(thing)).isTrue();
        }
        return world;
    }

    /** A place on the object's surface, at most two ulp off in each coordinate; null if a ray missed it. */
    private Point nearSurface(Geometry alone, GeometryObject object) {
        Point from = new Point(random.nextDouble(-9, 9), random.nextDouble(-2, 2), random.nextDouble(-9, 9));
        Point c = object.center();
        Point way = new Point(
                c.x() - from.x() + random.nextDouble(-0.4, 0.4),
                c.y() - from.y() + random.nextDouble(-0.4, 0.4),
                c.z() - from.z() + random.nextDouble(-0.4, 0.4));
        if (random.nextInt(4) == 0) {
            way = random.nextBoolean() ? new Point(way.x(), 0, 0) : new Point(0, 0, way.z());
            from = new Point(way.x() == 0 ? c.x() : from.x(), c.y(), way.z() == 0 ? c.z() : from.z());
        }
        RayHit hit = alone.castRay(new Ray(from, way), FAR);
        return hit == null
                ? null
                : new Point(
                        off(hit.point().x()),
                        off(hit.point().y()),
                        off(hit.point().z()));
    }

    private double off(double number) {
        int ulps = random.nextInt(-2, 3);
        return random.nextBoolean() ? number : number + ulps * Math.ulp(number);
    }

    private double[] directions(GeometryObject object, Point start) {
        List<Point> all = new ArrayList<>();
        double[] r = object.rotation();
        for (int k = 0; k < RAYS; k++) {
            double sign = random.nextBoolean() ? 1 : -1;
            int axis = random.nextBoolean() ? 0 : 2;
            all.add(
                    switch (k % 3) {
                        case 0 -> objects.direction();
                        case 1 -> new Point(sign * r[axis], 0, sign * r[axis + 6]);
                        default ->
                            new Point(
                                    object.center().x() - start.x() + 1e-3,
                                    object.center().y() - start.y(),
                                    object.center().z() - start.z() + random.nextDouble(-0.1, 0.1));
                    });
        }
        double[] out = new double[3 * RAYS];
        for (int k = 0; k < RAYS; k++) {
            Point way = all.get(k).x() == 0 && all.get(k).z() == 0 ? new Point(1, 0, 0) : all.get(k);
            out[3 * k] = way.x();
            out[3 * k + 1] = way.y();
            out[3 * k + 2] = way.z();
        }
        return out;
    }

    /** The rays from one start, with all ways to ask. */
    private void one(Geometry world, Point start, double[] directions, boolean isFirstAround) {
        double[] rays = new double[7 * RAYS];
        for (int k = 0; k < RAYS; k++) {
            rays[7 * k] = start.x();
            rays[7 * k + 1] = start.y();
            rays[7 * k + 2] = start.z();
            System.arraycopy(directions, 3 * k, rays, 7 * k + 3, 3);
            rays[7 * k + 6] = FAR;
        }
        Pose pose = Pose.of(start, 0);
        SenseOptions options = SenseOptions.range(0, FAR);
        double[] sensedWays = directions.clone();
        for (int k = 1; world.dimension() == Dimension.PLANAR && k < sensedWays.length; k += 3) {
            sensedWays[k] = 0; // a pattern that looks up or down sees heights
        }
        RayPattern pattern = RayPattern.of(sensedWays);
        world.castRays(rays, RAYS, batch);
        world.sense(pose, pattern, options, sensed);
        Snapshot snapshot = world.snapshot();
        SenseBuffer batchOfSnapshot = new SenseBuffer(Extra.OBJECTS);
        SenseBuffer sensedBySnapshot = new SenseBuffer(Extra.OBJECTS);
        snapshot.castRays(rays, RAYS, batchOfSnapshot);
        snapshot.sense(pose, pattern, options, sensedBySnapshot);
        for (int k = 0; k < RAYS; k++) {
            Ray ray = new Ray(start, new Point(directions[3 * k], directions[3 * k + 1], directions[3 * k + 2]));
            double truth = world.getRayDistance(ray, 0, FAR, 0);
            double range = world.getRayDistance(ray, 0, 1, 0);
            RayHit hit = world.castRay(ray, FAR);
            Supplier<String> what = () -> text(world) + ray;
            assertThat(bits(truth)).as(what).isNotNegative();
            assertThat(bits(range)).as(what).isEqualTo(bits(truth <= 1 ? truth : FAR));
            assertThat(bits(hit == null ? FAR : hit.distance())).as(what).isEqualTo(bits(truth));
            GeometryObject named = hit == null ? null : hit.object();
            for (SenseBuffer out : List.of(batch, sensed, batchOfSnapshot, sensedBySnapshot)) {
                assertThat(bits(out.distance(k))).as(what).isEqualTo(bits(truth));
                assertThat(out.object(k)).as(what).isEqualTo(named);
            }
            double cone = world.getRayDistance(ray, 0, FAR, 30);
            assertThat(bits(cone)).as(what).isNotNegative();
            if (isFirstAround) {
                assertThat(truth).as(what).isZero();
                assertThat(cone).as(what).isZero();
                assertThat(named).as(what).isNotNull();
                assertThat(named.name()).as(what).isEqualTo("first");
            } else {
                inside += truth == 0 ? 1 : 0;
                outside += truth > 0 && truth < FAR ? 1 : 0;
                missed += truth == FAR ? 1 : 0;
            }
        }
    }

    /** Distances of places and of a sensor that an object carries, from the same start. */
    private void others(Geometry world, Point start, boolean isFirstAround) {
        List<NearObject> near = world.search().nearest(start, 2, FAR);
        for (NearObject found : near) {
            assertThat(bits(found.distance())).as(text(world) + start).isNotNegative();
        }
        if (isFirstAround) {
            assertThat(near.get(0).object().name()).isEqualTo("first");
        }
        Geometry carried = world.snapshot().toGeometry();
        assertThat(carried.addObjectUnchecked(new SphereObject(start, 0).moveable("eye")))
                .isTrue();
        for (double distance : carried.scan("eye", random.nextDouble(360), 40, 9, 0, FAR)) {
            assertThat(bits(distance)).as(text(world) + start).isNotNegative();
            assertThat(distance == 0 || !isFirstAround).isTrue();
        }
        assertThat(bits(carried.getProximity("eye", FAR))).isNotNegative();
        if (world.accuracy() == Accuracy.EXACT) { // else enclosed by more than a point
            assertThat(bits(carried.getProximity("eye", FAR)))
                    .isEqualTo(bits(near.get(0).distance()));
        }
    }

    private static String text(Geometry world) {
        StringBuilder text = new StringBuilder();
        for (GeometryObject object : world.objects()) {
            text.append(object.kind() == GeometryObject.Kind.GRID ? object.toString() : Paste.of(object))
                    .append('\n');
        }
        return text.toString();
    }

    private static long bits(double number) {
        return Double.doubleToRawLongBits(number);
    }
}
