package robosim.geometry.report.speed;

import java.io.BufferedReader;
import java.io.IOException;
import java.math.BigDecimal;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.Geometry;
import robosim.geometry.SenseBuffer;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Bounds;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.Ray;
import robosim.geometry.model.RayPattern;
import robosim.geometry.model.SenseOptions;
import robosim.geometry.model.SphereObject;
import robosim.geometry.reference.Reference;

/**
 * The boxes, cylinders and spheres of a scene, for this module and for Embree, ray by ray: the program {@code bin/embree} of
 * the peers' folder, in which they are shapes of its user with kernels in doubles. Meshes, capsules and
 * cylinders that do not stand are left out for both.
 * Each engine's answers are compared with exact ones for some rays, and with the module's for all.
 */
final class SensorPeers {
    static final String EMBREE = "Embree 3 by single rays";
    static final String JUDGED = "judged rays";
    static final String WRONG = "wrong of these";
    static final String DIFFERENT = "share off by 1 mm or more";
    static final String WORST = "largest difference";
    static final String RAY_BY_RAY = "this module ray by ray";

    /** Rays that are answered in exact arithmetic. */
    private static final int SAMPLE = 150;

    /** A distance is wrong if it is off by more than this share of the largest coordinate. */
    private static final double RIGHT = 1e-9;

    private static final SenseOptions OPTIONS = SenseOptions.range(0, SensorScene.RANGE);

    private final Path program;
    private final Path folder;

    private SensorPeers(Path program, Path folder) {
        this.program = program;
        this.folder = folder;
    }

    /** Measures a scene, where a folder of native engines was given. */
    static void run(SensorScene scene, Form form, Study.Sink sink) throws IOException {
        String peers = System.getProperty("peers", "");
        Path program = Path.of(peers, "bin", "embree").toAbsolutePath();
        if (!peers.isEmpty() && Files.isExecutable(program)) {
            Path folder = Files.createTempDirectory("robosim-sensors");
            Files.createDirectories(folder.resolve("data"));
            Files.createDirectories(folder.resolve("results"));
            new SensorPeers(program, folder).measure(scene, form, sink);
        }
    }

    private void measure(SensorScene scene, Form form, Study.Sink sink) throws IOException {
        List<GeometryObject> solids = new ArrayList<>();
        for (GeometryObject object : scene.objects) {
            add(object, Pose.ORIGIN, solids);
        }
        Geometry world = new Geometry(400, 100, 400, Dimension.SPATIAL, Accuracy.EXACT);
        solids.forEach(world::addObjectUnchecked);
        Ray[] depth = rays(scene.poses, SensorScene.camera());
        Ray[] lidar = rays(scene.poses, SensorScene.turn());
        write(100, solids, lidar, depth);
        for (int size : new int[] {1000, 10_000, 100_000}) { // the program asks for all four
            write(size, solids.subList(0, 1), new Ray[] {lidar[0]}, new Ray[] {depth[0]});
        }
        for (String query : List.of(Sensors.DEPTH, Sensors.LIDAR)) {
            Ray[] rays = query.equals(Sensors.DEPTH) ? depth : lidar;
            double[] own = frames(world, scene.poses, query);
            for (int k = 0; k < rays.length; k++) {
                if (own[k] != world.getRayDistance(rays[k], 0, SensorScene.RANGE, 0)) {
                    throw new IllegalStateException("a frame must have the bits of single rays: " + rays[k]);
                }
            }
            ours(world, scene, query, rays, form, sink);
            judge(Subject.module(Accuracy.EXACT, Dimension.SPATIAL), scene, query, solids, rays, own, own, sink);
        }
        double[] nanos = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
        for (int round = 0; round < 3; round++) {
            ask(nanos);
        }
        for (int k = 0; k < 2; k++) {
            String query = k == 0 ? Sensors.LIDAR : Sensors.DEPTH;
            Ray[] rays = k == 0 ? lidar : depth;
            Subject embree = Subject.peer(EMBREE);
            sink.put(embree, boxes(scene), query, Results.NANOS, nanos[k] * rays.length / scene.poses.size());
            double[] said = answers(k == 0 ? "W5" : "W6", rays.length);
            judge(embree, scene, query, solids, rays, said, frames(world, scene.poses, query), sink);
        }
    }

    /** The name of a scene of such solids alone. */
    static String boxes(SensorScene scene) {
        return boxes(scene.name);
    }

    static String boxes(String scene) {
        return scene + " of boxes and cylinders";
    }

