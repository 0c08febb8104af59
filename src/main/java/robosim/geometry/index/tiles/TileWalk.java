package robosim.geometry.index.tiles;

import org.jspecify.annotations.Nullable;

/**
 * Walks a ray over {@link Tiles}, front to back: from each tile to the neighbour on the side where the ray leaves it.
 * Returns the listed objects whose outlines the ray may meet; one that lies on several tiles may be returned more than
 * once.
 *
 * <p>Why none is missed: in units of tiles, the start is {@code g = (o - origin) scale}, wrong by at most {@code 2^-52
 * |g|}, which shifts the ray by as much. The parameter at which the ray crosses the k-th line between tiles is {@code
 * (line - g) / v} and k times {@code 1 / v}, k + 5 roundings in all, so there the ray is off the line by at most {@code
 * (k + 5) 2^-53} times the tiles from the start, along either axis, whatever the slope. With {@link Tiles#REACH} and
 * 2^14 lines that is below 2^-16 tiles; within divided tiles, where there are 16 lines and the start is up to 2^34
 * tiles away, below 2^-14 of theirs: far below {@link Tiles#MARGIN}, by which every object is listed beyond its box.
 * For the same reason an object that begins just within the reach is listed on a tile that certainly begins within it.
 * A direction component below 2^-60 of the other is treated as 0, which shifts the ray by less than 2^-34 tiles.
 */
public final class TileWalk {
    private static final double FLAT = 0x1p-60;
    private static final double LEAST = 0x1p-300;

    private final Line line;
    private Tiles tiles;
    private int[] data;

    // The parameters at which the ray enters the next tile, and crosses the grid lines after it.
    private double from;
    private double crossX;
    private double crossZ;
    private double tileX;
    private double tileZ;

    /** The next tile, and the distances to its neighbours in the store. */
    private int tile;

    private int nextX;
    private int nextZ;

    /** The next position in the current list, and the list's end. */
    private int entry;

    private int end;
    private boolean isWithin;
    private @Nullable TileWalk inner;
    private long visited;

    /** A ray, shared by a walk and the walks within its divided tiles. */
    public static final class Line {
        private double ox;
        private double oz;
        private double dx;
        private double dz;

        /**
         * Half of the squared length of the direction; infinite if that might under- or overflow, so that everything is
         * within reach.
         */
        private double halfSquare;

        /** The largest rounding error of an outline's distance from the ray's line. */
        private double aside;

        /** Sets a new ray, in a world where no coordinate exceeds {@code most} in magnitude. */
        public void start(double x, double z, double wayX, double wayZ, double most) {
            ox = x;
            oz = z;
            dx = wayX;
            dz = wayZ;
            // Twenty roundings of 2^-53 in sums of products with numbers no greater than these, and underflow.
            aside = 0x1p-47 * (most + (Math.abs(x) + Math.abs(z))) * (Math.abs(wayX) + Math.abs(wayZ)) + 0x1p-1000;
            double square = wayX * wayX + wayZ * wayZ;
            halfSquare = square > 0x1p-900 && square < 0x1p900 ? square / 2 : Double.POSITIVE_INFINITY;
        }

        /** Whether no product of a coordinate or a tile with the direction can overflow. */
        public boolean isOrdinary() {
            return aside < 0x1p960 && Math.abs(dx) + Math.abs(dz) < 0x1p600;
        }
    }

    public TileWalk(Line line, Tiles any) {
        this.line = line;
        tiles = any;
        data = any.store.data;
    }

    public long visited() {
        return visited + (inner == null ? 0 : inner.visited());
    }

    public void stop() {
        end = entry;
        from = Double.NaN;
        isWithin = false;
    }

    /**
     * Starts at the beginning of the line; returns false, with nothing to walk, if that is too far away or the
     * direction is too short.
     */
    public boolean start(Tiles over) {
        return start(over, false);
    }

    private boolean start(Tiles over, boolean isPart) {
        Line l = line;
        double vx = l.dx * over.scaleX;
        double vz = l.dz * over.scaleZ;
        double gx = (l.ox - over.originX) * over.scaleX;
        double gz = (l.oz - over.originZ) * over.scaleZ;
        tiles = over;
        data = over.store.data;
        isWithin = false;
        from = 0;
        boolean isInside = gx >= 0 && gx <= over.countX && gz >= 0 && gz <= over.countZ;
        boolean isOrdinary = isInside && Math.abs(vx) > LEAST && Math.abs(vz) > LEAST;
        if (!isOrdinary) {
            from = Double.NaN;
            if (over.isSingle()) {
                read(over.at(0, 0));
                return true;
            }
            if (!isPart && !isNear(gx, gz, vx, vz)) {
                stop();
                return false;
            }
            from = isInside ? 0 : entry(over, gx, gz, vx, vz);
        }
        read(over.rest());
        // -1 for a decreasing coordinate, else 0, without a branch, which would be mispredicted half of the time.
        int fallX = (int) (Double.doubleToRawLongBits(vx) >> 63);
        int fallZ = (int) (Double.doubleToRawLongBits(vz) >> 63);
        int column = clamp(gx + from * vx, over.countX);
        int row = clamp(gz + from * vz, over.countZ);
        boolean alongX = Math.abs(vx) > FLAT * Math.abs(vz);
        boolean alongZ = Math.abs(vz) > FLAT * Math.abs(vx);
        double inverseX = 1 / vx;
        double inverseZ = 1 / vz;
        crossX = alongX ? (column + 1 + fallX - gx) * inverseX : Double.POSITIVE_INFINITY;
        crossZ = alongZ ? (row + 1 + fallZ - gz) * inverseZ : Double.POSITIVE_INFINITY;
        tileX = Math.abs(inverseX);
        tileZ = Math.abs(inverseZ);
        nextX = (1 + 2 * fallX) * TileLists.STRIDE;
        nextZ = (1 + 2 * fallZ) * over.rowStep();
        tile = over.at(column, row);
        return true;
    }

