package robosim.geometry.engine.broadphase;

import robosim.geometry.index.boxes.SpaceKeys;
import robosim.geometry.index.hierarchy.BoxCursor;
import robosim.geometry.index.hierarchy.Hierarchy;
import robosim.geometry.index.hierarchy.NearestCursor;
import robosim.geometry.index.hierarchy.PointCursor;
import robosim.geometry.index.hierarchy.RayCursor;

/**
 * Where the objects of a table are looked for in a world with heights: one hierarchy of static objects, and one of moveable
 * ones, which changes all the time and is built anew more often.
 */
final class SpaceIndex {
    /** A hierarchy with cursors of one thread. */
    static final class Part {
        final Hierarchy tree;
        final BoxCursor boxes;
        final NearestCursor nearest;

        Part(Hierarchy tree, SpaceKeys keys) {
            this.tree = tree;
            boxes = new BoxCursor(tree);
            nearest = new NearestCursor(tree, keys);
        }

        boolean isEmpty() {
            return tree.size() == 0;
        }
    }

    /** What the cursors for cones look for. */
    final SpaceKeys keys = new SpaceKeys();

    // For rays through both hierarchies, and for what is near a point.
    final RayCursor rays = new RayCursor();
    final PointCursor points = new PointCursor();

    final Part still;
    final Part moving;

    /**
     * An empty index.
     *
     * @param whenBuilt what to do when the hierarchy of static objects has been built anew
     */
    SpaceIndex(Runnable whenBuilt) {
        still = new Part(new Hierarchy(whenBuilt), keys);
        moving = new Part(new Hierarchy(() -> {}), keys);
    }

    private SpaceIndex(SpaceIndex of) {
        still = new Part(of.still.tree, keys);
        moving = new Part(of.moving.tree, keys);
    }

    /** The same objects, of which none comes or goes any more, for one more thread to ask. */
    SpaceIndex view() {
        return new SpaceIndex(this);
    }

    void freeze() {
        still.tree.freeze();
        moving.tree.freeze();
    }

    /** No object that was ever here has a coordinate of a greater magnitude. */
    double most() {
        return Math.max(still.tree.most(), moving.tree.most());
    }
}
