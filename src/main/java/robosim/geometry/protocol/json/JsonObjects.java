package robosim.geometry.protocol.json;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.exact.Degrees;
import robosim.geometry.material.Material;
import robosim.geometry.material.TextureCoordinates;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CapsuleObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.SphereObject;
import robosim.geometry.protocol.MessageLimits;
import robosim.geometry.protocol.ProtocolException;

/** Reads objects from JSON. Their fields come in any order, so all are read before the kind is evaluated. */
final class JsonObjects {
    private static final Fields FIELDS = Fields.of(
            "kind",
            "name moveable center rotation headingDegrees width height length radius vertices faces solid"
                    + " boundingVolume members segment cell columns rows occupied material texturePoints textureCorners"
                    + " heading");

    private static final List<String> COMMON =
            List.of("kind", "name", "moveable", "center", "rotation", "headingDegrees", "heading", "material");

    private static final List<Form> FORMS = List.of(
            Form.of(GeometryObject.Kind.BOX, "box", "center width height length", ""),
            Form.of(GeometryObject.Kind.CYLINDER, "cylinder", "center radius height", ""),
            Form.of(GeometryObject.Kind.SPHERE, "sphere", "center radius", ""),
            Form.of(GeometryObject.Kind.CAPSULE, "capsule", "center radius segment", ""),
            Form.of(
                    GeometryObject.Kind.MESH,
                    "mesh",
                    "vertices faces",
                    "solid boundingVolume texturePoints textureCorners"),
            Form.of(GeometryObject.Kind.GROUP, "group", "members", "boundingVolume"),
            Form.of(GeometryObject.Kind.GRID, "grid", "center cell height columns rows occupied", ""));

    private static final int MAX_VERTICES = MessageLimits.MAX_ARRAY_LENGTH / 3;

    private static final int MAX_CELLS = MessageLimits.MAX_ARRAY_LENGTH * Byte.SIZE;

    private final JsonInput in;
    private final JsonMaterials materials;
    private long parts;

    /** The number of parts of the last object or list read. */
    private long weight;

    JsonObjects(JsonInput in) {
        this.in = in;
        this.materials = new JsonMaterials(in);
    }

    /** The current value as an object beside others of the same message. */
    GeometryObject one() throws IOException {
        GeometryObject made = object();
        add(weight);
        return made;
    }

    /** The current value as a list of objects. */
    List<GeometryObject> list() throws IOException {
        List<GeometryObject> objects = new ArrayList<>();
        long sum = 0;
        in.list();
        while (in.more(objects.size(), MessageLimits.MAX_LIST_LENGTH)) {
            objects.add(object());
            sum += weight;
            add(weight);
        }
        weight = sum;
        return objects;
    }

    private void add(long more) throws ProtocolException {
        parts += more;
        if (parts > MessageLimits.MAX_PARTS) {
            throw in.refused("a message's objects must have at most " + MessageLimits.MAX_PARTS
                    + " parts, counted in every list that contains them (got: more)");
        }
    }

    private GeometryObject object() throws IOException {
        Draft draft = new Draft();
        JsonMembers members = in.object(FIELDS);
        for (int field = members.next(); field >= 0; field = members.next()) {
            read(draft, field);
        }
        checkFields(draft, members);
        GeometryObject made = in.make(draft::make);
        weight = made instanceof GridObject grid ? MessageLimits.parts(grid) : draft.weight;
        return made;
    }

    private void read(Draft draft, int field) throws IOException {
        switch (field) {
            case 0 -> draft.form = form();
            case 1 -> draft.name = in.text();
            case 2 -> draft.moveable = in.flag();
            case 3 -> draft.center = point();
            case 4 -> draft.rotation = in.numbers(9);
            case 5 -> draft.heading = in.numbers(2);
            case 6 -> draft.width = in.number();
            case 7 -> draft.height = in.number();
            case 8 -> draft.length = in.number();
            case 9 -> draft.radius = in.number();
            case 10 -> draft.vertices = vertices();
            case 11 -> {
                draft.faces = faces();
                draft.weight = weight;
            }
            case 12 -> draft.solid = in.flag();
            case 13 -> draft.boundingVolume = object();
            case 14 -> {
                draft.members = list();
                draft.weight = weight;
            }
            case 15 -> draft.segment = in.number();
            case 16 -> draft.cell = in.number();
            case 17 -> draft.columns = (int) in.whole(1, MAX_CELLS);
            case 18 -> draft.rows = (int) in.whole(1, MAX_CELLS);
            case 19 -> draft.occupied = in.base64(1, MessageLimits.MAX_ARRAY_LENGTH);
            case 20 -> draft.material = materials.material();
            case 21 -> draft.texturePoints = texturePoints();
            case 22 -> draft.textureCorners = textureCorners();
            default -> draft.turn = heading(in);
        }
    }

    private void checkFields(Draft draft, JsonMembers members) throws ProtocolException {
        Form form = draft.form;
        for (int field = 0; field < FIELDS.count(); field++) {
            String name = FIELDS.name(field);
            if (members.has(field) ? !form.may.contains(name) : form.must.contains(name)) {
                throw in.refused("a " + form.word + (members.has(field) ? " must not" : " must") + " have the field \""
                        + name + "\"");
            }
        }
        if (draft.turn != null && draft.rotation != null) {
            throw in.refused(
                    "heading and rotation must not both be given; a heading is for what stands upright (got: both)");
        }
        if (draft.heading != null && draft.rotation == null) {
            throw in.refused("headingDegrees must come with the rotation that it belongs to (got: no rotation)");
        }
        if ((draft.texturePoints == null) != (draft.textureCorners == null)) {
            throw in.refused("texturePoints and textureCorners must come together (got: one of them)");
        }
    }

