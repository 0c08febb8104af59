package robosim.geometry.world.check;

import java.util.Arrays;
import java.util.BitSet;
import java.util.Objects;
import robosim.geometry.Geometry;
import robosim.geometry.MoveResult;
import robosim.geometry.check.Checks;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Bounds;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;

/** What one robot can do on a grid among static objects: step, turn, and go straight to another robot. */
final class RobotSteps {
    /** Numbers of an edge: X, Y, Z and heading at each end. */
    private static final int EDGE = 8;

    /** How far in steps around a place is looked, first where nothing is known, then where that much is free. */
    private static final double[] LOOKS = {1.5, 4, 16};

    /** Of the size of the world: far above the error of any place or clearance, which is that of a few roundings. */
    private static final double ROUNDED = 1e-11;

    /** As much as rounding can shorten a difference. */
    private static final double OUTWARDS = 1 + 0x1p-50;

    private final Geometry geometry;

    /** The static objects without the robot. */
    private final Geometry statics;

    private final PlaceGrid grid;
    private final GeometryObject body;
    private final String name;
    private final boolean upright;

    /** How far the body reaches from its centre seen from above, at any heading. */
    private final double reach;

    /** Twice as far as the body reaches up or down from its centre. */
    private final double height;

    private final double slack;
    private final boolean looks;

    /** States in which the body cannot stand. */
    private final BitSet blocked = new BitSet();

    private final int[] asked = new int[4];
    private final double[] edges = new double[4 * EDGE];
    private final long[] bits = new long[1];

    /**
     * Steps of a robot.
     *
     * @param geometry of the static objects, with the robot
     * @param statics  of the static objects alone
     */
    RobotSteps(Geometry geometry, Geometry statics, PlaceGrid grid, GeometryObject body) {
        this.geometry = geometry;
        this.statics = statics;
        this.grid = grid;
        this.body = body;
        name = String.valueOf(body.name());
        upright = body.pose().isUpright();
        Point c = body.center();
        Bounds bounds = body.bounds();
        slack = ROUNDED * (geometry.width() + geometry.height() + geometry.length());
        reach = StrictMath.hypot(
                        Math.max(bounds.maxX() - c.x(), c.x() - bounds.minX()),
                        Math.max(bounds.maxZ() - c.z(), c.z() - bounds.minZ()))
                + slack;
        height = 2 * Math.max(bounds.maxY() - c.y(), c.y() - bounds.minY()) * OUTWARDS;
        // At other levels an enclosure stands for the body, which may extend beyond that of a box around it.
        looks = geometry.accuracy() == Accuracy.EXACT && height <= Checks.LIMIT;
    }

    /**
     * How far around the body's circle a box is free. If it is at least 0, the body may turn there, and may go so far in any
     * direction. A look is one test of a box, which is fast among meshes too, and spares the sweeps of all moves that it
     * covers.
     *
     * @param known such a number, negative if none is known
     * @return such a number, negative if nothing follows
     */
    double clearance(int state, double known) {
        double clearance = known;
        for (double look : LOOKS) {
            double wanted = looks ? Math.min(look * grid.step, border(state)) : -1;
            if (clearance > grid.step || wanted <= clearance || !isFreeAround(state, wanted)) {
                break;
            }
            clearance = wanted;
        }
        return clearance;
    }

    /** Whether the body's own circle is free, so that it may turn there. */
    boolean isFreeAround(int state) {
        return looks && border(state) >= 0 && isFreeAround(state, 0);
    }

    /** How far the body's circle is from the world's border. */
    private double border(int state) {
        return Math.min(geometry.width() / 2 - Math.abs(grid.x(state)), geometry.length() / 2 - Math.abs(grid.z(state)))
                - reach;
    }

    private boolean isFreeAround(int state, double clearance) {
        double side = 2 * (reach + clearance + slack);
        return !statics.testObject(new BoxObject(grid.center(state), side, height, side));
    }

