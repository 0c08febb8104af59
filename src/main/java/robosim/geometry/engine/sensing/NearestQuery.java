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

    /** The nearest so far: while the search runs a heap, with the last of them at its root. */
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
        sort();
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
            take(id, least);
        }
        return reach();
    }

    /** How far there is still something to be found: as far as the last of those wanted, ties included. */
    private double reach() {
        return count < most ? limit : Math.min(limit, distances[0]);
    }

    /** Takes in an object, which the search shows once, in place of the last of those wanted where there are as many. */
    private void take(int id, double found) {
        if (count == most) {
            if (isBefore(found, id, distances[0], ids[0])) {
                sift(0, count, id, found);
            }
            return;
        }
        if (count == ids.length) {
            ids = Arrays.copyOf(ids, 2 * count);
            distances = Arrays.copyOf(distances, 2 * count);
        }
        int at = count++;
        while (at > 0 && isBefore(distances[(at - 1) / 2], ids[(at - 1) / 2], found, id)) {
            put(at, ids[(at - 1) / 2], distances[(at - 1) / 2]);
            at = (at - 1) / 2;
        }
        put(at, id, found);
    }

    /** Sorts the heap, the last of which is at its root: the nearest comes first. */
    private void sort() {
        for (int end = count - 1; end > 0; end--) {
            int id = ids[end];
            double found = distances[end];
            put(end, ids[0], distances[0]);
            sift(0, end, id, found);
        }
    }

    /** Puts an object into the heap from a place on down, up to an end. */
    private void sift(int from, int end, int id, double found) {
        int at = from;
        for (int down = 2 * at + 1; down < end; down = 2 * at + 1) {
            if (down + 1 < end && isBefore(distances[down], ids[down], distances[down + 1], ids[down + 1])) {
                down++;
            }
            if (!isBefore(found, id, distances[down], ids[down])) {
                break;
            }
            put(at, ids[down], distances[down]);
            at = down;
        }
        put(at, id, found);
    }

    private void put(int at, int id, double found) {
        ids[at] = id;
        distances[at] = found;
    }

    private boolean isBefore(double found, int id, double other, int otherId) {
        return found < other || (found == other && objects.isEarlier(id, otherId));
    }
}
