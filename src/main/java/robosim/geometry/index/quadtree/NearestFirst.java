package robosim.geometry.index.quadtree;

import robosim.geometry.index.meshes.PlaneKeys;

/**
 * A best-first query of a {@link RegionTree}, ordered along a ray or by the distance from a point; pending regions wait
 * in a queue.
 */
public final class NearestFirst {
    private static final int NONE = Regions.NONE;

    private final EntryQueue queue = new EntryQueue();
    private final PlaneKeys keys = new PlaneKeys();
    private long visited;
    private double entry;

    public long visited() {
        return visited;
    }

    public double entry() {
        return entry;
    }

    public void startRay(RegionTree tree, double ox, double oz, double dx, double dz, double limit) {
        keys.startRay(ox, oz, dx, dz);
        start(tree, limit);
    }

    public void startPoint(RegionTree tree, double x, double z, double limit) {
        keys.startPoint(x, z);
        start(tree, limit);
    }

    private void start(RegionTree tree, double limit) {
        queue.clear();
        entry = 0;
        push(keys.key(tree.regions.bounds, 0), 0, keys.inner(limit));
    }

    /** The next object within the limit, or -1. */
    public int next(RegionTree tree, double[] boxes, double limit) {
        double within = keys.inner(limit);
        while (!queue.isEmpty() && queue.leastKey() <= within) {
            double key = queue.leastKey();
            int id = descend(tree, boxes, queue.pop(), key, within);
            if (id != NONE) {
                return id;
            }
        }
        return -1;
    }

    // Descends from the item of the smallest key as long as one of its parts comes before everything in the queue, so
    // that part need not be queued.
    private int descend(RegionTree tree, double[] boxes, int item, double itsKey, double within) {
        int region = item;
        double key = itsKey;
        while (region >= 0) {
            visited++;
            int link = tree.regions.links[region];
            if (link < 0) {
                int id = RegionTree.first(link);
                if (link != ~id) {
                    pushAll(tree, boxes, id, within);
                    return NONE;
                }
                entry = keys.outer(key); // the region's bounds are its box
                return id;
            }
            double least = Double.POSITIVE_INFINITY;
            int nearest = NONE;
            for (int quarter = link; quarter < link + 4; quarter++) {
                double its = keys.key(tree.regions.bounds, 4 * quarter);
                if (its < least) {
                    push(least, nearest, within);
                    least = its;
                    nearest = quarter;
                } else {
                    push(its, quarter, within);
                }
            }
            if (nearest == NONE || least > within || least > queue.leastKey()) {
                push(least, nearest, within);
                return NONE;
            }
            region = nearest;
            key = least;
        }
        entry = keys.outer(key);
        return ~region;
    }

    private void pushAll(RegionTree tree, double[] boxes, int first, double within) {
        for (int id = first; id != NONE; id = tree.next[id]) {
            push(keys.keyOfObject(boxes, 6 * id), ~id, within);
        }
    }

    private void push(double key, int item, double within) {
        if (key <= within && key < Double.POSITIVE_INFINITY) {
            queue.push(key, item);
        }
    }
}
