package robosim.geometry;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import robosim.geometry.exact.Degrees;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.Ray;
import robosim.geometry.narrow.Border;
import robosim.geometry.narrow.LeafColumn;
import robosim.geometry.narrow.OwnLeaves;
import robosim.geometry.narrow.Scratch;

/**
 * A world: a box centred at the origin with objects in it, and the answers to three questions. May this object be here?
 * How far may it move? How far away is the next surface?
 *
 * <p>Static objects stand in a quadtree, moveable ones in a list. Nothing may be added or moved so that any part of it
 * leaves the world, on the way or at the end: such a call answers false. The border is closed (touching it is inside),
 * is always judged on the exact shape, and echoes nothing. In {@link Dimension#PLANAR} it has no heights.
 *
 * <p>A bad argument throws {@code IllegalArgumentException} with the argument and its value in the message; after any
 * exception the world is as it was. A world belongs to one thread at a time.
 */
public final class Geometry {
    private final double width;
    private final double height;
    private final double length;
    private final Dimension dimension;
    private final Accuracy accuracy;

    private final Bodies bodies = new Bodies();
    private final Border border;

    /** The levels made so far, the world's own first. */
    private Level[] levels;

    private final Level level;
    private final Ranging ranging;
    private final Motion motion;
    private final double[] vector = new double[6];
    private final double[] box = new double[6];

    /** The leaves of an object that is asked about. */
    private final LeafColumn candidate = new LeafColumn(1);

    /** A world of 1000 x 1000 x 1000 world units, SPATIAL and EXACT. */
    public Geometry() {
        this(1000, 1000, 1000);
    }

    /** A SPATIAL and EXACT world of a size along X, Y and Z. */
    public Geometry(double width, double height, double length) {
        this(width, height, length, Dimension.SPATIAL, Accuracy.EXACT);
    }

    /**
     * A world.
     *
     * @param width     its extent along X in world units, above 0 and at most 2<sup>101</sup>
     * @param height    its extent along Y
     * @param length    its extent along Z
     * @param dimension whether heights count
     * @param accuracy  what stands for an object where a query does not say
     */
    public Geometry(double width, double height, double length, Dimension dimension, Accuracy accuracy) {
        this.width = Arguments.worldSize("width", width);
        this.height = Arguments.worldSize("height", height);
        this.length = Arguments.worldSize("length", length);
        this.dimension = Arguments.present("dimension", dimension);
        this.accuracy = Arguments.present("accuracy", accuracy);
        border = new Border(width, height, length, dimension);
        level = new Level(accuracy, dimension, width, length);
        levels = new Level[] {level};
        Scratch scratch = new Scratch();
        ranging = new Ranging(bodies, scratch);
        motion = new Motion(bodies, border, scratch);
    }

    /** Extent along X in world units. */
    public double width() {
        return width;
    }

    /** Extent along Y in world units. */
    public double height() {
        return height;
    }

    /** Extent along Z in world units. */
    public double length() {
        return length;
    }

    /** Whether heights count. */
    public Dimension dimension() {
        return dimension;
    }

    /** What stands for an object where a query does not say. */
    public Accuracy accuracy() {
        return accuracy;
    }

    /**
     * Adds an object where it touches nothing.
     *
     * @return false, and nothing is added, where it would touch or overlap another object or leave the world
     * @throws IllegalArgumentException where its name is taken
     */
    public boolean addObject(GeometryObject object) {
        return add(object, true);
    }

    /**
     * Adds an object even where it overlaps others, as RoboSim's worlds do.
     *
     * @return false, and nothing is added, where it would leave the world
     * @throws IllegalArgumentException where its name is taken
     */
    public boolean addObjectUnchecked(GeometryObject object) {
        return add(object, false);
    }

    private boolean add(GeometryObject object, boolean checked) {
        String name = Arguments.present("object", object).name();
        if (name != null && bodies.find(name) >= 0) {
            throw new IllegalArgumentException("name must be unique in its world (got: \"" + name + "\" again)");
        }
        if (!fits(object) || (checked && collides(level, object, -1))) {
            return false;
        }
        int id = bodies.add(object);
        for (Level each : levels) {
            each.add(id, object);
        }
        return true;
    }

    private boolean fits(GeometryObject object) {
        OwnLeaves.placed(object, candidate);
        return border.holds(candidate, 0, candidate.size());
    }

    private boolean collides(Level at, GeometryObject object, int but) {
        at.placed(object, candidate);
        at.boundsOf(candidate, 0, candidate.size(), box, 0);
        return ranging.collides(at, candidate, box, but);
    }

    /**
     * Whether an object would touch or overlap another one in the world as it is. The border is no object: what would
     * leave the world is refused when it is added.
     */
    public boolean testObject(GeometryObject object) {
        return collides(level, Arguments.present("object", object), -1);
    }

