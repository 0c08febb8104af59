package robosim.geometry.model;

import java.io.InvalidObjectException;
import java.io.ObjectInputStream;
import java.io.Serial;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import robosim.geometry.exact.Checks;
import robosim.geometry.material.Material;

/** A solid cylinder, placed by its centre; its axis is its own Y. */
public final class CylinderObject implements GeometryObject {
    private static final long serialVersionUID = 1;

    private final transient Tag tag;
    private final transient Pose pose;
    private final transient double radius;
    private final transient double height;

    /**
     * An upright cylinder.
     *
     * @param center the middle of the cylinder
     * @param radius world units; at least 0
     * @param height extent along the axis in world units; at least 0
     */
    public CylinderObject(Point center, double radius, double height) {
        this(Tag.NONE, Pose.of(center, 0), radius, height);
    }

    CylinderObject(Tag tag, Pose pose, double radius, double height) {
        this.tag = tag;
        this.pose = pose;
        this.radius = Checks.size("radius", radius);
        this.height = Checks.halved("height", height);
    }

    /** The same shape with another tag and pose. */
    CylinderObject with(Tag newTag, Pose newPose) {
        return new CylinderObject(newTag, newPose, radius, height);
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
    public CylinderObject named(String name) {
        return with(tag.named(name), pose);
    }

    @Override
    public CylinderObject moveable(String name) {
        return with(tag.moveable(name), pose);
    }

    @Override
    public CylinderObject withMaterial(Material material) {
        return with(tag.of(material), pose);
    }

    @Override
    public CylinderObject movedTo(Point center) {
        return with(tag, pose.movedTo(center));
    }

    @Override
    public CylinderObject turned(double rx, double ry) {
        return with(tag, pose.turned(rx, ry));
    }

    @Override
    public CylinderObject oriented(double[] rotation) {
        return with(tag, pose.oriented(rotation));
    }

    @Override
    public CylinderObject at(Pose place) {
        return with(tag, Checks.present("pose", place));
    }

    @Override
    public Kind kind() {
        return Kind.CYLINDER;
    }

    /** Radius in world units. */
    public double radius() {
        return radius;
    }

    /** Extent along the axis in world units. */
    public double height() {
        return height;
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof CylinderObject that
                && radius == that.radius
                && height == that.height
                && tag.equals(that.tag)
                && pose.equals(that.pose);
    }

    @Override
    public int hashCode() {
        return 31 * Objects.hash(tag, pose) + Double.hashCode(radius + 3 * height);
    }

    @Override
    public String toString() {
        return "cylinder" + tag.text(pose) + ", radius " + radius + ", height " + height;
    }

    @Serial
    private Object writeReplace() {
        return SerialForms.of(this, new SerialForms.Cylinder(SerialForms.Place.of(this), radius, height));
    }

    @Serial
    private void readObject(ObjectInputStream in) throws InvalidObjectException {
        throw SerialForms.formRequired();
    }
}
