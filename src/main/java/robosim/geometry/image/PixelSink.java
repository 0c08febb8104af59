package robosim.geometry.image;

import java.io.IOException;

/** Takes the pixels of an image while it is read, so that no reader needs room for all of them. */
public interface PixelSink {
    /**
     * What an image is.
     *
     * @param white    the largest value of a sample
     * @param channels samples of a pixel: 1 grey, 2 grey and opacity, 3 red, green and blue, 4 these and opacity
     */
    public record Format(int width, int height, int white, int channels) {
        /** Whether the last sample of a pixel is its opacity. */
        public boolean hasOpacity() {
            return channels % 2 == 0;
        }

        /** Whether a pixel has red, green and blue; else it is grey. */
        public boolean isColour() {
            return channels > 2;
        }
    }

    /**
     * Called once before all pixels. Since a small file may claim any size, room for pixels is best made when the first
     * come.
     *
     * @throws IOException or IllegalArgumentException to refuse the image
     */
    public void begin(Format format) throws IOException;

    /**
     * Takes pixels of a row. Each pixel of the image comes once, in any order.
     *
     * @param row     counted from 0 at the top
     * @param first   the column of the first pixel
     * @param step    from a column to the next
     * @param count   how many pixels there are
     * @param samples those of all of them, which change after the call
     */
    public void pixels(int row, int first, int step, int count, int[] samples) throws IOException;
}
