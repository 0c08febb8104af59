package robosim.geometry.protocol;

import java.io.IOException;
import java.io.InputStream;
import java.io.InvalidClassException;
import java.io.ObjectInputFilter;
import java.io.ObjectInputStream;
import java.io.ObjectStreamClass;
import java.io.ObjectStreamConstants;
import java.util.IdentityHashMap;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Text;
import robosim.geometry.material.ImageTexture;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.protocol.batch.BatchRequest;
import robosim.geometry.protocol.batch.WorldRequest;
import robosim.geometry.protocol.pace.MessagePace;

/**
 * An object stream that trusts nothing: classes are taken from a list by their exact names, and depth, references,
 * lengths and the memory of objects are checked before and while they are created.
 */
final class BundleInputStream extends ObjectInputStream {
    private final Bytes input;
    private final AllowedClasses allowed;

    /** The number of parts of groups that the sender may still refer to. */
    private final IdentityHashMap<ObjectGroup, Long> groups = new IdentityHashMap<>();

    private long parts;
    private long pixels;
    private long claimedBytes;
    private long references;
    private long referencesBefore;
    private @Nullable String refusal;

    BundleInputStream(Bytes input, AllowedClasses allowed) throws IOException {
        super(input);
        this.input = input;
        this.allowed = allowed;
        setObjectInputFilter(this::judge);
        enableResolveObject(true);
    }

    /** Reads the next message; if it is refused, {@link #refusal()} says why. */
    Object readMessage() throws IOException, ClassNotFoundException {
        claimedBytes = 0;
        parts = 0;
        pixels = 0;
        if (input.afterReset()) {
            referencesBefore = references;
            groups.clear();
        }
        return readObject();
    }

    /** The filter's reason for a refusal, which the stream's own exception does not contain. */
    @Nullable
    String refusal() {
        return refusal;
    }

    private ObjectInputFilter.Status judge(ObjectInputFilter.FilterInfo info) {
        references = info.references();
        if (info.depth() > MessageLimits.MAX_DEPTH) {
            return refuse("nesting must be at most " + MessageLimits.MAX_DEPTH + " deep (got: more)");
        }
        if (references - referencesBefore > MessageLimits.MAX_REFERENCES) {
            return refuse("a sender must send at most " + MessageLimits.MAX_REFERENCES
                    + " objects before it resets its stream (got: more)");
        }
        Class<?> type = info.serialClass();
        if (type != null && !allowed.holds(type)) {
            return refuse("class " + type.getName() + " is not on the list of a message's classes");
        }
        return type != null && info.arrayLength() >= 0
                ? judgeArray(type, info.arrayLength())
                : ObjectInputFilter.Status.ALLOWED;
    }

    /**
     * An array is allocated before its items have come: its claimed length must fit into the rest of what the message
     * may contain.
     */
    private ObjectInputFilter.Status judgeArray(Class<?> type, long length) {
        Class<?> item = type.getComponentType();
        boolean numbers = item != null && item.isPrimitive();
        int most = numbers ? MessageLimits.MAX_ARRAY_LENGTH : MessageLimits.MAX_LIST_LENGTH;
        if (length > most) {
            return refuse("a" + (numbers ? "n array" : " list") + " must have at most " + most + " items (got: "
                    + length + ")");
        }
        claimedBytes += length * leastBytes(item);
        if (claimedBytes > MessageLimits.MAX_MESSAGE_BYTES) {
            return refuse("a message's lists and arrays must fit into " + MessageLimits.MAX_MESSAGE_BYTES
                    + " bytes (got: more)");
        }
        return ObjectInputFilter.Status.ALLOWED;
    }

    /** The bytes of an item on the wire: of an object at least the 5 of a reference to an earlier one. */
    private static int leastBytes(@Nullable Class<?> item) {
        return item == byte.class ? 1 : item == double.class ? 8 : item != null && item.isPrimitive() ? 4 : 5;
    }

    private ObjectInputFilter.Status refuse(String reason) {
        refusal = reason;
        return ObjectInputFilter.Status.REJECTED;
    }

    /** Never loads a class by a name that a peer sent. */
    @Override
    protected Class<?> resolveClass(ObjectStreamClass description) throws IOException {
        Class<?> type = allowed.byName(description.getName());
        if (type == null) {
            throw new InvalidClassException(
                    "class " + Text.quoted(description.getName()) + " is not on the list of a message's classes");
        }
        return type;
    }

    @Override
    protected Class<?> resolveProxyClass(String[] interfaces) throws IOException {
        throw new InvalidClassException("a proxy class is not on the list of a message's classes");
    }

    /**
     * Sees each object when it is created, before the object that contains it: exponentially growing structures are
     * stopped early.
     */
    @Override
    protected Object resolveObject(Object made) throws IOException {
        if (made instanceof List<?> items && !items.isEmpty() && items.get(0) instanceof GeometryObject) {
            add(sum(items));
        } else if (made instanceof List<?> items && !items.isEmpty() && items.get(0) instanceof BatchRequest) {
            addAdditions(items);
        } else if (made instanceof MeshObject mesh) {
            // With a material it comes a second time, as the same triangles.
            add(mesh.material().isDefault() ? partsOf(mesh) : 0);
        } else if (made instanceof ImageTexture image) {
            addPixels((long) image.width() * image.height());
        } else if (made instanceof ObjectGroup group) {
            groups.put(group, sum(group.members()));
        }
        return made;
    }

