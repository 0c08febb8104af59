package robosim.geometry.export;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.HashMap;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.Point;
import robosim.geometry.net.Session;
import robosim.geometry.net.SessionOptions;
import robosim.geometry.protocol.BatchRequestBundle;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.MoveRequest;
import robosim.geometry.protocol.SonarRequest;
import robosim.geometry.protocol.SonarRequestBundle;
import robosim.geometry.protocol.StepBundle;
import robosim.geometry.protocol.batch.BatchRequest;
import robosim.geometry.protocol.batch.BeamPattern;
import robosim.geometry.protocol.batch.Mount;
import robosim.geometry.protocol.batch.Numbers;
import robosim.geometry.protocol.batch.PictureRequest;
import robosim.geometry.protocol.batch.ScanMotion;
import robosim.geometry.protocol.batch.SenseRequest;
import robosim.geometry.protocol.motion.BodyRequest;
import robosim.geometry.protocol.motion.DriveCommand;
import robosim.geometry.scenario.ScenarioHeader;
import robosim.geometry.scenario.Step;
import robosim.geometry.scenario.source.StepReader;

/** What an MCAP file of a recording has, by a reader of its own, and by Python's libraries where they are. */
class RosRecordingTest {
    private static final long NANOS = 1_000_000_000;
    private static final long EPOCH = RosRecording.EPOCH_SECONDS * NANOS;

    @TempDir
    private Path folder;

    /** A conversation with a session, as a recording has it. */
    static StepReader conversation(Bundle... requests) {
        Session session = new Session();
        List<Step> steps = new ArrayList<>();
        for (Bundle request : requests) {
            steps.add(new Step(request, session.reply(request)));
        }
        Iterator<Step> next = steps.iterator();
        return new StepReader() {
            @Override
            public ScenarioHeader header() {
                return new ScenarioHeader("test", "", SessionOptions.ROBOSIM);
            }

            @Override
            public @Nullable Step next() {
                return next.hasNext() ? next.next() : null;
            }

            @Override
            public void close() {}
        };
    }

    static InitBundle world() {
        BitSet cells = new BitSet();
        cells.set(0); // the cell at the lowest X and the lowest Z
        GeometryObject map = new GridObject(new Point(10, 0.5, 0), 0.5, 1, 4, 3, cells);
        GeometryObject wall = new BoxObject(new Point(3, 0.5, 0), 0.2, 1, 4);
        GeometryObject robot = new CylinderObject(new Point(0, 0.25, 1), 0.25, 0.5).moveable("robot 1");
        return new InitBundle(List.of(wall, map, robot));
    }

    private DecodedMcap write(double tick, Bundle... requests) throws IOException {
        Path file = folder.resolve("a.mcap");
        RosRecording.write(conversation(requests), tick, file, n -> {});
        return new DecodedMcap(Files.readAllBytes(file));
    }

    private static List<Map<String, Object>> of(DecodedMcap mcap, String topic) {
        return mcap.messages.stream()
                .filter(message -> message.topic().equals(topic))
                .map(DecodedMcap.Message::value)
                .toList();
    }

    /** A part of a message: names of fields and indices of lists. */
    private static Object at(Object value, Object... path) {
        Object part = value;
        for (Object step : path) {
            part = step instanceof String name ? ((Map<?, ?>) part).get(name) : ((List<?>) part).get((Integer) step);
        }
        return part;
    }

    private static double number(Object value, Object... path) {
        return ((Number) at(value, path)).doubleValue();
    }

    private static double[] xyz(Object value, Object... path) {
        Object point = at(value, path);
        return new double[] {number(point, "x"), number(point, "y"), number(point, "z")};
    }

    @Test
    void robotsHaveTheirBasesOnTheFloorInTheAxesOfRos() throws Exception {
        DecodedMcap mcap = write(
                0.5,
                world(),
                new MoveBundle(List.of(new MoveRequest("robot 1", 1, 0, 0, 0, Math.PI / 2))),
                new MoveBundle(List.of(new MoveRequest("robot 1", 9, 0, 0, 0, 0))));
        List<Map<String, Object>> tf = of(mcap, "/tf");
        assertThat(tf).hasSize(2); // the refused move changes nothing
        Object first = at(tf.get(0), "transforms", 0);
        assertThat(at(first, "header", "frame_id")).isEqualTo("world");
        assertThat(at(first, "child_frame_id")).isEqualTo("robot_1/base_link");
        assertThat(xyz(first, "transform", "translation")).containsExactly(new double[] {0, -1, 0}, within(1e-12));
        Object second = at(tf.get(1), "transforms", 0);
        assertThat(xyz(second, "transform", "translation")).containsExactly(new double[] {1, -1, 0}, within(1e-12));
        // A quarter turn to the left, about ROS's Z.
        assertThat(xyz(second, "transform", "rotation"))
                .containsExactly(new double[] {0, 0, Math.sqrt(0.5)}, within(1e-12));
        assertThat(number(second, "transform", "rotation", "w")).isEqualTo(Math.sqrt(0.5), within(1e-12));
        assertThat(mcap.messages.stream()
                        .filter(m -> m.topic().equals("/clock"))
                        .map(DecodedMcap.Message::nanos))
                .containsExactly(EPOCH, EPOCH + NANOS / 2, EPOCH + NANOS);
        assertThat(number(second, "header", "stamp", "nanosec")).isEqualTo(5e8);
    }

