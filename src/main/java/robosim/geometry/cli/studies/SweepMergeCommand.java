package robosim.geometry.cli.studies;

import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import robosim.geometry.cli.terminal.ExitCodes;
import robosim.geometry.cli.terminal.Inputs;
import robosim.geometry.cli.terminal.Version;
import robosim.geometry.sweep.SweepResults;

/** Brings the results of shards together. */
@Command(
        name = "merge",
        description = "Brings the results of a sweep's shards together, and tells them as one.",
        mixinStandardHelpOptions = true,
        versionProvider = Version.class,
        exitCodeListHeading = ExitCodes.HEADING,
        exitCodeList = {ExitCodes.DONE, ExitCodes.FINDINGS + ":replicates are missing, or failed", ExitCodes.REFUSED},
        footerHeading = "%nExamples:%n",
        footer = {"  robosim-geometry sweep merge sweep-*-of-4.jsonl --out sweep.jsonl --digest"})
public final class SweepMergeCommand implements Callable<Integer> {
    @Spec
    @SuppressWarnings("NullAway.Init") // set by picocli before call()
    private CommandSpec spec;

    @Parameters(arity = "1..*", paramLabel = "FILE", description = "results of shards")
    private List<Path> files = List.of();

    @Option(
            names = {"-o", "--out"},
            paramLabel = "FILE",
            description = "write all results there, by their index")
    private @Nullable Path target;

    @Mixin
    @SuppressWarnings("NullAway.Init") // set by picocli before call()
    private SweepOutput output;

    private SweepMergeCommand() {}

    @Override
    public Integer call() throws Exception {
        List<Path> present = new ArrayList<>();
        for (Path file : files) {
            present.add(Inputs.file(spec, "FILE", file));
        }
        if (target != null && Files.exists(target)) {
            throw new ParameterException(spec.commandLine(), "--out must be a new file (got: " + target + ")");
        }
        PrintWriter out = spec.commandLine().getOut();
        SweepResults results = SweepResults.read(present);
        if (target != null) {
            results.write(target);
        }
        int code = output.tell(results, out);
        if (results.torn() > 0) {
            out.printf("%,d of the files end in a line that broke off; it was passed over%n", results.torn());
        }
        long missing = results.header().size() - results.size();
        if (missing > 0) {
            out.printf(
                    "%,d of %,d replicates are missing: other shards have them, or resume those that were stopped%n",
                    missing, results.header().size());
        }
        out.flush();
        return missing > 0 ? ExitCodes.FINDINGS : code;
    }
}
