package robosim.geometry.export;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import robosim.geometry.model.Point;
import robosim.geometry.protocol.BatchRequestBundle;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.MoveRequest;
import robosim.geometry.protocol.SonarRequest;
import robosim.geometry.protocol.SonarRequestBundle;
import robosim.geometry.protocol.StepBundle;
import robosim.geometry.protocol.batch.BeamPattern;
import robosim.geometry.protocol.batch.Mount;
import robosim.geometry.protocol.batch.ScanMotion;
import robosim.geometry.protocol.batch.SenseRequest;
import robosim.geometry.protocol.motion.BodyRequest;
import robosim.geometry.protocol.motion.DriveCommand;

/** WPILOG files, decoded by a reader of its own, and by robotpy-wpiutil where that is installed. */
class WpilogWriterTest {
    @TempDir
    private Path folder;

    /** A value of an entry. */
    private record Value(String entry, String type, long micros, ByteBuffer bytes) {
        private double[] doubles() {
            double[] numbers = new double[bytes.remaining() / 8];
            bytes.duplicate().order(ByteOrder.LITTLE_ENDIAN).asDoubleBuffer().get(numbers);
            return numbers;
        }
    }

    private List<Value> written(Bundle... requests) throws IOException {
        Path file = folder.resolve("a.wpilog");
        RosRecording.write(RosRecordingTest.conversation(requests), 0.5, file, n -> {});
        return decoded(ByteBuffer.wrap(Files.readAllBytes(file)).order(ByteOrder.LITTLE_ENDIAN));
    }

    /** By the widths that each record states, unlike the writer, which has one of each. */
    private static List<Value> decoded(ByteBuffer in) {
        byte[] magic = new byte[6];
        in.get(magic);
        assertThat(magic).asString(StandardCharsets.US_ASCII).isEqualTo("WPILOG");
        assertThat(in.getShort()).isEqualTo((short) 0x0100);
        in.position(in.getInt() + in.position());
        Map<Long, String[]> entries = new HashMap<>();
        List<Value> values = new ArrayList<>();
        while (in.hasRemaining()) {
            int widths = in.get();
            long entry = number(in, (widths & 3) + 1);
            int size = (int) number(in, (widths >> 2 & 3) + 1);
            long micros = number(in, (widths >> 4 & 7) + 1);
            ByteBuffer payload = in.slice(in.position(), size).order(ByteOrder.LITTLE_ENDIAN);
            in.position(in.position() + size);
            if (entry == 0) {
                assertThat(payload.get()).as("only starts are written").isZero();
                long started = payload.getInt();
                String[] names = {text(payload), text(payload)};
                assertThat(text(payload)).as("metadata").isEmpty();
                assertThat(entries.put(started, names)).isNull();
            } else {
                String[] names = entries.get(entry);
                values.add(new Value(names[0], names[1], micros, payload));
            }
        }
        return values;
    }

    private static long number(ByteBuffer in, int bytes) {
        long number = 0;
        for (int k = 0; k < bytes; k++) {
            number |= (in.get() & 0xffL) << 8 * k;
        }
        return number;
    }

    private static String text(ByteBuffer in) {
        byte[] bytes = new byte[in.getInt()];
        in.get(bytes);
        return new String(bytes, StandardCharsets.UTF_8);
    }

    private static List<Value> of(List<Value> all, String entry) {
        return all.stream().filter(value -> value.entry.equals(entry)).toList();
    }

