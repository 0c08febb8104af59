package robosim.geometry.cli.worlds;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;
import robosim.geometry.Snapshot;
import robosim.geometry.check.NumberText;
import robosim.geometry.check.Text;
import robosim.geometry.cli.terminal.Arguments;
import robosim.geometry.cli.terminal.ExitCodes;
import robosim.geometry.cli.terminal.Progress;
import robosim.geometry.cli.terminal.UsageException;
import robosim.geometry.collision.CollisionDetection;
import robosim.geometry.exact.Degrees;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.RayPattern;
import robosim.geometry.model.SphereObject;
import robosim.geometry.sensor.DepthCamera;
import robosim.geometry.sensor.DepthFrame;
import robosim.geometry.sensor.Intrinsics;
import robosim.geometry.sensor.Lidar;
import robosim.geometry.sensor.LidarFrame;
import robosim.geometry.sensor.Noise;
import robosim.geometry.sensor.NpyWriter;
import robosim.geometry.sensor.PointCloud;
import robosim.geometry.sensor.RayFrame;
import robosim.geometry.sensor.RaySensor;
import robosim.geometry.world.SdfSensor;
import robosim.geometry.world.World;
import robosim.geometry.world.WorldObject;

/** Scans a world with a lidar or a depth camera. */
@Command(
        name = "scan",
        description =
                "Scans a world with a lidar or a depth camera and writes what it sees as a point cloud, or its ranges"
                        + " or depths as an array.",
        footer = {
            "  robosim-geometry scan worlds/rooms.xml -o cloud.ply",
            "  robosim-geometry scan worlds/warehouse.xml --lidar os1-128 --at 0,2,0 --in-world -o cloud.pcd",
            "  robosim-geometry scan arena.sdf --sensor front_laser --seed 7 -o cloud.ply",
            "  robosim-geometry scan worlds/maze.xml --depth 640x480,70 --on cart --at 0.2,0.3,0 -o depth.npy",
            "  robosim-geometry scan worlds/rooms.xml --lidar utm30lx --noise 0.01 --seed 7 -o ranges.npy"
        })
public final class ScanCommand implements Callable<Integer> {
    /** Reading the world, building it, scanning and writing. */
    private static final int PHASES = 4;

    @Spec
    private CommandSpec spec;

    @Mixin
    private WorldOptions world;

    @Option(
            names = {"-o", "--output"},
            paramLabel = "FILE",
            required = true,
            description = "a point cloud (.ply or .pcd), or the ranges by ring and column (.npy)")
    private Path output = Path.of("");

    @Option(
            names = "--lidar",
            paramLabel = "MODEL",
            defaultValue = "vlp16",
            description = "${COMPLETION-CANDIDATES} (default: ${DEFAULT-VALUE})")
    private LidarModel model = LidarModel.VLP16;

    @Option(
            names = "--depth",
            paramLabel = "WxH[,DEGREES]",
            description =
                    "a depth camera instead of a lidar: its pixels, and its horizontal field of view (80 if it is left"
                            + " out); as .npy the depths along its optical axis by row and column")
    private @Nullable String depth;

    @Option(
            names = "--sensor",
            paramLabel = "NAME",
            description =
                    "a lidar or depth camera that WORLD, in SDFormat, describes; with its noise, where it is mounted")
    private @Nullable String sensor;

    @Option(
            names = "--on",
            paramLabel = "NAME",
            description = "the moveable object that carries it (default: the first one, unless --at is given)")
    private @Nullable String carrier;

    @Option(
            names = "--at",
            paramLabel = "X,Y,Z[,HEADING]",
            description = "its place and heading in degrees, in the frame of --on or else of the world")
    private @Nullable String at;

    @Option(names = "--in-world", description = "points in the frame of the world, instead of the lidar's own")
    private boolean inWorld;

    @Option(
            names = "--axes",
            paramLabel = "AXES",
            defaultValue = "ros",
            description = "of the points: ros (Z up, Y to the left) or module (Y up, Z to the right)"
                    + " (default: ${DEFAULT-VALUE})")
    private CloudAxes axes = CloudAxes.ROS;

    @Option(
            names = "--noise",
            paramLabel = "METRES",
            defaultValue = "0",
            description = "standard deviation of a normal error (default: ${DEFAULT-VALUE})")
    private double noise;

    @Option(
            names = "--seed",
            paramLabel = "NUMBER",
            defaultValue = "0",
            description = "of the noise (default: ${DEFAULT-VALUE})")
    private long seed;

