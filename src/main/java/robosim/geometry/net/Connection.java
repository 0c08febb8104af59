package robosim.geometry.net;

import java.io.IOException;
import java.io.ObjectStreamConstants;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.Socket;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Objects;
import java.util.function.LongConsumer;
import java.util.function.Supplier;
import javax.net.ssl.SSLSocket;
import org.jspecify.annotations.Nullable;
import robosim.geometry.WorkLimit;
import robosim.geometry.WorkLimitException;
import robosim.geometry.check.Text;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.net.pace.Admissions;
import robosim.geometry.net.pace.CpuTurn;
import robosim.geometry.net.pace.MessageMemory;
import robosim.geometry.net.pace.PacedInput;
import robosim.geometry.net.pace.PacedOutput;
import robosim.geometry.net.pace.ReadAhead;
import robosim.geometry.net.pace.RequestBudget;
import robosim.geometry.net.pace.SocketSettings;
import robosim.geometry.net.pace.Watchdog;
import robosim.geometry.net.pace.WorldMemory;
import robosim.geometry.net.session.Refused;
import robosim.geometry.net.session.SessionStart;
import robosim.geometry.net.session.WorldRequests;
import robosim.geometry.protocol.BatchRequestBundle;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.ProtocolException;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.SonarRequestBundle;
import robosim.geometry.protocol.StepBundle;
import robosim.geometry.protocol.batch.BatchRequest;
import robosim.geometry.protocol.batch.WorldRequest;
import robosim.geometry.protocol.channel.MessageChannel;
import robosim.geometry.protocol.json.PeerAdmission;
import robosim.geometry.protocol.json.WorldLoader;

/**
 * One socket and its session, whichever end dialled. Nothing that a peer sends can cause a failure beyond this class.
 */
final class Connection implements Runnable {
    private static final System.Logger LOG = System.getLogger(Connection.class.getPackageName());

    /** How long, and for how many bytes, a peer that made an error is still read. */
    private static final long PARTING_NANOS = 500_000_000;

    private static final int PARTING_BYTES = 1 << 20;

    /** A world from a message of at least this many bytes has more objects than can be indexed within one turn. */
    private static final int HEAVY_BYTES = 1 << 20;

    private static final String NO_MEMORY =
            "the module does not have enough memory for this request; ask for less at a time, or"
                    + " give it more (-Xmx); a new connection may go on";

    private final Socket socket;
    private final String name;
    private final ConnectionContext around;
    private final NetOptions options;
    private final @Nullable Cipher cipher;
    private Admissions.Newcomer newcomer;
    private final Watchdog.Guard guard;
    private final CpuTurn turn;
    private final RequestBudget effort;
    private final MessageMemory.Share messageMemory;
    private WorldMemory.Share worldMemory;

    /** What is carried out here; null until there is a session. */
    private KeptSessions.@Nullable Kept own;

    private WorkLimit limit = WorkLimit.of(Long.MAX_VALUE);

    /** Whether the session may go on in another connection. */
    private volatile boolean isSound = true;

    /** The name in the peer's certificate; empty without TLS. */
    private String identity = "";

    /** Both directions; null until TLS is agreed on. */
    private volatile @Nullable MessageChannel channel;

    /** What is being carried out, and since when; null if nothing is. */
    private volatile @Nullable Object request;

    private volatile long requestSince;

    private final Instant opened = Instant.now();
    private long answers;
    private volatile boolean stopping;

    /** What the peer sends; null before it may send requests. */
    private @Nullable ReadAhead bytes;

    private @Nullable OutputStream answering;

    private boolean isJson;

    /** Whether the current request was cut off because the module is shutting down. */
    private volatile boolean ending;

    /** Layers TLS over a connected socket. */
    @FunctionalInterface
    interface Cipher {
        SSLSocket over(Socket plain) throws IOException;
    }

    /** A connection over a socket, with a cipher if it is not null. */
    Connection(Socket socket, String name, ConnectionContext around, @Nullable Cipher cipher) {
        this.socket = socket;
        this.name = name;
        this.around = around;
        this.options = around.options();
        this.cipher = cipher;
        this.newcomer = Admissions.Newcomer.chosen();
        this.guard = around.watchdog().guard(this::abort);
        this.turn = around.turns().turn();
        this.effort = new RequestBudget(turn, options.quotas().time().toNanos(), this::isPeerGone);
        this.messageMemory = around.messageMemory().share();
        this.worldMemory = around.worldMemory().share();
    }

