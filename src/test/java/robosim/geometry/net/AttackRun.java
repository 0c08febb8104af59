package robosim.geometry.net;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import robosim.geometry.Rulings;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.MoveRequest;
import robosim.geometry.protocol.StepBundle;
import robosim.geometry.protocol.WorldSettings;
import robosim.geometry.protocol.motion.BodyRequest;
import robosim.geometry.protocol.motion.Velocity;

/** What peers do to a server by legal requests alone, or before they have made any; each must be survived. */
final class AttackRun {
    private static final int PATIENCE_SECONDS = 60;
    private static final int CROWD = 300;
    private static final String WORLD =
            "{\"type\":\"init\",\"objects\":[{\"kind\":\"cylinder\",\"name\":\"r\",\"moveable\":true,\"center\":[0,0,0],"
                    + "\"radius\":0.2,\"height\":1}]}\n";
    private static final String GO =
            "{\"type\":\"moves\",\"moves\":[{\"objectName\":\"r\",\"x\":0.1,\"y\":0,\"z\":0,\"rx\":0,\"ry\":0}]}\n";
    private static final String HELLO = "{\"type\":\"hello\",\"version\":1}\n";

    /** Each is answered with an error, and the session goes on with its world. */
    private static final List<String> WRONG = List.of(
            sonar("{\"min\":2,\"max\":1,\"width\":0.1}"),
            sonar("{\"min\":0,\"max\":9,\"width\":3.2}"),
            sonar("{\"min\":-1,\"max\":9,\"width\":0}"),
            "{\"type\":\"moves\",\"moves\":[{\"objectName\":\"r\",\"x\":1e999,\"y\":0,\"z\":0,\"rx\":0,\"ry\":0}]}",
            "{\"type\":\"moves\",\"moves\":[{\"objectName\":\"r\",\"x\":1}]}",
            "{\"type\":\"step\",\"seconds\":-1}",
            "{\"type\":\"init\",\"objects\":[{\"kind\":\"box\",\"center\":[0,0,0],\"width\":-1,\"height\":1,\"length\":1}]}",
            "{\"type\":\"init\",\"objects\":[{\"kind\":\"mesh\",\"vertices\":[[0,0,0],[1,0,0],[0,0,1]],\"faces\":[[0,1,9]]}]}",
            "{\"type\":\"load\",\"file\":\"w.xml\",\"files\":{\"w.xml\":\"AAAA\"}}",
            "{\"type\":\"fly\"}");

    private final GeometryServer server;
    private final FaultTable table;
    private final InitBundle slivers;
    private final InitBundle crowd;
    private final StepBundle hour;

    /**
     * Attacks on a server of this process.
     *
     * @param slivers of each of two meshes: all pairs are close, and none touches
     * @param bodies  that a step of an hour moves
     */
    AttackRun(GeometryServer server, FaultTable table, int slivers, int bodies) {
        this.server = server;
        this.table = table;
        this.slivers = new InitBundle(
                List.of(
                        Rulings.mesh(slivers, true, 0),
                        Rulings.mesh(slivers, false, 1e-3).moveable("m")),
                new WorldSettings(10, 10, 10, Dimension.SPATIAL, Accuracy.EXACT));
        List<GeometryObject> objects = new ArrayList<>();
        List<BodyRequest> moving = new ArrayList<>();
        for (int k = 0; k < bodies; k++) {
            objects.add(new CylinderObject(new Point(k % 60 - 30, 0, k / 60 - 25), 0.4, 1).moveable("b" + k));
            moving.add(BodyRequest.of("b" + k).withVelocity(new Velocity(1 - k % 3, 0, k % 5 - 2, 0.1)));
        }
        crowd = new InitBundle(objects, new WorldSettings(100, 5, 100, Dimension.PLANAR, Accuracy.EXACT));
        hour = new StepBundle(3600, moving, List.of());
    }

    /** Those that send a request of hours, and are gone when it has begun. */
    void vanish() throws IOException, InterruptedException {
        vanish(
                "a move of slivers along slivers, whose peer vanishes",
                slivers,
                new MoveBundle(List.of(new MoveRequest("m", 0, 1e-5, 0, 0, 0))));
        vanish("a step of an hour, whose peer vanishes", crowd, hour);
    }

