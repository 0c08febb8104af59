package robosim.geometry.engine.motion;

import org.jspecify.annotations.Nullable;
import robosim.geometry.engine.broadphase.AccuracyView;
import robosim.geometry.engine.broadphase.BoxQuery;
import robosim.geometry.engine.broadphase.LeafTable;
import robosim.geometry.engine.broadphase.ObjectRegistry;
import robosim.geometry.engine.objects.ObjectLeaves;
import robosim.geometry.engine.objects.ObjectTable;
import robosim.geometry.engine.objects.WorldBounds;
import robosim.geometry.exact.DoubleDouble;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.Pose;
import robosim.geometry.narrow.Overlap;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.StartContacts;
import robosim.geometry.narrow.Sweep;
import robosim.geometry.narrow.leaf.Enclosure;
import robosim.geometry.narrow.leaf.LeafBoxes;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.LocalLeaves;
import robosim.geometry.narrow.planar.DiscSweepFilter;
import robosim.geometry.narrow.planar.PlainCells;

/**
 * Answers whether a straight move is free, and no more; the verdict is that of {@link Motion}. Most moves meet nothing, and
 * then there is no share and no contact to work out. Reads the world's own columns and places nothing before it is sure.
 */
final class TranslationFastPath {
    /** A yes: {@link #end()} is where the object comes to stand. */
    static final int FREE = 1;

    static final int BLOCKED = -1;

    /** Only {@link Motion} can tell. */
    static final int UNKNOWN = 0;

    /** More than a place loses when it is stored, as a share of its coordinates. */
    private static final double STORED = 0x1p-47;

    /** More than a sweep may stop early, as a share of the coordinates. */
    private static final double EARLY = 0x1p-19;

    /** More than rounding changes a fraction of the displacement. */
    private static final double SHARE = 0x1p-40;

    /** More than the least float. */
    private static final double LEAST = 0x1p-140;

    private final ObjectRegistry registry;
    private final ObjectTable objects;
    private final BoxQuery query;
    private final WorldBounds worldBounds;
    private final Scratch s;
    private final Sweep sweep;
    private final LeafColumn probe = new LeafColumn(1);
    private final double[] box = new double[6];
    private final double[] end = new double[6];

    private AccuracyView view;

    /** Where the object's own leaves and bounds stand. */
    private LeafTable own;

    private int id;
    private double dx;
    private double dy;
    private double dz;
    private boolean hasProbe;

    /** The bounds of the path of each leaf, if there are several. */
    private final LeafBoxes swept = new LeafBoxes();

    private boolean hasSwept;
    private boolean isUnsure;

    // The disc around the object, and by how much it may be off.
    private double ownX;
    private double ownZ;
    private double ownRadius;
    private double ownSlack;

    /** The sum of the coordinates of its bounds, unsigned, without the heights. */
    private double ownSize;

    private boolean ownIsDisc;

    /** Whether the query is about enclosures: then the objects in them must pass too. */
    private boolean isCoarse;

    /** The enclosure at the start, wide enough to hold whatever the object itself may be stopped before. */
    private final LeafColumn wide = new LeafColumn(1);

    private boolean hasWide;

    /** By how much it is wider. */
    private double margin;

    /** Asks about the objects themselves; null until a move at an accuracy below EXACT first needs it. */
    private @Nullable TranslationFastPath shapes;

    private boolean hasShapes;
    private boolean isKnown;
    private double givenX;
    private double givenY;
    private double givenZ;

    @SuppressWarnings("NullAway.Init") // a question sets its view
    TranslationFastPath(ObjectRegistry registry, Scratch scratch) {
        this.registry = registry;
        objects = registry.objects;
        worldBounds = registry.worldBounds;
        s = scratch;
        sweep = new Sweep(scratch);
        query = new BoxQuery(objects);
    }

    /** The centre at the end, and what it has lost; six numbers. */
    double[] end() {
        return end;
    }

