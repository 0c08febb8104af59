package robosim.geometry;

import java.util.Arrays;
import robosim.geometry.exact.Attitude;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.Border;
import robosim.geometry.narrow.Distance;
import robosim.geometry.narrow.LeafColumn;
import robosim.geometry.narrow.Overlap;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.Sweep;

/**
 * One attempt to move an object: its translation, its turn about Y and its turn about X, each a phase that is swept in
 * the world as it is. Nothing is changed here; {@link #end()} is where the object would come to stand.
 *
 * <p>A phase is free where no sweep meets anything and its end, as stored, overlaps nothing that its start did not.
 */
final class Motion {
    static final int NOTHING = -1;
    static final int BORDER = -2;

    /** What a phase turns about: nothing, the own X, the own Y or the vertical. */
    private static final int NO_TURN = 0;

    private static final int OWN_X = 1;
    private static final int OWN_Y = 2;
    private static final int VERTICAL = 3;

    private static final int PLACE = Bodies.PLACE;

    private final Bodies bodies;
    private final Border border;
    private final Near near;
    private final Scratch s;
    private final Sweep sweep;
    private final Distance distance;

    private final double[] start = new double[PLACE];
    private final double[] end = new double[PLACE];
    private final double[] probePlace = new double[PLACE];
    private LeafColumn atStart = new LeafColumn(1);
    private LeafColumn probe = new LeafColumn(1);
    private LeafColumn exact = new LeafColumn(1);
    private final double[] box = new double[6];
    private final double[] part = new double[6];

    private Level level;
    private int id;
    private Level.Form form;

    /** The phase under way: a translation, or turns in degrees. */
    private double dx;

    private double dy;
    private double dz;
    private int axis;
    private double degrees;

    private double clearance;
    private int obstacle;
    private int obstacleLeaf;
    private int ownLeaf;
    private double fraction;
    private double turnFraction;

    @SuppressWarnings("NullAway.Init") // an attempt sets its level and form
    Motion(Bodies bodies, Border border, Scratch scratch) {
        this.bodies = bodies;
        this.border = border;
        near = new Near(bodies);
        s = scratch;
        sweep = new Sweep(scratch);
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
        return end;
    }

    /**
     * Tries a motion by a displacement in the world's axes, then turns about the own axes in degrees.
     *
     * @param gap how far to stay from what blocks; 0 to stop just before contact
     * @return whether all of it is free; else {@link #end()} is the place before contact
     */
    boolean attempt(Level inLevel, int mover, double x, double y, double z, double turnX, double turnY, double gap) {
        begin(inLevel, mover, gap);
        boolean free = phase(x, y, z, NO_TURN, 0);
        if (!free) {
            fraction = share;
            turnFraction = 0;
            return false;
        }
        double each = turnX != 0 && turnY != 0 ? 0.5 : 1;
        if (turnY != 0 && !phase(0, 0, 0, OWN_Y, turnY)) {
            turnFraction = each * share;
            return false;
        }
        if (turnX != 0 && !phase(0, 0, 0, OWN_X, turnX)) {
            turnFraction = (1 - each) + each * share;
            return false;
        }
        return true;
    }

    /** Tries a turn about the vertical through the centre. */
    boolean attemptTurn(Level inLevel, int mover, double byDegrees) {
        begin(inLevel, mover, 0);
        boolean free = phase(0, 0, 0, VERTICAL, byDegrees);
        turnFraction = free ? 1 : share;
        return free;
    }

    private void begin(Level inLevel, int mover, double gap) {
        level = inLevel;
        id = mover;
        form = inLevel.form(mover);
        clearance = gap;
        obstacle = NOTHING;
        fraction = 1;
        turnFraction = 1;
        System.arraycopy(bodies.places(), bodies.place(mover), start, 0, PLACE);
        reserve();
    }

    private void reserve() {
        atStart.clear();
        atStart.append(form.size());
        probe.clear();
        probe.append(form.size());
        exact.clear();
        exact.append(form.own.size());
    }

    /** The free share of the phase that was blocked last. */
    private double share;

    /** Sweeps one phase from {@link #start} on; where it is free, its end is the next one's start. */
    private boolean phase(double x, double y, double z, int about, double byDegrees) {
        dx = x;
        dy = y;
        dz = z;
        axis = about;
        degrees = byDegrees;
        placeAt(1, end);
        if (Arrays.equals(start, end) && degrees == 0) {
            return true;
        }
        level.place(form, start[0], start[1], start[2], start, 3, atStart, 0);
        setSweep();
        sweptBox(1, box);
        near.find(level, box, id);
        double met = isRigid() ? leastFree() : leastFreeOfEnclosures();
        double leaves = leavesWorld();
        if (leaves < met) {
            met = leaves;
            obstacle = BORDER;
        }
        if (met == Double.POSITIVE_INFINITY && !touchesAnew(1)) {
            System.arraycopy(end, 0, start, 0, PLACE);
            return true;
        }
        share = backOff(Math.min(met, 1));
        placeAt(share, end);
        return false;
    }

