package robosim.geometry.narrow.packet;

import java.util.Arrays;
import robosim.geometry.exact.FilterBound;
import robosim.geometry.exact.VectorMath;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.LeafKind;

/**
 * Up to 64 rays that begin at one place, and a sieve: it tells for one leaf after the other which of the rays may meet it
 * within what they have met so far, and mostly between which bounds, so that the kernel of single rays is asked about the
 * nearest leaf of each ray alone. Sets of rays are the bits of a long.
 *
 * <p>A leaf is made larger and smaller by a slack: what a ray misses of the larger one it misses of the leaf, and where it
 * enters the smaller one it has entered the leaf. The slack is a share of all coordinates and sizes. It is more than what is
 * rounded here, in the own frame of a leaf or in a unit vector; than how far columns are from orthonormal, less than 1e-8 of
 * what is taken to the own frame; and than the error of a distance that a kernel answers, 4 ulp of the coordinates.
 *
 * <p>An instance belongs to one owner of queries and allocates nothing.
 */
public final class RayPacket {
    /** The most rays. */
    public static final int MOST = Lanes.COUNT;

    /** All of them. */
    private static final long ALL = -1;

    private static final double SLACK = FilterBound.bound(0x1p-24);

    /** Sums of coordinates within which no product here loses bits or overflows. */
    private static final double SMALLEST = 0x1p-100;

    private static final double LARGEST = 0x1p104;

    /** A squared length is 1 for the slack if it is off by less. */
    private static final double UNIT = 0x1p-40;

    /** The unit directions. */
    final double[] x = new double[MOST];

    final double[] y = new double[MOST];
    final double[] z = new double[MOST];

    /** How far each ray still looks; below 0 for one that is not there. */
    final double[] near = new double[MOST];

    /** Where the start is. */
    private double ox;

    private double oy;
    private double oz;
    private double place;
    private int count;

    /** Whether all rays stay at the height of the start. */
    private boolean isLevel;

    // Reciprocals of the slopes along the world's axes; made when they are first needed.
    private final double[] worldX = new double[MOST];
    private final double[] worldY = new double[MOST];
    private final double[] worldZ = new double[MOST];
    private boolean hasWorld;

    // The same for the axes of a leaf, or the slopes.
    private final double[] ownX = new double[MOST];
    private final double[] ownY = new double[MOST];
    private final double[] ownZ = new double[MOST];
    private final double[] square = new double[MOST];
    private final double[] product = new double[MOST];
    private final double[] cross = new double[MOST];

    // Where the rays enter and leave the larger leaf, and the smaller one.
    private final double[] enter = new double[MOST];
    private final double[] leave = new double[MOST];
    private final double[] late = new double[MOST];
    private final double[] early = new double[MOST];

    /** The rays that certainly enter the leaf from outside. */
    private long sure;

    /**
     * Sets the rays.
     *
     * @param directions three numbers each, of any length but zero, from an index on
     * @param number how many rays
     */
    public void aim(double fromX, double fromY, double fromZ, double[] directions, int at, int number) {
        ox = fromX;
        oy = fromY;
        oz = fromZ;
        place = size(ox, oy, oz);
        count = number;
        hasWorld = false;
        isLevel = true;
        for (int i = 0, k = at; i < number; i++, k += 3) {
            double dx = directions[k];
            double dy = directions[k + 1];
            double dz = directions[k + 2];
            isLevel &= dy == 0;
            double square = dx * dx + dy * dy + dz * dz;
            if (!(Math.abs(square - 1) < UNIT)) {
                double scale = 1 / VectorMath.largest(dx, dy, dz);
                dx *= scale;
                dy *= scale;
                dz *= scale;
                double inverse = 1 / VectorMath.length(dx, dy, dz);
                dx *= inverse;
                dy *= inverse;
                dz *= inverse;
            }
            x[i] = dx;
            y[i] = dy;
            z[i] = dz;
        }
        if (number < MOST) {
            Arrays.fill(x, number, MOST, x[0]);
            Arrays.fill(y, number, MOST, y[0]);
            Arrays.fill(z, number, MOST, z[0]);
        }
    }

    /** Lets all rays look as far as a limit. */
    public void look(double limit) {
        Arrays.fill(near, 0, count, limit);
        Arrays.fill(near, count, MOST, -1);
    }

    /** The rays that there are. */
    public long rays() {
        return count == MOST ? ALL : (1L << count) - 1;
    }

    /** The number of rays. */
    public int count() {
        return count;
    }

    /** How far a ray still looks. */
    public double near(int ray) {
        return near[ray];
    }

    /** Makes a ray look no farther than this. */
    public void shorten(int ray, double limit) {
        near[ray] = Math.min(near[ray], limit);
    }

    /** How far any ray still looks. */
    public double reach() {
        return Lanes.most(near);
    }

