package robosim.geometry.engine.broadphase;

import java.lang.ref.SoftReference;
import java.util.Arrays;
import java.util.Iterator;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.check.NearNames;
import robosim.geometry.engine.objects.Attachments;
import robosim.geometry.engine.objects.ObjectLeaves;
import robosim.geometry.engine.objects.ObjectTable;
import robosim.geometry.engine.objects.SharedObjectTable;
import robosim.geometry.engine.objects.WorldBounds;
import robosim.geometry.exact.WorkCounter;
import robosim.geometry.index.QuadCursor;
import robosim.geometry.index.tiles.NearTarget;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.narrow.Overlap;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.LocalLeaves;

/**
 * The objects of a world: they are added, removed and moved, in the table of objects and in every {@link AccuracyView} that
 * has been asked for. A refused change changes nothing.
 */
public final class ObjectRegistry {
    public final ObjectTable objects;
    public final WorldBounds worldBounds;

    /** Which objects are attached to others. */
    public final Attachments attachments = new Attachments();

    /** Attaches and detaches. */
    public final ObjectAttacher attacher = new ObjectAttacher(this);

    /** The world as it is seen where a query does not say how. */
    public final AccuracyView view;

    public final Dimension dimension;
    public final double width;
    public final double height;
    public final double length;
    private final Scratch s;

    /** Counts what is done. */
    public final WorkCounter work;

    /** So many cells of a grid are looked at in about the time of a unit. */
    private static final int CELLS = 64;

    /** What limits a call; null for nothing. */
    private WorkCounter.@Nullable Limit limit;

    /** The views made so far, the world's own first. */
    private AccuracyView[] views;

    /** The leaves of an object that is asked about, and their bounds. */
    private final LeafColumn candidate = new LeafColumn(1);

    private final double[] box = new double[6];

    private final BoxQuery overlaps;

    // The upright cylinder about which a world without heights is asked, and whether something near it needs a closer
    // look.
    private LeafTable asked;

    private double discX;
    private double discZ;
    private double discRadius;
    private boolean isDoubtful;
    private final NearTarget hitDisc = this::hitDisc;

    /** The static objects that are shared with other worlds; null where there are none. */
    private @Nullable SharedIndex shared;

    /** The static objects as they were last shared, and when; forgotten where memory runs short. */
    private SoftReference<SharedIndex> lastShared = new SoftReference<>(null);

    private long sharedAt;

    /** What was changed since the outermost call that is made of others began; null outside of one. */
    private @Nullable UndoLog journal;

    /**
     * A world without objects of its own.
     *
     * @param shared  static objects that other worlds have too; null for none
     * @param scratch may be shared with other worlds of the same thread
     */
    public ObjectRegistry(
            double width,
            double height,
            double length,
            Dimension dimension,
            Accuracy accuracy,
            @Nullable SharedIndex shared,
            Scratch scratch) {
        this.shared = shared;
        this.width = width;
        this.height = height;
        this.length = length;
        this.dimension = dimension;
        s = scratch;
        work = scratch.work;
        worldBounds = new WorldBounds(width, height, length, dimension);
        objects = shared == null ? new ObjectTable() : new ObjectTable(shared);
        view = new AccuracyView(objects, accuracy, dimension, width, length, shared(accuracy, dimension));
        views = new AccuracyView[] {view};
        asked = view.own;
        overlaps = new BoxQuery(objects, this::touches);
    }

    /** Limits each call from now on; null for no limit. */
    public void limit(WorkCounter.@Nullable Limit of) {
        limit = of;
    }

    public boolean isLimited() {
        return limit != null;
    }

    /** Begins a call, which has the whole budget unless it is a part of another one. */
    public void begin(String call) {
        work.begin(limit, call);
    }

    /** Begins a call that is made of others, up to {@link #close}. */
    public void open(String call) {
        work.open(limit, call);
    }

    /** Ends a call that was opened. */
    public void close() {
        work.close();
    }

    /**
     * Makes calls as one, with one budget; if they throw, the world is put back as it was.
     *
     * @param call what it is called in messages
     */
    public <T extends @Nullable Object> T together(String call, Supplier<T> calls) {
        work.open(limit, call);
        UndoLog outer = journal;
        UndoLog own = new UndoLog(this);
        journal = own;
        boolean isMade = false;
        try {
            T result = calls.get();
            isMade = true;
            return result;
        } finally {
            journal = null;
            if (!isMade) {
                own.undo();
            } else if (outer != null) {
                outer.add(own);
            }
            journal = outer;
            work.close();
        }
    }

