package robosim.geometry.engine.motion;

import java.util.Arrays;

/** Half spaces n.x >= level of displacements, and the shortest displacement that lies in all of them. */
final class HalfSpaces {
    private static final int MOST = 48;
    private static final double SAME = 0x1p-40;

    private final double[] normals = new double[3 * MOST];
    private final double[] levels = new double[MOST];
    private int count;
    private final double[] contact = new double[6];
    private final double[] tried = new double[3];

    void clear() {
        count = 0;
    }

    int count() {
        return count;
    }

    /**
     * Adds the half space in which a displacement leaves a pair that touches.
     *
     * @param made the displacement at which it touches
     * @param more how far beyond the plane of the contact
     */
    void add(NearPairs pairs, int k, double[] made, double more) {
        pairs.contact(k, 0, contact);
        double depth = Math.max(0, pairs.level(k, contact, 3) - pairs.ownLevel(k, contact, 3));
        double far = made[0] * contact[3] + made[1] * contact[4] + made[2] * contact[5];
        add(contact[3], contact[4], contact[5], depth + more + far);
    }

    /** Adds a half space by its unit normal, unless there is no more room. */
    void add(double nx, double ny, double nz, double level) {
        if (count < MOST) {
            normals[3 * count] = nx;
            normals[3 * count + 1] = ny;
            normals[3 * count + 2] = nz;
            levels[count++] = level;
        }
    }

    /** Writes the shortest displacement in all half spaces; false if there is none, or none is found. */
    boolean least(double[] out) {
        double best = Double.POSITIVE_INFINITY;
        for (int p = 0; p < count; p++) {
            for (int axis = 0; axis < 3; axis++) {
                tried[axis] = levels[p] * normals[3 * p + axis];
            }
            best = take(best, out);
            for (int q = p + 1; q < count; q++) {
                if (onTwo(p, q)) {
                    best = take(best, out);
                }
                for (int r = q + 1; r < count; r++) {
                    if (onThree(p, q, r)) {
                        best = take(best, out);
                    }
                }
            }
        }
        return best < Double.POSITIVE_INFINITY;
    }

    private double take(double best, double[] out) {
        double square = tried[0] * tried[0] + tried[1] * tried[1] + tried[2] * tried[2];
        if (!(square < best)) {
            return best;
        }
        for (int p = 0; p < count; p++) {
            if (dot(p, tried) < levels[p] - 0x1p-40 * (Math.abs(levels[p]) + Math.sqrt(square))) {
                return best;
            }
        }
        System.arraycopy(tried, 0, out, 0, 3);
        return square;
    }

    private double dot(int p, double[] v) {
        return normals[3 * p] * v[0] + normals[3 * p + 1] * v[1] + normals[3 * p + 2] * v[2];
    }

    private double dot(int p, int q) {
        return normals[3 * p] * normals[3 * q]
                + normals[3 * p + 1] * normals[3 * q + 1]
                + normals[3 * p + 2] * normals[3 * q + 2];
    }

    /** The shortest displacement to the line in two planes. */
    private boolean onTwo(int p, int q) {
        double cosine = dot(p, q);
        double square = 1 - cosine * cosine;
        if (square < SAME) {
            return false;
        }
        double byP = (levels[p] - cosine * levels[q]) / square;
        double byQ = (levels[q] - cosine * levels[p]) / square;
        for (int axis = 0; axis < 3; axis++) {
            tried[axis] = byP * normals[3 * p + axis] + byQ * normals[3 * q + axis];
        }
        return true;
    }

    /** The point in three planes, by Cramer's rule. */
    private boolean onThree(int p, int q, int r) {
        Arrays.fill(tried, 0);
        double det = cross(q, r, 0, p);
        if (Math.abs(det) < 0x1p-20) {
            return false;
        }
        cross(q, r, levels[p] / det, p);
        cross(r, p, levels[q] / det, q);
        cross(p, q, levels[r] / det, r);
        return true;
    }

    private double cross(int p, int q, double times, int with) {
        int a = 3 * p;
        int b = 3 * q;
        double x = normals[a + 1] * normals[b + 2] - normals[a + 2] * normals[b + 1];
        double y = normals[a + 2] * normals[b] - normals[a] * normals[b + 2];
        double z = normals[a] * normals[b + 1] - normals[a + 1] * normals[b];
        tried[0] += times * x;
        tried[1] += times * y;
        tried[2] += times * z;
        return x * normals[3 * with] + y * normals[3 * with + 1] + z * normals[3 * with + 2];
    }
}
