package robosim.geometry.dynamics.spatial;

import robosim.geometry.exact.Attitude;
import robosim.geometry.exact.Radians;
import robosim.geometry.exact.Rotations;
import robosim.geometry.model.Pose;

/** Turns places by rotation vectors. */
final class RotationVectors {
    private final double[] turn = new double[9];
    private final double[] rotation = new double[9];

    /** Turns a place by a share of a vector in radians. */
    void turn(double[] from, double[] angle, double share, double[] to) {
        double size = RigidBody.length(angle, 0);
        double half = 0.5 * size * share;
        double sine = size == 0 ? 0 : Radians.sin(half) / size;
        double w = Radians.cos(half);
        double x = sine * angle[0];
        double y = sine * angle[1];
        double z = sine * angle[2];
        turn[0] = 1 - 2 * (y * y + z * z);
        turn[1] = 2 * (x * y - w * z);
        turn[2] = 2 * (x * z + w * y);
        turn[3] = 2 * (x * y + w * z);
        turn[4] = 1 - 2 * (x * x + z * z);
        turn[5] = 2 * (y * z - w * x);
        turn[6] = 2 * (x * z - w * y);
        turn[7] = 2 * (y * z + w * x);
        turn[8] = 1 - 2 * (x * x + y * y);
        Rotations.multiply(turn, 0, from, 3, rotation, 0);
        Rotations.orthonormalise(rotation, 0);
        if (from != to) {
            System.arraycopy(from, 0, to, 0, Pose.PLACE);
        }
        Attitude.orient(to, 3, rotation);
    }
}
