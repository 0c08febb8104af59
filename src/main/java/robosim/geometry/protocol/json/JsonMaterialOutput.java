package robosim.geometry.protocol.json;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.Base64;
import org.jspecify.annotations.Nullable;
import robosim.geometry.material.Color;
import robosim.geometry.material.ImageTexture;
import robosim.geometry.material.Material;
import robosim.geometry.material.Texture;
import robosim.geometry.material.TextureCoordinates;

/** Writes materials as JSON: only what differs from the default. */
final class JsonMaterialOutput {
    private final JsonGenerator out;

    JsonMaterialOutput(JsonGenerator out) {
        this.out = out;
    }

    /** Writes the field of an object's material; nothing for the default. */
    void field(Material material) throws IOException {
        if (material.isDefault()) {
            return;
        }
        Material plain = Material.DEFAULT;
        out.writeObjectFieldStart("material");
        if (!material.color().equals(plain.color())) {
            color("color", material.color());
        }
        number("diffuse", material.diffuse(), plain.diffuse());
        number("specular", material.specular(), plain.specular());
        number("shininess", material.shininess(), plain.shininess());
        number("mirror", material.mirror(), plain.mirror());
        if (!material.emission().equals(plain.emission())) {
            color("emission", material.emission());
        }
        texture(material.texture());
        number("reflectance", material.reflectance(), plain.reflectance());
        if (material.label() != plain.label()) {
            out.writeNumberField("label", material.label());
        }
        out.writeEndObject();
    }

    /** Writes the fields of a mesh's texture coordinates; nothing for null. */
    void fields(@Nullable TextureCoordinates coordinates) throws IOException {
        if (coordinates == null) {
            return;
        }
        double[] points = coordinates.points();
        out.writeFieldName("texturePoints");
        out.writeArray(points, 0, points.length);
        int[] corners = coordinates.corners();
        out.writeFieldName("textureCorners");
        out.writeArray(corners, 0, corners.length);
    }

    private void number(String field, double value, double usual) throws IOException {
        if (value != usual) {
            out.writeNumberField(field, value);
        }
    }

    void color(String field, Color color) throws IOException {
        if (color.isPacked()) {
            out.writeStringField(field, color.toString());
        } else {
            out.writeFieldName(field);
            out.writeArray(new double[] {color.red(), color.green(), color.blue()}, 0, 3);
        }
    }

    private void texture(@Nullable Texture texture) throws IOException {
        if (texture == null) {
            return;
        }
        out.writeObjectFieldStart("texture");
        if (texture instanceof Texture.Checker checker) {
            pattern("checker", checker.first(), checker.second(), checker.size());
        } else if (texture instanceof Texture.Stripes stripes) {
            pattern("stripes", stripes.first(), stripes.second(), stripes.size());
            out.writeNumberField("degrees", stripes.degrees());
        } else {
            image((ImageTexture) texture);
        }
        out.writeEndObject();
    }

    private void pattern(String kind, Color first, Color second, double size) throws IOException {
        out.writeStringField("kind", kind);
        color("first", first);
        color("second", second);
        out.writeNumberField("size", size);
    }

    private void image(ImageTexture image) throws IOException {
        out.writeStringField("kind", "image");
        out.writeNumberField("columns", image.width());
        out.writeNumberField("rows", image.height());
        out.writeStringField("pixels", Base64.getEncoder().encodeToString(image.bytes()));
        out.writeNumberField("width", image.tileWidth());
        out.writeNumberField("height", image.tileHeight());
    }
}
