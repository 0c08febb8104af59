package robosim.geometry.protocol.batch;

import robosim.geometry.check.Checks;

/** Checks the numbers of poses. */
final class Places {
    private static final int POSE = FreePosesRequest.STRIDE;

    private Places() {}

    static void check(String argument, Numbers numbers, int stride) {
        if (numbers.size() % stride != 0) {
            throw new IllegalArgumentException(
                    argument + " must have " + stride + " numbers each (got: " + numbers.size() + " numbers)");
        }
        for (int k = 0; k < numbers.size(); k++) {
            if (!(Math.abs(numbers.get(k)) <= Checks.LIMIT)) {
                refuse(argument + "[" + k + "]", numbers.get(k), k % POSE == POSE - 1);
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
