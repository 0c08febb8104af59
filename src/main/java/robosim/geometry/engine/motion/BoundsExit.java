package robosim.geometry.engine.motion;

import robosim.geometry.engine.objects.WorldBounds;
import robosim.geometry.narrow.leaf.LeafColumn;

/** Where an object on a segment leaves the world; its exact shape counts. */
final class BoundsExit {
    private final WorldBounds worldBounds;
    private final MotionSegment segment;
    private final double[] swept = new double[6];

    BoundsExit(WorldBounds worldBounds, MotionSegment segment) {
        this.worldBounds = worldBounds;
        this.segment = segment;
    }

    /**
     * The share of the segment after which the object would leave the world, +Infinity where it stays inside.
     *
     * @param clearance how far to stay inside
     */
    double share(double clearance) {
        if (segment.turns()) {
            return turn();
        }
        double free = translation();
        if (clearance > 0) {
            LeafColumn exact = segment.exactAtStart();
            for (int axis = 0; axis < 3; axis++) {
                double way = segment.displacement(axis);
                free = Math.min(free, worldBounds.share(exact, axis, way, clearance));
            }
        }
        return free;
    }

    private double translation() {
        if (holds(segment.exactAtEnd())) {
            return Double.POSITIVE_INFINITY;
        }
        double dx = segment.displacement(0);
        double dy = segment.displacement(1);
        double dz = segment.displacement(2);
        LeafColumn exact = segment.exactAtStart();
        double leaves = worldBounds.share(exact, 0, exact.size(), dx, dy, dz);
        return Math.max(0, Math.min(1, leaves));
    }

    private double turn() {
        segment.exactlySwept(1, swept);
        if (!worldBounds.nearlyHolds(swept)) {
            segment.tightlySwept(1, swept);
        }
        if (worldBounds.nearlyHolds(swept) && holds(segment.exactAtEnd())) {
            return Double.POSITIVE_INFINITY;
        }
        double low = 0;
        double high = 1;
        for (int halving = 0; halving < 50; halving++) {
            double middle = low / 2 + high / 2;
            segment.tightlySwept(middle, swept);
            if (worldBounds.nearlyHolds(swept)) {
                low = middle;
            } else {
                high = middle;
            }
        }
        segment.turnBy(1);
        return low;
    }

    /** Whether the world holds an object. */
    boolean holds(LeafColumn exact) {
        return worldBounds.holds(exact, 0, exact.size());
    }

    /** Contact point and normal at the end of what is free, six numbers. */
    void contact(double[] out) {
        if (segment.turns()) {
            segment.exactlySwept(1, swept);
        } else {
            LeafColumn exact = segment.exactAfter(1);
            exact.bounds(0, exact.size(), swept);
        }
        worldBounds.contact(swept, segment.exactAtEnd(), out);
    }
}
