package robosim.geometry.engine.motion;

import robosim.geometry.engine.broadphase.AccuracyView;
import robosim.geometry.engine.broadphase.Candidates;
import robosim.geometry.engine.broadphase.LeafTable;
import robosim.geometry.engine.objects.ObjectTable;
import robosim.geometry.engine.objects.WorldBounds;
import robosim.geometry.exact.VectorMath;
import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.Distance;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.StartContacts;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.LeafKind;

/**
 * Tries to move an object, without moving it: its translation, its turn about Y and its turn about X, each a leg that is swept
 * in the world as it is. {@link #end()} is where the object would come to stand; {@code Geometry} then moves it there.
 *
 * <p>A leg is free where no sweep meets anything and its end, as stored, overlaps nothing that its start did not. What is
 * behind a plane of a contact at the start ({@link StartContacts}) counts for neither.
 */
public final class Motion {
    static final int NOTHING = -1;
    static final int BORDER = -2;

    /** A share is taken back by so much first, then by twice as much each time. */
    private static final double FIRST_STEP = 0x1p-52;

    /** The largest share of what is refused. */
    private static final double MOST = Math.nextDown(1.0);

    /** Less, in degrees, is not turned by to 53 bits. */
    private static final double LEAST_ANGLE = 0x1p-900;

    /**
     * How far off a place may be at the end of a share of a translation, of all coordinates: a caller's product and sum, and
     * the sweep's own difference, are rounded, each by at most an ulp of these. A blocked translation is taken back by so
     * much.
     */
    private static final double ROUNDED = 0x1p-50;

    /** The same in degrees: a caller adds the share of a turn to a heading, and takes the heading off again. */
    private static final double ROUNDED_HEADING = 0x1p-43;

    /**
     * A translation that nears its obstacle by at least this share of its length does so all the way, as convex sets do. Taken
     * back by so much more, it is known not to touch it, however it is rounded, and nothing is swept again.
     */
    private static final double LEAST_CLOSING = 0x1p-8;

    /** A larger margin is not taken: a place then has no more than a few digits. */
    private static final double MOST_MARGIN = 0x1p-20;

    private final ObjectTable objects;
    private final WorldBounds worldBounds;
    private final Candidates candidates;
    private final Leg leg;
    private final EnclosureTurn enclosure;
    private final BoundsExit exit;
    private final ClearanceSearch search;
    private final StartContacts standing;
    private final Distance distance;
    private final double[] box = new double[6];
    private final double[] part = new double[6];

    /** What holds the whole leg however its places are rounded. */
    private final double[] around = new double[6];

    /** The bounds of what stands for the object at the end of the leg. */
    private final double[] endBox = new double[6];

    private AccuracyView view;
    private int id;
    private double clearance;
    private boolean isEndWanted;
    private int obstacle;
    private int obstacleLeaf;
    private int ownLeaf;

    // The pieces by which an object was met last.
    private int metLeaf;
    private int metPiece;
    private int metOwnLeaf;
    private int metOwnPiece;

    private int obstaclePiece;
    private int ownPiece;
    private boolean isStandingKnown;
    private final LeafColumn touching = new LeafColumn(1);
    private final LeafColumn touched = new LeafColumn(1);
    private double fraction;
    private double turnFraction;
    private boolean isSecondTurn;

    /** The contact, where it had to be known to find the share. */
    private final double[] contact = new double[6];

    private boolean isContactKnown;

    @SuppressWarnings("NullAway.Init") // an attempt sets its view
    public Motion(ObjectTable objects, WorldBounds worldBounds, Scratch scratch) {
        this.objects = objects;
        this.worldBounds = worldBounds;
        candidates = new Candidates(objects);
        leg = new Leg(scratch);
        enclosure = new EnclosureTurn(leg);
        exit = new BoundsExit(worldBounds, leg);
        search = new ClearanceSearch(leg, scratch);
        standing = new StartContacts(scratch);
        distance = new Distance(scratch);
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
        return leg.end;
    }