    /** Whether an object would touch or overlap another one, at a given accuracy. */
    public boolean testObject(GeometryObject object, Accuracy accuracy) {
        return collides(at(accuracy), Arguments.present("object", object), -1);
    }

    /** Takes an object out; false where there is none of that name. */
    public boolean removeObject(String name) {
        int id = bodies.find(Arguments.present("name", name));
        if (id < 0) {
            return false;
        }
        for (Level each : levels) {
            each.remove(id, bodies);
        }
        bodies.remove(id);
        return true;
    }

    /**
     * Puts a moveable object upright at a place, without a way there.
     *
     * @param heading degrees about the vertical
     * @return false, and nothing changes, where it would touch or overlap another object or leave the world
     */
    public boolean placeObject(String name, Point center, double heading) {
        int id = mover(name);
        GeometryObject placed =
                bodies.value(id).at(Pose.of(Arguments.present("center", center), Arguments.angle("heading", heading)));
        if (!fits(placed) || collides(level, placed, id)) {
            return false;
        }
        double[] places = bodies.places();
        int at = bodies.place(id);
        places[at] = center.x();
        places[at + 1] = center.y();
        places[at + 2] = center.z();
        placed.pose().attitude(places, at + 3);
        moved(id);
        return true;
    }

    private void moved(int id) {
        for (Level each : levels) {
            each.move(id, bodies.places(), bodies.place(id));
        }
    }

    /** The object of a name, at its present place. */
    public GeometryObject getObject(String name) {
        return bodies.present(known(name));
    }

    /** Whether there is an object of that name. */
    public boolean hasObject(String name) {
        return bodies.find(Arguments.present("name", name)) >= 0;
    }

    /** All objects at their present places, in the order in which they were added. */
    public List<GeometryObject> objects() {
        List<GeometryObject> objects = new ArrayList<>(bodies.size());
        IntStream.range(0, bodies.limit())
                .filter(bodies::isPresent)
                .boxed()
                .sorted(earlierFirst())
                .forEach(id -> objects.add(bodies.present(id)));
        return List.copyOf(objects);
    }

    private Comparator<Integer> earlierFirst() {
        return (a, b) -> a.equals(b) ? 0 : bodies.isEarlier(a, b) ? -1 : 1;
    }

    /** The world as it is seen at an accuracy, made when it is first asked. */
    private Level at(Accuracy asked) {
        Arguments.present("accuracy", asked);
        for (Level each : levels) {
            if (each.accuracy == asked) {
                return each;
            }
        }
        Level made = new Level(asked, dimension, width, length);
        IntStream.range(0, bodies.limit()).filter(bodies::isPresent).forEach(id -> made.add(id, bodies.present(id)));
        levels = Arrays.copyOf(levels, levels.length + 1);
        levels[levels.length - 1] = made;
        return made;
    }

    /**
     * Moves an object along its own axes, straight.
     *
     * @param x world units forward
     * @return false, and it stays where it is, where anything blocks the way or the end
     */
    public boolean simpleMove(String name, double x, double y, double z) {
        int id = mover(name);
        ownToWorld(id, Arguments.coordinate("x", x), Arguments.coordinate("y", y), Arguments.coordinate("z", z));
        return carryOut(id, vector[0], vector[1], vector[2], 0, 0);
    }

    /**
     * Turns an object about the vertical through its centre.
     *
     * @param degrees counter-clockwise seen from above
     * @return false, and it stays as it is, where anything blocks the turn
     */
    public boolean simpleTurn(String name, double degrees) {
        int id = mover(name);
        Arguments.angle("degrees", degrees);
        return commitIf(id, motion.attemptTurn(level, id, degrees));
    }

    private boolean carryOut(int id, double dx, double dy, double dz, double rx, double ry) {
        return commitIf(id, motion.attempt(level, id, dx, dy, dz, rx, ry, 0));
    }

    private boolean commitIf(int id, boolean free) {
        if (free) {
            commit(id);
        }
        return free;
    }

    private void commit(int id) {
        System.arraycopy(motion.end(), 0, bodies.places(), bodies.place(id), Bodies.PLACE);
        moved(id);
    }

    /**
     * Makes a move along the object's own axes, or tells what blocks it. All or nothing: a refused move leaves the
     * object where it was, to the bit.
     */
    public MoveResult move(String name, Move move) {
        int id = mover(name);
        Move asked = Arguments.present("move", move);
        ownToWorld(id, asked.x(), asked.y(), asked.z());
        return result(carryOut(id, vector[0], vector[1], vector[2], asked.rx(), asked.ry()));
    }

