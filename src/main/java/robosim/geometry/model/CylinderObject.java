package robosim.geometry.model;

import java.io.InvalidObjectException;
import java.io.ObjectInputStream;
import java.io.Serial;
import java.util.Objects;
import robosim.geometry.check.Checks;

/** A solid cylinder, placed by its centre; its axis is its own Y. */
public final class CylinderObject extends PlacedObject<CylinderObject> implements GeometryObject {
    private static final long serialVersionUID = 1;

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
        super(tag, pose);
        this.radius = Checks.size("radius", radius);
        this.height = Checks.halved("height", height);
    }

    @Override
    CylinderObject with(Tag newTag, Pose newPose) {
        return new CylinderObject(newTag, newPose, radius, height);
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
