package robosim.geometry.narrow.gjk;

import robosim.geometry.exact.VectorMath;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.PairOrder;

/**
 * Distance between two leaves as a certified bracket, with witness points and a separating direction: the algorithm of
 * Gilbert, Johnson and Keerthi (1988) on the difference set.
 *
 * <p>{@link #lower} is the width of an empty slab between the two, less everything that rounding may have added: if it
 * is above 0 the leaves are apart. {@link #upper} is the distance of two points that belong to the leaves, each off by
 * less than {@link #error}. The two ends meet to within rounding, some 2^-48 of distance and sizes; on round rims the
 * iteration continues until the bracket is below 2^-44 of the distance or of that size. In plain doubles the number of
 * steps is limited, and the iteration ends when the simplex is too thin; the bracket is valid in any case, and {@link
 * #isClosed} says whether it is narrow. {@link #close} continues in double-doubles until it is.
 *
 * <p>(a, b) and (b, a) give the same bits. A query allocates nothing.
 */
public final class Gjk {
    /** Maximum number of steps of a query. Random pairs take at most 16; rims would take some 60 without {@link RimStep}. */
    private static final int MOST_STEPS = 160;

    /**
     * Number of steps without a nearer point after which doubles are considered exhausted. A tilt of 2^-26 against a
     * cap does not change a distance, but does change the slab.
     */
    private static final int MOST_STALLS = 6;

    /** Maximum number of directions that are tried in a row along rims. */
    private static final int MOST_TURNS = 10;

    /** The bracket is narrow enough at this fraction of the distance. */
    private static final double NARROW = 0x1p-44;

    /**
     * Rounding error of the slab n.(a - b) in units of the summed extents, for a direction n whose components'
     * magnitudes sum to at most sqrt(3), in u = 2^-53. Whatever a coordinate found is made of, the difference of a and
     * b adds 1 to it and the dot product 3; of what can make the slab wide, n's length adds 3.5 and the last
     * subtractions 2. To these come:
     *
     * <ul>
     * <li>a centre: 2 in all, 11.5 with the rest;
     * <li>a box's half vectors: 4, and 6 as a sign may be mistaken where the product is within 3 of 0: 14;
     * <li>a triangle's corner: 1, and 6 as another may be taken for the furthest: 16.5;
     * <li>a cylinder's way to its cap: 3, and 8 as the wrong cap may be taken, the axis being off by 1: 15;
     * <li>its rim, times 1 and not sqrt(3), as that is a length: 5 for the length, 3 for what is along the axis, 4.4 as n
     *     across the axis may be off by 2.2, 2 for sums: 18.4.
     * </ul>
     *
     * All are below 28.6. A prism's corners, from bounds that are drawn in twice, are off by 21: 36.5, or 63.2; so its
     * extent counts twice. Seen: a tenth to an eighth of the bound.
     */
    public static final double ROUNDOFF = 32 * 0x1p-53;

    /** Below this size a problem is scaled up before squares are taken. */
    private static final double SMALL = 0x1p-240;

    /**
     * The origin is certainly in a tetrahedron if it cuts it into volumes that are each above this fraction of the
     * cubed extents: each is a sum of six products of three coordinates off by 17u of the extents, so off by less than
     * 6 * 60u = 2^-44.
     */
    static final double DEEP = 0x1p-43;

    final Support first = new Support();
    final Support second = new Support();
    private final Simplex simplex = new Simplex();
    private final RimStep rims = new RimStep(first, second);
    private final DoubleDoubleSimplex fine = new DoubleDoubleSimplex();

    private double lower;
    private double upper;
    private double nx;
    private double ny;
    private double nz;
    private double ax;
    private double ay;
    private double az;
    private double bx;
    private double by;
    private double bz;
    private boolean overlapping;
    private double attained;
    private boolean closed;
    private double error;
    private double reach;
    private double coreReach;
    private double coreUpper;
    private int steps;
    private boolean deep;
    private double ox;
    private double oy;
    private double oz;
    private double unscale;
    private boolean reversed;
    private boolean decides;
    private boolean turned;

    /**
     * Runs a query in space only until it is known whether the two touch: 1 if they certainly do, -1 if they certainly do not,
     * 0 if neither is certain; then it has run to its end, as that of {@link #spatial}.
     */
    public int decide(Leaf a, Leaf b) {
        decides = true;
        query(a, b, false);
        decides = false;
        return lower > 0 ? -1 : deep ? 1 : 0;
    }

    /** Runs a query in space; returns the lower end of the bracket, at least 0. */
    public double spatial(Leaf a, Leaf b) {
        return query(a, b, false);
    }

