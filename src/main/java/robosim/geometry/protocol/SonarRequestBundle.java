package robosim.geometry.protocol;

import java.io.Serial;
import java.util.List;
import robosim.geometry.check.Checks;

/**
 * Distances to measure; answered by a {@link DistanceBundle} with one distance for each request, in order.
 *
 * @param requests what to measure
 */
public record SonarRequestBundle(List<SonarRequest> requests) implements Bundle {
    @Serial
    private static final long serialVersionUID = 1;

    /** Refuses a list or a request that is null. */
    public SonarRequestBundle {
        requests = Checks.copy("requests", requests, SonarRequest.class);
    }
}
