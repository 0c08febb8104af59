package robosim.geometry.engine.motion;

import java.util.Arrays;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import robosim.geometry.engine.broadphase.AccuracyView;
import robosim.geometry.engine.objects.ObjectLeaves;
import robosim.geometry.engine.objects.ObjectTable;
import robosim.geometry.exact.Attitude;
import robosim.geometry.exact.Degrees;
import robosim.geometry.exact.DoubleDouble;
import robosim.geometry.exact.Rotations;
import robosim.geometry.exact.VectorMath;
import robosim.geometry.exact.WorkCounter;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.Pose;
import robosim.geometry.model.Twist;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.Sweep;
import robosim.geometry.narrow.leaf.LeafBoxes;
import robosim.geometry.narrow.leaf.LeafColumn;

/**
 * One segment of a motion: a straight translation, a turn about an axis through the centre, or a {@link Twist}, which is swept
 * as a turn about the centre of its arc. It knows where the object starts, where it is after a share of the segment, and what box holds it all the way.
 */
public final class MotionSegment {
    /** What a segment turns about: nothing, the own X, the own Y, the vertical or the world's X. */
    static final int NO_TURN = 0;

    static final int OWN_X = 1;
    static final int OWN_Y = 2;
    static final int VERTICAL = 3;
    static final int WORLD_X = 4;

    /**
     * How far off the centre of an upright object may be at the end of a way, as a share of its length, apart from half an
     * ulp of each coordinate: 8u, u = 2<sup>-53</sup>.
     *
     * <p>A step (x, y, z) goes by {@code cos * x + sin * z} along the world's X, and by {@code cos * z - sin * x} along its
     * Z. The cosine and the sine are off by 3u of themselves, their products by u, and the sum by u: 5u (|cos x| + |sin z|)
     * and 5u (|sin x| + |cos z|), together at most 7.1u of the step. Adding it to a coordinate c costs {@code 2^-105 |c|}
     * more, which is less than that for every step above {@code 2^-52 |c|}.
     */
    public static final double WAY_ERROR = 0x1p-50;

    /** More than a place loses when it is stored, and than an enclosure is widened by, as a share of its coordinates. */
    private static final double STORED = 0x1p-42;

    /** More than a sweep of the objects themselves may stop early, as a share of their coordinates; see docs/numerics.md. */
    static final double EARLY = 0x1p-19;

    /** An arc of fewer radians is swept as a translation: no point of it is off by more than a path is by rounding. */
    private static final double STRAIGHT = 0x1p-48;

    /** An arc of a larger radius, in sizes of the object, is wide. */
    private static final double WIDE = 16;

    private static final int PLACE = ObjectTable.PLACE;

    final double[] start = new double[PLACE];
    final double[] end = new double[PLACE];

    /** What stands for the object at its start, at the accuracy asked for. */
    final LeafColumn atStart = new LeafColumn(1);

    final Sweep sweep;

    /** Counts what is done about the segment. */
    final WorkCounter work;

    private final double[] between = new double[PLACE];

    /** What stands for the object at the end of the segment; see {@link #placeEnd}. */
    final LeafColumn atLast = new LeafColumn(1);

    /** What stands for the object where it was asked about last, after its start. */
    private final LeafColumn probe = new LeafColumn(1);

    /** The share after which the probe stands; NaN where it does not tell a place of this segment. */
    private double probed = Double.NaN;

    private final LeafColumn exact = new LeafColumn(1);
    private final double[] part = new double[6];
    private final double[] theirs = new double[6];

    /** The bounds of all places of each leaf during the segment as it was scaled; not kept of a single leaf. */
    private final LeafBoxes leavesSwept = new LeafBoxes();

    /** For which scale that is so; NaN for none. */
    private double sweptScale = Double.NaN;

    /** More than a sweep of a leaf may stop early, and than a place may be rounded. */
    private double early;

    private AccuracyView view;
    private ObjectLeaves form;
    private double givenX;
    private double givenY;
    private double givenZ;
    private double givenDegrees;
    private boolean isOwn;

    /** By what share the segment that was set has been scaled. */
    private double scaled;

    /** What turns while it translates, and for how long; null for other segments. */
    private @Nullable Twist twist;

    private double seconds;

