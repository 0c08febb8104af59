package robosim.geometry.narrow.sweep;

import robosim.geometry.exact.Degrees;
import robosim.geometry.exact.ExactVector;
import robosim.geometry.exact.Radians;
import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.gjk.Gjk;
import robosim.geometry.narrow.gjk.Penetration;
import robosim.geometry.narrow.leaf.FeatureDirections;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.MovedLeaf;
import robosim.geometry.narrow.leaf.PivotTurn;
import robosim.geometry.narrow.overlap.ConvexOverlap;
import robosim.geometry.narrow.overlap.OverlapScratch;

/**
 * A leaf of any kind turned about any axis, against one at rest: conservative advancement with fixed separating axes.
 *
 * <p>At an angle a separating axis is found and kept fixed, once in the world, where the mover's points follow
 * sinusoids, and once in the mover, where the other's do. The turn is free for as long as the better of the two still
 * separates; then the next axis is searched. If that is soon, the normals of sides, the directions perpendicular to an
 * edge of each ({@link TurningEdgePair}), which turn with both, and the axis made perpendicular to each edge are tried too.
 * For polytopes these are all axes of the separating-axis theorem, each for as long as it separates; for round shapes
 * the loss from a fixed axis grows with the square of the angle. Only these axes prove anything, with all rounding
 * counted; how they are found does not matter. From contact the same is done with the depth at the start allowed for.
 *
 * <p>If no axis makes progress there is contact, or a gap of at most 2^-30 of the mover's radius, its largest distance
 * from the pivot, and 2^-43 of both leaves' distances from it.
 */
final class TurnAdvancement {
    private static final int MOST_STEPS = 1000;

    /**
     * An axis that separates for an arc as long as this is good enough; else those of the sides and edges are tried.
     */
    private static final double FAR = 0.1;

    /** A gap of this fraction of the mover's size that allows hardly any progress counts as contact. */
    private static final double CLOSE = 0x1p-34;

    private static final double STALLED = 0x1p-16;

    /** A gap up to these shares of the mover's and the other's extent may be left by a turn, and is too small to begin one. */
    private static final double NEAR = 0x1p-30;

    private static final double NEAR_COORDINATES = 0x1p-42;

    /** Edges whose directions have a larger cosine are nearly parallel. */
    private static final double MOST_ALONG = 1 - 0x1p-6;

    /** An edge this close to a direction is not considered perpendicular to it. */
    private static final double SQUARE = 0.5;

    // For nearly parallel edges the direction perpendicular to both is kept fixed too, as the turning one is too
    // inaccurate.
    private static final double NEARLY = 0x1p-8;
    private static final double PARALLEL = 0x1p-40;

    private final TurningLeaf mover = new TurningLeaf();
    private final TurningLeaf rest = new TurningLeaf();
    private final Leaf pose = new Leaf();

    private final FeatureDirections ofRest = new FeatureDirections();
    private final FeatureDirections ofMover = new FeatureDirections();
    private final TurningEdgePair across = new TurningEdgePair(rest, mover);
    private final StartGap startGap = new StartGap();
    private final StartGap.Motion keepsOff = this::notes;
    private final double[] towards = new double[3];
    private final double[] axis = new double[3];
    private double rising;

    /** Whether to go on by the smallest steps while the gap grows. */
    private boolean isPatient;

    private boolean haveFacets;
    private int steps;

    // The query: the mover, the leaf at rest, and the turn by the right hand about its axis.
    private boolean planar;
    private Leaf a = pose;
    private Leaf b = pose;
    private final PivotTurn turn = new PivotTurn();

    @SuppressWarnings("NullAway.Init") // set by each query
    private Gjk gjk;

    @SuppressWarnings("NullAway.Init")
    private Penetration ways;

    /** How much depth is allowed for. */
    private double depth;

