package robosim.geometry.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import robosim.geometry.image.PngReader;

/** The pictures of the gallery are what the commands beside them make. */
@Tag("slow")
class GalleryPageTest {
    private static final Path PAGE = Path.of("docs", "gallery.md");
    private static final Path PICTURES = Path.of("docs", "images", "gallery");

    /** A picture, and the command in the block that follows it. */
    private static final Pattern ENTRY = Pattern.compile(
            "!\\[[^\\]]+\\]\\(images/gallery/([\\w-]+\\.png)\\)\\s+```\\n(robosim-geometry render [^`]+)```");

    /** A sixteenth of the pictures' size. */
    private static final int WIDTH = 45;

    private static final int HEIGHT = 27;

    @TempDir
    Path folder;

    private static Map<String, String> entries() throws IOException {
        Map<String, String> entries = new LinkedHashMap<>();
        Matcher found = ENTRY.matcher(Files.readString(PAGE));
        while (found.find()) {
            entries.put(found.group(1), found.group(2).replace("\\\n", " ").strip());
        }
        return entries;
    }

    static List<String> pictures() throws IOException {
        return List.copyOf(entries().keySet());
    }

    @Test
    void eachPictureHasItsCommand() throws IOException {
        List<String> there = new ArrayList<>();
        long bytes = 0;
        try (Stream<Path> files = Files.list(PICTURES)) {
            for (Path file : files.toList()) {
                there.add(String.valueOf(file.getFileName()));
                assertThat(Files.size(file)).as("%s", file).isLessThan(300_000);
                bytes += Files.size(file);
            }
        }
        assertThat(entries().keySet())
                .containsExactlyInAnyOrderElementsOf(there)
                .hasSizeGreaterThan(7);
        assertThat(bytes).isLessThan(2_500_000);
        entries().forEach((picture, command) -> assertThat(command).endsWith("-o " + picture));
    }

    /** Coarsely, with a ray a pixel: compared with the means of the published picture. */
    @ParameterizedTest
    @MethodSource("pictures")
    void theCommandMakesThePicture(String picture) throws IOException {
        Path file = folder.resolve(picture);
        String command = entries().get(picture);
        String coarse = command.replaceFirst("robosim-geometry ", "")
                .replaceFirst("--size \\S+", "--size " + WIDTH + "x" + HEIGHT)
                .replaceFirst("--sky-rays \\S+", "--sky-rays 4")
                .replaceFirst("-o \\S+", "-o " + Matcher.quoteReplacement(file.toString()));
        StringWriter err = new StringWriter();
        int code = Commands.run(new PrintWriter(new StringWriter()), new PrintWriter(err, true), coarse.split("\\s+"));
        assertThat(code).as(err.toString()).isZero();
        double[] made = means(read(file));
        double[] published = means(read(PICTURES.resolve(picture)));
        double difference = 0;
        for (int k = 0; k < made.length; k++) {
            difference += Math.abs(made[k] - published[k]) / made.length;
        }
        // Points of a lidar are at least a pixel wide.
        assertThat(difference).as("mean difference of 255").isLessThan(command.contains("points") ? 28 : 16);
        // Pictures of different things differ more.
        double[] other = means(read(PICTURES.resolve(picture.equals("depth.png") ? "studio.png" : "depth.png")));
        double far = 0;
        for (int k = 0; k < other.length; k++) {
            far += Math.abs(other[k] - published[k]) / other.length;
        }
        assertThat(far).isGreaterThan(Math.max(24, 1.5 * difference));
    }

    private static PngReader.Pixels read(Path file) throws IOException {
        return PngReader.read(new ByteArrayInputStream(Files.readAllBytes(file)));
    }

    /** The mean colours of 15 x 9 parts of a picture. */
    private static double[] means(PngReader.Pixels image) {
        int columns = 15;
        int rows = 9;
        double[] sums = new double[3 * columns * rows];
        int[] counts = new int[columns * rows];
        for (int k = 0; k < image.pixels().length; k++) {
            int part =
                    k / image.width() * rows / image.height() * columns + k % image.width() * columns / image.width();
            counts[part]++;
            for (int channel = 0; channel < 3; channel++) {
                sums[3 * part + channel] += image.pixels()[k] >> (16 - 8 * channel) & 255;
            }
        }
        for (int k = 0; k < sums.length; k++) {
            sums[k] /= counts[k / 3];
        }
        return sums;
    }
}
