package robosim.geometry.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.Writer;
import java.nio.charset.Charset;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Files of every format from a stranger cost no more than their size: what is against a limit is refused by its line. */
@Tag("clock")
@Timeout(120)
class HostileFilesTest {
    private static final String WORLD = "<world xmlns=\"urn:robosim:world:1\" width=\"9\" height=\"9\" length=\"9\"";

    @TempDir
    Path folder;

    private Path file(String name, String text) throws IOException {
        return Files.writeString(folder.resolve(name), text);
    }

    private static void refused(Path file, String message) {
        assertThatThrownBy(() -> WorldImport.read(file, ImportOptions.DEFAULT))
                .isInstanceOf(WorldException.class)
                .hasMessageContaining(message);
    }

    @ParameterizedTest
    @CsvSource({
        "a.yaml, 'image: ', [, lists and keys must be nested at most 20 deep",
        "b.yaml, 'image: ', '{a: ', lists and keys must be nested at most 20 deep",
        "c.sdf, '<sdf version=\"1.6\">\n', <x>, elements must be nested at most 200 deep",
        "g.dae, '<COLLADA>\n', <x>, elements must be nested at most 200 deep",
        "d.sdf, '<x>\n', <x>, the root of SDFormat must be <sdf>",
        "e.xml, '<x>\n', <x>, the root",
        "f.xml, '<world xmlns=\"urn:robosim:world:1\" width=\"9\" height=\"9\" length=\"9\">\n', <group>,"
                + " groups must be nested at most 50 deep"
    })
    void whatIsNestedWithoutEndIsRefusedByItsLine(String name, String head, String level, String message)
            throws IOException {
        Path file = file(name, head + level.repeat(60_000 / level.length()));
        assertThatThrownBy(() -> WorldImport.read(file, ImportOptions.DEFAULT))
                .isInstanceOf(WorldException.class)
                .hasMessageContaining(message);
        // What tells all that is wrong reads on behind the first.
        for (WorldException each : WorldReader.problems(file, ImportOptions.DEFAULT)) {
            assertThat(each.line()).isBetween(1, 2);
        }
    }

    @Test
    void aModelConfigThatIsNestedWithoutEnd() throws IOException {
        file("model.config", "<model>" + "<x>".repeat(60_000));
        file("model.sdf", "<sdf version=\"1.6\"><model name=\"m\"/></sdf>");
        refused(folder, "elements must be nested at most 200 deep");
    }

    /** The parser would keep all of it in memory before it tells of it. */
    @ParameterizedTest
    @CsvSource({
        "xml, UTF-8, ' unit=\"', m",
        "xml, UTF-16, ' unit=\"', m",
        "xml, UTF-8, '><!--', m",
        "xml, UTF-8, '><?x ', m",
        "sdf, UTF-8, ' x=\"', m",
        "sdf, UTF-8, '><![CDATA[', m",
        "sdf, UTF-8, ' x=\"', '&lt;'",
        "dae, UTF-8, ' x=\"', m",
        "dae, UTF-8, '><!--', m"
    })
    void markupWithoutEnd(String ending, String encoding, String before, String character) throws IOException {
        Path file = folder.resolve("t." + ending);
        String head = switch (ending) {
            case "xml" -> WORLD;
            case "dae" -> "<COLLADA";
            default -> "<sdf version=\"1.6\"";
        };
        try (Writer out = Files.newBufferedWriter(file, Charset.forName(encoding))) {
            out.write("<?xml version=\"1.0\" encoding=\"" + encoding + "\"?>\n");
            out.write(head + before);
            for (int k = 0; k < 5000; k++) {
                out.write(character.repeat(1000));
            }
        }
        refused(file, file + ":2: a tag with its attributes, a comment, or the space before");
    }

