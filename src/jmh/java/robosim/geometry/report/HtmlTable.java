package robosim.geometry.report;

import java.util.List;
import robosim.geometry.cases.HardCase;

/** The table as one page that needs nothing else. */
final class HtmlTable {
    private static final String HEAD = """
            <!DOCTYPE html>
            <html lang="en">
            <head>
            <meta charset="utf-8">
            <meta name="viewport" content="width=device-width, initial-scale=1">
            <title>Hard cases</title>
            <style>
            :root {
              color-scheme: light dark;
              --ground: #ffffff; --ink: #1c2733; --faint: #5b6b7b; --line: #d8dfe6; --band: #f3f6f9;
              --right: #1b7f4d; --wrong: #b3261e; --differs: #8a5a00; --link: #1a5fb4;
            }
            @media (prefers-color-scheme: dark) {
              :root {
                --ground: #14191f; --ink: #dfe6ee; --faint: #93a1b0; --line: #2f3944; --band: #1b222a;
                --right: #5fc992; --wrong: #ff8f85; --differs: #e3b34f; --link: #8ab8ff;
              }
            }
            body { margin: 0 auto; max-width: 100rem; padding: 1.5rem; background: var(--ground); color: var(--ink);
              font: 0.95rem/1.45 system-ui, sans-serif; }
            h1 { margin: 0 0 0.5rem; font-size: 1.6rem; }
            h2 { margin: 2.2rem 0 0.6rem; font-size: 1.15rem; }
            a { color: var(--link); }
            .sum { display: flex; flex-wrap: wrap; gap: 0.8rem; margin: 1rem 0; padding: 0; list-style: none; }
            .sum li { flex: 1 1 16rem; padding: 0.8rem 1rem; border: 1px solid var(--line); border-radius: 0.5rem;
              background: var(--band); }
            .sum b { display: block; font-size: 1.25rem; }
            .notes { max-width: 62rem; padding-left: 1.2rem; color: var(--faint); }
            .wide { overflow-x: auto; }
            table { width: 100%; min-width: 66rem; border-collapse: collapse; table-layout: fixed; font-size: 0.86rem; }
            th, td { padding: 0.5rem 0.7rem; border-bottom: 1px solid var(--line); text-align: left;
              vertical-align: top; overflow-wrap: anywhere; }
            th { border-bottom: 2px solid var(--line); color: var(--faint); font-weight: 600; }
            tr:hover td { background: var(--band); }
            td ol { margin: 0; padding-left: 1.3rem; }
            td p { margin: 0 0 0.25rem; }
            .faint { color: var(--faint); }
            .right { color: var(--right); } .wrong { color: var(--wrong); } .differs { color: var(--differs); }
            .cannot { color: var(--faint); }
            .right::before { content: "\\2713  "; } .wrong::before { content: "\\2717  "; }
            .differs::before { content: "\\2260  "; } .cannot::before { content: "\\2013  "; }
            </style>
            </head>
            <body>
            """;

    private HtmlTable() {}

    static String write(List<Row> rows, List<Peer> peers, Summary summary) {
        StringBuilder out = new StringBuilder(HEAD);
        out.append("<h1>Hard cases</h1>\n<p>Questions that engines have answered wrongly, asked here.</p>\n");
        out.append("<ul class=\"sum\">\n<li><b>")
                .append(summary.wrong() == 0 ? "0 wrong here" : summary.wrong() + " wrong here")
                .append("</b>")
                .append(summary.cases() + " cases, " + summary.questions() + " questions, " + summary.variants())
                .append(" variants</li>\n");
        summary.peers().forEach(line -> {
            int at = line.indexOf(':');
            out.append("<li><b>").append(text(line.substring(0, at))).append("</b>");
            out.append(text(line.substring(at + 2))).append("</li>\n");
        });
        out.append("</ul>\n<ul class=\"notes\">\n");
        Summary.notes().forEach(note -> out.append("<li>").append(text(note)).append("</li>\n"));
        out.append("</ul>\n");
        String family = "";
        for (Row row : rows) {
            if (!row.family().equals(family)) {
                out.append(family.isEmpty() ? "" : "</tbody></table></div>\n");
                family = row.family();
                head(family, peers, out);
            }
            write(row, peers, out);
        }
        return out.append("</tbody></table></div>\n</body>\n</html>\n").toString();
    }

    private static void head(String family, List<Peer> peers, StringBuilder out) {
        out.append("<h2>").append(text(Titles.of(family))).append("</h2>\n<div class=\"wide\"><table>\n<colgroup>");
        out.append("<col style=\"width:20%\"><col style=\"width:22%\"><col style=\"width:8%\">");
        peers.forEach(peer -> out.append("<col style=\"width:15%\">"));
        out.append("<col style=\"width:20%\"></colgroup>\n<thead><tr><th>case</th><th>truth</th><th>ours</th>");
        peers.forEach(peer -> out.append("<th>")
                .append(text(peer.name() + " " + peer.version() + ", in projection"))
                .append("</th>"));
        out.append("<th>reported elsewhere</th></tr></thead>\n<tbody>\n");
    }

    private static void write(Row row, List<Peer> peers, StringBuilder out) {
        HardCase hard = row.hard();
        out.append("<tr id=\"")
                .append(hard.id())
                .append("\"><td><p><b>")
                .append(hard.id())
                .append("</b> ");
        out.append(text(hard.title())).append("</p><p>").append(source(hard)).append("</p><p class=\"faint\">");
        out.append(text(hard.hard()))
                .append(" <i>Numbers: ")
                .append(text(hard.numbers()))
                .append(".</i></p></td>\n<td>")
                .append(numbered(row.questions()))
                .append("</td>\n<td>");
        out.append(paragraph(row.wrong() == 0 ? "right" : "wrong", row.ours())).append("</td>");
        for (Peer peer : peers) {
            out.append("\n<td>");
            for (String line : row.theirs(peer.name())) {
                out.append(paragraph(style(line), line));
            }
            out.append("</td>");
        }
        out.append("\n<td><p>").append(text(hard.there()));
        if (!hard.version().isEmpty()) {
            out.append(" <span class=\"faint\">(").append(text(hard.version())).append(")</span>");
        }
        out.append("</p><p class=\"faint\">Today: ").append(text(hard.today())).append("</p>");
        if (!hard.meaning().isEmpty()) {
            out.append("<p class=\"differs\">").append(text(hard.meaning())).append("</p>");
        }
        out.append("</td></tr>\n");
    }

    private static String style(String line) {
        return line.startsWith("wrong")
                ? "wrong"
                : line.startsWith("meaning") ? "differs" : line.startsWith("cannot") ? "cannot" : "right";
    }

    private static String paragraph(String style, String line) {
        return "<p class=\"" + style + "\">" + text(line) + "</p>";
    }

    private static String source(HardCase hard) {
        return hard.link().isEmpty()
                ? text(hard.source())
                : "<a href=\"" + text(hard.link()) + "\">" + text(hard.source()) + "</a>";
    }

    private static String numbered(List<String> lines) {
        if (lines.size() == 1) {
            return text(lines.get(0));
        }
        StringBuilder out = new StringBuilder("<ol>");
        lines.forEach(line -> out.append("<li>").append(text(line)).append("</li>"));
        return out.append("</ol>").toString();
    }

    private static String text(String plain) {
        return plain.replace("&", "&amp;")
                .replace("<", "&lt;")
                .replace(">", "&gt;")
                .replace("\"", "&quot;");
    }
}
