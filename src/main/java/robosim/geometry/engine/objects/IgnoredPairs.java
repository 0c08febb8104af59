package robosim.geometry.engine.objects;

import java.util.HashMap;
import java.util.Map;
import java.util.Set;

/** Pairs of objects that pass through each other in the steps of bodies; mostly none. */
public final class IgnoredPairs {
    private final ObjectTable objects;
    private final Attachments attachments;

    /** By moveable object, those that do not count for it. */
    private final Map<Integer, IgnoredObjects> byMover = new HashMap<>();

    public IgnoredPairs(ObjectTable objects, Attachments attachments) {
        this.objects = objects;
        this.attachments = attachments;
    }

    /** Forgets all pairs. */
    public void clear() {
        byMover.clear();
    }

    /**
     * Adds the pairs of a moveable object and of those that some names stand for: objects, what they are attached to, or layers.
     * A name that no object and no layer has is left out.
     */
    public void add(int mover, Set<String> names) {
        for (String name : names) {
            String root = attachments.root(name);
            int other = objects.find(root == null ? name : root);
            for (int id : other >= 0 ? new int[] {other} : objects.ignored.layer(name)) {
                pair(mover, id);
                if (objects.isMoveable(id)) {
                    pair(id, mover);
                }
            }
        }
    }

    private void pair(int mover, int other) {
        if (mover != other) {
            byMover.computeIfAbsent(mover, id -> new IgnoredObjects(objects)).add(other);
        }
    }

    /** Whether a moveable object and another one pass through each other; an id below 0 is the border. */
    public boolean has(int mover, int other) {
        if (other < 0 || byMover.isEmpty()) {
            return false;
        }
        IgnoredObjects others = byMover.get(mover);
        return others != null && others.has(other);
    }

    /** Leaves out of the queries that follow what a moveable object passes through, up to {@link #end}. */
    public void begin(int mover) {
        IgnoredObjects others = byMover.isEmpty() ? null : byMover.get(mover);
        if (others != null) {
            objects.ignored.addAll(others);
        }
    }

    /** All objects count again. */
    public void end() {
        objects.ignored.clear();
    }
}
