package robosim.geometry.render;

import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.material.Color;

/**
 * What a ray sees that meets nothing, and the even light from all around: from above in the colours of the sky, from below
 * in that of the ground.
 *
 * @param zenith   straight up
 * @param horizon  at the horizon
 * @param ground   straight down
 * @param strength how much of their light reaches the surfaces; 0 for none. With 1, white under a white sky is white
 * @param light    the colour of the even light, from above and from below; null for those of the sky and the ground
 */
public record Sky(
        Color zenith,
        Color horizon,
        Color ground,
        double strength,
        @Nullable Color light) {
    /** A clear day. */
    public static final Sky DAY = new Sky(Color.parse("#4d84c4"), Color.parse("#e3edf7"), Color.parse("#b4b6b8"), 0.7);

    /** A dark room: black, and no light at all. */
    public static final Sky NONE = new Sky(Color.BLACK, Color.BLACK, Color.BLACK, 0);

    public Sky {
        Checks.present("zenith", zenith);
        Checks.present("horizon", horizon);
        Checks.present("ground", ground);
        if (!(strength >= 0 && strength <= Checks.LIMIT)) { // written so that NaN fails it
            throw new IllegalArgumentException("strength must be from 0 to 2^100 (got: " + strength + ")");
        }
    }

    /** A sky whose light has its own colours. */
    public Sky(Color zenith, Color horizon, Color ground, double strength) {
        this(zenith, horizon, ground, strength, null);
    }

    /** A sky of one colour in all directions. */
    public static Sky of(Color color, double strength) {
        return new Sky(color, color, color, strength);
    }

    /** This sky with another strength of its light. */
    public Sky withStrength(double newStrength) {
        return new Sky(zenith, horizon, ground, newStrength, light);
    }

    /** This sky with even light of another colour; null for its own colours. */
    public Sky withLight(@Nullable Color newLight) {
        return new Sky(zenith, horizon, ground, strength, newLight);
    }
}
