package robosim.geometry.world;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import robosim.geometry.Geometry;
import robosim.geometry.check.Checks;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.render.Lighting;
import robosim.geometry.world.shared.Floor;

/**
 * The content of a world file: its settings and its objects, in their order. A value; {@link #toGeometry()} creates a
 * geometry from it that moves objects and measures.
 *
 * @param width     extent along X in world units, about the origin; above 0 and at most 2<sup>101</sup>
 * @param height    extent along Y; the ground is at {@code -height / 2}
 * @param length    extent along Z
 * @param unit      what one world unit is, for users and for lengths with their own unit; null if unspecified
 * @param dimension whether heights count
 * @param accuracy  what stands for an object in a query
 * @param objects   with names that are unique among them
 * @param lighting  in which pictures show it; null for that of a clear day
 * @param scenery   what pictures show beside the objects and nothing collides with: static, without names
 */
public record World(
        double width,
        double height,
        double length,
        @Nullable Unit unit,
        Dimension dimension,
        Accuracy accuracy,
        List<WorldObject> objects,
        @Nullable Lighting lighting,
        List<GeometryObject> scenery) {

    /** Refuses invalid sizes, and two objects of one name. */
    public World {
        width = size("width", width);
        height = size("height", height);
        length = size("length", length);
        Checks.present("dimension", dimension);
        Checks.present("accuracy", accuracy);
        objects = Checks.list("objects", objects);
        Set<String> names = new HashSet<>();
        for (WorldObject object : objects) {
            String name = object.object().name();
            if (name != null && !names.add(name)) {
                throw new IllegalArgumentException("names must be unique in a world (got twice: " + name + ")");
            }
        }
        checkAttached(objects);
        scenery = Checks.list("scenery", scenery);
        for (GeometryObject each : scenery) {
            if (each.name() != null || each.isMoveable() || each.visuals() != null) {
                throw new IllegalArgumentException(
                        "scenery must be static, without names and without visuals (got: " + each + ")");
            }
        }
    }

    private static void checkAttached(List<WorldObject> objects) {
        Map<String, WorldObject> movers = new HashMap<>();
        for (WorldObject each : objects) {
            String name = each.object().name();
            if (name != null && each.object().isMoveable()) {
                movers.put(name, each);
            }
        }
        for (WorldObject each : objects) {
            Set<WorldObject> below = new HashSet<>(Set.of(each));
            for (String carrier = each.attached(); carrier != null; ) {
                WorldObject found = movers.get(carrier);
                if (found == null || !below.add(found)) {
                    throw new IllegalArgumentException(
                            "attached must be the name of another moveable object of the world"
                                    + ", which is not attached to this one (got: \""
                                    + each.object().name() + "\" to \"" + carrier
                                    + "\")");
                }
                carrier = found.attached();
            }
        }
    }

    /** A SPATIAL world with accuracy EXACT, without a unit. */
    public World(double width, double height, double length, List<WorldObject> objects) {
        this(width, height, length, null, Dimension.SPATIAL, Accuracy.EXACT, objects);
    }

    /** A world on a clear day. */
    public World(
            double width,
            double height,
            double length,
            @Nullable Unit unit,
            Dimension dimension,
            Accuracy accuracy,
            List<WorldObject> objects) {
        this(width, height, length, unit, dimension, accuracy, objects, null, List.of());
    }

    private static double size(String argument, double value) {
        if (!(value > 0 && value <= 0x1p101)) { // written so that NaN fails it
            throw new IllegalArgumentException(argument + " must be above 0 and at most 2^101 (got: " + value + ")");
        }
        return value;
    }

    /** A world of the same size and settings with other objects. */
    public World withObjects(List<WorldObject> others) {
        return new World(width, height, length, unit, dimension, accuracy, others, lighting, scenery);
    }

    /** The same world in other light; null for that of a clear day. */
    public World withLighting(@Nullable Lighting newLighting) {
        return new World(width, height, length, unit, dimension, accuracy, objects, newLighting, scenery);
    }

    /** The same world with other scenery. */
    public World withScenery(List<GeometryObject> newScenery) {
        return new World(width, height, length, unit, dimension, accuracy, objects, lighting, newScenery);
    }

    /** The light in which pictures show the world: its own, or that of a clear day. */
    public Lighting light() {
        return lighting == null ? Lighting.DAY : lighting;
    }

    /**
     * The same world where heights do not count, without its floors and roofs: a static box that fills the world would be in
     * the way of everything there.
     */
    public World planar() {
        List<WorldObject> standing = objects.stream()
                .filter(each -> !Floor.isFloor(each.object(), width, length))
                .toList();
        return new World(width, height, length, unit, Dimension.PLANAR, accuracy, standing, lighting, scenery);
    }

    /** The same world where heights count. */
    public World spatial() {
        return new World(width, height, length, unit, Dimension.SPATIAL, accuracy, objects, lighting, scenery);
    }

    /**
     * The objects as a geometry has them, in their order: what is attached is a part of its carrier, a group. Objects beyond the
     * world's bounds come last.
     */
    public List<GeometryObject> joined() {
        if (objects.stream().allMatch(each -> each.attached() == null)) {
            return objects.stream().map(WorldObject::object).toList();
        }
        List<GeometryObject> outside = new ArrayList<>();
        List<GeometryObject> joined =
                new ArrayList<>(toGeometry(each -> outside.add(each.object())).objects());
        joined.addAll(outside);
        return List.copyOf(joined);
    }

    /**
     * A geometry of this world with all its objects, added unchecked in their order: they may overlap, as the walls of
     * a plan do.
     *
     * @throws IllegalArgumentException naming the objects that extend beyond the world's bounds
     */
    public Geometry toGeometry() {
        List<String> outside = new ArrayList<>();
        Geometry geometry = toGeometry(refused -> outside.add(refused.object().toString()));
        if (!outside.isEmpty()) {
            throw new IllegalArgumentException("every object must lie within the world of " + width + " x " + height
                    + " x " + length + " about the origin; enlarge the world or move them (got outside: "
                    + String.join("; ", outside) + ")");
        }
        return geometry;
    }

    /**
     * A geometry of this world with all objects that fit in, added unchecked in their order.
     *
     * @param refused receives each object that extends beyond the world's bounds and was left out
     */
    public Geometry toGeometry(Consumer<WorldObject> refused) {
        Checks.present("refused", refused);
        Geometry geometry = new Geometry(width, height, length, dimension, accuracy);
        for (WorldObject object : objects) {
            if (!geometry.addObjectUnchecked(object.object())) {
                refused.accept(object);
            }
        }
        for (WorldObject each : objects) {
            String carrier = each.attached();
            String name = each.object().name();
            if (carrier != null && name != null && geometry.hasObject(name) && geometry.hasObject(carrier)) {
                geometry.attach(carrier, name);
            }
        }
        return geometry;
    }
}
