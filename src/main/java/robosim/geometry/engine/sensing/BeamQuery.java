package robosim.geometry.engine.sensing;

import robosim.geometry.check.Checks;
import robosim.geometry.engine.broadphase.AccuracyView;
import robosim.geometry.engine.broadphase.BeamSearch;
import robosim.geometry.engine.broadphase.ConeCandidates;
import robosim.geometry.engine.broadphase.LeafTable;
import robosim.geometry.engine.objects.ObjectTable;
import robosim.geometry.exact.BeamAxis;
import robosim.geometry.exact.Degrees;
import robosim.geometry.exact.WorkCounter;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;
import robosim.geometry.narrow.Cast;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.LeafColumn;

/**
 * The nearest echo of a beam: of one as callers ask for it, from a place or from a sensor on an object, or of one that was set.
 * Keeps the least distance, and whose it is, among the objects that the search visits.
 */
public final class BeamQuery extends BeamSearch {
    private final WorkCounter work;
    private final double[] vector = new double[3];

    /** Where a beam begins that stands on an object. */
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

    private BeamQuery(ObjectTable objects, Cast cast, WorkCounter work) {
        super(objects, cast);
        this.work = work;
    }

    /** The object that gave the last answer, or -1. */
    public int hit() {
        return hit;
    }

    /**
     * Distance to the nearest echo of a beam.
     *
     * @param ignored an object that does not echo; -1 for none
     */
    public double distance(AccuracyView view, Ray ray, double min, double max, double width, int ignored) {
        Checks.present("ray", ray);
        Checks.range(min, max);
        Checks.width(width);
        line(view.dimension, ray);
        widen(width);
        double nearest = nearest(view, max, ignored);
        return nearest < min ? min : nearest;
    }

    /** What a sonar hears that stands at an object's centre and looks along one of the directions of its own X and Z. */
    public double sonar(AccuracyView view, int id, double x, double z, double min, double max, double width) {
        Checks.range(min, max);
        Checks.width(width);
        stand(id, 0, 0, 0);
        look(view.dimension, id, x, 0, z);
        widen(width);
        double nearest = nearest(view, max, id);
        return nearest < min ? min : nearest;
    }

    /** What a sonar hears that looks along a ray of an object's own frame. */
    public double sonar(AccuracyView view, int id, Ray mount, double min, double max, double width) {
        Checks.range(min, max);
        Checks.width(width);
        Point from = mount.start();
        Point to = mount.direction();
        stand(id, from.x(), from.y(), from.z());
        look(view.dimension, id, to.x(), to.y(), to.z());
        widen(width);
        double nearest = nearest(view, max, id);
        return nearest < min ? min : nearest;
    }

    /** Takes a point of an object's own frame for where a beam begins. */
    private void stand(int id, double x, double y, double z) {
        double[] places = objects.places();
        int at = objects.place(id);
        objects.toWorld(id, x, y, z, vector);
        ox = places[at] + vector[0];
        oy = places[at + 1] + vector[1];
        oz = places[at + 2] + vector[2];
    }

    /** Looks from there along a direction of the object's own frame. */
    private void look(Dimension dimension, int id, double x, double y, double z) {
        objects.toWorld(id, x, y, z, vector);
        checkLevel(dimension, vector[0], vector[1], vector[2]);
        line(dimension, ox, oy, oz, vector[0], vector[1], vector[2]);
    }

    /**
     * How far a ray goes until it meets anything within a range, +Infinity where it meets nothing.
     *
     * @param normal three numbers, of the face that is hit
     */
    public double cast(AccuracyView view, Ray ray, double max, double[] normal) {
        Checks.present("ray", ray);
        Checks.range(0, max);
        line(view.dimension, ray);
        double distance = nearest(view, max, -1);
        if (hit >= 0) {
            normal(view, distance, normal);
        }
        return distance;
    }

    private void line(Dimension dimension, Ray ray) {
        Point from = ray.start();
        Point to = ray.direction();
        checkLevel(dimension, to.x(), to.y(), to.z());
        line(dimension, from.x(), from.y(), from.z(), to.x(), to.y(), to.z());
    }

