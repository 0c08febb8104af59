package site;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class SiteTest {
    @TempDir
    Path folder;

    @BeforeEach
    void project() throws IOException {
        Files.createDirectories(folder.resolve("project/docs/images"));
        Files.createDirectories(folder.resolve("project/src"));
        Files.createDirectories(folder.resolve("apidocs"));
        Files.writeString(folder.resolve("apidocs/index.html"), "<html></html>");
        Files.writeString(folder.resolve("project/docs/images/a.svg"), "<svg/>");
    }

    private LinkCheck site(String readme, String page) throws IOException {
        Files.writeString(folder.resolve("project/README.md"), readme);
        Files.writeString(folder.resolve("project/docs/page.md"), page);
        return Site.write(folder.resolve("project"), folder.resolve("site"), folder.resolve("apidocs"), "https://x/");
    }

    @Test
    void linksAreOfPagesAndHeadings() throws IOException {
        LinkCheck check = site(
                "# One & `two`\n[page](docs/page.md#a-b-and-c-1) [far](https://example.org) [code](src)",
                "# Page\n## A `b`, and c\n## A b and c\n[up](../README.md#one--two) ![picture](images/a.svg)\n\n| a | b |\n|---|--:|\n| 1 | 2 |\n");
        assertEquals(List.of(), check.faults());
        String first = Files.readString(folder.resolve("site/index.html"));
        assertTrue(first.contains("href=\"docs/page.html#a-b-and-c-1\""), first);
        assertTrue(first.contains("href=\"https://x/src\""), first);
        assertTrue(first.contains("<title>One &amp; two</title>"), first);
        assertTrue(first.contains("href=\"javadoc/index.html\""), first);
        String second = Files.readString(folder.resolve("site/docs/page.html"));
        assertTrue(second.contains("href=\"../index.html#one--two\""), second);
        assertTrue(second.contains("<td align=\"right\">2</td>"), second);
        assertTrue(Files.exists(folder.resolve("site/docs/images/a.svg")));
    }

    @Test
    void whatLeadsNowhereIsSeen() throws IOException {
        LinkCheck check = site(
                "# One\n[a](docs/page.md#nothing) [b](docs/none.md) [c](none.txt) [good](docs/page.md)",
                "# Page\n<a href=\"none.html\">d</a> [out](../../secret.txt)");
        assertEquals(
                List.of(
                        "index.html: docs/page.html#nothing",
                        "index.html: docs/none.html",
                        "index.html: none.txt",
                        "docs/page.html: none.html",
                        "docs/page.html: ../../secret.txt"),
                check.faults());
    }
}
