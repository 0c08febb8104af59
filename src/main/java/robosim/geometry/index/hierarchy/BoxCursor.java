package robosim.geometry.index.hierarchy;

import java.util.Arrays;

/** Finds the objects of a {@link Hierarchy} whose bounds meet a box, each once; a few more whose bounds nearly do. */
public final class BoxCursor {
    private static final int WIDTH = Hierarchy.WIDTH;
    private static final int PART = Hierarchy.PART;

    private final Hierarchy tree;
    private int[] stack = new int[Hierarchy.STACK];
    private int depth;
    private float minX;
    private float minY;
    private float minZ;
    private float maxX;
    private float maxY;
    private float maxZ;

    /** A cursor over a hierarchy. */
    public BoxCursor(Hierarchy tree) {
        this.tree = tree;
    }

    /** Starts a query in a scene that mostly stands still: the hierarchy may be built anew, and later queries gain by it. */
    public void startSettled(double[] box) {
        tree.settle();
        start(box);
    }

    /** Starts a query with a box of six numbers. */
    public void start(double[] box) {
        minX = Hierarchy.lower(box[0]);
        minY = Hierarchy.lower(box[1]);
        minZ = Hierarchy.lower(box[2]);
        maxX = Hierarchy.upper(box[3]);
        maxY = Hierarchy.upper(box[4]);
        maxZ = Hierarchy.upper(box[5]);
        stack[0] = 0;
        depth = tree.size() == 0 ? 0 : 1;
    }

    /** The next object; -1 after the last. */
    public int next() {
        float[] n = tree.nodes;
        while (depth > 0) {
            int link = stack[--depth];
            if (link < 0) {
                return link & Integer.MAX_VALUE;
            }
            if (depth + WIDTH > stack.length) {
                stack = Arrays.copyOf(stack, 2 * stack.length);
            }
            int at = link * Hierarchy.STRIDE;
            int links = at + Hierarchy.LINKS;
            for (int k = at; k < at + WIDTH * PART; k += PART, links++) {
                // A child that is missing begins at infinity.
                if (n[k] <= maxX
                        && minX <= n[k + 3]
                        && n[k + 2] <= maxZ
                        && minZ <= n[k + 5]
                        && n[k + 1] <= maxY
                        && minY <= n[k + 4]) {
                    stack[depth++] = Float.floatToRawIntBits(n[links]);
                }
            }
        }
        return -1;
    }
}