    /** The current value as a heading, of radians. */
    static double heading(JsonInput in) throws IOException {
        double heading = in.number();
        return in.make(() -> {
            Checks.radians("heading", heading);
            return heading;
        });
    }

    Point point() throws IOException {
        double[] numbers = in.numbers(3);
        return in.make(() -> new Point(numbers[0], numbers[1], numbers[2]));
    }

    private List<Point> vertices() throws IOException {
        List<Point> vertices = new ArrayList<>();
        in.list();
        while (in.more(vertices.size(), MAX_VERTICES)) {
            vertices.add(point());
        }
        return vertices;
    }

    private int[][] faces() throws IOException {
        List<int[]> faces = new ArrayList<>();
        long triangles = 0;
        in.list();
        while (in.more(faces.size(), MessageLimits.MAX_LIST_LENGTH)) {
            int[] face = face();
            faces.add(face);
            triangles += face.length - 2;
        }
        weight = triangles;
        add(triangles);
        return faces.toArray(int[][]::new);
    }

    private double[] texturePoints() throws IOException {
        double[] points = new double[2];
        int count = 0;
        in.list();
        while (in.more(count, MessageLimits.MAX_ARRAY_LENGTH)) {
            points = count < points.length ? points : Arrays.copyOf(points, 2 * count);
            points[count++] = in.number();
        }
        return Arrays.copyOf(points, count);
    }

    private int[] textureCorners() throws IOException {
        int[] corners = new int[4];
        int count = 0;
        in.list();
        while (in.more(count, MessageLimits.MAX_ARRAY_LENGTH)) {
            corners = count < corners.length ? corners : Arrays.copyOf(corners, 2 * count);
            corners[count++] = (int) in.whole(TextureCoordinates.NONE, MessageLimits.MAX_ARRAY_LENGTH / 2 - 1L);
        }
        return Arrays.copyOf(corners, count);
    }

    private int[] face() throws IOException {
        int[] corners = new int[4];
        int count = 0;
        in.list();
        while (in.more(count, 4)) {
            corners[count++] = (int) in.whole(0, MAX_VERTICES - 1L);
        }
        if (count < 3) {
            throw in.refused("a face must have 3 or 4 corners (got: " + count + ")");
        }
        return Arrays.copyOf(corners, count);
    }

    /** The name of a kind of object, and its required and optional fields. */
    private record Form(GeometryObject.Kind kind, String word, List<String> must, List<String> may) {
        static Form of(GeometryObject.Kind kind, String word, String must, String more) {
            List<String> may = new ArrayList<>(COMMON);
            may.addAll(List.of((must + " " + more).trim().split(" ")));
            return new Form(kind, word, List.of(must.split(" ")), List.copyOf(may));
        }
    }

    private Form form() throws IOException {
        String text = in.text();
        for (Form form : FORMS) {
            if (form.word.equals(text)) {
                return form;
            }
        }
        throw in.refused("must be box, cylinder, sphere, capsule, mesh, group or grid (got: " + in.told(text) + ")");
    }

    /** The fields of an object read so far. */
    private static final class Draft {
        private Form form = FORMS.get(0);
        private long weight = 1;
        private @Nullable String name;
        private @Nullable Double turn;
        private boolean moveable;
        private Point center = new Point();
        private double @Nullable [] rotation;
        private double @Nullable [] heading;
        private double width;
        private double height;
        private double length;
        private double radius;
        private double segment;
        private double cell;
        private int columns;
        private int rows;
        private byte[] occupied = {};
        private List<Point> vertices = List.of();
        private int[][] faces = {};
        private boolean solid;
        private @Nullable GeometryObject boundingVolume;
        private List<GeometryObject> members = List.of();
        private Material material = Material.DEFAULT;
        private double @Nullable [] texturePoints;
        private int @Nullable [] textureCorners;

        GeometryObject make() {
            GeometryObject placed = shape().at(pose()).withMaterial(material);
            if (moveable) {
                if (name == null) {
                    throw new IllegalArgumentException("name must be given for a moveable object (got: none)");
                }
                return placed.moveable(name);
            }
            return name == null ? placed : placed.named(name);
        }

        private GeometryObject shape() {
            return switch (form.kind) {
                case BOX -> new BoxObject(center, width, height, length);
                case CYLINDER -> new CylinderObject(center, radius, height);
                case SPHERE -> new SphereObject(center, radius);
                case CAPSULE -> new CapsuleObject(center, radius, segment);
                case MESH -> mesh();
                case GROUP -> new ObjectGroup(members, boundingVolume);
                case GRID -> GridObject.of(center, cell, height, columns, rows, occupied);
            };
        }

        private MeshObject mesh() {
            MeshObject surface = boundingVolume == null
                    ? new MeshObject(vertices, faces)
                    : new MeshObject(vertices, faces, boundingVolume);
            if (texturePoints != null && textureCorners != null) {
                surface = surface.withTextureCoordinates(new TextureCoordinates(texturePoints, textureCorners));
            }
            return solid ? surface.solid() : surface;
        }

        private Pose pose() {
            if (rotation == null) {
                return Pose.of(center, turn == null ? 0 : Degrees.toDegrees(turn));
            }
            return heading == null
                    ? Pose.of(center, 0).oriented(rotation)
                    : Pose.of(center, rotation, heading[0], heading[1]);
        }
    }
}
