package robosim.geometry.report.speed;

import java.util.List;
import robosim.geometry.report.speed.Page.Block;
import robosim.geometry.report.speed.Page.Code;
import robosim.geometry.report.speed.Page.Heading;
import robosim.geometry.report.speed.Page.Paragraph;
import robosim.geometry.report.speed.Page.Picture;
import robosim.geometry.report.speed.Page.Table;

/** A page as one file that needs nothing else: its pictures are in it. */
final class Html {
    private static final String HEAD = """
            <!DOCTYPE html>
            <html lang="en">
            <head>
            <meta charset="utf-8">
            <meta name="viewport" content="width=device-width, initial-scale=1">
            <title>Speed against error</title>
            <style>
            :root {
              color-scheme: light dark;
              --ground: #ffffff; --ink: #1c2733; --faint: #5b6b7b; --line: #d8dfe6; --band: #f3f6f9; --link: #1a5fb4;
            }
            @media (prefers-color-scheme: dark) {
              :root {
                --ground: #14191f; --ink: #dfe6ee; --faint: #93a1b0; --line: #2f3944; --band: #1b222a; --link: #8ab8ff;
              }
            }
            body { margin: 0 auto; max-width: 72rem; padding: 1.5rem; background: var(--ground); color: var(--ink);
              font: 0.97rem/1.5 system-ui, sans-serif; }
            h1 { margin: 0 0 0.5rem; font-size: 1.7rem; }
            h2 { margin: 2.6rem 0 0.6rem; font-size: 1.25rem; }
            h3 { margin: 1.8rem 0 0.5rem; font-size: 1.05rem; }
            p { max-width: 52rem; }
            a { color: var(--link); }
            figure { margin: 1rem 0; border: 1px solid var(--line); border-radius: 0.5rem; overflow-x: auto; }
            figure svg { display: block; width: 100%; height: auto; min-width: 44rem; }
            .wide { overflow-x: auto; margin: 1rem 0; }
            table { border-collapse: collapse; font-size: 0.84rem; }
            th, td { padding: 0.3rem 0.6rem; border-bottom: 1px solid var(--line); text-align: left;
              vertical-align: top; }
            th { border-bottom: 2px solid var(--line); color: var(--faint); font-weight: 600; }
            .number { text-align: right; font-variant-numeric: tabular-nums; }
            td.number, td:first-child { white-space: nowrap; }
            th { vertical-align: bottom; }
            tr:hover td { background: var(--band); }
            pre { padding: 0.8rem 1rem; background: var(--band); border-radius: 0.4rem; overflow-x: auto; }
            code { font-family: ui-monospace, monospace; font-size: 0.92em; }
            </style>
            </head>
            <body>
            """;

    private Html() {}

    static String write(Page page) {
        StringBuilder out = new StringBuilder(HEAD);
        for (Block block : page.blocks()) {
            if (block instanceof Heading heading) {
                out.append("<h").append(heading.level()).append('>').append(text(heading.text()));
                out.append("</h").append(heading.level()).append(">\n");
            } else if (block instanceof Paragraph paragraph) {
                out.append("<p>").append(text(paragraph.text())).append("</p>\n");
            } else if (block instanceof Picture picture) {
                out.append("<figure id=\"").append(picture.figure().name()).append("\">\n");
                out.append(picture.figure().svg()).append("</figure>\n");
            } else if (block instanceof Table table) {
                table(table, out);
            } else if (block instanceof Code code) {
                out.append("<pre><code>").append(escaped(code.text())).append("</code></pre>\n");
            }
        }
        return out.append("</body>\n</html>\n").toString();
    }

    private static void table(Table table, StringBuilder out) {
        out.append("<div class=\"wide\"><table>\n<thead>");
        row(table, table.head(), "th", out);
        out.append("</thead>\n<tbody>\n");
        table.rows().forEach(row -> row(table, row, "td", out));
        out.append("</tbody></table></div>\n");
    }

    private static void row(Table table, List<String> cells, String tag, StringBuilder out) {
        out.append("<tr>");
        for (int column = 0; column < cells.size(); column++) {
            out.append('<').append(tag).append(Markdown.isNumber(table, column) ? " class=\"number\">" : ">");
            out.append(text(cells.get(column))).append("</").append(tag).append('>');
        }
        out.append("</tr>\n");
    }

    /** Plain text with {@code code}, bold and links as Markdown has them. */
    private static String text(String plain) {
        return escaped(plain)
                .replaceAll("`([^`]+)`", "<code>$1</code>")
                .replaceAll("\\*\\*([^*]+)\\*\\*", "<b>$1</b>")
                .replaceAll("\\[([^\\]]+)\\]\\(([^)]+)\\)", "<a href=\"$2\">$1</a>");
    }

    private static String escaped(String text) {
        return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;");
    }
}