    /** As {@link SpatialSweep#turn} and {@link PlanarSweep#turn}. */
    double free(boolean inPlane, Leaf moving, PivotTurn by, Leaf resting, OverlapScratch s) {
        a = moving;
        b = resting;
        gjk = s.gjk.pair;
        ways = s.gjk.penetration();
        double way = by.degrees < 0 ? -1 : 1;
        planar = inPlane;
        turn.about(by.px, by.py, by.pz).by(way * by.wx, way * by.wy, way * by.wz, Math.abs(by.degrees));
        mover.level = planar && turn.isLevel();
        rest.level = mover.level;
        mover.load(a, turn);
        rest.load(b, turn);
        across.about(turn);
        double angle = Degrees.toRadians(turn.degrees);
        double t = 0;
        depth = 0;
        haveFacets = false;
        query(a);
        boolean isContact = !(gjk.lower() > 0);
        boolean isNear = isNear();
        if (isContact) {
            depth = Math.max(0, depth(a));
            t = fromContact();
        }
        if (!isContact || t > 0) {
            t = advance(t, angle, s);
        }
        if (!TurningPolygon.covers(t, angle) && isNear && !(isContact && isTouching(s))) {
            double rising = fromNear();
            if (TurningPolygon.covers(rising, angle)) {
                return Double.POSITIVE_INFINITY;
            }
            if (t < STALLED) {
                isPatient = true;
                depth = 0;
                t = Math.max(t, advance(Math.max(t, rising), angle, s));
                isPatient = false;
            }
        }
        return TurningPolygon.covers(t, angle) ? Double.POSITIVE_INFINITY : TurningPolygon.fraction(t, angle);
    }

    /** Goes on from an angle that is free up to there, with the depth allowed for; infinite where all that is angle is free. */
    private double advance(double from, double angle, OverlapScratch s) {
        double t = from;
        double widest = 0;
        for (steps = 0; steps < MOST_STEPS; steps++) {
            s.leaf.work.take();
            if (TurningPolygon.covers(t, angle)) {
                return Double.POSITIVE_INFINITY;
            }
            MovedLeaf.turned(a, turn, Radians.cos(t), Radians.sin(t), pose);
            query(pose);
            double next = t;
            if (gjk.lower() > 0) {
                next = found(t, angle);
            }
            // Without progress there is contact, or a bracket of round shapes that is still open.
            boolean isClose = gjk.upper() + depth < CLOSE * mover.extent;
            if (!(next - t > STALLED) && depth == 0 && !isClose && !gjk.isClosed() && gjk.close() > 0) {
                next = Math.max(next, found(t, angle));
            }
            double gap = gjk.lower() > 0 ? gjk.upper() : 0;
            if (gap == 0 && depth > 0) {
                depth(pose);
                for (int k = 0; k < ways.count(); k++) {
                    next = Math.max(next, hold(ways.nx(k), ways.ny(k), ways.nz(k), t));
                }
            }
            boolean isOpening = isPatient && gap > widest;
            widest = gap;
            boolean isStalled = gap + depth < CLOSE * mover.extent && next - t < STALLED && !isOpening;
            if (!(next > t) || (isStalled && !TurningPolygon.covers(next, angle))) {
                break;
            }
            t = next;
        }
        return t;
    }

    /** Whether the two start nearer to each other than a turn can resolve, or in contact, and notes the direction. */
    private boolean isNear() {
        towards[0] = gjk.nx();
        towards[1] = gjk.ny();
        towards[2] = gjk.nz();
        boolean isDirection = towards[0] != 0 || towards[1] != 0 || towards[2] != 0;
        return isDirection && !gjk.isDeep() && gjk.lower() < NEAR * mover.extent + NEAR_COORDINATES * rest.extent;
    }

    /** Whether the two certainly touch at the start. */
    private boolean isTouching(OverlapScratch s) {
        return a.kind.isEnclosure()
                || b.kind.isEnclosure()
                || (ConvexOverlap.test(planar ? Dimension.PLANAR : Dimension.SPATIAL, a, b, s) && !s.uncertain);
    }

    /**
     * A start from a gap too small to resolve, taken as a contact: the angle until which some plane, which certainly separates
     * the two at the start, is not approached.
     */
    private double fromNear() {
        startGap.between(planar, a, b);
        rising = planar ? 0 : alongEdges();
        axis[0] = turn.wx;
        axis[1] = turn.wy;
        axis[2] = turn.wz;
        startGap.isSettled(towards, axis, keepsOff);
        return rising;
    }

