package robosim.geometry.sweep;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import robosim.geometry.ChildJvm;

/** The results of a sweep are the same bits on any number of threads and shards, killed or not, and on every JDK. */
@Tag("clock")
@Timeout(120)
class ParameterSweepTest {
    @TempDir
    Path folder;

    private static String stored() throws IOException {
        try (InputStream in = ParameterSweepTest.class.getResourceAsStream("sweep-digest.txt")) {
            assertThat(in).isNotNull();
            return new String(in.readAllBytes(), StandardCharsets.UTF_8).strip();
        }
    }

    private SweepResults results(int threads) throws Exception {
        return SweepRun.of(Sweeps.wander(0), folder.resolve("on-" + threads + ".jsonl"))
                .withThreads(threads)
                .run();
    }

    /** Where results are meant to change, the message tells the new digest. */
    @Test
    void onEveryJdk() throws Exception {
        SweepResults results = results(1);
        assertThat(results.digest()).isEqualTo(stored());
        SweepSummary summary = new SweepSummary();
        results.forEach(summary);
        assertThat(summary.failures()).as("of 160, one in 40 fails").isBetween(1L, 12L);
        assertThat(summary.cells()).hasSize(8);
        String table = summary.markdown();
        assertThat(table).contains("| maze", "nearest [m]", "| failures");
    }

    @Test
    void onAnyNumberOfThreads() throws Exception {
        byte[] onOne = Files.readAllBytes(file(results(1), 1));
        assertThat(Files.readAllBytes(file(results(2), 2))).isEqualTo(onOne);
        assertThat(Files.readAllBytes(file(results(7), 7))).isEqualTo(onOne);
    }

