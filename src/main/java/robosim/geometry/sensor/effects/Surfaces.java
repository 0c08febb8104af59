package robosim.geometry.sensor.effects;

import java.util.IdentityHashMap;
import java.util.List;
import robosim.geometry.material.Material;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.ObjectGroup;

/** What objects and the parts of groups are made of; remembers what it was asked of groups. */
public final class Surfaces {
    private final IdentityHashMap<ObjectGroup, List<GeometryObject>> groups = new IdentityHashMap<>();

    /**
     * The material of a part of an object.
     *
     * @param part as {@link robosim.geometry.SenseBuffer#part} tells it; -1 for a group as a whole
     */
    public Material of(GeometryObject object, int part) {
        if (!(object instanceof ObjectGroup group) || part < 0) {
            return object.material();
        }
        List<GeometryObject> parts = groups.get(group);
        if (parts == null) {
            parts = group.parts();
            groups.put(group, parts);
        }
        return parts.get(part).material();
    }

    public void forget() {
        groups.clear();
    }
}
