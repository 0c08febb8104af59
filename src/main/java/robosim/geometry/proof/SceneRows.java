package robosim.geometry.proof;

import java.util.ArrayList;
import java.util.Arrays;
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
    SceneRows(List<GeometryObject> objects, @Nullable SceneRows earlier) {
        this.objects = objects;
        List<double[]> all = new ArrayList<>(objects.size());
        first = new int[objects.size() + 1];
        int same = 0;
        for (int k = 0; k < objects.size(); k++) {
            if (earlier != null
                    && k < earlier.objects.size()
                    && earlier.objects.get(k) == objects.get(k)
                    && earlier.first[k] == first[k]) {
                all.addAll(Arrays.asList(earlier.rows).subList(earlier.first[k], earlier.first[k + 1]));
                same++;
            } else {
                all.addAll(Piece.stored(objects.get(k)));
            }
            first[k + 1] = all.size();
        }
        rows = all.toArray(double[][]::new);
        exact = new Piece[rows.length];
        bounds = earlier != null && earlier.rows.length == rows.length && same > 0
                ? earlier.bounds.clone()
                : new double[6 * rows.length];
        for (int j = 0; j < rows.length; j++) {
            if (earlier == null || bounds.length != earlier.bounds.length || earlier.rows[j] != rows[j]) {
                Rows.bounds(rows[j], bounds, 6 * j);
            }
        }
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
