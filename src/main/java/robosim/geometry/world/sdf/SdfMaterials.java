package robosim.geometry.world.sdf;

import org.jspecify.annotations.Nullable;
import robosim.geometry.material.Color;
import robosim.geometry.material.Material;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.Numbers;

/** The materials of SDFormat's visuals, for the collisions beside them: diffuse, specular and emissive colour, shininess. */
final class SdfMaterials {
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

    private static Material read(SdfElement element) throws FileProblem {
        Material material = Material.DEFAULT;
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
        SdfElement emissive = element.child("emissive");
        return emissive == null ? material : material.withEmission(color(emissive));
    }

    /** Red, green and blue, and opacity, which is ignored; what is brighter than white is white. */
    private static Color color(SdfElement element) throws FileProblem {
        double[] shares = element.numbers(Numbers.words(element.value()).length == 3 ? 3 : 4);
        return new Color(share(shares[0]), share(shares[1]), share(shares[2]));
    }

    private static double share(double number) {
        return Math.min(Math.max(0, number), 1);
    }
}
