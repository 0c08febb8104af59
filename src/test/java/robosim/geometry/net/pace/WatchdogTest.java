package robosim.geometry.net.pace;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import robosim.geometry.net.HostilePeerTest;
import robosim.geometry.net.LogCapture;

@Tag("clock")
class WatchdogTest {
    /** Another connection's message may have taken the memory for the moment. */
    @Test
    void anErrorInBreakingOffOneEndsTheWatchOverNoOther() throws Exception {
        try (LogCapture log = new LogCapture();
                Watchdog watchdog = new Watchdog("geometry-watch-of-a-test", Duration.ofMillis(4))) {
            Watchdog.Guard failing = watchdog.guard(() -> {
                throw new OutOfMemoryError("none for the moment");
            });
            failing.begin(System.nanoTime());
            HostilePeerTest.await(failing::isBroken);
            CountDownLatch brokenOff = new CountDownLatch(1);
            Watchdog.Guard next = watchdog.guard(brokenOff::countDown);
            next.begin(System.nanoTime());
            assertThat(brokenOff.await(5, TimeUnit.SECONDS)).isTrue();
            assertThat(log.linesWith("geometry-watch-of-a-test: goes on after an error"))
                    .hasSize(1);
        }
    }
}
