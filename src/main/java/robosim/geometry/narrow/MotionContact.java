package robosim.geometry.narrow;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.exact.VectorMath;
import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.distance.ConvexContact;
import robosim.geometry.narrow.gjk.ClosingDirections;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.UnderflowScaling;

/**
 * The contact point and normal of a motion that was blocked, from the mover where it stops and the pieces that it meets there.
 *
 * <p>Each piece has one or more normals: the separating axes that close where the mover stops ({@link ClosingDirections}). Of
 * all of them, that is reported which opposes the motion most. Where several pieces are hit at once, normals of planes that
 * part the mover from all of them come first: at the seam of two tiles of a wall, the normal of the wall.
 *
 * <p>A piece that is near, but has an axis along which the motion does not close, does not block, and counts for nothing: the
 * floor below a mover. A normal never points along the motion: if rounding would make it, it is made square to it.
 */
public final class MotionContact {
    /** Numbers of a contact: a point and a normal. */
    private static final int CONTACT = 6;

    /** A motion whose direction has less of a normal than this goes along the plane. */
    private static final double ALONG = 0x1p-48;

    /** What rounding may make of the product of a normal and a direction square to it, and more. */
    private static final double ROUNDING = 0x1p-50;

    /** Normals that oppose a motion equally to within this tie. */
    private static final double EQUAL = 0x1p-40;

    /** How much further away than the first piece others may be, in roundings of the distance. */
    private static final double TIE = 4;

    /** Most pairs that are compared. */
    private static final int MOST_PAIRS = 1024;

    private final Scratch s;
    private final ClosingDirections closing = new ClosingDirections();
    private final PiecePairs near;
    private final PiecePairs.Visitor visitor = this::visit;
    private final double[] way = new double[3];
    private final double[] point = new double[CONTACT];
    private final double[] box = new double[6];
    private final double[] other = new double[6];

    private Dimension dimension = Dimension.SPATIAL;
    private Sweep motion;

    /** The leaves of each pair that is near, and whether it blocks; the first is the one that was met first. */
    private final List<Leaf> movers = new ArrayList<>();

    private final List<Leaf> others = new ArrayList<>();
    private boolean[] isBlocking = new boolean[4];
    private boolean[] isDeep = new boolean[4];
    private int pairs;

    /** The contacts that may be reported, and how much each opposes the motion: -1 head on. */
    private double[] contacts = new double[8 * CONTACT];

    private double[] ahead = new double[8];
    private long[] ranks = new long[8];
    private int[] pairOf = new int[8];

    /** By contact, the first one with its normal: many objects in one place have few different normals. */
    private int[] sameAs = new int[8];

    /** The contacts that are the first with their normals. */
    private int[] distinct = new int[8];

    private int distinctCount;

    /** Whether the plane of a contact parts the mover from all that is near, and from all that blocks. */
    private boolean[] partsNear = new boolean[8];

    private boolean[] partsBlocking = new boolean[8];
    private int found;

    /** Pairs further apart do not block. */
    private double limit;

    /** The pair that was found last; -1 if it was not kept. */
    private int current;

    // Of the last pair.
    private double gap;
    private double slack;

    private long rank;

    @SuppressWarnings("NullAway.Init") // begin sets the motion
    public MotionContact(Scratch scratch) {
        s = scratch;
        near = new PiecePairs(scratch);
    }

    /**
     * Begins with the pieces that met first: single ones, unless one is inside of the other.
     *
     * @param first the rank of the other piece's object
     */
    public void begin(Dimension inDimension, Sweep sweep, LeafColumn own, LeafColumn met, long first) {
        dimension = inDimension;
        motion = sweep;
        pairs = 0;
        found = 0;
        rank = first;
        limit = Double.POSITIVE_INFINITY;
        visit(s.leaf.placedA.set(own, 0), -1, s.leaf.placedB.set(met, 0), -1);
    }

    /** How far away other pieces may be that are hit at once. */
    public double reach() {
        return limit;
    }

    /**
     * Adds the pieces of two leaves that block as well.
     *
     * @param of the rank of the second leaf's object: of equal contacts, the one of least rank is reported; -1 if none of its
     *     contacts may be reported
     */
    public void add(LeafColumn own, int i, LeafColumn met, int j, long of) {
        own.bounds(i, box);
        met.bounds(j, other);
        for (int k = 0; k < 3; k++) {
            boolean counts = k != 1 || dimension == Dimension.SPATIAL;
            if (counts && (box[k] - other[3 + k] > limit || other[k] - box[3 + k] > limit)) {
                return;
            }
        }
        rank = of;
        near.within(limit).any(dimension, own, i, met, j, visitor);
    }

