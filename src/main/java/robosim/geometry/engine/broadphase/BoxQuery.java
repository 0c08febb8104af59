package robosim.geometry.engine.broadphase;

import java.util.Arrays;
import robosim.geometry.engine.objects.ObjectTable;
import robosim.geometry.index.QuadCursor;
import robosim.geometry.index.hierarchy.BoxCursor;
import robosim.geometry.index.hierarchy.Hierarchy;
import robosim.geometry.index.tiles.NearTarget;

/**
 * Finds the objects that may meet a box, also a swept one: as a list ({@link #gather}), or one by one for a target until it
 * needs no more ({@link #probe}, {@link #each}). Only {@link #each} compares all bounds and gives each object once; else some
 * that come from the quadtree may lie beside the box, above it or below it.
 */
public final class BoxQuery {
    private final ObjectTable objects;
    private final BoxTarget target;
    private final NearTarget passOn = this::passOn;

    private int[] ids = new int[16];
    private int count;

    // What passOn refers to.
    private LeafTable table;
    private int ignored;

    /** A query that only gathers. */
    public BoxQuery(ObjectTable objects) {
        this(objects, (table, id) -> false);
    }

    @SuppressWarnings("NullAway.Init") // a query sets its table
    public BoxQuery(ObjectTable objects, BoxTarget target) {
        this.objects = objects;
        this.target = target;
    }

    /**
     * Lists the objects that may meet a box, perhaps more than once, while objects come and move: nothing is laid out anew for
     * one question. Take them with {@link #gathered}.
     *
     * @param ignored an object that is left out; -1 for none
     * @return how many there are
     */
    public int gather(AccuracyView view, double[] box, int ignored) {
        count = 0;
        gather(view.own, box, ignored);
        LeafTable shared = view.shared;
        if (shared != null) {
            gather(shared, box, ignored);
        }
        return count;
    }

    /** The k-th object that was gathered. */
    public int gathered(int k) {
        return ids[k];
    }

    private void gather(LeafTable of, double[] box, int but) {
        SpaceIndex space = of.space;
        if (space == null) {
            QuadCursor cursor = of.cursor;
            int found = cursor.gather(
                    box[0], box[2], box[3], box[5], but ^ of.mark, of.leaves().outlines());
            for (int k = 0; k < found; k++) {
                add(cursor.gathered(k) | of.mark);
            }
        } else {
            gather(of, space.boxes, space.still, box, but);
            gather(of, space.boxes, space.moving, box, but);
        }
        for (int k = 0; k < of.gridCount(); k++) {
            addNear(of, of.grid(k), box, but);
        }
        for (int k = 0; k < of.moversBesideTree(); k++) {
            addNear(of, objects.mover(k), box, but);
        }
    }

    private void gather(LeafTable of, BoxCursor cursor, Hierarchy tree, double[] box, int but) {
        cursor.start(tree, box);
        for (int local = cursor.next(); local >= 0; local = cursor.next()) {
            if ((local | of.mark) != but) {
                add(local | of.mark);
            }
        }
    }

    private void addNear(LeafTable of, int id, double[] box, int but) {
        if (id != but && of.overlaps(id, box)) {
            add(id);
        }
    }

    private void add(int id) {
        if (count == ids.length) {
            ids = Arrays.copyOf(ids, 2 * count);
        }
        ids[count++] = id;
    }

    /** Asks a world that mostly stands still: the quadtree may be laid out anew, and later questions gain by it. */
    public boolean probe(AccuracyView view, double[] box, int ignored) {
        LeafTable shared = view.shared;
        return probes(view.own, box, ignored) || (shared != null && probes(shared, box, ignored));
    }

    private boolean probes(LeafTable of, double[] box, int but) {
        if (of.space != null) {
            return meetsEach(of, box, but);
        }
        double x = box[0] / 2 + box[3] / 2;
        double z = box[2] / 2 + box[5] / 2;
        double halfX = QuadCursor.half(box[0], box[3]);
        double halfZ = QuadCursor.half(box[2], box[5]);
        ignored = but;
        if (table != of) { // writing a reference is slow
            table = of;
        }
        int asked = of.cursor.near(x, z, halfX, halfZ, of.leaves().outlines(), passOn);
        return switch (asked) {
            case QuadCursor.ENOUGH -> true;
            case QuadCursor.ALL -> probeBesideTree(of, box, but);
            default -> meetsEach(of, box, but);
        };
    }

    /** Shows each object whose bounds meet the box once. */
    public boolean each(AccuracyView view, double[] box, int ignored) {
        LeafTable shared = view.shared;
        return meetsEach(view.own, box, ignored) || (shared != null && meetsEach(shared, box, ignored));
    }

    private boolean meetsEach(LeafTable of, double[] box, int but) {
        return meetsInTree(of, box, but) || probeBesideTree(of, box, but);
    }

    private boolean passOn(int local) {
        int id = local | table.mark;
        return id != ignored && target.visit(table, id);
    }

    private boolean meetsInTree(LeafTable of, double[] box, int but) {
        SpaceIndex space = of.space;
        if (space != null) {
            return (space.still.size() > 0 && overlaps(of, space.boxes, space.still, box, but))
                    || (space.moving.size() > 0 && overlaps(of, space.boxes, space.moving, box, but));
        }
        of.cursor.startBox(box[0], box[2], box[3], box[5]);
        for (int local = of.cursor.next(); local >= 0; local = of.cursor.next()) {
            int id = local | of.mark;
            if (id != but && of.overlaps(id, box) && target.visit(of, id)) {
                return true;
            }
        }
        return false;
    }

    private boolean overlaps(LeafTable of, BoxCursor cursor, Hierarchy tree, double[] box, int but) {
        cursor.startSettled(tree, box);
        for (int local = cursor.next(); local >= 0; local = cursor.next()) {
            int id = local | of.mark;
            if (id != but && of.overlaps(id, box) && target.visit(of, id)) {
                return true;
            }
        }
        return false;
    }

    /** Whether the bounds of any object that is in no tree meet the box. */
    boolean hasBesideTree(LeafTable of, double[] box, int but) {
        for (int k = 0; k < of.gridCount(); k++) {
            if (of.grid(k) != but && of.overlaps(of.grid(k), box)) {
                return true;
            }
        }
        for (int k = 0; k < of.moversBesideTree(); k++) {
            if (objects.mover(k) != but && of.overlaps(objects.mover(k), box)) {
                return true;
            }
        }
        return false;
    }

    /** Shows the objects that are in no tree and whose bounds meet the box. */
    boolean probeBesideTree(LeafTable of, double[] box, int but) {
        for (int k = 0; k < of.gridCount(); k++) {
            if (overlaps(of, of.grid(k), box, but)) {
                return true;
            }
        }
        for (int k = 0; k < of.moversBesideTree(); k++) {
            if (overlaps(of, objects.mover(k), box, but)) {
                return true;
            }
        }
        return false;
    }

    private boolean overlaps(LeafTable of, int id, double[] box, int but) {
        return id != but && of.overlaps(id, box) && target.visit(of, id);
    }
}
