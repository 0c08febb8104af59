package robosim.geometry.protocol.json;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.JsonStreamContext;
import com.fasterxml.jackson.core.JsonToken;
import com.fasterxml.jackson.core.StreamReadConstraints;
import com.fasterxml.jackson.core.StreamWriteFeature;
import com.fasterxml.jackson.core.exc.StreamConstraintsException;
import java.io.ByteArrayInputStream;
import java.io.Closeable;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.Reader;
import java.math.BigDecimal;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import java.util.function.Function;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Text;
import robosim.geometry.material.ImageTexture;
import robosim.geometry.protocol.MessageLimits;
import robosim.geometry.protocol.ProtocolException;

/**
 * One line of JSON, read strictly: an object must have its required fields and may have its optional ones, each once; a
 * value must be of its type and within the limits. Errors name the place as a JSON pointer.
 */
final class JsonInput implements Closeable {
    /** Maximum length of a number: the longest double has about 1,080 exact digits. */
    static final int MAX_NUMBER_LENGTH = 1_100;

    /** Maximum length of a whole number that has a decimal point or an exponent. */
    private static final int MAX_WHOLE_LENGTH = 40;

    /** The largest whole number that every reader of JSON has exactly. */
    static final long MAX_ID = (1L << 53) - 1;

    /** Maximum length of any string: the base64 of a normal for each of the most beams. */
    private static final int MAX_BASE64 = 3 * Double.BYTES * MessageLimits.MAX_BEAMS / 3 * 4;

    static final JsonFactory FACTORY = JsonFactory.builder()
            .streamReadConstraints(constraints())
            // Names come from a peer, so none are cached.
            .disable(JsonFactory.Feature.INTERN_FIELD_NAMES)
            .disable(JsonFactory.Feature.CANONICALIZE_FIELD_NAMES)
            // The shortest digits that identify the double, on every JVM.
            .enable(StreamWriteFeature.USE_FAST_DOUBLE_WRITER)
            .disable(StreamWriteFeature.AUTO_CLOSE_TARGET)
            // A line is written with its line feed, at once.
            .disable(StreamWriteFeature.FLUSH_PASSED_TO_STREAM)
            .build();

    private static StreamReadConstraints constraints() {
        StreamReadConstraints.Builder constraints = StreamReadConstraints.builder()
                .maxNestingDepth(MessageLimits.MAX_DEPTH)
                .maxNumberLength(MAX_NUMBER_LENGTH)
                .maxStringLength(MAX_BASE64); // other strings are limited by text()
        try {
            return constraints.maxNameLength(MessageLimits.MAX_TEXT_BYTES).build();
        } catch (NoSuchMethodError e) {
            // Jackson 2.15 has no limit of its own for names: there a line's length limits them.
            return constraints.build();
        }
    }

    private final JsonParser parser;
    private final JsonProblems problems;
    private final Map<ImageTexture, ImageTexture> images = new HashMap<>();
    private int containers;
    private long parts;

    /** The id of the message; null if it has none, or it has not been read yet. */
    private @Nullable Object id;

    /** The last string read. */
    private @Nullable String lastText;

    private JsonInput(JsonParser parser, boolean discreet) {
        this.parser = parser;
        problems = new JsonProblems(parser, discreet);
    }

    /** A line whose contents may be quoted in errors. */
    static JsonInput of(byte[] bytes, int at, int length) throws IOException {
        return new JsonInput(parser(bytes, at, length), false);
    }

    /** A line whose contents may be quoted in errors, read as it arrives. */
    static JsonInput of(Reader line) throws IOException {
        return new JsonInput(FACTORY.createParser(line), false);
    }

    /** A line that may contain a secret: nothing of it is quoted. */
    static JsonInput discreet(byte[] bytes, int at, int length) throws IOException {
        return new JsonInput(parser(bytes, at, length), true);
    }

    // Not createParser(bytes, at, length): if names are not canonicalized, Jackson 2.22 takes at + length for the
    // length when it exceeds 8,000 bytes, and reads beyond the line.
    private static JsonParser parser(byte[] bytes, int at, int length) throws IOException {
        return length <= LineInput.BUFFER
                ? FACTORY.createParser(new String(bytes, at, length, StandardCharsets.UTF_8))
                : FACTORY.createParser(
                        new InputStreamReader(new ByteArrayInputStream(bytes, at, length), StandardCharsets.UTF_8));
    }