    @Test
    void aLongTextAndManyCommentsAreNoMarkupWithoutEnd() throws IOException {
        String comment = "<!--" + "x".repeat(1_000_000) + "-->\n";
        StringBuilder vertices = new StringBuilder();
        for (int k = 0; k < 60_000; k++) {
            vertices.append(k % 3 == 0 ? "0 0 0\n" : k % 3 == 1 ? "1 0 0\n" : "0 1 0\n");
        }
        Path file = file(
                "t.xml",
                comment.repeat(6) + WORLD + ">" + comment.repeat(6) + "<mesh><vertices>" + vertices
                        + "</vertices><triangles>0 1 2" + " ".repeat(6_000_000) + "</triangles></mesh></world>");
        assertThat(WorldReader.read(file).objects()).hasSize(1);
    }

    /** Teeth that reach past each other: each ear that is tried holds the tip of the next one. */
    @Test
    @Timeout(60)
    void polygonsOfManyTeeth() throws IOException {
        StringBuilder text = new StringBuilder();
        int half = 500;
        for (int k = 0; k < 2 * half; k++) {
            int x = k < half ? k : 2 * half - 1 - k;
            text.append("v ").append(x).append(' ').append((x % 2 == 0 ? 1 : 1000) - (k < half ? 0.0 : 0.5));
            text.append(" 0\n");
        }
        StringBuilder face = new StringBuilder("f");
        for (int k = 1; k <= 2 * half; k++) {
            face.append(' ').append(k);
        }
        Path file = file("comb.obj", text + (face + "\n").repeat(200));
        WorldImport read = WorldImport.read(file, ImportOptions.DEFAULT);
        assertThat(read.read()).containsEntry("face", 200 * (2 * half - 2));
    }

    @Test
    void facesOfManyCornersAndManyFaces() throws IOException {
        String corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
        refused(
                file("corners.obj", corners + "f" + " 1".repeat(1001) + "\n"),
                ":4: a face must have 3 to 1000 corners");
        StringBuilder round = new StringBuilder();
        StringBuilder face = new StringBuilder("f");
        for (int k = 0; k < 12; k++) {
            round.append("v ").append(k).append(' ').append(k * k).append(" 0\n");
            face.append(' ').append(k + 1);
        }
        refused(
                file("faces.obj", round + (face + "\n").repeat(500_001)),
                ":500013: a file must have at most 5000000 faces, cut into triangles; simplify or split it (got: more)");
    }

    @ParameterizedTest
    @ValueSource(strings = {"t.xml", "t.sdf", "t.yaml", "t.obj", "t.stl", "t.dae"})
    void whatIsNoFileIsNotWaitedFor(String name) throws IOException, InterruptedException {
        Path pipe = folder.resolve(name);
        assumeTrue(isMade(pipe), "pipes with names are a matter of Unix");
        refused(pipe, "the file must be a regular one");
        assertThat(WorldReader.problems(pipe)).hasSize(1);
    }

    @Test
    void aMapAndAModelThatNamePipes() throws IOException, InterruptedException {
        assumeTrue(isMade(folder.resolve("map.pgm"))
                && isMade(folder.resolve("m.sdf"))
                && isMade(folder.resolve("m.stl")));
        refused(
                file(
                        "t.yaml",
                        "image: map.pgm\nresolution: 1\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\n"
                                + "free_thresh: 0.2\n"),
                "there is no such image file");
        refused(
                file(
                        "a.sdf",
                        "<sdf version=\"1.6\"><world name=\"w\"><include><uri>m.sdf</uri></include></world></sdf>"),
                "the file must be a regular one");
        refused(
                file(
                        "b.sdf",
                        "<sdf version=\"1.6\"><model name=\"m\"><link name=\"l\"><collision name=\"c\"><geometry>"
                                + "<mesh><uri>m.stl</uri></mesh></geometry></collision></link></model></sdf>"),
                "the file must be a regular one");
    }

    private static boolean isMade(Path pipe) throws InterruptedException {
        try {
            Process process = new ProcessBuilder("mkfifo", pipe.toString()).start();
            return process.waitFor(20, TimeUnit.SECONDS) && process.exitValue() == 0;
        } catch (IOException e) {
            return false;
        }
    }
}
