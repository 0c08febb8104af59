package robosim.geometry.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import robosim.geometry.Geometry;
import robosim.geometry.image.PngWriter;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;

/** Heightmaps of SDFormat. */
class HeightmapTest {
    @TempDir
    Path folder;

    private WorldImport read(String heightmap) throws IOException {
        Path file = Files.writeString(
                folder.resolve("w.sdf"),
                "<sdf version=\"1.9\"><world name=\"w\"><model name=\"box\"><link name=\"l\"><pose>90 0 0 0 0 0</pose>"
                        + "<collision name=\"c\"><geometry><box><size>1 1 1</size></box></geometry></collision></link>"
                        + "</model><model name=\"m\"><static>true</static><link name=\"l\">\n<collision name=\"c\"><geometry>"
                        + "<heightmap>" + heightmap
                        + "</heightmap></geometry></collision></link></model></world></sdf>");
        return WorldImport.read(file, ImportOptions.DEFAULT);
    }

    private MeshObject mesh(String heightmap) throws IOException {
        WorldImport read = read(heightmap);
        assertThat(read.skipped()).isEmpty();
        return (MeshObject) read.world().objects().stream()
                .filter(each -> each.object().name().equals("m"))
                .findFirst()
                .orElseThrow()
                .object();
    }

    private void pgm(String name, String text) throws IOException {
        Files.writeString(folder.resolve(name), text);
    }

    @Test
    void aCornerForEachPixel() throws IOException {
        pgm("h.pgm", "P2 3 2 100  0 25 50  10 5 20\n");
        MeshObject mesh =
                mesh("<uri>h.pgm</uri><size>4 6 10</size><pos>100 200 300</pos><texture><size>1</size></texture>");
        // Z of SDFormat is up, and so Y here; the first row has the largest Y of SDFormat, and so the least Z here.
        assertThat(mesh.vertices())
                .as("the brightest pixel is as high as the size")
                .containsExactly(
                        new Point(98, 300, -203),
                        new Point(100, 305, -203),
                        new Point(102, 310, -203),
                        new Point(98, 302, -197),
                        new Point(100, 301, -197),
                        new Point(102, 304, -197));
        assertThat(mesh.faces()).isDeepEqualTo(new int[][] {{0, 3, 4, 1}, {1, 4, 5, 2}});
    }

    @Test
    void itsFacesLookUp() throws IOException {
        pgm("h.pgm", "P2 2 2 9  3 3 3 3\n");
        MeshObject mesh = mesh("<uri>h.pgm</uri>");
        List<Point> corners = mesh.vertices();
        int[] face = mesh.faces()[0];
        Point a = corners.get(face[0]);
        Point b = corners.get(face[1]);
        Point c = corners.get(face[2]);
        double up = (b.z() - a.z()) * (c.x() - a.x()) - (b.x() - a.x()) * (c.z() - a.z());
        assertThat(up).isPositive();
        assertThat(corners).as("of size 1 1 1, if it has none").contains(new Point(-.5, 1, -.5), new Point(.5, 1, .5));
    }

