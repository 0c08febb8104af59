package robosim.geometry.world;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import robosim.geometry.material.Color;
import robosim.geometry.material.ImageTexture;
import robosim.geometry.material.Material;
import robosim.geometry.material.Texture;
import robosim.geometry.material.TextureCoordinates;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.world.shared.Decimal;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.Limits;
import robosim.geometry.world.shared.Numbers;
import robosim.geometry.world.shared.TextureFiles;
import robosim.geometry.world.xml.Text;

/** The materials of a world file: its elements while they are read, and the names of those that are written. */
final class WorldMaterials {
    final TextureFiles textures;

    private final ObjectBuilder builder;
    private final String source;
    private final @Nullable Path base;
    private final Map<String, Material> byName = new HashMap<>();

    WorldMaterials(ObjectBuilder builder, String source, @Nullable Path base) {
        this.builder = builder;
        this.source = source;
        this.base = base;
        textures = new TextureFiles(base == null ? List.of() : List.of(base));
    }

    /** What an object's attributes say that it is made of; null if they say nothing. */
    @Nullable
    Material of(Element object) {
        String name = object.attribute("material");
        String color = object.attribute("color");
        if (name == null) {
            return color == null ? null : Material.of(Color.parse(color.strip()));
        }
        Material material = byName.get(name);
        if (material == null) {
            throw new IllegalArgumentException(
                    "material must be the name of a <material> at the beginning of the world (got: " + name + ")");
        }
        return material;
    }

    /** Adds the material of an element. */
    void define(Element element) {
        String name = element.attribute("name");
        if (byName.size() >= Limits.MAX_MATERIALS) {
            throw new IllegalArgumentException("a world must have at most " + Limits.MAX_MATERIALS
                    + " materials; give the same one to more objects (got: more)");
        }
        Material plain = Material.DEFAULT;
        Material material = plain.withColor(color(element, "color", plain.color()))
                .withDiffuse(number(element, "diffuse", plain.diffuse()))
                .withSpecular(number(element, "specular", plain.specular()))
                .withShininess(number(element, "shininess", plain.shininess()))
                .withMirror(number(element, "mirror", plain.mirror()))
                .withEmission(color(element, "emission", plain.emission()))
                .withTexture(element.texture)
                .withReflectance(number(element, "reflectance", plain.reflectance()));
        String label = element.attribute("label");
        if (label != null) {
            material = material.withLabel(Numbers.index(label.strip()));
        }
        if (name == null || byName.putIfAbsent(name, material) != null) {
            throw new IllegalArgumentException("materials must have names of their own (got twice: " + name + ")");
        }
    }

    private static double number(Element element, String attribute, double otherwise) {
        return element.attribute(attribute) == null ? otherwise : ObjectBuilder.number(element, attribute, "");
    }

    /** {@code #rrggbb}, or three numbers. */
    static Color color(Element element, String attribute, @Nullable Color otherwise) {
        String value = element.attribute(attribute);
        if (value == null) {
            if (otherwise == null) {
                throw new IllegalArgumentException(attribute + " must be given (got: none)");
            }
            return otherwise;
        }
        String text = value.strip();
        return ObjectBuilder.named(attribute, () -> {
            if (text.startsWith("#")) {
                return Color.parse(text);
            }
            double[] shares = Arrays.stream(Numbers.words(text))
                    .mapToDouble(Numbers::parse)
                    .toArray();
            return new Color(shares[0], shares[1], shares[2]);
        });
    }

    /** The pattern of a material. */
    Texture texture(Element element) throws FileProblem {
        return switch (element.name) {
            case "checker" ->
                new Texture.Checker(
                        color(element, "first", null),
                        color(element, "second", null),
                        builder.length(element, "size", "0"));
            case "stripes" ->
                new Texture.Stripes(
                        color(element, "first", null),
                        color(element, "second", null),
                        builder.length(element, "size", "0"),
                        ObjectBuilder.number(element, "degrees", "0"));
            default ->
                picture(element).tiled(builder.length(element, "width", "1"), builder.length(element, "height", "1"));
        };
    }

