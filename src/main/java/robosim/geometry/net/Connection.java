package robosim.geometry.net;

import java.io.IOException;
import java.net.Socket;
import javax.net.ssl.SSLSocket;
import org.jspecify.annotations.Nullable;
import robosim.geometry.net.pace.PacedInput;
import robosim.geometry.net.pace.PacedOutput;
import robosim.geometry.net.pace.Room;
import robosim.geometry.net.pace.SocketSettings;
import robosim.geometry.net.pace.Turn;
import robosim.geometry.net.pace.Watchdog;
import robosim.geometry.net.pace.Worlds;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.ProtocolException;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.SonarRequestBundle;
import robosim.geometry.protocol.Text;
import robosim.geometry.protocol.channel.MessageChannel;

/** One socket and its session, whoever dialled. Whatever comes over it ends here. */
final class Connection implements Runnable {
    private static final System.Logger LOG = System.getLogger(Connection.class.getPackageName());

    /** How long, and how far, a peer is listened to that has erred. */
    private static final long PARTING_NANOS = 500_000_000;

    private static final int PARTING_BYTES = 1 << 20;

    /** A world from a message of so many bytes has more objects than can be put into an index within a turn. */
    private static final int HEAVY_BYTES = 1 << 20;

    private static final String NO_MEMORY =
            "the module has not enough memory for this request; ask for less at a time, or"
                    + " give it more (-Xmx); a new connection may go on";

    private final Socket socket;
    private final String name;
    private final ConnectionContext around;
    private final NetOptions options;
    private final @Nullable Cipher cipher;
    private final Watchdog.Guard guard;
    private final Turn turn;
    private final Room.Share room;
    private final Worlds.Plot plot;

    /** The message that is being read or carried out, from 1. */
    private long message;

    private long answers;
    private volatile boolean stopping;

    /** Whether what it does was cut off because the module is ending. */
    private volatile boolean ending;

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
    Connection(Socket socket, String name, ConnectionContext around, @Nullable Cipher cipher) {
        this.socket = socket;
        this.name = name;
        this.around = around;
        this.options = around.options();
        this.cipher = cipher;
        this.guard = around.watchdog().guard(this::abort);
        this.turn = around.turns().turn();
        this.room = around.room().share();
        this.plot = around.worlds().plot();
    }

    /** Answers until the peer ends, errs or is told to stop; then the socket is closed. Nothing is thrown. */
    @Override
    public void run() {
        around.figures().opened();
        LOG.log(System.Logger.Level.DEBUG, name + ": open");
        try {
            converse();
        } catch (Turn.CutOff e) {
            closed("cut off", e);
            partGently();
        } catch (ProtocolException e) {
            closed(String.valueOf(e.getMessage()), e);
            partGently();
        } catch (IOException e) {
            closed("the answer could not be sent: " + e.getMessage(), e);
        } catch (OutOfMemoryError e) {
            plot.free(); // and the world with it: the session is no more
            closed(NO_MEMORY + " (got: " + e + ")", e);
            partGently();
        } catch (RuntimeException | Error e) {
            failed(e);
        } finally {
            abort();
            turn.give();
            plot.free();
            around.figures().closed();
        }
    }

    private void failed(Throwable e) {
        around.figures().failed();
        if (around.log().take() >= 0) {
            LOG.log(
                    System.Logger.Level.ERROR,
                    name + ": closed at message " + message + ", after an error of the module itself",
                    e);
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
        guard.begin(System.nanoTime() + options.timeouts().stall().toNanos());
        secured.close(); // says so to the peer, and may wait for him
        guard.end();
    }

    private SSLSocket shakeHands(Cipher made) throws ProtocolException {
        guard.begin(System.nanoTime() + options.timeouts().message().toNanos());
        try {
            socket.setSoTimeout(Math.toIntExact(options.timeouts().stall().toMillis()));
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
        Timeouts times = options.timeouts();
        PacedInput in = new PacedInput(
                socket,
                talk.getInputStream(),
                guard,
                times.idle(),
                times.stall(),
                times.message(),
                turn,
                room,
                () -> stopping);
        PacedOutput out = new PacedOutput(talk.getOutputStream(), guard, times.stall(), times.message(), turn);
        Authenticator authenticator = new Authenticator(options.access(), in, times);
        MessageChannel channel = new MessageChannel(in, out, options.translator(), in, authenticator);
        authenticator.watch(channel);
        SessionListener listener = options.listeners().apply(name);
        try {
            Session session = new Session(options.session(), listener, name);
            converse(channel, session.pausing(turn::breathe, around.log()));
        } finally {
            listener.ended();
        }
    }

    private void converse(MessageChannel channel, Session session) throws IOException {
        message = 1;
        for (Bundle request = channel.read(); request != null; request = channel.read()) {
            long start = System.nanoTime();
            String refusal = refusal(request, channel.messageBytes());
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

    private @Nullable Reply reply(MessageChannel channel, Session session, Bundle request) {
        try {
            Reply reply = session.reply(request);
            if (request instanceof InitBundle && channel.messageBytes() >= HEAVY_BYTES) {
                turn.heavy(); // the first questions about it make its indexes
            }
            return reply;
        } catch (Turn.CutOff e) {
            channel.refuse("the module is ending: message " + message + " was cut off, and has no answer");
            throw e;
        } catch (OutOfMemoryError e) {
            channel.refuse(NO_MEMORY);
            throw e;
        } catch (RuntimeException | Error e) {
            channel.refuse("an error of the module itself, which its log tells; a new connection may go on");
            throw e;
        }
    }

    /** Why this cannot be asked here; null where it can. */
    private @Nullable String refusal(Bundle request, int messageBytes) {
        Quotas quotas = options.quotas();
        if (request instanceof InitBundle init) {
            String tooMany = tooMany("a world", "objects", init.objects().size(), quotas.objects());
            return tooMany == null ? plot.claim(messageBytes) : tooMany;
        }
        if (request instanceof MoveBundle moves) {
            return tooMany("a bundle", "requests", moves.moves().size(), quotas.requests());
        }
        if (request instanceof SonarRequestBundle sonars) {
            return tooMany("a bundle", "requests", sonars.requests().size(), quotas.requests());
        }
        return "a request must be an InitBundle, a MoveBundle or a SonarRequestBundle (got: "
                + request.getClass().getSimpleName() + ")";
    }

    private static @Nullable String tooMany(String whole, String items, int count, int most) {
        return count <= most ? null : whole + " must have at most " + most + " " + items + " (got: " + count + ")";
    }

    private void closed(String reason, Throwable e) {
        if (ending) {
            warn("closed at message " + message + ", which was cut off and has no answer, as the module is ending");
        } else if (!stopping || guard.isBroken()) {
            around.figures().failed();
            warn("closed at message " + message + ", " + Text.line(reason));
        }
        LOG.log(System.Logger.Level.DEBUG, name + ": in detail", e);
    }

    private void warn(String words) {
        around.log().log(LOG, System.Logger.Level.WARNING, name + ": " + words);
    }

    /** Lets answers arrive that are on their way: closing a socket that has unread bytes takes them back. */
    private void partGently() {
        turn.give();
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

    /** What has not been answered by now is not answered any more; the peer is told. */
    void cutOff() {
        ending = true;
        stopping = true;
        turn.cutOff();
        room.close();
    }

    /** Ends at once. */
    void abort() {
        stopping = true;
        guard.close();
        turn.cutOff();
        room.close();
        try {
            socket.close();
        } catch (IOException e) {
            LOG.log(System.Logger.Level.DEBUG, name + ": the socket could not be closed", e);
        }
    }
}
