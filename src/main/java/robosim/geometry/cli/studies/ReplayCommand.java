package robosim.geometry.cli.studies;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import robosim.geometry.check.NumberText;
import robosim.geometry.cli.terminal.Arguments;
import robosim.geometry.cli.terminal.ExitCodes;
import robosim.geometry.cli.terminal.FailureText;
import robosim.geometry.cli.terminal.Progress;
import robosim.geometry.cli.terminal.ProofOptions;
import robosim.geometry.cli.terminal.WireFiles;
import robosim.geometry.net.SessionOptions;
import robosim.geometry.scenario.Mismatch;
import robosim.geometry.scenario.Replay;
import robosim.geometry.scenario.ScenarioReader;
import robosim.geometry.scenario.Step;
import robosim.geometry.scenario.source.StepReader;

/** Replays recorded conversations. */
@Command(
        name = "replay",
        description = "Replays recorded conversations, without sockets, and compares the answers bit for bit.",
        exitCodeList = {
            ExitCodes.FINE + ":every answer is as recorded",
            ExitCodes.FINDINGS
                    + ":an answer differs, a proof failed, a recording was altered or lacks answers, or nothing could be compared",
            ExitCodes.REFUSED
        },
        footer = {
            "  robosim-geometry serve 5555 --record recordings",
            "  robosim-geometry replay recordings",
            "  robosim-geometry replay target/demo",
            "  robosim-geometry replay bug.scenario.jsonl worlds/scenarios"
        })
public final class ReplayCommand implements Callable<Integer> {
    @Spec
    private CommandSpec spec;

    @Parameters(
            arity = "1..*",
            paramLabel = "FILE|FOLDER",
            description =
                    "scenarios, or folders, which are searched with their subfolders for *" + ScenarioReader.ENDING
                            + "; also the demo's " + WireFiles.TO_MODULE + ", with " + WireFiles.FROM_MODULE
                            + " beside it")
    private List<Path> places = List.of();

    @Option(
            names = "--root",
            paramLabel = "DIR",
            description = "worlds that a scenario names are read from within this folder only (default: the parent of"
                    + " the scenario's folder)")
    private @Nullable Path root;

    @Option(
            names = "--most",
            paramLabel = "N",
            description = "maximum number of differences listed for each file (default: 10)")
    private int most = 10;

    @Mixin
    private ProofOptions proofs;

    private long steps;
    private long compared;
    private int different;
    private int unreadable;
    private int altered;
    private int incomplete;
    private int lacking;
    private long unanswered;

    @Override
    public Integer call() throws Exception {
        List<Path> files = files();
        try (Progress progress = Progress.of(spec.commandLine(), "replaying", files.size())) {
            for (int k = 0; k < files.size(); k++) {
                replay(files.get(k), k, progress);
            }
        }
        PrintWriter out = spec.commandLine().getOut();
        out.printf(
                Locale.ROOT,
                "%s, %s, %s compared: %s%n",
                NumberText.count(files.size(), "scenario"),
                NumberText.count(steps, "step"),
                NumberText.count(compared, "answer"),
                verdict());
        out.flush();
        boolean isFine = proofs.tell(out) && different + altered + lacking == 0 && compared > 0;
        return unreadable > 0 ? ExitCodes.UNUSABLE : isFine ? 0 : ExitCodes.FINDINGS;
    }

    private String verdict() {
        List<String> parts = new ArrayList<>();
        if (different + unreadable > 0) {
            parts.add(different + " answered differently, " + unreadable + " unreadable");
        } else if (compared > 0) {
            parts.add(
                    altered + lacking + incomplete == 0
                            ? "all the same, bit for bit"
                            : "what was compared is the same, bit for bit");
        } else {
            parts.add("nothing was compared");
        }
        if (altered > 0) {
            parts.add(altered + " altered");
        }
        if (incomplete > 0) {
            parts.add(incomplete + " incomplete");
        }
        if (unanswered > 0) {
            parts.add(NumberText.count(unanswered, "request") + " without an answer to compare with");
        }
        return String.join(", ", parts);
    }

    private List<Path> files() throws IOException {
        List<Path> files = new ArrayList<>();
        for (Path place : places) {
            if (Files.isRegularFile(place)) {
                Path toModule = WireFiles.at(place);
                files.add(toModule == null ? place : toModule);
                continue;
            }
            if (Files.exists(place) && !Files.isDirectory(place)) {
                Arguments.input("FILE|FOLDER", place); // which refuses it
            }
            Arguments.refuse(!Files.isDirectory(place), "FILE|FOLDER must exist", place);
            int before = files.size();
            try (Stream<Path> tree = Files.walk(place)) {
                tree.filter(file -> isRecording(file) && Files.isRegularFile(file))
                        .sorted()
                        .forEach(files::add);
            }
            Arguments.refuse(
                    files.size() == before,
                    "FOLDER must contain a *" + ScenarioReader.ENDING + " or the demo's " + WireFiles.TO_MODULE
                            + ", directly or in a subfolder",
                    place);
        }
        return files;
    }

    private static boolean isRecording(Path file) {
        return file.toString().endsWith(ScenarioReader.ENDING) || file.endsWith(WireFiles.TO_MODULE);
    }

    private StepReader open(Path file) throws IOException {
        if (file.endsWith(WireFiles.TO_MODULE)) {
            return WireFiles.open(file);
        }
        return StepReader.of(root == null ? ScenarioReader.open(file) : ScenarioReader.open(file, root));
    }

    private void replay(Path file, int number, Progress progress) {
        PrintWriter out = spec.commandLine().getOut();
        try (StepReader reader = open(file)) {
            SessionOptions options = reader.header().options();
            Replay replay = new Replay(options, proofs.listener(String.valueOf(file.getFileName()), options));
            for (Step step = reader.next(); step != null; step = reader.next()) {
                Mismatch mismatch = replay.step(step);
                if (mismatch != null && replay.mismatches() <= most) {
                    progress.clear();
                    out.println(file + ": " + mismatch);
                }
                progress.at(number, () -> file.getFileName() + ", step " + replay.steps());
            }
            progress.clear();
            conclude(file, reader, replay);
        } catch (IOException e) {
            progress.clear();
            unreadable++;
            String told = FailureText.of(e);
            spec.commandLine().getErr().println(told.startsWith(file.toString()) ? told : file + ": " + told);
        }
    }

    private void conclude(Path file, StepReader reader, Replay replay) {
        PrintWriter out = spec.commandLine().getOut();
        if (replay.mismatches() > most) {
            long rest = replay.mismatches() - most;
            out.println(file + ": and " + NumberText.count(rest, "more step") + (rest == 1 ? " is" : " are")
                    + " answered differently");
        }
        ScenarioReader lines = reader.scenario();
        boolean isRecording = lines != null && lines.isRecording();
        if (lines != null) {
            lines.problems().forEach(problem -> out.println(file + ": " + problem));
            altered += lines.altered() > 0 || lines.hasOtherCount() ? 1 : 0;
            incomplete += lines.isComplete() ? 0 : 1;
            // Of a recorder that was killed the last request has no answer; the module may have failed in it.
            lacking += isRecording && replay.unanswered() > (lines.isComplete() ? 0 : 1) ? 1 : 0;
        }
        if (isRecording && replay.unanswered() > 0) {
            out.println(file + ": " + NumberText.count(replay.unanswered(), "request")
                    + (replay.unanswered() == 1 ? " has" : " have") + " no answer to compare with");
        }
        unanswered += replay.unanswered();
        steps += replay.steps();
        compared += replay.compared();
        different += replay.mismatches() > 0 ? 1 : 0;
    }
}
