package robosim.geometry.world.sdf;

import org.jspecify.annotations.Nullable;
import robosim.geometry.world.shared.Placement;

/** Something that has a frame of its own in a scope: a model, a link, a frame or a joint. */
public final class SdfNode {
    final SdfElement element;

    /** Where it stands, as its element says or whoever includes it; null leaves it at its base. */
    final @Nullable SdfElement pose;

    /** The frame that its pose counts from where the pose names none; empty for the scope's own. */
    final String base;

    /** What stands for the scope's own frame, for what was merged into the scope; else null. */
    final @Nullable SdfNode home;

    /** What is inside a model; of a merged one, only where its placement frame is. */
    final @Nullable SdfScope inner;

    /** The frame inside that the pose is about; empty for the model's own. */
    final String placementFrame;

    final boolean isStatic;

    /** In the scope's frame, once that is known. */
    @Nullable
    Placement local;

    /** Whether somebody is working it out. */
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

    /** The name of the frame that the pose counts from; empty for the scope's own. */
    String relativeTo() {
        String named = pose == null ? "" : pose.attribute("relative_to");
        return named.isEmpty() ? base : named;
    }

    /** Where the frame is named, for messages. */
    SdfElement place() {
        return pose == null ? element : pose;
    }
}