    /** 8 bits and 16 bits, and every number of samples, against the formula of the two lines. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 5})
    void samplesBetweenPixels(int sampling) throws IOException {
        SplittableRandom random = new SplittableRandom(sampling);
        int width = 7;
        int height = 4;
        int[] pixels = random.ints(width * height, 0, 65536).toArray();
        short[] greys = new short[pixels.length];
        for (int k = 0; k < greys.length; k++) {
            greys[k] = (short) pixels[k];
        }
        try (OutputStream out = Files.newOutputStream(folder.resolve("h.png"))) {
            PngWriter.writeGrey16(out, width, height, greys);
        }
        MeshObject mesh = mesh("<uri>h.png</uri><size>12 6 1.5</size><sampling>" + sampling + "</sampling>");
        int columns = (width - 1) * sampling + 1;
        assertThat(mesh.vertices()).hasSize(columns * ((height - 1) * sampling + 1));
        int highest = 0;
        for (int each : pixels) {
            highest = Math.max(highest, each);
        }
        for (int k = 0; k < mesh.vertices().size(); k++) {
            double x = (double) (k % columns) / sampling;
            double y = (double) (k / columns) / sampling;
            double sum = 0;
            for (int n = 0; n < pixels.length; n++) { // tents of all pixels
                sum += pixels[n] * Math.max(0, 1 - Math.abs(x - n % width)) * Math.max(0, 1 - Math.abs(y - n / width));
            }
            Point vertex = mesh.vertices().get(k);
            assertThat(vertex.x()).isCloseTo(2 * x - 6, within(1e-12));
            assertThat(vertex.z()).isCloseTo(2 * y - 3, within(1e-12));
            assertThat(vertex.y()).isCloseTo(1.5 * sum / highest, within(1e-12));
        }
    }

    /** A ray down meets the surface where its height is. */
    @Test
    void raysMeetIt() throws IOException {
        byte[] pixels = new byte[65 * 65];
        for (int k = 0; k < pixels.length; k++) {
            pixels[k] = (byte) (k % 65 * 3); // a ramp along X
        }
        try (OutputStream out = Files.newOutputStream(folder.resolve("h.png"))) {
            PngWriter.writeGrey(out, 65, 65, pixels);
        }
        World world = read("<uri>h.png</uri><size>64 64 32</size>").world();
        Geometry geometry = world.toGeometry();
        SplittableRandom random = new SplittableRandom(1);
        for (int k = 0; k < 100; k++) {
            double x = random.nextDouble(-31, 31);
            double y = random.nextDouble(-31, 31);
            Ray down = new Ray(new Point(x, 33, y), new Point(0, -1, 0));
            assertThat(geometry.getRayDistance(down, 0, 100, 0)).isCloseTo(33 - (x + 32) / 2, within(1e-9));
        }
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "<uri>gone.png</uri> | there is no such file or folder below",
                "<size>1 1 1</size> | <heightmap> must have <uri>",
                "<uri>h.tif</uri> | h.tif is neither PNG nor PGM; save it as a grey PNG of 16 bits",
                "<uri>https://example.com/h.png</uri> | network addresses are not followed",
                "<uri>h.pgm</uri><size>1 -1 1</size> | <size> must be above 0, and its height at least 0",
                "<uri>h.pgm</uri><size>1 1 -1</size> | <size> must be above 0, and its height at least 0",
                "<uri>h.pgm</uri><sampling>0</sampling> | <sampling> must be a whole number from 1 to 1000 (got: 0.0)",
                "<uri>h.pgm</uri><sampling>1.5</sampling> | <sampling> must be a whole number",
                "<uri>small.pgm</uri> | the image of a heightmap must have at least 2 x 2 pixels (got: 1 x 2)",
                "<uri>cut.pgm</uri> | cut.pgm:1: a pixel must come next (got: the end of the file)",
                "<uri>text.png</uri> | text.png:1: P2 or P5 must come next (got: text)"
            })
    void aBadOneCostsItself(String heightmap, String message) throws IOException {
        pgm("h.pgm", "P2 2 2 9  0 1 2 3\n");
        pgm("small.pgm", "P2 1 2 9  0 1\n");
        pgm("cut.pgm", "P2 2 2 9  0 1 2");
        pgm("text.png", "text");
        WorldImport read = read(heightmap);
        assertThat(read.world().objects()).hasSize(1);
        assertThat(read.skipped()).hasSize(1);
        assertThat(read.skipped().get(0).toString())
                .contains("w.sdf:2: left out <")
                .contains(message.strip());
    }

    @Test
    void oneThatIsTooLargeIsRefused() throws IOException {
        pgm("h.pgm", "P2 1600 1600 9 ");
        assertThatThrownBy(() -> read("<uri>h.pgm</uri>"))
                .isInstanceOf(WorldException.class)
                .hasMessageContaining("a heightmap must have at most 5000000 triangles; make its image smaller");
    }
}
