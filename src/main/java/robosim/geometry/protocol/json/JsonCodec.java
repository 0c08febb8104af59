package robosim.geometry.protocol.json;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.InterruptedIOException;
import java.io.OutputStream;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.check.Text;
import robosim.geometry.protocol.BatchAnswerBundle;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MessageLimits;
import robosim.geometry.protocol.ProtocolException;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.batch.WorldAnswer;
import robosim.geometry.protocol.pace.MessagePace;

/**
 * A connection in JSON lines: a hello first, then requests and pings. A line that is JSON but no request that can be carried
 * out is answered here with an error, and the next one is read; the rest ends the connection.
 */
public final class JsonCodec {
    private final LineInput lines;

    /** The output, which is also the lock for writing a message. */
    private final OutputStream target;

    private final OutputStream buffered;
    private final PeerAdmission gate;
    private final Consumer<String> wrongRequests;
    private final WorldLoader worlds;
    private boolean admitted;

    /** The id of the last message, a String or a Long, which its answer repeats; null if it has none. */
    private @Nullable Object id;

    /** What the last line asks besides. */
    private final Deque<Bundle> followUps = new ArrayDeque<>();

    /** Whether the bundle that was read last is a part of a load, of whose answer only the problems are told, at its end. */
    private boolean isPart;

    /** What a load has left out. */
    private final List<WorldAnswer.LeftOut> leftOut = new ArrayList<>();

    private int messageBytes;

    /** The id of the last message, a String or a Long; null for a message without an id. */
    public @Nullable Object id() {
        return id;
    }

    /** The number of the line that is awaited or was read last. */
    private volatile int message = 1;

    private JsonCodec(
            InputStream in,
            OutputStream out,
            MessagePace pace,
            PeerAdmission gate,
            WorldLoader worlds,
            Consumer<String> wrongRequests) {
        this.lines = new LineInput(in, pace);
        this.target = out;
        this.buffered = new BufferedOutputStream(out, 8192);
        this.gate = gate;
        this.worlds = worlds;
        this.wrongRequests = wrongRequests;
    }

    /**
     * A codec for a connection of which nothing has been read.
     *
     * @param worlds        reads world files for the peer
     * @param wrongRequests takes the reason of each error with which a wrong request is answered here
     * @throws LinkageError if Jackson is missing
     */
    public static JsonCodec open(
            InputStream in,
            OutputStream out,
            MessagePace pace,
            PeerAdmission gate,
            WorldLoader worlds,
            Consumer<String> wrongRequests) {
        Checks.present("in", in);
        Checks.present("out", out);
        Checks.present("pace", pace);
        Checks.present("gate", gate);
        Checks.present("worlds", worlds);
        Checks.present("wrongRequests", wrongRequests);
        JsonInput.FACTORY.version(); // fails here rather than within a message
        return new JsonCodec(in, out, pace, gate, worlds, wrongRequests);
    }

    /**
     * The next bundle, once all hellos, pings and wrong requests before it have been answered; null at the end of the stream.
     *
     * @throws ProtocolException if the bytes are not a message, the peer is not admitted, or the stream fails
     */
    public @Nullable Bundle read() throws ProtocolException {
        Bundle next = followUps.poll();
        if (next != null) {
            isPart = !followUps.isEmpty();
            messageBytes = 0;
            return next;
        }
        isPart = false;
        leftOut.clear();
        try {
            Bundle request = null;
            while (request == null) {
                message = lines.number() + 1;
                if (!lines.await(admitted ? MessageLimits.MAX_MESSAGE_BYTES : MessageLimits.MAX_HELLO_BYTES)) {
                    return null;
                }
                request = message();
            }
            return request;
        } catch (ProtocolException e) {
            throw new ProtocolException("line " + lines.number() + ", " + e.getMessage(), e.getCause());
        } catch (InterruptedIOException e) {
            throw new ProtocolException(
                    "line " + lines.number() + ", a message stalled after " + lines.count() + " bytes of it", e);
        } catch (IOException e) {
            throw new ProtocolException(
                    "line " + lines.number() + ", the connection failed: " + Text.line(e.toString()), e);
        }
    }

    /** Reads one message; null if it was answered here. */
    private @Nullable Bundle message() throws IOException {
        if (!admitted) {
            hello();
            messageBytes = lines.count();
            return null;
        }
        id = null;
        Object message;
        try {
            message = JsonLines.guardedAsItComes(this::decode);
        } catch (ProtocolException e) {
            if (!e.isAboutRequest()) {
                throw e;
            }
            refuseLine(String.valueOf(e.getMessage()));
            return null;
        }
        messageBytes = lines.count();
        if (message instanceof WorldLoader.Load load) {
            return load(load);
        }
        if (message instanceof JsonMessages.Ping) {
            send(out -> JsonMessages.writePong(out, id));
            return null;
        }
        return (Bundle) message;
    }

    private void refuseLine(String reason) throws IOException {
        String told = "line " + lines.number() + ", " + reason;
        wrongRequests.accept(told); // first, so that the log has it when the peer has its answer
        refuse(told);
    }

    /** Reads a world file, whose world comes as several bundles; null if it cannot be read, which has been answered. */
    private @Nullable Bundle load(WorldLoader.Load load) throws IOException {
        WorldLoader.Loaded loaded;
        try {
            loaded = worlds.load(load);
        } catch (ProtocolException e) { // the peer is not admitted
            throw e;
        } catch (IOException | IllegalArgumentException e) {
            refuseLine(String.valueOf(e.getMessage()));
            return null;
        }
        messageBytes = Math.max(messageBytes, loaded.bytes());
        leftOut.addAll(loaded.leftOut());
        followUps.addAll(loaded.requests().subList(1, loaded.requests().size()));
        followUps.add(InitBundle.Answered.QUESTION);
        return loaded.requests().get(0);
    }

