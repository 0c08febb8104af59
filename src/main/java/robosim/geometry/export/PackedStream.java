package robosim.geometry.export;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;

/** A stream of numbers and texts, each in as few bytes as it needs. */
final class PackedStream {
    /** Numbers from here on are no longer exact in JavaScript. */
    static final long MOST = 1L << 53;

    private static final double LARGEST = 0x1p60;

    private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();

    /** A whole number from 0 to below {@link #MOST}: seven bits a byte, the lowest first, the eighth set on all but the last. */
    void count(long value) {
        if (value < 0 || value >= MOST) {
            throw new IllegalArgumentException("value must be from 0 to below 2^53 (got: " + value + ")");
        }
        long left = value;
        while (left > 127) {
            bytes.write((int) (left & 127) | 128);
            left >>>= 7;
        }
        bytes.write((int) left);
    }

    /** A whole number with a sign, of a magnitude below 2^52: its sign becomes the lowest bit. */
    void signed(long value) {
        count(value < 0 ? -2 * value - 1 : 2 * value);
    }

    void octet(int value) {
        bytes.write(value);
    }

    /** The lower bytes of a number, lowest first. */
    PackedStream number(long value, int size) {
        for (int k = 0; k < size; k++) {
            bytes.write((int) (value >>> (8 * k)));
        }
        return this;
    }

    /** The nearest float of a magnitude whose square is one too, lowest byte first. */
    void real(double value) {
        number(Float.floatToIntBits((float) Math.max(-LARGEST, Math.min(LARGEST, value))), Float.BYTES);
    }

    /** A double with all its bits, lowest byte first. */
    void exact(double value) {
        number(Double.doubleToLongBits(value), Double.BYTES);
    }

    void text(String text) {
        byte[] utf8 = text.getBytes(StandardCharsets.UTF_8);
        count(utf8.length);
        bytes.writeBytes(utf8);
    }

    /** A text of a length of four bytes. */
    PackedStream longText(String text) {
        byte[] utf8 = text.getBytes(StandardCharsets.UTF_8);
        return number(utf8.length, Integer.BYTES).append(utf8);
    }

    PackedStream append(byte[] more) {
        bytes.writeBytes(more);
        return this;
    }

    int size() {
        return bytes.size();
    }

    byte[] toBytes() {
        return bytes.toByteArray();
    }
}
