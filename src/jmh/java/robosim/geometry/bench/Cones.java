package robosim.geometry.bench;

import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.State;

/** A sonar's cone of 15 degrees and a range of 30; see {@link FlatScene} for the caches. No peer knows cones. */
public class Cones {
    private static final double RANGE = 30;
    private static final double WIDTH = 15;

    /** The nearest point within the cone. */
    @Benchmark
    public double module(FlatScene scene) {
        return scene.geometry.getRayDistance(scene.ray(), 0, RANGE, WIDTH);
    }

    /** What others do: a fan of 31 rays over the same angle, here by the module's own scan. */
    @Benchmark
    public double fan(RobotScene scene, Fan fan) {
        scene.geometry.scan(scene.robot(), -0.5 * WIDTH, WIDTH / 30, 0, RANGE, fan.distances);
        return fan.distances[15];
    }

    /** To subtract. */
    @Benchmark
    public double loop(FlatScene scene) {
        return scene.ray().start().x();
    }

    /** Room for a fan's distances. */
    @State(Scope.Thread)
    public static class Fan {
        final double[] distances = new double[31];
    }
}
