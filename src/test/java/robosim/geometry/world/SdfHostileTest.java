package robosim.geometry.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import robosim.geometry.Effort;
import robosim.geometry.model.Point;

/** Files of SDFormat from a stranger: they cost no more than their size, and open nothing that is none of theirs. */
@Tag("slow")
@Timeout(120)
class SdfHostileTest {
    @TempDir
    Path folder;

    private Path file(String name, String text) throws IOException {
        Path file = folder.resolve(name);
        Files.createDirectories(file.getParent());
        return Files.writeString(file, text);
    }

    private Path world(String content) throws IOException {
        return file("t.sdf", "<sdf version=\"1.11\"><world name=\"w\">\n" + content + "\n</world></sdf>");
    }

    private static String ball(String link, String pose) {
        return "<link name=\"" + link + "\">" + pose
                + "<collision name=\"c\"><geometry><sphere><radius>0.5</radius></sphere></geometry></collision></link>";
    }

    @ParameterizedTest
    @ValueSource(
            strings = {"../outside.sdf", "file:///etc/hostname", "linked.sdf", "a\\b.sdf", "model://../outside.sdf"})
    void nothingOutsideOfTheFoldersIsOpened(String uri) throws IOException {
        Path outside = file("outside.sdf", "<sdf version=\"1.6\"><model name=\"secret\"/></sdf>");
        Path file = file(
                "in/t.sdf",
                "<sdf version=\"1.6\"><world name=\"w\"><include><uri>" + uri + "</uri></include></world></sdf>");
        Files.createSymbolicLink(folder.resolve("in/linked.sdf"), outside);
        WorldImport refused = SdfReader.read(file, List.of());
        assertThat(refused.read()).isEmpty();
        assertThat(refused.skipped()).singleElement().asString().contains("<uri> must ");
        // A folder that was given is another matter.
        if (uri.equals("linked.sdf")) {
            assertThat(SdfReader.read(file, List.of(folder)).read()).containsEntry("model", 1);
        }
    }

    /** Each file includes the next twice: two to the fiftieth models, were they not counted. */
    @Test
    void includesThatGrowWithoutEnd() throws IOException {
        for (int k = 0; k < 48; k++) {
            String twice =
                    "<include><uri>f%d.sdf</uri><name>a</name></include><include><uri>f%d.sdf</uri><name>b</name>"
                            + "</include>";
            file(
                    "f" + k + ".sdf",
                    "<sdf version=\"1.6\"><model name=\"m\">" + twice.formatted(k + 1, k + 1) + "</model></sdf>");
        }
        file("f48.sdf", "<sdf version=\"1.6\"><model name=\"m\"/></sdf>");
        assertThatThrownBy(() -> SdfReader.read(folder.resolve("f0.sdf"), List.of()))
                .hasMessageContaining("a world must have at most 500000 models, links and frames");
    }

    /** To place a merged model it is looked at by itself first: twice the work at every level, were it not counted. */
    @Test
    void mergesThatGrowWithoutEnd() throws IOException {
        for (int k = 0; k < 45; k++) {
            file(
                    "g" + k + ".sdf",
                    "<sdf version=\"1.10\"><model name=\"m\"><frame name=\"x" + k + "\"/>"
                            + "<include merge=\"1\"><uri>g" + (k + 1) + ".sdf</uri><placement_frame>x" + (k + 1)
                            + "</placement_frame><pose/></include></model></sdf>");
        }
        file("g45.sdf", "<sdf version=\"1.10\"><model name=\"m\"><frame name=\"x45\"/></model></sdf>");
        assertThatThrownBy(() -> SdfReader.read(folder.resolve("g0.sdf"), List.of()))
                .hasMessageContaining("a world must have at most 500000 models, links and frames");
        assertThat(SdfReader.read(folder.resolve("g35.sdf"), List.of()).isWhole())
                .isTrue();
    }

