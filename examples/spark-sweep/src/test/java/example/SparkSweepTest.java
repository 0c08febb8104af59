package example;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.atomic.AtomicInteger;
import org.apache.spark.SparkConf;
import org.apache.spark.api.java.JavaSparkContext;
import org.apache.spark.scheduler.SparkListener;
import org.apache.spark.scheduler.SparkListenerExecutorRemoved;
import org.apache.spark.scheduler.SparkListenerTaskEnd;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import robosim.geometry.sweep.Outcome;
import robosim.geometry.sweep.ParameterSweep;
import robosim.geometry.sweep.SweepResults;
import robosim.geometry.sweep.SweepRun;
import robosim.geometry.sweep.SweepWorld;

/** Spark finds the same bits as one machine does, also where a machine is lost. */
@Timeout(150)
class SparkSweepTest {
    private static final Path HOME = Path.of(System.getenv("SPARK_HOME"));

    @TempDir
    Path folder;

    private static ParameterSweep sweep(long replicates) throws IOException {
        return ParameterSweep.of(new Patrol())
                .over(SweepWorld.read(Path.of("worlds", "hall.xml")))
                .over(SweepWorld.read(Path.of("worlds", "corridor.xml")))
                .vary("keep", "0.25", "0.5", "1")
                .replicates(replicates);
    }

    private static SparkConf conf(String master) {
        return new SparkConf()
                .setAppName("test")
                .setMaster(master)
                .set("spark.ui.enabled", "false")
                .set("spark.driver.host", "127.0.0.1")
                .set("spark.driver.bindAddress", "127.0.0.1");
    }

    /** What an unpacked Spark has in its folder: links to the jars that Maven brought. */
    @BeforeAll
    static void layOutSpark() throws IOException {
        Path jars = Files.createDirectories(HOME.resolve("jars"));
        for (String entry : System.getProperty("java.class.path").split(File.pathSeparator)) {
            Path jar = Path.of(entry);
            Path link = jars.resolve(jar.getFileName());
            if (entry.endsWith(".jar") && !Files.exists(link)) {
                Files.createSymbolicLink(link, jar.toAbsolutePath());
            }
        }
    }

    @Test
    void theSameAsOnOneMachine() throws Exception {
        ParameterSweep sweep = sweep(12);
        Path onOne = folder.resolve("one.jsonl");
        SweepResults results = SweepRun.of(sweep, onOne).run();
        try (JavaSparkContext spark = new JavaSparkContext(conf("local[4]"))) {
            for (int shards : new int[] {1, 4, 7}) {
                List<Outcome> outcomes = SparkSweep.run(spark, sweep, shards);
                assertEquals(72, outcomes.size());
                assertEquals(results.digest(), SparkSweep.digest(sweep.header(), outcomes));
                Path onSpark = folder.resolve("spark-" + shards);
                SparkSweep.write(sweep.header(), outcomes, onSpark);
                assertArrayEquals(Files.readAllBytes(onOne), Files.readAllBytes(onSpark));
            }
        }
    }

    /** Two workers with a process each; one of these is killed while it works. */
    @Test
    void aKilledWorkerChangesNothing() throws Exception {
        ParameterSweep sweep = sweep(400);
        SparkConf conf = conf("local-cluster[2,1,512]")
                .set("spark.executor.memory", "512m")
                .set(
                        "spark.executor.extraClassPath",
                        Path.of("target", "classes").toAbsolutePath().toString());
        AtomicInteger done = new AtomicInteger();
        AtomicInteger lost = new AtomicInteger();
        List<Outcome> outcomes;
        ExecutorService pool = Executors.newSingleThreadExecutor();
        try (JavaSparkContext spark = new JavaSparkContext(conf)) {
            spark.sc().addSparkListener(new SparkListener() {
                @Override
                public void onTaskEnd(SparkListenerTaskEnd end) {
                    done.incrementAndGet();
                }

                @Override
                public void onExecutorRemoved(SparkListenerExecutorRemoved removed) {
                    lost.incrementAndGet();
                }
            });
            Future<List<Outcome>> running = pool.submit(() -> SparkSweep.run(spark, sweep, 24));
            while (done.get() < 4 && !running.isDone()) {
                Thread.sleep(5);
            }
            ProcessHandle executor = ProcessHandle.current()
                    .descendants()
                    .filter(process -> process.info().commandLine().orElse("").contains("CoarseGrainedExecutorBackend"))
                    .findFirst()
                    .orElse(null);
            assertNotNull(executor);
            assertTrue(executor.destroyForcibly());
            outcomes = running.get();
        } finally {
            pool.shutdownNow();
        }
        assertTrue(lost.get() >= 1, "an executor was lost while there was work");
        SweepResults onOne =
                SweepRun.of(sweep, folder.resolve("one.jsonl")).withThreads(2).run();
        assertEquals(sweep.size(), outcomes.size());
        assertEquals(onOne.digest(), SparkSweep.digest(sweep.header(), outcomes));
    }
}
