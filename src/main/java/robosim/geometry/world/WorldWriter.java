package robosim.geometry.world;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.BitSet;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;
import java.util.function.LongConsumer;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.dynamics.Drive;
import robosim.geometry.exact.Attitude;
import robosim.geometry.material.Color;
import robosim.geometry.material.Material;
import robosim.geometry.material.TextureCoordinates;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.render.Light;
import robosim.geometry.render.Lighting;
import robosim.geometry.render.Sky;
import robosim.geometry.world.body.BodyXml;
import robosim.geometry.world.body.ObjectBody;
import robosim.geometry.world.shared.AtomicFileWriter;
import robosim.geometry.world.shared.Decimal;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.Limits;
import robosim.geometry.world.xml.GridRuns;

/**
 * Writes a world as XML that reads back to an equal one. The same world always gives the same text.
 *
 * <p>Numbers are in world units, in the shortest form that is exact. An attitude is written as a heading with its
 * rounding error if that gives the same rotation to the bit, and as nine numbers otherwise, so an object that was
 * written and read back continues to turn exactly as before. Meshes are written inline, even those that came from a
 * file.
 */
public final class WorldWriter {
    /** The namespace of the format. */
    public static final String NAMESPACE = "urn:robosim:world:1";

    private final StringBuilder out = new StringBuilder();
    private final long most;
    private Map<Material, String> materials = Map.of();

    /** @param most maximum number of characters, at which it gives up */
    private WorldWriter(long most) {
        this.most = most;
    }

    /** Thrown if the text is longer than allowed. */
    private static final class TooLong extends RuntimeException {
        private static final long serialVersionUID = 1;
    }

    /**
     * Writes a world file atomically: an existing file stays as it was until the new one is complete.
     *
     * @throws WorldException if the file cannot be written, or would exceed the maximum size of a file that is read
     * @throws IllegalArgumentException as {@link #toXml} does
     */
    public static void write(World world, Path file) throws WorldException {
        write(world, file, Limits.MAX_BYTES);
    }

    /** @param most maximum size of the file, bytes */
    static void write(World world, Path file, long most) throws WorldException {
        Checks.present("world", world);
        Checks.present("file", file);
        byte[] bytes = bytes(world, most);
        if (bytes.length == 0) {
            throw new WorldException(new FileProblem(
                    file.toString(),
                    "a world file must have at most " + most + " bytes, or it could not be read back; write an .obj"
                            + " file instead, or keep large meshes in separate files (got: more)"));
        }
        try {
            AtomicFileWriter.write(file, out -> out.write(bytes));
        } catch (IOException e) {
            throw new WorldException(new FileProblem(file.toString(), "the file could not be written: " + e, e));
        }
    }

    /** The bytes of a file; empty if there would be more than {@code most}. */
    private static byte[] bytes(World world, long most) {
        WorldWriter writer = new WorldWriter(most);
        try {
            writer.world(world);
        } catch (TooLong e) {
            return new byte[0];
        }
        // Each character takes at least one byte.
        byte[] bytes = writer.out.toString().getBytes(StandardCharsets.UTF_8);
        return bytes.length > most ? new byte[0] : bytes;
    }

    /**
     * Writes the surfaces of a world as a Wavefront OBJ file, for display in other programs: world units, Y up, an {@code o}
     * for each object. Boxes, meshes and the cells of a grid are exact to within rounding. A cylinder has 48 flat sides, and a
     * sphere or capsule as many around; their corners are on the true surface, so round shapes are slightly too small.
     *
     * <p>Where objects have materials, an MTL file of the same name is written beside it, with a PNG file for each picture. A
     * checker or stripes, and a picture on anything but a mesh with texture coordinates, are only a colour there. An existing
     * file stays as it was until the new one is complete.
     *
     * @param progress called from time to time with the number of objects written
     * @throws WorldException if the file cannot be written
     */
    public static void writeObj(World world, Path file, LongConsumer progress) throws WorldException {
        ObjWriter.write(world, file, progress);
    }

