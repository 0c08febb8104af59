package robosim.geometry.world.rosmap;

import robosim.geometry.world.shared.AsciiScanner;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.Limits;

/** Reads the cells of a map from a PGM image, text (P2) or binary (P5), with 1 or 2 bytes per pixel. */
public final class PgmReader {
    private static final int MOST = 65_535;

    private PgmReader() {}

    static OccupancyGrid read(byte[] bytes, String source, MapSettings settings) throws FileProblem {
        AsciiScanner words = new AsciiScanner(bytes, source, '#');
        boolean isText = words.expect("P2 or P5", "P2", "P5") == 0;
        int width = words.digits("the width", 1, Limits.MAX_MAP_CELLS);
        int height = words.digits("the height", 1, Limits.MAX_MAP_CELLS);
        try {
            OccupancyGrid.checkSize(width, height);
        } catch (IllegalArgumentException e) {
            throw words.wrong(String.valueOf(e.getMessage()));
        }
        int white = words.digits("the value of white", 1, MOST);
        OccupancyGrid grid = new OccupancyGrid(width, height, settings);
        if (isText) {
            return text(words, grid, cells(grid, white));
        }
        int size = white < 256 ? 1 : 2;
        int from = words.behind();
        long need = (long) width * height * size;
        long there = bytes.length - (long) from;
        if (there != need) {
            throw new FileProblem(
                    source,
                    0,
                    0,
                    "an image of " + width + " x " + height + " pixels must have " + need + " bytes after its header; "
                            + (there < need
                                    ? "it is truncated (got: " + Math.max(0, there) + ")"
                                    : "there is extra data after its last pixel, so save it again (got: " + there
                                            + ")"));
        }
        return binary(bytes, from, source, grid, cells(grid, white));
    }

    /** What each value of a pixel means, up to that of white. */
    private static OccupancyGrid.Cell[] cells(OccupancyGrid grid, int white) {
        OccupancyGrid.Cell[] cells = new OccupancyGrid.Cell[white + 1];
        for (int value = 0; value <= white; value++) {
            cells[value] = grid.cell(value, white, 0, 0);
        }
        return cells;
    }

    private static OccupancyGrid text(AsciiScanner words, OccupancyGrid grid, OccupancyGrid.Cell[] cells)
            throws FileProblem {
        for (int row = 0; row < grid.height; row++) {
            for (int x = 0; x < grid.width; x++) {
                grid.set(x, row, cells[words.digits("a pixel", 0, cells.length - 1)]);
            }
        }
        if (words.next()) {
            throw words.wrong("an image must end after its last pixel (got: "
                    + words.word().length() + " more)");
        }
        return grid;
    }

    private static OccupancyGrid binary(
            byte[] bytes, int from, String source, OccupancyGrid grid, OccupancyGrid.Cell[] cells) throws FileProblem {
        int white = cells.length - 1;
        int at = from;
        for (int row = 0; row < grid.height; row++) {
            for (int x = 0; x < grid.width; x++) {
                int value = bytes[at++] & 0xff;
                if (white > 255) {
                    value = 256 * value + (bytes[at++] & 0xff);
                }
                if (value > white) {
                    throw new FileProblem(
                            source,
                            0,
                            0,
                            "a pixel must be at most white, " + white + " (got: " + value + " in column " + (x + 1)
                                    + " of row " + (row + 1) + ")");
                }
                grid.set(x, row, cells[value]);
            }
        }
        return grid;
    }
}
