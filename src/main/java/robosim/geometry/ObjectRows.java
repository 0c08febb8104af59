package robosim.geometry;

import java.io.Serial;
import java.io.Serializable;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.material.Material;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GeometryObject.Kind;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.PlacedObject;
import robosim.geometry.model.Pose;

/**
 * Many objects as columns of plain values, for serialization: sizes, names and places to the last bit, with the
 * rounding errors of centres. Data that placements of one mesh, group or grid share is written once, and shared again after
 * reading.
 *
 * <p>Nothing read is trusted: {@link #objects()} creates each object through its constructor.
 *
 * @param kinds    by object: which constructor makes it
 * @param sizes    by object: three numbers of a box, two of a cylinder or capsule, one of a sphere
 * @param shapes   the meshes, groups and grids, each once
 * @param shapeOf  by object: the index of its shape in {@code shapes}; unused for other kinds
 * @param names    by object: null if it has none
 * @param moveable by object
 * @param places   by object: the {@link Pose#PLACE} numbers of its place
 * @param materials by object: null for the default; all of it null if no object was given one
 * @param visuals  by object: null for none; all of it null if no object was given any
 * @param layers   by object: null for none; all of it null if no object is in a layer
 */
@SuppressWarnings("ArrayRecordComponent") // never compared; the numbers are checked on the way out
record ObjectRows(
        byte[] kinds,
        double[] sizes,
        GeometryObject[] shapes,
        int[] shapeOf,
        @Nullable String[] names,
        boolean[] moveable,
        double[] places,
        @Nullable Material @Nullable [] materials,
        @Nullable List<GeometryObject> @Nullable [] visuals,
        @Nullable List<String> @Nullable [] layers)
        implements Serializable {
    @Serial
    private static final long serialVersionUID = 1;

    private static final byte OTHER = 3;

    /** By code: the kinds that are given by sizes, and MESH for what shares a shape. */
    private static final List<Kind> CODES = List.of(Kind.BOX, Kind.CYLINDER, Kind.SPHERE, Kind.MESH, Kind.CAPSULE);

    private static final int SIZES = 3;

    /** What placements of one mesh, group or grid have in common, by identity. */
    private record Shape(
            Object parts, boolean solid, @Nullable GeometryObject boundingVolume) {
        @Override
        public boolean equals(@Nullable Object other) {
            return other instanceof Shape that
                    && parts == that.parts
                    && solid == that.solid
                    && boundingVolume == that.boundingVolume;
        }

        @Override
        public int hashCode() {
            return System.identityHashCode(parts);
        }
    }

    /** The columns of given objects. */
    static ObjectRows of(List<GeometryObject> objects) {
        int count = objects.size();
        byte[] kinds = new byte[count];
        double[] sizes = new double[SIZES * count];
        int[] shapeOf = new int[count];
        @Nullable String[] names = new String[count];
        boolean[] moveable = new boolean[count];
        double[] places = new double[Pose.PLACE * count];
        @Nullable Material @Nullable [] materials = null;
        @Nullable List<GeometryObject> @Nullable [] visuals = null;
        @Nullable List<String> @Nullable [] layers = null;
        List<GeometryObject> shapes = new ArrayList<>();
        Map<Shape, Integer> seen = new HashMap<>();
        for (int k = 0; k < count; k++) {
            GeometryObject object = objects.get(k);
            names[k] = object.name();
            moveable[k] = object.isMoveable();
            if (!object.material().isDefault()) {
                materials = materials == null ? new Material[count] : materials;
                materials[k] = object.material();
            }
            if (object.visuals() != null) {
                visuals = visuals == null ? lists(count) : visuals;
                visuals[k] = object.visuals();
            }
            if (!object.layers().isEmpty()) {
                layers = layers == null ? lists(count) : layers;
                layers[k] = object.layers().stream().sorted().toList();
            }
            object.pose().place(places, Pose.PLACE * k);
            double[] own = object.sizes();
            System.arraycopy(own, 0, sizes, SIZES * k, own.length);
            kinds[k] = own.length == 0 ? OTHER : (byte) CODES.indexOf(object.kind());
            if (kinds[k] == OTHER) {
                shapeOf[k] = seen.computeIfAbsent(shape(object), s -> {
                    shapes.add(PlacedObject.like(object, null, false, Material.DEFAULT, null, Pose.ORIGIN));
                    return shapes.size() - 1;
                });
            }
        }
        return new ObjectRows(
                kinds,
                sizes,
                shapes.toArray(GeometryObject[]::new),
                shapeOf,
                names,
                moveable,
                places,
                materials,
                visuals,
                layers);
    }

    @SuppressWarnings("unchecked") // there is no array of a generic type
    private static <T> @Nullable List<T>[] lists(int count) {
        return (List<T>[]) new List<?>[count];
    }

    private static Shape shape(GeometryObject object) {
        if (object instanceof MeshObject mesh) {
            return new Shape(mesh.triangles(), mesh.isSolid(), mesh.boundingVolume());
        }
        return object instanceof ObjectGroup group
                ? new Shape(group.members(), false, group.boundingVolume())
                : new Shape(((GridObject) object).cells(), false, null);
    }

    /**
     * The objects.
     *
     * @throws IllegalArgumentException if a column is missing or too short, or an object's numbers are invalid
     */
    List<GeometryObject> objects() {
        int count = Checks.present("kinds", kinds).length;
        checkLength("sizes", Checks.present("sizes", sizes).length, (long) SIZES * count);
        checkLength("shapeOf", Checks.present("shapeOf", shapeOf).length, count);
        checkLength("names", Checks.present("names", names).length, count);
        checkLength("moveable", Checks.present("moveable", moveable).length, count);
        checkLength("places", Checks.present("places", places).length, (long) Pose.PLACE * count);
        checkLength("materials", materials == null ? count : materials.length, count);
        checkLength("visuals", visuals == null ? count : visuals.length, count);
        checkLength("layers", layers == null ? count : layers.length, count);
        Checks.present("shapes", shapes);
        List<GeometryObject> objects = new ArrayList<>(count);
        for (int k = 0; k < count; k++) {
            objects.add(object(k, Pose.checked(places, Pose.PLACE * k)));
        }
        return objects;
    }

    private Material material(int k) {
        Material material = materials == null ? null : materials[k];
        return material == null ? Material.DEFAULT : material;
    }

    private static void checkLength(String column, long length, long wanted) {
        if (length != wanted) {
            throw new IllegalArgumentException(column + " must have " + wanted + " entries (got: " + length + ")");
        }
    }

    private GeometryObject object(int k, Pose pose) {
        if (kinds[k] < 0 || kinds[k] >= CODES.size()) {
            throw new IllegalArgumentException("kinds[" + k + "] must be 0 to 4 (got: " + kinds[k] + ")");
        }
        Kind kind = CODES.get(kinds[k]);
        int from = SIZES * k;
        GeometryObject made = kinds[k] == OTHER
                ? shape(k)
                : kind.of(
                        pose.center(),
                        Arrays.copyOfRange(sizes, from, from + kind.sizes().size()));
        GeometryObject placed =
                PlacedObject.like(made, names[k], moveable[k], material(k), visuals == null ? null : visuals[k], pose);
        List<String> in = layers == null ? null : layers[k];
        return in == null ? placed : placed.withLayers(new HashSet<>(in));
    }

    private GeometryObject shape(int k) {
        int of = shapeOf[k];
        if (of < 0 || of >= shapes.length) {
            throw new IllegalArgumentException(
                    "shapeOf[" + k + "] must be one of the " + shapes.length + " shapes (got: " + of + ")");
        }
        return Checks.present("shapes[" + of + "]", shapes[of]);
    }

    /** A short text for logs and debugging. */
    @Override
    public String toString() {
        return kinds.length + " objects, shapes " + Arrays.toString(shapes);
    }
}