    @Test
    void includesInACircleAndTooDeep() throws IOException {
        file("a.sdf", "<sdf version=\"1.6\"><model name=\"m\"><include><uri>b.sdf</uri></include></model></sdf>");
        file(
                "b.sdf",
                "<sdf version=\"1.6\"><model name=\"m\"><include merge=\"1\"><uri>a.sdf</uri>"
                        + "<placement_frame>x</placement_frame><pose/></include></model></sdf>");
        assertThat(SdfReader.read(folder.resolve("a.sdf"), List.of()).skipped())
                .singleElement()
                .asString()
                .contains("a file must not include itself, directly or through others (got: a.sdf)");
        for (int k = 0; k < 60; k++) {
            file(
                    "d" + k + ".sdf",
                    "<sdf version=\"1.6\"><model name=\"m\"><include><uri>d" + (k + 1)
                            + ".sdf</uri></include></model></sdf>");
        }
        assertThatThrownBy(() -> SdfReader.read(folder.resolve("d0.sdf"), List.of()))
                .hasMessageContaining("models must be nested at most 50 deep, included ones too");
        String deep = "<model name=\"m\">".repeat(60);
        Path nested = file("n.sdf", "<sdf version=\"1.6\">" + deep + "</model>".repeat(60) + "</sdf>");
        assertThatThrownBy(() -> SdfReader.read(nested, List.of()))
                .hasMessageContaining("models must be nested at most 50 deep; nest less (got: one more)");
    }

    /** A hundred thousand frames, each counting from the one before: no stack is deep enough to follow them by calls. */
    @Test
    void aLongChainOfFrames() throws IOException {
        StringBuilder text = new StringBuilder("<sdf version=\"1.7\"><model name=\"m\"><static>1</static>\n");
        int count = 100_000;
        for (int k = count; k > 0; k--) {
            text.append("<frame name=\"f")
                    .append(k)
                    .append("\" attached_to=\"f")
                    .append(k - 1)
                    .append("\"><pose>1 0 0 0 0 0</pose></frame>\n");
        }
        text.append("<frame name=\"f0\"/>").append(ball("l", "<pose relative_to=\"f" + count + "\"/>"));
        Path file = file("chain.sdf", text.append("</model></sdf>").toString());
        WorldImport read = SdfReader.read(file, List.of());
        assertThat(read.world().objects().get(0).object().center()).isEqualTo(new Point(count, 0, 0));
    }

    /** Else each include of a link would go through all of its poses anew. */
    @ParameterizedTest
    @ValueSource(
            strings = {"pose in link", "pose in model", "pose in collision", "static in model", "geometry in collision"
            })
    void whatCountsOnceIsGivenOnce(String where) throws IOException {
        String name = where.substring(0, where.indexOf(' '));
        String parent = where.substring(where.lastIndexOf(' ') + 1);
        String one = switch (name) {
            case "pose" -> "<pose/>";
            case "static" -> "<static>1</static>";
            default -> "<geometry><sphere><radius>0.5</radius></sphere></geometry>";
        };
        String text = "<model name=\"m\">%s<link name=\"l\">%s<collision name=\"c\">%s%s</collision></link></model>";
        for (int times = 1; times <= 2; times++) {
            String given = one.repeat(times);
            Path file = world(text.formatted(
                    parent.equals("model") ? given : "",
                    parent.equals("link") ? given : "",
                    parent.equals("collision") ? given : "",
                    name.equals("geometry") ? "" : "<geometry><sphere><radius>0.5</radius></sphere></geometry>"));
            if (times == 1) {
                assertThat(SdfReader.read(file, List.of()).world().objects()).hasSize(1);
            } else {
                WorldImport read = SdfReader.read(file, List.of());
                assertThat(read.world().objects()).hasSize(1);
                // Without a second value nothing is missing.
                List<String> told = name.equals("geometry")
                        ? read.skipped().stream().map(Skipped::toString).toList()
                        : read.remarks();
                assertThat(told)
                        .singleElement()
                        .asString()
                        .startsWith(file + ":2: left out <" + name + ">")
                        .contains("<" + parent + "> must have only one <" + name + ">");
            }
        }
    }

