package robosim.geometry.engine.broadphase;

import java.util.Arrays;
import robosim.geometry.engine.objects.IgnoredObjects;
import robosim.geometry.engine.objects.ObjectTable;

/** A list of the objects whose bounds meet a box, each once. */
public final class Candidates {
    private final BoxQuery query;
    private final ObjectTable objects;
    private final IgnoredObjects ignored;
    private int[] ids = new int[16];
    private int count;

    public Candidates(ObjectTable objects) {
        query = new BoxQuery(objects, this::add);
        this.objects = objects;
        ignored = objects.ignored;
    }

    public int count() {
        return count;
    }

    public int id(int k) {
        return ids[k];
    }

    /**
     * Finds the candidates of a box.
     *
     * @param ignored an object that is left out; -1 for none
     */
    public void find(AccuracyView view, double[] box, int ignored) {
        count = 0;
        query.each(view, box, ignored);
    }

    /** Puts them into the order in which they were added to the world, which no tree and no earlier query changes. */
    public void sort() {
        objects.sort(ids, count);
    }

    private boolean add(LeafTable table, int id) {
        if (ignored.has(id)) {
            return false;
        }
        if (count == ids.length) {
            ids = Arrays.copyOf(ids, 2 * count);
        }
        ids[count++] = id;
        return false;
    }
}
