package robosim.geometry.protocol.batch;

import java.io.Serial;
import robosim.geometry.exact.Checks;

/**
 * What the beams of a {@link SenseRequest} measured.
 *
 * @param distances world units, one for each beam, in order; {@code +Infinity} if nothing echoes
 * @param normals   X, Y and Z of the unit normal of the surface that each ray met, (0, 0, 0) if none; empty unless asked for
 */
public record SenseAnswer(Numbers distances, Numbers normals) implements BatchAnswer {
    @Serial
    private static final long serialVersionUID = 1;

    /** Refuses null, a distance that is negative or NaN, and normals that are no unit vectors or as many as the distances. */
    public SenseAnswer {
        for (int k = 0; k < Checks.present("distances", distances).size(); k++) {
            if (!(distances.get(k) >= 0)) { // written so that NaN fails it
                throw new IllegalArgumentException(
                        "distances[" + k + "] must be at least 0 (got: " + distances.get(k) + ")");
            }
        }
        int size = Checks.present("normals", normals).size();
        if (size != 0 && size != 3L * distances.size()) {
            throw new IllegalArgumentException("normals must have three numbers for each of " + distances.size()
                    + " distances, or none (got: " + size + " numbers)");
        }
        for (int k = 0; k < size; k++) {
            if (!(Math.abs(normals.get(k)) <= 1 + 0x1p-40)) { // a unit vector's, with its rounding
                throw new IllegalArgumentException(
                        "normals[" + k + "] must be from -1 to 1 (got: " + normals.get(k) + ")");
            }
        }
    }

    @Override
    public boolean fits(BatchRequest request) {
        return Checks.present("request", request) instanceof SenseRequest sense
                && distances.size() == sense.size()
                && normals.size() == (sense.normals() ? 3 * sense.size() : 0);
    }
}
