package robosim.geometry.engine;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import robosim.geometry.engine.broadphase.AccuracyView;
import robosim.geometry.engine.broadphase.ObjectRegistry;
import robosim.geometry.engine.broadphase.TouchQuery;
import robosim.geometry.engine.motion.ClearanceQuery;
import robosim.geometry.engine.motion.FreePlaces;
import robosim.geometry.engine.motion.FreeingSearch;
import robosim.geometry.engine.motion.Motion;
import robosim.geometry.engine.motion.PlaceBatches;
import robosim.geometry.engine.motion.Placer;
import robosim.geometry.engine.motion.Slide;
import robosim.geometry.engine.objects.IgnoredPairs;
import robosim.geometry.engine.objects.ObjectTable;
import robosim.geometry.engine.sensing.BeamQuery;
import robosim.geometry.engine.sensing.NearestQuery;
import robosim.geometry.engine.sensing.PatternSensor;
import robosim.geometry.engine.sensing.ProximityQuery;
import robosim.geometry.engine.sensing.RayBatch;
import robosim.geometry.exact.Attitude;
import robosim.geometry.exact.DoubleDouble;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.Move;
import robosim.geometry.model.Pose;
import robosim.geometry.narrow.Scratch;

/**
 * A world: its objects by their ids, what moves them and what senses them. {@code Geometry} wraps it, checks arguments and finds
 * the ids of names; dynamics holds it as it is. The methods that move an object allocate nothing.
 *
 * <p>Its parts are public, since each is a whole: {@link #registry} for what is added, removed and counted, {@link #motion} for
 * what blocks, and one part for each kind of query. What not every world needs is made on first use.
 */
public final class World {
    /** Where nothing blocks; see {@link Motion#obstacle}. */
    public static final int NOTHING = Motion.NOTHING;

    /** Where the border of the world blocks. */
    public static final int BORDER = Motion.BORDER;

    public final double width;
    public final double height;
    public final double length;
    public final Dimension dimension;
    public final ObjectRegistry registry;
    public final ObjectTable objects;
    public final AccuracyView view;
    public final Motion motion;
    public final BeamQuery beams;
    public final PatternSensor sensor;
    public final RayBatch rays;
    public final ProximityQuery proximity;
    private final Scratch scratch;
    private @Nullable FreePlaces places;
    private @Nullable PlaceBatches batches;
    private @Nullable ClearanceQuery clearance;
    private @Nullable Slide slide;
    private @Nullable TouchQuery touching;
    private @Nullable NearestQuery nearest;
    private final double[] vector = new double[3];
    private final double[] place = new double[ObjectTable.PLACE];

    /**
     * A world of the objects of a registry.
     *
     * @param scratch that of the registry
     */
    public World(ObjectRegistry registry, Scratch scratch) {
        this.registry = registry;
        this.scratch = scratch;
        width = registry.width;
        height = registry.height;
        length = registry.length;
        dimension = registry.dimension;
        objects = registry.objects;
        view = registry.view;
        beams = new BeamQuery(objects, scratch);
        sensor = new PatternSensor(registry, beams, scratch);
        rays = new RayBatch(dimension, beams);
        proximity = new ProximityQuery(objects, scratch);
        motion = new Motion(registry, scratch);
    }

    /** The id of a moveable object that must be there. */
    public int mover(String name) {
        return registry.mover(name);
    }

    /** Begins a call that consists of several, such as a step. They share one budget of work, up to {@link #end}. */
    public void begin(String call) {
        registry.open(call);
    }

    /** Ends such a call. */
    public void end() {
        registry.close();
    }

    /** Counts a unit of its work, which may end it. */
    public void take() {
        registry.work.take();
    }

    /** Whether calls may be ended by a limit of work. */
    public boolean isLimited() {
        return registry.isLimited();
    }

    /** What stands for an object in queries that name no accuracy. */
    public Accuracy accuracy() {
        return view.accuracy;
    }

    /** What blocked the last motion: an id, {@link #NOTHING} or {@link #BORDER}. */
    public int obstacle() {
        return motion.obstacle();
    }

    /** Answers batches of poses and edges. */
    public FreePlaces places() {
        FreePlaces made = places == null ? new FreePlaces(registry, motion, scratch) : places;
        places = made;
        return made;
    }

    /** Answers batches with a margin, with ignored objects, or with more than a bit. */
    public PlaceBatches batches() {
        PlaceBatches made = batches == null ? new PlaceBatches(registry, motion, places(), clearance()) : batches;
        batches = made;
        return made;
    }

    /** Measures how far an object is from others, with points. */
    public ClearanceQuery clearance() {
        ClearanceQuery made = clearance == null ? new ClearanceQuery(objects, scratch) : clearance;
        clearance = made;
        return made;
    }

