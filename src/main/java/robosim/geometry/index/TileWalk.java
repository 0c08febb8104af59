package robosim.geometry.index;

/**
 * A ray's way over {@link Tiles}, front to back: from each tile to the neighbour through whose side the ray leaves it, and
 * of what each lists the objects whose outlines the ray's line may meet.
 *
 * <p>Why none is missed: in tiles, the start is {@code g = (o - origin) scale}, wrong by at most {@code 2^-52 |g|}, which moves
 * the ray by as much. The parameter at which the ray crosses the k-th line between tiles is {@code (line - g) / v} and k times
 * {@code 1 / v}, k + 5 roundings in all, so there the ray is off the line by at most {@code (k + 5) 2^-53} times the tiles from
 * the start, along either axis, whatever the slope. With {@link Tiles#REACH} and 2^14 lines that is below 2^-16 tiles; within
 * divided tiles, where there are 16 lines and the start is up to 2^34 tiles away, below 2^-14 of theirs: far below {@link
 * Tiles#MARGIN}, by which every object is listed beyond its box. So too what begins just within the reach is listed on a tile
 * that does for certain. A slope below 2^-60 of the other is taken for none: it moves the ray by less than 2^-34 tiles.
 */
final class TileWalk {
    private static final double FLAT = 0x1p-60;
    private static final double LEAST = 0x1p-300;

    private final Line line;
    private long visited;

    /** The ray, and which objects it was given last: one for a walk and those within its tiles. */
    static final class Line {
        /** How many objects are remembered, so that one that lies on several tiles comes once or twice. */
        private static final int RECENT = 8;

        private double ox;
        private double oz;
        private double dx;
        private double dz;

        /** Half of the square of the direction; infinite where that might under- or overflow, so that all is within reach. */
        private double halfSquare;

        /** What rounding may do to how far an outline is aside. */
        private double aside;

        /** By the last bits of an id: the query's number above the id. */
        private final long[] recent = new long[RECENT];

        private long query;

        /** Takes a new ray in a world where no coordinate is of a greater magnitude than the most. */
        void start(double x, double z, double wayX, double wayZ, double most) {
            ox = x;
            oz = z;
            dx = wayX;
            dz = wayZ;
            // Twenty roundings of 2^-53 in sums of products with what is no greater than these, and what underflows.
            aside = 0x1p-47 * (most + (Math.abs(x) + Math.abs(z))) * (Math.abs(wayX) + Math.abs(wayZ)) + 0x1p-1000;
            double square = wayX * wayX + wayZ * wayZ;
            halfSquare = square > 0x1p-900 && square < 0x1p900 ? square / 2 : Double.POSITIVE_INFINITY;
            query += 1L << Integer.SIZE;
        }

        /** Whether no product of a place and the direction can overflow. */
        boolean isOrdinary() {
            return aside < 0x1p960;
        }

        /** The middle of the way to a reach, times the direction; 0 where that is beyond all numbers. */
        private double half(double reach) {
            double half = reach * halfSquare;
            return half < Double.POSITIVE_INFINITY ? half : 0;
        }

        /** As long, or for ever, and wide of what rounding does. */
        private double margin(double reach) {
            return reach * halfSquare * (1 + 0x1p-48) + aside;
        }

        private boolean isNew(int id) {
            long mark = query | id;
            int place = id & (RECENT - 1);
            boolean isNew = recent[place] != mark;
            recent[place] = mark;
            return isNew;
        }
    }

    TileWalk(Line line) {
        this.line = line;
    }

    long visited() {
        return visited;
    }

    /**
     * Walks the line over tiles and lets the target meet each object whose outline it may meet on a tile that begins within
     * the reach.
     *
     * @return how far there is still to look; NaN, and nothing was met, where the line begins too far away or is too slow
     */
    double trace(Tiles over, double limit, double[] outlines, RayTarget target) {
        return trace(over, false, limit, outlines, target);
    }

