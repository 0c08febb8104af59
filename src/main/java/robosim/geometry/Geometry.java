package robosim.geometry;

import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.engine.broadphase.AccuracyView;
import robosim.geometry.engine.broadphase.ObjectRegistry;
import robosim.geometry.engine.broadphase.SharedIndex;
import robosim.geometry.engine.motion.Carrier;
import robosim.geometry.engine.motion.FreePlaces;
import robosim.geometry.engine.motion.Motion;
import robosim.geometry.engine.motion.Slide;
import robosim.geometry.engine.motion.TranslationFastPath;
import robosim.geometry.engine.objects.ObjectTable;
import robosim.geometry.engine.sensing.BeamQuery;
import robosim.geometry.engine.sensing.Beams;
import robosim.geometry.engine.sensing.Echoes;
import robosim.geometry.engine.sensing.PatternSensor;
import robosim.geometry.engine.sensing.ProximityQuery;
import robosim.geometry.engine.sensing.RayBatch;
import robosim.geometry.exact.Checks;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.Ray;
import robosim.geometry.model.RayPattern;
import robosim.geometry.model.SenseOptions;
import robosim.geometry.narrow.Scratch;

/**
 * A world: a box centred at the origin with objects in it. It answers three questions: May this object be here? How far
 * may it move? How far away is the nearest surface?
 *
 * <p>Static objects are indexed by a quadtree or, where heights count, by a bounding-volume hierarchy. Up to 16
 * moveable objects are kept in a list; more are put in a tree too. No answer depends on this choice.
 *
 * <p>No part of an object may leave the world, on the way or at the end: a call that would add or move it so returns
 * false. The world's bounds are closed (touching them is inside), are always checked against the exact shape, and echo
 * nothing. In {@link Dimension#PLANAR} heights are not bounded.
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
 * A piece that an object already touches or overlaps where a move begins, as in worlds loaded unchecked, blocks only
 * motion deeper into it; moving along it or away is free. Each face of a mesh and each member of a group is a separate
 * piece. An object that stands on a floor may cross its seams: if a plane separates the object from a piece that it
 * touches, and the move does not cross that plane, nothing that lies wholly behind the plane blocks, such as the next
 * triangle of a floor, the next tile of equal height, or the flush wall along which it slides. This is decided without
 * rounding on the start and the end as stored, so a step of even one ulp across the plane is blocked. A level move
 * keeps the height to the bit. On a sloping floor the end of a move is rounded, possibly to behind the plane; then this
 * move, or the next one across a seam, is refused. {@code docs/numerics.md} says which planes are used.
 *
 * <h2>Long runs</h2>
 *
 * A moveable object's centre and heading are kept as compensated sums, that is, together with their rounding errors;
 * queries see the nearest doubles. So rounding errors do not accumulate with the size of the coordinates. After any
 * number of moves, refused ones included:
 *
 * <ul>
 *   <li>the heading of an upright object is the exact sum of its turns to within half an ulp, 1.5e-14 degree;
 *   <li>its centre is where exact moves along exact headings lead, to within half an ulp of each coordinate and
 *       2<sup>-50</sup> of the length of its path;
 *   <li>a path out and back to where it was added or placed ends there to the bit; so does a closed path of quarter
 *       turns;
 *   <li>the attitude of a tipped object, one whose own Y is not vertical, always remains a rotation to 2<sup>-50</sup>;
 *       its direction is off by at most 7 * 2<sup>-53</sup> radian per turn, and its position by that fraction of its
 *       path.
 * </ul>
 *
 * The rounding error of a pose stays with the value that {@link #getObject} returns, but no query sees it, and it is
 * not sent over the network.
 *
 * <p>A bad argument throws an {@code IllegalArgumentException} whose message names the argument and its value; after
 * any exception the world is unchanged. A world may be used by one thread at a time.
 */
public final class Geometry {
    private static final Point CENTER = new Point();

    static {
        Carrier.open(world -> ((Geometry) world).carrier());
    }

    private final double width;
    private final double height;
    private final double length;
    private final Dimension dimension;
    private final Accuracy accuracy;

    private final ObjectRegistry registry;
    private final ObjectTable objects;
    private final AccuracyView view;
    private final Beams beams;
    private final PatternSensor sensor;
    private final RayBatch rays;
    private final ProximityQuery proximity;
    private final Motion motion;
    private final TranslationFastPath fastPath;
    private final Slide slide;
    private final FreePlaces places;
    private final Scratch scratch;
    private @Nullable ObjectSearch search;
    private final double[] vector = new double[6];
    private @Nullable Carrier carrier;

