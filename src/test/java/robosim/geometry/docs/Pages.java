package robosim.geometry.docs;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** The pages that people read: Markdown, and the javadoc of what is exported. */
public final class Pages {
    private static final Pattern FENCE = Pattern.compile("^\\s*(?:```|~~~)\\s*(\\w*).*$");
    private static final Pattern MARKER = Pattern.compile("<!-- java: (.*?) -->\\s*$");
    private static final Path SOURCES = Path.of("src", "main", "java");

    private Pages() {}

    /** Every Markdown page of the project. */
    static List<Path> markdown() throws IOException {
        List<Path> pages = new ArrayList<>();
        for (Path root : List.of(Path.of("README.md"), Path.of("CONTRIBUTING.md"), Path.of("CHANGELOG.md"))) {
            pages.add(root);
        }
        for (String folder : List.of("docs", "examples", "worlds", "src")) {
            try (Stream<Path> files = Files.walk(Path.of(folder))) {
                files.filter(file -> file.toString().endsWith(".md"))
                        .filter(file -> !file.toString().contains("target"))
                        .sorted()
                        .forEach(pages::add);
            }
        }
        return pages;
    }

    /** The fenced blocks of a page, of any language. */
    public static List<Block> blocks(Path page) throws IOException {
        List<Block> blocks = new ArrayList<>();
        List<String> lines = Files.readAllLines(page);
        for (int k = 0; k < lines.size(); k++) {
            Matcher fence = FENCE.matcher(lines.get(k));
            if (fence.matches()) {
                int from = k + 1;
                int to = from;
                while (to < lines.size() && !lines.get(to).strip().matches("```|~~~")) {
                    to++;
                }
                blocks.add(new Block(
                        page.toString().replace('\\', '/'),
                        from + 1,
                        fence.group(1),
                        k > 0 ? marker(lines.get(k - 1)) : "",
                        String.join("\n", lines.subList(from, Math.min(to, lines.size()))) + "\n"));
                k = to;
            }
        }
        return blocks;
    }

    /** A page without its fenced blocks: their lines are empty. */
    static List<String> prose(Path page) throws IOException {
        List<String> lines = new ArrayList<>(Files.readAllLines(page));
        boolean inside = false;
        for (int k = 0; k < lines.size(); k++) {
            boolean fence = FENCE.matcher(lines.get(k)).matches();
            if (fence || inside) {
                lines.set(k, "");
            }
            inside ^= fence;
        }
        return lines;
    }

    /** The sources of the exported packages. */
    static List<Path> exported() throws IOException {
        Matcher exports =
                Pattern.compile("exports ([a-z.]+);").matcher(Files.readString(SOURCES.resolve("module-info.java")));
        List<Path> files = new ArrayList<>();
        while (exports.find()) {
            try (Stream<Path> all = Files.list(SOURCES.resolve(exports.group(1).replace('.', '/')))) {
                all.filter(file -> file.toString().endsWith(".java")).sorted().forEach(files::add);
            }
        }
        return files;
    }

    /** The blocks of code in a source file's javadoc. */
    static List<Block> javadoc(Path source) throws IOException {
        List<Block> blocks = new ArrayList<>();
        List<String> lines = Files.readAllLines(source);
        for (int k = 0; k < lines.size(); k++) {
            if (!lines.get(k).strip().endsWith("<pre>{@code")) {
                continue;
            }
            int from = k + 1;
            StringBuilder code = new StringBuilder();
            int to = from;
            for (; !lines.get(to).contains("}</pre>"); to++) {
                code.append(lines.get(to).replaceFirst("^\\s*\\* ?", "")).append('\n');
            }
            blocks.add(new Block(
                    source.toString().replace('\\', '/'), from + 1, "java", marker(lines.get(k - 1)), code.toString()));
            k = to;
        }
        return blocks;
    }

    private static String marker(String line) {
        Matcher marker = MARKER.matcher(line);
        return marker.find() ? marker.group(1) : "";
    }
}