    @Test
    void mapsAndShapesAreWhereTheyAre() throws Exception {
        DecodedMcap mcap = write(0.1, world());
        Map<String, Object> map = of(mcap, "/map").get(0);
        assertThat(number(map, "info", "resolution")).isEqualTo(0.5);
        assertThat(number(map, "info", "width")).isEqualTo(4);
        assertThat(number(map, "info", "height")).isEqualTo(3);
        assertThat(xyz(map, "info", "origin", "position")).containsExactly(9, -0.75, 0);
        // The lowest Z is the highest Y of ROS: the last row.
        assertThat((List<?>) at(map, "data")).isEqualTo(List.of(0L, 0L, 0L, 0L, 0L, 0L, 0L, 0L, 100L, 0L, 0L, 0L));

        List<?> markers = (List<?>) at(of(mcap, "/markers").get(1), "markers");
        assertThat(markers).hasSize(3);
        assertThat(reach(markers.get(0), "x")).containsExactly(2.9, 3.1);
        assertThat(reach(markers.get(0), "y")).containsExactly(-2, 2);
        assertThat(reach(markers.get(0), "z")).containsExactly(0, 1);
        assertThat(reach(markers.get(1), "y")).containsExactly(0.25, 0.75); // of the grid the occupied cell
        assertThat(at(markers.get(2), "header", "frame_id")).isEqualTo("robot_1/base_link");
        assertThat(reach(markers.get(2), "z")).containsExactly(0, 0.5);

        Map<String, Object> scene = of(mcap, "/scene").get(0);
        assertThat(at(scene, "deletions", 0, "type")).isEqualTo(1L);
        assertThat((List<?>) at(scene, "entities")).hasSize(3);
        for (int k = 0; k < 3; k++) {
            assertThat(at(scene, "entities", k, "triangles", 0, "points")).isEqualTo(at(markers.get(k), "points"));
            assertThat(at(scene, "entities", k, "frame_id")).isEqualTo(at(markers.get(k), "header", "frame_id"));
        }
        assertThat(at(scene, "entities", 2, "id")).isEqualTo("robot 1");
    }

    private static double[] reach(Object marker, String axis) {
        double[] numbers = ((List<?>) at(marker, "points"))
                .stream().mapToDouble(point -> number(point, axis)).sorted().toArray();
        return new double[] {Math.round(numbers[0] * 1e6) / 1e6, Math.round(numbers[numbers.length - 1] * 1e6) / 1e6};
    }

