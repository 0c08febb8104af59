package robosim.geometry.proof;

import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.model.Point;
import robosim.geometry.narrow.gjk.Gjk;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.proof.Proof.Flaw;
import robosim.geometry.proof.Witness.Anchor;
import robosim.geometry.proof.Witness.Contact;
import robosim.geometry.proof.Witness.Form;

/** Looks for two points, one of each piece, that are as near as claimed. */
final class NearSearch {
    /** Keeps a rounded point inside a round piece. */
    private static final double INWARD = 1 - 0x1p-50;

    private final Gjk gjk = new Gjk();
    private final Leaf a = new Leaf();
    private final Leaf b = new Leaf();
    private final SceneRows scene;
    private final boolean isFlat;
    private final Runnable betweenParts;

    NearSearch(SceneRows scene, boolean isFlat, Runnable betweenParts) {
        this.scene = scene;
        this.isFlat = isFlat;
        this.betweenParts = betweenParts;
    }

    @Nullable
    Contact find(double[][] body, int self, int other, double high) {
        for (int object = 0; object < scene.objects.size(); object++) {
            for (int j = scene.first[object];
                    (other == Claim.ALL ? object != self : object == other) && j < scene.first[object + 1];
                    j++) {
                for (int i = 0; i < body.length; i++) {
                    betweenParts.run();
                    Contact near = find(i, body[i], j, scene.rows[j], high);
                    if (near != null) {
                        return near;
                    }
                }
            }
        }
        return null;
    }

    private @Nullable Contact find(int i, double[] mine, int j, double[] theirs, double high) {
        Rows.leaf(mine, a);
        Rows.leaf(theirs, b);
        if ((isFlat ? gjk.planar(a, b) : gjk.spatial(a, b)) > high) {
            return null;
        }
        if (!gjk.isClosed()) {
            gjk.close();
        }
        double[] p = {gjk.ax(), isFlat ? mine[1] : gjk.ay(), gjk.az()};
        double[] q = {gjk.bx(), isFlat ? theirs[1] : gjk.by(), gjk.bz()};
        Contact near =
                new Contact(i, j, Form.NEAR, List.of(), new Point(), List.of(anchor(mine, p), anchor(theirs, q)));
        return isWithin(new Piece(mine), new Piece(theirs), near, high) ? near : null;
    }

    private boolean isWithin(Piece mine, Piece theirs, Contact near, double high) {
        try {
            Vec gap = Meeting.anchor(theirs, near.anchors().get(1))
                    .minus(Meeting.anchor(mine, near.anchors().get(0)));
            gap = isFlat ? gap.level() : gap;
            return gap.dot(gap).compareTo(Num.of(high).square()) <= 0;
        } catch (Flaw notInside) {
            return false;
        }
    }

    /** A point in a piece's own coordinates, brought inside. */
    static Anchor anchor(double[] row, double[] x) {
        if (Rows.isTriangle(row)) {
            return inTriangle(row, x);
        }
        double[] from = {x[0] - row[0], x[1] - row[1], x[2] - row[2]};
        double[] at = new double[3];
        for (int k = 0; k < 3; k++) {
            double half = row[12 + k];
            at[k] = half == 0 ? 0 : Math.max(-1, Math.min(1, Rows.alongAxis(row, k, from) / half));
            for (int axis = 0; axis < 3; axis++) {
                from[axis] -= at[k] * half * row[3 + 3 * axis + k];
            }
        }
        if (row[15] > 0) {
            double[] up = {row[4], row[7], row[10]};
            double along = Rows.product(up, from);
            for (int axis = 0; axis < 3; axis++) {
                from[axis] -= along * up[axis];
            }
        }
        double radius = row[15] + row[16];
        double length = Rows.length(from);
        double scale = radius == 0 ? 0 : length > radius * INWARD ? radius / length * INWARD : 1;
        boolean isDisc = row[15] > 0;
        return new Anchor(
                new Point(at[0], isDisc ? at[1] * INWARD : at[1], at[2]),
                new Point(scale * from[0], scale * from[1], scale * from[2]));
    }

    private static Anchor inTriangle(double[] row, double[] x) {
        double[] u = {row[3] - row[0], row[4] - row[1], row[5] - row[2]};
        double[] v = {row[6] - row[0], row[7] - row[1], row[8] - row[2]};
        double[] from = {x[0] - row[0], x[1] - row[1], x[2] - row[2]};
        double uu = Rows.product(u, u);
        double uv = Rows.product(u, v);
        double vv = Rows.product(v, v);
        double determinant = uu * vv - uv * uv;
        double fu = Rows.product(from, u);
        double fv = Rows.product(from, v);
        double s = determinant > 0 ? (fu * vv - fv * uv) / determinant : uu > 0 ? fu / uu : 0;
        double t = determinant > 0 ? (fv * uu - fu * uv) / determinant : uu > 0 ? 0 : vv > 0 ? fv / vv : 0;
        s = Math.max(0, Math.min(1, s));
        t = Math.max(0, Math.min(1 - s, t));
        return new Anchor(new Point(s, s + t > 1 ? 0 : t, 0), new Point());
    }
}
