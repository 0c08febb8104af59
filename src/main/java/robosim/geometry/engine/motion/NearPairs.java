package robosim.geometry.engine.motion;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import robosim.geometry.engine.broadphase.AccuracyView;
import robosim.geometry.engine.broadphase.Candidates;
import robosim.geometry.engine.broadphase.LeafTable;
import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.Distance;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.StartContacts;
import robosim.geometry.narrow.Sweep;
import robosim.geometry.narrow.leaf.LeafColumn;

/**
 * The pairs of a piece of a mover and a piece of another object that come within a distance of each other on a segment, or may:
 * those whose gap at the start is at most that distance and the length of the longest path of any point of the mover.
 *
 * <p>Left out are pieces that an exact contact at the start holds off ({@link StartContacts}).
 */
final class NearPairs {
    /** More than the error of gaps and paths, as a share of them and of what the places are made of. */
    private static final double ROUNDING = 0x1p-40;

    private final MotionSegment segment;
    private final Distance distance;
    private final Sweep.Pairs collect = this::collect;
    private final LeafColumn own = new LeafColumn(1);
    private final LeafColumn other = new LeafColumn(1);

    private int count;
    private int[] objects = new int[8];
    private int[] leaves = new int[8];
    private int[] pieces = new int[8];
    private int[] ownLeaves = new int[8];
    private int[] ownPieces = new int[8];
    private double[] gaps = new double[8];

    /** Sweeps single pieces; with a scratch of its own. */
    private @Nullable Sweep pieceSweep;

    private AccuracyView view;
    private double reach;

    private boolean isOnly;
    private int onlyObject;
    private int onlyLeaf;
    private int onlyPiece;

    // Whose pieces are being collected.
    private int object;
    private int leaf;
    private int ownLeaf;

    @SuppressWarnings("NullAway.Init") // a search sets its view
    NearPairs(MotionSegment segment, Distance distance) {
        this.segment = segment;
        this.distance = distance;
    }

    /** For the next search only one piece of one object counts. */
    void only(int ofObject, int ofLeaf, int ofPiece) {
        isOnly = true;
        onlyObject = ofObject;
        onlyLeaf = ofLeaf;
        onlyPiece = ofPiece;
    }

    /** Finds all pairs among the candidates, whose bounds meet those of the segment widened by the distance. */
    void find(AccuracyView in, Candidates candidates, StartContacts standing, double within) {
        view = in;
        count = 0;
        reach = (within + segment.longestPath()) * (1 + ROUNDING) + ROUNDING * segment.size();
        try {
            findEach(in, candidates, standing, within);
        } finally {
            isOnly = false;
        }
    }

    private void findEach(AccuracyView in, Candidates candidates, StartContacts standing, double within) {
        for (int k = 0; k < candidates.count(); k++) {
            object = candidates.id(k);
            LeafTable table = in.table(object);
            int first = table.first(object);
            for (leaf = first; leaf < first + table.count(object); leaf++) {
                for (ownLeaf = 0; ownLeaf < segment.atStart.size(); ownLeaf++) {
                    segment.sweep.nearby(segment.atStart, ownLeaf, table.leaves(), leaf, standing, within, collect);
                }
            }
        }
    }

    private double collect(int ownPiece, int piece, double least) {
        if (isOnly && (object != onlyObject || leaf != onlyLeaf || piece != onlyPiece)) {
            return Double.POSITIVE_INFINITY;
        }
        own.setPiece(segment.atStart, ownLeaf, ownPiece);
        other.setPiece(view.table(object).leaves(), leaf, piece);
        double gap = distance.between(segment.dimension(), own, 0, other, 0, Double.POSITIVE_INFINITY);
        if (gap <= reach) {
            add(ownPiece, piece, gap);
        }
        return Double.POSITIVE_INFINITY;
    }

    private void add(int ownPiece, int piece, double gap) {
        if (count == objects.length) {
            objects = Arrays.copyOf(objects, 2 * count);
            leaves = Arrays.copyOf(leaves, 2 * count);
            pieces = Arrays.copyOf(pieces, 2 * count);
            ownLeaves = Arrays.copyOf(ownLeaves, 2 * count);
            ownPieces = Arrays.copyOf(ownPieces, 2 * count);
            gaps = Arrays.copyOf(gaps, 2 * count);
        }
        objects[count] = object;
        leaves[count] = leaf;
        pieces[count] = piece;
        ownLeaves[count] = ownLeaf;
        ownPieces[count] = ownPiece;
        gaps[count] = gap;
        count++;
    }

