package robosim.geometry.export;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.function.LongConsumer;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.exact.Degrees;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.RayPattern;
import robosim.geometry.net.session.RayPatterns;
import robosim.geometry.protocol.BatchAnswerBundle;
import robosim.geometry.protocol.BatchRequestBundle;
import robosim.geometry.protocol.Beam;
import robosim.geometry.protocol.DistanceBundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.SonarRequest;
import robosim.geometry.protocol.SonarRequestBundle;
import robosim.geometry.protocol.StepBundle;
import robosim.geometry.protocol.batch.BatchAnswer;
import robosim.geometry.protocol.batch.BatchRequest;
import robosim.geometry.protocol.batch.BeamPattern;
import robosim.geometry.protocol.batch.Mount;
import robosim.geometry.protocol.batch.Numbers;
import robosim.geometry.protocol.batch.PictureAnswer;
import robosim.geometry.protocol.batch.PictureRequest;
import robosim.geometry.protocol.batch.SenseAnswer;
import robosim.geometry.protocol.batch.SenseRequest;
import robosim.geometry.protocol.motion.BodyAnswer;
import robosim.geometry.protocol.motion.DriveCommand;
import robosim.geometry.protocol.motion.Velocity;
import robosim.geometry.scenario.Step;
import robosim.geometry.scenario.source.StepReader;
import robosim.geometry.viewer.playback.Colours;
import robosim.geometry.viewer.playback.Frame;
import robosim.geometry.viewer.playback.Replayer;
import robosim.geometry.viewer.scene.Scene;
import robosim.geometry.world.shared.AtomicFileWriter;

/**
 * Writes a recording as an MCAP file of ROS 2 messages, which Foxglove, RViz and PlotJuggler show; or as a WPILOG file for
 * AdvantageScope.
 *
 * <p>Axes are those of ROS: X as in the world, Y along the world's -Z, Z up. The frame of a moveable object is {@code
 * NAME/base_link}, at the bottom of its bounding box as it stands upright, below its centre, facing its forward direction. A
 * sensor's frame is {@code NAME/sensor_1} and so on, by its mount; from the seventeenth on, {@code NAME/sensor_turning}. What nothing carries is in the frame {@code world}.
 *
 * <p>Time is simulated: it begins at {@link #EPOCH_SECONDS} and advances by the duration of each step. Until the first step, a
 * bundle of moves takes a fixed time; moves within a batch take none. Equal recordings give equal files.
 */
public final class RosRecording {
    /** The ending of files of ROS 2 messages. */
    public static final String MCAP = ".mcap";

    /** The ending of logs for AdvantageScope. */
    public static final String WPILOG = ".wpilog";

    /** When each recording begins, seconds since 1970: the start of the year 2000. */
    public static final long EPOCH_SECONDS = 946_684_800;

    /** The duration of a bundle of moves, seconds, unless another one is given. */
    public static final double TICK = 0.1;

    /** How many sensors of an object have a frame and topics of their own; the others share one, which turns. */
    private static final int MOST_FRAMES = 16;

    private static final String WORLD = "world";
    private static final int TRIANGLES = 11;
    private static final int DELETE_ALL = 3;

    /** Of the entities of a scene. */
    private static final int ALL = 1;

    private static final double NANOS = 1e9;

    private final MessageSink out;
    private final double tick;
    private final Replayer replayer;
    private final Beam beam;

    private double seconds;
    private boolean hasSteps;

    /** The moveable objects of the world, where they are. */
    private final Map<String, Mover> movers = new LinkedHashMap<>();

    /** The frames of sensors, by object and mount. */
    private final Map<String, Map<Mount, String>> mounts = new HashMap<>();

    private final Map<String, String> names = new HashMap<>();

    /**
     * A moveable object.
     *
     * @param rise how high its centre is above its base
     */
    private record Mover(GeometryObject object, Pose pose, double rise) {
        private Mover at(Pose other) {
            return new Mover(object, other, rise);
        }
    }

    private RosRecording(StepReader recording, MessageSink out, double tick) {
        this.out = out;
        this.tick = tick;
        this.replayer = new Replayer(recording.header().options(), Colours.NONE);
        this.beam = recording.header().options().beam();
    }

