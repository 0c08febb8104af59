package robosim.geometry.model;

import robosim.geometry.check.Checks;
import robosim.geometry.model.GeometryObject.RoundedBox;

/**
 * A solid capsule: all points within a radius of a segment along its own Y, placed by its centre. A leg, an arm, a person.
 */
public final class CapsuleObject extends PlacedObject<CapsuleObject> implements GeometryObject {
    private static final long serialVersionUID = 1;

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
        this(tag, pose, RoundedBox.segment(0, Checks.size("radius", radius), Checks.halved("segment", segment)));
    }

    private CapsuleObject(Tag tag, Pose pose, RoundedBox box) {
        super(tag, pose, box);
    }

    @Override
    CapsuleObject with(Tag newTag, Pose newPose) {
        return new CapsuleObject(newTag, newPose, roundedBox());
    }

    @Override
    public Kind kind() {
        return Kind.CAPSULE;
    }

    /** Radius in world units. */
    public double radius() {
        return roundedBox().ball();
    }

    /** Length of the segment in world units, without the two round ends. */
    public double segment() {
        return 2 * roundedBox().halfHeight();
    }

    /** Extent along the own Y in world units: the segment and a radius at either end, rounded. */
    public double height() {
        return segment() + 2 * radius();
    }

    @Override
    public double[] sizes() {
        return new double[] {radius(), segment()};
    }
}