    int count() {
        return count;
    }

    /** The id of the other object of a pair. */
    int object(int k) {
        return objects[k];
    }

    int leaf(int k) {
        return leaves[k];
    }

    int piece(int k) {
        return pieces[k];
    }

    int ownLeaf(int k) {
        return ownLeaves[k];
    }

    int ownPiece(int k) {
        return ownPieces[k];
    }

    /** The gap at the start of the segment. */
    double gap(int k) {
        return gaps[k];
    }

    /** The gap after a share of the segment. */
    double gap(int k, double share) {
        load(k, share);
        return distance.between(segment.dimension(), own, 0, other, 0, Double.POSITIVE_INFINITY);
    }

    /** Contact point and normal after a share of the segment, six numbers. Side to side, upright pieces have level normals. */
    void contact(int k, double share, double[] out) {
        load(k, share);
        distance.contact(segment.dimension(), own, 0, other, 0, out);
        boolean isUpright = own.kind(0).isVerticalPrism() && other.kind(0).isVerticalPrism();
        if (isUpright && segment.dimension() == Dimension.SPATIAL && Math.abs(out[4]) < 0.5) {
            double flat = distance.between(Dimension.PLANAR, own, 0, other, 0, Double.POSITIVE_INFINITY);
            if (flat > 0 && flat == distance.between(Dimension.SPATIAL, own, 0, other, 0, Double.POSITIVE_INFINITY)) {
                distance.contact(Dimension.PLANAR, own, 0, other, 0, out);
            }
        }
    }

    /** The largest n.x of the other's piece, where n is at a place of an array. */
    double level(int k, double[] n, int at) {
        other.setPiece(view.table(objects[k]).leaves(), leaves[k], pieces[k]);
        return distance.extent(segment.dimension(), other, 0, n[at], n[at + 1], n[at + 2]);
    }

    /** The least n.x of the mover's piece at the start. */
    double ownLevel(int k, double[] n, int at) {
        own.setPiece(segment.atStart, ownLeaves[k], ownPieces[k]);
        return -distance.extent(segment.dimension(), own, 0, -n[at], -n[at + 1], -n[at + 2]);
    }

    /** Whether the segment, a translation, goes into the other's piece. */
    boolean isHit(int k) {
        load(k, 0);
        Sweep alone = pieceSweep == null ? new Sweep(new Scratch()) : pieceSweep;
        pieceSweep = alone;
        alone.translation(segment.dimension(), segment.stored(0), segment.stored(1), segment.stored(2));
        return alone.free(own, 0, other, 0) != Double.POSITIVE_INFINITY;
    }

    /** The free share of the segment, a turn, of the mover's piece of a pair beside a single leaf. */
    double free(int k, LeafColumn leaf) {
        own.setPiece(segment.atStart, ownLeaves[k], ownPieces[k]);
        segment.turnBy(1);
        return segment.sweep.free(own, 0, leaf, 0);
    }

    /** Whether any piece of the mover touches the other's piece at the start. */
    boolean isTouched(int k) {
        for (int each = 0; each < count; each++) {
            if (gaps[each] == 0
                    && objects[each] == objects[k]
                    && leaves[each] == leaves[k]
                    && pieces[each] == pieces[k]) {
                return true;
            }
        }
        return false;
    }

    /**
     * Whether the mover starts within the other's leaf, which is a mesh, and so may leave it through faces that it does not
     * touch: inside a solid one, or in the plane over any.
     */
    boolean isFromInside(int k) {
        LeafColumn of = view.table(objects[k]).leaves();
        if (!of.kind(leaves[k]).isMesh()) {
            return false;
        }
        boolean isTouching = false;
        for (int other = 0; other < count && !isTouching; other++) {
            isTouching = objects[other] == objects[k] && leaves[other] == leaves[k] && gaps[other] == 0;
        }
        return isTouching
                ? segment.dimension() == Dimension.PLANAR
                : distance.between(segment.dimension(), segment.atStart, ownLeaves[k], of, leaves[k], 0) == 0;
    }

    private void load(int k, double share) {
        own.setPiece(share == 0 ? segment.atStart : segment.after(share), ownLeaves[k], ownPieces[k]);
        other.setPiece(view.table(objects[k]).leaves(), leaves[k], pieces[k]);
    }
}
