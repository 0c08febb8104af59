package robosim.geometry.protocol.json;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import robosim.geometry.exact.Degrees;
import robosim.geometry.index.meshes.TriangleMesh;
import robosim.geometry.material.ImageTexture;
import robosim.geometry.material.Material;
import robosim.geometry.material.Texture;
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

/** Objects and their materials as JSON. */
final class JsonShapes {
    private static final int MAX_VERTICES = MessageLimits.MAX_ARRAY_LENGTH / 3;

    /** The most pixels of a picture, which has three bytes for each. A line cannot have more than {@link MessageLimits#MAX_PIXELS}. */
    private static final int MAX_PIXELS = MessageLimits.MAX_ARRAY_LENGTH / 3;

    private static final JsonForm<Integer> CELLS = JsonForm.whole(1, MessageLimits.MAX_ARRAY_LENGTH * Byte.SIZE);

    private static final JsonKinds<Texture> TEXTURES = JsonKinds.tagged(
            "",
            JsonKinds.kind("checker", JsonObject.of(Texture.Checker.class)),
            JsonKinds.kind("stripes", JsonObject.of(Texture.Stripes.class)),
            JsonKinds.kind(
                    "image",
                    ImageTexture.class,
                    JsonObject.of(Image.class)
                            .form("columns rows", JsonForm.whole(1, MAX_PIXELS))
                            .form("pixels", JsonForm.bytes(3, MAX_PIXELS))
                            .as(Image::texture, Image::of)));

    private static final JsonForm<Texture> TEXTURE = JsonForm.of(
            in -> {
                Texture made = TEXTURES.read(in);
                return made instanceof ImageTexture image ? in.shared(image) : made;
            },
            TEXTURES::write);

    private static final JsonObject<Material> MATERIAL = JsonObject.of(Material.class)
            .omitting(Material.DEFAULT.color(), "color")
            .omitting(Material.DEFAULT.diffuse(), "diffuse")
            .omitting(Material.DEFAULT.specular(), "specular")
            .omitting(Material.DEFAULT.shininess(), "shininess")
            .omitting(Material.DEFAULT.mirror(), "mirror")
            .omitting(Material.DEFAULT.emission(), "emission")
            .form("texture", TEXTURE)
            .omitting(null, "texture")
            .omitting(Material.DEFAULT.reflectance(), "reflectance")
            .omitting(Material.DEFAULT.label(), "label");

    private static final JsonObject<Placed> PLACED = JsonObject.of(Placed.class)
            .omitting(null, "name")
            .omitting(false, "moveable")
            .form("rotation", JsonForm.numbers(9))
            .form("headingDegrees", JsonForm.numbers(2))
            .form("heading", JsonForm.HEADING)
            .omitting(null, "rotation headingDegrees heading")
            .form("material", MATERIAL)
            .omitting(Material.DEFAULT, "material")
            .omitting(List.of(), "layers");

    /** Of what has a frame of its own, which is at the origin unless a centre is given. */
    private static final JsonObject<Placed> IN_FRAME = PLACED.optional(new Point(), "center");

    private static final JsonKinds<GeometryObject> KINDS = JsonKinds.tagged(
            "a",
            JsonKinds.kind(
                    "box",
                    BoxObject.class,
                    JsonObject.of(Box.class).inline("placed", PLACED).as(Box::made, Box::of)),
            JsonKinds.kind(
                    "cylinder",
                    CylinderObject.class,
                    JsonObject.of(Cylinder.class).inline("placed", PLACED).as(Cylinder::made, Cylinder::of)),
            JsonKinds.kind(
                    "sphere",
                    SphereObject.class,
                    JsonObject.of(Sphere.class).inline("placed", PLACED).as(Sphere::made, Sphere::of)),
            JsonKinds.kind(
                    "capsule",
                    CapsuleObject.class,
                    JsonObject.of(Capsule.class).inline("placed", PLACED).as(Capsule::made, Capsule::of)),
            JsonKinds.kind(
                    "mesh",
                    MeshObject.class,
                    JsonObject.of(Mesh.class)
                            .inline("placed", IN_FRAME)
                            .form("vertices", JsonForm.list(JsonForm.POINT, MAX_VERTICES))
                            .form("faces", JsonForm.of(JsonShapes::faces, JsonShapes::write))
                            .form("texturePoints", JsonForm.doubles(MessageLimits.MAX_ARRAY_LENGTH))
                            .form(
                                    "textureCorners",
                                    JsonForm.wholes(
                                            MessageLimits.MAX_ARRAY_LENGTH,
                                            TextureCoordinates.NONE,
                                            MessageLimits.MAX_ARRAY_LENGTH / 2 - 1))
                            .omitting(false, "solid")
                            .form("boundingVolume", JsonForm.of(JsonShapes::read, JsonShapes::write))
                            .omitting(null, "texturePoints textureCorners boundingVolume")
                            .as(Mesh::made, Mesh::of)),
            JsonKinds.kind(
                    "group",
                    ObjectGroup.class,
                    JsonObject.of(Group.class)
                            .inline("placed", IN_FRAME)
                            .form("members", JsonForm.list(JsonForm.of(JsonShapes::readCounted, JsonShapes::write)))
                            .form("boundingVolume", JsonForm.of(JsonShapes::read, JsonShapes::write))
                            .omitting(null, "boundingVolume")
                            .as(Group::made, Group::of)),
            JsonKinds.kind(
                    "grid",
                    GridObject.class,
                    JsonObject.of(Grid.class)
                            .inline("placed", PLACED)
                            .form("columns rows", CELLS)
                            .form("occupied", JsonForm.bytes(1, MessageLimits.MAX_ARRAY_LENGTH))
                            .as(Grid::made, Grid::of)));

