package robosim.geometry.engine.motion;

import java.util.Arrays;
import robosim.geometry.engine.broadphase.AccuracyView;
import robosim.geometry.engine.broadphase.LeafTable;
import robosim.geometry.engine.broadphase.NearestSearch;
import robosim.geometry.engine.objects.IgnoredObjects;
import robosim.geometry.engine.objects.ObjectLeaves;
import robosim.geometry.engine.objects.ObjectTable;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;
import robosim.geometry.narrow.Distance;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.GridWalk;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.LocalLeaves;
import robosim.geometry.narrow.leaf.UprightLeaves;
import robosim.geometry.narrow.mesh.SignedPairs;

/**
 * How far a moveable object is from all others at a place, or how deep in one of them, with the points and the direction.
 * Objects of {@link IgnoredObjects} do not count.
 */
public final class ClearanceQuery {
    /** The numbers of an answer: the signed distance, a point on the object, one on the other, the direction from that. */
    public static final int NUMBERS = 10;

    /** How much farther than the nearest cell others are gathered, as a share of the distance. */
    private static final double BEYOND = 0x1p-20;

    /** More than the rounding of bounds, as a share of the heights. */
    private static final double FLUSH = 0x1p-40;

    /** More than what a square may lose by underflow. */
    private static final double UNDERFLOW = 0x1p-1000;

    private final Leaf one = new Leaf();
    private final Leaf two = new Leaf();
    private final IgnoredObjects ignored;
    private final ObjectTable objects;
    private final Distance distance;
    private final SignedPairs pairs;
    private final GridWalk walk;
    private final NearestSearch search;

    /** What stands for the object, and its bounds. */
    final LeafColumn own = new LeafColumn(1);

    final double[] box = new double[6];
    private final LeafColumn ownPieces = new LeafColumn(1);
    private final LeafColumn otherPieces = new LeafColumn(1);
    private final double[] near = new double[6];
    private final double[] witness = new double[9];
    private int[] touched = new int[8];
    private int touchedCount;
    private AccuracyView view;
    private boolean isBelowIgnored;
    private double best;
    private int nearest;
    private double low;
    private double high;
    private long steps;

    @SuppressWarnings("NullAway.Init") // a query sets its view
    public ClearanceQuery(ObjectTable objects, Scratch scratch) {
        this.objects = objects;
        ignored = objects.ignored;
        distance = new Distance(scratch);
        pairs = new SignedPairs(scratch.distance);
        walk = new GridWalk(scratch.work);
        search = new NearestSearch(objects, this::hit);
    }

    /** Puts the object where it is. */
    public void present(AccuracyView in, int id) {
        view = in;
        LeafTable home = in.table(id);
        own.clear();
        own.appendWhole(home.leaves(), home.first(id), home.count(id));
        System.arraycopy(home.bounds(), home.boundsAt(id), box, 0, 6);
    }

    /** Puts the object at a place, laid out as in the table of objects. */
    public void at(AccuracyView in, int id, double[] place) {
        view = in;
        ObjectLeaves form = in.form(id);
        own.clear();
        own.append(form.size());
        form.place(in.dimension, place[0], place[1], place[2], place, ObjectTable.ROTATION, own, 0);
        own.bounds(0, own.size(), box);
    }

    /** Asks about a point instead of an object. */
    public void point(AccuracyView in, Point point) {
        view = in;
        LocalLeaves.placed(new SphereObject(point, 0), own);
        own.bounds(0, own.size(), box);
    }

    /** From now on what lies wholly at or below the object's lowest point does not count, or does again. */
    void ignoreBelow(boolean isLevel) {
        isBelowIgnored = isLevel;
    }

    /**
     * The least distance to any other object; 0 in contact, +Infinity beyond the limit. It has the bits of a proximity.
     *
     * @param id the object itself, which does not count; -1 for none
     */
    public double distance(int id, double limit) {
        best = Double.POSITIVE_INFINITY;
        nearest = -1;
        touchedCount = 0;
        search.search(view, box, limit, id);
        return best <= limit ? best : Double.POSITIVE_INFINITY;
    }