    /** Makes a move whose translation is along the world's axes; its turns are about the object's own. */
    public MoveResult moveGlobal(String name, Move move) {
        int id = mover(name);
        Move asked = Arguments.present("move", move);
        return result(carryOut(id, asked.x(), asked.y(), asked.z(), asked.rx(), asked.ry()));
    }

    /**
     * Goes as far as a move is free and stops short of what blocks it: of everything that the whole move would meet, the
     * object stays at least the clearance away. What is passed by without being met is no obstacle, however near.
     *
     * @param clearance world units; at least 0
     * @return {@code allowed} where the whole move was made; else the shares that were made
     */
    public MoveResult moveToContact(String name, Move move, double clearance) {
        int id = mover(name);
        Move asked = Arguments.present("move", move);
        Arguments.clearance(clearance);
        ownToWorld(id, asked.x(), asked.y(), asked.z());
        boolean all = motion.attempt(level, id, vector[0], vector[1], vector[2], asked.rx(), asked.ry(), clearance);
        MoveResult result = result(all);
        commit(id);
        return result;
    }

    private MoveResult result(boolean allowed) {
        if (allowed) {
            return new MoveResult(true, 1, 1, null, null, null);
        }
        motion.contact(vector);
        int obstacle = motion.obstacle();
        return new MoveResult(
                false,
                motion.fraction(),
                motion.turnFraction(),
                obstacle >= 0 ? bodies.present(obstacle) : null,
                new Point(vector[0], vector[1], vector[2]),
                new Point(vector[3], vector[4], vector[5]));
    }

    /** Takes a vector from the own axes of a moveable object into {@link #vector}. */
    private void ownToWorld(int id, double x, double y, double z) {
        double[] r = bodies.places();
        int at = bodies.place(id) + 3;
        vector[0] = r[at] * x + r[at + 1] * y + r[at + 2] * z;
        vector[1] = r[at + 3] * x + r[at + 4] * y + r[at + 5] * z;
        vector[2] = r[at + 6] * x + r[at + 7] * y + r[at + 8] * z;
    }

    /**
     * Distance from the ray's start to the nearest surface within its beam. With an opening angle the beam is a cone,
     * and the answer is that of the nearest point of any object within it.
     *
     * @param min   blind range, world units; a nearer echo is reported as {@code min} and still hides what is behind it
     * @param max   range, world units, {@code min <= max}; may be infinite
     * @param width full opening angle in degrees, from 0 (a line) up to, not including, 180
     * @return world units in {@code [min, max]}, or {@code +Infinity} where nothing echoes; {@code min} where the ray
     *     starts inside a solid
     * @throws IllegalArgumentException naming the argument that is NaN or out of range; in PLANAR also for a vertical ray
     */
    public double getRayDistance(Ray ray, double min, double max, double width) {
        return range(level, ray, min, max, width, -1);
    }

    /** Distance along a ray at a given accuracy. */
    public double getRayDistance(Ray ray, double min, double max, double width, Accuracy accuracy) {
        return range(at(accuracy), ray, min, max, width, -1);
    }

    /** Distance along a ray to the nearest object but one, which does not echo. */
    public double getRayDistance(Ray ray, double min, double max, double width, String ignored) {
        return range(level, ray, min, max, width, known(ignored));
    }

    private double range(Level seen, Ray ray, double min, double max, double width, int but) {
        Point from = Arguments.present("ray", ray).start();
        Point to = ray.direction();
        return range(seen, from.x(), from.y(), from.z(), to.x(), to.y(), to.z(), min, max, width, but);
    }

    private double range(
            Level seen,
            double x,
            double y,
            double z,
            double dx,
            double dy,
            double dz,
            double min,
            double max,
            double width,
            int but) {
        Arguments.range(min, max);
        Arguments.width(width);
        checkLevel(dx, dy, dz);
        ranging.beam(dimension, x, y, z, dx, dy, dz, width);
        double nearest = ranging.nearest(seen, max, but);
        return nearest < min ? min : nearest;
    }

    private void checkLevel(double dx, double dy, double dz) {
        if (dimension == Dimension.PLANAR && dx == 0 && dz == 0) {
            throw new IllegalArgumentException(
                    "direction must not be vertical in a PLANAR world, which has no heights (got: (" + dx + ", " + dy
                            + ", " + dz + "))");
        }
    }

    /**
     * Distance that a sonar in the middle of a moveable object hears, which does not hear itself.
     *
     * @param x how far the direction goes forward in the object's own frame
     * @param z how far it goes to the right
     */
    public double getSonarDistance(String name, double x, double z, double min, double max, double width) {
        int id = mover(name);
        Arguments.coordinate("x", x);
        Arguments.coordinate("z", z);
        if (x == 0 && z == 0) {
            throw new IllegalArgumentException("direction must not be zero (got: x " + x + ", z " + z + ")");
        }
        return sonar(id, 0, 0, 0, x, 0, z, min, max, width);
    }

