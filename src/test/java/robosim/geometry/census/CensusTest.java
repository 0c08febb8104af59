package robosim.geometry.census;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.junit.jupiter.api.Test;

/**
 * A census of regimes: each kernel against a slow twin, two-sided, with no regime that only a few cases fall into.
 *
 * <p>The table comes to {@code target/census/regimes.md}. {@code census.cases} is how many plain and how many adversarial cases
 * a kernel is asked, {@code census.seed} where they start, {@code census.kernels} a regular expression of names.
 */
class CensusTest {
    /** Fewer cases than this, plain and adversarial together, are no test of a regime. */
    private static final long LEAST = 1_000;

    private static final long CASES = Long.getLong("census.cases", 10_000);
    private static final long SEED = Long.getLong("census.seed", 20_261_122);
    private static final String NAMES = System.getProperty("census.kernels", ".*");

    @Test
    void noRegimeIsThinAndEveryClaimHolds() throws IOException {
        List<Count> counts = Kernels.all().parallelStream()
                .filter(kernel -> kernel.name().matches(NAMES))
                .map(kernel -> Count.of(kernel, SEED, CASES))
                .toList();
        Path folder = Path.of("target", "census");
        Files.createDirectories(folder);
        Files.writeString(folder.resolve("regimes.md"), table(counts));

        List<String> failures = new ArrayList<>();
        List<String> thin = new ArrayList<>();
        for (Count count : counts) {
            failures.addAll(count.failures);
            for (Map.Entry<String, Count.Row> row : count.rows.entrySet()) {
                if (row.getValue().random + row.getValue().adversarial < LEAST) {
                    thin.add("%s, %s: %d"
                            .formatted(
                                    count.kernel.name(),
                                    row.getKey(),
                                    row.getValue().random + row.getValue().adversarial));
                }
            }
        }
        assertThat(failures).as("claims that do not hold, of seed " + SEED).isEmpty();
        assertThat(thin).as("regimes with fewer than " + LEAST + " cases").isEmpty();
    }

    private static String table(List<Count> counts) {
        StringBuilder text =
                new StringBuilder("| kernel | regime | random | adversarial | early | late | width | wrong |\n");
        text.append("|---|---|--:|--:|--:|--:|--:|--:|\n");
        for (Count count : counts) {
            count.rows.forEach((regime, row) -> text.append(String.format(
                    Locale.ROOT,
                    "| %s | %s | %,d | %,d | %s | %s | %s | %d |%n",
                    count.kernel.name(),
                    regime,
                    row.random,
                    row.adversarial,
                    share(row.early),
                    share(row.late),
                    share(row.width),
                    row.wrong)));
        }
        return text.toString();
    }

    private static String share(double share) {
        return share == 0 ? "0" : String.format(Locale.ROOT, "%.2g", share);
    }
}