    /** Goes to a field of the line's object, at any position; returns whether it exists. */
    boolean find(String field) throws IOException {
        if (advance() == null) {
            throw new ProtocolException("a line must contain a message (got: a blank line)");
        }
        if (!isObject()) {
            throw refused("must be an object, {...} (got: " + kind() + ")");
        }
        for (String name = nextField(); name != null; name = nextField()) {
            if (name.equals(field)) {
                return true;
            }
            skip();
        }
        return false;
    }

    /** Goes to the value of the current object's next field and returns the name; null at the object's end. */
    @Nullable
    String nextField() throws IOException {
        if (advance() != JsonToken.FIELD_NAME) {
            return null;
        }
        String name = fieldName();
        advance();
        return name;
    }

    /** The name of the current field. */
    String fieldName() throws IOException {
        return parser.currentName();
    }

    private void skip() throws IOException {
        try {
            parser.skipChildren();
        } catch (JsonProcessingException e) {
            throw problems.noJson(e);
        }
    }

    /** Begins reading the line's value. */
    void begin() throws IOException {
        advance();
    }

    /** Checks that the line ends here. */
    void end() throws IOException {
        if (advance() != null) {
            throw more();
        }
    }

    private ProtocolException more() {
        return problems.unreadable("nothing may follow a message on its line (got: " + kind() + ")");
    }

    /** Reads the current value as the id of the message. */
    void readId() throws IOException {
        if (isText()) {
            id = text();
        } else if (isNumber()) {
            id = whole(-MAX_ID, MAX_ID);
        } else {
            throw refused(
                    "an id must be a text or a whole number; leave it out if there is none (got: " + kind() + ")");
        }
    }

    /** The id of the message, a String or a Long; null if it has none, or it has not been read yet. */
    @Nullable
    Object id() {
        return id;
    }

    /**
     * Reads the rest of the line, whose message is wrong, for its id.
     *
     * @throws ProtocolException if the line is not JSON
     */
    void skipRest() throws IOException {
        boolean isId = isFieldOfMessage("id");
        boolean ended = hasEnded();
        while (advance() != null) {
            if (ended) {
                throw more();
            }
            if (isId && (isText() || isNumber())) {
                try {
                    readId();
                } catch (ProtocolException e) {
                    if (!e.isAboutRequest()) {
                        throw e;
                    }
                }
            }
            isId = isFieldOfMessage("id");
            ended = hasEnded();
        }
    }

    private boolean hasEnded() {
        return parser.currentToken() != null && parser.getParsingContext().inRoot();
    }

    private boolean isFieldOfMessage(String field) throws IOException {
        JsonStreamContext in = parser.getParsingContext();
        return parser.currentToken() == JsonToken.FIELD_NAME
                && in.getParent() != null
                && in.getParent().inRoot()
                && field.equals(fieldName());
    }

    JsonToken advance() throws IOException {
        try {
            return parser.nextToken();
        } catch (JsonProcessingException e) {
            throw problems.noJson(e);
        }
    }

    /** Begins reading the current value as an object. */
    void beginObject() throws IOException {
        if (!isObject()) {
            throw refused("must be an object, {...} (got: " + kind() + ")");
        }
        count();
    }

    boolean isObject() {
        return parser.currentToken() == JsonToken.START_OBJECT;
    }

    boolean isNull() {
        return parser.currentToken() == JsonToken.VALUE_NULL;
    }

    boolean isText() {
        return parser.currentToken() == JsonToken.VALUE_STRING;
    }

    boolean isNumber() {
        return parser.currentToken() == JsonToken.VALUE_NUMBER_INT
                || parser.currentToken() == JsonToken.VALUE_NUMBER_FLOAT;
    }

    boolean isFlag() {
        return parser.currentToken() == JsonToken.VALUE_TRUE || parser.currentToken() == JsonToken.VALUE_FALSE;
    }

