package robosim.geometry.docs;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Pages are read on a screen, by somebody who looks for one thing: no paragraph is long, and an example comes early. */
@Tag("sources")
class ParagraphsTest {
    /** A paragraph has fewer words than this. */
    private static final int WORDS = 80;

    /** So many lines of prose at most come before the first example: code, a picture or a table. */
    private static final int BEFORE = 16;

    private static final Pattern ITEM = Pattern.compile("^\\s*(?:[-*+]|\\d+\\.|>)\\s.*");
    private static final Pattern NO_PROSE = Pattern.compile("^\\s*(?:#|\\||<).*");
    private static final Pattern EXAMPLE = Pattern.compile("^\\s*(?:```|~~~|!\\[|\\|).*");

    /** Those that people write; reports are written by programs, and the list of changes is no page to read. */
    private static List<Path> pages() throws IOException {
        return Pages.markdown().stream()
                .filter(page -> !page.startsWith(Path.of("docs", "report")) && !page.startsWith("src"))
                .filter(page -> !page.getFileName().toString().startsWith("LICENSE"))
                .filter(page -> !page.endsWith("CHANGELOG.md"))
                .toList();
    }

    @Test
    void noneIsLong() throws IOException {
        List<String> faults = new ArrayList<>();
        int seen = 0;
        for (Path page : pages()) {
            List<Paragraph> paragraphs = paragraphs(page);
            seen += paragraphs.size();
            paragraphs.stream()
                    .filter(paragraph -> paragraph.words() >= WORDS)
                    .forEach(paragraph ->
                            faults.add("%s:%d: %d words".formatted(page, paragraph.line(), paragraph.words())));
        }
        assertThat(faults).as("paragraphs of %d words or more", WORDS).isEmpty();
        assertThat(seen).as("paragraphs seen").isGreaterThan(500);
    }

    /** A glossary or a guide for contributors is no exception: a table is an example of what is in it. */
    @Test
    void anExampleComesEarly() throws IOException {
        List<String> late = new ArrayList<>();
        for (Path page : pages()) {
            Optional<Integer> before = proseBeforeAnExample(page);
            if (before.isPresent() && before.get() > BEFORE) {
                late.add(page + ": " + before.get() + " lines");
            }
        }
        assertThat(late)
                .as("pages whose first example comes after more than %d lines", BEFORE)
                .isEmpty();
    }

    private static Optional<Integer> proseBeforeAnExample(Path page) throws IOException {
        int prose = 0;
        for (String line : Files.readAllLines(page)) {
            if (EXAMPLE.matcher(line).matches()) {
                return Optional.of(prose);
            }
            prose += line.isBlank() || line.startsWith("#") ? 0 : 1;
        }
        return Optional.empty();
    }

    /** With the line where it begins. */
    private record Paragraph(int line, int words) {}

    /** Also the items of lists, each by itself. */
    private static List<Paragraph> paragraphs(Path page) throws IOException {
        List<Paragraph> paragraphs = new ArrayList<>();
        int begin = 0;
        int words = 0;
        int number = 0;
        List<String> lines = new ArrayList<>(Pages.prose(page));
        lines.add("");
        for (String line : lines) {
            number++;
            boolean isProse = !line.isBlank() && !NO_PROSE.matcher(line).matches();
            if (words > 0 && (!isProse || ITEM.matcher(line).matches())) {
                paragraphs.add(new Paragraph(begin, words));
                words = 0;
            }
            if (isProse) {
                begin = words == 0 ? number : begin;
                words += line.strip().split("\\s+").length;
            }
        }
        return paragraphs;
    }

    @Test
    void whatIsLongIsSeen(@TempDir Path folder) throws IOException {
        String ten = "one two three four five six seven eight nine ten\n";
        Path page = Files.writeString(
                folder.resolve("page.md"),
                "# A page\n" + ten.repeat(8) + "\n" + ten.repeat(7) + "- " + ten.repeat(3) + "- item\n" + "```\n"
                        + ten.repeat(30) + "```\n" + "| " + ten);
        assertThat(paragraphs(page))
                .containsExactly(
                        new Paragraph(2, 80), new Paragraph(11, 70), new Paragraph(18, 31), new Paragraph(21, 2));
        assertThat(proseBeforeAnExample(page)).contains(19);
    }
}
