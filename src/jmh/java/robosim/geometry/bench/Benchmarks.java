package robosim.geometry.bench;

import com.fasterxml.jackson.core.JsonFactory;
import java.util.List;
import java.util.concurrent.TimeUnit;
import joptsimple.OptionParser;
import org.apache.commons.math3.stat.StatUtils;
import org.dyn4j.world.World;
import org.jspecify.annotations.Nullable;
import org.locationtech.jts.index.strtree.STRtree;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.profile.GCProfiler;
import org.openjdk.jmh.runner.Runner;
import org.openjdk.jmh.runner.RunnerException;
import org.openjdk.jmh.runner.options.ChainedOptionsBuilder;
import org.openjdk.jmh.runner.options.OptionsBuilder;
import org.openjdk.jmh.runner.options.TimeValue;
import robosim.geometry.Geometry;

/**
 * Runs the JMH benchmarks of this package with the GC profiler: nanoseconds an operation, and in the rows
 * {@code gc.alloc.rate.norm} how many bytes each allocates. All of them, or some by name:
 *
 * <p>{@code mvn -q test-compile exec:java -Dexec.classpathScope=test -Dexec.mainClass=robosim.geometry.bench.Benchmarks
 * -Dbench=Rays,Cones}; {@code -Dobjects=100,10000} takes some sizes, {@code -Dquick=true} a fifth of the time.
 *
 * <p>A row that is named {@code loop} does all but what is measured: it is there to be subtracted.
 */
public final class Benchmarks {
    private static final List<String> ALL = List.of(
            "Rays",
            "Overlaps",
            "Additions",
            "Moves",
            "Cones",
            "Scans",
            "TallScenes",
            "MeshRays",
            "MeshPairs",
            "Bundles");

    private Benchmarks() {}

    /** Runs what the properties name. */
    public static void main(String[] args) throws RunnerException {
        // The forked JVMs get this one's class path, which is Maven's own where Maven runs a program.
        System.setProperty("java.class.path", classPath());
        boolean quick = Boolean.getBoolean("quick");
        ChainedOptionsBuilder options = new OptionsBuilder()
                .mode(Mode.AverageTime)
                .timeUnit(TimeUnit.NANOSECONDS)
                .warmupIterations(quick ? 1 : 3)
                .warmupTime(TimeValue.milliseconds(quick ? 500 : 1000))
                .measurementIterations(quick ? 2 : 5)
                .measurementTime(TimeValue.milliseconds(quick ? 300 : 1000))
                .forks(1)
                .shouldFailOnError(true)
                .addProfiler(GCProfiler.class);
        for (String name : System.getProperty("bench", String.join(",", ALL)).split(",", -1)) {
            if (!ALL.contains(name)) {
                throw new IllegalArgumentException("bench must be of " + ALL + " (got: " + name + ")");
            }
            options.include("\\." + name + "\\.");
        }
        @Nullable String objects = System.getProperty("objects");
        if (objects != null) {
            options.param("objects", objects.split(",", -1));
        }
        new Runner(options.build()).run();
    }

    private static String classPath() {
        return ClassPath.of(
                Benchmarks.class,
                Geometry.class,
                Runner.class,
                OptionParser.class,
                StatUtils.class,
                STRtree.class,
                World.class,
                JsonFactory.class,
                Nullable.class);
    }
}
