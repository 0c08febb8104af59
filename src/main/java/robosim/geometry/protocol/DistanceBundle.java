package robosim.geometry.protocol;

import java.io.Serial;
import java.util.List;
import robosim.geometry.check.Checks;

/**
 * The answer to a {@link SonarRequestBundle}.
 *
 * @param distances world units, one for each request, in order; {@code +Infinity} if nothing echoes, NaN if the request
 *                  names no moveable object
 */
public record DistanceBundle(List<Double> distances) implements Bundle {
    @Serial
    private static final long serialVersionUID = 1;

    /** Refuses a list or a distance that is null, and a distance that is negative. */
    public DistanceBundle {
        distances = Checks.copy("distances", distances, Double.class);
        for (int k = 0; k < distances.size(); k++) {
            if (distances.get(k) < 0) {
                throw new IllegalArgumentException(
                        "distances[" + k + "] must be at least 0, or NaN (got: " + distances.get(k) + ")");
            }
        }
    }

    @Override
    public boolean isAnswer() {
        return true;
    }
}