    /** The unit directions: X, Y or Z of each; {@link #MOST} of them, with the first one again where there are fewer. Read only. */
    public double[] units(int axis) {
        return axis == 0 ? x : axis == 1 ? y : z;
    }

    /** Whether a ray certainly enters the last leaf from outside, between {@link #low} and {@link #high}. */
    public boolean isSure(int ray) {
        return (sure >>> ray & 1) != 0;
    }

    /** A lower bound of where a ray meets the last leaf. */
    public double low(int ray) {
        return enter[ray];
    }

    /** An upper bound where that is sure. */
    public double high(int ray) {
        return late[ray];
    }

    /** Whether anything but all rays can be told for a kind of leaf. */
    public static boolean knows(LeafKind kind) {
        return kind.isBox() || kind.isCylinder() || kind == LeafKind.SPHERE;
    }

    /** The rays that may meet a box of six numbers, its minimum corner and its maximum, within what they have met. */
    public long box(double[] b, int at) {
        double x = ox - (b[at] / 2 + b[at + 3] / 2);
        double y = oy - (b[at + 1] / 2 + b[at + 4] / 2);
        double z = oz - (b[at + 2] / 2 + b[at + 5] / 2);
        double halfX = b[at + 3] / 2 - b[at] / 2;
        double halfY = b[at + 4] / 2 - b[at + 1] / 2;
        double halfZ = b[at + 5] / 2 - b[at + 2] / 2;
        double size = place + size(x, y, z) + size(halfX, halfY, halfZ);
        if (!isOrdinary(size)) {
            return rays();
        }
        takeWorld();
        double slack = SLACK * size;
        if (isAbove(y, halfY, slack)) {
            return 0;
        }
        Lanes.slab(worldX, x, halfX + slack, enter, leave);
        if (!isLevel) {
            Lanes.clip(worldY, y, halfY + slack, enter, leave);
        }
        Lanes.clip(worldZ, z, halfZ + slack, enter, leave);
        return Lanes.hits(enter, leave, near) & rays();
    }

    /**
     * The rays that may meet a leaf within what they have met; those of a kind that is not known here are all the rays.
     */
    public long sift(LeafColumn column, int leaf) {
        sure = 0;
        double[] row = column.rows(leaf);
        int at = column.at(leaf);
        long met = switch (column.kind(leaf)) {
            case UPRIGHT_BOX -> boxes(row, at, true);
            case BOX -> boxes(row, at, false);
            case SPHERE -> spheres(row, at);
            case UPRIGHT_CYLINDER -> cylinders(row, at, true);
            case CYLINDER -> cylinders(row, at, false);
            case TRIANGLE, PRISM, UPRIGHT_CAPSULE, CAPSULE, MESH, SOLID_MESH, GRID -> ALL;
        };
        return met & rays();
    }

    /** Whether the rays are all above or below what is within a half of a height. */
    private boolean isAbove(double height, double half, double slack) {
        return isLevel && Math.abs(height) > half + slack;
    }

    private static double size(double x, double y, double z) {
        return Math.abs(x) + Math.abs(y) + Math.abs(z);
    }

    private static boolean isOrdinary(double size) {
        return size > SMALLEST && size < LARGEST;
    }

    private void takeWorld() {
        if (!hasWorld) {
            Lanes.inverses(x, y, z, 1, 0, 0, worldX);
            Lanes.inverses(x, y, z, 0, 1, 0, worldY);
            Lanes.inverses(x, y, z, 0, 0, 1, worldZ);
            hasWorld = true;
        }
    }

    private long boxes(double[] b, int j, boolean isUpright) {
        double mx = ox - b[j];
        double my = oy - b[j + 1];
        double mz = oz - b[j + 2];
        double halfX = b[j + 3];
        double halfY = b[j + 4];
        double halfZ = b[j + 5];
        double size = place + size(b[j], b[j + 1], b[j + 2]) + (halfX + halfY + halfZ);
        if (!isOrdinary(size)) {
            return rays();
        }
        double slack = SLACK * size;
        if (isUpright && isAbove(my, halfY, slack)) {
            return 0;
        }
        int r = j + Leaf.ROTATION;
        double[] ix = ownX;
        double[] iy = ownY;
        double[] iz = ownZ;
        double left = mx;
        double up = my;
        double back = mz;
        if (isUpright) {
            takeWorld();
            iy = worldY;
        } else {
            up = mx * b[r + 1] + my * b[r + 4] + mz * b[r + 7];
            Lanes.inverses(x, y, z, b[r + 1], b[r + 4], b[r + 7], iy);
        }
        if (isUpright && b[r] == 1 && b[r + 8] == 1 && b[r + 2] == 0 && b[r + 6] == 0) {
            ix = worldX;
            iz = worldZ;
        } else {
            left = mx * b[r] + my * b[r + 3] + mz * b[r + 6];
            back = mx * b[r + 2] + my * b[r + 5] + mz * b[r + 8];
            Lanes.inverses(x, y, z, b[r], b[r + 3], b[r + 6], ix);
            Lanes.inverses(x, y, z, b[r + 2], b[r + 5], b[r + 8], iz);
        }
        // A level ray may not be sure to be within a height that it is not certainly beyond.
        boolean isClipped = !(isUpright && isLevel && Math.abs(my) < halfY - slack);
        Lanes.slab(ix, left, halfX + slack, enter, leave);
        if (isClipped) {
            Lanes.clip(iy, up, halfY + slack, enter, leave);
        }
        Lanes.clip(iz, back, halfZ + slack, enter, leave);
        long met = Lanes.hits(enter, leave, near);
        if (met != 0) {
            Lanes.slab(ix, left, halfX - slack, late, early);
            if (isClipped) {
                Lanes.clip(iy, up, halfY - slack, late, early);
            }
            Lanes.clip(iz, back, halfZ - slack, late, early);
            sure = Lanes.sure(enter, late, early);
        }
        return met;
    }

