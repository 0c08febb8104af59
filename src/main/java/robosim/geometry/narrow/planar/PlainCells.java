package robosim.geometry.narrow.planar;

import robosim.geometry.exact.FilterBound;
import robosim.geometry.index.cells.CellScan;
import robosim.geometry.index.cells.PlacedCells;
import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafColumn;

/**
 * Whether an upright leaf that stands, or goes straight, meets a cell of a grid: in plain doubles, and only where these are
 * certain. In the cells' own coordinates a disc is compared with each square that is near its way by their distance, a box by
 * separating axes: those of the square, its own and the normal of its way, which are all edge normals of the square and of the
 * hexagon that the box sweeps.
 *
 * <p>An instance belongs to one owner of queries.
 */
public final class PlainCells {
    /** Doubles cannot tell. */
    public static final int UNSURE = 0;

    /** Every cell stays apart from the leaf, on all of its way. */
    public static final int PAST = 1;

    /** A cell overlaps the leaf on its way by more than rounding, and does not touch it at the start of one. */
    public static final int MET = -1;

    /** In units of the error of own coordinates, which a gap or a depth sums up a few of. */
    private static final double MARGIN = FilterBound.bound(16);

    /** More than the rounding of a sum of heights. */
    private static final double HEIGHT = FilterBound.bound(0x1p-48);

    private final CellScan scan = new CellScan();

    // All in cells: the middle, the way, and the reach along the cells' axes.
    private double u;
    private double v;
    private double du;
    private double dv;
    private double reachU;
    private double reachV;
    private double margin;

    // A disc has a radius; a box the unit vector of its first axis and its half sizes.
    private boolean isDisc;
    private double radius;
    private double axisU;
    private double axisV;
    private double halfAlong;
    private double halfAcross;

    /** The unit normal of the way. */
    private double normalU;

    private double normalV;

    /**
     * Compares a leaf with the cells of a grid.
     *
     * @param dx the way, 0 for a leaf that stands
     */
    public int compare(Dimension dimension, Leaf piece, double dx, double dy, double dz, LeafColumn grid, int leaf) {
        int heights = dimension == Dimension.PLANAR ? MET : heights(piece, dy, grid, leaf);
        if (heights == PAST || !take(piece, dx, dz, grid.cells(leaf))) {
            return heights == PAST ? PAST : UNSURE;
        }
        int found = PAST;
        for (int cell = scan.next(); cell >= 0; cell = scan.next()) {
            int columns = grid.cells(leaf).map.columns();
            int with = isDisc ? disc(cell % columns, cell / columns) : box(cell % columns, cell / columns);
            if (with == MET && heights == MET) {
                return MET;
            }
            if (with != PAST) {
                found = UNSURE;
            }
        }
        return found;
    }

    /** Whether the heights of a leaf stay apart from those of a grid, or overlap all the way by more than rounding. */
    private static int heights(Leaf piece, double dy, LeafColumn grid, int leaf) {
        double half = switch (piece.kind) {
            case UPRIGHT_BOX, UPRIGHT_CYLINDER -> piece.get(4);
            case SPHERE -> piece.get(3);
            case UPRIGHT_CAPSULE -> piece.get(3) + piece.get(4);
            case BOX, CYLINDER, TRIANGLE, PRISM, CAPSULE, MESH, SOLID_MESH, GRID -> Double.NaN;
        };
        double[] cells = grid.rows();
        int own = leaf * Leaf.STRIDE;
        double middle = cells[own + 1];
        double sum = half + cells[own + 4];
        double slack = HEIGHT * (Math.abs(piece.get(1)) + Math.abs(middle) + sum + Math.abs(dy));
        double before = piece.get(1) - middle;
        double after = before + dy;
        double nearest = before < 0 == after < 0 ? Math.min(Math.abs(before), Math.abs(after)) : 0;
        double farthest = Math.max(Math.abs(before), Math.abs(after));
        if (nearest > sum + slack) {
            return PAST;
        }
        return piece.kind.isVerticalPrism() && farthest < sum - slack ? MET : UNSURE;
    }