    /**
     * A world as the text of its file.
     *
     * @throws IllegalArgumentException if XML cannot express it: a name with a character that XML does not allow or of
     *     more than 1000 characters, groups more than 50 deep, or grids of more than 16,777,216 cells together
     */
    public static String toXml(World world) {
        Checks.present("world", world);
        WorldWriter writer = new WorldWriter(Long.MAX_VALUE);
        writer.world(world);
        return writer.out.toString();
    }

    private void world(World world) {
        out.append("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<world xmlns=\"")
                .append(NAMESPACE)
                .append('"');
        number("width", world.width());
        number("height", world.height());
        number("length", world.length());
        Unit unit = world.unit();
        if (unit != null) {
            attribute("unit", unit.symbol());
        }
        attribute("dimension", world.dimension().name());
        attribute("accuracy", world.accuracy().name());
        out.append(">\n");
        materials = WorldMaterials.named(world);
        WorldMaterials.write(materials, this);
        lighting(world.lighting());
        if (!world.scenery().isEmpty()) {
            shapes("scenery", world.scenery(), 1);
        }
        long cells = 0;
        for (WorldObject object : world.objects()) {
            if (object.object() instanceof GridObject grid) {
                cells += (long) grid.columns() * grid.rows();
            }
        }
        if (cells > Limits.MAX_CELLS) {
            throw new IllegalArgumentException("the grids of a world file must have at most " + Limits.MAX_CELLS
                    + " cells together; use larger cells (got: " + cells + ")");
        }
        for (WorldObject object : world.objects()) {
            object(object.object(), object.color(), object.sonars(), object.body(), object.attached(), 1);
        }
        out.append("</world>\n");
    }

    /** Writes the light of a world; nothing for that of a clear day. */
    private void lighting(@Nullable Lighting lighting) {
        if (lighting == null) {
            return;
        }
        open("lighting", 1);
        line(">");
        Sky sky = lighting.sky();
        open("sky", 2);
        attribute("zenith", WorldMaterials.text(sky.zenith()));
        attribute("horizon", WorldMaterials.text(sky.horizon()));
        attribute("ground", WorldMaterials.text(sky.ground()));
        number("strength", sky.strength());
        Color even = sky.light();
        if (even != null) {
            attribute("light", WorldMaterials.text(even));
        }
        line("/>");
        lighting.lights().forEach(this::light);
        close("lighting", 1);
    }

    private void light(Light light) {
        if (light instanceof Light.Sun sun) {
            open("sun", 2);
            attribute("direction", text(sun.direction()));
        } else if (light instanceof Light.Spot spot) {
            open("spot", 2);
            attribute("center", text(spot.place()));
            attribute("direction", text(spot.direction()));
            number("angle", spot.degrees());
            falloff(spot.falloff());
        } else {
            Light.Lamp lamp = (Light.Lamp) light;
            open("lamp", 2);
            attribute("center", text(lamp.place()));
            falloff(lamp.falloff());
        }
        attribute("color", WorldMaterials.text(light.color()));
        number("strength", light.strength());
        if (light.shadows() == Light.Shadows.NONE) {
            attribute("shadows", "none");
        }
        line("/>");
    }

    private void falloff(Light.Falloff falloff) {
        if (falloff.range() < Double.POSITIVE_INFINITY) {
            number("range", falloff.range());
        }
        if (falloff.constant() != 0 || falloff.linear() != 0 || falloff.quadratic() != 1) {
            number("constant", falloff.constant());
            number("linear", falloff.linear());
            number("quadratic", falloff.quadratic());
        }
    }

    private static String text(Point point) {
        return Decimal.of(point.x()) + " " + Decimal.of(point.y()) + " " + Decimal.of(point.z());
    }

