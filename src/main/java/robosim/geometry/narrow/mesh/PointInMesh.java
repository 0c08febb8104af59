package robosim.geometry.narrow.mesh;

import robosim.geometry.exact.Orientation;
import robosim.geometry.index.meshes.TriangleMesh;
import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.gjk.Support;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.leaf.LeafScratch;

/**
 * Whether a point lies inside a closed mesh: a ray from it crosses the surface an odd number of times. Exact for the
 * placed vertices.
 *
 * <p>The ray goes along +X and is symbolically perturbed, first up and then along +Z, so that it meets no edge and no
 * vertex (Edelsbrunner and Muecke 1990): in the YZ plane an edge counts if one end is above the ray and the other is
 * not.
 */
public final class PointInMesh {
    private PointInMesh() {}

    /**
     * Whether the inside of the leaf must be considered in addition to its surface; in a projection the surface above a
     * point inside covers it anyway.
     */
    public static boolean counts(Dimension dimension, LeafColumn column, int leaf) {
        return dimension == Dimension.SPATIAL && column.kind(leaf) == LeafKind.SOLID_MESH;
    }

    /** Whether a leaf that does not meet the surface lies inside the mesh. */
    public static boolean holdsLeaf(LeafColumn mesh, int leaf, Leaf piece, LeafScratch s) {
        double x = Support.originX(piece.kind, piece.row, piece.at);
        double y = Support.originY(piece.kind, piece.row, piece.at);
        double z = Support.originZ(piece.kind, piece.row, piece.at);
        return holds(mesh, leaf, x, y, z, s);
    }

    /** Whether some connected part of another mesh, whose surface does not meet this one's, lies inside. */
    public static boolean holdsMesh(LeafColumn mesh, int leaf, LeafColumn other, int otherLeaf, LeafScratch s) {
        TriangleMesh parts = other.mesh(otherLeaf);
        double[] place = other.rows();
        int at = otherLeaf * Leaf.STRIDE;
        for (int seed : parts.seeds()) {
            if (holds(
                    mesh,
                    leaf,
                    parts.placed(seed, 0, place, at),
                    parts.placed(seed, 1, place, at),
                    parts.placed(seed, 2, place, at),
                    s)) {
                return true;
            }
        }
        return false;
    }

    /** Whether a point that is not on the surface lies inside. */
    public static boolean holds(LeafColumn mesh, int leaf, double px, double py, double pz, LeafScratch s) {
        double[] box = s.meshBox;
        mesh.bounds(leaf, box);
        boolean out = px < box[0] || px > box[3] || py < box[1] || py > box[4] || pz < box[2] || pz > box[5];
        if (out) {
            return false;
        }
        box[0] = px;
        box[1] = py;
        box[2] = pz;
        box[4] = py;
        box[5] = pz;
        boolean inside = false;
        s.around.startBox(mesh, leaf, box);
        double[] t = s.triangleB;
        for (int triangle = s.around.next(0); triangle >= 0; triangle = s.around.next(0)) {
            s.around.corners(triangle, t, 0);
            inside ^= crosses(t, px, py, pz);
        }
        return inside;
    }

    private static boolean crosses(double[] t, double px, double py, double pz) {
        boolean through = edge(t, 0, 3, py, pz) ^ edge(t, 3, 6, py, pz) ^ edge(t, 6, 0, py, pz);
        if (!through) {
            return false;
        }
        // The crossing is ahead if the point is on the -X side of the plane.
        int side = Orientation.volume(t, px, py, pz);
        int facing = Orientation.side(t[1], t[2], t[4], t[5], t[7], t[8]);
        if (facing == 0) {
            return false; // edge-on: the perturbed ray misses it
        }
        int behind = Orientation.volume(t, least(t) - 1 - Math.abs(least(t)), py, pz);
        return side != 0 && side == behind;
    }

    private static double least(double[] t) {
        return Math.min(t[0], Math.min(t[3], t[6]));
    }

    /** Whether the edge passes the ray on the side of +Z in the YZ plane. */
    private static boolean edge(double[] t, int a, int b, double py, double pz) {
        boolean aboveA = t[a + 1] > py;
        boolean aboveB = t[b + 1] > py;
        if (aboveA == aboveB) {
            return false;
        }
        // From the lower to the upper end, regardless of the triangle's orientation, so that both triangles of an edge
        // agree.
        int low = aboveB ? a : b;
        int high = aboveB ? b : a;
        return Orientation.side(t[low + 1], t[low + 2], t[high + 1], t[high + 2], py, pz) < 0;
    }
}
