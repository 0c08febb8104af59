package robosim.geometry.engine.objects;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import org.jspecify.annotations.Nullable;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Pose;

/**
 * Which objects of a world are attached to others. A carrier with its loads is one object of the world, a group under the
 * carrier's name (see {@link ObjectGroup#loads}), so that every query and every move treats them as one; this table finds the
 * loads by their names.
 */
public final class Attachments {
    /**
     * An attached object.
     *
     * @param root  the name of the object of the world that it is a part of
     * @param birth see {@link #birth}
     */
    private record Attached(String root, long birth) {}

    private final Map<String, Attached> attached = new HashMap<>();

    /** For objects that were attached and no longer are, when they came into the world at first. */
    private final Map<String, Long> births = new HashMap<>();

    /** Whether nothing is attached and nothing was. */
    public boolean isEmpty() {
        return attached.isEmpty() && births.isEmpty();
    }

    /** The name of the object of the world that has an attached object as a part; null for any other name. */
    public @Nullable String root(String name) {
        Attached found = attached.isEmpty() ? null : attached.get(name);
        return found == null ? null : found.root;
    }

    /**
     * When an object came into the world at first. Attaching and detaching does not change it, while the order among the arrivals
     * is that of the last time it came; no two objects share it.
     *
     * @param arrival its present place among the arrivals
     */
    public long birth(String name, long arrival) {
        Attached part = attached.get(name);
        return part != null ? part.birth : births.getOrDefault(name, arrival);
    }

    /** Remembers when an object came at first that is about to become a part, or stops being one. */
    public void keepBirth(String name, long birth) {
        births.put(name, birth);
    }

    /** Refuses an object whose names are taken, its loads included. */
    public void check(GeometryObject object, ObjectTable objects) {
        Map<String, String> seen = new HashMap<>();
        forEachLoad(object, load -> {
            String name = String.valueOf(load.name());
            if (objects.find(name) >= 0
                    || attached.containsKey(name)
                    || name.equals(object.name())
                    || seen.put(name, name) != null) {
                throw new IllegalArgumentException(
                        "the names of loads must be unique in their world (got: \"" + name + "\" again)");
            }
        });
    }

    /** An object came into the world. */
    public void added(GeometryObject object, long arrival) {
        forEachLoad(object, load -> {
            String name = String.valueOf(load.name());
            Long birth = births.remove(name);
            attached.put(name, new Attached(String.valueOf(object.name()), birth == null ? -1 - arrival : birth));
        });
    }

    /** An object leaves the world. */
    public void removed(GeometryObject object) {
        births.remove(String.valueOf(object.name()));
        forEachLoad(object, load -> attached.remove(String.valueOf(load.name())));
    }

    /** What this table holds, for {@link #restore}. */
    public Attachments copy() {
        Attachments copy = new Attachments();
        copy.restore(this);
        return copy;
    }

    /** Takes back all that was changed since a copy was made. */
    public void restore(Attachments from) {
        attached.clear();
        attached.putAll(from.attached);
        births.clear();
        births.putAll(from.births);
    }

    private static void forEachLoad(GeometryObject object, Consumer<GeometryObject> each) {
        if (object instanceof ObjectGroup group) {
            for (GeometryObject load : group.loads()) {
                each.accept(load);
                forEachLoad(load, each);
            }
        }
    }

    /** Whether anything is attached to an object. */
    public static boolean carries(GeometryObject object) {
        return object instanceof ObjectGroup group && !group.loads().isEmpty();
    }

    /** Runs something for the carrier itself without its loads and for each load, with names, at their places. */
    public static void forEachPart(GeometryObject placed, BiConsumer<String, Pose> each) {
        each.accept(String.valueOf(placed.name()), placed.pose());
        if (placed instanceof ObjectGroup group) {
            for (GeometryObject load : group.loads()) {
                forEachPart(load.at(load.pose().within(placed.pose())), each);
            }
        }
    }

    /** The part of an object that has a name, itself included, at its place; null if there is none. */
    public static @Nullable GeometryObject find(GeometryObject placed, String name) {
        if (name.equals(placed.name())) {
            return placed;
        }
        if (placed instanceof ObjectGroup group) {
            for (GeometryObject load : group.loads()) {
                GeometryObject found = find(load.at(load.pose().within(placed.pose())), name);
                if (found != null) {
                    return found;
                }
            }
        }
        return null;
    }

    /** The name of the part to which a load is attached; null if it is none of this object. */
    public static @Nullable String carrier(GeometryObject object, String load) {
        if (object instanceof ObjectGroup group) {
            for (GeometryObject each : group.loads()) {
                String found = load.equals(each.name()) ? object.name() : carrier(each, load);
                if (found != null) {
                    return found;
                }
            }
        }
        return null;
    }

    /** An object one part of which has been given one more load, at a pose in the frame of that part. */
    public static GeometryObject with(GeometryObject object, String carrier, GeometryObject load, Pose pose) {
        if (load instanceof GridObject) {
            throw new IllegalArgumentException("load must not be a grid (got: " + load + ")");
        }
        return changed(object, carrier, part -> {
            List<GeometryObject> members = new ArrayList<>();
            if (part instanceof ObjectGroup group && carries(part)) {
                members.addAll(group.members());
            } else {
                members.add(part.at(Pose.ORIGIN));
            }
            members.add(load.at(pose));
            return group(part, members);
        });
    }

    /** An object without a load of its part of a name. */
    public static GeometryObject without(GeometryObject object, String carrier, String load) {
        return changed(object, carrier, part -> {
            List<GeometryObject> members = new ArrayList<>(((ObjectGroup) part).members());
            members.removeIf(each -> load.equals(each.name()));
            return members.size() == 1 ? members.get(0).at(part.pose()) : group(part, members);
        });
    }

    private static GeometryObject changed(GeometryObject object, String name, UnaryOperator<GeometryObject> change) {
        if (name.equals(object.name())) {
            return change.apply(object);
        }
        if (!(object instanceof ObjectGroup group) || group.loads().isEmpty()) {
            return object;
        }
        List<GeometryObject> members = new ArrayList<>();
        group.members().forEach(each -> members.add(members.isEmpty() ? each : changed(each, name, change)));
        return group(object, members);
    }

    /** A carrier of the name and place of a part; what is seen of it are the visuals of its members, where they have any. */
    private static GeometryObject group(GeometryObject part, List<GeometryObject> members) {
        ObjectGroup group = new ObjectGroup(members).moveable(String.valueOf(part.name()));
        if (members.stream().anyMatch(each -> each.visuals() != null)) {
            List<GeometryObject> seen = new ArrayList<>();
            for (GeometryObject each : members) {
                GeometryObject look = each.seen();
                if (look != null) {
                    seen.add(new ObjectGroup(List.of(look)));
                }
            }
            group = group.withVisuals(seen);
        }
        return group.at(part.pose());
    }
}
