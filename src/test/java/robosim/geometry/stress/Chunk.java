package robosim.geometry.stress;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.proof.Witnesses;
import robosim.geometry.reference.Truth;

/** A stretch of cases of one family that starts from a seed of its own, whoever runs it and when. */
final class Chunk {
    static final int CASES = 4096;
    private static final int BLOCK = 256;

    private final Family family;
    private final boolean adversarial;
    private final Case[] block = new Case[BLOCK];
    private final int[] answers = new int[BLOCK];
    private final Scratch scratch = new Scratch();
    private final Decision decision = new Decision();
    private final List<String> failures = new ArrayList<>();
    private final Witnesses witnesses;
    private long yes;
    private long wrong;
    private long nanos;
    private long digest = 0x1234_5678_9abc_def0L;

    private Chunk(Family family, boolean adversarial, long seed) {
        witnesses = new Witnesses(seed);
        this.family = family;
        this.adversarial = adversarial;
        Arrays.setAll(block, k -> new Case());
    }

    static Tally run(Family family, boolean adversarial, long seed, long index, int cases) {
        long own = seed(family, adversarial, seed, index);
        return new Chunk(family, adversarial, own).run(own, cases);
    }

    private static long seed(Family family, boolean adversarial, long seed, long index) {
        long mixed = seed * 31 + family.name().hashCode();
        mixed = mixed * 31 + (adversarial ? 1 : 0);
        return new SplittableRandom(mixed + index * 0x9e37_79b9_7f4a_7c15L).nextLong();
    }

    private Tally run(long seed, int cases) {
        Family.Source source = family.source(new SplittableRandom(seed));
        for (int done = 0; done < cases; done += BLOCK) {
            int count = Math.min(BLOCK, cases - done);
            for (int k = 0; k < count; k++) {
                if (adversarial) {
                    source.adversarial(block[k]);
                } else {
                    source.random(block[k]);
                }
            }
            long begin = System.nanoTime();
            for (int k = 0; k < count; k++) {
                answers[k] = family.product(block[k], scratch);
            }
            nanos += System.nanoTime() - begin;
            for (int k = 0; k < count; k++) {
                judge(block[k], answers[k]);
            }
        }
        return new Tally(
                family.name(),
                adversarial,
                cases,
                yes,
                decision.doubts(),
                decision.checks(),
                nanos,
                digest,
                wrong,
                witnesses.counts(),
                List.copyOf(failures));
    }

    private void judge(Case question, int answer) {
        int truth = decision.of(family, question);
        yes += truth > 0 ? 1 : 0;
        long bits = Double.doubleToLongBits(question.a[0])
                ^ Long.rotateLeft(Double.doubleToLongBits(question.b[1]), 21)
                ^ Long.rotateLeft(Double.doubleToLongBits(question.ray[3]), 42);
        digest = (digest ^ bits ^ answer) * 0x100_0000_01b3L;
        if (answer == truth) {
            String wrongProof = family.proof(question, answer, witnesses, scratch);
            if (wrongProof != null && failures.size() < Tally.FAILURES) {
                failures.add("%s answers %d, but %s\n%s\n%s"
                        .formatted(family.name(), answer, wrongProof, family.call(), question.paste()));
            }
            return;
        }
        wrong++;
        if (failures.size() < Tally.FAILURES) {
            int exact = family.truth(question, Truth.EXACT);
            failures.add("%s answers %d, true is %d (exactly %d)\n%s\n%s"
                    .formatted(family.name(), answer, truth, exact, family.call(), question.paste()));
        }
    }
}