    /** Transforms a leaf and starts the scan; false for a kind without a plain comparison. */
    private boolean take(Leaf leaf, double dx, double dz, PlacedCells cells) {
        double x = leaf.get(0);
        double z = leaf.get(2);
        double size = leaf.get(3);
        double skew = 0;
        switch (leaf.kind) {
            case UPRIGHT_CYLINDER, SPHERE, UPRIGHT_CAPSULE -> {
                isDisc = true;
                radius = size * cells.perCell();
                reachU = radius;
                reachV = radius;
            }
            case UPRIGHT_BOX -> {
                isDisc = false;
                double cos = leaf.get(Leaf.ROTATION);
                double sin = leaf.get(Leaf.ROTATION + 2);
                skew = Math.abs(cos * cos + sin * sin - 1);
                double side = 1 / cells.perCell();
                axisU = cells.du(cos, 0.0 - sin) * side;
                axisV = cells.dv(cos, 0.0 - sin) * side;
                halfAlong = size * cells.perCell();
                halfAcross = leaf.get(5) * cells.perCell();
                reachU = Math.abs(axisU) * halfAlong + Math.abs(axisV) * halfAcross;
                reachV = Math.abs(axisV) * halfAlong + Math.abs(axisU) * halfAcross;
                size += leaf.get(5);
            }
            case BOX, CYLINDER, TRIANGLE, PRISM, CAPSULE, MESH, SOLID_MESH, GRID -> {
                return false;
            }
        }
        u = cells.u(x, z);
        v = cells.v(x, z);
        du = cells.du(dx, dz);
        dv = cells.dv(dx, dz);
        double slack = cells.slack(Math.abs(x) + Math.abs(z) + size + Math.abs(dx) + Math.abs(dz));
        double scanned = slack + 2 * skew * size * cells.perCell();
        margin = MARGIN * scanned;
        double way = Math.sqrt(du * du + dv * dv);
        normalU = way > 0 ? dv / way : 0;
        normalV = way > 0 ? -du / way : 0;
        scan.over(cells.map).start(u - reachU, v - reachV, u + reachU, v + reachV, du, dv, scanned);
        return true;
    }

    private int disc(int i, int j) {
        double q = i + 0.5 - u;
        double p = j + 0.5 - v;
        double start = fromSquare(q, p);
        if (du == 0 && dv == 0) {
            return apart(start - radius);
        }
        double off = Math.abs(normalU * q + normalV * p) - 0.5 * (Math.abs(normalU) + Math.abs(normalV)) - radius;
        if (off > margin) {
            return PAST;
        }
        double gap = fromWay(q, p, start) - radius;
        return gap < -margin && !(start - radius > margin) ? UNSURE : apart(gap);
    }

    private int apart(double gap) {
        return gap > margin ? PAST : gap < -margin ? MET : UNSURE;
    }

    /** The distance of the origin from the square around (q, p). */
    private static double fromSquare(double q, double p) {
        double a = Math.max(0, Math.abs(q) - 0.5);
        double b = Math.max(0, Math.abs(p) - 0.5);
        return Math.sqrt(a * a + b * b);
    }

    /** The distance of the square around (q, p) from the way, which begins at the origin. */
    private double fromWay(double q, double p, double start) {
        if (crosses(q, p)) {
            return 0;
        }
        double least = Math.min(start, fromSquare(q - du, p - dv));
        for (int corner = 0; corner < 4; corner++) {
            double cu = q + ((corner & 1) == 0 ? -0.5 : 0.5);
            double cv = p + ((corner & 2) == 0 ? -0.5 : 0.5);
            double share = Math.max(0, Math.min(1, (cu * du + cv * dv) / (du * du + dv * dv)));
            double eu = cu - share * du;
            double ev = cv - share * dv;
            least = Math.min(least, Math.sqrt(eu * eu + ev * ev));
        }
        return least;
    }

    /** Whether the way passes through the square, by separating axes. */
    private boolean crosses(double q, double p) {
        return Math.abs(q - du / 2) <= 0.5 + Math.abs(du) / 2
                && Math.abs(p - dv / 2) <= 0.5 + Math.abs(dv) / 2
                && Math.abs(normalU * q + normalV * p) <= 0.5 * (Math.abs(normalU) + Math.abs(normalV));
    }

    private int box(int i, int j) {
        double q = i + 0.5 - u;
        double p = j + 0.5 - v;
        double gap = boxGap(q, p, du, dv);
        if (du == 0 && dv == 0) {
            return apart(gap);
        }
        double half = 0.5 * (Math.abs(normalU) + Math.abs(normalV))
                + halfAlong * Math.abs(normalU * axisU + normalV * axisV)
                + halfAcross * Math.abs(normalV * axisU - normalU * axisV);
        gap = Math.max(gap, Math.abs(normalU * q + normalV * p) - half);
        return gap < -margin && !(boxGap(q, p, 0, 0) > margin) ? UNSURE : apart(gap);
    }

    /** The greatest gap, below 0 a depth, along the axes of the square and of the box, on a way. */
    private double boxGap(double q, double p, double wayU, double wayV) {
        double s = q - wayU / 2;
        double t = p - wayV / 2;
        double gap = Math.abs(s) - 0.5 - reachU - Math.abs(wayU) / 2;
        gap = Math.max(gap, Math.abs(t) - 0.5 - reachV - Math.abs(wayV) / 2);
        double corner = 0.5 * (Math.abs(axisU) + Math.abs(axisV));
        double along = Math.abs(s * axisU + t * axisV) - corner - halfAlong;
        gap = Math.max(gap, along - Math.abs(wayU * axisU + wayV * axisV) / 2);
        double across = Math.abs(t * axisU - s * axisV) - corner - halfAcross;
        return Math.max(gap, across - Math.abs(wayV * axisU - wayU * axisV) / 2);
    }
}
