package robosim.geometry.proof;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.Point;
import robosim.geometry.narrow.gjk.Gjk;
import robosim.geometry.narrow.leaf.Leaf;

/** Looks for planes between the pieces of a course and those of a scene. Where doubles are not sure, the checker's own numbers decide. */
final class SlabSearch {
    /** Most planes for one pair of pieces; ten are usually enough for half a turn. */
    private static final int MOST_SLABS = 200;

    private static final int DEPTH = 44;

    /** Gaps that are negative by less than this fraction of sizes and places are tried to be widened. */
    private static final double NEARLY = 0x1p-6;

    private static final double FIRST_STEP = 0x1p-8;
    private static final double LAST_STEP = 0x1p-30;
    private static final int MOST_STEPS = 150;

    private final Gjk gjk = new Gjk();
    private final GapSearch gaps = new GapSearch();
    private final Leaf a = new Leaf();
    private final Leaf b = new Leaf();
    private final SceneRows scene;
    private final boolean isFlat;
    private final Course course;
    private final double margin;
    private @Nullable Path path;
    private int found;

    SlabSearch(SceneRows scene, Dimension dimension, Course course, double margin) {
        this.scene = scene;
        this.course = course;
        this.margin = margin;
        isFlat = dimension == Dimension.PLANAR;
    }

    /** The best direction so far, and how wide the gap is along it. */
    private static final class Best {
        double[] n = new double[3];
        double gap = Double.NEGATIVE_INFINITY;
    }

    /** Adds planes for a pair; whether they cover the whole course. */
    boolean find(int i, int j, boolean isWeak, List<Witness.Slab> out) {
        int before = out.size();
        found = 0;
        if (find(i, j, 0, course.end, DEPTH, isWeak, out)) {
            return true;
        }
        out.subList(before, out.size()).clear();
        return false;
    }

    private boolean find(int i, int j, double from, double to, int depth, boolean isWeak, List<Witness.Slab> out) {
        double error = Rows.ROUNDING * (course.size(i) + Rows.size(scene.rows[j])) + Double.MIN_NORMAL;
        Best best = new Best();
        boolean isSure = quick(i, j, from, to, error, best) || search(i, j, from, to, error, best);
        if (!isSure && best.gap > margin - error && (isWeak || best.gap > -error)) {
            isSure = isExact(i, j, best.n, from, to, isWeak);
        }
        if (!isSure && best.gap > margin - (course.cosine > 0 ? 1e9 : 1e4) * error) {
            for (double[] n : across(i, j, from, to)) {
                isSure = gap(i, j, n, from, to) > margin - error && isExact(i, j, n, from, to, isWeak);
                if (isSure) {
                    best.n = n;
                    break;
                }
            }
        }
        if (!isSure
                && !course.isTurn()
                && !course.isStill()
                && best.gap > margin - NEARLY * (course.size(i) + Rows.size(scene.rows[j]))) {
            isSure = polish(i, j, from, to, error, best);
        }
        if (isSure) {
            double[] n = best.n;
            out.add(new Witness.Slab(
                    i, j, from, to, new Point(n[0], n[1], n[2]), course.isTurn() ? course.along(i, n, from, to) : 0));
            return ++found <= MOST_SLABS;
        }
        if (depth == 0 || !course.isTurn() || isOverlap(i, j, from) || isOverlap(i, j, to)) {
            return false;
        }
        double middle = (from + to) / 2;
        return find(i, j, from, middle, depth - 1, isWeak, out) && find(i, j, middle, to, depth - 1, isWeak, out);
    }

    /** The direction that the kernel has for what is still, or at a moment of a motion. */
    private boolean quick(int i, int j, double from, double to, double error, Best best) {
        return kernel(i, j, from, from, to, error, best)
                || (course.cosine == 0
                        && to > from
                        && (kernel(i, j, to, from, to, error, best)
                                || kernel(i, j, (from + to) / 2, from, to, error, best)));
    }

    private boolean kernel(int i, int j, double moment, double from, double to, double error, Best best) {
        Rows.leaf(moment == 0 ? course.rows[i] : course.at(i, moment), a);
        Rows.leaf(scene.rows[j], b);
        if (isFlat) {
            gjk.planar(a, b);
        } else {
            gjk.spatial(a, b);
        }
        boolean isSure = offer(i, j, from, to, error, best);
        if (!isSure && !gjk.isClosed()) {
            gjk.close();
            isSure = offer(i, j, from, to, error, best);
        }
        return isSure;
    }

    private boolean offer(int i, int j, double from, double to, double error, Best best) {
        return offer(i, j, new double[] {-gjk.nx(), isFlat ? 0 : -gjk.ny(), -gjk.nz()}, from, to, error, best);
    }

    private boolean offer(int i, int j, double[] n, double from, double to, double error, Best best) {
        double gap = gap(i, j, n, from, to);
        if (gap > best.gap) {
            best.gap = gap;
            best.n = n;
        }
        return gap > margin + error;
    }

    private double gap(int i, int j, double[] n, double from, double to) {
        double[] back = {-n[0], -n[1], -n[2]};
        return -Rows.most(scene.rows[j], back) - course.top(i, n, from, to);
    }

    private boolean search(int i, int j, double from, double to, double error, Best best) {
        if (course.isTurn() || course.isStill()) {
            return false;
        }
        double[] n = new double[3];
        double[] row = scene.rows[j];
        if (isFlat) {
            Course flat = course.level(i);
            gaps.find(flat, 0, from, to, Rows.level(row), n);
            n = Rows.unit(new double[] {n[0], 0, n[2]});
        } else {
            gaps.find(course, i, from, to, row, n);
        }
        return (n[0] != 0 || n[1] != 0 || n[2] != 0) && offer(i, j, n, from, to, error, best);
    }

