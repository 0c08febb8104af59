package robosim.geometry.world.stage;

import java.util.List;
import robosim.geometry.world.shared.FileProblem;

/** The range sensors of a ranger: those of Stage 4, and the sonars and the laser of Stage 3. */
final class StageSensors {
    private StageSensors() {}

    /** Adds a ring for each sensor: count, first, step, min, max and width. */
    static void add(StageEntity ranger, double heading, List<double[]> rings) throws FileProblem {
        for (StageEntity sensor : ranger.children) {
            if (sensor.type.equals("sensor")) {
                double[] range = sensor.numbers("range", 0, 5);
                double[] pose = sensor.numbers("pose", 0, 0, 0, 0);
                double samples = sensor.number("samples", 1);
                rings.add(ring(sensor, heading + pose[3], range[0], range[1], sensor.number("fov", 0.1), samples));
            }
        }
        int count = (int) Math.min(10_000, ranger.number("scount", 0));
        for (int k = 0; k < count; k++) {
            double[] pose = ranger.numbers("spose[" + k + "]", 0, 0, 0);
            double[] view = ranger.numbers("sview", 0, 5, 5);
            rings.add(ring(ranger, heading + pose[2], view[0], view[1], view[2], 1));
        }
        if (ranger.type.equals("laser")) {
            double fov = ranger.number("fov", 180);
            rings.add(ring(ranger, heading, 0, ranger.number("range_max", 8), fov, ranger.number("samples", 180)));
        }
    }

    private static double[] ring(StageEntity sensor, double heading, double min, double max, double fov, double samples)
            throws FileProblem {
        if (!(samples >= 1 && samples <= 10_000) || samples != Math.rint(samples)) {
            throw sensor.wrong("samples must be a whole number from 1 to 10000 (got: " + samples + ")");
        }
        if (!(min >= 0 && max >= min && fov >= 0 && fov <= 360)) {
            throw sensor.wrong("a sensor's range must begin at 0 or above and not end before, and its fov be 0 to 360"
                    + " (got: " + min + " to " + max + ", " + fov + ")");
        }
        if (samples == 1) {
            if (fov >= 180) {
                throw sensor.wrong("fov of a single sample must be below 180 (got: " + fov + ")");
            }
            return new double[] {1, heading, 0, min, max, fov};
        }
        return new double[] {samples, heading - fov / 2, fov / (samples - 1), min, max, 0};
    }

    /** How far from its robot's centre a sensor is, if their ranger is so far. */
    static double farthest(StageEntity ranger, double far) throws FileProblem {
        double farthest = far;
        for (StageEntity sensor : ranger.children) {
            double[] pose = sensor.numbers("pose", 0, 0);
            farthest = Math.max(farthest, far + StrictMath.hypot(pose[0], pose[1]));
        }
        for (int k = 0; k < Math.min(10_000, ranger.number("scount", 0)); k++) {
            double[] pose = ranger.numbers("spose[" + k + "]", 0, 0);
            farthest = Math.max(farthest, far + StrictMath.hypot(pose[0], pose[1]));
        }
        return farthest;
    }
}
