package robosim.geometry.engine.broadphase;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import robosim.geometry.engine.objects.ObjectLeaves;
import robosim.geometry.engine.objects.ObjectTable;
import robosim.geometry.index.ArrayGrowth;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;

/**
 * A world as it is seen at one accuracy: its own objects and those that it shares with other worlds. A world has the view of
 * the accuracy that it was made for; another one is made when it is first asked for.
 */
public final class AccuracyView {
    public final Accuracy accuracy;
    public final Dimension dimension;

    final LeafTable own;

    /** The static objects that are shared with other worlds; null where there are none. */
    @Nullable
    LeafTable shared;

    /** The objects that were moved since the last query of this view, each once, and a bit for each. */
    private int[] late = new int[0];

    private long[] isLate = new long[0];
    private int lateCount;

    AccuracyView(
            ObjectTable objects,
            Accuracy accuracy,
            Dimension dimension,
            double width,
            double length,
            @Nullable LeafTable shared) {
        this.accuracy = accuracy;
        this.dimension = dimension;
        this.shared = shared;
        own = new LeafTable(objects, accuracy, dimension, width, length);
    }

    /** The table to look at first: that of shared objects, if there are any. The other is {@link #own}. */
    LeafTable first() {
        LeafTable other = shared;
        return other == null ? own : other;
    }

    /** Where an object's leaves and bounds stand. */
    public LeafTable table(int id) {
        LeafTable other = shared;
        return other != null && ObjectTable.isShared(id) ? other : own;
    }

    /** Notes that an object was moved: the next query of the view places it first. */
    void noteMoved(int id) {
        int word = id >> 6;
        if (word >= isLate.length) {
            isLate = Arrays.copyOf(isLate, ArrayGrowth.of(word));
        }
        if ((isLate[word] & 1L << id) == 0) {
            isLate[word] |= 1L << id;
            if (lateCount == late.length) {
                late = Arrays.copyOf(late, ArrayGrowth.of(lateCount));
            }
            late[lateCount++] = id;
        }
    }

    /** Puts all objects where they stand. */
    void catchUp(ObjectTable objects) {
        for (int k = 0; k < lateCount; k++) {
            int id = late[k];
            isLate[id >> 6] = 0;
            own.move(id, objects.places(), objects.place(id));
        }
        lateCount = 0;
    }

    /** Adds an object under an id that it already has in the world. */
    void add(int id, GeometryObject object) {
        own.add(id, object);
    }

    /** How to place a moveable object. */
    public ObjectLeaves form(int id) {
        return own.form(id);
    }

    /** Whether one convex leaf about its centre stands for a moveable object, at its place to the bit. */
    public boolean isSingle(int id) {
        return own.isSingle(id);
    }

    /** Whether what stands for a moveable object is made of convex leaves that keep their shape as it moves. */
    public boolean keepsShape(int id) {
        return own.keepsShape(id);
    }
}