    private void count() throws IOException {
        if (++containers > MessageLimits.MAX_REFERENCES) {
            throw problems.unreadable("there must be at most " + MessageLimits.MAX_REFERENCES
                    + " objects and lists in a message (got: more)");
        }
    }

    /** Begins reading the current value as a list; {@link #more} goes to its items. */
    void list() throws IOException {
        if (parser.currentToken() != JsonToken.START_ARRAY) {
            throw refused("must be a list, [...] (got: " + kind() + ")");
        }
        count();
    }

    /**
     * Goes to the next item of a list.
     *
     * @param sofar number of items read so far
     * @return false at its end
     */
    boolean more(int sofar, int most) throws IOException {
        if (advance() == JsonToken.END_ARRAY) {
            return false;
        }
        if (sofar >= most) {
            throw refused("a list must have at most " + most + " items here (got: more)");
        }
        return true;
    }

    /** The current value as a finite number: the nearest double. */
    double number() throws IOException {
        if (!isNumber()) {
            throw refused("must be a number (got: " + kind() + ")");
        }
        String digits = scalar();
        if (digits.length() > MAX_NUMBER_LENGTH) { // the parser's own limit counts neither the sign nor the point
            throw problems.unreadable(JsonProblems.numberTooLong());
        }
        double value = Double.parseDouble(digits);
        if (!Double.isFinite(value)) {
            throw refused("must be a number that a double can hold (got: one beyond 1.8e308)");
        }
        return value;
    }

    /** The current value as a whole number. */
    long whole(long least, long most) throws IOException {
        double value = number();
        if (!(value >= least && value <= most) || !isWhole()) {
            throw refused(
                    "must be a whole number from " + least + " to " + most + " (got: " + Text.line(scalar()) + ")");
        }
        return (long) value;
    }

    // 1.0 and 1e0 are whole numbers too, as in the schema; a number that only rounds to one is not, nor one too long to
    // check quickly.
    private boolean isWhole() throws IOException {
        return parser.currentToken() == JsonToken.VALUE_NUMBER_INT
                || (parser.getTextLength() <= MAX_WHOLE_LENGTH
                        && new BigDecimal(scalar()).stripTrailingZeros().scale() <= 0);
    }

    /** The current value as a list of the given number of numbers. */
    double[] numbers(int count) throws IOException {
        double[] numbers = new double[count];
        list();
        int k = 0;
        while (more(k, count)) {
            numbers[k++] = number();
        }
        if (k < count) {
            throw refused("must be a list of " + count + " numbers (got: " + k + ")");
        }
        return numbers;
    }

    /** The current value as a list of numbers. */
    double[] doubles(int most) throws IOException {
        double[] numbers = new double[4];
        int count = 0;
        list();
        while (more(count, most)) {
            numbers = count < numbers.length ? numbers : Arrays.copyOf(numbers, 2 * count);
            numbers[count++] = number();
        }
        return Arrays.copyOf(numbers, count);
    }

    /** The current value as a list of whole numbers. */
    int[] wholes(int most, int least, int greatest) throws IOException {
        int[] numbers = new int[4];
        int count = 0;
        list();
        while (more(count, most)) {
            numbers = count < numbers.length ? numbers : Arrays.copyOf(numbers, 2 * count);
            numbers[count++] = (int) whole(least, greatest);
        }
        return Arrays.copyOf(numbers, count);
    }

    boolean flag() throws IOException {
        if (!isFlag()) {
            throw refused("must be true or false (got: " + kind() + ")");
        }
        return parser.currentToken() == JsonToken.VALUE_TRUE;
    }

    /** The current value as a string without unpaired surrogates, no longer than a Java stream can hold. */
    String text() throws IOException {
        if (!isText()) {
            throw refused("must be a string (got: " + kind() + ")");
        }
        String last = lastText;
        if (last != null && isAgain(last)) {
            return last; // a bundle repeats a robot's name in many requests
        }
        String text = scalar();
        int bytes = 0;
        for (int k = 0; k < text.length(); k++) {
            char c = text.charAt(k);
            bytes += c >= 1 && c <= 0x7f ? 1 : c <= 0x7ff ? 2 : 3; // modified UTF-8
            if (Character.isHighSurrogate(c) && k + 1 < text.length() && Character.isLowSurrogate(text.charAt(k + 1))) {
                k++;
                bytes += 3;
            } else if (Character.isSurrogate(c)) {
                throw refused("a string must have no unpaired surrogate (got: " + told(String.valueOf(c)) + ")");
            }
        }
        if (bytes > MessageLimits.MAX_TEXT_BYTES) {
            throw refused(JsonProblems.tooLong());
        }
        lastText = text;
        return text;
    }

