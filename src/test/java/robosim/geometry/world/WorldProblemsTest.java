package robosim.geometry.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import robosim.geometry.world.shared.Limits;

/** All problems of a file at once. */
class WorldProblemsTest {
    @TempDir
    Path folder;

    private List<String> problems(String text) throws IOException {
        Path file = Files.writeString(folder.resolve("t.xml"), text);
        return WorldReader.problems(file).stream()
                .map(problem -> String.valueOf(problem.getMessage())
                        .replace(folder + file.getFileSystem().getSeparator(), ""))
                .toList();
    }

    @Test
    void eachIsToldWithItsLineAndOnce() throws IOException {
        List<String> problems = problems("""
                <world xmlns="urn:robosim:world:1" width="9" height="9" length="9">
                  <box width="x" height="-1" length="1"/>
                  <bo/>
                  <sphere name="a" radius="1"/>
                  <sphere name="a" radius="1" colour="red"/>
                  <mesh><vertices>0 0 0 1 0 0
                     0 1,5 0</vertices><triangles>0 1 2</triangles></mesh>
                  <group><box width="1" height="1"/><sphere radius="2"/></group>
                  <cylinder moveable="true" radius="1" height="1"/>
                  <box width="1" height="1" length="1"/>
                </world>
                """);
        assertThat(problems)
                .extracting(problem -> problem.replaceFirst(":\\d+: .*", ""))
                .containsExactly(
                        "t.xml:2", "t.xml:2", "t.xml:3", "t.xml:5", "t.xml:5", "t.xml:7", "t.xml:8", "t.xml:9");
        assertThat(problems.get(0)).contains("width of <box>");
        assertThat(problems.get(1)).contains("height of <box>");
        assertThat(problems.get(2)).contains("<bo> is not allowed");
        assertThat(problems.get(3)).contains("names must be unique");
        assertThat(problems.get(4)).contains("colour");
        assertThat(problems.get(5)).contains("(got: 1,5)");
        assertThat(problems.get(6)).contains("<box> needs the attribute length");
        assertThat(problems.get(7)).contains("a moveable object must have a name");
    }

    @Test
    void whatIsNoXmlEndsTheList() throws IOException {
        assertThat(problems("<world xmlns=\"urn:robosim:world:1\" width=\"9\" height=\"9\">\n<bo/>\n</worl>"))
                .hasSize(3)
                .last()
                .asString()
                .startsWith("t.xml:3:")
                .contains("well-formed");
        assertThat(problems("")).hasSize(1);
        assertThat(problems("<world xmlns=\"urn:robosim:world:1\" width=\"9\" height=\"9\" length=\"9\">"
                        + "\n<box/>".repeat(500) + "</world>"))
                .hasSize(Limits.MAX_PROBLEMS);
        assertThat(WorldReader.problems(folder.resolve("nowhere.xml")))
                .singleElement()
                .asString()
                .contains("check the path");
    }

    /** The list is empty where the file is read, and else begins with what reading it throws. */
    @Test
    void theFirstIsWhatReadingThrows() throws IOException {
        String text = Files.readString(Path.of("worlds/rooms.xml"));
        SplittableRandom random = new SplittableRandom(3);
        String[] bits = {"\"", "<", ">", "x", "-", " ", "1", "<box/>", "name", "/", "moveable=\"true\" ", "0 0"};
        int good = 0;
        int many = 0;
        for (int run = 0; run < 150; run++) {
            StringBuilder changed = new StringBuilder(text);
            for (int k = random.nextInt(1, 3); k > 0; k--) {
                int at = random.nextInt(changed.length());
                changed.replace(at, at + random.nextInt(2), bits[random.nextInt(bits.length)]);
            }
            Path file = Files.writeString(folder.resolve("t.xml"), changed);
            List<WorldException> problems = WorldReader.problems(file);
            if (problems.isEmpty()) {
                good++;
                assertThat(WorldReader.read(file).objects()).isNotEmpty();
            } else {
                many += problems.size() > 1 ? 1 : 0;
                WorldException thrown = catchThrowableOfType(WorldException.class, () -> WorldReader.read(file));
                assertThat(problems.get(0)).hasMessage(thrown.getMessage());
                assertThat(problems.get(0).line()).isEqualTo(thrown.line());
            }
        }
        assertThat(good).isBetween(5, 145);
        assertThat(many).isBetween(5, 145);
    }
}
