package robosim.geometry.report;

import java.util.List;
import robosim.geometry.cases.HardCase;

/** The table as Markdown. */
final class MarkdownTable {
    private MarkdownTable() {}

    static String write(List<Row> rows, List<Peer> peers, Summary summary) {
        StringBuilder out = new StringBuilder("# Hard cases\n\n");
        out.append("Questions that engines have answered wrongly, asked here. The cases are data, in"
                + " `src/test/resources/robosim/geometry/cases`; this page is written by\n\n```\nmvn -q test-compile"
                + " exec:java -Dexec.classpathScope=test -Dexec.mainClass=robosim.geometry.report.HardCases"
                + " -Dreport=docs/report\n```\n\n");
        out.append("**").append(text(summary.line())).append("**\n\n");
        Summary.notes().forEach(note -> out.append("- ").append(text(note)).append('\n'));
        String family = "";
        for (Row row : rows) {
            if (!row.family().equals(family)) {
                family = row.family();
                out.append("\n## ").append(Titles.of(family)).append("\n\n| case | truth | ours |");
                peers.forEach(peer -> out.append(' ')
                        .append(peer.name())
                        .append(' ')
                        .append(peer.version())
                        .append(", in projection |"));
                out.append(" reported elsewhere |\n|---|---|---|");
                peers.forEach(peer -> out.append("---|"));
                out.append("---|\n");
            }
            write(row, peers, out);
        }
        return out.toString();
    }

    private static void write(Row row, List<Peer> peers, StringBuilder out) {
        HardCase hard = row.hard();
        out.append("| **").append(hard.id()).append("** ").append(text(hard.title()));
        out.append("<br>")
                .append(source(hard))
                .append("<br>*numbers: ")
                .append(text(hard.numbers()))
                .append('*');
        out.append(" | ").append(numbered(row.questions()));
        out.append(" | ").append(row.wrong() == 0 ? row.ours() : "**" + row.ours() + "**");
        for (Peer peer : peers) {
            out.append(" | ").append(lines(row.theirs(peer.name())));
        }
        out.append(" | ").append(text(hard.there()));
        if (!hard.version().isEmpty()) {
            out.append(" (").append(text(hard.version())).append(')');
        }
        out.append("<br>*today: ").append(text(hard.today())).append('*');
        if (!hard.meaning().isEmpty()) {
            out.append("<br>*meaning: ").append(text(hard.meaning())).append('*');
        }
        out.append(" |\n");
    }

    private static String source(HardCase hard) {
        return hard.link().isEmpty() ? text(hard.source()) : "[" + text(hard.source()) + "](" + hard.link() + ")";
    }

    private static String numbered(List<String> lines) {
        StringBuilder out = new StringBuilder();
        for (int k = 0; k < lines.size(); k++) {
            out.append(k == 0 ? "" : "<br>").append(lines.size() == 1 ? "" : k + 1 + ". ");
            out.append(text(lines.get(k)));
        }
        return out.toString();
    }

    private static String lines(List<String> lines) {
        return String.join("<br>", lines.stream().map(MarkdownTable::text).toList());
    }

    private static String text(String plain) {
        return plain.replace("&", "&amp;")
                .replace("<", "&lt;")
                .replace("|", "\\|")
                .replace("*", "\\*");
    }
}
