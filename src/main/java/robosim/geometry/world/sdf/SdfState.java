package robosim.geometry.world.sdf;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.model.Point;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.Placement;

/**
 * The state with which Gazebo Classic saves a world: the poses of models and links in the world's frame, which override
 * their own, and the scales of models.
 */
public final class SdfState {
    private static final Point UNSCALED = new Point(1, 1, 1);

    private final SdfTree tree;
    private final List<String> unknown = new ArrayList<>();

    private SdfState(SdfTree tree) {
        this.tree = tree;
    }

    /** Reads the scope of a file's only world, or of its models if it has no world, as its state has them. */
    public static SdfScope read(SdfTree tree, SdfElement sdf) throws FileProblem {
        SdfScope scope = tree.read(sdf);
        SdfElement world = sdf.child("world");
        SdfElement state = world == null ? null : world.child("state");
        if (state != null) {
            SdfElement insertions = state.child("insertions");
            if (insertions != null) {
                tree.insert(scope, insertions);
            }
            apply(state, scope, tree);
        }
        return scope;
    }

    /** Puts the models of a world where its state has them, and removes those that were deleted. */
    private static void apply(SdfElement state, SdfScope world, SdfTree tree) throws FileProblem {
        SdfState applied = new SdfState(tree);
        int placed = 0;
        for (SdfElement each : state.children) {
            if (each.name.equals("model_state") && applied.place(world, Placement.NONE, each)) {
                placed++;
            }
        }
        if (placed > 0) {
            tree.remark(
                    state,
                    "the <state> has the poses of " + placed + (placed == 1 ? " model" : " models")
                            + ", which stand there as in Gazebo Classic, and not at their own <pose>; remove the <state>"
                            + " if you do not want that");
        }
        if (!applied.unknown.isEmpty()) {
            tree.remark(
                    state,
                    "the <state> also has what the world has not, which is ignored: "
                            + SdfTree.listed(applied.unknown));
        }
        applied.delete(state, world);
    }

    private void delete(SdfElement state, SdfScope world) {
        SdfElement deletions = state.child("deletions");
        List<String> deleted = new ArrayList<>();
        for (SdfElement each : deletions == null ? List.<SdfElement>of() : deletions.children) {
            SdfNode node = world.named(each.value());
            if (node != null && world.models.remove(node)) {
                deleted.add(each.value());
            }
        }
        if (!deleted.isEmpty()) {
            tree.remark(state, "these models are not in the world, as the <state> says: " + SdfTree.listed(deleted));
        }
    }

    /** Places a model and its links; a mistake costs the state of that model. */
    private boolean place(SdfScope scope, Placement outer, SdfElement state) throws FileProblem {
        String name = state.attribute("name");
        SdfNode model = scope.named(name);
        if (model == null || model.inner == null || !scope.models.contains(model)) {
            unknown.add(scope.pathOf(name));
            return false;
        }
        try {
            Placement here = pose(state);
            move(model, outer, here, state);
            Point scale = scale(state);
            for (SdfNode link : model.inner.links) {
                link.scale = scale;
            }
            for (SdfElement each : state.children) {
                if (each.name.equals("link_state")) {
                    link(model.inner, here, each);
                } else if (each.name.equals("model_state")) {
                    place(model.inner, here, each);
                }
            }
            return true;
        } catch (FileProblem e) {
            tree.skip(state, "the <state> of " + scope.pathOf(name), e);
            return false;
        }
    }

    private void link(SdfScope model, Placement here, SdfElement state) throws FileProblem {
        SdfNode link = model.named(state.attribute("name"));
        if (link == null || !model.links.contains(link)) {
            unknown.add(model.pathOf(state.attribute("name")));
            return;
        }
        move(link, here, pose(state), state);
    }

    private static void move(SdfNode node, Placement outer, Placement inWorld, SdfElement state) throws FileProblem {
        try {
            node.stood = node.local;
            node.local = outer.inverse().then(inWorld);
        } catch (IllegalArgumentException e) {
            throw state.wrong("<pose>: " + e.getMessage());
        }
    }

    /** A pose in the world's frame; Gazebo takes one that is missing as the world's origin. */
    private static Placement pose(SdfElement state) throws FileProblem {
        SdfElement pose = state.child("pose");
        return pose == null ? Placement.NONE : SdfPose.read(pose);
    }

    /** By which the shapes of a model are multiplied; null if they are not. */
    private static @Nullable Point scale(SdfElement state) throws FileProblem {
        Point scale = state.vector("scale", UNSCALED);
        if (!(scale.x() > 0 && scale.y() > 0 && scale.z() > 0)) {
            throw state.required("scale").wrong("<scale> must be above 0 (got: " + state.valueOf("scale") + ")");
        }
        return scale.equals(UNSCALED) ? null : scale;
    }
}
