package robosim.geometry.dynamics.proof;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

/**
 * All families of scenes: no overlap, decided without the world's own code, nobody through a wall, no energy from nowhere.
 * {@code -Ddynamics.steps=N} for N steps.
 */
class StepFamiliesTest {
    @Test
    void nothingOverlapsAndNothingPassesThrough() {
        long steps = Long.getLong("dynamics.steps", 3000);
        StepProof proof = new StepProof(StepProof.all(), steps).run(steps > 100_000);
        assertThat(proof.failures).isEmpty();
        assertThat(proof.steps()).isGreaterThanOrEqualTo(steps);
        assertThat(proof.contacts.get()).isGreaterThan(proof.steps() / 2);
        // Speeds of 10 km/s, wedges and cages may need more collisions than a step has; ordinary drives never do.
        proof.stopped.assertAtMost(8000);
        proof.stops[StepFamily.DRIVEN.ordinal()].assertAtMost(0);
    }

    /** One digest, whatever the threads and the JVM. */
    @Test
    void theBitsAreTheSameEverywhere() {
        StepProof alone = new StepProof(StepProof.all(), 1000).run(false);
        StepProof together = new StepProof(StepProof.all(), 1000).run(true);
        assertThat(together.digest.get()).isEqualTo(alone.digest.get());
        assertThat(Long.toHexString(alone.digest.get())).isEqualTo("3fd350a40ac856e6");
    }

    /** Of a lying cylinder the rims are lines, whose hull was once cut short: it went into a wall. */
    @Test
    void aLyingCylinderKeepsOutOfAWall() {
        StepProof proof = new StepProof(List.of(StepFamily.SHAPES), 1);
        assertThat(proof.run(StepFamily.SHAPES, 168839)).isNull();
    }
}