    /** Moves objects along what blocks them. */
    public Slide slide() {
        Slide made = slide == null ? new Slide(registry, motion) : slide;
        slide = made;
        return made;
    }

    /** Finds what an object touches. */
    public TouchQuery touching() {
        TouchQuery made = touching == null ? new TouchQuery(registry, scratch) : touching;
        touching = made;
        return made;
    }

    /** Finds the nearest objects. */
    public NearestQuery nearest() {
        NearestQuery made = nearest == null ? new NearestQuery(objects, scratch) : nearest;
        nearest = made;
        return made;
    }

    /** Moves an object out of what it overlaps; see {@link FreeingSearch#find}. */
    public boolean separate(int id, double max, double[] out) {
        return new FreeingSearch(registry, motion, slide()).find(view, id, max, out);
    }

    /** Pairs of objects that pass through each other in steps; none so far. */
    public IgnoredPairs ignoredPairs() {
        return new IgnoredPairs(objects, registry.attachments);
    }

    /** Puts objects at places of any attitude. */
    public Placer placer() {
        return new Placer(registry, motion);
    }

    /** Whether queries see the objects as they are, and not enclosures. */
    public boolean isExact() {
        return accuracy() == Accuracy.EXACT;
    }

    /** Makes a straight move along the object's own axes if all of it is free. */
    public boolean translateOwn(int id, double x, double y, double z) {
        objects.toWorld(id, x, y, z, vector);
        return motion.allows(view, id, vector[0], vector[1], vector[2]) && motion.commit();
    }

    /** Makes a straight move along the world's axes if all of it is free. */
    public boolean translate(int id, double dx, double dy, double dz) {
        return motion.allows(view, id, dx, dy, dz) && motion.commit();
    }

    /** Makes a turn about the vertical if all of it is free. */
    public boolean turn(int id, double degrees) {
        return motion.allowsTurn(view, id, degrees) && motion.commit();
    }

    /** Makes a move along the object's own axes and about them if all of it is free. */
    public boolean moveOwn(int id, Move move) {
        return motion.attemptOwn(view, id, move, 0) && motion.commit();
    }

    /** Makes a move along the world's axes and about them if all of it is free. */
    public boolean moveGlobal(int id, Move move) {
        double rx = dimension == Dimension.PLANAR ? 0 : move.rx(); // a plane has no turn about its X
        return motion.attempt(view, id, move.x(), move.y(), move.z(), rx, move.ry(), 0) && motion.commit();
    }

    /**
     * Moves an object along the world's axes and then turns it about the vertical as far as both are free, with a gap to the piece
     * that blocks and to no other; returns whether all was free.
     */
    public boolean moveToContact(int id, double dx, double dz, double degrees, double gap) {
        boolean isFree = motion.attemptBeside(view, id, dx, 0, dz, degrees, gap);
        motion.commit();
        return isFree;
    }

    /** What blocks a displacement and then a turn about the vertical: an id, {@link #NOTHING} or {@link #BORDER}. Nothing moves. */
    public int blocker(int id, double dx, double dz, double degrees) {
        return motion.attempt(view, id, dx, 0, dz, 0, degrees, 0) ? NOTHING : motion.obstacle();
    }

    /**
     * Puts an object where {@link #translate} along X and Z and then {@link #turn} would, to the bit, without a check: only for what
     * is known to be free.
     */
    public void put(int id, double dx, double dz, double degrees) {
        System.arraycopy(objects.places(), objects.place(id), place, 0, ObjectTable.PLACE);
        add(0, dx);
        add(2, dz);
        if (degrees != 0) {
            Attitude.turnVertically(place, ObjectTable.ROTATION, degrees);
        }
        registry.move(id, place);
    }

    private void add(int along, double by) {
        double from = place[along];
        double to = from + by;
        double rest = DoubleDouble.sumTail(from, by, to) + place[Pose.LOST + along];
        double sum = to + rest;
        place[along] = sum;
        place[Pose.LOST + along] = DoubleDouble.sumTail(to, rest, sum);
    }

    /** The places of all moveable objects, for {@link #putBack}. */
    public double[] placesOfMovers() {
        return Arrays.copyOf(objects.places(), objects.moverCount() * ObjectTable.PLACE);
    }

    /** Puts all moveable objects back to where they were; none has been added or removed since. */
    public void putBack(double[] places) {
        for (int k = 0; k < objects.moverCount(); k++) {
            int id = objects.mover(k);
            int at = objects.place(id);
            if (!Arrays.equals(objects.places(), at, at + ObjectTable.PLACE, places, at, at + ObjectTable.PLACE)) {
                System.arraycopy(places, at, place, 0, ObjectTable.PLACE);
                registry.move(id, place);
            }
        }
    }
}