    private boolean visit(Leaf a, int t, Leaf b, int u) {
        find(a, b);
        if (gap > limit || (gap < -limit && rank < 0)) {
            return false;
        }
        int before = found;
        boolean blocks = true;
        for (int k = 0; k < closing.count(); k++) {
            point[3] = closing.x(k);
            point[4] = closing.y(k);
            point[5] = closing.z(k);
            if (motion.isTurn() && (k == 0 || closing.isLevel())) {
                place(a, b);
            }
            blocks &= offer();
        }
        if (pairs == 0) {
            limit = Math.max(0, gap) + TIE * slack;
            blocks = true;
        }
        if (found == before) { // concentric: any direction parts them
            Arrays.fill(point, 0);
            place(a, b);
            offer();
        }
        if (rank < 0 || !blocks) {
            found = before;
        }
        keep(a, b);
        isBlocking[pairs - 1] = blocks;
        isDeep[pairs - 1] = gap < -limit;
        current = pairs - 1;
        return pairs == MOST_PAIRS;
    }

    /** Finds the closing directions of a pair, its gap and how far that may be off. */
    private void find(Leaf a, Leaf b) {
        current = -1;
        boolean isFlat = dimension == Dimension.PLANAR;
        UnderflowScaling m = s.leaf.scaling;
        if (m.take(dimension, a, b)) {
            closing.find(isFlat, m.first, m.second);
            gap = m.down(closing.gap());
            slack = m.down(closing.slack());
        } else {
            closing.find(isFlat, a, b);
            gap = closing.gap();
            slack = closing.slack();
        }
    }

    /** Writes the contact point of the pair, which depends on the normal if they are side to side. */
    private void place(Leaf a, Leaf b) {
        ConvexContact.along(dimension, closing.isLevel(), a, b, point, s.distance);
        if (closing.isLevel()) {
            point[1] = closing.middle();
        }
    }

    /** Adds a contact, and answers whether the motion goes against its normal. */
    private boolean offer() {
        if (found == ahead.length) {
            contacts = Arrays.copyOf(contacts, 2 * contacts.length);
            ahead = Arrays.copyOf(ahead, 2 * found);
            ranks = Arrays.copyOf(ranks, 2 * found);
            pairOf = Arrays.copyOf(pairOf, 2 * found);
            sameAs = Arrays.copyOf(sameAs, 2 * found);
            distinct = Arrays.copyOf(distinct, 2 * found);
            partsNear = Arrays.copyOf(partsNear, 2 * found);
            partsBlocking = Arrays.copyOf(partsBlocking, 2 * found);
        }
        motion.direction(point[0], point[1], point[2], way);
        System.arraycopy(point, 0, contacts, CONTACT * found, CONTACT);
        ranks[found] = rank;
        pairOf[found] = pairs;
        ahead[found] = point[3] * way[0] + point[4] * way[1] + point[5] * way[2];
        return ahead[found++] < -ALONG;
    }

    private void keep(Leaf a, Leaf b) {
        if (pairs == movers.size()) {
            movers.add(new Leaf());
            others.add(new Leaf());
        }
        if (pairs == isBlocking.length) {
            isBlocking = Arrays.copyOf(isBlocking, 2 * pairs);
            isDeep = Arrays.copyOf(isDeep, 2 * pairs);
        }
        movers.get(pairs).copy(a.kind, a.row, a.at);
        others.get(pairs).copy(b.kind, b.row, b.at);
        pairs++;
    }

    /** Writes the contact that is reported, six numbers; returns the rank of its object. */
    public long choose(double[] out) {
        sort();
        Arrays.fill(partsNear, 0, found, true);
        Arrays.fill(partsBlocking, 0, found, true);
        for (int k = 0; k < pairs && pairs > 1; k++) {
            part(k);
        }
        for (int k = 0; k < found; k++) {
            partsNear[k] = partsNear[sameAs[k]];
            partsBlocking[k] = partsBlocking[sameAs[k]];
        }
        int best = best(partsNear, -ALONG);
        best = best >= 0 ? best : best(partsNear, ALONG);
        best = best >= 0 ? best : best(partsBlocking, 0);
        best = best >= 0 ? best : best(null, 2);
        System.arraycopy(contacts, CONTACT * best, point, 0, CONTACT);
        if (!motion.isTurn()) { // else it was needed to know which way it goes
            Leaf mover = movers.get(pairOf[best]);
            Leaf other = others.get(pairOf[best]);
            if (current != pairOf[best]) {
                find(mover, other);
            }
            place(mover, other);
        }
        System.arraycopy(point, 0, out, 0, CONTACT);
        lean(motion, out);
        return ranks[best];
    }

