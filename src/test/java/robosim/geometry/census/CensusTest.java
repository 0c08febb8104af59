package robosim.geometry.census;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import robosim.geometry.Effort;
import robosim.geometry.proof.Witnesses;

/**
 * A census of regimes: each kernel against a slow twin, two-sided, with no regime that only a few cases fall into.
 *
 * <p>The table comes to {@code target/census/regimes.md}; the published one is of {@code census.cases} of 10,000. That is how
 * many plain and how many adversarial cases a kernel is asked, {@code census.seed} where they start, {@code census.kernels} a regular expression of names.
 */
@Tag("slow")
class CensusTest {
    private static final long CASES = Long.getLong("census.cases", Math.max(400, Effort.cases(800)));

    /** Fewer cases than this, plain and adversarial together, are no test of a regime. Of few the scatter is larger. */
    private static final long LEAST = CASES / (CASES < 800 ? 16 : 12);

    private static final long SEED = Long.getLong("census.seed", 20_261_122);
    private static final Path PAGE = Path.of("docs", "report", "regimes.md");
    private static final String NAMES = System.getProperty("census.kernels", ".*");

    @Test
    void noRegimeIsThinAndEveryClaimHolds() throws IOException {
        List<Count> counts = Kernels.all().parallelStream()
                .filter(kernel -> kernel.name().matches(NAMES))
                .map(kernel -> Count.of(kernel, SEED, CASES))
                .toList();
        Path folder = Path.of("target", "census");
        Files.createDirectories(folder);
        Files.writeString(folder.resolve("regimes.md"), page(counts));

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

    /** Every regime is on the published page, and no other. */
    @Test
    void thePublishedPageHasAllRegimes() throws IOException {
        List<String> rows = new ArrayList<>();
        for (Kernel kernel : Kernels.all()) {
            kernel.regimes().forEach(regime -> rows.add("| %s | %s |".formatted(kernel.name(), regime)));
        }
        List<String> published;
        try (Stream<String> lines = Files.lines(PAGE)) {
            published = lines.filter(line -> line.startsWith("| ") && !line.startsWith("| kernel"))
                    .map(line -> line.substring(0, line.indexOf('|', line.indexOf('|', 2) + 1) + 1))
                    .toList();
        }
        assertThat(published).containsExactlyElementsOf(rows);
    }

    private static String page(List<Count> counts) {
        long cases = counts.stream().mapToLong(Count::cases).sum();
        long wrong = counts.stream()
                .flatMap(count -> count.rows.values().stream())
                .mapToLong(row -> row.wrong)
                .sum();
        Witnesses.Counts proofs = counts.stream()
                .map(count -> count.witnesses.counts())
                .reduce(Witnesses.Counts.NONE, Witnesses.Counts::plus);
        return String.format(Locale.ROOT, """
                        # A census of regimes

                        Each kernel, that is, each question about two shapes, against a slow twin of another method: which features
                        are nearest, whether they are inside or outside, touching or tangent, is told by the twin. The build
                        fails where a claim of [numerics.md](../numerics.md) is broken, or where fewer than %,d cases fall into
                        a regime. One build asks 400 cases and requires 25; `.ci/run` asks 800 on its last JDK, and requires 66.

                        ```
                        mvn test -Dtest=CensusTest -Dcensus.cases=10000
                        ```

                        writes this page to `target/census/regimes.md`; `-Dcensus.cases=1000000` asks more, `-Dcensus.seed=7` others.

                        Seed %d; %,d cases, **%,d wrong**. *Random* and *adversarial* count cases. *Early* and *late* are the largest error to
                        either side, *width* the widest bracket that the kernel itself tells, each as a share of the documented
                        bound: above 1 the claim is broken. Where all three are 0 the question is a verdict, or the answer is exact.

                        Of a share of the answers [proofs](../proofs.md) were sought and checked, of all with `-Dtest.proofs=1`:
                        %s.

                        """, LEAST, SEED, cases, wrong, proofs) + table(counts);
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
