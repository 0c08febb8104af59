package robosim.geometry.bench;

import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import robosim.geometry.Geometry;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Ray;

/**
 * The nearest hit of a ray at a mesh. A triangle takes some 150 bytes with its share of the tree: 4,000 fit the second
 * cache, 64,000 the third, 1,024,000 none. JTS and dyn4j know no meshes; {@link Peers} asks Embree and Parry.
 */
@State(Scope.Thread)
public class MeshRays {
    private static final int QUESTIONS = 4096;

    /** How many triangles, about. */
    @Param({"4000", "64000", "1024000"})
    public int triangles;

    private final Geometry geometry = new Geometry();
    private Ray[] rays;
    private int next;

    /** Builds the mesh and its tree. */
    @Setup
    public void build() {
        MeshScene scene = new MeshScene();
        MeshObject mesh = scene.torus(triangles);
        geometry.addObjectUnchecked(mesh);
        rays = scene.rays(QUESTIONS);
        geometry.getRayDistance(rays[0], 0, 100, 0);
    }

    private Ray ray() {
        return rays[next++ & (QUESTIONS - 1)];
    }

    /** The module, through its public call. */
    @Benchmark
    public double module() {
        return geometry.getRayDistance(ray(), 0, 100, 0);
    }

    /** To subtract. */
    @Benchmark
    public double loop() {
        return ray().start().x();
    }
}
