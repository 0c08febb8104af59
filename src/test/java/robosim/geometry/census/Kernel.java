package robosim.geometry.census;

import java.util.List;
import java.util.SplittableRandom;
import org.jspecify.annotations.Nullable;
import robosim.geometry.proof.Witnesses;

/**
 * One kernel of the product, that is, a question about two shapes in one dimension: the regimes that its cases fall into, a
 * way to make up cases, and a slow twin of another method that knows the answer.
 *
 * <p>A regime is told by the twin, never by the product: which features are nearest, whether they are inside, outside or
 * tangent, at which end a search stops. Whatever the generator makes up falls into one of them.
 */
public interface Kernel {
    /** As in the published table: the question, the shapes, the dimension. */
    String name();

    /** Every regime that a case can fall into. Each must be met. */
    List<String> regimes();

    /** How many times as many cases as the other kernels it takes until every regime is met often enough. */
    default double effort() {
        return 1;
    }

    /**
     * Makes up one case, asks the product and the twin, and tells how they compare.
     *
     * @param random      all that the case depends on
     * @param adversarial whether the case is built to be near a border between regimes, or plain
     */
    Visit ask(SplittableRandom random, boolean adversarial);

    /** Has a share of the answers proved, where there is such a claim: the one to the last case. Tells what is wrong with a proof. */
    default @Nullable String proof(Witnesses witnesses) {
        return null;
    }
}
