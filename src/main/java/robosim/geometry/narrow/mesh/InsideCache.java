package robosim.geometry.narrow.mesh;

import org.jspecify.annotations.Nullable;
import robosim.geometry.index.meshes.TriangleMesh;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.LeafScratch;

/** Whether a point lies inside a solid mesh, remembered: the rays of a sensor all begin at one. */
public final class InsideCache {
    /** The numbers that say where a mesh is. */
    private static final int PLACE = Leaf.ROTATION + 9;

    private @Nullable TriangleMesh mesh;
    private final double[] place = new double[PLACE];
    private double x;
    private double y;
    private double z;
    private boolean isInside;

    /** The same as {@link PointInMesh#holds}. */
    @SuppressWarnings("ReferenceEquality") // another mesh of the same triangles is asked again
    public boolean holds(LeafColumn column, int leaf, double px, double py, double pz, LeafScratch s) {
        TriangleMesh asked = column.mesh(leaf);
        if (asked != mesh || px != x || py != y || pz != z || !isHere(column.rows(), leaf * Leaf.STRIDE)) {
            mesh = asked;
            x = px;
            y = py;
            z = pz;
            System.arraycopy(column.rows(), leaf * Leaf.STRIDE, place, 0, PLACE);
            isInside = PointInMesh.holds(column, leaf, px, py, pz, s);
        }
        return isInside;
    }

    private boolean isHere(double[] rows, int at) {
        for (int k = 0; k < PLACE; k++) {
            if (rows[at + k] != place[k]) {
                return false;
            }
        }
        return true;
    }
}
