package robosim.geometry.narrow.mesh;

import org.jspecify.annotations.Nullable;
import robosim.geometry.narrow.turn.TurnScratch;

/** The working memory of meshes. */
public class MeshScratch extends TurnScratch {
    public final MeshRay meshRay = new MeshRay();
    public final MeshSight meshSight = new MeshSight();

    private @Nullable MeshPairs meshPairs;
    private @Nullable ContactPairs pairs;

    /** Descends two meshes in space at once. */
    public MeshPairs meshPairs() {
        if (meshPairs == null) {
            meshPairs = new MeshPairs(this);
        }
        return meshPairs;
    }

    /** Descends the projections of two meshes at once. */
    public ContactPairs pairs() {
        if (pairs == null) {
            pairs = new ContactPairs(this);
        }
        return pairs;
    }
}