    /** A world of 1000 x 1000 x 1000 world units, SPATIAL and EXACT. */
    public Geometry() {
        this(1000, 1000, 1000);
    }

    /** A SPATIAL and EXACT world of a given size along X, Y and Z. */
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
     * @param accuracy  what stands for an object in queries that name no accuracy
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

    /**
     * The world of a snapshot, without its moveable objects so far; its working memory may be shared with other worlds
     * of its thread.
     */
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
        this.scratch = scratch;
        registry = new ObjectRegistry(width, height, length, dimension, accuracy, shared, scratch);
        objects = registry.objects;
        view = registry.view;
        BeamQuery ranging = new BeamQuery(objects, scratch);
        beams = new Beams(dimension, objects, ranging);
        sensor = new PatternSensor(dimension, objects, ranging, scratch);
        rays = new RayBatch(dimension, objects, ranging);
        proximity = new ProximityQuery(objects, scratch);
        motion = new Motion(objects, registry.worldBounds, scratch);
        fastPath = new TranslationFastPath(objects, registry.worldBounds, scratch);
        slide = new Slide(registry, motion);
        places = new FreePlaces(registry, motion, scratch);
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

    /** What stands for an object in queries that name no accuracy. */
    public Accuracy accuracy() {
        return accuracy;
    }

    /**
     * Adds an object unless it would touch something.
     *
     * @return false, and nothing is added, if it would touch or overlap another object or leave the world
     * @throws IllegalArgumentException if its name is taken
     */
    public boolean addObject(GeometryObject object) {
        return registry.add(object, true);
    }

    /**
     * Adds an object even if it overlaps others, as some do in RoboSim's worlds.
     *
     * @return false, and nothing is added, if it would leave the world
     * @throws IllegalArgumentException if its name is taken
     */
    public boolean addObjectUnchecked(GeometryObject object) {
        return registry.add(object, false);
    }

    /**
     * Whether an object would touch or overlap another one in the world as it is. The world's bounds are not an object:
     * they are checked only when an object is added.
     */
    public boolean testObject(GeometryObject object) {
        return registry.collides(view, object, -1);
    }

    /** Whether an object would touch or overlap another one, at a given accuracy. */
    public boolean testObject(GeometryObject object, Accuracy accuracy) {
        return registry.collides(registry.at(accuracy), object, -1);
    }

    /** Removes an object; returns false if there is none of that name. */
    public boolean removeObject(String name) {
        return registry.remove(name);
    }

    /**
     * Places a moveable object upright at a point, without checking a path to it.
     *
     * @param heading degrees about the vertical
     * @return false, and nothing changes, if it would touch or overlap another object or leave the world
     */
    public boolean placeObject(String name, Point center, double heading) {
        return registry.place(registry.mover(name), center, heading);
    }

    /** The object with a given name, at its present place. */
    public GeometryObject getObject(String name) {
        return objects.present(registry.known(name));
    }

    /** Whether there is an object of that name. */
    public boolean hasObject(String name) {
        return objects.find(Checks.present("name", name)) >= 0;
    }

    /** Which objects are where: in the way of an addition or a placement, in a box, nearest. */
    public ObjectSearch search() {
        ObjectSearch made = search == null ? new ObjectSearch(registry, scratch) : search;
        search = made;
        return made;
    }

    /** All objects at their present places, in the order in which they were added. */
    public List<GeometryObject> objects() {
        return registry.present();
    }

    /**
     * An immutable snapshot of the world as it is now: many threads may make copies of it, which share its static
     * objects and the indexes over them. Takes about as long as adding the static objects did, unless this world is
     * itself a copy of a snapshot and its static objects are unchanged.
     */
    public Snapshot snapshot() {
        return Snapshot.of(this, objects, registry.shared());
    }

    /** Puts an object of a snapshot back where it was, while a world is made from it. */
    void restore(GeometryObject object, long arrival) {
        registry.restore(object, arrival);
    }

    /** What moves objects by their ids, made when it is first asked for. */
    private Carrier carrier() {
        Carrier made = carrier == null ? new Carrier(registry, motion, fastPath) : carrier;
        carrier = made;
        return made;
    }

    /** Ends a series of calls of {@link #restore}, with the number of objects added to the original world so far. */
    void restored(long arrivals) {
        objects.arriveAt(arrivals);
    }