    /** What a turn is about: the centre at the start, or that of the arc of a twist. */
    final double[] pivot = new double[3];

    /** The pose at the origin, from which a twist leads to {@link #chord}. */
    private final double[] origin = new double[PLACE];

    private final double[] chord = new double[PLACE];

    /** The displacement of the segment along the world's axes, and that of a share of it. */
    private final double[] whole = new double[3];

    private final double[] way = new double[3];
    private int axis;
    private double degrees;

    @SuppressWarnings("NullAway.Init") // a motion begins with its view and form
    MotionSegment(Scratch scratch) {
        sweep = new Sweep(scratch);
        work = scratch.work;
        Attitude.setHeading(origin, 3, 0, 0);
    }

    /** Starts a motion of an object from its place. */
    void begin(AccuracyView inView, int mover, double[] places, int at) {
        isOwn = false;
        twist = null;
        view = inView;
        form = inView.form(mover);
        System.arraycopy(places, at, start, 0, PLACE);
        atStart.clear();
        atStart.append(form.size());
        probe.clear();
        probe.append(form.size());
        atLast.clear();
        atLast.append(form.size());
        exact.clear();
        exact.append(form.own.size());
    }

    /** Sets the next segment, from {@link #start}; false where it goes nowhere, or by less than a coordinate can tell. */
    boolean set(double x, double y, double z, int about, double byDegrees) {
        givenX = x;
        givenY = y;
        givenZ = z;
        axis = about;
        givenDegrees = byDegrees;
        return set();
    }

    /** Sets the only segment of a motion with a constant twist. */
    boolean set(Twist velocity, double time) {
        twist = velocity;
        seconds = time;
        boolean isInPlace = velocity.x() == 0 && velocity.z() == 0;
        double angle = Degrees.toRadians(Math.abs(velocity.ry() * time));
        axis = angle > (isInPlace ? 0 : STRAIGHT) ? OWN_Y : NO_TURN;
        return set();
    }

    /** Sets the segment that another one is, from the same start. */
    void set(MotionSegment other) {
        givenX = other.givenX;
        givenY = other.givenY;
        givenZ = other.givenZ;
        givenDegrees = other.givenDegrees;
        axis = other.axis;
        isOwn = other.isOwn;
        twist = other.twist;
        seconds = other.seconds;
        set();
    }

    private boolean set() {
        System.arraycopy(start, 0, pivot, 0, 3);
        if (isArc() && turns()) {
            // The velocity at the centre is square to the line from the pivot: in the own frame that is at (z, -x) over
            // the speed
            // of turning.
            double spin = Degrees.toRadians(twist().ry());
            double ahead = twist().z() / spin;
            double aside = -twist().x() / spin;
            for (int along = 0; along < 3; along++) {
                pivot[along] += start[3 + 3 * along] * ahead + start[5 + 3 * along] * aside;
            }
        }
        if (!scale(1)) {
            return false;
        }
        form.place(view.dimension, start[0], start[1], start[2], start, 3, atStart, 0);
        return true;
    }

    /** Whether the segment turns while it translates. */
    boolean isArc() {
        return twist != null && (twist.x() != 0 || twist.z() != 0) && twist.ry() * seconds != 0;
    }

    /** Whether the centre of an arc is so far away that its sweep resolves little beside the size of the object. */
    boolean isWide() {
        atStart.bounds(0, atStart.size(), part);
        double radius = VectorMath.anyLength(pivot[0] - start[0], pivot[1] - start[1], pivot[2] - start[2]);
        return radius > WIDE * (part[3] - part[0] + part[4] - part[1] + part[5] - part[2]);
    }

    private Twist twist() {
        return Objects.requireNonNull(twist);
    }

    /**
     * Makes the segment the one that a caller gets who multiplies what was set by a share, in doubles: it ends where the one set
     * is after that share, and its path differs by roundings. False where it goes nowhere.
     */
    boolean scale(double share) {
        scaled = share;
        degrees = twist == null ? share * givenDegrees : twist.ry() * (share * seconds);
        sweptScale = Double.NaN;
        probed = Double.NaN;
        placeAt(1, end);
        System.arraycopy(way, 0, whole, 0, 3);
        if (Arrays.equals(start, 0, Pose.LOST, end, 0, Pose.LOST) && degrees == 0) {
            return false;
        }
        if (turns()) {
            turnBy(1);
        } else {
            sweep.translation(view.dimension, end[0] - start[0], end[1] - start[1], end[2] - start[2]);
        }
        return true;
    }

