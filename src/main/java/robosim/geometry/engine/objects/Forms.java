package robosim.geometry.engine.objects;

import java.util.EnumMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import robosim.geometry.exact.Attitude;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.narrow.leaf.LeafColumn;

/**
 * Places objects as they are seen at one accuracy below EXACT. The forms of the meshes and groups that came last are kept, as
 * measuring one takes long and many objects have the same shape.
 */
public final class Forms {
    /** The number of shapes kept. */
    private static final int KEPT = 8;

    private final Accuracy accuracy;

    /** The objects for which the forms were made, the same number of each; null where there is none yet. */
    private final @Nullable GeometryObject[] shapes = new GeometryObject[KEPT];

    private final @Nullable ObjectLeaves[] forms = new ObjectLeaves[KEPT];
    private final double[] attitude = new double[Attitude.STRIDE];

    /** The one that is given up next. */
    private int oldest;

    /** For objects given by sizes, one of each kind. */
    private final Map<GeometryObject.Kind, ObjectLeaves> sized = new EnumMap<>(GeometryObject.Kind.class);

    public Forms(Accuracy accuracy) {
        this.accuracy = accuracy;
    }

    /** Sets a column to what stands for an object where it stands. */
    public void place(Dimension dimension, GeometryObject object, LeafColumn column) {
        column.clear();
        if (object.kind().isSized()) {
            ObjectLeaves form = sized.get(object.kind());
            if (form == null) {
                form = new ObjectLeaves(object, accuracy);
                sized.put(object.kind(), form);
            }
            form.placeSized(dimension, object, column);
            return;
        }
        object.pose().attitude(attitude, 0);
        Point c = object.center();
        ObjectLeaves form = shared(object);
        column.append(form.size());
        form.place(dimension, c.x(), c.y(), c.z(), attitude, 0, column, 0);
    }

    /** The form of an object, for it alone. */
    public ObjectLeaves of(GeometryObject object) {
        return object.kind().isSized() ? new ObjectLeaves(object, accuracy) : new ObjectLeaves(shared(object));
    }

    private ObjectLeaves shared(GeometryObject object) {
        for (int k = 0; k < KEPT; k++) {
            GeometryObject other = shapes[k];
            ObjectLeaves form = forms[k];
            if (other != null && form != null && hasShape(object, other)) {
                return form;
            }
        }
        ObjectLeaves made = new ObjectLeaves(object, accuracy);
        shapes[oldest] = object;
        forms[oldest] = made;
        oldest = (oldest + 1) % KEPT;
        return made;
    }

    /** Whether two objects are of the same triangles or members; not whether these are equal, which takes long. */
    @SuppressWarnings("ReferenceEquality")
    private static boolean hasShape(GeometryObject one, GeometryObject two) {
        if (one instanceof MeshObject mesh && two instanceof MeshObject other) {
            return mesh.triangles() == other.triangles() && mesh.isSolid() == other.isSolid();
        }
        return one instanceof ObjectGroup group
                && two instanceof ObjectGroup other
                && group.members() == other.members();
    }
}