    @Test
    void sensorsMeasureInTheirFrames() throws Exception {
        Mount mount = new Mount(new Point(0.1, 0.2, 0));
        List<BatchRequest> sensors = List.of(
                new SenseRequest(
                        "robot 1",
                        mount,
                        new BeamPattern.Fan(-0.25, 0.25, 4),
                        0.1,
                        20,
                        0,
                        false,
                        false,
                        false,
                        ScanMotion.NONE,
                        false,
                        List.of()),
                new SenseRequest(
                        "robot 1",
                        mount,
                        new BeamPattern.Layers(Numbers.of(0, Math.PI / 2), 0, Math.PI / 2, 2),
                        0,
                        Double.POSITIVE_INFINITY,
                        0,
                        false,
                        false,
                        false,
                        ScanMotion.NONE,
                        false,
                        List.of()),
                new SenseRequest(
                        "robot 1",
                        mount,
                        new BeamPattern.Pinhole(4, 2, 1),
                        0,
                        20,
                        0,
                        false,
                        false,
                        false,
                        ScanMotion.NONE,
                        false,
                        List.of()),
                new SenseRequest(
                        "robot 1",
                        mount,
                        new BeamPattern.Fan(0, 0.1, 2),
                        0,
                        5,
                        0.2,
                        false,
                        false,
                        false,
                        ScanMotion.NONE,
                        false,
                        List.of()),
                new PictureRequest("robot 1", mount, new BeamPattern.Pinhole(4, 2, 1)));
        DecodedMcap mcap = write(
                0.1,
                world(),
                new SonarRequestBundle(List.of(new SonarRequest("robot 1", 0, -1))),
                new BatchRequestBundle(sensors));

        Object fixed = at(of(mcap, "/tf_static").get(1), "transforms", 0);
        assertThat(at(fixed, "header", "frame_id")).isEqualTo("robot_1/base_link");
        assertThat(at(fixed, "child_frame_id")).isEqualTo("robot_1/sensor_2");
        assertThat(xyz(fixed, "transform", "translation")).containsExactly(new double[] {0.1, 0, 0.45}, within(1e-12));
        // The sonar to the left, where nothing is.
        Object left = at(of(mcap, "/tf_static").get(0), "transforms", 0, "transform", "rotation");
        assertThat(number(left, "z")).isEqualTo(Math.sqrt(0.5), within(1e-12));
        assertThat(number(of(mcap, "/robot_1/range").get(0), "range")).isInfinite();

        Map<String, Object> scan = of(mcap, "/robot_1/scan_2").get(0);
        assertThat(number(scan, "angle_min")).isEqualTo(-0.25);
        assertThat(number(scan, "angle_max")).isEqualTo(0.5);
        assertThat(number(scan, "angle_increment")).isEqualTo(0.25);
        List<?> ranges = (List<?>) at(scan, "ranges");
        for (int k = 0; k < 4; k++) { // the wall's face is at X = 2.9
            double expected = 2.8 / Math.cos(-0.25 + k * 0.25);
            assertThat((double) ranges.get(k)).isEqualTo(expected, within(1e-6));
        }

        Map<String, Object> cloud = of(mcap, "/robot_1/points_2").get(0);
        assertThat(number(cloud, "height")).isEqualTo(2);
        assertThat(number(cloud, "width")).isEqualTo(2);
        assertThat(at(cloud, "is_dense")).isEqualTo(false);
        assertThat(floats(cloud).subList(0, 3)).isEqualTo(List.of(2.8f, 0f, 0f));
        assertThat(floats(cloud).get(3)).isNaN(); // nothing to the left

        Map<String, Object> depth = of(mcap, "/robot_1/depth_2").get(0);
        assertThat(at(depth, "encoding")).isEqualTo("32FC1");
        assertThat(at(depth, "header", "frame_id")).isEqualTo("robot_1/sensor_2_optical");
        assertThat(floats(depth).subList(0, 3))
                .allSatisfy(each -> assertThat(each).isEqualTo(2.8f, within(1e-6f)));
        assertThat(floats(depth).get(3)).isInfinite(); // past the wall's right end
        Map<String, Object> info = of(mcap, "/robot_1/depth_info_2").get(0);
        assertThat(number(info, "k", 0)).isEqualTo(2 / Math.tan(0.5), within(1e-12));
        // In ROS the middles of the four columns are at 0, 1, 2 and 3.
        assertThat(number(info, "k", 2)).isEqualTo(1.5);
        assertThat(number(info, "k", 5)).isEqualTo((number(info, "height") - 1) / 2);
        assertThat(number(info, "p", 2)).isEqualTo(1.5);
        Map<String, Object> picture = of(mcap, "/robot_1/image_2").get(0);
        assertThat(at(picture, "encoding")).isEqualTo("rgb8");
        assertThat((List<?>) at(picture, "data")).hasSize(24);
        List<Map<String, Object>> cones = of(mcap, "/robot_1/range_2");
        assertThat(cones).hasSize(2);
        assertThat(number(cones.get(0), "field_of_view")).isEqualTo(0.2, within(1e-7));
        assertThat(number(cones.get(0), "range")).isEqualTo(2.8, within(1e-6));
    }

    private static List<Float> floats(Map<String, Object> message) {
        List<?> bytes = (List<?>) at(message, "data");
        List<Float> floats = new ArrayList<>();
        for (int k = 0; k < bytes.size(); k += 4) {
            int bits = 0;
            for (int j = 0; j < 4; j++) {
                bits |= (int) (long) (Long) bytes.get(k + j) << 8 * j;
            }
            floats.add(Float.intBitsToFloat(bits));
        }
        return floats;
    }