    /** The objects that a batch adds, counted at every reference to them. */
    private void addAdditions(List<?> items) throws IOException {
        long sum = 0;
        for (Object item : items) {
            GeometryObject addition = item instanceof WorldRequest request ? request.addition() : null;
            sum += addition == null ? 0 : partsOf(addition);
        }
        add(sum);
    }

    private long sum(List<?> items) {
        long sum = 0;
        for (Object item : items) {
            sum += item instanceof GeometryObject object ? partsOf(object) : 1;
        }
        return sum;
    }

    private long partsOf(GeometryObject object) {
        if (object instanceof MeshObject mesh) {
            return mesh.triangles().size();
        }
        if (object instanceof GridObject grid) {
            return MessageLimits.parts(grid);
        }
        return object instanceof ObjectGroup group ? groups.getOrDefault(group, 1L) : 1;
    }

    /** A picture takes memory for each pixel, and a few bytes can make another one of the same numbers. */
    private void addPixels(long more) throws IOException {
        pixels += more;
        if (pixels > MessageLimits.MAX_PIXELS) {
            throw new InvalidClassException("a message's pictures must have at most " + MessageLimits.MAX_PIXELS
                    + " pixels together (got: more)");
        }
    }

    private void add(long more) throws IOException {
        parts += more;
        if (parts > MessageLimits.MAX_PARTS) {
            throw new InvalidClassException("a message's objects must have at most " + MessageLimits.MAX_PARTS
                    + " parts, counted at every reference to them (got: more)");
        }
    }

    /**
     * The bytes below an object stream: buffered, and counted per message, because the object stream only counts over its
     * whole life.
     */
    static final class Bytes extends InputStream {
        private static final int NONE = -1;

        private final InputStream source;
        private final MessagePace pace;
        private final byte[] buffer = new byte[8192];
        private int next;
        private int end;
        private int count;

        /** Whether a reset code was read while the stream was idle, to be passed on with the next message. */
        private boolean resetFirst;

        private boolean afterReset;
        private boolean inside;
        private @Nullable IOException failure;

        Bytes(InputStream source, MessagePace pace) {
            this.source = source;
            this.pace = pace;
        }

        /**
         * Waits for the next message.
         *
         * @return its first byte, which is not consumed, or -1 at the end of the stream
         */
        int awaitMessage() throws IOException {
            pace.idle();
            inside = false;
            int first = peek();
            while (first == ObjectStreamConstants.TC_RESET) {
                resetFirst = true; // a sender writes it after a message; the next one may come much later
                next++;
                first = peek();
            }
            if (first != NONE) {
                pace.begun();
            }
            inside = true;
            count = 0;
            afterReset = resetFirst;
            return first;
        }

        /** The failure of the stream itself; null if there was none. */
        @Nullable
        IOException failure() {
            return failure;
        }

        /** Whether the sender reset its stream before this message, which then does not refer to earlier ones. */
        boolean afterReset() {
            return afterReset;
        }

        /** Whether a message has begun. */
        boolean isInside() {
            return inside;
        }

        /** The number of bytes of the message so far. */
        int count() {
            return count;
        }

        private int peek() throws IOException {
            return next < end || fill() ? buffer[next] & 0xff : NONE;
        }

        private boolean fill() throws IOException {
            int got;
            try {
                got = source.read(buffer, 0, buffer.length);
            } catch (IOException e) {
                failure = e;
                throw e;
            }
            next = 0;
            end = Math.max(got, 0);
            return got > 0;
        }

        /** An object stream reads single type codes this way, but never the bytes of a string or an array. */
        @Override
        public int read() throws IOException {
            if (resetFirst) {
                resetFirst = false;
                return ObjectStreamConstants.TC_RESET;
            }
            int value = peek();
            if (value == ObjectStreamConstants.TC_LONGSTRING) {
                throw new ProtocolException(
                        "a string must have at most " + MessageLimits.MAX_TEXT_BYTES + " bytes (got: more)");
            }
            if (value != NONE) {
                take(1);
            }
            return value;
        }

        @Override
        public int read(byte[] into, int at, int length) throws IOException {
            if (length == 0) {
                return 0;
            }
            if (resetFirst) {
                resetFirst = false;
                into[at] = ObjectStreamConstants.TC_RESET;
                return 1;
            }
            if (peek() == NONE) {
                return NONE;
            }
            int taken = Math.min(length, end - next);
            System.arraycopy(buffer, next, into, at, taken);
            take(taken);
            return taken;
        }

        private void take(int bytes) throws IOException {
            next += bytes;
            count += bytes;
            if (count > MessageLimits.MAX_MESSAGE_BYTES) {
                throw new ProtocolException(
                        "a message must have at most " + MessageLimits.MAX_MESSAGE_BYTES + " bytes (got: more)");
            }
        }

        @Override
        public int available() {
            return end - next;
        }
    }
}
