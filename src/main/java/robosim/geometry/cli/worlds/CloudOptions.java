package robosim.geometry.cli.worlds;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import picocli.CommandLine.Option;
import robosim.geometry.Snapshot;
import robosim.geometry.cli.terminal.Arguments;
import robosim.geometry.cli.terminal.UsageException;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.render.ColorCamera;
import robosim.geometry.sensor.Lidar;
import robosim.geometry.sensor.LidarFrame;
import robosim.geometry.sensor.PointCloud;

/** The options of a picture of what lidars measure, and the picture. */
public final class CloudOptions {
    /** Radius of a point, as a share of its distance from the camera, and the most pixels of it. */
    private static final double RADIUS = 0.0011;

    private static final double MOST_RADIUS = 3;

    /** The share of points that may be lower than the first colour, or higher than the last one. */
    private static final double BEYOND = 0.01;

    @Option(
            names = "--lidar",
            paramLabel = "MODEL",
            defaultValue = "os1-128",
            description = "of --show points: ${COMPLETION-CANDIDATES} (default: ${DEFAULT-VALUE})")
    private LidarModel model = LidarModel.OS1_128;

    @Option(
            names = "--from",
            paramLabel = "PLACE",
            description =
                    "of --show points: where the lidar is, robot:NAME or X,Y,Z; may be repeated (default: all robots)")
    private List<String> places = new ArrayList<>();

    /** All points that lidars at the given places see, drawn as a camera sees them; the higher, the lighter. */
    int[] picture(ColorCamera camera, CameraWorld studio, Snapshot world, double metres) {
        PointCloud cloud = cloud(studio, world, metres);
        int samples = camera.samples();
        int width = camera.width() * samples;
        int height = camera.height() * samples;
        Raster raster = new Raster(width, new int[width * height], new double[width * height]);
        Arrays.fill(raster.pixels, PictureStyle.NOTHING);
        Arrays.fill(raster.nearest, Double.POSITIVE_INFINITY);
        double[] heights = new double[cloud.size()];
        for (int k = 0; k < heights.length; k++) {
            heights[k] = cloud.y(k);
        }
        double[] sorted = heights.clone();
        Arrays.sort(sorted);
        int last = sorted.length - 1;
        double low = last < 0 ? 0 : sorted[(int) (BEYOND * last)];
        double high = last < 0 ? 1 : sorted[(int) ((1 - BEYOND) * last)];
        Pose pose = studio.pose(camera);
        Point eye = pose.center();
        double[] r = pose.rotation();
        double focal = width / 2.0 / StrictMath.tan(StrictMath.toRadians(camera.fieldOfView() / 2));
        for (int k = 0; k < heights.length; k++) {
            double dx = cloud.x(k) - eye.x();
            double dy = cloud.y(k) - eye.y();
            double dz = cloud.z(k) - eye.z();
            double ahead = r[0] * dx + r[3] * dy + r[6] * dz;
            if (ahead <= 0) {
                continue;
            }
            double x = width / 2.0 + focal * (r[2] * dx + r[5] * dy + r[8] * dz) / ahead;
            double y = height / 2.0 - focal * (r[1] * dx + r[4] * dy + r[7] * dz) / ahead;
            double bright = Math.min(1, 0.45 + 0.55 * cloud.value(PointCloud.Field.INTENSITY, k));
            int colour = PictureStyle.mixed(
                    PictureStyle.NOTHING,
                    PictureStyle.ramp(1 - (heights[k] - low) / (high - low) * 0.85 - 0.05),
                    bright);
            double radius =
                    Math.min(MOST_RADIUS * samples, Math.max(0.5, RADIUS * focal * studio.depth(camera) / ahead));
            raster.dot(x, y, radius, ahead, colour);
        }
        return PictureStyle.means(raster.pixels, camera.width(), camera.height(), samples);
    }

    /**
     * Colours of samples.
     *
     * @param nearest how far ahead what a sample shows is
     */
    @SuppressWarnings("ArrayRecordComponent") // is never compared
    private record Raster(int width, int[] pixels, double[] nearest) {
        void dot(double x, double y, double radius, double ahead, int colour) {
            int height = pixels.length / width;
            for (int row = (int) Math.max(0, y - radius); row <= Math.min(height - 1, y + radius); row++) {
                for (int column = (int) Math.max(0, x - radius); column <= Math.min(width - 1, x + radius); column++) {
                    double dx = column + 0.5 - x;
                    double dy = row + 0.5 - y;
                    int at = row * width + column;
                    if (dx * dx + dy * dy <= radius * radius && ahead < nearest[at]) {
                        nearest[at] = ahead;
                        pixels[at] = colour;
                    }
                }
            }
        }
    }

    private PointCloud cloud(CameraWorld studio, Snapshot world, double metres) {
        Lidar lidar = model.lidar();
        lidar = lidar.withRange(lidar.options().min() / metres, lidar.options().max() / metres)
                .withThreads(Runtime.getRuntime().availableProcessors());
        PointCloud cloud = new PointCloud(PointCloud.Field.INTENSITY);
        LidarFrame frame = new LidarFrame(LidarFrame.Extra.INTENSITIES);
        List<String> all = new ArrayList<>(places);
        if (all.isEmpty()) {
            studio.carriers().forEach(name -> all.add(CameraOptions.ROBOT + name));
        }
        if (all.isEmpty()) {
            throw new UsageException("--from must be given for a world without moveable objects (got: none)");
        }
        for (String place : all) {
            placed(lidar, place, studio).read(world, 0, frame);
            frame.addInWorldTo(cloud);
        }
        return cloud;
    }

    private Lidar placed(Lidar lidar, String place, CameraWorld studio) {
        if (!place.startsWith(CameraOptions.ROBOT)) {
            return lidar.at(Pose.of(Arguments.point("--from", "robot:NAME or X,Y,Z, three numbers", place), 0));
        }
        String name = place.substring(CameraOptions.ROBOT.length());
        if (!studio.carriers().contains(name)) {
            throw new UsageException("--from robot:NAME must name a moveable object of the world, "
                    + studio.choice(name) + " (got: " + name + ")");
        }
        return lidar.on(name, Pose.of(new Point(0, studio.top(name), 0), 0));
    }
}
