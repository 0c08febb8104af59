package robosim.geometry.report;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import robosim.geometry.cases.CaseReader;
import robosim.geometry.cases.Finding;
import robosim.geometry.cases.HardCase;

/**
 * Runs the hard cases against this module and, where they have words for a question, against JTS and dyn4j, and writes a
 * table as {@code hard-cases.md} into {@code target}, or into the folder that the system property {@code report} names.
 *
 * <p>{@code mvn -q test-compile exec:java -Dexec.classpathScope=test -Dexec.mainClass=robosim.geometry.report.HardCases
 * -Dreport=docs/report}
 */
public final class HardCases {
    private HardCases() {}

    /**
     * Runs and writes.
     *
     * @param args none
     * @throws IllegalStateException after all is written, where an answer of the module is wrong
     */
    public static void main(String[] args) throws IOException {
        Path folder = Path.of(System.getProperty("report", "target"));
        List<Peer> peers = List.of(new JtsPeer(), new Dyn4jPeer());
        List<Row> rows = new ArrayList<>();
        for (String family : CaseReader.FAMILIES) {
            for (HardCase hard : CaseReader.family(family)) {
                rows.add(Row.of(hard, family, peers));
            }
        }
        Summary summary = Summary.of(rows, peers);
        Files.createDirectories(folder);
        Files.writeString(folder.resolve("hard-cases.md"), MarkdownTable.write(rows, peers, summary));
        System.out.println(summary.line());
        System.out.println(folder.resolve("hard-cases.md"));
        if (summary.wrong() > 0) {
            List<Finding> wrong = rows.stream()
                    .flatMap(row -> row.findings().stream())
                    .filter(finding -> !finding.right())
                    .toList();
            throw new IllegalStateException("no answer may be wrong (got: " + wrong + ")");
        }
    }
}
