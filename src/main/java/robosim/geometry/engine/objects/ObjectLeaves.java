package robosim.geometry.engine.objects;

import org.jspecify.annotations.Nullable;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.narrow.leaf.Enclosure;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.LocalLeaves;

/** The leaves that stand for an object at one accuracy, in the object's own frame, ready to be placed. */
public final class ObjectLeaves {
    public final LocalLeaves own;
    private final Accuracy accuracy;
    private final @Nullable Enclosure enclosure;
    private final @Nullable LeafColumn exact;

    public ObjectLeaves(GeometryObject object, Accuracy accuracy) {
        this.accuracy = accuracy;
        own = LocalLeaves.of(object);
        enclosure = accuracy == Accuracy.EXACT ? null : new Enclosure(own);
        exact = accuracy == Accuracy.EXACT ? null : new LeafColumn(own.size());
        if (exact != null) {
            exact.append(own.size());
        }
    }

    /** The number of leaves that stand for the object. */
    public int size() {
        return enclosure == null ? own.size() : 1;
    }

    /** Writes the placed leaves into a column that has room; in SPATIAL with their bounds in height. */
    public void place(
            Dimension as,
            double cx,
            double cy,
            double cz,
            double[] rotation,
            int at,
            LeafColumn column,
            int firstLeaf) {
        if (enclosure == null || exact == null) {
            own.place(cx, cy, cz, rotation, at, column, firstLeaf);
        } else {
            own.place(cx, cy, cz, rotation, at, exact, 0);
            enclosure.place(accuracy, as, exact, cx, cy, cz, rotation, at, column, firstLeaf);
        }
    }
}