    /** Distance that a sonar hears along a ray given in a moveable object's own frame; the object itself is silent. */
    public double getSonarDistance(String name, Ray mount, double min, double max, double width) {
        int id = mover(name);
        Point from = Arguments.present("mount", mount).start();
        Point to = mount.direction();
        return sonar(id, from.x(), from.y(), from.z(), to.x(), to.y(), to.z(), min, max, width);
    }

    private double sonar(
            int id,
            double x,
            double y,
            double z,
            double dx,
            double dy,
            double dz,
            double min,
            double max,
            double width) {
        double[] places = bodies.places();
        int at = bodies.place(id);
        ownToWorld(id, x, y, z);
        double ox = places[at] + vector[0];
        double oy = places[at + 1] + vector[1];
        double oz = places[at + 2] + vector[2];
        ownToWorld(id, dx, dy, dz);
        return range(level, ox, oy, oz, vector[0], vector[1], vector[2], min, max, width, id);
    }

    /**
     * The least distance between an object and any other.
     *
     * @param max range, world units; may be infinite
     * @return 0 in contact, {@code +Infinity} where nothing is within {@code max}
     */
    public double getProximity(String name, double max) {
        int id = known(name);
        Arguments.range(0, max);
        return ranging.proximity(level, id, max);
    }

    /**
     * What a ray meets first within a range; null where it meets nothing. A ray that starts inside a solid meets it at
     * distance 0. In PLANAR the point keeps the height of the ray's start.
     */
    public @Nullable RayHit castRay(Ray ray, double max) {
        Point from = Arguments.present("ray", ray).start();
        Point to = ray.direction();
        Arguments.range(0, max);
        checkLevel(to.x(), to.y(), to.z());
        ranging.beam(dimension, from.x(), from.y(), from.z(), to.x(), to.y(), to.z(), 0);
        double distance = ranging.nearest(level, max, -1);
        if (ranging.hit() < 0) {
            return null;
        }
        ranging.normal(level, distance, vector);
        return new RayHit(
                distance,
                new Point(ranging.point(0, distance), ranging.point(1, distance), ranging.point(2, distance)),
                new Point(vector[0], vector[1], vector[2]),
                bodies.present(ranging.hit()));
    }

    /**
     * A sweep of single rays from the middle of a moveable object, level with it: ray k goes at
     * {@code firstDegrees + k * stepDegrees} counter-clockwise from forward.
     *
     * @param count how many rays; at least 0
     * @return a distance each, as {@link #getRayDistance} answers it with a width of 0
     */
    public double[] scan(String name, double firstDegrees, double stepDegrees, int count, double min, double max) {
        double[] distances = new double[Arguments.count(count)];
        scan(name, firstDegrees, stepDegrees, min, max, distances);
        return distances;
    }

    /** A sweep of single rays into a given array, as many as it has room for. */
    public void scan(String name, double firstDegrees, double stepDegrees, double min, double max, double[] out) {
        scan(name, 0, 0, 0, firstDegrees, stepDegrees, min, max, out);
    }

    /**
     * A sweep of single rays from a sensor that is mounted elsewhere.
     *
     * @param mount where the sensor stands in the object's own frame
     */
    public void scan(
            String name, Point mount, double firstDegrees, double stepDegrees, double min, double max, double[] out) {
        Arguments.present("mount", mount);
        scan(name, mount.x(), mount.y(), mount.z(), firstDegrees, stepDegrees, min, max, out);
    }

    private void scan(
            String name,
            double x,
            double y,
            double z,
            double firstDegrees,
            double stepDegrees,
            double min,
            double max,
            double[] out) {
        int id = mover(name);
        Arguments.angle("firstDegrees", firstDegrees);
        Arguments.angle("stepDegrees", stepDegrees);
        Arguments.range(min, max);
        Arguments.present("out", out);
        for (int k = 0; k < out.length; k++) {
            double degrees = Arguments.angle("angle of the last ray", firstDegrees + k * stepDegrees);
            out[k] = sonar(id, x, y, z, Degrees.cos(degrees), 0, -Degrees.sin(degrees), min, max, 0);
        }
    }

    private int known(String name) {
        int id = bodies.find(Arguments.present("name", name));
        if (id < 0) {
            throw new IllegalArgumentException("name must be that of an object in the world (got: \"" + name + "\")");
        }
        return id;
    }

    private int mover(String name) {
        int id = known(name);
        if (!bodies.isMoveable(id)) {
            throw new IllegalArgumentException(
                    "name must be that of a moveable object; this one is static (got: \"" + name + "\")");
        }
        return id;
    }
}
