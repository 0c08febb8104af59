package robosim.geometry.dynamics.spatial;

import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;

/**
 * The part of a convex piece that is foremost in a direction, to within a depth: a corner, an edge or a face, as a polygon
 * across that direction with a height at each corner. A rim is a polygon of which one corner is the foremost point.
 */
final class Feature {
    /** Corners of the polygon of a rim. */
    private static final int RIM = 16;

    /** Most points of a piece: a rim and the foremost point of the other one. */
    private static final int MOST = RIM + 2;

    int count;

    /** Across the direction, and along it. */
    final double[] s = new double[2 * MOST];

    final double[] t = new double[2 * MOST];
    final double[] height = new double[2 * MOST];

    private final double[] px = new double[MOST];
    private final double[] py = new double[MOST];
    private final double[] pz = new double[MOST];
    private int points;
    private final double[] hs = new double[2 * MOST];
    private final double[] ht = new double[2 * MOST];
    private final double[] hh = new double[2 * MOST];

    /**
     * Finds it.
     *
     * @param frame nine numbers: two unit vectors across the direction and the direction along which heights are told
     * @param sign  1 for what is foremost along the third of them, -1 for what is hindmost
     */
    void find(LeafKind kind, double[] row, int at, double[] origin, double[] frame, double sign, double within) {
        points = 0;
        double dx = sign * frame[6];
        double dy = sign * frame[7];
        double dz = sign * frame[8];
        collect(kind, row, at, dx, dy, dz);
        double most = Double.NEGATIVE_INFINITY;
        for (int k = 0; k < points; k++) {
            px[k] -= origin[0];
            py[k] -= origin[1];
            pz[k] -= origin[2];
            most = Math.max(most, dx * px[k] + dy * py[k] + dz * pz[k]);
        }
        count = 0;
        for (int k = 0; k < points; k++) {
            double along = dx * px[k] + dy * py[k] + dz * pz[k];
            if (along >= most - within) {
                s[count] = frame[0] * px[k] + frame[1] * py[k] + frame[2] * pz[k];
                t[count] = frame[3] * px[k] + frame[4] * py[k] + frame[5] * pz[k];
                height[count] = sign * along;
                count++;
            }
        }
        dropWhatIsBehind(sign);
        surround();
    }

    /** Of a thin piece the far side is near too: what is steeply behind another point belongs to it. */
    private void dropWhatIsBehind(double sign) {
        int kept = 0;
        for (int k = 0; k < count; k++) {
            boolean isBehind = false;
            for (int m = 0; m < count && !isBehind; m++) {
                double deeper = sign * (height[m] - height[k]);
                double ds = s[m] - s[k];
                double dt = t[m] - t[k];
                isBehind = deeper > 0 && ds * ds + dt * dt < deeper * deeper;
            }
            hs[k] = isBehind ? Double.NaN : s[k];
        }
        for (int k = 0; k < count; k++) {
            if (!Double.isNaN(hs[k])) {
                s[kept] = s[k];
                t[kept] = t[k];
                height[kept] = height[k];
                kept++;
            }
        }
        count = kept;
    }

    private void point(double x, double y, double z) {
        px[points] = x;
        py[points] = y;
        pz[points] = z;
        points++;
    }

    private void collect(LeafKind kind, double[] row, int at, double dx, double dy, double dz) {
        switch (kind) {
            case UPRIGHT_BOX, BOX -> {
                int r = at + Leaf.ROTATION;
                for (int corner = 0; corner < 8; corner++) {
                    double a = (corner & 1) == 0 ? row[at + 3] : -row[at + 3];
                    double b = (corner & 2) == 0 ? row[at + 4] : -row[at + 4];
                    double c = (corner & 4) == 0 ? row[at + 5] : -row[at + 5];
                    point(
                            row[at] + (row[r] * a + row[r + 1] * b + row[r + 2] * c),
                            row[at + 1] + (row[r + 3] * a + row[r + 4] * b + row[r + 5] * c),
                            row[at + 2] + (row[r + 6] * a + row[r + 7] * b + row[r + 8] * c));
                }
            }
            case SPHERE -> {
                double r = row[at + 3];
                point(row[at] + r * dx, row[at + 1] + r * dy, row[at + 2] + r * dz);
            }
            case UPRIGHT_CAPSULE -> capsule(row, at, 0, 1, 0, dx, dy, dz);
            case CAPSULE -> capsule(row, at, row[at + 7], row[at + 10], row[at + 13], dx, dy, dz);
            case UPRIGHT_CYLINDER -> cylinder(row, at, 0, 1, 0, dx, dy, dz);
            case CYLINDER -> cylinder(row, at, row[at + 7], row[at + 10], row[at + 13], dx, dy, dz);
            case TRIANGLE -> {
                for (int k = at; k < at + 9; k += 3) {
                    point(row[k], row[k + 1], row[k + 2]);
                }
            }
            case PRISM, MESH, SOLID_MESH, GRID -> throw kind.refused();
        }
    }