    /**
     * Tries a motion by a displacement in the world's axes, then turns in degrees about the own axes or the world's.
     *
     * @param gap how far to stay from what blocks; 0 to stop just before contact
     * @return whether all of it is free; else {@link #end()} is the place before contact
     */
    public boolean attempt(
            AccuracyView inView,
            int mover,
            double x,
            double y,
            double z,
            double turnX,
            double turnY,
            boolean isGlobal,
            double gap) {
        begin(inView, mover, gap, true);
        return attempt(x, y, z, turnX, turnY, isGlobal);
    }

    /** The same along the object's own axes, and about them. */
    public boolean attemptOwn(
            AccuracyView inView, int mover, double x, double y, double z, double turnX, double turnY, double gap) {
        begin(inView, mover, gap, true);
        leg.takeOwnAxes();
        return attempt(x, y, z, turnX, turnY, false);
    }

    private boolean attempt(double x, double y, double z, double turnX, double turnY, boolean isGlobal) {
        boolean free = isFree(x, y, z, Leg.NO_TURN, 0);
        if (!free) {
            fraction = share;
            turnFraction = 0;
            return false;
        }
        double each = turnX != 0 && turnY != 0 ? 0.5 : 1;
        if (turnY != 0 && !isFree(0, 0, 0, isGlobal ? Leg.VERTICAL : Leg.OWN_Y, turnY)) {
            turnFraction = each * share;
            return false;
        }
        isSecondTurn = each < 1;
        if (turnX != 0 && !isFree(0, 0, 0, isGlobal ? Leg.WORLD_X : Leg.OWN_X, turnX)) {
            turnFraction = (1 - each) + each * share;
            return false;
        }
        return true;
    }

    /** Whether a displacement in the world's axes is free, and no more: {@link #end()} is only set where it is. */
    public boolean allows(AccuracyView inView, int mover, double x, double y, double z) {
        begin(inView, mover, 0, false);
        return isFree(x, y, z, Leg.NO_TURN, 0);
    }

    /** Whether a turn about the vertical through the centre is free, and no more. */
    public boolean allowsTurn(AccuracyView inView, int mover, double byDegrees) {
        begin(inView, mover, 0, false);
        return isFree(0, 0, 0, Leg.VERTICAL, byDegrees);
    }

    /**
     * Whether a displacement in the world's axes and then a turn about the vertical are free from another place than the
     * mover's own, laid out as in the table of objects; and no more.
     */
    public boolean allowsFrom(
            AccuracyView inView, int mover, double[] place, double x, double y, double z, double byDegrees) {
        begin(inView, mover, 0, false, place, 0);
        return isFree(x, y, z, Leg.NO_TURN, 0) && (byDegrees == 0 || isFree(0, 0, 0, Leg.VERTICAL, byDegrees));
    }

    private void begin(AccuracyView inView, int mover, double gap, boolean isToEnd) {
        begin(inView, mover, gap, isToEnd, objects.places(), objects.place(mover));
    }

    private void begin(AccuracyView inView, int mover, double gap, boolean isToEnd, double[] places, int at) {
        isEndWanted = isToEnd;
        view = inView;
        id = mover;
        clearance = gap;
        obstacle = NOTHING;
        isSecondTurn = false;
        isContactKnown = false;
        fraction = 1;
        turnFraction = 1;
        leg.begin(inView, mover, places, at);
    }

    /** The free share of the leg that was blocked last. */
    private double share;

    /** Sweeps the next leg; where it is free, its end is the next one's start. */
    private boolean isFree(double x, double y, double z, int about, double byDegrees) {
        if (!leg.set(x, y, z, about, byDegrees)) {
            leg.advance();
            return true;
        }
        enclose();
        candidates.find(view, around, id);
        if (!isEndWanted) {
            if (isBlockedAnywhere(NOTHING)) {
                return false;
            }
            leg.advance();
            return true;
        }
        double least = leastFree();
        if (least == Double.POSITIVE_INFINITY) {
            leg.advance();
            return true;
        }
        settle(isSecondTurn ? halved(least) : least);
        return false;
    }

