package robosim.geometry.narrow.planar;

import robosim.geometry.exact.DoubleDouble;
import robosim.geometry.exact.Orientation;
import robosim.geometry.exact.VectorMath;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;

/**
 * The projection of a leaf on the XZ plane, relative to an origin near it: a disc, a convex polygon, or the oval of a
 * turned cylinder (an ellipse swept along its minor axis).
 *
 * <p>Corners are within {@link #error} of the true ones in each coordinate, ordered from x towards z. A degenerate
 * polygon has two corners or one. Exact decisions start from the row itself ({@link ExactPolygon}).
 */
public final class PlanarShape {
    /** What the projection is. */
    public enum Outline {
        DISC,
        POLYGON,
        OVAL
    }

    /** The most corners a polygon has: those of an octagon. */
    static final int CORNERS = 8;

    // In u = 2^-53: each coordinate takes at most eight roundings of numbers no larger than the sum of the magnitudes
    // that enter it; the sum itself is rounded too.
    private static final double ROUNDING = 9 * 0x1p-53;

    // A triangle's corner is one difference: off by 1u of itself.
    private static final double CORNER_ROUNDING = 0x1p-53;

    public Outline outline = Outline.POLYGON;

    /** The number of corners; 0 of a disc or an oval. */
    public int count;

    public final double[] x = new double[CORNERS];
    public final double[] z = new double[CORNERS];

    /** The rounding errors of a triangle's corners, which are rounded once; 0 for all other shapes. */
    public final double[] tailX = new double[CORNERS];

    public final double[] tailZ = new double[CORNERS];

    /**
     * The direction of the side that leads to each corner from the previous one, of any length. Not the difference of
     * the two corners: rounding could turn that arbitrarily for a short side seen from far away. For a box, the own
     * axis as stored; for an octagon, the direction of its plane; for a triangle, the difference of the stored corners,
     * off by 1u of itself.
     */
    public final double[] sideX = new double[CORNERS];

    public final double[] sideZ = new double[CORNERS];

    /** The error bound of each corner coordinate; for a disc or an oval, that of its outline. */
    public double error;

    /** An upper bound of each corner coordinate and of the sum of the magnitudes that enter it. */
    public double size;

    /** The centre of a disc or an oval. */
    public double centerX;

    public double centerZ;

    /** The radius of a disc; half the width of an oval across its axis. */
    public double radius;

    /** The oval's own direction, of unit length. */
    public double axisX;

    public double axisZ;

    /** Half the length of the straight part of an oval. */
    public double reach;

    /** Half the thickness of the swept ellipse, measured along the axis. */
    public double minor;

    /** The last support point. */
    public double pointX;

    public double pointZ;

    private final BoxProjection box = new BoxProjection();

    private static Outline outline(LeafKind kind) {
        return switch (kind.fromAbove()) {
            case DISC -> Outline.DISC;
            case POLYGON -> Outline.POLYGON;
            case OVAL -> Outline.OVAL;
            case TRIANGLES, CELLS -> throw kind.refused();
        };
    }

    /** Whether it is so small and so near that products of its numbers would underflow; then no filter holds. */
    public boolean isTiny() {
        return error < 0x1p-448;
    }

    /** By how much a tiny shape has to be enlarged for its squares: down to the least double nothing underflows then. */
    double enlargement() {
        return error < 0x1p-900 ? 0x1p950 : VectorMath.ENLARGED;
    }

    /** Scales the corners by a power of two, so that nothing is rounded. */
    void enlarge(double power) {
        for (int k = 0; k < count; k++) {
            x[k] *= power;
            z[k] *= power;
        }
    }

    static double bound(double size, double rounding) {
        return size < 0x1p-450 ? 2 * size + Double.MIN_VALUE : rounding * size;
    }

    /** An origin near a leaf, relative to which it and other leaves are projected: its centre or one corner. */
    public static double originX(LeafKind kind, double[] row, int at) {
        return switch (kind.layout()) {
            case CENTRE, CORNERS -> row[at];
            case RANGES -> (row[at] + row[at + 1]) / 2;
        };
    }

    public static double originZ(LeafKind kind, double[] row, int at) {
        return switch (kind.layout()) {
            case CENTRE, CORNERS -> row[at + 2];
            case RANGES -> (row[at + 2] + row[at + 3]) / 2;
        };
    }

    /** Sets this to the projection of a leaf, relative to (ox, oz). */
    public void set(LeafKind kind, double[] row, int at, double ox, double oz) {
        outline = outline(kind);
        count = 0;
        switch (kind) {
            case UPRIGHT_CYLINDER, SPHERE, UPRIGHT_CAPSULE -> disc(row, at, ox, oz);
            case CYLINDER -> oval(row, at, ox, oz);
            case CAPSULE -> {
                oval(row, at, ox, oz);
                minor = radius; // its ends are discs
            }
            case TRIANGLE -> triangle(row, at, ox, oz);
            case PRISM -> octagon(row, at, ox, oz);
            case UPRIGHT_BOX, BOX -> box.set(this, row, at, ox, oz);
            case MESH, SOLID_MESH, GRID -> throw kind.refused();
        }
    }

