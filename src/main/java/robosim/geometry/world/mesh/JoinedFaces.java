package robosim.geometry.world.mesh;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.UnaryOperator;
import robosim.geometry.material.TextureCoordinates;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.FileWork;

/** The faces of a mesh that is put together from parts. Equal vertices are joined, and those that no face uses left out. */
final class JoinedFaces {
    private final Map<Point, Integer> indices = new HashMap<>();
    private final List<Point> vertices = new ArrayList<>();
    private final ObjFaces faces = new ObjFaces(vertices);

    /** How many faces there are. */
    int size() {
        return faces.size();
    }

    /**
     * A part in its own coordinates.
     *
     * @param textures  for each face the texture points of its corners; none if no face has any
     * @param points    u and v of each texture point
     * @param materials for each face the name of what it is made of; none if no face has any
     */
    @SuppressWarnings("ArrayRecordComponent") // never compared
    record Part(
            List<Point> vertices, List<int[]> faces, List<int[]> textures, double[] points, List<String> materials) {
        /** The same part without vertices and texture points that no face uses, so that many instances of it cost what they show. */
        Part used() {
            dropUnused(vertices, faces);
            int[] places = new int[points.length / 2]; // 1 more than the new index; 0 for those that are not used
            double[] left = new double[points.length];
            int count = 0;
            for (int[] texture : textures) {
                for (int k = 0; k < texture.length; k++) {
                    int point = texture[k];
                    if (point >= 0 && places[point] == 0) {
                        left[2 * count] = points[2 * point];
                        left[2 * count + 1] = points[2 * point + 1];
                        places[point] = ++count;
                    }
                    texture[k] = point < 0 ? TextureCoordinates.NONE : places[point] - 1;
                }
            }
            return new Part(vertices, faces, textures, Arrays.copyOf(left, 2 * count), materials);
        }
    }

    /**
     * Adds all of a part, or nothing of it.
     *
     * @param names answers what the name of a material stands for where the part is
     * @throws IllegalArgumentException if a vertex has no coordinates that a point may have, once it is placed
     */
    void add(Part part, AffineTransform place, UnaryOperator<String> names) {
        List<Point> corners = part.vertices;
        Point[] placed = new Point[corners.size()];
        for (int[] face : part.faces) {
            for (int corner : face) {
                if (placed[corner] == null) {
                    placed[corner] = place.apply(corners.get(corner));
                }
            }
        }
        int before = faces.points();
        for (int k = 0; k < part.points.length; k += 2) {
            faces.point(part.points[k], part.points[k + 1]);
        }
        int[] known = new int[corners.size()]; // 1 more than the index
        boolean isMirror = place.isMirror();
        for (int f = 0; f < part.faces.size(); f++) {
            int[] face = part.faces.get(f);
            FileWork.take(1);
            int[] copy = new int[face.length];
            int[] texture = new int[face.length];
            for (int k = 0; k < face.length; k++) {
                int corner = face[k];
                if (known[corner] == 0) {
                    known[corner] = 1 + index(placed[corner]);
                }
                // From the first corner on, so that a quad keeps its diagonal.
                int to = isMirror ? (face.length - k) % face.length : k;
                copy[to] = known[corner] - 1;
                int point = part.textures.isEmpty()
                        ? TextureCoordinates.NONE
                        : part.textures.get(f)[k];
                texture[to] = point < 0 ? TextureCoordinates.NONE : before + point;
            }
            if (!part.materials.isEmpty()) {
                faces.use(names.apply(part.materials.get(f)));
            }
            faces.keep(copy, texture);
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

    /** The mesh of shape alone. */
    MeshObject mesh() throws FileProblem {
        return faces.mesh(null);
    }

    /** The mesh with its materials. */
    MeshObject mesh(ObjFaces.Materials materials) throws FileProblem {
        return faces.mesh(materials);
    }
}
