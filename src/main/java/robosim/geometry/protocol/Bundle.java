package robosim.geometry.protocol;

import java.io.Serializable;

/** One message. */
public sealed interface Bundle extends Serializable
        permits InitBundle,
                InitBundle.Answered,
                MoveBundle,
                SonarRequestBundle,
                DistanceBundle,
                BatchRequestBundle,
                BatchAnswerBundle,
                StepBundle,
                StepBundle.Answer {
    /** Whether this is an answer and no request; moves may be either. */
    default boolean isAnswer() {
        return false;
    }
}
