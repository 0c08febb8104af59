package robosim.geometry.narrow.gjk;

import robosim.geometry.exact.VectorMath;

/**
 * A search for directions in which one leaf gets out of another by a short translation. It finds local minima to some
 * 2^-30 of an angle and adds them to the list of directions: by the corners that a pattern of tries around a direction
 * finds, {@link RimStep} leads from the pattern to the minimum; where it does not, the pattern is drawn closer.
 */
final class DepthSearch {
    private static final int MOST_PROBES = 600;
    private static final double FIRST_STEP = 0.5;
    private static final double LAST_STEP = 0x1p-30;

    /** On a circle: minima at which two corners tie are directions of sides, or across edges, which need no search. */
    private static final double LAST_ON_CIRCLE = 0x1p-8;

    /** A proposal this near, of a method that doubles the digits with each, is the minimum. */
    private static final double MEETS = 0x1p-26;

    private static final int MOST_PROPOSALS = 8;

    /** Around the direction of a flat side a pattern this small does not miss a way down. */
    private static final double CLOSE = 0x1p-8;

    /** Directions tried around an edge before the best is refined, a 15-8-17 triangle's angle apart: 28 degrees. */
    private static final int SPREAD = 13;

    private static final double SPREAD_COS = 15 / 17.0;
    private static final double SPREAD_SIN = 8 / 17.0;

    /** Whether only directions with y = 0 count. */
    boolean flat;

    private final Support first;
    private final Support second;
    private final Directions directions;

    // The current direction of the search.
    private double searchX;
    private double searchY;
    private double searchZ;
    private double searchDepth;
    private int probes;
    private final RimStep rims;
    private boolean isMet;

    /** How often a direction was tried since it was last set. */
    int tries;

    /** The corners found by the last tries around the direction. */
    private final int[] around = new int[4];

    /** For two leaves loaded relative to the same origin and at the same scale; the first is to get out. */
    DepthSearch(Support first, Support second, Directions directions) {
        this.first = first;
        this.second = second;
        this.directions = directions;
        this.rims = new RimStep(first, second);
    }

    /** How far a has to move along a unit direction until the supporting planes meet. */
    double depth(double dx, double dy, double dz) {
        find(dx, dy, dz);
        return dx * (second.x - first.x)
                + dy * (second.y - first.y)
                + dz * (second.z - first.z)
                + first.margin
                + second.margin;
    }

    private void find(double dx, double dy, double dz) {
        first.find(-dx, -dy, -dz);
        second.find(dx, dy, dz);
    }

    /** Searches the circle perpendicular to a unit direction, from the best of some directions spread over it. */
    void circle(double ex, double ey, double ez) {
        double tx = ez;
        double ty = 0;
        double tz = -ex;
        if (Math.abs(ex) + Math.abs(ez) < 0x1p-10) {
            tx = 1;
            ty = -ex / ey;
            tz = 0;
        }
        double length = Math.sqrt(tx * tx + ty * ty + tz * tz);
        tx /= length;
        ty /= length;
        tz /= length;
        double sx = ey * tz - ez * ty;
        double sy = ez * tx - ex * tz;
        double sz = ex * ty - ey * tx;
        searchX = 0; // so that results do not depend on an earlier search
        searchY = 0;
        searchZ = 0;
        searchDepth = Double.POSITIVE_INFINITY;
        double c = 1;
        double s = 0;
        for (int n = 0; n < SPREAD; n++) {
            tryAt(c * tx + s * sx - searchX, c * ty + s * sy - searchY, c * tz + s * sz - searchZ);
            double turned = c * SPREAD_COS - s * SPREAD_SIN;
            s = s * SPREAD_COS + c * SPREAD_SIN;
            c = turned;
        }
        probes = 0;
        for (double step = SPREAD_SIN; step > LAST_ON_CIRCLE && probes < MOST_PROBES; ) {
            double ax = step * (ey * searchZ - ez * searchY);
            double ay = step * (ez * searchX - ex * searchZ);
            double az = step * (ex * searchY - ey * searchX);
            if (!tryAt(ax, ay, az) && !tryAt(-ax, -ay, -az)) {
                if (meetsOnCircle(ex, ey, ez)) {
                    break;
                }
                step *= 0.5;
            }
        }
        directions.take(searchX, searchY, searchZ, searchDepth);
    }

