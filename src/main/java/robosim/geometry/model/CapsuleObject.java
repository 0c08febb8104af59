package robosim.geometry.model;

import java.io.InvalidObjectException;
import java.io.ObjectInputStream;
import java.io.Serial;
import java.util.Objects;
import robosim.geometry.check.Checks;

/**
 * A solid capsule: all points within a radius of a segment along its own Y, placed by its centre. A leg, an arm, a person.
 */
public final class CapsuleObject extends PlacedObject<CapsuleObject> implements GeometryObject {
    private static final long serialVersionUID = 1;

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
        super(tag, pose);
        this.radius = Checks.size("radius", radius);
        this.segment = Checks.halved("segment", segment);
    }

    @Override
    CapsuleObject with(Tag newTag, Pose newPose) {
        return new CapsuleObject(newTag, newPose, radius, segment);
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
