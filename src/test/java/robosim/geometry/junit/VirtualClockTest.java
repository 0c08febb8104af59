package robosim.geometry.junit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.time.ZoneId;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Time that only steps move. */
class VirtualClockTest {
    @Test
    void itStandsStillBetweenSteps() {
        VirtualClock clock = new VirtualClock(Duration.ofMillis(40));
        Clock there = clock.withZone(ZoneId.of("Europe/Berlin"));
        assertThat(clock.instant()).isEqualTo(Instant.EPOCH);
        clock.advance(25);
        assertThat(clock.elapsed()).isEqualTo(Duration.ofSeconds(1));
        assertThat(there.millis()).isEqualTo(1000);
        assertThat(there.getZone()).isEqualTo(ZoneId.of("Europe/Berlin"));
    }

    @Test
    void eachStepLetsAllActInTheirOrder() {
        VirtualClock clock = new VirtualClock(Duration.ofMillis(40));
        List<String> acted = new ArrayList<>();
        clock.each(() -> acted.add("a" + clock.steps()));
        clock.each(() -> acted.add("b" + clock.steps()));
        clock.advance(2);
        assertThat(acted).containsExactly("a1", "b1", "a2", "b2");
    }

    @Test
    void badNumbersAreRefused() {
        assertThatThrownBy(() -> new VirtualClock(Duration.ZERO)).hasMessageContaining("(got: PT0S)");
        assertThatThrownBy(() -> new VirtualClock(Duration.ofMillis(1)).advance(-1))
                .hasMessageContaining("(got: -1)");
    }
}
