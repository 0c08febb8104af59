package robosim.geometry.docs;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Every work that the code cites by its authors and year is among the glossary's sources. */
@Tag("sources")
class CitationsTest {
    private static final Pattern SOURCE = Pattern.compile("^- ([^:]*?) (\\d{4}):", Pattern.MULTILINE);

    /** The first author, others, and the year. */
    private static final Pattern CITED = Pattern.compile(
            "\\b([A-Z]\\w+)(?:, [A-Z]\\w+)*(?:,? and (?:[A-Z]\\w+ )?[A-Z]\\w+| et al\\.)?,? \\(?((?:19|20)\\d\\d)\\b");

    @Test
    void worksThatAreCitedAreListed() throws IOException {
        String page = Files.readString(Path.of("docs", "glossary.md"));
        Set<String> listed = new HashSet<>();
        Matcher source = SOURCE.matcher(page.substring(page.indexOf("\n## Sources")));
        while (source.find()) {
            String first = source.group(1).replaceFirst("(, | and ).*", "");
            listed.add(first.substring(first.lastIndexOf(' ') + 1) + " " + source.group(2));
        }
        List<Path> files;
        try (Stream<Path> all = Files.walk(Path.of("src", "main", "java"))) {
            files = all.filter(file -> file.toString().endsWith(".java")).toList();
        }
        Set<String> missing = new TreeSet<>();
        int cited = 0;
        for (Path file : files) {
            String text = Files.readString(file).replaceAll("\\R\\s*(\\*|//) ?", " ");
            Matcher work = CITED.matcher(text);
            while (work.find()) {
                cited++;
                if (!listed.contains(work.group(1) + " " + work.group(2))) {
                    missing.add(file.getFileName() + ": " + work.group());
                }
            }
        }
        assertThat(missing).isEmpty();
        assertThat(cited).as("citations seen").isGreaterThan(15);
    }
}