    @Test
    void posesAndVelocitiesAreStructs() throws Exception {
        List<Value> log = written(
                RosRecordingTest.world(),
                new MoveBundle(List.of(new MoveRequest("robot 1", 1, 0, 0, 0, Math.PI / 2))),
                new StepBundle(
                        0.25, List.of(BodyRequest.of("robot 1")), List.of(new DriveCommand("robot 1", 0.4, 0.5))));
        List<Value> poses = of(log, "/robot_1/pose");
        assertThat(poses).allSatisfy(pose -> assertThat(pose.type).isEqualTo("struct:Pose3d"));
        assertThat(poses).extracting(Value::micros).containsExactly(0L, 500_000L, 750_000L);
        double half = Math.sqrt(0.5);
        assertThat(poses.get(0).doubles()).containsExactly(0, -1, 0, 1, 0, 0, 0);
        assertThat(poses.get(1).doubles()).containsExactly(new double[] {1, -1, 0, half, 0, 0, half}, within(1e-15));
        Value command = of(log, "/robot_1/cmd_vel").get(0);
        assertThat(command.type).isEqualTo("struct:ChassisSpeeds");
        assertThat(command.micros).isEqualTo(500_000);
        assertThat(command.doubles()).containsExactly(0.4, 0, 0.5);
        assertThat(of(log, "/robot_1/odom/velocity").get(0).doubles())
                .containsExactly(new double[] {0.4, 0, 0.5}, within(1e-9));
        // Schemas come first, each after those that it contains.
        assertThat(log.stream().limit(5).map(Value::entry))
                .containsExactly(
                        "/.schema/struct:Quaternion",
                        "/.schema/struct:Rotation3d",
                        "/.schema/struct:Translation3d",
                        "/.schema/struct:Pose3d",
                        "/.schema/struct:ChassisSpeeds");
    }

    @Test
    void distancesAreNumbers() throws Exception {
        Mount mount = new Mount(new Point(0.1, 0.2, 0));
        List<Value> log = written(
                RosRecordingTest.world(),
                new SonarRequestBundle(List.of(new SonarRequest("robot 1", 1, 0))),
                new BatchRequestBundle(List.of(new SenseRequest(
                        "robot 1",
                        mount,
                        new BeamPattern.Fan(-0.25, 0.25, 3),
                        0.1,
                        20,
                        0,
                        false,
                        false,
                        false,
                        ScanMotion.NONE,
                        false,
                        List.of()))));
        // The wall's near side is at X = 2.9; the sonar's cone is wide, but reaches nothing nearer.
        assertThat(of(log, "/robot_1/range").get(0).doubles()).containsExactly(new double[] {2.9}, within(1e-6));
        Value scan = of(log, "/robot_1/scan_2").get(0);
        assertThat(scan.type).isEqualTo("float[]");
        float[] ranges = new float[3];
        scan.bytes.asFloatBuffer().get(ranges);
        double slanted = 2.8 / Math.cos(0.25);
        assertThat(ranges).containsExactly(new float[] {(float) slanted, 2.8f, (float) slanted}, within(1e-5f));
    }

    @Test
    void pythonsLibraryReadsIt() throws Exception {
        written(RosRecordingTest.world(), new MoveBundle(List.of(new MoveRequest("robot 1", 1, 0, 0, 0, 0))));
        String program = """
                import sys, struct
                from wpiutil.log import DataLogReader
                names = {}
                for record in DataLogReader(sys.argv[1]):
                    if record.isStart():
                        start = record.getStartData()
                        names[start.entry] = (start.name, start.type)
                    elif names[record.getEntry()][0] == "/robot_1/pose":
                        print(names[record.getEntry()][1], record.getTimestamp(), *struct.unpack("<7d", record.getRaw()))
                """;
        Process python;
        try {
            python = new ProcessBuilder(
                            "python3", "-c", program, folder.resolve("a.wpilog").toString())
                    .redirectErrorStream(true)
                    .start();
        } catch (IOException e) {
            Assumptions.abort("there is no Python");
            return;
        }
        String printed = new String(python.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertThat(python.waitFor(30, TimeUnit.SECONDS)).isTrue();
        Assumptions.assumeFalse(printed.contains("No module named"), "robotpy-wpiutil is not installed");
        assertThat(printed.lines())
                .containsExactly(
                        "struct:Pose3d 0 0.0 -1.0 0.0 1.0 0.0 0.0 0.0",
                        "struct:Pose3d 500000 1.0 -1.0 0.0 1.0 0.0 0.0 0.0");
    }
}
