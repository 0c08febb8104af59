package robosim.geometry.index;

import org.jspecify.annotations.Nullable;

/**
 * A ray's way over {@link Tiles}, front to back: from each tile to the neighbour through whose side the ray leaves it, and
 * of what each lists the objects whose boxes the ray's line may meet.
 *
 * <p>Why none is missed: in tiles, the start is {@code g = (o - origin) scale}, wrong by at most {@code 2^-52 |g|}, and the
 * parameter at which the ray crosses a line between tiles is {@code (line - g) / v}, three roundings more, so at each
 * parameter the ray is off the tile that is visited then by at most {@code 2^-50} times the tiles from the start to the
 * line, along either axis, whatever the slope. With {@link Tiles#REACH} that is below 2^-26 tiles, and below 2^-13 of the
 * tiles within divided ones, of which at most 2^12 lie along an outer one: far below {@link Tiles#MARGIN}, by which every
 * object is listed beyond its box. A slope below 2^-60 of the other is taken for
 * none: it moves the ray by less than 2^-34 tiles.
 */
final class TileWalk {
    private static final double FLAT = 0x1p-60;
    private static final double LEAST = 0x1p-300;

    private Tiles tiles;
    private final Line line;

    // The walk: the next tile, at which parameter the ray comes to it and crosses its far sides, and the last tile's
    // end.
    private double gx;
    private double gz;
    private double inverseX;
    private double inverseZ;
    private double lineX;
    private double lineZ;
    private double stepX;
    private double stepZ;
    private int countX;
    private int countZ;
    private int fillX;
    private int fillZ;
    private int atX;
    private int atZ;
    private double begin;
    private double crossX;
    private double crossZ;
    private double end;

    /** The next entry of the list that is read. */
    private int entry = Tiles.NONE;

    /** What the next tile holds, read while the lists before it are: memory is slow. */
    private int ahead = Tiles.NONE;

    private boolean isWithin;
    private @Nullable TileWalk inner;
    private long visited;

    /** The ray, and which objects it was given last: one for a walk and those within its tiles. */
    static final class Line {
        /** How many objects are remembered, so that one that lies on several tiles comes once or twice. */
        private static final int RECENT = 8;

        private double ox;
        private double oz;
        private double dx;
        private double dz;

        /** The square of the direction; infinite where that might under- or overflow, so that all is within reach. */
        private double square;

        /** What rounding may do to how far a box is aside. */
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
            // Sums of four numbers up to the most, times a direction: six roundings of 2^-53.
            aside = 0x1p-47 * (most + (Math.abs(x) + Math.abs(z))) * (Math.abs(wayX) + Math.abs(wayZ));
            double sum = wayX * wayX + wayZ * wayZ;
            square = sum > 0x1p-900 && sum < 0x1p900 ? sum : Double.POSITIVE_INFINITY;
            query += 1L << Integer.SIZE;
        }

        /** Whether no product of a place and the direction can overflow. */
        boolean isOrdinary() {
            return aside < 0x1p960;
        }