    private boolean isAgain(String text) throws IOException {
        try {
            char[] chars = parser.getTextCharacters();
            int from = parser.getTextOffset();
            boolean same = parser.getTextLength() == text.length();
            for (int k = 0; same && k < text.length(); k++) {
                same = chars[from + k] == text.charAt(k);
            }
            return same;
        } catch (JsonProcessingException e) {
            throw problems.noJson(e);
        }
    }

    /**
     * The current value as bytes in base64 (RFC 4648, section 4), whose text may be longer than that of other values.
     *
     * @param stride the bytes come in groups of so many
     * @param most   maximum number of groups
     */
    byte[] base64(int stride, int most) throws IOException {
        if (!isText()) {
            throw refused("must be a string of base64 (got: " + kind() + ")");
        }
        Base64Sink bytes = new Base64Sink(stride * most);
        String tooMuch = "must have at most " + (long) stride * most + " bytes in base64 (got: more)";
        try {
            parser.getText(bytes);
        } catch (StreamConstraintsException e) {
            throw problems.unreadable(tooMuch);
        } catch (JsonProcessingException e) {
            throw problems.noJson(e);
        }
        if (bytes.isFull()) {
            throw refused(tooMuch);
        }
        if (!bytes.isWhole()) {
            throw refused("must be base64, with its padding and nothing else (got: other characters)");
        }
        if (bytes.count() % stride != 0) {
            throw refused("must have " + stride + " bytes each in base64 (got: " + bytes.count() + " bytes)");
        }
        return bytes.bytes();
    }

    /** The current value as a constant of an enum. */
    <E extends Enum<E>> E constant(Class<E> type) throws IOException {
        String text = text();
        for (E constant : type.getEnumConstants()) {
            if (constant.name().equals(text)) {
                return constant;
            }
        }
        throw refused("must be one of " + Arrays.toString(type.getEnumConstants()) + " (got: " + told(text) + ")");
    }

    private String scalar() throws IOException {
        try {
            return parser.getText();
        } catch (JsonProcessingException e) {
            throw problems.noJson(e);
        }
    }

    /** Constructs a value; an exception of its constructor becomes one of this input. */
    <T> T make(Supplier<T> constructor) throws ProtocolException {
        return make(constructor, message -> null);
    }

    /**
     * The same for an object that has been read.
     *
     * @param culprit finds the member that a constructor's message is about; null for the object as a whole
     */
    <T> T make(Supplier<T> constructor, Function<String, @Nullable String> culprit) throws ProtocolException {
        try {
            return constructor.get();
        } catch (IllegalArgumentException e) {
            String message = String.valueOf(e.getMessage());
            throw ProtocolException.ofRequest(problems.place(culprit.apply(message)) + message, e);
        }
    }

    /** Counts parts of objects. */
    void addParts(long more) throws ProtocolException {
        parts += more;
        if (parts > MessageLimits.MAX_PARTS) {
            throw refused("a message's objects must have at most " + MessageLimits.MAX_PARTS
                    + " parts, counted in every list that contains them (got: more)");
        }
    }

    /** An equal value that was read before in this message, or else this one: pictures share their pixels. */
    ImageTexture shared(ImageTexture image) {
        return images.computeIfAbsent(image, same -> same);
    }

    /** An exception about the current value. */
    ProtocolException refused(String what) {
        return problems.refused(what);
    }

    /** Quotes a value for a message, unless it may be secret. */
    String told(String text) {
        return problems.told(text);
    }

    /** The type of the current value, for a message. */
    String kind() {
        return problems.kind();
    }

    @Override
    public void close() throws IOException {
        parser.close();
    }
}
