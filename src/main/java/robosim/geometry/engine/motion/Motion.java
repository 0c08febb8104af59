package robosim.geometry.engine.motion;

import org.jspecify.annotations.Nullable;
import robosim.geometry.engine.broadphase.AccuracyView;
import robosim.geometry.engine.broadphase.Candidates;
import robosim.geometry.engine.broadphase.LeafTable;
import robosim.geometry.engine.broadphase.ObjectRegistry;
import robosim.geometry.engine.objects.ObjectTable;
import robosim.geometry.engine.objects.WorldBounds;
import robosim.geometry.exact.Attitude;
import robosim.geometry.exact.VectorMath;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.Move;
import robosim.geometry.model.Twist;
import robosim.geometry.narrow.Distance;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.StartContacts;
import robosim.geometry.narrow.Sweep;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.LeafKind;

/**
 * Tries to move an object, without moving it: its translation, its turn about Y and its turn about X, each a segment that is swept
 * in the world as it is. {@link #end()} is where the object would come to stand; {@link #commit} moves it there. A translation
 * alone is first tried by {@link TranslationFastPath}, which finds most of them free, with the same verdict.
 *
 * <p>A segment is free where no sweep meets anything and its end, as stored, overlaps nothing that its start did not. What is
 * behind a plane of a contact at the start ({@link StartContacts}) counts for neither.
 *
 * <p>At an accuracy below EXACT, a segment with anything near is swept twice, for the enclosures and for the objects themselves,
 * and the smaller share counts: enclosures that overlap at the start prove nothing about the objects in them.
 */
public final class Motion {
    public static final int NOTHING = -1;
    public static final int BORDER = -2;

    /** A share is taken back by so much first, then by twice as much each time. */
    private static final double FIRST_STEP = 0x1p-52;

    /** A share that is taken back by more was not refused by rounding. */
    private static final double FAR_BACK = 0x1p-30;

    /** The largest share of what is refused. */
    private static final double MOST = Math.nextDown(1.0);

    /** Less, in degrees, is not turned by to 53 bits. */
    private static final double LEAST_ANGLE = 0x1p-900;

    /**
     * How far off a place may be at the end of a share of a translation, of all coordinates: a caller's product and sum, and
     * the sweep's own difference, are rounded, each by at most an ulp of these. A blocked translation is taken back by so
     * much.
     */
    private static final double ROUNDED = 0x1p-46;

    /** The same for a place alone, whose coordinates are off by a rounding of a sum and one of a product. */
    private static final double PLACED = 0x1p-50;

    /** The same in degrees: a caller adds the share of a turn to a heading, and takes the heading off again. */
    private static final double ROUNDED_HEADING = 0x1p-43;

    /** A larger margin is not taken: a place then has no more than a few digits. */
    private static final double MOST_MARGIN = 0x1p-20;

    /** More than a share is taken back beside its obstacle. */
    private static final double LATER = 2 * MOST_MARGIN;

    private final ObjectRegistry registry;
    private final ObjectTable objects;
    private final WorldBounds worldBounds;
    private final Scratch scratch;
    private final Candidates candidates;
    private final MotionSegment segment;
    private final EnclosureSweep enclosure;
    private final BoundsExit exit;
    /** Made for the first motion with a clearance. */
    private @Nullable ClearanceSearch search;

    /** Decides most straight moves; null until the first one. */
    private @Nullable TranslationFastPath straight;

    /** Whether the last motion was found free by {@link #straight}, which knows its end. */
    private boolean isStraight;

    private final TurnFastPath turning;
    private final StartContacts standing;
    private final BlockingContact stop;
    private final Distance distance;
    private final double[] vector = new double[3];
    private final double[] box = new double[6];
    private final double[] part = new double[6];

    /** What holds the whole segment however its places are rounded. */
    private final double[] around = new double[6];

    /** The bounds of what stands for the object at the end of the segment. */
    private final double[] endBox = new double[6];

    /** The shares after which the candidates are met. */
    private double[] impacts = new double[16];

    private AccuracyView view;
    private int id;
    private double clearance;
    private boolean isEndWanted;
    private int obstacle;
    private int obstacleLeaf;
    private int ownLeaf;

    // The pieces by which an object was met last.
    private int hitLeaf;
    private int hitPiece;
    private int hitOwnLeaf;
    private int hitOwnPiece;

    private int obstaclePiece;
    private int ownPiece;
    private boolean isStandingKnown;
    private int touched;
    private double fraction;
    private double turnFraction;
    private boolean isSecondTurn;
    private boolean isBesideBlocker;

    /** Sweeps the objects themselves; null until a segment at an accuracy below EXACT first needs it. */
    private @Nullable Motion exact;

    /** Whether the objects themselves block before their enclosures, so that the contact is theirs. */
    private boolean isBlockedExactly;

