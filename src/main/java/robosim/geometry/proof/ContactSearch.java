package robosim.geometry.proof;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.model.Point;
import robosim.geometry.narrow.gjk.Gjk;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.proof.Proof.Flaw;
import robosim.geometry.proof.Witness.Anchor;
import robosim.geometry.proof.Witness.Contact;
import robosim.geometry.proof.Witness.Form;

/** Looks for what shows that two pieces touch: the checker's own test decides which candidate does. */
final class ContactSearch {
    /** What is farther apart than this fraction of sizes and places is not worth an exact test. */
    private static final double FAR = 1e-9;

    private static final int PROJECTIONS = 80;

    /** Half the length of a segment through a triangle, of sizes and places. */
    private static final double CHORD = 1e-13;

    private final Gjk gjk = new Gjk();
    private final Leaf a = new Leaf();
    private final Leaf b = new Leaf();

    /** A witness that a piece of the body, moved by {@code at} times a way, touches a piece of the scene; null if none is found. */
    @Nullable
    Contact find(int i, Piece mine, int j, Piece theirs, Point way, double at, boolean isFlat) {
        Piece first = isFlat ? mine.flat() : mine;
        Piece second = isFlat ? theirs.flat() : theirs;
        if (first == null || second == null) {
            return null;
        }
        Vec shift = Vec.of(way).times(Num.of(at));
        Vec by = isFlat ? shift.level() : shift;
        double[] d = {at * way.x(), isFlat ? 0 : at * way.y(), at * way.z()};
        double[] moved = moved(first.stored, d);
        if (gap(moved, second.stored) > 0) {
            return null;
        }
        for (Contact candidate : candidates(i, moved, j, second.stored, d)) {
            if (holds(first, second, candidate, by, isFlat)) {
                return candidate;
            }
        }
        return null;
    }

    private static boolean holds(Piece a, Piece b, Contact candidate, Vec by, boolean isFlat) {
        try {
            return Meeting.holds(a, b, candidate, by, isFlat);
        } catch (Flaw notInside) {
            return false;
        }
    }

    static double[] moved(double[] row, double[] d) {
        double[] moved = row.clone();
        for (int k = 0; k < (Rows.isTriangle(row) ? 9 : 3); k++) {
            moved[k] += d[k % 3];
        }
        return moved;
    }

    private double gap(double[] mine, double[] theirs) {
        Rows.leaf(mine, a);
        Rows.leaf(theirs, b);
        return gjk.spatial(a, b);
    }

    private List<Contact> candidates(int i, double[] mine, int j, double[] theirs, double[] d) {
        List<Contact> all = new ArrayList<>();
        point(i, j, (gjk.ax() + gjk.bx()) / 2, (gjk.ay() + gjk.by()) / 2, (gjk.az() + gjk.bz()) / 2, all);
        double[] common = {(gjk.ax() + gjk.bx()) / 2, (gjk.ay() + gjk.by()) / 2, (gjk.az() + gjk.bz()) / 2};
        if (Rows.isTriangle(mine) || Rows.isTriangle(theirs)) {
            all.clear(); // a rounded point is hardly ever in a triangle
        }
        edges(i, mine, j, theirs, Form.MINE, all);
        edges(i, theirs, j, mine, Form.THEIRS, all);
        balls(i, mine, j, Form.MY_BALL, all);
        balls(i, theirs, j, Form.THEIR_BALL, all);
        point(i, j, mine[0], mine[1], mine[2], all);
        point(i, j, theirs[0], theirs[1], theirs[2], all);
        if ((mine.length == 17 && mine[15] > 0) || (theirs.length == 17 && theirs[15] > 0)) {
            inner(mine, theirs, common);
            point(i, j, common[0], common[1], common[2], all);
            for (List<Anchor> ends : chord(mine, theirs, common, d)) {
                all.add(new Contact(i, j, Form.MY_CHORD, List.of(), new Point(), ends));
            }
            for (List<Anchor> ends : chord(theirs, mine, common, new double[3])) {
                all.add(new Contact(i, j, Form.THEIR_CHORD, List.of(), new Point(), ends));
            }
        }
        return all;
    }

    private static void point(int i, int j, double x, double y, double z, List<Contact> all) {
        all.add(new Contact(i, j, Form.POINT, List.of(), new Point(x, y, z), List.of()));
    }