    /** Where the object stands after a share of the phase. */
    private void placeAt(double part, double[] place) {
        System.arraycopy(start, 0, place, 0, PLACE);
        place[0] += part * dx;
        place[1] += part * dy;
        place[2] += part * dz;
        switch (axis) {
            case OWN_X -> Attitude.turn(place, 3, part * degrees, 0);
            case OWN_Y -> Attitude.turn(place, 3, 0, part * degrees);
            case VERTICAL -> Attitude.turnVertically(place, 3, part * degrees);
            default -> {}
        }
    }

    private void setSweep() {
        if (turns()) {
            setTurn(1);
        } else {
            sweep.translation(level.dimension, end[0] - start[0], end[1] - start[1], end[2] - start[2]);
        }
    }

    private void setTurn(double part) {
        int column = axis == OWN_X ? 3 : 4; // of the attitude, where it begins at 3
        boolean vertical = axis == VERTICAL;
        sweep.turn(
                level.dimension,
                start[0],
                start[1],
                start[2],
                vertical ? 0 : start[column],
                vertical ? 1 : start[column + 3],
                vertical ? 0 : start[column + 6],
                part * degrees);
    }

    private boolean turns() {
        return axis != NO_TURN;
    }

    /** Whether what stands for the object moves with it as one piece. */
    private boolean isRigid() {
        return !turns() || (level.accuracy != Accuracy.AABB && level.accuracy != Accuracy.DOP);
    }

    /** The bounds of all places of the object during a share of the phase. */
    private void sweptBox(double upTo, double[] out) {
        LeafColumn column = atStart;
        if (!isRigid()) {
            // The enclosure changes with the turn: what encloses the exact leaves all the way encloses it too.
            form.own.place(start[0], start[1], start[2], start, 3, exact, 0);
            column = exact;
            setTurn(upTo);
        }
        union(column, out);
    }

    private void union(LeafColumn column, double[] out) {
        Arrays.fill(out, 0, 3, Double.POSITIVE_INFINITY);
        Arrays.fill(out, 3, 6, Double.NEGATIVE_INFINITY);
        for (int leaf = 0; leaf < column.size(); leaf++) {
            sweep.bounds(column, leaf, part);
            for (int k = 0; k < 3; k++) {
                out[k] = Math.min(out[k], part[k]);
                out[3 + k] = Math.max(out[3 + k], part[3 + k]);
            }
        }
    }

    /** The least free share over all pairs of leaves, and what blocks there: the one added first, its lower leaf. */
    private double leastFree() {
        double least = Double.POSITIVE_INFINITY;
        for (int k = 0; k < near.count(); k++) {
            int other = near.id(k);
            for (int j = level.first(other); j < level.first(other) + level.count(other); j++) {
                for (int i = 0; i < atStart.size(); i++) {
                    double free = sweep.free(atStart, i, level.leaves(), j);
                    if (free != Double.POSITIVE_INFINITY && clearance > 0) {
                        free = standOff(i, j, Math.min(free, 1));
                    }
                    if (free < least || (free == least && isBefore(other, free))) {
                        least = free;
                        blame(other, i, j);
                    }
                }
            }
        }
        return least;
    }

    private boolean isBefore(int other, double free) {
        return free != Double.POSITIVE_INFINITY && obstacle >= 0 && bodies.isEarlier(other, obstacle);
    }

    private void blame(int other, int i, int j) {
        obstacle = other;
        ownLeaf = i;
        obstacleLeaf = j;
    }

    /** A turn of an axis-aligned enclosure: free where the box about all of it meets nothing new or deeper. */
    private double leastFreeOfEnclosures() {
        double least = Double.POSITIVE_INFINITY;
        for (int k = 0; k < near.count(); k++) {
            int other = near.id(k);
            if (level.meets(other, box) && deepens(other, box)) {
                double low = 0;
                double high = 1;
                for (int halving = 0; halving < 50; halving++) {
                    double middle = low / 2 + high / 2;
                    sweptBox(middle, box);
                    if (level.meets(other, box) && deepens(other, box)) {
                        high = middle;
                    } else {
                        low = middle;
                    }
                }
                sweptBox(1, box);
                if (low < least || (low == least && isBefore(other, low))) {
                    least = low;
                    blame(other, 0, level.first(other));
                }
            }
        }
        return least;
    }

    /** Whether a box overlaps an object's bounds more deeply than the object does at the start. */
    private boolean deepens(int other, double[] swept) {
        level.boundsOf(atStart, 0, atStart.size(), part, 0);
        double before = depth(other, part);
        double after = depth(other, swept);
        return after >= 0 && (before < 0 || after > before);
    }

    private double depth(int other, double[] swept) {
        double[] b = level.bounds();
        double least = Double.POSITIVE_INFINITY;
        for (int k = 0; k < 3; k += level.dimension == Dimension.PLANAR ? 2 : 1) {
            double one = swept[3 + k] - b[6 * other + k];
            double two = b[6 * other + 3 + k] - swept[k];
            least = Math.min(least, Math.min(one, two));
        }
        return least;
    }

