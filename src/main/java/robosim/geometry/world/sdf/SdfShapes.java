package robosim.geometry.world.sdf;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import robosim.geometry.exact.Rotations;
import robosim.geometry.material.TextureCoordinates;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CapsuleObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;
import robosim.geometry.world.mesh.MeshFiles;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.FileWork;
import robosim.geometry.world.shared.Floor;
import robosim.geometry.world.shared.ImageFiles;
import robosim.geometry.world.shared.Limits;
import robosim.geometry.world.shared.Placement;

/** Creates shapes from SDFormat's geometries, at the origin and in the world's axes: its Z is our Y. */
public final class SdfShapes {
    /** Width and length in metres of a plane that has no size, which Gazebo draws as one metre and takes as infinite. */
    private static final double PLANE = 100;

    private static final double THICKNESS = 0.1;
    private static final Point UNSCALED = new Point(1, 1, 1);

    private final SdfTree tree;
    private final SdfFiles files;
    private final Map<Part, MeshObject> surfaces;
    private final Map<Scaled, MeshObject> meshes;
    private long vertices;

    /** A part of a file by its name, all of it if that is empty; for a picture that the file does not name, perhaps. */
    private record Part(Path file, String name, boolean isPictured) {}

    private record Scaled(Part part, boolean isCentred, Point scale) {}

    public SdfShapes(SdfTree tree, SdfFiles files) {
        this(tree, files, new HashMap<>(), new HashMap<>());
    }

    private SdfShapes(SdfTree tree, SdfFiles files, Map<Part, MeshObject> surfaces, Map<Scaled, MeshObject> meshes) {
        this.tree = tree;
        this.files = files;
        this.surfaces = surfaces;
        this.meshes = meshes;
    }

    SdfFiles files() {
        return files;
    }

    /** The same meshes for shapes that are only seen, of which nobody needs to know what they are made of here. */
    SdfShapes ofVisuals() {
        return new SdfShapes(tree.aside(), files, surfaces, meshes);
    }

    /**
     * The shape of a collision; null if it has none or is left out.
     *
     * @param owner the collision's name with those of the enclosing elements
     * @param place where it stands in the world
     * @param scale what its size is multiplied by, along its axes; null if it is not
     */
    @Nullable
    GeometryObject shape(SdfElement collision, String owner, Placement place, @Nullable Point scale)
            throws FileProblem {
        SdfElement geometry = collision.required("geometry");
        tree.account(geometry);
        if (geometry.children.size() != 1) {
            if (geometry.children.isEmpty() && !geometry.skipped.isEmpty()) {
                return null;
            }
            throw geometry.wrong("<geometry> must contain one shape (got: " + geometry.children.size() + ")");
        }
        SdfElement shape = geometry.children.get(0);
        tree.account(shape);
        Point size = scale == null ? UNSCALED : scale;
        if (scale != null && !isScaled(shape.name)) {
            tree.skip(
                    shape,
                    "the scale of " + named(shape, owner),
                    "a saved <state> scales only boxes, cylinders, spheres and meshes here; give its size itself");
        }
        try {
            return switch (shape.name) {
                case "box" -> {
                    double[] given = shape.required("size").numbers(3);
                    yield new BoxObject(new Point(), given[0] * size.x(), given[2] * size.z(), given[1] * size.y());
                }
                case "sphere" ->
                    new SphereObject(
                            new Point(), shape.number("radius") * Math.max(size.z(), Math.max(size.x(), size.y())));
                case "cylinder" -> cylinder(shape, size);
                case "capsule" -> capsule(shape);
                case "mesh" -> mesh(shape, owner, size, SdfMaterials.picture(collision) != null);
                case "plane" -> plane(shape, owner, place);
                case "heightmap" -> heightmap(shape, owner);
                case "empty" -> null;
                case "cone" ->
                    approximate(shape, owner, SdfSurfaces.cone(shape.number("radius"), shape.number("length")));
                case "ellipsoid" -> ellipsoid(shape, owner);
                case "polyline" -> SdfSurfaces.polyline(shape);
                default -> {
                    tree.skip(
                            shape, named(shape, owner), "this shape is not supported; use boxes, cylinders or a mesh");
                    yield null;
                }
            };
        } catch (IllegalArgumentException e) {
            throw shape.wrong("<" + shape.name + ">: " + e.getMessage());
        }
    }

    private static String named(SdfElement shape, String owner) {
        return "<" + shape.name + "> of " + owner;
    }

    private GeometryObject ellipsoid(SdfElement shape, String owner) throws FileProblem {
        double[] radii = shape.required("radii").numbers(3);
        return radii[0] == radii[1] && radii[1] == radii[2]
                ? new SphereObject(new Point(), radii[0])
                : approximate(shape, owner, SdfSurfaces.ellipsoid(radii));
    }

    private MeshObject approximate(SdfElement shape, String owner, MeshObject mesh) {
        tree.remark(
                shape,
                named(shape, owner) + " is a solid mesh here, of flat faces with " + SdfSurfaces.SIDES
                        + " sides around, whose corners are on its surface");
        return mesh;
    }

