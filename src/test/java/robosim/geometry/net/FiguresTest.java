package robosim.geometry.net;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.management.ManagementFactory;
import java.net.InetAddress;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import javax.management.MBeanServer;
import javax.management.ObjectName;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import robosim.geometry.Allocated;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Point;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MoveRequest;
import robosim.geometry.protocol.SonarRequest;

/** What an operator sees. */
@Tag("clock")
class FiguresTest {
    private static final MBeanServer BEANS = ManagementFactory.getPlatformMBeanServer();

    @Test
    void quantilesAreThoseOfTheSortedTimesWithinASixteenth() {
        SplittableRandom random = new SplittableRandom(2);
        for (int size : new int[] {1, 2, 100, 5000}) {
            Histogram histogram = new Histogram();
            long[] times = new long[size];
            for (int k = 0; k < size; k++) {
                times[k] = random.nextLong() >>> random.nextInt(1, 64); // of every magnitude, 0 and the greatest too
                histogram.add(times[k]);
            }
            Arrays.sort(times);
            for (double share : new double[] {0.01, 0.5, 0.9, 0.99, 1}) {
                long truth = times[(int) Math.ceil(share * size) - 1];
                assertThat(histogram.quantile(share))
                        .as("quantile %s of %s", share, size)
                        .isBetween(truth, truth > Long.MAX_VALUE - truth / 16 ? Long.MAX_VALUE : truth + truth / 16);
            }
        }
    }

    @Test
    void noTimesAndTheLongestAreTimesToo() {
        Histogram histogram = new Histogram();
        assertThat(histogram.quantile(0.5)).isZero();
        histogram.add(Long.MAX_VALUE);
        assertThat(histogram.quantile(0.99)).isEqualTo(Long.MAX_VALUE);
        histogram.add(-1); // of a clock that went back
        assertThat(histogram.quantile(0.5)).isZero();
    }

    @Test
    void countingAllocatesNothing() {
        Histogram histogram = new Histogram();
        long bytes = Allocated.everyTime(() -> {
            for (int k = 0; k < 100_000; k++) {
                histogram.add(k * 1000L);
            }
        });
        assertThat(bytes).as("bytes for 100,000 times").isLessThan(100_000);
    }

    @Test
    void everythingIsCountedAndShownByJmx() throws Exception {
        NetOptions two = NetOptions.defaults().withConnections(2);
        try (LogCapture log = new LogCapture();
                GeometryServer server = new GeometryServer(InetAddress.getLoopbackAddress(), 0, two)) {
            try (Peer peer = Peer.dial(server.port());
                    Peer rude = Peer.dial(server.port())) {
                peer.send(new InitBundle(List.of(
                        new CylinderObject(new Point(), 1, 1).moveable("robot"),
                        new CylinderObject(new Point(3, 0, 0), 1, 1))));
                assertThat(peer.move(
                                new MoveRequest("robot", 0.5, 0, 0, 0, 0),
                                new MoveRequest("robot", 5, 0, 0, 0, 0),
                                new MoveRequest("nobody", 1, 0, 0, 0, 0)))
                        .hasSize(1);
                assertThat(peer.measure(new SonarRequest("robot", 1, 0), new SonarRequest("robot", 0, 1)))
                        .containsExactly(1.5, Double.POSITIVE_INFINITY);
                assertThat(rude.move()).isEmpty();
                try (Peer third = Peer.dial(server.port())) {
                    assertThat(third.isClosedByTheOtherEnd()).isTrue();
                }
                rude.send(new byte[] {1, 2, 3});
                assertThat(rude.isClosedByTheOtherEnd()).isTrue();
                HostilePeerTest.await(() -> server.figures().getOpenConnections() == 1);
                see(server);
            }
            HostilePeerTest.await(() -> server.figures().getOpenConnections() == 0);
            assertThat(log.linesWith("closed at message 2, ")).hasSize(1);
            assertThat(log.linesWith("closed at message 1, ")).isEmpty();
        }
        assertThat(beans("GeometryServer")).as("left behind").isEmpty();
    }

    /** Who embeds the module needs java.base and java.xml; without java.management a server is without JMX alone. */
    @Test
    void withoutTheModuleJavaManagementAServerServes() throws Exception {
        try (LogCapture log = new LogCapture();
                Child server = Child.start("serve", 0, 1, "--limit-modules", "java.base,java.xml")) {
            Conversation conversation = Conversation.of(4, 20);
            int port = Integer.parseInt(server.line());
            assertThat(conversation.difference(new Talker(port, 2, conversation).talk()))
                    .isEmpty();
            assertThat(log.linesWith("closed")).isEmpty();
        }
    }

    private static Set<ObjectName> beans(String type) throws Exception {
        return BEANS.queryNames(new ObjectName("robosim.geometry:type=" + type + ",*"), null);
    }

    private static void see(GeometryServer server) throws Exception {
        ObjectName name = beans("GeometryServer").stream()
                .filter(each -> each.getKeyProperty("name").contains(":" + server.port()))
                .findFirst()
                .orElseThrow();
        assertThat(BEANS.getAttribute(name, "OpenConnections")).isEqualTo(1);
        assertThat(BEANS.getAttribute(name, "Connections")).isEqualTo(2L);
        assertThat(BEANS.getAttribute(name, "RefusedConnections")).isEqualTo(1L);
        assertThat(BEANS.getAttribute(name, "Bundles")).isEqualTo(4L);
        assertThat(BEANS.getAttribute(name, "Requests")).isEqualTo(5L);
        assertThat(BEANS.getAttribute(name, "RefusedMoves")).isEqualTo(2L);
        assertThat(BEANS.getAttribute(name, "Errors")).isEqualTo(1L);
        double median = (double) BEANS.getAttribute(name, "AnswerMicrosecondsP50");
        assertThat(median).isPositive();
        assertThat((double) BEANS.getAttribute(name, "AnswerMicrosecondsP99")).isGreaterThanOrEqualTo(median);
        assertThat((String) BEANS.invoke(name, "line", null, null))
                .startsWith(
                        "connections 1 open, 2 in all, 1 refused; 4 bundles, 5 requests, 2 moves refused; 1 errors;")
                .isEqualTo(server.figures().line());
    }
}