    @Test
    void drivenRobotsHaveCommandsAndOdometry() throws Exception {
        Bundle step = new StepBundle(
                0.5, List.of(BodyRequest.of("robot 1")), List.of(new DriveCommand("robot 1", 1, 0, 0.5)));
        DecodedMcap mcap = write(0.1, world(), step, new StepBundle(0.25, List.of(), List.of()));
        Map<String, Object> command = of(mcap, "/robot_1/cmd_vel").get(0);
        assertThat(number(command, "linear", "x")).isEqualTo(1);
        assertThat(number(command, "angular", "z")).isEqualTo(0.5);
        List<Map<String, Object>> odometry = of(mcap, "/robot_1/odom");
        assertThat(odometry).hasSize(2);
        assertThat(number(odometry.get(1), "header", "stamp", "nanosec")).isEqualTo(7.5e8);
        Object pose = at(odometry.get(1), "pose", "pose");
        Object transform = at(of(mcap, "/tf").get(2), "transforms", 0, "transform");
        assertThat(xyz(pose, "position")).containsExactly(xyz(transform, "translation"));
        assertThat(number(pose, "position", "y")).isGreaterThan(-1); // to the left
        assertThat(number(odometry.get(1), "twist", "twist", "angular", "z")).isEqualTo(0.5, within(1e-9));
    }

    @Test
    void equalRecordingsGiveEqualFilesAndManyMessagesSeveralChunks() throws Exception {
        List<Bundle> requests = new ArrayList<>(List.of(world()));
        for (int k = 0; k < 60; k++) {
            double angle = k * 0.1;
            requests.add(new SonarRequestBundle(
                    List.of(new SonarRequest("robot 1", StrictMath.cos(angle), StrictMath.sin(angle)))));
            requests.add(new BatchRequestBundle(
                    List.of(new SenseRequest("robot 1", new BeamPattern.Fan(0, 0.001, 10_000)))));
        }
        DecodedMcap mcap = write(0.1, requests.toArray(new Bundle[0]));
        byte[] first = Files.readAllBytes(folder.resolve("a.mcap"));
        write(0.1, requests.toArray(new Bundle[0]));
        assertThat(Files.readAllBytes(folder.resolve("a.mcap"))).isEqualTo(first);
        assertThat(first.length).isGreaterThan(2 << 20);
        // Each direction of a sonar is a frame, but not without end.
        assertThat(mcap.counts.keySet()).hasSizeLessThan(30);
        assertThat(mcap.messages.stream()
                        .filter(m -> m.topic().equals("/tf"))
                        .filter(m ->
                                at(m.value(), "transforms", 0, "child_frame_id").equals("robot_1/sensor_turning")))
                .hasSizeGreaterThan(40);
    }

    @Test
    void namesThatLookTheSameToRosStayApart() throws Exception {
        GeometryObject a = new CylinderObject(new Point(0, 0, 0), 0.2, 1).moveable("a b");
        GeometryObject b = new CylinderObject(new Point(1, 0, 0), 0.2, 1).moveable("a_b");
        GeometryObject c = new CylinderObject(new Point(2, 0, 0), 0.2, 1).moveable("3");
        DecodedMcap mcap = write(0.1, new InitBundle(List.of(a, b, c)));
        Map<Object, Object> frames = new HashMap<>();
        for (Object each : (List<?>) at(of(mcap, "/tf").get(0), "transforms")) {
            frames.put(at(each, "child_frame_id"), number(each, "transform", "translation", "x"));
        }
        assertThat(frames).containsOnlyKeys("a_b/base_link", "a_b_2/base_link", "_3/base_link");
    }

    @Test
    void refusesATickOfZero() {
        assertThatThrownBy(() -> write(0, world())).hasMessageContaining("tick").hasMessageContaining("0");
    }

    @Test
    void pythonsLibrariesReadIt() throws Exception {
        write(0.5, world(), new MoveBundle(List.of(new MoveRequest("robot 1", 1, 0, 0, 0, 0))));
        String program = """
                import sys
                from mcap.reader import make_reader
                from mcap_ros2.decoder import DecoderFactory
                with open(sys.argv[1], "rb") as f:
                    reader = make_reader(f, validate_crcs=True, decoder_factories=[DecoderFactory()])
                    for schema, channel, message, value in reader.iter_decoded_messages(topics=["/tf"]):
                        print(value.transforms[0].transform.translation.x)
                """;
        Process python;
        try {
            python = new ProcessBuilder(
                            "python3", "-c", program, folder.resolve("a.mcap").toString())
                    .redirectErrorStream(true)
                    .start();
        } catch (IOException e) {
            Assumptions.abort("there is no Python");
            return;
        }
        String printed = new String(python.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertThat(python.waitFor(30, TimeUnit.SECONDS)).isTrue();
        Assumptions.assumeFalse(printed.contains("No module named"), "mcap and mcap-ros2-support are not installed");
        assertThat(printed.lines()).containsExactly("0.0", "1.0");
    }
}
