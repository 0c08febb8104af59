package robosim.geometry.bench;

import org.openjdk.jmh.annotations.Benchmark;

/** Whether a disc would touch anything; see {@link FlatScene} for the caches. */
public class Overlaps {
    /** The module, through its public call. */
    @Benchmark
    public boolean module(FlatScene scene) {
        return scene.geometry.testObject(scene.probe());
    }

    /** To subtract. */
    @Benchmark
    public double loop(FlatScene scene) {
        return scene.probe().center().x();
    }

    /** JTS's packed tree, then the module's kernel. */
    @Benchmark
    public boolean jts(PeerScene scene) {
        return scene.jts(scene.probe());
    }

    /** dyn4j's world. */
    @Benchmark
    public boolean dyn4j(PeerScene scene) {
        return scene.dyn4j(scene.probe());
    }
}
