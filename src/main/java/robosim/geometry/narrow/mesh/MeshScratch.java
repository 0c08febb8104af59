package robosim.geometry.narrow.mesh;

import org.jspecify.annotations.Nullable;
import robosim.geometry.narrow.distance.DistanceScratch;
import robosim.geometry.narrow.leaf.LeafScratch;
import robosim.geometry.narrow.overlap.OverlapScratch;

/** The working memory of meshes. */
public final class MeshScratch {
    public final DistanceScratch distance;
    public final OverlapScratch overlap;
    public final LeafScratch leaf;

    public final MeshRay meshRay = new MeshRay();
    public final MeshBeamSearch meshSight = new MeshBeamSearch();

    private @Nullable MeshPairs meshPairs;
    private @Nullable ContactPairs pairs;
    private @Nullable MeshSweep sweep;

    public MeshScratch(DistanceScratch distance, OverlapScratch overlap, LeafScratch leaf) {
        this.distance = distance;
        this.overlap = overlap;
        this.leaf = leaf;
    }

    /** Descends two meshes in space at once. */
    public MeshPairs meshPairs() {
        if (meshPairs == null) {
            meshPairs = new MeshPairs(overlap);
        }
        return meshPairs;
    }

    /** Descends a mesh that is translated and one at rest at once. */
    public MeshSweep sweep() {
        if (sweep == null) {
            sweep = new MeshSweep(leaf);
        }
        return sweep;
    }

    /** Descends the projections of two meshes at once. */
    public ContactPairs pairs() {
        if (pairs == null) {
            pairs = new ContactPairs(distance);
        }
        return pairs;
    }
}
