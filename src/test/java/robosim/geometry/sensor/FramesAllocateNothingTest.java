package robosim.geometry.sensor;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.SplittableRandom;
import java.util.function.LongConsumer;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.Allocated;
import robosim.geometry.Geometry;
import robosim.geometry.Snapshot;
import robosim.geometry.material.Material;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.SphereObject;
import robosim.geometry.model.Twist;

/** A sensor that keeps its frame leaves nothing for the garbage collector, noise or not, on any JDK. */
@Tag("slow")
class FramesAllocateNothingTest {
    private static final int READINGS = 40;

    private static final Pose MAST = Pose.of(new Point(0.01, 0.73, 0.02), 15.1);

    private static Geometry world(Dimension dimension) {
        SplittableRandom random = new SplittableRandom(8);
        Geometry world = new Geometry(60, 10, 60, dimension, Accuracy.EXACT);
        for (int k = 0; k < 80; k++) {
            // In no particular place: where only exact arithmetic decides, it takes memory.
            Point place = new Point(
                    k % 9 * 6 - 24 + random.nextDouble(0.4),
                    random.nextDouble(0.3),
                    k / 9 * 5 - 22 + random.nextDouble(0.4));
            world.addObject(
                    k % 3 == 0
                            ? new BoxObject(place, 1, 2, 1.5).turned(0, k + 0.3)
                            : k % 3 == 1
                                    ? new SphereObject(place, 0.9)
                                    : new ObjectGroup(List.of(
                                                    new CylinderObject(new Point(), 0.5, 2),
                                                    new BoxObject(new Point(0.8, 0, 0), 0.5, 1, 0.5)
                                                            .withMaterial(Material.DEFAULT.withLabel(2))))
                                            .movedTo(place));
        }
        assertThat(world.addObject(new CylinderObject(new Point(3, 0, 2.5), 0.4, 1).moveable("robot")))
                .isTrue();
        return world;
    }

    @ParameterizedTest
    @EnumSource
    void readings(Dimension dimension) {
        Geometry world = world(dimension);
        Snapshot snapshot = world.snapshot();
        Noise noise = Noise.mixedPixels(0.5, 0.1)
                .and(Noise.gaussian(0.01))
                .and(Noise.proportional(0.01))
                .and(Noise.bias(0, 0.1))
                .and(Noise.grazing(0.01, 85))
                .and(Noise.falseEchoes(0.01))
                .and(Noise.dropout(0.02))
                .and(Noise.quantized(0.001));
        Lidar lidar = Lidar.hokuyoUtm30lx().on("robot", MAST);
        Lidar rings = Lidar.velodyneVlp16(20).on("robot", MAST);
        LidarFrame turn = new LidarFrame();
        LidarFrame all = new LidarFrame(LidarFrame.Extra.INTENSITIES, LidarFrame.Extra.OBJECTS);
        allocatesNothing("laser", k -> lidar.read(world, turn));
        allocatesNothing("laser in a snapshot", k -> lidar.read(snapshot, turn));
        allocatesNothing("intensities", k -> lidar.read(world, all));
        Lidar noisy = lidar.withNoise(noise, 4, 2);
        allocatesNothing("noise", k -> noisy.read(world, k, all));
        allocatesNothing("rings", k -> rings.read(snapshot, all));
        Lidar driven = lidar.withMotion(Twist.drive(2, 30));
        allocatesNothing("motion", k -> driven.read(world, all));
        PointCloud cloud = new PointCloud(PointCloud.Field.INTENSITY, PointCloud.Field.TIME, PointCloud.Field.LABEL);
        allocatesNothing("cloud", k -> {
            cloud.clear();
            all.addInWorldTo(cloud);
        });
        Intrinsics lens = Intrinsics.fieldOfView(80, 60, 87);
        DepthCamera depth = DepthCamera.of(lens).on("robot", MAST);
        DepthFrame depths = new DepthFrame();
        short[] millimetres = new short[80 * 60];
        allocatesNothing("depth", k -> {
            depth.read(world, depths);
            depths.millimetres(1, millimetres);
        });
        NormalCamera normal = NormalCamera.of(lens).on("robot", MAST);
        NormalFrame normals = new NormalFrame();
        allocatesNothing("normals", k -> normal.read(world, normals));
        SegmentationCamera segmentation = SegmentationCamera.of(lens).on("robot", MAST);
        SegmentationFrame segments = new SegmentationFrame();
        allocatesNothing("segments", k -> segmentation.read(world, segments));
        SonarArray sonars = SonarArray.ring(16, 15, 0, 10).on("robot", MAST);
        SonarFrame echoes = new SonarFrame();
        allocatesNothing("sonars", k -> sonars.read(world, echoes));
    }

    private static void allocatesNothing(String what, LongConsumer reading) {
        assertThat(Allocated.everyTime(() -> run(reading)) / (double) READINGS)
                .as(what)
                .isLessThan(1);
    }

    private static void run(LongConsumer reading) {
        for (int k = 0; k < READINGS; k++) {
            reading.accept(k);
        }
    }
}
