package robosim.geometry.render;

import java.util.ArrayList;
import java.util.List;
import robosim.geometry.check.Checks;
import robosim.geometry.material.Color;
import robosim.geometry.model.Point;

/**
 * All light of a picture: that of the sky, and lights that throw shadows.
 *
 * @param sky    what is seen where nothing is met, and the even light from all around
 * @param lights at most {@link #MOST_LIGHTS}
 */
public record Lighting(Sky sky, List<Light> lights) {
    /** The most lights. Each is asked about at every point that is seen. */
    public static final int MOST_LIGHTS = 256;

    /**
     * A clear day, with the sun on the left behind somebody who looks along -Z, so that the sides of a box differ. Together its
     * light makes white nearly white and no brighter.
     */
    public static final Lighting DAY =
            new Lighting(Sky.DAY, List.of(new Light.Sun(new Point(0.55, -1.0, -0.6), Color.parse("#fff0d8"), 0.68)));

    /** No light at all. */
    public static final Lighting NONE = new Lighting(Sky.NONE, List.of());

    public Lighting {
        Checks.present("sky", sky);
        lights = List.copyOf(Checks.list("lights", lights));
        if (lights.size() > MOST_LIGHTS) {
            throw new IllegalArgumentException(
                    "lights must be at most " + MOST_LIGHTS + " (got: " + lights.size() + ")");
        }
    }

    /** This lighting with another sky. */
    public Lighting withSky(Sky newSky) {
        return new Lighting(newSky, lights);
    }

    /** This lighting with one more light. */
    public Lighting withLight(Light light) {
        List<Light> more = new ArrayList<>(lights);
        more.add(Checks.present("light", light));
        return new Lighting(sky, more);
    }

    /** This lighting without any of its lights; the sky stays. */
    public Lighting withoutLights() {
        return new Lighting(sky, List.of());
    }
}
