package robosim.geometry.model;

import robosim.geometry.check.Checks;
import robosim.geometry.model.GeometryObject.RoundedBox;

/** A solid sphere, placed by its centre. It has an attitude too, which defines its forward direction. */
public final class SphereObject extends PlacedObject<SphereObject> implements GeometryObject {
    private static final long serialVersionUID = 1;

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
        this(tag, pose, RoundedBox.segment(0, Checks.size("radius", radius), 0));
    }

    private SphereObject(Tag tag, Pose pose, RoundedBox box) {
        super(tag, pose, box);
    }

    @Override
    SphereObject with(Tag newTag, Pose newPose) {
        return new SphereObject(newTag, newPose, roundedBox());
    }

    @Override
    public Kind kind() {
        return Kind.SPHERE;
    }

    /** Radius in world units. */
    public double radius() {
        return roundedBox().ball();
    }

    @Override
    public double[] sizes() {
        return new double[] {radius()};
    }
}
