package robosim.geometry.world.shared;

import java.io.IOException;
import robosim.geometry.image.PixelSink;

/** Reads a PGM image, text (P2) or binary (P5), with 1 or 2 bytes per pixel. */
final class PgmReader {
    private static final int MOST = 65_535;

    /** The most pixels that are given at once. */
    private static final int PIECE = 4096;

    private PgmReader() {}

    static void read(byte[] bytes, String source, PixelSink sink) throws IOException {
        AsciiScanner words = new AsciiScanner(bytes, source, '#');
        boolean isText = words.expect("P2 or P5", "P2", "P5") == 0;
        int width = words.digits("the width", 1, Limits.MAX_MAP_CELLS);
        int height = words.digits("the height", 1, Limits.MAX_MAP_CELLS);
        int white = 0;
        try {
            if ((long) width * height > Limits.MAX_MAP_CELLS) {
                throw new IllegalArgumentException("an image must have 1 to " + Limits.MAX_MAP_CELLS + " pixels (got: "
                        + width + " x " + height + ")");
            }
            white = words.digits("the value of white", 1, MOST);
            sink.begin(new PixelSink.Format(width, height, white, 1));
        } catch (IllegalArgumentException e) {
            throw words.wrong(String.valueOf(e.getMessage()));
        }
        int most = white;
        if (isText) {
            copy(width, height, (row, column) -> words.digits("a pixel", 0, most), sink);
            if (words.next()) {
                throw words.wrong("an image must end after its last pixel (got: "
                        + words.word().length() + " more)");
            }
            return;
        }
        int size = white < 256 ? 1 : 2;
        int from = words.behind();
        long need = (long) width * height * size;
        long there = bytes.length - (long) from;
        if (there != need) {
            throw new FileProblem(
                    source,
                    "an image of " + width + " x " + height + " pixels must have " + need + " bytes after its header; "
                            + (there < need
                                    ? "it is truncated (got: " + Math.max(0, there) + ")"
                                    : "there is extra data after its last pixel, so save it again (got: " + there
                                            + ")"));
        }
        copy(
                width,
                height,
                (row, column) -> {
                    int at = from + size * (row * width + column);
                    int value = size == 1 ? bytes[at] & 0xff : 256 * (bytes[at] & 0xff) + (bytes[at + 1] & 0xff);
                    if (value > most) {
                        throw new FileProblem(
                                source,
                                "a pixel must be at most white, " + most + " (got: " + value + " in column "
                                        + (column + 1) + " of row " + (row + 1) + ")");
                    }
                    return value;
                },
                sink);
    }

    /** Reads the value of the next pixel of the file. */
    @FunctionalInterface
    private interface Pixel {
        int next(int row, int column) throws IOException;
    }

    private static void copy(int width, int height, Pixel from, PixelSink sink) throws IOException {
        int[] samples = new int[Math.min(width, PIECE)];
        for (int row = 0; row < height; row++) {
            for (int x = 0; x < width; x += PIECE) {
                int count = Math.min(PIECE, width - x);
                for (int k = 0; k < count; k++) {
                    samples[k] = from.next(row, x + k);
                }
                sink.pixels(row, x, 1, count, samples);
            }
        }
    }
}