    /** An object, whose parts are counted among those of its message. */
    static final JsonForm<GeometryObject> OBJECT = JsonForm.of(JsonShapes::readCounted, JsonShapes::write);

    private JsonShapes() {}

    private static GeometryObject read(JsonInput in) throws IOException {
        return KINDS.read(in);
    }

    private static void write(JsonGenerator out, GeometryObject object) throws IOException {
        KINDS.write(out, object);
    }

    private static GeometryObject readCounted(JsonInput in) throws IOException {
        GeometryObject made = KINDS.read(in);
        in.addParts(parts(made));
        return made;
    }

    private static long parts(GeometryObject object) {
        if (object instanceof ObjectGroup group) {
            return group.members().stream().mapToLong(JsonShapes::parts).sum();
        }
        return object instanceof MeshObject mesh
                ? mesh.triangles().size()
                : object instanceof GridObject grid ? MessageLimits.parts(grid) : 1;
    }

    private static int[][] faces(JsonInput in) throws IOException {
        List<int[]> faces = new ArrayList<>();
        long triangles = 0;
        in.list();
        while (in.more(faces.size(), MessageLimits.MAX_LIST_LENGTH)) {
            int[] face = in.wholes(4, 0, MAX_VERTICES - 1);
            if (face.length < 3) {
                throw in.refused("a face must have 3 or 4 corners (got: " + face.length + ")");
            }
            faces.add(face);
            triangles += face.length - 2;
        }
        in.addParts(triangles);
        return faces.toArray(int[][]::new);
    }

    private static void write(JsonGenerator out, int[][] faces) throws IOException {
        out.writeStartArray();
        for (int[] face : faces) {
            out.writeArray(face, 0, face.length);
        }
        out.writeEndArray();
    }

    @SuppressWarnings("ArrayRecordComponent") // is never compared
    record Image(int columns, int rows, byte[] pixels, double width, double height) {
        static Image of(ImageTexture of) {
            return new Image(of.width(), of.height(), of.bytes(), of.tileWidth(), of.tileHeight());
        }

        ImageTexture texture() {
            return ImageTexture.of(columns, rows, pixels, width, height);
        }
    }

    /** What all objects have. */
    @SuppressWarnings("ArrayRecordComponent") // is never compared
    record Placed(
            @Nullable String name,
            boolean moveable,
            Point center,
            double @Nullable [] rotation,
            double @Nullable [] headingDegrees,
            @Nullable Double heading,
            Material material,
            List<String> layers) {
        private static final double[] FORWARD = {1, 0, 0, 0, 1, 0, 0, 0, 1};

        Placed {
            if (heading != null && rotation != null) {
                throw new IllegalArgumentException(
                        "heading and rotation must not both be given; a heading is for what stands upright (got: both)");
            }
            if (new HashSet<>(layers).size() < layers.size()) {
                throw new IllegalArgumentException("layers must have each name once (got: " + layers + ")");
            }
            if (headingDegrees != null && rotation == null) {
                throw new IllegalArgumentException(
                        "headingDegrees must come with the rotation that it belongs to (got: no rotation)");
            }
        }

        static Placed of(GeometryObject object) {
            Point center = object.center();
            Pose pose = object.pose();
            double[] rotation = pose.rotation();
            Pose plain = Pose.of(center, 0).oriented(rotation);
            boolean isPlain = plain.heading() == pose.heading() && plain.lostHeading() == pose.lostHeading();
            boolean isForward = Arrays.equals(rotation, FORWARD) && pose.heading() == 0 && pose.lostHeading() == 0;
            return new Placed(
                    object.name(),
                    object.isMoveable(),
                    center,
                    isForward ? null : rotation,
                    isForward || isPlain ? null : new double[] {pose.heading(), pose.lostHeading()},
                    null,
                    object.material(),
                    object.layers().stream().sorted().toList());
        }

        GeometryObject put(GeometryObject shape) {
            GeometryObject placed = shape.at(pose()).withMaterial(material).withLayers(new HashSet<>(layers));
            if (name == null && moveable) {
                throw new IllegalArgumentException("name must be given for a moveable object (got: none)");
            }
            return name == null ? placed : moveable ? placed.moveable(name) : placed.named(name);
        }

        private Pose pose() {
            if (rotation == null) {
                return Pose.of(center, heading == null ? 0 : Degrees.toDegrees(heading));
            }
            return headingDegrees == null
                    ? Pose.of(center, 0).oriented(rotation)
                    : Pose.of(center, rotation, headingDegrees[0], headingDegrees[1]);
        }
    }

