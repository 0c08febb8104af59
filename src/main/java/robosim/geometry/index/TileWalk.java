package robosim.geometry.index;

import org.jspecify.annotations.Nullable;

/**
 * A ray's way over {@link Tiles}, front to back: from each tile to the neighbour through whose side the ray leaves it.
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
    private double gx;
    private double gz;
    private double inverseX;
    private double inverseZ;
    private double lineX;
    private double lineZ;
    private int stepX;
    private int stepZ;
    private int fillX;
    private int fillZ;
    private int atX;
    private int atZ;
    private int leftX;
    private int leftZ;
    private double begin;
    private double crossX;
    private double crossZ;
    private boolean isOver = true;
    private boolean isWithin;
    private @Nullable TileWalk inner;
    private int restHead = Tiles.NONE;
    private double fromX;
    private double fromZ;
    private double wayX;
    private double wayZ;
    private long visited;

    TileWalk(Tiles any) {
        tiles = any;
    }

    long visited() {
        return visited + (inner == null ? 0 : inner.visited());
    }

    void stop() {
        isOver = true;
    }

    /** The entries of the tiles that are walked. */
    Tiles.Entries entries() {
        return tiles.store;
    }

    /** Whether a ray begins near enough for the tiles' margin and is not too slow for a parameter. */
    static boolean isNear(Tiles over, double ox, double oz, double dx, double dz) {
        return over.isSingle()
                || (Math.abs((ox - over.originX) * over.scaleX) <= Tiles.REACH
                        && Math.abs((oz - over.originZ) * over.scaleZ) <= Tiles.REACH
                        && Math.max(Math.abs(dx * over.scaleX), Math.abs(dz * over.scaleZ)) > LEAST);
    }

    /** Starts the walk of a ray that is near. */
    void start(Tiles over, double ox, double oz, double dx, double dz) {
        tiles = over;
        begin = 0;
        isOver = false;
        isWithin = false;
        restHead = over.rest;
        fromX = ox;
        fromZ = oz;
        wayX = dx;
        wayZ = dz;
        if (over.isSingle()) {
            atX = 0;
            atZ = 0;
            leftX = 0;
            leftZ = 0;
            crossX = Double.POSITIVE_INFINITY;
            crossZ = Double.POSITIVE_INFINITY;
            return;
        }
        double vx = dx * over.scaleX;
        double vz = dz * over.scaleZ;
        double speedX = Math.abs(vx);
        double speedZ = Math.abs(vz);
        gx = (ox - over.originX) * over.scaleX;
        gz = (oz - over.originZ) * over.scaleZ;
        boolean alongX = speedX > FLAT * speedZ;
        boolean alongZ = speedZ > FLAT * speedX;
        inverseX = 1 / vx;
        inverseZ = 1 / vz;
        boolean isInside = gx >= 0 && gx <= over.countX && gz >= 0 && gz <= over.countZ;
        if (!isInside && !enter(over, alongX, alongZ)) {
            isOver = true;
            return;
        }
        int x = clamp(begin == 0 ? gx : gx + begin * vx, over.countX);
        int z = clamp(begin == 0 ? gz : gz + begin * vz, over.countZ);
        boolean rises = vx > 0;
        stepX = rises ? 1 : -1;
        fillX = rises ? ~over.maskX : 0;
        lineX = rises ? x + 1 : x;
        leftX = rises ? over.countX - 1 - x : x;
        crossX = alongX ? (lineX - gx) * inverseX : Double.POSITIVE_INFINITY;
        boolean deepens = vz > 0;
        stepZ = deepens ? 1 : -1;
        fillZ = deepens ? ~over.maskZ : 0;
        lineZ = deepens ? z + 1 : z;
        leftZ = deepens ? over.countZ - 1 - z : z;
        crossZ = alongZ ? (lineZ - gz) * inverseZ : Double.POSITIVE_INFINITY;
        atX = over.spreadX(x);
        atZ = over.spreadZ(z);
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
        return place <= 0 ? 0 : place >= count ? count - 1 : (int) place;
    }

    /**
     * The first entry of the next list that is not empty and whose tile begins within the reach;
     * {@link Tiles#NONE} after the last.
     */
    int next(double reach) {
        if (restHead != Tiles.NONE) {
            int head = restHead;
            restHead = Tiles.NONE;
            return head;
        }
        while (true) {
            if (isWithin) {
                int head = within().next(reach);
                if (head != Tiles.NONE) {
                    return head;
                }
                isWithin = false;
            }
            int head = isOver ? Tiles.NONE : step(reach);
            if (head >= Tiles.NONE) {
                return head;
            }
            within().start(tiles.within(head), fromX, fromZ, wayX, wayZ);
            isWithin = true;
        }
    }

    private TileWalk within() {
        if (inner == null) {
            inner = new TileWalk(tiles);
        }
        return inner;
    }

    /** What the next tile that is not empty holds. */
    private int step(double reach) {
        int[] heads = tiles.heads;
        int x = atX;
        int z = atZ;
        double cx = crossX;
        double cz = crossZ;
        double from = begin;
        while (from <= reach) {
            visited++;
            int head = heads[x | z];
            if (cx < cz) {
                from = cx;
                isOver = leftX-- == 0;
                x = ((x | fillX) + stepX) & tiles.maskX;
                lineX += stepX;
                cx = (lineX - gx) * inverseX;
            } else {
                from = cz;
                isOver = leftZ-- == 0;
                z = ((z | fillZ) + stepZ) & tiles.maskZ;
                lineZ += stepZ;
                cz = (lineZ - gz) * inverseZ;
            }
            if (head != Tiles.NONE || isOver) {
                begin = from;
                atX = x;
                atZ = z;
                crossX = cx;
                crossZ = cz;
                return head;
            }
        }
        isOver = true;
        return Tiles.NONE;
    }
}