    private void vanish(String kind, InitBundle world, Bundle request) throws IOException, InterruptedException {
        String place;
        boolean hasBegun;
        try (Peer peer = Peer.dial(server.port())) {
            place = ":" + peer.socket.getLocalPort();
            peer.send(world);
            peer.send(request);
            String name = request.getClass().getSimpleName();
            hasBegun = comesTrue(() -> of(place).anyMatch(each -> name.equals(each.request())));
            TimeUnit.MILLISECONDS.sleep(200);
        }
        boolean isOver = comesTrue(() -> of(place).findAny().isEmpty());
        table.enter(kind, !hasBegun ? "was not begun" : isOver ? "" : "was computed on");
    }

    private Stream<GeometryServer.Peer> of(String place) {
        return server.peers().stream().filter(each -> each.address().endsWith(place));
    }

    /** Those that dial and say nothing, while somebody else is served, over TLS where there are keys. */
    void idle(@Nullable Tls tls) throws IOException {
        List<Socket> silent = new ArrayList<>();
        try {
            for (int k = 0; k < CROWD; k++) {
                silent.add(new Socket(InetAddress.getLoopbackAddress(), server.port()));
            }
            Socket plain = new Socket(InetAddress.getLoopbackAddress(), server.port());
            try (Peer served = new Peer(tls == null ? plain : tls.dial(plain, "127.0.0.1", server.port()))) {
                served.move(new MoveRequest("nobody", 1, 0, 0, 0, 0));
            }
            table.enter(CROWD + " that say nothing" + (tls == null ? "" : " to a server with TLS"), "");
        } finally {
            for (Socket each : silent) {
                each.close();
            }
        }
    }

    /** One that sends a byte from time to time, and so is never silent for long. */
    void trickle() throws IOException, InterruptedException {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_SECONDS);
        boolean isOver = false;
        try (Peer slow = Peer.dial(server.port())) {
            String place = ":" + slow.socket.getLocalPort();
            byte[] start = HELLO.substring(0, 5).getBytes(StandardCharsets.UTF_8);
            slow.send(start);
            while (!isOver && System.nanoTime() < end) {
                slow.send(new byte[] {' '});
                TimeUnit.MILLISECONDS.sleep(200);
                isOver = of(place).findAny().isEmpty();
            }
        } catch (IOException e) {
            isOver = true; // closed meanwhile
        }
        table.enter("a hello that trickles", isOver ? "" : "was waited for");
    }

    /** A session of wrong numbers, each of which is answered, and after which all is as before. */
    void wrong() throws IOException {
        try (Peer peer = Peer.dial(server.port());
                BufferedReader heard = new BufferedReader(
                        new InputStreamReader(peer.socket.getInputStream(), StandardCharsets.UTF_8))) {
            peer.send((HELLO + WORLD + String.join("\n", WRONG) + "\n" + GO).getBytes(StandardCharsets.UTF_8));
            String failure = heard.readLine().contains("hello") ? "" : "no hello";
            for (String line : WRONG) {
                String answer = String.valueOf(heard.readLine());
                failure += answer.startsWith("{\"type\":\"error\"") ? "" : line + " was answered by " + answer + "; ";
            }
            String last = String.valueOf(heard.readLine());
            failure += last.contains("\"moves\":[{\"objectName\":\"r\"") ? "" : "the session ended: " + last;
            table.enter("a session of " + WRONG.size() + " wrong requests", failure);
        }
    }

    private static String sonar(String beam) {
        return "{\"type\":\"sonars\",\"requests\":[{\"objectName\":\"r\",\"xOffset\":1,\"zOffset\":0,\"beam\":" + beam
                + "}]}";
    }

    private static boolean comesTrue(BooleanSupplier what) throws InterruptedException {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_SECONDS);
        while (!what.getAsBoolean() && System.nanoTime() < end) {
            TimeUnit.MILLISECONDS.sleep(10);
        }
        return what.getAsBoolean();
    }
}
