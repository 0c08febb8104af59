package robosim.geometry.world.sdf;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.Limits;
import robosim.geometry.world.shared.Placement;

/**
 * A scope of names that can refer to each other: those directly in a world or in a model. Computes the placement of
 * each in the scope's frame, in any order of dependence.
 */
public final class SdfScope {
    /** The scope's own frame, by its reserved name. */
    private static final String OWN = "__model__";

    private static final String WORLD = "world";

    /** The names of the enclosing models and of this one, separated by {@code ::}; empty for a world. */
    final String path;

    final List<SdfNode> models = new ArrayList<>();
    final List<SdfNode> links = new ArrayList<>();

    /** The lights of a world that are in none of its links. */
    final List<SdfNode> lights = new ArrayList<>();

    /** The {@code <scene>} of a world. */
    @Nullable
    SdfElement scene;

    private final Map<String, SdfNode> nodes = new HashMap<>();

    SdfScope(String path) {
        this.path = path;
    }

    /** The path of something in this scope. */
    String pathOf(String name) {
        return path.isEmpty() ? name : path + "::" + name;
    }

    /** Adds a name; returns false if it exists already. */
    boolean add(String name, SdfNode node) {
        return nodes.putIfAbsent(name, node) == null;
    }

    /** The node of a name in this scope. */
    @Nullable
    SdfNode named(String name) {
        return nodes.get(name);
    }

    /** The placement of a node in this scope's frame. */
    Placement placement(SdfNode node) throws FileProblem {
        // Iterative, not recursive: a file may chain a hundred thousand frames.
        Deque<SdfNode> waiting = new ArrayDeque<>();
        try {
            compute(node, waiting);
        } catch (FileProblem e) {
            // All that depend on it fail for the same reason, without looking for it anew.
            for (SdfNode at : waiting) {
                at.failure = e;
                at.isOpen = false;
            }
            throw e;
        }
        if (node.local == null) {
            throw new IllegalStateException("a placement was not computed");
        }
        return node.local;
    }

    private void compute(SdfNode node, Deque<SdfNode> waiting) throws FileProblem {
        for (SdfNode at = node; at != null && at.local == null; at = next(at)) {
            if (at.failure != null) {
                throw at.failure;
            }
            if (at.isOpen) {
                throw at.place()
                        .wrong("poses must not be relative to each other in a cycle; make one of them relative to"
                                + " the model (got: " + at.relativeTo() + ")");
            }
            at.isOpen = true;
            waiting.push(at);
        }
        while (!waiting.isEmpty()) {
            SdfNode at = waiting.element();
            at.local = work(at);
            at.isOpen = false;
            waiting.pop();
        }
    }

    private Placement work(SdfNode node) throws FileProblem {
        Placement place = placement(node.relativeTo(), node.home, node.place());
        try {
            if (node.pose != null) {
                place = place.then(SdfPose.read(node.pose));
            }
            if (!node.placementFrame.isEmpty() && node.inner != null) {
                Placement within = node.inner.placement(node.placementFrame, null, node.element);
                place = place.then(within.inverse());
            }
            return place;
        } catch (IllegalArgumentException e) {
            throw node.place().wrong("<pose>: " + e.getMessage());
        }
    }

    /** The node of this scope on which a node's placement depends; null if that is the scope's own frame. */
    private @Nullable SdfNode next(SdfNode node) throws FileProblem {
        String name = node.relativeTo();
        return isOwn(name) ? node.home : first(name, node.place());
    }

    private boolean isOwn(String name) {
        return name.isEmpty() || name.equals(path.isEmpty() ? WORLD : OWN) || (path.isEmpty() && name.equals(OWN));
    }

    /**
     * Where the first part of a name ends; -1 if it is a single name, which in older files may contain {@code ::} too.
     */
    private int end(String name) {
        return nodes.containsKey(name) ? -1 : name.indexOf("::");
    }

    private SdfNode first(String name, SdfElement place) throws FileProblem {
        int end = end(name);
        SdfNode node = nodes.get(end < 0 ? name : name.substring(0, end));
        if (node == null || (end >= 0 && node.inner == null)) {
            throw place.wrong("there is no such frame in " + (path.isEmpty() ? "the world" : "model " + path)
                    + "; name a link, frame, joint or model in it (got: " + name + ")");
        }
        return node;
    }

    /**
     * The placement of a named frame in this scope's frame.
     *
     * @param home  what stands for this scope's own frame; null for itself
     * @param place the referring element, for messages
     */
    Placement placement(String name, @Nullable SdfNode home, SdfElement place) throws FileProblem {
        if (isOwn(name)) {
            return home == null ? Placement.NONE : placement(home);
        }
        SdfNode node = first(name, place);
        Placement found = placement(node);
        int end = end(name);
        return end < 0 || node.inner == null
                ? found
                : found.then(node.inner.placement(name.substring(end + 2), null, place));
    }

    /** Refuses a name that is too long to append a number. */
    static void checkName(String name, SdfElement place) throws FileProblem {
        if (name.length() > Limits.MAX_ATTRIBUTE - 20) {
            throw place.wrong("a name with those of the enclosing models must have at most "
                    + (Limits.MAX_ATTRIBUTE - 20) + " characters (got: " + name.length() + ")");
        }
    }
}