    /**
     * Writes the rest of a recording: as a WPILOG file if its name ends in {@code .wpilog}, otherwise as MCAP. An existing file stays as it was until the new one is complete.
     *
     * @param tick     seconds that a bundle of moves stands for if the recording has no steps; above 0
     * @param progress called with the number of steps so far
     * @return how many steps there were
     * @throws IOException if the recording cannot be read, or the file not written
     */
    public static long write(StepReader recording, double tick, Path file, LongConsumer progress) throws IOException {
        Checks.present("recording", recording);
        Checks.positive("tick", tick);
        long[] count = new long[1];
        AtomicFileWriter.write(file, raw -> {
            OutputStream buffered = new BufferedOutputStream(raw, 1 << 16);
            MessageSink sink = hasEnding(file, WPILOG)
                    ? new WpilogWriter(buffered, EPOCH_SECONDS * 1_000_000_000)
                    : new McapWriter(buffered, new RosTypes(), "robosim-geometry");
            RosRecording ros = new RosRecording(recording, sink, tick);
            for (Step step = recording.next(); step != null; step = recording.next()) {
                ros.add(step);
                progress.accept(++count[0]);
            }
            sink.finish();
            buffered.flush();
        });
        return count[0];
    }

    /** Whether a file's name ends as that of a log does: {@link #MCAP} or {@link #WPILOG}. */
    public static boolean isLog(Path file) {
        return hasEnding(file, MCAP) || hasEnding(file, WPILOG);
    }

    private static boolean hasEnding(Path file, String ending) {
        return file.toString().toLowerCase(Locale.ROOT).endsWith(ending);
    }

    private void add(Step step) throws IOException {
        commands(step);
        advance(step);
        Frame frame = replayer.play(step);
        send("/clock", "rosgraph_msgs/Clock", List.of(stamp()));
        if (frame.opening() != null) {
            open(frame.opening());
        }
        place(frame.placed());
        answers(step);
    }

    private void advance(Step step) {
        if (step.request() instanceof StepBundle stepped) {
            hasSteps = true;
            seconds += stepped.seconds();
        } else if (!hasSteps && step.request() instanceof MoveBundle) {
            seconds += tick;
        }
    }

    /** Commands of drives are sent with the time at which their step begins. */
    private void commands(Step step) throws IOException {
        if (step.request() instanceof StepBundle stepped) {
            for (DriveCommand command : stepped.commands()) {
                send(
                        topic(command.objectName(), "cmd_vel"),
                        "geometry_msgs/Twist",
                        twist(command.forward(), 0, command.right(), command.turn()));
            }
        }
    }

    /** X, Y and Z of the world's or an object's own axes as a twist along X, left and up, and about up. */
    private static List<?> twist(double forward, double up, double right, double turn) {
        return List.of(List.of(forward, 0 - right, up), List.of(0.0, 0.0, turn));
    }

    private void open(Frame.Setting setting) throws IOException {
        movers.clear();
        mounts.clear();
        send("/markers", "visualization_msgs/MarkerArray", List.of(List.of(marker("", 0, DELETE_ALL, WORLD, null))));
        List<Object> markers = new ArrayList<>();
        List<Object> entities = new ArrayList<>();
        for (Scene.Thing thing : setting.statics()) {
            RosGeometry.Triangles shape = RosGeometry.placed(thing.object());
            String name = thing.object().name();
            markers.add(marker("static", markers.size(), 0, WORLD, shape));
            entities.add(entity(name == null ? "static " + entities.size() : name, WORLD, shape));
            if (thing.object() instanceof GridObject grid) {
                send("/map", "nav_msgs/OccupancyGrid", map(grid));
            }
        }
        for (Scene.Thing thing : setting.movers()) {
            GeometryObject object = thing.object();
            String name = Objects.requireNonNull(object.name()); // a moveable object has one
            double rise = RosGeometry.rise(object);
            movers.put(name, new Mover(object, object.pose(), rise));
            RosGeometry.Triangles shape = RosGeometry.own(object).raised(rise);
            markers.add(marker("moveable", markers.size(), 0, base(name), shape));
            entities.add(entity(name, base(name), shape));
        }
        send("/markers", "visualization_msgs/MarkerArray", List.of(markers));
        List<?> deletion = List.of(stamp(), ALL, "");
        send("/scene", "foxglove_msgs/SceneUpdate", List.of(List.of(deletion), entities));
        Map<String, Pose> all = new LinkedHashMap<>();
        movers.forEach((name, mover) -> all.put(name, mover.pose));
        place(all);
    }

