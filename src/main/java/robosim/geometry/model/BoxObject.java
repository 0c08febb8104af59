package robosim.geometry.model;

import java.io.InvalidObjectException;
import java.io.ObjectInputStream;
import java.io.Serial;
import java.util.Objects;
import robosim.geometry.check.Checks;

/** A solid box, placed by its centre; width along its own X, height along Y, length along Z. */
public final class BoxObject extends PlacedObject<BoxObject> implements GeometryObject {
    private static final long serialVersionUID = 1;

    private final transient double width;
    private final transient double height;
    private final transient double length;

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
        super(tag, pose);
        this.width = Checks.halved("width", width);
        this.height = Checks.halved("height", height);
        this.length = Checks.halved("length", length);
    }

    @Override
    BoxObject with(Tag newTag, Pose newPose) {
        return new BoxObject(newTag, newPose, width, height, length);
    }

    @Override
    public Kind kind() {
        return Kind.BOX;
    }

    /** Extent along the own X, world units. */
    public double width() {
        return width;
    }

    /** Extent along the own Y, world units. */
    public double height() {
        return height;
    }

    /** Extent along the own Z, world units. */
    public double length() {
        return length;
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof BoxObject that
                && width == that.width
                && height == that.height
                && length == that.length
                && tag.equals(that.tag)
                && pose.equals(that.pose);
    }

    @Override
    public int hashCode() {
        return 31 * Objects.hash(tag, pose) + Double.hashCode(width + 3 * height + 7 * length);
    }

    @Override
    public String toString() {
        return "box" + tag.text(pose) + ", " + width + " x " + height + " x " + length;
    }

    @Serial
    private Object writeReplace() {
        return SerialForms.of(this, new SerialForms.Box(SerialForms.Place.of(this), width, height, length));
    }

    @Serial
    private void readObject(ObjectInputStream in) throws InvalidObjectException {
        throw SerialForms.formRequired();
    }
}
