package robosim.geometry.docs;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Every link of a page to another page, to a file or to a heading leads there. */
@Tag("sources")
class LinksTest {
    private static final Pattern LINK =
            Pattern.compile("!?\\[[^\\]]*\\]\\(([^)\\s]+)(?:\\s+\"[^\"]*\")?\\)|\\b(?:src|href)=\"([^\"]+)\"");
    private static final Pattern ADDRESS = Pattern.compile("^[a-z][a-z0-9+.-]*:");

    @Test
    void linksLeadSomewhere() throws IOException {
        List<String> broken = new ArrayList<>();
        int seen = 0;
        for (Path page : Pages.markdown()) {
            List<String> links = links(page);
            seen += links.size();
            for (String link : links) {
                String fault = fault(page, link);
                if (!fault.isEmpty()) {
                    broken.add(page + ": " + link + ": " + fault);
                }
            }
        }
        assertThat(broken).isEmpty();
        assertThat(seen).as("links seen").isGreaterThan(100);
    }

    /** Each page of docs is reached from the README. */
    @Test
    void noPageIsForgotten() throws IOException {
        List<Path> reached = new ArrayList<>(List.of(Path.of("README.md")));
        for (int k = 0; k < reached.size(); k++) {
            Path page = reached.get(k);
            for (String link : links(page)) {
                Path target = target(page, link.replaceFirst("#.*", ""));
                if (link.replaceFirst("#.*", "").endsWith(".md") && !reached.contains(target) && Files.exists(target)) {
                    reached.add(target);
                }
            }
        }
        assertThat(reached)
                .containsAll(Pages.markdown().stream()
                        .filter(page -> page.startsWith("docs"))
                        .toList());
    }

    private static List<String> links(Path page) throws IOException {
        List<String> links = new ArrayList<>();
        for (String line : Pages.prose(page)) {
            Matcher link = LINK.matcher(line.replaceAll("`[^`]*`", ""));
            while (link.find()) {
                String address = link.group(1) == null ? link.group(2) : link.group(1);
                if (!ADDRESS.matcher(address).find()) {
                    links.add(address);
                }
            }
        }
        return links;
    }

    private static Path target(Path page, String file) {
        if (file.isEmpty()) {
            return page;
        }
        Path folder = page.getParent();
        return (folder == null ? Path.of(file) : folder.resolve(file)).normalize();
    }

    private static String fault(Path page, String link) throws IOException {
        String file = link.replaceFirst("#.*", "");
        String anchor = link.contains("#") ? link.substring(link.indexOf('#') + 1) : "";
        Path target = target(page, file);
        if (target.startsWith("..") || target.startsWith("target") || !Files.exists(target)) {
            return "there is no such file in the project";
        }
        if (!anchor.isEmpty()
                && target.toString().endsWith(".md")
                && !Headings.of(target).contains(anchor)) {
            return "there is no such heading, of " + Headings.of(target);
        }
        return "";
    }

    @Test
    void aBrokenLinkIsSeen(@TempDir Path folder) throws IOException {
        Path page = Files.writeString(folder.resolve("page.md"), """
                # A page: about `this`
                ## Twice
                ## Twice
                [good](page.md#a-page-about-this) [good](#twice-1) ![good](page.md "title") [far](https://example.org/x.md)
                [bad](other.md) [bad](#thrice) `[code](nowhere.md)`
                ```
                [code](nowhere.md)
                ```
                """);
        assertThat(links(page))
                .containsExactly("page.md#a-page-about-this", "#twice-1", "page.md", "other.md", "#thrice");
        assertThat(links(page))
                .map(link -> fault(page, link).isEmpty())
                .containsExactly(true, true, true, false, false);
    }

    @ParameterizedTest
    @CsvSource({
        "JSON lines, json-lines",
        "What is promised, what-is-promised",
        "'`serve` and `connect`: two ends', serve-and-connect-two-ends",
        "10% of it (or less), 10-of-it-or-less",
        "'[A link](x.md) here', a-link-here",
    })
    void headingsAreNamedAsGitHubDoes(String heading, String slug) {
        assertThat(Headings.slug(heading)).isEqualTo(slug);
    }
}
