package robosim.geometry.world;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.xml.sax.Attributes;
import org.xml.sax.helpers.AttributesImpl;
import robosim.geometry.material.Texture;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.render.Light;
import robosim.geometry.render.Lighting;
import robosim.geometry.render.Sky;
import robosim.geometry.world.xml.Text;

/** An XML element that is being read: its attributes, where it began, and what its children have yielded so far. */
final class Element {
    final @Nullable Element parent;
    final String namespace;
    final String name;
    final Attributes attributes;
    final int line;
    final int column;

    /** The members of a group, or the one volume of a bounds element. */
    final List<GeometryObject> members = new ArrayList<>();

    /** What is seen of an object; null for its shape. */
    @Nullable
    List<GeometryObject> visuals;

    /** The sky and the lights of a world's light. */
    @Nullable
    Sky sky;

    final List<Light> lights = new ArrayList<>();

    /** What a world shows beside its objects. */
    List<GeometryObject> scenery = List.of();

    /** The light of a world; null for that of a clear day. */
    @Nullable
    Lighting lighting;

    final List<SonarRing> sonars = new ArrayList<>();
    final List<Point> vertices = new ArrayList<>();
    final List<int[]> faces = new ArrayList<>();
    final Text text;

    @Nullable
    GeometryObject bounds;

    /** The {@code <body>} of an object, and the {@code <drive>} of a body. */
    @Nullable
    Element motion;

    /** The pattern of a material. */
    @Nullable
    Texture texture;

    /** The points of a mesh in a picture. */
    double @Nullable [] uv;

    /** By corner of a mesh's faces, the index of its point. */
    int @Nullable [] corners;

    /** The pixels of a picture. */
    int @Nullable [] pixels;

    /** The occupied cells of a grid. */
    @Nullable
    BitSet occupied;

    /** Which elements may be in it, in words; null before one that may not has been found. */
    @Nullable
    String allowed;

    /** Whether it or something in it was refused, so that no object can be made of it. */
    boolean broken;

    Element(@Nullable Element parent, String namespace, String name, Attributes attributes, int line, int column) {
        this.parent = parent;
        this.namespace = namespace;
        this.name = name;
        this.attributes = new AttributesImpl(attributes); // the parser reuses its own
        this.line = line;
        this.column = column;
        this.text = new Text(column);
    }

    /** Whether its content is text, that is, numbers. */
    boolean takesText() {
        return switch (name) {
            case "vertices", "triangles", "quads", "heights", "grid", "uv", "corners", "image" -> true;
            default -> false;
        };
    }

    /** The value of an attribute, or null if it was left out. */
    @Nullable
    String attribute(String attribute) {
        int index = attributes.getIndex("", attribute);
        return index < 0 ? null : attributes.getValue(index);
    }

    String attribute(String attribute, String otherwise) {
        String value = attribute(attribute);
        return value == null ? otherwise : value.strip();
    }

    boolean isTrue(String attribute) {
        String value = attribute(attribute, "false");
        return value.equals("true") || value.equals("1");
    }

    /** The nesting depth of groups for the content of this element. */
    int groups() {
        int around = parent == null ? 0 : parent.groups();
        return name.equals("group") ? around + 1 : around;
    }
}
