package robosim.geometry.viewer.scene;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import robosim.geometry.index.meshes.TriangleMesh;
import robosim.geometry.model.Bounds;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;

/**
 * Orders what a plan shows by height. A mesh takes part with each of its triangles, so that furniture is seen on the
 * floor of a mesh that has walls too. In plain doubles.
 */
public final class Layers {
    private Layers() {}

    /**
     * A part of an object that is painted at once.
     *
     * @param thing  the object
     * @param areas  what it covers
     * @param isMesh whether the areas are triangles, which have no outlines of their own
     * @param lines  the edges of a mesh to be drawn, x, z, x, z each; on top of the areas
     * @param index  of the object among those given
     * @param height from 0 for the lowest triangles of all meshes to 1 for the highest, in steps; 1 for other objects
     */
    public record Layer(
            Scene.Thing thing, List<Footprint> areas, boolean isMesh, List<double[]> lines, int index, double height) {
        /** What contains its areas as seen from above. */
        public Bounds bounds() {
            if (!isMesh) {
                return thing.object().bounds();
            }
            double minX = Double.POSITIVE_INFINITY;
            double minZ = Double.POSITIVE_INFINITY;
            double maxX = Double.NEGATIVE_INFINITY;
            double maxZ = Double.NEGATIVE_INFINITY;
            for (Footprint area : areas) {
                double[] corners = ((Footprint.Polygon) area).corners();
                for (int k = 0; k < corners.length; k += 2) {
                    minX = Math.min(minX, corners[k]);
                    maxX = Math.max(maxX, corners[k]);
                    minZ = Math.min(minZ, corners[k + 1]);
                    maxZ = Math.max(maxZ, corners[k + 1]);
                }
            }
            return new Bounds(minX, 0, minZ, maxX, 0, maxZ);
        }
    }

    /** Steps of the heights of triangles. */
    private static final int STEPS = 8;

    /** One triangle, or all of an object without meshes. */
    private record Piece(
            Scene.Thing thing, int order, double top, List<Footprint> areas, boolean isMesh, List<double[]> lines) {}

    /** Layers in painting order: the lowest top first, in the given order for equal tops. */
    public static List<Layer> fromBelow(List<Scene.Thing> things) {
        List<Piece> pieces = new ArrayList<>();
        for (int k = 0; k < things.size(); k++) {
            split(things.get(k), things.get(k).object(), k, pieces);
        }
        pieces.sort(Comparator.comparingDouble(Piece::top).thenComparingInt(Piece::order)); // stable
        return merged(pieces);
    }

    private static void split(Scene.Thing thing, GeometryObject part, int order, List<Piece> pieces) {
        if (part instanceof MeshObject mesh) {
            triangles(thing, mesh.triangles(), new Footprint.Frame(part.pose()), order, pieces);
        } else if (part instanceof ObjectGroup group && hasMesh(group)) {
            for (GeometryObject member : group.placedMembers()) {
                split(thing, member, order, pieces);
            }
        } else {
            pieces.add(new Piece(thing, order, part.bounds().maxY(), Footprint.of(part), false, List.of()));
        }
    }

    private static boolean hasMesh(GeometryObject object) {
        return object instanceof MeshObject
                || (object instanceof ObjectGroup group
                        && group.members().stream().anyMatch(Layers::hasMesh));
    }

    private static void triangles(
            Scene.Thing thing, TriangleMesh mesh, Footprint.Frame frame, int order, List<Piece> pieces) {
        double[] seen = new double[2 * mesh.vertices()];
        double[] heights = new double[mesh.vertices()];
        for (int v = 0; v < heights.length; v++) {
            double x = mesh.coordinate(v, 0);
            double y = mesh.coordinate(v, 1);
            double z = mesh.coordinate(v, 2);
            frame.project(x, y, z, seen, 2 * v);
            heights[v] = frame.height(x, y, z);
        }
        double[] tops = new double[mesh.size()];
        List<List<double[]>> lines = new ArrayList<>();
        for (int t = 0; t < tops.length; t++) {
            tops[t] = Math.max(
                    heights[mesh.vertex(t, 0)], Math.max(heights[mesh.vertex(t, 1)], heights[mesh.vertex(t, 2)]));
            lines.add(List.of());
        }
        new MeshEdges(mesh).drawn(seen, tops, (a, b, highest) -> {
            if (lines.get(highest).isEmpty()) {
                lines.set(highest, new ArrayList<>());
            }
            lines.get(highest).add(new double[] {seen[2 * a], seen[2 * a + 1], seen[2 * b], seen[2 * b + 1]});
        });
        for (int t = 0; t < tops.length; t++) {
            double[] corners = new double[6];
            for (int corner = 0; corner < 3; corner++) {
                System.arraycopy(seen, 2 * mesh.vertex(t, corner), corners, 2 * corner, 2);
            }
            List<Footprint> area = List.of(new Footprint.Polygon(Footprint.hull(corners)));
            pieces.add(new Piece(thing, order, tops[t], area, true, lines.get(t)));
        }
    }

    /**
     * Joins neighbouring triangles of an object. A higher one that follows lines begins a new layer, as it may cover
     * them.
     */
    private static List<Layer> merged(List<Piece> pieces) {
        double[] tops = pieces.stream()
                .filter(Piece::isMesh)
                .mapToDouble(Piece::top)
                .sorted()
                .toArray();
        List<Layer> layers = new ArrayList<>();
        for (int from = 0; from < pieces.size(); ) {
            Piece first = pieces.get(from);
            double height = height(first, tops);
            List<Footprint> areas = new ArrayList<>(first.areas);
            List<double[]> lines = new ArrayList<>(first.lines);
            int to = from + 1;
            while (to < pieces.size() && joins(pieces.get(to - 1), pieces.get(to), lines.isEmpty())) {
                Piece next = pieces.get(to);
                if (height(next, tops) != height) {
                    break;
                }
                areas.addAll(next.areas);
                lines.addAll(next.lines);
                to++;
            }
            layers.add(new Layer(first.thing, areas, first.isMesh, lines, first.order, height));
            from = to;
        }
        return layers;
    }

    private static boolean joins(Piece last, Piece next, boolean hasNoLines) {
        return last.isMesh && next.isMesh && last.order == next.order && (hasNoLines || next.top == last.top);
    }

    /** The height of a piece among the sorted tops of all triangles. */
    private static double height(Piece piece, double[] tops) {
        double lowest = tops.length == 0 ? 0 : tops[0];
        double range = tops.length == 0 ? 0 : tops[tops.length - 1] - lowest;
        boolean isRanked = piece.isMesh && range > 0;
        return isRanked ? (double) Math.round((piece.top - lowest) / range * STEPS) / STEPS : 1;
    }
}