    private void capsule(double[] row, int at, double ax, double ay, double az, double dx, double dy, double dz) {
        double r = row[at + 3];
        double half = row[at + 4];
        for (int end = -1; end <= 1; end += 2) {
            point(
                    row[at] + end * half * ax + r * dx,
                    row[at + 1] + end * half * ay + r * dy,
                    row[at + 2] + end * half * az + r * dz);
        }
    }

    private void cylinder(double[] row, int at, double ax, double ay, double az, double dx, double dy, double dz) {
        double r = row[at + 3];
        double half = row[at + 4];
        double along = ax * dx + ay * dy + az * dz;
        double ex = dx - along * ax;
        double ey = dy - along * ay;
        double ez = dz - along * az;
        double size = Math.sqrt(ex * ex + ey * ey + ez * ez);
        if (size < 0x1p-40) { // straight up or down: any point of the rim will do
            boolean isFlat = Math.abs(ax) < 0.5;
            ex = isFlat ? 1 - ax * ax : -ay * ax;
            ey = isFlat ? -ax * ay : 1 - ay * ay;
            ez = isFlat ? -ax * az : -ay * az;
            size = Math.sqrt(ex * ex + ey * ey + ez * ez);
        }
        ex /= size;
        ey /= size;
        ez /= size;
        double fx = ay * ez - az * ey;
        double fy = az * ex - ax * ez;
        double fz = ax * ey - ay * ex;
        double near = along >= 0 ? half : -half;
        for (int k = 0; k < RIM; k++) {
            double c = r * COS[k];
            double n = r * COS[(k + RIM - RIM / 4) % RIM];
            point(
                    row[at] + near * ax + c * ex + n * fx,
                    row[at + 1] + near * ay + c * ey + n * fy,
                    row[at + 2] + near * az + c * ez + n * fz);
        }
        point(row[at] - near * ax + r * ex, row[at + 1] - near * ay + r * ey, row[at + 2] - near * az + r * ez);
    }

    private static final double[] COS = cosines();

    private static double[] cosines() {
        double[] all = new double[RIM];
        for (int k = 0; k < RIM; k++) {
            all[k] = StrictMath.cos(2 * Math.PI * k / RIM);
        }
        all[RIM / 4] = 0;
        all[3 * RIM / 4] = 0;
        return all;
    }

    /** Keeps the convex hull of the points, counter-clockwise (Andrew 1979). */
    private void surround() {
        for (int k = 1; k < count; k++) { // insertion sort by s, then t
            double a = s[k];
            double b = t[k];
            double h = height[k];
            int to = k;
            while (to > 0 && (s[to - 1] > a || (s[to - 1] == a && t[to - 1] > b))) {
                s[to] = s[to - 1];
                t[to] = t[to - 1];
                height[to] = height[to - 1];
                to--;
            }
            s[to] = a;
            t[to] = b;
            height[to] = h;
        }
        if (count < 3) {
            return;
        }
        int made = 0;
        for (int k = 0; k < count; k++) {
            made = turn(made, 2, k);
        }
        int lower = made + 1;
        for (int k = count - 2; k >= 0; k--) {
            made = turn(made, lower, k);
        }
        made--;
        System.arraycopy(hs, 0, s, 0, made);
        System.arraycopy(ht, 0, t, 0, made);
        System.arraycopy(hh, 0, height, 0, made);
        count = made;
    }

