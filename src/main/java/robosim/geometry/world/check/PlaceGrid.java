package robosim.geometry.world.check;

import robosim.geometry.model.Bounds;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.world.World;

/**
 * The places of a grid that begins at a robot's own, each with the headings that are tried there. A state is a place with
 * a heading, as one number.
 */
final class PlaceGrid {
    private static final int TURNS = 8;

    /** The angle between two headings, degrees. */
    static final double TURN = 360.0 / TURNS;

    final double step;

    /** Number of headings: one for a robot that is round, or that lies on its side. */
    final int turns;

    private final Point start;
    private final int countX;
    private final int countZ;

    /** How many places precede the robot's own. */
    private final int beforeX;

    private final int beforeZ;
    private double heading;

    PlaceGrid(World world, GeometryObject robot, double step) {
        this.step = step;
        turns = turns(robot);
        start = robot.center();
        heading = robot.heading();
        beforeX = steps(start.x() + world.width() / 2);
        beforeZ = steps(start.z() + world.length() / 2);
        countX = beforeX + steps(world.width() / 2 - start.x()) + 1;
        countZ = beforeZ + steps(world.length() / 2 - start.z()) + 1;
    }

    private int steps(double way) {
        return (int) Math.max(0, Math.floor(way / step));
    }

    static int turns(GeometryObject robot) {
        return robot.kind().isRound() || !robot.pose().isUpright() ? 1 : TURNS;
    }

    /** The smaller one of an object's extents along X and Z. */
    static double narrow(GeometryObject object) {
        Bounds bounds = object.bounds();
        return Math.min(bounds.width(), bounds.length());
    }

    /** The diagonal of an object's bounds, seen from above. */
    static double diagonal(GeometryObject object) {
        Bounds bounds = object.bounds();
        return StrictMath.hypot(bounds.width(), bounds.length());
    }

    /** The heading nearest to a given one that is a multiple of the angle between two. */
    static double square(double heading) {
        return Math.rint(heading / TURN) * TURN;
    }

    /** Counts headings from another one. */
    void align(double square) {
        heading = square;
    }

    /** Number of states. */
    long size() {
        return (long) countX * countZ * turns;
    }

    /** The state in which the robot begins. */
    int start() {
        return (beforeX * countZ + beforeZ) * turns;
    }

    int place(int state) {
        return state / turns;
    }

    /**
     * The states one step away, along X, against it, along Z and against it; -1 beyond the grid.
     *
     * @param out four states
     */
    void neighbours(int state, int[] out) {
        int place = state / turns;
        int i = place / countZ;
        int j = place % countZ;
        out[0] = i + 1 < countX ? state + countZ * turns : -1;
        out[1] = i > 0 ? state - countZ * turns : -1;
        out[2] = j + 1 < countZ ? state + turns : -1;
        out[3] = j > 0 ? state - turns : -1;
    }

    /** The state at the same place with the next heading, or with the one before. */
    int turned(int state, boolean isCounterClockwise) {
        int turn = state % turns;
        return state - turn + (turn + (isCounterClockwise ? 1 : turns - 1)) % turns;
    }

    double x(int state) {
        return start.x() + (state / turns / countZ - beforeX) * step;
    }

    double z(int state) {
        return start.z() + (state / turns % countZ - beforeZ) * step;
    }

    /** The robot's centre in a state. */
    Point center(int state) {
        return new Point(x(state), start.y(), z(state));
    }

    double heading(int state) {
        return heading + TURN * (state % turns);
    }
}
