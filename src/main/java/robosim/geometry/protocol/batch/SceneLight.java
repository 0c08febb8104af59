package robosim.geometry.protocol.batch;

import java.io.Serial;
import java.io.Serializable;
import java.util.List;
import robosim.geometry.check.Checks;
import robosim.geometry.material.Color;
import robosim.geometry.model.Point;

/**
 * All light of a picture: that of the sky, which has no shadows, and sources that throw them.
 *
 * @param zenith   what a ray sees that meets nothing, straight up
 * @param horizon  the same at the horizon
 * @param ground   the same straight down
 * @param strength how much of the sky's light reaches the surfaces, from 0 to 2<sup>100</sup>
 * @param sources  at most {@link #MOST_SOURCES}
 */
public record SceneLight(Color zenith, Color horizon, Color ground, double strength, List<Source> sources)
        implements Serializable {
    @Serial
    private static final long serialVersionUID = 1;

    /** The most sources. Each is asked about at every point that is seen; a large room has about ten lamps. */
    public static final int MOST_SOURCES = 16;

    /** Refuses null, numbers out of range and too many sources. */
    public SceneLight {
        Checks.present("zenith", zenith);
        Checks.present("horizon", horizon);
        Checks.present("ground", ground);
        check(strength);
        sources = Checks.copy("sources", sources, Source.class);
        if (sources.size() > MOST_SOURCES) {
            throw new IllegalArgumentException(
                    "sources must be at most " + MOST_SOURCES + " (got: " + sources.size() + ")");
        }
    }

    /** Something that gives light and throws hard shadows. */
    public sealed interface Source extends Serializable permits Sun, Lamp, Spot {
        /** The colour of the light. */
        Color color();

        /** How strong the light is, from 0 to 2<sup>100</sup>; of a lamp, at a distance of one world unit. */
        double strength();
    }

    /**
     * A light so far away that its rays are parallel.
     *
     * @param direction in which the light travels, of any length but zero
     */
    public record Sun(Point direction, Color color, double strength) implements Source {
        @Serial
        private static final long serialVersionUID = 1;

        /** Refuses null and numbers out of range. */
        public Sun {
            checkDirection(direction);
            check(color, strength);
        }
    }

    /**
     * A light that shines in all directions.
     *
     * @param place in the world
     */
    public record Lamp(Point place, Color color, double strength) implements Source {
        @Serial
        private static final long serialVersionUID = 1;

        /** Refuses null and numbers out of range. */
        public Lamp {
            Checks.present("place", place);
            check(color, strength);
        }
    }

    /**
     * A lamp that shines into a cone.
     *
     * @param place     in the world
     * @param direction of the axis, of any length but zero
     * @param angle     the full opening angle in radians, above 0 and below pi
     */
    public record Spot(Point place, Point direction, double angle, Color color, double strength) implements Source {
        @Serial
        private static final long serialVersionUID = 1;

        /** Refuses null and numbers out of range. */
        public Spot {
            Checks.present("place", place);
            checkDirection(direction);
            if (!(angle > 0 && angle < Math.PI)) { // written so that NaN fails it
                throw new IllegalArgumentException(
                        "angle must be an angle in radians above 0 and below pi (got: " + angle + ")");
            }
            check(color, strength);
        }
    }

    private static void checkDirection(Point direction) {
        Checks.present("direction", direction);
        if (direction.x() == 0 && direction.y() == 0 && direction.z() == 0) {
            throw new IllegalArgumentException("direction must not be zero (got: " + direction + ")");
        }
    }

    private static void check(Color color, double strength) {
        Checks.present("color", color);
        check(strength);
    }

    private static void check(double strength) {
        if (!(strength >= 0 && strength <= Checks.LIMIT)) { // written so that NaN fails it
            throw new IllegalArgumentException("strength must be from 0 to 2^100 (got: " + strength + ")");
        }
    }
}
