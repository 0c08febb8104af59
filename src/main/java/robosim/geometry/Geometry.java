package robosim.geometry;

import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.engine.broadphase.AccuracyView;
import robosim.geometry.engine.broadphase.ObjectRegistry;
import robosim.geometry.engine.broadphase.SharedIndex;
import robosim.geometry.engine.motion.Motion;
import robosim.geometry.engine.motion.TranslationFastPath;
import robosim.geometry.engine.objects.ObjectTable;
import robosim.geometry.engine.sensing.BeamQuery;
import robosim.geometry.engine.sensing.Beams;
import robosim.geometry.engine.sensing.ProximityQuery;
import robosim.geometry.exact.Checks;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;
import robosim.geometry.narrow.Scratch;

/**
 * A world: a box centred at the origin with objects in it, and the answers to three questions. May this object be here?
 * How far may it move? How far away is the next surface?
 *
 * <p>Static objects stand in a quadtree or, where heights count and the scene is stacked, in an octree. Up to 16 moveable
 * objects are in a list; where there are more, they are in the quadtree too. No answer depends on that.
 *
 * <p>Nothing may be added or moved so that any part of it leaves the world, on the way or at the end: such a call answers
 * false. The border is closed (touching it is inside), is always judged on the exact shape, and echoes nothing. In
 * {@link Dimension#PLANAR} it has no heights.
 *
 * <pre>{@code
 * Geometry geometry = new Geometry(20, 5, 20);
 * geometry.addObject(new BoxObject(new Point(4, 0, 0), 0.2, 2, 6));                     // true
 * geometry.addObject(new CylinderObject(new Point(0, 0, 0), 0.3, 1).moveable("robot")); // true
 * geometry.getSonarDistance("robot", 1, 0, 0, 10, 15);                                  // 3.9
 * geometry.simpleMove("robot", 2, 0, 0);                                                // true
 * geometry.simpleMove("robot", 5, 0, 0);                                                // false: the wall
 * }</pre>
 *
 * <h2>Contacts at the start</h2>
 *
 * What an object touches or overlaps where a move begins, as in worlds that were loaded unchecked, blocks only what goes
 * deeper into it: along it and away are free. Each face of a mesh and each member of a group is a piece of its own. And who
 * stands on a floor may cross its seams: where a plane is between the object and a piece that it touches, and the move does
 * not cross that plane, nothing that lies wholly behind the plane blocks, such as the next triangle of a floor, the next tile of
 * equal height, or the flush wall along which it slides. That is decided without rounding on the start and the end as stored, so
 * that a step of one ulp does block. Heights that are exact sums stay: who drives level keeps its height to the bit. On a
 * sloping floor the end of a move is rounded, and may be rounded to behind the plane: then the move is refused, or the
 * next seam is. {@code docs/numerics.md} says which planes are known.
 *
 * <h2>Long runs</h2>
 *
 * A moveable object's centre and heading are kept as sums together with the rounding that they lost; every query sees
 * the doubles nearest to them. So rounding does not pile up with the size of the coordinates. After any number of moves,
 * refused ones included:
 *
 * <ul>
 *   <li>the heading of an upright object is the exact sum of its turns to within half an ulp, 1.5e-14 degree;
 *   <li>its centre is where exact moves along exact headings lead, to within half an ulp of each coordinate and
 *       2<sup>-50</sup> of the length of the way that it went;
 *   <li>a way there and back again, from where it was added or placed, ends there to the bit; so does a closed path of
 *       quarter turns;
 *   <li>a tipped object, one whose own Y is not the vertical, stays a rotation to 2<sup>-50</sup> for ever; its direction is
 *       off by at most 7 * 2<sup>-53</sup> radian a turn, and where it goes along that by as much of its way.
 * </ul>
 *
 * What a place has lost stays with the value that {@link #getObject} answers, but no question sees it, and it does not
 * travel over a wire.
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

    private final ObjectRegistry registry;
    private final ObjectTable objects;
    private final AccuracyView view;
    private final Beams beams;
    private final ProximityQuery proximity;
    private final Motion motion;
    private final TranslationFastPath fastPath;
    private final double[] vector = new double[6];

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
        this(
                Checks.worldSize("width", width),
                Checks.worldSize("height", height),
                Checks.worldSize("length", length),
                Checks.present("dimension", dimension),
                Checks.present("accuracy", accuracy),
                null,
                new Scratch());
    }

    /** The world of a snapshot before anything moveable is in it, with working memory that others of its thread may use. */
    Geometry(
            double width,
            double height,
            double length,
            Dimension dimension,
            Accuracy accuracy,
            @Nullable SharedIndex shared,
            Scratch scratch) {
        this.width = width;
        this.height = height;
        this.length = length;
        this.dimension = dimension;
        this.accuracy = accuracy;
        registry = new ObjectRegistry(width, height, length, dimension, accuracy, shared, scratch);
        objects = registry.objects;
        view = registry.view;
        beams = new Beams(dimension, objects, new BeamQuery(objects, scratch));
        proximity = new ProximityQuery(objects, scratch);
        motion = new Motion(objects, registry.worldBounds, scratch);
        fastPath = new TranslationFastPath(objects, registry.worldBounds, scratch);
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
        return registry.add(object, true);
    }

    /**
     * Adds an object even where it overlaps others, as RoboSim's worlds do.
     *
     * @return false, and nothing is added, where it would leave the world
     * @throws IllegalArgumentException where its name is taken
     */
    public boolean addObjectUnchecked(GeometryObject object) {
        return registry.add(object, false);
    }

    /**
     * Whether an object would touch or overlap another one in the world as it is. The border is no object: what would
     * leave the world is refused when it is added.
     */
    public boolean testObject(GeometryObject object) {
        return registry.collides(view, object, -1);
    }

    /** Whether an object would touch or overlap another one, at a given accuracy. */
    public boolean testObject(GeometryObject object, Accuracy accuracy) {
        return registry.collides(registry.at(accuracy), object, -1);
    }

    /** Takes an object out; false where there is none of that name. */
    public boolean removeObject(String name) {
        return registry.remove(name);
    }

    /**
     * Puts a moveable object upright at a place, without a way there.
     *
     * @param heading degrees about the vertical
     * @return false, and nothing changes, where it would touch or overlap another object or leave the world
     */
    public boolean placeObject(String name, Point center, double heading) {
        return registry.place(registry.mover(name), center, heading);
    }

    /** The object of a name, at its present place. */
    public GeometryObject getObject(String name) {
        return objects.present(registry.known(name));
    }

    /** Whether there is an object of that name. */
    public boolean hasObject(String name) {
        return objects.find(Checks.present("name", name)) >= 0;
    }

    /** All objects at their present places, in the order in which they were added. */
    public List<GeometryObject> objects() {
        return registry.present();
    }

    /**
     * The world as it is now, for good: many threads may make copies of it that share its static objects and what is
     * built over them. Takes about as long as adding the static objects did, unless this world is itself a copy of a
     * snapshot and its static objects are still the same.
     */
    public Snapshot snapshot() {
        return Snapshot.of(this, objects, registry.shared());
    }

    /** Puts an object of a snapshot back where it was; for a world that is being made of it. */
    void restore(GeometryObject object, long arrival) {
        registry.restore(object, arrival);
    }

    /** Ends what {@link #restore} began: so many objects have come. */
    void restored(long arrivals) {
        objects.arriveAt(arrivals);
    }

    /**
     * Moves an object along its own axes, straight.
     *
     * @param x world units forward
     * @return false, and it stays where it is, where anything blocks the way or the end
     */
    public boolean simpleMove(String name, double x, double y, double z) {
        int id = registry.mover(name);
        objects.toWorld(id, Checks.coordinate("x", x), Checks.coordinate("y", y), Checks.coordinate("z", z), vector);
        int verdict = stride(id, vector[0], vector[1], vector[2]);
        return verdict == TranslationFastPath.UNKNOWN
                ? commitIf(id, motion.allows(view, id, vector[0], vector[1], vector[2]))
                : verdict == TranslationFastPath.FREE;
    }

    /** Makes a straight move if it is known to be free. */
    private int stride(int id, double dx, double dy, double dz) {
        int verdict = fastPath.ask(view, id, dx, dy, dz);
        if (verdict == TranslationFastPath.FREE) {
            registry.shift(id, fastPath.end());
        }
        return verdict;
    }

    /**
     * Turns an object about the vertical through its centre.
     *
     * @param degrees counter-clockwise seen from above
     * @return false, and it stays as it is, where anything blocks the turn
     */
    public boolean simpleTurn(String name, double degrees) {
        int id = registry.mover(name);
        Checks.angle("degrees", degrees);
        return commitIf(id, motion.allowsTurn(view, id, degrees));
    }

    private boolean carryOut(int id, double dx, double dy, double dz, double rx, double ry, boolean isGlobal) {
        boolean isMade = rx == 0 && ry == 0 && stride(id, dx, dy, dz) == TranslationFastPath.FREE;
        return isMade || commitIf(id, motion.attempt(view, id, dx, dy, dz, rx, ry, isGlobal, 0));
    }

    private boolean commitIf(int id, boolean free) {
        if (free) {
            registry.move(id, motion.end());
        }
        return free;
    }

    /**
     * Makes a move along the object's own axes, or tells what blocks it. All or nothing: a refused move leaves the
     * object where it was, to the bit. What is free is free as stored: see {@link MoveResult} for moves of the size of an ulp.
     */
    public MoveResult move(String name, Move move) {
        int id = registry.mover(name);
        Move asked = Checks.present("move", move);
        objects.toWorld(id, asked.x(), asked.y(), asked.z(), vector);
        return result(carryOut(id, vector[0], vector[1], vector[2], asked.rx(), asked.ry(), false));
    }

    /**
     * Makes a move in the world's axes, or tells what blocks it: a translation along them, then in place a turn by
     * {@code ry} about the world's Y and one by {@code rx} about the world's X, both through the object's centre. In PLANAR
     * an object turns about the vertical only, and {@code rx} is left out.
     */
    public MoveResult moveGlobal(String name, Move move) {
        int id = registry.mover(name);
        Move asked = Checks.present("move", move);
        double rx = dimension == Dimension.PLANAR ? 0 : asked.rx();
        return result(carryOut(id, asked.x(), asked.y(), asked.z(), rx, asked.ry(), true));
    }

    /**
     * Goes as far as a move is free and stops short of what blocks it: of every piece that the whole move would meet, all
     * parts of the object stay at least the clearance away. What is passed by without being met is no obstacle, however near.
     *
     * @param clearance world units; at least 0
     * @return {@code allowed} where the whole move was made; else the shares that were made
     */
    public MoveResult moveToContact(String name, Move move, double clearance) {
        int id = registry.mover(name);
        Move asked = Checks.present("move", move);
        Checks.clearance(clearance);
        objects.toWorld(id, asked.x(), asked.y(), asked.z(), vector);
        boolean all =
                motion.attempt(view, id, vector[0], vector[1], vector[2], asked.rx(), asked.ry(), false, clearance);
        MoveResult result = result(all);
        registry.move(id, motion.end());
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
                obstacle >= 0 ? objects.present(obstacle) : null,
                new Point(vector[0], vector[1], vector[2]),
                new Point(vector[3], vector[4], vector[5]));
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
        return beams.distance(view, ray, min, max, width, -1);
    }

    /** Distance along a ray at a given accuracy. */
    public double getRayDistance(Ray ray, double min, double max, double width, Accuracy accuracy) {
        return beams.distance(registry.at(accuracy), ray, min, max, width, -1);
    }

    /** Distance along a ray to the nearest object but one, which does not echo. */
    public double getRayDistance(Ray ray, double min, double max, double width, String ignored) {
        return beams.distance(view, ray, min, max, width, registry.known(ignored));
    }

    /**
     * Distance that a sonar in the middle of a moveable object hears, which does not hear itself.
     *
     * @param x how far the direction goes forward in the object's own frame
     * @param z how far it goes to the right
     */
    public double getSonarDistance(String name, double x, double z, double min, double max, double width) {
        int id = registry.mover(name);
        Checks.coordinate("x", x);
        Checks.coordinate("z", z);
        if (x == 0 && z == 0) {
            throw new IllegalArgumentException("direction must not be zero (got: x " + x + ", z " + z + ")");
        }
        return beams.sonar(view, id, 0, 0, 0, x, 0, z, min, max, width);
    }

    /** Distance that a sonar hears along a ray given in a moveable object's own frame; the object itself is silent. */
    public double getSonarDistance(String name, Ray mount, double min, double max, double width) {
        int id = registry.mover(name);
        Point from = Checks.present("mount", mount).start();
        Point to = mount.direction();
        return beams.sonar(view, id, from.x(), from.y(), from.z(), to.x(), to.y(), to.z(), min, max, width);
    }

    /**
     * The least distance between an object and any other: the least of those to each other object alone, to the bit, and
     * within 2<sup>-43</sup> of itself and of the sizes of the two. In contact it is 0.
     *
     * @param max range, world units; may be infinite
     * @return 0 in contact, {@code +Infinity} where nothing is within {@code max}
     */
    public double getProximity(String name, double max) {
        int id = registry.known(name);
        Checks.range(0, max);
        return proximity.of(view, id, max);
    }

    /**
     * What a ray meets first within a range; null where it meets nothing. A ray that starts inside a solid meets it at
     * distance 0. In PLANAR the point keeps the height of the ray's start.
     */
    public @Nullable RayHit castRay(Ray ray, double max) {
        double distance = beams.cast(view, ray, max, vector);
        return distance == Double.POSITIVE_INFINITY
                ? null
                : new RayHit(
                        distance,
                        new Point(beams.point(0, distance), beams.point(1, distance), beams.point(2, distance)),
                        new Point(vector[0], vector[1], vector[2]),
                        objects.present(beams.hit()));
    }

    /**
     * A scan: single rays from the middle of a moveable object, level with it: ray k goes at
     * {@code firstDegrees + k * stepDegrees} counter-clockwise from forward.
     *
     * @param count how many rays; at least 0
     * @return a distance each, as {@link #getRayDistance} answers it with a width of 0
     */
    public double[] scan(String name, double firstDegrees, double stepDegrees, int count, double min, double max) {
        double[] distances = new double[Checks.count(count)];
        scan(name, firstDegrees, stepDegrees, min, max, distances);
        return distances;
    }

    /** A scan into a given array, as many as it has room for. */
    public void scan(String name, double firstDegrees, double stepDegrees, double min, double max, double[] out) {
        beams.scan(view, registry.mover(name), 0, 0, 0, firstDegrees, stepDegrees, min, max, out);
    }

    /**
     * A scan from a sensor that is mounted elsewhere.
     *
     * @param mount where the sensor stands in the object's own frame
     */
    public void scan(
            String name, Point mount, double firstDegrees, double stepDegrees, double min, double max, double[] out) {
        Checks.present("mount", mount);
        beams.scan(
                view, registry.mover(name), mount.x(), mount.y(), mount.z(), firstDegrees, stepDegrees, min, max, out);
    }
}
