package robosim.geometry.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import robosim.geometry.cli.terminal.ExitCodes;
import robosim.geometry.image.PngReader;

/** What {@code render --show} draws of a row of posts, at places whose distances are known. */
class RenderShowTest {
    private static final int WIDTH = 60;
    private static final int HEIGHT = 20;
    private static final int NOTHING = 0x0d1117;

    @TempDir
    Path folder;

    private final StringWriter err = new StringWriter();

    private Path world() throws IOException {
        Path file = folder.resolve("posts.xml");
        Files.writeString(file, """
                <world xmlns="urn:robosim:world:1" width="40" height="8" length="40" unit="m" dimension="SPATIAL">
                  <material name="one" color="#ff0000" label="1"/>
                  <material name="two" color="#00ff00" label="2"/>
                  <box material="one" center="4 0 -3" width="1" height="6" length="2"/>
                  <box material="one" center="8 0 0" width="1" height="6" length="2"/>
                  <box material="two" center="12 0 5" width="1" height="6" length="2"/>
                  <cylinder name="robot" moveable="true" center="-2 0 0" radius="0.3" height="0.4"/>
                </world>
                """);
        return file;
    }

    private int[] shown(String what, String... more) throws IOException {
        Path out = folder.resolve("out.png");
        String[] line = {
            "render",
            world().toString(),
            "--show",
            what,
            "--camera",
            "0,0,0",
            "--look-at",
            "10,0,0",
            "--no-floor",
            "--fov",
            "90",
            "--samples",
            "1",
            "--size",
            WIDTH + "x" + HEIGHT,
            "-o",
            out.toString()
        };
        String[] all = Arrays.copyOf(line, line.length + more.length);
        System.arraycopy(more, 0, all, line.length, more.length);
        int code = Commands.run(new PrintWriter(new StringWriter()), new PrintWriter(err, true), all);
        assertThat(code).as(err.toString()).isZero();
        PngReader.Pixels pixels = PngReader.read(new ByteArrayInputStream(Files.readAllBytes(out)));
        assertThat(pixels.width()).isEqualTo(WIDTH);
        return pixels.pixels();
    }

    /** The pixel in the middle row in which a point of the floor plan is seen: 45 degrees are half the width. */
    private static int at(int[] pixels, double x, double z) {
        return pixels[HEIGHT / 2 * WIDTH + (int) (WIDTH / 2.0 * (1 + z / x))];
    }

    private static int lightness(int pixel) {
        return (pixel >> 16 & 255) + (pixel >> 8 & 255) + (pixel & 255);
    }

    @Test
    void nearDepthsAreLight() throws IOException {
        int[] pixels = shown("depth");
        int near = at(pixels, 3.5, -3);
        int middle = at(pixels, 7.5, 0);
        int far = at(pixels, 11.5, 5);
        assertThat(lightness(near)).isGreaterThan(lightness(middle) + 100);
        assertThat(lightness(middle)).isGreaterThan(lightness(far) + 100);
        assertThat(at(pixels, 10, 9)).isEqualTo(NOTHING);
    }

    /** All front faces look towards the camera. */
    @Test
    void normalsAreThoseOfTheCamera() throws IOException {
        int[] pixels = shown("normals");
        assertThat(at(pixels, 7.5, 0)).isEqualTo(0x8080ff);
        assertThat(at(pixels, 11.5, 5)).isEqualTo(0x8080ff);
    }

    @Test
    void objectsDifferAndLabelsMayBeTheSame() throws IOException {
        int[] objects = shown("objects");
        int[] labels = shown("labels");
        assertThat(at(objects, 3.5, -3)).isNotEqualTo(at(objects, 7.5, 0)).isNotEqualTo(NOTHING);
        assertThat(at(labels, 3.5, -3)).isEqualTo(at(labels, 7.5, 0)).isNotEqualTo(at(labels, 11.5, 5));
        assertThat(at(labels, 10, 9)).isEqualTo(NOTHING);
    }

    /** A lidar behind the camera sees the posts, and nothing between them. */
    @Test
    void pointsLieOnWhatTheLidarSees() throws IOException {
        int[] pixels = shown("points", "--lidar", "os1-128");
        long lit = IntStream.of(pixels).filter(pixel -> pixel != NOTHING).count();
        assertThat(lit).isBetween((long) WIDTH, pixels.length * 3 / 4L);
        assertThat(at(pixels, 10, 9)).isEqualTo(NOTHING);
        boolean isThere = IntStream.range(0, HEIGHT).anyMatch(row -> pixels[row * WIDTH + WIDTH / 2] != NOTHING);
        assertThat(isThere).as("the post ahead").isTrue();
        assertThat(shown("points", "--from", "0,0,0", "--lidar", "os1-128")).isNotEqualTo(pixels);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            --show heat                       | must be one of colour, depth, normals, objects, labels, points (got: heat)
            --show points --from robot:nobody | --from robot:NAME must name a moveable object of the world, one of ["robot"] (got: nobody)
            --show points --from 1,2          | --from must be robot:NAME or X,Y,Z, three numbers (got: 1,2)
            --show points --lidar big         | must be one of vlp16,
            """)
    void whatCannotBeShownIsRefused(String options, String reason) throws IOException {
        String line = "render " + world() + " -o " + folder.resolve("no.png") + " --size 8x8 " + options;
        int code = Commands.run(new PrintWriter(new StringWriter()), new PrintWriter(err, true), line.split(" "));
        assertThat(code).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).contains(reason);
        assertThat(folder.resolve("no.png")).doesNotExist();
    }
}