    /** Makes this segment one that stays at its start. */
    void stay() {
        givenX = 0;
        givenY = 0;
        givenZ = 0;
        givenDegrees = 0;
        axis = NO_TURN;
        twist = null;
        scale(1);
        form.place(view.dimension, start[0], start[1], start[2], start, 3, atStart, 0);
        sweptScale = Double.NaN;
        sweep.translation(view.dimension, 0, 0, 0);
    }

    /** The length of the path of every point of the mover, or more. */
    double longestPath() {
        if (!turns()) {
            return VectorMath.anyLength(whole[0], dimension() == Dimension.PLANAR ? 0 : whole[1], whole[2]);
        }
        atStart.bounds(0, atStart.size(), part);
        double radius = VectorMath.anyLength(farthest(0), farthest(1), farthest(2));
        double more = isRigid() ? 1 : 2; // what stands for it changes with the turn
        return more * radius * Math.abs(degrees) * (Math.PI / 180);
    }

    /** How far the bounds in {@link #part} extend along an axis from the pivot. */
    private double farthest(int along) {
        return Math.max(Math.abs(part[along] - pivot[along]), Math.abs(part[3 + along] - pivot[along]));
    }

    /** The sum of the magnitudes of the bounds at the start, to which rounding is proportional; of heights if they count. */
    double size() {
        atStart.bounds(0, atStart.size(), part);
        double size = 0;
        for (int along = 0; along < 3; along += dimension() == Dimension.PLANAR ? 2 : 1) {
            size += Math.abs(part[along]) + Math.abs(part[3 + along]);
        }
        return size;
    }

    /** From now on translations are along the axes of the object as it stands at the start. */
    void takeOwnAxes() {
        isOwn = true;
    }

    /** Makes the end of this segment the start of the next. */
    void advance() {
        System.arraycopy(end, 0, start, 0, PLACE);
    }

    /** Makes the place after a share of the segment its end. */
    void endAt(double share) {
        placeAt(share, end);
    }

    /** Where the object stands after a share of the segment. */
    private void placeAt(double share, double[] place) {
        System.arraycopy(start, 0, place, 0, PLACE);
        toWorld(share);
        advance(place, 0, way[0]);
        advance(place, 1, way[1]);
        advance(place, 2, way[2]);
        double by = share * degrees;
        switch (twist == null ? axis : OWN_Y) {
            case OWN_X -> Attitude.turn(place, 3, by, 0);
            case OWN_Y -> Attitude.turn(place, 3, 0, by);
            case VERTICAL -> Attitude.turnVertically(place, 3, by);
            case WORLD_X -> Attitude.turnAboutX(place, 3, by);
            default -> {}
        }
    }

    /** Finds the {@link #way} for a share of the segment, along the world's axes as {@code ObjectTable.toWorld} does. */
    private void toWorld(double share) {
        if (twist != null) {
            twist.after(origin, 0, share * (scaled * seconds), chord);
            toWorld(chord[0], chord[1], chord[2], true);
        } else {
            toWorld(share * (scaled * givenX), share * (scaled * givenY), share * (scaled * givenZ), isOwn);
        }
    }

    private void toWorld(double x, double y, double z, boolean isOwn) {
        way[0] = isOwn ? start[3] * x + start[4] * y + start[5] * z : x;
        way[1] = isOwn ? start[6] * x + start[7] * y + start[8] * z : y;
        way[2] = isOwn ? start[9] * x + start[10] * y + start[11] * z : z;
    }

    /**
     * Adds to a coordinate and to what it has lost: off by at most {@code 2^-105} of the larger of the coordinate before and
     * after. The one rounding is that of {@code rest}, which is at most an ulp of that coordinate.
     */
    private static void advance(double[] place, int along, double by) {
        double from = place[along];
        double to = from + by;
        double rest = DoubleDouble.sumTail(from, by, to) + place[Pose.LOST + along];
        double sum = to + rest;
        place[along] = sum;
        place[Pose.LOST + along] = DoubleDouble.sumTail(to, rest, sum);
    }

