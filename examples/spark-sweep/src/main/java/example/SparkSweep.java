package example;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.Iterator;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.LongStream;
import org.apache.spark.SparkConf;
import org.apache.spark.api.java.JavaSparkContext;
import org.apache.spark.broadcast.Broadcast;
import robosim.geometry.sweep.Outcome;
import robosim.geometry.sweep.ParameterSweep;
import robosim.geometry.sweep.Shard;
import robosim.geometry.sweep.SweepHeader;
import robosim.geometry.sweep.SweepResults;
import robosim.geometry.sweep.SweepSummary;
import robosim.geometry.sweep.SweepWorld;

/**
 * Carries out a sweep on Spark: the worlds are sent to each machine once, and a partition is a shard. Results are the same
 * bits as those of the command {@code sweep} on one machine, whatever is lost and carried out again on the way.
 *
 * <p>{@code spark-submit --class example.SparkSweep spark-sweep-1.jar RESULTS SHARDS REPLICATES WORLD...}
 */
public final class SparkSweep {
    private SparkSweep() {}

    /** Writes the results of {@link Patrol} and prints their table and digest. */
    public static void main(String[] arguments) throws Exception {
        ParameterSweep sweep = ParameterSweep.of(new Patrol())
                .vary("keep", "0.25", "0.5", "1")
                .replicates(Long.parseLong(arguments[2]));
        for (int k = 3; k < arguments.length; k++) {
            sweep = sweep.over(SweepWorld.read(Path.of(arguments[k])));
        }
        Path file = Path.of(arguments[0]);
        // spark-submit tells the master; without it, all cores of this machine.
        SparkConf conf = new SparkConf().setAppName("sweep").setIfMissing("spark.master", "local[*]");
        try (JavaSparkContext spark = new JavaSparkContext(conf)) {
            write(sweep.header(), run(spark, sweep, Integer.parseInt(arguments[1])), file);
        }
        SweepResults results = SweepResults.read(List.of(file));
        SweepSummary summary = new SweepSummary();
        results.forEach(summary);
        System.out.println(summary.markdown());
        System.out.println("digest " + results.digest());
    }

    /** All outcomes by ascending index. */
    static List<Outcome> run(JavaSparkContext spark, ParameterSweep sweep, int shards) throws Exception {
        Broadcast<ParameterSweep> shared = spark.broadcast(sweep);
        List<Integer> numbers = IntStream.range(0, shards).boxed().toList();
        List<String> lines = spark.parallelize(numbers, shards)
                .flatMap(number -> lines(shared.value(), new Shard(number, shards)))
                .collect();
        List<Outcome> outcomes = new ArrayList<>();
        for (String line : lines) {
            outcomes.add(Outcome.of(line));
        }
        outcomes.sort(Comparator.comparingLong(Outcome::index));
        return outcomes;
    }

    private static Iterator<String> lines(ParameterSweep sweep, Shard shard) {
        return LongStream.range(0, sweep.size())
                .filter(index -> sweep.isOf(shard, index))
                .mapToObj(index -> sweep.run(index).line())
                .iterator();
    }

    /** A file as the command writes it, to the byte. */
    static void write(SweepHeader header, List<Outcome> outcomes, Path file) throws Exception {
        List<String> lines = new ArrayList<>(List.of(header.sealed()));
        outcomes.forEach(outcome -> lines.add(outcome.sealed()));
        Files.writeString(file, String.join("\n", lines) + "\n");
    }

    static String digest(SweepHeader header, List<Outcome> outcomes) {
        return header.digest(outcomes);
    }
}
