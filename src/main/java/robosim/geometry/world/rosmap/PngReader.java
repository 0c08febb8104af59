package robosim.geometry.world.rosmap;

import java.awt.image.BufferedImage;
import java.awt.image.ColorModel;
import java.awt.image.IndexColorModel;
import java.awt.image.Raster;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.MemoryCacheImageInputStream;
import robosim.geometry.world.shared.FileProblem;

/** Reads the cells of a map from a PNG image of any colour type. */
public final class PngReader {
    private PngReader() {}

    static boolean isPng(byte[] bytes) {
        return bytes.length >= 4 && bytes[0] == (byte) 0x89 && bytes[1] == 'P' && bytes[2] == 'N' && bytes[3] == 'G';
    }

    static OccupancyGrid read(byte[] bytes, String source, MapSettings settings) throws FileProblem {
        ImageReader reader = ImageIO.getImageReadersByFormatName("png").next();
        try (var in = new MemoryCacheImageInputStream(new ByteArrayInputStream(bytes))) {
            reader.setInput(in, true, true); // without metadata, which may be of any size
            OccupancyGrid.checkSize(reader.getWidth(0), reader.getHeight(0));
            BufferedImage image = reader.read(0);
            OccupancyGrid grid = new OccupancyGrid(image.getWidth(), image.getHeight(), settings);
            if (image.getColorModel() instanceof IndexColorModel palette) {
                fromPalette(image.getRaster(), palette, grid);
            } else {
                fromSamples(image.getRaster(), image.getColorModel(), grid);
            }
            return grid;
        } catch (IOException | RuntimeException e) { // invalid images throw either
            throw new FileProblem(source, 0, 0, "the PNG image could not be read: " + e.getMessage(), e);
        } finally {
            reader.dispose();
        }
    }

    private static void fromPalette(Raster raster, IndexColorModel palette, OccupancyGrid grid) {
        int opaque = palette.hasAlpha() ? 255 : 0;
        for (int row = 0; row < grid.height; row++) {
            for (int x = 0; x < grid.width; x++) {
                int index = raster.getSample(x, row, 0);
                int sum = palette.getRed(index) + palette.getGreen(index) + palette.getBlue(index);
                grid.pixel(x, row, sum, 3 * 255, palette.getAlpha(index), opaque);
            }
        }
    }

    // The samples themselves: a BufferedImage's own grey values would come through a gamma curve.
    private static void fromSamples(Raster raster, ColorModel model, OccupancyGrid grid) {
        int most = (1 << model.getComponentSize(0)) - 1;
        int colours = model.getNumColorComponents();
        int opaque = model.hasAlpha() ? most : 0;
        int[] samples = new int[raster.getNumBands()];
        for (int row = 0; row < grid.height; row++) {
            for (int x = 0; x < grid.width; x++) {
                raster.getPixel(x, row, samples);
                long sum = colours == 1 ? 3L * samples[0] : (long) samples[0] + samples[1] + samples[2];
                grid.pixel(x, row, sum, 3L * most, opaque > 0 ? samples[colours] : 0, opaque);
            }
        }
    }
}
