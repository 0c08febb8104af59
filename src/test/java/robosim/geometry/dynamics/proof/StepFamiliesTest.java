package robosim.geometry.dynamics.proof;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.File;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import robosim.geometry.Geometry;
import robosim.geometry.bench.ClassPath;

/** {@code -Ddynamics.steps=N} for N steps, and how far it is; some thousand otherwise. */
class StepFamiliesTest {
    private static final long STEPS = Long.getLong("dynamics.steps", 3000);
    private static final long FEW = 1200;

    /** Nothing overlaps, nothing has passed through anything, and energy has not grown. */
    @Test
    void nothingIsBrokenInAnyFamily() {
        StepProof proof = new StepProof(StepProof.all(), STEPS, STEPS > 100_000).run(1);
        assertThat(proof.failures).isEmpty();
        assertThat(proof.failed.get()).isZero();
        assertThat(proof.steps()).isGreaterThanOrEqualTo(STEPS);
        // Worlds in which nothing meets, or in which everything is stopped, prove nothing.
        assertThat(proof.contacts.get()).isGreaterThan(proof.steps() / 2);
        assertThat(proof.stopped.get()).isLessThan(proof.steps() / 5);
    }

    /** The same bits on one thread, on three, by an interpreter, and on all other JDKs that are found beside this one. */
    @Test
    void theBitsAreTheSameEverywhere() throws Exception {
        String digest = digest(1);
        assertThat(digest(3)).isEqualTo(digest);
        File own = new File(System.getProperty("java.home"));
        assertThat(elsewhere(own, "-Xint")).isEqualTo(digest);
        File[] beside = own.getParentFile().listFiles(home -> new File(home, "release").exists());
        for (File home : beside == null ? new File[0] : beside) {
            if (!home.getCanonicalFile().equals(own.getCanonicalFile()) && new File(home, "bin/java").canExecute()) {
                assertThat(elsewhere(home, "-Xshare:auto")).as("%s", home).isEqualTo(digest);
            }
        }
    }

    private static String digest(int threads) {
        return Long.toHexString(
                new StepProof(StepProof.all(), FEW, false).run(threads).digest.get());
    }

    private static String elsewhere(File home, String option) throws Exception {
        List<String> command = new ArrayList<>(List.of(
                home + "/bin/java",
                option,
                "-Ddynamics.steps=" + FEW,
                "-cp",
                ClassPath.of(StepProof.class, Geometry.class),
                StepProof.class.getName()));
        Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
        StringBuilder said = new StringBuilder();
        try (BufferedReader lines =
                new BufferedReader(new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8))) {
            lines.lines().forEach(line -> said.append(line).append('\n'));
        }
        process.waitFor();
        int at = said.indexOf("digest ");
        assertThat(at).as(said.toString()).isPositive();
        String padded = said.substring(at + 7, at + 7 + 16);
        return Long.toHexString(Long.parseUnsignedLong(padded, 16));
    }
}
