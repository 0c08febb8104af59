package robosim.geometry.bench;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.InputStreamReader;
import java.lang.management.ManagementFactory;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import robosim.geometry.net.GeometryServer;
import robosim.geometry.net.NetOptions;
import robosim.geometry.scenario.drive.WorldLoading;

/**
 * What docs/server.md promises of how long a healthy environment waits beside greedy ones. Under {@code -Psoak} each kind of them
 * has a tenth of {@code soak.seconds}, and the promise is checked, which needs a machine without other work. In an ordinary build
 * one of them has half a second, and only the answers are checked.
 */
@Tag("clock")
class FairnessTest {
    private static final long SECONDS = Long.getLong("soak.seconds", 0);

    /** Milliseconds, as published. */
    private static final double P99 = 20;

    private static final double P999 = 100;

    static Greed[] attacks() {
        return SECONDS > 0 ? Greed.values() : new Greed[] {Greed.HYPAR};
    }

    /** Else the requests of {@link Greed#MIXED} would cost nothing. */
    @Test
    void mixedRequestsAreLegal() throws Exception {
        NetOptions options = NetOptions.defaults()
                .withWorlds(WorldLoading.of(null, List.of()))
                .withRequestLimit(Duration.ofMillis(20), Long.MAX_VALUE);
        int carriedOut = 0;
        try (GeometryServer server = new GeometryServer(InetAddress.getLoopbackAddress(), 0, options);
                Socket socket = new Socket(InetAddress.getLoopbackAddress(), server.port());
                BufferedReader in =
                        new BufferedReader(new InputStreamReader(socket.getInputStream(), StandardCharsets.UTF_8))) {
            socket.getOutputStream().write(Greed.HELLO);
            assertThat(in.readLine()).contains("hello");
            LegalRequests legal = new LegalRequests(1);
            for (int k = 0; k < 40; k++) {
                boolean isWorld = k % 5 == 0;
                socket.getOutputStream().write(isWorld ? legal.world() : legal.request());
                String answer = in.readLine();
                boolean isCarriedOut = !answer.startsWith("{\"type\":\"error\"");
                assertThat(isCarriedOut || answer.contains("processor time") || !isWorld)
                        .as("world %d: %s", k, answer)
                        .isTrue();
                carriedOut += isCarriedOut ? 1 : 0;
            }
        }
        assertThat(carriedOut).isBetween(10, 39);
    }

    @ParameterizedTest
    @MethodSource("attacks")
    void aHealthyEnvironmentIsAnsweredInTime(Greed attack) throws Exception {
        Duration time =
                SECONDS > 0 ? Duration.ofSeconds(Math.max(5, SECONDS / Greed.values().length)) : Duration.ofMillis(500);
        Fairness.Waits[] waits = Fairness.measure(attack, time); // fails where an answer is not the right one
        assertThat(waits[0].answers()).isPositive();
        assertThat(waits[1].answers()).isPositive();
        if (SECONDS > 0) {
            String beside = String.format(
                    Locale.ROOT,
                    "beside %s, at a load of the machine of %.1f: %s; beside nobody %s",
                    attack,
                    ManagementFactory.getOperatingSystemMXBean().getSystemLoadAverage(),
                    waits[1],
                    waits[0]);
            System.out.println(beside);
            assertThat(waits[1].p99()).as(beside).isLessThan(P99);
            assertThat(waits[1].p999()).as(beside).isLessThan(P999);
        }
    }
}
