package robosim.geometry.render;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import robosim.geometry.Geometry;
import robosim.geometry.Snapshot;
import robosim.geometry.check.Checks;
import robosim.geometry.image.PngWriter;
import robosim.geometry.model.Dimension;

/**
 * Takes the pictures of a {@link ColorCamera}, with the working memory for them. Used again for the next picture, it
 * allocates nothing more unless that is larger, or the world is PLANAR. A frame is used by one call at a time.
 */
public final class ColorFrame {
    private int width;
    private int height;
    private int[] pixels = new int[0];
    private BlockPainter[] painters = new BlockPainter[0];
    private @Nullable Snapshot snapshot;
    private @Nullable SkyShade shade;

    /** An empty frame. */
    public ColorFrame() {}

    /** Makes room, and forgets what was there. */
    void reset(int newWidth, int newHeight) {
        width = 0;
        height = 0;
        if (pixels.length != newWidth * newHeight) {
            pixels = new int[newWidth * newHeight];
        }
    }

    /** Says that all pixels have been written. */
    void finish(int newWidth, int newHeight) {
        width = newWidth;
        height = newHeight;
    }

    /** Room for the shadows of the sky; made for the first picture that has them. */
    SkyShade shade(FramePlan plan) {
        SkyShade room = shade;
        if (room == null) {
            room = new SkyShade();
            shade = room;
        }
        room.reset(plan.width, plan.height, plan.widthOfPixel());
        return room;
    }

    /** One painter for each thread, all of them for copies of one snapshot. */
    BlockPainter[] painters(Snapshot of, int count) {
        if (snapshot != of || painters.length < count) {
            painters = new BlockPainter[count];
            snapshot = of;
            Snapshot seen = of.withHeights();
            for (int k = 0; k < count; k++) {
                painters[k] = new BlockPainter(seen.toGeometry());
            }
        }
        return painters;
    }

    /** The painter of a world. */
    BlockPainter painter(Geometry world) {
        if (world.dimension() == Dimension.PLANAR) {
            return painters(world.snapshot(), 1)[0];
        }
        if (snapshot != null || painters.length == 0 || !painters[0].isOf(world)) {
            painters = new BlockPainter[] {new BlockPainter(world)};
            snapshot = null;
        }
        return painters[0];
    }

    /** Pixels in a row; 0 before the first picture, and after a call that threw an exception. */
    public int width() {
        return width;
    }

    /** The number of rows. */
    public int height() {
        return height;
    }

    /**
     * All pixels, row by row from the top, {@code 0xRRGGBB} in sRGB: the frame's own array, no copy. A later call writes to
     * the same array unless its picture has another size.
     */
    public int[] pixels() {
        return pixels;
    }

    /** One pixel, {@code 0xRRGGBB}. */
    public int pixel(int column, int row) {
        if (column < 0 || column >= width || row < 0 || row >= height) {
            throw new IllegalArgumentException("column and row must be in the picture of " + width + " x " + height
                    + " (got: " + column + " and " + row + ")");
        }
        return pixels[row * width + column];
    }

    /**
     * Writes the picture as a PNG of 8 bits a channel.
     *
     * @throws IllegalStateException if nothing has been rendered yet
     */
    public void writePng(OutputStream out) throws IOException {
        Checks.present("out", out);
        if (width == 0) {
            throw new IllegalStateException("a frame must have a picture: render first (got: none)");
        }
        PngWriter.writeColour(out, width, height, pixels);
    }

    /** Writes the picture to a file. */
    public void writePng(Path file) throws IOException {
        Checks.present("file", file);
        if (width == 0) {
            throw new IllegalStateException("a frame must have a picture: render first (got: none)");
        }
        try (OutputStream out = new BufferedOutputStream(Files.newOutputStream(file))) {
            writePng(out);
        }
    }
}