    /** Whether an object may go by a displacement in the world's axes: {@link #FREE}, {@link #BLOCKED} or {@link #UNKNOWN}. */
    int find(AccuracyView inView, int mover, double x, double y, double z) {
        if (!begin(inView, mover, x, y, z) || (dx == 0 && dy == 0 && dz == 0)) {
            return UNKNOWN;
        }
        if (!worldBounds.clearlyHolds(box) && !staysLow() && !endsInside()) {
            return BLOCKED;
        }
        int count = query.gather(view, box, id);
        for (int k = 0; k < count; k++) {
            int other = query.gathered(k);
            LeafTable table = view.table(other);
            int one = isCoarse ? coarsely(table, other) : exactly(table, other);
            if (one != FREE) {
                return one;
            }
        }
        return FREE;
    }

    /** Takes a move; false where only {@link Motion} can tell about it. */
    private boolean begin(AccuracyView inView, int mover, double x, double y, double z) {
        view = inView;
        own = inView.table(mover);
        id = mover;
        givenX = x;
        givenY = y;
        givenZ = z;
        isCoarse = view.accuracy != Accuracy.EXACT;
        if (!isCoarse && !view.keepsShape(mover)) {
            return false;
        }
        double[] places = objects.places();
        int at = objects.place(mover);
        dx = advance(places, at, 0, x);
        dy = advance(places, at, 1, y);
        dz = advance(places, at, 2, z);
        hasProbe = false;
        hasSwept = false;
        hasWide = false;
        hasShapes = false;
        isUnsure = false;
        enclose();
        takeSweptBox(places, at);
        return true;
    }

    /** Whether the object passes another one whose bounds may meet those of its path. */
    private int exactly(LeafTable table, int other) {
        int quick = isGrid(table, other) ? pastCells(table, other) : quickly(table, other, isDiscs(table, other));
        if (quick == DiscSweepFilter.MET) {
            return BLOCKED;
        }
        return quick == DiscSweepFilter.CLEAR || !table.overlaps(other, box) || passes(table, other) ? FREE : refusal();
    }

    /** What stands on something may have leave to go on, if not where the insides meet: see {@link StartContacts}. */
    private int refusal() {
        return isUnsure || touches() ? UNKNOWN : BLOCKED;
    }

    /** The same for enclosures, and for the objects in them. */
    private int coarsely(LeafTable table, int other) {
        if (quickly(table, other, false) == DiscSweepFilter.CLEAR || !table.overlaps(other, box)) {
            return FREE;
        }
        if (isGrid(table, other)) {
            return UNKNOWN;
        }
        if (areBoxesPast(table, other)) {
            return FREE;
        }
        int known = view.accuracy == Accuracy.SPHERE ? betweenBalls(table, other, 0) : DiscSweepFilter.UNSURE;
        if (known == DiscSweepFilter.MET) {
            return BLOCKED;
        }
        if (passesWidely(table, other)) {
            return FREE;
        }
        if (known != DiscSweepFilter.CLEAR && !passes(table, other)) {
            return refusal();
        }
        TranslationFastPath exact = shapes();
        return exact != null && exact.exactly(exact.view.table(other), other) == FREE ? FREE : UNKNOWN;
    }

    /** Whether the bounds of two enclosures are apart, and stay so by more than the objects in them need. */
    private boolean areBoxesPast(LeafTable table, int other) {
        double[] b = own.bounds();
        double[] c = table.bounds();
        int at = own.boundsAt(id);
        int to = table.boundsAt(other);
        double enter = 0;
        double leave = 1;
        for (int k = 0; k < 3; k += view.dimension == Dimension.PLANAR ? 2 : 1) {
            double by = k == 0 ? dx : k == 1 ? dy : dz;
            // Between these displacements the two overlap along the axis.
            double least = c[to + k] - b[at + 3 + k] - 2 * margin;
            double most = c[to + 3 + k] - b[at + k] + 2 * margin;
            if (by == 0) {
                if (least > 0 || most < 0) {
                    return true;
                }
            } else {
                enter = Math.max(enter, (by > 0 ? least : most) / by - SHARE);
                leave = Math.min(leave, (by > 0 ? most : least) / by + SHARE);
            }
        }
        return enter > leave;
    }

