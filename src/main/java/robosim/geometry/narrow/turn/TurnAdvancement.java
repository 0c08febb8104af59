package robosim.geometry.narrow.turn;

import robosim.geometry.exact.Degrees;
import robosim.geometry.exact.ExactVector;
import robosim.geometry.exact.Radians;
import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.gjk.Gjk;
import robosim.geometry.narrow.gjk.GjkScratch;
import robosim.geometry.narrow.gjk.Penetration;
import robosim.geometry.narrow.leaf.FeatureDirections;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.MovedLeaf;
import robosim.geometry.narrow.overlap.ConvexOverlap;
import robosim.geometry.narrow.sweep.StartGap;

/**
 * A leaf of any kind turned about any axis, against one at rest: conservative advancement with fixed separating axes.
 *
 * <p>At an angle a separating axis is found and kept fixed, once in the world, where the mover's points follow
 * sinusoids, and once in the mover, where the other's do. The turn is free for as long as the better of the two still
 * separates; then the next axis is searched. If that is soon, the normals of sides, the directions perpendicular to an
 * edge of each ({@link EdgeCrossTurn}), which turn with both, and the axis made perpendicular to each edge are tried too.
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

    private final TurnBody mover = new TurnBody();
    private final TurnBody rest = new TurnBody();
    private final Leaf pose = new Leaf();

    private final FeatureDirections ofRest = new FeatureDirections();
    private final FeatureDirections ofMover = new FeatureDirections();
    private final EdgeCrossTurn across = new EdgeCrossTurn();
    private final StartGap startGap = new StartGap();
    private final StartGap.Motion keepsOff = this::notes;
    private final double[] towards = new double[3];
    private final double[] axis = new double[3];
    private double rising;

    /** Whether to go on by the smallest steps while the gap grows. */
    private boolean isPatient;

    private boolean haveFacets;
    private int steps;

    private boolean planar;
    private double wx;
    private double wy;
    private double wz;

    /** As {@link SpatialTurnSweep#free} and {@link PlanarTurnSweep#free}. */
    double free(
            boolean inPlane,
            Leaf a,
            double px,
            double py,
            double pz,
            double axisX,
            double axisY,
            double axisZ,
            double degrees,
            Leaf b,
            TurnScratch s) {
        Gjk gjk = s.gjk.pair;
        Penetration ways = s.gjk.penetration();
        double way = degrees < 0 ? -1 : 1;
        planar = inPlane;
        wx = way * axisX;
        wy = way * axisY;
        wz = way * axisZ;
        mover.level = planar && wx == 0 && wz == 0;
        rest.level = mover.level;
        mover.load(a, px, py, pz, wx, wy, wz);
        rest.load(b, px, py, pz, wx, wy, wz);
        double angle = Degrees.toRadians(Math.abs(degrees));
        double t = 0;
        double depth = 0;
        haveFacets = false;
        ask(gjk, a, b);
        boolean isContact = !(gjk.lower() > 0);
        boolean isNear = isNear(gjk);
        if (isContact) {
            depth = Math.max(0, depth(ways, a, b));
            t = fromContact(ways);
        }
        if (!isContact || t > 0) {
            t = advance(a, px, py, pz, b, t, angle, depth, s.gjk);
        }
        if (!TurningPolygon.covers(t, angle) && isNear && !(isContact && isTouching(a, b, s))) {
            double rising = fromNear(a, b);
            if (TurningPolygon.covers(rising, angle)) {
                return Double.POSITIVE_INFINITY;
            }
            if (t < STALLED) {
                isPatient = true;
                t = Math.max(t, advance(a, px, py, pz, b, Math.max(t, rising), angle, 0, s.gjk));
                isPatient = false;
            }
        }
        return TurningPolygon.covers(t, angle) ? Double.POSITIVE_INFINITY : TurningPolygon.fraction(t, angle);
    }

    /** Goes on from an angle that is free up to there, with a depth allowed for; infinite where all that is angle is free. */
    private double advance(
            Leaf a, double px, double py, double pz, Leaf b, double from, double angle, double depth, GjkScratch s) {
        Gjk gjk = s.pair;
        Penetration ways = s.penetration();
        double t = from;
        double widest = 0;
        for (steps = 0; steps < MOST_STEPS; steps++) {
            s.leaf.work.take();
            if (TurningPolygon.covers(t, angle)) {
                return Double.POSITIVE_INFINITY;
            }
            pose(a, px, py, pz, t);
            ask(gjk, pose, b);
            double next = t;
            if (gjk.lower() > 0) {
                next = found(gjk, a, b, t, angle, depth);
            }
            // Without progress there is contact, or a bracket of round shapes that is still open.
            boolean isClose = gjk.upper() + depth < CLOSE * mover.extent;
            if (!(next - t > STALLED) && depth == 0 && !isClose && !gjk.isClosed() && gjk.close() > 0) {
                next = Math.max(next, found(gjk, a, b, t, angle, depth));
            }
            double gap = gjk.lower() > 0 ? gjk.upper() : 0;
            if (gap == 0 && depth > 0) {
                depth(ways, pose, b);
                for (int k = 0; k < ways.count(); k++) {
                    next = Math.max(next, hold(ways.nx(k), ways.ny(k), ways.nz(k), t, depth));
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
    private boolean isNear(Gjk gjk) {
        towards[0] = gjk.nx();
        towards[1] = gjk.ny();
        towards[2] = gjk.nz();
        boolean isDirection = towards[0] != 0 || towards[1] != 0 || towards[2] != 0;
        return isDirection && !gjk.isDeep() && gjk.lower() < NEAR * mover.extent + NEAR_COORDINATES * rest.extent;
    }

    /** Whether the two certainly touch at the start. */
    private boolean isTouching(Leaf a, Leaf b, TurnScratch s) {
        return a.kind.isEnclosure()
                || b.kind.isEnclosure()
                || (ConvexOverlap.test(planar ? Dimension.PLANAR : Dimension.SPATIAL, a, b, s.overlap)
                        && !s.overlap.uncertain);
    }

    /**
     * A start from a gap too small to resolve, taken as a contact: the angle until which some plane, which certainly separates
     * the two at the start, is not approached.
     */
    private double fromNear(Leaf a, Leaf b) {
        startGap.between(planar, a, b);
        rising = planar ? 0 : alongEdges(a, b);
        axis[0] = wx;
        axis[1] = wy;
        axis[2] = wz;
        startGap.isSettled(towards, axis, keepsOff);
        return rising;
    }

    /**
     * The same in space for the directions across an edge of each, which turn with both: as long as the edges are far from
     * parallel, as the direction across parallel ones is none.
     */
    private double alongEdges(Leaf a, Leaf b) {
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
            across.aim(rest, ex, ey, ez, mover, fx, fy, fz, wx, wy, wz, way);
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
    private double found(Gjk gjk, Leaf a, Leaf b, double t, double angle, double depth) {
        double next = hold(gjk.nx(), gjk.ny(), gjk.nz(), t, depth);
        if (next - t < FAR && !TurningPolygon.covers(next, angle) && !planar) {
            if (!haveFacets) {
                ofMover.spatial(a);
                ofRest.spatial(b);
                haveFacets = true;
            }
            next = Math.max(next, near(gjk.nx(), gjk.ny(), gjk.nz(), t, depth));
        }
        return next;
    }

    /** The number of steps of the last query. */
    int steps() {
        return steps;
    }

    private void ask(Gjk gjk, Leaf a, Leaf b) {
        if (planar) {
            gjk.planar(a, b);
        } else {
            gjk.spatial(a, b);
        }
    }

    private double depth(Penetration ways, Leaf a, Leaf b) {
        return planar ? ways.planar(a, b) : ways.spatial(a, b);
    }

    private void pose(Leaf leaf, double px, double py, double pz, double t) {
        double cos = Radians.cos(t);
        double sin = Radians.sin(t);
        MovedLeaf.turned(leaf, px, py, pz, wx, wy, wz, cos, sin, pose);
    }

    /**
     * The angle until which the depth along a direction from the other to the mover, found at t, stays within a limit.
     */
    private double hold(double nx, double ny, double nz, double t, double depth) {
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
     *
     * @param nx the direction that is off
     */
    private double near(double nx, double ny, double nz, double t, double depth) {
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
                across.aim(rest, ex, ey, ez, mover, fx, fy, fz, wx, wy, wz, way);
                end = Math.max(end, across.until(t));
                double length = Math.sqrt(cx * cx + cy * cy + cz * cz);
                if (length < NEARLY && length > PARALLEL) {
                    end = Math.max(end, side(nx, ny, nz, cx / length, cy / length, cz / length, t, depth));
                }
            }
            end = Math.max(end, square(nx, ny, nz, ex, ey, ez, t, depth));
        }
        for (int m = 0; m < ofMover.edges; m++) {
            turned(ofMover.edgeX[m], ofMover.edgeY[m], ofMover.edgeZ[m], cos, sin);
            end = Math.max(end, square(nx, ny, nz, vx, vy, vz, t, depth));
        }
        for (int k = 0; k < ofRest.faces; k++) {
            end = Math.max(end, side(nx, ny, nz, ofRest.faceX[k], ofRest.faceY[k], ofRest.faceZ[k], t, depth));
        }
        for (int m = 0; m < ofMover.faces; m++) {
            turned(ofMover.faceX[m], ofMover.faceY[m], ofMover.faceZ[m], cos, sin);
            end = Math.max(end, side(nx, ny, nz, vx, vy, vz, t, depth));
        }
        return end;
    }

    /** Tries a side's normal as a fixed axis. */
    private double side(double nx, double ny, double nz, double x, double y, double z, double t, double depth) {
        double way = nx * x + ny * y + nz * z < 0 ? -1 : 1;
        return hold(way * x, way * y, way * z, t, depth);
    }

    /** Tries the component of a direction perpendicular to an edge as a fixed axis. */
    private double square(double nx, double ny, double nz, double ex, double ey, double ez, double t, double depth) {
        double along = nx * ex + ny * ey + nz * ez;
        double x = nx - along * ex;
        double y = ny - along * ey;
        double z = nz - along * ez;
        double length = Math.sqrt(x * x + y * y + z * z);
        return length > SQUARE ? hold(x / length, y / length, z / length, t, depth) : t;
    }

    private double vx;
    private double vy;
    private double vz;

    /** Finds (vx, vy, vz), a direction of the mover turned. */
    private void turned(double x, double y, double z, double cos, double sin) {
        double along = (wx * x + wy * y + wz * z) * (1 - cos);
        vx = x * cos + (wy * z - wz * y) * sin + wx * along;
        vy = y * cos + (wz * x - wx * z) * sin + wy * along;
        vz = z * cos + (wx * y - wy * x) * sin + wz * along;
    }

    private double fromContact(Penetration ways) {
        double best = 0;
        for (int k = 0; k < ways.count(); k++) {
            best = Math.max(best, rises(ways.nx(k), ways.ny(k), ways.nz(k)));
        }
        return best;
    }
}
