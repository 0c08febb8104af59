package robosim.geometry.world;

import robosim.geometry.material.Color;
import robosim.geometry.model.Point;
import robosim.geometry.render.Light;
import robosim.geometry.render.Lighting;
import robosim.geometry.render.Sky;

/** The light of a world file: the elements of {@code <lighting>} while they are read. */
final class WorldLights {
    private WorldLights() {}

    /** The light of a world. */
    static Lighting of(Element lighting) {
        Sky sky = lighting.sky;
        return new Lighting(sky == null ? Sky.DAY : sky, lighting.lights);
    }

    static Sky sky(Element element) {
        Sky day = Sky.DAY;
        return new Sky(
                WorldMaterials.color(element, "zenith", day.zenith()),
                WorldMaterials.color(element, "horizon", day.horizon()),
                WorldMaterials.color(element, "ground", day.ground()),
                element.attribute("strength") == null ? day.strength() : ObjectBuilder.number(element, "strength", ""),
                element.attribute("light") == null ? null : WorldMaterials.color(element, "light", null));
    }

    /** The light of a {@code <sun>}, {@code <lamp>} or {@code <spot>}. */
    static Light light(Element element, ObjectBuilder builder) {
        Color color = WorldMaterials.color(element, "color", Color.WHITE);
        double strength = ObjectBuilder.number(element, "strength", "1");
        Light.Shadows shadows =
                element.attribute("shadows", "hard").equals("none") ? Light.Shadows.NONE : Light.Shadows.HARD;
        Point center = builder.point(element, "center");
        return switch (element.name) {
            case "sun" -> new Light.Sun(direction(element), color, strength, shadows);
            case "lamp" -> new Light.Lamp(center, color, strength, falloff(element, builder), shadows);
            default ->
                new Light.Spot(
                        center,
                        direction(element),
                        ObjectBuilder.number(element, "angle", ""),
                        color,
                        strength,
                        falloff(element, builder),
                        shadows);
        };
    }

    private static Point direction(Element element) {
        double[] numbers = ObjectBuilder.numbers("direction", element.attribute("direction", ""));
        return new Point(numbers[0], numbers[1], numbers[2]);
    }

    private static Light.Falloff falloff(Element element, ObjectBuilder builder) {
        double range = element.attribute("range") == null
                ? Light.Falloff.SQUARE.range()
                : builder.length(element, "range", "");
        double constant = ObjectBuilder.number(element, "constant", "0");
        double linear = ObjectBuilder.number(element, "linear", "0");
        String usual = element.attribute("constant") == null && element.attribute("linear") == null ? "1" : "0";
        return new Light.Falloff(range, constant, linear, ObjectBuilder.number(element, "quadratic", usual));
    }
}
