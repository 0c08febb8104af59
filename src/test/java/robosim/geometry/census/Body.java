package robosim.geometry.census;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.jspecify.annotations.Nullable;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.LeafKind;

/** A convex leaf as the twin sees it: support, projection, corners and edges in plain doubles. Shares no code with the kernels. */
final class Body {
    enum Type {
        BOX,
        CYLINDER,
        TRIANGLE,
        SPHERE,
        CAPSULE
    }

    final Type type;
    final LeafKind kind;
    final double[] row;

    /** The centre; a triangle's first corner. */
    final double[] c;

    /** The own axes of a box; of a cylinder or a capsule the second is its axis. */
    final double[][] axes;

    final double[][] corners;
    final double[][] edges;

    private Body(Type type, LeafKind kind, double[] row) {
        this.type = type;
        this.kind = kind;
        this.row = row;
        c = new double[] {row[0], row[1], row[2]};
        axes = new double[3][];
        for (int k = 0; k < 3; k++) {
            axes[k] = isPlain(kind)
                    ? new double[] {k == 0 ? 1 : 0, k == 1 ? 1 : 0, k == 2 ? 1 : 0}
                    : new double[] {row[6 + k], row[9 + k], row[12 + k]};
        }
        corners = corners();
        edges = edges();
    }

    static Body box(double[] centre, double[] half, double[] r, boolean upright) {
        return new Body(
                Type.BOX, upright ? LeafKind.UPRIGHT_BOX : LeafKind.BOX, row(centre, r, half[0], half[1], half[2]));
    }

    static Body cylinder(double[] centre, double radius, double half, double[] r, boolean upright) {
        return new Body(
                Type.CYLINDER,
                upright ? LeafKind.UPRIGHT_CYLINDER : LeafKind.CYLINDER,
                row(centre, r, radius, half, 0));
    }

    private static boolean isPlain(LeafKind kind) {
        return kind == LeafKind.UPRIGHT_CYLINDER || kind == LeafKind.UPRIGHT_CAPSULE || kind == LeafKind.SPHERE;
    }

    static Body capsule(double[] centre, double radius, double half, double[] r, boolean upright) {
        return new Body(
                Type.CAPSULE, upright ? LeafKind.UPRIGHT_CAPSULE : LeafKind.CAPSULE, row(centre, r, radius, half, 0));
    }

    static Body sphere(double[] centre, double radius) {
        return new Body(Type.SPHERE, LeafKind.SPHERE, row(centre, new double[9], radius, 0, 0));
    }

    static Body triangle(double[] corners) {
        double[] row = Arrays.copyOf(corners, 16);
        return new Body(Type.TRIANGLE, LeafKind.TRIANGLE, row);
    }

    private static double[] row(double[] centre, double[] r, double p, double q, double s) {
        double[] row = new double[16];
        System.arraycopy(centre, 0, row, 0, 3);
        row[3] = p;
        row[4] = q;
        row[5] = s;
        System.arraycopy(r, 0, row, 6, 9);
        return row;
    }

    /** The same somewhere else. */
    Body movedBy(double[] way) {
        double[] moved = row.clone();
        for (int k = 0; k < (type == Type.TRIANGLE ? 9 : 3); k++) {
            moved[k] += way[k % 3];
        }
        return new Body(type, kind, moved);
    }

    /** What of a solid is deeper inside than a margin; null where nothing is, or it is no solid. */
    @Nullable
    Body shrunkBy(double by) {
        double[] smaller = row.clone();
        int sizes = switch (type) {
            case BOX -> 3;
            case CYLINDER -> 2;
            case SPHERE, CAPSULE -> 1;
            case TRIANGLE -> 0;
        };
        for (int k = 3; k < 3 + sizes; k++) {
            smaller[k] -= by;
            if (smaller[k] < 0) {
                return null;
            }
        }
        return sizes > 0 ? new Body(type, kind, smaller) : null;
    }

    void writeTo(LeafColumn column) {
        column.clear();
        column.append(1);
        column.setKind(0, kind);
        System.arraycopy(row, 0, column.rows(0), column.at(0), 16);
    }

    boolean isUpright() {
        return kind == LeafKind.UPRIGHT_BOX || kind == LeafKind.UPRIGHT_CYLINDER;
    }

    /** The sum of the half sizes. */
    double size() {
        return switch (type) {
            case BOX -> row[3] + row[4] + row[5];
            case CYLINDER, CAPSULE -> row[3] + row[4];
            case SPHERE -> row[3];
            case TRIANGLE -> Math.max(Vec.length(Vec.minus(corners[1], c)), Vec.length(Vec.minus(corners[2], c)));
        };
    }

