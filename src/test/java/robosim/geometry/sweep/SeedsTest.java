package robosim.geometry.sweep;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.math.BigInteger;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;

/** Seeds are what the documents say, and streams are even. */
class SeedsTest {
    private static final BigInteger WORD = BigInteger.ONE.shiftLeft(64);

    /** The step of docs/sweep.md, in whole numbers without an end. */
    private static BigInteger take(BigInteger h, long word) {
        BigInteger z = h.xor(unsigned(word)).add(unsigned(0x9E3779B97F4A7C15L)).mod(WORD);
        z = z.xor(z.shiftRight(30)).multiply(unsigned(0xBF58476D1CE4E5B9L)).mod(WORD);
        z = z.xor(z.shiftRight(27)).multiply(unsigned(0x94D049BB133111EBL)).mod(WORD);
        return z.xor(z.shiftRight(31));
    }

    private static BigInteger unsigned(long word) {
        return new BigInteger(Long.toUnsignedString(word));
    }

    private static BigInteger take(BigInteger h, String text) {
        BigInteger taken = h;
        for (char unit : text.toCharArray()) {
            taken = take(taken, unit);
        }
        return take(taken, 0x10000);
    }

    @Test
    void areMadeAsTheDocumentsSay() {
        BigInteger h = take(BigInteger.ZERO, -5);
        h = take(take(h, "scenario"), "world");
        h = take(take(take(take(h, "a"), "1"), "b"), "x\u00e4");
        h = take(h, 12);
        long seed = Seeds.of(-5, "scenario", "world", new TreeMap<>(Map.of("b", "x\u00e4", "a", "1")), 12);
        assertThat(Long.toUnsignedString(seed)).isEqualTo(h.toString());
        BigInteger paired = take(take(take(BigInteger.ZERO, -5), "scenario"), 12);
        assertThat(Long.toUnsignedString(Seeds.paired(-5, "scenario", 12))).isEqualTo(paired.toString());
    }

    @Test
    void differWhereAnythingDiffers() {
        Set<Long> seeds = new HashSet<>();
        int count = 0;
        for (String scenario : new String[] {"a", "ab", ""}) {
            for (String world : new String[] {"b", "bc", "", "a"}) {
                for (long root = 0; root < 20; root++) {
                    for (long replicate = 0; replicate < 50; replicate++) {
                        seeds.add(Seeds.of(root, scenario, world, new TreeMap<>(), replicate));
                        seeds.add(Seeds.of(root, scenario, world, new TreeMap<>(Map.of("p", "1")), replicate));
                        count += 2;
                    }
                }
            }
        }
        assertThat(seeds).hasSize(count);
    }

    @Test
    void aReplicateKeepsItsSeedWhereASweepGrows() {
        ParameterSweep small = Sweeps.wander(0);
        ParameterSweep large = small.vary("step", "0.25", "0.5", "1").replicates(30);
        Map<String, Long> seeds = new TreeMap<>();
        for (long index = 0; index < small.size(); index++) {
            Outcome outcome = small.run(index);
            seeds.put(outcome.world() + outcome.parameters() + outcome.replicate(), outcome.seed());
        }
        int found = 0;
        for (long index = 0; index < large.size(); index++) {
            Outcome outcome = large.run(index);
            Long seed = seeds.get(outcome.world() + outcome.parameters() + outcome.replicate());
            if (seed != null) {
                assertThat(outcome.seed()).isEqualTo(seed);
                found++;
            }
        }
        assertThat(found).isEqualTo(160);
    }

    /** The JDK's own has the same stream of longs. */
    @Test
    void theStreamIsSplitMix64() {
        SeededRandom own = new SeededRandom(77);
        SplittableRandom theirs = new SplittableRandom(77);
        for (int k = 0; k < 1000; k++) {
            assertThat(own.nextLong()).isEqualTo(theirs.nextLong());
        }
        assertThat(new SeededRandom(0).nextLong()).isEqualTo(0xE220A8397B1DCDAFL);
    }

    @Test
    void drawsAreEven() {
        SeededRandom random = new SeededRandom(3);
        int[] counts = new int[7];
        double sum = 0;
        double squares = 0;
        int inner = 0;
        for (int k = 0; k < 70_000; k++) {
            counts[random.nextInt(7)]++;
            double number = random.nextGaussian();
            sum += number;
            squares += number * number;
            inner += Math.abs(number) < 1 ? 1 : 0;
            assertThat(random.nextDouble(-3, 2)).isBetween(-3.0, 2.0);
        }
        for (int count : counts) {
            assertThat(count).isBetween(9_600, 10_400);
        }
        assertThat(sum / 70_000).isBetween(-0.02, 0.02);
        assertThat(squares / 70_000).isBetween(0.97, 1.03);
        assertThat(inner / 70_000.0).isBetween(0.67, 0.695);
        assertThatThrownBy(() -> random.nextInt(0)).hasMessageContaining("bound must be above 0");
        assertThatThrownBy(() -> random.nextDouble(1, 1)).hasMessageContaining("from must be below to");
    }
}