    /** Axes of points, as the command line names them. */
    enum CloudAxes {
        ROS(PointCloud.Axes.ROS),
        MODULE(PointCloud.Axes.MODULE);

        private final PointCloud.Axes axes;

        CloudAxes(PointCloud.Axes axes) {
            this.axes = axes;
        }
    }

    private static final int DIGITS = 6;

    private static final Pattern PIXELS = Pattern.compile("(\\d{1,5})x(\\d{1,5})(?:,(\\d{1,3}(?:\\.\\d{1,9})?))?");

    /** The field of view of a depth camera: those that robots carry have 70 to 90 degrees. */
    private static final double USUAL_DEGREES = 80;

    @Override
    public Integer call() throws Exception {
        String name = output.toString().toLowerCase(Locale.ROOT);
        Arguments.output("FILE", output, ".ply", ".pcd", ".npy");
        Arguments.refuse(
                !(noise >= 0 && noise <= 1000),
                "--noise must be from 0 to 1000",
                noise); // written so that NaN fails it
        if (sensor != null && (carrier != null || at != null)) {
            throw new UsageException("--on and --at must not be given with --sensor, which is where WORLD says");
        }
        if (sensor != null && depth != null) {
            throw new UsageException(
                    "--depth must not be given with --sensor, which is what WORLD says (got: " + depth + ")");
        }
        Intrinsics pixels = depth == null ? null : pixels(depth);
        String what;
        try (Progress progress = Progress.of(spec.commandLine(), "scanning", PHASES)) {
            World read = world.read();
            world.keep("FILE", output);
            progress.at(1, () -> "building the world");
            Snapshot snapshot = read.toGeometry().snapshot();
            String described = sensor;
            if (described == null) {
                double metres = read.unit() == null ? 1 : read.unit().metres();
                Noise its = noise > 0 ? Noise.gaussian(noise / metres) : Noise.NONE;
                if (pixels == null) {
                    Lidar lidar = placed(read, model.lidar());
                    lidar = lidar.withRange(
                            lidar.options().min() / metres, lidar.options().max() / metres);
                    what = scan(snapshot, noisy(lidar, its), name, progress);
                } else {
                    what = scan(snapshot, noisy(placed(read, DepthCamera.of(pixels)), its), name, progress);
                }
            } else {
                what = scan(read, snapshot, described, name, progress);
            }
        }
        spec.commandLine().getOut().println("Wrote " + output + ": " + what);
        return ExitCodes.FINE;
    }

    /** Scans with a sensor that the world's file describes. */
    private String scan(World read, Snapshot snapshot, String described, String name, Progress progress)
            throws Exception {
        SdfSensor found = world.sensor("--sensor", described);
        warn(read, found);
        try {
            Noise its = found.noise().and(noise > 0 ? Noise.gaussian(noise) : Noise.NONE);
            return switch (found.kind()) {
                case LIDAR -> scan(snapshot, found.lidar().withNoise(its, seed, found.name()), name, progress);
                case DEPTH -> scan(snapshot, found.depthCamera().withNoise(its, seed, found.name()), name, progress);
                case SEGMENTATION, NORMALS, COLOR, OTHER ->
                    throw new UsageException("--sensor must be a lidar or a depth camera (got: " + found.name()
                            + " of type " + found.type() + ")");
            };
        } catch (IllegalArgumentException e) {
            throw new UsageException(String.valueOf(e.getMessage()));
        }
    }

    /** Warns of a sensor in what stands still, which it sees: a robot is invisible to its own sensors only. */
    private void warn(World read, SdfSensor found) {
        if (found.carrier() != null) {
            return;
        }
        SphereObject lens = new SphereObject(found.pose().center(), 0);
        for (WorldObject each : read.objects()) {
            if (CollisionDetection.intersects(each.object(), lens)) {
                spec.commandLine()
                        .getErr()
                        .println("warning: the sensor " + found.name() + " is inside " + each.object()
                                + ", so it sees nothing else; a model that is not <static> is invisible to its own"
                                + " sensors");
            }
        }
    }

    /** With noise of its own: a sensor that the file does not name goes by the name of what carries it. */
    private <S extends RaySensor<S, ?>> S noisy(S by, Noise its) {
        String on = by.carrier();
        return by.withNoise(its, seed, on == null ? "" : on);
    }

    private static int threads() {
        return Runtime.getRuntime().availableProcessors();
    }

