package robosim.geometry.index.hierarchy;

import java.util.Arrays;

/** Visits the objects of a {@link Hierarchy} around a point, mostly those first whose bounds are nearer. */
public final class PointCursor {
    private static final int WIDTH = Hierarchy.WIDTH;
    private static final int PART = Hierarchy.PART;

    /** Rounds up the square of a limit, or down what squares of distances are compared with: by more than they are off. */
    private static final double UP = 1 + 0x1p-48;

    private Hierarchy tree = new Hierarchy(() -> {});
    private double x;
    private double y;
    private double z;
    private int[] links = new int[Hierarchy.STACK];

    /** The squares of the distances of bounds. */
    private double[] squares = new double[links.length];

    private int depth;

    /** Starts at a point. */
    public void start(Hierarchy through, double px, double py, double pz) {
        if (tree != through) { // writing a reference is slow
            tree = through;
        }
        through.settle();
        x = px;
        y = py;
        z = pz;
        links[0] = 0;
        squares[0] = 0;
        depth = through.size() == 0 ? 0 : 1;
    }

    /** The next object whose bounds are within a limit; -1 after the last. The limit may shrink from call to call. */
    public int next(double limit) {
        double most = limit * limit * UP + Double.MIN_NORMAL;
        while (depth > 0) {
            depth--;
            if (squares[depth] > most) {
                continue;
            }
            int link = links[depth];
            if (link < 0) {
                return link & Integer.MAX_VALUE;
            }
            open(link, most);
        }
        return -1;
    }

    /** Puts the children of a node on the stack, the nearest on top. */
    private void open(int node, double most) {
        if (depth + WIDTH > links.length) {
            links = Arrays.copyOf(links, 2 * links.length);
            squares = Arrays.copyOf(squares, links.length);
        }
        float[] n = tree.nodes;
        int base = depth;
        int at = node * Hierarchy.STRIDE;
        int link = at + Hierarchy.LINKS;
        for (int k = at; k < at + WIDTH * PART; k += PART, link++) {
            double dx = Math.max(0, Math.max(n[k] - x, x - n[k + 3]));
            double dy = Math.max(0, Math.max(n[k + 1] - y, y - n[k + 4]));
            double dz = Math.max(0, Math.max(n[k + 2] - z, z - n[k + 5]));
            double square = dx * dx + dy * dy + dz * dz;
            if (square <= most && square < Double.POSITIVE_INFINITY) { // infinitely far where a child is missing
                push(base, square, Float.floatToRawIntBits(n[link]));
            }
        }
    }

    private void push(int base, double square, int link) {
        int place = depth++;
        while (place > base && squares[place - 1] < square) {
            squares[place] = squares[place - 1];
            links[place] = links[place - 1];
            place--;
        }
        squares[place] = square;
        links[place] = link;
    }
}
