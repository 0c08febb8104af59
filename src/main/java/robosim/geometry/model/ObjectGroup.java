package robosim.geometry.model;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.material.Material;

/**
 * The union of its members, which are given in the group's own frame; groups may hold groups, but no grid.
 *
 * <p>The frame's origin is the group's centre: (0, 0, 0) until it is moved. Inside a group, the names of the members
 * and whether they are moveable have no meaning, except in a carrier.
 *
 * <p>A <i>carrier</i> is a moveable group whose members are all moveable, and whose first member has the group's own name: an object
 * with loads attached to it. The world moves them as one, and {@code Geometry.detach} takes a load off by its name.
 * {@code Geometry.attach} makes such groups; they may also be written down as part of a world.
 */
public final class ObjectGroup extends PlacedObject<ObjectGroup> implements GeometryObject {
    /**
     * Maximum nesting depth of groups; queries recurse into members. The deepest realistic case tried is a shelf in a
     * row in a hall, 3.
     */
    public static final int MAX_DEPTH = 100;

    private static final long serialVersionUID = 1;

    private final transient List<GeometryObject> members;
    private final transient @Nullable GeometryObject boundingVolume;

    /** Nesting depth, this group included. */
    private final transient int depth;

    /**
     * A union.
     *
     * @param members objects in the group's own frame; at least one, with groups nested at most {@link #MAX_DEPTH}
     *     deep, this one included
     */
    public ObjectGroup(List<GeometryObject> members) {
        this(members, null);
    }

    /**
     * A union with a bounding volume, which is tested first and can only rule out contact.
     *
     * @param boundingVolume a box, cylinder or sphere in the own frame that encloses every member; null for a default
     * @throws IllegalArgumentException if it does not enclose them, since collisions would be missed
     */
    public ObjectGroup(List<GeometryObject> members, @Nullable GeometryObject boundingVolume) {
        this(Tag.NONE, Pose.ORIGIN, copy(members), boundingVolume);
        if (boundingVolume != null) {
            Enclosing.check(boundingVolume, this);
        }
    }

    private ObjectGroup(
            Tag tag, Pose pose, List<GeometryObject> members, @Nullable GeometryObject checkedBoundingVolume) {
        super(tag, pose, null);
        this.members = members;
        this.boundingVolume = checkedBoundingVolume;
        int deepest = 0;
        for (GeometryObject member : members) {
            deepest = Math.max(deepest, member instanceof ObjectGroup group ? group.depth : 0);
        }
        this.depth = deepest + 1;
        if (depth > MAX_DEPTH) {
            throw new IllegalArgumentException(
                    "groups must be at most " + MAX_DEPTH + " within each other (got: one more)");
        }
    }

    private static List<GeometryObject> copy(List<GeometryObject> members) {
        if (Checks.present("members", members).isEmpty()) {
            throw new IllegalArgumentException("members must hold at least one object (got: none)");
        }
        int k = 0;
        for (GeometryObject member : members) {
            if (Checks.present("members[" + k++ + "]", member) instanceof GridObject) {
                throw refused(member);
            }
        }
        return List.copyOf(members);
    }

    /** What is thrown for a grid among the members. */
    static IllegalArgumentException refused(GeometryObject grid) {
        return new IllegalArgumentException(
                "members must not hold a grid, which is an object of the world itself (got: " + grid + ")");
    }

    @Override
    ObjectGroup with(Tag newTag, Pose newPose) {
        return new ObjectGroup(newTag, newPose, members, boundingVolume);
    }

    @Override
    public Kind kind() {
        return Kind.GROUP;
    }

    /** The members, in the group's own frame. */
    public List<GeometryObject> members() {
        return members;
    }

    /** What is attached to this object, in its own frame: empty unless it is a carrier. */
    public List<GeometryObject> loads() {
        GeometryObject first = members.get(0);
        return tag.moveable()
                        && Objects.equals(tag.name(), first.name())
                        && members.stream().allMatch(GeometryObject::isMoveable)
                ? members.subList(1, members.size())
                : List.of();
    }

    /** A carrier without its loads, at its place; any other object itself. */
    public static GeometryObject withoutLoads(GeometryObject object) {
        return object instanceof ObjectGroup group && !group.loads().isEmpty()
                ? group.members.get(0).at(group.pose())
                : object;
    }

    /** The members where this group stands, each in the frame in which the group is given. */
    public List<GeometryObject> placedMembers() {
        List<GeometryObject> placed = new ArrayList<>(members.size());
        for (GeometryObject member : members) {
            placed.add(member.at(member.pose().within(pose)));
        }
        return placed;
    }

    /**
     * The members that are no groups themselves, depth first, each placed in this group's own frame and made of what is seen
     * of it: its own material, or where it has none that of the group around it. A walk through all members; the index in
     * the list is what {@code SenseBuffer.part} tells.
     */
    public List<GeometryObject> parts() {
        List<GeometryObject> parts = new ArrayList<>();
        addParts(Pose.ORIGIN, material(), parts);
        return List.copyOf(parts);
    }

    private void addParts(Pose frame, Material around, List<GeometryObject> parts) {
        boolean isPlaced = frame.equals(Pose.ORIGIN); // within() would round its attitude
        for (GeometryObject member : members) {
            Pose place = isPlaced ? member.pose() : member.pose().within(frame);
            Material own = member.material().within(around);
            if (member instanceof ObjectGroup inner) {
                inner.addParts(place, own, parts);
            } else {
                GeometryObject part = isPlaced ? member : member.at(place);
                parts.add(own.equals(part.material()) ? part : part.withMaterial(own));
            }
        }
    }

    /** The bounding volume that was given, in the group's own frame; null if a default is used. */
    public @Nullable GeometryObject boundingVolume() {
        return boundingVolume;
    }

    @Override
    public boolean equals(@Nullable Object other) {
        return other instanceof ObjectGroup that
                && tag.equals(that.tag)
                && pose.equals(that.pose)
                && Objects.equals(boundingVolume, that.boundingVolume)
                && members.equals(that.members);
    }

    @Override
    public int hashCode() {
        return 31 * Objects.hash(tag, pose) + members.hashCode();
    }

    @Override
    public String toString() {
        return "group" + tag.text(pose) + " of " + members.size();
    }
}
