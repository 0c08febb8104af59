package robosim.geometry.bench;

import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.State;
import robosim.geometry.collision.CollisionDetection;
import robosim.geometry.model.MeshObject;

/**
 * Whether two meshes of 4,000 triangles touch, at random places of which four in five collide; both trees fit the second
 * cache. JTS and dyn4j know no meshes; {@link Peers} asks FCL and Parry.
 */
@State(Scope.Thread)
public class MeshPairs {
    private static final int PLACES = 1024;

    private final MeshScene scene = new MeshScene();
    private final MeshObject mesh = scene.torus(4000);
    private final MeshObject[] others = scene.beside(mesh, PLACES);
    private int next;

    private MeshObject other() {
        return others[next++ & (PLACES - 1)];
    }

    /** The module, through its public call. */
    @Benchmark
    public boolean module() {
        return CollisionDetection.intersects(mesh, other());
    }

    /** To subtract. */
    @Benchmark
    public double loop() {
        return other().center().x();
    }
}
