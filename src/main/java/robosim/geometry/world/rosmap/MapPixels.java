package robosim.geometry.world.rosmap;

import org.jspecify.annotations.Nullable;
import robosim.geometry.image.PixelSink;

/** Turns the pixels of a map's image into cells. */
final class MapPixels implements PixelSink {
    private final MapSettings settings;
    private Format format = new Format(0, 0, 1, 1);
    private @Nullable OccupancyGrid grid;

    /** What each grey is, for images of greys alone. */
    private OccupancyGrid.Cell[] greys = {};

    MapPixels(MapSettings settings) {
        this.settings = settings;
    }

    @Override
    public void begin(Format given) {
        OccupancyGrid.checkSize(given.width(), given.height());
        format = given;
    }

    @Override
    public void pixels(int row, int first, int step, int count, int[] samples) {
        OccupancyGrid cells = grid();
        if (format.channels() == 1) {
            for (int k = 0; k < count; k++) {
                cells.set(first + k * step, row, greys[samples[k]]);
            }
            return;
        }
        int channels = format.channels();
        int opaque = format.hasOpacity() ? format.white() : 0;
        long whole = 3L * format.white();
        long lastSum = -1;
        int lastAlpha = 0;
        OccupancyGrid.Cell cell = OccupancyGrid.Cell.FREE;
        int at = 0;
        for (int k = 0; k < count; k++) {
            long sum = format.isColour() ? (long) samples[at] + samples[at + 1] + samples[at + 2] : 3L * samples[at];
            int alpha = opaque > 0 ? samples[at + channels - 1] : 0;
            if (sum != lastSum || alpha != lastAlpha) { // most pixels are as the one before
                cell = cells.cell(sum, whole, alpha, opaque);
                lastSum = sum;
                lastAlpha = alpha;
            }
            cells.set(first + k * step, row, cell);
            at += channels;
        }
    }

    /** The cells, for which room is made when the first come. */
    OccupancyGrid grid() {
        OccupancyGrid made = grid;
        if (made == null) {
            made = new OccupancyGrid(format.width(), format.height(), settings);
            if (format.channels() == 1) {
                greys = new OccupancyGrid.Cell[format.white() + 1];
                for (int value = 0; value < greys.length; value++) {
                    greys[value] = made.cell(value, format.white(), 0, 0);
                }
            }
            grid = made;
        }
        return made;
    }
}