    private static void add(GeometryObject object, Pose frame, List<GeometryObject> solids) {
        Pose pose = frame.equals(Pose.ORIGIN) ? object.pose() : object.pose().within(frame);
        if (object instanceof ObjectGroup group) {
            for (GeometryObject member : group.members()) {
                add(member, pose, solids);
            }
        } else if (object instanceof BoxObject box) {
            solids.add(new BoxObject(pose.center(), box.width(), box.height(), box.length()).oriented(pose.rotation()));
        } else if (object instanceof CylinderObject cylinder && Math.abs(pose.rotation()[4]) == 1) {
            solids.add(
                    new CylinderObject(pose.center(), cylinder.radius(), cylinder.height()).oriented(pose.rotation()));
        } else if (object instanceof SphereObject sphere) {
            solids.add(new SphereObject(pose.center(), sphere.radius()));
        }
    }

    private static Ray[] rays(List<Pose> poses, RayPattern pattern) {
        Ray[] rays = new Ray[poses.size() * pattern.size()];
        for (int k = 0; k < rays.length; k++) {
            Pose pose = poses.get(k / pattern.size());
            Point d = pattern.direction(k % pattern.size());
            double[] r = pose.rotation();
            rays[k] = new Ray(
                    pose.center(),
                    new Point(
                            r[0] * d.x() + r[1] * d.y() + r[2] * d.z(),
                            r[3] * d.x() + r[4] * d.y() + r[5] * d.z(),
                            r[6] * d.x() + r[7] * d.y() + r[8] * d.z()));
        }
        return rays;
    }

    private static double[] frames(Geometry world, List<Pose> poses, String query) {
        RayPattern pattern = query.equals(Sensors.DEPTH) ? SensorScene.camera() : SensorScene.turn();
        SenseBuffer out = new SenseBuffer();
        double[] all = new double[poses.size() * pattern.size()];
        for (int k = 0; k < poses.size(); k++) {
            world.sense(poses.get(k), pattern, OPTIONS, out);
            System.arraycopy(out.distances(), 0, all, k * pattern.size(), pattern.size());
        }
        return all;
    }

    /** This module's frames, and the same rays one by one. */
    private static void ours(Geometry world, SensorScene scene, String query, Ray[] rays, Form form, Study.Sink sink) {
        RayPattern pattern = query.equals(Sensors.DEPTH) ? SensorScene.camera() : SensorScene.turn();
        int poses = scene.poses.size();
        SenseBuffer out = new SenseBuffer();
        InTurn tasks = new InTurn(form);
        tasks.add(Subject.module(Accuracy.EXACT, Dimension.SPATIAL), boxes(scene), query, poses, (from, count) -> {
            double sum = 0;
            for (int k = from; k < from + count; k++) {
                world.sense(scene.poses.get(k), pattern, OPTIONS, out);
                sum += out.distances()[k];
            }
            return sum;
        });
        tasks.add(Subject.peer(RAY_BY_RAY), boxes(scene), query, poses, (from, count) -> {
            double sum = 0;
            for (int k = from * pattern.size(); k < (from + count) * pattern.size(); k++) {
                sum += Math.min(1000, world.getRayDistance(rays[k], 0, SensorScene.RANGE, 0));
            }
            return sum;
        });
        tasks.run(sink, share -> {});
    }

    private void write(int size, List<GeometryObject> solids, Ray[] single, Ray[] frames) throws IOException {
        List<BoxObject> boxes = new ArrayList<>();
        List<CylinderObject> cylinders = new ArrayList<>();
        List<SphereObject> spheres = new ArrayList<>();
        for (GeometryObject solid : solids) {
            if (solid instanceof BoxObject box) {
                boxes.add(box);
            } else if (solid instanceof CylinderObject cylinder) {
                cylinders.add(cylinder);
            } else {
                spheres.add((SphereObject) solid);
            }
        }
        ByteBuffer out = ByteBuffer.allocate(28
                        + 8 * (15 * boxes.size() + 14 * cylinders.size() + 4 * spheres.size())
                        + 48 * (single.length + frames.length))
                .order(ByteOrder.LITTLE_ENDIAN);
        out.putInt(boxes.size()).putInt(cylinders.size()).putInt(spheres.size());
        out.putInt(single.length).putInt(frames.length).putDouble(100);
        for (BoxObject box : boxes) {
            put(out, box.center());
            out.putDouble(box.width() / 2).putDouble(box.height() / 2).putDouble(box.length() / 2);
            put(out, box.rotation());
        }
        for (CylinderObject cylinder : cylinders) {
            put(out, cylinder.center());
            out.putDouble(cylinder.radius()).putDouble(cylinder.height() / 2);
            put(out, cylinder.rotation());
        }
        for (SphereObject sphere : spheres) {
            put(out, sphere.center());
            out.putDouble(sphere.radius());
        }
        for (Ray[] rays : new Ray[][] {single, frames}) {
            for (Ray ray : rays) {
                put(out, ray.start());
                put(out, ray.direction());
            }
        }
        Files.write(folder.resolve("data").resolve("scene3d_" + size + ".bin"), out.array());
    }

