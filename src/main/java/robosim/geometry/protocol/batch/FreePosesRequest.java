package robosim.geometry.protocol.batch;

import java.io.Serial;
import robosim.geometry.check.Checks;

/**
 * Asks for many upright poses of an object whether it would touch anything there; answered by a {@link FreeAnswer}.
 * Nothing is moved, the object itself is not in the way, and the world's bounds are not asked.
 *
 * @param objectName the name of a moveable object
 * @param poses      four numbers each: X, Y and Z of the centre in world units, and the heading in radians
 */
public record FreePosesRequest(String objectName, Numbers poses) implements BatchRequest {
    @Serial
    private static final long serialVersionUID = 1;

    /** How many numbers belong to one pose. */
    public static final int STRIDE = 4;

    /** Refuses null, a number of numbers that is no multiple of 4, and numbers that are NaN or beyond 2<sup>100</sup>. */
    public FreePosesRequest {
        Checks.present("objectName", objectName);
        check("poses", Checks.present("poses", poses), STRIDE);
    }

    @Override
    public boolean isAboutMover() {
        return true;
    }

    @Override
    public int size() {
        return poses.size() / STRIDE;
    }

    /** Checks the numbers of poses, so many of them for each question. */
    static void check(String argument, Numbers numbers, int stride) {
        if (numbers.size() % stride != 0) {
            throw new IllegalArgumentException(
                    argument + " must have " + stride + " numbers each (got: " + numbers.size() + " numbers)");
        }
        for (int k = 0; k < numbers.size(); k++) {
            if (!(Math.abs(numbers.get(k)) <= Checks.LIMIT)) {
                refuse(argument + "[" + k + "]", numbers.get(k), k % STRIDE == STRIDE - 1);
            }
        }
    }

    private static void refuse(String argument, double number, boolean isHeading) {
        if (isHeading) {
            Checks.radians(argument, number);
        } else {
            Checks.coordinate(argument, number);
        }
    }
}
