package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import robosim.geometry.Geometry;
import robosim.geometry.RayHit;
import robosim.geometry.SenseBuffer;
import robosim.geometry.SenseBuffer.Extra;
import robosim.geometry.Snapshot;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.Ray;
import robosim.geometry.model.RayPattern;
import robosim.geometry.model.SenseOptions;
import robosim.geometry.model.Twist;

/** A scan from a sensor that moves answers, beam by beam, as if its carrier had been put where it is at that time. */
class MovingSensorTest {
    private static final double SIZE = 64;

    private final SplittableRandom random = new SplittableRandom(47);

    private Geometry world(Dimension dimension, int count, double spread, int oneIn) {
        Geometry world = new Geometry(SIZE, SIZE, SIZE, dimension, Accuracy.EXACT);
        RandomObjects objects = new RandomObjects(random, spread);
        for (int k = 0; k < count; k++) {
            GeometryObject object = objects.next();
            GeometryObject given = random.nextInt(oneIn) == 0 ? object.moveable("object " + k) : object;
            assertThat(world.addObjectUnchecked(given)).isTrue();
        }
        world.addObjectUnchecked(new CylinderObject(objects.place(), 0.3, 0.6).moveable("upright"));
        world.addObjectUnchecked(new BoxObject(objects.place(), 0.4, 0.2, 0.3)
                .turned(random.nextDouble(-60, 60), objects.heading())
                .moveable("tipped"));
        Script.run(world, 40, random.nextLong(), spread, 0.25);
        return world;
    }

    private Twist twist() {
        double speed = random.nextInt(5) == 0 ? 0 : 3;
        double turn = random.nextInt(4) == 0 ? 0 : random.nextInt(4) == 0 ? 90 : random.nextDouble(-400, 400);
        return new Twist(
                random.nextDouble(-1, 1) * speed, random.nextDouble(-1, 1), random.nextDouble(speed + 0.1), turn);
    }

    private RayPattern pattern(int kind) {
        return switch (kind) {
            case 0 -> RayPattern.fan(-135, 3, 91).withDuration(random.nextDouble(-1, 1));
            case 1 ->
                RayPattern.layers(new double[] {-30, -15, -7.5, 0, 7.5, 15, 30}, 90, -4, 45)
                        .withDuration(0.5);
            case 2 -> {
                RayPattern camera = RayPattern.pinhole(9, 7, 80);
                double[] times = new double[63];
                for (int k = 0; k < times.length; k++) {
                    times[k] = random.nextInt(4) / 8.0 - 0.125; // equal and unequal neighbours
                }
                yield camera.withTimes(times);
            }
            default -> RayPattern.layers(new double[] {-10, 0, 10}, 0, 7, 30).withTimes(times(30));
        };
    }

    private double[] times(int count) {
        double[] times = new double[count];
        for (int k = 0; k < count; k++) {
            times[k] = k / 3 * 0.05;
        }
        return times;
    }

    private static Point turned(double[] r, Point d) {
        return new Point(
                r[0] * d.x() + r[1] * d.y() + r[2] * d.z(),
                r[3] * d.x() + r[4] * d.y() + r[5] * d.z(),
                r[6] * d.x() + r[7] * d.y() + r[8] * d.z());
    }

