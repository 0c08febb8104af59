package robosim.geometry.protocol.batch;

import java.io.Serializable;

/** One request with packed numbers. */
public sealed interface BatchRequest extends Serializable
        permits SenseRequest, FreePosesRequest, FreeEdgesRequest, PictureRequest {
    /** The name of the moveable object that it is about; empty for a picture by a camera that nothing carries. */
    String objectName();

    /** How many beams, poses, edges or pixels it has. */
    int size();
}
