package robosim.geometry.proof;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.model.GeometryObject;

/** The pieces of a scene as numbers, with bounds. */
final class SceneRows {
    final List<GeometryObject> objects;
    final double[][] rows;
    final int[] first;

    /** Six numbers a piece, rounded outward. */
    final double[] bounds;

    private final @Nullable Piece[] exact;

    /** The pieces of a scene; those of objects that another one has at the same index are taken from there. */
    static SceneRows of(List<GeometryObject> objects, @Nullable SceneRows earlier) {
        SceneRows same = earlier == null ? null : earlier.with(objects);
        return same == null ? new SceneRows(objects) : same;
    }

    private SceneRows(List<GeometryObject> objects) {
        this.objects = objects;
        List<double[]> all = new ArrayList<>(objects.size());
        first = new int[objects.size() + 1];
        for (int k = 0; k < objects.size(); k++) {
            all.addAll(Piece.stored(objects.get(k)));
            first[k + 1] = all.size();
        }
        rows = all.toArray(double[][]::new);
        exact = new Piece[rows.length];
        bounds = new double[6 * rows.length];
        for (int j = 0; j < rows.length; j++) {
            Rows.bounds(rows[j], bounds, 6 * j);
        }
    }

    private SceneRows(List<GeometryObject> objects, SceneRows earlier) {
        this.objects = objects;
        first = earlier.first;
        rows = earlier.rows.clone();
        exact = earlier.exact.clone();
        bounds = earlier.bounds.clone();
    }

    /** The rows of as many objects with as many pieces each; null if these have others. */
    private @Nullable SceneRows with(List<GeometryObject> others) {
        if (others.size() != objects.size()) {
            return null;
        }
        SceneRows made = this;
        for (int k = 0; k < others.size(); k++) {
            if (others.get(k) != objects.get(k)) {
                made = made == this ? new SceneRows(others, this) : made;
                if (!made.replace(k)) {
                    return null;
                }
            }
        }
        return made;
    }

    private boolean replace(int object) {
        List<double[]> stored = Piece.stored(objects.get(object));
        if (stored.size() != first[object + 1] - first[object]) {
            return false;
        }
        for (int k = 0; k < stored.size(); k++) {
            int j = first[object] + k;
            rows[j] = stored.get(k);
            exact[j] = null;
            Rows.bounds(rows[j], bounds, 6 * j);
        }
        return true;
    }

    Piece exact(int j) {
        Piece made = exact[j];
        if (made == null) {
            made = new Piece(rows[j]);
            exact[j] = made;
        }
        return made;
    }

    /** The pieces from one on to before another. */
    List<Piece> exact(int[] range) {
        List<Piece> pieces = new ArrayList<>();
        for (int j = range[0]; j < range[1]; j++) {
            pieces.add(exact(j));
        }
        return pieces;
    }
}