    /** Makes {@link #sweep} the turn of the first share of the segment. */
    void turnBy(double share) {
        int column = axis == OWN_X ? 3 : 4; // of the attitude, where it begins at 3
        boolean isOwn = axis == OWN_X || axis == OWN_Y;
        sweep.turn(view.dimension)
                .about(pivot[0], pivot[1], pivot[2])
                .by(
                        isOwn ? start[column] : axis == WORLD_X ? 1 : 0,
                        isOwn ? start[column + 3] : axis == WORLD_X ? 0 : 1,
                        isOwn ? start[column + 6] : 0,
                        share * degrees);
    }

    /** Whether heights count. */
    Dimension dimension() {
        return view.dimension;
    }

    boolean turns() {
        return axis != NO_TURN;
    }

    /** Degrees of the turn, unsigned. */
    double angle() {
        return Math.abs(degrees);
    }

    /** Displacement along an axis (0 to 2) of the world. */
    double displacement(int along) {
        return whole[along];
    }

    /** Displacement along an axis of the world between the start and the end as they are stored. */
    double stored(int along) {
        return end[along] - start[along];
    }

    /** Whether what stands for the object moves with it as one piece. */
    boolean isRigid() {
        return !turns()
                || switch (view.accuracy) {
                    case AABB, DOP -> false;
                    case SPHERE -> !tips();
                    case OBB, EXACT -> true;
                };
    }

    /** Whether an upright object whose heights do not matter is tipped, so that from then on they do. */
    private boolean tips() {
        return axis == OWN_X && view.dimension == Dimension.PLANAR && Rotations.isUpright(start, 3);
    }

    /** The bounds of all places of what stands for the object during the first share of the segment. */
    void sweptBox(double share, double[] out) {
        if (isRigid()) {
            sweepLeaves(out);
        } else if (view.accuracy == Accuracy.SPHERE) {
            turnBy(share);
            form.place(Dimension.SPATIAL, start[0], start[1], start[2], start, 3, probe, 0);
            probed = Double.NaN;
            union(probe, out);
        } else {
            // The enclosure changes with the turn: what encloses the exact leaves all the way encloses it too.
            exactlySwept(share, out);
        }
    }

    /** The bounds of all places of the object itself during the first share of a turn. */
    void exactlySwept(double share, double[] out) {
        exactAtStart();
        turnBy(share);
        union(exact, out);
    }

    /**
     * The bounds of x + z (two numbers) and of x - z (two more) of all places of the octagon that stands for the object during
     * the first share of a turn.
     */
    void sweptDiagonals(double share, double[] out) {
        System.arraycopy(atStart.rows(0), atStart.at(0) + 4, out, 0, 4);
        exactAtStart();
        turnBy(share);
        for (int leaf = 0; leaf < exact.size(); leaf++) {
            sweep.turnDiagonals(exact, leaf, out);
        }
    }

    /** The same with each triangle of a mesh for itself, which takes longer. */
    void tightlySwept(double share, double[] out) {
        exactAtStart();
        turnBy(share);
        clear(out);
        for (int leaf = 0; leaf < exact.size(); leaf++) {
            sweep.tightBounds(exact, leaf, part);
            include(part, out);
        }
    }

    private void sweepLeaves(double[] out) {
        if (atStart.size() == 1) {
            sweep.bounds(atStart, 0, out);
            return;
        }
        sweptScale = scaled;
        leavesSwept.clear(atStart.size(), dimension() == Dimension.PLANAR);
        clear(out);
        for (int leaf = 0; leaf < atStart.size(); leaf++) {
            sweep.bounds(atStart, leaf, part);
            leavesSwept.set(leaf, part);
            include(part, out);
        }
        early = EARLY * size(out);
    }

    /** The sum of the magnitudes of the bounds of a box and of the pivot. */
    private double size(double[] box) {
        double size = Math.abs(pivot[0]) + Math.abs(pivot[1]) + Math.abs(pivot[2]);
        for (double bound : box) {
            size += Math.abs(bound);
        }
        return size;
    }

