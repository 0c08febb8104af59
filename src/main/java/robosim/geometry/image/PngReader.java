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
import robosim.geometry.check.Checks;

/**
 * Reads PNG (ISO/IEC 15948): greys, colours and palettes of 1 to 16 bits, with or without opacity, interlaced or not.
 *
 * <p>No more is inflated than the size needs, and everything that is wrong with a file is an {@link IOException} that says
 * what.
 */
public final class PngReader {
    private static final byte[] SIGNATURE = {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};

    /** The most bytes of a chunk that is looked at whole: a palette. */
    private static final int PALETTE = 3 * 256;

    /** The most pixels of an image, whoever takes them. */
    private static final int MOST_PIXELS = 1 << 28;

    /** The most bytes of a row. */
    private static final int MOST_BYTES = 1 << 27;

    /** The most pixels that are given at once. */
    private static final int PIECE = 4096;

    /** The seven passes of an interlaced image (8.2): the first column and row of each, and the steps to the next. */
    private static final int[][] PASSES = {
        {0, 0, 8, 8}, {4, 0, 8, 8}, {0, 4, 4, 8}, {2, 0, 4, 4}, {0, 2, 2, 4}, {1, 0, 2, 2}, {0, 1, 1, 2}
    };

    private static final int[][] WHOLE = {{0, 0, 1, 1}};

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
    private boolean isInterlaced;
    private int[] palette = new int[0];

