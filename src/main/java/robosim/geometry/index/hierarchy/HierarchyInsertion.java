package robosim.geometry.index.hierarchy;

/** Hangs one object in a {@link Hierarchy}: goes down to where the surface area grows least. */
final class HierarchyInsertion {
    private static final int WIDTH = Hierarchy.WIDTH;
    private static final int PART = Hierarchy.PART;

    private HierarchyInsertion() {}

    /** Hangs an object with its box; returns how deep. */
    static int insert(Hierarchy tree, int id, float[] box) {
        int node = 0;
        int depth = 1;
        while (true) {
            int best = cheapest(tree, node, box);
            int spare = spare(tree, node);
            int link = best < 0 ? Hierarchy.NONE : tree.link(best);
            if (spare >= 0
                    && (link < 0
                            || link == Hierarchy.NONE
                            || growth(tree.nodes, Hierarchy.at(best), box) >= area(box, 0))) {
                System.arraycopy(box, 0, tree.nodes, Hierarchy.at(spare), PART);
                tree.link(spare, Integer.MIN_VALUE | id);
                return depth;
            }
            if (link < 0) {
                int made = tree.claim();
                System.arraycopy(tree.nodes, Hierarchy.at(best), tree.nodes, Hierarchy.at(WIDTH * made), PART);
                tree.link(WIDTH * made, link);
                tree.link(best, made);
                link = made;
            }
            grow(tree.nodes, Hierarchy.at(best), box);
            node = link;
            depth++;
        }
    }

    /** The child whose area grows least by a box, of several the smallest; -1 where there is none. */
    private static int cheapest(Hierarchy tree, int node, float[] box) {
        int best = -1;
        double least = Double.POSITIVE_INFINITY;
        double smallest = Double.POSITIVE_INFINITY;
        for (int slot = WIDTH * node; slot < WIDTH * node + WIDTH; slot++) {
            if (tree.link(slot) == Hierarchy.NONE) {
                continue;
            }
            int at = Hierarchy.at(slot);
            double growth = growth(tree.nodes, at, box);
            double area = growth <= least ? area(tree.nodes, at) : 0;
            if (growth < least || (growth == least && area < smallest) || best < 0) {
                best = slot;
                least = growth;
                smallest = area;
            }
        }
        return best;
    }

    private static int spare(Hierarchy tree, int node) {
        for (int slot = WIDTH * node; slot < WIDTH * node + WIDTH; slot++) {
            if (tree.link(slot) == Hierarchy.NONE) {
                return slot;
            }
        }
        return -1;
    }

    /** By how much the area of the bounds that begin at an index would grow by a box. */
    private static double growth(float[] of, int at, float[] box) {
        double x = Math.max((double) of[at + 3], box[3]) - Math.min(of[at], box[0]);
        double y = Math.max((double) of[at + 4], box[4]) - Math.min(of[at + 1], box[1]);
        double z = Math.max((double) of[at + 5], box[5]) - Math.min(of[at + 2], box[2]);
        return x * y + y * z + z * x - area(of, at);
    }

    private static double area(float[] of, int at) {
        double x = (double) of[at + 3] - of[at];
        double y = (double) of[at + 4] - of[at + 1];
        double z = (double) of[at + 5] - of[at + 2];
        return x * y + y * z + z * x;
    }

    private static void grow(float[] of, int at, float[] box) {
        for (int axis = 0; axis < 3; axis++) {
            of[at + axis] = Math.min(of[at + axis], box[axis]);
            of[at + 3 + axis] = Math.max(of[at + 3 + axis], box[3 + axis]);
        }
    }
}