    /**
     * The static objects for other worlds to share: as they were shared last, unless any has come or gone since.
     *
     * @param made takes in all of them
     */
    public SharedIndex share(Supplier<SharedIndex> made) {
        if (shared != null && objects.ownStatics() == 0) {
            return shared;
        }
        SharedIndex last = lastShared.get();
        if (last == null || sharedAt != objects.changesOfStatics()) {
            last = made.get();
            lastShared = new SoftReference<>(last);
            sharedAt = objects.changesOfStatics();
        }
        return last;
    }

    /** What is shared as it is seen at an accuracy. */
    private @Nullable LeafTable shared(Accuracy accuracy, Dimension seen) {
        return shared == null ? null : shared.table(accuracy, seen);
    }

    /** The world as it is seen at an accuracy, made when it is first asked. */
    public AccuracyView at(Accuracy asked) {
        return at(Checks.present("accuracy", asked), dimension);
    }

    /** The world with the heights of its objects, made when a PLANAR one is first asked. */
    public AccuracyView withHeights() {
        return at(view.accuracy, Dimension.SPATIAL);
    }

    private AccuracyView at(Accuracy asked, Dimension seen) {
        for (AccuracyView each : views) {
            if (each.accuracy == asked && each.dimension == seen) {
                each.catchUp(objects);
                return each;
            }
        }
        AccuracyView made = new AccuracyView(objects, asked, seen, width, length, shared(asked, seen));
        IntStream.range(0, objects.limit()).filter(objects::isPresent).forEach(id -> made.add(id, objects.present(id)));
        views = Arrays.copyOf(views, views.length + 1);
        views[views.length - 1] = made;
        return made;
    }

    /** Adds an object; a checked one only where it touches nothing. */
    public boolean add(GeometryObject object, boolean checked) {
        String name = Checks.present("object", object).name();
        if (name != null && (objects.find(name) >= 0 || attachments.root(name) != null)) {
            throw new IllegalArgumentException("name must be unique in its world (got: \"" + name + "\" again)");
        }
        attachments.check(object, objects);
        work.take(parts(object));
        if (!fitsAsPlaced(object) || (checked && touchesAny())) {
            return false;
        }
        int id = objects.add(object);
        view.own.add(id, object, candidate, box);
        for (int k = 1; k < views.length; k++) {
            views[k].add(id, object);
        }
        attachments.added(object, objects.arrival(id));
        if (journal != null) {
            journal.added(id);
        }
        return true;
    }

    /**
     * Units of work that adding an object takes, for the trees over its faces, members or cells and the index of the world: these
     * are built once, at the first use of any, so whoever uses them first is not charged for them.
     */
    private static long parts(GeometryObject object) {
        return switch (object.kind()) {
            case BOX, CYLINDER, SPHERE, CAPSULE -> 1;
            case MESH -> ((MeshObject) object).triangles().size();
            case GROUP ->
                ((ObjectGroup) object)
                        .members().stream().mapToLong(ObjectRegistry::parts).sum();
            case GRID ->
                ((GridObject) object).rows()
                        + (long) ((GridObject) object).rows() * ((GridObject) object).columns() / CELLS;
        };
    }

    /** Adds an object that has been in such a world, at its place among the arrivals there. */
    public int restore(GeometryObject object, long arrival) {
        objects.arriveAt(arrival);
        int id = objects.addAt(object, arrival);
        for (AccuracyView each : views) {
            each.add(id, object);
        }
        attachments.added(object, arrival);
        return id;
    }

    /** Makes static objects that are shared with other worlds this world's own, so that they can be taken out. */
    private void unshare(SharedObjectTable others) {
        shared = null;
        objects.unshare();
        for (AccuracyView each : views) {
            each.shared = null;
        }
        long arrivals = objects.arrivals();
        for (int id = 0; id < others.objects.limit(); id++) {
            restore(others.objects.value(id), others.arrival(id));
        }
        objects.arriveAt(arrivals);
    }

    /** Places an object as the world's own view has it, with its bounds; false where the object itself is not in the world. */
    private boolean fitsAsPlaced(GeometryObject object) {
        boolean isExact = view.accuracy == Accuracy.EXACT;
        if (!isExact && !fits(object)) {
            return false;
        }
        view.own.placed(object, candidate);
        view.own.outline(candidate, box);
        return !isExact || worldBounds.clearlyHolds(box) || worldBounds.holds(candidate, 0, candidate.size());
    }

    /** Whether the candidate touches or overlaps any object in the world. */
    private boolean touchesAny() {
        int count = overlaps.gather(view, box, -1);
        for (int k = 0; k < count; k++) {
            int other = overlaps.gathered(k);
            if (touches(view.table(other), other)) {
                return true;
            }
        }
        return false;
    }

