package robosim.geometry.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.awt.image.BufferedImage;
import java.awt.image.IndexColorModel;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.zip.CRC32;
import javax.imageio.ImageIO;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.junit.jupiter.api.Test;

/** The JDK's own reader and writer stand for everybody else's. */
class PngTest {
    private final SplittableRandom random = new SplittableRandom(20);

    private int[] picture(int width, int height, int kind) {
        int[] pixels = new int[width * height];
        for (int k = 0; k < pixels.length; k++) {
            int x = k % width;
            int y = k / width;
            pixels[k] = switch (kind) {
                case 0 -> random.nextInt() & 0xffffff;
                case 1 -> (x & 0xff) << 16 | (y & 0xff) << 8 | (x + y & 0xff);
                default -> x / 5 % 2 == y / 7 % 2 ? 0xff8000 : 0x102030;
            };
        }
        return pixels;
    }

    @Test
    void othersReadWhatIsWritten() throws IOException {
        for (int[] size : new int[][] {{1, 1}, {3, 1}, {1, 5}, {37, 21}, {300, 200}}) {
            for (int kind = 0; kind < 3; kind++) {
                int[] pixels = picture(size[0], size[1], kind);
                BufferedImage image = ImageIO.read(new ByteArrayInputStream(colour(size[0], size[1], pixels)));
                assertThat(new int[] {image.getWidth(), image.getHeight()}).isEqualTo(size);
                for (int k = 0; k < pixels.length; k++) {
                    assertThat(image.getRGB(k % size[0], k / size[0]) & 0xffffff)
                            .isEqualTo(pixels[k]);
                }
            }
        }
    }

    @Test
    void othersReadGreysOf8And16Bits() throws IOException {
        short[] deep = new short[40 * 30];
        byte[] flat = new byte[40 * 30];
        for (int k = 0; k < deep.length; k++) {
            deep[k] = (short) (k < 600 ? 50 * k : random.nextInt());
            flat[k] = (byte) random.nextInt();
        }
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        PngWriter.writeGrey16(out, 40, 30, deep);
        BufferedImage image = ImageIO.read(new ByteArrayInputStream(out.toByteArray()));
        assertThat(image.getType()).isEqualTo(BufferedImage.TYPE_USHORT_GRAY);
        int[] read = image.getRaster().getPixels(0, 0, 40, 30, (int[]) null);
        for (int k = 0; k < deep.length; k++) {
            assertThat(read[k]).isEqualTo(deep[k] & 0xffff);
        }
        out.reset();
        PngWriter.writeGrey(out, 40, 30, flat);
        read = ImageIO.read(new ByteArrayInputStream(out.toByteArray()))
                .getRaster()
                .getPixels(0, 0, 40, 30, (int[]) null);
        for (int k = 0; k < flat.length; k++) {
            assertThat(read[k]).isEqualTo(flat[k] & 0xff);
        }
    }

    @Test
    void readsItsOwnAndWhatOthersWrite() throws IOException {
        int[] pixels = picture(61, 43, 0);
        assertThat(PngReader.read(new ByteArrayInputStream(colour(61, 43, pixels)))
                        .pixels())
                .isEqualTo(pixels);
        int[] types = {
            BufferedImage.TYPE_INT_RGB,
            BufferedImage.TYPE_INT_ARGB,
            BufferedImage.TYPE_BYTE_GRAY,
            BufferedImage.TYPE_USHORT_GRAY,
            BufferedImage.TYPE_BYTE_BINARY,
            BufferedImage.TYPE_BYTE_INDEXED
        };
        for (int type : types) {
            BufferedImage image = new BufferedImage(61, 43, type);
            paint(image, pixels);
            check(image, "type " + type);
        }
        for (int bits : new int[] {1, 2, 4}) { // greys and palettes of few bits
            int count = 1 << bits;
            byte[] reds = new byte[count];
            byte[] others = new byte[count];
            random.nextBytes(reds);
            random.nextBytes(others);
            for (byte[] greens : new byte[][] {reds, others}) {
                IndexColorModel colours = new IndexColorModel(bits, count, reds, greens, reds);
                BufferedImage image = new BufferedImage(61, 43, BufferedImage.TYPE_BYTE_BINARY, colours);
                paint(image, pixels);
                check(image, bits + " bits");
            }
        }
    }

