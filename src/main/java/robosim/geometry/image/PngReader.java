package robosim.geometry.image;

import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.zip.CRC32;
import java.util.zip.DataFormatException;
import java.util.zip.Inflater;
import robosim.geometry.exact.Checks;

/**
 * Reads PNG (ISO/IEC 15948) as colour of 8 bits a channel: greys, colours and palettes of 1 to 16 bits, with or without
 * transparency, which is left out. Interlaced images are refused.
 *
 * <p>The size is checked before anything is allocated for it, no more is inflated than the size needs, and everything that
 * is wrong with a file is an {@link IOException} that says what.
 */
public final class PngReader {
    private static final byte[] SIGNATURE = {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};

    /** The most bytes of a chunk that is looked at whole: a palette. */
    private static final int PALETTE = 3 * 256;

    private static final int GREY = 0;
    private static final int COLOUR = 2;
    private static final int INDEXED = 3;
    private static final int GREY_ALPHA = 4;
    private static final int COLOUR_ALPHA = 6;

    private final DataInputStream in;
    private final CRC32 sum = new CRC32();
    private int width;
    private int height;
    private int bits;
    private int type;
    private int[] palette = new int[0];

    /** Bytes that the data chunk at hand still has. */
    private int left;

    private boolean isOver;

    private PngReader(InputStream in) {
        this.in = new DataInputStream(in);
    }

    /**
     * An image: rows from the top.
     *
     * @param pixels one number for each pixel, {@code 0xRRGGBB}
     */
    @SuppressWarnings("ArrayRecordComponent") // a carrier that nobody compares
    public record Pixels(int width, int height, int[] pixels) {}

    static byte[] signature() {
        return SIGNATURE.clone();
    }

    /**
     * Reads one image; what follows it in the stream may have been read too.
     *
     * @throws IOException if it is no PNG, is broken, interlaced, or has more than {@link PngWriter#MAX_PIXELS} pixels
     */
    public static Pixels read(InputStream in) throws IOException {
        try {
            return new PngReader(Checks.present("in", in)).read();
        } catch (EOFException e) {
            throw new IOException("a PNG ends before it is complete", e);
        }
    }

    private Pixels read() throws IOException {
        byte[] start = new byte[SIGNATURE.length];
        in.readFully(start);
        if (!Arrays.equals(start, SIGNATURE)) {
            throw new IOException("an image must be a PNG, whose first bytes are 89 50 4e 47 0d 0a 1a 0a");
        }
        readHeader();
        while (!openChunk("IDAT")) {
            if (isOver) {
                throw new IOException("a PNG must have data, of a chunk IDAT (got: none)");
            }
        }
        if (type == INDEXED && palette.length == 0) {
            throw new IOException("a PNG of indexed colours must have a palette before its data (got: none)");
        }
        return new Pixels(width, height, readData());
    }

    /** Begins the next chunk; one of another name is read to its end. Answers whether it has that name. */
    private boolean openChunk(String name) throws IOException {
        left = in.readInt();
        if (left < 0) {
            throw new IOException("a chunk's length must be at least 0 (got: " + left + ")");
        }
        byte[] found = new byte[4];
        in.readFully(found);
        sum.reset();
        sum.update(found);
        String is = new String(found, StandardCharsets.ISO_8859_1);
        if (is.equals(name)) {
            return true;
        }
        if (is.equals("PLTE")) {
            readPalette();
        } else {
            isOver = is.equals("IEND");
            if (!isOver && (found[0] & 0x20) == 0 && !is.equals("IDAT")) {
                throw new IOException(
                        "a PNG must have no chunk that one must know but IHDR, PLTE, IDAT and IEND (got: " + is + ")");
            }
            byte[] skipped = new byte[Math.min(left, 4096)];
            while (left > 0) {
                read(skipped, Math.min(left, skipped.length));
            }
        }
        closeChunk();
        return false;
    }

    private void read(byte[] into, int count) throws IOException {
        in.readFully(into, 0, count);
        sum.update(into, 0, count);
        left -= count;
    }

    private void closeChunk() throws IOException {
        if (in.readInt() != (int) sum.getValue()) {
            throw new IOException("a chunk of a PNG must have the checksum that it says (got: another)");
        }
    }

    private void readHeader() throws IOException {
        if (!openChunk("IHDR") || left != 13) {
            throw new IOException("a PNG must begin with a header of 13 bytes (got: another chunk)");
        }
        byte[] header = new byte[13];
        read(header, 13);
        closeChunk();
        width = number(header, 0);
        height = number(header, 4);
        if (width < 1 || height < 1 || (long) width * height > PngWriter.MAX_PIXELS) {
            throw new IOException("an image must have 1 to " + PngWriter.MAX_PIXELS + " pixels (got: "
                    + Integer.toUnsignedString(width) + " x " + Integer.toUnsignedString(height) + ")");
        }
        bits = header[8];
        type = header[9];
        boolean isKnown = switch (type) {
            case GREY -> bits == 1 || bits == 2 || bits == 4 || bits == 8 || bits == 16;
            case INDEXED -> bits == 1 || bits == 2 || bits == 4 || bits == 8;
            case COLOUR, GREY_ALPHA, COLOUR_ALPHA -> bits == 8 || bits == 16;
            default -> false;
        };
        if (!isKnown || header[10] != 0 || header[11] != 0) {
            throw new IOException("a PNG must be of a kind that its standard has (got: colour type " + type + " of "
                    + bits + " bits)");
        }
        if (header[12] != 0) {
            throw new IOException("a PNG must not be interlaced; save it again without (got: interlaced)");
        }
    }

