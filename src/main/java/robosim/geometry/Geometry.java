package robosim.geometry;

import java.util.List;
import java.util.Set;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.collision.SignedDistance;
import robosim.geometry.engine.World;
import robosim.geometry.engine.broadphase.AccuracyView;
import robosim.geometry.engine.broadphase.ObjectRegistry;
import robosim.geometry.engine.broadphase.SharedIndex;
import robosim.geometry.engine.motion.ClearanceQuery;
import robosim.geometry.engine.motion.FreePlaces;
import robosim.geometry.engine.motion.Motion;
import robosim.geometry.engine.motion.Slide;
import robosim.geometry.engine.objects.ObjectTable;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.Ray;
import robosim.geometry.model.RayPattern;
import robosim.geometry.model.SenseOptions;
import robosim.geometry.model.Twist;
import robosim.geometry.narrow.Scratch;

/**
 * A world: a box centred at the origin with objects in it. It answers three questions: May this object be here? How far
 * may it move? How far away is the nearest surface?
 *
 * <p>Static objects are indexed by a quadtree or, where heights count, by a bounding-volume hierarchy; moveable
 * ones too, but for up to 16 in a PLANAR world, which are kept in a list. No answer depends on this choice.
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
 * <h2>What true means</h2>
 *
 * A method that changes the world ({@code add...}, {@code place...}, {@code remove...}, {@code simple...}) returns true if it
 * has done so. A question whether something collides ({@link #testObject}, {@code CollisionDetection.intersects}) returns true
 * for a collision. A question whether something is possible ({@link ObjectSearch#fits}, {@link MoveResult#allowed}, the
 * batches {@code free...}) returns true where nothing is touched.
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
public final class Geometry implements WorldQueries {
    private static final Point CENTER = new Point();

    private final World engine;
    private final ObjectRegistry registry;
    private final ObjectTable objects;
    private final AccuracyView view;
    private final double[] vector = new double[6];
    private @Nullable ObjectSearch search;
    private @Nullable WorldProver prover;
    private WorkLimit workLimit = WorkLimit.none();

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
        registry = new ObjectRegistry(width, height, length, dimension, accuracy, shared, scratch);
        engine = new World(registry, scratch);
        objects = engine.objects;
        view = engine.view;
    }

    /**
     * What this world wraps: for the other packages of this module, whose modules alone can use it.
     *
     * @hidden
     */
    @SuppressWarnings({"exports", "InvalidBlockTag"}) // users of the module cannot see the type
    public World engine() {
        return engine;
    }

    @Override
    public double width() {
        return engine.width;
    }

    @Override
    public double height() {
        return engine.height;
    }

    @Override
    public double length() {
        return engine.length;
    }

    @Override
    public Dimension dimension() {
        return engine.dimension;
    }

    @Override
    public Accuracy accuracy() {
        return view.accuracy;
    }

    /**
     * Adds an object unless it would touch something.
     *
     * @return false, and nothing is added, if it would touch or overlap another object or leave the world
     * @throws IllegalArgumentException if its name is taken
     */
    public boolean addObject(GeometryObject object) {
        registry.begin("addObject");
        return registry.add(object, true);
    }

    /**
     * Adds an object even if it overlaps others, as some do in RoboSim's worlds.
     *
     * @return false, and nothing is added, if it would leave the world
     * @throws IllegalArgumentException if its name is taken
     */
    public boolean addObjectUnchecked(GeometryObject object) {
        registry.begin("addObjectUnchecked");
        return registry.add(object, false);
    }

    /**
     * Whether an object would touch or overlap another one in the world as it is. The world's bounds are not an object:
     * they are checked only when an object is added.
     */
    public boolean testObject(GeometryObject object) {
        registry.begin("testObject");
        return registry.collides(view, object, -1);
    }

    /** Whether an object would touch or overlap another one, at a given accuracy. */
    public boolean testObject(GeometryObject object, Accuracy accuracy) {
        registry.begin("testObject");
        return registry.collides(registry.at(accuracy), object, -1);
    }

    /** Removes an object; returns false if there is none of that name. What it carries is detached first, and stays. */
    public boolean removeObject(String name) {
        return registry.remove(name);
    }

    /**
     * Places a moveable object upright at a point, without checking a path to it: a reset, which also sets a tipped object on
     * its feet. (Poses of {@link #freePoses} keep it tipped.) What the object stands on now does not count, as there.
     *
     * @param heading degrees about the vertical
     * @return false, and nothing changes, if it would touch or overlap another object or leave the world
     */
    public boolean placeObject(String name, Point center, double heading) {
        registry.begin("placeObject");
        int id = registry.mover(name);
        return registry.place(id, center, heading) || engine.places().stand(view, id, center, heading);
    }

    /** The object with a given name, at its present place. */
    public GeometryObject getObject(String name) {
        return registry.attacher.part(name);
    }

    /** Whether there is an object of that name, attached ones included. */
    public boolean hasObject(String name) {
        return objects.find(Checks.present("name", name)) >= 0 || registry.attachments.root(name) != null;
    }

    /**
     * Attaches a moveable object to another one where it is now, as a gripper, forks or a tow hook do: from then on the two move
     * as one. The load is a part of the carrier in every query and every move: the two never collide with each other, sensors
     * of the carrier ignore both, and whatever hits the load reports the carrier, whose value is then an
     * {@link robosim.geometry.model.ObjectGroup} with {@code loads()}. {@link #getObject} still finds the load by its name;
     * methods that move or query one object refuse it. A load may carry others.
     *
     * <pre>{@code
     * Geometry geometry = new Geometry(20, 5, 20);
     * geometry.addObject(new BoxObject(new Point(0, 0, 0), 2, 1, 1).moveable("forklift"));  // true
     * geometry.addObject(new BoxObject(new Point(1.6, 0, 0), 1, 1, 1).moveable("crate"));   // true
     * geometry.attach("forklift", "crate");
     * geometry.simpleTurn("forklift", 90);                                                  // true
     * geometry.getObject("crate").center();                       // Point[x=0.0, y=0.0, z=-1.6]
     * geometry.detach("crate");
     * }</pre>
     *
     * @param carrier a moveable object, or one that is attached itself
     * @param load    a moveable object that is not attached
     * @throws IllegalArgumentException if either is static, a grid or unknown, or the carrier is the load or attached to it
     */
    public void attach(String carrier, String load) {
        registry.begin("attach");
        registry.attacher.attach(carrier, load, null);
    }

    /**
     * The same at a given pose; no path to it is checked.
     *
     * @param at the pose of the load in the frame of the carrier
     * @return false, and nothing changes, if the load would touch anything but the carrier there or leave the world
     */
    public boolean attach(String carrier, String load, Pose at) {
        registry.begin("attach");
        return registry.attacher.attach(carrier, load, Checks.present("at", at));
    }

    /**
     * Detaches an object from its carrier, with what it carries itself. It stays where it is, counts as added now, and blocks
     * the carrier from then on, but for motion away from it (see above).
     *
     * @throws IllegalArgumentException if the object is unknown or not attached
     */
    public void detach(String load) {
        registry.begin("detach");
        registry.attacher.detach(load);
    }

    /** The name of the object to which another one is attached; null if it is not attached. */
    public @Nullable String carrierOf(String name) {
        return registry.attacher.carrier(name);
    }

    /** Which objects are where: in the way of an addition or a placement, in a box, nearest. */
    public ObjectSearch search() {
        ObjectSearch made = search == null ? new ObjectSearch(engine) : search;
        search = made;
        return made;
    }

    /** Answers with proofs, which a {@link robosim.geometry.proof.ProofChecker} verifies; see {@code docs/proofs.md}. */
    public WorldProver prove() {
        WorldProver made = prover == null ? new WorldProver(engine) : prover;
        prover = made;
        return made;
    }

    @Override
    public List<GeometryObject> objects() {
        return registry.present();
    }

    /**
     * An immutable snapshot of the world as it is now: many threads may make copies of it, which share its static
     * objects and the indexes over them. Takes about as long as adding the static objects did the first time, and again
     * after any of them has been added or removed; otherwise only the moveable objects are copied.
     */
    public Snapshot snapshot() {
        return Snapshot.of(this, registry);
    }

    /** Puts an object of a snapshot back where it was, while a world is made from it. */
    void restore(GeometryObject object, long arrival) {
        registry.restore(object, arrival);
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
        registry.begin("simpleMove");
        int id = registry.mover(name);
        return engine.translateOwn(id, Checks.coordinate("x", x), Checks.coordinate("y", y), Checks.coordinate("z", z));
    }

    /**
     * Turns an object about the vertical through its centre.
     *
     * @param degrees counter-clockwise seen from above
     * @return false, and it stays as it is, if anything blocks the turn
     */
    public boolean simpleTurn(String name, double degrees) {
        registry.begin("simpleTurn");
        return engine.turn(registry.mover(name), Checks.angle("degrees", degrees));
    }

    /**
     * Makes a move along the object's own axes, or reports what blocks it. All or nothing: a refused move leaves the
     * object where it was, to the bit. Free places are checked as stored, after rounding: see {@link MoveResult} for
     * moves of the size of an ulp.
     *
     * <p>In PLANAR too, {@code rx} tips the object about its own X and {@code ry} turns it about its own Y, even if that is
     * tipped; what its projection touches on the way blocks. For turns about the vertical see {@link #moveGlobal}.
     */
    public MoveResult move(String name, Move move) {
        registry.begin("move");
        return result(engine.moveOwn(registry.mover(name), Checks.present("move", move)));
    }

    /**
     * The same with a margin that is kept all along the move, and without the objects that do not count. An object that is
     * nearer to something than the margin may move along it or away, as with {@link #moveToContact}.
     */
    public MoveResult move(String name, Move move, Avoidance avoid) {
        registry.begin("move");
        int id = registry.mover(name);
        Checks.present("move", move);
        Checks.present("avoid", avoid).begin(engine);
        try {
            boolean isFree = engine.motion.attemptOwn(view, id, move, avoid.margin());
            MoveResult result = result(isFree);
            if (isFree) {
                engine.motion.commit();
            }
            return result;
        } finally {
            objects.ignored.clear();
        }
    }

    /**
     * Moves an object with a velocity that stays constant in its own frame, or reports what blocks it: straight ahead, along the
     * arc of a car, or in a turn in place. It turns while it translates; a {@link Move} turns after it.
     *
     * <p>The rules are those of {@link #move(String, Move)}, also for what the object touches at the start: the arc is swept as
     * the turn about its centre that it is. {@code fraction} and {@code turnFraction} are both the fraction of the time that is
     * free. It can be used: {@code fraction * seconds}, computed in doubles, is accepted with the same twist.
     *
     * <p>From a start in contact, the gap that counts as contact is 2<sup>-30</sup> of the object's largest distance from the centre
     * of its arc, as for other turns; else it is at most 2<sup>-25</sup> of the object's size.
     *
     * @param seconds at least 0
     * @throws IllegalArgumentException if it turns and climbs at once, a helix, in a SPATIAL world (or a tipped object does in
     *     any): {@link #driveFractions} measures such motions
     */
    public MoveResult move(String name, Twist twist, double seconds) {
        return move(name, twist, seconds, Avoidance.ALL);
    }

    /** The same with a margin that is kept all along the motion, and without the objects that do not count. */
    public MoveResult move(String name, Twist twist, double seconds, Avoidance avoid) {
        registry.begin("move");
        int id = arc(name, twist, seconds);
        Checks.present("avoid", avoid).begin(engine);
        try {
            boolean isFree = engine.batches().attemptTwist(view, id, twist, seconds, avoid.margin());
            MoveResult result = result(isFree);
            if (isFree) {
                engine.motion.commit();
            }
            return result;
        } finally {
            objects.ignored.clear();
        }
    }

    /** Checks a motion with a twist; returns the id of the object. */
    private int arc(String name, Twist twist, double seconds) {
        int id = registry.mover(name);
        engine.motion.checkTwist(view, id, Checks.present("twist", twist), seconds);
        return id;
    }

    /**
     * Makes a move along the world's axes, or reports what blocks it: a translation along them, then in place a turn by
     * {@code ry} about the world's Y and one by {@code rx} about the world's X, both through the object's centre. In
     * PLANAR an object turns about the vertical only, and {@code rx} is ignored, unlike in {@link #move}: the world's X lies
     * in the plane, and a plane has no turn about it.
     */
    public MoveResult moveGlobal(String name, Move move) {
        registry.begin("moveGlobal");
        return result(engine.moveGlobal(registry.mover(name), Checks.present("move", move)));
    }

    /**
     * Moves an object as far as it can go while every part of it keeps a clearance from everything, also from what it passes:
     * for docking. An object that has the clearance at the start has it at the end, by the distance that {@link #getProximity}
     * returns; on the path, and beside what it moves along at just the clearance, it is kept to rounding. From what is nearer at the start the object may move away, or along it, and
     * so past what lies behind it, such as the next tile of a wall.
     *
     * @param clearance world units; at least 0. With 0 it stops just before contact
     * @return {@code allowed} if the whole move was made; else the fractions that were made, with a contact in the gap that
     *     is left: it lies neither on the object nor on what blocks it
     */
    public MoveResult moveToContact(String name, Move move, double clearance) {
        registry.begin("moveToContact");
        int id = registry.mover(name);
        Checks.present("move", move);
        MoveResult result = result(engine.motion.attemptOwn(view, id, move, Checks.clearance(clearance)));
        engine.motion.commit();
        return result;
    }

    /** The same for a motion with a constant twist, as {@link #move(String, Twist, double)} makes it. */
    public MoveResult moveToContact(String name, Twist twist, double seconds, double clearance) {
        registry.begin("moveToContact");
        int id = arc(name, twist, seconds);
        MoveResult result =
                result(engine.batches().attemptTwist(view, id, twist, seconds, Checks.clearance(clearance)));
        engine.motion.commit();
        return result;
    }

    /**
     * Moves an object with a clearance, as {@link #moveAndSlide(String, Move, SlideOptions)} does, sliding along every surface.
     *
     * @param clearance world units; at least 0
     * @param bends     number of contacts after which the motion may go on; from 0, as {@code moveToContact}, to 64
     */
    public SlideResult moveAndSlide(String name, Move move, double clearance, int bends) {
        return moveAndSlide(name, move, SlideOptions.clearance(clearance).bends(bends));
    }

    /**
     * Moves an object and continues along what blocks it, along the plane of a contact or, between two planes, along their edge,
     * but never back against the displacement asked for; then turns it as far as that is free. The part of the displacement into
     * a plane is lost.
     *
     * <p>The clearance is kept from everything that the object passes or stops beside, and got back first where it was lost and
     * there is room: a level move (one whose displacement has no height) gets it back from walls only, and keeps the object's
     * height to the bit while all that it slides along is vertical. Without a clearance the object keeps a gap of
     * 2<sup>-36</sup> of the magnitudes of its bounds, so that seams of flat walls, which rounding puts an ulp before or behind
     * each other, do not stop it.
     *
     * <p>After it the object overlaps nothing that it did not overlap before.
     */
    public SlideResult moveAndSlide(String name, Move move, SlideOptions options) {
        registry.begin("moveAndSlide");
        int id = registry.mover(name);
        objects.toWorld(id, Checks.present("move", move).x(), move.y(), move.z(), vector);
        Slide slide = engine.slide();
        slide.set(
                Checks.present("options", options).clearance(),
                options.bends(),
                options.stepHeight(),
                options.maxSlope(),
                options.snap());
        slide.make(view, id, vector, move.rx(), move.ry());
        return SlideResult.of(slide, objects);
    }

    /**
     * Frees an object that touches or overlaps others, or is wedged between them: moves it, without turning it, by the smallest
     * displacement found to a place where it touches nothing. It passes through what it touches at the start, and through nothing
     * else. A displacement shorter than the one found may exist.
     *
     * @param max world units; at least 0. The search takes longer the more objects are within this distance
     * @return the displacement along the world's axes, zero if the object touches nothing; null, and the object stays where it
     *     is, if none of at most {@code max} was found
     */
    public @Nullable Point separate(String name, double max) {
        registry.begin("separate");
        int id = registry.mover(name);
        return engine.separate(id, Checks.size("max", max), vector) ? new Point(vector[0], vector[1], vector[2]) : null;
    }

    private MoveResult result(boolean allowed) {
        if (allowed) {
            return new MoveResult(true, 1, 1, null, null, null);
        }
        Motion motion = engine.motion;
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
        registry.begin("getRayDistance");
        return engine.beams.distance(view, ray, min, max, width, -1);
    }

    /** Distance along a ray at a given accuracy. */
    public double getRayDistance(Ray ray, double min, double max, double width, Accuracy accuracy) {
        registry.begin("getRayDistance");
        return engine.beams.distance(registry.at(accuracy), ray, min, max, width, -1);
    }

    /** Distance along a ray to the nearest object, ignoring the one of a given name. */
    public double getRayDistance(Ray ray, double min, double max, double width, String ignored) {
        registry.begin("getRayDistance");
        return engine.beams.distance(view, ray, min, max, width, registry.known(ignored));
    }

    /**
     * Distance that a sonar at the centre of a moveable object measures; the object itself does not echo.
     *
     * @param x forward component of the direction in the object's own frame
     * @param z component to the right
     */
    public double getSonarDistance(String name, double x, double z, double min, double max, double width) {
        registry.begin("getSonarDistance");
        int id = registry.mover(name);
        Checks.coordinate("x", x);
        Checks.coordinate("z", z);
        if (x == 0 && z == 0) {
            throw new IllegalArgumentException("direction must not be zero (got: x " + x + ", z " + z + ")");
        }
        return engine.beams.sonar(view, id, x, z, min, max, width);
    }

    /**
     * Distance that a sonar measures along a ray given in a moveable object's own frame; the object itself does not
     * echo.
     */
    public double getSonarDistance(String name, Ray mount, double min, double max, double width) {
        registry.begin("getSonarDistance");
        int id = registry.mover(name);
        return engine.beams.sonar(view, id, Checks.present("mount", mount), min, max, width);
    }

    /**
     * The smallest distance between an object and any other. To the bit, it is the minimum of the distances to each
     * other object alone; its error is within 2<sup>-43</sup> of the distance and of the sizes of the two.
     *
     * @param max range, world units; may be infinite
     * @return 0 in contact, {@code +Infinity} if nothing is within {@code max}
     */
    public double getProximity(String name, double max) {
        registry.begin("getProximity");
        int id = registry.known(name);
        Checks.range(0, max);
        return engine.proximity.of(view, id, max);
    }

    /**
     * The nearest object within a range, or the one in which an object is deepest, with the points, the direction and the
     * signed distance: what keeps a robot away from it, and by how much. It has the distance of {@link #getProximity}.
     *
     * @param max range, world units; may be infinite
     * @return null if nothing is within {@code max}
     */
    public @Nullable NearObject clearance(String name, double max) {
        return clearance(name, max, Avoidance.ALL);
    }

    /** The same without the objects that do not count; the margin does not matter. */
    public @Nullable NearObject clearance(String name, double max, Avoidance avoid) {
        registry.begin("clearance");
        int id = registry.known(name);
        Checks.range(0, max);
        Checks.present("avoid", avoid).begin(engine);
        try {
            ClearanceQuery query = engine.clearance();
            query.present(view, id);
            double found = query.signed(id, max);
            return found == Double.POSITIVE_INFINITY
                    ? null
                    : ObjectSearch.near(objects, query.object(), Math.max(0, found), query);
        } finally {
            objects.ignored.clear();
        }
    }

    /**
     * The signed distance of two objects of this world, as {@link
     * robosim.geometry.collision.ContactQuery#signedDistance(GeometryObject, GeometryObject) ContactQuery.signedDistance} has it
     * in the dimension of the world; below {@code EXACT} that of what stands for them.
     *
     * @param name  of any object, moveable or not
     * @param other of another one
     */
    public SignedDistance signedDistance(String name, String other) {
        registry.begin("signedDistance");
        int id = registry.known(name);
        int second = registry.known(other);
        if (id == second) {
            throw new IllegalArgumentException("other must be another object than name (got: \"" + other + "\")");
        }
        ClearanceQuery query = engine.clearance();
        query.present(view, id);
        query.measure(second, Double.POSITIVE_INFINITY);
        return ObjectSearch.signed(query);
    }

    /**
     * What a ray hits first within a range; null if it hits nothing. A ray that starts inside a solid hits it at
     * distance 0. In PLANAR the hit point keeps the height of the ray's start.
     */
    public @Nullable RayHit castRay(Ray ray, double max) {
        registry.begin("castRay");
        double distance = engine.beams.cast(view, ray, max, vector);
        return distance == Double.POSITIVE_INFINITY
                ? null
                : new RayHit(
                        distance,
                        new Point(
                                engine.beams.point(0, distance),
                                engine.beams.point(1, distance),
                                engine.beams.point(2, distance)),
                        new Point(vector[0], vector[1], vector[2]),
                        objects.present(engine.beams.hit()));
    }

    /**
     * The same without some objects: what a ray hits first behind them.
     *
     * @param ignored names of objects, or of {@linkplain GeometryObject#layers layers}, as in {@link Avoidance}
     */
    public @Nullable RayHit castRay(Ray ray, double max, Set<String> ignored) {
        registry.ignore(Checks.names("ignored", ignored));
        try {
            return castRay(ray, max);
        } finally {
            objects.ignored.clear();
        }
    }

    /**
     * A scan: rays from the centre of a moveable object in its own horizontal plane. Ray k points {@code firstDegrees +
     * k * stepDegrees} counter-clockwise from forward. In a PLANAR world, that of a tipped object looks up or down and sees
     * heights, as {@link #sense} describes.
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
        registry.begin("scan");
        Checks.present("mount", mount);
        engine.sensor.scan(registry.mover(name), mount, firstDegrees, stepDegrees, min, max, out);
    }

    @Override
    public void sense(String name, Pose mount, RayPattern pattern, SenseOptions options, SenseBuffer out) {
        registry.begin("sense");
        int id = registry.mover(Checks.present("name", name));
        engine.sensor.frame().mounted(id, Checks.present("mount", mount));
        sense(pattern, options, out);
    }

    @Override
    public void sense(Pose sensor, RayPattern pattern, SenseOptions options, SenseBuffer out) {
        registry.begin("sense");
        engine.sensor.frame().at(Checks.present("sensor", sensor));
        sense(pattern, options, out);
    }

    private void sense(RayPattern pattern, SenseOptions options, SenseBuffer out) {
        Checks.present("pattern", pattern);
        Checks.present("options", options);
        engine.sensor.senseAll(pattern, options, Checks.present("out", out).echoes());
    }

    @Override
    public void castRays(double[] rays, int count, SenseBuffer out) {
        castRays(engine, rays, count, out);
    }

    /** Answers rays in a world or a copy of it, as do the other methods of a given world. */
    static void castRays(World world, double[] rays, int count, SenseBuffer out) {
        world.registry.begin("castRays");
        world.rays.check(rays, count);
        world.rays.cast(world.view, rays, count, Checks.present("out", out).echoes());
    }

    @Override
    public int freeRays(double[] rays, int count, long[] free) {
        return freeRays(engine, rays, count, -1, free);
    }

    @Override
    public int freeRays(double[] rays, int count, String ignored, long[] free) {
        return freeRays(engine, rays, count, registry.known(Checks.present("ignored", ignored)), free);
    }

    static int freeRays(World world, double[] rays, int count, int ignored, long[] free) {
        world.registry.begin("freeRays");
        world.rays.check(rays, count);
        FreePlaces.checkRoom(count, free);
        return world.rays.free(world.view, rays, count, ignored, free);
    }

    @Override
    public int freePoses(String name, double[] poses, long[] free) {
        return freePoses(engine, name, poses, free);
    }

    static int freePoses(World world, String name, double[] poses, long[] free) {
        world.registry.begin("freePoses");
        int id = world.registry.mover(name);
        int count = FreePlaces.check("poses", poses, FreePlaces.POSE, free);
        return world.places().poses(world.view, id, poses, 0, count, free);
    }

    @Override
    public int freeEdges(String name, double[] edges, long[] free) {
        return freeEdges(engine, name, edges, free);
    }

    static int freeEdges(World world, String name, double[] edges, long[] free) {
        world.registry.begin("freeEdges");
        int id = world.registry.mover(name);
        int count = FreePlaces.check("edges", edges, FreePlaces.EDGE, free);
        return world.places().edges(world.view, id, edges, 0, count, free);
    }

    @Override
    public int freePoses(String name, double[] poses, Avoidance avoid, long[] free) {
        return PlaceBatch.poses(name, poses, avoid, free).answer(engine);
    }

    @Override
    public int freeEdges(String name, double[] edges, Avoidance avoid, long[] free) {
        return PlaceBatch.edges(name, edges, avoid, free).answer(engine);
    }

    @Override
    public int edgeFractions(String name, double[] edges, Avoidance avoid, double[] fractions) {
        return PlaceBatch.fractions(name, edges, avoid, fractions).answer(engine);
    }

    @Override
    public int driveFractions(String name, double[] drives, Avoidance avoid, double[] fractions) {
        return PlaceBatch.drives(name, drives, avoid, fractions).answer(engine);
    }

    @Override
    public int clearances(String name, double[] poses, double max, Avoidance avoid, double[] out) {
        return PlaceBatch.clearances(name, poses, max, avoid, out).answer(engine);
    }

    /**
     * Limits the work of each call from now on: one that would exceed it throws a {@link WorkLimitException}, and the world is
     * as it was before. {@link WorkLimit#none} takes a limit away. Worlds of a snapshot begin without one.
     */
    public void limitWork(WorkLimit limit) {
        registry.limit(Checks.present("limit", limit).counted());
        workLimit = limit;
    }

    /** The limit of the work of each call. */
    public WorkLimit workLimit() {
        return workLimit;
    }

    /** How many units of work the last call took, also one that was ended; 0 if none was made since {@link #limitWork}. */
    public long workDone() {
        return registry.work.done();
    }

    /**
     * Makes calls as one: under a limit of work they share the units of a single call, and if they end with an exception of any
     * kind, the world is as it was before the first of them. What was moved, placed, added or removed is put back; objects and
     * their order, places and headings are the same to the bit.
     *
     * <pre>{@code
     * Geometry geometry = new Geometry(20, 5, 20);
     * geometry.addObject(new CylinderObject(new Point(0, 0, 0), 0.3, 1).moveable("robot"));
     * geometry.together("a round", () -> {
     *     geometry.move("robot", new Move(1, 0, 0, 0, 0));
     *     return geometry.move("robot", new Move(0, 0, 0, 0, 90)).allowed();
     * });  // true
     * }</pre>
     *
     * @param call  what messages about the limit call it
     * @param calls use this world on the calling thread
     * @return what {@code calls} returns
     */
    public <T extends @Nullable Object> T together(String call, Supplier<T> calls) {
        return registry.together(Checks.present("call", call), Checks.present("calls", calls));
    }

    /** As in {@code SPATIAL EXACT world of 20.0 x 5.0 x 20.0 with 113 objects, 8 of them moveable}. */
    @Override
    public String toString() {
        return dimension() + " " + accuracy() + " world of " + width() + " x " + height() + " x " + length() + " with "
                + objects.ids().count() + " objects, " + objects.moverCount() + " of them moveable";
    }
}