    record Box(Placed placed, double width, double height, double length) {
        static Box of(GeometryObject object) {
            BoxObject box = (BoxObject) object;
            return new Box(Placed.of(box), box.width(), box.height(), box.length());
        }

        GeometryObject made() {
            return placed.put(new BoxObject(placed.center, width, height, length));
        }
    }

    record Cylinder(Placed placed, double radius, double height) {
        static Cylinder of(GeometryObject object) {
            CylinderObject cylinder = (CylinderObject) object;
            return new Cylinder(Placed.of(cylinder), cylinder.radius(), cylinder.height());
        }

        GeometryObject made() {
            return placed.put(new CylinderObject(placed.center, radius, height));
        }
    }

    record Sphere(Placed placed, double radius) {
        static Sphere of(GeometryObject object) {
            return new Sphere(Placed.of(object), ((SphereObject) object).radius());
        }

        GeometryObject made() {
            return placed.put(new SphereObject(placed.center, radius));
        }
    }

    record Capsule(Placed placed, double radius, double segment) {
        static Capsule of(GeometryObject object) {
            CapsuleObject capsule = (CapsuleObject) object;
            return new Capsule(Placed.of(capsule), capsule.radius(), capsule.segment());
        }

        GeometryObject made() {
            return placed.put(new CapsuleObject(placed.center, radius, segment));
        }
    }

    @SuppressWarnings("ArrayRecordComponent") // is never compared
    record Mesh(
            Placed placed,
            List<Point> vertices,
            int[][] faces,
            double @Nullable [] texturePoints,
            int @Nullable [] textureCorners,
            boolean solid,
            @Nullable GeometryObject boundingVolume) {
        Mesh {
            if ((texturePoints == null) != (textureCorners == null)) {
                throw new IllegalArgumentException(
                        "texturePoints and textureCorners must come together (got: one of them)");
            }
        }

        static Mesh of(GeometryObject object) {
            MeshObject mesh = (MeshObject) object;
            TriangleMesh all = mesh.triangles();
            TextureCoordinates coordinates = mesh.textureCoordinates();
            return new Mesh(
                    Placed.of(mesh),
                    IntStream.range(0, all.vertices())
                            .mapToObj(v -> new Point(all.coordinate(v, 0), all.coordinate(v, 1), all.coordinate(v, 2)))
                            .toList(),
                    mesh.faces(),
                    coordinates == null ? null : coordinates.points(),
                    coordinates == null ? null : coordinates.corners(),
                    mesh.isSolid(),
                    mesh.boundingVolume());
        }

        GeometryObject made() {
            MeshObject surface = boundingVolume == null
                    ? new MeshObject(vertices, faces)
                    : new MeshObject(vertices, faces, boundingVolume);
            if (texturePoints != null && textureCorners != null) {
                surface = surface.withTextureCoordinates(new TextureCoordinates(texturePoints, textureCorners));
            }
            return placed.put(solid ? surface.solid() : surface);
        }
    }

    record Group(
            Placed placed,
            List<GeometryObject> members,
            @Nullable GeometryObject boundingVolume) {
        static Group of(GeometryObject object) {
            ObjectGroup group = (ObjectGroup) object;
            return new Group(Placed.of(group), group.members(), group.boundingVolume());
        }

        GeometryObject made() {
            return placed.put(new ObjectGroup(members, boundingVolume));
        }
    }

    @SuppressWarnings("ArrayRecordComponent") // is never compared
    record Grid(Placed placed, double cell, double height, int columns, int rows, byte[] occupied) {
        static Grid of(GeometryObject object) {
            GridObject grid = (GridObject) object;
            return new Grid(Placed.of(grid), grid.cell(), grid.height(), grid.columns(), grid.rows(), grid.bytes());
        }

        GeometryObject made() {
            return placed.put(GridObject.of(placed.center, cell, height, columns, rows, occupied));
        }
    }
}
