package robosim.geometry.world.sdf;

import robosim.geometry.exact.Degrees;
import robosim.geometry.exact.Rotations;
import robosim.geometry.model.Point;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.Placement;

/**
 * Converts SDFormat poses to the world's axes. SDFormat has Z up: its (x, y, z) is (x, z, -y) here. Its angles turn
 * about its fixed X, then Y, then Z; about its own axes that is yaw, then pitch, then roll, which are our Y, -Z and X.
 */
public final class SdfPose {
    private SdfPose() {}

    /** Converts a point or a direction of SDFormat to the world's axes. */
    static Point place(double x, double y, double z) {
        return new Point(x, z, -y);
    }

    /** Reads a pose element; its {@code relative_to} is not evaluated here. */
    static Placement read(SdfElement pose) throws FileProblem {
        String format = pose.attribute("rotation_format");
        String degrees = pose.attribute("degrees");
        boolean inDegrees = !degrees.isEmpty() && SdfElement.isTrue(pose, "degrees of <pose>", degrees);
        try {
            return switch (format) {
                case "", "euler_rpy" -> pose.value().isEmpty() ? Placement.NONE : angles(pose.numbers(6), inDegrees);
                case "quat_xyzw" -> {
                    if (inDegrees) {
                        throw pose.wrong("degrees must be false where rotation_format is quat_xyzw (got: true)");
                    }
                    yield pose.value().isEmpty() ? Placement.NONE : quaternion(pose.numbers(7));
                }
                default -> throw pose.wrong("rotation_format must be euler_rpy or quat_xyzw (got: " + format + ")");
            };
        } catch (IllegalArgumentException e) {
            throw pose.wrong("<pose>: " + e.getMessage());
        }
    }

    private static Placement angles(double[] numbers, boolean inDegrees) {
        Point origin = place(numbers[0], numbers[1], numbers[2]);
        double roll = inDegrees ? numbers[3] : Degrees.toDegrees(numbers[3]);
        double pitch = inDegrees ? numbers[4] : Degrees.toDegrees(numbers[4]);
        double yaw = inDegrees ? numbers[5] : Degrees.toDegrees(numbers[5]);
        Placement turned = Placement.upright(origin, yaw, 0);
        if (pitch != 0) {
            double c = Degrees.cos(pitch);
            double s = Degrees.sin(pitch);
            turned = turned.then(Placement.turned(new Point(), new double[] {c, s, 0, -s, c, 0, 0, 0, 1}));
        }
        if (roll != 0) {
            double c = Degrees.cos(roll);
            double s = Degrees.sin(roll);
            turned = turned.then(Placement.turned(new Point(), new double[] {1, 0, 0, 0, c, -s, 0, s, c}));
        }
        return turned;
    }

    private static Placement quaternion(double[] numbers) {
        Point origin = place(numbers[0], numbers[1], numbers[2]);
        double size = 0; // so that no square over- or underflows
        for (int k = 3; k < 7; k++) {
            size = Math.max(size, Math.abs(numbers[k]));
        }
        if (size == 0) {
            throw new IllegalArgumentException("a quaternion must not be zero (got: 0 0 0 0)");
        }
        double x = numbers[3] / size;
        double y = numbers[5] / size;
        double z = -numbers[4] / size;
        double w = numbers[6] / size;
        double norm = x * x + y * y + z * z + w * w;
        double[] rotation = {
            (w * w + x * x - y * y - z * z) / norm, 2 * (x * y - w * z) / norm, 2 * (x * z + w * y) / norm,
            2 * (x * y + w * z) / norm, (w * w - x * x + y * y - z * z) / norm, 2 * (y * z - w * x) / norm,
            2 * (x * z - w * y) / norm, 2 * (y * z + w * x) / norm, (w * w - x * x - y * y + z * z) / norm
        };
        if (x == 0 && z == 0) {
            return Placement.upright(origin, Degrees.headingOf(rotation[0], rotation[6]), 0);
        }
        Rotations.orthonormalise(rotation, 0);
        return Placement.turned(origin, rotation);
    }
}
