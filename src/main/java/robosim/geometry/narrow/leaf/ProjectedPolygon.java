package robosim.geometry.narrow.leaf;

import robosim.geometry.exact.Orientation;

/**
 * The projection of a polytope on XZ as a convex polygon: corners in order (from x towards z), relative to an origin,
 * and for each edge from a corner to the next an outward normal of any length. A degenerate projection is a polygon
 * without area; its edges of zero length have normals too, so that a round shape meets its ends as it meets those of a
 * wall.
 *
 * <p>The error of a corner is at most 8u of {@link #size}; that of a normal one unit roundoff in each coordinate.
 */
public final class ProjectedPolygon {
    public static final int MOST_CORNERS = 8;

    public int corners;

    /** The number of normals: as many as corners, or 0 for a single point. */
    public int normals;

    public final double[] x = new double[MOST_CORNERS];
    public final double[] z = new double[MOST_CORNERS];
    public final double[] nx = new double[MOST_CORNERS];
    public final double[] nz = new double[MOST_CORNERS];

    /** An upper bound of the sum of the magnitudes of the terms of any corner's coordinate. */
    public double size;

    /** How each corner is composed; see {@code DoubleDoubleCorner}. */
    public final int[] source = new int[MOST_CORNERS];

    private final double[] gx = new double[3];
    private final double[] gz = new double[3];
    private final double[] ux = new double[3];
    private final double[] uz = new double[3];

    // Which column of the row each of these is, and whether as it is or turned back: a bit among three.
    private final int[] column = new int[3];
    private final int[] turned = new int[3];

    public void load(Leaf leaf, double ox, double oz) {
        switch (leaf.kind.polytope()) {
            case BOX -> {
                if (leaf.kind == LeafKind.UPRIGHT_BOX) {
                    rectangle(leaf.row, leaf.at, ox, oz);
                } else {
                    zonogon(leaf.row, leaf.at, ox, oz);
                }
            }
            case TRIANGLE -> triangle(leaf.row, leaf.at, ox, oz);
        }
        normals = corners;
    }

    /** A single point, which has no normals. */
    public void point(double px, double pz) {
        corners = 1;
        normals = 0;
        x[0] = px;
        z[0] = pz;
        source[0] = 0;
        size = Math.max(Math.abs(px), Math.abs(pz));
    }

    /** Multiplies all z by a sign: -1 mirrors the outline. */
    public void mirror(int sign) {
        for (int k = 0; k < corners; k++) {
            z[k] *= sign;
            nz[k] *= sign;
        }
    }

    private void rectangle(double[] row, int at, double ox, double oz) {
        double ax = row[at + 6];
        double az = row[at + 12];
        double bx = row[at + 8];
        double bz = row[at + 14];
        double cx = row[at] - ox;
        double cz = row[at + 2] - oz;
        double px = row[at + 3] * ax;
        double pz = row[at + 3] * az;
        double qx = row[at + 5] * bx;
        double qz = row[at + 5] * bz;
        corners = 4;
        set(0, cx - px - qx, cz - pz - qz, -bx, -bz);
        set(1, cx + px - qx, cz + pz - qz, ax, az);
        set(2, cx + px + qx, cz + pz + qz, bx, bz);
        set(3, cx - px + qx, cz - pz + qz, -ax, -az);
        source[0] = 0;
        source[1] = 1;
        source[2] = 5;
        source[3] = 4;
        size = Math.max(Math.abs(cx) + Math.abs(px) + Math.abs(qx), Math.abs(cz) + Math.abs(pz) + Math.abs(qz));
    }

