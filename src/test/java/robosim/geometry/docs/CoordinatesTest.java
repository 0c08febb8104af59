package robosim.geometry.docs;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import robosim.geometry.cli.terminal.Version;
import robosim.geometry.protocol.json.JsonLines;

/** Whoever copies coordinates from a page or an example gets those of the pom. */
@Tag("sources")
class CoordinatesTest {
    private static final Pattern JAR =
            Pattern.compile("robosim-geometry-(\\d[\\w.]*(?:-rc\\.\\d+|-SNAPSHOT)?)(?:-app)?\\.jar");
    private static final Pattern DEPENDENCY = Pattern.compile(
            "<groupId>([\\w.-]+)</groupId>\\s*<artifactId>robosim-geometry</artifactId>\\s*<version>([^<]+)</version>");

    private static String ofThePom(String pattern) throws IOException {
        Matcher found = Pattern.compile(pattern).matcher(Files.readString(Path.of("pom.xml")));
        assertThat(found.find()).as(pattern).isTrue();
        return found.group(1);
    }

    @Test
    void allAreThoseOfThePom() throws IOException {
        String group = ofThePom("<groupId>(.*?)</groupId>");
        String version = ofThePom("<version>(.*?)</version>");
        assertThat(group).isEqualTo("io.github." + ofThePom("<github.owner>(.*?)</github.owner>"));
        assertThat(Version.NUMBER).isEqualTo(version);
        assertThat(JsonLines.MODULE).isEqualTo("robosim-geometry " + version);
        assertThat(Files.readString(Path.of("CITATION.cff"))).contains("\nversion: " + version + "\n");

        List<Path> files = new ArrayList<>(Pages.markdown());
        files.removeIf(file -> file.endsWith("CHANGELOG.md"));
        try (Stream<Path> examples = Files.walk(Path.of("examples"))) {
            examples.filter(file -> file.endsWith("pom.xml")).forEach(files::add);
        }
        int seen = 0;
        for (Path file : files) {
            String text = Files.readString(file);
            for (Matcher jar = JAR.matcher(text); jar.find(); seen++) {
                assertThat(jar.group(1)).as(file + ": " + jar.group()).isEqualTo(version);
            }
            for (Matcher found = DEPENDENCY.matcher(text); found.find(); seen++) {
                assertThat(found.group(1)).as(file.toString()).isEqualTo(group);
                assertThat(found.group(2)).as(file.toString()).isIn(version, "${robosim.version}");
            }
        }
        assertThat(seen).isGreaterThan(8);
    }
}