    private void shapes(String tag, List<GeometryObject> shapes, int depth) {
        open(tag, depth);
        line(">");
        for (GeometryObject shape : shapes) {
            object(shape, WorldMaterials.colorOf(shape), List.of(), null, null, depth + 1);
        }
        close(tag, depth);
    }

    private void object(
            GeometryObject object,
            @Nullable String color,
            List<SonarRing> sonars,
            @Nullable ObjectBody body,
            @Nullable String attached,
            int depth) {
        if (depth > Limits.MAX_GROUPS + 1) {
            throw new IllegalArgumentException(
                    "groups must be nested at most " + Limits.MAX_GROUPS + " deep; nest less (got: one more)");
        }
        String tag = object.kind().word();
        indent(depth).append('<').append(tag);
        placed(object);
        if (attached != null) {
            attribute("attached", attached);
        }
        size(object);
        if (color != null) {
            attribute("color", color);
        }
        if (!WorldMaterials.isToldBy(object.material(), color)) {
            attribute("material", materials.getOrDefault(object.material(), ""));
        }
        int begin = out.append(">\n").length();
        content(object, depth + 1);
        List<GeometryObject> visuals = object.visuals();
        if (visuals != null) {
            shapes("visual", visuals, depth + 1);
        }
        for (SonarRing sonar : sonars) {
            sonar(sonar, depth + 1);
        }
        if (body != null) {
            open("body", depth + 1);
            BodyXml.write(body, this::attribute);
            Drive drive = body.drive();
            line(drive == null ? "/>" : ">");
            if (drive != null) {
                open("drive", depth + 2);
                BodyXml.write(drive, this::attribute);
                line("/>");
                close("body", depth + 1);
            }
        }
        if (out.length() == begin) {
            out.setLength(begin - 2);
            out.append("/>\n");
        } else {
            indent(depth).append("</").append(tag).append(">\n");
        }
    }

    private void placed(GeometryObject object) {
        String name = object.name();
        if (name != null) {
            attribute("name", name);
        }
        if (object.isMoveable()) {
            attribute("moveable", "true");
        }
        if (!object.layers().isEmpty()) {
            attribute("layers", String.join(" ", new TreeSet<>(object.layers())));
        }
        Pose pose = object.pose();
        Point center = pose.center();
        if (!center.equals(new Point())) {
            attribute("center", text(center));
        }
        double heading = pose.heading();
        double lost = pose.lostHeading();
        // A heading is more than its rotation: later turns add to it and to its rounding error.
        double[] made = Attitude.identity();
        Attitude.setHeading(made, 0, heading, lost);
        if (!Pose.of(center, made, 0).equals(pose)) {
            StringBuilder numbers = new StringBuilder();
            for (int k = 0; k < 9; k++) {
                numbers.append(k == 0 ? "" : " ").append(Decimal.of(pose.rotation(k)));
            }
            attribute("rotation", numbers.toString());
        } else if (lost != 0) {
            attribute("heading", Decimal.of(heading) + " " + Decimal.of(lost));
        } else if (heading != 0) {
            number("heading", heading);
        }
    }

    private void size(GeometryObject object) {
        double[] sizes = object.sizes();
        for (int k = 0; k < sizes.length; k++) {
            number(object.kind().sizes().get(k), sizes[k]);
        }
        if (object instanceof MeshObject mesh && mesh.isSolid()) {
            attribute("solid", "true");
        } else if (object instanceof GridObject grid) {
            number("cell", grid.cell());
            number("height", grid.height());
            number("columns", grid.columns());
            number("rows", grid.rows());
        }
    }

    private void content(GeometryObject object, int depth) {
        if (object instanceof MeshObject mesh) {
            bounds(mesh.boundingVolume(), depth);
            surface(mesh, depth);
            TextureCoordinates coordinates = mesh.textureCoordinates();
            if (coordinates != null) {
                WorldMaterials.write(coordinates, depth, this);
            }
        } else if (object instanceof ObjectGroup group) {
            bounds(group.boundingVolume(), depth);
            for (GeometryObject member : group.members()) {
                object(member, WorldMaterials.colorOf(member), List.of(), null, null, depth);
            }
        } else if (object instanceof GridObject grid) {
            BitSet occupied = grid.occupied();
            for (int row = 0; row < grid.rows(); row++) {
                GridRuns.write(grid, occupied, row, indent(depth));
                out.append('\n');
            }
        }
    }