    /** Runs a query for the projections on XZ; returns the lower end of the bracket, at least 0. All y are 0. */
    public double planar(Leaf a, Leaf b) {
        return query(a, b, true);
    }

    private double query(Leaf a, Leaf b, boolean flat) {
        reversed = PairOrder.isReversed(a, b);
        if (reversed) {
            solve(b, a, flat);
            reverse();
        } else {
            solve(a, b, flat);
        }
        return Math.max(0, lower);
    }

    /** Whether the bracket of the last query is as narrow as stated above, or does not matter since the two overlap. */
    public boolean isClosed() {
        return closed;
    }

    /**
     * If plain doubles lost the simplex of the last query, narrows its bracket as far as the accuracy of the leaves'
     * points allows: continues with a {@link DoubleDoubleSimplex}, in which every step makes progress, until the
     * bracket is closed. Returns the lower end, at least 0.
     */
    public double close() {
        if (reversed) {
            reverse();
        }
        error /= unscale;
        approachFinely();
        finish();
        if (reversed) {
            reverse();
        }
        return Math.max(0, lower);
    }

    /** A lower bound of the distance; if above 0 it proves that the leaves do not touch. May be negative. */
    public double lower() {
        return lower;
    }

    /**
     * The distance of the two witness points, each of which is within {@link #error} of its leaf; 0 for a deep overlap.
     */
    public double upper() {
        return upper;
    }

    /** Whether a common point was found, to within rounding; never together with a positive {@link #lower}. */
    public boolean overlapping() {
        return overlapping;
    }

    /**
     * Unit direction, from b towards a, of the slab that {@link #lower} measures; meaningful only if that is positive.
     */
    public double nx() {
        return nx;
    }

    public double ny() {
        return ny;
    }

    public double nz() {
        return nz;
    }

    /** The witness point of a. */
    public double ax() {
        return ax;
    }

    public double ay() {
        return ay;
    }

    public double az() {
        return az;
    }

    /** The witness point of b. */
    public double bx() {
        return bx;
    }

    public double by() {
        return by;
    }

    public double bz() {
        return bz;
    }

    /** Whether a common point is certain: it lies inside by more than any rounding error. */
    public boolean isDeep() {
        return deep;
    }

    /** The rounding error of the bounds of this query, world units. */
    public double error() {
        return error;
    }

    /** The width of the slab without allowance for rounding: the computed distance. May be negative. */
    public double reach() {
        return reach;
    }

    /** The same without the radii of spheres (discs, in the plane), that is, for their centres. */
    double coreReach() {
        return coreReach;
    }

    /** An upper bound, to within rounding, of the distance that {@link #coreReach} bounds from below. */
    double coreUpper() {
        return coreUpper;
    }

    /** The number of steps of the last query. */
    int steps() {
        return steps;
    }

    private void solve(Leaf a, Leaf b, boolean flat) {
        ox = Support.originX(a.kind, a.row, a.at);
        oy = flat ? 0 : Support.originY(a.kind, a.row, a.at);
        oz = Support.originZ(a.kind, a.row, a.at);
        load(a, b, 1, flat);
        double scale = 1;
        double size = first.extent + second.extent;
        if (size > 0 && size < SMALL) {
            scale = Math.scalb(1.0, Math.min(1000, -Math.getExponent(size)));
            load(a, b, scale, flat);
        }
        error = ROUNDOFF * (first.extent + second.extent);
        unscale = 1 / scale;
        deep = false;
        approach();
        deep |= simplex.depth() > DEEP * cube(first.extent + second.extent);
        finish();
    }

    private void load(Leaf a, Leaf b, double scale, boolean flat) {
        if (flat) {
            first.planar(a.kind, a.row, a.at, ox, oz, scale);
            second.planar(b.kind, b.row, b.at, ox, oz, scale);
        } else {
            first.spatial(a.kind, a.row, a.at, ox, oy, oz, scale);
            second.spatial(b.kind, b.row, b.at, ox, oy, oz, scale);
        }
    }

