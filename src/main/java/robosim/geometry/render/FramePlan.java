package robosim.geometry.render;

import java.util.Objects;
import org.jspecify.annotations.Nullable;
import robosim.geometry.exact.Degrees;
import robosim.geometry.model.RayPattern;
import robosim.geometry.sensor.Intrinsics;

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

    /** How the pixels are painted again that differ from their neighbours; null if none are. */
    final @Nullable FramePlan edges;

    private final double fieldOfView;

    /** Into how many parts a sample's share of a pixel is divided along each axis: each row of samples is in another one. */
    private final int spread;

    private final double tangent;

    /** What aims the rays of a calibrated camera; null for one of a field of view. */
    private final @Nullable Intrinsics lens;

    /** The side of a patch in pixels. */
    private final int side;

    /** Patches of a block, along each axis. */
    private final int patches;

    private final int across;
    private final int down;
    private final @Nullable RayPattern[] kept;

    FramePlan(int width, int height, double fieldOfView, int samples) {
        this(width, height, fieldOfView, null, new Sampling(samples, 1, 0));
    }

    /** For a calibrated camera, of whose field of view only the width of a pixel is taken. */
    FramePlan(Intrinsics lens, double fieldOfView) {
        this(lens.width(), lens.height(), fieldOfView, lens, new Sampling(1, 1, 0));
    }

    /**
     * How many samples a pixel has.
     *
     * @param samples along each axis
     * @param spread  into how many parts a sample's share of a pixel is divided
     * @param atEdges samples of pixels that are painted again; 0 for none
     */
    private record Sampling(int samples, int spread, int atEdges) {}

    private FramePlan(int width, int height, double fieldOfView, @Nullable Intrinsics lens, Sampling sampling) {
        this.width = width;
        this.height = height;
        this.fieldOfView = fieldOfView;
        this.lens = lens;
        samples = sampling.samples;
        spread = sampling.spread;
        int atEdges = sampling.atEdges;
        edges = atEdges == 0
                ? null
                : new FramePlan(width, height, fieldOfView, lens, new Sampling(atEdges, atEdges, 0));
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

    /** The same picture with so many samples for each pixel along each axis. */
    FramePlan withSamples(int count) {
        return new FramePlan(width, height, fieldOfView, lens, new Sampling(count, 1, 0));
    }

    /** The same picture with one sample for each pixel, and so many along each axis where pixels differ. */
    FramePlan withEdges(int count) {
        return new FramePlan(width, height, fieldOfView, lens, new Sampling(1, 1, count == 1 ? 0 : count));
    }

    private static int parts(int count, int each) {
        return (count + each - 1) / each;
    }

    /** Whether another plan of this size has the same samples. */
    boolean isLike(FramePlan other) {
        return samples == other.samples
                && Objects.equals(lens, other.lens)
                && (edges == null ? other.edges == null : other.edges != null && edges.isLike(other.edges));
    }

    int blocks() {
        return across * down;
    }

    /** The intrinsic parameters for an image of so many times as many pixels along each axis. */
    Intrinsics intrinsics(int times) {
        Intrinsics given = lens;
        return given == null
                ? Intrinsics.fieldOfView(width * times, height * times, fieldOfView)
                : new Intrinsics(
                        width * times,
                        height * times,
                        given.fx() * times,
                        given.fy() * times,
                        (given.cx() + 0.5) * times - 0.5,
                        (given.cy() + 0.5) * times - 0.5,
                        given.distortion());
    }

    /** The width of a pixel one unit ahead of the camera. */
    double widthOfPixel() {
        return 2 * tangent / width;
    }

    /** The most pixels of a block. */
    int mostPixels() {
        return patches * side * patches * side;
    }

    /**
     * Writes the pixels of a block, by their places in the picture, in the order of their samples; answers how many.
     *
     * @param only the pixels that are wanted; null for all
     */
    int pixels(int block, boolean @Nullable [] only, int[] out) {
        int left = block % across * patches * side;
        int top = block / across * patches * side;
        int count = 0;
        for (int patch = 0; patch < patches * patches; patch++) {
            int x = left + patch % patches * side;
            int y = top + patch / patches * side;
            for (int row = y; row < Math.min(y + side, height); row++) {
                for (int column = x; column < Math.min(x + side, width); column++) {
                    if (only == null || only[row * width + column]) {
                        out[count++] = row * width + column;
                    }
                }
            }
        }
        return count;
    }

    /** The rays of a block's samples in the camera's own frame. */
    RayPattern pattern(int block, boolean @Nullable [] only, int[] pixels, int count) {
        if (kept.length == 0 || only != null) {
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
                int down = sample / samples;
                int along = sample % samples;
                at = spread == 1
                        ? aim(row + down, column + along, directions, at)
                        : aim((row + down) * spread + along, (column + along) * spread + down, directions, at);
            }
        }
        return RayPattern.of(directions);
    }

    /** As {@link RayPattern#pinhole} aims, to the bit, or as a calibrated camera does. */
    private int aim(int row, int column, double[] out, int at) {
        int rows = height * samples * spread;
        int columns = width * samples * spread;
        Intrinsics given = lens;
        if (given != null) {
            double share = 1.0 / (samples * spread);
            given.aim((column + 0.5) * share - 0.5, (row + 0.5) * share - 0.5, out, at);
            return at + 3;
        }
        double y = (double) (rows - 1 - 2 * row) / columns * tangent;
        double z = (double) (2 * column + 1 - columns) / columns * tangent;
        double length = Math.sqrt(1 + y * y + z * z);
        out[at] = 1 / length;
        out[at + 1] = y / length;
        out[at + 2] = z / length;
        return at + 3;
    }
}