    /**
     * The same in space for the directions across an edge of each, which turn with both: as long as the edges are far from
     * parallel, as the direction across parallel ones is none.
     */
    private double alongEdges() {
        ofMover.spatial(a);
        ofRest.spatial(b);
        haveFacets = true;
        double best = 0;
        for (int k = 0; k < ofRest.edges; k++) {
            for (int m = 0; m < ofMover.edges; m++) {
                best = Math.max(best, alongEdges(k, m, best));
            }
        }
        return best;
    }

    /** The same for one edge of each; a lesser angle than the given one need not be found. */
    private double alongEdges(int k, int m, double least) {
        double ex = ofRest.edgeX[k];
        double ey = ofRest.edgeY[k];
        double ez = ofRest.edgeZ[k];
        double fx = ofMover.edgeX[m];
        double fy = ofMover.edgeY[m];
        double fz = ofMover.edgeZ[m];
        // The cosine between two directions, of which one turns, changes by no more than the angle.
        double most = MOST_ALONG - Math.abs(ex * fx + ey * fy + ez * fz);
        double best = 0;
        for (int way = -1; way <= 1; way += 2) {
            across.aim(ex, ey, ez, fx, fy, fz, way);
            double end = Math.min(most, across.notNearer());
            if (end > Math.max(least, best) && isApartAcross(ex, ey, ez, way * fx, way * fy, way * fz)) {
                best = end;
            }
        }
        return best;
    }

    /** Whether the two are certainly apart at the start along the cross product of two directions. */
    private boolean isApartAcross(double ex, double ey, double ez, double fx, double fy, double fz) {
        return startGap.isApart(ExactVector.of(ex, ey, ez).cross(ExactVector.of(fx, fy, fz)));
    }

    /** Notes for how long a plane that separates the two at the start is not approached; never settles the question. */
    private boolean notes(ExactVector n, double[] u) {
        double best = rises(u[0], u[1], u[2]);
        if (best > rising && startGap.isApart(n)) {
            rising = best;
        }
        return false;
    }

    /** The angle until which neither leaf comes nearer along a direction, fixed in the world or in the mover. */
    private double rises(double nx, double ny, double nz) {
        mover.aim(nx, ny, nz, 1);
        double best = mover.notFurtherBack();
        if (!planar || mover.level) {
            rest.aim(-nx, -ny, -nz, -1);
            best = Math.max(best, rest.notFurtherBack());
        }
        return best;
    }

    /** How far the axis found, and others near it, separate. */
    private double found(double t, double angle) {
        double next = hold(gjk.nx(), gjk.ny(), gjk.nz(), t);
        if (next - t < FAR && !TurningPolygon.covers(next, angle) && !planar) {
            if (!haveFacets) {
                ofMover.spatial(a);
                ofRest.spatial(b);
                haveFacets = true;
            }
            next = Math.max(next, near(t));
        }
        return next;
    }

    /** The number of steps of the last query. */
    int steps() {
        return steps;
    }

    private void query(Leaf placed) {
        if (planar) {
            gjk.planar(placed, b);
        } else {
            gjk.spatial(placed, b);
        }
    }

    private double depth(Leaf placed) {
        return planar ? ways.planar(placed, b) : ways.spatial(placed, b);
    }

    /**
     * The angle until which the depth along a direction from the other to the mover, found at t, stays within a limit.
     */
    private double hold(double nx, double ny, double nz, double t) {
        rest.aim(-nx, -ny, -nz, 1);
        double place = -rest.least(0) + rest.error() - depth;
        mover.aim(nx, ny, nz, 1);
        double end = mover.until(place, t);
        if (!planar || mover.level) {
            // The direction in the mover as it stood at the start.
            turned(nx, ny, nz, Radians.cos(t), -Radians.sin(t));
            double mx = vx;
            double my = vy;
            double mz = vz;
            mover.aim(mx, my, mz, 1);
            place = -mover.least(0) + mover.error() - depth;
            rest.aim(-mx, -my, -mz, -1);
            end = Math.max(end, rest.until(place, t));
        }
        return end;
    }