    /** The ends of a segment of a piece through the plane of the other, if that is a triangle or a disc; else nothing. */
    private static List<List<Anchor>> chord(double[] of, double[] other, double[] x, double[] moved) {
        boolean isDisc = !Rows.isTriangle(other) && other[15] > 0 && other[13] == 0;
        if ((!Rows.isTriangle(other) && !isDisc) || Rows.isTriangle(of)) {
            return List.of();
        }
        double[] n = isDisc ? new double[] {other[4], other[7], other[10]} : normal(other);
        double size = CHORD * (Rows.size(of) + Rows.size(other));
        double[] unmoved = moved(of, new double[] {-moved[0], -moved[1], -moved[2]});
        double[][] ends = new double[2][3];
        for (int k = 0; k < 3; k++) {
            ends[0][k] = x[k] - moved[k] - size * n[k];
            ends[1][k] = x[k] - moved[k] + size * n[k];
        }
        return List.of(List.of(NearSearch.anchor(unmoved, ends[0]), NearSearch.anchor(unmoved, ends[1])));
    }

    private static double[] normal(double[] row) {
        double[] u = {row[3] - row[0], row[4] - row[1], row[5] - row[2]};
        double[] v = {row[6] - row[0], row[7] - row[1], row[8] - row[2]};
        return Rows.unit(Rows.cross(u, v));
    }

    private void edges(int i, double[] of, int j, double[] other, Form form, List<Contact> all) {
        double[][] corners = Rows.corners(of);
        for (int k = 0; k < corners.length; k++) {
            for (int m = corners.length == 1 ? k : k + 1; m < corners.length; m++) {
                boolean isEdge = Rows.isTriangle(of) || corners.length == 1 || Integer.bitCount(k ^ m) == 1;
                if (isEdge && (corners.length < 3 || isNear(corners[k], corners[m], other))) {
                    all.add(new Contact(i, j, form, List.of(k, m), new Point(), List.of()));
                }
            }
        }
    }

    /** Whether an edge may touch a piece. */
    private boolean isNear(double[] p, double[] q, double[] other) {
        double[] row = new double[17];
        double[] way = new double[3];
        for (int k = 0; k < 3; k++) {
            row[k] = p[k] / 2 + q[k] / 2;
            way[k] = q[k] / 2 - p[k] / 2;
        }
        row[13] = Rows.length(way);
        double[] up = Rows.unit(way);
        double[] side = Rows.unit(
                Math.abs(up[0]) < 0.7
                        ? Rows.cross(up, new double[] {1, 0, 0})
                        : Rows.cross(up, new double[] {0, 0, 1}));
        double[] third = Rows.cross(side, up);
        for (int k = 0; k < 3; k++) {
            row[3 + 3 * k] = side[k];
            row[4 + 3 * k] = up[k];
            row[5 + 3 * k] = third[k];
        }
        return row[13] == 0 || gap(row, other) <= FAR * (Rows.size(row) + Rows.size(other));
    }

    private static void balls(int i, double[] of, int j, Form form, List<Contact> all) {
        if (of.length == 17 && of[16] > 0) {
            for (int k = 0; k < (of[13] > 0 ? 2 : 1); k++) {
                for (int face = 0; face < 3; face++) {
                    all.add(new Contact(i, j, form, List.of(k, face), new Point(), List.of()));
                }
            }
        }
    }

    /** Goes to a point well inside both, if there is one, by projecting on one shrunk piece and the other in turn. */
    private static void inner(double[] mine, double[] theirs, double[] x) {
        for (int step = 0; step < PROJECTIONS; step++) {
            project(step % 2 == 0 ? mine : theirs, x);
        }
    }

    private static void project(double[] row, double[] x) {
        if (Rows.isTriangle(row)) {
            Point at = NearSearch.anchor(row, x).at();
            for (int k = 0; k < 3; k++) {
                x[k] = row[k] + at.x() * (row[3 + k] - row[k]) + at.y() * (row[6 + k] - row[k]);
            }
            return;
        }
        double shrunk = 1 - 0x1p-36;
        double[] from = {x[0] - row[0], x[1] - row[1], x[2] - row[2]};
        double[] own = new double[3];
        for (int k = 0; k < 3; k++) {
            own[k] = Rows.alongAxis(row, k, from);
            boolean isAcross = row[15] > 0 && k != 1;
            double half = row[12 + k] * shrunk;
            if (!isAcross && row[16] == 0) {
                own[k] = Math.max(-half, Math.min(half, own[k]));
            }
        }
        double radius = (row[15] + row[16]) * shrunk;
        double middle = row[16] > 0 ? Math.max(-row[13], Math.min(row[13], own[1])) : own[1];
        double length = Math.sqrt(own[0] * own[0] + own[2] * own[2] + (own[1] - middle) * (own[1] - middle));
        if (radius > 0 && length > radius) {
            own[0] *= radius / length;
            own[2] *= radius / length;
            own[1] = middle + (own[1] - middle) * (radius / length);
        }
        for (int axis = 0; axis < 3; axis++) {
            x[axis] = row[axis];
            for (int k = 0; k < 3; k++) {
                x[axis] += own[k] * row[3 + 3 * axis + k];
            }
        }
    }
}
