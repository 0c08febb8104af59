package robosim.geometry.world.xml;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The bytes of an XML document with those mistakes mended that Gazebo's parsers do not mind: a declaration that is broken
 * or not at the very beginning, {@code --} in a comment, an {@code &} that begins no entity, a {@code <} in an attribute, and bytes that are no UTF-8.
 * Lines stay what they are. It looks a few bytes ahead and keeps nothing else in memory.
 */
final class LenientXml extends InputStream {
    /** The longest entity that is recognized, and the longest declaration. */
    private static final int AHEAD = 256;

    private static final Pattern ENTITY = Pattern.compile("&(?:#\\d{1,7}|#x[0-9a-fA-F]{1,6}|[A-Za-z_][\\w.-]{0,60});");
    private static final Pattern DECLARATION = Pattern.compile("(?:\\xef\\xbb\\xbf)?<\\?xml\\s+version\\s*=\\s*"
            + "(?:\"1\\.\\d\"|'1\\.\\d')(?:\\s+encoding\\s*=\\s*[\"']([A-Za-z][\\w.-]*)[\"'])?"
            + "(?:\\s+standalone\\s*=\\s*[\"'](?:yes|no)[\"'])?\\s*\\?>");

    private enum Part {
        TEXT,
        TAG,
        COMMENT,
        CDATA,
        INSTRUCTION,
        /** A declaration that is replaced by spaces. */
        BLANK
    }

    private final InputStream in;
    private final byte[] bytes = new byte[1 << 14];
    private final Map<String, Integer> mended = new LinkedHashMap<>();
    private int from;
    private int to;
    private boolean isAtEnd;

    /** Whether it is encoded so that tags can be told from bytes. */
    private final boolean isByByte;

    private final boolean isUtf8;
    private Part part = Part.TEXT;
    /** The quotation mark around the value of an attribute; 0 outside. */
    private int quote;

    private boolean hasTag;
    private int line = 1;

    /** Bytes that follow as they are. */
    private int plain;

    /** Bytes to insert. */
    private byte[] inserted = {};

    private int insertedAt;

    LenientXml(InputStream in) throws IOException {
        this.in = in;
        fill();
        int first = ahead(0);
        int second = ahead(1);
        boolean isMarked = (first == 0xfe && second == 0xff) || (first == 0xff && second == 0xfe);
        isByByte = first > 0 && second > 0 && !isMarked; // and not UTF-16
        Matcher declaration = DECLARATION.matcher(head());
        boolean isDeclared = declaration.lookingAt();
        String encoding = isDeclared ? declaration.group(1) : null;
        isUtf8 = encoding == null || encoding.equalsIgnoreCase("UTF-8");
        plain = isDeclared ? declaration.end() : first == 0xef && second == 0xbb && ahead(2) == 0xbf ? 3 : 0;
    }

    /** What was mended, each kind with its first line, in the order of these. */
    List<String> mended(String source) {
        List<String> remarks = new ArrayList<>();
        mended.forEach((what, where) -> remarks.add(source + ":" + where
                + ": this is not well-formed XML, and was read nevertheless, as Gazebo does: " + what));
        return remarks;
    }

    private void mend(String what) {
        mended.putIfAbsent(what, line);
    }

    @Override
    public int read() throws IOException {
        if (insertedAt < inserted.length) {
            return inserted[insertedAt++];
        }
        if (to - from < AHEAD && !isAtEnd) {
            fill();
        }
        if (from == to) {
            return -1;
        }
        int value = plain > 0 || !isByByte ? passed() : next();
        if (value == '\n') {
            line++;
        }
        return value;
    }

    @Override
    public int read(byte[] target, int start, int length) throws IOException {
        int count = 0;
        while (count < length) {
            int value = read();
            if (value < 0) {
                return count == 0 ? -1 : count;
            }
            target[start + count++] = (byte) value;
        }
        return count;
    }

    private int passed() {
        plain = Math.max(0, plain - 1);
        return bytes[from++] & 0xff;
    }

    private int next() {
        int value = ahead(0);
        if (value >= 0x80) {
            return other(value);
        }
        return switch (part) {
            case TEXT -> text(value);
            case TAG -> tag(value);
            case COMMENT -> comment();
            case CDATA -> until("]]>");
            case INSTRUCTION -> until("?>");
            case BLANK -> {
                boolean isLast = starts("?>");
                passed();
                if (isLast) {
                    passed();
                    insert(" ");
                    part = Part.TEXT;
                }
                yield value == '\n' || value == '\r' ? value : ' ';
            }
        };
    }

