package robosim.geometry.engine.motion;

import java.util.Arrays;
import robosim.geometry.engine.objects.ObjectTable;

/**
 * The planes that hold an object off at a place: one for each piece that is about as near as the clearance, unless it lies
 * behind another one's plane, as the other tiles of a flat wall do. Displacements are clipped by all of them at once.
 *
 * <p>All of this is in plain doubles and only chooses where to go; the motion decides how far that is free.
 */
final class SlidePlanes {
    /** Numbers of a plane: a contact point, a unit normal, and how far its piece extends along the normal. */
    private static final int PLANE = 7;

    private static final int NORMAL = 3;
    private static final int LEVEL = 6;

    /** Most planes; further ones are left out, and the motion stops at them. */
    private static final int MOST = 32;

    /** Normals that differ by less, squared, are one plane's. */
    private static final double SAME = 0x1p-40;

    /** A normal that leans by less is that of a vertical wall, for a level displacement. */
    private static final double UPRIGHT = 0x1p-20;

    /** What a displacement may go into a plane by rounding, as a share of its length. */
    private static final double ALONG = 0x1p-44;

    /** What rounding leaves of the part of a displacement that is taken off, as a share of the whole. */
    private static final double CLIPPED = 0x1p-50;

    /** What sticks out of a plane by this share of the sizes was placed there by rounding. */
    private static final double FLUSH = 0x1p-44;

    private final ObjectTable objects;
    private final double[] numbers = new double[MOST * PLANE];
    private final int[] obstacles = new int[MOST];
    private final double[] gaps = new double[MOST];
    private final double[] spreads = new double[MOST];
    private int count;
    private final int[] pairOf = new int[MOST];
    private final HalfSpaces spaces = new HalfSpaces();
    private final double[] one = new double[PLANE];
    private final double[] tried = new double[3];
    /** What the displacement clipped last may go into a plane by. */
    private double clipped;

    private boolean isLevel;
    private boolean isFlat;

    /** The least height of a normal of ground; below 0 there is none. */
    private double ground = -1;

    SlidePlanes(ObjectTable objects) {
        this.objects = objects;
    }

    /**
     * For level displacements surfaces are vertical walls, so that they stay level, except ground: surfaces with normals at
     * least this high; -1 for no ground.
     */
    void walkOn(double leastHeight) {
        ground = leastHeight;
    }

    /**
     * Finds the planes of pairs at the start of a segment.
     *
     * @param level whether displacements are level: then walls that are vertical to rounding are taken as vertical
     * @param flat whether heights do not count
     */
    void find(NearPairs pairs, boolean level, boolean flat, double size) {
        isLevel = level;
        isFlat = flat;
        count = 0;
        for (int k = 0; k < pairs.count() && count < MOST; k++) {
            pairs.contact(k, 0, one);
            straighten();
            one[LEVEL] = pairs.level(k, one, NORMAL);
            double depth = one[LEVEL] - pairs.ownLevel(k, one, NORMAL);
            double slack = FLUSH * (size + Math.abs(one[LEVEL]));
            if (pairs.gap(k) == 0 && depth > 4 * slack) {
                continue; // an overlap, which the motion judges by all the directions out of it
            }
            offer(k, pairs, slack);
        }
    }

    /** Takes a plane, unless its piece is behind one that is there; planes whose pieces are behind it go. */
    private void offer(int k, NearPairs pairs, double slack) {
        for (int p = 0; p < count; p++) {
            if (isSame(p, one, NORMAL) && Math.abs(numbers[PLANE * p + LEVEL] - one[LEVEL]) <= slack + spread(p)) {
                merge(p, pairs.object(k), pairs.gap(k));
                return;
            }
        }
        for (int p = 0; p < count; p++) {
            double level = numbers[PLANE * p + LEVEL];
            int at = PLANE * p + NORMAL;
            if (pairs.level(k, numbers, at) <= level + slack && pairs.ownLevel(k, numbers, at) >= level - slack) {
                return;
            }
        }
        int kept = 0;
        for (int p = 0; p < count; p++) {
            int pair = pairOf[p];
            boolean isBehind = pairs.level(pair, one, NORMAL) <= one[LEVEL] + slack
                    && pairs.ownLevel(pair, one, NORMAL) >= one[LEVEL] - slack;
            if (!isBehind) {
                copy(p, kept++);
            }
        }
        count = kept;
        put(pairs.object(k), pairs.gap(k));
        pairOf[count - 1] = k;
    }

    private void copy(int from, int to) {
        System.arraycopy(numbers, PLANE * from, numbers, PLANE * to, PLANE);
        obstacles[to] = obstacles[from];
        gaps[to] = gaps[from];
        spreads[to] = spreads[from];
        pairOf[to] = pairOf[from];
    }

    private void put(int obstacle, double gap) {
        System.arraycopy(one, 0, numbers, PLANE * count, PLANE);
        obstacles[count] = obstacle;
        gaps[count] = gap;
        spreads[count] = 0;
        count++;
    }

    private void merge(int p, int obstacle, double gap) {
        double spread = 0;
        for (int axis = 0; axis < 3; axis++) {
            spread += Math.abs(numbers[PLANE * p + NORMAL + axis] - one[NORMAL + axis]);
        }
        spreads[p] = Math.max(spreads[p], spread);
        gaps[p] = Math.min(gaps[p], gap);
        if (obstacle >= 0 && objects.isEarlier(obstacle, obstacles[p])) {
            obstacles[p] = obstacle;
            System.arraycopy(one, 0, numbers, PLANE * p, NORMAL);
        }
    }

