package robosim.geometry.proof;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.index.meshes.TriangleMesh;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;

/**
 * A convex piece of an object as the doubles that are stored: a triangle of nine, or a box that is widened by a disc about its own Y
 * or by a ball, of seventeen: centre, rotation (row-major), half sizes, radius of the disc, radius of the ball.
 */
final class Piece {
    final double[] stored;
    final boolean isTriangle;

    /** Where it is, or the first corner. */
    final Vec c;

    /** The own axes, or the three corners. */
    final Vec[] r = new Vec[3];

    final Num[] h = new Num[3];
    final Num disc;
    final Num ball;

    Piece(double... stored) {
        this.stored = stored;
        isTriangle = stored.length == 9;
        c = Vec.of(stored[0], stored[1], stored[2]);
        for (int k = 0; k < 3; k++) {
            r[k] = isTriangle
                    ? Vec.of(stored[3 * k], stored[3 * k + 1], stored[3 * k + 2])
                    : Vec.of(stored[3 + k], stored[6 + k], stored[9 + k]);
            h[k] = isTriangle ? Num.ZERO : Num.of(stored[12 + k]);
        }
        disc = isTriangle ? Num.ZERO : Num.of(stored[15]);
        ball = isTriangle ? Num.ZERO : Num.of(stored[16]);
    }

    /** A single point. */
    static Piece point(Point at) {
        return new Piece(at.x(), at.y(), at.z(), 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0);
    }

    /** The pieces of an object where it stands: members of groups in order, triangles in the order of faces, cells by rows. */
    static List<Piece> of(GeometryObject object) {
        return stored(object).stream().map(Piece::new).toList();
    }

    /** The same as numbers. */
    static List<double[]> stored(GeometryObject object) {
        List<double[]> pieces = new ArrayList<>(1);
        if (object instanceof ObjectGroup group) {
            for (GeometryObject part : group.parts()) {
                add(part, part.pose().within(group.pose()), pieces);
            }
        } else if (object instanceof GridObject grid) {
            for (int row = 0; row < grid.rows(); row++) {
                for (int column = 0; column < grid.columns(); column++) {
                    if (grid.isOccupied(column, row)) {
                        BoxObject cell = grid.box(column, row);
                        add(cell, cell.pose(), pieces);
                    }
                }
            }
        } else {
            add(object, object.pose(), pieces);
        }
        return pieces;
    }

    private static void add(GeometryObject object, Pose pose, List<double[]> pieces) {
        double[] place = new double[17];
        place[0] = pose.center().x();
        place[1] = pose.center().y();
        place[2] = pose.center().z();
        if (object instanceof MeshObject mesh) {
            pose.rotation(place, 6);
            TriangleMesh triangles = mesh.triangles();
            for (int t = 0; t < triangles.size(); t++) {
                double[] corners = new double[9];
                for (int k = 0; k < 9; k++) {
                    corners[k] = triangles.placed(triangles.vertex(t, k / 3), k % 3, place, 0);
                }
                pieces.add(corners);
            }
            return;
        }
        GeometryObject.RoundedBox box = object.roundedBox();
        pose.rotation(place, 3);
        place[12] = box.halfWidth();
        place[13] = box.halfHeight();
        place[14] = box.halfLength();
        place[15] = box.disc();
        place[16] = box.ball();
        pieces.add(place);
    }

    boolean isSphere() {
        return !isTriangle && ball.sign() > 0 && h[0].sign() == 0 && h[1].sign() == 0 && h[2].sign() == 0;
    }

    /** The same as an upright prism about height 0, which is all that counts in the plane; null if it is a tipped box, cylinder or capsule. */
    @Nullable
    Piece flat() {
        double[] s = stored.clone();
        if (isTriangle) {
            s[1] = s[4] = s[7] = 0;
            return new Piece(s);
        }
        boolean isUpright = s[4] == 0 && Math.abs(s[7]) == 1 && s[10] == 0 && s[6] == 0 && s[8] == 0;
        if (!isUpright && !isSphere()) {
            return null;
        }
        if (!isUpright) {
            System.arraycopy(new double[] {1, 0, 0, 0, 1, 0, 0, 0, 1}, 0, s, 3, 9);
        }
        s[1] = 0;
        s[13] = 1;
        s[15] = s[15] + s[16]; // one of them is 0
        s[16] = 0;
        return new Piece(s);
    }

    /** The largest of n.x over the piece, or slightly more. */
    Num most(Vec n) {
        if (isTriangle) {
            Num a = n.dot(r[0]);
            Num b = n.dot(r[1]);
            Num d = n.dot(r[2]);
            a = a.compareTo(b) < 0 ? b : a;
            return a.compareTo(d) < 0 ? d : a;
        }
        return straight(n).plus(round(n, n.dot(r[1])));
    }

