package robosim.geometry.model;

import robosim.geometry.check.Checks;
import robosim.geometry.model.GeometryObject.RoundedBox;

/** A solid cylinder, placed by its centre; its axis is its own Y. */
public final class CylinderObject extends PlacedObject<CylinderObject> implements GeometryObject {
    private static final long serialVersionUID = 1;

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
        this(tag, pose, RoundedBox.segment(Checks.size("radius", radius), 0, Checks.halved("height", height)));
    }

    private CylinderObject(Tag tag, Pose pose, RoundedBox box) {
        super(tag, pose, box);
    }

    @Override
    CylinderObject with(Tag newTag, Pose newPose) {
        return new CylinderObject(newTag, newPose, roundedBox());
    }

    @Override
    public Kind kind() {
        return Kind.CYLINDER;
    }

    /** Radius in world units. */
    public double radius() {
        return roundedBox().disc();
    }

    /** Extent along the axis in world units. */
    public double height() {
        return 2 * roundedBox().halfHeight();
    }

    @Override
    public double[] sizes() {
        return new double[] {radius(), height()};
    }
}