    /** Whether a saved state scales a shape; the ground and nothing have no size. */
    private static boolean isScaled(String shape) {
        return switch (shape) {
            case "box", "sphere", "cylinder", "mesh", "plane", "empty" -> true;
            default -> false;
        };
    }

    /** It stays round, as in Gazebo. */
    private static CylinderObject cylinder(SdfElement shape, Point size) throws FileProblem {
        return new CylinderObject(
                new Point(), shape.number("radius") * Math.max(size.x(), size.y()), shape.number("length") * size.z());
    }

    /** Its length is that of the cylinder between the two round ends. */
    private static CapsuleObject capsule(SdfElement shape) throws FileProblem {
        return new CapsuleObject(new Point(), shape.number("radius"), shape.number("length"));
    }

    /** The ground becomes the floor of the world, in the world's own axes. Any other plane becomes a wide, thin box behind it. */
    private GeometryObject plane(SdfElement shape, String owner, Placement place) throws FileProblem {
        if (!isGround(shape, place)) {
            return wall(shape, owner, normal(shape));
        }
        double height = place.origin().y();
        tree.remark(
                shape,
                named(shape, owner) + " is infinite ground, and a box here that fills the world, " + Floor.THICKNESS
                        + " m thick, with its top at a height of " + height + " m");
        return Floor.at(height);
    }

    private static Point normal(SdfElement plane) throws FileProblem {
        Point normal = plane.vector("normal", new Point(0, 0, 1));
        return SdfPose.place(normal.x(), normal.y(), normal.z());
    }

    private static boolean isGround(SdfElement plane, Placement place) throws FileProblem {
        Point normal = normal(plane);
        Point up = place.direction(normal.x(), normal.y(), normal.z());
        return up.x() == 0 && up.z() == 0 && up.y() > 0;
    }

    /** Whether the shape of a collision is the floor of the world: a plane that faces straight up. */
    static boolean isFloor(SdfElement collision, Placement place) throws FileProblem {
        SdfElement geometry = collision.child("geometry");
        SdfElement plane = geometry == null || geometry.children.size() != 1 ? null : geometry.child("plane");
        return plane != null && isGround(plane, place);
    }

    /** A thin box, the middle of whose front is the origin, facing along a direction of the model. */
    private GeometryObject wall(SdfElement shape, String owner, Point normal) throws FileProblem {
        double size = Math.sqrt(normal.x() * normal.x() + normal.y() * normal.y() + normal.z() * normal.z());
        if (!(size > 0)) {
            throw shape.wrong("<normal> must not be zero (got: 0 0 0)");
        }
        double x = normal.x() / size;
        double y = normal.y() / size;
        double z = normal.z() / size;
        double[] extent = shape.child("size") == null
                ? new double[] {PLANE, PLANE}
                : shape.required("size").numbers(2);
        tree.remark(
                shape,
                named(shape, owner) + " is a box here, of " + extent[0] + " x " + extent[1] + " m and " + THICKNESS
                        + " m thick, and not infinite");
        // The rotation that takes Y to the normal, about the axis across both.
        double[] rotation = y <= -1
                ? new double[] {1, 0, 0, 0, -1, 0, 0, 0, -1}
                : new double[] {
                    1 - x * x / (1 + y), x, -x * z / (1 + y), -x, y, -z, -x * z / (1 + y), z, 1 - z * z / (1 + y)
                };
        Rotations.orthonormalise(rotation, 0);
        Point middle = new Point(-x * THICKNESS / 2, -y * THICKNESS / 2, -z * THICKNESS / 2);
        GeometryObject box = new BoxObject(new Point(), extent[0], THICKNESS, extent[1])
                .at(Placement.turned(middle, rotation).pose());
        return new ObjectGroup(List.of(box)); // so that its own frame is the plane's
    }

    private @Nullable GeometryObject heightmap(SdfElement shape, String owner) throws FileProblem {
        SdfElement uri = shape.required("uri");
        String name = uri.value().toLowerCase(Locale.ROOT);
        if (!name.endsWith(".png") && !name.endsWith(".pgm")) {
            tree.skip(
                    shape,
                    named(shape, owner),
                    uri.value() + " is neither PNG nor PGM; save it as a grey PNG of 16 bits");
            return null;
        }
        Path file = files.find(uri);
        if (file == null) {
            return missing(shape, owner, uri);
        }
        SdfHeightmap heights = new SdfHeightmap(shape);
        files.count(uri, file);
        ImageFiles.read(file, heights);
        count(heights.corners(), uri);
        tree.remark(
                shape,
                named(shape, owner)
                        + " is a mesh here, without an inside: what is below it is free, and what stands on it"
                        + " touches it");
        return heights.mesh();
    }

