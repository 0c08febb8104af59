package robosim.geometry.architecture;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** docs/numerics.md names files, constants and tests that there are, and repeats the values that the constants have. */
@Tag("sources")
class NumericsPageTest {
    private static final Path PAGE = Path.of("docs", "numerics.md");
    private static final Pattern LINK = Pattern.compile("\\]\\((\\.\\./[^)#]+)\\)");
    private static final Pattern MEMBER = Pattern.compile("`([A-Z][A-Za-z]+)\\.([A-Za-z_]+)`");
    private static final Pattern CONSTANT = Pattern.compile("`([A-Z][A-Za-z]+)\\.([A-Z_]+)`");

    /** Between a constant and its value; where two have the same one, it stands behind the second. */
    private static final Pattern BETWEEN = Pattern.compile(" and `[A-Za-z]+\\.[A-Z_]+` |,? ");

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

    /**
     * What the page says is a multiple of u may be a hundredth of u more in the code, for the squares of u, as the page
     * says; all else is equal.
     */
    @Test
    void constantsHaveTheValuesThatThePageRepeats() throws IOException {
        String page = Files.readString(PAGE);
        Set<String> named = new TreeSet<>();
        Set<String> compared = new TreeSet<>();
        var matcher = CONSTANT.matcher(page);
        while (matcher.find()) {
            String name = matcher.group(1) + "." + matcher.group(2);
            named.add(name);
            String said = valueBehind(page, matcher.end());
            double value = Constants.leading(said);
            if (Double.isNaN(value)) {
                continue;
            }
            double constant = Constants.value(Path.of("src/main/java"), matcher.group(1), matcher.group(2));
            double hundredth = said.matches("(?s)\\d+ \\* U(?! \\* U).*") ? 0.01001 * 0x1p-53 : 0;
            assertThat(constant).as("%s, of which the page says %s", name, said).isBetween(value, value + hundredth);
            compared.add(name);
        }
        assertThat(compared).hasSizeGreaterThan(60);
        named.removeAll(compared);
        assertThat(named).as("constants of which the page tells no value").isEmpty();
    }

    @Test
    void valuesAreReadAsTheyAreWritten() throws IOException {
        assertThat(Constants.leading(inCode("2<sup>-40</sup> of"))).isEqualTo(0x1p-40);
        assertThat(Constants.leading(inCode("128u, then"))).isEqualTo(0x1p-46);
        assertThat(Constants.leading(inCode("33u<sup>2</sup>)"))).isEqualTo(33 * 0x1p-106);
        assertThat(Constants.leading(inCode("1 - 6u and"))).isEqualTo(1 - 6 * 0x1p-53);
        assertThat(Constants.leading(inCode("1 + 2<sup>-49</sup> and"))).isEqualTo(1 + 0x1p-49);
        assertThat(Constants.leading(inCode("(7 + 56u)u of"))).isEqualTo(7 * 0x1p-53 + 56 * 0x1p-106);
        assertThat(Constants.leading(inCode("1.42 times"))).isEqualTo(1.42);
        assertThat(Constants.leading(inCode("of the sizes"))).isNaN();
    }

    /** The text of the page behind a constant, as code. */
    private static String valueBehind(String page, int end) {
        var between = BETWEEN.matcher(page).region(end, page.length());
        if (!between.lookingAt()) {
            return "";
        }
        return inCode(page.substring(between.end(), Math.min(page.length(), between.end() + 40)));
    }

    private static String inCode(String value) {
        return value.replaceAll("\\b2<sup>(-?\\d+)</sup>", "0x1p$1")
                .replaceAll("(?<=[0-9)])u<sup>2</sup>", " * U * U")
                .replaceAll("(?<=[0-9)])u\\b", " * U");
    }

    @Test
    void testsAreThere() throws IOException {
        List<String> tests = all(TEST, 1);
        assertThat(tests).hasSizeGreaterThan(40);
        for (String test : tests) {
            assertThat(source("src/test/java", test + ".java")).as(test).isRegularFile();
        }
    }

    /** The file of that name below a root. */
    static Path source(String root, String name) throws IOException {
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
