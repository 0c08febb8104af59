package robosim.geometry.protocol.batch;

import java.io.Serializable;

/** One request of a batch. */
public sealed interface BatchRequest extends Serializable
        permits SenseRequest, FreePosesRequest, FreeEdgesRequest, WorldRequest {
    /** The name of the object that it is about; empty if that has none, or there is no such object. */
    String objectName();

    /** How many beams, poses or edges it has; 1 for any other. */
    int size();
}
