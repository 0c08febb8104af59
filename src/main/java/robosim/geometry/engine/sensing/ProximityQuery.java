package robosim.geometry.engine.sensing;

import robosim.geometry.engine.broadphase.AccuracyView;
import robosim.geometry.engine.broadphase.LeafTable;
import robosim.geometry.engine.broadphase.NearestSearch;
import robosim.geometry.engine.objects.ObjectTable;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.Distance;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.LeafBoxes;
import robosim.geometry.narrow.leaf.LeafColumn;

/** The least distance of an object to any other in a world. */
public final class ProximityQuery {
    /** More than what a square may lose by underflow. */
    private static final double UNDERFLOW = 0x1p-1000;

    private final Distance distance;
    private final NearestSearch search;

    /** What stands for the object whose distance to others is asked. */
    private final LeafColumn own = new LeafColumn(1);

    /** The bounds of its leaves, where there are several. */
    private final LeafBoxes ownBoxes = new LeafBoxes();

    /** And its bounds. */
    private final double[] box = new double[6];

    private Dimension dimension = Dimension.SPATIAL;
    private boolean isCoarse;
    private double best;

    public ProximityQuery(ObjectTable objects, Scratch scratch) {
        distance = new Distance(scratch);
        search = new NearestSearch(objects, this::hit);
    }

    /** The least distance of an object to any other; +Infinity where that is beyond the limit. */
    public double of(AccuracyView view, int id, double limit) {
        LeafTable home = view.table(id);
        System.arraycopy(home.bounds(), home.boundsAt(id), box, 0, 6);
        own.clear();
        own.appendWhole(home.leaves(), home.first(id), home.count(id));
        dimension = view.dimension;
        if (own.size() > 1) {
            ownBoxes.setAll(own, 0, own.size(), dimension == Dimension.PLANAR);
        }
        isCoarse = view.accuracy != Accuracy.EXACT;
        best = Double.POSITIVE_INFINITY;
        search.search(view, box, limit, id);
        return best <= limit ? best : Double.POSITIVE_INFINITY;
    }

    private double hit(LeafTable table, int other, double reach) {
        double sizes = Distance.sides(box) + sides(table, other);
        double far = Distance.reach(reach, sizes);
        if (boxGap(table, other) > far) {
            return reach;
        }
        int first = table.first(other);
        int last = first + table.count(other);
        for (int j = first; j < last; j++) {
            int near = near(table, j, Distance.reach(Math.min(reach, best), sizes));
            for (int k = 0; k < near; k++) {
                int i = own.size() == 1 ? 0 : ownBoxes.found(k);
                double limit = isCoarse ? Math.min(far, Distance.reach(best, sizes)) : Math.min(reach, best);
                double found = distance.between(dimension, own, i, table.leaves(), j, limit);
                best = Math.min(best, isCoarse ? Distance.ofEnclosures(found, sizes) : found);
            }
        }
        return Math.min(reach, best);
    }

    /** Finds the own leaves that may be so near to another leaf. */
    private int near(LeafTable table, int leaf, double far) {
        if (own.size() == 1) {
            return 1;
        }
        table.leaves().bounds(leaf, ownBoxes.box);
        return ownBoxes.within(far);
    }

    static double sides(LeafTable table, int other) {
        double[] b = table.bounds();
        int k = table.boundsAt(other);
        return (b[k + 3] - b[k]) + (b[k + 4] - b[k + 1]) + (b[k + 5] - b[k + 2]);
    }

    /** A lower bound of the distance of another object: that of their bounds. */
    private double boxGap(LeafTable table, int other) {
        double[] b = table.bounds();
        int k = table.boundsAt(other);
        double squared = 0;
        for (int axis = 0; axis < 3; axis += dimension == Dimension.PLANAR ? 2 : 1) {
            double gap = Math.max(box[axis] - b[k + 3 + axis], b[k + axis] - box[3 + axis]);
            if (gap > 0) {
                squared += gap * gap;
            }
        }
        return squared < UNDERFLOW ? 0 : Math.sqrt(squared) * (1 - 0x1p-50);
    }
}
