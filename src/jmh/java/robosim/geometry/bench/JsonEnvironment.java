package robosim.geometry.bench;

import java.io.BufferedOutputStream;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.json.JsonLines;

/** An environment that speaks JSON lines. */
final class JsonEnvironment implements AutoCloseable {
    private final Socket socket;
    private final OutputStream out;
    private final BufferedReader in;

    /** Dials a server of this machine and greets it. */
    JsonEnvironment(int port) throws IOException {
        socket = new Socket(InetAddress.getLoopbackAddress(), port);
        socket.setTcpNoDelay(true);
        out = new BufferedOutputStream(socket.getOutputStream(), 1 << 16);
        in = new BufferedReader(new InputStreamReader(socket.getInputStream(), StandardCharsets.UTF_8), 1 << 16);
        say("{\"type\":\"hello\",\"version\":" + JsonLines.VERSION + "}");
        in.readLine();
    }

    void say(Bundle bundle) throws IOException {
        say(JsonLines.write(bundle));
    }

    private void say(String line) throws IOException {
        out.write(line.getBytes(StandardCharsets.UTF_8));
        out.write('\n');
        out.flush();
    }

    Bundle ask(Bundle request) throws IOException {
        say(request);
        String line = in.readLine();
        if (line == null) {
            throw new IOException("an answer must come (got: the end)");
        }
        return JsonLines.readReply(line).bundle();
    }

    @Override
    public void close() throws IOException {
        socket.close();
    }
}