    public boolean remove(String name) {
        if (attachments.root(Checks.present("name", name)) != null) {
            attacher.detach(name);
        }
        int id = objects.find(name);
        if (id < 0) {
            return false;
        }
        while (objects.value(id) instanceof ObjectGroup group && !group.loads().isEmpty()) {
            attacher.detach(String.valueOf(group.loads().get(0).name()));
            id = objects.find(name);
        }
        SharedIndex others = shared;
        if (ObjectTable.isShared(id) && others != null) {
            unshare(others);
            id = objects.find(name);
        }
        if (journal != null) {
            journal.removes(id);
        }
        remove(id);
        return true;
    }

    void remove(int id) {
        for (AccuracyView each : views) {
            each.catchUp(objects);
            each.own.remove(id);
        }
        attachments.removed(objects.value(id));
        objects.remove(id);
    }

    /** Takes an object out for good. */
    void take(int id) {
        if (journal != null) {
            journal.removes(id);
        }
        remove(id);
    }

    /** Notes that an object has been restored. */
    void note(int id) {
        if (journal != null) {
            journal.added(id);
        }
    }

    /** Puts a moveable object upright at a place where it touches nothing. */
    public boolean place(int id, Point center, double heading) {
        GeometryObject placed =
                objects.value(id).at(Pose.of(Checks.present("center", center), Checks.angle("heading", heading)));
        if (!fits(placed) || collides(view, placed, id)) {
            return false;
        }
        noteMove(id);
        objects.put(id, placed.pose());
        moved(id);
        return true;
    }

    /** Puts a moveable object where a motion ends. */
    public void move(int id, double[] place) {
        noteMove(id);
        objects.put(id, place);
        moved(id);
    }

    /** Moves the centre of an object, which keeps its attitude; six numbers, see {@link ObjectTable#shift}. */
    public void shift(int id, double[] centre) {
        noteMove(id);
        objects.shift(id, centre);
        view.own.shift(id, objects.places(), objects.place(id));
        noteMoved(id);
    }

    private void noteMove(int id) {
        if (journal != null) {
            journal.moves(id);
        }
    }

    private void moved(int id) {
        view.own.move(id, objects.places(), objects.place(id));
        noteMoved(id);
    }

    /** Views other than the world's own are updated by their next query. */
    private void noteMoved(int id) {
        for (int k = 1; k < views.length; k++) {
            views[k].noteMoved(id);
        }
    }

    /** Whether an object lies within the world, exactly. */
    public boolean fits(GeometryObject object) {
        LocalLeaves.placed(object, candidate);
        return worldBounds.holds(candidate, 0, candidate.size());
    }

    /**
     * Whether an object would touch or overlap any in the world.
     *
     * @param ignored an object that is left out; -1 for none
     */
    public boolean collides(AccuracyView at, GeometryObject object, int ignored) {
        LeafTable own = at.own;
        if (own.isFlat
                && Checks.present("object", object) instanceof CylinderObject cylinder
                && cylinder.pose().isUpright()) {
            discX = cylinder.center().x();
            discZ = cylinder.center().z();
            discRadius = cylinder.radius();
            LeafTable others = at.shared;
            int met = others == null ? QuadCursor.ALL : probe(others);
            if (met == QuadCursor.ALL && !own.hasEmptyTrees()) {
                met = probe(own);
            }
            if (met == QuadCursor.ENOUGH) {
                return true;
            }
            if (met == QuadCursor.ALL) {
                return touchesBesideTrees(at, cylinder, ignored);
            }
        }
        own.placed(Checks.present("object", object), candidate);
        return collides(at, ignored);
    }

    /** Whether an upright cylinder that touches nothing in the trees touches what is in none. */
    private boolean touchesBesideTrees(AccuracyView at, CylinderObject cylinder, int ignored) {
        LeafTable others = at.shared;
        boolean isAll = at.own.hasAllInTrees() && (others == null || others.hasAllInTrees());
        if (isAll) {
            return false;
        }
        outline(0, discX);
        outline(2, discZ);
        boolean isOwn = overlaps.hasBesideTree(at.own, box, ignored);
        if (!isOwn && (others == null || !overlaps.hasBesideTree(others, box, ignored))) {
            return false; // placing it takes longer than all this
        }
        at.own.placed(cylinder, candidate);
        return overlaps.probeBesideTree(at.own, box, ignored)
                || (others != null && overlaps.probeBesideTree(others, box, ignored));
    }

    /** Writes bounds of the disc along an axis, rounded outward. */
    private void outline(int axis, double middle) {
        double half = discRadius + (0x1p-51 * (Math.abs(middle) + discRadius) + Double.MIN_NORMAL);
        box[axis] = middle - half;
        box[3 + axis] = middle + half;
    }