    private double hit(LeafTable table, int other, double reach) {
        if (ignored.has(other) || (isBelowIgnored && isBelow(table, other))) {
            return reach;
        }
        boolean isCoarse = view.accuracy != Accuracy.EXACT;
        double sizes = Distance.sides(box) + sides(table, other);
        if (boxGap(table, other) > Distance.reach(reach, sizes)) {
            return reach;
        }
        int first = table.first(other);
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < own.size(); i++) {
            for (int j = first; j < first + table.count(other); j++) {
                double most = Math.min(reach, least);
                double limit = isCoarse ? Distance.reach(most, sizes) : most;
                double found = distance.between(view.dimension, own, i, table.leaves(), j, limit);
                least = Math.min(least, isCoarse ? Distance.ofEnclosures(found, sizes) : found);
            }
        }
        if (least < best || (least == best && nearest >= 0 && objects.isEarlier(other, nearest))) {
            best = least;
            nearest = other;
        }
        if (least == 0) {
            touch(other);
        }
        return Math.min(reach, best);
    }

    /** Whether another object lies wholly at or below the lowest point of this one; exact for what stands upright. */
    private boolean isBelow(LeafTable table, int other) {
        int at = table.boundsAt(other);
        double top = table.bounds()[at + 4];
        double size = Math.abs(table.bounds()[at + 1]) + Math.abs(top) + Math.abs(box[1]) + Math.abs(box[4]);
        if (top > box[1] + FLUSH * size) {
            return false;
        }
        for (int j = table.first(other); j < table.first(other) + table.count(other); j++) {
            for (int i = 0; i < own.size(); i++) {
                boolean isUpright =
                        own.kind(i).isVerticalPrism() && table.leaves().kind(j).isVerticalPrism();
                if (isUpright
                        ? !UprightLeaves.isOnOrAbove(one.set(own, i), two.set(table.leaves(), j))
                        : top > box[1]) {
                    return false;
                }
            }
        }
        return true;
    }

    private static double sides(LeafTable table, int other) {
        double[] b = table.bounds();
        int k = table.boundsAt(other);
        return (b[k + 3] - b[k]) + (b[k + 4] - b[k + 1]) + (b[k + 5] - b[k + 2]);
    }

    /** A lower bound of the distance of another object: that of their bounds. */
    private double boxGap(LeafTable table, int other) {
        double[] b = table.bounds();
        int k = table.boundsAt(other);
        double squared = 0;
        for (int axis = 0; axis < 3; axis += view.dimension == Dimension.PLANAR ? 2 : 1) {
            double gap = Math.max(box[axis] - b[k + 3 + axis], b[k + axis] - box[3 + axis]);
            squared += gap > 0 ? gap * gap : 0;
        }
        return squared < UNDERFLOW ? 0 : Math.sqrt(squared) * (1 - 0x1p-50);
    }

    private void touch(int other) {
        for (int k = 0; k < touchedCount; k++) {
            if (touched[k] == other) {
                return; // shown twice
            }
        }
        if (touchedCount == touched.length) {
            touched = Arrays.copyOf(touched, 2 * touchedCount);
        }
        touched[touchedCount++] = other;
    }

    /** The object that the last answer is about: the nearest, or the one most deeply overlapped; of equal ones the one added first. */
    public int object() {
        return nearest;
    }

    /** The ends of the bracket of the last answer. */
    public double low() {
        return low;
    }

    public double high() {
        return high;
    }

    /** How many steps the last answer took. */
    public long steps() {
        return steps;
    }

    /** The numbers of the last answer: points on the object and on the other, and the direction. */
    public double[] witness() {
        return witness;
    }

    /**
     * The signed distance to the nearest object, or, where the object touches some, minus the depth in that in which it is
     * deepest; +Infinity beyond the limit.
     */
    public double signed(int id, double limit) {
        double least = signedAlone(id, limit);
        if (least > 0 && least < Double.POSITIVE_INFINITY) {
            measure(nearest, least);
        }
        return least;
    }

    /** The same without points and direction, except for an object that touches another one. */
    double signedAlone(int id, double limit) {
        double least = distance(id, limit);
        if (least > 0) {
            return least;
        }
        double depth = Double.POSITIVE_INFINITY;
        for (int k = 0; k < touchedCount; k++) {
            run(touched[k], 0);
            if (pairs.high() < depth || (pairs.high() == depth && objects.isEarlier(touched[k], nearest))) {
                depth = pairs.high();
                nearest = touched[k];
                store();
            }
        }
        return Math.min(0, depth) + 0.0;
    }

    /** The signed distance to one object that is at most so far away. */
    public void measure(int other, double within) {
        run(other, within);
        store();
    }

    private void store() {
        low = pairs.low();
        high = pairs.high();
        steps = pairs.steps();
        pairs.witness(witness);
    }

    private void run(int other, double within) {
        LeafTable table = view.table(other);
        double[] bounds = table.bounds();
        int at = table.boundsAt(other);
        pieces(own, 0, own.size(), bounds, at, within, ownPieces);
        pieces(table.leaves(), table.first(other), table.count(other), box, 0, within, otherPieces);
        if (!pairs.isAnswered(view.dimension, ownPieces, otherPieces)) {
            pairs.start(view.dimension, ownPieces, otherPieces);
            while (!pairs.isMeasured()) {
                pairs.step();
            }
            pairs.finish();
        }
    }

    /** The leaves of an object; of a grid those of its cells that are near a box. */
    private void pieces(LeafColumn from, int first, int count, double[] bounds, int at, double within, LeafColumn out) {
        out.clear();
        if (!from.kind(first).isGrid()) {
            out.appendWhole(from, first, count);
            return;
        }
        double size = 0;
        for (int k = 0; k < 6; k++) {
            size += Math.abs(bounds[at + k]);
        }
        double wide = within * (1 + BEYOND) + BEYOND * size;
        for (int axis = 0; axis < 3; axis++) {
            near[axis] = axis == 1 ? Double.NEGATIVE_INFINITY : bounds[at + axis] - wide;
            near[3 + axis] = axis == 1 ? Double.POSITIVE_INFINITY : bounds[at + 3 + axis] + wide;
        }
        walk.startBox(from, first, near);
        for (int cell = walk.nextInBox(); cell >= 0; cell = walk.nextInBox()) {
            out.appendWhole(walk.piece(cell, from.kind(first)), 0, 1);
        }
    }

    boolean isBelowIgnored() {
        return isBelowIgnored;
    }
}
