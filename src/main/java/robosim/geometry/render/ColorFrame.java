package robosim.geometry.render;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import robosim.geometry.Geometry;
import robosim.geometry.Snapshot;
import robosim.geometry.check.Checks;
import robosim.geometry.image.PngWriter;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;

/**
 * Takes the pictures of a {@link ColorCamera}, with the working memory for them. Used again for the next picture, it
 * allocates nothing more unless that is larger, or the world is PLANAR. A frame is used by one call at a time.
 */
public final class ColorFrame {
    /** How far the components of pixels may be apart, of 255, without an edge between them. */
    private static final int ALIKE = 8;

    private int width;
    private int height;
    private int[] pixels = new int[0];
    private BlockPainter[] painters = new BlockPainter[0];
    private @Nullable Snapshot snapshot;
    private @Nullable SkyShade shade;
    private boolean[] edges = new boolean[0];

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

    /** By pixel, whether it differs visibly from one beside it. */
    boolean[] edges(int columns, int rows) {
        if (edges.length != pixels.length) {
            edges = new boolean[pixels.length];
        }
        Arrays.fill(edges, false);
        for (int at = 0; at < pixels.length; at++) {
            compare(at, (at + 1) % columns == 0 ? at : at + 1);
            compare(at, at + columns < columns * rows ? at + columns : at);
        }
        return edges;
    }

    private void compare(int at, int other) {
        for (int shift = 0; shift <= 16; shift += 8) {
            if (Math.abs((pixels[at] >> shift & 0xff) - (pixels[other] >> shift & 0xff)) > ALIKE) {
                edges[at] = true;
                edges[other] = true;
            }
        }
    }

    /** One painter for each thread, all of them for copies of one snapshot. */
    BlockPainter[] painters(Snapshot of, int count) {
        if (snapshot != of || painters.length < count) {
            painters = new BlockPainter[count];
            snapshot = of;
            Snapshot seen = of.asSeen();
            for (int k = 0; k < count; k++) {
                painters[k] = new BlockPainter(seen.toGeometry());
            }
        }
        return painters;
    }

    /** The painter of a world. */
    BlockPainter painter(Geometry world) {
        if (world.dimension() == Dimension.PLANAR || hasVisuals(world)) {
            return painters(world.snapshot(), 1)[0];
        }
        if (snapshot != null || painters.length == 0 || !painters[0].isOf(world)) {
            painters = new BlockPainter[] {new BlockPainter(world)};
            snapshot = null;
        }
        return painters[0];
    }

    private static boolean hasVisuals(Geometry world) {
        for (GeometryObject object : world.objects()) {
            if (object.visuals() != null) {
                return true;
            }
        }
        return false;
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
