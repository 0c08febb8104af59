package robosim.geometry.material;

import java.io.InvalidObjectException;
import java.io.ObjectInputStream;
import java.io.Serial;
import java.io.Serializable;
import java.util.Arrays;
import robosim.geometry.check.Checks;

/**
 * A picture on a surface, repeated in both directions.
 *
 * <p>A texture of millions of pixels is shared by all materials that have it: copies of a material copy no pixel.
 */
public final class ImageTexture implements Texture {
    /** The most pixels: a picture of 8192 x 8192, 256 MB. */
    public static final int MOST_PIXELS = 1 << 26;

    private static final long serialVersionUID = 1;

    private final transient int width;
    private final transient int height;
    private final transient int[] pixels;
    private final transient double tileWidth;
    private final transient double tileHeight;

    /** Of the pixels, which are many. */
    private transient volatile int hash;

    /**
     * A picture.
     *
     * @param width      pixels of a row; at least 1
     * @param height     rows; at least 1. There are at most {@link #MOST_PIXELS} pixels
     * @param pixels     in sRGB, {@code 0xrrggbb}, the topmost row first; higher bits are ignored. Copied
     * @param tileWidth  world units that the picture covers before it repeats; above 0. Texture coordinates of a mesh count
     *     in pictures instead
     * @param tileHeight the same upwards
     */
    public ImageTexture(int width, int height, int[] pixels, double tileWidth, double tileHeight) {
        this(checked(width, height, pixels), width, height, tileWidth, tileHeight);
    }

    private ImageTexture(int[] ownPixels, int width, int height, double tileWidth, double tileHeight) {
        this.width = width;
        this.height = height;
        this.pixels = ownPixels;
        this.tileWidth = Checks.positive("tileWidth", tileWidth);
        this.tileHeight = Checks.positive("tileHeight", tileHeight);
    }

    /**
     * Checks the size of a picture, before room is made for its pixels.
     *
     * @return the number of pixels
     */
    public static int checkSize(long width, long height) {
        if (width < 1 || height < 1 || width > MOST_PIXELS || height > MOST_PIXELS / width) {
            throw new IllegalArgumentException("width and height must be at least 1, and their product at most "
                    + MOST_PIXELS + " pixels (got: " + width + " x " + height + ")");
        }
        return (int) (width * height);
    }

    private static int[] checked(int width, int height, int[] pixels) {
        int count = checkSize(width, height);
        if (Checks.present("pixels", pixels).length != count) {
            throw new IllegalArgumentException("pixels must have one number for each of " + width + " x " + height
                    + " (got: " + pixels.length + ")");
        }
        int[] own = pixels.clone();
        for (int k = 0; k < count; k++) {
            own[k] &= 0xffffff;
        }
        return own;
    }

    /** The same picture, sharing its pixels, with another size on a surface. */
    public ImageTexture tiled(double newWidth, double newHeight) {
        return new ImageTexture(pixels, width, height, newWidth, newHeight);
    }

    /** Pixels of a row. */
    public int width() {
        return width;
    }

    /** Rows. */
    public int height() {
        return height;
    }

    /** World units to the right that the picture covers before it repeats. */
    public double tileWidth() {
        return tileWidth;
    }

    /** World units upwards that the picture covers before it repeats. */
    public double tileHeight() {
        return tileHeight;
    }

    /**
     * One pixel, {@code 0xrrggbb} in sRGB.
     *
     * @param column from 0, at the left
     * @param row    from 0, at the top
     */
    public int pixel(int column, int row) {
        if (column < 0 || column >= width || row < 0 || row >= height) {
            throw new IllegalArgumentException("column and row must be in the picture of " + width + " x " + height
                    + " (got: " + column + " and " + row + ")");
        }
        return pixels[row * width + column];
    }

    /** All pixels, the topmost row first; a fresh array. */
    public int[] pixels() {
        return pixels.clone();
    }

    @Override
    public boolean equals(Object other) {
        return this == other
                || (other instanceof ImageTexture that
                        && width == that.width
                        && height == that.height
                        && tileWidth == that.tileWidth
                        && tileHeight == that.tileHeight
                        && (pixels == that.pixels || Arrays.equals(pixels, that.pixels)));
    }

    @Override
    public int hashCode() {
        int known = hash;
        if (known == 0) {
            known = Arrays.hashCode(pixels);
            hash = known;
        }
        return 31 * known + Double.hashCode(tileWidth + 3 * tileHeight);
    }

    @Override
    public String toString() {
        return "image of " + width + " x " + height + " pixels, " + tileWidth + " x " + tileHeight;
    }

    @Serial
    private Object writeReplace() {
        return new Form(width, height, bytes(), tileWidth, tileHeight);
    }

    @Serial
    private void readObject(ObjectInputStream in) throws InvalidObjectException {
        throw new InvalidObjectException("an image must come as its serial form (got: its own class)");
    }

    /** All pixels as bytes: red, green, blue of each, the topmost row first. */
    public byte[] bytes() {
        byte[] bytes = new byte[3 * pixels.length];
        for (int k = 0; k < pixels.length; k++) {
            bytes[3 * k] = (byte) (pixels[k] >> 16);
            bytes[3 * k + 1] = (byte) (pixels[k] >> 8);
            bytes[3 * k + 2] = (byte) pixels[k];
        }
        return bytes;
    }

    /**
     * A picture of given bytes.
     *
     * @param bytes as {@link #bytes} gives them: red, green, blue of each pixel
     */
    public static ImageTexture of(int width, int height, byte[] bytes, double tileWidth, double tileHeight) {
        int count = checkSize(width, height);
        if (Checks.present("bytes", bytes).length != 3L * count) {
            throw new IllegalArgumentException(
                    "bytes must have 3 for each of " + width + " x " + height + " pixels (got: " + bytes.length + ")");
        }
        int[] pixels = new int[count];
        for (int k = 0; k < count; k++) {
            pixels[k] = (bytes[3 * k] & 0xff) << 16 | (bytes[3 * k + 1] & 0xff) << 8 | (bytes[3 * k + 2] & 0xff);
        }
        return new ImageTexture(pixels, width, height, tileWidth, tileHeight);
    }

    /** The serialized form. */
    @SuppressWarnings("ArrayRecordComponent") // never compared, and the numbers are copied on the way in
    record Form(int width, int height, byte[] rgb, double tileWidth, double tileHeight) implements Serializable {
        @Serial
        private static final long serialVersionUID = 1;

        @Serial
        private Object readResolve() {
            return of(width, height, rgb, tileWidth, tileHeight);
        }
    }
}
