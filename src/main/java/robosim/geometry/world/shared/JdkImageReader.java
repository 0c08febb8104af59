package robosim.geometry.world.shared;

import java.awt.image.BufferedImage;
import java.awt.image.ColorModel;
import java.awt.image.DataBuffer;
import java.awt.image.IndexColorModel;
import java.awt.image.Raster;
import java.io.IOException;
import java.io.InputStream;
import java.util.Iterator;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.MemoryCacheImageInputStream;
import org.jspecify.annotations.Nullable;
import robosim.geometry.image.PixelSink;

/** Reads the samples of images in formats that only the JDK decodes: BMP, JPEG and TIFF, in its module java.desktop. */
final class JdkImageReader {
    /** Receives the size of an image before it is decoded, and refuses it if it is too large. */
    @FunctionalInterface
    interface Size {
        void check(int width, int height) throws IOException;
    }

    private JdkImageReader() {}

    /** The format of an image by its first bytes, as the JDK names it; null if it is none of these. */
    static @Nullable String format(byte[] bytes) {
        if (bytes.length < 4) {
            return null;
        }
        int first = (bytes[0] & 0xff) << 8 | (bytes[1] & 0xff);
        return switch (first) {
            case 'B' << 8 | 'M' -> "BMP";
            case 0xffd8 -> "JPEG";
            case 'I' << 8 | 'I' -> bytes[2] == 42 && bytes[3] == 0 ? "TIFF" : null;
            case 'M' << 8 | 'M' -> bytes[2] == 0 && bytes[3] == 42 ? "TIFF" : null;
            default -> null;
        };
    }

    static void read(InputStream in, String format, PixelSink sink, Size size) throws IOException {
        Iterator<ImageReader> readers = ImageIO.getImageReadersByFormatName(format);
        if (!readers.hasNext()) {
            throw new IOException("this Java has no reader of it; save the image as PNG");
        }
        ImageReader reader = readers.next();
        try (var stream = new MemoryCacheImageInputStream(in)) {
            reader.setInput(stream, true, true);
            size.check(reader.getWidth(0), reader.getHeight(0)); // before there is room for the pixels
            BufferedImage image = reader.read(0);
            ColorModel colours = image.getColorModel();
            if (colours instanceof IndexColorModel palette) {
                indexed(image.getRaster(), palette, sink);
            } else {
                direct(image.getRaster(), colours, sink);
            }
        } catch (FileWork.Ended e) {
            throw e;
        } catch (RuntimeException e) { // a broken image throws any
            throw new IOException(e.toString(), e);
        } catch (OutOfMemoryError e) {
            throw new IOException("it claims more memory than there is; save it as PNG or PGM", e);
        } finally {
            reader.dispose();
        }
    }

    /** Refuses an image of more pixels than a map may have. */
    static void check(int width, int height) throws IOException {
        if ((long) width * height > Limits.MAX_MAP_CELLS) {
            throw new IOException("an image must have at most " + Limits.MAX_MAP_CELLS
                    + " pixels; cut or scale it (got: " + width + " x " + height + ")");
        }
    }

    private static void indexed(Raster raster, IndexColorModel palette, PixelSink sink) throws IOException {
        int channels = palette.hasAlpha() ? 4 : 3;
        int width = raster.getWidth();
        sink.begin(new PixelSink.Format(width, raster.getHeight(), 255, channels));
        int[] indices = new int[width];
        int[] samples = new int[channels * width];
        for (int row = 0; row < raster.getHeight(); row++) {
            raster.getSamples(0, row, width, 1, 0, indices);
            for (int x = 0; x < width; x++) {
                int at = channels * x;
                samples[at] = palette.getRed(indices[x]);
                samples[at + 1] = palette.getGreen(indices[x]);
                samples[at + 2] = palette.getBlue(indices[x]);
                if (channels == 4) {
                    samples[at + 3] = palette.getAlpha(indices[x]);
                }
            }
            sink.pixels(row, 0, 1, width, samples);
        }
    }

    // The samples themselves: a BufferedImage's own colours would come through a profile.
    private static void direct(Raster raster, ColorModel colours, PixelSink sink) throws IOException {
        int channels = raster.getNumBands();
        int bits = raster.getSampleModel().getSampleSize(0);
        int type = raster.getSampleModel().getDataType();
        boolean isWhole = type == DataBuffer.TYPE_BYTE || type == DataBuffer.TYPE_USHORT || type == DataBuffer.TYPE_INT;
        boolean hasOpacity = colours.hasAlpha();
        if (!isWhole || bits > 16 || channels > 4 || hasOpacity != (channels % 2 == 0)) {
            throw new IOException(
                    "its pixels must be grey or of three colours, with samples of at most 16 bits; save it"
                            + " as PNG (got: " + channels + " channels of " + bits + " bits)");
        }
        for (int band = 1; band < channels; band++) {
            if (raster.getSampleModel().getSampleSize(band) != bits) {
                throw new IOException("its samples must have one size; save it as PNG (got: " + bits + " and "
                        + raster.getSampleModel().getSampleSize(band) + " bits)");
            }
        }
        int width = raster.getWidth();
        sink.begin(new PixelSink.Format(width, raster.getHeight(), (1 << bits) - 1, channels));
        int[] samples = new int[channels * width];
        for (int row = 0; row < raster.getHeight(); row++) {
            raster.getPixels(0, row, width, 1, samples);
            sink.pixels(row, 0, 1, width, samples);
        }
    }
}
