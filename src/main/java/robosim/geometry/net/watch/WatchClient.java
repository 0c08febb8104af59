package robosim.geometry.net.watch;

import java.io.FilterInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.SocketTimeoutException;
import robosim.geometry.check.Checks;

/** Dials a {@link WatchServer} and reads what it reports. Sends nothing. */
public final class WatchClient {
    private static final int TIMEOUT_MILLIS = 10_000;

    private WatchClient() {}

    /**
     * Dials.
     *
     * @return the lines; closing the stream hangs up. If the server is silent for 10 seconds, reading throws
     * @throws IOException if the server cannot be reached
     */
    public static InputStream dial(String host, int port) throws IOException {
        Checks.present("host", host);
        Checks.port(port, 1);
        Socket socket = new Socket();
        try {
            socket.connect(new InetSocketAddress(host, port), TIMEOUT_MILLIS);
            socket.setSoTimeout(TIMEOUT_MILLIS);
            socket.shutdownOutput();
            return new Hearing(socket);
        } catch (IOException | RuntimeException e) {
            socket.close();
            throw new IOException(
                    "cannot watch " + host + ":" + port + ": " + e.getMessage() + "; is there a server with --watch "
                            + port + "?",
                    e);
        }
    }

    /** A socket's input whose exception says that the other end is silent. */
    private static final class Hearing extends FilterInputStream {
        private final Socket socket;

        Hearing(Socket socket) throws IOException {
            super(socket.getInputStream());
            this.socket = socket;
        }

        @Override
        public int read() throws IOException {
            byte[] single = new byte[1];
            return read(single, 0, 1) < 0 ? -1 : single[0] & 0xff;
        }

        @Override
        public int read(byte[] bytes, int at, int length) throws IOException {
            try {
                return super.read(bytes, at, length);
            } catch (SocketTimeoutException e) {
                throw new IOException(
                        "nothing was received for " + TIMEOUT_MILLIS / 1000
                                + " s; the server is gone, or this is not its port for watching",
                        e);
            }
        }

        @Override
        public void close() throws IOException {
            socket.close();
        }
    }
}
