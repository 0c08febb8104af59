package robosim.geometry.viewer.playback;

import java.util.ArrayList;
import java.util.List;
import robosim.geometry.exact.Degrees;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Pose;
import robosim.geometry.model.RayPattern;
import robosim.geometry.net.session.RayPatterns;
import robosim.geometry.protocol.batch.Numbers;
import robosim.geometry.protocol.batch.SenseRequest;
import robosim.geometry.viewer.scene.Scene;

/** What a sensor that a batch asks shows: its level beams, of many as many as can be told apart. */
final class Lasers {
    /** The most beams of one sensor: 3 degrees from each to the next all round. */
    private static final int MOST = 120;

    /** The largest rise of a beam that counts as level, for each unit of its way: some 3 degrees. */
    private static final double LEVEL = 0.05;

    private Lasers() {}

    /**
     * The beams of one request.
     *
     * @param carrier   at its place when the sensor measured
     * @param distances by beam
     */
    static List<Scene.Ping> of(GeometryObject carrier, SenseRequest request, Numbers distances) {
        Pose sensor = request.mount().pose().within(carrier.pose());
        RayPattern pattern = RayPatterns.make(request.pattern());
        List<Scene.Ping> level = new ArrayList<>();
        int size = Math.min(pattern.size(), distances.size());
        double[] direction = new double[3];
        for (int k = 0; k < size; k++) {
            pattern.directions(k, 1, direction, 0);
            double x = along(sensor, 0, direction);
            double y = along(sensor, 3, direction);
            double z = along(sensor, 6, direction);
            double across = StrictMath.hypot(x, z);
            if (across > 0 && Math.abs(y) <= LEVEL * across && !Double.isNaN(distances.get(k))) {
                level.add(new Scene.Ping(
                        sensor.center(),
                        StrictMath.toDegrees(StrictMath.atan2(0 - z, x)),
                        Degrees.toDegrees(request.width()),
                        request.max(),
                        distances.get(k)));
            }
        }
        int stride = (level.size() + MOST - 1) / MOST;
        List<Scene.Ping> some = new ArrayList<>();
        for (int k = 0; k < level.size(); k += Math.max(1, stride)) {
            some.add(level.get(k));
        }
        return some;
    }

    private static double along(Pose pose, int row, double[] v) {
        return pose.rotation(row) * v[0] + pose.rotation(row + 1) * v[1] + pose.rotation(row + 2) * v[2];
    }
}
