package robosim.geometry.dynamics.planar;

import java.util.Arrays;

/** In which order bodies are carried: of two that touch at the end, the one into whose place the other goes is first. */
final class CarryingOrder {
    /** The bodies, first to last. */
    int[] bodies = new int[8];

    private int count;
    private boolean[] isSeen = new boolean[8];
    private int[] stack = new int[8];
    private int[] nextLink = new int[8];

    /** Sorts all bodies; where each has been carried from is told by two arrays. */
    void sort(MovingBodies of, CollisionQueue pairs, ConvexPieces pieces, double[] fromX, double[] fromZ) {
        if (bodies.length < of.count) {
            bodies = new int[2 * of.count];
            isSeen = new boolean[2 * of.count];
            stack = new int[2 * of.count];
            nextLink = new int[2 * of.count];
        }
        count = 0;
        Arrays.fill(isSeen, 0, of.count, false);
        for (int b = 0; b < of.count; b++) {
            if (!isSeen[b]) {
                visit(b, of, pairs, pieces, fromX, fromZ);
            }
        }
    }

    private void visit(
            int start, MovingBodies of, CollisionQueue pairs, ConvexPieces pieces, double[] fromX, double[] fromZ) {
        int depth = 0;
        push(0, start, pairs);
        while (depth >= 0) {
            int b = stack[depth];
            int link = nextLink[depth];
            if (link < 0) {
                bodies[count++] = b;
                depth--;
                continue;
            }
            nextLink[depth] = pairs.links[link];
            int pair = link >> 1;
            boolean isSecond = (link & 1) == 1;
            int other = pieces.body[isSecond ? pairs.a[pair] : pairs.b[pair]];
            if (other < 0 || isSeen[other] || !pairs.isNear[pair]) {
                continue;
            }
            double along = (of.x[b] - fromX[b]) * pairs.nx[pair] + (of.z[b] - fromZ[b]) * pairs.nz[pair];
            if (isSecond ? along > 0 : along < 0) {
                push(++depth, other, pairs);
            }
        }
    }

    private void push(int depth, int b, CollisionQueue pairs) {
        stack[depth] = b;
        nextLink[depth] = pairs.heads[b];
        isSeen[b] = true;
    }
}
