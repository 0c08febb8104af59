package robosim.geometry.net.session;

import java.util.Collections;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.protocol.BatchAnswerBundle;
import robosim.geometry.protocol.BatchRequestBundle;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.DistanceBundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.SonarRequestBundle;
import robosim.geometry.protocol.StepBundle;
import robosim.geometry.protocol.batch.NoAnswer;

/** The answer in Java serialization, which has no message for errors, to a bundle of which nothing was carried out. */
public final class Refused {
    private Refused() {}

    /** An answer in which each request is refused; null for one that has no answer. */
    public static @Nullable Reply of(Bundle request) {
        if (request instanceof MoveBundle) {
            return new Reply(new MoveBundle(List.of()));
        }
        if (request instanceof SonarRequestBundle sonars) {
            int count = sonars.requests().size();
            return new Reply(new DistanceBundle(Collections.nCopies(count, Double.NaN)));
        }
        if (request instanceof BatchRequestBundle batch) {
            int count = batch.requests().size();
            return new Reply(new BatchAnswerBundle(Collections.nCopies(count, new NoAnswer())));
        }
        if (request instanceof StepBundle) {
            return new Reply(new StepBundle.Answer(List.of(), List.of(), List.of()));
        }
        return request instanceof InitBundle.Answered
                ? new Reply(new BatchAnswerBundle(List.of(new NoAnswer())))
                : null;
    }
}
