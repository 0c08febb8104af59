package robosim.geometry.dynamics.spatial;

import java.util.Arrays;
import java.util.List;
import java.util.function.BiPredicate;

/**
 * The bodies that can touch each other in a slice of time, directly or through others: what one cluster does in it concerns no
 * other. Balls around the bodies, larger by twice their ways, are swept along X (sort and sweep).
 */
final class Clusters {
    /** How many bodies the present cluster has, and their indices in ascending order. */
    int count;

    int[] member = new int[0];

    private final List<RigidBody> bodies;
    private final double pull;
    private final BiPredicate<RigidBody, RigidBody> arePassing;

    /** Bodies by where their balls begin, which changes little from slice to slice. */
    private int[] order = new int[0];

    private double[] begin = new double[0];
    private double[] size = new double[0];

    /** By body: one of its cluster, the least one at the end; and the next one of the cluster, -1 for none. */
    private int[] root = new int[0];

    private int[] next = new int[0];
    private int[] last = new int[0];

    /** Two bodies that pass through each other cannot touch each other. */
    Clusters(List<RigidBody> bodies, double[] gravity, BiPredicate<RigidBody, RigidBody> arePassing) {
        this.arePassing = arePassing;
        this.bodies = bodies;
        pull = RigidBody.length(gravity, 0);
    }

    /** Finds the clusters of a slice. */
    void find(double seconds) {
        int all = bodies.size();
        if (order.length != all) {
            order = new int[all];
            for (int k = 0; k < all; k++) {
                order[k] = k;
            }
            begin = new double[all];
            size = new double[all];
            root = new int[all];
            next = new int[all];
            last = new int[all];
            member = new int[all];
        }
        for (int b = 0; b < all; b++) {
            RigidBody body = bodies.get(b);
            double way = (RigidBody.length(body.v, 0) + (pull + body.pushed()) * seconds) * seconds;
            size[b] = body.reach + 2 * way + ContactDetection.TOUCH;
            begin[b] = body.place[0] - size[b];
            root[b] = b;
        }
        sort(all);
        for (int k = 0; k < all; k++) {
            int b = order[k];
            double end = bodies.get(b).place[0] + size[b];
            for (int m = k + 1; m < all && begin[order[m]] <= end; m++) {
                if (isNear(b, order[m]) && !arePassing.test(bodies.get(b), bodies.get(order[m]))) {
                    join(b, order[m]);
                }
            }
        }
        list(all);
    }

    private void sort(int all) {
        for (int k = 1; k < all; k++) {
            int b = order[k];
            int to = k;
            while (to > 0 && begin[order[to - 1]] > begin[b]) {
                order[to] = order[to - 1];
                to--;
            }
            order[to] = b;
        }
    }

    private boolean isNear(int a, int b) {
        double[] p = bodies.get(a).place;
        double[] q = bodies.get(b).place;
        double x = p[0] - q[0];
        double y = p[1] - q[1];
        double z = p[2] - q[2];
        double reach = size[a] + size[b];
        return x * x + y * y + z * z <= reach * reach;
    }

    private int root(int b) {
        int at = b;
        while (root[at] != at) {
            root[at] = root[root[at]];
            at = root[at];
        }
        return at;
    }

    private void join(int a, int b) {
        int one = root(a);
        int other = root(b);
        root[Math.max(one, other)] = Math.min(one, other);
    }

    private void list(int all) {
        Arrays.fill(next, 0, all, -1);
        for (int b = 0; b < all; b++) {
            int first = root(b);
            if (first != b) {
                next[last[first]] = b;
            }
            last[first] = b;
        }
    }

    /** Takes the cluster of which a body is the first one; false if it is not, or if all of the cluster rest. */
    boolean take(int first) {
        if (root(first) != first) {
            return false;
        }
        count = 0;
        boolean moves = false;
        for (int b = first; b >= 0; b = next[b]) {
            member[count++] = b;
            moves |= !bodies.get(b).isAsleep;
        }
        return moves;
    }

    /** Whether a body is of the present cluster. */
    boolean has(int b) {
        return root(b) == member[0];
    }
}
