package robosim.geometry.engine.broadphase;

import java.util.Arrays;
import robosim.geometry.check.Checks;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.narrow.Overlap;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.LeafColumn;

/** Lists the objects of a world that another one touches or overlaps, the first one added first. */
public final class TouchQuery {
    private final ObjectRegistry registry;
    private final Scratch s;
    private final BoxQuery query;

    /** The leaves of the object that is asked about, and their bounds. */
    private final LeafColumn candidate = new LeafColumn(1);

    private final double[] box = new double[6];
    private AccuracyView view;
    private int[] met = new int[8];
    private int count;

    public TouchQuery(ObjectRegistry registry, Scratch scratch) {
        this.registry = registry;
        s = scratch;
        view = registry.view;
        query = new BoxQuery(registry.objects, this::touch);
    }

    /**
     * Finds what an object touches or overlaps.
     *
     * @param ignored an object that is left out; -1 for none
     * @return how many there are; {@link #touched} has their ids
     */
    public int find(AccuracyView at, GeometryObject object, int ignored) {
        view = at;
        at.own.placed(Checks.present("object", object), candidate);
        candidate.bounds(0, candidate.size(), box);
        count = 0;
        query.each(at, box, ignored);
        registry.objects.sort(met, count);
        return count;
    }

    /** The k-th object found, in the order in which they were added. */
    public int touched(int k) {
        return met[k];
    }

    private boolean touch(LeafTable table, int id) {
        if (Overlap.any(view.dimension, candidate, table.leaves(), table.first(id), table.count(id), s)) {
            add(id);
        }
        return false; // and on to the others
    }

    private void add(int id) {
        if (count == met.length) {
            met = Arrays.copyOf(met, 2 * count);
        }
        met[count++] = id;
    }
}