    private List<?> marker(String space, int id, int action, String frame, RosGeometry.@Nullable Triangles shape) {
        List<?> color = shape == null ? List.of(0.0, 0.0, 0.0, 0.0) : shape.color();
        List<?> corners = shape == null ? List.of() : shape.corners();
        return List.of(
                header(frame),
                space,
                id,
                TRIANGLES,
                action,
                RosGeometry.IDENTITY,
                List.of(1.0, 1.0, 1.0),
                color,
                List.of(0, 0),
                true,
                corners,
                List.of(),
                "",
                List.of(header(""), "", new byte[0]),
                List.of(),
                "",
                "",
                List.of("", new byte[0]),
                false);
    }

    /** What Foxglove shows without a plugin for markers. */
    private List<?> entity(String id, String frame, RosGeometry.Triangles shape) {
        List<?> none = List.of();
        List<?> triangles = List.of(RosGeometry.IDENTITY, shape.corners(), shape.color(), none, none);
        return List.of(
                stamp(),
                frame,
                id,
                List.of(0, 0),
                true,
                none,
                none,
                none,
                none,
                none,
                none,
                List.of(triangles),
                none,
                none);
    }

    /** A grid's rows are counted along our Z, a map's along the Y of ROS, the other way. */
    private List<?> map(GridObject grid) {
        byte[] cells = new byte[grid.columns() * grid.rows()];
        for (int row = 0; row < grid.rows(); row++) {
            for (int column = 0; column < grid.columns(); column++) {
                cells[(grid.rows() - 1 - row) * grid.columns() + column] =
                        (byte) (grid.isOccupied(column, row) ? 100 : 0);
            }
        }
        return List.of(
                header(WORLD),
                List.of(stamp(), grid.cell(), grid.columns(), grid.rows(), RosGeometry.gridOrigin(grid)),
                cells);
    }

    private void place(Map<String, Pose> placed) throws IOException {
        List<Object> transforms = new ArrayList<>();
        for (Map.Entry<String, Pose> each : placed.entrySet()) {
            Mover mover = movers.get(each.getKey());
            if (mover != null) {
                movers.put(each.getKey(), mover.at(each.getValue()));
                transforms.add(List.of(
                        header(WORLD),
                        base(each.getKey()),
                        RosGeometry.pose(RosGeometry.below(each.getValue(), mover.rise))));
            }
        }
        if (!transforms.isEmpty()) {
            send("/tf", "tf2_msgs/TFMessage", List.of(transforms));
        }
    }

    private void answers(Step step) throws IOException {
        if (step.expected() == null || step.request() instanceof InitBundle) {
            return;
        }
        Object answer = step.expected().bundle();
        if (step.request() instanceof SonarRequestBundle sonars && answer instanceof DistanceBundle distances) {
            for (int k = 0; k < sonars.requests().size(); k++) {
                sonar(sonars.requests().get(k), distances.distances().get(k));
            }
        } else if (step.request() instanceof BatchRequestBundle batch && answer instanceof BatchAnswerBundle answers) {
            for (int k = 0; k < batch.requests().size(); k++) {
                item(batch.requests().get(k), answers.answers().get(k));
            }
        } else if (answer instanceof StepBundle.Answer stepped) {
            for (BodyAnswer body : stepped.bodies()) {
                odometry(body);
            }
        }
    }

    private void odometry(BodyAnswer body) throws IOException {
        Mover mover = movers.get(body.objectName());
        if (mover == null) {
            return;
        }
        Velocity v = body.velocity();
        send(
                topic(body.objectName(), "odom"),
                "nav_msgs/Odometry",
                List.of(
                        header(WORLD),
                        base(body.objectName()),
                        List.of(RosGeometry.pose(RosGeometry.below(mover.pose, mover.rise)), new double[36]),
                        List.of(twist(v.x(), v.y(), v.z(), v.ry()), new double[36])));
    }

