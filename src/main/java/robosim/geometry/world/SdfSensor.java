package robosim.geometry.world;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.exact.Degrees;
import robosim.geometry.model.Pose;
import robosim.geometry.model.RayPattern;
import robosim.geometry.model.SenseOptions;
import robosim.geometry.sensor.DepthCamera;
import robosim.geometry.sensor.Intrinsics;
import robosim.geometry.sensor.Lidar;
import robosim.geometry.sensor.Noise;
import robosim.geometry.sensor.NormalCamera;
import robosim.geometry.sensor.RaySensor;
import robosim.geometry.sensor.SegmentationCamera;
import robosim.geometry.world.sdf.SdfFiles;
import robosim.geometry.world.sdf.SdfObjects;
import robosim.geometry.world.sdf.SdfShapes;
import robosim.geometry.world.sdf.SdfState;
import robosim.geometry.world.sdf.SdfTree;
import robosim.geometry.world.sdf.SensorElement;
import robosim.geometry.world.shared.FileProblem;

/**
 * A sensor of a link as SDFormat describes it, and the sensors of this module that follow from it, where they are mounted
 * and without their noise: {@link #noise} returns that.
 *
 * <p>What a file leaves out has SDFormat's own values: a lidar of 640 rays straight ahead, a camera of 320 x 240 pixels and
 * 1.047 radians that sees from 0.1 to 100 m. A lidar has {@code samples} times {@code resolution} rays in each direction; its
 * rays are sent all at once, as SDFormat's are. Near and far ends of a camera's view are taken along its rays. What is out of
 * range is reported as Gazebo does: {@link RaySensor#withRep117}. The {@code resolution} of a range is not applied, as Gazebo
 * does not apply it; {@link Noise#quantized} does.
 *
 * @param name    those of its models, its link and its own, separated by {@code ::}
 * @param type    as in the file: {@code gpu_lidar}, {@code camera}
 * @param carrier the name of the moveable object that carries it; null for one that stands in the world
 * @param pose    in the frame of the carrier, or in the world
 * @param values  the texts of its elements by their paths, as {@code scan/horizontal/samples} or {@code noise/stddev}
 * @param source  the file that describes it
 * @param line    in the file, from 1
 */