    private static void put(ByteBuffer out, Point point) {
        out.putDouble(point.x()).putDouble(point.y()).putDouble(point.z());
    }

    private static void put(ByteBuffer out, double[] numbers) {
        for (double number : numbers) {
            out.putDouble(number);
        }
    }

    /** Runs Embree; keeps the least time of a ray of the lidar, and of the camera. */
    private void ask(double[] nanos) throws IOException {
        ProcessBuilder builder = new ProcessBuilder(program.toString(), "W5");
        builder.environment().put("REPS", "3");
        Process process = builder.directory(folder.toFile())
                .redirectError(ProcessBuilder.Redirect.DISCARD)
                .start();
        try (BufferedReader lines = process.inputReader()) {
            for (String line = lines.readLine(); line != null; line = lines.readLine()) {
                String[] words = line.split(" ", -1);
                if (words.length > 3 && words[2].equals("100")) {
                    int k = words[1].equals("W5") ? 0 : 1;
                    nanos[k] = Math.min(nanos[k], Double.parseDouble(words[3]));
                }
            }
        }
    }

    private double[] answers(String work, int count) throws IOException {
        ByteBuffer in = ByteBuffer.wrap(
                        Files.readAllBytes(folder.resolve("results").resolve(work + ".100.embree3-usergeom.f64")))
                .order(ByteOrder.LITTLE_ENDIAN);
        double[] answers = new double[count];
        for (int k = 0; k < count; k++) {
            answers[k] = in.getDouble();
        }
        return answers;
    }

    private static void judge(
            Subject subject,
            SensorScene scene,
            String query,
            List<GeometryObject> solids,
            Ray[] rays,
            double[] said,
            double[] ours,
            Study.Sink sink) {
        int wrong = 0;
        int judged = 0;
        for (int k = 0; k < rays.length; k += rays.length / SAMPLE) {
            judged++;
            wrong += isRight(said[k], truth(solids, rays[k])) ? 0 : 1;
        }
        int different = 0;
        double worst = 0;
        for (int k = 0; k < said.length; k++) {
            double off = said[k] == ours[k]
                    ? 0
                    : Math.abs(Math.min(said[k], SensorScene.RANGE) - Math.min(ours[k], SensorScene.RANGE));
            different += off >= 1e-3 ? 1 : 0;
            worst = Math.max(worst, off);
        }
        sink.put(subject, boxes(scene), query, JUDGED, judged);
        sink.put(subject, boxes(scene), query, WRONG, wrong);
        sink.put(subject, boxes(scene), query, DIFFERENT, different / (double) said.length);
        sink.put(subject, boxes(scene), query, WORST, worst);
    }

    private static boolean isRight(double said, @Nullable BigDecimal truth) {
        if (truth == null || said == Double.POSITIVE_INFINITY) {
            return truth == null && said == Double.POSITIVE_INFINITY;
        }
        return truth.subtract(new BigDecimal(said)).abs().doubleValue() <= RIGHT * SensorScene.RANGE;
    }

    /** The exact distance; null where nothing is within the range. */
    private static @Nullable BigDecimal truth(List<GeometryObject> solids, Ray ray) {
        BigDecimal least = null;
        for (GeometryObject solid : solids) {
            if (mayMeet(solid.bounds(), ray)) {
                BigDecimal distance = Reference.distance(ray, solid, Dimension.SPATIAL);
                if (distance != null && (least == null || distance.compareTo(least) < 0)) {
                    least = distance;
                }
            }
        }
        return least == null || least.doubleValue() > SensorScene.RANGE ? null : least;
    }

    /** Whether a ray comes near a box; says yes where it comes within a thousandth. */
    private static boolean mayMeet(Bounds box, Ray ray) {
        double[] low = {box.minX(), box.minY(), box.minZ()};
        double[] high = {box.maxX(), box.maxY(), box.maxZ()};
        double[] from = {ray.start().x(), ray.start().y(), ray.start().z()};
        double[] way = {
            ray.direction().x(), ray.direction().y(), ray.direction().z()
        };
        double enter = 0;
        double leave = Double.POSITIVE_INFINITY;
        for (int k = 0; k < 3; k++) {
            double slope = Math.abs(way[k]) < 1e-12 ? 1e-12 : way[k];
            double a = (low[k] - 1e-3 - from[k]) / slope;
            double b = (high[k] + 1e-3 - from[k]) / slope;
            enter = Math.max(enter, Math.min(a, b));
            leave = Math.min(leave, Math.max(a, b));
        }
        return enter <= leave * (1 + 1e-6);
    }
}
