package robosim.geometry.protocol.batch;

import java.io.Serializable;

/** One request of a batch. */
public sealed interface BatchRequest extends Serializable
        permits SenseRequest,
                FreePosesRequest,
                FreeEdgesRequest,
                MeasureRequest,
                PictureRequest,
                WorldRequest,
                CopyRequest {
    /**
     * The name of the object that it is about; empty if that has none, if there is no such object, and for a sensor or a
     * camera that nothing carries.
     */
    String objectName();

    /** Whether the object that it names must be moveable, and there. */
    boolean isAboutMover();

    /** How many beams, poses, edges or pixels it has; 1 for any other. */
    int size();
}
