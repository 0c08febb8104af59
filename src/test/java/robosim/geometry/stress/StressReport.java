package robosim.geometry.stress;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;

/** What a run found, as a table to read and as one to compute with. */
final class StressReport {
    private final long seed;
    private final List<Tally> tallies;

    StressReport(long seed, List<Tally> tallies) {
        this.seed = seed;
        this.tallies = List.copyOf(tallies);
    }

    void write(Path folder) throws IOException {
        Files.createDirectories(folder);
        Files.writeString(folder.resolve("stress.md"), markdown());
        Files.writeString(folder.resolve("stress.csv"), csv());
    }

    private String markdown() {
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
        return text.toString();
    }

    private String csv() {
        StringBuilder text = new StringBuilder(
                line("family,sort,seed,cases,yes,close,oracle_checks,wrong,bound,nanos_per_case,digest"));
        for (Tally t : tallies) {
            text.append(line(
                    "%s,%s,%d,%d,%d,%d,%d,%d,%.3e,%.1f,%016x",
                    t.family(),
                    sort(t),
                    seed,
                    t.cases(),
                    t.yes(),
                    t.doubts(),
                    t.checks(),
                    t.wrong(),
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