        private boolean isNew(int id) {
            long mark = query | id;
            int place = id & (RECENT - 1);
            boolean isNew = recent[place] != mark;
            recent[place] = mark;
            return isNew;
        }
    }

    TileWalk(Tiles any, Line line) {
        tiles = any;
        this.line = line;
    }

    long visited() {
        return visited + (inner == null ? 0 : inner.visited());
    }

    void stop() {
        end = Double.NEGATIVE_INFINITY;
        entry = Tiles.NONE;
        isWithin = false;
    }

    /** Whether a ray begins near enough for the tiles' margin and is not too slow for a parameter. */
    static boolean isNear(Tiles over, double ox, double oz, double dx, double dz) {
        return over.isSingle()
                || (Math.abs((ox - over.originX) * over.scaleX) <= Tiles.REACH
                        && Math.abs((oz - over.originZ) * over.scaleZ) <= Tiles.REACH
                        && Math.max(Math.abs(dx * over.scaleX), Math.abs(dz * over.scaleZ)) > LEAST);
    }

    /** Starts the walk of the line, which is near. */
    void start(Tiles over) {
        tiles = over;
        isWithin = false;
        entry = over.rest;
        begin = 0;
        if (over.isSingle()) {
            end = Double.NEGATIVE_INFINITY;
            entry = over.heads[0];
            return;
        }
        double vx = line.dx * over.scaleX;
        double vz = line.dz * over.scaleZ;
        double speedX = Math.abs(vx);
        double speedZ = Math.abs(vz);
        gx = (line.ox - over.originX) * over.scaleX;
        gz = (line.oz - over.originZ) * over.scaleZ;
        boolean alongX = speedX > FLAT * speedZ;
        boolean alongZ = speedZ > FLAT * speedX;
        inverseX = 1 / vx;
        inverseZ = 1 / vz;
        boolean isInside = gx >= 0 && gx <= over.countX && gz >= 0 && gz <= over.countZ;
        if (!isInside && !enter(over, alongX, alongZ)) {
            end = Double.NEGATIVE_INFINITY;
            return;
        }
        int x = clamp(gx + begin * vx, over.countX);
        int z = clamp(gz + begin * vz, over.countZ);
        // -1 for a falling coordinate, else 0, without a branch that would be guessed wrong half of the time.
        int fallX = (int) (Double.doubleToRawLongBits(vx) >> 63);
        int fallZ = (int) (Double.doubleToRawLongBits(vz) >> 63);
        countX = 1 + 2 * fallX;
        countZ = 1 + 2 * fallZ;
        stepX = countX;
        stepZ = countZ;
        fillX = ~over.maskX & ~fallX;
        fillZ = ~over.maskZ & ~fallZ;
        lineX = x + 1 + fallX;
        lineZ = z + 1 + fallZ;
        crossX = alongX ? (lineX - gx) * inverseX : Double.POSITIVE_INFINITY;
        crossZ = alongZ ? (lineZ - gz) * inverseZ : Double.POSITIVE_INFINITY;
        double endX = alongX ? ((over.countX & ~fallX) - gx) * inverseX : Double.POSITIVE_INFINITY;
        double endZ = alongZ ? ((over.countZ & ~fallZ) - gz) * inverseZ : Double.POSITIVE_INFINITY;
        // At least the first tile is looked at, wherever rounding lets the walk end.
        end = Math.max(Math.min(endX, endZ), Math.nextUp(begin));
        atX = over.spreadX(x);
        atZ = over.spreadZ(z);
        ahead = over.heads[atX | atZ];
    }

    // Where the ray enters the window from outside; false where it passes by.
    private boolean enter(Tiles over, boolean alongX, boolean alongZ) {
        double enter = 0;
        double leave = Double.POSITIVE_INFINITY;
        if (alongX) {
            double one = (-Tiles.MARGIN - gx) * inverseX;
            double two = (over.countX + Tiles.MARGIN - gx) * inverseX;
            enter = Math.max(enter, Math.min(one, two));
            leave = Math.min(leave, Math.max(one, two));
        } else if (gx < -Tiles.MARGIN || gx > over.countX + Tiles.MARGIN) {
            return false;
        }
        if (alongZ) {
            double one = (-Tiles.MARGIN - gz) * inverseZ;
            double two = (over.countZ + Tiles.MARGIN - gz) * inverseZ;
            enter = Math.max(enter, Math.min(one, two));
            leave = Math.min(leave, Math.max(one, two));
        } else if (gz < -Tiles.MARGIN || gz > over.countZ + Tiles.MARGIN) {
            return false;
        }
        begin = enter;
        return enter <= leave;
    }

    private static int clamp(double place, int count) {
        return Math.max(0, Math.min((int) place, count - 1));
    }

    /**
     * The next object whose box the line may meet, on a tile that begins within the reach; {@link Tiles#NONE} after the
     * last.
     */
    int next(double reach) {
        while (true) {
            int id = isWithin ? within().next(reach) : Tiles.NONE;
            if (id != Tiles.NONE) {
                return id;
            }
            isWithin = false;
            id = nextListed(reach);
            if (!isWithin) {
                return id;
            }
        }
    }

    /** The same, but where it comes to a divided tile it only starts there. */
    private int nextListed(double reach) {
        Line l = line;
        double dx = l.dx;
        double dz = l.dz;
        double wayX = Math.abs(dx);
        double wayZ = Math.abs(dz);
        double fromX = 2 * l.ox;
        double fromZ = 2 * l.oz;
        double most = l.aside;
        // The middle of the way to the reach, twice and times the direction, as the offsets are; wide of what this
        // rounds.
        double half = reach * l.square;
        boolean isNarrow = half < Double.POSITIVE_INFINITY;
        double margin = isNarrow ? half * (1 + 0x1p-48) + most : Double.POSITIVE_INFINITY;
        half = isNarrow ? half : 0;
        int[] heads = tiles.heads;
        float[] entries = tiles.store.data;
        double from = begin;
        double cx = crossX;
        double cz = crossZ;
        double farX = lineX;
        double farZ = lineZ;
        int x = atX;
        int z = atZ;
        int listed = entry;
        int after = ahead;
        while (true) {
            while (listed >= 0) {
                double minX = entries[listed];
                double minZ = entries[listed + 1];
                double maxX = entries[listed + 2];
                double maxZ = entries[listed + 3];
                int id = Float.floatToRawIntBits(entries[listed + TileEntries.ID]);
                listed = Float.floatToRawIntBits(entries[listed + TileEntries.NEXT]);
                double offX = minX + maxX - fromX;
                double offZ = minZ + maxZ - fromZ;
                double wide = maxX - minX;
                double deep = maxZ - minZ;
                double across = (wide * wayZ + deep * wayX + most) - Math.abs(offX * dz - offZ * dx);
                double along = (wide * wayX + deep * wayZ + margin) - Math.abs(offX * dx + offZ * dz - half);
                // Two comparisons in one branch: a negative difference is a gap.
                long gaps = Double.doubleToRawLongBits(across) | Double.doubleToRawLongBits(along);
                if (gaps >= 0 && l.isNew(id)) {
                    begin = from;
                    crossX = cx;
                    crossZ = cz;
                    lineX = farX;
                    lineZ = farZ;
                    atX = x;
                    atZ = z;
                    entry = listed;
                    ahead = after;
                    return id;
                }
            }
            if (listed < Tiles.NONE) {
                within().start(tiles.within(listed));
                isWithin = true;
                break;
            }
            if (!(from <= reach && from < end)) {
                end = Double.NEGATIVE_INFINITY;
                break;
            }
            visited++;
            listed = after;
            if (cx < cz) {
                from = cx;
                x = ((x | fillX) + countX) & tiles.maskX;
                farX += stepX;
                cx = (farX - gx) * inverseX;
            } else {
                from = cz;
                z = ((z | fillZ) + countZ) & tiles.maskZ;
                farZ += stepZ;
                cz = (farZ - gz) * inverseZ;
            }
            after = heads[x | z];
        }
        begin = from;
        crossX = cx;
        crossZ = cz;
        lineX = farX;
        lineZ = farZ;
        atX = x;
        atZ = z;
        entry = Tiles.NONE;
        ahead = after;
        return Tiles.NONE;
    }

    private TileWalk within() {
        if (inner == null) {
            inner = new TileWalk(tiles, line);
        }
        return inner;
    }
}
