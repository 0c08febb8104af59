package robosim.geometry.model;

import java.io.Serial;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.material.Material;
import robosim.geometry.model.GeometryObject.RoundedBox;

/**
 * The name, place and material of an object, which all shapes share; {@link GeometryObject} describes its methods. It is public only
 * since the compiler names it where it infers a type from several shapes.
 *
 * @param <S> the shape
 */
public abstract class PlacedObject<S extends GeometryObject> {
    final Tag tag;
    final Pose pose;
    private final @Nullable RoundedBox box;

    PlacedObject(Tag tag, Pose pose, @Nullable RoundedBox box) {
        this.tag = tag;
        this.pose = pose;
        this.box = box;
    }

    /** The same as {@link GeometryObject#kind}. */
    public abstract GeometryObject.Kind kind();

    public double[] sizes() {
        return new double[0];
    }

    public final RoundedBox roundedBox() {
        if (box == null) {
            throw new IllegalArgumentException(
                    "object must be given by sizes, as a box is, and not a " + kind().word() + " (got: " + this + ")");
        }
        return box;
    }

    /** For internal use: all classes of this package that a serialized object may contain, for an allow-list. */
    public static Set<Class<?>> serialClasses() {
        return SerialForms.classes();
    }

    /** For internal use: the shape of an object with another name, mobility, material, visuals and pose, in no layer. */
    public static GeometryObject like(
            GeometryObject object,
            @Nullable String name,
            boolean moveable,
            Material material,
            @Nullable List<GeometryObject> visuals,
            Pose pose) {
        Look look = Look.of(material, Tag.checked(visuals), Set.of());
        return ((PlacedObject<?>) object).with(new Tag(name, moveable, look), pose);
    }

    /** The same shape with another tag and pose. */
    abstract S with(Tag newTag, Pose newPose);

    public final @Nullable String name() {
        return tag.name();
    }

    public boolean isMoveable() {
        return tag.moveable();
    }

    public final Pose pose() {
        return pose;
    }

    public final Material material() {
        return tag.look().material();
    }

    public final @Nullable List<GeometryObject> visuals() {
        return tag.look().visuals();
    }

    public final S withVisuals(@Nullable List<? extends GeometryObject> visuals) {
        return with(tag.with(Look.of(material(), Tag.checked(visuals), layers())), pose);
    }

    public final Set<String> layers() {
        return tag.look().layers();
    }

    public final S withLayers(Set<String> layers) {
        return with(tag.with(Look.of(material(), visuals(), layers)), pose);
    }

    public final S named(String name) {
        return with(tag.named(name), pose);
    }

    public S moveable(String name) {
        return with(tag.moveable(name), pose);
    }

    public final S withMaterial(Material material) {
        return with(tag.with(Look.of(material, visuals(), layers())), pose);
    }

    public final S movedTo(Point center) {
        return with(tag, pose.movedTo(center));
    }

    public S turned(double rx, double ry) {
        return with(tag, pose.turned(rx, ry));
    }

    public final S oriented(double[] rotation) {
        return with(tag, pose.oriented(rotation));
    }

    public final S at(Pose place) {
        return with(tag, Checks.present("pose", place));
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof PlacedObject<?> that
                && kind() == that.kind()
                && Objects.equals(box, that.box)
                && tag.equals(that.tag)
                && pose.equals(that.pose);
    }

    @Override
    public int hashCode() {
        return Objects.hash(tag, pose, box);
    }

    @Override
    public String toString() {
        StringBuilder text = new StringBuilder(kind().word()).append(tag.text(pose));
        double[] sizes = sizes();
        for (int k = 0; k < sizes.length; k++) {
            text.append(", ").append(kind().sizes().get(k)).append(' ').append(sizes[k]);
        }
        return text.toString();
    }

    @Serial
    final Object writeReplace() {
        return SerialForms.of((GeometryObject) this);
    }

    /**
     * What an object has besides its shape and name: most share {@link #DEFAULT}.
     *
     * @param visuals what is seen of it; null for its shape
     * @param layers  names of the layers that it belongs to
     */
    record Look(Material material, @Nullable List<GeometryObject> visuals, Set<String> layers) {
        static final Look DEFAULT = new Look(Material.DEFAULT, null, Set.of());

        Look {
            Checks.present("material", material);
            layers = Checks.names("layers", layers);
            for (String layer : layers) {
                if (layer.chars().anyMatch(Character::isWhitespace)) {
                    throw new IllegalArgumentException(
                            "layers must have names without spaces, as files list them (got: \"" + layer + "\")");
                }
            }
        }

        static Look of(Material material, @Nullable List<GeometryObject> visuals, Set<String> layers) {
            boolean isPlain =
                    visuals == null && Checks.present("layers", layers).isEmpty();
            return isPlain && Checks.present("material", material).isDefault()
                    ? DEFAULT
                    : new Look(material, visuals, layers);
        }
    }

    /** An object's name, whether a world may move it, and its look; a moveable object always has a name. */
    record Tag(@Nullable String name, boolean moveable, Look look) {
        static final Tag NONE = new Tag(null, false);

        Tag {
            if (name != null) {
                Checks.name(name);
            } else if (moveable) {
                throw new IllegalArgumentException("name must be given for a moveable object (got: null)");
            }
        }

        Tag(@Nullable String name, boolean moveable) {
            this(name, moveable, Look.DEFAULT);
        }

        /** A copy of a list of visuals, none of which may be moveable or have visuals itself. */
        static @Nullable List<GeometryObject> checked(@Nullable List<? extends GeometryObject> visuals) {
            if (visuals == null) {
                return null;
            }
            List<GeometryObject> copy = Checks.list("visuals", visuals);
            for (GeometryObject each : copy) {
                if (each.isMoveable() || each.visuals() != null) {
                    throw new IllegalArgumentException(
                            "visuals must be static, and have no visuals themselves (got: " + each + ")");
                }
            }
            return copy;
        }

        /** The same as one that a world may move. */
        Tag moveable(String newName) {
            return new Tag(Checks.name(newName), true, look);
        }

        /** The same under another name. */
        Tag named(String newName) {
            return new Tag(Checks.name(newName), moveable, look);
        }

        /** The same with another look. */
        Tag with(Look newLook) {
            return new Tag(name, moveable, newLook);
        }

        /** The name, if any, and the place, as text for people. */
        String text(Pose pose) {
            return (name == null ? "" : " \"" + name + "\"") + " at " + pose;
        }
    }
}