    @ParameterizedTest
    @CsvSource({"PLANAR, 120, 9, 30", "SPATIAL, 120, 7, 30", "SPATIAL, 60, 5, 3", "PLANAR, 60, 8, 3"})
    void asFromThere(Dimension dimension, int count, double spread, int oneIn) {
        int beams = 0;
        int echoes = 0;
        int elsewhere = 0;
        SenseBuffer out = new SenseBuffer();
        SenseBuffer several = new SenseBuffer(Extra.OBJECTS);
        SenseBuffer still = new SenseBuffer();
        RandomObjects objects = new RandomObjects(random, spread);
        for (int round = 0; round < 8; round++) {
            Geometry world = world(dimension, count, spread, oneIn);
            Snapshot snapshot = world.snapshot();
            for (int kind = 0; kind < 4; kind++) {
                String name = new String[] {"upright", null, "tipped"}[(round + kind) % 3];
                Pose pose = name == null
                        ? Pose.of(objects.place(), objects.heading())
                        : Pose.of(new Point(0.2, 0.1, random.nextDouble(0.5)), random.nextInt(3) * 45.0);
                RayPattern pattern = pattern(kind);
                Twist twist = twist();
                SenseOptions options = SenseOptions.range(0.1, kind == 3 ? 6 : Double.POSITIVE_INFINITY)
                        .withWidth(round % 4 == 3 ? 9 : 0);
                SenseOptions moving = options.withMotion(twist);
                if (name == null) {
                    world.sense(pose, pattern, moving, out);
                    world.sense(pose, pattern, options, still);
                    snapshot.sense(pose, pattern, moving.withThreads(3), several);
                } else {
                    world.sense(name, pose, pattern, moving, out);
                    world.sense(name, pose, pattern, options, still);
                    snapshot.sense(name, pose, pattern, moving.withThreads(3), several);
                }
                Geometry copy = Heights.seen(snapshot.toGeometry(), name, pose, pattern, options.width());
                GeometryObject carrier = name == null ? null : copy.getObject(name);
                double time = 0;
                for (int beam = 0; beam < pattern.size(); beam++) {
                    double single;
                    if (carrier == null) {
                        Pose then = twist.after(pose, pattern.time(beam));
                        Ray ray = new Ray(then.center(), turned(then.rotation(), pattern.direction(beam)));
                        single = copy.getRayDistance(ray, 0.1, options.max(), options.width());
                    } else {
                        if (pattern.time(beam) != time) {
                            time = pattern.time(beam);
                            copy.removeObject(name);
                            assertThat(copy.addObjectUnchecked(carrier.at(twist.after(carrier.pose(), time))))
                                    .isTrue();
                        }
                        Ray ray = new Ray(pose.center(), turned(pose.rotation(), pattern.direction(beam)));
                        single = copy.getSonarDistance(name, ray, 0.1, options.max(), options.width());
                    }
                    assertThat(out.distance(beam))
                            .as("beam %d at %s of %s on %s, %s", beam, pattern.time(beam), pattern, name, twist)
                            .isEqualTo(single);
                    assertThat(several.distance(beam)).isEqualTo(single);
                    beams++;
                    echoes += single < Double.POSITIVE_INFINITY ? 1 : 0;
                    elsewhere += single != still.distance(beam) ? 1 : 0;
                }
            }
        }
        assertThat(echoes).isBetween(beams / 5, beams * 19 / 20);
        assertThat(elsewhere).isGreaterThan(beams / 3);
    }

    /** A lidar drives along a wall: without its motion, the wall is bent. */
    @Test
    void aStraightWallIsStraight() {
        Geometry world = new Geometry(100, 10, 100);
        world.addObject(new BoxObject(new Point(0, 0, -5.5), 80, 4, 1));
        world.addObject(new CylinderObject(new Point(), 0.3, 0.6).moveable("robot"));
        RayPattern lidar = RayPattern.fan(0, 1, 360).withDuration(0.1);
        Twist drive = Twist.drive(10, 90);
        SenseBuffer out = new SenseBuffer();
        world.sense("robot", Pose.ORIGIN, lidar, SenseOptions.range(0, 20).withMotion(drive), out);
        int met = 0;
        double[] errors = {0, 0};
        for (int beam = 0; beam < 360; beam++) {
            double distance = out.distance(beam);
            if (distance < 20) {
                Pose then = drive.after(Pose.ORIGIN, lidar.time(beam));
                Point way = turned(then.rotation(), lidar.direction(beam));
                errors[0] = Math.max(errors[0], Math.abs(then.center().z() + distance * way.z() + 5));
                errors[1] = Math.max(
                        errors[1], Math.abs(distance * lidar.direction(beam).z() + 5));
                met++;
            }
        }
        assertThat(met).isGreaterThan(100);
        assertThat(errors[0]).isLessThan(1e-13);
        assertThat(errors[1]).isGreaterThan(0.5);
    }

