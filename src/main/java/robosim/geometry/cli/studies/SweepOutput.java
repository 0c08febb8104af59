package robosim.geometry.cli.studies;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Option;
import robosim.geometry.cli.terminal.Arguments;
import robosim.geometry.cli.terminal.ExitCodes;
import robosim.geometry.cli.terminal.WorldFiles;
import robosim.geometry.sweep.SweepResults;
import robosim.geometry.sweep.SweepSummary;

/** The options for how the results of a sweep are reported. */
public final class SweepOutput {
    @Option(names = "--table", paramLabel = "FILE.md", description = "also write the table to a Markdown file")
    private @Nullable Path table;

    @Option(names = "--plot", paramLabel = "FILE.svg", description = "plot the means over the values of a parameter")
    private @Nullable Path plot;

    @Option(
            names = "--csv",
            paramLabel = "FILE.csv",
            description = "also write a row for each replicate, for spreadsheets and data frames")
    private @Nullable Path csv;

    @Option(
            names = "--digest",
            description = "print a digest of all results: the same on any number of threads, shards and machines")
    private boolean digest;

    /** Refuses files that cannot be written, or of another kind, such as a world. */
    void check() {
        if (csv != null) {
            Arguments.output("--csv", csv, ".csv");
        }
        if (table != null) {
            Arguments.output("--table", table, ".md");
        }
        if (plot != null) {
            Arguments.output("--plot", plot, ".svg");
        }
    }

    /** Refuses to write to a file that was read. */
    void keep(WorldFiles files) throws IOException {
        if (csv != null) {
            files.output("--csv", csv);
        }
        if (table != null) {
            files.output("--table", table);
        }
        if (plot != null) {
            files.output("--plot", plot);
        }
    }

    /** Prints the results and returns the exit code. */
    int tell(SweepResults results, PrintWriter out) throws IOException {
        SweepSummary summary = new SweepSummary();
        Failures failures = new Failures();
        results.forEach(outcome -> {
            summary.accept(outcome);
            failures.accept(outcome);
        });
        String text = summary.markdown();
        out.print(text);
        if (table != null) {
            Files.writeString(table, text);
        }
        if (plot != null) {
            Files.writeString(plot, summary.svg(results.header()));
        }
        if (csv != null) {
            results.writeCsv(csv);
        }
        if (summary.isRepetition()) {
            out.println("The replicates of each world and combination of values are all the same: nothing random"
                    + " varied, so one of each says as much");
        }
        failures.tell(out);
        if (digest) {
            out.println("digest " + results.digest());
        }
        out.flush();
        return failures.areThere() ? ExitCodes.FINDINGS : ExitCodes.FINE;
    }
}
