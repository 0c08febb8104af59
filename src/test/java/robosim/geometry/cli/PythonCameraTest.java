package robosim.geometry.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.InputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import robosim.geometry.image.PngReader;
import robosim.geometry.net.GeometryServer;
import robosim.geometry.net.NetOptions;

/** examples/camera.py, a process of its own, against the module in this one. */
@Tag("clock")
@Timeout(120)
class PythonCameraTest {
    private static final int PIXELS = 64 * 48;

    @BeforeAll
    static void pythonIsThere() {
        PythonEnvironmentTest.pythonIsThere();
    }

    private static Process start(String... arguments) throws Exception {
        String program = Examples.FOLDER.resolve("camera.py").toString();
        ProcessBuilder builder = new ProcessBuilder("python3", program).redirectErrorStream(true);
        builder.environment().put("PYTHONDONTWRITEBYTECODE", "1");
        builder.command().addAll(List.of(arguments));
        return builder.start();
    }

    private static String end(Process process) throws Exception {
        return new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    }

    @Test
    void visitsEachBallByWhatItSees(@TempDir Path folder) throws Exception {
        NetOptions options = NetOptions.defaults();
        try (GeometryServer server = new GeometryServer(InetAddress.getLoopbackAddress(), 0, options)) {
            String place = InetAddress.getLoopbackAddress().getHostAddress() + ":" + server.port();
            Process process = start("--connect", place, "--seed", "3", "--save", folder.toString());
            String text = end(process);
            assertThat(process.waitFor()).as(text).isZero();
            assertThat(text).contains("3 of 3 balls visited");
        }
        byte[] head = "P5\n64 48\n65535\n".getBytes(StandardCharsets.US_ASCII);
        byte[] depth = Files.readAllBytes(folder.resolve("depth-0000.pgm"));
        assertThat(depth).startsWith(head).hasSize(head.length + 2 * PIXELS);
        ByteBuffer millimetres = ByteBuffer.wrap(depth, head.length, 2 * PIXELS);
        for (int pixel = 0; pixel < PIXELS; pixel++) {
            // The room is closed up to the eaves, 2 m high; above them there is nothing to see.
            int here = Short.toUnsignedInt(millimetres.getShort());
            assertThat(here).isLessThan(5_300);
            assertThat(here > 0 || pixel < PIXELS / 2).isTrue();
        }
        byte[] head6 = "P6\n64 48\n255\n".getBytes(StandardCharsets.US_ASCII);
        int frames = 0;
        boolean seesBall = false;
        for (; Files.exists(folder.resolve(String.format(Locale.ROOT, "objects-%04d.ppm", frames))); frames++) {
            byte[] objects = Files.readAllBytes(folder.resolve(String.format(Locale.ROOT, "objects-%04d.ppm", frames)));
            assertThat(objects).startsWith(head6).hasSize(head6.length + 3 * PIXELS);
            byte[] blues = Arrays.copyOfRange(objects, head6.length, objects.length);
            for (int pixel = 0; pixel < PIXELS; pixel++) {
                seesBall |= blues[3 * pixel + 2] == 20;
            }
        }
        try (InputStream in = Files.newInputStream(folder.resolve("color-0010.png"))) {
            PngReader.Pixels picture = PngReader.read(in);
            assertThat(picture.width()).isEqualTo(320);
            assertThat(picture.height()).isEqualTo(240);
            assertThat(Arrays.stream(picture.pixels()).distinct().count()).isGreaterThan(200);
        }
        assertThat(frames).isBetween(50, 400);
        assertThat(seesBall).isTrue();
    }

    @Test
    void whereNobodyListensIsTold() throws Exception {
        int port;
        try (ServerSocket free = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            port = free.getLocalPort();
        }
        Process process = start("--connect", "127.0.0.1:" + port);
        assertThat(end(process)).startsWith("Not done: ").contains("refused");
        assertThat(process.waitFor()).isEqualTo(2);
    }
}