    @Test
    void whatIsTooLongIsRefused() throws IOException {
        String long1 = "x".repeat(1001);
        for (String content : List.of(
                "<model name=\"" + long1 + "\"/>",
                "<include><uri>" + long1 + "</uri></include>",
                "<model name=\"m\"><link name=\"l\"><pose>" + "0 ".repeat(501) + "</pose></link></model>")) {
            Path file = world(content);
            assertThatThrownBy(() -> SdfReader.read(file, List.of()))
                    .hasMessageContaining("must have at most 1000 characters");
        }
        String chain = ("<model name=\"" + "n".repeat(300) + "\"><static>1</static>").repeat(4)
                + ball("l", "")
                + "</model>".repeat(4);
        assertThat(SdfReader.read(world(chain), List.of()).skipped())
                .singleElement()
                .asString()
                .contains("a name with those of the enclosing models must have at most 980 characters");
    }

    /** A file of megabytes that holds nothing but sensors costs no memory to speak of, and is no mistake. */
    @Test
    void whatIsPassedOverIsNotKept() throws IOException {
        Path file = folder.resolve("sensors.sdf");
        try (var out = Files.newBufferedWriter(file, StandardCharsets.UTF_8)) {
            out.write("<sdf version=\"1.6\"><model name=\"m\"><link name=\"l\">");
            for (int k = 0; k < 100_000; k++) {
                out.write("<sensor name=\"s" + k + "\"><ray><scan><a/><b/><c/></scan></ray></sensor>\n");
            }
            out.write("</link></model></sdf>");
        }
        assertThat(SdfReader.read(file, List.of()).passedOver()).containsEntry("sensor", 100_000);
    }

    /** Real files with bytes changed, cut out and doubled: each is read or refused as a file, and nothing else happens. */
    @Test
    void brokenFilesAreReadOrRefused() throws IOException {
        SplittableRandom random = new SplittableRandom(66);
        Path real = Path.of("src/test/resources/robosim/geometry/world/sdf");
        int read = 0;
        int refused = 0;
        for (String name : List.of("shapes.sdf", "nested_model.sdf", "turtlebot3_world/model.sdf")) {
            byte[] whole = Files.readAllBytes(real.resolve(name));
            for (int k = 0; k < Effort.cases(300); k++) {
                byte[] bytes = broken(whole, random);
                Path file = Files.write(folder.resolve("broken.sdf"), bytes);
                try {
                    assertThat(SdfReader.read(file, List.of()).world().width()).isPositive();
                    read++;
                } catch (WorldException e) {
                    assertThat(e).hasMessageStartingWith(file + ":");
                    refused++;
                }
            }
        }
        assertThat(read).isGreaterThan(Effort.cases(100));
        assertThat(refused).isGreaterThan(Effort.cases(300));
    }

    private static byte[] broken(byte[] whole, SplittableRandom random) {
        String text = new String(whole, StandardCharsets.ISO_8859_1);
        for (int k = random.nextInt(3); k >= 0; k--) {
            int from = random.nextInt(text.length());
            int to = Math.min(text.length(), from + random.nextInt(1, 40));
            text = switch (random.nextInt(5)) {
                case 0 -> text.substring(0, from) + (char) random.nextInt(256) + text.substring(from + 1);
                case 1 -> text.substring(0, from) + text.substring(to);
                case 2 -> text.substring(0, to) + text.substring(from);
                case 3 ->
                    text.substring(0, from) + random.nextInt(-9, 10) + "e" + random.nextInt(400) + text.substring(from);
                default ->
                    text.replace(
                            new String[] {"<pose>", "<radius>0", "true", "<link ", "0 0", "<size>1"}[random.nextInt(6)],
                            new String[] {
                                        "<pose relative_to=\"box\">", "<radius>-", "1", "<frame ", "1 nan", "<size>1e99"
                                    }
                                    [random.nextInt(6)]);
            };
        }
        return text.getBytes(StandardCharsets.ISO_8859_1);
    }
}