    /** Bounds a leg that has been set or scaled; what it touches at its start is to be found again. */
    private void enclose() {
        leg.sweptBox(1, box);
        leg.around(box, around);
        standing.begin(view.dimension, leg.sweep, leg.atStart, leg.atLast);
        isStandingKnown = false;
        leg.after(1).bounds(0, leg.atStart.size(), endBox);
    }

    /** The greatest share, not above the given one, of which half and a half are a number. */
    private static double halved(double share) {
        double sum = 0.5 + 0.5 * share;
        double whole = 2 * sum - 1;
        return whole > share ? 2 * Math.nextDown(sum) - 1 : whole;
    }

    /**
     * Finds the share of a blocked leg that is reported, not above the least of all: one that a caller can use, who multiplies
     * what was asked for by it, and so asks for another leg, whose path differs by roundings.
     */
    private void settle(double least) {
        if (leg.turns() && isSureTurn()) {
            share = backOff(least);
            leg.endAt(share);
            return;
        }
        double free = least;
        double margin = leg.turns() ? ROUNDED_HEADING / leg.angle() : ROUNDED * size() / length();
        int sure = NOTHING;
        if (!leg.turns() && isPlain()) {
            double closing = closing(least);
            sure = closing > LEAST_CLOSING ? obstacle : NOTHING;
            margin /= closing > LEAST_CLOSING ? closing : 1;
        }
        if (margin < MOST_MARGIN) {
            free = Math.max(0, least - margin);
        } else {
            sure = NOTHING;
        }
        double from = isSecondTurn ? halved(free) : free;
        double step = FIRST_STEP;
        free = from;
        while (free > 0 && !(sure != NOTHING && isAlone(free, sure)) && !isAccepted(free, sure)) {
            free = from - step;
            step *= 2;
            sure = NOTHING;
        }
        share = Math.max(0, free);
        leg.scale(1);
        leg.endAt(share);
    }

    /** Whether a turn that a share of this one is may be used as it is: its sweep takes the same steps, up to there. */
    private boolean isSureTurn() {
        return leg.isRigid() && !standing.spares() && worldBounds.clearlyHolds(box) && leg.angle() > LEAST_ANGLE;
    }

    /** Whether nothing but one object is near a translation up to a share of it. */
    private boolean isAlone(double share, int but) {
        leg.atStart.bounds(0, leg.atStart.size(), part);
        leg.after(share).bounds(0, leg.atStart.size(), endBox);
        for (int k = 0; k < 3; k++) {
            part[k] = Math.min(part[k], endBox[k]);
            part[3 + k] = Math.max(part[3 + k], endBox[3 + k]);
        }
        leg.around(part, around);
        for (int k = 0; k < candidates.count(); k++) {
            int other = candidates.id(k);
            if (other != but && view.table(other).meets(other, around)) {
                return false;
            }
        }
        return but == BORDER || worldBounds.clearlyHolds(around);
    }

    private boolean isAccepted(double share, int sure) {
        if (!leg.scale(share)) {
            return true;
        }
        enclose();
        return !isBlockedAnywhere(sure);
    }

    /** By how much of its length a translation nears its obstacle at the end of a share; the contact there is kept. */
    private double closing(double share) {
        leg.endAt(share);
        contact(contact);
        isContactKnown = true;
        double nearer = -(leg.displacement(0) * contact[3]
                + leg.displacement(1) * contact[4]
                + leg.displacement(2) * contact[5]);
        return nearer / length();
    }

    private double length() {
        return VectorMath.anyLength(leg.displacement(0), leg.displacement(1), leg.displacement(2));
    }

    /** The sum of all coordinates of the leg's bounds, unsigned. */
    private double size() {
        double size = 0;
        for (double bound : box) {
            size += Math.abs(bound);
        }
        return size;
    }

    /** Whether one upright prism hits another, or in the plane a disc, each of a single leaf; or the border is hit. */
    private boolean isPlain() {
        if (obstacle == BORDER) {
            return true;
        }
        LeafTable of = view.table(obstacle);
        return leg.atStart.size() == 1
                && of.count(obstacle) == 1
                && isExact(leg.atStart.kind(0))
                && isExact(of.leaves().kind(of.first(obstacle)));
    }

