package robosim.geometry.dynamics.spatial;

import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafColumn;

/** Finds where bodies touch. */
final class ContactDetection {
    /** Contacts are looked for within so many metres. */
    static final double TOUCH = 1e-4;

    /** What rises above a plane by less than so many metres is flush with it. */
    private static final double FLUSH = 1e-7;

    private final List<RigidBody> bodies;
    private final EnergyBudget budget;
    private final NearbyPieces near;
    private final Contacts contacts;
    private final ContactGeometry meeting = new ContactGeometry();
    private final LeafColumn leaf = new LeafColumn(1);
    private int[] bodyOf = new int[0];

    ContactDetection(List<RigidBody> bodies, EnergyBudget budget, NearbyPieces near, Contacts contacts) {
        this.bodies = bodies;
        this.budget = budget;
        this.near = near;
        this.contacts = contacts;
    }

    /** Forgets which objects are bodies; ids are below a limit. */
    void clear(int limit) {
        if (bodyOf.length < limit) {
            bodyOf = new int[limit + 16];
        }
        Arrays.fill(bodyOf, -1);
    }

    void add(int object, int body) {
        bodyOf[object] = body;
    }

    private int bodyOf(int object) {
        return object < 0 || object >= bodyOf.length ? -1 : bodyOf[object];
    }

    /** Lets a body share its momentum with the one that an object is, if it is a body that moves. */
    void join(int b, int object) {
        int other = bodyOf(object);
        if (other >= 0 && !bodies.get(other).isAsleep) {
            budget.join(b, other);
        }
    }

    /** Finds the contacts of a body; those with other bodies that will find them too only if asked. */
    void gather(int b, boolean all) {
        RigidBody body = bodies.get(b);
        near.find(body, 0, 0, 0, body.reach + TOUCH);
        near.leaf(body, body.place, leaf);
        int from = contacts.count;
        for (int k = 0; k < near.count; k++) {
            int other = bodyOf(near.object[k]);
            if (other >= 0 && !all && other < b && !bodies.get(other).isAsleep) {
                continue;
            }
            int at = k * Leaf.STRIDE;
            if (meeting.measure(leaf.kind(0), leaf.rows(), 0, near.kind[k], near.rows, at) && meeting.apart <= TOUCH) {
                body.isTouching = true;
                if (other >= 0) {
                    budget.join(b, other);
                }
                body.isHeld |= other < 0 || bodies.get(other).isAsleep;
                int added = contacts.count;
                meeting.points(b, other, near.object[k], TOUCH, contacts);
                Arrays.fill(contacts.piece, added, contacts.count, k);
            }
        }
        dropInnerEdges(from);
    }

    /** The first object around a body from which no direction separates it; -1 for the border, and if there is none. */
    int overlapped(RigidBody body) {
        near.find(body, 0, 0, 0, body.reach + TOUCH);
        near.leaf(body, body.place, leaf);
        for (int k = 0; k < near.count; k++) {
            if (!meeting.measure(leaf.kind(0), leaf.rows(), 0, near.kind[k], near.rows, k * Leaf.STRIDE)) {
                return near.object[k];
            }
        }
        return -1;
    }

    /** How far a body is at least from all that is near it; 0 if no direction separates it from something. */
    double apart(RigidBody body) {
        near.find(body, 0, 0, 0, body.reach + TOUCH);
        near.leaf(body, body.place, leaf);
        double least = TOUCH;
        for (int k = 0; k < near.count && least > 0; k++) {
            boolean isApart = meeting.measure(leaf.kind(0), leaf.rows(), 0, near.kind[k], near.rows, k * Leaf.STRIDE);
            least = isApart ? Math.min(least, meeting.apart) : 0;
        }
        return least;
    }

    /** Whether everything except the bodies of its own group is farther from a body than a distance. */
    boolean isAlone(RigidBody body, double distance) {
        near.find(body, 0, 0, 0, body.reach + distance);
        near.leaf(body, body.place, leaf);
        for (int k = 0; k < near.count; k++) {
            int other = bodyOf(near.object[k]);
            boolean isOwn = other >= 0 && bodies.get(other).group == body.group;
            if (!isOwn && !isFarther(k, distance)) {
                return false;
            }
        }
        return true;
    }

    private boolean isFarther(int k, double distance) {
        return meeting.measure(leaf.kind(0), leaf.rows(), 0, near.kind[k], near.rows, k * Leaf.STRIDE)
                && meeting.apart > distance;
    }

    /** Adds the bodies that are nearer to a body than a distance. */
    void neighbours(RigidBody body, double within, BitSet out) {
        near.find(body, 0, 0, 0, body.reach + TOUCH);
        near.leaf(body, body.place, leaf);
        for (int k = 0; k < near.count; k++) {
            int other = bodyOf(near.object[k]);
            if (other >= 0 && !isFarther(k, within)) {
                out.set(other);
            }
        }
    }

    /**
     * Takes out, from one contact on, those on an inner edge of a surface: where a piece that does not rise above the plane of
     * a nearer contact is met, the body is on that plane, and the edge is none.
     */
    private void dropInnerEdges(int from) {
        int kept = from;
        for (int k = from; k < contacts.count; k++) {
            if (!isOnInnerEdge(from, k)) {
                contacts.copy(k, kept++);
            }
        }
        contacts.count = kept;
    }

    private boolean isOnInnerEdge(int from, int k) {
        double[] normal = contacts.normal;
        for (int m = from; m < contacts.count; m++) {
            if (m == k || contacts.other[m] != contacts.other[k] || contacts.apart[m] > contacts.apart[k]) {
                continue;
            }
            int a = 3 * m;
            int b = 3 * k;
            double same = normal[a] * normal[b] + normal[a + 1] * normal[b + 1] + normal[a + 2] * normal[b + 2];
            if (same > 1 - 1e-9 || same < 0.5) {
                continue; // one plane, or a corner that is sharp indeed
            }
            if (height(k, m) < FLUSH) {
                return true;
            }
        }
        return false;
    }

    /** How far the piece of one contact rises above the plane of another one, both of those found last. */
    double height(int k, int plane) {
        // Points lie midway, so the obstacle's own is half of the gap further back.
        double back = 0.5 * contacts.apart[plane];
        int piece = contacts.piece[k];
        return meeting.height(
                        near.kind[piece], near.rows, piece * Leaf.STRIDE, contacts.point, contacts.normal, 3 * plane)
                + back;
    }
}
