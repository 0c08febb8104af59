package robosim.geometry.architecture;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** docs/numerics.md names files, constants and tests that there are. */
class NumericsPageTest {
    private static final Path PAGE = Path.of("docs", "numerics.md");
    private static final Pattern LINK = Pattern.compile("\\]\\((\\.\\./[^)#]+)\\)");
    private static final Pattern MEMBER = Pattern.compile("`([A-Z][A-Za-z]+)\\.([A-Za-z_]+)`");
    private static final Pattern TEST = Pattern.compile("\\b([A-Z][A-Za-z]+Test)\\b");

    @Test
    void linksLeadToFiles() throws IOException {
        List<String> links = all(LINK, 1);
        assertThat(links).hasSizeGreaterThan(60);
        assertThat(links)
                .allSatisfy(link -> assertThat(PAGE.getParent().resolve(link)).exists());
    }

    @Test
    void constantsStandWhereThePageSays() throws IOException {
        List<String> types = all(MEMBER, 1);
        List<String> members = all(MEMBER, 2);
        assertThat(members).hasSizeGreaterThan(35);
        for (int k = 0; k < types.size(); k++) {
            String name = types.get(k) + ".java";
            String member = members.get(k);
            if (!name.equals("Math.java")) {
                assertThat(Files.readString(source("src/main/java", name)))
                        .as(types.get(k) + "." + member)
                        .containsPattern("\\b" + member + "( = |\\()");
            }
        }
    }

    @Test
    void testsAreThere() throws IOException {
        List<String> tests = all(TEST, 1);
        assertThat(tests).hasSizeGreaterThan(40);
        for (String test : tests) {
            assertThat(source("src/test/java", test + ".java")).as(test).isRegularFile();
        }
    }

    private static Path source(String root, String name) throws IOException {
        try (Stream<Path> files = Files.walk(Path.of(root))) {
            return files.filter(file -> file.getFileName().toString().equals(name))
                    .findFirst()
                    .orElse(Path.of(name));
        }
    }

    private static List<String> all(Pattern pattern, int group) throws IOException {
        List<String> found = new ArrayList<>();
        var matcher = pattern.matcher(Files.readString(PAGE));
        while (matcher.find()) {
            found.add(matcher.group(group));
        }
        return found;
    }
}
