package robosim.geometry.sensor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import robosim.geometry.sensor.PointCloud.Axes;
import robosim.geometry.sensor.PointCloud.Field;

/** Files of points and arrays, read again by other code that follows the formats' descriptions. */
class SensorFilesTest {
    @TempDir
    Path folder;

    private static PointCloud cloud(int points) {
        PointCloud cloud = new PointCloud(Field.values());
        SplittableRandom random = new SplittableRandom(5);
        for (int k = 0; k < points; k++) {
            cloud.add(
                    random.nextDouble(-50, 50),
                    random.nextDouble(-5, 5),
                    random.nextDouble(-50, 50),
                    random.nextDouble(),
                    random.nextInt(65536),
                    random.nextDouble(0.1),
                    random.nextInt(),
                    random.nextInt(),
                    0.6,
                    0.8,
                    -0.1);
        }
        return cloud;
    }

    /** A file with a header of lines, the last of which begins with a word, and its body. */
    private record Split(List<String> header, ByteBuffer body) {
        static Split of(Path file, String last) throws IOException {
            byte[] bytes = Files.readAllBytes(file);
            String text = new String(bytes, StandardCharsets.ISO_8859_1);
            int end = text.indexOf('\n', text.indexOf("\n" + last) + 1) + 1;
            ByteBuffer body = ByteBuffer.wrap(bytes, end, bytes.length - end).order(ByteOrder.LITTLE_ENDIAN);
            return new Split(text.substring(0, end).lines().toList(), body);
        }
    }

    private static double[] along(Axes axes, double x, double y, double z) {
        return switch (axes) {
            case MODULE -> new double[] {x, y, z};
            case ROS -> new double[] {x, -z, y}; // forward, left, up
            case OPTICAL -> new double[] {z, -y, x}; // right, down, forward
        };
    }

    private static void checkRows(PointCloud cloud, Axes axes, ByteBuffer body) {
        for (int k = 0; k < cloud.size(); k++) {
            for (double number : along(axes, cloud.x(k), cloud.y(k), cloud.z(k))) {
                assertThat(body.getFloat()).isEqualTo((float) number);
            }
            assertThat(body.getFloat()).isEqualTo((float) cloud.value(Field.INTENSITY, k));
            assertThat(body.getShort() & 0xffff).isEqualTo((int) cloud.value(Field.RING, k));
            assertThat(body.getFloat()).isEqualTo((float) cloud.value(Field.TIME, k));
            assertThat(body.getInt()).isEqualTo((int) cloud.value(Field.LABEL, k));
            assertThat(body.getInt()).isEqualTo((int) cloud.value(Field.INSTANCE, k));
            for (double number : along(axes, 0.6, 0.8, -0.1)) {
                assertThat(body.getFloat()).isEqualTo((float) number);
            }
        }
        assertThat(body.hasRemaining()).isFalse();
    }

    @ParameterizedTest
    @EnumSource
    void ply(Axes axes) throws IOException {
        PointCloud cloud = cloud(5000);
        Path file = folder.resolve("a.ply");
        cloud.writePly(axes, file);
        Split split = Split.of(file, "end_header");
        assertThat(split.header())
                .containsExactly(
                        "ply",
                        "format binary_little_endian 1.0",
                        "element vertex 5000",
                        "property float x",
                        "property float y",
                        "property float z",
                        "property float intensity",
                        "property ushort ring",
                        "property float time",
                        "property int label",
                        "property int instance",
                        "property float nx",
                        "property float ny",
                        "property float nz",
                        "end_header");
        checkRows(cloud, axes, split.body());
    }

