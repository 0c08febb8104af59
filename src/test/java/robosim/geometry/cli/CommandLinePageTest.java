package robosim.geometry.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** docs/command-line.md: its commands exist, its examples are understood, and what they print is what they print. */
class CommandLinePageTest {
    private static final String PROMPT = "$ robosim-geometry ";

    private static String page() throws IOException {
        return Files.readString(Path.of("docs", "command-line.md"));
    }

    private static List<String> blocks(String language) throws IOException {
        Matcher fences =
                Pattern.compile("(?ms)^```" + language + "\\R(.*?)^```$").matcher(page());
        List<String> blocks = new ArrayList<>();
        while (fences.find()) {
            blocks.add(fences.group(1));
        }
        return blocks;
    }

    static List<String> examples() throws IOException {
        return page().lines()
                .filter(line -> line.startsWith(PROMPT))
                .map(line -> line.substring(PROMPT.length()))
                .toList();
    }

    private static String[] words(String example) {
        return example.strip().split(" +");
    }

    @ParameterizedTest
    @MethodSource("examples")
    void itsExamplesAreUnderstood(String example) {
        Commands.line(false).parseArgs(words(example));
    }

    @Test
    void everyCommandHasAnExampleAndALineOfTheTable() throws IOException {
        List<String> shown =
                examples().stream().map(example -> words(example)[0]).toList();
        assertThat(shown).containsAll(Commands.line(false).getSubcommands().keySet());
        for (String name : Commands.line(false).getSubcommands().keySet()) {
            assertThat(page()).contains("| [" + name + "](#").containsPattern("(?m)^## .*\\b" + name + "\\b");
        }
    }

    /** Blocks of a console are carried out; a line of three dots stands for any lines. */
    static List<String> consoles() throws IOException {
        return blocks("console");
    }

    @ParameterizedTest
    @MethodSource("consoles")
    void whatIsShownIsPrinted(String console, @TempDir Path folder) throws IOException {
        String yard = blocks("xml").get(0);
        assertThat(yard).startsWith("<!-- yard.xml -->");
        Path file = Files.writeString(folder.resolve("yard.xml"), yard);
        List<String> shown = console.lines().toList();
        String[] words = words(shown.get(0).substring(PROMPT.length()));
        Arrays.setAll(words, k -> words[k].equals("yard.xml") ? file.toString() : words[k]);
        StringWriter out = new StringWriter();
        int code = Commands.run(new PrintWriter(out, true), new PrintWriter(out, true), words);
        String printed = out.toString().replace(file.toString(), "yard.xml") + "[exit " + code + "]";
        StringBuilder pattern = new StringBuilder();
        for (String line : shown.subList(1, shown.size())) {
            pattern.append(line.equals("...") ? "(?:.*\\R)*?" : Pattern.quote(line) + "(?:\\R|$)");
        }
        assertThat(printed).matches(pattern.toString());
    }

    @Test
    void thereIsSomethingToBeCarriedOut() throws IOException {
        assertThat(consoles()).hasSizeGreaterThan(4);
        assertThat(examples()).hasSizeGreaterThan(15);
    }
}
