package robosim.geometry.world;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;

/** The triangles of meshes as lists of points that can be compared, however their vertices are numbered. */
final class MeshTriangles {
    private static final Comparator<Point> ORDER =
            Comparator.comparingDouble(Point::x).thenComparingDouble(Point::y).thenComparingDouble(Point::z);

    private MeshTriangles() {}

    /** The only object of a file that is read. */
    static MeshObject read(Path file) throws IOException {
        return mesh(WorldImport.read(file, ImportOptions.DEFAULT));
    }

    static MeshObject mesh(WorldImport read) {
        return (MeshObject) read.world().objects().get(0).object();
    }

    /** The triangles, each from its least corner on, in order; a polygon that was cut in one way only. */
    static List<List<Point>> of(MeshObject mesh) {
        List<List<Point>> triangles = new ArrayList<>();
        for (int[] face : mesh.faces()) {
            for (int k = 1; k + 1 < face.length; k++) {
                triangles.add(turned(
                        mesh.vertices().get(face[0]),
                        mesh.vertices().get(face[k]),
                        mesh.vertices().get(face[k + 1])));
            }
        }
        return sorted(triangles);
    }

    static List<List<Point>> sorted(List<List<Point>> triangles) {
        List<List<Point>> sorted = new ArrayList<>(triangles);
        sorted.sort(Comparator.<List<Point>, Point>comparing(t -> t.get(0), ORDER)
                .thenComparing(t -> t.get(1), ORDER)
                .thenComparing(t -> t.get(2), ORDER));
        return sorted;
    }

    /** A triangle from its least corner on, in its orientation. */
    static List<Point> turned(Point a, Point b, Point c) {
        if (ORDER.compare(a, b) <= 0 && ORDER.compare(a, c) <= 0) {
            return List.of(a, b, c);
        }
        return ORDER.compare(b, c) <= 0 && ORDER.compare(b, a) <= 0 ? List.of(b, c, a) : List.of(c, a, b);
    }
}
