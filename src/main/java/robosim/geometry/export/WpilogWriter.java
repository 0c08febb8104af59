package robosim.geometry.export;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Writes a WPILOG file, which AdvantageScope shows: of the messages of ROS 2 the poses, velocities, commands, distances and scans,
 * as structs of WPILib and arrays of numbers. Equal messages give equal bytes.
 *
 * <p>Source: the WPILib data log format, version 1.0, and the schemas of its structs.
 */
final class WpilogWriter implements MessageSink {
    private static final int VERSION = 0x0100;

    /** Sizes of a record's numbers: an entry of four bytes, a size of four, a time of eight. */
    private static final int WIDTHS = 3 | 3 << 2 | 7 << 4;

    private static final String POSE = "struct:Pose3d";
    private static final String SPEEDS = "struct:ChassisSpeeds";

    /** A schema comes before the first value that needs it, and before the schemas that contain it. */
    private static final Map<String, String> SCHEMAS = schemas();

    private final OutputStream out;
    private final long epoch;
    private final Map<String, Integer> entries = new HashMap<>();

    /**
     * Begins a file.
     *
     * @param epoch nanoseconds of the messages' times that are 0 in the file
     */
    WpilogWriter(OutputStream out, long epoch) throws IOException {
        this.out = out;
        this.epoch = epoch;
        out.write(new PackedStream()
                .append("WPILOG".getBytes(StandardCharsets.UTF_8))
                .number(VERSION, 2)
                .longText("robosim-geometry")
                .toBytes());
        for (Map.Entry<String, String> schema : SCHEMAS.entrySet()) {
            int entry = entry("/.schema/struct:" + schema.getKey(), "structschema", 0);
            record(entry, 0, schema.getValue().getBytes(StandardCharsets.UTF_8));
        }
    }

    private static Map<String, String> schemas() {
        Map<String, String> all = new LinkedHashMap<>();
        all.put("Quaternion", "double w;double x;double y;double z");
        all.put("Rotation3d", "Quaternion q");
        all.put("Translation3d", "double x;double y;double z");
        all.put("Pose3d", "Translation3d translation;Rotation3d rotation");
        all.put("ChassisSpeeds", "double vx;double vy;double omega");
        return all;
    }

    @Override
    public void write(String topic, String type, long nanos, List<?> value) throws IOException {
        long micros = Math.floorDiv(nanos - epoch, 1000);
        switch (type) {
            case "tf2_msgs/TFMessage" -> transforms(list(value, 0), micros);
            case "nav_msgs/Odometry" -> send(topic + "/velocity", SPEEDS, micros, speeds(list(list(value, 3), 0)));
            case "geometry_msgs/Twist" -> send(topic, SPEEDS, micros, speeds(value));
            case "sensor_msgs/Range" -> send(topic, "double", micros, number(value, 5));
            case "sensor_msgs/LaserScan" -> scan(topic, value, micros);
            default -> {
                // Maps, markers, pictures and clouds have no form that AdvantageScope shows.
            }
        }
    }

    /** Frames whose parent is the world are robots; those of sensors are left out. */
    private void transforms(List<?> transforms, long micros) throws IOException {
        for (Object each : transforms) {
            List<?> transform = (List<?>) each;
            String frame = (String) transform.get(1);
            String base = "/base_link";
            if (frame.endsWith(base)) {
                List<?> pose = list(transform, 2);
                List<?> place = list(pose, 0);
                List<?> turn = list(pose, 1);
                send(
                        "/" + frame.substring(0, frame.length() - base.length()) + "/pose",
                        POSE,
                        micros,
                        number(place, 0),
                        number(place, 1),
                        number(place, 2),
                        number(turn, 3),
                        number(turn, 0),
                        number(turn, 1),
                        number(turn, 2));
            }
        }
    }

    private static double[] speeds(List<?> twist) {
        List<?> linear = list(twist, 0);
        return new double[] {number(linear, 0), number(linear, 1), number(list(twist, 1), 2)};
    }

    private void scan(String topic, List<?> scan, long micros) throws IOException {
        float[] ranges = (float[]) scan.get(8);
        PackedStream bytes = new PackedStream();
        for (float range : ranges) {
            bytes.number(Float.floatToRawIntBits(range), Float.BYTES);
        }
        record(entry(topic, "float[]", micros), micros, bytes.toBytes());
    }

    private void send(String name, String type, long micros, double... numbers) throws IOException {
        PackedStream bytes = new PackedStream();
        for (double number : numbers) {
            bytes.exact(number);
        }
        record(entry(name, type, micros), micros, bytes.toBytes());
    }

    /** An entry's number; it is started at its first value. */
    private int entry(String name, String type, long micros) throws IOException {
        Integer known = entries.get(name);
        if (known != null) {
            return known;
        }
        int entry = entries.size() + 1;
        entries.put(name, entry);
        PackedStream start = new PackedStream().number(0, 1).number(entry, 4);
        record(0, micros, start.longText(name).longText(type).number(0, 4).toBytes());
        return entry;
    }

    private void record(int entry, long micros, byte[] payload) throws IOException {
        out.write(new PackedStream()
                .number(WIDTHS, 1)
                .number(entry, 4)
                .number(payload.length, 4)
                .number(micros, 8)
                .append(payload)
                .toBytes());
    }

    private static List<?> list(List<?> value, int index) {
        return (List<?>) value.get(index);
    }

    private static double number(List<?> value, int index) {
        return ((Number) value.get(index)).doubleValue();
    }

    @Override
    public void finish() {
        // A file ends with its last record.
    }
}