    /** Finds the different normals: each is compared with the pairs once, however many contacts have it. */
    private void sort() {
        distinctCount = 0;
        for (int k = 0; k < found; k++) {
            int first = k;
            for (int d = 0; d < distinctCount && first == k; d++) {
                first = haveSameNormal(distinct[d], k) ? distinct[d] : k;
            }
            if (first == k) {
                distinct[distinctCount++] = k;
            }
            sameAs[k] = first;
            s.work.take(distinctCount);
        }
    }

    private boolean haveSameNormal(int a, int b) {
        int n = CONTACT * a + 3;
        int m = CONTACT * b + 3;
        return contacts[n] == contacts[m] && contacts[n + 1] == contacts[m + 1] && contacts[n + 2] == contacts[m + 2];
    }

    /** Finds the normals whose planes do not part a pair; no plane parts a deep overlap. */
    private void part(int pair) {
        s.work.take(distinctCount);
        if (isDeep[pair]) {
            return;
        }
        Leaf mover = movers.get(pair);
        Leaf other = others.get(pair);
        UnderflowScaling m = s.leaf.scaling;
        boolean flat = dimension == Dimension.PLANAR;
        double error;
        if (m.take(dimension, mover, other)) {
            error = closing.load(flat, m.first, m.second);
        } else {
            error = closing.load(flat, mover, other);
        }
        for (int d = 0; d < distinctCount; d++) {
            int k = distinct[d];
            int n = CONTACT * k + 3;
            boolean isParted = closing.gap(contacts[n], contacts[n + 1], contacts[n + 2]) >= -error;
            partsNear[k] &= isParted;
            partsBlocking[k] &= isParted || !isBlocking[pair];
        }
    }

    /**
     * The contact that opposes the motion most, of those that have at most so much of its direction; -1 if there is none.
     *
     * @param parts which contacts count; null if all do
     */
    private int best(boolean @Nullable [] parts, double most) {
        double least = Double.POSITIVE_INFINITY;
        for (int k = 0; k < found; k++) {
            if ((parts == null || parts[k]) && ahead[k] <= most) {
                least = Math.min(least, ahead[k]);
            }
        }
        int best = -1;
        for (int k = 0; k < found; k++) {
            boolean counts = (parts == null || parts[k]) && ahead[k] <= Math.min(most, least + EQUAL);
            if (counts && (best < 0 || isBefore(k, best))) {
                best = k;
            }
        }
        return best;
    }

    /** Of equal contacts that of the object of least rank comes first, and then those with greater coordinates of the normal. */
    private boolean isBefore(int k, int than) {
        int n = CONTACT * k + 3;
        int m = CONTACT * than + 3;
        int order = Long.compare(ranks[than], ranks[k]);
        order = order != 0 ? order : Double.compare(contacts[n], contacts[m]);
        order = order != 0 ? order : Double.compare(contacts[n + 2], contacts[m + 2]);
        return (order != 0 ? order : Double.compare(contacts[n + 1], contacts[m + 1])) > 0;
    }

    /** Takes off the part of a normal that points along a motion; if nothing else is left, it becomes the opposite. */
    public void lean(Sweep sweep, double[] out) {
        sweep.direction(out[0], out[1], out[2], way);
        double along = out[3] * way[0] + out[4] * way[1] + out[5] * way[2];
        double length = VectorMath.length(out[3], out[4], out[5]);
        boolean isSquare = out[3] * way[0] == 0 && out[4] * way[1] == 0 && out[5] * way[2] == 0;
        if ((along < -ROUNDING || isSquare) && length > 0) {
            return;
        }
        for (int k = 0; k < 3; k++) {
            out[3 + k] -= (along + ROUNDING) * way[k];
        }
        length = VectorMath.length(out[3], out[4], out[5]);
        for (int k = 0; k < 3; k++) {
            out[3 + k] = length > 0x1p-40 ? out[3 + k] / length : 0 - way[k];
        }
    }
}