    @SuppressWarnings("NullAway.Init") // an attempt sets its view
    public Motion(ObjectRegistry registry, Scratch scratch) {
        this.registry = registry;
        this.scratch = scratch;
        objects = registry.objects;
        worldBounds = registry.worldBounds;
        candidates = new Candidates(objects);
        segment = new MotionSegment(scratch);
        enclosure = new EnclosureSweep(segment);
        exit = new BoundsExit(worldBounds, segment);
        turning = new TurnFastPath(registry);
        standing = new StartContacts(scratch);
        distance = new Distance(scratch);
        stop = new BlockingContact(objects, candidates, segment, scratch, distance);
    }

    /** What blocks: an id, {@link #NOTHING} or {@link #BORDER}. */
    public int obstacle() {
        return obstacle;
    }

    public double fraction() {
        return fraction;
    }

    public double turnFraction() {
        return turnFraction;
    }

    /** The place at the end of what is free: of the whole motion where nothing blocks. */
    public double[] end() {
        if (isStraight) {
            int at = objects.place(id);
            System.arraycopy(objects.places(), at, segment.end, 0, ObjectTable.PLACE);
            ObjectTable.shift(segment.end, 0, straight().end());
            isStraight = false;
        }
        return segment.end;
    }

    /** Moves the object to the end of what is free; returns true. */
    public boolean commit() {
        if (isStraight) {
            registry.shift(id, straight().end());
        } else {
            registry.move(id, segment.end);
        }
        return true;
    }

    /**
     * Tries a motion by a displacement in the world's axes, then turns in degrees about the world's axes.
     *
     * @param gap how far to stay from what blocks; 0 to stop just before contact
     * @return whether all of it is free; else {@link #end()} is the place before contact
     */
    public boolean attempt(
            AccuracyView inView, int mover, double x, double y, double z, double turnX, double turnY, double gap) {
        if (gap == 0
                && turnX == 0
                && turnY == 0
                && objects.ignored.isEmpty()
                && goesStraight(mover, straight().find(inView, mover, x, y, z))) {
            return true;
        }
        begin(inView, mover, gap, true);
        return attempt(x, y, z, turnX, turnY, true);
    }

    /** The same with a gap to the piece that blocks alone, and to no other: for bodies, which are near to much that they move along. */
    public boolean attemptBeside(
            AccuracyView inView, int mover, double x, double y, double z, double turnY, double gap) {
        begin(inView, mover, gap, true);
        isBesideBlocker = true;
        return attempt(x, y, z, 0, turnY, true);
    }

    /** The same along the object's own axes, and about them. */
    public boolean attemptOwn(AccuracyView inView, int mover, Move move, double gap) {
        if (gap == 0 && move.rx() == 0 && move.ry() == 0 && objects.ignored.isEmpty()) {
            objects.toWorld(mover, move.x(), move.y(), move.z(), vector);
            if (goesStraight(mover, straight().find(inView, mover, vector[0], vector[1], vector[2]))) {
                return true;
            }
        }
        begin(inView, mover, gap, true);
        segment.takeOwnAxes();
        return attempt(move.x(), move.y(), move.z(), move.rx(), move.ry(), false);
    }

