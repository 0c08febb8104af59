package robosim.geometry.protocol;

import java.io.Serial;
import java.util.List;
import robosim.geometry.check.Checks;
import robosim.geometry.protocol.batch.BatchAnswer;
import robosim.geometry.protocol.batch.NoAnswer;

/**
 * The answer to a {@link BatchRequestBundle}.
 *
 * @param answers one for each request, in order; a {@link NoAnswer} if the request names no such object
 */
public record BatchAnswerBundle(List<BatchAnswer> answers) implements Bundle {
    @Serial
    private static final long serialVersionUID = 1;

    /** Refuses a list or an answer that is null. */
    public BatchAnswerBundle {
        answers = Checks.copy("answers", answers, BatchAnswer.class);
    }

    @Override
    public boolean isAnswer() {
        return true;
    }
}
