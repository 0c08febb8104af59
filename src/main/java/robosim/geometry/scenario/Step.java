package robosim.geometry.scenario;

import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.protocol.BatchAnswerBundle;
import robosim.geometry.protocol.BatchRequestBundle;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.DistanceBundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.SonarRequestBundle;
import robosim.geometry.protocol.StepBundle;
import robosim.geometry.protocol.batch.BatchAnswer;
import robosim.geometry.protocol.batch.BatchRequest;

/**
 * One request of a conversation, and its answer.
 *
 * @param line     the line of the request in its file, from 1; 0 if there is none
 * @param notes    notes for people before it
 * @param request  an {@link InitBundle}, a {@link MoveBundle}, a {@link SonarRequestBundle}, a
 *                 {@link BatchRequestBundle} or a {@link StepBundle}
 * @param expected the recorded or expected answer; null for an InitBundle, and if unknown
 * @param timing   the timing; null if it was not recorded
 */
public record Step(
        long line,
        List<String> notes,
        Bundle request,
        @Nullable Reply expected,
        @Nullable Timing timing) {

    /** Refuses an answer that does not fit the request. */
    public Step {
        notes = Checks.list("notes", notes);
        if (request == null || request.isAnswer()) {
            throw new IllegalArgumentException("request must be an InitBundle, a MoveBundle, a SonarRequestBundle, a"
                    + " BatchRequestBundle or a StepBundle (got: "
                    + (request == null ? "null" : "a " + request.getClass().getSimpleName()) + ")");
        }
        if (expected != null) {
            checkAnswer(request, expected.bundle());
        }
    }

    /** A step without line, notes and timing. */
    public Step(Bundle request, @Nullable Reply expected) {
        this(0, List.of(), request, expected, null);
    }

    /** Refuses an answer that does not fit a request. */
    static void checkAnswer(Bundle request, Bundle answer) {
        if (request instanceof InitBundle) {
            throw new IllegalArgumentException("an init must have no answer (got: one)");
        }
        if (request instanceof MoveBundle moves) {
            if (!(answer instanceof MoveBundle made)) {
                throw new IllegalArgumentException("moves must be answered by moves (got: " + words(answer) + ")");
            }
            if (made.moves().size() > moves.moves().size()) {
                throw new IllegalArgumentException("there must be at most as many moves made as asked for, "
                        + moves.moves().size() + " (got: " + made.moves().size() + ")");
            }
        }
        if (request instanceof SonarRequestBundle sonars) {
            if (!(answer instanceof DistanceBundle distances)) {
                throw new IllegalArgumentException("sonars must be answered by distances (got: " + words(answer) + ")");
            }
            if (distances.distances().size() != sonars.requests().size()) {
                throw new IllegalArgumentException("there must be one distance for each request, "
                        + sonars.requests().size() + " (got: "
                        + distances.distances().size() + ")");
            }
        }
        if (request instanceof BatchRequestBundle batch) {
            if (!(answer instanceof BatchAnswerBundle answers)) {
                throw new IllegalArgumentException("a batch must be answered by answers (got: " + words(answer) + ")");
            }
            checkAnswers(batch.requests(), answers.answers());
        }
        if (request instanceof StepBundle && !(answer instanceof StepBundle.Answer)) {
            throw new IllegalArgumentException("a step must be answered by bodies (got: " + words(answer) + ")");
        }
    }

    private static String words(Bundle answer) {
        if (answer instanceof StepBundle.Answer) {
            return "bodies";
        }
        return answer instanceof MoveBundle ? "moves" : answer instanceof DistanceBundle ? "distances" : "answers";
    }

    private static void checkAnswers(List<BatchRequest> requests, List<BatchAnswer> answers) {
        if (answers.size() != requests.size()) {
            throw new IllegalArgumentException("there must be one answer for each request of a batch, "
                    + requests.size() + " (got: " + answers.size() + ")");
        }
        for (int k = 0; k < answers.size(); k++) {
            if (!answers.get(k).fits(requests.get(k))) {
                throw new IllegalArgumentException("answers[" + k + "] must be of the kind and size of its request, "
                        + requests.get(k).size() + " items (got: another)");
            }
        }
    }
}
