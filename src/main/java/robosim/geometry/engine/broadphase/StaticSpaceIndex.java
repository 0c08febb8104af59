package robosim.geometry.engine.broadphase;

import java.util.BitSet;
import org.jspecify.annotations.Nullable;
import robosim.geometry.index.QuadTree;
import robosim.geometry.index.boxes.OctTree;

/**
 * Where the static objects of a table are looked for: in its quadtree, or, where heights count and the scene is stacked, in
 * an octree. It is taken for stacked when its objects' heights above the ground vary by more than they are high themselves;
 * that is looked at as the scene grows, and once an octree has been made it stays.
 */
public final class StaticSpaceIndex {
    /** So few objects are no stack. */
    private static final int FEW = 64;

    /** The standard deviation of heights above the ground, in mean heights of objects: above that of some five storeys. */
    private static final double SPREAD = 1.5;

    private final boolean hasHeights;
    private final BitSet ids = new BitSet(0);
    private int count;
    private double sum;
    private double squares;
    private double heights;
    private double most;

    /** At so many objects the scene is looked at again. */
    private int look = FEW;

    private @Nullable OctTree tree;
    private OctTree.@Nullable Cursor cursor;

    StaticSpaceIndex(boolean hasHeights) {
        this.hasHeights = hasHeights;
    }

    /** The same objects, of which none comes or goes any more, for one more thread to ask. */
    StaticSpaceIndex view() {
        StaticSpaceIndex view = new StaticSpaceIndex(hasHeights);
        view.most = most;
        view.tree = tree;
        view.cursor = tree == null ? null : tree.cursor();
        return view;
    }

    /** The cursor over the octree; null where there is none, and all stand in the quadtree. */
    public OctTree.@Nullable Cursor cursor() {
        return cursor;
    }

    /** No object that was ever here is higher or lower. */
    public double most() {
        return most;
    }

    /** Adds a static object to one of the trees; the quadtree keeps the bounds of all. */
    void add(int id, QuadTree flat) {
        if (tree != null) {
            tree.add(id, flat.boxes());
        } else {
            flat.list(id);
        }
        if (hasHeights) {
            ids.set(id);
            count(flat.boxes(), 6 * id, 1);
            if (tree == null && count >= look) {
                look = count + (count >> 1);
                if (isStacked()) {
                    pile(flat.boxes(), flat);
                }
            }
        }
    }

    /** Takes a static object out of the one that it is in. */
    void remove(int id, QuadTree flat) {
        if (tree != null) {
            tree.remove(id, flat.boxes());
        } else {
            flat.remove(id);
        }
        if (hasHeights) {
            ids.clear(id);
            count(flat.boxes(), 6 * id, -1);
        }
    }

    private void count(double[] bounds, int b, int by) {
        double y = bounds[b + 1] / 2 + bounds[b + 4] / 2;
        count += by;
        sum += by * y;
        squares += by * y * y;
        heights += by * (bounds[b + 4] - bounds[b + 1]);
        most = Math.max(most, Math.max(-bounds[b + 1], bounds[b + 4]));
    }

    private boolean isStacked() {
        double mean = sum / count;
        double height = SPREAD * heights / count;
        return squares / count - mean * mean > height * height;
    }

    /** Moves all static objects from the quadtree to an octree. */
    private void pile(double[] bounds, QuadTree flat) {
        double[] extent = {1 / 0.0, 1 / 0.0, 1 / 0.0, -1 / 0.0, -1 / 0.0, -1 / 0.0};
        for (int id = ids.nextSetBit(0); id >= 0; id = ids.nextSetBit(id + 1)) {
            for (int axis = 0; axis < 3; axis++) {
                extent[axis] = Math.min(extent[axis], bounds[6 * id + axis]);
                extent[3 + axis] = Math.max(extent[3 + axis], bounds[6 * id + 3 + axis]);
            }
        }
        OctTree made = new OctTree(extent);
        for (int id = ids.nextSetBit(0); id >= 0; id = ids.nextSetBit(id + 1)) {
            flat.remove(id);
            made.add(id, bounds);
        }
        tree = made;
        cursor = made.cursor();
    }
}
