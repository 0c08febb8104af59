package robosim.geometry.protocol.batch;

import java.io.Serializable;

/** One request with packed numbers. */
public sealed interface BatchRequest extends Serializable permits SenseRequest, FreePosesRequest, FreeEdgesRequest {
    /** The name of the moveable object that it is about. */
    String objectName();

    /** How many beams, poses or edges it has. */
    int size();
}
