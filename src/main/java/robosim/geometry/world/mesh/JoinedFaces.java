package robosim.geometry.world.mesh;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;
import robosim.geometry.world.shared.FileWork;

/** The faces of a mesh that is put together from parts. Equal vertices are joined, and those that no face uses left out. */
final class JoinedFaces {
    private final Map<Point, Integer> indices = new HashMap<>();
    private final List<Point> vertices = new ArrayList<>();
    private final List<int[]> faces = new ArrayList<>();

    /** How many faces there are. */
    int size() {
        return faces.size();
    }

    /**
     * Adds all of a part, or nothing of it.
     *
     * @throws IllegalArgumentException if a vertex has no coordinates that a point may have, once it is placed
     */
    void add(List<Point> corners, List<int[]> part, AffineTransform place) {
        Point[] placed = new Point[corners.size()];
        for (int[] face : part) {
            for (int corner : face) {
                if (placed[corner] == null) {
                    placed[corner] = place.apply(corners.get(corner));
                }
            }
        }
        int[] known = new int[corners.size()]; // 1 more than the index
        boolean isMirror = place.isMirror();
        for (int[] face : part) {
            FileWork.take(1);
            int[] copy = new int[face.length];
            for (int k = 0; k < face.length; k++) {
                int corner = face[k];
                if (known[corner] == 0) {
                    known[corner] = 1 + index(placed[corner]);
                }
                // From the first corner on, so that a quad keeps its diagonal.
                copy[isMirror ? (face.length - k) % face.length : k] = known[corner] - 1;
            }
            faces.add(copy);
        }
    }

    /** Leaves out the vertices of a part that no face uses, so that many instances of it cost what they show. */
    static void dropUnused(List<Point> vertices, List<int[]> faces) {
        int[] places = new int[vertices.size()]; // 1 more than the new index; 0 for those that are not used
        List<Point> used = new ArrayList<>();
        for (int[] face : faces) {
            for (int k = 0; k < face.length; k++) {
                int corner = face[k];
                if (places[corner] == 0) {
                    used.add(vertices.get(corner));
                    places[corner] = used.size();
                }
                face[k] = places[corner] - 1;
            }
        }
        vertices.clear();
        vertices.addAll(used);
    }

    private int index(Point point) {
        Integer known = indices.putIfAbsent(point, vertices.size());
        if (known != null) {
            return known;
        }
        vertices.add(point);
        return vertices.size() - 1;
    }

    MeshObject mesh() {
        return new MeshObject(vertices, faces.toArray(int[][]::new));
    }
}
