package site;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.commonmark.Extension;
import org.commonmark.ext.gfm.tables.TablesExtension;
import org.commonmark.node.AbstractVisitor;
import org.commonmark.node.Image;
import org.commonmark.node.Link;
import org.commonmark.node.Node;
import org.commonmark.parser.Parser;
import org.commonmark.renderer.html.AttributeProvider;
import org.commonmark.renderer.html.HtmlRenderer;

/** One Markdown page of the project. */
final class Page {
    private static final List<Extension> EXTENSIONS = List.of(TablesExtension.create());
    private static final Parser PARSER = Parser.builder().extensions(EXTENSIONS).build();

    private final Path root;
    private final Path file;
    private final Node node;
    private final Headings headings;
    private final Set<Path> links = new LinkedHashSet<>();

    /** Of a file of the project, told relative to its root. {@code source} begins the address of a file that is not on the site. */
    Page(Path root, Path file, String text, String source) {
        this.root = root;
        this.file = file;
        node = PARSER.parse(text);
        headings = Headings.of(node);
        node.accept(new AbstractVisitor() {
            @Override
            public void visit(Link link) {
                link.setDestination(address(link.getDestination(), source));
                visitChildren(link);
            }

            @Override
            public void visit(Image image) {
                image.setDestination(address(image.getDestination(), source));
                visitChildren(image);
            }
        });
    }

    /** Pages become HTML, folders are shown where the source is, and other files come along. */
    private String address(String link, String source) {
        String path = link.replaceFirst("#.*", "");
        String anchor = link.substring(path.length());
        if (path.isEmpty() || path.matches("^[a-z][a-z0-9+.-]*:.*")) {
            return link;
        }
        Path target = file.resolveSibling(path).normalize();
        if (Files.isDirectory(root.resolve(target))) {
            return source + target.toString().replace('\\', '/');
        }
        links.add(target);
        Path from = file.getParent() == null ? Path.of("") : file.getParent();
        return from.relativize(written(target)).toString().replace('\\', '/') + anchor;
    }

    /** Where a file of the project comes to on the site. */
    static Path written(Path file) {
        if (file.equals(Path.of("README.md"))) {
            return Path.of("index.html");
        }
        String name = file.toString();
        return name.endsWith(".md") ? Path.of(name.substring(0, name.length() - 3) + ".html") : file;
    }

    Path file() {
        return file;
    }

    String title() {
        return headings.title();
    }

    /** Files of the project that it links to, relative to its root, in their order. */
    Set<Path> links() {
        return links;
    }

    String body() {
        AttributeProvider named = (part, tag, attributes) -> {
            if (headings.name(part) != null) {
                attributes.put("id", headings.name(part));
            }
        };
        return HtmlRenderer.builder()
                .extensions(EXTENSIONS)
                .attributeProviderFactory(context -> named)
                .build()
                .render(node);
    }

    /** The whole page, with a menu of all, whose values are titles. */
    String html(Map<Path, String> menu) {
        Path here = written(file);
        Path from = here.getParent() == null ? Path.of("") : here.getParent();
        StringBuilder list = new StringBuilder();
        menu.forEach((target, title) -> list.append("<li><a%s href=\"%s\">%s</a></li>\n"
                .formatted(
                        target.equals(here) ? " aria-current=\"page\"" : "",
                        from.relativize(target).toString().replace('\\', '/'),
                        escaped(title))));
        String style = from.relativize(Path.of("style.css")).toString().replace('\\', '/');
        return """
                <!DOCTYPE html>
                <html lang="en">
                <head>
                <meta charset="utf-8">
                <meta name="viewport" content="width=device-width, initial-scale=1">
                <title>%s</title>
                <link rel="stylesheet" href="%s">
                </head>
                <body>
                <nav aria-label="Pages">
                <ul>
                %s</ul>
                </nav>
                <main>
                %s</main>
                </body>
                </html>
                """.formatted(escaped(title()), style, list, body());
    }

    private static String escaped(String text) {
        return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;").replace("\"", "&quot;");
    }
}
