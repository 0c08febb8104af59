package robosim.geometry.model;

import java.io.InvalidObjectException;
import java.io.ObjectInputStream;
import java.io.Serial;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import robosim.geometry.exact.Checks;
import robosim.geometry.material.Material;

/** A solid sphere, placed by its centre. It has an attitude too, which defines its forward direction. */
public final class SphereObject implements GeometryObject {
    private static final long serialVersionUID = 1;

    private final transient Tag tag;
    private final transient Pose pose;
    private final transient double radius;

    /**
     * A sphere facing +X.
     *
     * @param center the middle of the sphere
     * @param radius world units; at least 0
     */
    public SphereObject(Point center, double radius) {
        this(Tag.NONE, Pose.of(center, 0), radius);
    }

    SphereObject(Tag tag, Pose pose, double radius) {
        this.tag = tag;
        this.pose = pose;
        this.radius = Checks.size("radius", radius);
    }

    /** The same shape with another tag and pose. */
    SphereObject with(Tag newTag, Pose newPose) {
        return new SphereObject(newTag, newPose, radius);
    }

    @Override
    public @Nullable String name() {
        return tag.name();
    }

    @Override
    public boolean isMoveable() {
        return tag.moveable();
    }

    @Override
    public Pose pose() {
        return pose;
    }

    @Override
    public Material material() {
        return tag.material();
    }

    @Override
    public SphereObject named(String name) {
        return with(tag.named(name), pose);
    }

    @Override
    public SphereObject moveable(String name) {
        return with(tag.moveable(name), pose);
    }

    @Override
    public SphereObject withMaterial(Material material) {
        return with(tag.of(material), pose);
    }

    @Override
    public SphereObject movedTo(Point center) {
        return with(tag, pose.movedTo(center));
    }

    @Override
    public SphereObject turned(double rx, double ry) {
        return with(tag, pose.turned(rx, ry));
    }

    @Override
    public SphereObject oriented(double[] rotation) {
        return with(tag, pose.oriented(rotation));
    }

    @Override
    public SphereObject at(Pose place) {
        return with(tag, Checks.present("pose", place));
    }

    @Override
    public Kind kind() {
        return Kind.SPHERE;
    }

    /** Radius in world units. */
    public double radius() {
        return radius;
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof SphereObject that
                && radius == that.radius
                && tag.equals(that.tag)
                && pose.equals(that.pose);
    }

    @Override
    public int hashCode() {
        return 31 * Objects.hash(tag, pose) + Double.hashCode(radius);
    }

    @Override
    public String toString() {
        return "sphere" + tag.text(pose) + ", radius " + radius;
    }

    @Serial
    private Object writeReplace() {
        return SerialForms.of(this, new SerialForms.Sphere(SerialForms.Place.of(this), radius));
    }

    @Serial
    private void readObject(ObjectInputStream in) throws InvalidObjectException {
        throw SerialForms.formRequired();
    }
}