    private double[][] corners() {
        if (type == Type.TRIANGLE) {
            return new double[][] {c, {row[3], row[4], row[5]}, {row[6], row[7], row[8]}};
        }
        if (type != Type.BOX) {
            return new double[0][];
        }
        double[][] out = new double[8][];
        for (int k = 0; k < 8; k++) {
            double[] p = c;
            for (int axis = 0; axis < 3; axis++) {
                p = Vec.plus(p, (k >> axis & 1) == 0 ? -row[3 + axis] : row[3 + axis], axes[axis]);
            }
            out[k] = p;
        }
        return out;
    }

    /** From where, and the way to the other end: six numbers each. */
    private double[][] edges() {
        if (type == Type.TRIANGLE) {
            return new double[][] {edge(0, 1), edge(1, 2), edge(2, 0)};
        }
        if (type != Type.BOX) {
            return new double[0][];
        }
        double[][] out = new double[12][];
        int n = 0;
        for (int axis = 0; axis < 3; axis++) {
            for (int k = 0; k < 8; k++) {
                if ((k >> axis & 1) == 0) {
                    out[n++] = edge(k, k | 1 << axis);
                }
            }
        }
        return out;
    }

    private double[] edge(int from, int to) {
        double[] p = corners[from];
        double[] q = corners[to];
        return new double[] {p[0], p[1], p[2], q[0] - p[0], q[1] - p[1], q[2] - p[2]};
    }

    /** How far it reaches along n. */
    double reach(double[] n) {
        return switch (type) {
            case BOX ->
                Vec.dot(n, c)
                        + row[3] * Math.abs(Vec.dot(n, axes[0]))
                        + row[4] * Math.abs(Vec.dot(n, axes[1]))
                        + row[5] * Math.abs(Vec.dot(n, axes[2]));
            case CYLINDER ->
                Vec.dot(n, c) + row[4] * Math.abs(Vec.dot(n, axes[1])) + row[3] * Vec.length(Vec.cross(n, axes[1]));
            case SPHERE -> Vec.dot(n, c) + row[3] * Vec.length(n);
            case CAPSULE -> Vec.dot(n, c) + row[4] * Math.abs(Vec.dot(n, axes[1])) + row[3] * Vec.length(n);
            case TRIANGLE -> Math.max(Vec.dot(n, c), Math.max(Vec.dot(n, corners[1]), Vec.dot(n, corners[2])));
        };
    }

    /** The nearest point of it. */
    double[] project(double[] p) {
        double[] w = Vec.minus(p, c);
        switch (type) {
            case BOX -> {
                double[] out = c;
                for (int k = 0; k < 3; k++) {
                    double t = Math.max(-row[3 + k], Math.min(row[3 + k], Vec.dot(w, axes[k])));
                    out = Vec.plus(out, t, axes[k]);
                }
                return out;
            }
            case CYLINDER -> {
                double t = Vec.dot(w, axes[1]);
                double[] aside = Vec.plus(w, -t, axes[1]);
                double away = Vec.length(aside);
                double share = away > row[3] ? row[3] / away : 1;
                return Vec.plus(Vec.plus(c, Math.max(-row[4], Math.min(row[4], t)), axes[1]), share, aside);
            }
            case SPHERE -> {
                double away = Vec.length(w);
                return Vec.plus(c, away > row[3] ? row[3] / away : 1, w);
            }
            case CAPSULE -> {
                double[] foot = foot(p);
                double[] aside = Vec.minus(p, foot);
                double away = Vec.length(aside);
                return Vec.plus(foot, away > row[3] ? row[3] / away : 1, aside);
            }
            default -> {
                return projectOnTriangle(p);
            }
        }
    }

    /** The nearest point of a capsule's segment. */
    private double[] foot(double[] p) {
        double along = Vec.dot(Vec.minus(p, c), axes[1]);
        return Vec.plus(c, Math.max(-row[4], Math.min(row[4], along)), axes[1]);
    }

    /** A capsule's segment, as a triangle without a side of its own; the body itself if it is none. */
    Body core() {
        if (type != Type.CAPSULE) {
            return this;
        }
        double[] corners = new double[9];
        for (int k = 0; k < 3; k++) {
            corners[k] = c[k] - row[4] * axes[1][k];
            corners[3 + k] = c[k] + row[4] * axes[1][k];
            corners[6 + k] = corners[3 + k];
        }
        return triangle(corners);
    }

    /** How far it reaches around its core. */
    double around() {
        return type == Type.CAPSULE ? row[3] : 0;
    }

