package robosim.geometry.protocol.json;

import java.io.Writer;
import java.util.Arrays;

/** Decodes base64 (RFC 4648, section 4), a part at a time and strictly: no other characters, all padding, unused bits 0. */
final class Base64Sink extends Writer {
    private static final int NONE = -1;
    private static final int[] SIX_BITS = sixBits();

    private final int most;
    private byte[] bytes = new byte[256];
    private int count;
    private boolean isFull;
    private boolean isBad;

    /** The characters since the last whole group of four, and their bits. */
    private int pending;

    private int bits;
    private int padding;

    /** Takes so many bytes at most. */
    Base64Sink(int most) {
        this.most = most;
    }

    private static int[] sixBits() {
        String alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
        int[] values = new int[128];
        Arrays.fill(values, NONE);
        for (int k = 0; k < alphabet.length(); k++) {
            values[alphabet.charAt(k)] = k;
        }
        return values;
    }

    @Override
    public void write(char[] text, int at, int length) {
        for (int k = at; k < at + length && !isBad && !isFull; k++) {
            take(text[k]);
        }
    }

    private void take(char c) {
        int value = c < SIX_BITS.length ? SIX_BITS[c] : NONE;
        boolean isPad = c == '=' && pending >= 2;
        if (!isPad && (value == NONE || padding > 0)) { // nothing follows padding
            isBad = true;
            return;
        }
        padding += isPad ? 1 : 0;
        bits = (bits << 6) | (isPad ? 0 : value);
        if (++pending == 4) {
            emit();
        }
    }

    private void emit() {
        pending = 0;
        int more = 3 - padding;
        isBad = more < 1 || (bits & ((1 << (8 * padding)) - 1)) != 0;
        isFull = more > most - count;
        if (isBad || isFull) {
            return;
        }
        if (count + 3 > bytes.length) {
            bytes = Arrays.copyOf(bytes, (int) Math.min(most + 3L, 2L * bytes.length));
        }
        for (int k = 0; k < more; k++) {
            bytes[count++] = (byte) (bits >> (16 - 8 * k));
        }
    }

    /** Whether there were more bytes than there may be. */
    boolean isFull() {
        return isFull;
    }

    /** Whether all that has come is base64. */
    boolean isWhole() {
        return !isBad && pending == 0;
    }

    int count() {
        return count;
    }

    byte[] bytes() {
        return Arrays.copyOf(bytes, count);
    }

    @Override
    public void flush() {}

    @Override
    public void close() {}
}
