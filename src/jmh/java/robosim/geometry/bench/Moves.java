package robosim.geometry.bench;

import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import robosim.geometry.Geometry;

/**
 * One attempted move of one of a {@link Swarm}, whose robots all go there and all go back. A robot takes about 400 bytes:
 * 100 fit the first cache, 1,000 the second, 10,000 the third.
 */
@State(Scope.Thread)
public class Moves {
    /** How many robots. */
    @Param({"100", "1000", "10000"})
    public int robots;

    private Swarm swarm;
    private Geometry geometry;
    private Swarm.Flock tree;
    private int next;

    /** Puts them where they start. */
    @Setup
    public void build() {
        swarm = new Swarm(robots);
        geometry = swarm.geometry();
        tree = swarm.new Flock(true);
    }

    private int step() {
        next = next + 1 < 2 * robots ? next + 1 : 0;
        return next;
    }

    /** The module, through its public call. */
    @Benchmark
    public boolean module() {
        return swarm.move(geometry, step());
    }

    /** dyn4j's dynamic tree, then the module's sweep. */
    @Benchmark
    public boolean dyn4j() {
        return tree.move(step());
    }

    /** To subtract. */
    @Benchmark
    public double loop() {
        return swarm.wayX(step());
    }
}
