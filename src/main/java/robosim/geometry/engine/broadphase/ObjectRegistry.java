package robosim.geometry.engine.broadphase;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import robosim.geometry.engine.objects.ObjectTable;
import robosim.geometry.engine.objects.SharedObjects;
import robosim.geometry.engine.objects.WorldBounds;
import robosim.geometry.exact.Checks;
import robosim.geometry.index.QuadCursor;
import robosim.geometry.index.tiles.NearTarget;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.narrow.Overlap;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.OwnLeaves;

/**
 * Who is in a world: objects come, go and are put elsewhere, the same at every {@link AccuracyView} that has been asked for.
 * What is refused changes nothing.
 */
public final class ObjectRegistry {
    public final ObjectTable bodies;
    public final WorldBounds border;

    /** The world as it is seen where a query does not say how. */
    public final AccuracyView level;

    private final Dimension dimension;
    private final double width;
    private final double length;
    private final Scratch s;
    private final Candidates near;

    /** The levels made so far, the world's own first. */
    private AccuracyView[] levels;

    /** The leaves of an object that is asked about, and their bounds. */
    private final LeafColumn candidate = new LeafColumn(1);

    private final double[] box = new double[6];

    // What is asked: an upright cylinder about all that stand still, or what has been placed about all but one.
    private AccuracyView asked;
    private int ignored;
    private double discX;
    private double discZ;
    private double discRadius;
    private boolean isDoubtful;
    private final NearTarget meetDisc = this::meetDisc;
    /** The static objects that are shared with other worlds; null where there are none. */
    private @Nullable SharedStatics statics;

    private final NearTarget meetCandidate = this::meetCandidate;

    public ObjectRegistry(
            double width,
            double height,
            double length,
            Dimension dimension,
            Accuracy accuracy,
            @Nullable SharedStatics shared,
            Scratch scratch) {
        statics = shared;
        this.width = width;
        this.length = length;
        this.dimension = dimension;
        s = scratch;
        border = new WorldBounds(width, height, length, dimension);
        bodies = shared == null ? new ObjectTable() : new ObjectTable(shared);
        level = new AccuracyView(bodies, accuracy, dimension, width, length, view(accuracy));
        levels = new AccuracyView[] {level};
        asked = level;
        near = new Candidates(bodies);
    }

    /** The static objects that are shared with other worlds; null where there are none. */
    @Nullable
    public SharedStatics statics() {
        return statics;
    }

    /** What is shared as it is seen at an accuracy. */
    private @Nullable AccuracyView view(Accuracy accuracy) {
        return statics == null ? null : statics.view(accuracy);
    }

    /** The world as it is seen at an accuracy, made when it is first asked. */
    public AccuracyView at(Accuracy asked) {
        Checks.present("accuracy", asked);
        for (AccuracyView each : levels) {
            if (each.accuracy == asked) {
                return each;
            }
        }
        AccuracyView made = new AccuracyView(bodies, asked, dimension, width, length, view(asked));
        IntStream.range(0, bodies.limit()).filter(bodies::isPresent).forEach(id -> made.add(id, bodies.present(id)));
        levels = Arrays.copyOf(levels, levels.length + 1);
        levels[levels.length - 1] = made;
        return made;
    }

    /** Adds an object; a checked one only where it touches nothing. */
    public boolean add(GeometryObject object, boolean checked) {
        String name = Checks.present("object", object).name();
        if (name != null && bodies.find(name) >= 0) {
            throw new IllegalArgumentException("name must be unique in its world (got: \"" + name + "\" again)");
        }
        if (!fitsAsPlaced(object) || (checked && touchesAny())) {
            return false;
        }
        int id = bodies.add(object);
        level.add(id, object, candidate, box);
        for (int k = 1; k < levels.length; k++) {
            levels[k].add(id, object);
        }
        return true;
    }

    /** Adds an object that has been in such a world, at its place among the arrivals there. */
    public void restore(GeometryObject object, long arrival) {
        bodies.arriveAt(arrival);
        int id = bodies.add(object);
        for (AccuracyView each : levels) {
            each.add(id, object);
        }
    }

