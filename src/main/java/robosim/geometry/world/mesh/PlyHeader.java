package robosim.geometry.world.mesh;

import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.jspecify.annotations.Nullable;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.Numbers;

/** The header of a PLY file: which elements follow it, how many, and what numbers each has. */
final class PlyHeader {
    /** Lines of a header. A file with all properties of a photogrammetry program has some 40. */
    private static final int MOST_LINES = 10_000;

    private static final int LONGEST_LINE = 10_000;

    /** How a number is stored; text has the same types. */
    enum Type {
        INT8(1),
        UINT8(1),
        INT16(2),
        UINT16(2),
        INT32(4),
        UINT32(4),
        FLOAT32(4),
        FLOAT64(8);

        final int bytes;

        Type(int bytes) {
            this.bytes = bytes;
        }
    }

    /**
     * A number of each element, or a list of them.
     *
     * @param count the type of the list's length; null if it is a single number
     */
    record Property(String name, Type type, @Nullable Type count) {}

    /** Elements that follow each other. */
    record Element(String name, long count, List<Property> properties) {}

    final List<Element> elements = new ArrayList<>();

    /** The order of bytes; null if the file is text. */
    @Nullable
    ByteOrder order;

    /** The index of the first byte behind the header. */
    int end;

    /** The line in which that byte is, counted from 1. */
    int line;

    private final byte[] bytes;
    private final String source;
    private boolean hasFormat;

    private PlyHeader(byte[] bytes, String source) {
        this.bytes = bytes;
        this.source = source;
    }

    static PlyHeader read(byte[] bytes, String source) throws FileProblem {
        PlyHeader header = new PlyHeader(bytes, source);
        header.read();
        return header;
    }

    private void read() throws FileProblem {
        if (!nextLine().strip().equals("ply")) {
            throw wrong("a PLY file must begin with the line ply (got: another)");
        }
        while (true) {
            String text = nextLine();
            String[] words = Numbers.words(text);
            switch (words[0]) {
                case "", "comment", "obj_info" -> {}
                case "format" -> format(words);
                case "element" -> element(words);
                case "property" -> property(words);
                case "end_header" -> {
                    if (!hasFormat) {
                        throw wrong("a PLY file must say its format before end_header (got: none)");
                    }
                    line++;
                    return;
                }
                default -> {} // as a comment: no line of another kind changes what follows the header
            }
        }
    }

    private String nextLine() throws FileProblem {
        int begin = end;
        line++;
        while (end < bytes.length && bytes[end] != '\n') {
            end++;
        }
        if (end == bytes.length || line > MOST_LINES || end - begin > LONGEST_LINE) {
            throw wrong("the header of a PLY file must end with the line end_header, within " + MOST_LINES
                    + " lines of " + LONGEST_LINE + " characters (got: none)");
        }
        return new String(bytes, begin, end++ - begin, StandardCharsets.ISO_8859_1);
    }

    private void format(String[] words) throws FileProblem {
        String format = words.length > 1 ? words[1] : "";
        order = switch (format) {
            case "ascii" -> null;
            case "binary_little_endian" -> ByteOrder.LITTLE_ENDIAN;
            case "binary_big_endian" -> ByteOrder.BIG_ENDIAN;
            default ->
                throw wrong("format must be ascii, binary_little_endian or binary_big_endian (got: "
                        + Numbers.shown(format) + ")");
        };
        hasFormat = true;
    }

    private void element(String[] words) throws FileProblem {
        if (words.length != 3) {
            throw wrong("an element must have a name and a number (got: " + (words.length - 1) + " words)");
        }
        long count = -1;
        try {
            count = Long.parseLong(words[2]);
        } catch (NumberFormatException e) {
            count = -1;
        }
        if (count < 0) {
            throw wrong("the number of elements must be a whole number of at least 0 (got: " + Numbers.shown(words[2])
                    + ")");
        }
        elements.add(new Element(words[1], count, new ArrayList<>()));
    }

    private void property(String[] words) throws FileProblem {
        if (elements.isEmpty()) {
            throw wrong("a property must follow the element that has it (got: none before it)");
        }
        boolean isList = words.length == 5 && words[1].equals("list");
        if (!isList && words.length != 3) {
            throw wrong("a property must be TYPE NAME, or list TYPE TYPE NAME (got: " + (words.length - 1) + " words)");
        }
        List<Property> properties = elements.get(elements.size() - 1).properties();
        if (isList) {
            Type count = type(words[2]);
            if (count == Type.FLOAT32 || count == Type.FLOAT64) {
                throw wrong("the length of a list must be of a whole type (got: " + words[2] + ")");
            }
            properties.add(new Property(words[4], type(words[3]), count));
        } else {
            properties.add(new Property(words[2], type(words[1]), null));
        }
    }

    private Type type(String word) throws FileProblem {
        return switch (word.toLowerCase(Locale.ROOT)) {
            case "char", "int8" -> Type.INT8;
            case "uchar", "uint8" -> Type.UINT8;
            case "short", "int16" -> Type.INT16;
            case "ushort", "uint16" -> Type.UINT16;
            case "int", "int32" -> Type.INT32;
            case "uint", "uint32" -> Type.UINT32;
            case "float", "float32" -> Type.FLOAT32;
            case "double", "float64" -> Type.FLOAT64;
            default ->
                throw wrong("a type must be char, uchar, short, ushort, int, uint, float or double (got: "
                        + Numbers.shown(word) + ")");
        };
    }

    private FileProblem wrong(String problem) {
        return new FileProblem(source, line, 0, problem);
    }
}