    /** Finds the point of least norm of the difference set, without radii, and the best slab on the way. */
    private void approach() {
        simplex.clear();
        overlapping = false;
        lower = Double.NEGATIVE_INFINITY;
        upper = Double.POSITIVE_INFINITY;
        attained = Double.POSITIVE_INFINITY;
        double vx = first.centreX - second.centreX;
        double vy = first.centreY - second.centreY;
        double vz = first.centreZ - second.centreZ;
        if (VectorMath.largest(vx, vy, vz) <= error) {
            // Any direction will do to begin with; the square of this one may underflow.
            vx = 1;
            vy = 0;
            vz = 0;
        }
        steps = 1;
        if (meetsAtOnce()) {
            return;
        }
        boolean isRound = !first.isPolytope() || !second.isPolytope();
        double nearest = Double.POSITIVE_INFINITY;
        int stalls = 0;
        for (steps = 1; steps <= MOST_STEPS; steps++) {
            double length = Math.sqrt(vx * vx + vy * vy + vz * vz);
            double reach = probe(vx / length, vy / length, vz / length);
            if (isEnough() || (steps > 1 && upper - reach <= Math.max(NARROW * upper, error))) {
                return;
            }
            turned = false;
            // Later every other step only, so that no bad proposals in a row keep the query from its end.
            // In the plane, a simplex about the origin points out of it, where rims would lead to directions of no
            // meaning.
            if (isRound
                    && !(vy != 0 && first.isFlat())
                    && steps > 1
                    && (steps < MOST_TURNS || (steps & 1) == 0)
                    && followsRims(vx / length, vy / length, vz / length, reach)) {
                return;
            }
            double before = simplex.norm();
            boolean isNearer = simplex.advance(first, second);
            if (turned && !(isNearer && simplex.norm() < before)) {
                first.find(-vx / length, -vy / length, -vz / length);
                second.find(vx / length, vy / length, vz / length);
                isNearer |= simplex.advance(first, second);
            }
            if (!isNearer) {
                return;
            }
            double near = Math.sqrt(simplex.norm());
            // A tetrahedron that seems to contain the origin may be too thin to be sure; the point given by its weights
            // belongs to the set in any case.
            attained = Math.min(attained, simplex.depth() > 0 ? simplex.residual() : near);
            if (near < nearest) {
                nearest = near;
            } else if (++stalls > MOST_STALLS) {
                return; // no further progress beyond rounding
            }
            if (near < upper) {
                upper = near;
                witness();
            }
            if (upper <= error) {
                overlapping = true; // no slab could prove otherwise
                return;
            }
            vx = simplex.vx;
            vy = simplex.vy;
            vz = simplex.vz;
        }
    }

    /** Takes the nearest points of what has a closed form; whether the slab between them ends the query. */
    private boolean meetsAtOnce() {
        double near = rims.meetAtOnce();
        takeRims(near);
        if (isEnough()) {
            return true;
        }
        if (!(near > error && near < Double.POSITIVE_INFINITY)) {
            return false;
        }
        double reach = probe(rims.dx, rims.dy, rims.dz);
        return isEnough() || near - reach <= Math.max(NARROW * near, error);
    }

    /** Whether only the verdict is wanted, and the bracket already decides whether the two touch. */
    private boolean isEnough() {
        double margins = first.margin + second.margin;
        return decides && (lower - margins - error > 0 || attained + error < margins);
    }

    /**
     * Follows the directions in which the features of the simplex are nearest, from a unit direction with its reach, for as
     * long as the slab widens; leaves the points found in the last of these. Returns whether the query is at its end.
     */
    private boolean followsRims(double fromX, double fromY, double fromZ, double before) {
        double dx = fromX;
        double dy = fromY;
        double dz = fromZ;
        double widest = before;
        for (int n = 0; n < 2; n++) {
            if (!rims.proposeCap(n == 0, dx, dy, dz)) {
                continue;
            }
            double reach = probe(rims.dx, rims.dy, rims.dz);
            takeRims(rims.meetCap(n == 0));
            if (isEnough() || upper - reach <= Math.max(NARROW * upper, error)) {
                return true;
            }
            if (reach > widest) {
                dx = rims.dx;
                dy = rims.dy;
                dz = rims.dz;
                widest = reach;
            } else {
                first.find(-dx, -dy, -dz);
                second.find(dx, dy, dz);
            }
        }
        for (int n = 0; n < MOST_TURNS && rims.propose(simplex, dx, dy, dz); n++) {
            double reach = probe(rims.dx, rims.dy, rims.dz);
            takeRims(rims.meet());
            if (isEnough() || upper - reach <= Math.max(NARROW * upper, error) || (reach < 0 && isCommon())) {
                return true;
            }
            if (!(reach > widest)) {
                first.find(-dx, -dy, -dz);
                second.find(dx, dy, dz);
                break;
            }
            dx = rims.dx;
            dy = rims.dy;
            dz = rims.dz;
            widest = reach;
        }
        turned = widest > before;
        return false;
    }

