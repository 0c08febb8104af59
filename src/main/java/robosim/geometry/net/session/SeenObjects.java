package robosim.geometry.net.session;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import robosim.geometry.SenseBuffer;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.protocol.batch.Integers;

/** Which objects the beams of a sensor meet, and the labels of what they are made of. */
final class SeenObjects {
    /** The most characters of all names: 100,000 of 40. */
    private static final int MOST_CHARACTERS = 1 << 22;

    /**
     * An object that was seen.
     *
     * @param number the index of its name
     * @param parts  of a group
     */
    private record Seen(int number, List<GeometryObject> parts) {}

    private final IdentityHashMap<GeometryObject, Seen> known = new IdentityHashMap<>();
    private final List<String> names = new ArrayList<>();
    private final int[] objects;
    private final int[] labels;
    private int characters;

    SeenObjects(int beams) {
        objects = new int[beams];
        labels = new int[beams];
    }

    /** Takes some beams, the first of which has a number. */
    void take(SenseBuffer buffer, int first) {
        for (int k = 0; k < buffer.size(); k++) {
            GeometryObject object = buffer.object(k);
            if (object == null) {
                objects[first + k] = -1;
                continue;
            }
            Seen seen = seen(object);
            objects[first + k] = seen.number;
            int part = buffer.part(k);
            GeometryObject surface = part < 0 || seen.parts.isEmpty() ? object : seen.parts.get(part);
            labels[first + k] = surface.material().label();
        }
    }

    private Seen seen(GeometryObject object) {
        Seen seen = known.get(object);
        if (seen == null) {
            String name = object.name() == null ? "" : object.name();
            characters += name.length();
            if (characters > MOST_CHARACTERS) {
                throw new IllegalArgumentException("the names of the objects that are seen must have at most "
                        + MOST_CHARACTERS + " characters together (got: more)");
            }
            seen = new Seen(names.size(), object instanceof ObjectGroup group ? group.parts() : List.of());
            known.put(object, seen);
            names.add(name);
        }
        return seen;
    }

    List<String> names() {
        return names;
    }

    /** For each beam the index of its object's name; -1 for none. */
    Integers objects() {
        return new Integers(objects);
    }

    Integers labels() {
        return new Integers(labels);
    }
}
