package robosim.geometry.world.mesh;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.material.TextureCoordinates;
import robosim.geometry.model.Point;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.FileWork;
import robosim.geometry.world.shared.Limits;

/** The vertices and faces of one mesh of a COLLADA file, in its own coordinates, with its texture points and materials. */
final class ColladaFaces {
    private final List<Point> vertices = new ArrayList<>();
    private final List<int[]> faces = new ArrayList<>();
    private final List<int[]> textures = new ArrayList<>();
    private final List<String> materials = new ArrayList<>();
    private final List<Double> points = new ArrayList<>();

    /** Where the points of each source begin. */
    private final Map<ColladaElement, Integer> begins = new HashMap<>();

    private final ColladaParser file;

    private ColladaFaces(ColladaParser file) {
        this.file = file;
    }

    static JoinedFaces.Part read(ColladaElement mesh, ColladaParser file) throws FileProblem {
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
        }
        double[] all = read.points.stream().mapToDouble(Double::doubleValue).toArray();
        return new JoinedFaces.Part(read.vertices, read.faces, read.textures, all, read.materials).used();
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
        ColladaElement shares = null;
        for (ColladaElement input : primitive.all("input")) {
            int at = input.whole("offset", 0, Limits.MAX_CORNERS);
            stride = Math.max(stride, at + 1);
            offset = input.attribute("semantic").equals("VERTEX") ? at : offset;
            shares = shares == null && input.attribute("semantic").equals("TEXCOORD") ? input : shares;
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
            int begin = shares == null ? -1 : points(shares);
            Corners corners = new Corners(new int[count], new int[count]);
            for (int k = 0; k < count; k++) {
                corners.vertices[k] = list.index(k * stride + offset, vertices.size(), "vertices");
                corners.points[k] = shares == null ? TextureCoordinates.NONE : point(list, k * stride, shares, begin);
            }
            switch (primitive.name) {
                case "triangles" -> triangles(list, corners);
                case "polylist" -> polylist(primitive, list, corners);
                case "polygons" -> polygon(list, corners, 0, count);
                case "tristrips" -> strip(list, corners);
                default -> fan(list, corners);
            }
            String material = primitive.attribute("material");
            while (materials.size() < faces.size()) {
                materials.add(material);
            }
        }
    }

    /** The corners of a list: their vertices and their texture points. */
    @SuppressWarnings("ArrayRecordComponent") // never compared
    private record Corners(int[] vertices, int[] points) {
        int count() {
            return vertices.length;
        }
    }

    /** The texture point of a corner; {@link TextureCoordinates#NONE} for one that there is not, which harms no shape. */
    private int point(ColladaElement list, int at, ColladaElement shares, int begin) {
        try {
            int index = begin + list.index(at + shares.whole("offset", 0, Limits.MAX_CORNERS), Limits.MAX_NUMBERS, "");
            return begin >= 0 && 2 * index < points.size() ? index : TextureCoordinates.NONE;
        } catch (FileProblem e) {
            return TextureCoordinates.NONE;
        }
    }

    /** Where the texture points of an input begin among all; -1 if they cannot be read, which harms no shape. */
    private int points(ColladaElement input) {
        try {
            ColladaElement source = file.referred(input, "source");
            Integer known = begins.get(source);
            if (known == null) {
                ColladaElement array = source.required("float_array");
                ColladaElement technique = source.child("technique_common");
                ColladaElement accessor = technique == null ? null : technique.child("accessor");
                int stride = accessor == null ? 2 : Math.max(2, accessor.whole("stride", 2, Limits.MAX_CORNERS));
                known = points.size() / 2;
                for (int at = 0; at + 1 < array.count(); at += stride) {
                    FileWork.take(1);
                    points.add(Checks.coordinate("u", array.number(at)));
                    points.add(Checks.coordinate("v", array.number(at + 1)));
                }
                begins.put(source, known);
            }
            return known;
        } catch (FileProblem | IllegalArgumentException e) {
            return -1;
        }
    }

    private void triangles(ColladaElement list, Corners corners) throws FileProblem {
        if (corners.count() % 3 != 0) {
            throw list.wrong("triangles must have 3 corners each (got: " + corners.count() + " corners in all)");
        }
        for (int k = 0; k < corners.count(); k += 3) {
            face(list, corners, k, k + 1, k + 2);
        }
    }

    private void polylist(ColladaElement primitive, ColladaElement list, Corners corners) throws FileProblem {
        ColladaElement counts = primitive.required("vcount");
        int from = 0;
        for (int k = 0; k < counts.count(); k++) {
            int count = counts.index(k, corners.count() - from + 1, "corners that are left, and one");
            polygon(list, corners, from, count);
            from += count;
        }
        if (from != corners.count()) {
            throw counts.wrong("<vcount> must have the numbers of corners of all polygons, " + corners.count()
                    + " together (got: " + from + ")");
        }
    }

    /** A polygon; one that crosses itself is drawn as a fan, as simulators do. */
    private void polygon(ColladaElement list, Corners corners, int from, int count) throws FileProblem {
        if (count < 3) {
            return; // a point or an edge
        }
        if (count > Limits.MAX_CORNERS) {
            throw list.wrong("a polygon must have at most " + Limits.MAX_CORNERS
                    + " corners; cut it into smaller ones (got: " + count + ")");
        }
        bounded(list, count - 2);
        int[] polygon = Arrays.copyOfRange(corners.vertices, from, from + count);
        int before = faces.size();
        Polygon.cutOrFan(vertices, polygon, faces);
        Map<Integer, Integer> pointOf = new HashMap<>(); // of a vertex that occurs twice, the first one
        for (int k = 0; k < count; k++) {
            pointOf.putIfAbsent(polygon[k], corners.points[from + k]);
        }
        for (int[] piece : faces.subList(before, faces.size())) {
            textures.add(Arrays.stream(piece)
                    .map(vertex -> pointOf.getOrDefault(vertex, TextureCoordinates.NONE))
                    .toArray());
        }
    }

    private void strip(ColladaElement list, Corners corners) throws FileProblem {
        for (int k = 0; k + 2 < corners.count(); k++) {
            // Every other triangle of a strip is written the other way round.
            face(list, corners, k, k + 1 + k % 2, k + 2 - k % 2);
        }
    }

    private void fan(ColladaElement list, Corners corners) throws FileProblem {
        for (int k = 1; k + 1 < corners.count(); k++) {
            face(list, corners, 0, k, k + 1);
        }
    }

    private void face(ColladaElement list, Corners from, int a, int b, int c) throws FileProblem {
        bounded(list, 1);
        faces.add(new int[] {from.vertices[a], from.vertices[b], from.vertices[c]});
        textures.add(new int[] {from.points[a], from.points[b], from.points[c]});
    }

    private void bounded(ColladaElement list, int more) throws FileProblem {
        FileWork.take(more);
        if (faces.size() + more > Limits.MAX_FACES) {
            throw list.wrong("a mesh must have at most " + Limits.MAX_FACES
                    + " faces, cut into triangles; simplify or split it (got: more)");
        }
    }
}