    /** The origin itself, as a disc of radius 0. */
    public void point() {
        outline = Outline.DISC;
        count = 0;
        centerX = 0;
        centerZ = 0;
        radius = 0;
        error = 0;
    }

    private void disc(double[] row, int at, double ox, double oz) {
        centerX = row[at] - ox;
        centerZ = row[at + 2] - oz;
        radius = row[at + Leaf.SIZE];
        error = bound(Math.abs(centerX) + Math.abs(centerZ) + radius, ROUNDING);
    }

    private void oval(double[] row, int at, double ox, double oz) {
        centerX = row[at] - ox;
        centerZ = row[at + 2] - oz;
        radius = row[at + Leaf.SIZE];
        double ax = row[at + Leaf.ROTATION + 1];
        double ay = row[at + Leaf.ROTATION + 4];
        double az = row[at + Leaf.ROTATION + 7];
        double flat = ax * ax + az * az;
        double level = Math.sqrt(flat);
        // The caps are circles in space about an axis of any length; the half height is in units of that length.
        minor = radius * Math.abs(ay) / Math.sqrt(flat + ay * ay);
        reach = row[at + Leaf.SIZE + 1] * level;
        axisX = level > 0 ? ax / level : 1;
        axisZ = level > 0 ? az / level : 0;
        error = bound(Math.abs(centerX) + Math.abs(centerZ) + 2 * radius + reach, ROUNDING);
    }

    private void triangle(double[] row, int at, double ox, double oz) {
        double x0 = row[at] - ox;
        double z0 = row[at + 2] - oz;
        double x1 = row[at + 3] - ox;
        double z1 = row[at + 5] - oz;
        double x2 = row[at + 6] - ox;
        double z2 = row[at + 8] - oz;
        size = Math.max(
                Math.max(Math.abs(x0), Math.abs(z0)),
                Math.max(Math.max(Math.abs(x1), Math.abs(z1)), Math.max(Math.abs(x2), Math.abs(z2))));
        error = bound(size, CORNER_ROUNDING);
        int turn = isSame(row, at, at + 3) || isSame(row, at + 3, at + 6) || isSame(row, at + 6, at)
                ? 0
                : Orientation.side(row[at], row[at + 2], row[at + 3], row[at + 5], row[at + 6], row[at + 8]);
        if (turn > 0) {
            corner(x0, z0);
            corner(x1, z1);
            corner(x2, z2);
            side(0, row, at + 6, at);
            side(1, row, at, at + 3);
            side(2, row, at + 3, at + 6);
            tail(0, row, at, ox, oz);
            tail(1, row, at + 3, ox, oz);
            tail(2, row, at + 6, ox, oz);
        } else if (turn < 0) {
            corner(x0, z0);
            corner(x2, z2);
            corner(x1, z1);
            side(0, row, at + 3, at);
            side(1, row, at, at + 6);
            side(2, row, at + 6, at + 3);
            tail(0, row, at, ox, oz);
            tail(1, row, at + 6, ox, oz);
            tail(2, row, at + 3, ox, oz);
        } else {
            flatTriangle(row, at, x0, z0, x1, z1, x2, z2);
            tails(row, at, ox, oz);
        }
    }

    private void side(int k, double[] row, int from, int to) {
        sideX[k] = row[to] - row[from];
        sideZ[k] = row[to + 2] - row[from + 2];
    }

    private static boolean isSame(double[] row, int p, int q) {
        return row[p] == row[q] && row[p + 2] == row[q + 2];
    }

    // Each corner is one of the row's three, in any order.
    private void tails(double[] row, int at, double ox, double oz) {
        for (int k = 0; k < count; k++) {
            for (int from = at; from < at + 9; from += 3) {
                if (row[from] - ox == x[k] && row[from + 2] - oz == z[k]) {
                    tail(k, row, from, ox, oz);
                    break;
                }
            }
        }
    }

    private void tail(int k, double[] row, int from, double ox, double oz) {
        tailX[k] = DoubleDouble.differenceTail(row[from], ox, x[k]);
        tailZ[k] = DoubleDouble.differenceTail(row[from + 2], oz, z[k]);
    }

    // The longest side of a degenerate triangle.
    private void flatTriangle(double[] row, int at, double x0, double z0, double x1, double z1, double x2, double z2) {
        double s01 = Math.max(Math.abs(x1 - x0), Math.abs(z1 - z0));
        double s12 = Math.max(Math.abs(x2 - x1), Math.abs(z2 - z1));
        double s20 = Math.max(Math.abs(x0 - x2), Math.abs(z0 - z2));
        if (s01 >= s12 && s01 >= s20) {
            segment(row, at, at + 3, x0, z0, x1, z1);
        } else if (s12 >= s20) {
            segment(row, at + 3, at + 6, x1, z1, x2, z2);
        } else {
            segment(row, at + 6, at, x2, z2, x0, z0);
        }
    }

