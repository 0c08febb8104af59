package robosim.geometry.collision;

import org.jspecify.annotations.Nullable;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Pose;
import robosim.geometry.model.Ray;
import robosim.geometry.narrow.Overlap;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.LocalLeaves;

/**
 * Two queries about single objects of any shape in space: do two of them collide, and how far along a ray is one. For
 * many objects use a world, which tests only those that are near: {@link robosim.geometry.Geometry}.
 *
 * <pre>{@code
 * BoxObject crate = new BoxObject(new Point(0, 0, 0), 2, 2, 2);
 * CollisionDetection.intersects(crate, new SphereObject(new Point(2, 0, 0), 1));   // true: they touch
 * CollisionDetection.intersects(crate, new SphereObject(new Point(2.1, 0, 0), 1)); // false
 * Ray ray = new Ray(new Point(-5, 0, 0), new Point(1, 0, 0));
 * CollisionDetection.rayDistance(ray, crate);                                      // 4.0
 * }</pre>
 */
public final class CollisionDetection {
    private static final ThreadLocal<CollisionDetection> MEMORY = ThreadLocal.withInitial(CollisionDetection::new);

    private final Scratch scratch = new Scratch();
    private final LeafColumn first = new LeafColumn(1);
    private final LeafColumn second = new LeafColumn(1);

    private CollisionDetection() {}

    /**
     * Whether two objects touch or overlap, that is, have a point in common, heights included. Their order makes no
     * difference.
     */
    public static boolean intersects(GeometryObject a, GeometryObject b) {
        if (a == null || b == null) {
            throw new IllegalArgumentException((a == null ? "a" : "b") + " must be given (got: null)");
        }
        CollisionDetection memory = MEMORY.get();
        LeafColumn ofA = Parts.leaves(a, memory.first);
        LeafColumn ofB = Parts.leaves(b, memory.second);
        return memory.mayTouch(a, ofB) && memory.mayTouch(b, ofA) && memory.touch(ofA, ofB);
    }

    private boolean touch(LeafColumn one, LeafColumn other) {
        return Overlap.any(Dimension.SPATIAL, one, other, 0, other.size(), scratch);
    }

    /**
     * Whether the bounding volume that an object was given, if any, meets the other object. It can only rule out
     * contact.
     */
    private boolean mayTouch(GeometryObject object, LeafColumn other) {
        GeometryObject volume = boundingVolume(object);
        return volume == null || touch(LocalLeaves.placed(volume), other);
    }

    private static @Nullable GeometryObject boundingVolume(GeometryObject object) {
        GeometryObject volume = object instanceof MeshObject mesh
                ? mesh.boundingVolume()
                : object instanceof ObjectGroup group ? group.boundingVolume() : null;
        // The volume was checked to enclose the object only in the object's own frame, so only unplaced are its numbers
        // exact.
        return volume != null && object.pose().equals(Pose.ORIGIN) ? volume : null;
    }

    /**
     * Distance along a ray from its start to an object, in world units.
     *
     * @return 0 if the ray starts inside a solid or on the object; {@code +Infinity} if it misses
     */
    public static double rayDistance(Ray ray, GeometryObject object) {
        if (ray == null || object == null) {
            throw new IllegalArgumentException((ray == null ? "ray" : "object") + " must be given (got: null)");
        }
        return ContactQuery.beamDistance(ray, 0, object);
    }
}
