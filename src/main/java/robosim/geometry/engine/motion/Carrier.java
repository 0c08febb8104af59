package robosim.geometry.engine.motion;

import java.util.Arrays;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import robosim.geometry.engine.broadphase.ObjectRegistry;
import robosim.geometry.engine.objects.ObjectTable;
import robosim.geometry.exact.Attitude;
import robosim.geometry.exact.DoubleDouble;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Pose;

/**
 * Moves the objects of a world by their ids, as {@code Geometry} does by their names, and allocates nothing: for the rooms of
 * this module that move many.
 */
public final class Carrier {
    /** Where nothing blocks; see {@link #obstacle}. */
    public static final int NOTHING = Motion.NOTHING;

    /** Where the border of the world blocks. */
    public static final int BORDER = Motion.BORDER;

    private static @Nullable Function<Object, Carrier> door;

    public final ObjectTable objects;

    private final ObjectRegistry registry;
    private final Motion motion;
    private final TranslationFastPath fastPath;
    private final double[] place = new double[ObjectTable.PLACE];

    public Carrier(ObjectRegistry registry, Motion motion, TranslationFastPath fastPath) {
        this.registry = registry;
        this.motion = motion;
        this.fastPath = fastPath;
        objects = registry.objects;
    }

    /** Tells once how a world gives its carrier; called by the class of worlds. */
    public static void open(Function<Object, Carrier> way) {
        door = way;
    }

    /** The carrier of a world. */
    public static Carrier of(Object world) {
        Function<Object, Carrier> way = door;
        if (way == null) {
            throw new IllegalStateException("world must be a Geometry (got: " + world.getClass() + ")");
        }
        return way.apply(world);
    }

    /** Begins a call that is made of others, as a step is, with one budget of work for all of them, up to {@link #end}. */
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

    /** The places of all moveable objects, to put them back there. */
    public double[] places() {
        return Arrays.copyOf(objects.places(), objects.moverCount() * ObjectTable.PLACE);
    }

    /** Puts all moveable objects back to where they were; none has come or gone since. */
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

    /** The id of a moveable object that must be there. */
    public int mover(String name) {
        return registry.mover(name);
    }

    /** Makes a translation if all of it is free. */
    public boolean translate(int id, double dx, double dy, double dz) {
        int verdict = fastPath.ask(registry.view, id, dx, dy, dz);
        if (verdict == TranslationFastPath.FREE) {
            registry.shift(id, fastPath.end());
            return true;
        }
        if (verdict == TranslationFastPath.UNKNOWN && motion.allows(registry.view, id, dx, dy, dz)) {
            registry.move(id, motion.end());
            return true;
        }
        return false;
    }

    /** Makes a turn about the vertical if all of it is free. */
    public boolean turn(int id, double degrees) {
        if (!turnsInItself(id)) {
            if (!motion.allowsTurn(registry.view, id, degrees)) {
                return false;
            }
            registry.move(id, motion.end());
            return true;
        }
        System.arraycopy(objects.places(), objects.place(id), place, 0, ObjectTable.PLACE);
        Attitude.turnVertically(place, 3, degrees);
        registry.move(id, place);
        return true;
    }

    /** Whether the objects of the world collide as they are. */
    public boolean isExact() {
        return registry.view.accuracy == Accuracy.EXACT;
    }

    /**
     * Puts an object where a displacement along X and Z and then a turn about the vertical take it: to the bit where
     * {@link #translate} and {@link #turn} would, but nothing is asked. Only for what is known to be free.
     */
    public void put(int id, double dx, double dz, double degrees) {
        System.arraycopy(objects.places(), objects.place(id), place, 0, ObjectTable.PLACE);
        add(0, dx);
        add(2, dz);
        if (degrees != 0) {
            Attitude.turnVertically(place, 3, degrees);
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

    /** Whether a turn about the vertical takes the object to the same points, to the bit: one upright disc about its centre. */
    private boolean turnsInItself(int id) {
        boolean isRound = switch (objects.value(id).kind()) {
            case CYLINDER, SPHERE, CAPSULE -> true;
            case BOX, MESH, GROUP, GRID -> false;
        };
        return isRound
                && registry.view.accuracy == Accuracy.EXACT
                && Attitude.isUpright(objects.places(), objects.place(id) + 3);
    }

    /**
     * Goes by a displacement and then a turn about the vertical as far as both are free; answers whether all was.
     *
     * @param gap how far to stay from what blocks
     */
    public boolean toContact(int id, double dx, double dy, double dz, double degrees, double gap) {
        boolean all = motion.attemptBeside(registry.view, id, dx, dy, dz, degrees, gap);
        registry.move(id, motion.end());
        return all;
    }

    /** Asks who blocks a displacement and then a turn, and moves nothing: an id, {@link #NOTHING} or {@link #BORDER}. */
    public int blocker(int id, double dx, double dy, double dz, double degrees) {
        return motion.attempt(registry.view, id, dx, dy, dz, 0, degrees, true, 0) ? NOTHING : motion.obstacle();
    }

    /** Puts objects at places of any attitude. */
    public Placer placer() {
        return new Placer(registry, motion);
    }

    /** What blocked last: an id, {@link #NOTHING} or {@link #BORDER}. */
    public int obstacle() {
        return motion.obstacle();
    }

    /** Contact point and normal of what blocked last, six numbers. */
    public void contact(double[] out) {
        motion.contact(out);
    }
}
