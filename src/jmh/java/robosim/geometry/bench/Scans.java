package robosim.geometry.bench;

import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.State;

/** One of the 180 rays of a laser scanner that looks all round, with a range of 30, in one call and one by one. */
@State(Scope.Thread)
public class Scans {
    private static final int RAYS = 180;
    private static final double RANGE = 30;
    private final double[] distances = new double[RAYS];
    private final double[] x = new double[RAYS];
    private final double[] z = new double[RAYS];

    /** Directions of the single calls. */
    public Scans() {
        for (int k = 0; k < RAYS; k++) {
            double angle = 2 * Math.PI * k / RAYS;
            x[k] = StrictMath.cos(angle);
            z[k] = -StrictMath.sin(angle);
        }
    }

    /** In one call, into a given array. */
    @Benchmark
    @OperationsPerInvocation(RAYS)
    public double[] scan(RobotScene scene) {
        scene.geometry.scan(scene.robot(), 0, 360.0 / RAYS, 0, RANGE, distances);
        return distances;
    }

    /** One by one. */
    @Benchmark
    @OperationsPerInvocation(RAYS)
    public double[] single(RobotScene scene) {
        String robot = scene.robot();
        for (int k = 0; k < RAYS; k++) {
            distances[k] = scene.geometry.getSonarDistance(robot, x[k], z[k], 0, RANGE, 0);
        }
        return distances;
    }
}
