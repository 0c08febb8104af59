package robosim.geometry.protocol.batch;

import java.io.Serial;
import robosim.geometry.check.Checks;

/**
 * Asks for many edges, each a straight move from one upright pose to another, whether an object would touch nothing on the
 * whole way, which is swept, not sampled; answered by a {@link FreeAnswer}.
 * Nothing is moved, the object itself is not in the way, and the world's bounds are not asked.
 *
 * @param objectName the name of a moveable object
 * @param edges      eight numbers each: X, Y, Z and heading at the first pose, then at the second, as in a {@link FreePosesRequest}
 */
public record FreeEdgesRequest(String objectName, Numbers edges) implements BatchRequest {
    @Serial
    private static final long serialVersionUID = 1;

    /** How many numbers belong to one edge. */
    public static final int STRIDE = 8;

    /** Refuses null, a number of numbers that is no multiple of 8, and numbers that are NaN or beyond 2<sup>100</sup>. */
    public FreeEdgesRequest {
        Checks.present("objectName", objectName);
        FreePosesRequest.check("edges", Checks.present("edges", edges), STRIDE);
    }

    @Override
    public boolean isAboutMover() {
        return true;
    }

    @Override
    public int size() {
        return edges.size() / STRIDE;
    }
}
