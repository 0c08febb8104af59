package robosim.geometry.engine.sensing;

import java.util.Arrays;
import robosim.geometry.engine.broadphase.AccuracyView;
import robosim.geometry.engine.broadphase.LeafTable;
import robosim.geometry.engine.broadphase.NearestSearch;
import robosim.geometry.engine.objects.ObjectTable;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;
import robosim.geometry.narrow.Distance;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.LocalLeaves;

/** The objects that are nearest to another one or to a point, nearest first; of two equally near the one added first. */
public final class NearestQuery {
    private final ObjectTable objects;
    private final Distance distance;
    private final NearestSearch search;
    private final LeafColumn own = new LeafColumn(1);
    private final double[] box = new double[6];
    private Dimension dimension = Dimension.SPATIAL;
    private boolean isCoarse;
    private double limit;
    private int most;
    private int count;
    private int[] ids = new int[8];
    private double[] distances = new double[8];

    public NearestQuery(ObjectTable objects, Scratch scratch) {
        this.objects = objects;
        distance = new Distance(scratch);
        search = new NearestSearch(objects, this::hit);
    }

    /**
     * Searches around an object, which is left out.
     *
     * @return how many were found
     */
    public int around(AccuracyView view, int id, int wanted, double range) {
        LeafTable home = view.table(id);
        System.arraycopy(home.bounds(), home.boundsAt(id), box, 0, 6);
        own.clear();
        own.appendWhole(home.leaves(), home.first(id), home.count(id));
        return search(view, wanted, range, id);
    }

    /** Searches around a point. */
    public int around(AccuracyView view, Point point, int wanted, double range) {
        LocalLeaves.placed(new SphereObject(point, 0), own);
        own.bounds(0, own.size(), box);
        return search(view, wanted, range, -1);
    }

    private int search(AccuracyView view, int wanted, double range, int ignored) {
        dimension = view.dimension;
        isCoarse = view.accuracy != Accuracy.EXACT;
        most = wanted;
        limit = range;
        count = 0;
        if (wanted > 0) {
            search.search(view, box, range, ignored);
        }
        return count;
    }

    /** The k-th object found. */
    public int found(int k) {
        return ids[k];
    }

    /** Its distance. */
    public double distance(int k) {
        return distances[k];
    }

    private double hit(LeafTable table, int id, double reach) {
        int first = table.first(id);
        double least = Double.POSITIVE_INFINITY;
        double sizes = isCoarse ? Distance.sides(box) + ProximityQuery.sides(table, id) : 0;
        for (int i = 0; i < own.size(); i++) {
            for (int j = first; j < first + table.count(id); j++) {
                double most = Math.min(reach(), least);
                double far = isCoarse ? Distance.reach(most, sizes) : most;
                double found = distance.between(dimension, own, i, table.leaves(), j, far);
                least = Math.min(least, isCoarse ? Distance.ofEnclosures(found, sizes) : found);
            }
        }
        if (least <= limit && least < Double.POSITIVE_INFINITY) {
            insert(id, least);
        }
        return reach();
    }

    /** How far there is still something to be found: as far as the last of those wanted, ties included. */
    private double reach() {
        return count < most ? limit : Math.min(limit, distances[count - 1]);
    }

    private void insert(int id, double found) {
        int at = count;
        for (int k = 0; k < count; k++) {
            if (ids[k] == id) {
                return; // shown twice
            }
        }
        while (at > 0 && isBefore(found, id, distances[at - 1], ids[at - 1])) {
            at--;
        }
        if (at >= most) {
            return;
        }
        if (count < most) {
            if (count == ids.length) {
                ids = Arrays.copyOf(ids, 2 * count);
                distances = Arrays.copyOf(distances, 2 * count);
            }
            count++;
        }
        System.arraycopy(ids, at, ids, at + 1, count - 1 - at);
        System.arraycopy(distances, at, distances, at + 1, count - 1 - at);
        ids[at] = id;
        distances[at] = found;
    }

    private boolean isBefore(double found, int id, double other, int otherId) {
        return found < other || (found == other && objects.isEarlier(id, otherId));
    }
}