    /**
     * What doubles can tell of two balls.
     *
     * @param more by how much one is wider; if it is above 0, overlapping balls do not count as past each other
     */
    private int betweenBalls(LeafTable table, int other, double more) {
        int leaf = table.first(other);
        double[] a = own.leaves().rows(own.first(id));
        double[] b = table.leaves().rows(leaf);
        int at = own.leaves().at(own.first(id));
        int to = table.leaves().at(leaf);
        boolean isFlat = view.dimension == Dimension.PLANAR;
        double x = b[to] - a[at];
        double y = isFlat ? 0 : b[to + 1] - a[at + 1];
        double z = b[to + 2] - a[at + 2];
        double reach = a[at + 3] + b[to + 3];
        return more > 0 && x * x + y * y + z * z < reach * reach
                ? DiscSweepFilter.UNSURE
                : DiscSweepFilter.pastBall(x, y, z, dx, isFlat ? 0 : dy, dz, reach, more);
    }

    /**
     * Whether the enclosure, made so much wider that the object itself is not stopped either, is apart from another one and
     * stays so.
     */
    private boolean passesWidely(LeafTable table, int other) {
        if (view.accuracy == Accuracy.SPHERE) {
            return betweenBalls(table, other, margin) == DiscSweepFilter.CLEAR;
        }
        if (!hasWide) {
            hasWide = true;
            wide.clear();
            wide.append(1);
            Enclosure.widen(own.leaves(), own.first(id), margin, wide);
        }
        LeafColumn theirs = table.leaves();
        int leaf = table.first(other);
        if (Overlap.test(view.dimension, wide, 0, theirs, leaf, s)) {
            return false;
        }
        sweep.translation(view.dimension, dx, dy, dz);
        return sweep.free(wide, 0, theirs, leaf) == Double.POSITIVE_INFINITY;
    }

    /** The same move of the object itself; null where only {@link Motion} can tell about it. */
    private @Nullable TranslationFastPath shapes() {
        TranslationFastPath made = shapes;
        if (made == null) {
            made = new TranslationFastPath(registry, s);
            shapes = made;
        }
        if (!hasShapes) {
            hasShapes = true;
            isKnown = made.begin(registry.at(Accuracy.EXACT), id, givenX, givenY, givenZ);
        }
        return isKnown ? made : null;
    }

    /** Whether the object touches another one where it is, and does not overlap it so deeply that it has no say. */
    private boolean touches() {
        System.arraycopy(own.bounds(), own.boundsAt(id), box, 0, 6);
        int count = query.gather(view, box, id);
        for (int k = 0; k < count; k++) {
            int other = query.gathered(k);
            if (touches(view.table(other), other)) {
                return true;
            }
        }
        return false;
    }

    private boolean touches(LeafTable table, int other) {
        if (!table.overlaps(other, box)) {
            return false;
        }
        LeafColumn leaves = own.leaves();
        LeafColumn theirs = table.leaves();
        int first = own.first(id);
        sweep.translation(view.dimension, dx, dy, dz);
        enclose(first, own.count(id));
        for (int j = table.first(other); j < table.first(other) + table.count(other); j++) {
            int near = near(theirs, j);
            for (int k = 0; k < near; k++) {
                int i = first + near(k);
                if (Overlap.test(view.dimension, leaves, i, theirs, j, s)
                        && !Overlap.isDeep(view.dimension, leaves, i, theirs, j, s)) {
                    return true;
                }
            }
        }
        return false;
    }

    /** Writes a coordinate of the end; answers how far it is from the start. */
    private double advance(double[] places, int at, int along, double by) {
        double from = places[at + along];
        double to = from + by;
        double rest = DoubleDouble.sumTail(from, by, to) + places[at + Pose.LOST + along];
        double sum = to + rest;
        end[along] = sum;
        end[3 + along] = DoubleDouble.sumTail(to, rest, sum);
        return sum - from;
    }

