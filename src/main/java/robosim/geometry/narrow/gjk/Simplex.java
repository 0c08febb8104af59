package robosim.geometry.narrow.gjk;

/**
 * Up to four points of a difference set a - b, and the point of least norm of their hull.
 *
 * <p>Every part of the simplex that contains the newest point is tried and the nearest wins, so that degenerate
 * simplices need no special case. The direction {@code v} of a side or an edge is computed perpendicular to it, not
 * taken from the point of least norm, which close to contact would be only rounding error.
 */
final class Simplex {
    /** A side this flat (squared sine) is replaced by its edges. */
    private static final double FLAT = 0x1p-96;

    /**
     * Squared distances this close are equal to within rounding; the larger part of the simplex has the better
     * direction.
     */
    private static final double TIE = 1 + 0x1p-48;

    /** Direction of the point of least norm; its length has no meaning. */
    double vx;

    double vy;
    double vz;

    private int count;
    private final double[] x = new double[4];
    private final double[] y = new double[4];
    private final double[] z = new double[4];
    private final double[] weight = new double[4];
    private final double[] pointsA = new double[12];
    private final double[] pointsB = new double[12];
    private final int[] corners = new int[4];

    private double norm;
    private double depth;

    // The best part found so far by reduce: its direction, weights and norm.
    private double foundNorm;
    private double foundX;
    private double foundY;
    private double foundZ;
    private final double[] found = new double[4];

    void clear() {
        count = 0;
        norm = Double.POSITIVE_INFINITY;
        depth = 0;
    }

    /** Adds the difference of two points found; returns false if it is there already. */
    boolean add(Support a, Support b) {
        double qx = a.x - b.x;
        double qy = a.y - b.y;
        double qz = a.z - b.z;
        for (int k = 0; k < count; k++) {
            if (x[k] == qx && y[k] == qy && z[k] == qz) {
                return false;
            }
        }
        x[count] = qx;
        y[count] = qy;
        z[count] = qz;
        pointsA[3 * count] = a.x;
        pointsA[3 * count + 1] = a.y;
        pointsA[3 * count + 2] = a.z;
        pointsB[3 * count] = b.x;
        pointsB[3 * count + 1] = b.y;
        pointsB[3 * count + 2] = b.z;
        corners[count] = corners(a, b);
        count++;
        return true;
    }

    /** Which corners two points found belong to, as one number. */
    static int corners(Support a, Support b) {
        return a.corner << 4 | b.corner;
    }

    int count() {
        return count;
    }

    /** Which corners a point's two belong to. */
    int corners(int k) {
        return corners[k];
    }

    /** Adds the difference of two points found and keeps the nearest part; returns false, unchanged, if that is no nearer. */
    boolean advance(Support a, Support b) {
        if (!add(a, b)) {
            return false;
        }
        if (reduce()) {
            return true;
        }
        count--;
        return false;
    }

    /** Keeps the part of the simplex that is nearest to the origin; returns false if that is further than before. */
    boolean reduce() {
        foundNorm = Double.POSITIVE_INFINITY;
        int newest = count - 1;
        if (count == 4 && holdsOrigin()) {
            norm = 0;
            return true;
        }
        corner(newest);
        for (int k = 0; k < newest; k++) {
            edge(k, newest);
        }
        for (int k = 0; k < newest; k++) {
            for (int m = k + 1; m < newest; m++) {
                side(k, m, newest);
            }
        }
        if (!(foundNorm <= norm * TIE)) {
            return false;
        }
        norm = foundNorm;
        vx = foundX;
        vy = foundY;
        vz = foundZ;
        compact();
        return true;
    }

    /** Squared distance of the nearest point, as given by the weights; 0 if the origin is inside. */
    double norm() {
        return norm;
    }

    /** Six times the least of the volumes into which the origin cuts the tetrahedron; 0 if it is not inside one. */
    double depth() {
        return depth;
    }