    /**
     * Which of some straight moves are free.
     *
     * @param to   where they end, negative where there is none to ask; those that are not free are made negative
     */
    void slide(int from, int[] to) {
        int count = 0;
        for (int k = 0; k < to.length; k++) {
            if (to[k] >= 0 && upright && canStand(to[k])) {
                edge(from, to[k], grid.heading(to[k]), count);
                asked[count++] = k;
            } else if (upright || (to[k] >= 0 && !(put(from) && slides(from, to[k])))) {
                to[k] = -1;
            }
        }
        if (count > 0) {
            free(count);
            for (int k = 0; k < count; k++) {
                if ((bits[0] >>> k & 1) == 0) {
                    to[asked[k]] = -1;
                }
            }
        }
    }

    /** Whether a turn in place is free, from one state to another at the same place. */
    boolean turn(int from, int to, double degrees) {
        if (!canStand(to)) {
            return false;
        }
        edge(from, to, grid.heading(from) + degrees, 0);
        free(1);
        return (bits[0] & 1) != 0;
    }

    private void free(int count) {
        geometry.freeEdges(name, count == asked.length ? edges : Arrays.copyOf(edges, EDGE * count), bits);
    }

    private void edge(int from, int to, double heading, int number) {
        int at = EDGE * number;
        pose(from, grid.heading(from), edges, at);
        pose(to, heading, edges, at + EDGE / 2);
    }

    private void pose(int state, double heading, double[] poses, int at) {
        poses[at] = grid.x(state);
        poses[at + 1] = body.center().y();
        poses[at + 2] = grid.z(state);
        poses[at + 3] = heading;
    }

    /** Whether the body touches nothing in a state; each is asked once if it does. */
    private boolean canStand(int state) {
        if (blocked.get(state)) {
            return false;
        }
        double[] pose = new double[EDGE / 2];
        pose(state, grid.heading(state), pose, 0);
        boolean free = geometry.freePoses(name, pose, bits) > 0;
        if (!free) {
            blocked.set(state);
        }
        return free;
    }

    private boolean slides(int from, int to) {
        Move move = new Move(grid.x(to) - grid.x(from), 0, grid.z(to) - grid.z(from), 0, 0);
        return geometry.moveGlobal(name, move).allowed();
    }

    /** Puts the robot there; returns false if rounding makes that place not free. */
    private boolean put(int state) {
        Point at = grid.center(state);
        if (upright) {
            return geometry.placeObject(name, at, grid.heading(state));
        }
        // Only upright objects can be placed.
        geometry.removeObject(name);
        boolean free = geometry.addObject(body.movedTo(at));
        if (!free) {
            geometry.addObjectUnchecked(body);
        }
        return free;
    }

    /**
     * Whether the body, moving straight from there to the other's place, hits the other before anything else: at its
     * own height first, and then up or down if it has passed the other.
     */
    boolean meets(int state, GeometryObject other) {
        if (!put(state) || !geometry.addObjectUnchecked(other)) {
            return false;
        }
        try {
            if (!put(state)) {
                return true; // it overlaps the other
            }
            Point from = geometry.getObject(name).center();
            Point to = other.center();
            MoveResult across = geometry.moveGlobal(name, new Move(to.x() - from.x(), 0, to.z() - from.z(), 0, 0));
            if (!across.allowed() || geometry.dimension() == Dimension.PLANAR) {
                return across.allowed() || isBlockedBy(other, across);
            }
            MoveResult vertical = geometry.moveGlobal(name, new Move(0, to.y() - from.y(), 0, 0, 0));
            return vertical.allowed() || isBlockedBy(other, vertical);
        } finally {
            geometry.removeObject(String.valueOf(other.name()));
        }
    }

    private static boolean isBlockedBy(GeometryObject other, MoveResult refused) {
        GeometryObject obstacle = refused.obstacle();
        return obstacle != null && Objects.equals(obstacle.name(), other.name());
    }
}
