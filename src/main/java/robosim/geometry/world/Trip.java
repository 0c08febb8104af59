package robosim.geometry.world;

import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.function.IntConsumer;
import robosim.geometry.Geometry;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;
import robosim.geometry.model.SphereObject;

/** Where one robot gets to on a grid of straight moves and turns by 45 degrees, among static objects alone. */
final class Trip {
    private static final int TURNS = 8;
    private static final double TURN = 360.0 / TURNS;

    /** Most places and headings of a grid: some seconds among boxes and cylinders, most of a minute among large meshes. */
    private static final double MOST = 60_000;

    /** A robot without an extent goes in steps of this share of the world. */
    private static final double POINT_STEP = 1.0 / 256;

    private final World world;
    private final Geometry geometry;
    private final GeometryObject body;
    private final String name;
    private final Enclosure enclosure;
    private final boolean upright;
    private final int turns;
    private final double step;

    /** Places along X and Z, and how many of them come before the robot's own. */
    private final int countX;

    private final int countZ;
    private final int beforeX;
    private final int beforeZ;

    private final BitSet seen = new BitSet();
    private int[] queue = new int[1024];
    private int queued;
    private double heading;
    private int places;
    private int leastX;
    private int leastZ;
    private int mostX;
    private int mostZ;

    /** @param halvings of the first step */
    Trip(World world, Geometry geometry, GeometryObject robot, int halvings) {
        this.world = world;
        this.geometry = geometry;
        this.body = robot;
        this.name = String.valueOf(robot.name());
        this.enclosure = Enclosure.of(robot);
        this.upright = robot.pose().isUpright();
        boolean round = robot instanceof SphereObject || (robot instanceof CylinderObject && upright);
        this.turns = round || !upright ? 1 : TURNS;
        double shortest = Math.min(world.width(), world.length());
        double wanted = enclosure.narrow() > 0 ? enclosure.narrow() / 2 : shortest * POINT_STEP;
        double affordable = Math.max(
                Math.sqrt(world.width() / MOST) * Math.sqrt(world.length()) * Math.sqrt(turns),
                Math.max(world.width(), world.length()) / MOST * turns);
        step = Math.max(StrictMath.scalb(wanted, -halvings), affordable);
        Point c = robot.center();
        beforeX = steps(c.x() + world.width() / 2);
        beforeZ = steps(c.z() + world.length() / 2);
        countX = beforeX + steps(world.width() / 2 - c.x()) + 1;
        countZ = beforeZ + steps(world.length() / 2 - c.z()) + 1;
    }

    private int steps(double way) {
        return (int) Math.max(0, Math.floor(way / step));
    }

    double step() {
        return step;
    }

    int places() {
        return places;
    }

    double area() {
        return places * step * step;
    }

    WorldCheck.Room room(List<String> names) {
        double half = enclosure.narrow() / 2;
        return new WorldCheck.Room(
                names, x(leastX) - half, z(leastZ) - half, x(mostX) + half, z(mostZ) + half, area(), places, step);
    }

    private double x(int i) {
        return body.center().x() + (i - beforeX) * step;
    }

    private double z(int i) {
        return body.center().z() + (i - beforeZ) * step;
    }

    /**
     * Goes everywhere.
     *
     * @param others robots to be met
     * @param met    told the number of each that is
     */
    void go(List<GeometryObject> others, IntConsumer met, WorldCheck.Watch watch) {
        if (!geometry.addObjectUnchecked(body)) {
            throw new IllegalStateException("it does not stand within the world: " + body);
        }
        try {
            start();
            BitSet placesSeen = new BitSet();
            BitSet missing = new BitSet();
            missing.set(0, others.size());
            int turned = 0;
            for (int at = 0; at < queued; at++) {
                watch.at("the ways of " + name, at, (long) countX * countZ * turns);
                int state = queue[at];
                int place = state / turns;
                if (!placesSeen.get(place)) {
                    placesSeen.set(place);
                    count(place / countZ, place % countZ);
                    meet(place, others, missing, met);
                }
                spread(state);
                // Turns cost most: only where no straight way leads on.
                while (turns > 1 && at == queued - 1 && turned < queued) {
                    turn(queue[turned++]);
                }
            }
        } finally {
            geometry.removeObject(name);
        }
    }

