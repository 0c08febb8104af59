package robosim.geometry.world;

import java.util.stream.DoubleStream;
import org.jspecify.annotations.Nullable;
import robosim.geometry.material.Color;
import robosim.geometry.model.Point;
import robosim.geometry.render.Light;
import robosim.geometry.render.Lighting;
import robosim.geometry.render.Sky;
import robosim.geometry.world.shared.Decimal;

/** The light of a world file: the elements of {@code <lighting>}, while they are read and as they are written. */
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

    /** Writes the light of a world; nothing for that of a clear day. */
    static void write(@Nullable Lighting lighting, WorldWriter to) {
        if (lighting == null) {
            return;
        }
        to.open("lighting", 1);
        to.line(">");
        Sky sky = lighting.sky();
        to.open("sky", 2);
        to.attribute("zenith", WorldMaterials.text(sky.zenith()));
        to.attribute("horizon", WorldMaterials.text(sky.horizon()));
        to.attribute("ground", WorldMaterials.text(sky.ground()));
        to.attribute("strength", Decimal.of(sky.strength()));
        Color even = sky.light();
        if (even != null) {
            to.attribute("light", WorldMaterials.text(even));
        }
        to.line("/>");
        lighting.lights().forEach(light -> write(light, to));
        to.close("lighting", 1);
    }

    private static void write(Light light, WorldWriter to) {
        if (light instanceof Light.Sun sun) {
            to.open("sun", 2);
            to.attribute("direction", text(sun.direction()));
        } else if (light instanceof Light.Spot spot) {
            to.open("spot", 2);
            to.attribute("center", text(spot.place()));
            to.attribute("direction", text(spot.direction()));
            to.attribute("angle", Decimal.of(spot.degrees()));
            write(spot.falloff(), to);
        } else {
            Light.Lamp lamp = (Light.Lamp) light;
            to.open("lamp", 2);
            to.attribute("center", text(lamp.place()));
            write(lamp.falloff(), to);
        }
        to.attribute("color", WorldMaterials.text(light.color()));
        to.attribute("strength", Decimal.of(light.strength()));
        if (light.shadows() == Light.Shadows.NONE) {
            to.attribute("shadows", "none");
        }
        to.line("/>");
    }

    private static void write(Light.Falloff falloff, WorldWriter to) {
        if (falloff.range() < Double.POSITIVE_INFINITY) {
            to.attribute("range", Decimal.of(falloff.range()));
        }
        if (falloff.constant() != 0 || falloff.linear() != 0 || falloff.quadratic() != 1) {
            to.attribute("constant", Decimal.of(falloff.constant()));
            to.attribute("linear", Decimal.of(falloff.linear()));
            to.attribute("quadratic", Decimal.of(falloff.quadratic()));
        }
    }

    private static String text(Point point) {
        return String.join(
                " ",
                DoubleStream.of(point.x(), point.y(), point.z())
                        .mapToObj(Decimal::of)
                        .toList());
    }
}
