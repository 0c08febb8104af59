package robosim.geometry.sweep;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.stream.Stream;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import robosim.geometry.ChildJvm;
import robosim.geometry.Geometry;
import robosim.geometry.sweep.lines.ChecksummedLine;
import robosim.geometry.sweep.lines.SweepLines;

/** A file of results is nobody else's at the same time, and what is none is left alone. */
@Tag("clock")
@Timeout(120)
class SweepFileTest {
    @TempDir
    Path folder;

    private static Process child(Path file, Path told) throws IOException {
        return new ProcessBuilder(ChildJvm.running(Sweeps.class, file.toString()))
                .redirectErrorStream(true)
                .redirectOutput(told.toFile())
                .start();
    }

    /** The run of this process goes on, whoever else of this process or of another has tried. */
    @Test
    void aSecondRunIsKeptAway() throws Exception {
        Path file = folder.resolve("mine.jsonl");
        AtomicLong done = new AtomicLong(-1);
        CountDownLatch others = new CountDownLatch(1);
        ExecutorService pool = Executors.newSingleThreadExecutor();
        try {
            Future<SweepResults> running = pool.submit(() -> SweepRun.of(Sweeps.wander(10), file)
                    .withThreads(2)
                    .progress(count -> {
                        done.set(count);
                        awaitFrom(4, count, others);
                    })
                    .run());
            while (done.get() < 4) {
                assertThat(running.isDone()).isFalse();
                Thread.sleep(5);
            }
            assertThatThrownBy(
                            () -> SweepRun.of(Sweeps.wander(0), file).resume().run())
                    .isInstanceOf(SweepException.class)
                    .hasMessageContaining("another run must not write to it");
            Path told = folder.resolve("told");
            Process child = child(file, told);
            assertThat(child.waitFor(60, TimeUnit.SECONDS)).isTrue();
            assertThat(running.isDone()).as("it had no chance to meet").isFalse();
            assertThat(child.exitValue()).isNotZero();
            assertThat(Files.readString(told)).contains("another process must not write to it");
            others.countDown();
            assertThat(running.get().size()).isEqualTo(160);
        } finally {
            pool.shutdownNow();
        }
        assertThat(SweepRun.of(Sweeps.wander(0), file).resume().run().size()).isEqualTo(160);
    }

