package robosim.geometry.render;

import robosim.geometry.check.Checks;
import robosim.geometry.material.Color;
import robosim.geometry.model.Point;

/**
 * Something that gives light and throws hard shadows, unless its shadows are off. A surface is lit where the straight path to the
 * light is free; touching is blocking, as everywhere in this module. A light has no size and cannot be seen itself.
 *
 * <p>A surface that faces a sun of strength 1 scatters just as much light as its colour says; so does one that faces a
 * lamp of strength 1 at a distance of one world unit, if the lamp's light falls with the square of the distance.
 */
public sealed interface Light permits Light.Sun, Light.Lamp, Light.Spot {
    /** The colour of the light. */
    Color color();

    /** How strong the light is; at least 0. */
    double strength();

    /** Whether objects keep the light from the surfaces behind them. */
    Shadows shadows();

    /** The shadows of a light. */
    enum Shadows {
        /** With sharp edges. */
        HARD,
        /** None: the light passes through everything, as simulators save time. */
        NONE
    }

    /**
     * How the light of a lamp falls with the distance d: its strength is divided by {@code constant + linear d + quadratic
     * d<sup>2</sup>}.
     *
     * @param range     beyond which there is no light at all; above 0, may be infinite
     * @param constant  at least 0, as the others, of which one must be above 0
     * @param linear    by world unit
     * @param quadratic by the square of a world unit
     */
    record Falloff(double range, double constant, double linear, double quadratic) {
        /** With the square of the distance, without an end. */
        public static final Falloff SQUARE = new Falloff(Double.POSITIVE_INFINITY, 0, 0, 1);

        public Falloff {
            if (!(range > 0)) { // written so that NaN fails it
                throw new IllegalArgumentException("range must be above 0 (got: " + range + ")");
            }
            double sum = constant + linear + quadratic;
            if (!(constant >= 0 && linear >= 0 && quadratic >= 0 && sum > 0 && sum <= Checks.LIMIT)) {
                throw new IllegalArgumentException(
                        "constant, linear and quadratic must be at least 0, and their sum above 0 and at most 2^100 (got: "
                                + constant + ", " + linear + ", " + quadratic + ")");
            }
        }
    }

    /**
     * A light so far away that its rays are parallel.
     *
     * @param direction in which the light travels, of any length but zero
     */
    record Sun(Point direction, Color color, double strength, Shadows shadows) implements Light {
        public Sun {
            checkDirection(direction);
            check(color, strength, shadows);
        }

        /** A sun that throws shadows. */
        public Sun(Point direction, Color color, double strength) {
            this(direction, color, strength, Shadows.HARD);
        }
    }

    /**
     * A light that shines in all directions.
     *
     * @param place where it is: outside of every solid, or it lights nothing
     */
    record Lamp(Point place, Color color, double strength, Falloff falloff, Shadows shadows) implements Light {
        public Lamp {
            Checks.present("place", place);
            Checks.present("falloff", falloff);
            check(color, strength, shadows);
        }

        /** A lamp that throws shadows, whose light falls with the square of the distance. */
        public Lamp(Point place, Color color, double strength) {
            this(place, color, strength, Falloff.SQUARE, Shadows.HARD);
        }
    }

    /**
     * A lamp that shines into a cone, with full strength up to three quarters of the way from its axis to its edge.
     *
     * @param place     where it is: outside of every solid, or it lights nothing
     * @param direction of the axis, of any length but zero
     * @param degrees   the full opening angle of the cone, above 0 and below 180
     */
    record Spot(
            Point place,
            Point direction,
            double degrees,
            Color color,
            double strength,
            Falloff falloff,
            Shadows shadows)
            implements Light {
        public Spot {
            Checks.present("place", place);
            checkDirection(direction);
            if (!(degrees > 0 && degrees < 180)) { // written so that NaN fails it
                throw new IllegalArgumentException("degrees must be above 0 and below 180 (got: " + degrees + ")");
            }
            Checks.present("falloff", falloff);
            check(color, strength, shadows);
        }

        /** A spot that throws shadows, whose light falls with the square of the distance. */
        public Spot(Point place, Point direction, double degrees, Color color, double strength) {
            this(place, direction, degrees, color, strength, Falloff.SQUARE, Shadows.HARD);
        }
    }

    private static void checkDirection(Point direction) {
        Checks.present("direction", direction);
        if (direction.x() == 0 && direction.y() == 0 && direction.z() == 0) {
            throw new IllegalArgumentException("direction must not be zero (got: " + direction + ")");
        }
    }

    private static void check(Color color, double strength, Shadows shadows) {
        Checks.present("color", color);
        Checks.present("shadows", shadows);
        if (!(strength >= 0 && strength <= Checks.LIMIT)) {
            throw new IllegalArgumentException("strength must be from 0 to 2^100 (got: " + strength + ")");
        }
    }
}
