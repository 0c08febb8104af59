package robosim.geometry.material;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import org.junit.jupiter.api.Test;

class ImageTextureTest {
    static ImageTexture image() {
        return new ImageTexture(3, 2, new int[] {0xff0000, 0x00ff00, 0x0000ff, 0x102030, 0xffffff, 0}, 1.5, 2);
    }

    @Test
    void aPictureHoldsItsPixels() throws Exception {
        int[] pixels = {0xff0000, 0x00ff00, 0x0000ff, 0xff102030, 0xffffff, 0};
        ImageTexture image = new ImageTexture(3, 2, pixels, 1.5, 2);
        pixels[0] = 7;
        assertThat(image.pixel(0, 0)).isEqualTo(0xff0000);
        assertThat(image.pixel(0, 1)).as("without the opacity").isEqualTo(0x102030);
        image.pixels()[0] = 7;
        assertThat(image).isEqualTo(image()).hasSameHashCodeAs(image());
        assertThat(ImageTexture.of(3, 2, image.bytes(), 1.5, 2)).isEqualTo(image);
        assertThat(MaterialTest.copied(image)).isEqualTo(image);
        assertThat(image.tiled(1, 2)).isNotEqualTo(image).isEqualTo(image.tiled(1, 2));
        assertThat(image.tiled(1.5, 1)).isNotEqualTo(image);
        assertThat(new ImageTexture(2, 3, image.pixels(), 1.5, 2)).isNotEqualTo(image);
        assertThat(new ImageTexture(3, 2, new int[6], 1.5, 2)).isNotEqualTo(image);
        assertThat(image).hasToString("image of 3 x 2 pixels, 1.5 x 2.0");
    }

    @Test
    void aPictureOfAnImpossibleSizeIsRefusedBeforeItIsMade() {
        assertThat(ImageTexture.checkSize(1 << 13, 1 << 13)).isEqualTo(1 << 26);
        assertThat(ImageTexture.checkSize(1 << 26, 1)).isEqualTo(1 << 26);
        long[][] bad = {
            {0, 1},
            {1, 0},
            {-1, -1},
            {(1 << 13) + 1, 1 << 13},
            {1, (1 << 26) + 1},
            {1 << 16, 1 << 16},
            {Long.MAX_VALUE, Long.MAX_VALUE},
            {31_623, 31_623}
        };
        for (long[] size : bad) {
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> ImageTexture.checkSize(size[0], size[1]))
                    .withMessageContaining("67108864 pixels (got: " + size[0] + " x " + size[1] + ")");
        }
        // 2^32 pixels: their number as an int is 0.
        assertThatIllegalArgumentException().isThrownBy(() -> new ImageTexture(1 << 16, 1 << 16, new int[0], 1, 1));
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new ImageTexture(2, 2, new int[5], 1, 1))
                .withMessageEndingWith("(got: 5)");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> ImageTexture.of(2, 2, new byte[11], 1, 1))
                .withMessageEndingWith("(got: 11)");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> image().tiled(0, 1))
                .withMessageStartingWith("tileWidth must");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> image().tiled(1, Double.NaN))
                .withMessageStartingWith("tileHeight must");
        for (int[] place : new int[][] {{-1, 0}, {3, 0}, {0, -1}, {0, 2}}) {
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> image().pixel(place[0], place[1]))
                    .withMessageContaining("(got: " + place[0] + " and " + place[1] + ")");
        }
    }
}
