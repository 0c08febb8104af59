package robosim.geometry.engine.sensing;

import robosim.geometry.engine.broadphase.AccuracyView;
import robosim.geometry.engine.broadphase.BeamSearch;
import robosim.geometry.engine.broadphase.LeafTable;
import robosim.geometry.engine.broadphase.Surroundings;
import robosim.geometry.engine.objects.ObjectTable;
import robosim.geometry.exact.Degrees;
import robosim.geometry.exact.Work;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.narrow.Cast;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.LeafColumn;

/** The nearest echo of a beam: keeps the least distance, and whose it is, among the objects that the search visits. */
public final class BeamQuery extends BeamSearch {
    private final ObjectTable objects;
    private final Cast cast;
    private final Work work;

    private double ox;
    private double oy;
    private double oz;
    private double best;
    private int hit;
    private int hitLeaf;
    private int hitPiece;

    /** A distance at which the search may end, as nothing nearer is wanted; below 0 if the nearest is. */
    private double enough = Double.NEGATIVE_INFINITY;

    private double lastWidth;
    private double halfCos = 1;
    private double halfSin;

    public BeamQuery(ObjectTable objects, Scratch scratch) {
        this(objects, new Cast(scratch), scratch.work);
    }

    private BeamQuery(ObjectTable objects, Cast cast, Work work) {
        super(objects, cast);
        this.objects = objects;
        this.cast = cast;
        this.work = work;
    }

    /** The object that gave the last answer, or -1. */
    int hit() {
        return hit;
    }

    /**
     * Sets the beam. The direction is of any length but zero; in PLANAR that of its projection.
     *
     * @param width opening angle in degrees; 0 for a line
     */
    void beam(Dimension dimension, double x, double y, double z, double dx, double dy, double dz, double width) {
        work.take();
        cast.line(dimension, x, y, z, dx, dy, dz);
        ox = x;
        oy = y;
        oz = z;
        if (width > 0) {
            if (width != lastWidth) { // sensors mostly have one
                lastWidth = width;
                halfCos = Degrees.cos(width / 2);
                halfSin = Degrees.sin(width / 2);
            }
            cast.widen(halfCos, halfSin);
            cone(x, y, z, halfCos, halfSin);
        } else {
            line(x, y, z);
        }
    }

    /**
     * Distance to the nearest echo, at most the limit, or +Infinity; {@link #hit()} tells whose.
     *
     * @param ignored an object that does not echo; -1 for none
     */
    double nearest(AccuracyView view, double limit, int ignored) {
        hit = -1;
        best = Double.POSITIVE_INFINITY;
        search(view, limit, ignored);
        return nearest(limit);
    }

    /** The same for one of the cones that share what is around their place. */
    double nearest(AccuracyView view, double limit, int ignored, Surroundings around, int cone) {
        hit = -1;
        best = Double.POSITIVE_INFINITY;
        searchAround(view, limit, ignored, around, cone);
        return nearest(limit);
    }

    /**
     * Whether anything echoes within a limit: {@link #nearest(AccuracyView, double, int)} is finite. The search ends with the
     * first echo found; {@link #hit()} tells whose it is.
     *
     * @param likely an object that is looked at first, as it blocked a similar beam; -1 for none
     */
    boolean meets(AccuracyView view, double limit, int ignored, int likely) {
        hit = -1;
        best = Double.POSITIVE_INFINITY;
        enough = limit;
        cast.contentWith(limit);
        try {
            if (likely < 0 || likely == ignored || meet(view.table(likely), likely, limit) >= 0) {
                search(view, limit, ignored);
            }
        } finally {
            enough = Double.NEGATIVE_INFINITY;
            cast.contentWith(enough);
        }
        return hit >= 0 && best <= limit;
    }

    private double nearest(double limit) {
        if (best <= limit) {
            return best;
        }
        hit = -1;
        return Double.POSITIVE_INFINITY;
    }

    @Override
    protected double meet(LeafTable table, int id, double reach) {
        LeafColumn leaves = table.leaves();
        if (table.isUpright(id)) {
            meetLeaf(leaves, id, table.uprightLeaf(id), reach);
        } else {
            int first = table.first(id);
            int last = first + table.count(id);
            for (int leaf = first; leaf < last && !isEnough(); leaf++) {
                work.take();
                meetLeaf(leaves, id, leaf, reach);
            }
        }
        return left(reach);
    }

    /** How far to look from now on; nowhere if what was found is enough. */
    private double left(double reach) {
        if (isEnough()) {
            return Double.NEGATIVE_INFINITY;
        }
        return best < reach ? best : reach;
    }

    private boolean isEnough() {
        return best <= enough && hit >= 0; // both may be infinite
    }

    private void meetLeaf(LeafColumn leaves, int id, int leaf, double reach) {
        take(cast.distance(leaves, leaf, best < reach ? best : reach), id, leaf);
    }

    @Override
    protected double meetOutline(int id, double[] outlines, int local, double reach) {
        double found = cast.upright(outlines, local);
        if (Double.isNaN(found)) {
            return found;
        }
        take(found, id, local | LeafColumn.UPRIGHT);
        return left(reach);
    }

    @Override
    protected boolean isNearest(int id) {
        return id == hit;
    }

    private void take(double found, int id, int leaf) {
        if (found < best || (found == best && hit >= 0 && objects.isEarlier(id, hit))) {
            best = found;
            hit = id;
            hitLeaf = leaf;
            hitPiece = cast.piece();
        }
    }

    /** The unit normal where the line met what it hit. */
    void normal(AccuracyView view, double at, double[] out) {
        cast.normal(view.table(hit).leaves(), hitLeaf, at, hitPiece, out);
    }

    /** The leaf that gave the last answer, if anything did. */
    int leaf() {
        return hitLeaf;
    }

    /** The triangle or cell of it that the line met; -1 if it has none. */
    int face(AccuracyView view) {
        return cast.face(view.table(hit).leaves(), hitLeaf, hitPiece);
    }

    /** Which part of an object a leaf is; -1 for a group where one enclosure stands for all of them. */
    int part(AccuracyView view, int id, int leaf) {
        LeafTable table = view.table(id);
        if (table.count(id) > 1) {
            return leaf - table.first(id);
        }
        return view.accuracy != Accuracy.EXACT && objects.value(id) instanceof ObjectGroup ? -1 : 0;
    }

    /** A coordinate (0 to 2) of the point on the line at a distance. */
    double point(int axis, double at) {
        return switch (axis) {
            case 0 -> ox + at * cast.unit(0);
            case 1 -> oy + at * cast.unit(1);
            default -> oz + at * cast.unit(2);
        };
    }
}
