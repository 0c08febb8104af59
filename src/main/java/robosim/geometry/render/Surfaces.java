package robosim.geometry.render;

import java.util.IdentityHashMap;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.Geometry;
import robosim.geometry.model.Bounds;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Pose;

/**
 * The surfaces of the objects that have been seen in a world. Those of moveable objects are placed once for each picture,
 * when they are first seen in it.
 */
final class Surfaces {
    /** More objects than these are forgotten between two pictures: many may have been removed from the world. */
    private static final int MOST = 1 << 16;

    /** The parts of one object, and where they stand in it. */
    private static final class Entry {
        final ShadedSurface[] parts;
        final Pose[] within;
        long picture = -1;

        Entry(int count) {
            parts = new ShadedSurface[count];
            within = new Pose[count];
        }
    }

    private final Geometry world;

    /** By identity: a world gives the same instance for the same object. */
    private final IdentityHashMap<GeometryObject, Entry> known = new IdentityHashMap<>();

    private long picture;

    // The last answer; neighbours mostly see the same object.
    private @Nullable GeometryObject lastObject;
    private @Nullable Entry lastEntry;

    Surfaces(Geometry world) {
        this.world = world;
    }

    /** Begins a picture, before which objects may have moved. */
    void begin() {
        picture++;
        lastObject = null;
        if (known.size() > MOST) {
            known.clear();
        }
    }

    /**
     * The surface of a part of an object.
     *
     * @param part -1 where no single part is known; then the first one stands for all
     */
    @SuppressWarnings("ReferenceEquality") // the same instance is the same object; an equal one may be elsewhere
    ShadedSurface of(GeometryObject object, int part) {
        Entry entry = lastEntry;
        if (entry == null || lastObject != object) {
            entry = find(object);
            lastObject = object;
            lastEntry = entry;
        }
        return entry.parts[Math.max(0, part)];
    }

    private Entry find(GeometryObject object) {
        Entry entry = known.get(object);
        if (entry == null) {
            entry = made(object);
            known.put(object, entry);
        }
        if (entry.picture != picture) {
            entry.picture = picture;
            String name = object.name();
            if (object.isMoveable() && name != null) {
                place(entry, world.getObject(name).pose());
            }
        }
        return entry;
    }

    private static void place(Entry entry, Pose pose) {
        for (int k = 0; k < entry.parts.length; k++) {
            Pose within = entry.within[k];
            entry.parts[k].place(within.equals(Pose.ORIGIN) ? pose : within.within(pose));
        }
    }

    private static Entry made(GeometryObject object) {
        Bounds box = object.bounds();
        double x = box.maxX() - box.minX();
        double y = box.maxY() - box.minY();
        double z = box.maxZ() - box.minZ();
        double size = x + y + z; // at least the diagonal
        List<GeometryObject> parts = object instanceof ObjectGroup group ? group.parts() : List.of(object);
        Entry entry = new Entry(parts.size());
        for (int k = 0; k < parts.size(); k++) {
            entry.parts[k] = new ShadedSurface(parts.get(k), size);
            entry.within[k] = object instanceof ObjectGroup ? parts.get(k).pose() : Pose.ORIGIN;
        }
        place(entry, object.pose());
        return entry;
    }
}
