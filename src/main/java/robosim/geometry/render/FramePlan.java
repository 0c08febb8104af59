package robosim.geometry.render;

import org.jspecify.annotations.Nullable;
import robosim.geometry.exact.Degrees;
import robosim.geometry.model.RayPattern;

/**
 * The samples of a picture, in blocks that are painted one by one. Samples that follow each other are near each other in the
 * picture: a block is made of patches of some 64 samples, a patch of pixels row by row, and the samples of a pixel are
 * together, row by row.
 */
final class FramePlan {
    /** About the side of a patch in samples: rays in such patches are searched together. */
    private static final int PATCH = 8;

    /** About the samples of a block. */
    private static final int BLOCK = 4096;

    /** The patterns of so many samples are kept, 24 bytes each. */
    private static final int KEPT = 1 << 21;

    final int width;
    final int height;

    /** Samples of a pixel in a row, and rows of them. */
    final int samples;

    private final double tangent;

    /** The side of a patch in pixels. */
    private final int side;

    /** Patches of a block, along each axis. */
    private final int patches;

    private final int across;
    private final int down;
    private final @Nullable RayPattern[] kept;

    FramePlan(int width, int height, double fieldOfView, int samples) {
        this.width = width;
        this.height = height;
        this.samples = samples;
        double half = fieldOfView / 2;
        tangent = Degrees.sin(half) / Degrees.cos(half);
        side = Math.max(1, PATCH / samples);
        int count = BLOCK / (side * side * samples * samples);
        int along = 1;
        while ((along + 1) * (along + 1) <= count) {
            along++;
        }
        patches = along;
        across = parts(width, patches * side);
        down = parts(height, patches * side);
        kept = new RayPattern[(long) width * height * samples * samples <= KEPT ? blocks() : 0];
    }

    private static int parts(int count, int each) {
        return (count + each - 1) / each;
    }

    int blocks() {
        return across * down;
    }

    /** The width of a pixel one unit ahead of the camera. */
    double widthOfPixel() {
        return 2 * tangent / width;
    }

    /** The most pixels of a block. */
    int mostPixels() {
        return patches * side * patches * side;
    }

    /** Writes the pixels of a block, by their places in the picture, in the order of their samples; answers how many. */
    int pixels(int block, int[] out) {
        int left = block % across * patches * side;
        int top = block / across * patches * side;
        int count = 0;
        for (int patch = 0; patch < patches * patches; patch++) {
            int x = left + patch % patches * side;
            int y = top + patch / patches * side;
            for (int row = y; row < Math.min(y + side, height); row++) {
                for (int column = x; column < Math.min(x + side, width); column++) {
                    out[count++] = row * width + column;
                }
            }
        }
        return count;
    }

    /** The rays of a block's samples in the camera's own frame. */
    RayPattern pattern(int block, int[] pixels, int count) {
        if (kept.length == 0) {
            return made(pixels, count);
        }
        synchronized (kept) {
            RayPattern pattern = kept[block];
            if (pattern == null) {
                pattern = made(pixels, count);
                kept[block] = pattern;
            }
            return pattern;
        }
    }

    private RayPattern made(int[] pixels, int count) {
        double[] directions = new double[3 * count * samples * samples];
        int at = 0;
        for (int k = 0; k < count; k++) {
            int row = pixels[k] / width * samples;
            int column = pixels[k] % width * samples;
            for (int sample = 0; sample < samples * samples; sample++) {
                at = aim(row + sample / samples, column + sample % samples, directions, at);
            }
        }
        return RayPattern.of(directions);
    }

    /** As {@link RayPattern#pinhole} aims, to the bit. */
    private int aim(int row, int column, double[] out, int at) {
        int rows = height * samples;
        int columns = width * samples;
        double y = (double) (rows - 1 - 2 * row) / columns * tangent;
        double z = (double) (2 * column + 1 - columns) / columns * tangent;
        double length = Math.sqrt(1 + y * y + z * z);
        out[at] = 1 / length;
        out[at + 1] = y / length;
        out[at + 2] = z / length;
        return at + 3;
    }
}