    private static void paint(BufferedImage image, int[] pixels) {
        for (int k = 0; k < pixels.length; k++) {
            image.setRGB(k % 61, k / 61, 0xff000000 | pixels[k]);
        }
    }

    private static void check(BufferedImage image, String what) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        assertThat(ImageIO.write(image, "png", out)).isTrue();
        PngReader.Pixels read = PngReader.read(new ByteArrayInputStream(out.toByteArray()));
        boolean isGrey = image.getColorModel().getNumColorComponents() == 1;
        for (int k = 0; k < read.pixels().length; k++) {
            int sample = image.getRaster().getSample(k % 61, k / 61, 0);
            int expected = isGrey
                    ? (image.getSampleModel().getSampleSize(0) == 16 ? sample >> 8 : sample) * 0x010101
                    : image.getRGB(k % 61, k / 61) & 0xffffff; // for greys the JDK would convert it to another profile
            assertThat(read.pixels()[k]).as("%s, pixel %d", what, k).isEqualTo(expected);
        }
    }

    @Test
    void refusesWhatIsNoPngAndWhatIsBroken() throws IOException {
        byte[] whole = colour(20, 10, picture(20, 10, 1));
        refused(new byte[0], "ends before");
        refused("GIF89a and more".getBytes(StandardCharsets.US_ASCII), "must be a PNG");
        for (int length = 1; length < whole.length - 16; length++) { // up to its data's end
            byte[] cut = Arrays.copyOf(whole, length);
            assertThatExceptionOfType(IOException.class).as("%d bytes", length).isThrownBy(reading(cut));
        }
        int[] pixels = PngReader.read(new ByteArrayInputStream(whole)).pixels();
        for (int k = 8; k < whole.length - 16; k++) { // a changed byte is seen, by a checksum at the latest
            byte[] changed = whole.clone();
            changed[k] ^= 0x40;
            try {
                assertThat(PngReader.read(new ByteArrayInputStream(changed)).pixels())
                        .isEqualTo(pixels);
            } catch (IOException expected) {
                assertThat(expected).hasMessageMatching("(?s).*(PNG|chunk|image|row|palette).*");
            }
        }
    }

    @Test
    void refusesABombBeforeItMakesRoom() throws IOException {
        byte[] bomb = colour(20, 10, picture(20, 10, 1));
        ByteBuffer.wrap(bomb).putInt(16, 1 << 20).putInt(20, 1 << 20);
        seal(bomb);
        refused(bomb, "1 to 268435456 pixels (got: 1048576 x 1048576)");
        ByteBuffer.wrap(bomb).putInt(16, 8192).putInt(20, 8192);
        seal(bomb);
        refused(bomb, "must fill all its rows");
        bomb[28] = 1;
        seal(bomb);
        refused(bomb, "must fill all its rows");
        bomb[28] = 2;
        seal(bomb);
        refused(bomb, "must be interlaced in 7 passes or not at all (got: method 2)");
        ByteBuffer.wrap(bomb).putInt(16, 16384).putInt(20, 8192);
        bomb[28] = 0;
        seal(bomb);
        refused(bomb, "1 to 67108864 pixels (got: 16384 x 8192)");
    }

    private static void seal(byte[] png) {
        CRC32 sum = new CRC32();
        sum.update(png, 12, 17);
        ByteBuffer.wrap(png).putInt(29, (int) sum.getValue());
    }

    @Test
    void refusesPixelsThatAreTooFew() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> colour(3, 3, new int[8]))
                .withMessage("pixels must have 9 elements (got: 8)");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> colour(1 << 20, 1 << 20, new int[8]))
                .withMessageContaining("(got: 1048576 x 1048576)");
        assertThatIllegalArgumentException().isThrownBy(() -> colour(0, 3, new int[8]));
    }

    private static void refused(byte[] bytes, String because) {
        assertThatExceptionOfType(IOException.class).isThrownBy(reading(bytes)).withMessageContaining(because);
    }

    private static ThrowingCallable reading(byte[] bytes) {
        return () -> PngReader.read(new ByteArrayInputStream(bytes));
    }

    private static byte[] colour(int width, int height, int[] pixels) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        PngWriter.writeColour(out, width, height, pixels);
        return out.toByteArray();
    }
}