    private void sonar(SonarRequest request, double distance) throws IOException {
        Beam used = request.beam() == null ? beam : request.beam();
        double heading = Degrees.toDegrees(StrictMath.atan2(0 - request.zOffset(), request.xOffset()));
        double[] turned = Pose.of(new Point(), heading).rotation();
        String frame = frame(request.objectName(), new Mount(new Point(), Numbers.of(turned)));
        range(request.objectName(), frame, used, distance);
    }

    private void range(String name, String frame, Beam used, double distance) throws IOException {
        send(
                topic(name, "range", frame),
                "sensor_msgs/Range",
                List.of(header(frame), used.width() > 0 ? 0 : 1, used.width(), used.min(), used.max(), distance));
    }

    private void item(BatchRequest request, BatchAnswer answer) throws IOException {
        if (request instanceof SenseRequest sense && answer instanceof SenseAnswer sensed) {
            sense(sense, sensed);
        } else if (request instanceof PictureRequest picture && answer instanceof PictureAnswer taken) {
            String frame = frame(picture.objectName(), picture.mount());
            camera(picture.objectName(), frame, picture.camera(), "rgb8", 3, taken.rgb());
        }
    }

    private void sense(SenseRequest request, SenseAnswer answer) throws IOException {
        String name = request.objectName();
        String frame = frame(name, request.mount());
        Numbers distances = answer.distances();
        if (request.width() > 0) {
            for (int k = 0; k < distances.size(); k++) {
                Beam cone = new Beam(request.min(), request.max(), request.width());
                range(name, frame, cone, distances.get(k)); // the beams of a ring share a topic
            }
        } else if (request.pattern() instanceof BeamPattern.Fan fan) {
            float[] ranges = new float[distances.size()];
            for (int k = 0; k < ranges.length; k++) {
                ranges[k] = (float) distances.get(k);
            }
            send(
                    topic(name, "scan", frame),
                    "sensor_msgs/LaserScan",
                    List.of(
                            header(frame),
                            fan.first(),
                            fan.first() + (fan.count() - 1) * fan.step(),
                            fan.step(),
                            0.0,
                            0.0,
                            request.min(),
                            request.max(),
                            ranges,
                            new float[0]));
        } else if (request.pattern() instanceof BeamPattern.Pinhole pinhole) {
            camera(name, frame, pinhole, "32FC1", 4, depths(pinhole, distances));
        } else {
            cloud(name, frame, RayPatterns.make(request.pattern()), answer);
        }
    }

    /** Along the camera's axis, as ROS has them. */
    private static byte[] depths(BeamPattern.Pinhole pinhole, Numbers distances) {
        RayPattern rays = RayPatterns.make(pinhole);
        ByteBuffer depths = ByteBuffer.allocate(4 * distances.size()).order(ByteOrder.LITTLE_ENDIAN);
        for (int k = 0; k < distances.size(); k++) {
            Point d = rays.direction(k);
            double length = Math.sqrt(d.x() * d.x() + d.y() * d.y() + d.z() * d.z());
            depths.putFloat((float) (distances.get(k) * d.x() / length));
        }
        return depths.array();
    }

    private void cloud(String name, String frame, RayPattern rays, SenseAnswer answer) throws IOException {
        int size = answer.distances().size();
        ByteBuffer points = ByteBuffer.allocate(12 * size).order(ByteOrder.LITTLE_ENDIAN);
        boolean isDense = true;
        for (int k = 0; k < size; k++) {
            Point d = rays.direction(k);
            double length = Math.sqrt(d.x() * d.x() + d.y() * d.y() + d.z() * d.z());
            double distance = answer.distances().get(k);
            boolean isHit = Math.abs(distance) < Double.POSITIVE_INFINITY;
            isDense &= isHit;
            double share = isHit ? distance / length : Double.NaN;
            points.putFloat((float) (d.x() * share));
            points.putFloat((float) (0 - d.z() * share));
            points.putFloat((float) (d.y() * share));
        }
        List<Object> fields = new ArrayList<>();
        for (String axis : List.of("x", "y", "z")) {
            fields.add(List.of(axis, 4 * fields.size(), 7, 1));
        }
        int rows = rays.rows();
        send(
                topic(name, "points", frame),
                "sensor_msgs/PointCloud2",
                List.of(
                        header(frame),
                        rows,
                        size / rows,
                        fields,
                        false,
                        12,
                        12 * (size / rows),
                        points.array(),
                        isDense));
    }