    /** Makes static objects that are shared with other worlds this world's own, so that they can be taken out. */
    private void unshare(SharedObjects shared) {
        statics = null;
        bodies.unshare();
        for (AccuracyView each : levels) {
            each.unshare();
        }
        long arrivals = bodies.arrivals();
        for (int id = 0; id < shared.bodies.limit(); id++) {
            restore(shared.bodies.value(id), shared.arrival(id));
        }
        bodies.arriveAt(arrivals);
    }

    /** Places an object at the world's own level, with its bounds; false where the object itself is not in the world. */
    private boolean fitsAsPlaced(GeometryObject object) {
        boolean isExact = level.accuracy == Accuracy.EXACT;
        if (!isExact && !fits(object)) {
            return false;
        }
        level.placed(object, candidate);
        level.outline(candidate, box);
        return !isExact || border.clearlyHolds(box) || border.holds(candidate, 0, candidate.size());
    }

    /** Whether what has been placed touches or overlaps any object in the world. */
    private boolean touchesAny() {
        AccuracyView shared = level.shared();
        return touchesAny(level) || (shared != null && touchesAny(shared));
    }

    private boolean touchesAny(AccuracyView at) {
        if (at.spaceIndex.cursor() != null) {
            return collidesAnywhere(at, -1);
        }
        int near =
                at.cursor.gather(box[0], box[2], box[3], box[5], -1, at.leaves().outlines());
        for (int k = 0; k < near; k++) {
            int other = at.cursor.gathered(k);
            if ((dimension == Dimension.PLANAR || at.meets(other, box)) && touches(at, other)) {
                return true;
            }
        }
        return collidesBeside(at, -1);
    }

    /** Whether what has been placed touches one of the moveable objects that are not in the tree. */
    private boolean collidesBeside(AccuracyView at, int but) {
        for (int k = 0; k < at.moversBesideTree(); k++) {
            int other = bodies.mover(k);
            if (other != but && at.meets(other, box) && touches(at, other)) {
                return true;
            }
        }
        return false;
    }

    public boolean remove(String name) {
        int id = bodies.find(Checks.present("name", name));
        if (id < 0) {
            return false;
        }
        SharedStatics shared = statics;
        if (id >= ObjectTable.SHARED && shared != null) {
            unshare(shared);
            id = bodies.find(name);
        }
        for (AccuracyView each : levels) {
            each.remove(id);
        }
        bodies.remove(id);
        return true;
    }

    /** Puts a moveable object upright at a place where it touches nothing. */
    public boolean place(int id, Point center, double heading) {
        GeometryObject placed =
                bodies.value(id).at(Pose.of(Checks.present("center", center), Checks.angle("heading", heading)));
        if (!fits(placed) || collides(level, placed, id)) {
            return false;
        }
        bodies.put(id, placed.pose());
        moved(id);
        return true;
    }

    /** Puts a moveable object where a motion ends. */
    public void move(int id, double[] place) {
        bodies.put(id, place);
        moved(id);
    }

    /** Moves the centre of an object, which keeps its attitude; six numbers, see {@link ObjectTable#shift}. */
    public void shift(int id, double[] centre) {
        bodies.shift(id, centre);
        for (AccuracyView each : levels) {
            each.shift(id, bodies.places(), bodies.place(id));
        }
    }

    private void moved(int id) {
        for (AccuracyView each : levels) {
            each.move(id, bodies.places(), bodies.place(id));
        }
    }

    private boolean fits(GeometryObject object) {
        OwnLeaves.placed(object, candidate);
        return border.holds(candidate, 0, candidate.size());
    }

