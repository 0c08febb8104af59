package robosim.geometry.engine.sensing;

import org.jspecify.annotations.Nullable;
import robosim.geometry.engine.broadphase.AccuracyView;
import robosim.geometry.engine.objects.ObjectTable;
import robosim.geometry.index.boxes.OctTree;
import robosim.geometry.index.boxes.SpaceKeys;
import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.Distance;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.LeafColumn;

/** Least distances in a world: nearest first, and no farther than what has been found. */
public final class ProximityQuery {
    /** More than what a square may lose by underflow. */
    private static final double UNDERFLOW = 0x1p-1000;

    private final ObjectTable bodies;
    private final Distance distance;
    private final SpaceKeys keys = new SpaceKeys();

    /** What stands for the object whose distance to others is asked. */
    private final LeafColumn own = new LeafColumn(1);

    /** And its bounds. */
    private final double[] box = new double[6];

    private double best;

    public ProximityQuery(ObjectTable bodies, Scratch scratch) {
        this.bodies = bodies;
        distance = new Distance(scratch);
    }

    /** The least distance of an object to any other; +Infinity where that is beyond the limit. */
    public double of(AccuracyView level, int id, double limit) {
        AccuracyView home = level.of(id);
        System.arraycopy(home.bounds(), 6 * ObjectTable.bare(id), box, 0, 6);
        own.clear();
        own.appendWhole(home.leaves(), home.first(ObjectTable.bare(id)), home.count(ObjectTable.bare(id)));
        best = Double.POSITIVE_INFINITY;
        AccuracyView shared = level.shared();
        double reach = shared == null ? limit : nearestToOwn(shared, limit, id);
        reach = nearestToOwn(level, reach, id);
        for (int m = 0; m < level.moversBesideTree(); m++) {
            if (bodies.mover(m) != id) {
                reach = tryPair(level, bodies.mover(m), reach);
            }
        }
        return best <= limit ? best : Double.POSITIVE_INFINITY;
    }

    /** Tries what stands in a level's trees near the object in question; answers how far there is still to look. */
    private double nearestToOwn(AccuracyView level, double limit, int but) {
        int ignored = but ^ level.mark;
        double x = box[0] / 2 + box[3] / 2;
        double z = box[2] / 2 + box[5] / 2;
        double hx = Math.max(box[3] - x, x - box[0]);
        double hz = Math.max(box[5] - z, z - box[2]);
        double radius = Math.sqrt(hx * hx + hz * hz + UNDERFLOW) * (1 + 0x1p-50);
        double sizes = Distance.sides(box) + level.widest();
        double reach = limit;
        level.cursor.startPoint(x, z, Distance.reach(reach, sizes) + radius);
        for (int other = level.cursor.next(Distance.reach(reach, sizes) + radius);
                other >= 0;
                other = level.cursor.next(Distance.reach(reach, sizes) + radius)) {
            if (other != ignored) {
                reach = tryPair(level, other, reach);
            }
        }
        OctTree.@Nullable Cursor stacked = level.spaceIndex.cursor();
        if (stacked == null) {
            return reach;
        }
        double y = box[1] / 2 + box[4] / 2;
        double hy = Math.max(box[4] - y, y - box[1]);
        double all = Math.sqrt(hx * hx + hy * hy + hz * hz + UNDERFLOW) * (1 + 0x1p-50);
        keys.startPoint(x, y, z);
        stacked.start(level.bounds(), keys);
        for (int other = stacked.next(Distance.reach(reach, sizes) + all);
                other >= 0;
                other = stacked.next(Distance.reach(reach, sizes) + all)) {
            if (other != ignored) {
                reach = tryPair(level, other, reach);
            }
        }
        return reach;
    }

    private double tryPair(AccuracyView level, int other, double reach) {
        if (boxGap(level, other) > Distance.reach(reach, Distance.sides(box) + sides(level, other))) {
            return reach;
        }
        int first = level.first(other);
        int last = first + level.count(other);
        for (int i = 0; i < own.size(); i++) {
            for (int j = first; j < last; j++) {
                double found = distance.between(level.dimension, own, i, level.leaves(), j, Math.min(reach, best));
                best = Math.min(best, found);
            }
        }
        return Math.min(reach, best);
    }

    private static double sides(AccuracyView level, int other) {
        double[] b = level.bounds();
        int k = 6 * other;
        return (b[k + 3] - b[k]) + (b[k + 4] - b[k + 1]) + (b[k + 5] - b[k + 2]);
    }

    /** A lower bound of the distance of another object: that of their bounds. */
    private double boxGap(AccuracyView level, int other) {
        double[] b = level.bounds();
        int k = 6 * other;
        double squared = 0;
        for (int axis = 0; axis < 3; axis += level.dimension == Dimension.PLANAR ? 2 : 1) {
            double gap = Math.max(box[axis] - b[k + 3 + axis], b[k + axis] - box[3 + axis]);
            if (gap > 0) {
                squared += gap * gap;
            }
        }
        return squared < UNDERFLOW ? 0 : Math.sqrt(squared) * (1 - 0x1p-50);
    }
}