    /** Refuses a motion with a twist that {@link #attemptTwist} does not sweep. */
    public void checkTwist(AccuracyView inView, int mover, Twist twist, double seconds) {
        double[] places = objects.places();
        int at = objects.place(mover);
        if (!(seconds >= 0 && seconds < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException("seconds must be a time of at least 0 (got: " + seconds + ")");
        }
        twist.check(seconds, places[at], places[at + 1], places[at + 2]);
        boolean isPlanar =
                inView.dimension == Dimension.PLANAR && Attitude.isUpright(places, at + ObjectTable.ROTATION);
        if (twist.ry() != 0 && twist.y() != 0 && !isPlanar) {
            throw new IllegalArgumentException(
                    "y of a twist that turns must be 0; driveFractions measures a helix (got: " + twist + ")");
        }
    }

    /** Tries a motion with a constant twist, which must not turn and climb at once where heights count. */
    public boolean attemptTwist(AccuracyView inView, int mover, Twist twist, double seconds, double gap) {
        begin(inView, mover, gap, true);
        if (isFree(segment.set(twist, seconds))) {
            return true;
        }
        fraction = share;
        turnFraction = share;
        return false;
    }

    /** Whether the arc that was tried last is so wide that its sweep as a turn resolves little beside the object's size. */
    boolean isWide() {
        return segment.isWide();
    }

    /**
     * Goes on from the place that is known to be free after a share of a motion with a twist, for the rest of its time; if that
     * is blocked, the motion ends at that place.
     */
    boolean attemptRest(
            AccuracyView inView, int mover, double[] place, Twist twist, double seconds, double gap, double free) {
        begin(inView, mover, gap, true, place, 0);
        if (isFree(segment.set(twist, seconds * (1 - free)))) {
            return true;
        }
        segment.endAt(0);
        fraction = free;
        turnFraction = free;
        return false;
    }

    /** Turns about the object's own axes through its centre. */
    boolean attemptTurns(AccuracyView inView, int mover, double turnX, double turnY, double gap) {
        begin(inView, mover, gap, true);
        return attempt(0, 0, 0, turnX, turnY, false);
    }

    private boolean attempt(double x, double y, double z, double turnX, double turnY, boolean isGlobal) {
        boolean free = isFree(x, y, z, MotionSegment.NO_TURN, 0);
        if (!free) {
            fraction = share;
            turnFraction = 0;
            return false;
        }
        double each = turnX != 0 && turnY != 0 ? 0.5 : 1;
        if (turnY != 0 && !isFree(0, 0, 0, isGlobal ? MotionSegment.VERTICAL : MotionSegment.OWN_Y, turnY)) {
            turnFraction = each * share;
            return false;
        }
        isSecondTurn = each < 1;
        if (turnX != 0 && !isFree(0, 0, 0, isGlobal ? MotionSegment.WORLD_X : MotionSegment.OWN_X, turnX)) {
            turnFraction = (1 - each) + each * share;
            return false;
        }
        return true;
    }

    /** Whether a displacement in the world's axes is free, and no more: {@link #end()} is only set where it is. */
    public boolean allows(AccuracyView inView, int mover, double x, double y, double z) {
        int verdict = objects.ignored.isEmpty() ? straight().find(inView, mover, x, y, z) : TranslationFastPath.UNKNOWN;
        if (goesStraight(mover, verdict) || verdict == TranslationFastPath.BLOCKED) {
            return verdict == TranslationFastPath.FREE;
        }
        begin(inView, mover, 0, false);
        return isFree(x, y, z, MotionSegment.NO_TURN, 0);
    }

    /** Notes what was found about a straight move; whether it is free. */
    private boolean goesStraight(int mover, int verdict) {
        isStraight = verdict == TranslationFastPath.FREE;
        if (isStraight) {
            id = mover;
            obstacle = NOTHING;
            fraction = 1;
            turnFraction = 1;
        }
        return isStraight;
    }

    private TranslationFastPath straight() {
        TranslationFastPath made = straight;
        if (made == null) { // writing a reference in each move is slow
            made = new TranslationFastPath(registry, scratch);
            straight = made;
        }
        return made;
    }

    /** Whether a turn about the vertical through the centre is free, and no more. */
    public boolean allowsTurn(AccuracyView inView, int mover, double byDegrees) {
        if (turning.isFree(inView, mover)) {
            isStraight = false;
            id = mover;
            System.arraycopy(objects.places(), objects.place(mover), segment.end, 0, ObjectTable.PLACE);
            Attitude.turnVertically(segment.end, ObjectTable.ROTATION, byDegrees);
            return true;
        }
        begin(turning.deciding(inView, mover), mover, 0, false);
        return isFree(0, 0, 0, MotionSegment.VERTICAL, byDegrees);
    }

    /**
     * Whether a displacement in the world's axes and then a turn about the vertical are free from another place than the
     * mover's own, laid out as in the table of objects; and no more.
     */
    public boolean allowsFrom(
            AccuracyView inView, int mover, double[] place, double x, double y, double z, double byDegrees) {
        begin(inView, mover, 0, false, place, 0);
        return isFree(x, y, z, MotionSegment.NO_TURN, 0)
                && (byDegrees == 0 || isFree(0, 0, 0, MotionSegment.VERTICAL, byDegrees));
    }

    /**
     * Tries a displacement in the world's axes and then a turn about the vertical from another place than the mover's own,
     * with a gap; {@link #fraction} and {@link #turnFraction} are what is free.
     */
    public boolean attemptFrom(
            AccuracyView inView, int mover, double[] place, double[] displacement, double byDegrees, double gap) {
        begin(inView, mover, gap, true, place, 0);
        return attempt(displacement[0], displacement[1], displacement[2], 0, byDegrees, true);
    }

    private void begin(AccuracyView inView, int mover, double gap, boolean isToEnd) {
        begin(inView, mover, gap, isToEnd, objects.places(), objects.place(mover));
    }

    private void begin(AccuracyView inView, int mover, double gap, boolean isToEnd, double[] places, int at) {
        isEndWanted = isToEnd;
        isStraight = false;
        view = inView;
        id = mover;
        clearance = gap;
        obstacle = NOTHING;
        isSecondTurn = false;
        isBesideBlocker = false;
        fraction = 1;
        turnFraction = 1;
        segment.begin(inView, mover, places, at);
    }

    /** The share of the segment at which the contact is looked for, before rounding is allowed for; NaN for the end. */
    private double contactShare;

    /** The free share of the segment that was blocked last. */
    private double share;

    /** Sweeps the next segment; where it is free, its end is the next one's start. */
    private boolean isFree(double x, double y, double z, int about, double byDegrees) {
        return isFree(segment.set(x, y, z, about, byDegrees));
    }

    /** The same for a segment that has been set; whether it goes anywhere. */
    private boolean isFree(boolean isGoing) {
        if (!isGoing) {
            segment.advance();
            return true;
        }
        boolean free = isSegmentFree(1);
        // Where no enclosure is near, no object is; where the enclosures block, that is enough for a verdict.
        if (view.accuracy != Accuracy.EXACT && (free ? isNearAnything() : isEndWanted)) {
            Motion shapes = exact;
            if (shapes == null) {
                shapes = new Motion(registry, scratch);
                exact = shapes;
            }
            shapes.begin(registry.at(Accuracy.EXACT), id, clearance, isEndWanted, segment.start, 0);
            shapes.isSecondTurn = isSecondTurn;
            shapes.isBesideBlocker = isBesideBlocker;
            shapes.segment.set(segment);
            free &= shapes.isSegmentFree(free ? 1 : share + LATER);
            if (!free && isEndWanted) {
                takeLesser(shapes);
            }
        }
        if (free) {
            segment.advance();
        } else if (isEndWanted) {
            segment.endAt(share);
        }
        return free;
    }

    /**
     * Takes the smaller share of the enclosures' and the objects' own, reduced to a place that is verified for both. If they
     * are equal, the obstacle that was added first is named.
     */
    private void takeLesser(Motion shapes) {
        isBlockedExactly = shapes.share < share || (shapes.share == share && !isEarlier(obstacle, shapes.obstacle));
        double least = Math.min(share, shapes.share);
        int blocking = isBlockedExactly ? shapes.obstacle : obstacle;
        obstacle = NOTHING; // every candidate is verified
        shapes.obstacle = NOTHING;
        share = least;
        double step = FIRST_STEP;
        while (share > 0 && !(isAccepted(share, NOTHING) && shapes.isAccepted(share, NOTHING))) {
            share = Math.max(0, representable(least - step));
            step *= 2;
        }
        segment.scale(1);
        shapes.segment.scale(1);
        obstacle = blocking;
        shapes.obstacle = blocking;
    }

    private boolean isNearAnything() {
        return candidates.count() > 0 || !worldBounds.clearlyHolds(around);
    }

    private boolean isEarlier(int one, int two) {
        return one != BORDER && (two == BORDER || objects.isEarlier(one, two));
    }

    /**
     * Sweeps the segment, from which {@link #share} and the obstacle follow.
     *
     * @param upTo the share of the segment beyond which nothing need be found
     */
    private boolean isSegmentFree(double upTo) {
        isBlockedExactly = false;
        share = Double.POSITIVE_INFINITY;
        if (upTo < 1 && segment.scale(upTo)) {
            segment.sweptBox(1, box);
            segment.around(box, around, clearance);
            candidates.find(view, around, id);
            segment.scale(1);
            enclose();
        } else {
            enclose();
            candidates.find(view, around, id);
        }
        if (!isEndWanted) {
            return !isBlockedAnywhere(NOTHING);
        }
        double least = leastFree();
        share = 1;
        if (least != Double.POSITIVE_INFINITY) {
            share = isSureEnd() ? representable(backOff(least)) : accepted(least);
            segment.endAt(share);
        }
        if (clearance > 0 && segment.isRigid() && !(isBesideBlocker && obstacle < 0)) {
            enclose();
            keepClear();
        }
        if (share == 1) {
            share = Double.POSITIVE_INFINITY;
            return true;
        }
        return false;
    }

    /** Lessens the share to where the mover keeps its clearance, at the place as it is stored. */
    private void keepClear() {
        stands();
        ClearanceSearch clear = search();
        if (isBesideBlocker) {
            clear.only(obstacle, obstacleLeaf, obstaclePiece);
        }
        double kept = clear.share(view, candidates, standing, clearance, share);
        kept = kept < share ? Math.max(0, kept - margin()) : kept;
        double free = kept;
        double step = FIRST_STEP;
        boolean isExact = true;
        while (free > 0 && (clear.isCloser(free, isExact) || (free < share && !isFreeAfter(free)))) {
            if (isExact && step > FAR_BACK) { // what it passes along is no nearer anywhere, but for rounding
                isExact = false;
                step = FIRST_STEP / 2;
            }
            free = isExact || step > FIRST_STEP / 2 ? kept - step : kept;
            step *= 2;
        }
        free = Math.max(0, free);
        if (free < share && clear.first() >= 0) {
            block(clear.pairs(), clear.first());
        }
        share = free;
    }

    private ClearanceSearch search() {
        ClearanceSearch made = search == null ? new ClearanceSearch(segment, objects, distance) : search;
        search = made;
        return made;
    }

    private void block(NearPairs pairs, int pair) {
        obstacle = pairs.object(pair);
        obstacleLeaf = pairs.leaf(pair);
        obstaclePiece = pairs.piece(pair);
        ownLeaf = pairs.ownLeaf(pair);
        ownPiece = pairs.ownPiece(pair);
        stop.note(obstacle, 0, 1); // the only one
        contactShare = Double.NaN;
    }

    /** The sum of the magnitudes of the bounds of a mover at its place. */
    double size(AccuracyView inView, int mover) {
        begin(inView, mover, 0, true);
        segment.stay();
        return segment.size();
    }

    /** Half the width of the bounds of a mover at its place: the larger of those along X and Z. */
    double reach(AccuracyView inView, int mover) {
        begin(inView, mover, 0, true);
        segment.stay();
        segment.atStart.bounds(0, segment.atStart.size(), box);
        return Math.max(box[3] - box[0], box[5] - box[2]) / 2;
    }

    /** Whether a displacement hits nothing but pieces that the mover touches at the start. */
    boolean passes(AccuracyView inView, int mover, double[] way) {
        begin(inView, mover, 0, true);
        if (!segment.set(way[0], way[1], way[2], MotionSegment.NO_TURN, 0)) {
            return true;
        }
        segment.sweptBox(1, box);
        segment.around(box, around, 0);
        candidates.find(view, around, id);
        standing.begin(view.dimension, segment.sweep, segment.atStart, segment.atLast);
        NearPairs pairs = search().near(view, candidates, standing, 0);
        for (int k = 0; k < pairs.count(); k++) {
            if (pairs.gap(k) > 0 && pairs.isHit(k) && !pairs.isTouched(k) && !pairs.isFromInside(k)) {
                return false;
            }
        }
        return true;
    }

    /** Finds the pieces within a distance of a mover at its place. */
    NearPairs near(AccuracyView inView, int mover, double within) {
        begin(inView, mover, 0, true);
        segment.stay();
        segment.atStart.bounds(0, segment.atStart.size(), box);
        segment.around(box, around, within);
        candidates.find(view, around, id);
        standing.begin(view.dimension, segment.sweep, segment.atStart, segment.atLast);
        return search().near(view, candidates, standing, within);
    }

    /** Bounds a segment that has been set or scaled; what it touches at its start is to be found again. */
    private void enclose() {
        segment.sweptBox(1, box);
        segment.around(box, around, clearance);
        standing.begin(view.dimension, segment.sweep, segment.atStart, segment.atLast);
        isStandingKnown = false;
        segment.after(1).bounds(0, segment.atStart.size(), endBox);
    }

    /** The greatest share, not above the given one, of which half and a half are a number. */
    private static double halved(double share) {
        double sum = 0.5 + 0.5 * share;
        double whole = 2 * sum - 1;
        return whole > share ? 2 * Math.nextDown(sum) - 1 : whole;
    }

    /**
     * The greatest share, not above the given one, that a caller can use beside one obstacle alone, or within the border: who
     * multiplies what was asked for by it asks for another segment, whose path differs by roundings.
     */
    private double usable(int of, double least) {
        if (least == 0 || (segment.turns() && isSureTurn())) {
            return least;
        }
        if (!segment.turns() && !segment.isArc() && of != BORDER && isExact(of) && gapAfter(of, 0, 0) > 0) {
            double apart = apart(of, least);
            if (apart >= 0) {
                return apart;
            }
        }
        double margin = margin();
        int ownLeafMet = hitOwnLeaf;
        int ownPieceMet = hitOwnPiece;
        int leafMet = hitLeaf;
        int pieceMet = hitPiece;
        double from = margin < MOST_MARGIN ? Math.max(0, least - margin) : least;
        double free = representable(from);
        for (double step = FIRST_STEP; free > 0 && isBlockedBy(of, free); step *= 2) {
            free = representable(from - step);
        }
        segment.scale(1);
        enclose();
        note(ownLeafMet, ownPieceMet, leafMet, pieceMet);
        return Math.max(0, free);
    }

    /**
     * Beside an obstacle whose sweep is exact a share can be used if its place is apart by more than what a caller's product and
     * sum may be off; -1 if that takes more than rounding, as where the mover passes along what it touches.
     */
    private double apart(int of, double least) {
        double need = PLACED * size();
        if (!(need < MOST_MARGIN * length())) {
            return -1;
        }
        double step = Math.max(FIRST_STEP, need / length());
        double free = representable(least);
        for (; free > 0 && gapAfter(of, free, need) < need; step *= 2) {
            if (step > Math.max(FAR_BACK, 64 * need / length())) {
                return -1;
            }
            free = representable(least - step);
        }
        return Math.max(0, free);
    }

    /** The gap to an object after a share of the segment; any number above the limit where it is above that. */
    private double gapAfter(int of, double share, double limit) {
        LeafColumn there = share == 0 ? segment.atStart : segment.after(share);
        LeafTable table = view.table(of);
        int first = table.first(of);
        double gap = Double.POSITIVE_INFINITY;
        for (int j = first; j < first + table.count(of); j++) {
            int near = segment.near(table.leaves(), j, limit);
            for (int k = 0; k < near; k++) {
                double within = Math.min(gap, limit);
                gap = Math.min(
                        gap, distance.between(view.dimension, there, segment.near(k), table.leaves(), j, within));
            }
        }
        return gap;
    }

    /** Whether a translation of the mover beside an object is decided without rounding. */
    private boolean isExact(int of) {
        LeafTable table = view.table(of);
        int own = segment.atStart.kinds(0, segment.atStart.size());
        int others = table.leaves().kinds(table.first(of), table.count(of));
        for (int mine = own; mine != 0; mine &= mine - 1) {
            LeafKind kind = LeafKind.first(mine);
            for (int theirs = others; theirs != 0; theirs &= theirs - 1) {
                if (!Sweep.isExact(view.dimension, kind, LeafKind.first(theirs))) {
                    return false;
                }
            }
        }
        return true;
    }

    private boolean isBlockedBy(int of, double share) {
        if (!segment.scale(share)) {
            return false;
        }
        enclose();
        return of == BORDER ? isLeaving() : blocks(of);
    }

    /** The share after which the world is left, or is nearer to the border than the clearance. */
    private double leaves() {
        if (!isBesideBlocker || segment.turns()) {
            return exit.share(clearance);
        }
        double leaves = exit.share(0);
        return leaves == Double.POSITIVE_INFINITY ? leaves : Math.max(0, leaves - clearance / length());
    }

    private boolean isLeaving() {
        return !worldBounds.clearlyHolds(box) && exit.share(0) != Double.POSITIVE_INFINITY;
    }

    /** The greatest share, not above that beside the obstacle alone, that is accepted beside all others too. */
    private double accepted(double least) {
        double free = least;
        int sure = obstacle;
        for (double step = FIRST_STEP; free > 0 && !isAccepted(free, sure); step *= 2) {
            free = representable(least - step);
            sure = NOTHING;
        }
        segment.scale(1);
        return Math.max(0, free);
    }

    /** Whether the end of a share need only be verified as a place: its path is free, however a caller rounds the share. */
    private boolean isSureEnd() {
        if (segment.turns()) {
            return isSureTurn();
        }
        if (segment.isArc() || stands()) {
            return false; // a path along what is touched depends on its rounding
        }
        for (int k = 0; k < candidates.count(); k++) {
            if (!isExact(candidates.id(k))) {
                return false;
            }
        }
        return true;
    }

    private double representable(double share) {
        return isSecondTurn ? halved(share) : share;
    }

    /** By what share a blocked segment is taken back, so that it can be asked again with what a caller's rounding makes of it. */
    private double margin() {
        double ofTurn = segment.turns() ? ROUNDED_HEADING / segment.angle() : 0;
        return !segment.turns() || segment.isArc() ? ofTurn + ROUNDED * size() / length() : ofTurn;
    }

    /** Whether a turn that a share of this one is may be used as it is: its sweep takes the same steps, up to there. */
    private boolean isSureTurn() {
        return segment.isRigid()
                && !segment.isArc()
                && !standing.spares()
                && worldBounds.clearlyHolds(box)
                && segment.angle() > LEAST_ANGLE;
    }

    private boolean isAccepted(double share, int sure) {
        if (!segment.scale(share)) {
            return true;
        }
        enclose();
        return !isBlockedAnywhere(sure);
    }

    /** The length of a translation, without heights that do not count. */
    private double length() {
        double dy = view.dimension == Dimension.PLANAR ? 0 : segment.displacement(1);
        return VectorMath.anyLength(segment.displacement(0), dy, segment.displacement(2));
    }

    /** The sum of the magnitudes of the bounds of the segment, without heights where these do not count or do not change. */
    private double size() {
        boolean isLevel = view.dimension == Dimension.PLANAR || segment.displacement(1) == 0;
        double size = 0;
        for (int axis = 0; axis < 3; axis += isLevel ? 2 : 1) {
            size += Math.abs(box[axis]) + Math.abs(box[3 + axis]);
        }
        return size;
    }

    /**
     * Whether anything blocks the whole segment.
     *
     * @param sure an object that is known not to, or {@link #NOTHING}
     */
    private boolean isBlockedAnywhere(int sure) {
        for (int k = 0; k < candidates.count(); k++) {
            int other = candidates.id(k);
            scratch.work.take();
            if (other == sure || !view.table(other).overlaps(other, around)) {
                continue;
            }
            if (blocks(other)) {
                return true;
            }
        }
        return sure != BORDER && isLeaving();
    }

    /**
     * The least free share of those beside each obstacle alone, and whose it is: that of the one added first, the border's
     * last. What is free beside one is verified beside that one, so that it does not depend on the others. Obstacles that are
     * met later than the first by more than any share is taken back are not asked.
     */
    private double leastFree() {
        double last = allImpacts() + LATER;
        double least = Double.POSITIVE_INFINITY;
        double leastTouching = Double.POSITIVE_INFINITY;
        for (int k = 0; k < candidates.count(); k++) {
            if (!(impacts[k] <= last) || impacts[k] == Double.POSITIVE_INFINITY) {
                continue;
            }
            int other = candidates.id(k);
            // Where there is one candidate, it has just been looked at.
            double met = candidates.count() == 1 ? impacts[0] : impactOrEnd(other);
            double touching = backOff(other, Math.min(met, MOST));
            double free = usable(other, touching);
            stop.note(other, touching, leastTouching);
            leastTouching = Math.min(leastTouching, touching);
            if (free < least || (free == least && objects.isEarlier(other, obstacle))) {
                least = free;
                contactShare = touching;
                obstacle = other;
                ownLeaf = hitOwnLeaf;
                ownPiece = hitOwnPiece;
                obstacleLeaf = hitLeaf;
                obstaclePiece = hitPiece;
            }
        }
        boolean isInside = worldBounds.clearlyHolds(clearance > 0 ? around : box);
        double leaves = isInside ? Double.POSITIVE_INFINITY : leaves();
        if (leaves != Double.POSITIVE_INFINITY) {
            double free = usable(BORDER, backOff(BORDER, Math.min(leaves, MOST)));
            if (free < least) {
                least = free;
                obstacle = BORDER;
            }
        }
        return least;
    }

    /** Finds the share after which each candidate is met, and returns the least. */
    private double allImpacts() {
        if (impacts.length < candidates.count()) {
            impacts = new double[2 * candidates.count()];
        }
        double least = Double.POSITIVE_INFINITY;
        for (int k = 0; k < candidates.count(); k++) {
            scratch.work.take();
            impacts[k] = impactOrEnd(candidates.id(k));
            least = Math.min(least, impacts[k]);
        }
        return least;
    }

    /** The share after which an object is met; 1 if only the end, as it is stored, touches it, and infinity for neither. */
    private double impactOrEnd(int other) {
        double met = timeOfImpact(other);
        return met == Double.POSITIVE_INFINITY && endsOn(other) ? 1 : met;
    }

    /** The share after which an object is met, and the leaves that meet: of several the object's lower one. */
    private double timeOfImpact(int other) {
        if (segment.isRigid()) {
            return rigidImpact(other);
        }
        double met = enclosure.timeOfImpact(view, other, box);
        if (met != Double.POSITIVE_INFINITY) {
            note(0, -1, view.table(other).first(other), enclosure.piece());
        }
        return met;
    }

    /** Whether an object is met on the way, or by the end as it is stored. */
    private boolean blocks(int other) {
        if (!segment.isRigid()) {
            return enclosure.isMet(view, other, box) || endsThere(other);
        }
        return isMeshPair(other) ? endsThere(other) || isMet(other) : isMet(other) || endsThere(other);
    }

    /** Whether a mesh moves beside a mesh: it takes longer to sweep the two than to look where they are. */
    private boolean isMeshPair(int other) {
        LeafTable of = view.table(other);
        return segment.atStart.kind(0).isMesh()
                && of.leaves().kind(of.first(other)).isMesh();
    }

    /** Whether an object is met on the way. */
    private boolean isMet(int other) {
        LeafColumn atStart = segment.atStart;
        LeafTable of = view.table(other);
        int first = of.first(other);
        for (int j = first; j < first + of.count(other); j++) {
            int near = segment.near(of.leaves(), j, 0);
            for (int k = 0; k < near; k++) {
                int i = segment.near(k);
                boolean isOnFloor = hasPieces(of, other, i, j) && stands();
                if (segment.sweep.isBlocked(atStart, i, of.leaves(), j, isOnFloor ? standing : null)
                        && (isOnFloor || !stands() || segment.sweep.isBlocked(atStart, i, of.leaves(), j, standing))) {
                    return true;
                }
            }
        }
        return false;
    }

    private double rigidImpact(int other) {
        LeafColumn atStart = segment.atStart;
        LeafTable of = view.table(other);
        int first = of.first(other);
        double least = Double.POSITIVE_INFINITY;
        boolean isSeveral = atStart.size() > 1 || of.count(other) > 1;
        for (int j = first; j < first + of.count(other); j++) {
            int near = segment.near(of.leaves(), j, 0);
            for (int k = 0; k < near; k++) {
                int i = segment.near(k);
                if (isSeveral && segment.comesLater(i, of.leaves(), j, least)) {
                    continue;
                }
                boolean isOnFloor = hasPieces(of, other, i, j) && stands(); // whose planes spare most of a sweep
                double free = isOnFloor
                        ? segment.sweep.free(atStart, i, of.leaves(), j, standing)
                        : segment.sweep.free(atStart, i, of.leaves(), j);
                if (free != Double.POSITIVE_INFINITY && !isOnFloor && free <= least && stands()) {
                    free = segment.sweep.free(atStart, i, of.leaves(), j, standing);
                }
                if (free < least || (free == least && isLowerCell(of.leaves(), j))) {
                    least = free;
                    note(i, segment.sweep.ownPiece(), j, segment.sweep.otherPiece());
                }
            }
        }
        return least;
    }

    /** Whether the last sweep met a cell of a grid that comes before the one that was met by another leaf of the object. */
    private boolean isLowerCell(LeafColumn leaves, int j) {
        return leaves.kind(j).isGrid() && segment.sweep.otherPiece() >= 0 && segment.sweep.otherPiece() < hitPiece;
    }

    /** Whether one of the leaves is a mesh or a grid, and the object may touch the other at the start. */
    private boolean hasPieces(LeafTable of, int other, int i, int j) {
        if (!segment.atStart.kind(i).hasPieces() && !of.leaves().kind(j).hasPieces()) {
            return false;
        }
        segment.atStart.bounds(0, segment.atStart.size(), part);
        return of.overlaps(other, part);
    }

    private void note(int i, int t, int j, int u) {
        hitOwnLeaf = i;
        hitOwnPiece = t;
        hitLeaf = j;
        hitPiece = u;
    }

    /** Whether the object touches anything at the start of the segment; what it touches is found when this is first asked. */
    private boolean stands() {
        if (!isStandingKnown) {
            isStandingKnown = true;
            segment.placeEnd();
            segment.atStart.bounds(0, segment.atStart.size(), part);
            for (int k = 0; k < candidates.count(); k++) {
                int other = candidates.id(k);
                scratch.work.take();
                LeafTable of = view.table(other);
                if (of.overlaps(other, part)) {
                    int first = of.first(other);
                    for (int j = first; j < first + of.count(other); j++) {
                        standing.add(of.leaves(), j);
                    }
                }
            }
        }
        return !standing.isEmpty();
    }

    /** Whether the object, as stored at the end of the segment, overlaps one that it does not at the start. */
    private boolean endsOn(int other) {
        return view.table(other).overlaps(other, endBox) && touchesAnew(other, 1);
    }

    /** The same where it does not matter by which pieces. */
    private boolean endsThere(int other) {
        return view.table(other).overlaps(other, endBox) && isAnew(other, 1);
    }

    /** As {@link #touchesAnew}, where it does not matter by which pieces. */
    private boolean isAnew(int other, double share) {
        if (!isMeshPair(other) || stands()) {
            return touchesAnew(other, share);
        }
        LeafColumn there = segment.after(share);
        LeafTable of = view.table(other);
        int first = of.first(other);
        for (int j = first; j < first + of.count(other); j++) {
            int near = segment.near(of.leaves(), j, 0);
            for (int k = 0; k < near; k++) {
                if (standing.isTouchedAnew(there, segment.near(k), of.leaves(), j)) {
                    return true;
                }
            }
        }
        return false;
    }

    /** Whether the object, after a share of the segment, overlaps one that it does not at the start. */
    private boolean touchesAnew(int other, double share) {
        LeafColumn there = segment.after(share);
        LeafTable of = view.table(other);
        int first = of.first(other);
        for (int j = first; j < first + of.count(other); j++) {
            int near = segment.near(of.leaves(), j, 0);
            for (int k = 0; k < near; k++) {
                int i = segment.near(k);
                if (standing.touchesAnew(there, i, of.leaves(), j)) {
                    // Contacts are only looked for here, as mostly there is no need of them.
                    boolean wasKnown = isStandingKnown;
                    if (!wasKnown && stands() && !standing.touchesAnew(there, i, of.leaves(), j)) {
                        continue;
                    }
                    note(i, standing.ownPiece(), j, standing.otherPiece());
                    return true;
                }
            }
        }
        return false;
    }

    private boolean isFreeAfter(double share) {
        for (int k = 0; k < candidates.count(); k++) {
            scratch.work.take();
            if (candidates.id(k) != obstacle && isAnew(candidates.id(k), share)) {
                return false;
            }
        }
        return exit.holds(segment.exactAfter(share));
    }

    /** The greatest share, not above the given one, whose place has been verified free of one object, or within the border. */
    private double backOff(int of, double from) {
        double free = from;
        double step = FIRST_STEP;
        int ownLeafMet = hitOwnLeaf;
        int ownPieceMet = hitOwnPiece;
        int leafMet = hitLeaf;
        int pieceMet = hitPiece;
        while (free > 0 && (of == BORDER ? !exit.holds(segment.exactAfter(free)) : isAnew(of, free))) {
            free = from - step;
            step *= 2;
        }
        note(ownLeafMet, ownPieceMet, leafMet, pieceMet);
        return Math.max(0, free);
    }

    /**
     * The greatest share, not above the least of all, whose place has been verified free: just that least, but where the
     * place as it is stored meets what the way itself passes by within rounding.
     */
    private double backOff(double least) {
        double free = least;
        double step = FIRST_STEP;
        while (free > 0 && (!isFreeAfter(free) || (free < least && obstacle >= 0 && isAnew(obstacle, free)))) {
            free = least - step;
            step *= 2;
        }
        return Math.max(0, free);
    }

    /**
     * Contact point and normal at the end of what is free, six numbers. Of several objects with the same free share, that is
     * written whose normal opposes the motion most; {@link #touched} returns its object.
     */
    public void contact(double[] out) {
        Motion shapes = exact;
        if (isBlockedExactly && shapes != null) {
            System.arraycopy(segment.end, 0, shapes.segment.end, 0, segment.end.length);
            shapes.contact(out);
            touched = shapes.touched;
            return;
        }
        touched = obstacle;
        if (obstacle == BORDER) {
            exit.contact(out);
        } else {
            stop.set(ownLeaf, ownPiece, obstacleLeaf, obstaclePiece);
            touched = stop.contact(view, obstacle, contactShare, out);
        }
    }

    /** The object whose contact was written last, or {@link #BORDER}. */
    public int touched() {
        return touched;
    }
}
