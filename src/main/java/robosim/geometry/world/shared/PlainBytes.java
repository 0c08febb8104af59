package robosim.geometry.world.shared;

import java.io.BufferedInputStream;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/** The bytes of a text file without a byte order mark: some programs write one, and some write UTF-16. */
public final class PlainBytes {
    private PlainBytes() {}

    /** The text in UTF-8; the bytes themselves if they begin with no byte order mark. */
    public static byte[] of(byte[] bytes) {
        if (begins(bytes, 0xef, 0xbb, 0xbf)) {
            return Arrays.copyOfRange(bytes, 3, bytes.length);
        }
        Charset wide = begins(bytes, 0xff, 0xfe)
                ? StandardCharsets.UTF_16LE
                : begins(bytes, 0xfe, 0xff) ? StandardCharsets.UTF_16BE : null;
        return wide == null ? bytes : new String(bytes, 2, bytes.length - 2, wide).getBytes(StandardCharsets.UTF_8);
    }

    /** As {@link #of}, of a stream, of which only one in UTF-16 is read at once. */
    public static InputStream of(InputStream in) throws IOException {
        BufferedInputStream buffered = new BufferedInputStream(in);
        buffered.mark(3);
        byte[] start = buffered.readNBytes(3);
        buffered.reset();
        if (begins(start, 0xff, 0xfe) || begins(start, 0xfe, 0xff)) {
            return new ByteArrayInputStream(of(buffered.readAllBytes()));
        }
        buffered.skipNBytes(begins(start, 0xef, 0xbb, 0xbf) ? 3 : 0);
        return buffered;
    }

    private static boolean begins(byte[] bytes, int... start) {
        if (bytes.length < start.length) {
            return false;
        }
        for (int k = 0; k < start.length; k++) {
            if ((bytes[k] & 0xff) != start[k]) {
                return false;
            }
        }
        return true;
    }
}
