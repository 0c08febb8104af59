package robosim.geometry.world.sdf;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import robosim.geometry.exact.Degrees;
import robosim.geometry.material.Color;
import robosim.geometry.model.Point;
import robosim.geometry.render.Light;
import robosim.geometry.render.Lighting;
import robosim.geometry.render.Sky;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.LimitProblem;
import robosim.geometry.world.shared.Placement;

/** The lights of a world, its ambient light and its background. A light that cannot be read is not lit. */
final class SdfLights {
    /** What a scene has that does not say otherwise. */
    private static final double[] AMBIENT = {0.4, 0.4, 0.4};

    private static final Color BACKGROUND = new Color(0.7, 0.7, 0.7);

    /** The widest cone of a spot, in degrees. */
    private static final double WIDEST = 179;

    private final List<Light> lights = new ArrayList<>();
    private @Nullable Sky sky;
    private boolean hasShadows = true;
    private int failed;
    private String first = "";

    /** Where a light is in the world. */
    @FunctionalInterface
    interface Place {
        Placement get() throws FileProblem;
    }

    /** The light of the world; null if the file says nothing of it. */
    @Nullable
    Lighting lighting() {
        Sky seen = sky;
        return seen == null && lights.isEmpty() ? null : new Lighting(seen == null ? Sky.DAY : seen, lights);
    }

    /** Adds that some lights are missing. */
    void remark(List<String> remarks) {
        if (failed > 0) {
            remarks.add(failed + (failed == 1 ? " light is" : " lights are") + " not lit; the first one: " + first);
        }
    }

    /** Reads a {@code <light>}, unless it is switched off. */
    void add(SdfElement light, Place place) throws FileProblem {
        try {
            if (isTrue(light, "light_on", true)) {
                Light made = read(light, place.get());
                if (lights.size() == Lighting.MOST_LIGHTS) {
                    throw light.wrong("a world has at most " + Lighting.MOST_LIGHTS + " lights (got: more)");
                }
                lights.add(made);
            }
        } catch (LimitProblem e) {
            throw e;
        } catch (FileProblem | IllegalArgumentException e) {
            first = failed++ == 0 ? String.valueOf(e.getMessage()) : first;
        }
    }

    private Light read(SdfElement light, Placement place) throws FileProblem {
        SdfElement diffuse = light.child("diffuse");
        double[] shares = diffuse == null ? new double[] {1, 1, 1} : SdfMaterials.shares(diffuse);
        Color color = tint(shares);
        double strength = strength(shares) * numberOr(light, "intensity", 1);
        Light.Shadows shadows =
                hasShadows && isTrue(light, "cast_shadows", false) ? Light.Shadows.HARD : Light.Shadows.NONE;
        Point given = light.vector("direction", new Point(0, 0, -1));
        Point own = SdfPose.place(given.x(), given.y(), given.z());
        Point direction = place.direction(own.x(), own.y(), own.z());
        String type = light.attribute("type");
        return switch (type) {
            case "directional" -> new Light.Sun(direction, color, strength, shadows);
            case "point" -> new Light.Lamp(place.origin(), color, strength, falloff(light), shadows);
            case "spot" ->
                new Light.Spot(place.origin(), direction, degrees(light), color, strength, falloff(light), shadows);
            default -> throw light.wrong("type of <light> must be directional, point or spot (got: " + type + ")");
        };
    }

    /** The components of a light are amounts of light, of which the largest is its strength. */
    private static double strength(double[] shares) {
        return Math.max(0, Math.max(shares[0], Math.max(shares[1], shares[2])));
    }

    private static Color tint(double[] shares) {
        double most = strength(shares);
        return (shares[0] == shares[1] && shares[0] == shares[2]) || most == 0
                ? Color.WHITE // of any strength
                : Color.ofLinear(
                        Math.max(0, shares[0] / most), Math.max(0, shares[1] / most), Math.max(0, shares[2] / most));
    }

    private static boolean isTrue(SdfElement element, String child, boolean otherwise) throws FileProblem {
        SdfElement found = element.child(child);
        return found == null ? otherwise : SdfElement.isTrue(found, "<" + child + ">", found.value());
    }

    private static double numberOr(SdfElement element, String child, double otherwise) throws FileProblem {
        return element.child(child) == null ? otherwise : element.number(child);
    }

    private static double degrees(SdfElement light) throws FileProblem {
        return Math.min(WIDEST, Degrees.toDegrees(light.required("spot").number("outer_angle")));
    }

    private static Light.Falloff falloff(SdfElement light) throws FileProblem {
        SdfElement given = light.child("attenuation");
        if (given == null) {
            return new Light.Falloff(10, 1, 1, 0);
        }
        double constant = numberOr(given, "constant", 1);
        double linear = numberOr(given, "linear", 1);
        double quadratic = numberOr(given, "quadratic", 0);
        boolean isEven = constant == 0 && linear == 0 && quadratic == 0;
        return new Light.Falloff(numberOr(given, SdfNames.LIGHT_RANGE, 10), isEven ? 1 : constant, linear, quadratic);
    }

    /** Reads a {@code <scene>}. */
    void scene(SdfElement scene) throws FileProblem {
        try {
            SdfElement ambient = scene.child("ambient");
            SdfElement background = scene.child("background");
            double[] light = ambient == null ? AMBIENT : SdfMaterials.shares(ambient);
            Color seen = background == null ? BACKGROUND : SdfMaterials.color(background);
            Sky shown = scene.child("sky") == null ? Sky.of(seen, 1) : Sky.DAY;
            sky = shown.withStrength(strength(light)).withLight(tint(light));
            hasShadows = isTrue(scene, "shadows", true);
        } catch (FileProblem | IllegalArgumentException e) {
            first = failed++ == 0 ? String.valueOf(e.getMessage()) : first;
        }
    }

    /** The sun that comes with every Gazebo, which most worlds include. */
    static SdfElement sun(SdfElement include) {
        SdfElement sun =
                new SdfElement(include.file, "light", include.line, 0, Map.of("name", "sun", "type", "directional"));
        text(sun, "diffuse", "0.8 0.8 0.8 1");
        text(sun, "direction", "-0.5 0.1 -0.9");
        text(sun, "cast_shadows", "true");
        return sun;
    }

    private static void text(SdfElement parent, String name, String text) {
        SdfElement child = new SdfElement(parent.file, name, parent.line, 0, Map.of());
        child.text.append(text);
        parent.children.add(child);
    }
}
