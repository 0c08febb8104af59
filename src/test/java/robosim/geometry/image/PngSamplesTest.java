package robosim.geometry.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.awt.Point;
import java.awt.Transparency;
import java.awt.color.ColorSpace;
import java.awt.image.BufferedImage;
import java.awt.image.ColorModel;
import java.awt.image.ComponentColorModel;
import java.awt.image.DataBuffer;
import java.awt.image.IndexColorModel;
import java.awt.image.Raster;
import java.awt.image.WritableRaster;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Random;
import java.util.SplittableRandom;
import java.util.zip.CRC32;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageWriteParam;
import javax.imageio.ImageWriter;
import javax.imageio.stream.MemoryCacheImageOutputStream;
import org.junit.jupiter.api.Test;

/** Samples of PNG images against those that another program has written: every kind, interlaced or not. */
class PngSamplesTest {
    private final SplittableRandom random = new SplittableRandom(22_003);

    /** An image as it is read. */
    private static final class Taken implements PixelSink {
        private Format format = new Format(0, 0, 0, 0);
        private int[] samples = {};
        private int count;

        @Override
        public void begin(Format given) {
            format = given;
            samples = new int[given.width() * given.height() * given.channels()];
            Arrays.fill(samples, -1);
        }

        @Override
        public void pixels(int row, int first, int step, int number, int[] values) {
            int channels = format.channels();
            for (int k = 0; k < number; k++) {
                int at = (row * format.width() + first + k * step) * channels;
                assertThat(samples[at]).as("each pixel comes once").isEqualTo(-1);
                System.arraycopy(values, k * channels, samples, at, channels);
            }
            count += number;
        }
    }