    /** Turns the best direction by less and less, as long as the gap becomes wider. */
    private boolean polish(int i, int j, double from, double to, double error, Best best) {
        double step = FIRST_STEP;
        double angle = 0;
        for (int k = 0; k < MOST_STEPS && step > LAST_STEP; k++) {
            double[] n = best.n;
            double[] u =
                    Rows.unit(Rows.cross(n, Math.abs(n[1]) < 0.7 ? new double[] {0, 1, 0} : new double[] {1, 0, 0}));
            double[] v = isFlat ? u : Rows.cross(n, u);
            double before = best.gap;
            for (int side = 0; side < (isFlat ? 2 : 6); side++) {
                double turn = isFlat ? side * Math.PI : angle + side * Math.PI / 3;
                double cos = step * StrictMath.cos(turn);
                double sin = isFlat ? 0 : step * StrictMath.sin(turn);
                double[] next = {
                    n[0] + cos * u[0] + sin * v[0], n[1] + cos * u[1] + sin * v[1], n[2] + cos * u[2] + sin * v[2]
                };
                if (offer(i, j, Rows.unit(next), from, to, error, best)) {
                    return true;
                }
            }
            angle += 0.7;
            step *= best.gap > before ? 1.5 : 0.6;
        }
        return false;
    }

    private boolean isOverlap(int i, int j, double moment) {
        Rows.leaf(course.at(i, moment), a);
        Rows.leaf(scene.rows[j], b);
        return (isFlat ? gjk.planar(a, b) : gjk.spatial(a, b)) == 0 && gjk.upper() <= gjk.error();
    }

    /** Normals of faces, and directions across two edges, or an edge and the way. */
    private List<double[]> across(int i, int j, double from, double to) {
        List<double[]> all = new ArrayList<>();
        if (course.cosine > 0) {
            rims(i, scene.rows[j], all);
        }
        List<double[]> mine = edges(course.at(i, (from + to) / 2));
        List<double[]> theirs = edges(scene.rows[j]);
        if (course.cosine == 0 && to > from && !course.isTurn()) {
            mine.add(course.way);
        }
        if (isFlat) {
            mine.add(new double[] {0, 1, 0});
        }
        mine.addAll(theirs);
        for (int k = 0; k < mine.size(); k++) {
            add(mine.get(k), all);
            for (int m = k + 1; m < mine.size(); m++) {
                add(Rows.cross(mine.get(k), mine.get(m)), all);
            }
        }
        return all;
    }

    /** Where an edge passes the far end of a cone: the direction across the edge and the rim of the cone at that distance. */
    private void rims(int i, double[] row, List<double[]> all) {
        double[] apex = course.rows[i];
        double[][] corners = Rows.corners(row);
        for (int k = 0; k < corners.length; k++) {
            for (int m = k + 1; m < corners.length; m++) {
                double[] e = new double[3];
                double[] v = new double[3];
                for (int axis = 0; axis < 3; axis++) {
                    e[axis] = corners[m][axis] - corners[k][axis];
                    v[axis] = corners[k][axis] - apex[axis];
                }
                double ee = Rows.product(e, e);
                double ve = Rows.product(v, e);
                double root = Math.sqrt(ve * ve - ee * (Rows.product(v, v) - course.end * course.end));
                for (int sign = -1; sign <= 1 && root >= 0; sign += 2) {
                    double s = (sign * root - ve) / ee;
                    double[] p = {v[0] + s * e[0], v[1] + s * e[1], v[2] + s * e[2]};
                    add(Rows.cross(Rows.cross(course.way, p), e), all);
                }
            }
        }
    }

    private void add(double[] v, List<double[]> all) {
        double[] n = Rows.unit(isFlat ? new double[] {v[0], 0, v[2]} : v);
        if (n[0] != 0 || n[1] != 0 || n[2] != 0) {
            all.add(n);
            all.add(new double[] {-n[0], -n[1], -n[2]});
        }
    }

    private static List<double[]> edges(double[] row) {
        List<double[]> edges = new ArrayList<>();
        for (int k = 0; k < 3; k++) {
            edges.add(
                    Rows.isTriangle(row)
                            ? new double[] {
                                row[(3 * k + 3) % 9] - row[3 * k],
                                row[(3 * k + 4) % 9] - row[3 * k + 1],
                                row[(3 * k + 5) % 9] - row[3 * k + 2]
                            }
                            : new double[] {row[3 + k], row[6 + k], row[9 + k]});
        }
        return edges;
    }

    private boolean isExact(int i, int j, double[] n, double from, double to, boolean isWeak) {
        Path known = path == null ? course.exact() : path;
        path = known;
        Piece mine = known.body().get(i);
        Vec normal = Vec.of(n[0], n[1], n[2]);
        Num bound = scene.exact(j).least(normal);
        if (course.isTurn()) {
            Num along = Num.of(course.along(i, n, from, to));
            return known.turnsBelow(mine, normal, Num.of(from), Num.of(to), bound, isWeak, along);
        }
        Num gap = bound.minus(known.top(mine, normal, Num.of(from), Num.of(to)));
        return margin > 0
                ? gap.sign() > 0
                        && gap.square().compareTo(Num.of(margin).square().times(normal.dot(normal))) >= 0
                : gap.sign() > 0 || (isWeak && gap.sign() == 0);
    }
}
