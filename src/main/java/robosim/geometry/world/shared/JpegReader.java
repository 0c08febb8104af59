package robosim.geometry.world.shared;

import java.awt.image.Raster;
import java.io.IOException;
import java.io.InputStream;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.MemoryCacheImageInputStream;
import robosim.geometry.material.ImageTexture;

/** Reads JPEG images, grey or in colour, by the decoder of the JDK. */
final class JpegReader {
    /** Receives the size of an image before it is decoded, and refuses it if it is too large. */
    @FunctionalInterface
    interface Size {
        void check(long width, long height);
    }

    private JpegReader() {}

    static boolean isJpeg(byte[] start) {
        return start.length >= 2 && start[0] == (byte) 0xff && start[1] == (byte) 0xd8;
    }

    static ImageTexture read(InputStream in, Size size) throws IOException {
        ImageReader reader = ImageIO.getImageReadersByFormatName("jpeg").next();
        try (var stream = new MemoryCacheImageInputStream(in)) {
            reader.setInput(stream, true, true);
            size.check(reader.getWidth(0), reader.getHeight(0));
            return picture(reader.read(0).getRaster());
        } finally {
            reader.dispose();
        }
    }

    // The samples themselves: a BufferedImage's own colours would come through a profile.
    private static ImageTexture picture(Raster raster) throws IOException {
        int bands = raster.getNumBands();
        if (bands != 1 && bands != 3) {
            throw new IOException("a JPEG must be grey or of three colours (got: " + bands + " channels)");
        }
        int width = raster.getWidth();
        int[] pixels = new int[width * raster.getHeight()];
        int[] row = new int[bands * width];
        for (int y = 0; y < raster.getHeight(); y++) {
            raster.getPixels(0, y, width, 1, row);
            for (int x = 0; x < width; x++) {
                int at = x * bands;
                pixels[y * width + x] =
                        bands == 1 ? row[at] * 0x010101 : row[at] << 16 | row[at + 1] << 8 | row[at + 2];
            }
        }
        return new ImageTexture(width, raster.getHeight(), pixels, 1, 1);
    }
}