    /** Makes the box hold the object all the way, and its end however its parts are rounded when they are placed. */
    private void takeSweptBox(double[] places, int at) {
        double[] b = own.bounds();
        int k = own.boundsAt(id);
        double place = Math.abs(places[at]) + Math.abs(places[at + 1]) + Math.abs(places[at + 2]);
        double way = Math.abs(dx) + Math.abs(dy) + Math.abs(dz);
        double heights = Math.abs(b[k + 1]) + Math.abs(b[k + 4]);
        double size = (ownSize + heights) + (place + (way + way));
        if (isCoarse) {
            margin = MotionSegment.EARLY * size;
            ownSlack += margin;
        }
        double slack = (isCoarse ? MotionSegment.EARLY : STORED) * size + Double.MIN_NORMAL;
        box[0] = b[k] + Math.min(0, dx) - slack;
        box[1] = b[k + 1] + Math.min(0, dy) - slack;
        box[2] = b[k + 2] + Math.min(0, dz) - slack;
        box[3] = b[k + 3] + Math.max(0, dx) + slack;
        box[4] = b[k + 4] + Math.max(0, dy) + slack;
        box[5] = b[k + 5] + Math.max(0, dz) + slack;
    }

    private static boolean isGrid(LeafTable table, int other) {
        return table.leaves().kind(table.first(other)).isGrid();
    }

    /** What doubles can tell of the cells of a grid. */
    private int pastCells(LeafTable table, int other) {
        int first = own.first(id);
        sweep.translation(view.dimension, dx, dy, dz);
        int all = DiscSweepFilter.CLEAR;
        for (int i = first; i < first + own.count(id); i++) {
            int one = sweep.passesCells(own.leaves(), i, table.leaves(), table.first(other));
            if (one == PlainCells.MET) {
                return DiscSweepFilter.MET;
            }
            all = one == PlainCells.PAST ? all : DiscSweepFilter.UNSURE;
        }
        return all;
    }

    /** The disc around the object, as seen from above: its own where it is one, or that through the corners of its bounds. */
    private void enclose() {
        double[] b = own.bounds();
        int at = own.boundsAt(id);
        double minX = b[at];
        double minZ = b[at + 2];
        double maxX = b[at + 3];
        double maxZ = b[at + 5];
        ownIsDisc = own.isDisc(id);
        ownX = 0.5 * minX + 0.5 * maxX; // not its centre, which may be off it where it is a group
        ownZ = 0.5 * minZ + 0.5 * maxZ;
        double halfX = 0.5 * maxX - 0.5 * minX;
        double halfZ = 0.5 * maxZ - 0.5 * minZ;
        ownRadius = ownIsDisc ? Math.max(halfX, halfZ) : Math.sqrt(halfX * halfX + halfZ * halfZ);
        ownSize = (Math.abs(minX) + Math.abs(maxX)) + (Math.abs(minZ) + Math.abs(maxZ));
        ownSlack = 0x1p-50 * ownSize + LEAST;
    }

    /** Whether both are discs and no more; who meets as seen from above may be higher or lower where heights count. */
    private boolean isDiscs(LeafTable table, int other) {
        return ownIsDisc && view.dimension == Dimension.PLANAR && table.isDisc(other);
    }

    /**
     * What doubles can tell, as seen from above, of the discs around the object and around the bounds of another: a disc's
     * own, or that through the corners.
     */
    private int quickly(LeafTable table, int other, boolean isAll) {
        double[] bounds = table.bounds();
        int at = table.boundsAt(other);
        double minX = bounds[at];
        double minZ = bounds[at + 2];
        double maxX = bounds[at + 3];
        double maxZ = bounds[at + 5];
        double halfX = 0.5 * maxX - 0.5 * minX;
        double halfZ = 0.5 * maxZ - 0.5 * minZ;
        boolean isDisc = table.isDisc(other);
        double radius = isDisc ? Math.max(halfX, halfZ) : Math.sqrt(halfX * halfX + halfZ * halfZ);
        double slack = 0x1p-50 * (Math.abs(minX) + Math.abs(maxX) + Math.abs(minZ) + Math.abs(maxZ)) + ownSlack;
        double qx = 0.5 * minX + 0.5 * maxX - ownX;
        double qz = 0.5 * minZ + 0.5 * maxZ - ownZ;
        return DiscSweepFilter.past(qx, qz, dx, dz, ownRadius + radius, slack, isAll);
    }

