package robosim.geometry.engine.motion;

import java.util.Arrays;
import robosim.geometry.engine.broadphase.AccuracyView;
import robosim.geometry.engine.broadphase.Candidates;
import robosim.geometry.engine.objects.ObjectTable;
import robosim.geometry.narrow.Distance;
import robosim.geometry.narrow.StartContacts;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.LeafKind;

/**
 * How far a segment of a motion may go so that the mover keeps a clearance from everything that it would hit or pass by.
 *
 * <p>A piece that is nearer than the clearance at the start holds the mover off by a plane: a motion along the plane or away
 * is free, and so are all pieces behind the plane, such as the next tile of a floor. A motion across it is not.
 *
 * <p>Clearances are kept to rounding on the way and exactly where the mover stops, on the numbers that are stored there. That
 * nothing is hit is not decided here.
 */
final class ClearanceSearch {
    /** A step of the search is shorter by this share, so that its rounding does not take it past the clearance. */
    private static final double SHORTER = 1 - 0x1p-40;

    /** Most steps of the search along a translation, where it converges quadratically, and along a turn. */
    private static final int STEPS = 64;

    private static final int TURN_STEPS = 1000;

    /** A gap is just the clearance if it exceeds it by no more than this share. */
    private static final double LITTLE = 0x1p-10;

    /** What a direction may be off, and a motion along it go across. */
    private static final double ALONG = 0x1p-44;

    /** What sticks out of a plane by this share of its place and size was placed there by rounding. */
    private static final double FLUSH = 0x1p-44;

    /** Numbers of a plane: a normal, how far its piece extends along it, and how much nearer than the clearance that is. */
    private static final int PLANE = 5;

    private final MotionSegment segment;
    private final ObjectTable objects;
    private final NearPairs pairs;
    private final double[] contact = new double[6];
    private final double[] bounds = new double[6];
    private final LeafColumn wall = new LeafColumn(1);

    /** Normals, and how far along them the pieces extend that are nearer than the clearance. */
    private double[] planes = new double[4 * PLANE];

    private int planeCount;
    private double clearance;
    private int first;

    ClearanceSearch(MotionSegment segment, ObjectTable objects, Distance distance) {
        this.segment = segment;
        this.objects = objects;
        pairs = new NearPairs(segment, distance);
    }

    /** For the next search only one piece of one object counts. */
    void only(int object, int leaf, int piece) {
        pairs.only(object, leaf, piece);
    }

    /** The greatest share of the segment, up to a limit, at which the clearance is kept. */
    double share(AccuracyView view, Candidates candidates, StartContacts standing, double gap, double limit) {
        clearance = gap;
        pairs.find(view, candidates, standing, gap);
        findPlanes();
        double least = limit;
        first = -1; // each is searched up to the limit, so that ties are seen
        for (int k = 0; k < pairs.count(); k++) {
            double free = isHeldOff(k, false) ? Double.POSITIVE_INFINITY : free(k, limit);
            if (free < least || (free == least && first >= 0 && isEarlier(k))) {
                least = free;
                first = k;
            }
        }
        return least;
    }

    /** The pairs within a distance at the start of the segment. */
    NearPairs near(AccuracyView view, Candidates candidates, StartContacts standing, double within) {
        pairs.find(view, candidates, standing, within);
        return pairs;
    }

    private boolean isEarlier(int k) {
        return objects.isEarlier(pairs.object(k), pairs.object(first));
    }

    /**
     * Whether some pair, after a share of the segment, is nearer than the clearance although it was not at the start.
     *
     * @param isExact whether pairs count too that the motion passes along at just the clearance, which rounding may lessen
     */
    boolean isCloser(double share, boolean isExact) {
        for (int k = 0; k < pairs.count(); k++) {
            if (pairs.gap(k) >= clearance && !isHeldOff(k, isExact) && pairs.gap(k, share) < clearance) {
                first = first < 0 ? k : first;
                return true;
            }
        }
        return false;
    }

    /** The pair that ends the share found last, or -1. */
    int first() {
        return first;
    }

    NearPairs pairs() {
        return pairs;
    }

    /** Finds the planes of pieces no farther than the clearance that the motion goes along or away from. */
    private void findPlanes() {
        planeCount = 0;
        double most = clearance + FLUSH * (segment.size() + clearance);
        for (int k = 0; k < pairs.count(); k++) {
            double gap = pairs.gap(k);
            if (gap > 0 && gap <= most && !segment.turns()) {
                pairs.contact(k, 0, contact);
                if (ahead() >= -ALONG * segment.longestPath()) {
                    addPlane(pairs.level(k, contact, 3), clearance - gap);
                }
            }
        }
    }

    private double ahead() {
        return segment.displacement(0) * contact[3]
                + segment.displacement(1) * contact[4]
                + segment.displacement(2) * contact[5];
    }

    private void addPlane(double level, double nearer) {
        if (PLANE * planeCount == planes.length) {
            planes = Arrays.copyOf(planes, 2 * planes.length);
        }
        System.arraycopy(contact, 3, planes, PLANE * planeCount, 3);
        planes[PLANE * planeCount + 3] = level;
        planes[PLANE * planeCount + 4] = nearer;
        planeCount++;
    }

