package robosim.geometry.world.mesh;

import java.util.LinkedHashMap;
import java.util.Map;
import robosim.geometry.material.Color;
import robosim.geometry.material.ImageTexture;
import robosim.geometry.material.Material;
import robosim.geometry.material.Texture;
import robosim.geometry.world.shared.Decimal;

/** The materials of an OBJ file, which it names, and the text of its MTL file. */
public final class MaterialWriter {
    private final Map<Material, String> names = new LinkedHashMap<>();
    private final Map<ImageTexture, String> pictures = new LinkedHashMap<>();
    private final String stem;

    /** For files whose names begin with a stem. */
    public MaterialWriter(String stem) {
        this.stem = stem;
    }

    /** Adds a material; answers its name. */
    public String name(Material material) {
        if (material.texture() instanceof ImageTexture image) {
            // The size of a repeat is in the texture coordinates.
            pictures.computeIfAbsent(image.tiled(1, 1), other -> stem + "_" + (pictures.size() + 1) + ".png");
        }
        return names.computeIfAbsent(material, other -> "material_" + (names.size() + 1));
    }

    /** Whether no material but the default was added, so that the OBJ file needs none. */
    public boolean isPlain() {
        return names.keySet().stream().allMatch(Material::isDefault);
    }

    /** The pictures of the materials, each with the name of its file. */
    public Map<ImageTexture, String> pictures() {
        return pictures;
    }

    /** The text of the MTL file. */
    public String text() {
        StringBuilder out = new StringBuilder("# materials of " + stem + ".obj\n");
        names.forEach((material, name) -> {
            out.append("newmtl ").append(name).append('\n');
            Texture texture = material.texture();
            Color color = material.color();
            if (texture instanceof Texture.Checker checker) {
                color = checker.first();
            } else if (texture instanceof Texture.Stripes stripes) {
                color = stripes.first();
            }
            color(out, "Kd", color);
            double specular = material.specular();
            color(out, "Ks", new Color(specular, specular, specular));
            out.append("Ns ").append(Decimal.of(material.shininess())).append('\n');
            if (!material.emission().equals(Color.BLACK)) {
                color(out, "Ke", material.emission());
            }
            out.append("illum ").append(material.mirror() > 0 ? 3 : 2).append('\n');
            if (texture instanceof ImageTexture image) {
                out.append("map_Kd ").append(pictures.get(image.tiled(1, 1))).append('\n');
            }
        });
        return out.toString();
    }

    private static void color(StringBuilder out, String statement, Color color) {
        out.append(statement).append(' ').append(Decimal.of(color.red())).append(' ');
        out.append(Decimal.of(color.green()))
                .append(' ')
                .append(Decimal.of(color.blue()))
                .append('\n');
    }
}