    private static int number(byte[] b, int at) {
        return (b[at] & 0xff) << 24 | (b[at + 1] & 0xff) << 16 | (b[at + 2] & 0xff) << 8 | (b[at + 3] & 0xff);
    }

    private void readPalette() throws IOException {
        if (left < 3 || left > PALETTE || left % 3 != 0) {
            throw new IOException("a palette must have 1 to 256 colours (got: " + left + " bytes)");
        }
        byte[] colours = new byte[left];
        read(colours, left);
        palette = new int[colours.length / 3];
        for (int k = 0; k < palette.length; k++) {
            palette[k] = rgb(colours[3 * k], colours[3 * k + 1], colours[3 * k + 2]);
        }
    }

    private static int rgb(byte red, byte green, byte blue) {
        return (red & 0xff) << 16 | (green & 0xff) << 8 | (blue & 0xff);
    }

    private int[] readData() throws IOException {
        int channels = switch (type) {
            case GREY, INDEXED -> 1;
            case GREY_ALPHA -> 2;
            case COLOUR -> 3;
            default -> 4;
        };
        int length = (int) (((long) width * channels * bits + 7) / 8);
        RowFilter filter = new RowFilter(length, Math.max(1, channels * bits / 8));
        byte[] data = new byte[length];
        byte[] kind = new byte[1];
        Inflater inflater = new Inflater();
        try {
            int[] pixels = null; // made once the data has begun to make sense
            for (int row = 0; row < height; row++) {
                inflate(inflater, kind, 1);
                inflate(inflater, data, length);
                if (kind[0] < 0 || kind[0] >= RowFilter.KINDS) {
                    throw new IOException("a row's filter must be 0 to 4 (got: " + kind[0] + ")");
                }
                filter.restore(kind[0], data);
                pixels = pixels == null ? new int[width * height] : pixels;
                decode(filter.row(), channels, pixels, row * width);
                filter.next();
            }
            finish();
            return pixels == null ? new int[0] : pixels;
        } catch (DataFormatException e) {
            throw new IOException("the data of a PNG must be compressed by zlib (got: " + e.getMessage() + ")", e);
        } finally {
            inflater.end();
        }
    }

    /** Reads the chunk at hand to its end, for its checksum. */
    private void finish() throws IOException {
        byte[] rest = new byte[Math.min(left, 1 << 13)];
        while (left > 0) {
            read(rest, Math.min(left, rest.length));
        }
        closeChunk();
    }

    private void inflate(Inflater inflater, byte[] into, int count) throws IOException, DataFormatException {
        byte[] packed = new byte[0];
        int done = 0;
        while (done < count) {
            int more = inflater.inflate(into, done, count - done);
            done += more;
            if (more == 0) {
                if (inflater.finished() || inflater.needsDictionary()) {
                    throw new IOException("the data of a PNG must fill all its rows (got: less)");
                }
                packed = packed.length == 0 ? new byte[1 << 13] : packed;
                while (left == 0) {
                    closeChunk();
                    if (!openChunk("IDAT")) {
                        throw new IOException("the data of a PNG must fill all its rows (got: less)");
                    }
                }
                int piece = Math.min(left, packed.length);
                read(packed, piece);
                inflater.setInput(packed, 0, piece);
            }
        }
    }

    private void decode(byte[] row, int channels, int[] pixels, int at) throws IOException {
        int bytes = bits / 8;
        for (int k = 0; k < width; k++) {
            if (type == COLOUR || type == COLOUR_ALPHA) {
                int from = k * channels * bytes; // of 16 bits the higher byte
                pixels[at + k] = rgb(row[from], row[from + bytes], row[from + 2 * bytes]);
            } else if (type == INDEXED) {
                int index = sample(row, k);
                if (index >= palette.length) {
                    throw new IOException(
                            "an indexed colour must be in the palette of " + palette.length + " (got: " + index + ")");
                }
                pixels[at + k] = palette[index];
            } else {
                int grey = bits >= 8 ? row[k * channels * bytes] & 0xff : sample(row, k) * 255 / ((1 << bits) - 1);
                pixels[at + k] = grey * 0x010101;
            }
        }
    }

    /** A sample of at most 8 bits. */
    private int sample(byte[] row, int k) {
        int bit = k * bits;
        return (row[bit >> 3] & 0xff) >> (8 - bits - (bit & 7)) & ((1 << bits) - 1);
    }
}
