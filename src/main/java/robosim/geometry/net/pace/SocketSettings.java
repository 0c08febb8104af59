package robosim.geometry.net.pace;

import java.io.IOException;
import java.net.Socket;
import java.net.SocketOption;

/** The settings of every connection's socket. */
public final class SocketSettings {
    /**
     * How many bytes of answers may be in transit; beyond that the answer waits, and so does the peer's next request.
     */
    static final int QUEUE_BYTES = 1 << 17;

    /**
     * TCP keep-alive: an idle peer is probed after a minute, then every 10 seconds, and counts as gone after 6 probes.
     */
    private static final int ALIVE_AFTER_SECONDS = 60;

    private static final int ALIVE_EVERY_SECONDS = 10;
    private static final int ALIVE_TIMES = 6;

    private SocketSettings() {}

    public static void apply(Socket socket) throws IOException {
        socket.setTcpNoDelay(true); // answers are small and the peer waits for them
        socket.setSendBufferSize(QUEUE_BYTES);
        socket.setKeepAlive(true);
        // Looked up by name: their class is in the module jdk.net, which may be missing, and the system may lack them.
        for (SocketOption<?> option : socket.supportedOptions()) {
            switch (option.name()) {
                case "TCP_KEEPIDLE" -> set(socket, option, ALIVE_AFTER_SECONDS);
                case "TCP_KEEPINTERVAL" -> set(socket, option, ALIVE_EVERY_SECONDS);
                case "TCP_KEEPCOUNT" -> set(socket, option, ALIVE_TIMES);
                default -> {}
            }
        }
    }

    /**
     * Makes the system acknowledge received data at once. A peer that writes a message in parts, as a bare
     * ObjectOutputStream does, and has not disabled Nagle's algorithm, holds each part back until the previous one is
     * acknowledged. By default the system delays that for 40 ms, in case an answer can carry the acknowledgement (RFC
     * 1122, 4.2.3.2 and 4.2.3.4).
     */
    static void acknowledge(Socket socket) throws IOException {
        for (SocketOption<?> option : socket.supportedOptions()) {
            if (option.name().equals("TCP_QUICKACK")) {
                set(socket, option, true);
            }
        }
    }

    private static <T> void set(Socket socket, SocketOption<T> option, Object value) throws IOException {
        socket.setOption(option, option.type().cast(value));
    }
}
