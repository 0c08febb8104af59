package robosim.geometry.image;

/**
 * The five filters of PNG, which tell each byte of a row from its neighbours to the left and above: for each row that one
 * is taken whose bytes, as signed numbers, have the smallest sum of sizes.
 */
final class RowFilter {
    static final int KINDS = 5;

    private final int step;
    private byte[] row;
    private byte[] above;

    /** Behind the number of the filter; one row for each of the filters. */
    private byte[][] filtered = {};

    /**
     * Begins above the first row.
     *
     * @param length bytes of a row
     * @param step   bytes from a pixel to the next
     */
    RowFilter(int length, int step) {
        this.step = step;
        row = new byte[length];
        above = new byte[length];
    }

    /** Takes the next row. */
    byte[] row() {
        return row;
    }

    /** Filters the row that was written, with the number of its filter before it. */
    byte[] filtered() {
        if (filtered.length == 0) { // a reader has no need of them
            filtered = new byte[KINDS][row.length + 1];
        }
        byte[] best = filtered[0];
        long least = Long.MAX_VALUE;
        for (int kind = 0; kind < KINDS; kind++) {
            byte[] candidate = filtered[kind];
            candidate[0] = (byte) kind;
            long sum = 0;
            for (int k = 0; k < row.length; k++) {
                byte left = byteOr0(row, k - step);
                byte rest = (byte) (row[k] - guess(kind, left, above[k], byteOr0(above, k - step)));
                candidate[k + 1] = rest;
                sum += Math.abs(rest);
            }
            if (sum < least) {
                least = sum;
                best = candidate;
            }
        }
        byte[] done = row;
        row = above;
        above = done;
        return best;
    }

    /** Turns a filtered row back into what it was. */
    void restore(int kind, byte[] data) {
        if (kind == 0) {
            System.arraycopy(data, 0, row, 0, row.length);
            return;
        }
        for (int k = 0; k < row.length; k++) {
            byte left = byteOr0(row, k - step);
            row[k] = (byte) (data[k] + guess(kind, left, above[k], byteOr0(above, k - step)));
        }
    }

    /** Goes on to the row below the one that was restored. */
    void next() {
        byte[] done = row;
        row = above;
        above = done;
    }

    private static byte byteOr0(byte[] bytes, int at) {
        return at < 0 ? 0 : bytes[at];
    }

    private static int guess(int kind, byte left, byte up, byte upLeft) {
        int a = left & 0xff;
        int b = up & 0xff;
        int c = upLeft & 0xff;
        return switch (kind) {
            case 0 -> 0;
            case 1 -> a;
            case 2 -> b;
            case 3 -> (a + b) / 2;
            default -> paeth(a, b, c);
        };
    }

    /** Of left, above and above to the left, the one nearest to left + above - above to the left. */
    private static int paeth(int a, int b, int c) {
        int toLeft = Math.abs(b - c);
        int toAbove = Math.abs(a - c);
        int toBoth = Math.abs(a + b - 2 * c);
        if (toLeft <= toAbove && toLeft <= toBoth) {
            return a;
        }
        return toAbove <= toBoth ? b : c;
    }
}
