package robosim.geometry.world.sdf;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import robosim.geometry.material.TextureCoordinates;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CapsuleObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;
import robosim.geometry.world.mesh.MeshFiles;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.Limits;
import robosim.geometry.world.shared.Placement;

/** Creates shapes from SDFormat's geometries, at the origin and in the world's axes: its Z is our Y. */
public final class SdfShapes {
    private final SdfTree tree;
    private final SdfFiles files;
    private final Map<Path, MeshObject> surfaces = new HashMap<>();
    private final Map<Scaled, MeshObject> meshes = new HashMap<>();
    private long vertices;

    private record Scaled(Path file, Point scale) {}

    public SdfShapes(SdfTree tree, SdfFiles files) {
        this.tree = tree;
        this.files = files;
    }

    /**
     * The shape of a collision; null if it has none or is left out.
     *
     * @param owner the collision's name with those of the enclosing elements
     * @param place where it stands in the world
     */
    @Nullable
    GeometryObject shape(SdfElement collision, String owner, Placement place) throws FileProblem {
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
        try {
            return switch (shape.name) {
                case "box" -> {
                    double[] size = shape.required("size").numbers(3);
                    yield new BoxObject(new Point(), size[0], size[2], size[1]);
                }
                case "sphere" -> new SphereObject(new Point(), shape.number("radius"));
                case "cylinder" -> cylinder(shape);
                case "capsule" -> capsule(shape);
                case "mesh" -> mesh(shape, owner);
                case "plane" -> plane(shape, owner, place);
                case "empty" -> null;
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

    private static CylinderObject cylinder(SdfElement shape) throws FileProblem {
        return new CylinderObject(new Point(), shape.number("radius"), shape.number("length"));
    }

    /** Its length is that of the cylinder between the two round ends. */
    private static CapsuleObject capsule(SdfElement shape) throws FileProblem {
        return new CapsuleObject(new Point(), shape.number("radius"), shape.number("length"));
    }

    /** The ground is left out; any other plane is refused, since it would cut off half of the world. */
    private @Nullable GeometryObject plane(SdfElement shape, String owner, Placement place) throws FileProblem {
        Point normal = shape.vector("normal", new Point(0, 0, 1));
        Point given = SdfPose.place(normal.x(), normal.y(), normal.z());
        Point up = place.direction(given.x(), given.y(), given.z());
        if (!(up.x() == 0 && up.z() == 0 && up.y() > 0)) {
            throw shape.wrong("a plane must face straight up, as the ground does; use a box for " + owner
                    + " (got: a normal of " + up.x() + " " + (0.0 - up.z()) + " " + up.y() + " in the world)");
        }
        tree.ground(
                shape,
                named(shape, owner),
                "it is infinite ground, at height " + place.origin().y()
                        + ", and a world has no planes; use a box if robots must collide with it");
        return null;
    }

    private @Nullable GeometryObject mesh(SdfElement shape, String owner) throws FileProblem {
        SdfElement uri = shape.required("uri");
        String name = uri.value();
        SdfElement submesh = shape.child("submesh");
        if (submesh != null) {
            throw submesh.wrong("part of a mesh cannot be read alone; save it as a separate file, for " + owner
                    + " (got: <submesh>)");
        }
        if (!MeshFiles.isNamed(name)) {
            tree.skip(shape, named(shape, owner), name + " is neither OBJ nor STL; export it as one of them");
            return null;
        }
        if (SdfFiles.isRemote(name)) {
            tree.skip(shape, named(shape, owner), "network addresses are not followed: " + name);
            return null;
        }
        Path file = files.find(uri);
        if (file == null) {
            throw files.missing(uri);
        }
        Point scale = shape.vector("scale", new Point(1, 1, 1));
        Scaled key = new Scaled(file, scale);
        MeshObject known = meshes.get(key);
        if (known == null) {
            known = scaled(surface(uri, file), scale, uri);
            meshes.put(key, known);
        }
        return known;
    }

    private MeshObject surface(SdfElement uri, Path file) throws FileProblem {
        MeshObject known = surfaces.get(file);
        if (known == null) {
            files.count(uri, file);
            known = MeshFiles.trimmed(MeshFiles.read(file, 1, files.textures()));
            surfaces.put(file, known);
        }
        return known;
    }

    /**
     * A mesh scaled and in the world's axes; if the scale mirrors, the faces are reversed to keep their orientation.
     */
    private MeshObject scaled(MeshObject surface, Point scale, SdfElement uri) throws FileProblem {
        vertices += surface.vertices().size();
        if (vertices > Limits.MAX_VERTICES) {
            throw uri.wrong("all meshes together must have at most " + Limits.MAX_VERTICES + " vertices (got: more)");
        }
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