    /** Whether an object would touch or overlap any in the world but one; any with -1. */
    public boolean collides(AccuracyView at, GeometryObject object, int but) {
        ignored = but;
        AccuracyView shared = at.shared();
        if (at.isFlat
                && shared == null
                && Checks.present("object", object) instanceof CylinderObject cylinder
                && cylinder.pose().isUpright()) {
            int near = quickly(at, cylinder);
            if (near == QuadCursor.ENOUGH || (near == QuadCursor.ALL && at.moversBesideTree() == 0)) {
                return near == QuadCursor.ENOUGH;
            }
        }
        at.placed(Checks.present("object", object), candidate);
        if (candidate.size() == 1) {
            candidate.roughBounds(0, box);
        } else {
            at.boundsOf(candidate, 0, candidate.size(), box);
        }
        return collidesIn(at, but) || (shared != null && collidesIn(shared, but));
    }

    /**
     * Whether an upright cylinder touches one that is in the tree and stands still: enough where it does, all where it does
     * not, too many where it is not told so quickly, as with a moveable one nearby.
     */
    private int quickly(AccuracyView at, CylinderObject cylinder) {
        ask(at);
        Point c = cylinder.center();
        discX = c.x();
        discZ = c.z();
        discRadius = cylinder.radius();
        isDoubtful = false;
        int near =
                at.cursor.near(discX, discZ, discRadius, discRadius, at.leaves().outlines(), meetDisc);
        return near == QuadCursor.ALL && isDoubtful ? QuadCursor.TOO_MANY : near;
    }

    /** A reference is only written where it is another: that is slow. */
    private void ask(AccuracyView at) {
        if (asked != at) {
            asked = at;
        }
    }

    private boolean meetDisc(int id) {
        int sure = Overlap.sure(discX, discZ, discRadius, asked.leaves(), id);
        isDoubtful |= sure == 0;
        return sure < 0;
    }

    private boolean collidesIn(AccuracyView at, int but) {
        int near = QuadCursor.TOO_MANY;
        if (at.spaceIndex.cursor() == null) {
            ask(at);
            double x = box[0] / 2 + box[3] / 2;
            double z = box[2] / 2 + box[5] / 2;
            double halfX = QuadCursor.half(box[0], box[3]);
            double halfZ = QuadCursor.half(box[2], box[5]);
            near = at.cursor.near(x, z, halfX, halfZ, at.leaves().outlines(), meetCandidate);
        }
        return near == QuadCursor.TOO_MANY
                ? collidesAnywhere(at, but)
                : near == QuadCursor.ENOUGH || collidesBeside(at, but);
    }

    private boolean meetCandidate(int id) {
        boolean isOther = (id | asked.mark) != ignored;
        return isOther && (dimension == Dimension.PLANAR || asked.meets(id, box)) && touches(asked, id);
    }

    private boolean collidesAnywhere(AccuracyView at, int but) {
        near.findIn(at, box, but);
        for (int k = 0; k < near.count(); k++) {
            if (touches(at, ObjectTable.bare(near.id(k)))) {
                return true;
            }
        }
        return false;
    }

    private boolean touches(AccuracyView at, int other) {
        for (int j = at.first(other); j < at.first(other) + at.count(other); j++) {
            for (int i = 0; i < candidate.size(); i++) {
                if (Overlap.test(dimension, candidate, i, at.leaves(), j, s)) {
                    return true;
                }
            }
        }
        return false;
    }

    /** All objects at their present places, in the order in which they were added. */
    public List<GeometryObject> present() {
        List<GeometryObject> objects = new ArrayList<>(bodies.size());
        bodies.ids().forEach(id -> objects.add(bodies.present(id)));
        return List.copyOf(objects);
    }

    /** The id of an object that must be there. */
    public int known(String name) {
        int id = bodies.find(Checks.present("name", name));
        if (id < 0) {
            throw new IllegalArgumentException("name must be that of an object in the world (got: \"" + name + "\")");
        }
        return id;
    }

    /** The id of a moveable object that must be there. */
    public int mover(String name) {
        int id = known(name);
        if (!bodies.isMoveable(id)) {
            throw new IllegalArgumentException(
                    "name must be that of a moveable object; this one is static (got: \"" + name + "\")");
        }
        return id;
    }
}
