package robosim.geometry;

import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.Border;
import robosim.geometry.narrow.Distance;
import robosim.geometry.narrow.LeafColumn;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.Standing;

/**
 * One attempt to move an object: its translation, its turn about Y and its turn about X, each a phase that is swept in
 * the world as it is. Nothing is changed here; {@link #end()} is where the object would come to stand.
 *
 * <p>A phase is free where no sweep meets anything and its end, as stored, overlaps nothing that its start did not. What is
 * behind a plane of a contact at the start ({@link Standing}) counts for neither.
 */
final class Motion {
    static final int NOTHING = -1;
    static final int BORDER = -2;

    /** The largest share of what is refused. */
    private static final double MOST = Math.nextDown(1.0);

    private final Bodies bodies;
    private final Border border;
    private final Near near;
    private final Scratch s;
    private final Phase phase;
    private final StandOff standOff;
    private final Standing standing;
    private final Distance distance;
    private final double[] box = new double[6];
    private final double[] part = new double[6];
    private final double[] swept = new double[6];

    private Level level;
    private int id;
    private double clearance;
    private boolean isEndWanted;
    private int obstacle;
    private int obstacleLeaf;
    private int ownLeaf;
    private int obstaclePiece;
    private int ownPiece;
    private boolean isStandingKnown;
    private final LeafColumn touching = new LeafColumn(1);
    private final LeafColumn touched = new LeafColumn(1);
    private double fraction;
    private double turnFraction;

    @SuppressWarnings("NullAway.Init") // an attempt sets its level
    Motion(Bodies bodies, Border border, Scratch scratch) {
        this.bodies = bodies;
        this.border = border;
        near = new Near(bodies);
        s = scratch;
        phase = new Phase(scratch);
        standOff = new StandOff(phase, scratch);
        standing = new Standing(scratch);
        distance = new Distance(scratch);
    }

    /** What blocks: an id, {@link #NOTHING} or {@link #BORDER}. */
    int obstacle() {
        return obstacle;
    }

    double fraction() {
        return fraction;
    }

    double turnFraction() {
        return turnFraction;
    }

    /** The place at the end of what is free: of the whole motion where nothing blocks. */
    double[] end() {
        return phase.end;
    }

    /**
     * Tries a motion by a displacement in the world's axes, then turns about the own axes in degrees.
     *
     * @param gap how far to stay from what blocks; 0 to stop just before contact
     * @return whether all of it is free; else {@link #end()} is the place before contact
     */
    boolean attempt(Level inLevel, int mover, double x, double y, double z, double turnX, double turnY, double gap) {
        begin(inLevel, mover, gap, true);
        boolean free = isFree(x, y, z, Phase.NO_TURN, 0);
        if (!free) {
            fraction = share;
            turnFraction = 0;
            return false;
        }
        double each = turnX != 0 && turnY != 0 ? 0.5 : 1;
        if (turnY != 0 && !isFree(0, 0, 0, Phase.OWN_Y, turnY)) {
            turnFraction = each * share;
            return false;
        }
        if (turnX != 0 && !isFree(0, 0, 0, Phase.OWN_X, turnX)) {
            turnFraction = Math.min((1 - each) + each * share, MOST); // the sum may have been rounded up
            return false;
        }
        return true;
    }

    /** Whether a displacement in the world's axes is free, and no more: {@link #end()} is only set where it is. */
    boolean allows(Level inLevel, int mover, double x, double y, double z) {
        begin(inLevel, mover, 0, false);
        return isFree(x, y, z, Phase.NO_TURN, 0);
    }

    /** Whether a turn about the vertical through the centre is free, and no more. */
    boolean allowsTurn(Level inLevel, int mover, double byDegrees) {
        begin(inLevel, mover, 0, false);
        return isFree(0, 0, 0, Phase.VERTICAL, byDegrees);
    }

    private void begin(Level inLevel, int mover, double gap, boolean isToEnd) {
        isEndWanted = isToEnd;
        level = inLevel;
        id = mover;
        clearance = gap;
        obstacle = NOTHING;
        fraction = 1;
        turnFraction = 1;
        phase.begin(inLevel, mover, bodies.places(), bodies.place(mover));
    }

    /** The free share of the phase that was blocked last. */
    private double share;

