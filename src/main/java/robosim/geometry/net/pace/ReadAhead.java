package robosim.geometry.net.pace;

import java.io.IOException;
import java.io.InputStream;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.util.Arrays;

/** The bytes of a peer, of which some may be read ahead to learn whether it is still there. */
public final class ReadAhead extends InputStream {
    /** A peer that has sent more meanwhile counts as there. */
    private static final int MOST = 1 << 16;

    private final Socket socket;
    private final InputStream in;
    private byte[] ahead = new byte[0];
    private int at;
    private int end;
    private boolean isEnded;
    private boolean hasFailed;

    /** Reads the bytes that come from a socket, decrypted if need be. */
    public ReadAhead(Socket socket, InputStream in) {
        this.socket = socket;
        this.in = in;
    }

    /** Whether the connection has failed, as where the peer was ended. */
    public boolean hasFailed() {
        return hasFailed;
    }

    /** Whether the peer has ended its side of the connection, or that has failed; waits for a millisecond at most. */
    public boolean isEnded() {
        while (!isEnded && end - at < MOST) {
            if (at == end) {
                at = 0;
                end = 0;
            }
            if (end == ahead.length) {
                ahead = Arrays.copyOf(ahead, Math.max(1 << 12, 2 * end));
            }
            try {
                socket.setSoTimeout(1); // whoever reads next sets its own
                int got = in.read(ahead, end, ahead.length - end);
                isEnded = got < 0;
                end += Math.max(0, got);
            } catch (SocketTimeoutException e) {
                return false;
            } catch (IOException e) {
                isEnded = true;
                hasFailed = true;
            }
        }
        return isEnded;
    }

    @Override
    public int available() throws IOException {
        return end - at + (isEnded ? 0 : in.available());
    }

    @Override
    public int read() throws IOException {
        byte[] one = new byte[1];
        return read(one, 0, 1) < 0 ? -1 : one[0] & 0xff;
    }

    @Override
    public int read(byte[] into, int to, int length) throws IOException {
        if (at == end) {
            return isEnded ? -1 : in.read(into, to, length);
        }
        int count = Math.min(length, end - at);
        System.arraycopy(ahead, at, into, to, count);
        at += count;
        if (at == end) {
            ahead = new byte[0];
            at = 0;
            end = 0;
        }
        return count;
    }
}