    @ParameterizedTest
    @EnumSource
    void pcd(Axes axes) throws IOException {
        PointCloud cloud = cloud(4097);
        Path file = folder.resolve("a.pcd");
        cloud.writePcd(axes, file);
        Split split = Split.of(file, "DATA");
        assertThat(split.header())
                .containsExactly(
                        "# .PCD v0.7 - Point Cloud Data file format",
                        "VERSION 0.7",
                        "FIELDS x y z intensity ring time label instance normal_x normal_y normal_z",
                        "SIZE 4 4 4 4 2 4 4 4 4 4 4",
                        "TYPE F F F F U F I I F F F",
                        "COUNT 1 1 1 1 1 1 1 1 1 1 1",
                        "WIDTH 4097",
                        "HEIGHT 1",
                        "VIEWPOINT 0 0 0 1 0 0 0",
                        "POINTS 4097",
                        "DATA binary");
        checkRows(cloud, axes, split.body());
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 4096})
    void fewPoints(int points) throws IOException {
        PointCloud cloud = new PointCloud();
        for (int k = 0; k < points; k++) {
            cloud.add(k, 2, 3);
        }
        Path file = folder.resolve("few.ply");
        cloud.writePly(Axes.MODULE, file);
        assertThat(Split.of(file, "end_header").body().remaining()).isEqualTo(12 * points);
        cloud.writePcd(Axes.MODULE, file);
        assertThat(Split.of(file, "DATA").body().remaining()).isEqualTo(12 * points);
    }

    private ByteBuffer npy(Path file, String description) throws IOException {
        ByteBuffer bytes = ByteBuffer.wrap(Files.readAllBytes(file)).order(ByteOrder.LITTLE_ENDIAN);
        byte[] magic = new byte[8];
        bytes.get(magic);
        assertThat(magic).isEqualTo(new byte[] {(byte) 0x93, 'N', 'U', 'M', 'P', 'Y', 1, 0});
        byte[] header = new byte[bytes.getShort()];
        bytes.get(header);
        assertThat(bytes.position() % 64).isZero();
        String text = new String(header, StandardCharsets.US_ASCII);
        assertThat(text).endsWith("\n");
        assertThat(text.strip()).isEqualTo(description);
        return bytes;
    }

    @Test
    void npy() throws IOException {
        Path file = folder.resolve("a.npy");
        double[] values = {1, Double.POSITIVE_INFINITY, -0.0, 0.1, Math.PI, 1e300, 7};
        NpyWriter.write(values, file, 2, 3);
        ByteBuffer doubles = npy(file, "{'descr': '<f8', 'fortran_order': False, 'shape': (2, 3), }");
        for (double value : Arrays.copyOf(values, 6)) {
            assertThat(doubles.getDouble()).isEqualTo(value);
        }
        assertThat(doubles.hasRemaining()).isFalse();
        NpyWriter.writeFloats(values, file, 7);
        ByteBuffer floats = npy(file, "{'descr': '<f4', 'fortran_order': False, 'shape': (7,), }");
        for (double value : values) {
            assertThat(floats.getFloat()).isEqualTo((float) value);
        }
        int[] many = new int[20_000];
        Arrays.setAll(many, k -> k * 77_777);
        NpyWriter.write(many, file, 10, 20, 100);
        ByteBuffer ints = npy(file, "{'descr': '<i4', 'fortran_order': False, 'shape': (10, 20, 100), }");
        for (int value : many) {
            assertThat(ints.getInt()).isEqualTo(value);
        }
        NpyWriter.write(new short[] {1, (short) 65535}, file, 2, 1);
        ByteBuffer shorts = npy(file, "{'descr': '<u2', 'fortran_order': False, 'shape': (2, 1), }");
        assertThat(shorts.getShort()).isEqualTo((short) 1);
        assertThat(shorts.getShort() & 0xffff).isEqualTo(65535);
        NpyWriter.write(new int[0], file, 0, 5);
        assertThat(npy(file, "{'descr': '<i4', 'fortran_order': False, 'shape': (0, 5), }")
                        .hasRemaining())
                .isFalse();
    }

    @Test
    void refused() {
        Path file = folder.resolve("no.npy");
        refused(
                "shape must have lengths of at least 0, of no more numbers than there are, 3 (got: [2, 2])",
                () -> NpyWriter.write(new double[3], file, 2, 2));
        refused("(got: [65536, 65536])", () -> NpyWriter.write(new double[3], file, 65536, 65536));
        refused("(got: [-1])", () -> NpyWriter.write(new double[3], file, -1));
        refused("axes must be given", () -> new PointCloud().writePly(null, file));
        refused("axes must be given", () -> new PointCloud().writePcd(null, file));
        assertThat(file).doesNotExist();
        Path nowhere = folder.resolve("nowhere").resolve("a.ply");
        assertThatThrownBy(() -> new PointCloud().writePly(Axes.ROS, nowhere))
                .isInstanceOf(NoSuchFileException.class)
                .hasMessageContaining(nowhere.toString());
    }

    /** A call that may fail to write. */
    private interface Call {
        void run() throws IOException;
    }

    private static void refused(String message, Call call) {
        assertThatThrownBy(call::run)
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining(message);
    }
}