    /** Sweeps the next phase; where it is free, its end is the next one's start. */
    private boolean isFree(double x, double y, double z, int about, double byDegrees) {
        if (!phase.set(x, y, z, about, byDegrees)) {
            phase.advance();
            return true;
        }
        phase.sweptBox(1, box);
        near.find(level, box, id);
        standing.begin(level.dimension, phase.sweep, phase.atStart, phase.atLast);
        isStandingKnown = false;
        double met = phase.isRigid() ? leastFree() : leastFreeOfEnclosures();
        double leaves = border.clearlyHolds(box) ? Double.POSITIVE_INFINITY : leavesWorld();
        if (leaves < met) {
            met = leaves;
            obstacle = BORDER;
        }
        if (met == Double.POSITIVE_INFINITY && !touchesAnew(1)) {
            phase.advance();
            return true;
        }
        // How far it might have gone is dear: a place is looked for, next to contact, that is free for certain.
        if (isEndWanted) {
            share = backOff(Math.min(met, MOST));
            phase.endAt(share);
        }
        return false;
    }

    /** The least free share over all pairs of leaves, and what blocks there: the one added first, its lower leaf. */
    private double leastFree() {
        LeafColumn atStart = phase.atStart;
        double least = Double.POSITIVE_INFINITY;
        for (int k = 0; k < near.count(); k++) {
            int other = near.id(k);
            Level of = level.of(other);
            int first = of.first(Bodies.bare(other));
            for (int j = first; j < first + of.count(Bodies.bare(other)); j++) {
                for (int i = 0; i < atStart.size(); i++) {
                    double free = phase.sweep.free(atStart, i, of.leaves(), j);
                    if (free != Double.POSITIVE_INFINITY && (clearance > 0 || (free <= least && stands()))) {
                        StandOff stop = clearance > 0 ? standOff.of(of, i, j, clearance) : null;
                        stands();
                        free = phase.sweep.free(atStart, i, of.leaves(), j, standing, stop);
                    }
                    if (free < least || (free == least && isBefore(other, free))) {
                        least = free;
                        blame(other, i, phase.sweep.ownPiece(), j, phase.sweep.otherPiece());
                    }
                }
            }
        }
        return least;
    }

    private boolean isBefore(int other, double free) {
        return free != Double.POSITIVE_INFINITY && obstacle >= 0 && bodies.isEarlier(other, obstacle);
    }

    private void blame(int other, int i, int t, int j, int u) {
        obstacle = other;
        ownLeaf = i;
        ownPiece = t;
        obstacleLeaf = j;
        obstaclePiece = u;
    }

    /** Whether the object touches anything at the start of the phase; what it touches is found when this is first asked. */
    private boolean stands() {
        if (!isStandingKnown) {
            isStandingKnown = true;
            phase.placeEnd();
            level.boundsOf(phase.atStart, 0, phase.atStart.size(), part);
            for (int k = 0; k < near.count(); k++) {
                int other = near.id(k);
                Level of = level.of(other);
                if (of.meets(Bodies.bare(other), part)) {
                    int first = of.first(Bodies.bare(other));
                    for (int j = first; j < first + of.count(Bodies.bare(other)); j++) {
                        standing.add(of.leaves(), j);
                    }
                }
            }
        }
        return !standing.isEmpty();
    }

    /** A turn of an axis-aligned enclosure: free where the box about all of it meets nothing new or deeper. */
    private double leastFreeOfEnclosures() {
        double least = Double.POSITIVE_INFINITY;
        for (int k = 0; k < near.count(); k++) {
            int other = near.id(k);
            if (meets(other) && deepens(other, box)) {
                double low = 0;
                double high = 1;
                for (int halving = 0; halving < 50; halving++) {
                    double middle = low / 2 + high / 2;
                    phase.sweptBox(middle, box);
                    if (meets(other) && deepens(other, box)) {
                        high = middle;
                    } else {
                        low = middle;
                    }
                }
                phase.sweptBox(1, box);
                if (low < least || (low == least && isBefore(other, low))) {
                    least = low;
                    blame(other, 0, -1, level.of(other).first(Bodies.bare(other)), -1);
                }
            }
        }
        return least;
    }

    private boolean meets(int other) {
        return level.of(other).meets(Bodies.bare(other), box);
    }

    /** Whether a box overlaps an object's bounds more deeply than the object does at the start. */
    private boolean deepens(int other, double[] way) {
        level.boundsOf(phase.atStart, 0, phase.atStart.size(), part);
        double before = depth(other, part);
        double after = depth(other, way);
        return after >= 0 && (before < 0 || after > before);
    }

