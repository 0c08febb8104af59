package robosim.geometry.engine.broadphase;

import java.util.HashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.engine.objects.Attachments;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;

/** Attaches objects of a world to others and detaches them: a carrier with its loads stands in its own place as one group. */
public final class ObjectAttacher {
    private final ObjectRegistry registry;

    ObjectAttacher(ObjectRegistry registry) {
        this.registry = registry;
    }

    /**
     * Attaches a moveable object to another one, or to a load of one.
     *
     * @param at where it is held, in the frame of the carrier; null for where it is
     * @return false, and nothing changes, if it would touch anything but the carrier there or leave the world
     */
    public boolean attach(String carrier, String load, @Nullable Pose at) {
        int loadId = registry.mover(load);
        String root = registry.attachments.root(Checks.present("carrier", carrier));
        int rootId = registry.mover(root == null ? carrier : root);
        if (rootId == loadId) {
            throw new IllegalArgumentException("carrier must be neither the load nor attached to it (got: \"" + carrier
                    + "\" and \"" + load + "\")");
        }
        GeometryObject whole = registry.objects.present(rootId);
        GeometryObject object = registry.objects.present(loadId);
        Pose holder =
                Checks.present("carrier", Attachments.find(whole, carrier)).pose();
        Pose held = at == null ? object.pose().relativeTo(holder) : at;
        GeometryObject made = Attachments.with(whole, carrier, object, held);
        if (at != null && !isFree(object.at(held.within(holder)), rootId, loadId)) {
            return false;
        }
        Map<String, Long> births = births(object, registry.objects.arrival(loadId));
        registry.take(loadId);
        births.forEach(registry.attachments::keepBirth);
        replace(registry.objects.find(String.valueOf(whole.name())), made);
        return true;
    }

    /** Whether an object may be at a place, where two others do not count. */
    private boolean isFree(GeometryObject object, int one, int other) {
        registry.objects.ignored.add(one);
        registry.objects.ignored.add(other);
        try {
            return registry.fits(object) && !registry.collides(registry.view, object, -1);
        } finally {
            registry.objects.ignored.clear();
        }
    }

    /** Detaches an object from its carrier: it stays where it is, and counts as added now. */
    public void detach(String load) {
        String root = registry.attachments.root(Checks.present("load", load));
        if (root == null) {
            registry.known(load);
            throw new IllegalArgumentException("load must be attached to something (got: \"" + load + "\")");
        }
        int rootId = registry.objects.find(root);
        GeometryObject whole = registry.objects.present(rootId);
        GeometryObject object = Checks.present("load", Attachments.find(whole, load));
        for (double share = 0x1p-52; share < 1 && !registry.fits(object); share *= 2) { // rounding has put it outside
            Point c = object.center();
            object = object.at(object.pose()
                    .movedTo(new Point(c.x() - c.x() * share, c.y() - c.y() * share, c.z() - c.z() * share)));
        }
        Map<String, Long> births = births(object, registry.objects.arrivals());
        replace(rootId, Attachments.without(whole, String.valueOf(Attachments.carrier(whole, load)), load));
        births.forEach(registry.attachments::keepBirth);
        registry.note(registry.restore(object, registry.objects.arrivals()));
    }

    /** Puts an object in the place of another one, among the arrivals too. */
    private void replace(int id, GeometryObject by) {
        long arrivals = registry.objects.arrivals();
        long arrival = registry.objects.arrival(id);
        Map<String, Long> births = births(by, arrival);
        registry.take(id);
        births.forEach(registry.attachments::keepBirth);
        registry.note(registry.restore(by, arrival));
        registry.objects.arriveAt(arrivals);
    }

    /** When an object and all that it carries came into the world at first. */
    private Map<String, Long> births(GeometryObject object, long arrival) {
        Map<String, Long> births = new HashMap<>();
        Attachments.forEachPart(object, (part, pose) -> births.put(part, registry.attachments.birth(part, arrival)));
        return births;
    }

    /** An object at its present place, attached ones too. */
    public GeometryObject part(String name) {
        String root = registry.attachments.root(Checks.present("name", name));
        if (root == null) {
            return registry.objects.present(registry.known(name));
        }
        return Checks.present("name", Attachments.find(registry.objects.present(registry.objects.find(root)), name));
    }

    /** The name of what an object is attached to; null if it is not attached. */
    public @Nullable String carrier(String name) {
        String root = registry.attachments.root(Checks.present("name", name));
        if (root == null) {
            registry.known(name);
            return null;
        }
        return Attachments.carrier(registry.objects.value(registry.objects.find(root)), name);
    }
}
