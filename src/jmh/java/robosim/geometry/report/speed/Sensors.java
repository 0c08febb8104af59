package robosim.geometry.report.speed;

import java.io.IOException;
import java.util.List;
import robosim.geometry.Geometry;
import robosim.geometry.SenseBuffer;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.Pose;
import robosim.geometry.model.RayPattern;
import robosim.geometry.model.SenseOptions;
import robosim.geometry.render.ColorCamera;
import robosim.geometry.render.ColorFrame;
import robosim.geometry.sensor.DepthCamera;
import robosim.geometry.sensor.DepthFrame;
import robosim.geometry.sensor.Intrinsics;
import robosim.geometry.sensor.Lidar;
import robosim.geometry.sensor.LidarFrame;

/** Depth images, turns of a lidar and pictures in colour, each on one thread: time a frame, in nanoseconds. */
final class Sensors implements Study {
    static final String DEPTH = "depth 320 x 240";
    static final String LIDAR = "lidar 16 x 1800";
    static final String COLOUR = "colour 320 x 240";
    static final String COLOUR_SKY = "colour 320 x 240 with 3 sky rays";

    /** The rays of a frame in one call, without a sensor around them. */
    static final String BARE = "bare frame";

    private static final SenseOptions OPTIONS = SenseOptions.range(0, SensorScene.RANGE);

    @Override
    public void run(Form form, Sink sink, Progress progress) throws IOException {
        for (int k = 0; k < SensorScene.NAMES.size(); k++) {
            double done = k;
            scene(
                    SensorScene.of(SensorScene.NAMES.get(k)),
                    form,
                    sink,
                    share -> progress.at((done + share) / SensorScene.NAMES.size()));
        }
    }

    private static void scene(SensorScene scene, Form form, Sink sink, Progress progress) {
        InTurn tasks = new InTurn(new Form(
                10 * form.warmMillis(),
                form.batchMillis(),
                form.rounds(),
                form.sample(),
                form.cases(),
                form.objects(),
                form.forks()));
        Geometry world = scene.geometry;
        List<Pose> poses = scene.poses;
        Subject module = Subject.module(Accuracy.EXACT, Dimension.SPATIAL);
        addBare(tasks, scene, DEPTH, SensorScene.camera());
        DepthCamera depth = DepthCamera.of(
                        Intrinsics.fieldOfView(SensorScene.WIDTH, SensorScene.HEIGHT, SensorScene.DEGREES))
                .withRange(0, SensorScene.RANGE);
        DepthFrame image = new DepthFrame();
        tasks.add(module, scene.name, DEPTH, poses.size(), (from, count) -> {
            double sum = 0;
            for (int k = from; k < from + count; k++) {
                depth.at(poses.get(k)).read(world, image);
                sum += image.depths()[k];
            }
            return sum;
        });
        addBare(tasks, scene, LIDAR, SensorScene.turn());
        Lidar lidar = Lidar.of(SensorScene.turn(), OPTIONS);
        LidarFrame turn = new LidarFrame();
        tasks.add(module, scene.name, LIDAR, poses.size(), (from, count) -> {
            double sum = 0;
            for (int k = from; k < from + count; k++) {
                lidar.at(poses.get(k)).read(world, turn);
                sum += turn.ranges()[k];
            }
            return sum;
        });
        ColorCamera camera = ColorCamera.of(SensorScene.WIDTH, SensorScene.HEIGHT, SensorScene.DEGREES);
        addColour(tasks, scene, COLOUR, camera);
        addColour(tasks, scene, COLOUR_SKY, camera.withSkyRays(3, 4));
        tasks.run(sink, progress);
    }

    private static void addBare(InTurn tasks, SensorScene scene, String query, RayPattern pattern) {
        SenseBuffer out = new SenseBuffer();
        tasks.add(Subject.peer(BARE), scene.name, query, scene.poses.size(), (from, count) -> {
            double sum = 0;
            for (int k = from; k < from + count; k++) {
                scene.geometry.sense(scene.poses.get(k), pattern, OPTIONS, out);
                sum += out.distances()[k];
            }
            return sum;
        });
    }

    private static void addColour(InTurn tasks, SensorScene scene, String query, ColorCamera camera) {
        ColorFrame picture = new ColorFrame();
        Subject module = Subject.module(Accuracy.EXACT, Dimension.SPATIAL);
        tasks.add(module, scene.name, query, scene.poses.size(), (from, count) -> {
            double sum = 0;
            for (int k = from; k < from + count; k++) {
                camera.at(scene.poses.get(k)).render(scene.geometry, picture);
                sum += picture.pixels()[k];
            }
            return sum;
        });
    }
}