    private void start() {
        leastX = mostX = beforeX;
        leastZ = mostZ = beforeZ;
        heading = body.heading();
        double square = Math.rint(heading / TURN) * TURN;
        // A crooked start is put straight where there is room for that.
        if (turns > 1 && square != heading && geometry.simpleTurn(name, square - heading)) {
            heading = square;
        }
        enqueue((beforeX * countZ + beforeZ) * turns);
    }

    private void count(int i, int j) {
        places++;
        leastX = Math.min(leastX, i);
        mostX = Math.max(mostX, i);
        leastZ = Math.min(leastZ, j);
        mostZ = Math.max(mostZ, j);
    }

    private void enqueue(int state) {
        seen.set(state);
        if (queued == queue.length) {
            queue = Arrays.copyOf(queue, 2 * queued);
        }
        queue[queued++] = state;
    }

    private void spread(int state) {
        int place = state / turns;
        int i = place / countZ;
        int j = place % countZ;
        attempt(state, i > 0, state - countZ * turns, -step, 0);
        attempt(state, i + 1 < countX, state + countZ * turns, step, 0);
        attempt(state, j > 0, state - turns, 0, -step);
        attempt(state, j + 1 < countZ, state + turns, 0, step);
    }

    private void turn(int state) {
        int turn = state % turns;
        attemptTurn(state, state - turn + (turn + 1) % turns, TURN);
        attemptTurn(state, state - turn + (turn + turns - 1) % turns, -TURN);
    }

    private void attempt(int from, boolean exists, int to, double dx, double dz) {
        if (exists
                && !seen.get(to)
                && put(from)
                && geometry.moveGlobal(name, new Move(dx, 0, dz, 0, 0)).allowed()) {
            enqueue(to);
        }
    }

    private void attemptTurn(int from, int to, double degrees) {
        // Whether it may stand there at all is soon told.
        if (!seen.get(to) && put(to) && put(from) && geometry.simpleTurn(name, degrees)) {
            enqueue(to);
        }
    }

    /** Puts the robot at a place of the grid with a heading; false where it may not stand there by a rounding. */
    private boolean put(int state) {
        int place = state / turns;
        Point at = new Point(x(place / countZ), body.center().y(), z(place % countZ));
        if (upright) {
            return geometry.placeObject(name, at, heading + TURN * (state % turns));
        }
        // Only what is upright can be placed.
        geometry.removeObject(name);
        boolean free = geometry.addObject(body.movedTo(at));
        if (!free) {
            geometry.addObjectUnchecked(body);
        }
        return free;
    }

    private void meet(int place, List<GeometryObject> others, BitSet missing, IntConsumer met) {
        double x = x(place / countZ);
        double z = z(place % countZ);
        for (int k = missing.nextSetBit(0); k >= 0; k = missing.nextSetBit(k + 1)) {
            Point other = others.get(k).center();
            double near = (enclosure.diagonal() + Enclosure.of(others.get(k)).diagonal()) / 2 + 2 * step;
            if (Math.abs(other.x() - x) <= near
                    && Math.abs(other.z() - z) <= near
                    && isBetweenNothing(x, z, other, near)) {
                missing.clear(k);
                met.accept(k);
            }
        }
    }

    private boolean isBetweenNothing(double x, double z, Point other, double near) {
        double dx = other.x() - x;
        double dy = world.dimension() == Dimension.PLANAR
                ? 0
                : other.y() - body.center().y();
        double dz = other.z() - z;
        if (StrictMath.hypot(dx, dz) > near) {
            return false;
        }
        if (dx == 0 && dy == 0 && dz == 0) {
            return true;
        }
        Ray ray = new Ray(new Point(x, body.center().y(), z), new Point(dx, dy, dz));
        double way = Math.sqrt(dx * dx + dy * dy + dz * dz);
        return geometry.getRayDistance(ray, 0, way, 0, name) == Double.POSITIVE_INFINITY;
    }
}
