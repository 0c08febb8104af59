package robosim.geometry.protocol.batch;

import java.io.Serializable;

/** The answer to one {@link BatchRequest}. */
public sealed interface BatchAnswer extends Serializable
        permits SenseAnswer, FreeAnswer, MeasureRequest.Answer, PictureAnswer, WorldAnswer, TickAnswer, NoAnswer {
    /** Whether this is an answer to such a request, with as many items; {@link NoAnswer} is one to any. */
    boolean fits(BatchRequest request);
}
