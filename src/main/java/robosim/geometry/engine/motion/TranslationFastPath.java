package robosim.geometry.engine.motion;

import org.jspecify.annotations.Nullable;
import robosim.geometry.engine.broadphase.AccuracyView;
import robosim.geometry.engine.objects.Form;
import robosim.geometry.engine.objects.ObjectTable;
import robosim.geometry.engine.objects.WorldBounds;
import robosim.geometry.exact.DoubleDouble;
import robosim.geometry.index.QuadCursor;
import robosim.geometry.index.boxes.OctTree;
import robosim.geometry.index.boxes.SpaceKeys;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.Pose;
import robosim.geometry.narrow.Overlap;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.Sweep;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.planar.DiscWay;

/**
 * A straight move answered with yes or no and nothing else, as {@link Motion} would: most moves meet nothing, and who only
 * asks whether need not know where. Reads the world's own columns and places nothing before it is sure.
 */
public final class TranslationFastPath {
    /** A yes: {@link #end()} is where the object comes to stand. */
    public static final int FREE = 1;

    static final int BLOCKED = -1;

    /** Not asked here: see {@link Motion}. */
    public static final int UNKNOWN = 0;

    /** More than a place loses when it is stored, as a share of its coordinates. */
    private static final double STORED = 0x1p-47;

    /** More than the least float. */
    private static final double LEAST = 0x1p-140;

    private final ObjectTable bodies;
    private final SpaceKeys keys = new SpaceKeys();
    private final WorldBounds border;
    private final Scratch s;
    private final Sweep sweep;
    private final LeafColumn probe = new LeafColumn(1);
    private final double[] box = new double[6];
    private final double[] end = new double[6];

    private AccuracyView level;
    private int id;
    private double dx;
    private double dy;
    private double dz;
    private boolean hasProbe;
    private boolean isUnsure;
    private boolean isCertain;

    // The disc around the object, and by how much it may be off.
    private double ownX;
    private double ownZ;
    private double ownRadius;
    private double ownSlack;

    /** The sum of the coordinates of its bounds, unsigned, without the heights. */
    private double ownSize;

    private boolean ownIsDisc;

    @SuppressWarnings("NullAway.Init") // a question sets its level
    public TranslationFastPath(ObjectTable bodies, WorldBounds border, Scratch scratch) {
        this.bodies = bodies;
        this.border = border;
        s = scratch;
        sweep = new Sweep(scratch);
    }

    /** The centre at the end, and what it has lost; six numbers. */
    public double[] end() {
        return end;
    }

    /** Whether an object may go by a displacement in the world's axes. */
    public int ask(AccuracyView inLevel, int mover, double x, double y, double z) {
        level = inLevel;
        id = mover;
        if (!level.keepsShape(mover)) {
            return UNKNOWN;
        }
        double[] places = bodies.places();
        int at = bodies.place(mover);
        dx = advance(places, at, 0, x);
        dy = advance(places, at, 1, y);
        dz = advance(places, at, 2, z);
        if (dx == 0 && dy == 0 && dz == 0) {
            return UNKNOWN;
        }
        hasProbe = false;
        isUnsure = false;
        isCertain = false;
        enclose();
        takeSweptBox(places, at);
        if (!border.clearlyHolds(box) && !endsInside()) {
            return BLOCKED;
        }
        if (passesAll()) {
            return FREE;
        }
        // What it stands on may have a say, if not where the insides meet: see Standing.
        return !isCertain && (isUnsure || touches()) ? UNKNOWN : BLOCKED;
    }

    /** Whether the object touches another one where it is, and does not overlap it so deeply that it has no say. */
    private boolean touches() {
        System.arraycopy(level.bounds(), 6 * id, box, 0, 6);
        AccuracyView shared = level.shared();
        if (touchesIn(level) || (shared != null && touchesIn(shared))) {
            return true;
        }
        for (int k = 0; k < level.moversBesideTree(); k++) {
            int other = bodies.mover(k);
            if (other != id && level.meets(other, box) && touches(level, other)) {
                return true;
            }
        }
        return false;
    }

