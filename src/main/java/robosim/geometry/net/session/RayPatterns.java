package robosim.geometry.net.session;

import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;
import robosim.geometry.exact.Degrees;
import robosim.geometry.model.RayPattern;
import robosim.geometry.protocol.batch.BeamPattern;
import robosim.geometry.protocol.batch.Numbers;

/** Makes patterns of their descriptions, radians to degrees, and keeps those used last: a robot asks for the same again. */
public final class RayPatterns {
    /** The most beams of the patterns kept between two bundles, 800 kB. A lidar's turn of 16 x 1800 has 28,800. */
    private static final int MOST_BEAMS = 1 << 15;

    private final Map<BeamPattern, RayPattern> made = new LinkedHashMap<>(16, 0.75f, true);

    RayPattern of(BeamPattern pattern) {
        RayPattern known = made.get(pattern);
        if (known == null) {
            known = make(pattern);
            made.put(pattern, known);
        }
        return known;
    }

    /** Drops those that have not been used for longest, until the others are few enough. */
    void trim() {
        long beams = 0;
        for (RayPattern pattern : made.values()) {
            beams += pattern.size();
        }
        Iterator<RayPattern> eldest = made.values().iterator();
        while (beams > MOST_BEAMS) {
            beams -= eldest.next().size();
            eldest.remove();
        }
    }

    /** A pattern as its description has it. */
    public static RayPattern make(BeamPattern pattern) {
        if (pattern instanceof BeamPattern.Fan fan) {
            return RayPattern.fan(Degrees.toDegrees(fan.first()), Degrees.toDegrees(fan.step()), fan.count());
        }
        if (pattern instanceof BeamPattern.Layers layers) {
            return RayPattern.layers(
                    degrees(layers.elevations()),
                    Degrees.toDegrees(layers.first()),
                    Degrees.toDegrees(layers.step()),
                    layers.count());
        }
        if (pattern instanceof BeamPattern.Pinhole camera) {
            return RayPattern.pinhole(camera.width(), camera.height(), Degrees.toDegrees(camera.fieldOfView()));
        }
        return RayPattern.of(((BeamPattern.Directions) pattern).directions().values());
    }

    private static double[] degrees(Numbers radians) {
        double[] degrees = radians.values();
        for (int k = 0; k < degrees.length; k++) {
            degrees[k] = Degrees.toDegrees(degrees[k]);
        }
        return degrees;
    }
}
