package robosim.geometry.net.session;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import robosim.geometry.SenseBuffer;
import robosim.geometry.material.Material;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.protocol.batch.Integers;

/** Which objects the beams of a sensor meet, and the labels of what they are made of. */
final class SeenObjects {
    /** The most characters of all names: 100,000 of 40. */
    private static final int MOST_CHARACTERS = 1 << 22;

    private final IdentityHashMap<GeometryObject, Integer> known = new IdentityHashMap<>();
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
            objects[first + k] = object == null ? -1 : number(object);
            labels[first + k] =
                    object == null ? 0 : material(object, buffer.part(k)).label();
        }
    }

    private static Material material(GeometryObject object, int part) {
        return object instanceof ObjectGroup group && part >= 0 ? group.material(part) : object.material();
    }

    private int number(GeometryObject object) {
        Integer number = known.get(object);
        if (number == null) {
            String name = object.name() == null ? "" : object.name();
            characters += name.length();
            if (characters > MOST_CHARACTERS) {
                throw new IllegalArgumentException("the names of the objects that are seen must have at most "
                        + MOST_CHARACTERS + " characters together (got: more)");
            }
            number = names.size();
            known.put(object, number);
            names.add(name);
        }
        return number;
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