    private void zonogon(double[] row, int at, double ox, double oz) {
        double px = row[at] - ox;
        double pz = row[at + 2] - oz;
        double sizeX = Math.abs(px);
        double sizeZ = Math.abs(pz);
        int count = 0;
        for (int k = 0; k < 3; k++) {
            double vx = row[at + 6 + k];
            double vz = row[at + 12 + k];
            if (vx == 0 && vz == 0) {
                continue;
            }
            // Half of the plane only, in order of the angle.
            boolean back = vz < 0 || (vz == 0 && vx < 0);
            if (back) {
                vx = -vx;
                vz = -vz;
            }
            int place = count++;
            while (place > 0 && Orientation.compareProducts(ux[place - 1], vz, uz[place - 1], vx) < 0) {
                copy(place - 1, place);
                place--;
            }
            ux[place] = vx;
            uz[place] = vz;
            column[place] = 1 << k;
            turned[place] = back ? 1 << k : 0;
            gx[place] = row[at + 3 + k] * vx;
            gz[place] = row[at + 3 + k] * vz;
            px -= gx[place];
            pz -= gz[place];
            sizeX += Math.abs(gx[place]);
            sizeZ += Math.abs(gz[place]);
        }
        corners = 2 * count;
        for (int k = 0; k < corners; k++) {
            int g = k % count;
            int sign = k < count ? 1 : -1;
            set(k, px, pz, sign * uz[g], -sign * ux[g]);
            source[k] = 0;
            for (int m = 0; m < count; m++) {
                boolean passed = k < count ? m < k : m >= k - count;
                source[k] |= passed ? column[m] ^ turned[m] : turned[m];
            }
            px += sign * 2 * gx[g];
            pz += sign * 2 * gz[g];
        }
        size = 2 * Math.max(sizeX, sizeZ);
    }

    private void copy(int from, int to) {
        ux[to] = ux[from];
        uz[to] = uz[from];
        column[to] = column[from];
        turned[to] = turned[from];
        gx[to] = gx[from];
        gz[to] = gz[from];
    }

    private void triangle(double[] row, int at, double ox, double oz) {
        int side = Orientation.side(row[at], row[at + 2], row[at + 3], row[at + 5], row[at + 6], row[at + 8]);
        if (side == 0) {
            segment(row, least(row, at, 1), least(row, at, -1), ox, oz);
            return;
        }
        int second = side > 0 ? at + 3 : at + 6;
        int third = side > 0 ? at + 6 : at + 3;
        corners = 3;
        corner(0, row, at, second, ox, oz);
        corner(1, row, second, third, ox, oz);
        corner(2, row, third, at, ox, oz);
        measure();
    }

    // The first (sign 1) or the last (sign -1) of three corners on a line.
    private static int least(double[] row, int at, int sign) {
        int best = at;
        for (int k = at + 3; k < at + 9; k += 3) {
            int order = Double.compare(row[k] + 0.0, row[best] + 0.0);
            order = order == 0 ? Double.compare(row[k + 2] + 0.0, row[best + 2] + 0.0) : order;
            if (sign * order < 0) {
                best = k;
            }
        }
        return best;
    }

    private void segment(double[] row, int p, int q, double ox, double oz) {
        double ex = row[q] - row[p];
        double ez = row[q + 2] - row[p + 2];
        if (ex == 0 && ez == 0) {
            ex = 1;
        }
        corners = 4;
        set(0, row[p] - ox, row[p + 2] - oz, ez, -ex);
        set(1, row[q] - ox, row[q + 2] - oz, ex, ez);
        set(2, x[1], z[1], -ez, ex);
        set(3, x[0], z[0], -ex, -ez);
        source[0] = p;
        source[1] = q;
        source[2] = q;
        source[3] = p;
        measure();
    }

    private void corner(int k, double[] row, int p, int q, double ox, double oz) {
        set(k, row[p] - ox, row[p + 2] - oz, row[q + 2] - row[p + 2], row[p] - row[q]);
        source[k] = p;
    }

    private void set(int k, double px, double pz, double normalX, double normalZ) {
        x[k] = px;
        z[k] = pz;
        nx[k] = normalX;
        nz[k] = normalZ;
    }

    private void measure() {
        size = 0;
        for (int k = 0; k < corners; k++) {
            size = Math.max(size, Math.max(Math.abs(x[k]), Math.abs(z[k])));
        }
    }
}