    /** The same without roundness, of what is no triangle. */
    private Num straight(Vec n) {
        Num most = n.dot(c);
        for (int k = 0; k < 3; k++) {
            most = h[k].sign() == 0 ? most : most.plus(h[k].times(n.dot(r[k]).abs()));
        }
        return most;
    }

    /** Not above {@link #least}, and found without a root, of an n that is an axis of the world. */
    Num leastAlongAxis(Vec n) {
        return isTriangle
                ? least(n)
                : straight(n.negate()).plus(disc).plus(ball).negate();
    }

    /** The smallest of n.x over the piece, or slightly less. */
    Num least(Vec n) {
        return most(n.negate()).negate();
    }

    /** What the disc and the ball add along n, where the disc's axis has at least this product with n, or slightly more. */
    Num round(Vec n, Num along) {
        if (disc.sign() > 0) {
            Num aa = r[1].dot(r[1]);
            Num square = n.dot(n).times(aa).minus(along.square());
            return disc.times((square.sign() < 0 ? Num.ZERO : square).overUp(aa).rootUp());
        }
        return ball.sign() > 0 ? ball.times(n.dot(n).rootUp()) : Num.ZERO;
    }

    /** Corners, or of what is round the ends of its axis, without the roundness; each edge is two of them. */
    List<Vec> corners() {
        if (isTriangle) {
            return List.of(r);
        }
        List<Vec> all = new ArrayList<>(List.of(c));
        for (int k = 0; k < 3; k++) {
            List<Vec> next = new ArrayList<>();
            for (Vec v : h[k].sign() == 0 ? List.<Vec>of() : all) {
                next.add(v.minus(r[k].times(h[k])));
                next.add(v.plus(r[k].times(h[k])));
            }
            all = next.isEmpty() ? all : next;
        }
        return all;
    }

    /** Whether the segment from p to q has a point in this piece, whose disc and ball are widened by some radius. Exact. */
    boolean meets(Vec p, Vec q, Num wider) {
        if (isTriangle) {
            Vec n = r[1].minus(r[0]).cross(r[2].minus(r[0]));
            if (n.isZero()) {
                return meetsEdge(p, q, 0) || meetsEdge(p, q, 1) || meetsEdge(p, q, 2);
            }
            Clip clip = new Clip(p, q);
            clip.below(n, n.dot(r[0]));
            clip.below(n.negate(), n.dot(r[0]).negate());
            for (int k = 0; k < 3; k++) {
                Vec outward = r[(k + 1) % 3].minus(r[k]).cross(n);
                clip.below(outward, outward.dot(r[k]));
            }
            return clip.isAny();
        }
        Num discRadius = disc.sign() > 0 ? disc.plus(wider) : Num.ZERO;
        Num ballRadius = disc.sign() > 0 || h[0].plus(h[2]).sign() > 0 ? ball : ball.plus(wider);
        return ballRadius.sign() > 0
                ? hitsBall(p, q, -1, ballRadius)
                        || hitsBall(p, q, 1, ballRadius)
                        || (h[1].sign() > 0 && hitsTube(p, q, ballRadius))
                : discRadius.sign() > 0 ? hitsTube(p, q, discRadius) : hitsBox(p, q);
    }

    /** Whether a ball beyond a face reaches it, straight above it: the plane of a triangle, a side of a box (0 to 2) or a cap. Exact. */
    boolean isNearFace(Vec x, Num radius, int face) {
        if (isTriangle) {
            Vec n = r[1].minus(r[0]).cross(r[2].minus(r[0]));
            boolean isAbove = !n.isZero();
            for (int k = 0; k < 3; k++) {
                isAbove &=
                        r[(k + 1) % 3].minus(r[k]).cross(n).dot(x.minus(r[k])).sign() <= 0;
            }
            return isAbove
                    && n.dot(x.minus(r[0])).square().compareTo(radius.square().times(n.dot(n))) <= 0;
        }
        Vec from = x.minus(c);
        if (ball.sign() > 0 || disc.sign() > 0) {
            Num aa = r[1].dot(r[1]);
            Num level = r[1].dot(from).abs().minus(h[1].times(aa));
            Vec aside = from.cross(r[1]);
            return disc.sign() > 0
                    && level.sign() >= 0
                    && level.square().compareTo(radius.square().times(aa)) <= 0
                    && aside.dot(aside).compareTo(disc.square().times(aa)) <= 0;
        }
        Vec n = r[(face + 1) % 3].cross(r[(face + 2) % 3]);
        Num nn = n.dot(n);
        Num high = n.dot(from);
        Num level = high.abs().minus(h[face].times(n.dot(r[face])));
        boolean isAbove =
                level.sign() >= 0 && level.square().compareTo(radius.square().times(nn)) <= 0;
        for (int k = face + 1; k < face + 3; k++) {
            Vec m = r[(k + 1) % 3].cross(r[(k + 2) % 3]);
            Num foot = m.dot(from).times(nn).minus((high.sign() < 0 ? level.negate() : level).times(m.dot(n)));
            isAbove &= foot.abs().compareTo(h[k % 3].times(m.dot(r[k % 3])).times(nn)) <= 0;
        }
        return isAbove;
    }