    /**
     * The same of the directions that sides and edges have at t: close to contact that of {@link Gjk} is off by as much as
     * a rounding is large beside the gap, which counts where a flat side or a straight edge meets something.
     */
    private double near(double t) {
        double nx = gjk.nx();
        double ny = gjk.ny();
        double nz = gjk.nz();
        double end = t;
        double cos = Radians.cos(t);
        double sin = Radians.sin(t);
        for (int k = 0; k < ofRest.edges; k++) {
            double ex = ofRest.edgeX[k];
            double ey = ofRest.edgeY[k];
            double ez = ofRest.edgeZ[k];
            for (int m = 0; m < ofMover.edges; m++) {
                double fx = ofMover.edgeX[m];
                double fy = ofMover.edgeY[m];
                double fz = ofMover.edgeZ[m];
                turned(fx, fy, fz, cos, sin);
                double cx = ey * vz - ez * vy;
                double cy = ez * vx - ex * vz;
                double cz = ex * vy - ey * vx;
                double way = nx * cx + ny * cy + nz * cz < 0 ? -1 : 1;
                across.aim(ex, ey, ez, fx, fy, fz, way);
                end = Math.max(end, across.until(t));
                double length = Math.sqrt(cx * cx + cy * cy + cz * cz);
                if (length < NEARLY && length > PARALLEL) {
                    end = Math.max(end, side(cx / length, cy / length, cz / length, t));
                }
            }
            end = Math.max(end, square(ex, ey, ez, t));
        }
        for (int m = 0; m < ofMover.edges; m++) {
            turned(ofMover.edgeX[m], ofMover.edgeY[m], ofMover.edgeZ[m], cos, sin);
            end = Math.max(end, square(vx, vy, vz, t));
        }
        for (int k = 0; k < ofRest.faces; k++) {
            end = Math.max(end, side(ofRest.faceX[k], ofRest.faceY[k], ofRest.faceZ[k], t));
        }
        for (int m = 0; m < ofMover.faces; m++) {
            turned(ofMover.faceX[m], ofMover.faceY[m], ofMover.faceZ[m], cos, sin);
            end = Math.max(end, side(vx, vy, vz, t));
        }
        return end;
    }

    /** Tries a side's normal as a fixed axis. */
    private double side(double x, double y, double z, double t) {
        double way = gjk.nx() * x + gjk.ny() * y + gjk.nz() * z < 0 ? -1 : 1;
        return hold(way * x, way * y, way * z, t);
    }

    /** Tries the component of the direction found that is perpendicular to an edge as a fixed axis. */
    private double square(double ex, double ey, double ez, double t) {
        double along = gjk.nx() * ex + gjk.ny() * ey + gjk.nz() * ez;
        double x = gjk.nx() - along * ex;
        double y = gjk.ny() - along * ey;
        double z = gjk.nz() - along * ez;
        double length = Math.sqrt(x * x + y * y + z * z);
        return length > SQUARE ? hold(x / length, y / length, z / length, t) : t;
    }

    private double vx;
    private double vy;
    private double vz;

    /** Finds (vx, vy, vz), a direction of the mover turned. */
    private void turned(double x, double y, double z, double cos, double sin) {
        double wx = turn.wx;
        double wy = turn.wy;
        double wz = turn.wz;
        double along = (wx * x + wy * y + wz * z) * (1 - cos);
        vx = x * cos + (wy * z - wz * y) * sin + wx * along;
        vy = y * cos + (wz * x - wx * z) * sin + wy * along;
        vz = z * cos + (wx * y - wy * x) * sin + wz * along;
    }

    private double fromContact() {
        double best = 0;
        for (int k = 0; k < ways.count(); k++) {
            best = Math.max(best, rises(ways.nx(k), ways.ny(k), ways.nz(k)));
        }
        return best;
    }
}
