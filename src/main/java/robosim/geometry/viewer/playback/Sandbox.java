package robosim.geometry.viewer.playback;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import robosim.geometry.Geometry;
import robosim.geometry.MoveResult;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;
import robosim.geometry.viewer.scene.Scene;
import robosim.geometry.world.shared.ObjectNames;

/**
 * The viewer's own copy of a world, in which the user can push robots. Changes affect nothing else.
 */
public final class Sandbox {
    private final Geometry geometry;
    private final Frame.Setting setting;
    private final WorldSonars sonars;

    /** Moveable objects outside the world's bounds, by name; none is part of the world until it is put into it. */
    private final Map<String, GeometryObject> outside = new LinkedHashMap<>();

    /** What was refused last; null if nothing was. */
    private @Nullable Refused refused;

    /**
     * A place that was refused.
     *
     * @param ghost     the object at that place
     * @param obstacles what is in the way; empty for the world's bounds
     */
    public record Refused(GeometryObject ghost, List<GeometryObject> obstacles) {
        public String words() {
            if (obstacles.isEmpty()) {
                return "the border of the world";
            }
            String first = ObjectNames.of(obstacles.get(0));
            return obstacles.size() == 1 ? first : first + " and " + (obstacles.size() - 1) + " more";
        }
    }

    /** How a robot is pushed. */
    public enum Push {
        /** Put there, whatever is in between. */
        PLACE,
        /** Moved there in a straight line, if the whole way is free. */
        MOVE
    }

    private Sandbox(Geometry geometry, Frame.Setting setting, WorldSonars sonars) {
        this.geometry = geometry;
        this.setting = setting;
        this.sonars = sonars;
    }

    /** A separate world with the given moveable objects at their places, which have sonars. */
    public static Sandbox of(Frame.Setting setting, List<Scene.Thing> movers, WorldSonars sonars) {
        Geometry geometry = empty(setting);
        for (Scene.Thing thing : setting.statics()) {
            geometry.addObjectUnchecked(thing.object());
        }
        Sandbox sandbox = new Sandbox(geometry, setting, sonars);
        for (Scene.Thing thing : movers) {
            GeometryObject object = thing.object();
            if (!geometry.addObjectUnchecked(object)) {
                sandbox.outside.put(String.valueOf(object.name()), object);
            }
        }
        return sandbox;
    }

    private static Geometry empty(Frame.Setting setting) {
        return new Geometry(
                setting.width(), setting.height(), setting.length(), setting.dimension(), setting.accuracy());
    }

    /** Pushes a robot to a point at its own height; if that is refused it stays. */
    public void push(String name, double x, double z, Push push) {
        GeometryObject beyond = outside.get(name);
        if (beyond != null) {
            enter(name, beyond.movedTo(new Point(x, beyond.center().y(), z)));
            return;
        }
        GeometryObject before = geometry.getObject(name);
        Point from = before.center();
        Point to = new Point(x, from.y(), z);
        if (push == Push.PLACE && before.pose().isUpright()) {
            boolean placed = geometry.placeObject(name, to, before.heading());
            refused = placed ? null : refusal(before.movedTo(to));
            return;
        }
        MoveResult result = geometry.moveGlobal(name, new Move(x - from.x(), 0, z - from.z(), 0, 0));
        refused = result.allowed() ? null : refusal(before.movedTo(to), result);
    }

    /** Turns a robot in place; if that is refused it stays. */
    public void turn(String name, double degrees) {
        GeometryObject beyond = outside.get(name);
        if (beyond != null) {
            enter(name, beyond.turned(0, degrees));
            return;
        }
        GeometryObject before = geometry.getObject(name);
        MoveResult result = geometry.move(name, new Move(0, 0, 0, 0, degrees));
        refused = result.allowed() ? null : refusal(before.turned(0, degrees), result);
    }

    /** Puts an object from outside into the world without checking a path, since there is none. */
    private void enter(String name, GeometryObject there) {
        if (geometry.addObject(there)) {
            outside.remove(name);
            refused = null;
        } else {
            refused = refusal(there);
        }
    }

    private static Refused refusal(GeometryObject ghost, MoveResult result) {
        GeometryObject obstacle = result.obstacle();
        return new Refused(ghost, obstacle == null ? List.of() : List.of(obstacle));
    }

    /** Finds which objects the ghost would touch. */
    private Refused refusal(GeometryObject ghost) {
        List<GeometryObject> obstacles = new ArrayList<>();
        Geometry alone = empty(setting);
        if (alone.addObjectUnchecked(ghost)) {
            for (GeometryObject object : geometry.objects()) {
                boolean self = object.name() != null && object.name().equals(ghost.name());
                if (!self && alone.testObject(object)) {
                    obstacles.add(object);
                }
            }
        }
        return new Refused(ghost, obstacles);
    }

    @Nullable
    public Refused refused() {
        return refused;
    }

    /** What the sonars measure where the robots are now, by name. */
    public Map<String, List<Scene.Ping>> measured() {
        return sonars.measure(geometry);
    }

    /** The moveable objects at their present places. */
    public List<Scene.Thing> movers() {
        List<Scene.Thing> movers = new ArrayList<>();
        for (Scene.Thing thing : setting.movers()) {
            String name = thing.object().name();
            GeometryObject beyond = outside.get(name);
            if (beyond != null) {
                movers.add(new Scene.Thing(beyond, thing.colour()));
            } else if (name != null && geometry.hasObject(name)) {
                movers.add(new Scene.Thing(geometry.getObject(name), thing.colour()));
            }
        }
        return movers;
    }
}
