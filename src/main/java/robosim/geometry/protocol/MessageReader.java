package robosim.geometry.protocol;

import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.io.InterruptedIOException;
import java.io.ObjectStreamConstants;
import java.util.Objects;
import java.util.concurrent.atomic.AtomicLong;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.check.Text;
import robosim.geometry.protocol.pace.MessagePace;

/**
 * Reads bundles from a stream, within the {@link MessageLimits} and from an allow-list of classes. It reads ahead; after an
 * exception nothing more can be read.
 *
 * <p>The first byte of the stream identifies the encoding; {@code AC} (of {@code AC ED 00 05}) is Java serialization,
 * the only one supported here. Nothing is read before {@link #read}, so that both ends may write their stream headers
 * first.
 */
public final class MessageReader {
    private static final int JAVA = ObjectStreamConstants.STREAM_MAGIC >> 8 & 0xff;

    private final BundleInputStream.Bytes input;
    private final MessageTranslator translator;
    private @Nullable BundleInputStream objects;

    /** What the last message asks besides; null if nothing. */
    private @Nullable Bundle followUp;

    private final AtomicLong message = new AtomicLong();

    /** Reads the module's own records. */
    public MessageReader(InputStream in) {
        this(in, MessageTranslator.RECORDS, MessagePace.NONE);
    }

    /** Reads messages that a translator understands, and reports when a message begins. */
    public MessageReader(InputStream in, MessageTranslator translator, MessagePace pace) {
        this.input = new BundleInputStream.Bytes(Checks.present("in", in), Checks.present("pace", pace));
        this.translator = Checks.present("translator", translator);
    }

    /**
     * Waits for the next bundle. An {@link InitBundle.Answered} comes as two: its {@link InitBundle}, and the question what
     * became of it.
     *
     * @return null if the stream ends between two messages
     * @throws ProtocolException if the bytes are not a message, or the stream fails or ends inside one
     */
    public @Nullable Bundle read() throws ProtocolException {
        Bundle next = followUp;
        if (next != null) {
            followUp = null;
            return next;
        }
        message.incrementAndGet();
        try {
            boolean open = objects != null || open();
            return open && input.awaitMessage() >= 0 ? decode() : null;
        } catch (ProtocolException e) {
            throw e;
        } catch (IOException
                | ClassNotFoundException
                | RuntimeException
                | StackOverflowError
                | OutOfMemoryError
                | InternalError e) { // InternalError: the JDK read a map with a key but no value
            throw e instanceof OutOfMemoryError ? ProtocolException.noMemory(e) : new ProtocolException(reason(e), e);
        }
    }

    private boolean open() throws IOException {
        int first = input.awaitMessage();
        if (first < 0) {
            return false;
        }
        if (first != JAVA) {
            throw new ProtocolException(
                    "a stream must begin with AC ED 00 05, Java serialization (got: %02X)".formatted(first));
        }
        objects = new BundleInputStream(input, new AllowedClasses(translator.classes()));
        return true;
    }

    private Bundle decode() throws IOException, ClassNotFoundException {
        Object message = Objects.requireNonNull(objects).readMessage();
        if (message == null) {
            throw new ProtocolException("a message must be a bundle (got: null)");
        }
        Bundle bundle = Objects.requireNonNull(translator.decode(message), "the translator returned no bundle");
        if (bundle instanceof InitBundle.Answered asked) {
            followUp = InitBundle.Answered.QUESTION;
            return asked.init();
        }
        return bundle;
    }

    /** The number of the message that is awaited or was read last, from 1; may be called by any thread. */
    public long messageNumber() {
        return Math.max(1, message.get());
    }

    /** The size in bytes of the last message read, without a reset before it. */
    public int messageBytes() {
        return input.count();
    }

    private String reason(Throwable failure) {
        String refusal = objects == null ? null : objects.refusal();
        if (refusal != null) {
            return refusal;
        }
        if (failure instanceof EOFException) {
            return "the stream ended inside a message, after " + input.count() + " bytes of it";
        }
        if (failure instanceof InterruptedIOException) {
            return "a message stalled after " + input.count() + " bytes of it";
        }
        IOException broken = input.failure();
        if (broken != null) { // as when the peer is killed
            return "the connection failed "
                    + (input.isInside() ? "after " + input.count() + " bytes of a message: " : "between two messages: ")
                    + Text.line(String.valueOf(broken.getMessage()));
        }
        String text = failure.getMessage();
        String kind = failure.getClass().getSimpleName();
        return "the bytes are not a message: " + kind + (text == null ? "" : ", " + Text.line(text));
    }
}