    /**
     * The distance from the origin of the point given by the weights; differs from the root of {@link #norm} if that is
     * 0.
     */
    double residual() {
        double sx = 0;
        double sy = 0;
        double sz = 0;
        for (int k = 0; k < count; k++) {
            sx += weight[k] * x[k];
            sy += weight[k] * y[k];
            sz += weight[k] * z[k];
        }
        return Math.sqrt(sx * sx + sy * sy + sz * sz);
    }

    double ax() {
        return mean(pointsA, 0);
    }

    double ay() {
        return mean(pointsA, 1);
    }

    double az() {
        return mean(pointsA, 2);
    }

    double bx() {
        return mean(pointsB, 0);
    }

    double by() {
        return mean(pointsB, 1);
    }

    double bz() {
        return mean(pointsB, 2);
    }

    private double mean(double[] points, int axis) {
        double sum = 0;
        for (int k = 0; k < count; k++) {
            sum += weight[k] * points[3 * k + axis];
        }
        return sum;
    }

    private void corner(int p) {
        if (adopts(1, p, 1, p, 0, p, 0)) {
            find(x[p], y[p], z[p]);
        }
    }

    private void edge(int p, int q) {
        double ex = x[q] - x[p];
        double ey = y[q] - y[p];
        double ez = z[q] - z[p];
        double square = ex * ex + ey * ey + ez * ez;
        double t = -(x[p] * ex + y[p] * ey + z[p] * ez) / square;
        if (!(t > 0 && t < 1)) {
            return;
        }
        double dx = x[p] + t * ex;
        double dy = y[p] + t * ey;
        double dz = z[p] + t * ez;
        double slip = (dx * ex + dy * ey + dz * ez) / square;
        if (adopts(TIE, p, 1 - t, q, t, q, 0)) {
            find(dx - slip * ex, dy - slip * ey, dz - slip * ez);
        }
    }

    private void side(int p, int q, int r) {
        double qx = x[q] - x[p];
        double qy = y[q] - y[p];
        double qz = z[q] - z[p];
        double rx = x[r] - x[p];
        double ry = y[r] - y[p];
        double rz = z[r] - z[p];
        double tx = x[r] - x[q];
        double ty = y[r] - y[q];
        double tz = z[r] - z[q];
        double q2 = qx * qx + qy * qy + qz * qz;
        double r2 = rx * rx + ry * ry + rz * rz;
        double t2 = tx * tx + ty * ty + tz * tz;
        // The normal is computed from the two shorter edges, which minimizes cancellation.
        double nx;
        double ny;
        double nz;
        double product;
        if (r2 >= q2 && r2 >= t2) {
            nx = qy * tz - qz * ty;
            ny = qz * tx - qx * tz;
            nz = qx * ty - qy * tx;
            product = q2 * t2;
        } else if (q2 >= t2) {
            nx = ry * tz - rz * ty;
            ny = rz * tx - rx * tz;
            nz = rx * ty - ry * tx;
            product = r2 * t2;
        } else {
            nx = qy * rz - qz * ry;
            ny = qz * rx - qx * rz;
            nz = qx * ry - qy * rx;
            product = q2 * r2;
        }
        double n2 = nx * nx + ny * ny + nz * nz;
        if (!(n2 > FLAT * product)) {
            return;
        }
        int base = nearestOf(p, q, r);
        double height = (nx * x[base] + ny * y[base] + nz * z[base]) / n2;
        double fx = height * nx;
        double fy = height * ny;
        double fz = height * nz;
        double weightP = area(q, r, fx, fy, fz, nx, ny, nz) / n2;
        double weightQ = area(r, p, fx, fy, fz, nx, ny, nz) / n2;
        double weightR = area(p, q, fx, fy, fz, nx, ny, nz) / n2;
        double sum = weightP + weightQ + weightR;
        weightP /= sum;
        weightQ /= sum;
        weightR /= sum;
        boolean isInside = weightP > 0 && weightQ > 0 && weightR > 0;
        if (isInside && adopts(TIE, p, weightP, q, weightQ, r, weightR)) {
            double sign = height < 0 ? -1 : 1;
            find(sign * nx, sign * ny, sign * nz);
        }
    }

