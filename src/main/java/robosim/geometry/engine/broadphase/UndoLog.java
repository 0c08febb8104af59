package robosim.geometry.engine.broadphase;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import robosim.geometry.engine.objects.Attachments;
import robosim.geometry.engine.objects.ObjectTable;
import robosim.geometry.model.GeometryObject;

/** What was changed in a world since this began, so that it can be put back as it was. */
final class UndoLog {
    private final ObjectRegistry registry;
    private final ObjectTable objects;
    private final long arrivals;
    private final Attachments attachments;

    /** Where the moveable objects that were moved or removed were at first, by their names. */
    private final Map<String, double[]> places = new HashMap<>();

    private final List<Change> changes = new ArrayList<>();

    /**
     * An object that came or went.
     *
     * @param gone    what was removed; null where an object was added
     * @param arrival its place among the arrivals
     */
    private record Change(int id, @Nullable GeometryObject gone, long arrival) {}

    UndoLog(ObjectRegistry registry) {
        this.registry = registry;
        objects = registry.objects;
        arrivals = objects.arrivals();
        attachments = registry.attachments.copy();
    }

    /** An object is about to be moved. */
    void moves(int id) {
        String name = objects.value(id).name();
        if (name != null && !places.containsKey(name)) {
            double[] place = new double[ObjectTable.PLACE];
            System.arraycopy(objects.places(), objects.place(id), place, 0, place.length);
            places.put(name, place);
        }
    }

    /** An object was added. */
    void added(int id) {
        changes.add(new Change(id, null, 0));
    }

    /** An object is about to be removed. */
    void removes(int id) {
        if (objects.isMoveable(id)) {
            moves(id);
        }
        changes.add(new Change(id, objects.value(id), objects.arrival(id)));
    }

    /** Takes over what was changed in a part of the time. */
    void add(UndoLog part) {
        part.places.forEach(places::putIfAbsent);
        changes.addAll(part.changes);
    }

    /** Puts the world back as it was, the last change first. */
    void undo() {
        for (int k = changes.size() - 1; k >= 0; k--) {
            Change change = changes.get(k);
            if (change.gone == null) {
                registry.remove(change.id);
            } else {
                rename(k, change.id, registry.restore(change.gone, change.arrival));
            }
        }
        objects.arriveAt(arrivals);
        registry.attachments.restore(attachments);
        places.forEach((name, place) -> {
            int id = objects.find(name);
            if (id >= 0) {
                registry.move(id, place);
            }
        });
    }

    /** An object is back under another id, as its own was taken. */
    private void rename(int before, int was, int is) {
        for (int k = 0; k < before && was != is; k++) {
            Change change = changes.get(k);
            if (change.id == was) {
                changes.set(k, new Change(is, change.gone, change.arrival));
            }
        }
    }
}