    /** Answers the last message that was read with an error, after which the conversation goes on. */
    public void refuse(String reason) throws IOException {
        Checks.present("reason", reason);
        followUps.clear();
        send(out -> JsonMessages.writeError(out, Text.line(reason), id));
    }

    private Object decode() throws IOException {
        if (lines.isWhole()) {
            return decode(lines.buffer(), lines.start(), lines.length());
        }
        String type = JsonMessages.firstTypeOf(JsonInput.of(lines.buffer(), lines.start(), lines.length()));
        if (type == null) { // it may be at the end
            byte[] line = lines.gather();
            return decode(line, 0, line.length);
        }
        try (JsonInput in = JsonInput.of(lines.characters())) {
            return message(type, in);
        }
    }

    private Object decode(byte[] bytes, int at, int length) throws IOException {
        String type = "";
        ProtocolException untyped = null;
        try {
            type = JsonMessages.typeOf(JsonInput.of(bytes, at, length));
        } catch (ProtocolException e) {
            if (!e.isAboutRequest()) {
                throw e;
            }
            untyped = e;
        }
        try (JsonInput in = JsonInput.of(bytes, at, length)) {
            if (untyped != null) {
                throw rest(in, untyped);
            }
            return message(type, in);
        }
    }

    /** Decodes a message; of one that is wrong, the rest of the line is read as well. */
    private Object message(String type, JsonInput in) throws IOException {
        try {
            Object message = typed(type, in);
            id = in.id();
            return message;
        } catch (ProtocolException e) {
            throw e.isAboutRequest() ? rest(in, e) : e;
        } catch (IllegalArgumentException e) {
            throw rest(in, ProtocolException.ofRequest(String.valueOf(e.getMessage()), e));
        }
    }

    /** Reads on to the end of a wrong message: its id may be there, and what is not JSON. */
    private ProtocolException rest(JsonInput in, ProtocolException problem) throws IOException {
        in.skipRest();
        id = in.id();
        return problem;
    }

    private Object typed(String type, JsonInput in) throws IOException {
        if (type.equals("hello")) {
            throw ProtocolException.ofRequest("a hello must come once, as the first message (got: another)", null);
        }
        Object message = JsonMessages.request(type, in);
        if (message instanceof InitBundle.Answered asked) {
            followUps.add(InitBundle.Answered.QUESTION);
            return asked.init();
        }
        return message;
    }

    private void hello() throws IOException {
        JsonMessages.Hello hello;
        try {
            hello = JsonLines.guarded(this::decodeHello);
        } catch (ProtocolException e) {
            throw new ProtocolException(String.valueOf(e.getMessage())); // without a cause, which might repeat the line
        } finally {
            lines.wipe();
        }
        if (!gate.admits(hello.secret())) {
            throw new ProtocolException(
                    hello.secret() == null
                            ? "a hello must have the field \"secret\" here (got: none)"
                            : "the secret must be the one that this module was given (got: another)");
        }
        String token = hello.resume();
        PeerAdmission.Resumption resumption = token == null ? null : gate.resume(token);
        admitted = true;
        send(out -> JsonMessages.writeHello(out, resumption));
    }

    private JsonMessages.Hello decodeHello() throws IOException {
        String type = JsonMessages.typeOf(JsonInput.discreet(lines.buffer(), lines.start(), lines.length()));
        if (!type.equals("hello")) {
            throw new ProtocolException("the first message must be a hello, as in {\"type\":\"hello\",\"version\":"
                    + JsonLines.VERSION + "} (got: another)");
        }
        try (JsonInput in = JsonInput.discreet(lines.buffer(), lines.start(), lines.length())) {
            return JsonMessages.hello(in);
        }
    }

    /** Writes the answer to the last message that was read: one complete message with its id, flushed. */
    public void write(Reply reply) throws IOException {
        if (isPart) {
            reply.problems()
                    .forEach(problem -> leftOut.add(new WorldAnswer.LeftOut(problem.index(), "", problem.reason())));
            return;
        }
        Reply told = leftOut.isEmpty() ? reply : withLeftOut(reply);
        leftOut.clear();
        send(out -> JsonMessages.write(out, told, id));
    }

    /** The answer to a load, with what is missing of the file. */
    private Reply withLeftOut(Reply reply) {
        if (reply.bundle() instanceof BatchAnswerBundle batch
                && batch.answers().get(0) instanceof WorldAnswer.Described world) {
            List<WorldAnswer.LeftOut> all = new ArrayList<>(world.leftOut());
            all.addAll(leftOut);
            return new Reply(new BatchAnswerBundle(List.of(new WorldAnswer.Described(
                    world.added(),
                    all,
                    world.width(),
                    world.height(),
                    world.length(),
                    world.dimension(),
                    world.accuracy()))));
        }
        return reply;
    }

    private void send(JsonLines.Writing message) throws IOException {
        synchronized (target) {
            try (JsonGenerator generator = JsonInput.FACTORY.createGenerator(buffered)) {
                message.write(generator);
            }
            buffered.write('\n');
            buffered.flush();
        }
    }

    /** The number of the line that is awaited or was read last, from 1. */
    public long messageNumber() {
        return message;
    }

    /** The size in bytes of the last message read. */
    public int messageBytes() {
        return messageBytes;
    }
}