    /** Takes a place among the connections of a server; waits for one if need be. */
    void enter(Admissions admissions, InetAddress from) throws InterruptedException {
        newcomer = admissions.enter(from, options.timeouts().admission().toNanos(), this::isIdle, this::displace);
    }

    /** Gives that place back. */
    void leave() {
        newcomer.leave();
    }

    /**
     * Answers requests until the peer ends the connection, makes an error, or this connection is told to stop; then
     * closes the socket. Throws nothing.
     */
    @Override
    public void run() {
        around.figures().opened();
        LOG.log(System.Logger.Level.DEBUG, name + ": open");
        try {
            converse();
        } catch (CpuTurn.CutOff | ProtocolException e) {
            closed(String.valueOf(e.getMessage()), e);
            partGently();
        } catch (IOException e) {
            closed("the answer could not be sent: " + e.getMessage(), e);
        } catch (OutOfMemoryError e) {
            worldMemory.free(); // and the world, as the session is over
            closed(NO_MEMORY + " (got: " + e + ")", e);
            partGently();
        } catch (RuntimeException | Error e) {
            failed(e);
        } finally {
            abort();
            turn.give();
            worldMemory.free();
            leave();
            around.figures().closed();
        }
    }

    private void failed(Throwable e) {
        around.figures().failed();
        if (around.log().take() >= 0) {
            LOG.log(
                    System.Logger.Level.ERROR,
                    name + ": closed at message " + message() + ", after an error of the module itself",
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
        secured.close(); // tells the peer, and may wait for it
        guard.end();
    }

    private SSLSocket shakeHands(Cipher made) throws ProtocolException {
        guard.begin(
                newcomer.isAdmitted()
                        ? System.nanoTime() + options.timeouts().message().toNanos()
                        : newcomer.due());
        try {
            socket.setSoTimeout(Math.toIntExact(options.timeouts().stall().toMillis()));
            SSLSocket secured = made.over(socket);
            secured.startHandshake();
            String refusal = Tls.refusal(secured);
            if (refusal != null) {
                secured.getOutputStream().write(MessageChannel.errorLine(refusal));
                secured.close();
                throw new ProtocolException(refusal);
            }
            identity = secured.getSession().getPeerPrincipal().getName();
            LOG.log(System.Logger.Level.DEBUG, name + ": is " + identity);
            return secured;
        } catch (ProtocolException e) {
            throw e;
        } catch (IOException e) {
            String reason = guard.isBroken() ? "the peer took too long" : e.getMessage();
            throw new ProtocolException("TLS was not agreed on: " + reason, e);
        } finally {
            guard.end();
        }
    }

    private void converse(Socket talk) throws IOException {
        Timeouts times = options.timeouts();
        ReadAhead ahead = new ReadAhead(talk, talk.getInputStream());
        bytes = ahead;
        answering = talk.getOutputStream();
        PacedInput in = new PacedInput(
                socket,
                ahead,
                guard,
                times.idle(),
                times.stall(),
                times.message(),
                turn,
                messageMemory,
                () -> stopping);
        PacedOutput out = new PacedOutput(talk.getOutputStream(), guard, times.stall(), times.message(), turn);
        in.from(newcomer);
        if (options.access().hasSecret()) {
            in.mayIdle(times.stall());
        }
        MessageChannel channel = new MessageChannel(in, out, options.translator(), in, new PeerAdmission() {
            @Override
            public boolean admits(@Nullable String secret) throws ProtocolException {
                return isAdmitted(in, secret);
            }

            @Override
            public @Nullable Resumption resume(String token) throws ProtocolException {
                return around.kept().isEnabled() ? resumed(token) : PeerAdmission.OPEN.resume(token);
            }
        });
        this.channel = channel;
        limit = WorkLimit.of(options.quotas().work()).pausing(effort::breathe);
        channel.loadBy(load -> load(load, channel, limit.meter("a request")::take));
        channel.onWrongRequest(reason -> warn("answered with an error: " + Text.line(reason)));
        if (!around.kept().isEnabled()) {
            own(); // else the hello decides
        }
        try {
            converse(channel, in);
        } finally {
            letGo(own());
        }
    }

    /** The session of this connection, which is a new one unless its peer has resumed another. */
    private KeptSessions.Kept own() {
        KeptSessions.Kept present = own;
        if (present == null) {
            SessionListener listener = options.listeners().apply(name);
            present =
                    carry(new KeptSessions.Kept(new Session(options.session(), listener, name), listener, worldMemory));
        }
        return present;
    }

    private KeptSessions.Kept carry(KeptSessions.Kept kept) {
        kept.session
                .pausing(effort::breathe, around.log())
                .numbered(this::message)
                .within(limit);
        own = kept;
        worldMemory = kept.memory;
        return kept;
    }

    private PeerAdmission.Resumption resumed(String token) throws ProtocolException {
        InetAddress from = socket.getInetAddress();
        if (token.isEmpty()) {
            return new PeerAdmission.Resumption(around.kept().begin(own(), this::abort, from, identity), null);
        }
        KeptSessions.Kept kept = carry(around.kept().resume(token, this::abort, from, identity));
        around.log().log(LOG, System.Logger.Level.INFO, name + ": resumes a session");
        return new PeerAdmission.Resumption(token, kept.lastId);
    }

    private void letGo(KeptSessions.Kept kept) {
        boolean isKept = around.kept().release(kept, isSound);
        own = null;
        worldMemory = around.worldMemory().share(); // from here on the session may be that of another connection
        if (!isKept) {
            kept.end();
        }
    }

    /** Whether the peer is admitted, by its encoding and its secret; until it is, shorter timeouts hold. */
    private boolean isAdmitted(PacedInput in, @Nullable String secret) throws ProtocolException {
        boolean isJava = channel != null && channel.encoding() == MessageChannel.Encoding.JAVA;
        boolean isAdmitted =
                isJava ? options.access().admitsJava() : options.access().admitsJson(secret);
        if (isAdmitted) {
            in.mayIdle(options.timeouts().idle());
            if (!isJava) {
                newcomer.admit(); // a hello is a complete message; one of Java has begun
            }
        }
        return isAdmitted;
    }

    private void converse(MessageChannel channel, PacedInput in) throws IOException {
        for (Bundle request = channel.read(); request != null; request = channel.read()) {
            long start = System.nanoTime();
            begin(request, start);
            newcomer.admit();
            KeptSessions.Kept kept = own();
            Session session = kept.session;
            if (kept.isNew && !(request instanceof InitBundle)) {
                open(channel, session);
                kept.isNew = false;
            }
            String refusal = refusal(request, channel.messageBytes(), session.objectCount());
            if (refusal != null && channel.encoding() == MessageChannel.Encoding.JSON) {
                warn("answered message " + message() + " with an error: " + Text.line(refusal));
                channel.answerError(refusal);
                this.request = null;
                continue;
            }
            refuse(channel, refusal);
            kept.isNew = false;
            if (request instanceof BatchRequestBundle batch) {
                in.needs(batch.workBytes());
            }
            int before = session.objectCount();
            Reply reply;
            try {
                reply = reply(channel, session, request, channel.messageBytes());
                kept.lastId = channel.id();
            } catch (WorkLimitException | RequestBudget.Overtime e) {
                String reason = Text.line(String.valueOf(e.getMessage()));
                warn("message " + message() + " was not carried out: " + reason);
                around.figures().failed();
                reply = channel.answerError(reason) ? null : Refused.of(request);
            }
            if (session.objectCount() < before && request instanceof BatchRequestBundle) {
                worldMemory.shrink(session.objectCount(), before);
            }
            around.figures().carriedOut(request, reply);
            if (reply != null) {
                channel.write(reply);
                in.answered();
                answers++;
                around.figures().answered(System.nanoTime() - start);
            }
            this.request = null;
        }
        LOG.log(System.Logger.Level.DEBUG, name + ": closed at message " + message() + ", its end");
    }

    /** The number of the message that is awaited, read or carried out, as its peer counts them, from 1. */
    private long message() {
        MessageChannel present = channel;
        return present == null ? 1 : present.messageNumber();
    }

    private void begin(Object next, long start) {
        requestSince = start;
        request = next;
    }

    private static void refuse(MessageChannel channel, @Nullable String refusal) throws ProtocolException {
        if (refusal != null) {
            channel.refuse(refusal);
            throw new ProtocolException(refusal);
        }
    }

    /** Makes the world with which connections begin; only now, when the peer has been admitted and needs one. */
    private void open(MessageChannel channel, Session session) throws IOException {
        SessionStart opening = around.opening();
        if (!opening.requests().isEmpty()) {
            refuse(channel, claimed(() -> worldMemory.claim(opening.bytes())));
            for (Bundle request : opening.requests()) {
                reply(channel, session, request, opening.bytes());
            }
        }
    }

    /** Whether the peer has ended the connection, and not only its own side of it, as one may that waits for answers. */
    private boolean isPeerGone() {
        ReadAhead ahead = bytes;
        if (ahead == null || stopping || !ahead.isEnded()) { // stopping ends that side here
            return false;
        }
        return ahead.hasFailed() || !isReachable();
    }

    /** Sends a byte that means nothing before an answer; whoever is gone does not take it, or at least not the next one. */
    private boolean isReachable() {
        OutputStream out = answering;
        guard.begin(System.nanoTime() + options.timeouts().stall().toNanos());
        try {
            if (out != null) {
                out.write(isJson ? ' ' : ObjectStreamConstants.TC_RESET);
                out.flush();
            }
            return true;
        } catch (IOException e) {
            return false;
        } finally {
            guard.end();
        }
    }

    private @Nullable Reply reply(MessageChannel channel, Session session, Bundle request, int bytes)
            throws IOException {
        isJson = channel.encoding() == MessageChannel.Encoding.JSON;
        Reply reply = limited(channel, () -> session.reply(request));
        if (request instanceof InitBundle && bytes >= HEAVY_BYTES) {
            turn.heavy(); // the first queries build its indexes
        }
        return reply;
    }

    /** Reads a world file for the peer, which speaks JSON; what the file would exceed is answered as a mistake in it is. */
    private WorldLoader.Loaded load(WorldLoader.Load load, MessageChannel channel, LongConsumer work)
            throws IOException {
        begin(load, System.nanoTime());
        newcomer.admit();
        isJson = true;
        try {
            WorldLoader.Loaded loaded = limited(channel, () -> {
                try {
                    return options.worlds().load(load, work);
                } catch (IllegalArgumentException e) { // what is asked for cannot be
                    throw new IOException(String.valueOf(e.getMessage()), e);
                }
            });
            return Objects.requireNonNull(loaded, "what a loader returns");
        } catch (WorkLimitException | RequestBudget.Overtime e) {
            around.figures().failed();
            throw new IOException(Text.line(String.valueOf(e.getMessage())), e);
        } finally {
            this.request = null;
        }
    }

    @FunctionalInterface
    private interface Part<T> {
        @Nullable
        T carryOut() throws IOException;
    }

    /** Carries out a part of a request within its limits; if the connection ends instead, the peer is told why. */
    private <T> @Nullable T limited(MessageChannel channel, Part<T> part) throws IOException {
        try {
            effort.begin();
            return part.carryOut();
        } catch (CpuTurn.CutOff e) {
            String reason = ending ? "the module is shutting down" : String.valueOf(e.getMessage());
            channel.refuse(reason + ": message " + message() + " was cut off, and has no answer");
            throw e;
        } catch (WorkLimitException | RequestBudget.Overtime e) {
            throw e; // the conversation goes on
        } catch (OutOfMemoryError e) {
            isSound = false;
            channel.refuse(NO_MEMORY);
            throw e;
        } catch (RuntimeException | Error e) {
            isSound = false;
            channel.refuse("an internal error of the module, described in its log; you may connect again");
            throw e;
        }
    }

    /** Why a request is not allowed; null if it is allowed. */
    private @Nullable String refusal(Bundle request, int messageBytes, int objects) {
        Quotas quotas = options.quotas();
        if (request instanceof InitBundle init) {
            String tooMany = tooMany("a world", "objects", WorldRequests.count(init.objects()), quotas.objects());
            return tooMany == null ? claimed(() -> worldMemory.claim(messageBytes)) : tooMany;
        }
        if (request instanceof MoveBundle moves) {
            return tooMany("a bundle", "requests", moves.moves().size(), quotas.requests());
        }
        if (request instanceof SonarRequestBundle sonars) {
            return tooMany("a bundle", "requests", sonars.requests().size(), quotas.requests());
        }
        if (request instanceof BatchRequestBundle batch) {
            int additions = additions(batch);
            String tooMany = tooMany("a bundle", "beams, poses, edges and pixels", batch.size(), quotas.requests());
            tooMany = tooMany == null && additions > 0
                    ? tooMany("a world", "objects", objects + additions, quotas.objects())
                    : tooMany;
            return tooMany == null && additions > 0 ? claimed(() -> worldMemory.claimMore(messageBytes)) : tooMany;
        }
        if (request instanceof StepBundle step) {
            return tooMany("a bundle", "bodies and commands", step.size(), quotas.requests());
        }
        return "a request must be an InitBundle, a MoveBundle, a SonarRequestBundle, a BatchRequestBundle or a"
                + " StepBundle (got: "
                + request.getClass().getSimpleName() + ")";
    }

    /** Claims memory for a world, before which sessions without a peer have to go. */
    private @Nullable String claimed(Supplier<@Nullable String> claim) {
        String refusal = claim.get();
        while (refusal != null && around.kept().makeRoom()) {
            refusal = claim.get();
        }
        return refusal;
    }

    private static int additions(BatchRequestBundle batch) {
        int additions = 0;
        for (BatchRequest request : batch.requests()) {
            GeometryObject added = request instanceof WorldRequest about ? about.addition() : null;
            additions += added == null ? 0 : WorldRequests.count(List.of(added));
        }
        return additions;
    }

    private static @Nullable String tooMany(String whole, String items, int count, int most) {
        return count <= most ? null : whole + " must have at most " + most + " " + items + " (got: " + count + ")";
    }

    private void closed(String reason, Throwable e) {
        if (ending) {
            warn("closed at message " + message()
                    + ", which was cut off and has no answer, as the module is shutting down");
        } else if (!stopping || guard.isBroken()) {
            around.figures().failed();
            warn("closed at message " + message() + ", " + Text.line(reason));
        }
        LOG.log(System.Logger.Level.DEBUG, name + ": in detail", e);
    }

    private void warn(String words) {
        around.log().log(LOG, System.Logger.Level.WARNING, name + ": " + words);
    }

    /** Lets answers under way arrive: closing a socket that has unread bytes would discard them. */
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

    GeometryServer.Peer report(long id) {
        Object present = request;
        Duration age = present == null ? Duration.ZERO : Duration.ofNanos(System.nanoTime() - requestSince);
        String kind = present == null ? null : present.getClass().getSimpleName();
        return new GeometryServer.Peer(
                id,
                String.valueOf(socket.getRemoteSocketAddress()),
                opened,
                newcomer.isAdmitted(),
                message(),
                kind,
                age);
    }

    /** Ends the connection because an operator wants that. */
    void end() {
        warn("ended by an operator at message " + message());
        isSound = false;
        abort();
    }

    /** Whether this connection waits for bytes of its peer and none have come. */
    private boolean isIdle() {
        try {
            return guard.isRunning() && socket.getInputStream().available() == 0;
        } catch (IOException e) {
            return true; // closed
        }
    }

    /** Makes room for another peer before this one was admitted. */
    void displace() {
        around.figures().refused();
        warn("closed before it was admitted, to make room for others: at most " + Admissions.MOST
                + " connections, and " + Admissions.MOST_FROM_ONE
                + " from another machine, may be without a first message");
        abort();
    }

    /** Whether any request has been answered. */
    boolean hasAnswered() {
        return answers > 0;
    }

    /** Stops reading; requests already read are still answered. */
    void stop() {
        stopping = true;
        try {
            socket.shutdownInput();
        } catch (IOException e) {
            abort(); // not connected, or closed already
        }
    }

    /** Drops requests that are not answered yet, and tells the peer. */
    void cutOff() {
        ending = true;
        stopping = true;
        turn.cutOff();
        messageMemory.close();
    }

    /** Ends the connection at once. */
    void abort() {
        stopping = true;
        guard.close();
        turn.cutOff();
        messageMemory.close();
        try {
            socket.close();
        } catch (IOException e) {
            LOG.log(System.Logger.Level.DEBUG, name + ": the socket could not be closed", e);
        }
    }
}
