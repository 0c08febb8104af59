package robosim.geometry.world.sdf;

import org.jspecify.annotations.Nullable;
import robosim.geometry.model.Point;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.Placement;

/** Something with its own frame in a scope: a model, a link, a frame or a joint. */
public final class SdfNode {
    final SdfElement element;

    /** Its pose, given by its element or the including one; null leaves it at its base. */
    final @Nullable SdfElement pose;

    /** The frame to which its pose is relative if the pose names none; empty for the scope's own. */
    final String base;

    /** For a node merged into the scope, what stands for its original scope's own frame; else null. */
    final @Nullable SdfNode home;

    /** The scope inside a model; for a merged one, only used to locate its placement frame. */
    final @Nullable SdfScope inner;

    /** The inner frame that the pose places; empty for the model's own. */
    final String placementFrame;

    final boolean isStatic;

    /** Its pose in the scope's frame, once computed. */
    @Nullable
    Placement local;

    /** Where it stood before a saved state moved it; null if none did. */
    @Nullable
    Placement stood;

    /** By which a saved state scales the shapes of a link; null if none does. */
    @Nullable
    Point scale;

    /** Why its pose could not be computed. */
    @Nullable
    FileProblem failure;

    /** Whether it is being computed. */
    boolean isOpen;

    SdfNode(SdfElement element, @Nullable SdfElement pose, String base, @Nullable SdfNode home) {
        this(element, pose, base, home, null, "", false);
    }

    SdfNode(
            SdfElement element,
            @Nullable SdfElement pose,
            String base,
            @Nullable SdfNode home,
            @Nullable SdfScope inner,
            String placementFrame,
            boolean isStatic) {
        this.element = element;
        this.pose = pose;
        this.base = base;
        this.home = home;
        this.inner = inner;
        this.placementFrame = placementFrame;
        this.isStatic = isStatic;
    }

    /** The name of the frame to which the pose is relative; empty for the scope's own. */
    String relativeTo() {
        String named = pose == null ? "" : pose.relativeTo();
        return named.isEmpty() ? base : named;
    }

    /** The element that names the frame, for messages. */
    SdfElement place() {
        return pose == null ? element : pose;
    }
}
