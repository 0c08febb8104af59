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

    private static final int DEPTH = 20;

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
        if (!isSure && best.gap > margin - 1e4 * error) {
            for (double[] n : across(i, j, from, to)) {
                isSure = !isSure && gap(i, j, n, from, to) > margin - error && isExact(i, j, n, from, to, isWeak)
                        || isSure;
                if (isSure) {
                    best.n = n;
                    break;
                }
            }
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
        if (course.cosine > 0) {
            return false;
        }
        return kernel(i, j, from, from, to, error, best)
                || to > from
                        && (kernel(i, j, to, from, to, error, best)
                                || kernel(i, j, (from + to) / 2, from, to, error, best));
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

    private boolean isOverlap(int i, int j, double moment) {
        Rows.leaf(course.at(i, moment), a);
        Rows.leaf(scene.rows[j], b);
        return (isFlat ? gjk.planar(a, b) : gjk.spatial(a, b)) == 0 && gjk.upper() <= gjk.error();
    }

    /** Normals of faces, and directions across two edges, or an edge and the way. */
    private List<double[]> across(int i, int j, double from, double to) {
        List<double[]> mine = edges(course.at(i, (from + to) / 2));
        List<double[]> theirs = edges(scene.rows[j]);
        if (course.cosine == 0 && to > from && !course.isTurn()) {
            mine.add(course.way);
        }
        if (isFlat) {
            mine.add(new double[] {0, 1, 0});
        }
        List<double[]> all = new ArrayList<>();
        mine.addAll(theirs);
        for (int k = 0; k < mine.size(); k++) {
            add(mine.get(k), all);
            for (int m = k + 1; m < mine.size(); m++) {
                add(Rows.cross(mine.get(k), mine.get(m)), all);
            }
        }
        return all;
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
                : gap.sign() > 0 || isWeak && gap.sign() == 0;
    }
}
