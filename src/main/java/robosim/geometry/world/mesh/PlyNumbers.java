package robosim.geometry.world.mesh;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.world.shared.AsciiScanner;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.FileWork;

/** The numbers behind the header of a PLY file one after the other, in text or in bytes. */
final class PlyNumbers {
    private final String source;

    /** The words, if it is a text. */
    private final @Nullable AsciiScanner words;

    private final ByteBuffer bytes;
    private PlyHeader.Element element = new PlyHeader.Element("", 0, List.of());
    private long row;

    PlyNumbers(byte[] file, String source, PlyHeader header) {
        this.source = source;
        ByteOrder order = header.order;
        words = order == null ? new AsciiScanner(file, source, header.end, header.line) : null;
        bytes = ByteBuffer.wrap(file).order(order == null ? ByteOrder.BIG_ENDIAN : order);
        bytes.position(header.end);
    }

    /** Goes to an element, for messages. */
    void at(PlyHeader.Element of, long number) {
        FileWork.take(1);
        element = of;
        row = number;
    }

    /** The next number. */
    double next(PlyHeader.Property property, PlyHeader.Type type) throws FileProblem {
        if (words != null) {
            return words.number(property.name());
        }
        need(type.bytes);
        return switch (type) {
            case INT8 -> bytes.get();
            case UINT8 -> bytes.get() & 0xff;
            case INT16 -> bytes.getShort();
            case UINT16 -> bytes.getShort() & 0xffff;
            case INT32 -> bytes.getInt();
            case UINT32 -> bytes.getInt() & 0xffffffffL;
            case FLOAT32 -> bytes.getFloat();
            case FLOAT64 -> bytes.getDouble();
        };
    }

    /** The length of the list that follows. */
    int length(PlyHeader.Property list, PlyHeader.Type type) throws FileProblem {
        double length = next(list, type);
        if (!(length >= 0 && length <= Integer.MAX_VALUE) || length != Math.rint(length)) {
            throw wrong("the length of " + list.name() + " must be a whole number of at least 0 (got: " + length + ")");
        }
        return (int) length;
    }

    /** Skips numbers, which in a text may be no numbers. */
    void skip(PlyHeader.Property property, long count) throws FileProblem {
        if (words == null) {
            long length = count * property.type().bytes;
            need(length);
            bytes.position(bytes.position() + (int) length);
            return;
        }
        for (long k = 0; k < count; k++) {
            words.any(property.name());
        }
    }

    private void need(long length) throws FileProblem {
        if (bytes.remaining() < length) {
            throw wrong("the file ends before all elements that its header counts; it is truncated, so fetch or save it"
                    + " again (got: the end)");
        }
    }

    /** What is wrong with the element at hand. */
    FileProblem wrong(String problem) {
        String text = element.name() + " " + (row + 1) + " of " + element.count() + ": " + problem;
        return words != null ? words.wrong(text) : new FileProblem(source, text);
    }
}