    private double spread(int p) {
        double size = 0;
        for (int axis = 0; axis < 3; axis++) {
            size += Math.abs(numbers[PLANE * p + axis]);
        }
        return spreads[p] * size;
    }

    /** Adds the plane of a contact at which a motion was blocked, six numbers, unless it is there. */
    void add(int obstacle, double[] contact) {
        System.arraycopy(contact, 0, one, 0, 6);
        straighten();
        for (int p = 0; p < count; p++) {
            if (isSame(p, one, NORMAL)) {
                return;
            }
        }
        if (count < MOST) {
            one[LEVEL] = 0;
            put(obstacle, 0);
        }
    }

    private void straighten() {
        double ny = one[NORMAL + 1];
        double length = Math.sqrt(one[NORMAL] * one[NORMAL] + one[NORMAL + 2] * one[NORMAL + 2]);
        boolean isGround = ground >= 0 && ny >= ground;
        if (isLevel && ny != 0 && length > UPRIGHT && (Math.abs(ny) < UPRIGHT || !isGround)) {
            one[NORMAL + 1] = 0;
            one[NORMAL] /= length;
            one[NORMAL + 2] /= length;
        }
    }

    boolean isSame(int p, double[] normals, int at) {
        double sum = 0;
        for (int axis = 0; axis < 3; axis++) {
            double off = numbers[PLANE * p + NORMAL + axis] - normals[at + axis];
            sum += off * off;
        }
        return sum < SAME;
    }

    int count() {
        return count;
    }

    int obstacle(int p) {
        return obstacles[p];
    }

    /** One of the six numbers of a contact. */
    double contact(int p, int number) {
        return numbers[PLANE * p + number];
    }

    /** Whether a displacement goes into a plane, by more than rounding. */
    boolean isAgainst(int p, double[] way) {
        return gapRate(p, way) < -ALONG * size(way);
    }

    /** The displacement nearest to another one that goes into none of the planes; zero if there is none. */
    void clip(double[] way, double[] out) {
        System.arraycopy(way, 0, out, 0, 3);
        clipped = CLIPPED * size(way);
        if (isFree(way)) {
            return;
        }
        Arrays.fill(out, 0);
        double longest = 0;
        for (int p = 0; p < count; p++) {
            if (isAgainst(p, way)) {
                double into = gapRate(p, way);
                for (int axis = 0; axis < 3; axis++) {
                    tried[axis] = way[axis] - into * normal(p, axis);
                }
                longest = take(longest, out);
                for (int q = 0; q < count; q++) {
                    if (q != p && alongEdge(p, q, way)) {
                        longest = take(longest, out);
                    }
                }
            }
        }
    }

    private double take(double longest, double[] out) {
        double length = size(tried);
        if (length > longest && isFree(tried)) {
            System.arraycopy(tried, 0, out, 0, 3);
            return length;
        }
        return longest;
    }

    private boolean alongEdge(int p, int q, double[] way) {
        double x = normal(p, 1) * normal(q, 2) - normal(p, 2) * normal(q, 1);
        double y = normal(p, 2) * normal(q, 0) - normal(p, 0) * normal(q, 2);
        double z = normal(p, 0) * normal(q, 1) - normal(p, 1) * normal(q, 0);
        double square = x * x + y * y + z * z;
        if (square < SAME) {
            return false;
        }
        double along = (way[0] * x + way[1] * y + way[2] * z) / square;
        tried[0] = along * x;
        tried[1] = along * y;
        tried[2] = along * z;
        return true;
    }

    private boolean isFree(double[] way) {
        for (int p = 0; p < count; p++) {
            if (gapRate(p, way) < -(ALONG + 2 * spreads[p]) * size(way) - clipped) {
                return false;
            }
        }
        return true;
    }

    /**
     * Turns a displacement along planes away from them by what rounding takes it into them.
     *
     * @param share what the normals are off, at least
     * @param least the least length to lean by
     */
    void lean(double[] way, double share, double least) {
        double length = size(way);
        double near = Math.max(0x1p-30, share) * length;
        double[] sum = tried;
        Arrays.fill(sum, 0);
        for (int p = 0; p < count; p++) {
            if (gapRate(p, way) <= near + spreads[p] * length + clipped
                    && !(isLevel && normal(p, 1) != 0 && way[1] == 0)) {
                double by = (share + 2 * spreads[p]) * length + least + 2 * clipped;
                for (int axis = 0; axis < 3; axis++) {
                    sum[axis] += by * normal(p, axis);
                }
            }
        }
        for (int axis = 0; axis < 3; axis++) {
            way[axis] += sum[axis];
        }
    }

    /**
     * The least displacement after which no plane is nearer than a clearance; false if there is none, or none is needed. A level
     * one leaves floors, ceilings and slopes where they are.
     */
    boolean push(double clearance, double more, double[] out) {
        spaces.clear();
        boolean isNeeded = false;
        for (int p = 0; p < count; p++) {
            if (!isLevel || isFlat || normal(p, 1) == 0) {
                double need = clearance - gaps[p];
                isNeeded |= need > 0;
                spaces.add(normal(p, 0), normal(p, 1), normal(p, 2), need > 0 ? need + more : need);
            }
        }
        return isNeeded && spaces.least(out);
    }

    private double normal(int p, int axis) {
        return numbers[PLANE * p + NORMAL + axis];
    }

    private double gapRate(int p, double[] way) {
        return way[0] * normal(p, 0) + way[1] * normal(p, 1) + way[2] * normal(p, 2);
    }

    private static double size(double[] way) {
        return Math.sqrt(way[0] * way[0] + way[1] * way[1] + way[2] * way[2]);
    }
}
