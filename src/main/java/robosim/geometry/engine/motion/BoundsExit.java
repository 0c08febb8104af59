package robosim.geometry.engine.motion;

import robosim.geometry.engine.objects.WorldBounds;
import robosim.geometry.narrow.leaf.LeafColumn;

/** Where an object on a leg leaves the world; its exact shape counts. */
final class BoundsExit {
    private final WorldBounds worldBounds;
    private final Leg leg;
    private final double[] swept = new double[6];

    BoundsExit(WorldBounds worldBounds, Leg leg) {
        this.worldBounds = worldBounds;
        this.leg = leg;
    }

    /**
     * The share of the leg after which the object would leave the world, +Infinity where it stays inside.
     *
     * @param clearance how far to stay inside
     */
    double share(double clearance) {
        if (leg.turns()) {
            return turn();
        }
        double free = translation();
        if (clearance > 0) {
            LeafColumn exact = leg.exactAtStart();
            for (int axis = 0; axis < 3; axis++) {
                double way = leg.displacement(axis);
                free = Math.min(free, worldBounds.share(exact, axis, way, clearance));
            }
        }
        return free;
    }

    private double translation() {
        if (holds(leg.exactAtEnd())) {
            return Double.POSITIVE_INFINITY;
        }
        double dx = leg.displacement(0);
        double dy = leg.displacement(1);
        double dz = leg.displacement(2);
        LeafColumn exact = leg.exactAtStart();
        double leaves = worldBounds.share(exact, 0, exact.size(), dx, dy, dz);
        return Math.max(0, Math.min(1, leaves));
    }

    private double turn() {
        leg.exactlySwept(1, swept);
        if (!worldBounds.nearlyHolds(swept)) {
            leg.tightlySwept(1, swept);
        }
        if (worldBounds.nearlyHolds(swept) && holds(leg.exactAtEnd())) {
            return Double.POSITIVE_INFINITY;
        }
        double low = 0;
        double high = 1;
        for (int halving = 0; halving < 50; halving++) {
            double middle = low / 2 + high / 2;
            leg.tightlySwept(middle, swept);
            if (worldBounds.nearlyHolds(swept)) {
                low = middle;
            } else {
                high = middle;
            }
        }
        leg.turnBy(1);
        return low;
    }

    /** Whether the world holds an object. */
    boolean holds(LeafColumn exact) {
        return worldBounds.holds(exact, 0, exact.size());
    }

    /** Contact point and normal at the end of what is free, six numbers. */
    void contact(double[] out) {
        if (leg.turns()) {
            leg.exactlySwept(1, swept);
        } else {
            LeafColumn exact = leg.exactAfter(1);
            exact.bounds(0, exact.size(), swept);
        }
        worldBounds.contact(swept, leg.exactAtEnd(), out);
    }
}