    private @Nullable GeometryObject missing(SdfElement shape, String owner, SdfElement uri) throws FileProblem {
        if (SdfFiles.isRemote(uri.value())) {
            tree.skip(shape, named(shape, owner), files.remote(uri.value()));
            return null;
        }
        throw files.missing(uri);
    }

    private void count(int more, SdfElement uri) throws FileProblem {
        FileWork.take(more);
        vertices += more;
        if (vertices > Limits.MAX_VERTICES) {
            throw uri.wrong("all meshes together must have at most " + Limits.MAX_VERTICES
                    + " vertices; simplify or split them (got: more)");
        }
    }

    /** @param isPictured whether it may be seen with a picture that its file does not name */
    private @Nullable GeometryObject mesh(SdfElement shape, String owner, Point size, boolean isPictured)
            throws FileProblem {
        SdfElement uri = shape.required("uri");
        String name = uri.value();
        SdfElement submesh = shape.child("submesh");
        String part = submesh == null ? "" : submesh.required("name").value();
        if (!MeshFiles.isNamed(name)) {
            tree.skip(
                    shape,
                    named(shape, owner),
                    name + " does not end in " + MeshFiles.ENDINGS + "; export it as one of them");
            return null;
        }
        Path file = files.find(uri);
        if (file == null) {
            return missing(shape, owner, uri);
        }
        Point own = shape.vector("scale", UNSCALED);
        Point scale = new Point(own.x() * size.x(), own.y() * size.y(), own.z() * size.z());
        String center = submesh == null ? "" : submesh.valueOf("center");
        boolean isCentred = !center.isEmpty() && SdfElement.isTrue(shape, "<center>", center);
        Scaled key = new Scaled(new Part(file, part, isPictured), isCentred, scale);
        MeshObject known = meshes.get(key);
        if (known == null) {
            MeshObject surface = surface(uri, key.part);
            known = scaled(isCentred ? centred(surface) : surface, scale, uri);
            meshes.put(key, known);
        }
        return known;
    }

    private MeshObject surface(SdfElement uri, Part key) throws FileProblem {
        Path file = key.file;
        MeshObject known = surfaces.get(key);
        if (known == null) {
            files.count(uri, file);
            if (!key.name.isEmpty()) {
                known = MeshFiles.readPart(file, key.name, files.textures());
            } else if (MeshFiles.isCollada(file.toString())) {
                known = MeshFiles.readInItsAxes(file, null, files.textures());
            } else {
                known = MeshFiles.read(file, 1, files.textures());
            }
            known = key.isPictured ? known : MeshFiles.trimmed(known);
            surfaces.put(key, known);
        }
        return known;
    }

    /** A mesh moved so that the middle of its bounds is the origin. */
    private static MeshObject centred(MeshObject mesh) {
        double[] least = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
        double[] most = {Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY};
        for (Point vertex : mesh.vertices()) {
            double[] place = {vertex.x(), vertex.y(), vertex.z()};
            for (int k = 0; k < 3; k++) {
                least[k] = Math.min(least[k], place[k]);
                most[k] = Math.max(most[k], place[k]);
            }
        }
        List<Point> places = new ArrayList<>(mesh.vertices().size());
        for (Point vertex : mesh.vertices()) {
            places.add(new Point(
                    vertex.x() - (least[0] + most[0]) / 2,
                    vertex.y() - (least[1] + most[1]) / 2,
                    vertex.z() - (least[2] + most[2]) / 2));
        }
        return new MeshObject(places, mesh.faces())
                .withTextureCoordinates(mesh.textureCoordinates())
                .withMaterial(mesh.material());
    }

    /**
     * A mesh scaled and in the world's axes; if the scale mirrors, the faces are reversed to keep their orientation.
     */
    private MeshObject scaled(MeshObject surface, Point scale, SdfElement uri) throws FileProblem {
        count(surface.vertices().size(), uri);
        List<Point> places = new ArrayList<>(surface.vertices().size());
        for (Point vertex : surface.vertices()) {
            places.add(SdfPose.place(vertex.x() * scale.x(), vertex.y() * scale.y(), vertex.z() * scale.z()));
        }
        int[][] faces = surface.faces();
        TextureCoordinates texture = surface.textureCoordinates();
        if (Math.signum(scale.x()) * Math.signum(scale.y()) * Math.signum(scale.z()) < 0) {
            for (int[] face : faces) {
                // A quad keeps its diagonal, from the first corner to the third.
                int second = face[1];
                face[1] = face[face.length - 1];
                face[face.length - 1] = second;
            }
            texture = texture == null ? null : reversed(texture, faces);
        }
        return new MeshObject(places, faces).withTextureCoordinates(texture).withMaterial(surface.material());
    }

    private static TextureCoordinates reversed(TextureCoordinates texture, int[][] faces) {
        int[] corners = texture.corners();
        int at = 0;
        for (int[] face : faces) {
            int last = at + face.length - 1;
            int second = corners[at + 1];
            corners[at + 1] = corners[last];
            corners[last] = second;
            at = last + 1;
        }
        return new TextureCoordinates(texture.points(), corners);
    }
}
