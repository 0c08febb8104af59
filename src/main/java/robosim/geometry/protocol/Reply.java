package robosim.geometry.protocol;

import java.util.List;
import robosim.geometry.exact.Checks;

/**
 * A session's answer: the bundle, and the reasons of refusals. Java serialization sends the bundle alone, JSON lines
 * both.
 *
 * @param bundle   a {@link MoveBundle} of the moves that were made, a {@link DistanceBundle} or a {@link BatchAnswerBundle}
 * @param problems why requests were refused, in order: those of moves left out, of distances that are NaN, or of
 *                 requests of a batch without an answer
 */
public record Reply(Bundle bundle, List<Problem> problems) {
    /** Refuses null, and a bundle that is not an answer. */
    public Reply {
        if (!(bundle instanceof MoveBundle
                || bundle instanceof DistanceBundle
                || bundle instanceof BatchAnswerBundle)) {
            throw new IllegalArgumentException(
                    "bundle must be a MoveBundle, a DistanceBundle or a BatchAnswerBundle (got: "
                            + (bundle == null ? "null" : bundle.getClass().getSimpleName()) + ")");
        }
        problems = Checks.copy("problems", problems, Problem.class);
    }

    /** A reply without problems. */
    public Reply(Bundle bundle) {
        this(bundle, List.of());
    }
}
