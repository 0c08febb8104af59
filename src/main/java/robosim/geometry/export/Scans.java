package robosim.geometry.export;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.viewer.scene.Scene;

/** What the moveable objects measured. Directions are told once for each arrangement of sensors, distances each time. */
final class Scans {
    /** A place on an object is told to about a millionth of a world unit, so that rounding makes no other sensor of one. */
    private static final double STEPS = 1 << 20;

    /**
     * A sensor on its object: its direction from forward and its opening angle, in steps of a turn, its range, and its
     * place in the object's own frame.
     */
    private record Sensor(int bearing, int width, double range, Point place) {}

    /** Where a measurement started, in the frame of the object that made it. */
    static Point place(Point start, Pose pose) {
        Point c = pose.center();
        double x = start.x() - c.x();
        double y = start.y() - c.y();
        double z = start.z() - c.z();
        return new Point(along(pose, 0, x, y, z), along(pose, 1, x, y, z), along(pose, 2, x, y, z));
    }

    private static double along(Pose pose, int axis, double x, double y, double z) {
        double along = pose.rotation(axis) * x + pose.rotation(3 + axis) * y + pose.rotation(6 + axis) * z;
        return Math.rint(along * STEPS) / STEPS + 0.0;
    }

    private final PageQuantization quanta;
    private final PageStreams out;
    private final Map<List<Sensor>, Integer> arrangements = new LinkedHashMap<>();

    Scans(PageQuantization quanta, PageStreams out) {
        this.quanta = quanta;
        this.out = out;
    }

    /**
     * One measurement.
     *
     * @param pose of the object that measured
     */
    record Scan(int frame, Pose pose, List<Scene.Ping> pings) {}

    /** Writes what one object measured in a chapter that begins at a frame. */
    void write(int begin, List<Scan> scans) {
        out.scans.count(scans.size());
        Map<Integer, long[]> last = new HashMap<>();
        int before = begin;
        for (Scan scan : scans) {
            out.scans.count(scan.frame - before);
            before = scan.frame;
            int arrangement = arrangement(scan);
            out.scans.count(arrangement);
            long[] known = last.computeIfAbsent(arrangement, unseen -> new long[scan.pings.size()]);
            for (int k = 0; k < known.length; k++) {
                double distance = scan.pings.get(k).distance();
                if (Double.isInfinite(distance)) {
                    out.distances.count(0);
                    continue;
                }
                // One more than the difference with its sign as the lowest bit, as 0 stands for no echo.
                long steps = quanta.range(distance);
                long by = steps - known[k];
                out.distances.count(by < 0 ? -2 * by : 2 * by + 1);
                known[k] = steps;
            }
        }
    }

    private int arrangement(Scan scan) {
        List<Sensor> sensors = new ArrayList<>();
        for (Scene.Ping ping : scan.pings) {
            int width = (int) PageQuantization.round(ping.width() * (PageQuantization.TURN / 360.0));
            sensors.add(new Sensor(
                    PageQuantization.turn(ping.heading() - scan.pose.heading()),
                    width,
                    ping.range(),
                    place(ping.start(), scan.pose)));
        }
        Integer number = arrangements.get(sensors);
        if (number == null) {
            number = arrangements.size();
            arrangements.put(List.copyOf(sensors), number);
        }
        return number;
    }

    /** Writes the arrangements. */
    void finish() {
        out.sensors.count(arrangements.size());
        for (List<Sensor> sensors : arrangements.keySet()) {
            out.sensors.count(sensors.size());
            for (Sensor sensor : sensors) {
                out.sensors.count(sensor.bearing);
                out.sensors.count(sensor.width);
                out.sensors.octet(Double.isInfinite(sensor.range) ? 0 : 1);
                if (Double.isFinite(sensor.range)) {
                    out.sensors.real(quanta.length(sensor.range));
                }
                out.sensors.real(quanta.length(sensor.place.x()));
                out.sensors.real(quanta.length(sensor.place.y()));
                out.sensors.real(quanta.length(sensor.place.z()));
            }
        }
    }
}
