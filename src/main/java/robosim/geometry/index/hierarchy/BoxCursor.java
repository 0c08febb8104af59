package robosim.geometry.index.hierarchy;

import java.util.Arrays;

/** Finds the objects of a {@link Hierarchy} whose bounds meet a box, each once; a few more whose bounds nearly do. */
public final class BoxCursor {
    private static final int WIDTH = Hierarchy.WIDTH;
    private static final int PART = Hierarchy.PART;

    private Hierarchy tree = Hierarchy.EMPTY;
    private int[] links = new int[Hierarchy.STACK];
    private int depth;
    private float minX;
    private float minY;
    private float minZ;
    private float maxX;
    private float maxY;
    private float maxZ;

    /** Starts a query in a scene that mostly stands still: the hierarchy may be built anew, and later queries gain by it. */
    public void startSettled(Hierarchy through, double[] box) {
        through.settle();
        start(through, box);
    }

    /** Starts a query with a box of six numbers. */
    public void start(Hierarchy through, double[] box) {
        if (tree != through) { // writing a reference is slow
            tree = through;
        }
        minX = Hierarchy.lower(box[0]);
        minY = Hierarchy.lower(box[1]);
        minZ = Hierarchy.lower(box[2]);
        maxX = Hierarchy.upper(box[3]);
        maxY = Hierarchy.upper(box[4]);
        maxZ = Hierarchy.upper(box[5]);
        through.takeIn();
        links[0] = 0;
        depth = through.size() == 0 ? 0 : 1;
    }

    /** The next object; -1 after the last. */
    public int next() {
        float[] n = tree.nodes;
        while (depth > 0) {
            int link = links[--depth];
            if (link < 0) {
                return link & Integer.MAX_VALUE;
            }
            if (depth + WIDTH > links.length) {
                links = Arrays.copyOf(links, 2 * links.length);
            }
            int at = link * Hierarchy.STRIDE;
            int child = at + Hierarchy.LINKS;
            for (int k = at; k < at + WIDTH * PART; k += PART, child++) {
                // A child that is missing begins at infinity.
                if (n[k] <= maxX
                        && minX <= n[k + 3]
                        && n[k + 2] <= maxZ
                        && minZ <= n[k + 5]
                        && n[k + 1] <= maxY
                        && minY <= n[k + 4]) {
                    links[depth++] = Float.floatToRawIntBits(n[child]);
                }
            }
        }
        return -1;
    }
}
