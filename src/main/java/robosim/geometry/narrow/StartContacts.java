package robosim.geometry.narrow;

import java.util.Arrays;
import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.gjk.HullOverlap;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafBoxes;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.leaf.MeshWalk;
import robosim.geometry.narrow.overlap.ConvexOverlap;
import robosim.geometry.narrow.overlap.HeightIntervals;
import robosim.geometry.narrow.sat.ExactFeatures;

/**
 * The contacts of a mover at the start of a motion, such as a floor that it stands on: if a plane separates the mover
 * from a piece in contact, and the motion does not cross the plane, nothing that lies wholly behind the plane blocks.
 *
 * <p>A piece q does not block a piece k of the mover if some piece i of the mover touches some piece p at the start,
 * and there is a plane with p and q on one side and, at the start, at the end as stored and in between, i and k on the
 * other; both sides are closed. This is decided on the stored numbers without rounding. For pieces with corners all
 * planes are considered; for round ones, those that touch it in a line or in a point that is not on a rim, and those of
 * caps, faces and edges ({@link ExactFeatures#normalsWith}). A turn stays on its side of a plane if it is about the
 * plane's normal or does not change the set that turns.
 *
 * <p>Horizontal planes below or above upright pieces need only sums of two doubles, and nothing is allocated.
 */
public final class StartContacts {
    private final Scratch s;
    private final PiecePairs pairs;
    private final MeshWalk elsewhere;
    private final Leaf place = new Leaf();
    private final Leaf there = new Leaf();
    private final PiecePairs.Visitor contact = this::gather;
    private final PiecePairs.Visitor anew = this::isAnew;

    private Dimension dimension = Dimension.SPATIAL;
    private Sweep motion;
    private LeafColumn start;
    private LeafColumn end;
    private int leaf;

    /** The bounds of the mover's leaves at the start, where there are several. */
    private final LeafBoxes boxes = new LeafBoxes();

    private boolean hasBoxes;

    private ContactPlanes[] planes = new ContactPlanes[4];
    private int count;

    /** The heights of horizontal contact planes, each a sum of two doubles. */
    private double[] levels = new double[8];

    private int[] sides = new int[4];
    private int levelCount;
    private boolean spares;

    private boolean isMet;
    private boolean onlyAnew;
    private int ownPiece;
    private int otherPiece;

    @SuppressWarnings("NullAway.Init") // begin sets the motion
    public StartContacts(Scratch scratch) {
        s = scratch;
        elsewhere = new MeshWalk(scratch.work);
        pairs = new PiecePairs(scratch);
    }

    /** Clears all contacts and begins a motion from a start to an end, which are read only if contacts are added. */
    public void begin(Dimension inDimension, Sweep sweep, LeafColumn atStart, LeafColumn atEnd) {
        dimension = inDimension;
        motion = sweep;
        start = atStart;
        end = atEnd;
        count = 0;
        levelCount = 0;
        spares = false;
        hasBoxes = false;
    }

    /**
     * Whether a plane that is not horizontal has spared a piece. Which side of it a place is on depends on how the place is
     * rounded, unlike with heights, which no rounding takes out of their order.
     */
    public boolean spares() {
        return spares;
    }

    /** Whether there are no contacts at the start, except overlaps so deep that no plane separates the two. */
    public boolean isEmpty() {
        return count == 0;
    }

    /** Adds the pieces of a leaf that the mover touches at the start. */
    public void add(LeafColumn b, int j) {
        if (start.size() == 1) {
            add(0, b, j);
            return;
        }
        if (!hasBoxes) {
            hasBoxes = true;
            boxes.setAll(start, 0, start.size(), dimension == Dimension.PLANAR);
        }
        b.bounds(j, boxes.box);
        int near = boxes.meeting(Overlap.uncertain(boxes.box));
        for (int k = 0; k < near; k++) {
            add(boxes.found(k), b, j);
        }
    }