    private boolean touchesIn(AccuracyView of) {
        QuadCursor cursor = of.cursor;
        int near = cursor.gather(
                box[0], box[2], box[3], box[5], id ^ of.mark, of.leaves().outlines());
        for (int k = 0; k < near; k++) {
            int other = cursor.gathered(k);
            if (of.meets(other, box) && touches(of, other)) {
                return true;
            }
        }
        OctTree.@Nullable Cursor stacked = of.spaceIndex.cursor();
        if (stacked != null) {
            keys.startBox(box);
            stacked.start(of.bounds(), keys);
            for (int other = stacked.next(0); other >= 0; other = stacked.next(0)) {
                if (touches(of, other)) {
                    return true;
                }
            }
        }
        return false;
    }

    private boolean touches(AccuracyView of, int other) {
        LeafColumn leaves = level.leaves();
        int own = level.first(id);
        for (int j = of.first(other); j < of.first(other) + of.count(other); j++) {
            for (int i = own; i < own + level.count(id); i++) {
                if (Overlap.test(level.dimension, leaves, i, of.leaves(), j, s)
                        && !Overlap.isDeep(level.dimension, leaves, i, of.leaves(), j, s)) {
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
        double[] b = level.bounds();
        int own = 6 * id;
        double place = Math.abs(places[at]) + Math.abs(places[at + 1]) + Math.abs(places[at + 2]);
        double way = Math.abs(dx) + Math.abs(dy) + Math.abs(dz);
        double heights = Math.abs(b[own + 1]) + Math.abs(b[own + 4]);
        double slack = STORED * ((ownSize + heights) + (place + (way + way))) + Double.MIN_NORMAL;
        box[0] = b[own] + Math.min(0, dx) - slack;
        box[1] = b[own + 1] + Math.min(0, dy) - slack;
        box[2] = b[own + 2] + Math.min(0, dz) - slack;
        box[3] = b[own + 3] + Math.max(0, dx) + slack;
        box[4] = b[own + 4] + Math.max(0, dy) + slack;
        box[5] = b[own + 5] + Math.max(0, dz) + slack;
    }

    private boolean passesAll() {
        if (!passesTrees(level)) {
            return false;
        }
        AccuracyView shared = level.shared();
        if (shared != null && !passesTrees(shared)) {
            return false;
        }
        for (int k = 0; k < level.moversBesideTree(); k++) {
            int other = bodies.mover(k);
            if (other != id && !passes(level, other, DiscWay.UNSURE)) {
                return false;
            }
        }
        return true;
    }

    private boolean passesTrees(AccuracyView of) {
        QuadCursor cursor = of.cursor;
        int near = cursor.gather(
                box[0], box[2], box[3], box[5], id ^ of.mark, of.leaves().outlines());
        double[] boxes = cursor.boxes();
        for (int k = 0; k < near; k++) {
            int other = cursor.gathered(k);
            if (!passes(of, other, quickly(of, other, boxes))) {
                return false;
            }
        }
        OctTree.@Nullable Cursor stacked = of.spaceIndex.cursor();
        if (stacked != null) {
            keys.startBox(box);
            stacked.start(of.bounds(), keys);
            for (int other = stacked.next(0); other >= 0; other = stacked.next(0)) {
                if (!passesExactly(of, other)) {
                    return false;
                }
            }
        }
        return true;
    }

    private boolean passes(AccuracyView of, int other, int quick) {
        if (quick == DiscWay.UNSURE) {
            return !of.meets(other, box) || passesExactly(of, other);
        }
        isCertain = quick == DiscWay.MET;
        return !isCertain;
    }

    /** The disc around the object, as seen from above: its own where it is one, or that through the corners of its bounds. */
    private void enclose() {
        double[] b = level.bounds();
        double minX = b[6 * id];
        double minZ = b[6 * id + 2];
        double maxX = b[6 * id + 3];
        double maxZ = b[6 * id + 5];
        ownIsDisc = level.isDisc(id);
        ownX = 0.5 * minX + 0.5 * maxX; // not its centre, which may be off it where it is a group
        ownZ = 0.5 * minZ + 0.5 * maxZ;
        double halfX = 0.5 * maxX - 0.5 * minX;
        double halfZ = 0.5 * maxZ - 0.5 * minZ;
        ownRadius = ownIsDisc ? Math.max(halfX, halfZ) : Math.sqrt(halfX * halfX + halfZ * halfZ);
        ownSize = (Math.abs(minX) + Math.abs(maxX)) + (Math.abs(minZ) + Math.abs(maxZ));
        ownSlack = 0x1p-50 * ownSize + LEAST;
    }

    /**
     * What doubles can tell, as seen from above, of the discs around the object and around the bounds of another: a disc's
     * own, or that through the corners.
     */
    private int quickly(AccuracyView of, int other, double[] boxes) {
        double minX = boxes[6 * other];
        double minZ = boxes[6 * other + 2];
        double maxX = boxes[6 * other + 3];
        double maxZ = boxes[6 * other + 5];
        double halfX = 0.5 * maxX - 0.5 * minX;
        double halfZ = 0.5 * maxZ - 0.5 * minZ;
        boolean isDisc = of.isDisc(other);
        double radius = isDisc ? Math.max(halfX, halfZ) : Math.sqrt(halfX * halfX + halfZ * halfZ);
        double slack = 0x1p-50 * (Math.abs(minX) + Math.abs(maxX) + Math.abs(minZ) + Math.abs(maxZ)) + ownSlack;
        double qx = 0.5 * minX + 0.5 * maxX - ownX;
        double qz = 0.5 * minZ + 0.5 * maxZ - ownZ;
        // Who meets as seen from above may be higher or lower.
        boolean isAll = isDisc && ownIsDisc && level.dimension == Dimension.PLANAR;
        return DiscWay.past(qx, qz, dx, dz, ownRadius + radius, slack, isAll);
    }

    private boolean passesExactly(AccuracyView of, int other) {
        LeafColumn leaves = level.leaves();
        LeafColumn theirs = of.leaves();
        int own = level.first(id);
        int ownEnd = own + level.count(id);
        int others = of.first(other);
        int othersEnd = others + of.count(other);
        sweep.translation(level.dimension, dx, dy, dz);
        for (int j = others; j < othersEnd; j++) {
            for (int i = own; i < ownEnd; i++) {
                // Who drives on a mesh may be stopped by its next triangle only where the contacts say so.
                isUnsure = theirs.kind(j).isMesh() && Overlap.test(level.dimension, leaves, i, theirs, j, s);
                if (isUnsure || sweep.free(leaves, i, theirs, j) != Double.POSITIVE_INFINITY) {
                    return false;
                }
            }
        }
        placeProbe();
        for (int j = others; j < othersEnd; j++) {
            for (int i = own; i < ownEnd; i++) {
                if (Overlap.test(level.dimension, probe, i - own, theirs, j, s)) {
                    // Each face of a mesh is a piece of its own, any of which may be touched anew.
                    isUnsure = theirs.kind(j).isMesh();
                    if (isUnsure || !Overlap.test(level.dimension, leaves, i, theirs, j, s)) {
                        return false;
                    }
                }
            }
        }
        return true;
    }

    private boolean endsInside() {
        placeProbe();
        return border.holds(probe, 0, probe.size());
    }

    /** Puts what stands for the object where it would end. */
    private void placeProbe() {
        if (!hasProbe) {
            hasProbe = true;
            Form form = level.form(id);
            probe.clear();
            probe.append(form.size());
            level.place(form, end[0], end[1], end[2], bodies.places(), bodies.place(id) + 3, probe, 0);
        }
    }
}
