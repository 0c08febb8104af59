package robosim.geometry.bench;

import org.openjdk.jmh.annotations.Benchmark;

/** The nearest hit of a ray with a range of 100; see {@link FlatScene} for the caches. */
public class Rays {
    /** The module, through its public call. */
    @Benchmark
    public double module(FlatScene scene) {
        return scene.geometry.getRayDistance(scene.ray(), 0, FlatScene.RANGE, 0);
    }

    /** To subtract. */
    @Benchmark
    public double loop(FlatScene scene) {
        return scene.ray().start().x();
    }

    /** JTS's packed tree, then the module's kernel. */
    @Benchmark
    public double jts(PeerScene scene) {
        return scene.jts(scene.ray());
    }

    /** dyn4j's world. */
    @Benchmark
    public double dyn4j(PeerScene scene) {
        return scene.dyn4j(scene.ray());
    }
}