    private double depth(int other, double[] of) {
        double[] b = level.of(other).bounds();
        int at = 6 * Bodies.bare(other);
        double least = Double.POSITIVE_INFINITY;
        for (int k = 0; k < 3; k += level.dimension == Dimension.PLANAR ? 2 : 1) {
            double one = of[3 + k] - b[at + k];
            double two = b[at + 3 + k] - of[k];
            least = Math.min(least, Math.min(one, two));
        }
        return least;
    }

    /** The share after which the object would leave the world, +Infinity where it stays inside. */
    private double leavesWorld() {
        return phase.turns() ? turnLeavesWorld() : translationLeavesWorld();
    }

    private double translationLeavesWorld() {
        if (isHeld(phase.exactAtEnd())) {
            return Double.POSITIVE_INFINITY;
        }
        double dx = phase.displacement(0);
        double dy = phase.displacement(1);
        double dz = phase.displacement(2);
        LeafColumn exact = phase.exactAtStart();
        double leaves = border.share(exact, 0, exact.size(), dx, dy, dz);
        double length = Math.sqrt(dx * dx + dy * dy + dz * dz);
        return Math.max(0, Math.min(1, leaves) - (clearance > 0 ? clearance / length : 0));
    }

    private double turnLeavesWorld() {
        phase.exactlySwept(1, swept);
        if (!border.nearlyHolds(swept)) {
            phase.tightlySwept(1, swept);
        }
        if (border.nearlyHolds(swept) && isHeld(phase.exactAtEnd())) {
            return Double.POSITIVE_INFINITY;
        }
        double low = 0;
        double high = 1;
        for (int halving = 0; halving < 50; halving++) {
            double middle = low / 2 + high / 2;
            phase.tightlySwept(middle, swept);
            if (border.nearlyHolds(swept)) {
                low = middle;
            } else {
                high = middle;
            }
        }
        phase.turnBy(1);
        return low;
    }

    private boolean isHeld(LeafColumn exact) {
        return border.holds(exact, 0, exact.size());
    }

    /**
     * Whether the object, after a share of the phase, overlaps something that it does not at the start. Where nothing is
     * blamed yet, that is blamed, and of several the one added first.
     */
    private boolean touchesAnew(double share) {
        phase.after(share);
        boolean isBlamed = obstacle != NOTHING;
        boolean touches = false;
        for (int k = 0; k < near.count() && !(touches && isBlamed); k++) {
            int other = near.id(k);
            if (!touches || bodies.isEarlier(other, obstacle)) {
                touches |= touchesAnew(other, !isBlamed);
            }
        }
        return touches;
    }

    private boolean touchesAnew(int other, boolean isToBlame) {
        Level of = level.of(other);
        int first = of.first(Bodies.bare(other));
        for (int j = first; j < first + of.count(Bodies.bare(other)); j++) {
            for (int i = 0; i < phase.atStart.size(); i++) {
                if (standing.touchesAnew(phase.probe, i, of.leaves(), j)) {
                    // Contacts are only looked for here, as mostly there is no need of them.
                    boolean wasKnown = isStandingKnown;
                    if (!wasKnown && stands() && !standing.touchesAnew(phase.probe, i, of.leaves(), j)) {
                        continue;
                    }
                    if (isToBlame) {
                        blame(other, i, standing.ownPiece(), j, standing.otherPiece());
                    }
                    return true;
                }
            }
        }
        return false;
    }

    /** The greatest share, not above the given one, whose place has been verified free. */
    private double backOff(double from) {
        double free = from;
        double step = 0x1p-52;
        while (free > 0 && (touchesAnew(free) || !isHeld(phase.exactAfter(free)))) {
            free = from - step;
            step *= 2;
        }
        return Math.max(0, free);
    }

    /** Contact point and normal at the end of what is free, six numbers. */
    void contact(double[] out) {
        if (obstacle == BORDER) {
            LeafColumn exact = phase.exactAtEnd();
            level.boundsOf(exact, 0, exact.size(), part);
            exact = phase.exactAfter(1);
            level.boundsOf(exact, 0, exact.size(), swept);
            border.contact(swept, part, out);
            return;
        }
        touching.setPiece(phase.atEnd(), ownLeaf, ownPiece);
        touched.setPiece(level.of(obstacle).leaves(), obstacleLeaf, obstaclePiece);
        distance.contact(level.dimension, touching, 0, touched, 0, out);
    }
}