    /** Of a palette the opacity of each colour; else the samples of the one colour that is transparent; empty if none. */
    private int[] transparent = new int[0];

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
     * Reads one image as colours of 8 bits a channel, without its opacity; what follows it in the stream may have been read
     * too.
     *
     * @throws IOException if it is no PNG, is broken, or has more than {@link PngWriter#MAX_PIXELS} pixels
     */
    public static Pixels read(InputStream in) throws IOException {
        RgbPixels pixels = new RgbPixels();
        read(in, pixels);
        return pixels.taken();
    }

    /**
     * Reads one image piece by piece; what follows it in the stream may have been read too.
     *
     * @throws IOException if it is no PNG, is broken, or has more than 2^28 pixels
     */
    public static void read(InputStream in, PixelSink sink) throws IOException {
        try {
            new PngReader(Checks.present("in", in)).into(Checks.present("sink", sink));
        } catch (EOFException e) {
            throw new IOException("a PNG ends before it is complete", e);
        }
    }

    private void into(PixelSink sink) throws IOException {
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
        boolean hasOpacity = transparent.length > 0 || type == GREY_ALPHA || type == COLOUR_ALPHA;
        int colours = type == GREY || type == GREY_ALPHA ? 1 : 3;
        int white = type == INDEXED ? 255 : (1 << bits) - 1;
        PixelSink.Format format = new PixelSink.Format(width, height, white, colours + (hasOpacity ? 1 : 0));
        sink.begin(format);
        readData(sink, format);
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
        } else if (is.equals("tRNS")) {
            readTransparency();
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
        if (width < 1 || height < 1 || (long) width * height > MOST_PIXELS) {
            throw new IOException("an image must have 1 to " + MOST_PIXELS + " pixels (got: "
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
        if (header[12] < 0 || header[12] > 1) {
            throw new IOException(
                    "a PNG must be interlaced in 7 passes or not at all (got: method " + header[12] + ")");
        }
        isInterlaced = header[12] == 1;
        if ((long) width * channels() * bits > 8L * MOST_BYTES) {
            throw new IOException("a row of an image must have at most " + MOST_BYTES
                    + " bytes; split it in several files, or simplify what is in it (got: more)");
        }
    }

    private int channels() {
        return switch (type) {
            case GREY, INDEXED -> 1;
            case GREY_ALPHA -> 2;
            case COLOUR -> 3;
            default -> 4;
        };
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

    private void readTransparency() throws IOException {
        int need = type == GREY ? 2 : type == COLOUR ? 6 : 0;
        if (type == INDEXED ? left > palette.length : left != need || need == 0) {
            throw new IOException("a chunk tRNS must be as long as the colours need (got: " + left + " bytes)");
        }
        byte[] bytes = new byte[left];
        read(bytes, left);
        if (type == INDEXED) {
            transparent = new int[palette.length];
            Arrays.fill(transparent, 255);
            for (int k = 0; k < bytes.length; k++) {
                transparent[k] = bytes[k] & 0xff;
            }
        } else {
            transparent = new int[need / 2];
            for (int k = 0; k < transparent.length; k++) {
                transparent[k] = (bytes[2 * k] & 0xff) << 8 | (bytes[2 * k + 1] & 0xff);
            }
        }
    }

    private void readData(PixelSink sink, PixelSink.Format format) throws IOException {
        Inflater inflater = new Inflater();
        try {
            for (int[] pass : isInterlaced ? PASSES : WHOLE) {
                readPass(inflater, pass, sink, format);
            }
            finish();
        } catch (DataFormatException e) {
            throw new IOException("the data of a PNG must be compressed by zlib (got: " + e.getMessage() + ")", e);
        } finally {
            inflater.end();
        }
    }

    private void readPass(Inflater inflater, int[] pass, PixelSink sink, PixelSink.Format format)
            throws IOException, DataFormatException {
        int columns = (width - pass[0] + pass[2] - 1) / pass[2];
        if (columns <= 0) {
            return; // such a pass has no bytes, not even those that name the filters
        }
        int length = (int) (((long) columns * channels() * bits + 7) / 8);
        RowFilter filter = new RowFilter(length, Math.max(1, channels() * bits / 8));
        byte[] data = new byte[length];
        byte[] kind = new byte[1];
        int[] samples = new int[Math.min(columns, PIECE) * format.channels()];
        for (int row = pass[1]; row < height; row += pass[3]) {
            inflate(inflater, kind, 1);
            inflate(inflater, data, length);
            if (kind[0] < 0 || kind[0] >= RowFilter.KINDS) {
                throw new IOException("a row's filter must be 0 to 4 (got: " + kind[0] + ")");
            }
            filter.restore(kind[0], data);
            for (int from = 0; from < columns; from += PIECE) {
                int count = Math.min(PIECE, columns - from);
                decode(filter.row(), from, count, samples);
                sink.pixels(row, pass[0] + from * pass[2], pass[2], count, samples);
            }
            filter.next();
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

    /** Turns the bytes of pixels into samples: a palette's into colours, and a transparent colour's into an opacity. */
    private void decode(byte[] row, int from, int count, int[] samples) throws IOException {
        if (type == INDEXED) {
            decodeIndices(row, from, count, samples);
            return;
        }
        int channels = channels();
        int extra = transparent.length > 0 ? 1 : 0;
        int at = 0;
        for (int k = from * channels; k < (from + count) * channels; k += channels) {
            boolean isTransparent = extra > 0;
            for (int n = 0; n < channels; n++) {
                int value = sample(row, k + n);
                isTransparent = isTransparent && value == transparent[n];
                samples[at++] = value;
            }
            if (extra > 0) {
                samples[at++] = isTransparent ? 0 : (1 << bits) - 1;
            }
        }
    }

    private void decodeIndices(byte[] row, int from, int count, int[] samples) throws IOException {
        int at = 0;
        for (int k = from; k < from + count; k++) {
            int index = sample(row, k);
            if (index >= palette.length) {
                throw new IOException(
                        "an indexed colour must be in the palette of " + palette.length + " (got: " + index + ")");
            }
            int colour = palette[index];
            samples[at++] = colour >> 16;
            samples[at++] = colour >> 8 & 0xff;
            samples[at++] = colour & 0xff;
            if (transparent.length > 0) {
                samples[at++] = transparent[index];
            }
        }
    }

    /** The k-th sample of a row. */
    private int sample(byte[] row, int k) {
        if (bits == 8) {
            return row[k] & 0xff;
        }
        if (bits == 16) {
            return (row[2 * k] & 0xff) << 8 | (row[2 * k + 1] & 0xff);
        }
        int bit = k * bits;
        return (row[bit >> 3] & 0xff) >> (8 - bits - (bit & 7)) & ((1 << bits) - 1);
    }
}
