package robosim.geometry.sensor.file;

import java.util.Map;
import java.util.TreeMap;
import robosim.geometry.check.Checks;
import robosim.geometry.exact.Degrees;
import robosim.geometry.model.RayPattern;
import robosim.geometry.model.SenseOptions;
import robosim.geometry.sensor.DepthCamera;
import robosim.geometry.sensor.Intrinsics;
import robosim.geometry.sensor.Lidar;
import robosim.geometry.sensor.Noise;
import robosim.geometry.sensor.NormalCamera;
import robosim.geometry.sensor.OutOfRange;
import robosim.geometry.sensor.RaySensor;
import robosim.geometry.sensor.SegmentationCamera;
import robosim.geometry.world.SdfReader;

/**
 * Makes the sensors that SDFormat describes, where they are mounted, without their noise: {@link #noise} is that.
 *
 * <p>What a file leaves out is what SDFormat says: a lidar of 640 rays straight ahead, a camera of 320 x 240 pixels and 1.047
 * radians that sees from 0.1 to 100 m. A lidar has {@code samples} times {@code resolution} rays in each direction; its rays
 * are sent all at once, as SDFormat's are. Near and far ends of a camera's view are taken along its rays. What is out of range
 * is reported as Gazebo does: {@link OutOfRange#REP_117}. The {@code
 * resolution} of a range is not applied, as Gazebo does not; {@link Noise#quantized} does that.
 */
public final class SdfSensors {
    private SdfSensors() {}

    /** What a sensor of SDFormat measures, as far as this module has it. */
    public enum Kind {
        /** Types {@code lidar}, {@code gpu_lidar}, {@code ray} and {@code gpu_ray}. */
        LIDAR,
        /** Types {@code depth_camera}, {@code depth} and {@code rgbd_camera}; the latter sees colour too. */
        DEPTH,
        /** Types {@code segmentation_camera} and {@code segmentation}. */
        SEGMENTATION,
        /** Type {@code normal_camera}. */
        NORMALS,
        /** Type {@code camera}: for {@code robosim.geometry.render.ColorCamera}. */
        COLOR,
        /** Any other type. */
        OTHER;

        private static Kind of(String type) {
            return switch (type) {
                case "lidar", "gpu_lidar", "ray", "gpu_ray" -> LIDAR;
                case "depth_camera", "depth", "rgbd_camera" -> DEPTH;
                case "segmentation_camera", "segmentation" -> SEGMENTATION;
                case "normal_camera" -> NORMALS;
                case "camera" -> COLOR;
                default -> OTHER;
            };
        }

        /** Whether it has an image. */
        public boolean isCamera() {
            return this != LIDAR && this != OTHER;
        }
    }

    /** What a sensor measures. */
    public static Kind kind(SdfReader.Sensor sensor) {
        return Kind.of(Checks.present("sensor", sensor).type());
    }

    /** Readings a second; 0 if the file does not say. */
    public static double updateRate(SdfReader.Sensor sensor) {
        return number(Checks.present("sensor", sensor), "update_rate", 0);
    }

    /**
     * A lidar.
     *
     * @throws IllegalArgumentException naming the sensor, if it is none or has numbers that no lidar has
     */
    public static Lidar lidar(SdfReader.Sensor sensor) {
        check(sensor, Kind.LIDAR);
        try {
            int columns = rays(sensor, "scan/horizontal/", 640);
            int rows = rays(sensor, "scan/vertical/", 1);
            double[] elevations = new double[rows];
            double step = step(sensor, "scan/vertical/", rows);
            double lowest = first(sensor, "scan/vertical/", rows);
            for (int row = 0; row < rows; row++) {
                elevations[row] = lowest + row * step;
            }
            double first = first(sensor, "scan/horizontal/", columns);
            double aside = step(sensor, "scan/horizontal/", columns);
            RayPattern pattern = rows == 1 && elevations[0] == 0
                    ? RayPattern.fan(first, aside, columns)
                    : RayPattern.layers(elevations, first, aside, columns);
            double min = number(sensor, "range/min", 0);
            double max = number(sensor, "range/max", Double.POSITIVE_INFINITY);
            return mounted(Lidar.of(pattern, SenseOptions.range(min, max)).withOutOfRange(OutOfRange.REP_117), sensor);
        } catch (IllegalArgumentException e) {
            throw refused(sensor, e);
        }
    }

    /** Size and lens of a camera of any kind. */
    public static Intrinsics intrinsics(SdfReader.Sensor sensor) {
        if (!kind(sensor).isCamera()) {
            throw new IllegalArgumentException(
                    "sensor must be a camera (got: " + sensor.name() + " of type " + sensor.type() + ")");
        }
        try {
            return Intrinsics.fieldOfView(
                    whole(sensor, "image/width", 320), whole(sensor, "image/height", 240), fieldOfView(sensor));
        } catch (IllegalArgumentException e) {
            throw refused(sensor, e);
        }
    }