    /** Whether the segment from p to q has a point on an edge of this triangle. */
    private boolean meetsEdge(Vec p, Vec q, int from) {
        Vec a = r[from];
        Vec b = r[(from + 1) % 3];
        Vec along = b.minus(a);
        Clip clip = new Clip(p, q);
        clip.below(along, along.dot(b));
        clip.below(along.negate(), along.dot(a).negate());
        return clip.isNear(a, along, Num.ZERO);
    }

    private boolean hitsBall(Vec p, Vec q, int end, Num radius) {
        Vec middle = end < 0 ? c.minus(r[1].times(h[1])) : c.plus(r[1].times(h[1]));
        return new Clip(p, q).isNear(middle, Vec.ZERO, radius);
    }

    private boolean hitsTube(Vec p, Vec q, Num radius) {
        Clip clip = new Clip(p, q);
        clip.within(r[1], r[1].dot(c), h[1].times(r[1].dot(r[1])));
        return clip.isNear(c, r[1], radius);
    }

    private boolean hitsBox(Vec p, Vec q) {
        Clip clip = new Clip(p, q);
        for (int k = 0; k < 3; k++) {
            Vec n = r[(k + 1) % 3].cross(r[(k + 2) % 3]);
            clip.within(n, n.dot(c), h[k].times(n.dot(r[k])));
        }
        return clip.isAny();
    }

    /** The part of a segment p + s (q - p), s from 0 to 1, that is left: from low to high over positive numbers. */
    private static final class Clip {
        private final Vec p;
        private final Vec way;
        private Num low = Num.ZERO;
        private Num overLow = Num.ONE;
        private Num high = Num.ONE;
        private Num overHigh = Num.ONE;
        private boolean isEmpty;

        Clip(Vec p, Vec q) {
            this.p = p;
            way = q.minus(p);
        }

        void within(Vec n, Num middle, Num half) {
            below(n, middle.plus(half));
            below(n.negate(), half.minus(middle));
        }

        /** Leaves what has n.x at most the bound. */
        void below(Vec n, Num bound) {
            Num room = bound.minus(n.dot(p));
            Num rate = n.dot(way);
            if (rate.sign() == 0) {
                isEmpty |= room.sign() < 0;
            } else if (rate.sign() > 0 && room.times(overHigh).compareTo(high.times(rate)) < 0) {
                high = room;
                overHigh = rate;
            } else if (rate.sign() < 0 && room.negate().times(overLow).compareTo(low.times(rate.negate())) > 0) {
                low = room.negate();
                overLow = rate.negate();
            }
        }

        boolean isAny() {
            return !isEmpty && low.times(overHigh).compareTo(high.times(overLow)) <= 0;
        }

        /** Whether a point that is left is within a radius of the line through a point along an axis, or of the point if the axis is 0. */
        boolean isNear(Vec point, Vec axis, Num radius) {
            Vec from = p.minus(point);
            Vec u = axis.isZero() ? from : from.cross(axis);
            Vec v = axis.isZero() ? way : way.cross(axis);
            Num square = axis.isZero() ? radius.square() : radius.square().times(axis.dot(axis));
            Num a = v.dot(v);
            Num b = u.dot(v);
            Num f = u.dot(u).minus(square);
            if (!isAny()) {
                return false;
            }
            boolean isBetween = low.times(a).compareTo(b.negate().times(overLow)) < 0
                    && high.times(a).compareTo(b.negate().times(overHigh)) > 0;
            return isNegative(a, b, f, low, overLow)
                    || isNegative(a, b, f, high, overHigh)
                    || (isBetween && a.times(f).compareTo(b.square()) <= 0);
        }

        private static boolean isNegative(Num a, Num b, Num f, Num s, Num over) {
            return a.times(s.square())
                            .plus(b.times(s).times(over).twice())
                            .plus(f.times(over.square()))
                            .sign()
                    <= 0;
        }
    }
}
