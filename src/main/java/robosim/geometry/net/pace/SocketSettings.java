package robosim.geometry.net.pace;

import java.io.IOException;
import java.net.Socket;
import java.net.SocketOption;

/** What every connection's socket is set to. */
public final class SocketSettings {
    /** How much of an answer may be on its way; more waits, and so does its peer's next request. */
    static final int QUEUE_BYTES = 1 << 17;

    /** An idle peer is asked for a sign of life after a minute, then every 10 seconds, and is gone after 6 of them. */
    private static final int ALIVE_AFTER_SECONDS = 60;

    private static final int ALIVE_EVERY_SECONDS = 10;
    private static final int ALIVE_TIMES = 6;

    private SocketSettings() {}

    public static void apply(Socket socket) throws IOException {
        socket.setTcpNoDelay(true); // answers are small and waited for
        socket.setSendBufferSize(QUEUE_BYTES);
        socket.setKeepAlive(true);
        // By name: their class is in the module jdk.net, which need not be there; nor need the system have them.
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
     * Has the system acknowledge at once what has come. A peer that hands over a message in parts, as a bare
     * ObjectOutputStream does, and has not switched Nagle's algorithm off, holds each part back until the one before it is
     * acknowledged; which a system else puts off for 40 ms, in the hope of an answer that could carry it (RFC 1122,
     * 4.2.3.2 and 4.2.3.4).
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
