package robosim.geometry.image;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;

/**
 * Writes a film as an animated GIF (89a), picture by picture; it begins again after its end. Each picture has its own 255
 * colours, found by halving the box of its colours where they differ most, so that few colours are kept exactly. Pixels
 * that are as before are not written again, so what stands still takes no room.
 */
public final class GifWriter {
    private static final int MAX_SIDE = 65_535;
    private static final int COLOURS = 256;

    /** The index of pixels that stay as they are, and how many colours there are for all others. */
    private static final int SAME = 255;

    /** Colours are counted by the upper bits of their components. */
    private static final int BITS = 5;

    private static final int BINS = 1 << (3 * BITS);

    private static final int CLEAR = COLOURS;
    private static final int END = COLOURS + 1;
    private static final int MOST_CODES = 1 << 12;

    private final OutputStream out;
    private final int width;
    private final int height;
    private final int hundredths;
    private final long[][] sums = new long[BINS][4];
    private final byte[] indexOf = new byte[BINS];

    // The codes of sequences of pixels: by code and next pixel, the longer sequence's code.
    private final short[] codes = new short[MOST_CODES * COLOURS];
    private final byte[] piece = new byte[255];
    private int @Nullable [] before;
    private int filled;
    private int bits;
    private int pending;

    /**
     * Begins a film.
     *
     * @param out     is left open
     * @param width   of each picture, 1 to 65,535 pixels
     * @param height  of each picture, 1 to 65,535 pixels
     * @param seconds for which each picture is shown, 0.01 to 655.35
     */
    public GifWriter(OutputStream out, int width, int height, double seconds) throws IOException {
        this.out = Checks.present("out", out);
        if (width < 1 || width > MAX_SIDE || height < 1 || height > MAX_SIDE) {
            throw new IllegalArgumentException(
                    "width and height must be from 1 to " + MAX_SIDE + " (got: " + width + " x " + height + ")");
        }
        if (!(seconds >= 0.01 && seconds <= 655.35)) { // written so that NaN fails it
            throw new IllegalArgumentException("seconds must be from 0.01 to 655.35 (got: " + seconds + ")");
        }
        this.width = width;
        this.height = height;
        hundredths = (int) Math.rint(100 * seconds);
        out.write("GIF89a".getBytes(StandardCharsets.US_ASCII));
        pair(width);
        pair(height);
        out.write(new byte[] {0x70, 0, 0}); // no colours for all pictures
        out.write(new byte[] {0x21, (byte) 0xff, 11});
        out.write("NETSCAPE2.0".getBytes(StandardCharsets.US_ASCII));
        out.write(new byte[] {3, 1, 0, 0, 0}); // again and again
    }

    /**
     * Adds a picture.
     *
     * @param pixels row by row from the top, {@code 0xRRGGBB}
     */
    public void add(int[] pixels) throws IOException {
        if (Checks.present("pixels", pixels).length != width * height) {
            throw new IllegalArgumentException(
                    "pixels must be " + width + " x " + height + " (got: " + pixels.length + " in all)");
        }
        out.write(new byte[] {0x21, (byte) 0xf9, 4, (byte) (before == null ? 4 : 5)}); // drawn over the last picture
        pair(hundredths);
        out.write(new byte[] {(byte) SAME, 0, 0x2c, 0, 0, 0, 0});
        pair(width);
        pair(height);
        out.write(0x87); // 256 colours of its own
        out.write(colours(pixels));
        compress(pixels);
        before = pixels.clone();
    }

    /** Ends the film. */
    public void end() throws IOException {
        out.write(0x3b);
    }

    private void pair(int number) throws IOException {
        out.write(number);
        out.write(number >> 8);
    }

    private static int bin(int pixel) {
        int red = pixel >> (24 - BITS) & 31;
        int green = pixel >> (16 - BITS) & 31;
        int blue = pixel >> (8 - BITS) & 31;
        return red << (2 * BITS) | green << BITS | blue;
    }

    private boolean isSame(int[] pixels, int k) {
        return before != null && before[k] == pixels[k];
    }

    private int index(int[] pixels, int k) {
        return isSame(pixels, k) ? SAME : indexOf[bin(pixels[k])] & 0xff;
    }