    /** Equal times, and none: the sensor stands where it then is. */
    @Test
    void withoutTimesNothingMoves() {
        Geometry world = new Geometry(40, 10, 40);
        world.addObject(new BoxObject(new Point(10, 0, 0), 2, 2, 30));
        world.addObject(new CylinderObject(new Point(), 0.3, 0.6).moveable("robot"));
        RayPattern fan = RayPattern.fan(0, 0, 1);
        SenseOptions moving = SenseOptions.range(0, 20).withMotion(Twist.drive(2, 0));
        SenseBuffer out = new SenseBuffer();
        world.sense("robot", Pose.ORIGIN, fan, moving, out);
        assertThat(out.distance(0)).isEqualTo(9);
        world.sense("robot", Pose.ORIGIN, fan.withTimes(new double[] {1.5}), moving, out);
        assertThat(out.distance(0)).isEqualTo(6);
        world.sense("robot", Pose.ORIGIN, fan.withTimes(new double[] {-1}), moving, out);
        assertThat(out.distance(0)).isEqualTo(11);
        assertThat(world.getObject("robot").center()).isEqualTo(new Point());
    }

    @Test
    void refusals() {
        Geometry world = new Geometry(40, 10, 40);
        world.addObject(new CylinderObject(new Point(), 0.3, 0.6).moveable("robot"));
        RayPattern fan = RayPattern.fan(0, 1, 2).withDuration(1);
        SenseOptions moving = SenseOptions.range(0, 20).withMotion(Twist.drive(2, 0));
        SenseBuffer out = new SenseBuffer();
        assertThatThrownBy(() ->
                        world.sense("robot", Pose.ORIGIN, fan, moving.withCarrier(SenseOptions.Carrier.SEEN), out))
                .hasMessage(
                        "the object that carries a sensor must be IGNORED where it moves during the scan (got: SEEN)");
        SenseOptions far = SenseOptions.range(0, 20).withMotion(Twist.drive(0x1p100, 0));
        assertThatThrownBy(() -> world.sense("robot", Pose.ORIGIN, fan.withDuration(4), far, out))
                .hasMessageContaining("seconds must be a time at which coordinates are within 2^100");
        assertThatThrownBy(() -> moving.withMotion(null)).hasMessage("velocity must be given (got: null)");
        assertThat(moving).isNotEqualTo(SenseOptions.range(0, 20));
        assertThat(moving.toString()).contains("motion=Twist[x=2.0, y=0.0, z=0.0, ry=0.0]");
    }

    /** Threads and the way in which a pattern is cut change nothing. */
    @Test
    void moreLayersThanATileHasRows() {
        Geometry world = world(Dimension.SPATIAL, 120, 7, 9);
        double[] elevations = new double[100];
        for (int k = 0; k < elevations.length; k++) {
            elevations[k] = k - 50;
        }
        RayPattern lidar = RayPattern.layers(elevations, 0, 20, 18).withDuration(0.2);
        SenseOptions moving = SenseOptions.range(0, 50).withMotion(Twist.drive(4, 50));
        SenseBuffer out = new SenseBuffer(Extra.OBJECTS, Extra.NORMALS);
        world.sense("upright", Pose.ORIGIN, lidar, moving, out);
        Set<Double> seen = new HashSet<>();
        List<Double> single = new ArrayList<>();
        Geometry copy = world.snapshot().toGeometry();
        GeometryObject carrier = copy.getObject("upright");
        copy.removeObject("upright");
        for (int beam = 0; beam < lidar.size(); beam++) {
            Pose then = Twist.drive(4, 50).after(carrier.pose(), lidar.time(beam));
            RayHit hit = copy.castRay(new Ray(then.center(), turned(then.rotation(), lidar.direction(beam))), 50);
            single.add(hit == null ? Double.POSITIVE_INFINITY : hit.distance());
            assertThat(out.distance(beam)).isEqualTo(single.get(beam));
            if (hit != null) {
                assertThat(new Point(out.normalX(beam), out.normalY(beam), out.normalZ(beam)))
                        .isEqualTo(hit.normal());
            }
            seen.add(out.distance(beam));
        }
        assertThat(seen).hasSizeGreaterThan(300);
    }
}