    private void read(int place) {
        entry = TileLists.first(data, place, data[place]);
        end = entry + data[place];
    }

    /**
     * The next object, on a tile that begins within the limit, whose outline the line may meet within the limit; {@link
     * Tiles#NONE} after the last. The limit may shrink from call to call.
     */
    public int next(double limit, double[] outlines) {
        while (true) {
            int id = isWithin ? within().next(limit, outlines) : Tiles.NONE;
            if (id != Tiles.NONE) {
                return id;
            }
            isWithin = false;
            if (entry >= end && !(from <= limit)) {
                return Tiles.NONE;
            }
            id = nextListed(limit, outlines);
            if (!isWithin) {
                return id;
            }
        }
    }

    private TileWalk within() {
        if (inner == null) {
            inner = new TileWalk(line, tiles);
        }
        return inner;
    }

    /**
     * The same, but at a divided tile it only starts the nested walk: a loop without calls, so that everything stays in
     * registers.
     */
    private int nextListed(double limit, double[] outlines) {
        Line l = line;
        double ox = l.ox;
        double oz = l.oz;
        double dx = l.dx;
        double dz = l.dz;
        double aside = l.aside;
        double middle = limit * l.halfSquare;
        boolean isFinite = middle < 0x1p1000;
        double half = isFinite ? middle : 0;
        double margin = isFinite ? middle * (1 + 0x1p-48) + aside : Double.POSITIVE_INFINITY;
        double enter = from;
        double nearX = crossX;
        double nearZ = crossZ;
        double wideX = tileX;
        double wideZ = tileZ;
        int[] lists = data;
        int at = tile;
        int stepX = nextX;
        int stepZ = nextZ;
        int listed = entry;
        int last = end;
        int steps = 0;
        int found = Tiles.NONE;
        int length = 0;
        search:
        while (true) {
            while (listed < last) {
                int id = lists[listed++];
                if (overlaps(outlines, OrientedRectangle.at(id), ox, oz, dx, dz, aside, half, margin)) {
                    found = id;
                    break search;
                }
            }
            if (!(enter <= limit)) {
                break;
            }
            steps++;
            length = lists[at];
            listed = TileLists.first(lists, at, length);
            last = listed + length;
            // The nearer of the two lines, without a branch.
            long isX = Double.doubleToRawLongBits(nearX - nearZ) >> 63;
            enter = Double.longBitsToDouble(
                    (Double.doubleToRawLongBits(nearX) & isX) | (Double.doubleToRawLongBits(nearZ) & ~isX));
            at += (stepX & (int) isX) | (stepZ & ~(int) isX);
            nearX += Double.longBitsToDouble(Double.doubleToRawLongBits(wideX) & isX);
            nearZ += Double.longBitsToDouble(Double.doubleToRawLongBits(wideZ) & ~isX);
            if (length < 0) {
                listed = last;
                break;
            }
        }
        from = enter;
        crossX = nearX;
        crossZ = nearZ;
        tile = at;
        entry = listed;
        end = last;
        visited += steps;
        if (length < 0) {
            turn(length);
        }
        return found;
    }

    /** Enters a divided tile, or ends the walk. */
    private void turn(int length) {
        if (length == Tiles.OUT) {
            from = Double.NaN;
        } else {
            within().start(tiles.within(length), true);
            isWithin = true;
        }
    }

    /** Whether the line may meet an outline within the reach. */
    private static boolean overlaps(
            double[] outlines,
            int at,
            double ox,
            double oz,
            double dx,
            double dz,
            double aside,
            double half,
            double margin) {
        double offX = outlines[at + OrientedRectangle.X] - ox;
        double offZ = outlines[at + OrientedRectangle.Z] - oz;
        double halfX = outlines[at + OrientedRectangle.HALF_X];
        double halfZ = outlines[at + OrientedRectangle.HALF_Z];
        double cos = outlines[at + OrientedRectangle.COS];
        double sin = outlines[at + OrientedRectangle.SIN];
        // The direction along the outline's own axes.
        double wayX = Math.abs(Math.fma(dx, cos, -(dz * sin)));
        double wayZ = Math.abs(Math.fma(dx, sin, dz * cos));
        double across =
                Math.fma(halfX, wayZ, Math.fma(halfZ, wayX, aside)) - Math.abs(Math.fma(offX, dz, -(offZ * dx)));
        double along = Math.fma(halfX, wayX, Math.fma(halfZ, wayZ, margin))
                - Math.abs(Math.fma(offX, dx, Math.fma(offZ, dz, -half)));
        // Two comparisons in one branch: a negative difference is a gap.
        return (Double.doubleToRawLongBits(across) | Double.doubleToRawLongBits(along)) >= 0;
    }

    /** Whether a ray begins near enough for the tiles' margin, and its direction is long enough for a parameter. */
    private static boolean isNear(double gx, double gz, double vx, double vz) {
        return Math.abs(gx) <= Tiles.REACH
                && Math.abs(gz) <= Tiles.REACH
                && Math.max(Math.abs(vx), Math.abs(vz)) > LEAST;
    }

    /** The parameter at which a ray enters the window from outside; NaN if it misses it. */
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
