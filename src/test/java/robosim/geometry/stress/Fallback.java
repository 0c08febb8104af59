package robosim.geometry.stress;

import java.util.Arrays;
import java.util.SortedMap;
import java.util.SplittableRandom;
import java.util.TreeMap;
import robosim.geometry.exact.StageCounters;
import robosim.geometry.narrow.Scratch;

/**
 * How often the product's filters leave a question of one family to its exact stages, with so many awkward cases among
 * the random ones. Runs on one thread while nothing else asks, as the counts are the JVM's.
 *
 * @param perCase exact stages run for a case, for each of {@link #TIERS}; a case of many triangles may run many
 * @param stages  how often each stage was run in the last tier, by its name
 */
record Fallback(String family, long cases, double[] perCase, SortedMap<String, Long> stages) {
    /** Shares of adversarial cases: none, one in ten thousand, one in a hundred, one in ten, all. */
    static final double[] TIERS = {0, 0.0001, 0.01, 0.1, 1};

    private static final int BLOCK = 256;

    static Fallback measure(Family family, long seed, int cases) {
        double[] perCase = new double[TIERS.length];
        SortedMap<String, Long> stages = new TreeMap<>();
        for (int tier = 0; tier < TIERS.length; tier++) {
            SplittableRandom random = new SplittableRandom(seed + tier);
            stages = count(family, family.source(random.split()), random, TIERS[tier], cases);
            perCase[tier] =
                    (double) stages.values().stream().mapToLong(Long::longValue).sum() / cases;
        }
        return new Fallback(family.name(), cases, perCase, stages);
    }

    private static SortedMap<String, Long> count(
            Family family, Family.Source source, SplittableRandom random, double tier, int cases) {
        Case[] block = new Case[BLOCK];
        Arrays.setAll(block, k -> new Case());
        Scratch scratch = new Scratch();
        SortedMap<String, Long> sums = new TreeMap<>();
        for (int done = 0; done < cases; done += BLOCK) {
            int count = Math.min(BLOCK, cases - done);
            for (int k = 0; k < count; k++) {
                if (random.nextDouble() < tier) {
                    source.adversarial(block[k]);
                } else {
                    source.random(block[k]);
                }
            }
            SortedMap<String, Long> before = StageCounters.counts();
            for (int k = 0; k < count; k++) {
                family.product(block[k], scratch);
            }
            StageCounters.counts().forEach((name, after) -> {
                long runs = after - before.getOrDefault(name, 0L);
                if (runs > 0) {
                    sums.merge(name, runs, Long::sum);
                }
            });
        }
        return sums;
    }

    @Override
    public String toString() {
        return family + ": exact stages a case " + Arrays.toString(perCase) + " of " + cases + ", " + stages;
    }
}
