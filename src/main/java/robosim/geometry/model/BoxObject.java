package robosim.geometry.model;

import robosim.geometry.check.Checks;
import robosim.geometry.model.GeometryObject.RoundedBox;

/** A solid box, placed by its centre; width along its own X, height along Y, length along Z. */
public final class BoxObject extends PlacedObject<BoxObject> implements GeometryObject {
    private static final long serialVersionUID = 1;

    /**
     * An upright box facing +X.
     *
     * @param center the middle of the box
     * @param width  extent along X in world units; at least 0
     * @param height extent along Y
     * @param length extent along Z
     */
    public BoxObject(Point center, double width, double height, double length) {
        this(Tag.NONE, Pose.of(center, 0), width, height, length);
    }

    BoxObject(Tag tag, Pose pose, double width, double height, double length) {
        this(
                tag,
                pose,
                RoundedBox.box(
                        Checks.halved("width", width),
                        Checks.halved("height", height),
                        Checks.halved("length", length)));
    }

    private BoxObject(Tag tag, Pose pose, RoundedBox box) {
        super(tag, pose, box);
    }

    @Override
    BoxObject with(Tag newTag, Pose newPose) {
        return new BoxObject(newTag, newPose, roundedBox());
    }

    @Override
    public Kind kind() {
        return Kind.BOX;
    }

    /** Extent along the own X, world units. */
    public double width() {
        return 2 * roundedBox().halfWidth();
    }

    /** Extent along the own Y, world units. */
    public double height() {
        return 2 * roundedBox().halfHeight();
    }

    /** Extent along the own Z, world units. */
    public double length() {
        return 2 * roundedBox().halfLength();
    }

    @Override
    public double[] sizes() {
        return new double[] {width(), height(), length()};
    }

    @Override
    public String toString() {
        return "box" + tag.text(pose) + ", " + width() + " x " + height() + " x " + length();
    }
}