    private boolean isExact(LeafKind kind) {
        return (kind.isVerticalPrism() && !kind.isEnclosure()) || (kind.isDisc() && view.dimension == Dimension.PLANAR);
    }

    /**
     * Whether anything blocks the whole leg.
     *
     * @param sure an object that is known not to, or {@link #NOTHING}
     */
    private boolean isBlockedAnywhere(int sure) {
        for (int k = 0; k < candidates.count(); k++) {
            int other = candidates.id(k);
            if (other == sure || !view.table(other).meets(other, around)) {
                continue;
            }
            if (met(other) != Double.POSITIVE_INFINITY || endsOn(other)) {
                return true;
            }
        }
        return sure != BORDER && !worldBounds.clearlyHolds(box) && exit.share(clearance) != Double.POSITIVE_INFINITY;
    }

    /**
     * The least free share of those beside each obstacle alone, and whose it is: that of the one added first, the border's
     * last. What is free beside one is verified beside that one, so that it does not depend on the others.
     */
    private double leastFree() {
        double least = Double.POSITIVE_INFINITY;
        for (int k = 0; k < candidates.count(); k++) {
            int other = candidates.id(k);
            double met = met(other);
            if (met == Double.POSITIVE_INFINITY && !endsOn(other)) {
                continue;
            }
            double free = backOff(other, Math.min(met, MOST));
            if (free < least || (free == least && objects.isEarlier(other, obstacle))) {
                least = free;
                obstacle = other;
                ownLeaf = metOwnLeaf;
                ownPiece = metOwnPiece;
                obstacleLeaf = metLeaf;
                obstaclePiece = metPiece;
            }
        }
        double leaves = worldBounds.clearlyHolds(box) ? Double.POSITIVE_INFINITY : exit.share(clearance);
        if (leaves != Double.POSITIVE_INFINITY) {
            double free = backOff(BORDER, Math.min(leaves, MOST));
            if (free < least) {
                least = free;
                obstacle = BORDER;
            }
        }
        return least;
    }

    /** The share after which an object is met, and the leaves that meet: of several the object's lower one. */
    private double met(int other) {
        if (leg.isRigid()) {
            return metAsItIs(other);
        }
        double met = enclosure.met(view, other, box);
        if (met != Double.POSITIVE_INFINITY) {
            meet(0, -1, view.table(other).first(other), enclosure.piece());
        }
        return met;
    }

    private double metAsItIs(int other) {
        LeafColumn atStart = leg.atStart;
        LeafTable of = view.table(other);
        int first = of.first(other);
        double least = Double.POSITIVE_INFINITY;
        for (int j = first; j < first + of.count(other); j++) {
            for (int i = 0; i < atStart.size(); i++) {
                boolean isOnFloor = hasPieces(of, other, i, j) && stands(); // whose planes spare most of a sweep
                double free = isOnFloor
                        ? leg.sweep.free(atStart, i, of.leaves(), j, standing, null)
                        : leg.sweep.free(atStart, i, of.leaves(), j);
                boolean isDone = isOnFloor && clearance == 0;
                if (free != Double.POSITIVE_INFINITY && !isDone && (clearance > 0 || (free <= least && stands()))) {
                    ClearanceSearch stop = clearance > 0 ? search.of(of, i, j, clearance) : null;
                    stands();
                    free = leg.sweep.free(atStart, i, of.leaves(), j, standing, stop);
                }
                if (free < least || (free == least && isLowerCell(of.leaves(), j))) {
                    least = free;
                    meet(i, leg.sweep.ownPiece(), j, leg.sweep.otherPiece());
                }
            }
        }
        return least;
    }

    /** Whether the last sweep met a cell of a grid that comes before the one that was met by another leaf of the object. */
    private boolean isLowerCell(LeafColumn leaves, int j) {
        return leaves.kind(j).isGrid() && leg.sweep.otherPiece() >= 0 && leg.sweep.otherPiece() < metPiece;
    }