    /** The share after which the object would leave the world, +Infinity where it stays inside. */
    private double leavesWorld() {
        form.own.place(start[0], start[1], start[2], start, 3, exact, 0);
        if (!turns()) {
            double leaves = border.share(exact, 0, exact.size(), dx, dy, dz);
            form.own.place(end[0], end[1], end[2], end, 3, exact, 0);
            if (border.holds(exact, 0, exact.size())) {
                return Double.POSITIVE_INFINITY;
            }
            double length = Math.sqrt(dx * dx + dy * dy + dz * dz);
            return Math.max(0, Math.min(1, leaves) - (clearance > 0 ? clearance / length : 0));
        }
        setTurn(1);
        union(exact, part2);
        boolean endHeld = endHeld();
        if (border.nearlyHolds(part2) && endHeld) {
            return Double.POSITIVE_INFINITY;
        }
        form.own.place(start[0], start[1], start[2], start, 3, exact, 0);
        double low = 0;
        double high = 1;
        for (int halving = 0; halving < 50; halving++) {
            double middle = low / 2 + high / 2;
            setTurn(middle);
            union(exact, part2);
            if (border.nearlyHolds(part2)) {
                low = middle;
            } else {
                high = middle;
            }
        }
        setTurn(1);
        return low;
    }

    private final double[] part2 = new double[6];

    private boolean endHeld() {
        form.own.place(end[0], end[1], end[2], end, 3, exact, 0);
        return border.holds(exact, 0, exact.size());
    }

    /** Whether the object, after a share of the phase, overlaps something that it does not at the start. */
    private boolean touchesAnew(double part) {
        placeAt(part, probePlace);
        level.place(form, probePlace[0], probePlace[1], probePlace[2], probePlace, 3, probe, 0);
        for (int k = 0; k < near.count(); k++) {
            int other = near.id(k);
            for (int j = level.first(other); j < level.first(other) + level.count(other); j++) {
                for (int i = 0; i < probe.size(); i++) {
                    if (Overlap.test(level.dimension, probe, i, level.leaves(), j, s)
                            && !Overlap.test(level.dimension, atStart, i, level.leaves(), j, s)) {
                        if (obstacle == NOTHING) {
                            blame(other, i, j);
                        }
                        return true;
                    }
                }
            }
        }
        return false;
    }

    private boolean isOutside(double part) {
        placeAt(part, probePlace);
        form.own.place(probePlace[0], probePlace[1], probePlace[2], probePlace, 3, exact, 0);
        return !border.holds(exact, 0, exact.size());
    }

    /** The greatest share, not above the given one, whose place has been verified free. */
    private double backOff(double from) {
        double free = from;
        double step = 0x1p-52;
        while (free > 0 && (touchesAnew(free) || isOutside(free))) {
            free = from - step;
            step *= 2;
        }
        return Math.max(0, free);
    }

    /** The greatest share up to contact at which two leaves are still as far apart as the clearance. */
    private double standOff(int i, int j, double contact) {
        if (gap(0, i, j) < clearance) {
            return 0;
        }
        if (turns()) {
            return standOffTurn(i, j, contact);
        }
        // The gap of convex leaves is a convex function of the way, so it falls all the way to contact.
        double low = 0;
        double high = contact;
        for (int halving = 0; halving < 80 && low < Math.nextDown(high); halving++) {
            double middle = low / 2 + high / 2;
            if (gap(middle, i, j) >= clearance) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return low;
    }

    /** Back from contact, each time by as little as the missing gap could be made up in. */
    private double standOffTurn(int i, int j, double contact) {
        level.boundsOf(atStart, 0, atStart.size(), part, 0);
        double reach = 0;
        for (int k = 0; k < 3; k++) {
            double far = Math.max(Math.abs(part[k] - start[k]), Math.abs(part[3 + k] - start[k]));
            reach += far * far;
        }
        double way = Math.sqrt(reach) * Math.abs(degrees) * (Math.PI / 180);
        double free = contact;
        for (int step = 0; step < 1000 && free > 0; step++) {
            double missing = clearance - gap(free, i, j);
            if (missing <= 0) {
                return free;
            }
            free -= Math.max(missing / way, 0x1p-52);
        }
        return 0;
    }

    private double gap(double part, int i, int j) {
        placeAt(part, probePlace);
        level.place(form, probePlace[0], probePlace[1], probePlace[2], probePlace, 3, probe, 0);
        return distance.between(level.dimension, probe, i, level.leaves(), j, Double.POSITIVE_INFINITY);
    }

    /** Contact point and normal at the end of what is free, six numbers. */
    void contact(double[] out) {
        if (obstacle == BORDER) {
            form.own.place(end[0], end[1], end[2], end, 3, exact, 0);
            level.boundsOf(exact, 0, exact.size(), part, 0);
            placeAt(1, probePlace);
            form.own.place(probePlace[0], probePlace[1], probePlace[2], probePlace, 3, exact, 0);
            level.boundsOf(exact, 0, exact.size(), part2, 0);
            border.contact(part2, part, out);
            return;
        }
        level.place(form, end[0], end[1], end[2], end, 3, probe, 0);
        distance.contact(level.dimension, probe, ownLeaf, level.leaves(), obstacleLeaf, out);
    }
}
