package robosim.geometry.protocol.batch;

import java.io.Serial;
import java.util.List;
import robosim.geometry.check.Checks;

/**
 * What the beams of a {@link SenseRequest} measured.
 *
 * @param distances world units, one for each beam, in order; {@code +Infinity} if nothing echoes, and
 *                  {@code -Infinity} for an echo nearer than the blind range where that was asked for
 * @param normals   X, Y and Z of the unit normal of the surface that each ray met, (0, 0, 0) if none; empty unless asked for
 * @param names     the names of the objects that are seen, each once, in the order in which the beams meet them; empty for
 *                  one without a name
 * @param objects   for each beam the index of what it met in {@code names}, -1 if nothing; empty unless asked for
 * @param labels    for each beam the label of the material it met, 0 if nothing; empty unless objects were asked for
 */
public record SenseAnswer(Numbers distances, Numbers normals, List<String> names, Integers objects, Integers labels)
        implements BatchAnswer {
    @Serial
    private static final long serialVersionUID = 1;

    /** The distance of an echo nearer than the blind range, as REP 117 of ROS has it. */
    public static final double NEARER = Double.NEGATIVE_INFINITY;

    /**
     * Refuses null, a distance that is negative or NaN, normals that are no unit vectors, an object without a name, a negative
     * label, and what is not as many as the distances.
     */
    public SenseAnswer {
        names = names == null ? List.of() : Checks.copy("names", names, String.class); // null in messages of before
        objects = objects == null ? Integers.NONE : objects;
        labels = labels == null ? Integers.NONE : labels;
        for (int k = 0; k < Checks.present("distances", distances).size(); k++) {
            if (!(distances.get(k) >= 0 || distances.get(k) == NEARER)) { // written so that NaN fails it
                throw new IllegalArgumentException(
                        "distances[" + k + "] must be at least 0, or -Infinity (got: " + distances.get(k) + ")");
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
        check(distances.size(), names, objects, labels);
    }

    /** Distances and normals alone. */
    public SenseAnswer(Numbers distances, Numbers normals) {
        this(distances, normals, List.of(), Integers.NONE, Integers.NONE);
    }

    private static void check(int size, List<String> names, Integers objects, Integers labels) {
        if (labels.size() != objects.size() || (objects.size() != 0 && objects.size() != size)) {
            throw new IllegalArgumentException("objects and labels must have a number for each of " + size
                    + " distances, or none (got: " + objects.size() + " and " + labels.size() + " numbers)");
        }
        for (int k = 0; k < objects.size(); k++) {
            if (objects.get(k) < -1 || objects.get(k) >= names.size()) {
                throw new IllegalArgumentException("objects[" + k + "] must be from -1 to " + (names.size() - 1)
                        + ", as there are names (got: " + objects.get(k) + ")");
            }
            if (labels.get(k) < 0) {
                throw new IllegalArgumentException("labels[" + k + "] must be at least 0 (got: " + labels.get(k) + ")");
            }
        }
    }

    private boolean hasNearer() {
        for (int k = 0; k < distances.size(); k++) {
            if (distances.get(k) == NEARER) {
                return true;
            }
        }
        return false;
    }

    @Override
    public boolean fits(BatchRequest request) {
        return Checks.present("request", request) instanceof SenseRequest sense
                && distances.size() == sense.size()
                && (sense.rep117() || !hasNearer())
                && normals.size() == (sense.normals() ? 3 * sense.size() : 0)
                && objects.size() == (sense.objects() ? sense.size() : 0);
    }
}