    private ImageTexture picture(Element element) throws FileProblem {
        String file = element.attribute("file");
        int[] pixels = element.pixels;
        if ((file == null) == (pixels == null)) {
            throw new IllegalArgumentException("an image must have either a file, or columns, rows and pixels (got: "
                    + (file == null ? "neither" : "both") + ")");
        }
        if (file != null) {
            if (base == null) {
                throw new IllegalArgumentException("a world from a stream without a folder cannot use files; give the"
                        + " pixels inline (got: " + file + ")");
            }
            return textures.read(base, file);
        }
        return new ImageTexture(
                Numbers.integer(element.attribute("columns", "0")),
                Numbers.integer(element.attribute("rows", "0")),
                pixels == null ? new int[0] : pixels,
                1,
                1);
    }

    /** Whether the content of an element is read here. */
    static boolean reads(Element element) {
        return switch (element.name) {
            case "uv", "corners", "image" -> true;
            default -> false;
        };
    }

    /** Reads the numbers or the pixels of an element. */
    void readText(Element element) throws FileProblem {
        Text text = element.text;
        double[] numbers = new double[16];
        int[] indices = new int[16];
        boolean isUv = element.name.equals("uv");
        boolean isImage = element.name.equals("image");
        int count = 0;
        while (text.next()) {
            if (count == indices.length) {
                indices = Arrays.copyOf(indices, 2 * count);
                numbers = isUv ? Arrays.copyOf(numbers, 2 * count) : numbers;
            }
            try {
                if (isUv) {
                    numbers[count] = Numbers.parse(text.token());
                } else {
                    indices[count] = isImage ? pixel(text.token()) : Numbers.integer(text.token());
                }
            } catch (IllegalArgumentException e) {
                throw new FileProblem(
                        source, text.line(), text.column(), "<" + element.name + ">: " + e.getMessage(), e);
            }
            count++;
        }
        if (isUv) {
            element.uv = Arrays.copyOf(numbers, count);
        } else if (!isImage) {
            element.corners = Arrays.copyOf(indices, count);
        } else if (count > 0 || element.attribute("columns") != null || element.attribute("rows") != null) {
            element.pixels = Arrays.copyOf(indices, count);
        }
    }

    private static int pixel(String token) {
        if (!token.matches("[0-9a-fA-F]{6}")) {
            throw new IllegalArgumentException(
                    "a pixel must be six hexadecimal digits, rrggbb (got: " + Numbers.shown(token) + ")");
        }
        return Integer.parseInt(token, 16);
    }

    /** The names of the materials of a world's objects that a colour alone does not tell, in the order of their use. */
    static Map<Material, String> named(World world) {
        Map<Material, String> names = new LinkedHashMap<>();
        for (GeometryObject each : world.scenery()) {
            name(each, colorOf(each), names);
        }
        for (WorldObject each : world.objects()) {
            name(each.object(), each.color(), names);
        }
        return names;
    }

    private static void name(GeometryObject object, @Nullable String color, Map<Material, String> names) {
        if (!isToldBy(object.material(), color)) {
            names.computeIfAbsent(object.material(), other -> "material " + (names.size() + 1));
        }
        List<GeometryObject> visuals = object.visuals();
        if (visuals != null) {
            visuals.forEach(visual -> name(visual, colorOf(visual), names));
        }
        GeometryObject bounds = null;
        if (object instanceof ObjectGroup group) {
            bounds = group.boundingVolume();
            for (GeometryObject member : group.members()) {
                name(member, colorOf(member), names);
            }
        } else if (object instanceof MeshObject mesh) {
            bounds = mesh.boundingVolume();
        }
        if (bounds != null) {
            name(bounds, colorOf(bounds), names);
        }
    }

    /** Whether an object with that colour, and nothing else that says what it is made of, has the material. */
    static boolean isToldBy(Material material, @Nullable String color) {
        return color == null ? material.isDefault() : material.equals(Material.of(Color.parse(color)));
    }

