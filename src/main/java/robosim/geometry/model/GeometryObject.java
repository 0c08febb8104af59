package robosim.geometry.model;

import java.io.Serializable;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.material.Material;

/**
 * An object of a world: an immutable value. The world, not the value, holds where a moveable object is now.
 *
 * <p>Values compare by name, place, attitude, shape, material, visuals and layers. Serialization goes through small records, so that no object can
 * be created that its constructor would refuse.
 */
public sealed interface GeometryObject extends Serializable
        permits BoxObject, CylinderObject, SphereObject, CapsuleObject, MeshObject, ObjectGroup, GridObject {

    /** The seven shapes, for a switch that the compiler checks. Four of them are given by sizes alone, which a kind names. */
    enum Kind {
        BOX("width", "height", "length"),
        CYLINDER("radius", "height"),
        SPHERE("radius"),
        CAPSULE("radius", "segment"),
        MESH,
        GROUP,
        GRID;

        @SuppressWarnings("ImmutableEnumChecker") // a list that cannot be changed
        private final List<String> sizes;

        private final boolean isRound;

        Kind(String... sizes) {
            this.sizes = List.of(sizes);
            isRound = this.sizes.contains("radius");
        }

        /** As in files and sentences: {@code box}, {@code cylinder}, {@code sphere}, {@code capsule}, {@code mesh}, {@code group} or {@code grid}. */
        public String word() {
            return name().toLowerCase(Locale.ROOT);
        }

        /** The names of the sizes that are all there is to its shape, as in files; none of a mesh, group or grid. */
        public List<String> sizes() {
            return sizes;
        }

        /** Whether it is a convex solid that is given by sizes alone: a box, cylinder, sphere or capsule. */
        public boolean isSized() {
            return !sizes.isEmpty();
        }

        /** Whether any turn about its own Y takes it to itself. */
        public boolean isRound() {
            return isRound;
        }

        /**
         * An upright object at a place, facing +X.
         *
         * @param given as many as {@link #sizes}, in that order, in world units; each at least 0
         * @throws IllegalArgumentException for a mesh, group or grid, or a size that its constructor refuses
         */
        public GeometryObject of(Point center, double... given) {
            if (Checks.present("given", given).length != sizes.size() || !isSized()) {
                throw new IllegalArgumentException("a " + word() + " must be given by "
                        + (isSized() ? String.join(", ", sizes) : "more than sizes, with its constructor") + " (got: "
                        + given.length + " sizes)");
            }
            return switch (this) {
                case BOX -> new BoxObject(center, given[0], given[1], given[2]);
                case CYLINDER -> new CylinderObject(center, given[0], given[1]);
                case SPHERE -> new SphereObject(center, given[0]);
                case CAPSULE -> new CapsuleObject(center, given[0], given[1]);
                case MESH, GROUP, GRID -> throw new IllegalStateException("checked above (got: " + this + ")");
            };
        }
    }

    /** Which of the seven shapes this is. */
    Kind kind();

    /** The numbers of {@link Kind#sizes}, in world units; a fresh array, empty for a mesh, group or grid. */
    double[] sizes();

    /**
     * What an object that is given by its sizes is made of.
     *
     * @throws IllegalArgumentException for a mesh, group or grid
     */
    RoundedBox roundedBox();

    /** The name, unique in a world, or null for a static object without one. */
    @Nullable
    String name();

    /** Whether a world may move this object; it then has a name. */
    boolean isMoveable();

    /** The place and attitude. */
    Pose pose();

    /**
     * What its surface looks like, and what sensors feel of it; {@link Material#DEFAULT} unless it was given one. A member of
     * a group that has the default is made of the group's.
     */
    Material material();

    /**
     * What is seen of it in place of its shape: objects in its own frame; null where it looks like its shape, and empty where
     * nothing of it is seen. Pictures show visuals; moves, sonars and lasers know the shape alone. A visual that has the default
     * material is made of this object's.
     */
    @Nullable
    List<GeometryObject> visuals();

    /**
     * The names of the layers that it belongs to; mostly none. Queries leave out all objects of a layer where they are given its
     * name to be ignored, as in {@link SenseOptions#ignoring}. Layers of a member of a group have no effect.
     */
    Set<String> layers();

    /** This object as it is seen where it stands: itself, or a group of its visuals under its name; null if nothing is seen. */
    default @Nullable GeometryObject seen() {
        List<GeometryObject> visuals = visuals();
        String name = name();
        if (visuals == null) {
            return this;
        }
        if (visuals.isEmpty()) {
            return null;
        }
        GeometryObject group = new ObjectGroup(visuals)
                .withMaterial(material())
                .withLayers(layers())
                .at(pose());
        return name == null ? group : isMoveable() ? group.moveable(name) : group.named(name);
    }

    /** The place: the middle of a box, cylinder, sphere, capsule or grid; the origin of the own frame of a mesh or group. */
    default Point center() {
        return pose().center();
    }

    /**
     * The attitude: a 3 x 3 rotation matrix, row-major, whose columns are the object's own axes in the world; a fresh
     * array.
     */
    default double[] rotation() {
        return pose().rotation();
    }

    /** Degrees about the vertical from the world's X to the object's forward, above -180 and up to 180. */
    default double heading() {
        return pose().heading();
    }

    /** The box along the world's axes that holds this object where it stands, rounded outward. */
    default Bounds bounds() {
        return Bounds.of(this);
    }

    /** This object with a name; whether it is moveable does not change. */
    GeometryObject named(String name);

    /** This object with a name, as one that a world may move. */
    GeometryObject moveable(String name);

    /** This object of another material. */
    GeometryObject withMaterial(Material material);

    /**
     * This object with another look.
     *
     * @param visuals in its own frame, static and without visuals of their own; null for the look of its shape
     */
    GeometryObject withVisuals(@Nullable List<? extends GeometryObject> visuals);

    /** This object in given layers, and in no other: any names, which need not be unique. */
    GeometryObject withLayers(Set<String> layers);

    /** This object with another centre and the same attitude. */
    GeometryObject movedTo(Point center);

    /**
     * This object turned in place.
     *
     * @param rx degrees about its own X, after the turn by {@code ry}
     * @param ry degrees about its own Y
     */
    GeometryObject turned(double rx, double ry);

    /**
     * This object in a given attitude.
     *
     * @param rotation nine numbers, row-major, whose columns are the object's axes: right-handed, orthonormal to 1e-9,
     *     kept as given
     * @throws IllegalArgumentException if it is not a rotation
     */
    GeometryObject oriented(double[] rotation);

    /** This object at a place and in an attitude. */
    GeometryObject at(Pose pose);

    /**
     * What boxes, cylinders, spheres and capsules have in common: a box that is widened by a disc about its own Y and by a ball, in
     * the object's own frame and around its centre. A box has neither; a cylinder is a segment widened by a disc, a sphere is a
     * point and a capsule a segment, both widened by a ball. Who asks an object for this need not distinguish kinds of shapes.
     *
     * <pre>{@code
     * new CapsuleObject(new Point(), 0.5, 2).roundedBox();
     * // RoundedBox[halfWidth=0.0, halfHeight=1.0, halfLength=0.0, disc=0.0, ball=0.5]
     * }</pre>
     *
     * @param halfWidth  half the box's extent along the own X, world units
     * @param halfHeight the same along the own Y
     * @param halfLength the same along the own Z
     * @param disc       radius of the disc, world units; 0 for none
     * @param ball       radius of the ball, world units; 0 for none. It or {@code disc} is 0
     */
    record RoundedBox(double halfWidth, double halfHeight, double halfLength, double disc, double ball) {
        /** A box without rounding, by its extents. */
        static RoundedBox box(double width, double height, double length) {
            return new RoundedBox(width / 2, height / 2, length / 2, 0, 0);
        }

        /** A segment along the own Y, widened. */
        static RoundedBox segment(double disc, double ball, double length) {
            return new RoundedBox(0, length / 2, 0, disc, ball);
        }

        /** Whether it is widened. */
        public boolean isRound() {
            return radius() > 0;
        }

        /** The radius of the disc or ball; 0 if there is neither. */
        public double radius() {
            return disc + ball;
        }

        /** Coordinate x, y or z of a corner of the box, not widened; {@code corner} is 0 to 7, a bit for each axis. */
        public double corner(int corner, int axis) {
            double half = axis == 0 ? halfWidth : axis == 1 ? halfHeight : halfLength;
            return (corner >> axis & 1) == 0 ? -half : half;
        }
    }
}
