package robosim.geometry.export;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import robosim.geometry.exact.Degrees;
import robosim.geometry.image.PngWriter;
import robosim.geometry.material.Color;
import robosim.geometry.material.ImageTexture;
import robosim.geometry.material.Material;
import robosim.geometry.material.Texture;

/** The materials of a glTF file, with their pictures, which are in the file. */
final class GlbMaterials {
    /** glTF's constants: the nearest pixel; a mean of pixels, near and far. */
    private static final int NEAREST = 9728;

    private static final int LINEAR = 9729;
    private static final int MIPMAPS = 9987;

    private final PackedStream numbers;
    private final List<String> views;
    private final Map<String, Integer> materials = new LinkedHashMap<>();
    private final Map<Object, Integer> known = new HashMap<>();
    private final List<String> textures = new ArrayList<>();
    private final List<String> images = new ArrayList<>();

    /** The pixels of a picture without its size on a surface. */
    private record Pixels(ImageTexture image) {}

    private record TwoColours(int first, int second, boolean areSquares) {}

    /**
     * Materials of a file.
     *
     * @param numbers its binary part
     * @param views   the parts of that
     */
    GlbMaterials(PackedStream numbers, List<String> views) {
        this.numbers = numbers;
        this.views = views;
    }

    /** The number of a material. Shown from both sides, as a mesh may be a mere surface. */
    int number(Material material) {
        Texture texture = material.texture();
        Color color = texture == null ? material.color() : Color.WHITE;
        double diffuse = material.diffuse();
        StringBuilder json = new StringBuilder("{\"pbrMetallicRoughness\":{\"baseColorFactor\":")
                .append(List.of(
                        diffuse * color.linearRed(), diffuse * color.linearGreen(), diffuse * color.linearBlue(), 1.0));
        if (texture != null) {
            json.append(",\"baseColorTexture\":{\"index\":")
                    .append(texture(texture))
                    .append('}');
        }
        json.append(",\"metallicFactor\":")
                .append(material.mirror())
                .append(",\"roughnessFactor\":")
                .append(roughness(material))
                .append('}');
        Color glow = material.emission();
        if (!glow.equals(Color.BLACK)) {
            json.append(",\"emissiveFactor\":")
                    .append(List.of(glow.linearRed(), glow.linearGreen(), glow.linearBlue()));
        }
        return numberOf(materials, json.append(",\"doubleSided\":true}").toString());
    }

    private static int numberOf(Map<String, Integer> all, String json) {
        Integer number = all.get(json);
        if (number == null) {
            number = all.size();
            all.put(json, number);
        }
        return number;
    }

    /**
     * As rough as a surface whose highlight is as wide: glTF's square of the roughness is the square root of 2 / (n + 2) of a highlight
     * of exponent n. What has no highlight is rough, and what mirrors is as smooth as it mirrors.
     */
    private static double roughness(Material material) {
        double rough = material.specular() == 0 ? 1 : Math.sqrt(Math.sqrt(2 / (material.shininess() + 2)));
        return rough * (1 - material.mirror());
    }

    /** The number of a picture with the way it is looked at. */
    private int texture(Texture texture) {
        if (texture instanceof ImageTexture image) {
            return texture(new Pixels(image.tiled(1, 1)), image.width(), image.height(), image.pixels());
        }
        if (texture instanceof Texture.Checker checker) {
            int first = checker.first().packed();
            int second = checker.second().packed();
            return texture(new TwoColours(first, second, true), 2, 2, new int[] {second, first, first, second});
        }
        Texture.Stripes stripes = (Texture.Stripes) texture;
        int first = stripes.first().packed();
        int second = stripes.second().packed();
        return texture(new TwoColours(first, second, false), 2, 1, new int[] {first, second});
    }

    private int texture(Object key, int width, int height, int[] pixels) {
        Integer number = known.get(key);
        if (number == null) {
            number = textures.size();
            known.put(key, number);
            textures.add("{\"sampler\":" + (key instanceof Pixels ? 0 : 1) + ",\"source\":" + images.size() + "}");
            images.add("{\"bufferView\":" + views.size() + ",\"mimeType\":\"image/png\"}");
            byte[] png = png(width, height, pixels);
            views.add("{\"buffer\":0,\"byteOffset\":" + numbers.size() + ",\"byteLength\":" + png.length + "}");
            numbers.append(png);
            while (numbers.size() % 4 != 0) { // numbers begin at multiples of their size
                numbers.octet(0);
            }
        }
        return number;
    }

    private static byte[] png(int width, int height, int[] pixels) {
        ByteArrayOutputStream png = new ByteArrayOutputStream();
        try {
            PngWriter.writeColour(png, width, height, pixels);
        } catch (IOException e) {
            throw new UncheckedIOException(e); // memory does not fail
        }
        return png.toByteArray();
    }

    List<String> materials() {
        return List.copyOf(materials.keySet());
    }

    List<String> textures() {
        return textures;
    }

    List<String> images() {
        return images;
    }

    /** Pictures are smooth; squares and stripes have sharp edges. */
    List<String> samplers() {
        return textures.isEmpty()
                ? List.of()
                : List.of(
                        "{\"magFilter\":" + LINEAR + ",\"minFilter\":" + MIPMAPS + "}",
                        "{\"magFilter\":" + NEAREST + ",\"minFilter\":" + MIPMAPS + "}");
    }

    /**
     * How the plane of a texture, in world units, becomes shares of its picture: u = uS s + uT t, v = 1 - vT t.
     */
    record Mapping(double uS, double uT, double vT) {
        /** Of places that are shares of the picture. */
        static final Mapping SHARES = new Mapping(1, 0, 1);

        /** Of a texture; null for none. */
        static @Nullable Mapping of(@Nullable Texture texture) {
            if (texture instanceof ImageTexture image) {
                return new Mapping(1 / image.tileWidth(), 0, 1 / image.tileHeight());
            }
            if (texture instanceof Texture.Checker checker) {
                return new Mapping(0.5 / checker.size(), 0, 0.5 / checker.size());
            }
            if (texture instanceof Texture.Stripes stripes) {
                double each = 0.5 / stripes.size();
                return new Mapping(-Degrees.sin(stripes.degrees()) * each, Degrees.cos(stripes.degrees()) * each, 0);
            }
            return null;
        }

        /** Two shares for each vertex, from its place in the plane. */
        float[] shares(double[] places) {
            float[] shares = new float[places.length];
            for (int k = 0; k < places.length; k += 2) {
                shares[k] = (float) (uS * places[k] + uT * places[k + 1] + 0.0);
                shares[k + 1] = (float) (1 - vT * places[k + 1]);
            }
            return shares;
        }
    }
}