    private static byte[] png(BufferedImage image, boolean isInterlaced) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        ImageWriter writer = ImageIO.getImageWritersByFormatName("png").next();
        ImageWriteParam how = writer.getDefaultWriteParam();
        how.setProgressiveMode(isInterlaced ? ImageWriteParam.MODE_DEFAULT : ImageWriteParam.MODE_DISABLED);
        try (var stream = new MemoryCacheImageOutputStream(out)) {
            writer.setOutput(stream);
            writer.write(null, new IIOImage(image, null, null), how);
        }
        writer.dispose();
        assertThat(out.toByteArray()[28]).isEqualTo((byte) (isInterlaced ? 1 : 0));
        return out.toByteArray();
    }

    private static Taken taken(byte[] png) throws IOException {
        Taken taken = new Taken();
        PngReader.read(new ByteArrayInputStream(png), taken);
        assertThat(taken.count).isEqualTo(taken.format.width() * taken.format.height());
        return taken;
    }

    private BufferedImage ofSamples(int width, int height, int channels, int bits) {
        ColorSpace space = ColorSpace.getInstance(channels > 2 ? ColorSpace.CS_sRGB : ColorSpace.CS_GRAY);
        boolean hasOpacity = channels % 2 == 0;
        int type = bits == 8 ? DataBuffer.TYPE_BYTE : DataBuffer.TYPE_USHORT;
        ColorModel model = new ComponentColorModel(
                space, hasOpacity, false, hasOpacity ? Transparency.TRANSLUCENT : Transparency.OPAQUE, type);
        WritableRaster raster = Raster.createInterleavedRaster(type, width, height, channels, new Point());
        int[] samples = new int[width * height * channels];
        for (int k = 0; k < samples.length; k++) {
            samples[k] = random.nextInt(1 << bits);
        }
        raster.setPixels(0, 0, width, height, samples);
        return new BufferedImage(model, raster, false, null);
    }

    @Test
    void samplesOf8And16Bits() throws IOException {
        int[][] sizes = {{1, 1}, {2, 3}, {4, 4}, {5, 1}, {1, 9}, {8, 8}, {9, 17}, {33, 20}, {5000, 2}};
        for (int channels = 1; channels <= 4; channels++) {
            for (int bits : new int[] {8, 16}) {
                for (int[] size : sizes) {
                    BufferedImage image = ofSamples(size[0], size[1], channels, bits);
                    int[] expected = image.getRaster().getPixels(0, 0, size[0], size[1], (int[]) null);
                    for (boolean isInterlaced : new boolean[] {false, true}) {
                        Taken taken = taken(png(image, isInterlaced));
                        String what = channels + " channels, " + bits + " bits, " + size[0] + " x " + size[1];
                        assertThat(taken.format)
                                .isEqualTo(new PixelSink.Format(size[0], size[1], (1 << bits) - 1, channels));
                        assertThat(taken.samples).as(what).isEqualTo(expected);
                    }
                }
            }
        }
    }

    @Test
    void palettesWithAndWithoutOpacity() throws IOException {
        for (int bits : new int[] {1, 2, 4, 8}) {
            int count = 1 << bits;
            byte[] colours = new byte[4 * count];
            new Random(bits).nextBytes(colours);
            for (boolean hasOpacity : new boolean[] {false, true}) {
                byte[] rgb = new byte[3 * count];
                for (int k = 0; k < rgb.length; k++) {
                    rgb[k] = colours[k / 3 * 4 + k % 3];
                }
                IndexColorModel palette = hasOpacity
                        ? new IndexColorModel(bits, count, colours, 0, true)
                        : new IndexColorModel(bits, count, rgb, 0, false);
                WritableRaster raster = bits == 8
                        ? Raster.createInterleavedRaster(DataBuffer.TYPE_BYTE, 21, 13, 1, new Point())
                        : Raster.createPackedRaster(DataBuffer.TYPE_BYTE, 21, 13, 1, bits, new Point());
                for (int k = 0; k < 21 * 13; k++) {
                    raster.setSample(k % 21, k / 21, 0, random.nextInt(count));
                }
                BufferedImage image = new BufferedImage(palette, raster, false, null);
                for (boolean isInterlaced : new boolean[] {false, true}) {
                    Taken taken = taken(png(image, isInterlaced));
                    int channels = taken.format.channels();
                    assertThat(taken.format.white()).isEqualTo(255);
                    assertThat(channels).isEqualTo(hasOpacity ? 4 : 3);
                    for (int k = 0; k < 21 * 13; k++) {
                        int argb = palette.getRGB(raster.getSample(k % 21, k / 21, 0));
                        assertThat(taken.samples[k * channels]).isEqualTo(argb >> 16 & 0xff);
                        assertThat(taken.samples[k * channels + 1]).isEqualTo(argb >> 8 & 0xff);
                        assertThat(taken.samples[k * channels + 2]).isEqualTo(argb & 0xff);
                        if (hasOpacity) {
                            assertThat(taken.samples[k * channels + 3]).isEqualTo(argb >>> 24);
                        }
                    }
                }
            }
        }
    }

    private static byte[] withChunk(byte[] png, String name, int... bytes) {
        ByteBuffer out = ByteBuffer.allocate(png.length + 12 + bytes.length);
        out.put(png, 0, 33).putInt(bytes.length).put(name.getBytes(StandardCharsets.US_ASCII));
        for (int each : bytes) {
            out.put((byte) each);
        }
        CRC32 sum = new CRC32();
        sum.update(out.array(), 37, 4 + bytes.length);
        return out.putInt((int) sum.getValue()).put(png, 33, png.length - 33).array();
    }

    @Test
    void aTransparentColour() throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        PngWriter.writeGrey(out, 3, 1, new byte[] {1, 7, (byte) 200});
        Taken grey = taken(withChunk(out.toByteArray(), "tRNS", 0, 7));
        assertThat(grey.samples).containsExactly(1, 255, 7, 0, 200, 255);
        out.reset();
        PngWriter.writeColour(out, 2, 1, new int[] {0x010203, 0x010204});
        Taken colour = taken(withChunk(out.toByteArray(), "tRNS", 0, 1, 0, 2, 0, 4));
        assertThat(colour.samples).containsExactly(1, 2, 3, 255, 1, 2, 4, 0);
        assertThatExceptionOfType(IOException.class)
                .isThrownBy(() -> taken(withChunk(out.toByteArray(), "tRNS", 0, 1)))
                .withMessageContaining("tRNS must be as long as the colours need (got: 2 bytes)");
    }
}