    private void bounds(@Nullable GeometryObject volume, int depth) {
        if (volume != null) {
            indent(depth).append("<bounds>\n");
            object(volume, WorldMaterials.colorOf(volume), List.of(), null, null, depth + 1);
            indent(depth).append("</bounds>\n");
        }
    }

    private void surface(MeshObject mesh, int depth) {
        indent(depth).append("<vertices>\n");
        for (Point vertex : mesh.vertices()) {
            indent(depth + 1).append(Decimal.of(vertex.x())).append(' ');
            out.append(Decimal.of(vertex.y())).append(' ');
            out.append(Decimal.of(vertex.z())).append('\n');
        }
        indent(depth).append("</vertices>\n");
        int size = 0; // of the faces in the current run
        for (int[] face : mesh.faces()) {
            if (face.length != size) {
                closeRun(size, depth);
                indent(depth).append('<').append(run(face.length)).append(">\n");
                size = face.length;
            }
            indent(depth + 1).append(face[0]);
            for (int k = 1; k < size; k++) {
                out.append(' ').append(face[k]);
            }
            out.append('\n');
        }
        closeRun(size, depth);
    }

    private void closeRun(int size, int depth) {
        if (size > 0) {
            indent(depth).append("</").append(run(size)).append(">\n");
        }
    }

    private static String run(int size) {
        return size == 3 ? "triangles" : "quads";
    }

    private void sonar(SonarRing sonar, int depth) {
        indent(depth).append("<sonar count=\"").append(sonar.count()).append('"');
        number("first", sonar.first());
        number("step", sonar.step());
        number("min", sonar.min());
        if (sonar.max() < Double.POSITIVE_INFINITY) {
            number("max", sonar.max());
        }
        number("width", sonar.width());
        out.append("/>\n");
    }

    /** Begins a tag. */
    void open(String tag, int depth) {
        indent(depth).append('<').append(tag);
    }

    /** Writes the end of an element. */
    void close(String tag, int depth) {
        indent(depth).append("</").append(tag).append(">\n");
    }

    /** Ends a line. */
    void line(String end) {
        out.append(end).append('\n');
    }

    StringBuilder space() {
        return out.append(' ');
    }

    StringBuilder indent(int depth) {
        if (out.length() > most) {
            throw new TooLong();
        }
        return out.append("  ".repeat(depth));
    }

    private void number(String attribute, double value) {
        attribute(attribute, Decimal.of(value));
    }

    void attribute(String attribute, String value) {
        if (value.length() > Limits.MAX_ATTRIBUTE) {
            throw new IllegalArgumentException(attribute + " must have at most " + Limits.MAX_ATTRIBUTE
                    + " characters; shorten it (got: " + value.length() + ")");
        }
        out.append(' ').append(attribute).append("=\"");
        value.codePoints().forEach(c -> character(attribute, c));
        out.append('"');
    }

    private void character(String attribute, int c) {
        switch (c) {
            case '&' -> out.append("&amp;");
            case '<' -> out.append("&lt;");
            case '"' -> out.append("&quot;");
            case '\t', '\n', '\r' -> out.append("&#").append(c).append(';'); // otherwise they would be read as spaces
            default -> {
                // XML 1.0, production 2
                boolean legal = (c >= 0x20 && c < 0xd800) || (c >= 0xe000 && c <= 0xfffd) || c >= 0x10000;
                if (!legal) {
                    throw new IllegalArgumentException(attribute + " must have only characters that XML allows (got: U+"
                            + Integer.toHexString(c) + ")");
                }
                out.appendCodePoint(c);
            }
        }
    }
}