    /** The colour that tells all of a member's material; null if none does. */
    static @Nullable String colorOf(GeometryObject member) {
        String color = member.material().color().toString();
        return !member.material().isDefault() && isToldBy(member.material(), color) ? color : null;
    }

    /** Writes the materials at the beginning of a world. */
    static void write(Map<Material, String> names, WorldWriter to) {
        names.forEach((material, name) -> {
            Material plain = Material.DEFAULT;
            to.open("material", 1);
            to.attribute("name", name);
            if (!material.color().equals(plain.color())) {
                to.attribute("color", text(material.color()));
            }
            number(to, "diffuse", material.diffuse(), plain.diffuse());
            number(to, "specular", material.specular(), plain.specular());
            number(to, "shininess", material.shininess(), plain.shininess());
            number(to, "mirror", material.mirror(), plain.mirror());
            if (!material.emission().equals(plain.emission())) {
                to.attribute("emission", text(material.emission()));
            }
            number(to, "reflectance", material.reflectance(), plain.reflectance());
            if (material.label() != plain.label()) {
                to.attribute("label", String.valueOf(material.label()));
            }
            Texture texture = material.texture();
            if (texture == null) {
                to.line("/>");
            } else {
                to.line(">");
                write(texture, to);
                to.close("material", 1);
            }
        });
    }

    private static void number(WorldWriter to, String attribute, double value, double usual) {
        if (value != usual) {
            to.attribute(attribute, Decimal.of(value));
        }
    }

    static String text(Color color) {
        return color.isPacked()
                ? color.toString()
                : Decimal.of(color.red()) + " " + Decimal.of(color.green()) + " " + Decimal.of(color.blue());
    }

    private static void write(Texture texture, WorldWriter to) {
        if (texture instanceof Texture.Checker checker) {
            to.open("checker", 2);
            colors(checker.first(), checker.second(), checker.size(), to);
            to.line("/>");
        } else if (texture instanceof Texture.Stripes stripes) {
            to.open("stripes", 2);
            colors(stripes.first(), stripes.second(), stripes.size(), to);
            to.attribute("degrees", Decimal.of(stripes.degrees()));
            to.line("/>");
        } else {
            ImageTexture image = (ImageTexture) texture;
            to.open("image", 2);
            to.attribute("columns", String.valueOf(image.width()));
            to.attribute("rows", String.valueOf(image.height()));
            to.attribute("width", Decimal.of(image.tileWidth()));
            to.attribute("height", Decimal.of(image.tileHeight()));
            to.line(">");
            for (int row = 0; row < image.height(); row++) {
                StringBuilder line = to.indent(3);
                for (int column = 0; column < image.width(); column++) {
                    line.append(column == 0 ? "" : " ").append(Color.text(image.pixel(column, row)));
                }
                to.line("");
            }
            to.close("image", 2);
        }
    }

    private static void colors(Color first, Color second, double size, WorldWriter to) {
        to.attribute("first", text(first));
        to.attribute("second", text(second));
        to.attribute("size", Decimal.of(size));
    }

    /** Writes where the corners of a mesh's faces lie in a picture. */
    static void write(TextureCoordinates coordinates, int depth, WorldWriter to) {
        double[] points = coordinates.points();
        to.open("uv", depth);
        to.line(">");
        for (int k = 0; k < points.length; k += 2) {
            to.indent(depth + 1).append(Decimal.of(points[k])).append(' ').append(Decimal.of(points[k + 1]));
            to.line("");
        }
        to.close("uv", depth);
        to.open("corners", depth);
        to.line(">");
        int[] corners = coordinates.corners();
        for (int k = 0; k < corners.length; k++) {
            (k % 12 == 0 ? to.indent(depth + 1) : to.space()).append(corners[k]);
            if (k % 12 == 11 || k == corners.length - 1) {
                to.line("");
            }
        }
        to.close("corners", depth);
    }
}