    private void add(int i, LeafColumn b, int j) {
        s.work.take();
        if (start.kind(i).isMesh() && b.kind(j).isMesh() && !Overlap.test(dimension, start, i, b, j, s)) {
            return; // found sooner by both trees
        }
        leaf = i;
        pairs.any(dimension, start, i, b, j, contact);
    }

    private boolean gather(Leaf a, int t, Leaf b, int u) {
        if (a.kind.isEnclosure() || b.kind.isEnclosure()) {
            return false; // rounded outward, so that what touches overlaps
        }
        if (!touch(a, b) || ConvexOverlap.isDeep(dimension, a, b, s.overlap)) {
            return false; // no plane separates a deep overlap
        }
        if (count == planes.length) {
            planes = Arrays.copyOf(planes, 2 * count);
        }
        ContactPlanes found = planes[count];
        if (found == null) {
            found = new ContactPlanes();
            planes[count] = found;
        }
        found.clear();
        found.start.copy(a.kind, a.row, a.at);
        Leaf atEnd = place(end, leaf, a.kind, t);
        found.end.copy(atEnd.kind, atEnd.row, atEnd.at);
        found.other.copy(b.kind, b.row, b.at);
        noteLevel(found);
        count++;
        return false;
    }

    /** A leaf of the mover at its start or its end, or a triangle of it, valid until the next one. */
    private Leaf place(LeafColumn column, int of, LeafKind kind, int t) {
        if (t < 0) {
            return place.set(column, of);
        }
        elsewhere.open(column, of);
        elsewhere.corners(t, there.row, 0);
        there.kind = kind;
        return there;
    }

    /**
     * Records the horizontal plane that separates a contact, if there is one and the mover stays on its side; points in
     * it are on both sides.
     */
    private void noteLevel(ContactPlanes found) {
        if (dimension == Dimension.PLANAR
                || !found.start.kind.hasLevels()
                || !found.other.kind.hasLevels()
                || !found.end.kind.hasLevels()
                || !motion.keepsLevel(found.start)) {
            return;
        }
        for (int side = 1; side >= -1; side -= 2) {
            double middle = HeightIntervals.middle(found.other, side);
            double half = side * HeightIntervals.half(found.other);
            if (HeightIntervals.isBeyond(found.start, middle, half, side)
                    && HeightIntervals.isBeyond(found.end, middle, half, side)) {
                note(middle, half, side);
            }
        }
    }

    private void note(double middle, double half, int side) {
        for (int k = 0; k < levelCount; k++) {
            if (levels[2 * k] == middle && levels[2 * k + 1] == half && sides[k] == side) {
                return;
            }
        }
        if (levelCount == sides.length) {
            levels = Arrays.copyOf(levels, 4 * levelCount);
            sides = Arrays.copyOf(sides, 2 * levelCount);
        }
        levels[2 * levelCount] = middle;
        levels[2 * levelCount + 1] = half;
        sides[levelCount++] = side;
    }

    /**
     * Whether a piece does not block a piece of the mover because it is behind the plane of a contact.
     *
     * @param to the mover's piece at its destination, which is the end or a place before it
     */
    boolean isBehind(Leaf from, Leaf to, Leaf b) {
        if (isBehindLevel(from, to, b)) {
            return true;
        }
        if (count == 0) {
            return false;
        }
        HullOverlap hulls = s.gjk.hulls();
        hulls.clear(dimension == Dimension.PLANAR);
        hulls.above(from);
        hulls.above(to);
        hulls.below(b);
        if (hulls.areDeep()) {
            return false; // the motion goes into it, as for nearly everything that blocks
        }
        for (int k = 0; k < count; k++) {
            s.work.take();
            hulls.clear(dimension == Dimension.PLANAR);
            hulls.above(planes[k].start);
            hulls.above(planes[k].end);
            hulls.above(from);
            hulls.above(to);
            hulls.below(planes[k].other);
            hulls.below(b);
            if (hulls.areDeep()) {
                continue;
            }
            if (planes[k].part(dimension, motion, from, to, b, s)) {
                spares = true;
                return true;
            }
        }
        return false;
    }