    private boolean passes(LeafTable table, int other) {
        LeafColumn leaves = own.leaves();
        LeafColumn theirs = table.leaves();
        int first = own.first(id);
        int last = first + own.count(id);
        int others = table.first(other);
        int othersEnd = others + table.count(other);
        sweep.translation(view.dimension, dx, dy, dz);
        enclose(first, last - first);
        for (int j = others; j < othersEnd; j++) {
            int near = near(theirs, j);
            for (int k = 0; k < near; k++) {
                int i = first + near(k);
                // Who touches a mesh or a grid may be stopped by its next piece only where the contacts say so.
                isUnsure = theirs.kind(j).hasPieces() && Overlap.test(view.dimension, leaves, i, theirs, j, s);
                if (isUnsure || sweep.isBlocked(leaves, i, theirs, j, null)) {
                    return false;
                }
            }
        }
        placeProbe();
        for (int j = others; j < othersEnd; j++) {
            int near = near(theirs, j);
            for (int k = 0; k < near; k++) {
                int i = first + near(k);
                if (Overlap.test(view.dimension, probe, i - first, theirs, j, s)) {
                    // Each face of a mesh and each cell of a grid is a piece of its own, any of which may be touched
                    // anew.
                    isUnsure = theirs.kind(j).hasPieces();
                    if (isUnsure || !Overlap.test(view.dimension, leaves, i, theirs, j, s)) {
                        return false;
                    }
                }
            }
        }
        return true;
    }

    /** Bounds the path of each leaf, if there are several. */
    private void enclose(int first, int count) {
        if (count > 1 && !hasSwept) {
            hasSwept = true;
            swept.clear(count, view.dimension == Dimension.PLANAR);
            for (int k = 0; k < count; k++) {
                sweep.bounds(own.leaves(), first + k, swept.box);
                swept.set(k, swept.box);
            }
        }
    }

    /** Finds the leaves that may touch one of another object along the path or at its end. */
    private int near(LeafColumn theirs, int leaf) {
        if (!hasSwept) {
            return 1;
        }
        theirs.bounds(leaf, swept.box);
        double size = ownSize + Math.abs(dx) + Math.abs(dy) + Math.abs(dz);
        for (double bound : swept.box) {
            size += Math.abs(bound);
        }
        return swept.meeting(EARLY * size);
    }

    private int near(int k) {
        return hasSwept ? swept.found(k) : 0;
    }

    /** Whether an enclosure moves horizontally, by which the object in it goes through neither floor nor ceiling. */
    private boolean staysLow() {
        return isCoarse && dy == 0 && worldBounds.clearlyHoldsSides(box);
    }

    private boolean endsInside() {
        if (isCoarse) { // the border is that of the object itself
            LocalLeaves shape = view.form(id).own;
            probe.clear();
            probe.append(shape.size());
            shape.place(end[0], end[1], end[2], objects.places(), objects.place(id) + 3, probe, 0);
        } else {
            placeProbe();
        }
        return worldBounds.holds(probe, 0, probe.size());
    }

    /** Puts what stands for the object where it would end. */
    private void placeProbe() {
        if (!hasProbe) {
            hasProbe = true;
            ObjectLeaves form = view.form(id);
            probe.clear();
            probe.append(form.size());
            form.place(view.dimension, end[0], end[1], end[2], objects.places(), objects.place(id) + 3, probe, 0);
        }
    }
}