    /** Searches freely from a unit direction with a given depth, and adds the result. */
    void from(double dx, double dy, double dz, double depth) {
        searchX = dx;
        searchY = dy;
        searchZ = dz;
        searchDepth = depth;
        probes = 0;
        double turnC = 1;
        double turnS = 0;
        for (double step = FIRST_STEP; step > LAST_STEP && probes < MOST_PROBES; ) {
            if (!improve(step, turnC, turnS)) {
                if (meets(step)) {
                    break;
                }
                step *= 0.5;
                // A different star of directions each time, so that no valley stays between its arms.
                double c = 0.8 * turnC - 0.6 * turnS;
                turnS = 0.6 * turnC + 0.8 * turnS;
                turnC = c;
            }
        }
        directions.take(searchX, searchY, searchZ, searchDepth);
    }

    /** Follows the proposals for the corners around as long as they are shallower; whether they end at a minimum. */
    private boolean meets(double step) {
        boolean isClose = step < CLOSE;
        find(searchX, searchY, searchZ);
        for (int k = 0; k < 2; k++) {
            if ((k == 0 ? first : second).isAtCap()) {
                return isClose || rims.isAboveCap(k == 0);
            }
            if (rims.proposeCap(k == 0, searchX, searchY, searchZ)) {
                if (take(rims.dx, rims.dy, rims.dz)) {
                    return false;
                }
                find(searchX, searchY, searchZ);
            }
        }
        for (int n = 0; n < MOST_PROPOSALS; n++) {
            rims.begin(Simplex.corners(first, second));
            for (int each : around) {
                rims.addCorner(each);
            }
            if (!rims.propose(searchX, searchY, searchZ) || !rims.isMost) {
                return false;
            }
            if (isLast()) {
                return isMet && (isClose || rims.meet() < Double.POSITIVE_INFINITY);
            }
        }
        return false;
    }

    /** Tries a proposal; whether it is the last, of a minimum or as it is not shallower. */
    private boolean isLast() {
        isMet = VectorMath.largest(rims.dx - searchX, rims.dy - searchY, rims.dz - searchZ) < MEETS;
        return !take(rims.dx, rims.dy, rims.dz) || isMet;
    }

    private boolean meetsOnCircle(double ex, double ey, double ez) {
        find(searchX, searchY, searchZ);
        for (int n = 0; n < MOST_PROPOSALS; n++) {
            if (!rims.proposeAround(ex, ey, ez, searchX, searchY, searchZ) || !rims.isMost) {
                return false;
            }
            if (isLast()) {
                return isMet;
            }
        }
        return false;
    }

    /** One round of tries around the current direction; moves to the first that is shallower. */
    private boolean improve(double step, double turnC, double turnS) {
        if (flat) {
            return tryAt(-searchZ * step, 0, searchX * step) || tryAt(searchZ * step, 0, -searchX * step);
        }
        // Two perpendicular directions: one horizontal, or along X if the current direction is vertical.
        double tx = -searchZ;
        double tz = searchX;
        double length = Math.sqrt(tx * tx + tz * tz);
        if (length < 0x1p-10) {
            tx = 1;
            tz = 0;
            length = 1;
        }
        tx /= length;
        tz /= length;
        double sx = searchY * tz;
        double sy = searchZ * tx - searchX * tz;
        double sz = -searchY * tx;
        double c = step * turnC;
        double s = step * turnS;
        for (int arm = 0; arm < 4; arm++) {
            if (tryAt(c * tx + s * sx, s * sy, c * tz + s * sz)) {
                return true;
            }
            double swap = c;
            c = -s;
            s = swap;
        }
        return false;
    }

    private boolean tryAt(double offX, double offY, double offZ) {
        double dx = searchX + offX;
        double dy = searchY + offY;
        double dz = searchZ + offZ;
        double length = Math.sqrt(dx * dx + dy * dy + dz * dz);
        dx /= length;
        dy /= length;
        dz /= length;
        boolean isShallower = take(dx, dy, dz);
        around[probes & 3] = Simplex.corners(first, second);
        return isShallower;
    }

    /** Tries a unit direction; moves there if it is shallower. */
    private boolean take(double dx, double dy, double dz) {
        double depth = depth(dx, dy, dz);
        probes++;
        tries++;
        if (!(depth < searchDepth)) {
            return false;
        }
        searchX = dx;
        searchY = dy;
        searchZ = dz;
        searchDepth = depth;
        return true;
    }
}
