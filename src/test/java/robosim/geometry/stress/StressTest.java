package robosim.geometry.stress;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import robosim.geometry.Effort;

/**
 * The product's decisions against exact rational arithmetic, in every family of questions: some thousand cases in an
 * ordinary build, ten million and more under {@code -Pstress}.
 *
 * <p>The system properties {@code stress.random} and {@code stress.adversarial} are how many of each, {@code stress.seed}
 * is where they start, {@code stress.families} a regular expression of names.
 */
@Tag("slow")
class StressTest {
    private static final long RANDOM = Long.getLong("stress.random", Effort.cases(1_500));
    private static final long ADVERSARIAL = Long.getLong("stress.adversarial", Effort.cases(1_000));
    private static final long SEED = Long.getLong("stress.seed", 20_261_121);
    private static final String NAMES = System.getProperty("stress.families", ".*");

    /** Below so many cases a share is noise. */
    private static final long ENOUGH = 500;

    private static final int LONG_FALLBACK = 100_000;
    private static final int SHORT_FALLBACK = 1_000;

    /** Runs of exact stages for an adversarial case: of a mesh there may be several. */
    private static final double LEAST_RATE = 0.2;

    private static final double MOST_RATE = 6;

    @Test
    void noDecisionIsWrong() throws IOException {
        List<Family> families = Families.all().stream()
                .filter(family -> family.name().matches(NAMES))
                .toList();
        assertThat(families).as("families named " + NAMES).isNotEmpty();
        boolean isLong = RANDOM > 100_000 || ADVERSARIAL > 100_000;
        List<Tally> tallies = new ArrayList<>();
        for (Family family : families) {
            for (boolean adversarial : new boolean[] {false, true}) {
                Tally tally = Tally.of(family, adversarial, SEED, adversarial ? ADVERSARIAL : RANDOM, isLong);
                tallies.add(tally);
                if (isLong) {
                    System.out.println(tally);
                }
            }
        }
        List<Fallback> fallbacks = families.stream()
                .map(family -> Fallback.measure(family, SEED, isLong ? LONG_FALLBACK : SHORT_FALLBACK))
                .toList();
        StressReport report = new StressReport(SEED, tallies, fallbacks);
        report.write(Path.of("target", "stress"));
        if (isLong) {
            System.out.println(report.markdown());
        }

        List<String> failures = new ArrayList<>();
        for (Tally tally : tallies) {
            failures.addAll(tally.failures());
        }
        assertThat(failures).as("wrong decisions, of seed " + SEED).isEmpty();
        for (int k = 0; k < fallbacks.size(); k++) {
            inBand(fallbacks.get(k), families.get(k).exactAtRandom());
        }
        for (Tally tally : tallies) {
            assertThat(tally.wrong()).as(tally.family()).isZero();
            if (tally.cases() >= ENOUGH) {
                mixed(tally, families);
            }
        }
    }

    /** Plain doubles decide nearly all that is random; of what is awkward, the more the more there is of it. */
    private static void inBand(Fallback fallback, double atRandom) {
        double[] rates = fallback.perCase();
        double few = 40.0 / fallback.cases(); // awkward cases come in batches of one kind
        for (int tier = 0; tier < Fallback.TIERS.length; tier++) {
            double share = Fallback.TIERS[tier];
            assertThat(rates[tier])
                    .as("exact stages for a case with a share of %s awkward, %s", share, fallback)
                    .isBetween(Math.max(0, LEAST_RATE * share - few), atRandom + MOST_RATE * share + few);
        }
        assertThat(rates[Fallback.TIERS.length - 1])
                .as("adversarial, %s", fallback)
                .isPositive();
    }

    /** A sample that is all yes, all no or all certain proves nothing. */
    private static void mixed(Tally tally, List<Family> families) {
        Family family = families.stream()
                .filter(f -> f.name().equals(tally.family()))
                .findFirst()
                .orElseThrow();
        double[] mix = family.mix(tally.adversarial());
        assertThat(tally.share()).as("share of yes in " + tally).isBetween(mix[0], mix[1]);
        if (tally.adversarial()) {
            assertThat(tally.doubts())
                    .as("cases too close for doubles in " + tally)
                    .isGreaterThan(tally.cases() / 20);
        }
        if (tally.cases() > 100_000) {
            assertThat(tally.checks())
                    .as("checks of the oracle's own filter in " + tally)
                    .isPositive();
        }
    }

    @Test
    void theResultDoesNotDependOnTheNumberOfThreads() {
        Family family = Families.all().get(0);
        Tally alone = Tally.of(family, true, 1, 3L * Chunk.CASES, false);
        Tally together = Tally.of(family, true, 1, 3L * Chunk.CASES, true);
        assertThat(together.digest()).isEqualTo(alone.digest());
        assertThat(together.yes()).isEqualTo(alone.yes());
    }
}