    /** The unit direction from it to a place outside, where the distance grows the most; zero inside. */
    double[] outward(double[] p) {
        if (type == Type.CAPSULE) {
            double[] away = Vec.minus(p, foot(p));
            double length = Vec.length(away);
            return length > row[3] ? Vec.plus(new double[3], 1 / length, away) : new double[3];
        }
        if (type != Type.CYLINDER) {
            double[] away = Vec.minus(p, project(p));
            double length = Vec.length(away);
            return length > 0 ? Vec.plus(new double[3], 1 / length, away) : away;
        }
        // Not from the nearest point, of which rounding leaves no direction near contact.
        double[] w = Vec.minus(p, c);
        double t = Vec.dot(w, axes[1]);
        double[] aside = Vec.plus(w, -t, axes[1]);
        double far = Vec.length(aside);
        double up = Math.max(0, Math.abs(t) - row[4]);
        double out = Math.max(0, far - row[3]);
        double all = StrictMath.hypot(up, out);
        if (!(all > 0)) {
            return new double[3];
        }
        double[] along = Vec.plus(new double[3], Math.signum(t) * up / all, axes[1]);
        return out > 0 ? Vec.plus(along, out / all / far, aside) : along;
    }

    private double[] projectOnTriangle(double[] p) {
        double[] e = Vec.minus(corners[1], c);
        double[] f = Vec.minus(corners[2], c);
        double[] n = Vec.cross(e, f);
        double square = Vec.dot(n, n);
        double[] w = Vec.minus(p, c);
        if (square > 0) {
            double s = Vec.dot(Vec.cross(w, f), n) / square;
            double t = Vec.dot(Vec.cross(e, w), n) / square;
            if (s >= 0 && t >= 0 && s + t <= 1) {
                return Vec.plus(Vec.plus(c, s, e), t, f);
            }
        }
        double[] best = c;
        double least = Double.POSITIVE_INFINITY;
        for (double[] edge : edges) {
            double[] from = {edge[0], edge[1], edge[2]};
            double[] way = {edge[3], edge[4], edge[5]};
            double length = Vec.dot(way, way);
            double t = length > 0 ? Math.max(0, Math.min(1, Vec.dot(Vec.minus(p, from), way) / length)) : 0;
            double[] q = Vec.plus(from, t, way);
            double away = Vec.length(Vec.minus(p, q));
            if (away < least) {
                least = away;
                best = q;
            }
        }
        return best;
    }

    /** A point that is furthest along n; any one where there are many. */
    double[] furthest(double[] n, SplittableRandom random) {
        switch (type) {
            case BOX -> {
                double[] out = c;
                for (int k = 0; k < 3; k++) {
                    double along = Vec.dot(n, axes[k]);
                    double t = Math.abs(along) < 1e-12 ? random.nextDouble(-1, 1) : Math.signum(along);
                    out = Vec.plus(out, t * row[3 + k], axes[k]);
                }
                return out;
            }
            case CYLINDER -> {
                double along = Vec.dot(n, axes[1]);
                double[] aside = Vec.plus(n, -along, axes[1]);
                double length = Vec.length(aside);
                double t = Math.abs(along) < 1e-12 ? random.nextDouble(-1, 1) : Math.signum(along);
                double[] out = Vec.plus(c, t * row[4], axes[1]);
                if (length < 1e-12) {
                    double[] any = Vec.unit(Vec.cross(axes[1], Vec.direction(random)));
                    return Vec.plus(out, row[3] * random.nextDouble(), any);
                }
                return Vec.plus(out, row[3] / length, aside);
            }
            case SPHERE -> {
                return Vec.plus(c, row[3] / Vec.length(n), n);
            }
            case CAPSULE -> {
                double along = Vec.dot(n, axes[1]);
                double t = Math.abs(along) < 1e-12 ? random.nextDouble(-1, 1) : Math.signum(along);
                return Vec.plus(Vec.plus(c, t * row[4], axes[1]), row[3] / Vec.length(n), n);
            }
            default -> {
                double[] sum = new double[3];
                double all = 0;
                double reach = reach(n);
                for (double[] corner : corners) {
                    double weight = reach - Vec.dot(n, corner) < 1e-12 * (size() + Vec.length(c))
                            ? random.nextDouble(0.1, 1)
                            : 0;
                    sum = Vec.plus(sum, weight, corner);
                    all += weight;
                }
                return Vec.plus(new double[3], 1 / all, sum);
            }
        }
    }

    @Override
    public String toString() {
        return kind + " " + Arrays.toString(row);
    }
}