    private String scan(Snapshot snapshot, Lidar lidar, String name, Progress progress) throws IOException {
        LidarFrame frame = new LidarFrame(LidarFrame.Extra.INTENSITIES, LidarFrame.Extra.OBJECTS);
        read(lidar.withThreads(threads()), snapshot, frame, progress);
        return write(
                frame,
                lidar.pattern(),
                frame.ranges(),
                "ranges",
                name,
                new PointCloud(
                        PointCloud.Field.INTENSITY,
                        PointCloud.Field.RING,
                        PointCloud.Field.TIME,
                        PointCloud.Field.LABEL));
    }

    private String scan(Snapshot snapshot, DepthCamera camera, String name, Progress progress) throws IOException {
        DepthFrame frame = new DepthFrame();
        read(camera.withThreads(threads()), snapshot, frame, progress);
        return write(frame, camera.pattern(), frame.depths(), "depths", name, new PointCloud());
    }

    private Intrinsics pixels(String text) {
        Matcher match = PIXELS.matcher(text);
        if (match.matches()) {
            try {
                double degrees = match.group(3) == null ? USUAL_DEGREES : Double.parseDouble(match.group(3));
                return Intrinsics.fieldOfView(
                        Integer.parseInt(match.group(1)), Integer.parseInt(match.group(2)), degrees);
            } catch (IllegalArgumentException e) {
                throw new UsageException("--depth: " + e.getMessage());
            }
        }
        throw new UsageException("--depth must be WxH or WxH,DEGREES, such as 640x480,70 (got: " + text + ")");
    }

    private static <S extends RaySensor<S, F>, F extends RayFrame> void read(
            S by, Snapshot snapshot, F frame, Progress progress) {
        progress.at(2, () -> NumberText.count(by.pattern().size(), "ray"));
        by.read(snapshot, 0, frame);
        progress.at(3, () -> "writing");
    }

    /** Writes distances, called by the word, or points; returns what was written. */
    private String write(
            RayFrame frame, RayPattern pattern, double[] distances, String word, String name, PointCloud cloud)
            throws IOException {
        if (name.endsWith(".npy")) {
            NpyWriter.write(distances, output, frame.rows(), frame.columns());
            return frame.rows() + " x " + frame.columns() + " " + word + columns(pattern);
        } else {
            if (inWorld) {
                frame.addInWorldTo(cloud);
            } else {
                frame.addTo(cloud);
            }
            if (name.endsWith(".ply")) {
                cloud.writePly(axes.axes, output);
            } else {
                cloud.writePcd(axes.axes, output);
            }
            return NumberText.count(cloud.size(), "point") + " of " + NumberText.count(frame.size(), "ray");
        }
    }

    /** Where the columns of the first row point, in words; empty for less than two. */
    private static String columns(RayPattern pattern) {
        int last = pattern.columns() - 1;
        if (last < 1) {
            return "";
        }
        return "; column 0 points " + NumberText.digits(bearing(pattern, 0), DIGITS) + " degrees from ahead, column 1 "
                + NumberText.digits(bearing(pattern, 1), DIGITS) + ", the last "
                + NumberText.digits(bearing(pattern, last), DIGITS) + ", counter-clockwise";
    }

    /** The direction of a ray about the vertical, counter-clockwise from ahead, degrees. */
    private static double bearing(RayPattern pattern, int ray) {
        return Degrees.toDegrees(StrictMath.atan2(-pattern.z(ray), pattern.x(ray)));
    }

    private <S extends RaySensor<S, F>, F extends RayFrame> S placed(World read, S by) {
        Pose pose = at == null ? Pose.ORIGIN : pose(at);
        String on = carrier;
        if (on == null && at != null) {
            return by.at(pose);
        }
        List<String> moveable = read.objects().stream()
                .map(each -> each.object())
                .filter(GeometryObject::isMoveable)
                .map(object -> String.valueOf(object.name()))
                .toList();
        if (on == null) {
            if (moveable.isEmpty()) {
                throw new UsageException("--at must be given for a world without moveable objects (got: none)");
            }
            on = moveable.get(0);
        } else if (!moveable.contains(on)) {
            throw new UsageException("--on must be the name of a moveable object of WORLD, "
                    + (moveable.isEmpty() ? "which has none" : Text.choice(on, moveable)) + " (got: " + on
                    + ")");
        }
        return by.on(on, pose);
    }

    private static Pose pose(String text) {
        double[] at = Arguments.numbers(text, 3, 4);
        try {
            if (at != null) {
                return Pose.of(new Point(at[0], at[1], at[2]), at.length == 4 ? at[3] : 0);
            }
        } catch (IllegalArgumentException e) {
            // refused below
        }
        throw new UsageException("--at must be X,Y,Z or X,Y,Z,HEADING, all of them numbers (got: " + text + ")");
    }
}