    private int nearestOf(int p, int q, int r) {
        double pp = x[p] * x[p] + y[p] * y[p] + z[p] * z[p];
        double qq = x[q] * x[q] + y[q] * y[q] + z[q] * z[q];
        double rr = x[r] * x[r] + y[r] * y[r] + z[r] * z[r];
        if (pp <= qq) {
            return pp <= rr ? p : r;
        }
        return qq <= rr ? q : r;
    }

    /** Twice the signed area of the triangle of two points and the foot f, times the length of n. */
    private double area(int p, int q, double fx, double fy, double fz, double nx, double ny, double nz) {
        double px = x[p] - fx;
        double py = y[p] - fy;
        double pz = z[p] - fz;
        double qx = x[q] - fx;
        double qy = y[q] - fy;
        double qz = z[q] - fz;
        return nx * (py * qz - pz * qy) + ny * (pz * qx - px * qz) + nz * (px * qy - py * qx);
    }

    /** Adopts a part of the simplex, and returns true, if its nearest point, as given by the weights, is the nearest so far. */
    private boolean adopts(double tie, int p, double wp, int q, double wq, int r, double wr) {
        double sx = wp * x[p] + wq * x[q] + wr * x[r];
        double sy = wp * y[p] + wq * y[q] + wr * y[r];
        double sz = wp * z[p] + wq * z[q] + wr * z[r];
        double square = sx * sx + sy * sy + sz * sz;
        if (!(square < foundNorm * tie)) {
            return false;
        }
        foundNorm = square;
        for (int k = 0; k < 4; k++) {
            found[k] = 0;
        }
        found[p] += wp;
        found[q] += wq;
        found[r] += wr;
        return true;
    }

    /** Sets the direction of the part adopted. */
    private void find(double dx, double dy, double dz) {
        foundX = dx;
        foundY = dy;
        foundZ = dz;
    }

    /** Removes the points that have no weight. */
    private void compact() {
        int kept = 0;
        for (int k = 0; k < count; k++) {
            if (found[k] > 0) {
                x[kept] = x[k];
                y[kept] = y[k];
                z[kept] = z[k];
                weight[kept] = found[k];
                corners[kept] = corners[k];
                for (int axis = 0; axis < 3; axis++) {
                    pointsA[3 * kept + axis] = pointsA[3 * k + axis];
                    pointsB[3 * kept + axis] = pointsB[3 * k + axis];
                }
                kept++;
            }
        }
        count = kept;
    }

    /** Whether the origin is in the tetrahedron; sets the weights if it is. */
    private boolean holdsOrigin() {
        double w0 = volume(1, 2, 3);
        double w1 = -volume(0, 2, 3);
        double w2 = volume(0, 1, 3);
        double w3 = -volume(0, 1, 2);
        boolean allPositive = w0 > 0 && w1 > 0 && w2 > 0 && w3 > 0;
        boolean allNegative = w0 < 0 && w1 < 0 && w2 < 0 && w3 < 0;
        if (!allPositive && !allNegative) {
            return false;
        }
        depth = Math.min(Math.min(Math.abs(w0), Math.abs(w1)), Math.min(Math.abs(w2), Math.abs(w3)));
        double sum = w0 + w1 + w2 + w3;
        weight[0] = w0 / sum;
        weight[1] = w1 / sum;
        weight[2] = w2 / sum;
        weight[3] = w3 / sum;
        return true;
    }

    private double volume(int p, int q, int r) {
        return x[p] * (y[q] * z[r] - z[q] * y[r])
                + y[p] * (z[q] * x[r] - x[q] * z[r])
                + z[p] * (x[q] * y[r] - y[q] * x[r]);
    }
}