    private long cylinders(double[] b, int j, boolean isUpright) {
        double mx = ox - b[j];
        double my = oy - b[j + 1];
        double mz = oz - b[j + 2];
        double radius = b[j + 3];
        double half = b[j + 4];
        double size = place + size(b[j], b[j + 1], b[j + 2]) + (radius + half);
        if (!isOrdinary(size)) {
            return rays();
        }
        double slack = SLACK * size;
        if (isUpright && isAbove(my, half, slack)) {
            return 0;
        }
        double[] iy = ownY;
        double up = my;
        if (isUpright) {
            takeWorld();
            iy = worldY;
            Lanes.across(x, z, mx, mz, square, product, cross);
        } else {
            int r = j + Leaf.ROTATION;
            double left = mx * b[r] + my * b[r + 3] + mz * b[r + 6];
            double back = mx * b[r + 2] + my * b[r + 5] + mz * b[r + 8];
            up = mx * b[r + 1] + my * b[r + 4] + mz * b[r + 7];
            Lanes.slopes(x, y, z, b[r], b[r + 3], b[r + 6], ownX);
            Lanes.slopes(x, y, z, b[r + 2], b[r + 5], b[r + 8], ownZ);
            Lanes.inverses(x, y, z, b[r + 1], b[r + 4], b[r + 7], iy);
            Lanes.across(ownX, ownZ, left, back, square, product, cross);
        }
        boolean isClipped = !(isUpright && isLevel && Math.abs(my) < half - slack);
        start(isClipped, iy, up, half + slack, enter, leave);
        Lanes.circle(square, product, cross, (radius + slack) * (radius + slack), enter, leave);
        long met = Lanes.hits(enter, leave, near);
        if (met != 0 && radius > slack) {
            start(isClipped, iy, up, half - slack, late, early);
            Lanes.circle(square, product, cross, (radius - slack) * (radius - slack), late, early);
            sure = Lanes.sure(enter, late, early);
        }
        return met;
    }

    /** Begins with what is within a slab, or with all of the rays. */
    private static void start(
            boolean isClipped, double[] inverses, double height, double half, double[] enter, double[] leave) {
        if (isClipped) {
            Lanes.slab(inverses, height, half, enter, leave);
        } else {
            Arrays.fill(enter, 0);
            Arrays.fill(leave, Double.POSITIVE_INFINITY);
        }
    }

    private long spheres(double[] b, int j) {
        double radius = b[j + 3];
        double size = place + size(b[j], b[j + 1], b[j + 2]) + radius;
        if (!isOrdinary(size)) {
            return rays();
        }
        double slack = SLACK * size;
        double mx = b[j] - ox;
        double my = b[j + 1] - oy;
        double mz = b[j + 2] - oz;
        Lanes.ahead(x, y, z, mx, my, mz, product, square);
        double larger = (radius + slack) * (radius + slack);
        double smaller = radius > slack ? (radius - slack) * (radius - slack) : 0;
        long met = Lanes.within(square, larger);
        long left = met;
        while (left != 0) {
            long bit = left & -left;
            left ^= bit;
            int i = Long.numberOfTrailingZeros(bit);
            double chord = Math.sqrt(larger - square[i]);
            double first = Math.max(0, product[i] - chord - slack);
            if (product[i] + chord + slack < 0 || first > near[i]) {
                met ^= bit;
                continue;
            }
            enter[i] = first;
            double rest = smaller - square[i];
            if (rest > 0 && first > 0) {
                late[i] = product[i] - Math.sqrt(rest) + slack;
                sure |= bit;
            }
        }
        return met;
    }
}
