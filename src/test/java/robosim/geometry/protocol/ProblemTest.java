package robosim.geometry.protocol;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class ProblemTest {
    @Test
    void problemsAreEqualByIndexAndReason() {
        Problem one = Problem.of(2, () -> "too " + "far");
        assertThat(one).isEqualTo(Problem.of(2, () -> "too far")).hasSameHashCodeAs(Problem.of(2, () -> "too far"));
        assertThat(one).isNotEqualTo(Problem.of(3, () -> "too far")).isNotEqualTo(Problem.of(2, () -> "too near"));
        assertThat(one.hashCode()).isNotEqualTo(Problem.of(3, () -> "too far").hashCode());
        assertThat(one).hasToString("2: too far");
    }
}