    /** Whether one of the leaves is a mesh or a grid, and the object may touch the other at the start. */
    private boolean hasPieces(LeafTable of, int other, int i, int j) {
        if (!leg.atStart.kind(i).hasPieces() && !of.leaves().kind(j).hasPieces()) {
            return false;
        }
        leg.atStart.bounds(0, leg.atStart.size(), part);
        return of.meets(other, part);
    }

    private void meet(int i, int t, int j, int u) {
        metOwnLeaf = i;
        metOwnPiece = t;
        metLeaf = j;
        metPiece = u;
    }

    /** Whether the object touches anything at the start of the leg; what it touches is found when this is first asked. */
    private boolean stands() {
        if (!isStandingKnown) {
            isStandingKnown = true;
            leg.placeEnd();
            leg.atStart.bounds(0, leg.atStart.size(), part);
            for (int k = 0; k < candidates.count(); k++) {
                int other = candidates.id(k);
                LeafTable of = view.table(other);
                if (of.meets(other, part)) {
                    int first = of.first(other);
                    for (int j = first; j < first + of.count(other); j++) {
                        standing.add(of.leaves(), j);
                    }
                }
            }
        }
        return !standing.isEmpty();
    }

    /** Whether the object, as stored at the end of the leg, overlaps one that it does not at the start. */
    private boolean endsOn(int other) {
        return view.table(other).meets(other, endBox) && touchesAnew(other, 1);
    }

    /** Whether the object, after a share of the leg, overlaps one that it does not at the start. */
    private boolean touchesAnew(int other, double share) {
        LeafColumn there = leg.after(share);
        LeafTable of = view.table(other);
        int first = of.first(other);
        for (int j = first; j < first + of.count(other); j++) {
            for (int i = 0; i < leg.atStart.size(); i++) {
                if (standing.touchesAnew(there, i, of.leaves(), j)) {
                    // Contacts are only looked for here, as mostly there is no need of them.
                    boolean wasKnown = isStandingKnown;
                    if (!wasKnown && stands() && !standing.touchesAnew(there, i, of.leaves(), j)) {
                        continue;
                    }
                    meet(i, standing.ownPiece(), j, standing.otherPiece());
                    return true;
                }
            }
        }
        return false;
    }

    private boolean isFreeAfter(double share) {
        for (int k = 0; k < candidates.count(); k++) {
            if (candidates.id(k) != obstacle && touchesAnew(candidates.id(k), share)) {
                return false;
            }
        }
        return exit.holds(leg.exactAfter(share));
    }

    /** The greatest share, not above the given one, whose place has been verified free of one object, or within the border. */
    private double backOff(int of, double from) {
        double free = from;
        double step = FIRST_STEP;
        int ownLeafMet = metOwnLeaf;
        int ownPieceMet = metOwnPiece;
        int leafMet = metLeaf;
        int pieceMet = metPiece;
        while (free > 0 && (of == BORDER ? !exit.holds(leg.exactAfter(free)) : touchesAnew(of, free))) {
            free = from - step;
            step *= 2;
        }
        meet(ownLeafMet, ownPieceMet, leafMet, pieceMet);
        return Math.max(0, free);
    }

    /**
     * The greatest share, not above the least of all, whose place has been verified free: just that least, but where the
     * place as it is stored meets what the way itself passes by within rounding.
     */
    private double backOff(double least) {
        double free = least;
        double step = FIRST_STEP;
        while (free > 0 && (!isFreeAfter(free) || (free < least && obstacle >= 0 && touchesAnew(obstacle, free)))) {
            free = least - step;
            step *= 2;
        }
        return Math.max(0, free);
    }

    /** Contact point and normal at the end of what is free, six numbers. */
    public void contact(double[] out) {
        if (isContactKnown) {
            System.arraycopy(contact, 0, out, 0, contact.length);
            return;
        }
        if (obstacle == BORDER) {
            exit.contact(out);
            return;
        }
        touching.setPiece(leg.atEnd(), ownLeaf, ownPiece);
        touched.setPiece(view.table(obstacle).leaves(), obstacleLeaf, obstaclePiece);
        distance.contact(view.dimension, touching, 0, touched, 0, out);
    }
}
