package robosim.geometry.stress;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import robosim.geometry.proof.Witnesses;

/** What a run found, as a table to read and as one to compute with. */
final class StressReport {
    private final long seed;
    private final List<Tally> tallies;
    private final List<Fallback> fallbacks;

    StressReport(long seed, List<Tally> tallies, List<Fallback> fallbacks) {
        this.seed = seed;
        this.tallies = List.copyOf(tallies);
        this.fallbacks = List.copyOf(fallbacks);
    }

    void write(Path folder) throws IOException {
        Files.createDirectories(folder);
        Files.writeString(folder.resolve("stress.md"), markdown());
        Files.writeString(folder.resolve("stress.csv"), csv());
        Files.writeString(folder.resolve("fallback.csv"), fallbackCsv());
    }

    String markdown() {
        StringBuilder text = new StringBuilder();
        long cases = tallies.stream().mapToLong(Tally::cases).sum();
        long wrong = tallies.stream().mapToLong(Tally::wrong).sum();
        text.append(line("# Decisions against exact arithmetic"))
                .append(line(""))
                .append(line("Seed %d; Java %s; %,d cases, **%,d wrong**.", seed, Runtime.version(), cases, wrong))
                .append(line(""))
                .append(line(
                        "Where none of N was wrong, the rate of wrong answers on such cases is below 3/N with 95 %%"
                                + " confidence. *Close* is the share that the oracle had to decide in exact numbers. The digest is"
                                + " of all questions and answers."))
                .append(line(""))
                .append(line("| family | cases | number | yes | close | wrong | below | ns a case | digest |"))
                .append(line("|---|---|--:|--:|--:|--:|--:|--:|---|"));
        for (Tally t : tallies) {
            text.append(line(
                    "| %s | %s | %,d | %.1f %% | %.4f %% | %d | %s | %.0f | %016x |",
                    t.family(),
                    sort(t),
                    t.cases(),
                    100 * t.share(),
                    100.0 * t.doubts() / t.cases(),
                    t.wrong(),
                    t.wrong() == 0 ? String.format(Locale.ROOT, "%.1e", t.bound()) : "-",
                    t.nanosEach(),
                    t.digest()));
        }
        Witnesses.Counts proofs =
                tallies.stream().map(Tally::proofs).reduce(Witnesses.Counts.NONE, Witnesses.Counts::plus);
        text.append(line("")).append(line("Of a seeded share of the answers, %s.", proofs));
        text.append(fallbackMarkdown());
        return text.toString();
    }

    private String fallbackMarkdown() {
        StringBuilder text = new StringBuilder();
        text.append(line(""))
                .append(line("## How often exact numbers are needed"))
                .append(line(""))
                .append(line(
                        "Runs of exact stages for a hundred cases, with so many adversarial ones among the random ones;"
                                + " a case of many triangles may need many. The rest is decided in plain doubles."))
                .append(line(""))
                .append(
                        line(
                                "| family | cases | 0 %% | 0.01 %% | 1 %% | 10 %% | 100 %% | stages, of 100 adversarial cases |"))
                .append(line("|---|--:|--:|--:|--:|--:|--:|---|"));
        for (Fallback f : fallbacks) {
            text.append(line("| %s | %,d | %s | %s |", f.family(), f.cases(), rates(f, " | "), stages(f)));
        }
        return text.toString();
    }

    private static String rates(Fallback fallback, String between) {
        return Arrays.stream(fallback.perCase())
                .mapToObj(rate -> String.format(Locale.ROOT, "%.3f", 100 * rate))
                .collect(Collectors.joining(between));
    }

    private static String stages(Fallback fallback) {
        return fallback.stages().entrySet().stream()
                .map(e -> String.format(Locale.ROOT, "%s %.2f", e.getKey(), 100.0 * e.getValue() / fallback.cases()))
                .collect(Collectors.joining(", "));
    }

    private String fallbackCsv() {
        StringBuilder text = new StringBuilder(line("family,cases,none,1_in_10000,1_in_100,1_in_10,all"));
        for (Fallback f : fallbacks) {
            text.append(line("%s,%d,%s", f.family(), f.cases(), rates(f, ",")));
        }
        return text.toString();
    }

    private String csv() {
        StringBuilder text = new StringBuilder(
                line(
                        "family,sort,seed,cases,yes,close,oracle_checks,wrong,proved,unprovable,failed,bound,nanos_per_case,digest"));
        for (Tally t : tallies) {
            text.append(line(
                    "%s,%s,%d,%d,%d,%d,%d,%d,%d,%d,%d,%.3e,%.1f,%016x",
                    t.family(),
                    sort(t),
                    seed,
                    t.cases(),
                    t.yes(),
                    t.doubts(),
                    t.checks(),
                    t.wrong(),
                    t.proofs().proved(),
                    t.proofs().unprovable(),
                    t.proofs().failed(),
                    t.bound(),
                    t.nanosEach(),
                    t.digest()));
        }
        return text.toString();
    }

    private static String sort(Tally tally) {
        return tally.adversarial() ? "adversarial" : "random";
    }

    private static String line(String format, Object... arguments) {
        return String.format(Locale.ROOT, format, arguments) + "\n";
    }
}