    private void takeRims(double near) {
        if (near < upper) {
            upper = near;
            attained = Math.min(attained, near);
            ax = rims.onA[0];
            ay = rims.onA[1];
            az = rims.onA[2];
            bx = rims.onB[0];
            by = rims.onB[1];
            bz = rims.onB[2];
        }
    }

    /** Whether the middle of the features' nearest points is inside both leaves by more than rounding; takes it if so. */
    private boolean isCommon() {
        double x = 0.5 * rims.onA[0] + 0.5 * rims.onB[0];
        double y = 0.5 * rims.onA[1] + 0.5 * rims.onB[1];
        double z = 0.5 * rims.onA[2] + 0.5 * rims.onB[2];
        if (!first.holds(x, y, z, error) || !second.holds(x, y, z, error)) {
            return false;
        }
        deep = true;
        overlapping = true;
        upper = 0;
        attained = 0;
        ax = x;
        ay = y;
        az = z;
        bx = x;
        by = y;
        bz = z;
        return true;
    }

    /**
     * The same from the best slab on, with the simplex in double-doubles. While the bracket is open, the next point is
     * nearer than the side that it was searched from, so the norm decreases; it ends when the bracket is closed, or
     * when no nearer double exists.
     */
    private void approachFinely() {
        fine.clear();
        double vx = nx;
        double vy = ny;
        double vz = nz;
        lower = Double.NEGATIVE_INFINITY;
        attained = Double.POSITIVE_INFINITY;
        overlapping = false;
        for (steps = 1; ; steps++) {
            double length = Math.sqrt(vx * vx + vy * vy + vz * vz);
            probe(vx / length, vy / length, vz / length);
            if (isNarrow() || attained <= error || !fine.add(first, second) || !fine.reduce()) {
                break;
            }
            attained = fine.length();
            ax = fine.a(0);
            ay = fine.a(1);
            az = fine.a(2);
            bx = fine.b(0);
            by = fine.b(1);
            bz = fine.b(2);
            vx = fine.vx;
            vy = fine.vy;
            vz = fine.vz;
        }
        upper = attained;
        overlapping = attained <= error;
    }

    /** Whether, before margins, the attained distance and the best slab are as close to each other as stated. */
    private boolean isNarrow() {
        return attained < Double.POSITIVE_INFINITY && attained - lower <= Math.max(NARROW * attained, error);
    }

    /** Tries a unit direction: finds both supports, and keeps the slab if it is the widest so far. */
    private double probe(double dx, double dy, double dz) {
        first.find(-dx, -dy, -dz);
        second.find(dx, dy, dz);
        double reach = dx * (first.x - second.x) + dy * (first.y - second.y) + dz * (first.z - second.z);
        if (reach > lower) {
            lower = reach;
            nx = dx;
            ny = dy;
            nz = dz;
        }
        return reach;
    }

    private void witness() {
        ax = simplex.ax();
        ay = simplex.ay();
        az = simplex.az();
        bx = simplex.bx();
        by = simplex.by();
        bz = simplex.bz();
    }

    /** Adds the margins of spheres and discs, and converts back to the world's scale and origin. */
    private void finish() {
        double margins = first.margin + second.margin;
        double near = upper;
        deep |= attained + error < margins;
        closed = deep || attained <= error || isNarrow();
        coreReach = lower * unscale;
        coreUpper = near * unscale;
        reach = (lower - margins) * unscale;
        lower = lower - margins - error;
        upper = deep ? 0 : Math.max(0, attained - margins);
        overlapping = (overlapping || near <= margins) && !(lower > 0);
        // Along the witnesses, not along the slab, since a margin is the same all around.
        double dx = near > 0 ? (bx - ax) / near : 0;
        double dy = near > 0 ? (by - ay) / near : 0;
        double dz = near > 0 ? (bz - az) / near : 0;
        double fromA = Math.min(first.margin, near);
        double fromB = Math.min(second.margin, near);
        ax = ox + (ax + fromA * dx) * unscale;
        ay = oy + (ay + fromA * dy) * unscale;
        az = oz + (az + fromA * dz) * unscale;
        bx = ox + (bx - fromB * dx) * unscale;
        by = oy + (by - fromB * dy) * unscale;
        bz = oz + (bz - fromB * dz) * unscale;
        lower *= unscale;
        upper *= unscale;
        error *= unscale;
    }

    private static double cube(double v) {
        return v * v * v;
    }

    private void reverse() {
        nx = -nx;
        ny = -ny;
        nz = -nz;
        double swap = ax;
        ax = bx;
        bx = swap;
        swap = ay;
        ay = by;
        by = swap;
        swap = az;
        az = bz;
        bz = swap;
    }
}
