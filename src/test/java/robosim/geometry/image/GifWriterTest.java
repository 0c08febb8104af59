package robosim.geometry.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import org.junit.jupiter.api.Test;

class GifWriterTest {
    private static byte[] film(int width, int height, int[]... pictures) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        GifWriter writer = new GifWriter(out, width, height, 0.1);
        for (int[] picture : pictures) {
            writer.add(picture);
        }
        writer.end();
        return out.toByteArray();
    }

    /** The pictures as they are shown: one over the other. */
    private static List<BufferedImage> read(byte[] film) throws IOException {
        ImageReader reader = ImageIO.getImageReadersByFormatName("gif").next();
        reader.setInput(ImageIO.createImageInputStream(new ByteArrayInputStream(film)));
        List<BufferedImage> pictures = new ArrayList<>();
        for (int k = 0; k < reader.getNumImages(true); k++) {
            BufferedImage shown = reader.read(k);
            BufferedImage all = new BufferedImage(shown.getWidth(), shown.getHeight(), BufferedImage.TYPE_INT_RGB);
            for (BufferedImage picture : k == 0 ? List.of(shown) : List.of(pictures.get(k - 1), shown)) {
                all.getGraphics().drawImage(picture, 0, 0, null);
            }
            pictures.add(all);
        }
        return pictures;
    }

    /** Two hundred colours, none in the bin of another, in the order of a random walk. */
    private static int[] walk(SplittableRandom random, int count) {
        int[] pixels = new int[count];
        int colour = 0;
        for (int k = 0; k < count; k++) {
            colour = random.nextInt(4) == 0 ? random.nextInt(200) : colour;
            pixels[k] = colour % 6 * 40 << 16 | colour / 6 % 6 * 40 << 8 | colour / 36 * 40;
        }
        return pixels;
    }

    @Test
    void fewColoursAreReadBackByTheJdkAsTheyWere() throws IOException {
        SplittableRandom random = new SplittableRandom(7);
        for (int[] size : new int[][] {{1, 1}, {3, 2}, {64, 65}, {301, 200}}) {
            int[] first = walk(random, size[0] * size[1]);
            int[] second = walk(random, size[0] * size[1]);
            System.arraycopy(first, first.length / 3, second, first.length / 3, first.length / 3);
            List<BufferedImage> seen = read(film(size[0], size[1], first, second));
            assertThat(seen).hasSize(2);
            for (int k = 0; k < 2; k++) {
                int[] pixels = seen.get(k).getRGB(0, 0, size[0], size[1], null, 0, size[0]);
                int[] wanted = k == 0 ? first : second;
                for (int at = 0; at < pixels.length; at++) {
                    pixels[at] &= 0xffffff;
                }
                assertThat(pixels).as("%d x %d", size[0], size[1]).isEqualTo(wanted);
            }
        }
    }

    @Test
    void manyColoursAreNearlyWhatTheyWere() throws IOException {
        int[] pixels = new int[256 * 256];
        for (int k = 0; k < pixels.length; k++) {
            pixels[k] = (k % 256) << 16 | (k / 256) << 8 | (k % 256) / 2;
        }
        BufferedImage seen = read(film(256, 256, pixels)).get(0);
        long off = 0;
        for (int k = 0; k < pixels.length; k++) {
            int pixel = seen.getRGB(k % 256, k / 256);
            for (int shift = 0; shift <= 16; shift += 8) {
                off += Math.abs((pixel >> shift & 0xff) - (pixels[k] >> shift & 0xff));
            }
        }
        assertThat(off / (3.0 * pixels.length)).as("mean error of a component").isBetween(1.0, 6.0);
    }

    @Test
    void whatStaysTakesNoRoom() throws IOException {
        int[] picture = walk(new SplittableRandom(8), 100 * 100);
        int[] changed = picture.clone();
        changed[5_050] ^= 0x404040;
        int one = film(100, 100, picture).length;
        assertThat(film(100, 100, picture, picture).length - one).isLessThan(1_200);
        byte[] film = film(100, 100, picture, changed, picture);
        assertThat(film.length - one).isLessThan(2_400);
        List<BufferedImage> seen = read(film);
        assertThat(seen.get(1).getRGB(50, 50) & 0xffffff).isEqualTo(changed[5_050]);
        assertThat(seen.get(2).getRGB(50, 50) & 0xffffff).isEqualTo(picture[5_050]);
    }

    @Test
    void refusesOtherSizes() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new GifWriter(new ByteArrayOutputStream(), 0, 1, 0.1))
                .withMessageContaining("width and height")
                .withMessageContaining("0 x 1");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> film(2, 2, new int[3]))
                .withMessageContaining("2 x 2")
                .withMessageContaining("3");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new GifWriter(new ByteArrayOutputStream(), 1, 1, 0))
                .withMessageContaining("seconds");
    }
}