public record SdfSensor(
        String name,
        String type,
        @Nullable String carrier,
        Pose pose,
        Map<String, String> values,
        String source,
        int line) {
    /** Keeps a copy. */
    public SdfSensor {
        values = Map.copyOf(values);
    }

    /**
     * What of its description is not applied although it changes what the sensor measures, as a sentence for people that
     * names the sensor; empty if nothing is.
     */
    public Optional<String> ignored() {
        Set<String> elements = new TreeSet<>();
        values.forEach((path, value) -> {
            String[] names = path.split("/", -1);
            if (names.length == 3 && names[0].equals("lens") && !names[1].equals("intrinsics")) { // and a number
                elements.add("<lens><" + names[1] + ">");
            } else if (path.equals("lens/intrinsics/s") && !isZero(value)) {
                elements.add("<s> of <lens><intrinsics>");
            } else if (path.equals("distortion/center") && !value.matches("\\s*0?\\.50*\\s+0?\\.50*\\s*")) {
                elements.add("<center> of <distortion>"); // it is cx and cy
            }
        });
        return elements.isEmpty()
                ? Optional.empty()
                : Optional.of(
                        source + ":" + line + ": sensor " + name + ": " + String.join(", ", elements) + " is ignored");
    }

    private static boolean isZero(String number) {
        return number.matches("[-+]?(0+\\.?0*|\\.0+)([eE][-+]?\\d+)?");
    }

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

    static SdfSensor of(SensorElement each) {
        return new SdfSensor(
                each.name(), each.type(), each.carrier(), each.pose(), each.values(), each.file(), each.line());
    }

    /**
     * The sensors of a file, of any type, in the order of their links; their carriers are named as in the world that
     * {@link WorldImport#read} makes of it.
     *
     * @param file   SDFormat, or the folder of a model
     * @param models folders whose subfolders are models, as in {@link ImportOptions}
     * @throws WorldException naming file, line and remedy, as {@link WorldImport#read} does
     */
    public static List<SdfSensor> read(Path file, List<Path> models) throws WorldException {
        Checks.present("file", file);
        Checks.list("models", models);
        try {
            Path main = Files.isDirectory(file) ? SdfFiles.modelOf(file, remark -> {}) : file;
            SdfFiles files = new SdfFiles(main, models);
            return found(new SdfTree(files), files, main).sensors().stream()
                    .map(SdfSensor::of)
                    .toList();
        } catch (FileProblem e) {
            throw new WorldException(e);
        }
    }

    /** All objects and sensors of a file. */
    static SdfObjects found(SdfTree tree, SdfFiles files, Path file) throws FileProblem {
        SdfObjects found = new SdfObjects(tree, new SdfShapes(tree, files));
        found.add(SdfState.read(tree, files.main(file.toString())));
        return found;
    }

    /**
     * The noise that a {@code <noise>} element describes. {@code type} is {@code none}, {@code gaussian} or {@code
     * gaussian_quantized}, as an attribute or, as older files have it, an element. {@code mean}, {@code stddev}, {@code
     * bias_mean}, {@code bias_stddev} and {@code precision} have their values there; a bias that changes with time ({@code
     * dynamic_bias_stddev}) is refused unless it is 0, and so are other elements.
     *
     * <pre>{@code
     * Noise noise = SdfSensor.readNoise("<noise type='gaussian'><mean>0</mean><stddev>0.01</stddev></noise>");
     * noise.equals(Noise.gaussian(0.01)); // true
     * }</pre>
     *
     * @throws IllegalArgumentException if it is not such an element, with the reason
     */
    public static Noise readNoise(String xml) {
        return SdfNoise.read(xml);
    }

    /** What a sensor measures. */
    public Kind kind() {
        return Kind.of(type());
    }

    /** Readings a second; 0 if the file does not say. */
    public double updateRate() {
        return number("update_rate", 0);
    }

    /**
     * A lidar.
     *
     * @throws IllegalArgumentException naming the sensor, if it is none or has numbers that no lidar has
     */
    public Lidar lidar() {
        check(Kind.LIDAR);
        try {
            int columns = rays("scan/horizontal/", 640);
            int rows = rays("scan/vertical/", 1);
            double[] elevations = new double[rows];
            double step = step("scan/vertical/", rows);
            double lowest = first("scan/vertical/", rows);
            for (int row = 0; row < rows; row++) {
                elevations[row] = lowest + row * step;
            }
            double first = first("scan/horizontal/", columns);
            double aside = step("scan/horizontal/", columns);
            RayPattern pattern = rows == 1 && elevations[0] == 0
                    ? RayPattern.fan(first, aside, columns)
                    : RayPattern.layers(elevations, first, aside, columns);
            double min = number("range/min", 0);
            double max = number("range/max", Double.POSITIVE_INFINITY);
            return mounted(Lidar.of(pattern, SenseOptions.range(min, max)).withRep117());
        } catch (IllegalArgumentException e) {
            throw refused(e);
        }
    }

    /**
     * Size and lens of a camera of any kind: as {@code <lens><intrinsics>} and {@code <distortion>} say, and for what they leave
     * out, as {@code <horizontal_fov>} does.
     */
    public Intrinsics intrinsics() {
        if (!kind().isCamera()) {
            throw new IllegalArgumentException("sensor must be a camera (got: " + name + " of type " + type + ")");
        }
        try {
            Intrinsics usual =
                    Intrinsics.fieldOfView(whole("image/width", 320), whole("image/height", 240), fieldOfView());
            String given = "lens/intrinsics/";
            return new Intrinsics(
                    usual.width(),
                    usual.height(),
                    number(given + "fx", usual.fx()),
                    number(given + "fy", usual.fy()),
                    number(given + "cx", usual.cx()),
                    number(given + "cy", usual.cy()),
                    Intrinsics.Distortion.brownConrady(
                            number("distortion/k1", 0),
                            number("distortion/k2", 0),
                            number("distortion/p1", 0),
                            number("distortion/p2", 0),
                            number("distortion/k3", 0)));
        } catch (IllegalArgumentException e) {
            throw refused(e);
        }
    }

    /** Horizontal field of view of a camera of any kind, in degrees. */
    public double fieldOfView() {
        return Degrees.toDegrees(number("horizontal_fov", 1.047));
    }

    /** A depth camera. */
    public DepthCamera depthCamera() {
        check(Kind.DEPTH);
        return clipped(DepthCamera.of(intrinsics()));
    }

    /** A camera of objects and labels. */
    public SegmentationCamera segmentationCamera() {
        check(Kind.SEGMENTATION);
        return clipped(SegmentationCamera.of(intrinsics()));
    }

    /** A camera of normals. */
    public NormalCamera normalCamera() {
        check(Kind.NORMALS);
        return clipped(NormalCamera.of(intrinsics()));
    }

    /**
     * The noise of a lidar's ranges or of a camera's pixels, {@link Noise#NONE} if it has none: see {@link SdfNoise}.
     *
     * @throws IllegalArgumentException naming the sensor, if it is not noise of a kind that this module has
     */
    public Noise noise() {
        Map<String, String> elements = new TreeMap<>();
        values().forEach((path, value) -> {
            if (path.startsWith("noise/")) {
                elements.put(path.substring(6), value);
            }
        });
        try {
            return elements.isEmpty() ? Noise.NONE : SdfNoise.of(elements);
        } catch (IllegalArgumentException e) {
            throw refused(e);
        }
    }

    private <S extends RaySensor<S, ?>> S clipped(S camera) {
        try {
            double near = number("clip/near", 0.1);
            S ranged = camera.withRange(near, number("clip/far", 100));
            return mounted(ranged.withRep117());
        } catch (IllegalArgumentException e) {
            throw refused(e);
        }
    }

    private <S extends RaySensor<S, ?>> S mounted(S made) {
        return carrier == null ? made.at(pose) : made.on(carrier, pose);
    }

    private void check(Kind kind) {
        if (kind() != kind) {
            throw new IllegalArgumentException(
                    "sensor must be one of " + kind + " (got: " + name + " of type " + type + ")");
        }
    }

    private int rays(String direction, int usual) {
        double count = whole(direction + "samples", usual) * number(direction + "resolution", 1);
        if (!(count >= 0.5 && count <= RayPattern.MAX_SIZE)) { // written so that NaN fails it
            throw new IllegalArgumentException(
                    "<samples> times <resolution> must be from 1 to " + RayPattern.MAX_SIZE + " (got: " + count + ")");
        }
        return (int) Math.round(count);
    }

    /** Degrees of the first ray: a single one is in the middle. */
    private double first(String direction, int count) {
        double least = Degrees.toDegrees(number(direction + "min_angle", 0));
        double most = Degrees.toDegrees(number(direction + "max_angle", 0));
        return count == 1 ? (least + most) / 2 : least;
    }

    private double step(String direction, int count) {
        double least = Degrees.toDegrees(number(direction + "min_angle", 0));
        double most = Degrees.toDegrees(number(direction + "max_angle", 0));
        if (!(least <= most)) {
            throw new IllegalArgumentException(
                    "<min_angle> must be at most <max_angle> (got: " + least + " and " + most + " degrees)");
        }
        return count == 1 ? 0 : (most - least) / (count - 1);
    }

    private int whole(String path, int usual) {
        double number = number(path, usual);
        if (number != Math.rint(number) || Math.abs(number) > Integer.MAX_VALUE) {
            throw new IllegalArgumentException("<" + path + "> must be a whole number (got: " + number + ")");
        }
        return (int) number;
    }

    private double number(String path, double usual) {
        String text = values.get(path);
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

    private IllegalArgumentException refused(IllegalArgumentException e) {
        return new IllegalArgumentException(source + ":" + line + ": sensor " + name + ": " + e.getMessage(), e);
    }
}
