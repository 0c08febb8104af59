package robosim.geometry.cli.studies;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import robosim.geometry.cli.terminal.Arguments;
import robosim.geometry.cli.terminal.ExitCodes;
import robosim.geometry.sweep.SweepResults;

/** Merges the results of shards. */
@Command(
        name = "merge",
        description = "Merges the results of a sweep's shards and reports them as one.",
        exitCodeList = {ExitCodes.DONE, ExitCodes.FINDINGS + ":replicates are missing, or failed", ExitCodes.REFUSED},
        footer = {"  robosim-geometry sweep merge sweep-*-of-4.jsonl --out sweep.jsonl --digest"})
public final class SweepMergeCommand implements Callable<Integer> {
    @Spec
    private CommandSpec spec;

    @Parameters(arity = "1..*", paramLabel = "FILE", description = "results of shards")
    private List<Path> files = List.of();

    @Option(
            names = {"-o", "--out"},
            paramLabel = "FILE",
            description = "file for all results, sorted by index")
    private @Nullable Path target;

    @Mixin
    private SweepOutput output;

    @Override
    public Integer call() throws Exception {
        List<Path> present = new ArrayList<>();
        for (Path file : files) {
            present.add(Arguments.input("FILE", file));
        }
        if (target != null) {
            Arguments.newFile("--out", target);
        }
        output.check();
        PrintWriter out = spec.commandLine().getOut();
        SweepResults results = SweepResults.read(present);
        if (target != null) {
            results.write(target);
        }
        int code = output.tell(results, out);
        if (results.torn() > 0) {
            out.printf("%,d of the files end in an incomplete line, which was skipped%n", results.torn());
        }
        long missing = results.header().size() - results.size();
        if (missing > 0) {
            out.printf(
                    "%,d of %,d replicates are missing: add the other shards, or resume those that were stopped%n",
                    missing, results.header().size());
        }
        out.flush();
        return missing > 0 ? ExitCodes.FINDINGS : code;
    }
}