    /**
     * Finds the mover's leaves that may come within a distance of a leaf of another object during the segment; see {@link
     * #near(int)}.
     *
     * @return how many there are
     */
    int near(LeafColumn other, int leaf, double distance) {
        if (atStart.size() == 1) {
            return 1;
        }
        if (sweptScale != scaled) {
            if (turns()) {
                turnBy(1);
            }
            sweepLeaves(leavesSwept.box);
        }
        other.bounds(leaf, leavesSwept.box);
        double slack = early + EARLY * size(leavesSwept.box);
        return distance > 0 ? leavesSwept.within(distance + slack) : leavesSwept.meeting(slack);
    }

    /**
     * Whether a leaf of the mover certainly touches another one only after a share of a straight segment, if at all: their bounds
     * do, by more than a sweep may stop early.
     */
    boolean comesLater(int own, LeafColumn other, int leaf, double share) {
        if (turns() || share == Double.POSITIVE_INFINITY) {
            return false;
        }
        atStart.bounds(own, part);
        other.bounds(leaf, theirs);
        double slack = EARLY * (size(part) + size(theirs)) + Double.MIN_NORMAL;
        for (int k = 0; k < 3; k += dimension() == Dimension.PLANAR ? 2 : 1) {
            double by = end[k] - start[k];
            double gap = by > 0 ? theirs[k] - part[3 + k] : part[k] - theirs[3 + k];
            if (gap - slack > share * Math.abs(by) * (1 + EARLY)) {
                return by != 0;
            }
        }
        return false;
    }

    /** The k-th of the leaves that may come near, in ascending order. */
    int near(int k) {
        return atStart.size() == 1 ? 0 : leavesSwept.found(k);
    }

    private void union(LeafColumn column, double[] out) {
        clear(out);
        for (int leaf = 0; leaf < column.size(); leaf++) {
            sweep.bounds(column, leaf, part);
            include(part, out);
        }
    }

    private static void clear(double[] box) {
        Arrays.fill(box, 0, 3, Double.POSITIVE_INFINITY);
        Arrays.fill(box, 3, 6, Double.NEGATIVE_INFINITY);
    }

    private static void include(double[] one, double[] all) {
        for (int k = 0; k < 3; k++) {
            all[k] = Math.min(all[k], one[k]);
            all[3 + k] = Math.max(all[3 + k], one[3 + k]);
        }
    }

    /** What stands for the object after a share of the segment; valid until the next call. */
    LeafColumn after(double share) {
        if (share != probed) {
            placeAt(share, between);
            form.place(view.dimension, between[0], between[1], between[2], between, 3, probe, 0);
            probed = share;
        }
        return probe;
    }

    /**
     * Widens the bounds of a whole segment to hold every place on it as it is stored: enclosures are rounded outward by more
     * where coordinates are larger, and parts of groups and corners of meshes are rounded when they are placed. At an
     * accuracy below EXACT they also hold whatever a sweep of the objects themselves may stop before.
     *
     * @param more how much more to widen them, for a clearance
     */
    void around(double[] box, double[] out, double more) {
        double slack = more + (view.accuracy == Accuracy.EXACT ? STORED : EARLY) * size(box) + Double.MIN_NORMAL;
        for (int k = 0; k < 3; k++) {
            out[k] = box[k] - slack;
            out[3 + k] = box[3 + k] + slack;
        }
    }

    /** Writes {@link #atLast}: the end of the whole segment, whatever was asked since. */
    void placeEnd() {
        placeAt(1, between);
        form.place(view.dimension, between[0], between[1], between[2], between, 3, atLast, 0);
    }

    /** What stands for the object at the end; valid until the next call. */
    LeafColumn atEnd() {
        form.place(view.dimension, end[0], end[1], end[2], end, 3, probe, 0);
        probed = Double.NaN;
        return probe;
    }

    /** The object itself at the start; valid until the next call. */
    LeafColumn exactAtStart() {
        return exactAt(start);
    }

    /** The object itself at the end; valid until the next call. */
    LeafColumn exactAtEnd() {
        return exactAt(end);
    }

    /** The object itself after a share of the segment; valid until the next call. */
    LeafColumn exactAfter(double share) {
        placeAt(share, between);
        return exactAt(between);
    }

    private LeafColumn exactAt(double[] place) {
        form.own.place(place[0], place[1], place[2], place, 3, exact, 0);
        return exact;
    }
}