    /** Keeps a run from its end until others have tried. */
    private static void awaitFrom(long first, long count, CountDownLatch others) {
        try {
            if (count >= first) {
                others.await();
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /** A pipe in the place of the half-written file shows the run while it writes its file anew. */
    @Test
    @EnabledOnOs(OS.LINUX)
    void theLockIsKeptUntilTheFileIsWrittenAnew() throws Exception {
        Path pipe = folder.resolve("pipe");
        assertThat(new ProcessBuilder("mkfifo", pipe.toString()).start().waitFor())
                .isZero();
        Path file = folder.resolve("own.jsonl");
        Files.createSymbolicLink(folder.resolve("own.jsonl.half"), pipe);
        AtomicLong done = new AtomicLong();
        ExecutorService pool = Executors.newSingleThreadExecutor();
        try {
            Future<SweepResults> running = pool.submit(() ->
                    SweepRun.of(Sweeps.wander(0), file).progress(done::set).run());
            while (done.get() < 160) {
                Thread.sleep(5);
            }
            Thread.sleep(200);
            assertThatThrownBy(() -> SweepLock.of(file).close()).isInstanceOf(SweepException.class);
            byte[] written = Files.readAllBytes(pipe);
            try (OutputStream again = Files.newOutputStream(pipe)) {
                again.write(written); // what the run reads, to answer it
            }
            assertThat(running.get().size()).isEqualTo(160);
        } finally {
            pool.shutdownNow();
        }
        SweepLock.of(file).close();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "years of work",
                "years of work\n",
                "{\"a\":1}",
                "{\"type\":\"sweep\",\"version\":1,\"scenario\":\"another\",\"se",
                "{\"type\":\"sweep\",\"version\":1}\n"
            })
    void whatIsNoFileOfResultsIsLeftAlone(String text) throws Exception {
        Path file = folder.resolve("precious");
        Files.writeString(file, text);
        assertThatThrownBy(() -> SweepRun.of(Sweeps.wander(0), file).resume().run())
                .isInstanceOf(SweepException.class)
                .hasMessageContaining("line 1")
                .hasMessageContaining("check sum");
        assertThat(Files.readString(file)).isEqualTo(text);
    }

    @Test
    void aWholeLineThatIsDamagedIsRefusedAlsoAtTheEnd() throws Exception {
        Path file = folder.resolve("damaged.jsonl");
        SweepRun.of(Sweeps.wander(0).replicates(1), file).run();
        String whole = Files.readString(file);
        String damaged = whole.substring(0, whole.length() - 6) + "00" + whole.substring(whole.length() - 4);
        assertThat(damaged).isNotEqualTo(whole);
        Files.writeString(file, damaged);
        assertThatThrownBy(() -> SweepResults.read(List.of(file))).hasMessageContaining("line 9: it must be as it was");
        assertThatThrownBy(() -> SweepRun.of(Sweeps.wander(0).replicates(1), file)
                        .resume()
                        .run())
                .isInstanceOf(SweepException.class)
                .hasMessageContaining("line 9");
        assertThat(Files.readString(file)).isEqualTo(damaged);
        // A shard that was killed as it wrote its header has nothing to merge; any other text is no shard.
        Path killed = folder.resolve("killed.jsonl");
        Files.writeString(file, whole);
        for (int length : new int[] {1, 10, 17, 40}) {
            Files.writeString(killed, whole.substring(0, length));
            assertThat(SweepResults.read(List.of(killed, file)).torn()).isEqualTo(1);
        }
        Files.writeString(killed, "years of work");
        assertThatThrownBy(() -> SweepResults.read(List.of(killed, file))).hasMessageContaining("line 1");
    }

    /** Names, values and headers that no reader would take are refused before anything is written. */
    @Test
    void whatCouldNotBeReadAgainIsNotBegun() throws Exception {
        Path file = folder.resolve("none.jsonl");
        ParameterSweep sweep = Sweeps.wander(0);
        assertThatThrownBy(() -> sweep.vary("step", "\ud800")).hasMessageContaining("value of step must be");
        assertThatThrownBy(() -> Result.of("\udc00", 1)).hasMessageContaining("half of a surrogate pair");
        assertThatThrownBy(() -> Result.of("n".repeat(201), 1)).hasMessageContaining("at most 200 characters");
        String[] values = new String[400];
        for (int k = 0; k < values.length; k++) {
            values[k] = k + "v".repeat(190);
        }
        assertThatThrownBy(() -> SweepRun.of(sweep.vary("many", values), file).run())
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("must be readable again");
        ParameterSweep large = sweep.replicates(Integer.MAX_VALUE);
        assertThatThrownBy(() -> SweepRun.of(large, file).run()).hasMessageContaining("at most 2147483647 replicates");
        assertThatThrownBy(() -> SweepRun.of(large, file).size()).hasMessageContaining("at most 2147483647 replicates");
        String[] thousands =
                Stream.iterate(0, k -> k + 1).limit(5000).map(String::valueOf).toArray(String[]::new);
        ParameterSweep beyond = large.vary("a", thousands).vary("b", thousands).vary("c", thousands);
        assertThatThrownBy(beyond::size).hasMessageContaining("fewer than 2^63");
        try (Stream<Path> files = Files.list(folder)) {
            assertThat(files).isEmpty();
        }
    }

    /** Nothing to run is no sweep that is done. */
    @Test
    void aSweepWithoutAWorldIsAnError() throws IOException {
        ParameterSweep none =
                ParameterSweep.of("none", replicate -> Result.of("x", 1)).vary("p", "1", "2");
        String message = "a sweep must have at least one world; add it by over(world) (got: none)";
        Path file = folder.resolve("none.jsonl");
        for (ThrowingCallable call : List.<ThrowingCallable>of(
                none::size,
                none::cells,
                () -> none.run(0),
                () -> none.isOf(Shard.ALL, 0),
                () -> SweepRun.of(none, file).run(),
                () -> SweepRun.of(none, file).size())) {
            assertThatThrownBy(call).isInstanceOf(IllegalStateException.class).hasMessage(message);
        }
        assertThat(file).doesNotExist();
    }

    /** A line with a right check sum may still be of another place of the sweep. */
    @Test
    void resultsThatDoNotBelongTogetherAreRefused() throws Exception {
        Path whole = folder.resolve("whole.jsonl");
        SweepRun.of(Sweeps.wander(0), whole).run();
        List<String> lines = Files.readAllLines(whole);
        Outcome good = Outcome.of(String.valueOf(ChecksummedLine.open(lines.get(11))));
        Path file = folder.resolve("one.jsonl");
        for (Outcome bad : List.of(
                new Outcome(11, good.world(), good.parameters(), good.replicate(), good.seed(), good.values(), null),
                new Outcome(10, "maze", good.parameters(), good.replicate(), good.seed(), good.values(), null),
                new Outcome(10, good.world(), Map.of("step", "2"), good.replicate(), good.seed(), good.values(), null),
                new Outcome(10, good.world(), good.parameters(), 2, good.seed(), good.values(), null),
                new Outcome(10, good.world(), good.parameters(), good.replicate(), 3, good.values(), null))) {
            Files.writeString(file, lines.get(0) + "\n" + bad.sealed() + "\n");
            assertThatThrownBy(() -> SweepResults.read(List.of(file)))
                    .isInstanceOf(SweepException.class)
                    .hasMessageMatching(
                            ".* line 2: (world|parameters|replicate|seed) of the result with index 1[01] must"
                                    + " be .* in this sweep \\(got: .*\\)");
            assertThatThrownBy(
                            () -> SweepRun.of(Sweeps.wander(0), file).resume().run())
                    .hasMessageContaining("in this sweep");
        }
        Files.writeString(file, lines.get(0) + "\n" + good.sealed() + "\n");
        assertThat(SweepResults.read(List.of(file)).size()).isEqualTo(1);
    }

    /** Who merges files of two sweeps is told in what they differ, and not how a record prints itself. */
    @Test
    void anotherSweepIsToldByWhatDiffers() throws Exception {
        ParameterSweep one = ParameterSweep.of("one", replicate -> Result.of("x", 1))
                .over(world("w", 10))
                .vary("p", "1", "2");
        Path mine = folder.resolve("mine.jsonl");
        SweepRun.of(one, mine).run();
        Map<ParameterSweep, String> others = Map.of(
                one.seed(3), "the seed 0x0000000000000003 and not 0x0000000000000000",
                one.vary("p", "1", "3"), "the parameters {p=1,3} and not {p=1,2}",
                one.over(world("v", 10)), "the worlds [w, v] and not [w]",
                ParameterSweep.of("one", replicate -> Result.of("x", 1))
                                .over(world("w", 11))
                                .vary("p", "1", "2"),
                        "another world of the name w",
                ParameterSweep.of("two", replicate -> Result.of("x", 1))
                                .over(world("w", 10))
                                .vary("p", "1", "2"),
                        "the scenario two and not one");
        for (Map.Entry<ParameterSweep, String> other : others.entrySet()) {
            Path file = folder.resolve("other.jsonl");
            Files.deleteIfExists(file);
            SweepRun.of(other.getKey(), file).run();
            assertThatThrownBy(() -> SweepResults.read(List.of(mine, file)))
                    .hasMessage(file + ": it must be of the same sweep as the others; it has " + other.getValue());
            assertThatThrownBy(() -> SweepRun.of(one, file).resume().run())
                    .hasMessage(file + ": it must be of the same sweep to be resumed; it has " + other.getValue());
        }
    }

    private static SweepWorld world(String name, double size) {
        return new SweepWorld(name, new Geometry(size, size, size).snapshot());
    }

    /** What a full disk says has no name in it. */
    @Test
    @EnabledOnOs(OS.LINUX)
    void aFullDiskIsToldWithTheFile() throws Exception {
        Path file = folder.resolve("full.jsonl");
        Path half = Files.createSymbolicLink(folder.resolve("full.jsonl.half"), Path.of("/dev/full"));
        assertThatThrownBy(() -> SweepRun.of(Sweeps.wander(0), file).run())
                .isInstanceOf(SweepException.class)
                .hasMessageStartingWith(file + ": ");
        Files.delete(half);
    }

    /** No line follows one of which only a half could be written: the file would be damaged in its middle. */
    @Test
    void nothingFollowsAHalfLine() throws Exception {
        StringBuilder disk = new StringBuilder();
        SweepLines lines = new SweepLines(new OutputStream() {
            @Override
            public void write(int one) throws IOException {
                if (disk.length() == 10) {
                    throw new IOException("No space left on device");
                }
                disk.append((char) one);
            }
        });
        assertThat(lines.append("12345")).isTrue();
        assertThatThrownBy(() -> lines.append("67890")).hasMessageContaining("No space left");
        disk.delete(0, 3); // somebody made room
        assertThat(lines.append("x")).isFalse();
        assertThat(disk.toString()).isEqualTo("45\n6789");
    }

    @Test
    @EnabledOnOs(OS.LINUX)
    void manyShardsAreMergedWithFewFilesOpen() throws Exception {
        Path whole = folder.resolve("whole.jsonl");
        SweepRun.of(Sweeps.wander(0), whole).run();
        List<String> lines = Files.readAllLines(whole);
        List<Path> files = new ArrayList<>();
        for (int k = 1; k < lines.size(); k++) {
            Path file = folder.resolve("shard-" + k);
            Files.writeString(file, lines.get(0) + "\n" + lines.get(k) + "\n");
            files.add(file);
        }
        files.addAll(files); // each a second time, to be compared
        SweepResults results = SweepResults.read(files);
        assertThat(results.size()).isEqualTo(160);
        AtomicLong most = new AtomicLong();
        AtomicLong seen = new AtomicLong();
        long before = open();
        results.forEach(outcome -> {
            seen.incrementAndGet();
            most.accumulateAndGet(open(), Math::max);
        });
        assertThat(seen.get()).isEqualTo(160);
        assertThat(most.get() - before).isBetween(2L, 100L);
    }

    private static long open() {
        String[] files = Path.of("/proc/self/fd").toFile().list();
        return files == null ? 0 : files.length;
    }
}