    /** Chooses the colours of what a picture changes, and to each bin its colour. */
    private byte[] colours(int[] pixels) {
        for (long[] sum : sums) {
            Arrays.fill(sum, 0);
        }
        for (int k = 0; k < pixels.length; k++) {
            if (isSame(pixels, k)) {
                continue;
            }
            int pixel = pixels[k];
            long[] sum = sums[bin(pixel)];
            sum[0]++;
            for (int c = 1; c <= 3; c++) {
                sum[c] += pixel >> (24 - 8 * c) & 0xff;
            }
        }
        List<int[]> boxes = new ArrayList<>();
        int[] used =
                IntStream.range(0, sums.length).filter(bin -> sums[bin][0] > 0).toArray();
        if (used.length > 0) {
            boxes.add(used);
        }
        while (boxes.size() < SAME && halve(boxes)) {
            // until all colours are used, or each bin has its own
        }
        byte[] table = new byte[3 * COLOURS];
        for (int k = 0; k < boxes.size(); k++) {
            long[] all = new long[4];
            for (int bin : boxes.get(k)) {
                indexOf[bin] = (byte) k;
                for (int c = 0; c < 4; c++) {
                    all[c] += sums[bin][c];
                }
            }
            for (int c = 0; c < 3; c++) {
                table[3 * k + c] = (byte) ((all[c + 1] + all[0] / 2) / all[0]);
            }
        }
        return table;
    }

    private static int component(int bin, int axis) {
        return bin >> (BITS * (2 - axis)) & 31;
    }

    /** Halves the box whose pixels differ most along an axis; answers whether there was one to halve. */
    private boolean halve(List<int[]> boxes) {
        int worst = -1;
        int along = 0;
        double most = 0;
        for (int k = 0; k < boxes.size(); k++) {
            for (int axis = 0; axis < 3; axis++) {
                double spread = spread(boxes.get(k), axis);
                if (spread > most) {
                    most = spread;
                    worst = k;
                    along = axis;
                }
            }
        }
        if (worst < 0) {
            return false;
        }
        int[] bins = boxes.get(worst);
        int axis = along;
        double middle = mean(bins, axis);
        boxes.set(
                worst,
                Arrays.stream(bins)
                        .filter(bin -> component(bin, axis) <= middle)
                        .toArray());
        boxes.add(
                Arrays.stream(bins).filter(bin -> component(bin, axis) > middle).toArray());
        return true;
    }

    private double mean(int[] bins, int axis) {
        double count = 0;
        double sum = 0;
        for (int bin : bins) {
            count += sums[bin][0];
            sum += (double) sums[bin][0] * component(bin, axis);
        }
        return sum / count;
    }

    /** The sum of the squares by which the pixels of a box are off their mean. */
    private double spread(int[] bins, int axis) {
        if (bins.length == 1) {
            return 0;
        }
        double mean = mean(bins, axis);
        double sum = 0;
        for (int bin : bins) {
            double off = component(bin, axis) - mean;
            sum += sums[bin][0] * off * off;
        }
        return sum;
    }

    /** Lempel, Ziv and Welch: sequences of pixels that came before are one code. */
    private void compress(int[] pixels) throws IOException {
        out.write(8);
        filled = 0;
        bits = 0;
        pending = 0;
        int next = END + 1;
        int length = 9;
        code(CLEAR, length);
        int sequence = index(pixels, 0);
        for (int k = 1; k < pixels.length; k++) {
            int pixel = index(pixels, k);
            int longer = codes[sequence * COLOURS + pixel];
            if (longer > 0) {
                sequence = longer;
                continue;
            }
            code(sequence, length);
            if (next == MOST_CODES) {
                code(CLEAR, length);
                Arrays.fill(codes, (short) 0);
                next = END + 1;
                length = 9;
            } else {
                length = next == 1 << length ? length + 1 : length;
                codes[sequence * COLOURS + pixel] = (short) next++;
            }
            sequence = pixel;
        }
        code(sequence, length);
        code(END, next == 1 << length && length < 12 ? length + 1 : length);
        Arrays.fill(codes, (short) 0);
        if (bits > 0) {
            put(pending);
        }
        flush();
        out.write(0);
    }

    private void code(int code, int length) throws IOException {
        pending |= code << bits;
        bits += length;
        while (bits >= 8) {
            put(pending);
            pending >>>= 8;
            bits -= 8;
        }
    }

    private void put(int number) throws IOException {
        piece[filled++] = (byte) number;
        if (filled == piece.length) {
            flush();
        }
    }

    private void flush() throws IOException {
        if (filled > 0) {
            out.write(filled);
            out.write(piece, 0, filled);
            filled = 0;
        }
    }
}
