package robosim.geometry.net;

import java.io.IOException;
import java.net.Socket;
import javax.net.ssl.SSLSocket;
import org.jspecify.annotations.Nullable;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MessageChannel;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.ProtocolException;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.SonarRequestBundle;
import robosim.geometry.protocol.Text;

/** One socket and its session, whoever dialled. Whatever comes over it ends here. */
final class Connection implements Runnable {
    private static final System.Logger LOG = System.getLogger(Connection.class.getPackageName());

    /** How long, and how far, a peer is listened to that has erred. */
    private static final long PARTING_NANOS = 500_000_000;

    private static final int PARTING_BYTES = 1 << 20;

    private final Socket socket;
    private final String name;
    private final Surroundings around;
    private final NetOptions options;
    private final @Nullable Cipher cipher;
    private final Watchdog.Guard guard;

    /** The message that is being read or carried out, from 1. */
    private long message;

    private long answers;
    private volatile boolean stopping;

    /** Puts TLS over a connected socket. */
    @FunctionalInterface
    interface Cipher {
        SSLSocket over(Socket plain) throws IOException;
    }

    /**
     * Over that socket.
     *
     * @param cipher null for none
     */
    Connection(Socket socket, String name, Surroundings around, @Nullable Cipher cipher) {
        this.socket = socket;
        this.name = name;
        this.around = around;
        this.options = around.options();
        this.cipher = cipher;
        this.guard = around.watchdog().guard(this::abort);
    }

    /** Answers until the peer ends, errs or is told to stop; then the socket is closed. Nothing is thrown. */
    @Override
    public void run() {
        around.figures().opened();
        LOG.log(System.Logger.Level.DEBUG, name + ": open");
        try {
            converse();
        } catch (ProtocolException e) {
            closed(String.valueOf(e.getMessage()), e);
            partGently();
        } catch (IOException e) {
            closed("the answer could not be sent: " + e.getMessage(), e);
        } catch (RuntimeException | Error e) {
            around.figures().failed();
            LOG.log(
                    System.Logger.Level.ERROR,
                    name + ": closed at message " + message + ", after an error of the module itself",
                    e);
        } finally {
            abort();
            around.figures().closed();
        }
    }

    private void converse() throws IOException {
        SocketSettings.apply(socket);
        if (cipher == null) {
            converse(socket);
            return;
        }
        SSLSocket secured = shakeHands(cipher);
        converse(secured);
        guard.begin(System.nanoTime() + options.patience().stall().toNanos());
        secured.close(); // says so to the peer, and may wait for him
        guard.end();
    }

    private SSLSocket shakeHands(Cipher made) throws ProtocolException {
        guard.begin(System.nanoTime() + options.patience().message().toNanos());
        try {
            socket.setSoTimeout(Math.toIntExact(options.patience().stall().toMillis()));
            SSLSocket secured = made.over(socket);
            secured.startHandshake();
            LOG.log(
                    System.Logger.Level.DEBUG,
                    name + ": is " + secured.getSession().getPeerPrincipal());
            return secured;
        } catch (IOException e) {
            throw new ProtocolException("TLS was not agreed on: " + e.getMessage(), e);
        } finally {
            guard.end();
        }
    }

    private void converse(Socket talk) throws IOException {
        PacedInput in = new PacedInput(socket, talk.getInputStream(), guard, options.patience(), () -> stopping);
        PacedOutput out = new PacedOutput(talk.getOutputStream(), guard, options.patience());
        Porter porter = new Porter(options.access(), in, options.patience());
        MessageChannel channel = new MessageChannel(in, out, options.translator(), in, porter);
        porter.watch(channel);
        SessionListener listener = options.listeners().apply(name);
        try {
            converse(channel, new Session(options.session(), listener, name));
        } finally {
            listener.ended();
        }
    }

    private void converse(MessageChannel channel, Session session) throws IOException {
        message = 1;
        for (Bundle request = channel.read(); request != null; request = channel.read()) {
            long start = System.nanoTime();
            String refusal = refusal(request);
            if (refusal != null) {
                channel.refuse(refusal);
                throw new ProtocolException(refusal);
            }
            Reply reply = reply(channel, session, request);
            around.figures().carriedOut(request, reply);
            if (reply != null) {
                channel.write(reply);
                answers++;
                around.figures().answered(System.nanoTime() - start);
            }
            message++;
        }
        LOG.log(System.Logger.Level.DEBUG, name + ": closed at message " + message + ", its end");
    }

    private static @Nullable Reply reply(MessageChannel channel, Session session, Bundle request) {
        try {
            return session.reply(request);
        } catch (RuntimeException | Error e) {
            channel.refuse("an error of the module itself, which its log tells; a new connection may go on");
            throw e;
        }
    }

    /** Why this cannot be asked here; null where it can. */
    private @Nullable String refusal(Bundle request) {
        Allowance allowance = options.allowance();
        if (request instanceof InitBundle init) {
            return tooMany("a world", "objects", init.objects().size(), allowance.objects());
        }
        if (request instanceof MoveBundle moves) {
            return tooMany("a bundle", "requests", moves.moves().size(), allowance.requests());
        }
        if (request instanceof SonarRequestBundle sonars) {
            return tooMany("a bundle", "requests", sonars.requests().size(), allowance.requests());
        }
        return "a request must be an InitBundle, a MoveBundle or a SonarRequestBundle (got: "
                + request.getClass().getSimpleName() + ")";
    }

    private static @Nullable String tooMany(String whole, String items, int count, int most) {
        return count <= most ? null : whole + " must have at most " + most + " " + items + " (got: " + count + ")";
    }

    private void closed(String reason, Exception e) {
        if (!stopping || guard.isBroken()) {
            around.figures().failed();
            LOG.log(System.Logger.Level.WARNING, name + ": closed at message " + message + ", " + Text.line(reason));
        }
        LOG.log(System.Logger.Level.DEBUG, name + ": in detail", e);
    }

    /** Lets answers arrive that are on their way: closing a socket that has unread bytes takes them back. */
    private void partGently() {
        byte[] rest = new byte[1 << 13];
        long end = System.nanoTime() + PARTING_NANOS;
        try {
            socket.shutdownOutput();
            socket.setSoTimeout((int) (PARTING_NANOS / 1_000_000));
            int got = 0;
            for (int left = PARTING_BYTES; got >= 0 && left > 0 && System.nanoTime() < end; left -= got) {
                got = socket.getInputStream().read(rest);
            }
        } catch (IOException e) {
            LOG.log(System.Logger.Level.DEBUG, name + ": parted from at once", e);
        }
    }

    /** Whether any request was answered. */
    boolean hasAnswered() {
        return answers > 0;
    }

    /** No more is read; what has been read is still answered. */
    void stop() {
        stopping = true;
        try {
            socket.shutdownInput();
        } catch (IOException e) {
            abort(); // not connected, or closed already
        }
    }

    /** Ends at once. */
    void abort() {
        stopping = true;
        guard.close();
        try {
            socket.close();
        } catch (IOException e) {
            LOG.log(System.Logger.Level.DEBUG, name + ": the socket could not be closed", e);
        }
    }
}
