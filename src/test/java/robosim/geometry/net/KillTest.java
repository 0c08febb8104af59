package robosim.geometry.net;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.ServerSocket;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.MoveRequest;

/** Either end is killed in the midst of a conversation: the other goes on, and no third party notices. */
@Tag("clock")
class KillTest {
    private static List<Bundle> talk(int port, Conversation conversation) {
        try {
            return new Talker(port, 4, conversation).talk();
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
    }

    /** Kills an environment of that server while it talks; empty where nobody else noticed. */
    static String killEnvironment(GeometryServer server, Conversation healthy) throws Exception {
        CompletableFuture<List<Bundle>> beside;
        try (Child environment = Child.start("dial", server.port(), 21)) {
            assertThat(environment.line()).isEqualTo("talking");
            beside = CompletableFuture.supplyAsync(() -> talk(server.port(), healthy));
        }
        return healthy.difference(beside.get(30, TimeUnit.SECONDS));
    }

    @Test
    void anEnvironmentThatIsKilledIsMissedByNobody() throws Exception {
        try (LogCapture log = new LogCapture();
                GeometryServer server = new GeometryServer(0)) {
            assertThat(killEnvironment(server, Conversation.of(8, 100))).isEmpty();
            HostilePeerTest.await(() -> server.connections() == 0);
            assertThat(server.figures().getConnections()).isGreaterThanOrEqualTo(2);
            assertThat(log.linesWith("an error of the module itself")).isEmpty();
        }
    }

    @Test
    void aServerThatIsKilledIsWhatItWasWhenItComesBack() throws Exception {
        try (LogCapture log = new LogCapture()) {
            assertThat(killServer()).isEmpty();
            assertThat(log.linesWith("closed")).isEmpty();
        }
    }

    /** Empty where an environment heard the truth as far as it went, and all of it from the next server on that port. */
    static String killServer() throws Exception {
        Conversation conversation = Conversation.of(9, 3000);
        int port;
        List<Bundle> heard;
        try (Child server = Child.start("serve", 0, 1)) {
            port = Integer.parseInt(server.line());
            // Slow enough to be there when it happens.
            Talker talker = new Talker(port, 4, conversation).reading(k -> {
                if (k == 100) {
                    server.kill();
                }
            });
            heard = talker.talk();
        }
        if (heard.size() < 90 || heard.size() >= 3000) {
            return "the server must be killed at some 100 answers (got: " + heard.size() + ")";
        }
        String prefix = conversation.first(heard.size()).difference(heard);
        if (!prefix.isEmpty()) {
            return prefix;
        }
        try (Child again = Child.start("serve", port, 1)) {
            assertThat(again.line()).isEqualTo("" + port);
            return conversation.difference(talk(port, conversation));
        }
    }

    @Test
    void anEnvironmentWhoseClientIsKilledIsDialledByTheNextWithoutAWorld() throws Exception {
        Conversation conversation = Conversation.of(10, 200);
        try (ServerSocket environment = Peer.listen()) {
            try (Child client = Child.start("connect", environment.getLocalPort(), 1);
                    Peer peer = new Peer(environment.accept())) {
                peer.send(conversation.world());
                for (int k = 0; k < 100; k++) {
                    peer.send(conversation.requests().get(k));
                    assertThat(peer.receive()).isEqualTo(conversation.answers().get(k));
                }
                client.kill();
                assertThat(peer.isClosedByTheOtherEnd()).isTrue();
            }
            try (Child client = Child.start("connect", environment.getLocalPort(), 1);
                    Peer peer = new Peer(environment.accept())) {
                assertThat(peer.move(new MoveRequest("robot 0", 0, 0, 0, 0, 0.1)))
                        .as("made in the world of the one that was killed")
                        .isEmpty();
                peer.send(conversation.world());
                for (int k = 0; k < conversation.requests().size(); k++) {
                    peer.send(conversation.requests().get(k));
                    assertThat(peer.receive()).isEqualTo(conversation.answers().get(k));
                }
            }
        }
    }

    @Test
    void aClientFindsTheEnvironmentThatTookTheKilledOnesPlace() throws Exception {
        int port;
        try (ServerSocket free = Peer.listen()) {
            port = free.getLocalPort();
        }
        Redial redial = new Redial(Duration.ofMillis(20), Duration.ofMillis(200));
        try (LogCapture log = new LogCapture();
                GeometryClient client = new GeometryClient(
                        "127.0.0.1", port, NetOptions.defaults().withRedial(redial))) {
            Thread thread = new Thread(client, "geometry-client-of-a-test");
            thread.start();
            talkAndDie(port);
            talkAndDie(port);
            client.close();
            thread.join(5000);
            assertThat(thread.isAlive()).isFalse();
            assertThat(client.figures().getConnections()).isGreaterThanOrEqualTo(2);
            assertThat(log.linesWith("an error of the module itself")).isEmpty();
        }
    }

    private static void talkAndDie(int port) throws IOException, InterruptedException {
        try (Child environment = Child.start("listen", port, 22)) {
            assertThat(environment.line()).isEqualTo("" + port);
            assertThat(environment.line()).isEqualTo("talking");
            assertThat(environment.line()).isEqualTo("same");
        }
    }
}
