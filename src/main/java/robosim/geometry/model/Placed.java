package robosim.geometry.model;

import java.util.Objects;
import org.jspecify.annotations.Nullable;

/** What the five shapes have in common: a name, whether they move, and a pose. */
abstract class Placed<T extends GeometryObject> {
    private final Tag tag;
    private final Pose pose;

    /** A name and whether the object moves. */
    record Tag(@Nullable String name, boolean moveable) {
        static final Tag NONE = new Tag(null, false);

        Tag {
            if (moveable && name == null) {
                throw new IllegalArgumentException("name must be given for a moveable object (got: null)");
            }
        }
    }

    Placed(Tag tag, Pose pose) {
        this.tag = tag;
        this.pose = pose;
    }

    /** The same shape under another tag and pose. */
    abstract T with(Tag newTag, Pose newPose);

    final Tag tag() {
        return tag;
    }

    public final @Nullable String name() {
        return tag.name();
    }

    public final boolean isMoveable() {
        return tag.moveable();
    }

    public final Pose pose() {
        return pose;
    }

    public final T named(String name) {
        return with(new Tag(Checks.name(name), tag.moveable()), pose);
    }

    public final T moveable(String name) {
        return with(new Tag(Checks.name(name), true), pose);
    }

    public final T movedTo(Point center) {
        return with(tag, pose.movedTo(center));
    }

    public final T turned(double rx, double ry) {
        return with(tag, pose.turned(rx, ry));
    }

    public final T oriented(double[] rotation) {
        return with(tag, pose.oriented(rotation));
    }

    public final T at(Pose place) {
        return with(tag, Checks.present("pose", place));
    }

    final boolean samePlace(Placed<?> that) {
        return tag.equals(that.tag) && pose.equals(that.pose);
    }

    final int placeHash() {
        return Objects.hash(tag, pose);
    }

    /** The end of a text for people: what the object is called and where it is. */
    final String placeText() {
        return (tag.name() == null ? "" : " \"" + tag.name() + "\"") + " at " + pose;
    }
}
