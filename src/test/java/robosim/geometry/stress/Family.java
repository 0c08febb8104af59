package robosim.geometry.stress;

import java.util.SplittableRandom;
import org.jspecify.annotations.Nullable;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.proof.Witnesses;
import robosim.geometry.reference.Quantity.Arithmetic;

/** Questions of one sort: how to make them up, the product's answer, and the truth. */
abstract class Family {
    private final String name;

    Family(String name) {
        this.name = name;
    }

    final String name() {
        return name;
    }

    /** Makes up cases from one stretch of random numbers; what it makes depends on nothing else. */
    abstract Source source(SplittableRandom random);

    /** A yes is 1 and a no is 0; an orientation is its sign. */
    abstract int product(Case question, Scratch scratch);

    abstract int truth(Case question, Arithmetic numbers);

    /** Has a share of the answers proved, where there is such a claim; tells what is wrong with a proof. */
    @Nullable
    String proof(Case question, int answer, Witnesses witnesses, Scratch scratch) {
        return null;
    }

    /** The least and greatest share of yes among the random and among the adversarial cases. */
    double[] mix(boolean adversarial) {
        return adversarial ? new double[] {0.2, 0.85} : new double[] {0.3, 0.7};
    }

    /**
     * The most exact stages that a random case may need on average: none of those in general position, where there is a
     * filter for it, and some of the few that are thinner or smaller than rounding at their place.
     */
    double exactAtRandom() {
        return 0.04;
    }

    /** What a failure says beside the numbers. */
    String call() {
        return name;
    }

    interface Source {
        void random(Case question);

        void adversarial(Case question);
    }
}
