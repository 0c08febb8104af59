package site;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

/**
 * The documents as a static site: README.md is its first page, and each page that can be reached from it is written, in the
 * order in which they are first linked. Every link is followed; one that leads nowhere ends this with 1.
 *
 * <p>Arguments: the project, the folder to write, the folder of the javadoc, the address where the source is shown.
 */
public final class Site {
    private static final Path JAVADOC = Path.of("javadoc");

    private Site() {}

    /** Writes the site. */
    public static void main(String[] args) throws IOException {
        LinkCheck check = write(Path.of(args[0]), Path.of(args[1]), Path.of(args[2]), args[3]);
        check.faults().forEach(fault -> System.err.println("leads nowhere: " + fault));
        System.out.println(check.links() + " links, " + check.faults().size() + " lead nowhere: " + args[1]);
        if (!check.faults().isEmpty()) {
            System.exit(1);
        }
    }

    static LinkCheck write(Path project, Path out, Path javadoc, String source) throws IOException {
        Map<Path, Page> pages = new LinkedHashMap<>();
        Deque<Path> next = new ArrayDeque<>(List.of(Path.of("README.md")));
        while (!next.isEmpty()) {
            Path file = next.remove();
            if (pages.containsKey(file) || !Files.isRegularFile(project.resolve(file))) {
                continue;
            }
            if (!file.toString().endsWith(".md")) {
                copy(project.resolve(file), out.resolve(file));
                continue;
            }
            Page page = new Page(project, file, Files.readString(project.resolve(file)), source);
            pages.put(file, page);
            next.addAll(page.links());
        }
        Map<Path, String> menu = new LinkedHashMap<>();
        pages.values().forEach(page -> menu.put(Page.written(page.file()), page.title()));
        menu.put(JAVADOC.resolve("index.html"), "API (javadoc)");

        try (Stream<Path> files = Files.walk(javadoc)) {
            for (Path file : files.filter(Files::isRegularFile).toList()) {
                copy(file, out.resolve(JAVADOC).resolve(javadoc.relativize(file)));
            }
        }
        try (var style = Site.class.getResourceAsStream("style.css")) {
            Files.copy(style, out.resolve("style.css"), StandardCopyOption.REPLACE_EXISTING);
        }
        LinkCheck check = new LinkCheck(out);
        for (Page page : pages.values()) {
            Path file = out.resolve(Page.written(page.file()));
            Files.createDirectories(file.getParent());
            Files.writeString(file, page.html(menu));
        }
        for (Page page : pages.values()) {
            check.page(out.normalize().resolve(Page.written(page.file())));
        }
        return check;
    }

    private static void copy(Path from, Path to) throws IOException {
        Files.createDirectories(to.getParent());
        Files.copy(from, to, StandardCopyOption.REPLACE_EXISTING);
    }
}
