package robosim.geometry.image;

import java.io.IOException;

/** Takes an image as colours of 8 bits a channel; of 16 bits the higher 8, and no opacity. */
public final class RgbPixels implements PixelSink {
    private Format format = new Format(0, 0, 255, 1);
    private int[] pixels = {};

    @Override
    public void begin(Format given) throws IOException {
        if ((long) given.width() * given.height() > PngWriter.MAX_PIXELS) {
            throw new IOException("an image must have 1 to " + PngWriter.MAX_PIXELS + " pixels (got: " + given.width()
                    + " x " + given.height() + ")");
        }
        format = given;
    }

    @Override
    public void pixels(int row, int first, int step, int count, int[] samples) {
        if (pixels.length == 0) {
            pixels = new int[format.width() * format.height()];
        }
        int white = format.white();
        int from = row * format.width() + first;
        int at = 0;
        for (int k = 0; k < count; k++) {
            int red = bits8(samples[at], white);
            int pixel = format.isColour()
                    ? red << 16 | bits8(samples[at + 1], white) << 8 | bits8(samples[at + 2], white)
                    : red * 0x010101;
            pixels[from + k * step] = pixel;
            at += format.channels();
        }
    }

    private static int bits8(int sample, int white) {
        return white == 255 ? sample : white > 255 ? sample >> 8 : sample * 255 / white;
    }

    /** The image, once all of it was given. */
    public PngReader.Pixels taken() {
        return new PngReader.Pixels(format.width(), format.height(), pixels);
    }
}
