package robosim.geometry.export;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import robosim.geometry.check.Checks;
import robosim.geometry.exact.Degrees;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.Quaternion;
import robosim.geometry.viewer.playback.Frame;
import robosim.geometry.viewer.playback.StateHistory;
import robosim.geometry.viewer.scene.Scene;
import robosim.geometry.world.shared.JsonText;

/**
 * What happens in a world after its page was written, frame by frame; {@code live.js} reads what is written here. Places and
 * lengths are in world units, angles in radians. Objects have the numbers that the page gives them.
 */
public final class PageEvents {
    private static final double DIGITS = 1e6;

    private final PagePlaces places;
    private final Map<Integer, Pose> now = new TreeMap<>();

    /** Of the world of a frame, at that frame. */
    public PageEvents(StateHistory film, int number) {
        Frame.Setting setting = Checks.present("film", film).setting(number);
        if (setting == null) {
            throw new IllegalArgumentException("number must be of a frame with a world (got: " + number + ")");
        }
        List<Scene.Thing> movers = film.movers(number);
        places = new PagePlaces(movers, setting.statics());
        for (Scene.Thing mover : movers) {
            now.put(
                    places.mover(String.valueOf(mover.object().name())),
                    mover.object().pose());
        }
    }

    /** All that a frame changed, as one line of JSON; it replaces what was written about this frame before. */
    public String line(int number, Frame frame) {
        List<Object> placed = new ArrayList<>();
        frame.placed().forEach((name, pose) -> {
            int mover = places.mover(name);
            if (mover >= 0) {
                now.put(mover, pose);
                placed.add(place(mover, pose));
            }
        });
        List<Object> heard = new ArrayList<>();
        frame.heard().forEach((name, pings) -> {
            Pose pose = now.get(places.mover(name));
            if (pose != null) {
                heard.add(scan(places.mover(name), pose, pings));
            }
        });
        List<Object> bumps = new ArrayList<>();
        for (Frame.Bump bump : frame.bumps()) {
            int mover = places.mover(String.valueOf(bump.mover().name()));
            if (mover >= 0) {
                bumps.add(List.of(mover, radians(bump.heading()), places.obstacle(bump)));
            }
        }
        List<String> words = new ArrayList<>(frame.notes());
        if (placed.isEmpty() && heard.isEmpty() && bumps.isEmpty()) {
            words.add(frame.words());
        }
        return JsonText.of(
                JsonText.fields("frame", number, "placed", placed, "heard", heard, "refused", bumps, "words", words));
    }

    private static List<Object> place(int mover, Pose pose) {
        Point c = pose.center();
        Quaternion turned = Quaternion.of(pose);
        return List.of(mover, c.x(), c.y(), c.z(), turned.x(), turned.y(), turned.z(), turned.w());
    }

    /** A measurement: the mover, its sensors in its own frame, their distances. */
    private static List<Object> scan(int mover, Pose pose, List<Scene.Ping> pings) {
        List<Object> sensors = new ArrayList<>();
        List<Object> distances = new ArrayList<>();
        for (Scene.Ping ping : pings) {
            Point at = Scans.place(ping.start(), pose);
            List<Object> sensor = new ArrayList<>();
            sensor.add(radians(ping.heading() - pose.heading()));
            sensor.add(radians(ping.width()));
            sensor.add(ping.range()); // null in JSON where it is infinite
            sensor.add(at.x());
            sensor.add(at.y());
            sensor.add(at.z());
            sensors.add(sensor);
            distances.add(rounded(ping.distance()));
        }
        return List.of(mover, sensors, distances);
    }

    private static double radians(double degrees) {
        return rounded(Degrees.toRadians(degrees % 360));
    }

    private static double rounded(double value) {
        return Double.isFinite(value) && Math.abs(value) < DIGITS * DIGITS ? Math.rint(value * DIGITS) / DIGITS : value;
    }
}
