package robosim.geometry.sensor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.Geometry;
import robosim.geometry.RayHit;
import robosim.geometry.Snapshot;
import robosim.geometry.contract.Heights;
import robosim.geometry.material.Material;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CapsuleObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.Ray;
import robosim.geometry.model.RayPattern;
import robosim.geometry.model.SenseOptions;
import robosim.geometry.model.SphereObject;
import robosim.geometry.model.Twist;

/** What sensors read is, to the bit, what single calls return, whatever is asked of which world on how many threads. */
class SensorsTest {
    private static final double NOTHING = Double.POSITIVE_INFINITY;
    private static final Offset<Double> ROUNDING = Offset.offset(1e-12);

    private final SplittableRandom random = new SplittableRandom(20);

    /** Away from the sensors, which are near the origin. */
    private Point place() {
        double x = random.nextDouble(-13, 13);
        double z = random.nextDouble(-13, 13);
        return Math.abs(x) < 4.5 && Math.abs(z) < 4.5 ? place() : new Point(x, random.nextDouble(-3, 3), z);
    }

    private GeometryObject object(int k) {
        double size = random.nextDouble(0.3, 2);
        GeometryObject object = switch (k % 6) {
            case 0 -> new BoxObject(new Point(), size, 1, 2);
            case 1 -> new CylinderObject(new Point(), size, 2);
            case 2 -> new SphereObject(new Point(), size);
            case 3 -> new CapsuleObject(new Point(), 0.4, size);
            case 4 ->
                new MeshObject(
                        List.of(new Point(size, 0, 0), new Point(-1, 1, 0), new Point(0, -1, 1), new Point(0, 0, -1)),
                        new int[][] {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}});
            default ->
                new ObjectGroup(List.of(
                        new BoxObject(new Point(), 1, size, 1).withMaterial(Material.DEFAULT.withLabel(7)),
                        new ObjectGroup(List.of(
                                new SphereObject(new Point(1, 0, 0), 0.6),
                                new SphereObject(new Point(0, 0, 1), size)
                                        .withMaterial(Material.DEFAULT.withReflectance(0.25))))));
        };
        Material material = Material.DEFAULT.withLabel(k).withReflectance(random.nextDouble());
        GeometryObject turned = k % 2 == 0 ? object : object.turned(random.nextDouble(-90, 90), random.nextDouble(360));
        return turned.movedTo(place()).withMaterial(material);
    }

    private Geometry world(Dimension dimension) {
        Geometry world = new Geometry(40, 12, 40, dimension, Accuracy.EXACT);
        for (int k = 0; k < 100; k++) {
            GeometryObject object = object(k);
            world.addObjectUnchecked(k % 5 == 0 ? object.moveable("object " + k) : object);
        }
        GeometryObject robot = new CylinderObject(new Point(0.5, 0, 0.3), 0.4, 1).moveable("robot");
        world.addObjectUnchecked(robot.turned(0, 33));
        return world;
    }

    private static final Pose MOUNT = Pose.of(new Point(0.2, 0.9, -0.1), 40);

    /** A ray of a sensor on the robot as a single call takes it. */
    private static Ray mounted(RayPattern pattern, int ray) {
        double[] r = MOUNT.rotation();
        double x = pattern.x(ray);
        double y = pattern.y(ray);
        double z = pattern.z(ray);
        return new Ray(
                MOUNT.center(),
                new Point(
                        r[0] * x + r[1] * y + r[2] * z,
                        r[3] * x + r[4] * y + r[5] * z,
                        r[6] * x + r[7] * y + r[8] * z));
    }

    private static double[] singles(Geometry world, RayPattern pattern, SenseOptions options) {
        double[] distances = new double[pattern.size()];
        Arrays.setAll(
                distances,
                k -> world.getSonarDistance(
                        "robot", mounted(pattern, k), options.min(), options.max(), options.width()));
        assertThat(Arrays.stream(distances).filter(Double::isFinite).distinct().count())
                .isGreaterThan(pattern.size() / 20L);
        return distances;
    }

    private static double[] ranges(RayFrame frame) {
        return Arrays.copyOf(frame.ranges(), frame.size());
    }

    private <S extends RaySensor<S, F>, F extends RayFrame> void readsSingles(Dimension dimension, S given, F frame) {
        Geometry world = world(dimension);
        S sensor = given.on("robot", MOUNT);
        Geometry seen = Heights.seen(
                world, "robot", MOUNT, sensor.pattern(), sensor.options().width());
        double[] truth = singles(seen, sensor.pattern(), sensor.options());
        sensor.read(world, frame);
        assertThat(ranges(frame)).isEqualTo(truth);
        Snapshot snapshot = world.snapshot();
        for (int threads : new int[] {1, 2, 4}) {
            sensor.withThreads(threads).read(snapshot, frame);
            assertThat(ranges(frame)).isEqualTo(truth);
        }
        assertThat(frame.rows() * frame.columns()).isEqualTo(frame.size()).isEqualTo(truth.length);
    }

    @ParameterizedTest
    @EnumSource
    void rangesAreThoseOfSingleCalls(Dimension dimension) {
        RayPattern rings =
                RayPattern.layers(new double[] {-20, -3, 0, 9}, 180, -1, 360).withDuration(0.1);
        Lidar lidar = Lidar.of(rings, SenseOptions.range(0.7, 11));
        readsSingles(dimension, lidar, new LidarFrame());
        readsSingles(dimension, lidar, new LidarFrame(LidarFrame.Extra.INTENSITIES, LidarFrame.Extra.OBJECTS));
        Intrinsics lens = new Intrinsics(48, 36, 30, 33, 20, 17);
        readsSingles(dimension, DepthCamera.of(lens).withRange(0.5, 20), new DepthFrame());
        readsSingles(dimension, NormalCamera.of(lens), new NormalFrame());
        readsSingles(dimension, SegmentationCamera.of(lens), new SegmentationFrame());
        readsSingles(dimension, SonarArray.ring(24, 12, 0.1, 6), new SonarFrame());
        readsSingles(dimension, SonarArray.ring(24, 0, 0.1, 6), new SonarFrame());
    }

    @Test
    void depthsAreRangesAlongTheAxis() {
        Geometry world = world(Dimension.SPATIAL);
        DepthCamera camera = DepthCamera.of(Intrinsics.fieldOfView(64, 48, 80)).on("robot", MOUNT);
        DepthFrame image = new DepthFrame();
        camera.read(world, image);
        double[] truth = singles(world, camera.pattern(), camera.options());
        double[] point = new double[3];
        short[] millimetres = new short[image.size()];
        image.millimetres(0.01, millimetres);
        for (int k = 0; k < truth.length; k++) {
            assertThat(image.depth(k))
                    .isEqualTo(truth[k] * camera.pattern().x(k))
                    .isEqualTo(image.depths()[k]);
            image.point(k, point, 0);
            double x = truth[k] == NOTHING ? Double.NaN : image.depth(k);
            assertThat(point[0]).isCloseTo(x, Offset.offset(1e-12));
            int expected = truth[k] == NOTHING ? 0 : (int) Math.rint(image.depth(k) * 10);
            assertThat(millimetres[k] & 0xffff).isEqualTo(expected);
        }
        image.millimetres(10, millimetres); // 6.5535 world units are the most
        for (int k = 0; k < truth.length; k++) {
            assertThat(millimetres[k] & 0xffff)
                    .isEqualTo(image.depth(k) * 10000 < 65535.5 ? (int) Math.rint(image.depth(k) * 10000) : 0);
        }
    }

    @Test
    void aWallSquareToTheAxisHasOneDepth() {
        Geometry world = new Geometry(40, 40, 40);
        world.addObject(new BoxObject(new Point(6, 0, 0), 2, 30, 30));
        DepthFrame image = new DepthFrame();
        DepthCamera.of(new Intrinsics(31, 21, 20, 25, 11, 5)).read(world, image);
        for (int k = 0; k < image.size(); k++) {
            assertThat(image.depth(k)).isCloseTo(5, ROUNDING);
        }
    }

    /** A wall 3 high in a PLANAR world is seen as such: above and below it there is nothing. */
    @ParameterizedTest
    @EnumSource
    void depthsAreThoseOfThePointsTheyShow(Dimension dimension) {
        Geometry world = new Geometry(20, 4, 20, dimension, Accuracy.EXACT);
        world.addObject(new BoxObject(new Point(6, 0, 0), 2, 3, 18));
        DepthFrame image = new DepthFrame();
        DepthCamera camera = DepthCamera.of(Intrinsics.fieldOfView(64, 48, 80));
        camera.read(world, image);
        double[] point = new double[3];
        int wall = 0;
        for (int k = 0; k < image.size(); k++) {
            boolean isOnWall = Math.abs(camera.pattern().y(k) / camera.pattern().x(k)) < 0.3;
            wall += isOnWall ? 1 : 0;
            if (isOnWall) {
                image.point(k, point, 0);
                assertThat(image.depth(k)).isCloseTo(5, ROUNDING);
                assertThat(point[0]).isCloseTo(5, ROUNDING);
                assertThat(point[1])
                        .isCloseTo(5 * camera.pattern().y(k) / camera.pattern().x(k), ROUNDING);
            } else {
                assertThat(image.depth(k)).isEqualTo(NOTHING);
            }
        }
        assertThat(wall).isBetween(image.size() / 5, image.size() * 4 / 5);
    }

    /** What is nearer than a sensor can measure is no point of a cloud, whatever is reported for it. */
    @ParameterizedTest
    @EnumSource
    void whatIsNearerThanTheBlindRangeHasNoPoint(OutOfRange reported) {
        Geometry world = new Geometry(40, 4, 40);
        world.addObject(new BoxObject(new Point(0.35, 0, 0), 0.1, 2, 2)); // its face is at 0.3
        world.addObject(new BoxObject(new Point(-9, 0, 0), 2, 3, 6)); // at 8
        world.addObject(new BoxObject(new Point(0, 0, 15), 2, 3, 2)); // beyond the range
        Lidar lidar = Lidar.ousterOs1With64(10).withRange(0.8, 12).withOutOfRange(reported);
        assertThat(lidar.outOfRange()).isEqualTo(reported);
        LidarFrame turn = new LidarFrame(LidarFrame.Extra.INTENSITIES);
        Lidar.of(lidar.pattern(), SenseOptions.range(0, 12)).read(world, turn);
        double[] truth = ranges(turn);
        lidar.read(world, turn);
        PointCloud cloud = new PointCloud(PointCloud.Field.INTENSITY);
        turn.addTo(cloud);
        double[] point = new double[3];
        int near = 0;
        int points = 0;
        for (int k = 0; k < turn.size(); k++) {
            boolean isNear = truth[k] < 0.8;
            boolean isPoint = !isNear && truth[k] < NOTHING;
            double blind = reported == OutOfRange.REP_117 ? -NOTHING : 0.8;
            turn.point(k, point, 0);
            assertThat(turn.range(k)).isEqualTo(isNear ? blind : truth[k]);
            assertThat(turn.isNear(k)).isEqualTo(isNear);
            assertThat(turn.hasPoint(k)).isEqualTo(isPoint);
            assertThat(Double.isNaN(point[0])).isEqualTo(!isPoint);
            assertThat(turn.intensity(k) > 0).isEqualTo(isPoint);
            near += isNear ? 1 : 0;
            points += isPoint ? 1 : 0;
        }
        assertThat(near).isGreaterThan(10_000);
        assertThat(points).isBetween(1000, turn.size() - near - 1000);
        assertThat(cloud.size()).isEqualTo(points);
        DepthFrame image = new DepthFrame();
        DepthCamera.of(Intrinsics.fieldOfView(9, 7, 60))
                .withRange(0.5, 10)
                .withOutOfRange(reported)
                .read(world, image);
        short[] millimetres = new short[image.size()];
        image.millimetres(1, millimetres);
        boolean isClamped = reported == OutOfRange.CLAMPED;
        assertThat(image.depth(31)).isEqualTo(isClamped ? 0.5 : -NOTHING);
        assertThat(millimetres[31]).isEqualTo((short) (isClamped ? 500 : 0));
    }

    /** With noise: what was near stays so, what gets near becomes so, and a lost reading is an error. */
    @Test
    void noiseAndWhatIsOutOfRange() {
        Geometry world = new Geometry(40, 4, 40);
        world.addObject(new BoxObject(new Point(0.4, 0, -4), 0.2, 2, 8)); // at 0.3, on the left
        world.addObject(new BoxObject(new Point(1.9, 0, 4.1), 2, 2, 8)); // at 0.9, on the right
        Lidar plain = Lidar.of(RayPattern.fan(-45, 0.01, 9000), SenseOptions.range(0.8, 1.2));
        Noise noise = Noise.gaussian(0.1).and(Noise.dropout(0.1));
        LidarFrame frame = new LidarFrame();
        int[] counts = new int[4];
        plain.withRange(0, 1.2).read(world, frame);
        double[] truth = ranges(frame);
        plain.withNoise(noise, 5, "a").read(world, 1, frame);
        double[] clamped = ranges(frame);
        plain.withNoise(noise, 5, "a").withOutOfRange(OutOfRange.REP_117).read(world, 1, frame);
        for (int k = 0; k < truth.length; k++) {
            double range = frame.range(k);
            if (Double.isNaN(range)) {
                counts[0]++;
                assertThat(clamped[k]).isEqualTo(NOTHING);
            } else if (range == -NOTHING) {
                counts[truth[k] < 0.8 ? 1 : 2]++;
                assertThat(clamped[k]).isBetween(0.8, truth[k] < 0.8 ? NOTHING : 0.8);
                assertThat(frame.isNear(k)).isTrue();
            } else {
                counts[3]++;
                assertThat(truth[k]).isGreaterThanOrEqualTo(0.8);
                assertThat(range).isEqualTo(clamped[k]).isGreaterThanOrEqualTo(0.8);
                assertThat(frame.hasPoint(k)).isEqualTo(range <= 1.2);
            }
        }
        assertThat(counts[0]).isBetween(750, 1050);
        assertThat(counts[1]).isGreaterThan(1000);
        assertThat(counts[2]).isGreaterThan(100);
        assertThat(counts[3]).isGreaterThan(1000);
    }

    @ParameterizedTest
    @EnumSource
    void normalsAndObjectsAreThoseOfCastRay(Dimension dimension) {
        Geometry world = world(dimension);
        Pose pose = Pose.of(new Point(0, 0, 0.5), 20).turned(0, 15);
        Intrinsics lens = Intrinsics.fieldOfView(60, 40, 100);
        Geometry seen = Heights.of(world);
        NormalCamera camera = NormalCamera.of(lens).at(pose);
        NormalFrame normals = new NormalFrame();
        camera.read(world, normals);
        SegmentationFrame objects = new SegmentationFrame();
        SegmentationCamera.of(lens).at(pose).read(world, objects);
        double[] own = new double[3];
        int hits = 0;
        for (int k = 0; k < normals.size(); k++) {
            RayPattern pattern = camera.pattern();
            double[] r = pose.rotation();
            Point direction = new Point(
                    r[0] * pattern.x(k) + r[1] * pattern.y(k) + r[2] * pattern.z(k),
                    r[3] * pattern.x(k) + r[4] * pattern.y(k) + r[5] * pattern.z(k),
                    r[6] * pattern.x(k) + r[7] * pattern.y(k) + r[8] * pattern.z(k));
            RayHit hit = seen.castRay(new Ray(pose.center(), direction), NOTHING);
            Point normal = hit == null ? new Point() : hit.normal();
            assertThat(new Point(normals.normalX(k), normals.normalY(k), normals.normalZ(k)))
                    .isEqualTo(normal);
            // Turned into the camera's frame, it has the same length and the same angle with the ray.
            normals.ownNormal(k, own, 0);
            double cosine = own[0] * pattern.x(k) + own[1] * pattern.y(k) + own[2] * pattern.z(k);
            assertThat(cosine)
                    .isCloseTo(
                            normal.x() * direction.x() + normal.y() * direction.y() + normal.z() * direction.z(),
                            ROUNDING);
            assertThat(objects.object(k)).isEqualTo(hit == null ? null : hit.object());
            assertThat(objects.instance(k) == 0).isEqualTo(hit == null);
            if (hit != null) {
                hits++;
                assertThat(objects.known(objects.instance(k))).isEqualTo(hit.object());
                Material whole = hit.object().material();
                boolean isMarked = hit.object() instanceof ObjectGroup && objects.part(k) == 0;
                assertThat(objects.label(k)).isEqualTo(isMarked ? 7 : whole.label());
            }
        }
        assertThat(hits).isGreaterThan(normals.size() / 10);
        assertThat(objects.known()).isGreaterThan(2);
    }

    @Test
    void instancesKeepTheirNumbers() {
        Geometry world = world(Dimension.SPATIAL);
        SegmentationFrame image = new SegmentationFrame();
        SegmentationCamera camera = SegmentationCamera.of(Intrinsics.fieldOfView(40, 30, 90));
        camera.read(world, image);
        List<GeometryObject> before = new ArrayList<>();
        for (int k = 1; k <= image.known(); k++) {
            before.add(image.known(k));
        }
        camera.at(Pose.of(new Point(), 180)).read(world, image);
        assertThat(image.known()).isGreaterThan(before.size());
        for (int k = 0; k < before.size(); k++) {
            assertThat(image.known(k + 1)).isSameAs(before.get(k));
        }
        image.forget();
        assertThat(image.known()).isZero();
    }

    @ParameterizedTest
    @EnumSource
    void intensitiesAreReflectanceTimesTheCosineOfIncidence(Dimension dimension) {
        Geometry world = world(dimension);
        Lidar lidar = Lidar.velodyneVlp16(20).withRange(0, 9).at(Pose.of(new Point(0, 0.5, 0), 10));
        LidarFrame turn = new LidarFrame(LidarFrame.Extra.INTENSITIES, LidarFrame.Extra.OBJECTS);
        lidar.read(world, turn);
        Geometry seen = Heights.of(world);
        RayPattern pattern = lidar.pattern();
        double cos = Math.cos(Math.toRadians(10));
        double sin = Math.sin(Math.toRadians(10));
        int dark = 0;
        for (int k = 0; k < turn.size(); k++) {
            Point direction = new Point(
                    cos * pattern.x(k) + sin * pattern.z(k), pattern.y(k), cos * pattern.z(k) - sin * pattern.x(k));
            RayHit hit = seen.castRay(new Ray(new Point(0, 0.5, 0), direction), 9);
            if (hit == null) {
                dark++;
                assertThat(turn.intensity(k)).isZero();
                assertThat(turn.object(k)).isNull();
                continue;
            }
            Point n = hit.normal();
            double cosine = Math.abs(n.x() * direction.x() + n.y() * direction.y() + n.z() * direction.z());
            boolean isBright = hit.object() instanceof ObjectGroup && turn.part(k) == 2;
            double reflectance = isBright ? 0.25 : hit.object().material().reflectance();
            if (!(hit.object() instanceof ObjectGroup) || turn.part(k) > 0) {
                assertThat(turn.intensity(k)).isCloseTo(reflectance * cosine, Offset.offset(1e-9));
                assertThat(turn.label(k)).isEqualTo(hit.object().material().label());
            }
        }
        assertThat(dark).isBetween(turn.size() / 100, turn.size() * 9 / 10);
    }

    @ParameterizedTest
    @EnumSource
    void pointsLieWhereTheRaysHit(Dimension dimension) {
        Geometry world = world(dimension);
        Lidar lidar = Lidar.ousterOs1With64(20).withRange(0.2, 30).on("robot", MOUNT.turned(0, 20));
        LidarFrame turn = new LidarFrame();
        lidar.read(world, turn);
        PointCloud cloud = new PointCloud(PointCloud.Field.RING, PointCloud.Field.TIME);
        turn.addInWorldTo(cloud);
        PointCloud own = new PointCloud();
        turn.addTo(own);
        assertThat(own.size()).isEqualTo(cloud.size()).isGreaterThan(turn.size() / 4);
        Pose pose = turn.pose();
        double[] r = pose.rotation();
        double[] point = new double[3];
        int at = 0;
        for (int k = 0; k < turn.size(); k++) {
            turn.point(k, point, 0);
            if (turn.range(k) == NOTHING) {
                assertThat(point).containsOnly(Double.NaN);
                continue;
            }
            assertThat(cloud.value(PointCloud.Field.RING, at)).isEqualTo(turn.ring(k));
            assertThat(cloud.value(PointCloud.Field.TIME, at)).isEqualTo(turn.time(k));
            assertThat(new double[] {own.x(at), own.y(at), own.z(at)}).isEqualTo(point);
            double dx = cloud.x(at) - pose.center().x();
            double dy = cloud.y(at) - pose.center().y();
            double dz = cloud.z(at) - pose.center().z();
            assertThat(Math.sqrt(dx * dx + dy * dy + dz * dz)).isCloseTo(turn.range(k), Offset.offset(1e-10));
            assertThat(r[0] * dx + r[3] * dy + r[6] * dz).isCloseTo(point[0], Offset.offset(1e-10));
            assertThat(r[1] * dx + r[4] * dy + r[7] * dz).isCloseTo(point[1], Offset.offset(1e-10));
            assertThat(r[2] * dx + r[5] * dy + r[8] * dz).isCloseTo(point[2], Offset.offset(1e-10));
            at++;
        }
    }

    /** A moving lidar sees each column as a lidar at rest does that stands where it is then. */
    @ParameterizedTest
    @EnumSource
    void motionIsThatOfEachColumn(Dimension dimension) {
        Geometry world = world(dimension);
        Twist twist = new Twist(6, dimension == Dimension.PLANAR ? 0 : 0.4, -1, 200);
        Lidar lidar = Lidar.velodyneVlp16(20)
                .withRange(0, 15)
                .on("robot", MOUNT.turned(dimension == Dimension.PLANAR ? 0 : 25, 0));
        LidarFrame moving = new LidarFrame(LidarFrame.Extra.INTENSITIES);
        Lidar driven = lidar.withMotion(twist);
        driven.read(world, moving);
        LidarFrame still = new LidarFrame(LidarFrame.Extra.INTENSITIES);
        lidar.read(world, still);
        assertThat(ranges(moving)).isNotEqualTo(ranges(still));
        assertThat(driven.withoutMotion()).isEqualTo(lidar);
        GeometryObject robot = world.getObject("robot");
        double[] point = new double[3];
        double[] truth = new double[3];
        int columns = moving.columns();
        int checked = 0;
        for (int column = 0; column < columns; column += 67) {
            double time = driven.pattern().time(column);
            Pose start = Pose.of(robot.center(), 0).oriented(robot.rotation());
            Pose then = twist.after(start, time);
            Geometry later = world.snapshot().toGeometry();
            later.removeObject("robot");
            later.addObjectUnchecked(
                    ((CylinderObject) robot).movedTo(then.center()).oriented(then.rotation()));
            lidar.read(later, still);
            for (int row = 0; row < moving.rows(); row++) {
                int k = row * columns + column;
                assertThat(moving.range(k)).isCloseTo(still.range(k), Offset.offset(1e-9));
                assertThat(moving.intensity(k)).isCloseTo(still.intensity(k), Offset.offset(1e-9));
                if (moving.range(k) < NOTHING) {
                    checked++;
                    moving.worldPoint(k, point, 0);
                    still.worldPoint(k, truth, 0);
                    assertThat(point).containsExactly(truth, Offset.offset(1e-9));
                    // In its own frame it does not know that it moved.
                    moving.point(k, point, 0);
                    still.point(k, truth, 0);
                    assertThat(point).containsExactly(truth, Offset.offset(1e-9));
                }
            }
        }
        assertThat(checked).isGreaterThan(50);
        // A lidar that nothing carries moves by itself.
        Lidar free = lidar.at(Pose.of(new Point(1, 0.5, 2), 70)).withMotion(twist);
        free.read(world, moving);
        int last = columns - 1;
        lidar.at(twist.after(Pose.of(new Point(1, 0.5, 2), 70), free.pattern().time(last)))
                .read(world, still);
        for (int k = last; k < moving.size(); k += columns) {
            moving.worldPoint(k, point, 0);
            still.worldPoint(k, truth, 0);
            assertThat(point).containsExactly(truth, Offset.offset(1e-9));
        }
    }

    @Test
    void noiseNeitherKnowsThreadsNorOrder() {
        Geometry world = world(Dimension.SPATIAL);
        Noise noise = Noise.mixedPixels(1, 0.2)
                .and(Noise.gaussian(0.02))
                .and(Noise.proportional(0.01))
                .and(Noise.grazing(0.01, 85))
                .and(Noise.falseEchoes(0.05))
                .and(Noise.dropout(0.1))
                .and(Noise.quantized(0.005));
        Lidar lidar =
                Lidar.velodyneVlp16(20).on("robot", MOUNT).withRange(0.3, 9).withNoise(noise, 42, 1);
        LidarFrame frame = new LidarFrame();
        lidar.read(world, 7, frame);
        double[] truth = ranges(frame);
        Lidar plain = lidar.withNoise(Noise.NONE, 0, 0);
        plain.read(world, frame);
        double[] clean = ranges(frame);
        int same = 0;
        for (int k = 0; k < truth.length; k++) {
            same += truth[k] == clean[k] ? 1 : 0;
            assertThat(truth[k] == NOTHING || (truth[k] >= 0.3 && truth[k] <= 9))
                    .isTrue();
        }
        // Where nothing echoes, most stay as they are.
        assertThat(same).isLessThan(truth.length * 3 / 4);
        Snapshot snapshot = world.snapshot();
        for (int threads : new int[] {1, 3}) {
            lidar.withThreads(threads).read(snapshot, 3, frame);
            assertThat(ranges(frame)).isNotEqualTo(truth);
            lidar.withThreads(threads).read(snapshot, 7, frame);
            assertThat(ranges(frame)).isEqualTo(truth);
            assertThat(frame.number()).isEqualTo(7);
        }
        plain.read(world, frame);
        assertThat(ranges(frame)).isEqualTo(clean);
    }

    @Test
    void valuesAndRefusals() {
        Lidar lidar = Lidar.velodyneVlp16(10);
        assertThat(lidar).isEqualTo(Lidar.velodyneVlp16(10)).hasSameHashCodeAs(Lidar.velodyneVlp16(10));
        assertThat(lidar).isNotEqualTo(Lidar.velodyneVlp16(20)).isNotEqualTo(lidar.withThreads(2));
        assertThat(lidar.carrier()).isNull();
        assertThat(lidar.on("r", MOUNT).mount()).isEqualTo(MOUNT);
        Geometry world = world(Dimension.SPATIAL);
        LidarFrame frame = new LidarFrame();
        refused("ray must be one of a frame that was read, and none was (got: 0)", () -> frame.range(0));
        Lidar noisy = lidar.withNoise(Noise.gaussian(1), 1, 1);
        refused("a sensor with noise must be told the number of its frame", () -> noisy.read(world, frame));
        refused("world must be given (got: null)", () -> lidar.read((Geometry) null, frame));
        refused("out must be given (got: null)", () -> lidar.read(world, null));
        lidar.read(world, frame);
        refused("ray must be from 0 to ", () -> frame.range(frame.size()));
        refused("made for INTENSITIES", () -> frame.intensity(0));
        refused("hertz must be from 5 to 20 (got: NaN)", () -> Lidar.velodyneVlp16(Double.NaN));
        refused("hertz must be from 10 to 20 (got: 21.0)", () -> Lidar.ousterOs1With128(21));
        refused("name must be", () -> lidar.on("nobody", MOUNT).read(world, frame));
        assertThat(frame.size()).isZero();
        refused(
                "width must be 0 for a lidar",
                () -> Lidar.of(RayPattern.fan(0, 1, 3), SenseOptions.range(0, 1).withWidth(3)));
        refused(
                "noise must not need the normals of rays",
                () -> SonarArray.ring(8, 15, 0, 5).withNoise(Noise.grazing(0, 80), 1, 1));
        refused("fx must be from", () -> new Intrinsics(3, 3, 0, 1, 1, 1));
        refused("width must be from 1", () -> new Intrinsics(0, 3, 1, 1, 1, 1));
        refused("height must be from 1 to 16 rows", () -> new Intrinsics(1 << 20, 17, 1, 1, 1, 1));
        refused("horizontalFieldOfViewDegrees must be", () -> Intrinsics.fieldOfView(3, 3, 180));
        PointCloud cloud = new PointCloud(PointCloud.Field.INTENSITY);
        lidar.read(world, frame);
        refused("made for INTENSITIES", () -> frame.addTo(cloud));
        refused("all three components of the normal", () -> new PointCloud(PointCloud.Field.NORMAL_X));
    }

    private static void refused(String message, Runnable call) {
        assertThatThrownBy(call::run)
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining(message);
    }

    /** A frame serves sensors of different needs one after another. */
    @Test
    void oneFrameForWideAndNarrowBeams() {
        Geometry world = world(Dimension.SPATIAL);
        SonarFrame frame = new SonarFrame();
        SonarArray rays = SonarArray.ring(8, 0, 0, 9).on("robot", MOUNT);
        SonarArray cones = SonarArray.ring(8, 20, 0, 9).on("robot", MOUNT);
        double[] truth = singles(world, cones.pattern(), cones.options());
        rays.withNoise(Noise.grazing(0.1, 80), 1, 1).read(world, 0, frame);
        cones.read(world, frame);
        assertThat(ranges(frame)).isEqualTo(truth);
    }
}
