package robosim.geometry.render;

import robosim.geometry.check.Checks;
import robosim.geometry.material.Color;
import robosim.geometry.model.Point;

/**
 * Something that gives light and throws hard shadows. A surface is lit where the straight way to the light is free; touching
 * is blocking, as everywhere in this module. A light has no size and cannot be seen itself.
 *
 * <p>A surface that faces a sun of strength 1 scatters just as much light as its colour says; so does one that faces a
 * lamp of strength 1 at a distance of one world unit. The light of a lamp falls with the square of the distance.
 */
public sealed interface Light permits Light.Sun, Light.Lamp, Light.Spot {
    /** The colour of the light. */
    Color color();

    /** How strong the light is; at least 0. */
    double strength();

    /**
     * A light so far away that its rays are parallel.
     *
     * @param direction in which the light travels, of any length but zero
     */
    record Sun(Point direction, Color color, double strength) implements Light {
        public Sun {
            checkDirection(direction);
            check(color, strength);
        }
    }

    /**
     * A light that shines in all directions.
     *
     * @param place where it is: outside of every solid, or it lights nothing
     */
    record Lamp(Point place, Color color, double strength) implements Light {
        public Lamp {
            Checks.present("place", place);
            check(color, strength);
        }
    }

    /**
     * A lamp that shines into a cone, with full strength up to three quarters of the way from its axis to its edge.
     *
     * @param place     where it is: outside of every solid, or it lights nothing
     * @param direction of the axis, of any length but zero
     * @param degrees   the full opening angle of the cone, above 0 and below 180
     */
    record Spot(Point place, Point direction, double degrees, Color color, double strength) implements Light {
        public Spot {
            Checks.present("place", place);
            checkDirection(direction);
            if (!(degrees > 0 && degrees < 180)) { // written so that NaN fails it
                throw new IllegalArgumentException("degrees must be above 0 and below 180 (got: " + degrees + ")");
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
        if (!(strength >= 0 && strength <= Checks.LIMIT)) {
            throw new IllegalArgumentException("strength must be from 0 to 2^100 (got: " + strength + ")");
        }
    }
}