    private void camera(
            String name, String frame, BeamPattern.Pinhole camera, String encoding, int pixelBytes, byte[] pixels)
            throws IOException {
        double f = camera.width() / 2.0 / StrictMath.tan(camera.fieldOfView() / 2);
        double cx = (camera.width() - 1) / 2.0; // counted from the middle of the first pixel, as ROS does
        double cy = (camera.height() - 1) / 2.0;
        String optical = optical(frame);
        send(
                topic(name, pixelBytes == 3 ? "image" : "depth", frame),
                "sensor_msgs/Image",
                List.of(
                        header(optical),
                        camera.height(),
                        camera.width(),
                        encoding,
                        0,
                        pixelBytes * camera.width(),
                        pixels));
        send(
                topic(name, pixelBytes == 3 ? "image_info" : "depth_info", frame),
                "sensor_msgs/CameraInfo",
                List.of(
                        header(optical),
                        camera.height(),
                        camera.width(),
                        "plumb_bob",
                        new double[5],
                        new double[] {f, 0, cx, 0, f, cy, 0, 0, 1},
                        new double[] {1, 0, 0, 0, 1, 0, 0, 0, 1},
                        new double[] {f, 0, cx, 0, 0, f, cy, 0, 0, 0, 1, 0},
                        0,
                        0,
                        List.of(0, 0, 0, 0, false)));
    }

    /** The frame of a sensor on an object; sent once, or each time if it is one of too many. */
    private String frame(String name, Mount mount) throws IOException {
        Map<Mount, String> known = mounts.computeIfAbsent(name, unseen -> new HashMap<>());
        String frame = known.get(mount);
        if (frame != null) {
            return frame;
        }
        Mover mover = movers.get(name);
        String space = mover == null ? "" : called(name) + "/";
        boolean isFixed = known.size() < MOST_FRAMES;
        frame = space + (isFixed ? "sensor_" + (known.size() + 1) : "sensor_turning");
        Pose pose = mount.pose();
        Point c = pose.center();
        Pose raised = pose.movedTo(new Point(c.x(), c.y() + (mover == null ? 0 : mover.rise), c.z()));
        List<?> transform = List.of(header(mover == null ? WORLD : base(name)), frame, RosGeometry.pose(raised));
        send(isFixed ? "/tf_static" : "/tf", "tf2_msgs/TFMessage", List.of(List.of(transform)));
        if (isFixed) {
            known.put(mount, frame);
        }
        return frame;
    }

    /** A camera's frame in which X is right, Y down and Z forward. */
    private String optical(String frame) throws IOException {
        String optical = frame + "_optical";
        if (mounts.computeIfAbsent(optical, unseen -> new HashMap<>()).put(Mount.CENTER, optical) == null) {
            List<?> transform = List.of(header(frame), optical, RosGeometry.OPTICAL);
            send("/tf_static", "tf2_msgs/TFMessage", List.of(List.of(transform)));
        }
        return optical;
    }

    /** A name of ROS for an object, another one for each. */
    private String called(String name) {
        return names.computeIfAbsent(name, unseen -> {
            String text = RosGeometry.text(name);
            int number = 2;
            String unique = text;
            while (names.containsValue(unique)) {
                unique = text + "_" + number++;
            }
            return unique;
        });
    }

    private String base(String name) {
        return called(name) + "/base_link";
    }

    private String topic(String name, String what) {
        return name.isEmpty() ? "/" + what : "/" + called(name) + "/" + what;
    }

    /** The first frame of an object has the plain topic, the others a number. */
    private String topic(String name, String what, String frame) {
        String number = frame.substring(frame.lastIndexOf('_') + 1);
        return topic(name, number.equals("1") ? what : what + "_" + number);
    }

    private List<?> header(String frame) {
        return List.of(stamp(), frame);
    }

    private List<?> stamp() {
        long nanos = nanos();
        return List.of(nanos / 1_000_000_000, nanos % 1_000_000_000);
    }

    private long nanos() {
        return EPOCH_SECONDS * 1_000_000_000 + Math.round(seconds * NANOS);
    }

    private void send(String topic, String type, List<?> value) throws IOException {
        out.write(topic, type, nanos(), value);
    }
}
