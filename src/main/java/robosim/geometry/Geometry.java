package robosim.geometry;

import java.util.List;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import robosim.geometry.engine.broadphase.SharedIndex;
import robosim.geometry.engine.motion.Carrier;
import robosim.geometry.exact.Checks;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;
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
public final class Geometry extends GeometryQueries {
    static {
        Carrier.open(world -> ((Geometry) world).moves.carrier());
    }

    private final double width;
    private final double height;
    private final double length;
    private final Dimension dimension;
    private final Accuracy accuracy;
    private final GeometryMoves moves;
    private @Nullable ObjectSearch search;
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
        super(width, height, length, dimension, accuracy, shared, scratch);
        this.width = width;
        this.height = height;
        this.length = length;
        this.dimension = dimension;
        this.accuracy = accuracy;
        moves = new GeometryMoves(dimension, registry, motion, scratch);
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

    /** Removes an object; returns false if there is none of that name. */
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
        return registry.place(id, center, heading) || places().stand(view, id, center, heading);
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
        return moves.straight(registry.mover(name), x, y, z);
    }

    /**
     * Turns an object about the vertical through its centre.
     *
     * @param degrees counter-clockwise seen from above
     * @return false, and it stays as it is, if anything blocks the turn
     */
    public boolean simpleTurn(String name, double degrees) {
        registry.begin("simpleTurn");
        return moves.turn(registry.mover(name), degrees);
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
        return moves.own(registry.mover(name), Checks.present("move", move));
    }

    /**
     * Makes a move along the world's axes, or reports what blocks it: a translation along them, then in place a turn by
     * {@code ry} about the world's Y and one by {@code rx} about the world's X, both through the object's centre. In
     * PLANAR an object turns about the vertical only, and {@code rx} is ignored, unlike in {@link #move}: the world's X lies
     * in the plane, and a plane has no turn about it.
     */
    public MoveResult moveGlobal(String name, Move move) {
        registry.begin("moveGlobal");
        return moves.global(registry.mover(name), Checks.present("move", move));
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
        return moves.toContact(registry.mover(name), Checks.present("move", move), clearance);
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
        return moves.sliding(registry.mover(name), Checks.present("move", move), Checks.present("options", options));
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
        return moves.separate(registry.mover(name), Checks.size("max", max));
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
        return dimension + " " + accuracy + " world of " + width + " x " + height + " x " + length + " with "
                + objects.ids().count() + " objects, " + objects.moverCount() + " of them moveable";
    }
}
