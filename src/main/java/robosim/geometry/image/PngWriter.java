package robosim.geometry.image;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.zip.CRC32;
import java.util.zip.Deflater;
import robosim.geometry.check.Checks;

/**
 * Writes PNG (ISO/IEC 15948): colour of 8 bits a channel, and greys of 8 or 16 bits, row by row from the top. The pixels
 * that a reader finds are those given; the file's bytes also depend on the JVM's zlib.
 */
public final class PngWriter {
    /** The most pixels of an image that is written or read: 8192 x 8192. */
    public static final int MAX_PIXELS = 1 << 26;

    private static final int GREY = 0;
    private static final int COLOUR = 2;
    private static final int PIECE = 1 << 15;

    private final OutputStream out;
    private final CRC32 sum = new CRC32();

    private PngWriter(OutputStream out) {
        this.out = out;
    }

    /** A row of bytes, as the file has them before they are filtered. */
    @FunctionalInterface
    private interface Rows {
        void write(int row, byte[] into);
    }

    /**
     * Writes a picture in colour.
     *
     * @param pixels one number for each pixel, {@code 0xRRGGBB} in sRGB; the highest byte means nothing
     */
    public static void writeColour(OutputStream out, int width, int height, int[] pixels) throws IOException {
        check(width, height, Checks.present("pixels", pixels).length);
        new PngWriter(Checks.present("out", out)).write(width, height, 8, COLOUR, (row, into) -> {
            int from = row * width;
            for (int k = 0; k < width; k++) {
                int pixel = pixels[from + k];
                into[3 * k] = (byte) (pixel >> 16);
                into[3 * k + 1] = (byte) (pixel >> 8);
                into[3 * k + 2] = (byte) pixel;
            }
        });
    }

    /**
     * Writes greys of 8 bits.
     *
     * @param pixels one number for each pixel, without sign
     */
    public static void writeGrey(OutputStream out, int width, int height, byte[] pixels) throws IOException {
        check(width, height, Checks.present("pixels", pixels).length);
        new PngWriter(Checks.present("out", out))
                .write(width, height, 8, GREY, (row, into) -> System.arraycopy(pixels, row * width, into, 0, width));
    }

    /**
     * Writes greys of 16 bits, such as depths in millimetres.
     *
     * @param pixels one number for each pixel, without sign
     */
    public static void writeGrey16(OutputStream out, int width, int height, short[] pixels) throws IOException {
        check(width, height, Checks.present("pixels", pixels).length);
        new PngWriter(Checks.present("out", out)).write(width, height, 16, GREY, (row, into) -> {
            int from = row * width;
            for (int k = 0; k < width; k++) {
                into[2 * k] = (byte) (pixels[from + k] >> 8);
                into[2 * k + 1] = (byte) pixels[from + k];
            }
        });
    }

    private static void check(int width, int height, int length) {
        if (width < 1 || height < 1 || (long) width * height > MAX_PIXELS) {
            throw new IllegalArgumentException(
                    "an image must have 1 to " + MAX_PIXELS + " pixels (got: " + width + " x " + height + ")");
        }
        if (length < width * height) {
            throw new IllegalArgumentException(
                    "pixels must have " + width * height + " elements (got: " + length + ")");
        }
    }

    private void write(int width, int height, int bits, int type, Rows rows) throws IOException {
        out.write(PngReader.signature());
        ByteBuffer header = ByteBuffer.allocate(13).putInt(width).putInt(height);
        header.put((byte) bits).put((byte) type); // compression, filters and no interlacing are 0
        chunk("IHDR", header.array(), 13);
        int step = type == COLOUR ? 3 : bits / 8;
        Deflater deflater = new Deflater(Deflater.BEST_COMPRESSION);
        try {
            compress(deflater, height, width * step, step, rows);
        } finally {
            deflater.end();
        }
        chunk("IEND", new byte[0], 0);
    }

    private void compress(Deflater deflater, int height, int length, int step, Rows rows) throws IOException {
        byte[] packed = new byte[PIECE];
        ByteArrayOutputStream waiting = new ByteArrayOutputStream();
        RowFilter filter = new RowFilter(length, step);
        for (int row = 0; row < height; row++) {
            rows.write(row, filter.row());
            deflater.setInput(filter.filtered());
            while (!deflater.needsInput()) {
                waiting.write(packed, 0, deflater.deflate(packed));
            }
            if (waiting.size() >= PIECE) {
                flush(waiting);
            }
        }
        deflater.finish();
        while (!deflater.finished()) {
            waiting.write(packed, 0, deflater.deflate(packed));
        }
        flush(waiting);
    }

    private void flush(ByteArrayOutputStream waiting) throws IOException {
        chunk("IDAT", waiting.toByteArray(), waiting.size());
        waiting.reset();
    }

    private void chunk(String name, byte[] data, int length) throws IOException {
        byte[] type = name.getBytes(StandardCharsets.US_ASCII);
        out.write(ByteBuffer.allocate(4).putInt(length).array());
        out.write(type);
        out.write(data, 0, length);
        sum.reset();
        sum.update(type);
        sum.update(data, 0, length);
        out.write(ByteBuffer.allocate(4).putInt((int) sum.getValue()).array());
    }
}
