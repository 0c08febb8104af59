package robosim.geometry.report.speed;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.SplittableRandom;
import robosim.geometry.Geometry;
import robosim.geometry.SenseBuffer;
import robosim.geometry.export.PageWriter;
import robosim.geometry.export.Pages;
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
import robosim.geometry.sensor.Noise;
import robosim.geometry.viewer.playback.StateHistory;

/** Depth images, turns of a lidar and pictures in colour, each on one thread: time a frame, in nanoseconds. */
final class Sensors implements Study {
    static final String DEPTH = "depth 320 x 240";
    static final String LIDAR = "lidar 16 x 1800";
    static final String COLOUR = "colour 320 x 240";
    static final String COLOUR_SKY = "colour 320 x 240 with the sky's shadows";
    static final String PAGE = "page of 1000 objects and 3000 steps";
    static final String BYTES = "bytes";
    static final String NOISY = LIDAR + " with noise";

    /** The rays of a frame in one call, without a sensor around them. */
    static final String BARE = "bare frame";

    private static final SenseOptions OPTIONS = SenseOptions.range(0, SensorScene.RANGE);

    @Override
    public void run(Form form, Sink sink, Progress progress) throws IOException {
        int parts = SensorScene.NAMES.size() + 1;
        for (int k = 0; k < SensorScene.NAMES.size(); k++) {
            double done = k;
            SensorScene scene = SensorScene.of(SensorScene.NAMES.get(k));
            scene(scene, form, sink, share -> progress.at((done + share) / parts));
            SensorPeers.run(scene, form, sink);
        }
        SensorNoise.run(form, sink, share -> progress.at((parts - 1 + share) / parts));
        page(form, sink);
    }

    private static void page(Form form, Sink sink) throws IOException {
        int steps = Math.min(3000, 2 * form.cases());
        StateHistory film = Pages.film(Pages.wander(1000, 20, steps, true, new SplittableRandom(6)));
        Path page = Files.createTempFile("robosim", ".html");
        new PageWriter(film).write(page);
        Subject module = Subject.module(Accuracy.EXACT, Dimension.PLANAR);
        sink.put(module, "1000 objects", steps == 3000 ? PAGE : "page of " + steps + " steps", BYTES, Files.size(page));
        Files.delete(page);
    }

    private static void scene(SensorScene scene, Form form, Sink sink, Progress progress) {
        InTurn tasks = new InTurn(new Form(
                5 * form.warmMillis(),
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
        Lidar noisy = lidar.withNoise(
                Noise.gaussian(0.01).and(Noise.proportional(0.002)).and(Noise.quantized(0.001)), Form.SEED, 1);
        tasks.add(module, scene.name, NOISY, poses.size(), (from, count) -> {
            double sum = 0;
            for (int k = from; k < from + count; k++) {
                noisy.at(poses.get(k)).read(world, k, turn);
                sum += turn.ranges()[k];
            }
            return sum;
        });
        ColorCamera camera = ColorCamera.of(SensorScene.WIDTH, SensorScene.HEIGHT, SensorScene.DEGREES);
        addColour(tasks, scene, COLOUR, camera);
        addColour(tasks, scene, COLOUR_SKY, camera.withSmoothSky(3, 4));
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
