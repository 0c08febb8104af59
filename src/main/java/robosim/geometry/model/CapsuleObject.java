package robosim.geometry.model;

import java.io.InvalidObjectException;
import java.io.ObjectInputStream;
import java.io.Serial;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import robosim.geometry.exact.Checks;
import robosim.geometry.material.Material;

/**
 * A solid capsule: all points within a radius of a segment along its own Y, placed by its centre. A leg, an arm, a person.
 */
public final class CapsuleObject implements GeometryObject {
    private static final long serialVersionUID = 1;

    private final transient Tag tag;
    private final transient Pose pose;
    private final transient double radius;
    private final transient double segment;

    /**
     * An upright capsule.
     *
     * @param center the middle of the segment
     * @param radius world units; at least 0
     * @param segment length of the segment in world units, without the two round ends (the {@code length} of SDFormat); at
     *     least 0
     */
    public CapsuleObject(Point center, double radius, double segment) {
        this(Tag.NONE, Pose.of(center, 0), radius, segment);
    }

    CapsuleObject(Tag tag, Pose pose, double radius, double segment) {
        this.tag = tag;
        this.pose = pose;
        this.radius = Checks.size("radius", radius);
        this.segment = Checks.halved("segment", segment);
    }

    /** The same shape under another tag and pose. */
    CapsuleObject with(Tag newTag, Pose newPose) {
        return new CapsuleObject(newTag, newPose, radius, segment);
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
    public CapsuleObject named(String name) {
        return with(tag.named(name), pose);
    }

    @Override
    public CapsuleObject moveable(String name) {
        return with(tag.moveable(name), pose);
    }

    @Override
    public CapsuleObject withMaterial(Material material) {
        return with(tag.of(material), pose);
    }

    @Override
    public CapsuleObject movedTo(Point center) {
        return with(tag, pose.movedTo(center));
    }

    @Override
    public CapsuleObject turned(double rx, double ry) {
        return with(tag, pose.turned(rx, ry));
    }

    @Override
    public CapsuleObject oriented(double[] rotation) {
        return with(tag, pose.oriented(rotation));
    }

    @Override
    public CapsuleObject at(Pose place) {
        return with(tag, Checks.present("pose", place));
    }

    @Override
    public Kind kind() {
        return Kind.CAPSULE;
    }

    /** Radius in world units. */
    public double radius() {
        return radius;
    }

    /** Length of the segment in world units, without the two round ends. */
    public double segment() {
        return segment;
    }

    /** Extent along the own Y in world units: the segment and a radius at either end, rounded. */
    public double height() {
        return segment + 2 * radius;
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof CapsuleObject that
                && radius == that.radius
                && segment == that.segment
                && tag.equals(that.tag)
                && pose.equals(that.pose);
    }

    @Override
    public int hashCode() {
        return 31 * Objects.hash(tag, pose) + Double.hashCode(radius + 3 * segment);
    }

    @Override
    public String toString() {
        return "capsule" + tag.text(pose) + ", radius " + radius + ", segment " + segment;
    }

    @Serial
    private Object writeReplace() {
        return SerialForms.of(this, new SerialForms.Capsule(SerialForms.Place.of(this), radius, segment));
    }

    @Serial
    private void readObject(ObjectInputStream in) throws InvalidObjectException {
        throw SerialForms.formRequired();
    }
}
