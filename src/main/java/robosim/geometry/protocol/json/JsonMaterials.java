package robosim.geometry.protocol.json;

import java.io.IOException;
import java.util.HashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import robosim.geometry.material.Color;
import robosim.geometry.material.ImageTexture;
import robosim.geometry.material.Material;
import robosim.geometry.material.Texture;
import robosim.geometry.protocol.MessageLimits;

/** Reads materials from JSON. What a material leaves out is that of the default. */
final class JsonMaterials {
    private static final Fields MATERIAL =
            Fields.of("", "color diffuse specular shininess mirror emission texture reflectance label");
    private static final Fields TEXTURE =
            Fields.of("kind", "first second size degrees columns rows pixels width height");
    private static final JsonKinds TEXTURES = new JsonKinds(
            TEXTURE,
            new String[] {"checker", "first second size", ""},
            new String[] {"stripes", "first second size degrees", ""},
            new String[] {"image", "columns rows pixels width height", ""});

    /** The most pixels of a picture, which has three bytes for each. A line cannot have more than {@link MessageLimits#MAX_PIXELS}. */
    private static final int MAX_PIXELS = MessageLimits.MAX_ARRAY_LENGTH / 3;

    private final JsonInput in;

    /** The pictures of the message, so that equal ones share their pixels. */
    private final Map<ImageTexture, ImageTexture> images = new HashMap<>();

    JsonMaterials(JsonInput in) {
        this.in = in;
    }

    /** The current value as a material. */
    Material material() throws IOException {
        Material[] made = {Material.DEFAULT};
        var members = in.object(MATERIAL);
        for (int field = members.next(); field >= 0; field = members.next()) {
            made[0] = with(made[0], field);
        }
        return made[0];
    }

    private Material with(Material material, int field) throws IOException {
        if (field == 0 || field == 5) {
            Color color = color();
            return field == 0 ? material.withColor(color) : material.withEmission(color);
        }
        if (field == 6) {
            return material.withTexture(texture());
        }
        if (field == 8) {
            return material.withLabel((int) in.whole(0, Integer.MAX_VALUE));
        }
        double number = in.number();
        return in.make(() -> switch (field) {
            case 1 -> material.withDiffuse(number);
            case 2 -> material.withSpecular(number);
            case 3 -> material.withShininess(number);
            case 4 -> material.withMirror(number);
            default -> material.withReflectance(number);
        });
    }

    /** A text {@code #rrggbb}, or a list of three numbers. */
    Color color() throws IOException {
        if (in.isText()) {
            String text = in.text();
            return in.make(() -> Color.parse(text));
        }
        double[] shares = in.numbers(3);
        return in.make(() -> new Color(shares[0], shares[1], shares[2]));
    }

    /** The fields of a texture, as far as they are read. */
    private static final class Draft {
        private int kind;
        private Color first = Color.BLACK;
        private Color second = Color.WHITE;
        private double size;
        private double degrees;
        private int columns;
        private int rows;
        private byte @Nullable [] pixels;
        private double width;
        private double height;

        private Texture make() {
            return switch (kind) {
                case 0 -> new Texture.Checker(first, second, size);
                case 1 -> new Texture.Stripes(first, second, size, degrees);
                default -> ImageTexture.of(columns, rows, pixels == null ? new byte[0] : pixels, width, height);
            };
        }
    }

    private Texture texture() throws IOException {
        Draft draft = new Draft();
        var members = in.object(TEXTURE);
        for (int field = members.next(); field >= 0; field = members.next()) {
            switch (field) {
                case 0 -> draft.kind = TEXTURES.read(in);
                case 1 -> draft.first = color();
                case 2 -> draft.second = color();
                case 3 -> draft.size = in.number();
                case 4 -> draft.degrees = in.number();
                case 5 -> draft.columns = (int) in.whole(1, MAX_PIXELS);
                case 6 -> draft.rows = (int) in.whole(1, MAX_PIXELS);
                case 7 -> draft.pixels = in.base64(3, MAX_PIXELS);
                case 8 -> draft.width = in.number();
                default -> draft.height = in.number();
            }
        }
        TEXTURES.check(in, draft.kind, members::has);
        Texture made = in.make(draft::make);
        return made instanceof ImageTexture image ? images.computeIfAbsent(image, same -> same) : made;
    }
}