    /**
     * Moves an object in a straight line, along its own axes.
     *
     * @param x world units forward
     * @return false, and it stays where it is, if anything blocks the path or the end
     */
    public boolean simpleMove(String name, double x, double y, double z) {
        int id = registry.mover(name);
        objects.toWorld(id, Checks.coordinate("x", x), Checks.coordinate("y", y), Checks.coordinate("z", z), vector);
        int verdict = stride(id, vector[0], vector[1], vector[2]);
        return verdict == TranslationFastPath.UNKNOWN
                ? commitIf(id, motion.allows(view, id, vector[0], vector[1], vector[2]))
                : verdict == TranslationFastPath.FREE;
    }

    /** Makes a straight move if the fast path finds it free. */
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
     * @return false, and it stays as it is, if anything blocks the turn
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
     * Makes a move along the object's own axes, or reports what blocks it. All or nothing: a refused move leaves the
     * object where it was, to the bit. Free places are checked as stored, after rounding: see {@link MoveResult} for
     * moves of the size of an ulp.
     */
    public MoveResult move(String name, Move move) {
        int id = registry.mover(name);
        Move asked = Checks.present("move", move);
        objects.toWorld(id, asked.x(), asked.y(), asked.z(), vector);
        return result(carryOut(id, vector[0], vector[1], vector[2], asked.rx(), asked.ry(), false));
    }

    /**
     * Makes a move along the world's axes, or reports what blocks it: a translation along them, then in place a turn by
     * {@code ry} about the world's Y and one by {@code rx} about the world's X, both through the object's centre. In
     * PLANAR an object turns about the vertical only, and {@code rx} is ignored.
     */
    public MoveResult moveGlobal(String name, Move move) {
        int id = registry.mover(name);
        Move asked = Checks.present("move", move);
        double rx = dimension == Dimension.PLANAR ? 0 : asked.rx();
        return result(carryOut(id, asked.x(), asked.y(), asked.z(), rx, asked.ry(), true));
    }