    private int turn(int size, int least, int k) {
        int made = size;
        while (made >= least && side(hs, ht, made - 2, made - 1, s[k], t[k]) <= 0) {
            made--;
        }
        hs[made] = s[k];
        ht[made] = t[k];
        hh[made] = height[k];
        return made + 1;
    }

    private static double side(double[] x, double[] y, int a, int b, double px, double py) {
        return (x[b] - x[a]) * (py - y[a]) - (y[b] - y[a]) * (px - x[a]);
    }

    /** The height of it where a line along the direction meets it. */
    double heightAt(double atS, double atT) {
        if (count == 1) {
            return height[0];
        }
        double as = s[1] - s[0];
        double bt = t[1] - t[0];
        double rise = height[1] - height[0];
        double ps = atS - s[0];
        double pt = atT - t[0];
        if (count == 2) {
            double square = as * as + bt * bt;
            double share = square > 0 ? Math.max(0, Math.min(1, (ps * as + pt * bt) / square)) : 0;
            return height[0] + share * rise;
        }
        // The plane of the three corners that span the largest triangle with the first edge.
        int far = 2;
        double area = 0;
        for (int k = 2; k < count; k++) {
            double twice = side(s, t, 0, 1, s[k], t[k]);
            if (twice > area) {
                area = twice;
                far = k;
            }
        }
        if (area <= 0) {
            return Math.max(height[0], height[1]);
        }
        double cs = s[far] - s[0];
        double ct = t[far] - t[0];
        double b = (ps * ct - pt * cs) / area;
        double c = (as * pt - bt * ps) / area;
        return height[0] + b * rise + c * (height[far] - height[0]);
    }

    /** Cuts away what is outside another one of at least three corners (Sutherland and Hodgman 1974); may leave nothing. */
    void clip(Feature by, double slack) {
        for (int k = 0; k < by.count && count > 0; k++) {
            int next = k + 1 == by.count ? 0 : k + 1;
            double es = by.s[next] - by.s[k];
            double et = by.t[next] - by.t[k];
            double length = Math.sqrt(es * es + et * et);
            if (length > 0) {
                cut(by.s[k], by.t[k], -et / length, es / length, slack);
            }
        }
    }

    /** Cuts an edge down to the extent of another one along it. */
    void clipAlong(Feature edge, double slack) {
        double es = edge.s[1] - edge.s[0];
        double et = edge.t[1] - edge.t[0];
        double length = Math.sqrt(es * es + et * et);
        cut(edge.s[0], edge.t[0], es / length, et / length, slack);
        if (count > 0) {
            cut(edge.s[1], edge.t[1], -es / length, -et / length, slack);
        }
    }

    /** Keeps what is on the inner side of a line. */
    private void cut(double onS, double onT, double ns, double nt, double slack) {
        int made = 0;
        int edges = count == 2 ? 1 : count;
        for (int k = 0; k < count; k++) {
            double d = (s[k] - onS) * ns + (t[k] - onT) * nt + slack;
            if (d >= 0) {
                made = keep(made, s[k], t[k], height[k]);
            }
            if (k < edges && count > 1) {
                int next = k + 1 == count ? 0 : k + 1;
                double e = (s[next] - onS) * ns + (t[next] - onT) * nt + slack;
                if ((d < 0 && e > 0) || (d > 0 && e < 0)) {
                    double share = d / (d - e);
                    made = keep(
                            made,
                            s[k] + share * (s[next] - s[k]),
                            t[k] + share * (t[next] - t[k]),
                            height[k] + share * (height[next] - height[k]));
                }
            }
        }
        System.arraycopy(hs, 0, s, 0, made);
        System.arraycopy(ht, 0, t, 0, made);
        System.arraycopy(hh, 0, height, 0, made);
        count = made;
    }

    private int keep(int made, double atS, double atT, double high) {
        if (made == hs.length) {
            return made;
        }
        hs[made] = atS;
        ht[made] = atT;
        hh[made] = high;
        return made + 1;
    }
}