    static void checkLevel(Dimension dimension, double dx, double dy, double dz) {
        if (dimension == Dimension.PLANAR && dx == 0 && dz == 0) {
            throw vertical("direction", dx, dy, dz);
        }
    }

    static IllegalArgumentException vertical(String direction, double dx, double dy, double dz) {
        return new IllegalArgumentException(
                direction + " must not be vertical in a PLANAR world, which has no heights (got: (" + dx + ", " + dy
                        + ", " + dz + "))");
    }

    /** Sets a line. The direction is of any length but zero; in PLANAR that of its projection. */
    void line(Dimension dimension, double x, double y, double z, double dx, double dy, double dz) {
        work.take();
        cast.line(dimension, x, y, z, dx, dy, dz);
    }

    /** Makes the line a beam of an opening angle in degrees; 0 for a line. */
    void widen(double width) {
        if (width > 0) {
            if (width != lastWidth) { // sensors mostly have one
                lastWidth = width;
                halfCos = Degrees.cos(width / 2);
                halfSin = Degrees.sin(width / 2);
            }
            cast.beam.widen(halfCos, halfSin);
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
        return found(limit);
    }

    /** The same for one of the cones that share what is around their place. */
    double nearest(AccuracyView view, double limit, int ignored, ConeCandidates around, int cone) {
        hit = -1;
        best = Double.POSITIVE_INFINITY;
        searchAround(view, limit, ignored, around, cone);
        return found(limit);
    }

    /**
     * Whether anything echoes within a limit: {@link #nearest(AccuracyView, double, int)} is finite. The search ends with the
     * first echo found; {@link #hit()} tells whose it is.
     *
     * @param likely an object that is looked at first, as it blocked a similar beam; -1 for none
     */
    boolean hits(AccuracyView view, double limit, int ignored, int likely) {
        hit = -1;
        best = Double.POSITIVE_INFINITY;
        enough = limit;
        cast.contentWith(limit);
        try {
            if (likely < 0 || likely == ignored || hit(view.table(likely), likely, limit) >= 0) {
                search(view, limit, ignored);
            }
        } finally {
            enough = Double.NEGATIVE_INFINITY;
            cast.contentWith(enough);
        }
        return hit >= 0 && best <= limit;
    }

    private double found(double limit) {
        if (best <= limit) {
            return best;
        }
        hit = -1;
        return Double.POSITIVE_INFINITY;
    }

    @Override
    protected double hit(LeafTable table, int id, double reach) {
        LeafColumn leaves = table.leaves();
        if (table.isUpright(id)) {
            int leaf = table.uprightLeaf(id);
            take(cast.distance(leaves, leaf, best < reach ? best : reach), id, leaf);
        } else {
            int first = table.first(id);
            int last = first + table.count(id);
            for (int leaf = first; leaf < last && !isEnough(); leaf++) {
                work.take();
                take(cast.distance(leaves, leaf, best < reach ? best : reach), id, leaf);
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

    @Override
    protected double hitOutline(int id, double[] outlines, int local, double reach) {
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
        boolean isNearer = found < best || (found == best && hit >= 0 && objects.isEarlier(id, hit));
        if (isNearer && !objects.ignored.has(id)) {
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

    /** Notes what the last answer is of, at the distance that it gave. */
    void tell(BeamResults out, int beam, AccuracyView view, double at) {
        boolean isMissed = hit < 0;
        if (out.hasNormals() && !isMissed) {
            normal(view, at, vector);
        }
        out.object(beam, objects, hit, vector);
        if (out.hasParts()) {
            int face = isMissed ? -1 : cast.face(view.table(hit).leaves(), hitLeaf, hitPiece);
            out.part(beam, isMissed ? -1 : part(view, hit, hitLeaf), face);
        }
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
    public double point(int axis, double at) {
        BeamAxis beam = cast.beam;
        return switch (axis) {
            case 0 -> beam.ox + at * beam.ux();
            case 1 -> beam.oy + at * beam.uy();
            default -> beam.oz + at * beam.uz();
        };
    }
}
