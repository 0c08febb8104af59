package robosim.geometry.stress;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.LongStream;
import robosim.geometry.proof.Witnesses;

/**
 * What came of the cases of one sort of one family.
 *
 * @param yes     how many are true
 * @param doubts  how many the oracle had to take to exact numbers
 * @param checks  how many the oracle asked both ways
 * @param nanos   the product's time for all of them
 * @param digest  of all questions and answers; depends on the seed and the number of cases alone
 * @param wrong   how many answers of the product were not true
 * @param proofs  what came of the proofs of a share of the answers
 * @param failures the first few of them, to paste
 */
record Tally(
        String family,
        boolean adversarial,
        long cases,
        long yes,
        long doubts,
        long checks,
        long nanos,
        long digest,
        long wrong,
        Witnesses.Counts proofs,
        List<String> failures) {
    static final int FAILURES = 5;

    /** Asks so many cases of one sort of one family; the result depends on the seed and the number alone. */
    static Tally of(Family family, boolean adversarial, long seed, long cases, boolean isParallel) {
        LongStream chunks = LongStream.range(0, (cases + Chunk.CASES - 1) / Chunk.CASES);
        return (isParallel ? chunks.parallel() : chunks)
                .mapToObj(c -> {
                    int count = (int) Math.min(Chunk.CASES, cases - c * Chunk.CASES);
                    return Chunk.run(family, adversarial, seed, c, count);
                })
                .reduce(Tally::plus)
                .orElseThrow();
    }

    double share() {
        return (double) yes / cases;
    }

    double nanosEach() {
        return (double) nanos / cases;
    }

    /** With 95 % confidence the rate of wrong answers is below this (the rule of three) where none was seen. */
    double bound() {
        return 3.0 / cases;
    }

    Tally plus(Tally that) {
        List<String> both = new ArrayList<>(failures);
        both.addAll(that.failures);
        return new Tally(
                family,
                adversarial,
                cases + that.cases,
                yes + that.yes,
                doubts + that.doubts,
                checks + that.checks,
                nanos + that.nanos,
                digest + that.digest,
                wrong + that.wrong,
                proofs.plus(that.proofs),
                List.copyOf(both.subList(0, Math.min(FAILURES, both.size()))));
    }
}