    /** Whether the candidate touches or overlaps any object that is not ignored. */
    private boolean collides(AccuracyView at, int ignored) {
        if (candidate.size() == 1) {
            candidate.roughBounds(0, box);
        } else {
            candidate.bounds(0, candidate.size(), box);
        }
        return overlaps.probe(at, box, ignored);
    }

    /** Whether a moveable object would touch or overlap any other one at another place, laid out as in the table of objects. */
    public boolean collidesAt(AccuracyView at, int id, double[] place) {
        ObjectLeaves form = at.form(id);
        candidate.clear();
        candidate.append(form.size());
        form.place(dimension, place[0], place[1], place[2], place, 3, candidate, 0);
        return collides(at, id);
    }

    /**
     * The same at one more place with the same attitude, directly after {@link #collidesAt}, for an object of one leaf about its
     * centre.
     */
    public boolean collidesShifted(AccuracyView at, int id, double[] place) {
        double[] row = candidate.rows();
        row[0] = place[0];
        row[1] = place[1];
        row[2] = place[2];
        return collides(at, id);
    }

    /** Whether what {@link #collidesAt} has just placed is within the world, and not near its border. */
    public boolean isClearlyInside() {
        return worldBounds.clearlyHolds(box);
    }

    /** Whether a moveable object would be within the world at another place. */
    public boolean fitsAt(int id, double[] place) {
        LocalLeaves own = view.form(id).own;
        candidate.clear();
        candidate.append(own.size());
        own.place(place[0], place[1], place[2], place, 3, candidate, 0);
        return worldBounds.holds(candidate, 0, candidate.size());
    }

    /**
     * Whether an upright cylinder touches one that is in the tree and stands still: enough where it does, all where it does
     * not, too many where it is not told so quickly, as with a moveable one nearby.
     */
    private int probe(LeafTable table) {
        isDoubtful = false;
        if (asked != table) { // writing a reference is slow
            asked = table;
        }
        int met = table.cursor.near(
                discX, discZ, discRadius, discRadius, table.leaves().outlines(), hitDisc);
        return met == QuadCursor.ALL && isDoubtful ? QuadCursor.TOO_MANY : met;
    }

    private boolean hitDisc(int id) {
        int sure = Overlap.sure(discX, discZ, discRadius, asked.leaves(), id);
        isDoubtful |= sure == 0;
        return sure < 0;
    }

    /** Whether the leaves of the candidate touch those of an object. */
    private boolean touches(LeafTable at, int other) {
        if (objects.ignored.has(other)) {
            return false;
        }
        if (dimension == Dimension.SPATIAL && !at.overlaps(other, box)) {
            return false;
        }
        return Overlap.any(dimension, candidate, at.leaves(), at.first(other), at.count(other), s);
    }

    /** All objects at their present places, in the order in which they were added. */
    public List<GeometryObject> present() {
        return objects.ids().mapToObj(objects::present).toList();
    }

    /** The id of an object that must be there. */
    public int known(String name) {
        int id = objects.find(Checks.present("name", name));
        String root = id < 0 ? attachments.root(name) : null;
        if (root != null) {
            throw new IllegalArgumentException("name must be that of an object of its own; this one is attached to \""
                    + root + "\": use that, or detach it (got: \"" + name + "\")");
        }
        if (id < 0) {
            throw unknown("name must be that of an object", name);
        }
        return id;
    }

    /** Leaves out the objects of some names, and of layers of some names, until {@code objects.ignored.clear()}. */
    public void ignore(Set<String> names) {
        objects.ignored.clear();
        if (names.isEmpty()) {
            return; // so that an ordinary query makes no iterator
        }
        for (String name : names) {
            int id = objects.find(name);
            if (id >= 0) {
                objects.ignored.add(id);
            } else if (!objects.ignored.addLayer(name)) {
                objects.ignored.clear();
                throw unknown("ignored must name an object or a layer", name);
            }
        }
    }

    private IllegalArgumentException unknown(String rule, String name) {
        List<String> near = NearNames.of(name, this::names);
        return new IllegalArgumentException(
                rule + " in the world" + (near.isEmpty() ? "" : ", perhaps \"" + String.join("\", \"", near) + "\"")
                        + " (got: \"" + name + "\")");
    }

    private Iterator<String> names() {
        return objects.ids()
                .mapToObj(id -> objects.present(id).name())
                .filter(Objects::nonNull)
                .map(String::valueOf)
                .iterator();
    }

    /** The id of a moveable object that must be there. */
    public int mover(String name) {
        int id = known(name);
        if (!objects.isMoveable(id)) {
            throw new IllegalArgumentException(
                    "name must be that of a moveable object; this one is static (got: \"" + name + "\")");
        }
        return id;
    }
}