    private int text(int value) {
        if (value == '&') {
            return ampersand();
        }
        if (value != '<') {
            return passed();
        }
        if (starts("<!--")) {
            part = Part.COMMENT;
            plain = 4;
        } else if (starts("<![CDATA[")) {
            part = Part.CDATA;
            plain = 9;
        } else if (!hasTag && starts("<?xml") && " \t\r\n?".indexOf(ahead(5)) >= 0) {
            part = Part.BLANK;
            mend("its declaration is broken or not at the very beginning, and was ignored");
            return next();
        } else if (starts("<?")) {
            part = Part.INSTRUCTION;
            plain = 2;
        } else {
            part = Part.TAG;
            hasTag = true;
        }
        return passed();
    }

    private int tag(int value) {
        if (quote == 0) {
            if (value == '>') {
                part = Part.TEXT;
            } else if (value == '"' || value == '\'') {
                quote = value;
            }
        } else if (value == quote) {
            quote = 0;
        } else if (value == '<' && isClosed()) {
            mend("a < in an attribute that is not written as &lt;");
            insert("lt;");
            passed();
            return '&';
        }
        return value == '&' ? ampersand() : passed();
    }

    /** Whether the value of an attribute ends soon and in this line: if not, its end is what is missing. */
    private boolean isClosed() {
        for (int k = 1; k < AHEAD; k++) {
            int value = ahead(k);
            if (value == quote || value == '\n' || value < 0) {
                return value == quote;
            }
        }
        return false;
    }

    private int ampersand() {
        if (ENTITY.matcher(head()).lookingAt()) {
            return passed();
        }
        mend("an & that is not written as &amp;");
        insert("amp;");
        return passed();
    }

    private int comment() {
        if (starts("-->")) {
            part = Part.TEXT;
            plain = 3;
            return passed();
        }
        if (starts("--")) {
            mend("a comment has -- in it");
            passed();
            return ' ';
        }
        return passed();
    }

    private int until(String end) {
        if (starts(end)) {
            part = Part.TEXT;
            plain = end.length();
        }
        return passed();
    }

    /** A byte that is not ASCII: of a valid character of UTF-8, or replaced by a question mark. */
    private int other(int lead) {
        if (part == Part.BLANK) {
            passed();
            return ' ';
        }
        int length = isUtf8 ? length(lead) : 1;
        if (length == 0) {
            mend("bytes that are not UTF-8, as which it is read, are question marks");
            passed();
            return '?';
        }
        plain = length;
        return passed();
    }

    /** How many bytes the character has that begins with a byte; 0 if it is not valid. */
    private int length(int lead) {
        int second = ahead(1);
        if (lead >= 0xc2 && lead <= 0xdf) {
            return isWithin(second, 0x80, 0xbf) ? 2 : 0;
        }
        if (lead >= 0xe0 && lead <= 0xef) {
            int least = lead == 0xe0 ? 0xa0 : 0x80;
            int most = lead == 0xed ? 0x9f : 0xbf;
            boolean isNone = lead == 0xef && second == 0xbf && ahead(2) >= 0xbe; // U+FFFE and U+FFFF
            return isWithin(second, least, most) && isWithin(ahead(2), 0x80, 0xbf) && !isNone ? 3 : 0;
        }
        if (lead >= 0xf0 && lead <= 0xf4) {
            int least = lead == 0xf0 ? 0x90 : 0x80;
            int most = lead == 0xf4 ? 0x8f : 0xbf;
            return isWithin(second, least, most) && isWithin(ahead(2), 0x80, 0xbf) && isWithin(ahead(3), 0x80, 0xbf)
                    ? 4
                    : 0;
        }
        return 0;
    }

    private static boolean isWithin(int value, int least, int most) {
        return value >= least && value <= most;
    }

    private void insert(String ascii) {
        inserted = ascii.getBytes(StandardCharsets.US_ASCII);
        insertedAt = 0;
    }

    /** A byte ahead, from 0 to 255; -1 beyond the end. */
    private int ahead(int offset) {
        return from + offset < to ? bytes[from + offset] & 0xff : -1;
    }

    private boolean starts(String latin) {
        for (int k = 0; k < latin.length(); k++) {
            if (ahead(k) != latin.charAt(k)) {
                return false;
            }
        }
        return true;
    }

    /** The next bytes as characters. */
    private String head() {
        return new String(bytes, from, Math.min(AHEAD, to - from), StandardCharsets.ISO_8859_1);
    }

    private void fill() throws IOException {
        System.arraycopy(bytes, from, bytes, 0, to - from);
        to -= from;
        from = 0;
        while (to < bytes.length) {
            int count = in.read(bytes, to, bytes.length - to);
            if (count < 0) {
                isAtEnd = true;
                return;
            }
            to += count;
        }
    }

    @Override
    public void close() throws IOException {
        in.close();
    }
}