    private double trace(Tiles over, boolean isWithin, double limit, double[] outlines, RayTarget target) {
        Line l = line;
        double vx = l.dx * over.scaleX;
        double vz = l.dz * over.scaleZ;
        double gx = (l.ox - over.originX) * over.scaleX;
        double gz = (l.oz - over.originZ) * over.scaleZ;
        double from = 0;
        boolean isInside = gx >= 0 && gx <= over.countX && gz >= 0 && gz <= over.countZ;
        boolean isOrdinary = isInside && Math.abs(vx) > LEAST && Math.abs(vz) > LEAST;
        if (!isOrdinary) {
            if (over.isSingle()) {
                return read(over, over.at(0, 0), limit, outlines, target);
            }
            if (!isWithin && !isNear(gx, gz, vx, vz)) {
                return Double.NaN;
            }
            from = isInside ? 0 : entry(over, gx, gz, vx, vz);
        }
        double reach = over.hasRest() ? read(over, over.rest(), limit, outlines, target) : limit;
        if (!(from <= reach)) {
            return reach;
        }
        double dx = l.dx;
        double dz = l.dz;
        double ox = l.ox;
        double oz = l.oz;
        double aside = l.aside;
        double half = l.half(reach);
        double margin = l.margin(reach);
        // -1 for a falling coordinate, else 0, without a branch that would be guessed wrong half of the time.
        int fallX = (int) (Double.doubleToRawLongBits(vx) >> 63);
        int fallZ = (int) (Double.doubleToRawLongBits(vz) >> 63);
        int column = clamp(gx + from * vx, over.countX);
        int row = clamp(gz + from * vz, over.countZ);
        boolean alongX = Math.abs(vx) > FLAT * Math.abs(vz);
        boolean alongZ = Math.abs(vz) > FLAT * Math.abs(vx);
        double inverseX = 1 / vx;
        double inverseZ = 1 / vz;
        double crossX = alongX ? (column + 1 + fallX - gx) * inverseX : Double.POSITIVE_INFINITY;
        double crossZ = alongZ ? (row + 1 + fallZ - gz) * inverseZ : Double.POSITIVE_INFINITY;
        double tileX = Math.abs(inverseX);
        double tileZ = Math.abs(inverseZ);
        int nextX = (1 + 2 * fallX) * TileLists.STRIDE;
        int nextZ = (1 + 2 * fallZ) * over.rowStep();
        int[] data = over.store.data;
        int tile = over.at(column, row);
        int steps = 0;
        do {
            steps++;
            int length = data[tile];
            int listed = TileLists.first(data, tile, length);
            if (crossX < crossZ) {
                from = crossX;
                tile += nextX;
                crossX += tileX;
            } else {
                from = crossZ;
                tile += nextZ;
                crossZ += tileZ;
            }
            for (int k = listed; k < listed + length; k++) {
                int id = data[k];
                if (meets(outlines, Outline.at(id), ox, oz, dx, dz, aside, half, margin) && l.isNew(id)) {
                    reach = target.meet(id, reach);
                    half = l.half(reach);
                    margin = l.margin(reach);
                }
            }
            if (length < 0) {
                if (length == Tiles.OUT) {
                    break;
                }
                reach = trace(over.within(length), true, reach, outlines, target);
                half = l.half(reach);
                margin = l.margin(reach);
            }
        } while (from <= reach);
        visited += steps;
        return reach;
    }

    /** Reads a list that is not a tile's to walk over. */
    private double read(Tiles over, int at, double limit, double[] outlines, RayTarget target) {
        Line l = line;
        int[] data = over.store.data;
        int first = TileLists.first(data, at, data[at]);
        int last = first + data[at];
        double reach = limit;
        for (int k = first; k < last; k++) {
            int id = data[k];
            double half = l.half(reach);
            double margin = l.margin(reach);
            if (meets(outlines, Outline.at(id), l.ox, l.oz, l.dx, l.dz, l.aside, half, margin) && l.isNew(id)) {
                reach = target.meet(id, reach);
            }
        }
        return reach;
    }

    /** Whether the line may meet an outline on its way to the reach. */
    private static boolean meets(
            double[] outlines,
            int at,
            double ox,
            double oz,
            double dx,
            double dz,
            double aside,
            double half,
            double margin) {
        double offX = outlines[at + Outline.X] - ox;
        double offZ = outlines[at + Outline.Z] - oz;
        double halfX = outlines[at + Outline.HALF_X];
        double halfZ = outlines[at + Outline.HALF_Z];
        double cos = outlines[at + Outline.COS];
        double sin = outlines[at + Outline.SIN];
        // The direction along the outline's own axes.
        double wayX = Math.abs(dx * cos - dz * sin);
        double wayZ = Math.abs(dx * sin + dz * cos);
        double across = (halfX * wayZ + halfZ * wayX + aside) - Math.abs(offX * dz - offZ * dx);
        double along = (halfX * wayX + halfZ * wayZ + margin) - Math.abs(offX * dx + offZ * dz - half);
        // Two comparisons in one branch: a negative difference is a gap.
        return (Double.doubleToRawLongBits(across) | Double.doubleToRawLongBits(along)) >= 0;
    }

    /** Whether a ray begins near enough for the tiles' margin and is not too slow for a parameter. */
    private static boolean isNear(double gx, double gz, double vx, double vz) {
        return Math.abs(gx) <= Tiles.REACH
                && Math.abs(gz) <= Tiles.REACH
                && Math.max(Math.abs(vx), Math.abs(vz)) > LEAST;
    }

    /** Where a ray enters the window from outside; NaN where it passes by. */
    private static double entry(Tiles over, double gx, double gz, double vx, double vz) {
        double enter = 0;
        double leave = Double.POSITIVE_INFINITY;
        if (Math.abs(vx) > FLAT * Math.abs(vz)) {
            double one = (-Tiles.MARGIN - gx) * (1 / vx);
            double two = (over.countX + Tiles.MARGIN - gx) * (1 / vx);
            enter = Math.max(enter, Math.min(one, two));
            leave = Math.min(leave, Math.max(one, two));
        } else if (gx < -Tiles.MARGIN || gx > over.countX + Tiles.MARGIN) {
            return Double.NaN;
        }
        if (Math.abs(vz) > FLAT * Math.abs(vx)) {
            double one = (-Tiles.MARGIN - gz) * (1 / vz);
            double two = (over.countZ + Tiles.MARGIN - gz) * (1 / vz);
            enter = Math.max(enter, Math.min(one, two));
            leave = Math.min(leave, Math.max(one, two));
        } else if (gz < -Tiles.MARGIN || gz > over.countZ + Tiles.MARGIN) {
            return Double.NaN;
        }
        return enter <= leave ? enter : Double.NaN;
    }

    private static int clamp(double place, int count) {
        return Math.max(0, Math.min((int) place, count - 1));
    }
}
