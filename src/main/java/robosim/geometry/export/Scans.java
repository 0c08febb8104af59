package robosim.geometry.export;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import robosim.geometry.model.Pose;
import robosim.geometry.viewer.scene.Scene;

/** What the moveable objects measured. Directions are told once for each arrangement of sensors, distances each time. */
final class Scans {
    /** A sensor on its object: its direction from forward and its opening angle, in steps of a turn, and its range. */
    private record Sensor(int bearing, int width, double range) {}

    private final Quanta quanta;
    private final PageStreams out;
    private final Map<List<Sensor>, Integer> arrangements = new LinkedHashMap<>();

    Scans(Quanta quanta, PageStreams out) {
        this.quanta = quanta;
        this.out = out;
    }

    /**
     * One measurement.
     *
     * @param heading of the object that measured, degrees
     */
    record Scan(int frame, double heading, List<Scene.Ping> pings) {
        Scan(int frame, Pose pose, List<Scene.Ping> pings) {
            this(frame, pose.heading(), pings);
        }
    }

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
            int width = (int) Quanta.round(ping.width() * (Quanta.TURN / 360.0));
            sensors.add(new Sensor(Quanta.turn(ping.heading() - scan.heading), width, ping.range()));
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
            }
        }
    }
}
