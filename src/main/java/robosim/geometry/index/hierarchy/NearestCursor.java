package robosim.geometry.index.hierarchy;

import java.util.Arrays;
import robosim.geometry.index.boxes.SpaceKeys;

/** Visits the objects of a {@link Hierarchy} in the order of the keys at which bounds begin: nearly so, nearer nodes first. */
public final class NearestCursor {
    private static final int WIDTH = Hierarchy.WIDTH;
    private static final int PART = Hierarchy.PART;

    private final Hierarchy tree;
    private final SpaceKeys keys;
    private final double[] box = new double[PART];
    private double[] boxes = new double[0];
    private int[] links = new int[Hierarchy.STACK];
    private double[] begins = new double[links.length];
    private int depth;

    /**
     * A cursor over a hierarchy.
     *
     * @param keys tells where bounds begin; is set to what a query looks for before that starts
     */
    public NearestCursor(Hierarchy tree, SpaceKeys keys) {
        this.tree = tree;
        this.keys = keys;
    }

    /**
     * Starts a query.
     *
     * @param objects the boxes of objects, six numbers each, of which the keys are exact
     */
    public void start(double[] objects) {
        tree.settle();
        boxes = objects;
        links[0] = 0;
        begins[0] = 0;
        depth = tree.size() == 0 ? 0 : 1;
    }

    /** The next object that begins within the limit; -1 after the last. The limit may shrink from call to call. */
    public int next(double limit) {
        while (depth > 0) {
            depth--;
            if (!(begins[depth] <= limit)) {
                continue;
            }
            int link = links[depth];
            if (link < 0) {
                return link & Integer.MAX_VALUE;
            }
            open(link, limit);
        }
        return -1;
    }

    /** Puts the children of a node on the stack, the nearest on top. */
    private void open(int node, double limit) {
        int base = depth;
        int at = node * Hierarchy.STRIDE;
        for (int k = 0; k < WIDTH; k++) {
            int link = Float.floatToRawIntBits(tree.nodes[at + Hierarchy.LINKS + k]);
            if (link != Hierarchy.NONE) {
                push(
                        base,
                        link < 0 ? keys.key(boxes, 6 * (link & Integer.MAX_VALUE)) : key(at + PART * k),
                        link,
                        limit);
            }
        }
    }

    private double key(int at) {
        for (int k = 0; k < PART; k++) {
            box[k] = tree.nodes[at + k];
        }
        return keys.key(box, 0);
    }

    private void push(int base, double begin, int link, double limit) {
        if (!(begin <= limit && begin < Double.POSITIVE_INFINITY)) {
            return;
        }
        if (depth == links.length) {
            links = Arrays.copyOf(links, 2 * depth);
            begins = Arrays.copyOf(begins, 2 * depth);
        }
        int place = depth++;
        while (place > base && begins[place - 1] < begin) {
            begins[place] = begins[place - 1];
            links[place] = links[place - 1];
            place--;
        }
        begins[place] = begin;
        links[place] = link;
    }
}
