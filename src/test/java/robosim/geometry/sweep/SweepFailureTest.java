package robosim.geometry.sweep;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import robosim.geometry.Geometry;
import robosim.geometry.Snapshot;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.Point;

/** Whatever becomes of one replicate, the others are carried out, and the file can be read. */
@Timeout(60)
class SweepFailureTest {
    @TempDir
    Path folder;

    private static ParameterSweep sweep(SweepScenario scenario) {
        return ParameterSweep.of("trouble", scenario)
                .over(new SweepWorld("empty", new Geometry().snapshot()))
                .replicates(12);
    }

    private List<Outcome> outcomes(ParameterSweep sweep) throws Exception {
        List<Outcome> outcomes = new ArrayList<>();
        SweepRun.of(sweep, folder.resolve("results.jsonl")).withThreads(2).run().forEach(outcomes::add);
        assertThat(outcomes).hasSize(12);
        return outcomes;
    }

    private static final class Shy extends RuntimeException {
        private static final long serialVersionUID = 1;

        @Override
        public String getMessage() {
            throw new IllegalStateException("this tells nothing");
        }
    }

    private static int deep(int depth) {
        return depth < 0 ? depth : 1 + deep(depth + 1);
    }

    @Test
    void whateverIsThrownIsAnOutcome() throws Exception {
        List<Outcome> outcomes = outcomes(sweep(replicate -> {
            switch ((int) replicate.number()) {
                case 1 -> throw new AssertionError("it fell over");
                case 4 -> throw new NoClassDefFoundError("example/Missing");
                case 5 -> throw new Shy();
                case 7 -> deep(0);
                case 8 -> throw new InterruptedException("it waited");
                default -> {}
            }
            return Result.of("v", replicate.number());
        }));
        for (Outcome outcome : outcomes) {
            String error = outcome.error();
            switch ((int) outcome.replicate()) {
                case 1 -> assertThat(error).isEqualTo("java.lang.AssertionError: it fell over");
                case 4 -> assertThat(error).isEqualTo("java.lang.NoClassDefFoundError: example/Missing");
                case 5 -> assertThat(error).isEqualTo(Shy.class.getName());
                case 7 -> assertThat(error).isEqualTo("java.lang.StackOverflowError");
                case 8 -> assertThat(error).isEqualTo("java.lang.InterruptedException: it waited");
                default -> assertThat(error).isNull();
            }
        }
        ParameterSweep full = sweep(replicate -> {
            throw new OutOfMemoryError("no heap");
        });
        assertThatThrownBy(() -> full.run(0)).isInstanceOf(OutOfMemoryError.class);
    }

    /** The next replicate finds a thread that nobody has interrupted, and the file is still open. */
    @Test
    void aThreadThatIsLeftInterruptedStopsNothing() throws Exception {
        List<Outcome> outcomes = outcomes(sweep(replicate -> {
            boolean wasInterrupted = Thread.currentThread().isInterrupted();
            Thread.currentThread().interrupt();
            return Result.of("was", wasInterrupted ? 1 : 0);
        }));
        assertThat(outcomes).allMatch(outcome -> outcome.values().equals(Map.of("was", 0.0)));
    }

    @Test
    void anErrorIsCutAndCleaned() throws Exception {
        List<Outcome> outcomes = outcomes(sweep(replicate -> {
            throw new IllegalStateException(
                    replicate.number() % 2 == 0 ? "x\ud83d\ude00".repeat(40_000) : "half \ud83d of a pair, \udc00");
        }));
        for (Outcome outcome : outcomes) {
            String error = outcome.error();
            assertThat(error).isNotNull();
            if (outcome.replicate() % 2 == 0) {
                assertThat(error)
                        .startsWith("java.lang.IllegalStateException: x\ud83d\ude00x")
                        .endsWith("...");
                assertThat(error.codePointCount(0, error.length())).isEqualTo(2003);
            } else {
                assertThat(error).isEqualTo("java.lang.IllegalStateException: half \ufffd of a pair, \ufffd");
            }
        }
    }

    /** A world that cannot be in another dimension is tried once, not for each replicate. */
    @Test
    void aWorldThatCannotBeIsTriedOnce() {
        Geometry flat = new Geometry(10, 10, 10, Dimension.PLANAR, Accuracy.EXACT);
        assertThat(flat.addObjectUnchecked(new BoxObject(new Point(0, 30, 0), 1, 1, 1)))
                .isTrue();
        Snapshot snapshot = flat.snapshot();
        SweepWorld world = new SweepWorld("flat", snapshot);
        SweepWorld.Views views = new SweepWorld.Views();
        List<Throwable> failures = new ArrayList<>();
        for (int k = 0; k < 2; k++) {
            try {
                views.of(0, world, Dimension.SPATIAL, Accuracy.EXACT);
            } catch (IllegalArgumentException e) {
                failures.add(e);
            }
        }
        assertThat(failures).hasSize(2);
        assertThat(failures.get(0)).hasMessageContaining("must be within the world");
        assertThat(failures.get(1)).isSameAs(failures.get(0));
    }
}
