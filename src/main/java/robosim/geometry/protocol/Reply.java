package robosim.geometry.protocol;

import java.util.List;
import robosim.geometry.check.Checks;

/**
 * A session's answer: the bundle, and the reasons of refusals. Java serialization sends the bundle alone, JSON lines
 * both.
 *
 * @param bundle   a {@link MoveBundle} of the moves that were made, a {@link DistanceBundle}, a {@link BatchAnswerBundle} or
 *                 a {@link StepBundle.Answer}
 * @param problems why requests were refused, in order: those of moves left out, of distances that are NaN, of
 *                 requests of a batch without an answer, or of bodies and commands of a step, the bodies counted first
 */
public record Reply(Bundle bundle, List<Problem> problems) {
    /** Refuses null, and a bundle that is not an answer. */
    public Reply {
        if (!(bundle instanceof MoveBundle
                || bundle instanceof DistanceBundle
                || bundle instanceof BatchAnswerBundle
                || bundle instanceof StepBundle.Answer)) {
            throw new IllegalArgumentException(
                    "bundle must be a MoveBundle, a DistanceBundle, a BatchAnswerBundle or a StepBundle.Answer (got: "
                            + (bundle == null ? "null" : bundle.getClass().getSimpleName()) + ")");
        }
        problems = Checks.copy("problems", problems, Problem.class);
    }

    /** A reply without problems. */
    public Reply(Bundle bundle) {
        this(bundle, List.of());
    }
}
