package site;

import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import org.commonmark.node.AbstractVisitor;
import org.commonmark.node.Code;
import org.commonmark.node.Heading;
import org.commonmark.node.Node;
import org.commonmark.node.Text;

/** The names of a page's headings, as GitHub gives them: links into the pages name them in both places. */
final class Headings extends AbstractVisitor {
    private final Map<Node, String> names = new HashMap<>();
    private final Map<String, Integer> seen = new HashMap<>();
    private String title = "";

    static Headings of(Node page) {
        Headings headings = new Headings();
        page.accept(headings);
        return headings;
    }

    /** Of the first heading, or empty. */
    String title() {
        return title;
    }

    /** What a link to this heading has behind its {@code #}, or null for another node. */
    String name(Node node) {
        return names.get(node);
    }

    @Override
    public void visit(Heading heading) {
        String text = text(heading);
        title = title.isEmpty() ? text : title;
        String slug = slug(text);
        int before = seen.merge(slug, 1, Integer::sum) - 1;
        names.put(heading, before == 0 ? slug : slug + "-" + before);
    }

    static String slug(String heading) {
        return heading.toLowerCase(Locale.ROOT)
                .replaceAll("[^\\p{L}\\p{N}_ -]", "")
                .replace(' ', '-');
    }

    private static String text(Node node) {
        StringBuilder text = new StringBuilder();
        node.accept(new AbstractVisitor() {
            @Override
            public void visit(Text part) {
                text.append(part.getLiteral());
            }

            @Override
            public void visit(Code part) {
                text.append(part.getLiteral());
            }
        });
        return text.toString();
    }
}
