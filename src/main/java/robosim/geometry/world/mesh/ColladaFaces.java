package robosim.geometry.world.mesh;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.model.Point;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.FileWork;
import robosim.geometry.world.shared.Limits;

/** The vertices and faces of one mesh of a COLLADA file, in its own coordinates. */
final class ColladaFaces {
    final List<Point> vertices = new ArrayList<>();
    final List<int[]> faces = new ArrayList<>();
    private final ColladaParser file;

    private ColladaFaces(ColladaParser file) {
        this.file = file;
    }

    static ColladaFaces read(ColladaElement mesh, ColladaParser file) throws FileProblem {
        ColladaFaces read = new ColladaFaces(file);
        ColladaElement positions = read.positions(mesh);
        if (positions != null) {
            read.vertices(positions);
            for (ColladaElement each : mesh.children) {
                switch (each.name) {
                    case "triangles", "polylist", "polygons", "tristrips", "trifans" -> read.primitive(each);
                    default -> {} // sources and vertices
                }
            }
            JoinedFaces.dropUnused(read.vertices, read.faces);
        }
        return read;
    }

    /** The source of the positions, which a mesh of vertices has. */
    private @Nullable ColladaElement positions(ColladaElement mesh) throws FileProblem {
        ColladaElement vertices = mesh.child("vertices");
        if (vertices == null) {
            return null;
        }
        for (ColladaElement input : vertices.children) {
            if (input.attribute("semantic").equals("POSITION")) {
                return file.referred(input, "source");
            }
        }
        throw vertices.wrong("<vertices> must have <input semantic=\"POSITION\"> (got: none)");
    }

    private void vertices(ColladaElement source) throws FileProblem {
        ColladaElement array = source.required("float_array");
        ColladaElement technique = source.child("technique_common");
        ColladaElement accessor = technique == null ? null : technique.child("accessor");
        int stride = accessor == null ? 3 : accessor.whole("stride", 1, Limits.MAX_CORNERS);
        int offset = accessor == null ? 0 : accessor.whole("offset", 0, Limits.MAX_NUMBERS);
        int given = array.count() < offset ? 0 : (array.count() - offset) / Math.max(1, stride);
        int count = accessor == null ? given : accessor.whole("count", given, Limits.MAX_NUMBERS);
        if (stride < 3 || count > given) {
            throw source.wrong("<accessor> must take at least 3 numbers for each vertex, and not more than"
                    + " <float_array> has (got: " + count + " vertices with a stride of " + stride + " from "
                    + array.count() + " numbers)");
        }
        for (int k = 0; k < count; k++) {
            int at = offset + k * stride;
            FileWork.take(1);
            try {
                vertices.add(new Point(array.number(at), array.number(at + 1), array.number(at + 2)));
            } catch (IllegalArgumentException e) {
                throw array.wrong("<float_array>: " + e.getMessage());
            }
        }
    }

    private void primitive(ColladaElement primitive) throws FileProblem {
        int stride = 1;
        int offset = -1;
        for (ColladaElement input : primitive.all("input")) {
            int at = input.whole("offset", 0, Limits.MAX_CORNERS);
            stride = Math.max(stride, at + 1);
            offset = input.attribute("semantic").equals("VERTEX") ? at : offset;
        }
        ColladaElement holes = primitive.child("ph");
        if (holes != null) {
            throw holes.wrong("polygons with holes are not supported; cut them into triangles in the program that made"
                    + " the file (got: <ph>)");
        }
        List<ColladaElement> lists = primitive.all("p");
        if (offset < 0 && !lists.isEmpty()) {
            throw primitive.wrong(
                    "<" + primitive.name + "> must have <input semantic=\"VERTEX\" offset=\"...\"> (got: none)");
        }
        for (ColladaElement list : lists) {
            int count = list.count() / stride;
            if (count * stride != list.count()) {
                throw list.wrong("<p> must have " + stride + " indices for each corner (got: " + list.count() + ")");
            }
            int[] corners = new int[count];
            for (int k = 0; k < count; k++) {
                corners[k] = list.index(k * stride + offset, vertices.size(), "vertices");
            }
            switch (primitive.name) {
                case "triangles" -> triangles(list, corners);
                case "polylist" -> polylist(primitive, list, corners);
                case "polygons" -> polygon(list, corners);
                case "tristrips" -> strip(list, corners);
                default -> fan(list, corners);
            }
        }
    }

    private void triangles(ColladaElement list, int[] corners) throws FileProblem {
        if (corners.length % 3 != 0) {
            throw list.wrong("triangles must have 3 corners each (got: " + corners.length + " corners in all)");
        }
        for (int k = 0; k < corners.length; k += 3) {
            face(list, corners[k], corners[k + 1], corners[k + 2]);
        }
    }

    private void polylist(ColladaElement primitive, ColladaElement list, int[] corners) throws FileProblem {
        ColladaElement counts = primitive.required("vcount");
        int from = 0;
        for (int k = 0; k < counts.count(); k++) {
            int count = counts.index(k, corners.length - from + 1, "corners that are left, and one");
            int[] polygon = new int[count];
            System.arraycopy(corners, from, polygon, 0, count);
            polygon(list, polygon);
            from += count;
        }
        if (from != corners.length) {
            throw counts.wrong("<vcount> must have the numbers of corners of all polygons, " + corners.length
                    + " together (got: " + from + ")");
        }
    }

    /** A polygon; one that crosses itself is drawn as a fan, as simulators do. */
    private void polygon(ColladaElement list, int[] corners) throws FileProblem {
        if (corners.length < 3) {
            return; // a point or an edge
        }
        if (corners.length > Limits.MAX_CORNERS) {
            throw list.wrong("a polygon must have at most " + Limits.MAX_CORNERS
                    + " corners; cut it into smaller ones (got: " + corners.length + ")");
        }
        bounded(list, corners.length - 2);
        Polygon.cutOrFan(vertices, corners, faces);
    }

    private void strip(ColladaElement list, int[] corners) throws FileProblem {
        for (int k = 0; k + 2 < corners.length; k++) {
            // Every other triangle of a strip is written the other way round.
            face(list, corners[k], corners[k + 1 + k % 2], corners[k + 2 - k % 2]);
        }
    }

    private void fan(ColladaElement list, int[] corners) throws FileProblem {
        for (int k = 1; k + 1 < corners.length; k++) {
            face(list, corners[0], corners[k], corners[k + 1]);
        }
    }

    private void face(ColladaElement list, int a, int b, int c) throws FileProblem {
        bounded(list, 1);
        faces.add(new int[] {a, b, c});
    }

    private void bounded(ColladaElement list, int more) throws FileProblem {
        FileWork.take(more);
        if (faces.size() + more > Limits.MAX_FACES) {
            throw list.wrong("a mesh must have at most " + Limits.MAX_FACES
                    + " faces, cut into triangles; simplify or split it (got: more)");
        }
    }
}
