package robosim.geometry.net;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.DistanceBundle;
import robosim.geometry.protocol.MessageReader;
import robosim.geometry.protocol.MessageWriter;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.MoveRequest;
import robosim.geometry.protocol.SonarRequest;
import robosim.geometry.protocol.SonarRequestBundle;

/** An environment that says what a test tells it to. */
final class Peer implements AutoCloseable {
    private static final int PATIENCE_MILLIS = 20_000;

    final Socket socket;
    private @Nullable MessageWriter writer;
    private @Nullable MessageReader reader;

    Peer(Socket socket) throws IOException {
        this.socket = socket;
        socket.setSoTimeout(PATIENCE_MILLIS); // a test that waits longer has failed
        socket.setTcpNoDelay(true);
    }

    static Peer dial(int port) throws IOException {
        return new Peer(new Socket(InetAddress.getLoopbackAddress(), port));
    }

    static ServerSocket listen() throws IOException {
        ServerSocket listening = new ServerSocket(0, 10, InetAddress.getLoopbackAddress());
        listening.setSoTimeout(PATIENCE_MILLIS);
        return listening;
    }

    void send(Bundle bundle) throws IOException {
        if (writer == null) {
            writer = new MessageWriter(socket.getOutputStream());
        }
        writer.write(bundle);
    }

    void send(byte[] bytes) throws IOException {
        OutputStream out = socket.getOutputStream();
        out.write(bytes);
        out.flush();
    }

    @Nullable
    Bundle receive() throws IOException {
        if (reader == null) {
            reader = new MessageReader(socket.getInputStream());
        }
        return reader.read();
    }

    List<MoveRequest> move(MoveRequest... moves) throws IOException {
        send(new MoveBundle(List.of(moves)));
        return ((MoveBundle) receive()).moves();
    }

    List<Double> measure(SonarRequest... requests) throws IOException {
        send(new SonarRequestBundle(List.of(requests)));
        return ((DistanceBundle) receive()).distances();
    }

    /** Whether the other end closed the connection; waits for it and skips what it still sent. */
    boolean isClosedByTheOtherEnd() {
        try {
            byte[] rest = new byte[1000];
            int got;
            do {
                got = socket.getInputStream().read(rest);
            } while (got >= 0);
            return true;
        } catch (java.net.SocketTimeoutException e) {
            return false;
        } catch (IOException e) {
            return true; // a reset
        }
    }

    /** What comes until the other end closes the connection, as a text. */
    String heardToTheEnd() throws IOException {
        return new String(socket.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    }

    @Override
    public void close() throws IOException {
        socket.close();
    }

    /** The bytes that this bundle takes as a stream of its own. */
    static byte[] bytes(Bundle bundle) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        new MessageWriter(bytes).write(bundle);
        return bytes.toByteArray();
    }
}
