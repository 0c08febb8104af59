package robosim.geometry.model;

import java.io.InvalidObjectException;
import java.io.ObjectInputStream;
import java.io.Serial;
import java.util.Objects;
import robosim.geometry.check.Checks;

/** A solid sphere, placed by its centre. It has an attitude too, which defines its forward direction. */
public final class SphereObject extends PlacedObject<SphereObject> implements GeometryObject {
    private static final long serialVersionUID = 1;

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
        super(tag, pose);
        this.radius = Checks.size("radius", radius);
    }

    @Override
    SphereObject with(Tag newTag, Pose newPose) {
        return new SphereObject(newTag, newPose, radius);
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
