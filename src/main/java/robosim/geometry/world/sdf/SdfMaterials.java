package robosim.geometry.world.sdf;

import java.util.Map;
import org.jspecify.annotations.Nullable;
import robosim.geometry.material.Color;
import robosim.geometry.material.Material;
import robosim.geometry.world.mesh.MeshFiles;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.Numbers;

/**
 * The materials of SDFormat's visuals, and of the collisions beside them: diffuse, specular and emissive colour, shininess; of
 * physically based ones the roughness, the metalness and, where they are seen, the picture of the colours.
 */
final class SdfMaterials {
    private static final String GAZEBO = "Gazebo/";

    private static final String GLOW = "Glow";

    /** That of a metal which does not say. */
    private static final double ROUGHNESS = 0.5;

    /** The diffuse colours of scripts of Gazebo, by their names; of those with a picture, a colour like it. */
    private static final Map<String, String> COLORS = Map.ofEntries(
            Map.entry("Grey", "#b3b3b3"),
            Map.entry("Gray", "#b3b3b3"),
            Map.entry("DarkGrey", "#2d2d2d"),
            Map.entry("DarkGray", "#2d2d2d"),
            Map.entry("White", "#ffffff"),
            Map.entry("FlatBlack", "#1a1a1a"),
            Map.entry("Black", "#000000"),
            Map.entry("Red", "#ff0000"),
            Map.entry("RedBright", "#de2626"),
            Map.entry("Green", "#00ff00"),
            Map.entry("Blue", "#0000ff"),
            Map.entry("SkyBlue", "#21b5e6"),
            Map.entry("Yellow", "#ffff00"),
            Map.entry("ZincYellow", "#f9ee0f"),
            Map.entry("DarkYellow", "#b3b300"),
            Map.entry("Purple", "#ff00ff"),
            Map.entry("Turquoise", "#00ffff"),
            Map.entry("Orange", "#ff8200"),
            Map.entry("Indigo", "#54008a"),
            Map.entry("Gold", "#ccad26"),
            Map.entry("Wood", "#a87b4a"),
            Map.entry("WoodFloor", "#b98d5b"),
            Map.entry("WoodPallet", "#b48f63"),
            Map.entry("Bricks", "#9a5f4b"),
            Map.entry("CeilingTiled", "#d9d7d0"),
            Map.entry("Paper", "#f2efe6"),
            Map.entry("Grass", "#4f7a32"),
            Map.entry("Road", "#5a5a5c"),
            Map.entry("Residential", "#9a9a94"));

    private SdfMaterials() {}

    /**
     * What a collision is made of: that of the visual of the same name in its link; else of the link's first visual that has
     * a material; null without one.
     */
    static @Nullable Material of(SdfElement link, SdfElement collision) throws FileProblem {
        String name = collision.attribute("name");
        SdfElement found = null;
        for (SdfElement visual : link.children) {
            SdfElement material = visual.name.equals("visual") ? visual.child("material") : null;
            if (material != null && !material.children.isEmpty()) {
                if (visual.attribute("name").equals(name)) {
                    found = material;
                    break;
                }
                found = found == null ? material : found;
            }
        }
        return found == null ? null : read(found);
    }

    /** What a visual is made of, but for its picture; null if it does not say so. */
    static @Nullable Material ofVisual(SdfElement visual) throws FileProblem {
        SdfElement material = visual.child("material");
        return material == null || material.children.isEmpty() ? null : read(material);
    }

    /** The picture of the colours of a visual; null if there is none. */
    static @Nullable SdfElement picture(SdfElement visual) {
        SdfElement metal = metal(visual.child("material"));
        SdfElement map = metal == null ? null : metal.child("albedo_map");
        return map == null || map.value().isEmpty() ? null : map;
    }

    private static @Nullable SdfElement metal(@Nullable SdfElement material) {
        SdfElement physical = material == null ? null : material.child("pbr");
        return physical == null ? null : physical.child("metal");
    }

    /** A material by the name of one of Gazebo's scripts, which may glow; the default for others. */
    private static Material ofScript(SdfElement script) {
        String name = script.valueOf("name");
        String plain = name.startsWith(GAZEBO) ? name.substring(GAZEBO.length()) : "";
        boolean isGlowing = plain.endsWith(GLOW);
        String color = COLORS.get(plain.replaceFirst("(" + GLOW + "|Transparent)$", ""));
        if (color == null) {
            return Material.DEFAULT;
        }
        Material made = Material.DEFAULT.withColor(Color.parse(color));
        return isGlowing ? made.withEmission(Color.parse(color)) : made;
    }

    private static Material read(SdfElement element) throws FileProblem {
        SdfElement script = element.child("script");
        Material material = script == null ? Material.DEFAULT : ofScript(script);
        SdfElement diffuse = element.child("diffuse");
        if (diffuse != null) {
            material = material.withColor(color(diffuse));
        }
        SdfElement specular = element.child("specular");
        if (specular != null) {
            Color color = color(specular);
            material = material.withSpecular(Math.max(color.red(), Math.max(color.green(), color.blue())));
        }
        SdfElement shininess = element.child("shininess");
        if (shininess != null) {
            double exponent = shininess.numbers(1)[0];
            material = material.withShininess(Math.min(Math.max(1, exponent), Material.MOST_SHININESS));
        }
        SdfElement metal = metal(element);
        if (metal != null) {
            double rough = metal.child("roughness") == null ? ROUGHNESS : metal.number("roughness");
            double metallic = metal.child("metalness") == null ? 0 : metal.number("metalness");
            material = MeshFiles.rough(material, share(rough), share(metallic));
        }
        SdfElement emissive = element.child("emissive");
        return emissive == null ? material : material.withEmission(color(emissive));
    }

    /** Red, green and blue, and opacity, which is ignored; what is brighter than white is white. */
    static Color color(SdfElement element) throws FileProblem {
        double[] shares = shares(element);
        return new Color(share(shares[0]), share(shares[1]), share(shares[2]));
    }

    /** Red, green and blue, and perhaps a fourth number. */
    static double[] shares(SdfElement element) throws FileProblem {
        return element.numbers(Numbers.words(element.value()).length == 3 ? 3 : 4);
    }

    private static double share(double number) {
        return Math.min(Math.max(0, number), 1);
    }
}