    /**
     * Whether the pair's pieces are on two sides of a plane that the motion does not cross, and as far apart along its normal as
     * those are to which it belongs.
     *
     * @param isNearer whether only planes of pieces nearer than the clearance count
     */
    private boolean isHeldOff(int k, boolean isNearer) {
        for (int plane = 0; plane < planeCount; plane++) {
            int at = PLANE * plane;
            if (isNearer && planes[at + 4] <= 0) {
                continue;
            }
            double level = planes[at + 3];
            double above = pairs.ownLevel(k, planes, at);
            double below = pairs.level(k, planes, at);
            double slack = FLUSH * (Math.abs(level) + Math.abs(above) + Math.abs(below) + segment.size());
            double apart = clearance - planes[at + 4];
            if (below <= level + slack && above >= level + apart - slack) {
                return true;
            }
        }
        return false;
    }

    /** The share until the clearance is used up; 0 where it is at the start. */
    private double free(int k, double limit) {
        double gap = pairs.gap(k);
        if (gap == 0) {
            return Double.POSITIVE_INFINITY; // a contact; the sweep decides
        }
        if (gap < clearance) {
            return 0;
        }
        return segment.turns() ? ofTurn(k, limit) : ofTranslation(k, limit);
    }

    /** Newton's method: the gap of convex pieces is a convex function of the share. */
    private double ofTranslation(int k, double limit) {
        double free = 0;
        double gap = pairs.gap(k);
        double part = SHORTER;
        double closing = closing(k, free);
        for (int step = 0; step < STEPS && closing > 0; step++) {
            double next = free + part * (gap - clearance) / closing;
            if (next >= limit) {
                return Double.POSITIVE_INFINITY;
            }
            if (!(next > free)) {
                return free;
            }
            double there = pairs.gap(k, next);
            if (there < clearance) {
                part = Math.max(part / 2, 1 - 2 * (1 - part) - 0x1p-20); // places are rounded when they are stored
                continue;
            }
            free = next;
            gap = there;
            closing = closing(k, free);
        }
        return closing > 0 ? free : Double.POSITIVE_INFINITY;
    }

    /** How much of the gap a whole segment in the direction of the nearest points would take. */
    private double closing(int k, double share) {
        pairs.contact(k, share, contact);
        return -ahead();
    }

    /**
     * Conservative advancement (Mirtich 1996): by steps in none of which the gap can be used up. From just the clearance these
     * would not get anywhere, so there a turn first goes as far as its piece stays beyond a plane.
     */
    private double ofTurn(int k, double limit) {
        double path = segment.longestPath();
        double free = 0;
        double gap = pairs.gap(k);
        if (gap - clearance <= LITTLE * clearance) {
            double beyond = beyondPlane(k);
            if (beyond >= limit) {
                return Double.POSITIVE_INFINITY;
            }
            double there = beyond > 0 ? pairs.gap(k, beyond) : 0;
            free = there >= clearance ? beyond : 0;
            gap = there >= clearance ? there : gap;
        }
        for (int step = 0; step < TURN_STEPS; step++) {
            double next = free + SHORTER * (gap - clearance) / path;
            if (next >= limit) {
                return Double.POSITIVE_INFINITY;
            }
            if (!(next > free)) {
                return free;
            }
            gap = pairs.gap(k, next);
            if (gap < clearance) {
                return free;
            }
            free = next;
        }
        return free;
    }

    /** How far the mover's piece of a pair may turn beside the plane that is as far from the other's piece as the clearance. */
    private double beyondPlane(int k) {
        pairs.contact(k, 0, contact);
        double nx = contact[3];
        double ny = contact[4];
        double nz = contact[5];
        double level = pairs.level(k, contact, 3) + clearance;
        double size = 0;
        segment.atStart.bounds(0, segment.atStart.size(), bounds);
        for (int axis = 0; axis < 3; axis++) {
            double pivot = segment.pivot[axis];
            size += 2 * Math.max(Math.abs(bounds[axis] - pivot), Math.abs(bounds[3 + axis] - pivot));
        }
        // Any two directions that complete the normal: a wall as large as all that the mover may reach.
        boolean isSteep = Math.abs(ny) > 0.5;
        double length = isSteep ? Math.sqrt(ny * ny + nz * nz) : Math.sqrt(nx * nx + nz * nz);
        double ux = isSteep ? 0 : -nz / length;
        double uy = isSteep ? nz / length : 0;
        double uz = isSteep ? -ny / length : nx / length;
        double back = level - size - (nx * segment.pivot[0] + ny * segment.pivot[1] + nz * segment.pivot[2]);
        wall.clear();
        wall.append(1);
        wall.setKind(0, LeafKind.BOX);
        axis(0, nx, ny, nz, size);
        axis(1, ux, uy, uz, size);
        axis(2, ny * uz - nz * uy, nz * ux - nx * uz, nx * uy - ny * ux, size);
        double[] row = wall.rows();
        row[0] = segment.pivot[0] + back * nx;
        row[1] = segment.pivot[1] + back * ny;
        row[2] = segment.pivot[2] + back * nz;
        return pairs.free(k, wall);
    }

    private void axis(int column, double x, double y, double z, double half) {
        double[] row = wall.rows();
        row[3 + column] = half;
        row[Leaf.ROTATION + column] = x;
        row[Leaf.ROTATION + 3 + column] = y;
        row[Leaf.ROTATION + 6 + column] = z;
    }
}
