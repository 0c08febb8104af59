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
    private final @Nullable Enclosure enclosure;

    public ObjectLeaves(GeometryObject object, Accuracy accuracy) {
        own = LocalLeaves.of(object);
        enclosure = accuracy == Accuracy.EXACT ? null : new Enclosure(accuracy, own);
    }

    /** The form of an object of the same shape, for places of its own. */
    ObjectLeaves(ObjectLeaves of) {
        own = of.own;
        enclosure = of.enclosure == null ? null : new Enclosure(of.enclosure);
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
        if (enclosure == null) {
            own.place(cx, cy, cz, rotation, at, column, firstLeaf);
        } else {
            enclosure.place(as, cx, cy, cz, rotation, at, column, firstLeaf);
        }
    }

    /** Sets a column to what stands for an object given by sizes, where it stands; this becomes its form. */
    void placeSized(Dimension as, GeometryObject object, LeafColumn column) {
        if (enclosure == null) {
            LocalLeaves.placed(object, column);
        } else {
            enclosure.placeSized(as, object, column, column.append(1));
        }
    }
}
