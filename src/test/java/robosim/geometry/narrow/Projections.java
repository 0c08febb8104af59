package robosim.geometry.narrow;

import robosim.geometry.narrow.leaf.LeafKind;

/** The nearest point of a leaf, in its own frame: the plain twin of distances in space. */
public final class Projections {
    private Projections() {}

    /** The distance that alternating projections between the two come to; never below the truth. */
    public static double distance(LeafKind kindA, double[] a, LeafKind kindB, double[] b, int rounds) {
        double[] p = {a[0], a[1], a[2]};
        double[] q = p.clone();
        for (int n = 0; n < rounds; n++) {
            q = nearest(kindB, b, p);
            p = nearest(kindA, a, q);
        }
        return Math.sqrt(square(p[0] - q[0], p[1] - q[1], p[2] - q[2]));
    }

    public static double[] nearest(LeafKind kind, double[] row, double[] p) {
        return switch (kind) {
            case TRIANGLE -> triangle(row, p);
            case SPHERE -> sphere(row, p);
            case BOX, UPRIGHT_BOX -> box(row, p);
            case CYLINDER, UPRIGHT_CYLINDER -> cylinder(row, p);
            case PRISM, UPRIGHT_CAPSULE, CAPSULE, MESH, SOLID_MESH, GRID -> throw kind.refused();
        };
    }

    private static double[] own(double[] row, double[] p) {
        double[] own = new double[3];
        for (int k = 0; k < 3; k++) {
            for (int axis = 0; axis < 3; axis++) {
                own[k] += (p[axis] - row[axis]) * row[6 + 3 * axis + k];
            }
        }
        return own;
    }

    private static double[] world(double[] row, double[] own) {
        double[] p = {row[0], row[1], row[2]};
        for (int axis = 0; axis < 3; axis++) {
            for (int k = 0; k < 3; k++) {
                p[axis] += row[6 + 3 * axis + k] * own[k];
            }
        }
        return p;
    }

    private static double[] box(double[] row, double[] p) {
        double[] own = own(row, p);
        for (int k = 0; k < 3; k++) {
            own[k] = Math.max(-row[3 + k], Math.min(row[3 + k], own[k]));
        }
        return world(row, own);
    }

    private static double[] cylinder(double[] row, double[] p) {
        double[] own = own(row, p);
        double out = Math.sqrt(own[0] * own[0] + own[2] * own[2]);
        double shrink = out > row[3] ? row[3] / out : 1;
        own[0] *= shrink;
        own[2] *= shrink;
        own[1] = Math.max(-row[4], Math.min(row[4], own[1]));
        return world(row, own);
    }

    private static double[] sphere(double[] row, double[] p) {
        double dx = p[0] - row[0];
        double dy = p[1] - row[1];
        double dz = p[2] - row[2];
        double out = Math.sqrt(square(dx, dy, dz));
        double shrink = out > row[3] ? row[3] / out : 1;
        return new double[] {row[0] + dx * shrink, row[1] + dy * shrink, row[2] + dz * shrink};
    }

    private static double[] triangle(double[] row, double[] p) {
        double[] e = {row[3] - row[0], row[4] - row[1], row[5] - row[2]};
        double[] f = {row[6] - row[0], row[7] - row[1], row[8] - row[2]};
        double[] w = {p[0] - row[0], p[1] - row[1], p[2] - row[2]};
        double ee = dot(e, e);
        double ff = dot(f, f);
        double ef = dot(e, f);
        double det = ee * ff - ef * ef;
        double s = (dot(w, e) * ff - dot(w, f) * ef) / det;
        double t = (dot(w, f) * ee - dot(w, e) * ef) / det;
        if (s >= 0 && t >= 0 && s + t <= 1) {
            return new double[] {
                row[0] + s * e[0] + t * f[0], row[1] + s * e[1] + t * f[1], row[2] + s * e[2] + t * f[2]
            };
        }
        double[] best = segment(row, 0, 3, p);
        for (int k = 3; k < 9; k += 3) {
            double[] other = segment(row, k, (k + 3) % 9, p);
            if (square(other[0] - p[0], other[1] - p[1], other[2] - p[2])
                    < square(best[0] - p[0], best[1] - p[1], best[2] - p[2])) {
                best = other;
            }
        }
        return best;
    }

    private static double[] segment(double[] row, int from, int to, double[] p) {
        double[] e = {row[to] - row[from], row[to + 1] - row[from + 1], row[to + 2] - row[from + 2]};
        double[] w = {p[0] - row[from], p[1] - row[from + 1], p[2] - row[from + 2]};
        double t = Math.max(0, Math.min(1, dot(w, e) / dot(e, e)));
        return new double[] {row[from] + t * e[0], row[from + 1] + t * e[1], row[from + 2] + t * e[2]};
    }

    private static double dot(double[] p, double[] q) {
        return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
    }

    private static double square(double x, double y, double z) {
        return x * x + y * y + z * z;
    }
}
