package robosim.geometry.engine.broadphase;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import robosim.geometry.engine.objects.ObjectTable;
import robosim.geometry.index.boxes.OctTree;
import robosim.geometry.index.boxes.SpaceKeys;

/** The objects whose bounds meet a box: from the trees, and from the list of moveable ones where these are few. */
public final class Candidates {
    private final ObjectTable bodies;
    private final SpaceKeys keys = new SpaceKeys();
    private int[] ids = new int[16];
    private int count;

    public Candidates(ObjectTable bodies) {
        this.bodies = bodies;
    }

    public int count() {
        return count;
    }

    public int id(int k) {
        return ids[k];
    }

    /** Finds all but one, or all with -1. */
    public void find(AccuracyView level, double[] box, int but) {
        count = 0;
        gather(level, box, but);
        AccuracyView shared = level.shared();
        if (shared != null) {
            gather(shared, box, but);
        }
    }

    /** Finds all but one of those that are a level's own. */
    void findIn(AccuracyView level, double[] box, int but) {
        count = 0;
        gather(level, box, but);
    }

    private void gather(AccuracyView level, double[] box, int but) {
        int mark = level.mark;
        level.cursor.startBox(box[0], box[2], box[3], box[5]);
        for (int id = level.cursor.next(); id >= 0; id = level.cursor.next()) {
            if ((id | mark) != but && level.meets(id, box)) {
                add(id | mark);
            }
        }
        OctTree.@Nullable Cursor stacked = level.spaceIndex.cursor();
        if (stacked != null) {
            keys.startBox(box);
            stacked.start(level.bounds(), keys);
            for (int id = stacked.next(0); id >= 0; id = stacked.next(0)) {
                add(id | mark);
            }
        }
        for (int k = 0; k < level.moversBesideTree(); k++) {
            int id = bodies.mover(k);
            if (id != but && level.meets(id, box)) {
                add(id);
            }
        }
    }

    private void add(int id) {
        if (count == ids.length) {
            ids = Arrays.copyOf(ids, 2 * count);
        }
        ids[count++] = id;
    }
}