    private void segment(double[] row, int from, int to, double x0, double z0, double x1, double z1) {
        corner(x0, z0);
        if (x0 != x1 || z0 != z1) {
            corner(x1, z1);
            side(0, row, to, from);
            side(1, row, from, to);
        }
    }

    void corner(double px, double pz) {
        x[count] = px;
        z[count] = pz;
        tailX[count] = 0;
        tailZ[count] = 0;
        count++;
    }

    private void octagon(double[] row, int at, double ox, double oz) {
        double x0 = row[at] - ox;
        double x1 = row[at + 1] - ox;
        double z0 = row[at + 2] - oz;
        double z1 = row[at + 3] - oz;
        double so = ox + oz;
        double to = ox - oz;
        double s0 = row[at + 4] - so;
        double s1 = row[at + 5] - so;
        double d0 = row[at + 6] - to;
        double d1 = row[at + 7] - to;
        size = Math.abs(row[at])
                + Math.abs(row[at + 1])
                + Math.abs(row[at + 2])
                + Math.abs(row[at + 3])
                + 2 * (Math.abs(ox) + Math.abs(oz));
        error = bound(4 * size, ROUNDING);
        // The planes are rounded outward, so one may lie beyond the corner of its neighbours: move each back until it
        // touches that corner.
        for (int pass = 0; pass < 2; pass++) {
            x1 = Math.min(x1, Math.min(Math.min(d1 + z1, s1 - z0), (s1 + d1) / 2));
            x0 = Math.max(x0, Math.max(Math.max(d0 + z0, s0 - z1), (s0 + d0) / 2));
            z1 = Math.min(z1, Math.min(Math.min(s1 - x0, x1 - d0), (s1 - d0) / 2));
            z0 = Math.max(z0, Math.max(Math.max(s0 - x1, x0 - d1), (s0 - d1) / 2));
            s1 = Math.min(s1, x1 + z1);
            s0 = Math.max(s0, x0 + z0);
            d1 = Math.min(d1, x1 - z0);
            d0 = Math.max(d0, x0 - z1);
        }
        distinct(x1, x1 - d1, 1, 1);
        distinct(x1, s1 - x1, 0, 1);
        distinct(s1 - z1, z1, -1, 1);
        distinct(d0 + z1, z1, -1, 0);
        distinct(x0, x0 - d0, -1, -1);
        distinct(x0, s0 - x0, 0, -1);
        distinct(s0 - z0, z0, 1, -1);
        distinct(d1 + z0, z0, 1, 0);
        if (count > 1 && x[count - 1] == x[0] && z[count - 1] == z[0]) {
            count--;
            sideX[0] = sideX[count];
            sideZ[0] = sideZ[count];
        }
    }

    private void distinct(double px, double pz, double ex, double ez) {
        if (count == 0 || x[count - 1] != px || z[count - 1] != pz) {
            sideX[count] = ex;
            sideZ[count] = ez;
            corner(px, pz);
        }
    }

    /** The maximum of n . p over the shape, for a direction of any length; stores the point in pointX and pointZ. */
    public double support(double nx, double nz) {
        return switch (outline) {
            case POLYGON -> polygonSupport(nx, nz);
            case DISC -> discSupport(nx, nz);
            case OVAL -> ovalSupport(nx, nz);
        };
    }

    private double polygonSupport(double nx, double nz) {
        int best = 0;
        double most = nx * x[0] + nz * z[0];
        for (int k = 1; k < count; k++) {
            double here = nx * x[k] + nz * z[k];
            if (here > most) {
                most = here;
                best = k;
            }
        }
        pointX = x[best];
        pointZ = z[best];
        return most;
    }

    private double discSupport(double nx, double nz) {
        double length = Math.sqrt(nx * nx + nz * nz);
        pointX = centerX + radius * (nx / length);
        pointZ = centerZ + radius * (nz / length);
        return nx * centerX + nz * centerZ + radius * length;
    }

    private double ovalSupport(double nx, double nz) {
        double along = nx * axisX + nz * axisZ;
        double across = nz * axisX - nx * axisZ;
        double p = minor * along;
        double q = radius * across;
        double bulge = Math.sqrt(p * p + q * q);
        double u = along > 0 ? reach : along < 0 ? -reach : 0;
        double v = 0;
        if (bulge > 0) {
            u += minor * (p / bulge);
            v += radius * (q / bulge);
        }
        pointX = centerX + u * axisX - v * axisZ;
        pointZ = centerZ + u * axisZ + v * axisX;
        return nx * centerX + nz * centerZ + reach * Math.abs(along) + bulge;
    }
}
