package robosim.geometry.model;

import java.io.Serial;
import java.io.Serializable;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.index.meshes.TriangleMesh;
import robosim.geometry.material.Material;
import robosim.geometry.material.TextureCoordinates;

/**
 * The serialized forms of objects: records from which the object is created through its constructor, so that no object
 * can be created that the constructor would refuse.
 */
@SuppressWarnings("ArrayRecordComponent") // never compared, and the numbers are checked and copied on the way in
final class SerialForms {
    private SerialForms() {}

    /** All classes of this package that a serialized object may contain, for an allow-list. */
    static Set<Class<?>> classes() {
        return Set.of(
                Point.class,
                Ray.class,
                Move.class,
                Accuracy.class,
                Dimension.class,
                Place.class,
                Box.class,
                Cylinder.class,
                Sphere.class,
                Capsule.class,
                Mesh.class,
                Group.class,
                Grid.class,
                Textured.class,
                Surfaced.class,
                Seen.class,
                Layered.class);
    }

    /**
     * What stands for an object in a stream: its form, and around it what it may have besides. An object that has nothing
     * besides has the bytes that it always had.
     */
    static Object of(GeometryObject object) {
        if (!object.layers().isEmpty()) {
            return new Layered(
                    object.withLayers(Set.of()),
                    object.layers().stream().sorted().toList());
        }
        List<GeometryObject> visuals = object.visuals();
        if (visuals != null) {
            return new Seen(object.withVisuals(null), visuals);
        }
        Material material = object.material();
        if (!material.isDefault()) {
            return new Surfaced(object.withMaterial(Material.DEFAULT), material);
        }
        TextureCoordinates texture = object instanceof MeshObject mesh ? mesh.textureCoordinates() : null;
        return texture == null
                ? form(object)
                : new Textured(((MeshObject) object).withTextureCoordinates(null), texture.points(), texture.corners());
    }

    private static Serializable form(GeometryObject object) {
        Place place = Place.of(object);
        double[] sizes = object.sizes();
        return switch (object.kind()) {
            case BOX -> new Box(place, sizes[0], sizes[1], sizes[2]);
            case CYLINDER -> new Cylinder(place, sizes[0], sizes[1]);
            case SPHERE -> new Sphere(place, sizes[0]);
            case CAPSULE -> new Capsule(place, sizes[0], sizes[1]);
            case MESH -> {
                MeshObject mesh = (MeshObject) object;
                TriangleMesh surface = mesh.triangles();
                yield new Mesh(place, surface.coordinates(), surface.faces(), mesh.boundingVolume(), mesh.isSolid());
            }
            case GROUP -> {
                ObjectGroup group = (ObjectGroup) object;
                yield new Group(place, group.members(), group.boundingVolume());
            }
            case GRID -> {
                GridObject grid = (GridObject) object;
                yield new Grid(place, grid.cell(), grid.height(), grid.columns(), grid.rows(), grid.bytes());
            }
        };
    }

    /** Name, mobility and pose; the heading is sent with its rounding error. */
    record Place(@Nullable String name, boolean moveable, Point center, double[] rotation, double heading, double rest)
            implements Serializable {
        @Serial
        private static final long serialVersionUID = 1;

        static Place of(GeometryObject object) {
            Pose pose = object.pose();
            return new Place(
                    object.name(),
                    object.isMoveable(),
                    pose.center(),
                    pose.rotation(),
                    pose.heading(),
                    pose.lostHeading());
        }

        PlacedObject.Tag tag() {
            return new PlacedObject.Tag(name, moveable);
        }

        Pose pose() {
            return Pose.of(Checks.present("center", center), rotation, heading, rest);
        }
    }

    record Box(Place place, double width, double height, double length) implements Serializable {
        @Serial
        private static final long serialVersionUID = 1;

        @Serial
        private Object readResolve() {
            return new BoxObject(place.tag(), place.pose(), width, height, length);
        }
    }

    record Cylinder(Place place, double radius, double height) implements Serializable {
        @Serial
        private static final long serialVersionUID = 1;

        @Serial
        private Object readResolve() {
            return new CylinderObject(place.tag(), place.pose(), radius, height);
        }
    }

    record Sphere(Place place, double radius) implements Serializable {
        @Serial
        private static final long serialVersionUID = 1;

        @Serial
        private Object readResolve() {
            return new SphereObject(place.tag(), place.pose(), radius);
        }
    }

    record Capsule(Place place, double radius, double segment) implements Serializable {
        @Serial
        private static final long serialVersionUID = 1;

        @Serial
        private Object readResolve() {
            return new CapsuleObject(place.tag(), place.pose(), radius, segment);
        }
    }

    record Mesh(
            Place place,
            double[] coordinates,
            int[][] faces,
            @Nullable GeometryObject boundingVolume,
            boolean solid) implements Serializable {
        @Serial
        private static final long serialVersionUID = 1;

        @Serial
        private Object readResolve() {
            // Copied first: the stream may hold another reference to the same arrays.
            TriangleMesh triangles =
                    new TriangleMesh(Checks.present("vertices", coordinates).clone(), MeshObject.copy(faces));
            MeshObject mesh = new MeshObject(place.tag(), place.pose(), triangles, false, null).bounded(boundingVolume);
            return solid ? mesh.solid() : mesh;
        }
    }

    record Group(
            Place place,
            List<GeometryObject> members,
            @Nullable GeometryObject boundingVolume) implements Serializable {
        @Serial
        private static final long serialVersionUID = 1;

        @Serial
        private Object readResolve() {
            return new ObjectGroup(members, boundingVolume).with(place.tag(), place.pose());
        }
    }

    /** The occupied cells as bits, eight a byte; free ones are sent too, so that no small message asks for a large grid. */
    record Grid(Place place, double cell, double height, int columns, int rows, byte[] occupied)
            implements Serializable {
        @Serial
        private static final long serialVersionUID = 1;

        @Serial
        private Object readResolve() {
            return GridObject.of(place.tag(), place.pose(), cell, height, columns, rows, occupied);
        }
    }

    /** A mesh with texture coordinates. */
    record Textured(GeometryObject mesh, double[] points, int[] corners) implements Serializable {
        @Serial
        private static final long serialVersionUID = 1;

        @Serial
        private Object readResolve() {
            if (mesh instanceof MeshObject surface) {
                return surface.withTextureCoordinates(new TextureCoordinates(points, corners));
            }
            throw new IllegalArgumentException("only a mesh has texture coordinates (got: " + mesh + ")");
        }
    }

    /** An object that was given visuals. */
    record Seen(GeometryObject object, List<GeometryObject> visuals) implements Serializable {
        @Serial
        private static final long serialVersionUID = 1;

        @Serial
        private Object readResolve() {
            return Checks.present("object", object).withVisuals(Checks.present("visuals", visuals));
        }
    }

    /** An object in layers. */
    record Layered(GeometryObject object, List<String> layers) implements Serializable {
        @Serial
        private static final long serialVersionUID = 1;

        @Serial
        private Object readResolve() {
            List<String> names = Checks.list("layers", layers);
            return Checks.present("object", object).withLayers(new HashSet<>(names));
        }
    }

    /** An object that was given a material. */
    record Surfaced(GeometryObject object, Material material) implements Serializable {
        @Serial
        private static final long serialVersionUID = 1;

        @Serial
        private Object readResolve() {
            return Checks.present("object", object).withMaterial(material);
        }
    }
}