    /**
     * Moves an object as far as the way is free and stops short of what blocks it: every part of the object stays at
     * least the clearance away from every piece that the whole move would hit. A piece that the move passes without
     * touching is not an obstacle, however near.
     *
     * @param clearance world units; at least 0
     * @return {@code allowed} if the whole move was made; else the fractions that were made, with a contact in the gap that
     *     is left: it lies neither on the object nor on what blocks it
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

    /**
     * Moves an object as {@link #moveToContact} does, and where it is blocked goes on with what is left of the way, along
     * the plane of the contact or, between two planes, along their edge, but never back against the move asked for; then
     * turns it as far as that is free. The part of the way into a plane is lost. After it the object overlaps nothing that it did not overlap before. A plane into
     * which rounding leads again is left by 2<sup>-40</sup> of what is left of the way.
     *
     * @param clearance world units; at least 0
     * @param bends     at how many contacts the way may go on; it ends at the next. From 0, as
     *                  {@code moveToContact}, to 64
     */
    public SlideResult moveAndSlide(String name, Move move, double clearance, int bends) {
        int id = registry.mover(name);
        Move asked = Checks.present("move", move);
        Checks.clearance(clearance);
        Slide.checkBends(bends);
        objects.toWorld(id, asked.x(), asked.y(), asked.z(), vector);
        slide.make(view, id, vector[0], vector[1], vector[2], asked.rx(), asked.ry(), clearance, bends);
        return SlideResult.of(slide, objects);
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
     * Distance from the ray's start to the nearest surface within its beam. With an opening angle above 0 the beam is a
     * cone, and the result is the distance of the nearest point of any object within it.
     *
     * @param min   blind range, world units; a nearer echo is reported as {@code min} and still hides what is behind it
     * @param max   range, world units, {@code min <= max}; may be infinite
     * @param width full opening angle in degrees, from 0 (a line) up to, not including, 180
     * @return world units in {@code [min, max]}, or {@code +Infinity} if nothing echoes; {@code min} if the ray starts
     *     inside a solid
     * @throws IllegalArgumentException naming the argument that is NaN or out of range; in PLANAR also for a vertical ray
     */
    public double getRayDistance(Ray ray, double min, double max, double width) {
        return beams.distance(view, ray, min, max, width, -1);
    }

    /** Distance along a ray at a given accuracy. */
    public double getRayDistance(Ray ray, double min, double max, double width, Accuracy accuracy) {
        return beams.distance(registry.at(accuracy), ray, min, max, width, -1);
    }

    /** Distance along a ray to the nearest object, ignoring the one of a given name. */
    public double getRayDistance(Ray ray, double min, double max, double width, String ignored) {
        return beams.distance(view, ray, min, max, width, registry.known(ignored));
    }

    /**
     * Distance that a sonar at the centre of a moveable object measures; the object itself does not echo.
     *
     * @param x forward component of the direction in the object's own frame
     * @param z component to the right
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

    /**
     * Distance that a sonar measures along a ray given in a moveable object's own frame; the object itself does not
     * echo.
     */
    public double getSonarDistance(String name, Ray mount, double min, double max, double width) {
        int id = registry.mover(name);
        Point from = Checks.present("mount", mount).start();
        Point to = mount.direction();
        return beams.sonar(view, id, from.x(), from.y(), from.z(), to.x(), to.y(), to.z(), min, max, width);
    }

    /**
     * The smallest distance between an object and any other. To the bit, it is the minimum of the distances to each
     * other object alone; its error is within 2<sup>-43</sup> of the distance and of the sizes of the two.
     *
     * @param max range, world units; may be infinite
     * @return 0 in contact, {@code +Infinity} if nothing is within {@code max}
     */
    public double getProximity(String name, double max) {
        int id = registry.known(name);
        Checks.range(0, max);
        return proximity.of(view, id, max);
    }

    /**
     * What a ray hits first within a range; null if it hits nothing. A ray that starts inside a solid hits it at
     * distance 0. In PLANAR the hit point keeps the height of the ray's start.
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
     * A scan: rays from the centre of a moveable object in its own horizontal plane. Ray k points {@code firstDegrees +
     * k * stepDegrees} counter-clockwise from forward.
     *
     * @param count number of rays; at least 0
     * @return one distance per ray, as {@link #getRayDistance} returns it with a width of 0
     */
    public double[] scan(String name, double firstDegrees, double stepDegrees, int count, double min, double max) {
        double[] distances = new double[Checks.count(count)];
        scan(name, firstDegrees, stepDegrees, min, max, distances);
        return distances;
    }

    /** A scan into a given array, with as many rays as the array has elements. */
    public void scan(String name, double firstDegrees, double stepDegrees, double min, double max, double[] out) {
        scan(name, CENTER, firstDegrees, stepDegrees, min, max, out);
    }

    /**
     * A scan from a sensor that is not at the object's centre.
     *
     * @param mount the sensor's position in the object's own frame
     */
    public void scan(
            String name, Point mount, double firstDegrees, double stepDegrees, double min, double max, double[] out) {
        Checks.present("mount", mount);
        sensor.scan(view, registry.mover(name), mount, firstDegrees, stepDegrees, min, max, out);
    }

    /**
     * All beams of a sensor that is mounted on a moveable object. Each distance is, to the bit, that of
     * {@link #getSonarDistance(String, Ray, double, double, double)} along {@code new Ray(mount.center(), d)}, where d is
     * the beam's direction turned by the rotation of the mount. A {@link #scan} is a {@link RayPattern#fan}.
     *
     * @param mount   where the sensor is and which way it faces, in the object's own frame
     * @param options a world answers on the calling thread alone, whatever the number of threads: see
     *                {@link Snapshot#sense}
     * @param out     takes the answers
     */
    public void sense(String name, Pose mount, RayPattern pattern, SenseOptions options, SenseBuffer out) {
        mountSensor(Checks.present("name", name), Checks.present("mount", mount));
        sense(pattern, options, out);
    }

    /**
     * All beams of a sensor that nothing carries. Each distance is, to the bit, that of {@link #getRayDistance} from the
     * sensor's place, and each object and normal that of {@link #castRay}.
     *
     * @param sensor where it is and which way it faces
     */
    public void sense(Pose sensor, RayPattern pattern, SenseOptions options, SenseBuffer out) {
        mountSensor(null, Checks.present("sensor", sensor));
        sense(pattern, options, out);
    }

    private void sense(RayPattern pattern, SenseOptions options, SenseBuffer out) {
        Echoes echoes = prepareSensor(pattern, options, out);
        sensor.sense(view, pattern, options, echoes, 0, sensor.tiles(pattern, options));
        PatternSensor.finish(pattern, echoes);
    }

    /** Puts the sensor on an object, or into the world where none is named. */
    void mountSensor(@Nullable String name, Pose pose) {
        if (name == null) {
            sensor.frame().at(pose);
        } else {
            sensor.frame().mounted(registry.mover(name), pose);
        }
    }

    /** Checks what the sensor is asked, and makes room for its answers. */
    Echoes prepareSensor(RayPattern pattern, SenseOptions options, SenseBuffer out) {
        Checks.present("pattern", pattern);
        Checks.present("options", options);
        Echoes echoes = Checks.present("out", out).echoes();
        sensor.prepare(pattern, options, echoes);
        return echoes;
    }

    /** The number of tiles in a pattern of the sensor. */
    int sensorTiles(RayPattern pattern, SenseOptions options) {
        return sensor.tiles(pattern, options);
    }

    /** Answers some tiles of the sensor. */
    void senseSome(RayPattern pattern, SenseOptions options, Echoes out, int from, int to) {
        sensor.sense(view, pattern, options, out, from, to);
    }

    /**
     * What many rays meet first that begin anywhere: mirrored rays, or the echoes of a sensor that moves while it measures.
     * Each answer is, to the bit, that of {@link #castRay} with a range of its own.
     *
     * @param rays  seven numbers each: X, Y and Z of its start, X, Y and Z of its direction, of any length but zero, and its
     *              range, which may be infinite
     * @param count how many rays there are, from the beginning of the array
     * @param out   takes the answers
     */
    public void castRays(double[] rays, int count, SenseBuffer out) {
        this.rays.check(rays, count);
        this.rays.cast(view, rays, count, Checks.present("out", out).echoes());
    }

    /**
     * Tells for many rays whether each is free: whether it meets nothing within its range. Each bit is set where {@link
     * #castRay} would return null; it is found sooner than what is met first. Two points see each other where the ray from
     * one to the other, with their distance as its range, is free.
     *
     * @param rays  as in {@link #castRays}
     * @param count how many rays there are, from the beginning of the array
     * @param free  takes the answers as in {@link #freePoses}
     * @return how many are free
     */
    public int freeRays(double[] rays, int count, long[] free) {
        return freeRays(rays, count, -1, free);
    }

    /**
     * The same, ignoring the object of a given name.
     *
     * @throws IllegalArgumentException if there is no object of that name
     */
    public int freeRays(double[] rays, int count, String ignored, long[] free) {
        return freeRays(rays, count, registry.known(Checks.present("ignored", ignored)), free);
    }

    private int freeRays(double[] rays, int count, int ignored, long[] free) {
        this.rays.check(rays, count);
        FreePlaces.checkRoom(count, free);
        return this.rays.free(view, rays, count, ignored, free);
    }

    /**
     * Tells for many upright poses of a moveable object whether it would touch anything there. Nothing is moved, and the
     * object itself is not in the way. Each bit is set where {@link #testObject(GeometryObject)} would return false for
     * the object at that pose; as there, the world's bounds are not asked.
     *
     * @param poses four numbers each: X, Y and Z of the centre, and the heading in degrees
     * @param free  bit {@code k % 64} of element {@code k / 64} is the answer for pose k, the layout of
     *              {@link java.util.BitSet#valueOf(long[])}; the other bits of the last element are cleared
     * @return how many poses are free
     */
    public int freePoses(String name, double[] poses, long[] free) {
        int id = registry.mover(name);
        return places.poses(view, id, poses, 0, FreePlaces.check("poses", poses, FreePlaces.POSE, free), free);
    }

    /**
     * Tells for many edges, each a straight move from one upright pose to another, whether a moveable object would touch
     * nothing on the whole way, both ends included. Nothing is moved, and the object itself is not in the way. Each bit is
     * set where {@link #placeObject} would put the object at the first pose and {@link #moveGlobal} would then move it by
     * the differences of the coordinates, and in place turn it by that of the headings: a turn of 350 degrees is not one of
     * -10. The way is swept, not sampled.
     *
     * @param edges eight numbers each: X, Y, Z and heading at the first pose, then at the second
     * @param free  takes the answers as in {@link #freePoses}
     * @return how many edges are free
     */
    public int freeEdges(String name, double[] edges, long[] free) {
        int id = registry.mover(name);
        return places.edges(view, id, edges, 0, FreePlaces.check("edges", edges, FreePlaces.EDGE, free), free);
    }

    /** Answers some poses. */
    int somePoses(String name, double[] poses, int from, int to, long[] free) {
        return places.poses(view, registry.mover(name), poses, from, to, free);
    }

    /** Answers some edges. */
    int someEdges(String name, double[] edges, int from, int to, long[] free) {
        return places.edges(view, registry.mover(name), edges, from, to, free);
    }

    /** As in {@code SPATIAL EXACT world of 20.0 x 5.0 x 20.0 with 113 objects, 8 of them moveable}. */
    @Override
    public String toString() {
        return dimension + " " + accuracy + " world of " + width + " x " + height + " x " + length + " with "
                + objects.ids().count() + " objects, " + objects.moverCount() + " of them moveable";
    }
}
