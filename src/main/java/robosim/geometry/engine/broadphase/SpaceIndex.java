package robosim.geometry.engine.broadphase;

import robosim.geometry.index.hierarchy.BoxCursor;
import robosim.geometry.index.hierarchy.ConeCursor;
import robosim.geometry.index.hierarchy.Hierarchy;
import robosim.geometry.index.hierarchy.NearestCursor;
import robosim.geometry.index.hierarchy.RayCursor;

/**
 * Where the objects of a table are looked for in a world with heights: one hierarchy of static objects, and one of moveable
 * ones, which changes all the time and is built anew more often; with the cursors of one thread over both.
 */
final class SpaceIndex {
    final Hierarchy still;
    final Hierarchy moving;
    final RayCursor rays = new RayCursor();
    final ConeCursor cones = new ConeCursor();
    final BoxCursor boxes = new BoxCursor();
    final NearestCursor nearest = new NearestCursor();

    /**
     * An empty index.
     *
     * @param whenBuilt what to do when the hierarchy of static objects has been built anew
     */
    SpaceIndex(Runnable whenBuilt) {
        still = new Hierarchy(whenBuilt);
        moving = new Hierarchy(() -> {});
    }

    private SpaceIndex(SpaceIndex of) {
        still = of.still;
        moving = of.moving;
    }

    /** The same objects, of which none comes or goes any more, for one more thread to ask. */
    SpaceIndex view() {
        return new SpaceIndex(this);
    }

    void freeze() {
        still.freeze();
        moving.freeze();
    }

    /** The only object; -1 if there is none or more than one. */
    int only() {
        return still.size() + moving.size() == 1 ? (still.size() == 1 ? still : moving).only() : -1;
    }

    /** No object that was ever here has a coordinate of a greater magnitude. */
    double most() {
        return Math.max(still.most(), moving.most());
    }
}
