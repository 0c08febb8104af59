package robosim.geometry.net;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.file.Path;
import javax.net.ssl.SSLSocket;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import robosim.geometry.protocol.MoveRequest;

/** Certificates count only between their dates, and are replaced while sessions last. */
@Tag("clock")
class CertificatesTest {
    private static final MoveRequest NOBODY = new MoveRequest("nobody", 1, 0, 0, 0, 0);
    private static final InetAddress HERE = InetAddress.getLoopbackAddress();

    @TempDir
    static Path folder;

    private static Stores stores;

    @BeforeAll
    static void makeStores() throws Exception {
        stores = new Stores(folder);
        stores.make("expired", "-5d");
        stores.make("early", "+1d");
        stores.trust("expired", "module");
        stores.trust("early", "module");
        // Each certificate is itself trusted, as the guide says: of such a one Java does not look at the dates.
        stores.trust("module", "environment", "expired", "early");
    }

    private static Peer secured(int port, String who) throws IOException {
        SSLSocket socket = stores.of(who).dial(new Socket(HERE, port), "127.0.0.1", port);
        return new Peer(socket);
    }

    private static GeometryServer server() {
        return new GeometryServer(HERE, 0, NetOptions.defaults().withAccess(stores.of("module"), null));
    }

    @Test
    void whoseCertificateIsNotValidNowIsToldSo() throws Exception {
        try (LogCapture log = new LogCapture();
                GeometryServer server = server();
                Peer valid = secured(server.port(), "environment")) {
            assertThat(valid.move(NOBODY)).isEmpty();
            for (String who : new String[] {"expired", "early"}) {
                for (int time = 0; time < 2; time++) { // the second handshake resumes the first one's session
                    try (Peer peer = secured(server.port(), who)) {
                        assertThat(peer.heardToTheEnd())
                                .contains(
                                        "the peer's certificate must be valid now (got: CN=" + who + ", valid from 20");
                    }
                }
                HostilePeerTest.await(
                        () -> log.linesWith("valid now (got: CN=" + who).size() == 2);
            }
            assertThat(valid.move(NOBODY)).isEmpty();
        }
    }

    @Test
    void aClientLooksAtTheDatesToo() throws Exception {
        try (LogCapture log = new LogCapture();
                ServerSocket listening = Peer.listen();
                GeometryClient client = new GeometryClient(
                        "127.0.0.1",
                        listening.getLocalPort(),
                        NetOptions.defaults().withAccess(stores.of("module"), null))) {
            Thread thread = new Thread(client, "geometry-client-of-a-test");
            thread.start();
            try (Peer environment = new Peer(stores.of("expired").accept(listening.accept()))) {
                assertThat(environment.heardToTheEnd()).contains("must be valid now");
            }
            thread.join(20_000);
            assertThat(thread.isAlive()).isFalse();
            assertThat(log.linesWith("must be valid now")).hasSize(1);
        }
    }

    @Test
    void otherKeysAndAnotherSecretHoldForConnectionsFromThenOn() throws Exception {
        try (LogCapture log = new LogCapture();
                GeometryServer server = server();
                Peer first = secured(server.port(), "environment")) {
            assertThat(first.move(NOBODY)).isEmpty();
            stores.trust("module", "stranger");
            server.renew(stores.of("module"), null);
            try (Peer stranger = secured(server.port(), "stranger");
                    Peer second = secured(server.port(), "environment")) {
                assertThat(stranger.move(NOBODY)).isEmpty();
                assertThat(second.isClosedByTheOtherEnd()).isTrue();
            }
            assertThat(first.move(NOBODY)).as("a session that lasts").isEmpty();
            HostilePeerTest.await(() -> log.linesWith("TLS was not agreed on").size() == 1);
        } finally {
            stores.trust("module", "environment", "expired", "early");
        }
        try (GeometryServer server = new GeometryServer(
                InetAddress.getByName("0.0.0.0"), 0, NetOptions.defaults().withAccess(stores.of("module"), null))) {
            assertThatThrownBy(() -> server.renew(null, null)).hasMessageContaining("must authenticate its peers");
        }
    }
}