    /** Horizontal field of view of a camera of any kind, in degrees. */
    public static double fieldOfView(SdfReader.Sensor sensor) {
        return Degrees.toDegrees(number(Checks.present("sensor", sensor), "horizontal_fov", 1.047));
    }

    /** A depth camera. */
    public static DepthCamera depthCamera(SdfReader.Sensor sensor) {
        check(sensor, Kind.DEPTH);
        return clipped(DepthCamera.of(intrinsics(sensor)), sensor);
    }

    /** A camera of objects and labels. */
    public static SegmentationCamera segmentationCamera(SdfReader.Sensor sensor) {
        check(sensor, Kind.SEGMENTATION);
        return clipped(SegmentationCamera.of(intrinsics(sensor)), sensor);
    }

    /** A camera of normals. */
    public static NormalCamera normalCamera(SdfReader.Sensor sensor) {
        check(sensor, Kind.NORMALS);
        return clipped(NormalCamera.of(intrinsics(sensor)), sensor);
    }

    /**
     * The noise of a lidar's ranges or of a camera's pixels, {@link Noise#NONE} if it has none: see {@link SdfNoise}.
     *
     * @throws IllegalArgumentException naming the sensor, if it is not noise of a kind that this module has
     */
    public static Noise noise(SdfReader.Sensor sensor) {
        Map<String, String> elements = new TreeMap<>();
        Checks.present("sensor", sensor).values().forEach((path, value) -> {
            if (path.startsWith("noise/")) {
                elements.put(path.substring(6), value);
            }
        });
        try {
            return elements.isEmpty() ? Noise.NONE : SdfNoise.of(elements);
        } catch (IllegalArgumentException e) {
            throw refused(sensor, e);
        }
    }

    private static <S extends RaySensor<S, ?>> S clipped(S camera, SdfReader.Sensor sensor) {
        try {
            double near = number(sensor, "clip/near", 0.1);
            S ranged = camera.withRange(near, number(sensor, "clip/far", 100));
            return mounted(ranged.withOutOfRange(OutOfRange.REP_117), sensor);
        } catch (IllegalArgumentException e) {
            throw refused(sensor, e);
        }
    }

    private static <S extends RaySensor<S, ?>> S mounted(S made, SdfReader.Sensor sensor) {
        String carrier = sensor.carrier();
        return carrier == null ? made.at(sensor.pose()) : made.on(carrier, sensor.pose());
    }

    private static void check(SdfReader.Sensor sensor, Kind kind) {
        if (kind(sensor) != kind) {
            throw new IllegalArgumentException(
                    "sensor must be one of " + kind + " (got: " + sensor.name() + " of type " + sensor.type() + ")");
        }
    }

    private static int rays(SdfReader.Sensor sensor, String direction, int usual) {
        double count = whole(sensor, direction + "samples", usual) * number(sensor, direction + "resolution", 1);
        if (!(count >= 0.5 && count <= RayPattern.MAX_SIZE)) { // written so that NaN fails it
            throw new IllegalArgumentException(
                    "<samples> times <resolution> must be from 1 to " + RayPattern.MAX_SIZE + " (got: " + count + ")");
        }
        return (int) Math.round(count);
    }

    /** Degrees of the first ray: a single one is in the middle. */
    private static double first(SdfReader.Sensor sensor, String direction, int count) {
        double least = Degrees.toDegrees(number(sensor, direction + "min_angle", 0));
        double most = Degrees.toDegrees(number(sensor, direction + "max_angle", 0));
        return count == 1 ? (least + most) / 2 : least;
    }

    private static double step(SdfReader.Sensor sensor, String direction, int count) {
        double least = Degrees.toDegrees(number(sensor, direction + "min_angle", 0));
        double most = Degrees.toDegrees(number(sensor, direction + "max_angle", 0));
        if (!(least <= most)) {
            throw new IllegalArgumentException(
                    "<min_angle> must be at most <max_angle> (got: " + least + " and " + most + " degrees)");
        }
        return count == 1 ? 0 : (most - least) / (count - 1);
    }

    private static int whole(SdfReader.Sensor sensor, String path, int usual) {
        double number = number(sensor, path, usual);
        if (number != Math.rint(number) || Math.abs(number) > Integer.MAX_VALUE) {
            throw new IllegalArgumentException("<" + path + "> must be a whole number (got: " + number + ")");
        }
        return (int) number;
    }

    private static double number(SdfReader.Sensor sensor, String path, double usual) {
        String text = sensor.values().get(path);
        if (text == null || text.isEmpty()) {
            return usual;
        }
        if (text.equals("inf") || text.equals("+inf")) {
            return Double.POSITIVE_INFINITY;
        }
        try {
            return Double.parseDouble(text);
        } catch (NumberFormatException e) {
            throw new IllegalArgumentException("<" + path + "> must be a number (got: \"" + text + "\")", e);
        }
    }

    private static IllegalArgumentException refused(SdfReader.Sensor sensor, IllegalArgumentException e) {
        return new IllegalArgumentException(
                sensor.source() + ":" + sensor.line() + ": sensor " + sensor.name() + ": " + e.getMessage(), e);
    }
}
