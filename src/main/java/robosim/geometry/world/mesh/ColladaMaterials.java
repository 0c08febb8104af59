package robosim.geometry.world.mesh;

import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.material.Color;
import robosim.geometry.material.Material;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.Folder;

/**
 * The materials of a COLLADA file: the colours and the picture of the common profile of their effects. What cannot be read of
 * them is ignored, a picture too, since it costs no shape; the plain colour is seen there.
 */
final class ColladaMaterials {
    private static final List<String> MODELS = List.of("phong", "blinn", "lambert", "constant");
    private static final String FILE = "file://";

    private final ColladaParser file;
    private final ColladaSurface.@Nullable Pictures pictures;

    ColladaMaterials(ColladaParser file, ColladaSurface.@Nullable Pictures pictures) {
        this.file = file;
        this.pictures = pictures;
    }

    /** The id of the material that an instance of a geometry binds to a symbol; else the symbol, which may be an id itself. */
    String bound(ColladaElement instance, String symbol) {
        ColladaElement bind = instance.child("bind_material");
        ColladaElement technique = bind == null ? null : bind.child("technique_common");
        if (technique != null) {
            for (ColladaElement each : technique.all("instance_material")) {
                if (each.attribute("symbol").equals(symbol)) {
                    return each.attribute("target").replaceFirst("^#", "");
                }
            }
        }
        return symbol;
    }

    /** The material of an id; the default if there is none. */
    Material get(String id) {
        try {
            ColladaElement material = file.found(id);
            ColladaElement instance = material == null ? null : material.child("instance_effect");
            ColladaElement effect = instance == null ? null : file.referred(instance, "url");
            ColladaElement profile = effect == null ? null : effect.child("profile_COMMON");
            ColladaElement technique = profile == null ? null : profile.child("technique");
            if (technique == null || effect == null) {
                return Material.DEFAULT;
            }
            for (String model : MODELS) {
                ColladaElement shading = technique.child(model);
                if (shading != null) {
                    return read(shading, List.of(profile, effect));
                }
            }
            return Material.DEFAULT;
        } catch (FileProblem e) {
            return Material.DEFAULT;
        }
    }

    private Material read(ColladaElement shading, List<ColladaElement> parameters) throws FileProblem {
        Material material = Material.DEFAULT.withSpecular(0);
        Color diffuse = color(shading.child("diffuse"));
        material = diffuse == null ? material : material.withColor(diffuse);
        Color emission = color(shading.child("emission"));
        material = emission == null ? material : material.withEmission(emission);
        Color specular = color(shading.child("specular"));
        if (specular != null) {
            material = material.withSpecular(Math.max(specular.red(), Math.max(specular.green(), specular.blue())));
        }
        ColladaElement shininess = shading.child("shininess");
        ColladaElement number = shininess == null ? null : shininess.child("float");
        if (number != null && number.count() == 1) {
            material = material.withShininess(Math.min(Math.max(1, number.number(0)), Material.MOST_SHININESS));
        }
        ColladaElement picture = shading.child("diffuse");
        ColladaElement texture = picture == null ? null : picture.child("texture");
        return texture == null ? material : pictured(material, image(texture.attribute("texture"), parameters));
    }

    /** Red, green and blue; what is brighter than white is white. */
    private static @Nullable Color color(@Nullable ColladaElement of) throws FileProblem {
        ColladaElement given = of == null ? null : of.child("color");
        return given == null || given.count() < 3
                ? null
                : new Color(share(given.number(0)), share(given.number(1)), share(given.number(2)));
    }

    private static double share(double number) {
        return Math.min(Math.max(0, number), 1);
    }

    /** The image that a texture names: through a sampler and a surface, a sampler alone, or itself. */
    private String image(String name, List<ColladaElement> parameters) {
        ColladaElement sampler = parameter(name, "sampler2D", parameters);
        ColladaElement source = sampler == null ? null : sampler.child("source");
        String named = source == null ? name : source.text.toString().strip();
        ColladaElement surface = parameter(named, "surface", parameters);
        ColladaElement from = surface == null ? null : surface.child("init_from");
        return from == null ? named : from.text.toString().strip();
    }

    private static @Nullable ColladaElement parameter(String sid, String kind, List<ColladaElement> parameters) {
        for (ColladaElement holder : parameters) {
            for (ColladaElement each : holder.all("newparam")) {
                if (each.attribute("sid").equals(sid) && each.child(kind) != null) {
                    return each.child(kind);
                }
            }
        }
        return null;
    }

    private Material pictured(Material material, String id) throws FileProblem {
        ColladaElement image = file.found(id);
        ColladaElement from = image == null ? null : image.child("init_from");
        if (from == null || pictures == null) {
            return material;
        }
        ColladaElement ref = from.child("ref");
        String address = (ref == null ? from : ref).text.toString().strip().replace('\\', '/');
        String name = Folder.decoded(address.startsWith(FILE) ? address.substring(FILE.length()) : address);
        // Some name the place on the computer of whoever made the file.
        for (String each : List.of(name, name.substring(name.lastIndexOf('/') + 1))) {
            try {
                return material.withTexture(pictures.files().read(pictures.folder(), each));
            } catch (FileProblem | IllegalArgumentException e) {
                // the next one, or none
            }
        }
        return material;
    }
}
