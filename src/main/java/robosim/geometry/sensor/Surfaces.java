package robosim.geometry.sensor;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.material.Material;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.ObjectGroup;

/** What objects and the parts of groups are made of; remembers what it was asked of groups. */
final class Surfaces {
    private final IdentityHashMap<ObjectGroup, Material[]> groups = new IdentityHashMap<>();

    /**
     * The material of a part of an object.
     *
     * @param part as {@link robosim.geometry.SenseBuffer#part} tells it; -1 for a group as a whole
     */
    Material of(GeometryObject object, int part) {
        if (!(object instanceof ObjectGroup group) || part < 0) {
            return object.material();
        }
        Material @Nullable [] parts = groups.get(group);
        if (parts == null) {
            List<Material> found = new ArrayList<>();
            collect(group, group.material(), found);
            parts = found.toArray(new Material[0]);
            groups.put(group, parts);
        }
        return parts[part];
    }

    /** Lists the materials of a group's parts, depth first. */
    private static void collect(ObjectGroup group, Material ofGroup, List<Material> found) {
        for (GeometryObject member : group.members()) {
            Material own = member.material().within(ofGroup);
            if (member instanceof ObjectGroup inner) {
                collect(inner, own, found);
            } else {
                found.add(own);
            }
        }
    }

    void forget() {
        groups.clear();
    }
}
