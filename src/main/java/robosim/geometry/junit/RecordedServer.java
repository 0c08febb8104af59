package robosim.geometry.junit;

import java.io.ByteArrayOutputStream;
import java.net.InetAddress;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.net.GeometryServer;
import robosim.geometry.net.NetOptions;
import robosim.geometry.net.SessionListener;
import robosim.geometry.net.SessionOptions;
import robosim.geometry.scenario.Recordings;
import robosim.geometry.scenario.ScenarioHeader;

/** The server of one test, and the recordings of its connections. */
final class RecordedServer {
    private final List<ByteArrayOutputStream> recordings = new ArrayList<>();
    private @Nullable GeometryServer server;

    /** The server, which starts to listen at the first call. */
    GeometryServer server() {
        if (server == null) {
            NetOptions options = NetOptions.defaults().withListeners(this::record);
            server = new GeometryServer(InetAddress.getLoopbackAddress(), 0, options);
        }
        return server;
    }

    /** Called on a connection's own thread. */
    private SessionListener record(String connection) {
        ByteArrayOutputStream recording = new ByteArrayOutputStream();
        synchronized (recordings) {
            recordings.add(recording);
        }
        ScenarioHeader header = new ScenarioHeader(connection, SessionOptions.ROBOSIM);
        return Recordings.ofSession(recording, header);
    }

    /** The recordings so far, in the order of the connections; empty for a connection without requests. */
    List<byte[]> recorded() {
        synchronized (recordings) {
            return recordings.stream().map(ByteArrayOutputStream::toByteArray).toList();
        }
    }

    void close() {
        if (server != null) {
            server.close();
        }
    }
}