    private boolean isBehindLevel(Leaf from, Leaf to, Leaf b) {
        if (levelCount > 0
                && from.kind.hasLevels()
                && to.kind.hasLevels()
                && b.kind.hasLevels()
                && motion.keepsLevel(from)) {
            for (int k = 0; k < levelCount; k++) {
                double middle = levels[2 * k];
                double half = levels[2 * k + 1];
                if (HeightIntervals.isBeyond(from, middle, half, sides[k])
                        && HeightIntervals.isBeyond(to, middle, half, sides[k])
                        && HeightIntervals.isBeyond(b, middle, half, -sides[k])) {
                    return true;
                }
            }
        }
        return false;
    }

    /**
     * Whether it is behind a horizontal contact plane: the part of {@link #isBehind} that needs no exact numbers and
     * decides most cases.
     */
    boolean isBehindLevel(int i, Leaf from, int t, Leaf b) {
        if (levelCount == 0) {
            return false;
        }
        return isBehindLevel(from, place(end, i, from.kind, t), b);
    }

    /** The same for a leaf of the mover, or a triangle of its mesh, moving to the end. */
    boolean isBehind(int i, Leaf from, int t, Leaf b) {
        return isBehind(from, place(end, i, from.kind, t), b);
    }

    /**
     * The mover's triangle in the last {@link #touchesAnew}, as a position in the order of the leaves; -1 if it is not
     * a mesh.
     */
    public int ownPiece() {
        return ownPiece;
    }

    /** The same for the triangle that it touches. */
    public int otherPiece() {
        return otherPiece;
    }

    /**
     * Whether leaf i of the mover, at a place on its way, touches or overlaps a piece of leaf j that it did not touch
     * at the start and that is not behind the plane of a contact.
     */
    public boolean touchesAnew(LeafColumn at, int i, LeafColumn b, int j) {
        return touches(at, i, b, j, true);
    }

    /**
     * The same of a mover that touches nothing at the start, where it does not matter which pieces touch: whatever is touched is
     * then touched anew.
     */
    public boolean isTouchedAnew(LeafColumn at, int i, LeafColumn b, int j) {
        if (!Overlap.test(dimension, at, i, b, j, s)) {
            s.work.take();
            return false;
        }
        return !Overlap.test(dimension, start, i, b, j, s) || touches(at, i, b, j, true);
    }

    /** The same for a place that is not on the way, where what was touched at the start counts too. */
    public boolean touchesThere(LeafColumn at, int i, LeafColumn b, int j) {
        return touches(at, i, b, j, false);
    }

    private boolean touches(LeafColumn at, int i, LeafColumn b, int j, boolean isAnew) {
        s.work.take();
        if (!Overlap.test(dimension, at, i, b, j, s)) {
            return false;
        }
        onlyAnew = isAnew;
        leaf = i;
        ownPiece = -1;
        otherPiece = -1;
        isMet = false;
        if (pairs.any(dimension, at, i, b, j, anew)) {
            return true;
        }
        // Inside a solid, without touching a face.
        return !isMet && !(isAnew && Overlap.test(dimension, start, i, b, j, s));
    }

    private boolean isAnew(Leaf a, int t, Leaf b, int u) {
        if (!touch(a, b)) {
            return false;
        }
        isMet = true;
        Leaf from = place(start, leaf, a.kind, t);
        if ((onlyAnew && touch(from, b)) || isBehind(from, a, b)) {
            return false;
        }
        ownPiece = t;
        otherPiece = u;
        return true;
    }

    private boolean touch(Leaf a, Leaf b) {
        int known = dimension == Dimension.PLANAR ? 0 : HeightIntervals.touch(a, b, s.overlap);
        return known == 0 ? ConvexOverlap.test(dimension, a, b, s.overlap) : known > 0;
    }
}
