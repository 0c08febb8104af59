package robosim.geometry.protocol.batch;

import java.io.Serial;
import java.util.Arrays;
import robosim.geometry.check.Checks;
import robosim.geometry.model.RayPattern;

/**
 * The picture that a {@link PictureRequest} asked for.
 *
 * @param width  pixels in a row
 * @param height rows
 * @param rgb    red, green and blue of each pixel in sRGB, a byte each, row by row from the top; copied, on the way in and out
 */
@SuppressWarnings("ArrayRecordComponent") // copied, and compared by its elements
public record PictureAnswer(int width, int height, byte[] rgb) implements BatchAnswer {
    @Serial
    private static final long serialVersionUID = 1;

    /** Refuses null, a picture without pixels, and an array of another length than its pixels take. */
    public PictureAnswer {
        if (width < 1 || height < 1 || height > RayPattern.MAX_SIZE / width) {
            throw new IllegalArgumentException("width and height must be at least 1, and their product at most "
                    + RayPattern.MAX_SIZE + " (got: " + width + " x " + height + ")");
        }
        rgb = Checks.present("rgb", rgb).clone();
        if (rgb.length != 3L * width * height) {
            throw new IllegalArgumentException("rgb must have " + 3L * width * height + " bytes for " + width + " x "
                    + height + " pixels (got: " + rgb.length + ")");
        }
    }

    /**
     * A picture from packed pixels.
     *
     * @param pixels {@code 0xRRGGBB} each, row by row from the top
     */
    public static PictureAnswer of(int width, int height, int[] pixels) {
        byte[] rgb = new byte[3 * Checks.present("pixels", pixels).length];
        for (int k = 0; k < pixels.length; k++) {
            rgb[3 * k] = (byte) (pixels[k] >> 16);
            rgb[3 * k + 1] = (byte) (pixels[k] >> 8);
            rgb[3 * k + 2] = (byte) pixels[k];
        }
        return new PictureAnswer(width, height, rgb);
    }

    @Override
    public byte[] rgb() {
        return rgb.clone();
    }

    /** One pixel, {@code 0xRRGGBB}. */
    public int pixel(int column, int row) {
        if (column < 0 || column >= width || row < 0 || row >= height) {
            throw new IllegalArgumentException("column and row must be in the picture of " + width + " x " + height
                    + " (got: " + column + " and " + row + ")");
        }
        int at = 3 * (row * width + column);
        return (rgb[at] & 255) << 16 | (rgb[at + 1] & 255) << 8 | (rgb[at + 2] & 255);
    }

    @Override
    public boolean fits(BatchRequest request) {
        return Checks.present("request", request) instanceof PictureRequest picture
                && picture.camera().width() == width
                && picture.camera().height() == height;
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof PictureAnswer that
                && width == that.width
                && height == that.height
                && Arrays.equals(rgb, that.rgb);
    }

    @Override
    public int hashCode() {
        return 31 * width + Arrays.hashCode(rgb);
    }

    @Override
    public String toString() {
        return "PictureAnswer[" + width + " x " + height + "]";
    }
}