    private Path file(SweepResults results, int threads) {
        assertThat(results.size()).isEqualTo(160);
        return folder.resolve("on-" + threads + ".jsonl");
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 7})
    void onAnyNumberOfShards(int count) throws Exception {
        List<Path> files = new ArrayList<>();
        for (int number = count - 1; number >= 0; number--) {
            Path file = folder.resolve("shard-" + number);
            SweepRun run = SweepRun.of(Sweeps.wander(0), file)
                    .shard(new Shard(number, count))
                    .withThreads(1 + number % 2);
            assertThat(run.run().size()).isEqualTo(run.size()).isBetween(160L / count - 5, 160L / count + 5);
            files.add(file);
        }
        SweepResults all = SweepResults.read(files);
        assertThat(all.size()).isEqualTo(all.header().size()).isEqualTo(160);
        assertThat(all.digest()).isEqualTo(stored());
        all.write(folder.resolve("all"));
        assertThat(SweepResults.read(List.of(folder.resolve("all"))).digest()).isEqualTo(stored());
        if (count > 1) {
            assertThat(SweepResults.read(files.subList(1, count)).digest()).isNotEqualTo(stored());
        }
    }

    @Test
    void sentToAnotherMachine() throws Exception {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
            out.writeObject(Sweeps.wander(0));
        }
        try (ObjectInputStream in = new ObjectInputStream(new ByteArrayInputStream(bytes.toByteArray()))) {
            ParameterSweep read = (ParameterSweep) in.readObject();
            SweepDigest digest = new SweepDigest(read.header());
            for (long index = 0; index < read.size(); index++) {
                digest.add(Outcome.of(read.run(index).line()));
            }
            assertThat(digest.hex()).isEqualTo(stored());
        }
    }

    /** Killed for good, twice; what it has done is not done again. */
    @Test
    void killedAndResumed() throws Exception {
        Path file = folder.resolve("killed.jsonl");
        int before = 1;
        for (int lines : new int[] {20, 60}) {
            Process process = new ProcessBuilder(ChildJvm.running(Sweeps.class, file.toString()))
                    .redirectErrorStream(true)
                    .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                    .start();
            try {
                while (lines(file) < lines) {
                    assertThat(process.isAlive()).isTrue();
                    Thread.sleep(5);
                }
            } finally {
                process.destroyForcibly();
                process.waitFor();
            }
            assertThat(lines(file)).isGreaterThan(before).isLessThan(161);
            before = lines(file);
        }
        AtomicLong first = new AtomicLong(-1);
        AtomicLong told = new AtomicLong();
        SweepResults results = SweepRun.of(Sweeps.wander(0), file)
                .resume()
                .progress(done -> {
                    first.compareAndSet(-1, done);
                    told.incrementAndGet();
                })
                .run();
        assertThat(first.get()).as("whole lines, without the header").isEqualTo(before - 1);
        assertThat(told.get()).as("replicates carried out").isEqualTo(160 - first.get() + 1);
        assertThat(results.digest()).isEqualTo(stored());
        assertThat(Files.readAllBytes(file)).isEqualTo(Files.readAllBytes(file(results(3), 3)));
    }

    private static int lines(Path file) throws IOException {
        if (!Files.exists(file)) {
            return 0;
        }
        int lines = 0;
        for (byte each : Files.readAllBytes(file)) {
            lines += each == '\n' ? 1 : 0;
        }
        return lines;
    }

    @Test
    void aLineThatBrokeOffIsCarriedOutAgain() throws Exception {
        byte[] whole = Files.readAllBytes(file(results(1), 1));
        Path file = folder.resolve("torn.jsonl");
        for (int length = 0; length < whole.length; length += 1 + whole.length / 23) {
            Files.write(file, Arrays.copyOf(whole, length));
            SweepRun.of(Sweeps.wander(0), file).resume().withThreads(2).run();
            assertThat(Files.readAllBytes(file)).as("cut at %d", length).isEqualTo(whole);
        }
    }

    @Test
    void moreReplicatesAreAddedToThoseThatThereAre() throws Exception {
        Path file = folder.resolve("more.jsonl");
        SweepRun.of(Sweeps.wander(0).replicates(5), file).run();
        AtomicLong first = new AtomicLong(-1);
        SweepResults more = SweepRun.of(Sweeps.wander(0), file)
                .resume()
                .progress(done -> first.compareAndSet(-1, done))
                .run();
        assertThat(first.get()).isEqualTo(40);
        assertThat(more.digest()).isEqualTo(stored());
        assertThatThrownBy(() -> SweepRun.of(Sweeps.wander(0).replicates(5), file)
                        .resume()
                        .run())
                .isInstanceOf(SweepException.class)
                .hasMessageEndingWith("it has more replicates than asked for (got: 160 of 40)");
    }

    @Test
    void refusesWhatIsNotItsOwn() throws Exception {
        Path file = folder.resolve("own.jsonl");
        SweepRun.of(Sweeps.wander(0), file).run();
        String whole = Files.readString(file);
        assertThatThrownBy(() -> SweepRun.of(Sweeps.wander(0), file).run())
                .isInstanceOf(SweepException.class)
                .hasMessageContaining("must be a new file");
        assertThatThrownBy(() ->
                        SweepRun.of(Sweeps.wander(0).seed(8), file).resume().run())
                .isInstanceOf(SweepException.class)
                .hasMessageContaining("same sweep");
        Path other = folder.resolve("other.jsonl");
        SweepRun.of(Sweeps.wander(0).seed(8), other).run();
        assertThatThrownBy(() -> SweepResults.read(List.of(file, other)))
                .isInstanceOf(SweepException.class)
                .hasMessageContaining("same sweep");
        Files.writeString(other, whole.replaceFirst("\"replicate\":3", "\"replicate\":4"));
        assertThatThrownBy(() -> SweepResults.read(List.of(other)))
                .isInstanceOf(SweepException.class)
                .hasMessageContaining("check sum")
                .hasMessageContaining("line ");
        assertThat(Files.readString(file)).isEqualTo(whole);
    }

    @Test
    void aLambdaNeedsAName() throws IOException {
        SweepScenario lambda =
                replicate -> Result.of("drawn", replicate.random().nextDouble());
        assertThatThrownBy(() -> ParameterSweep.of(lambda)).hasMessageContaining("must be given a name");
        ParameterSweep sweep = ParameterSweep.of("dice", lambda).over(SweepWorld.read(Path.of("worlds", "maze.xml")));
        assertThat(sweep.run(0).values().get("drawn")).isBetween(0.0, 1.0);
        assertThat(sweep.header().scenario()).isEqualTo("dice");
    }

    @Test
    void aFailureTellsWhy() {
        ParameterSweep sweep = Sweeps.wander(0);
        Outcome failed = null;
        for (long index = 0; index < sweep.size(); index++) {
            Outcome outcome = sweep.run(index);
            failed = outcome.isFailed() ? outcome : failed;
        }
        assertThat(failed).isNotNull();
        assertThat(failed.error()).isEqualTo("java.lang.IllegalStateException: a flat battery");
        assertThat(failed.line()).contains("\"type\":\"failure\"");
    }

    @Test
    void outcomesAreReadAsTheyWereWritten() throws Exception {
        ParameterSweep sweep = Sweeps.wander(0);
        boolean hasNone = false;
        for (long index = 0; index < sweep.size(); index++) {
            Outcome outcome = sweep.run(index);
            assertThat(Outcome.of(outcome.line())).isEqualTo(outcome);
            hasNone |= outcome.values().containsValue(Double.POSITIVE_INFINITY);
        }
        Outcome none = new Outcome(1L << 40, "w", Map.of("a", "b"), 3, -1, Map.of("x", 1 / 0.0, "y", 0x1p-1074), null);
        assertThat(Outcome.of(none.line())).isEqualTo(none);
        assertThat(hasNone).as("a value that is none").isTrue();
    }
}
