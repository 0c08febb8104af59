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
        OccupancyGrid.Cell[] cells = new OccupancyGrid.Cell[palette.getMapSize()];
        for (int index = 0; index < cells.length; index++) {
            int sum = palette.getRed(index) + palette.getGreen(index) + palette.getBlue(index);
            cells[index] = grid.cell(sum, 3 * 255, palette.getAlpha(index), opaque);
        }
        int[] indices = new int[grid.width];
        for (int row = 0; row < grid.height; row++) {
            raster.getSamples(0, row, grid.width, 1, 0, indices);
            for (int x = 0; x < grid.width; x++) {
                grid.set(x, row, cells[indices[x]]);
            }
        }
    }

    // The samples themselves: a BufferedImage's own grey values would come through a gamma curve.
    private static void fromSamples(Raster raster, ColorModel model, OccupancyGrid grid) {
        int most = (1 << model.getComponentSize(0)) - 1;
        int colours = model.getNumColorComponents();
        int opaque = model.hasAlpha() ? most : 0;
        int bands = raster.getNumBands();
        int[] samples = new int[bands * grid.width];
        long lastSum = -1;
        int lastAlpha = 0;
        OccupancyGrid.Cell cell = OccupancyGrid.Cell.FREE;
        for (int row = 0; row < grid.height; row++) {
            raster.getPixels(0, row, grid.width, 1, samples);
            for (int x = 0; x < grid.width; x++) {
                int at = x * bands;
                long sum = colours == 1 ? 3L * samples[at] : (long) samples[at] + samples[at + 1] + samples[at + 2];
                int alpha = opaque > 0 ? samples[at + colours] : 0;
                if (sum != lastSum || alpha != lastAlpha) { // most pixels are as the one before
                    cell = grid.cell(sum, 3L * most, alpha, opaque);
                    lastSum = sum;
                    lastAlpha = alpha;
                }
                grid.set(x, row, cell);
            }
        }
    }
}
