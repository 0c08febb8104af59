package robosim.geometry.reference;

import static robosim.geometry.reference.Vectors.abs;
import static robosim.geometry.reference.Vectors.cross;
import static robosim.geometry.reference.Vectors.dot;
import static robosim.geometry.reference.Vectors.minus;
import static robosim.geometry.reference.Vectors.negate;
import static robosim.geometry.reference.Vectors.plus;
import static robosim.geometry.reference.Vectors.times;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.reference.Quantity.Arithmetic;

/**
 * A convex polytope, flat or not: its corners, its edges, and the slabs whose common part it is. In the plane all heights
 * are 0.
 *
 * <p>Two of them meet where an edge of one meets the other, because the common part has a corner and every corner of it
 * is on an edge of one of the two: no separating axes are needed, and no case for what is coplanar or degenerate.
 */
final class Hull {
    /** The points x with {@code low <= normal . x <= high}; unbounded where there is no high. */
    record Slab(Quantity[] normal, Quantity low, @Nullable Quantity high) {}

    /** A side: the parallelogram of two edges from a corner, or half of it. */
    record Side(Quantity[] corner, Quantity[] first, Quantity[] second, boolean whole) {}

    final List<Quantity[]> corners = new ArrayList<>(8);
    final List<int[]> edges = new ArrayList<>(12);

    /** From the first end of each edge to the second. */
    final List<Quantity[]> directions = new ArrayList<>(12);

    final List<Slab> slabs = new ArrayList<>(4);
    final List<Side> sides = new ArrayList<>(6);

    private Hull() {}

    /** A box given by centre, half sizes and a row-major rotation, as stored. */
    static Hull box(Arithmetic n, double[] row) {
        Hull hull = new Hull();
        Quantity[] centre = Vectors.of(n, row[0], row[1], row[2]);
        Quantity[][] axes = axes(n, row);
        Quantity[][] arms = arms(n, row, axes);
        hull.cube(centre, arms);
        for (int k = 0; k < 3; k++) {
            Quantity[] normal = cross(axes[(k + 1) % 3], axes[(k + 2) % 3]);
            Quantity reach = abs(dot(normal, axes[k])).times(n.of(row[3 + k]));
            Quantity middle = dot(normal, centre);
            hull.slabs.add(new Slab(normal, middle.minus(reach), middle.plus(reach)));
            Quantity[] first = plus(arms[(k + 1) % 3], arms[(k + 1) % 3]);
            Quantity[] second = plus(arms[(k + 2) % 3], arms[(k + 2) % 3]);
            hull.sides.add(new Side(hull.corners.get(0), first, second, true));
            hull.sides.add(new Side(hull.corners.get(1 << k), first, second, true));
        }
        return hull;
    }

    /** What a box throws on the plane. */
    static Hull shadow(Arithmetic n, double[] row) {
        Hull hull = new Hull();
        Quantity[] centre = Vectors.of(n, row[0], 0, row[2]);
        Quantity[][] axes = axes(n, row);
        for (Quantity[] axis : axes) {
            axis[1] = n.of(0);
        }
        Quantity[][] arms = arms(n, row, axes);
        if (row[7] == 0 && row[13] == 0) {
            hull.square(centre, arms[0], arms[2]);
        } else {
            hull.cube(centre, arms);
        }
        for (int k = 0; k < 3; k++) {
            Quantity[] normal = aside(n, axes[k]);
            Quantity reach = n.of(0);
            for (int j = 0; j < 3; j++) {
                if (j != k) {
                    reach = reach.plus(abs(dot(normal, axes[j])).times(n.of(row[3 + j])));
                }
            }
            Quantity middle = dot(normal, centre);
            hull.slabs.add(new Slab(normal, middle.minus(reach), middle.plus(reach)));
        }
        return hull;
    }

    /** A triangle in space, or the segment or point that it is. */
    static Hull triangle(Arithmetic n, double[] row) {
        Hull hull = ring(n, row, false);
        Quantity[] normal = cross(hull.edge(0), hull.edge(1));
        if (Vectors.isZero(normal)) {
            hull.thin(n, true);
            return hull;
        }
        Quantity height = dot(normal, hull.corners.get(0));
        hull.slabs.add(new Slab(normal, height, height));
        for (int k = 0; k < 3; k++) {
            Quantity[] inwards = cross(normal, hull.edge(k));
            hull.slabs.add(new Slab(inwards, dot(inwards, hull.corners.get(k)), null));
        }
        Quantity[] back = times(hull.edge(2), n.of(-1));
        hull.sides.add(new Side(hull.corners.get(0), hull.edge(0), back, false));
        return hull;
    }

    /** What a triangle throws on the plane. */
    static Hull flatTriangle(Arithmetic n, double[] row) {
        Hull hull = ring(n, row, true);
        Quantity area = dot(aside(n, hull.edge(0)), hull.edge(1));
        if (area.signum() == 0) {
            hull.thin(n, false);
            return hull;
        }
        for (int k = 0; k < 3; k++) {
            Quantity[] inwards = aside(n, hull.edge(k));
            if (area.signum() < 0) {
                inwards = times(inwards, n.of(-1));
            }
            hull.slabs.add(new Slab(inwards, dot(inwards, hull.corners.get(k)), null));
        }
        return hull;
    }

    /** The same so many times larger, a number above 0; without its sides. */
    Hull enlarged(Quantity factor) {
        Hull hull = new Hull();
        corners.forEach(corner -> hull.corners.add(Vectors.times(corner, factor)));
        hull.edges.addAll(edges);
        directions.forEach(direction -> hull.directions.add(Vectors.times(direction, factor)));
        for (Slab slab : slabs) {
            Quantity high = slab.high == null ? null : slab.high.times(factor);
            hull.slabs.add(new Slab(slab.normal, slab.low.times(factor), high));
        }
        return hull;
    }

    private static Hull ring(Arithmetic n, double[] row, boolean flat) {
        Hull hull = new Hull();
        for (int k = 0; k < 9; k += 3) {
            hull.corners.add(Vectors.of(n, row[k], flat ? 0 : row[k + 1], row[k + 2]));
        }
        hull.edges.add(new int[] {0, 1});
        hull.edges.add(new int[] {1, 2});
        hull.edges.add(new int[] {2, 0});
        for (int[] edge : hull.edges) {
            hull.directions.add(minus(hull.corners.get(edge[1]), hull.corners.get(edge[0])));
        }
        return hull;
    }

    /** The slabs of a segment or point: its line by three planes, of which two would do, and its length. */
    private void thin(Arithmetic n, boolean inSpace) {
        Quantity[][] units = {Vectors.of(n, 1, 0, 0), Vectors.of(n, 0, 1, 0), Vectors.of(n, 0, 0, 1)};
        for (int k = 0; k < 3; k++) {
            Quantity[] along = edge(k);
            if (!Vectors.isZero(along)) {
                if (inSpace) {
                    for (Quantity[] unit : units) {
                        spanned(cross(along, unit));
                    }
                } else {
                    spanned(aside(n, along));
                }
                spanned(along);
                return;
            }
        }
        for (Quantity[] unit : units) {
            spanned(unit);
        }
    }

    private void spanned(Quantity[] normal) {
        Quantity low = dot(normal, corners.get(0));
        Quantity high = low;
        for (Quantity[] corner : corners) {
            Quantity value = dot(normal, corner);
            low = Vectors.atMost(low, value) ? low : value;
            high = Vectors.atMost(value, high) ? high : value;
        }
        slabs.add(new Slab(normal, low, high));
    }

    private void cube(Quantity[] centre, Quantity[][] arms) {
        for (int corner = 0; corner < 8; corner++) {
            Quantity[] at = centre;
            for (int k = 0; k < 3; k++) {
                at = (corner >> k & 1) == 0 ? minus(at, arms[k]) : plus(at, arms[k]);
            }
            corners.add(at);
            for (int k = 0; k < 3; k++) {
                if ((corner >> k & 1) != 0) {
                    edges.add(new int[] {corner - (1 << k), corner});
                    directions.add(plus(arms[k], arms[k]));
                }
            }
        }
    }

    private void square(Quantity[] centre, Quantity[] x, Quantity[] z) {
        corners.add(minus(minus(centre, x), z));
        corners.add(minus(plus(centre, x), z));
        corners.add(plus(plus(centre, x), z));
        corners.add(plus(minus(centre, x), z));
        for (int k = 0; k < 4; k++) {
            edges.add(new int[] {k, (k + 1) % 4});
        }
        Quantity[] alongX = plus(x, x);
        Quantity[] alongZ = plus(z, z);
        directions.addAll(List.of(alongX, alongZ, negate(alongX), negate(alongZ)));
    }

    private static Quantity[][] axes(Arithmetic n, double[] row) {
        return new Quantity[][] {
            Vectors.of(n, row[6], row[9], row[12]),
            Vectors.of(n, row[7], row[10], row[13]),
            Vectors.of(n, row[8], row[11], row[14])
        };
    }

    private static Quantity[][] arms(Arithmetic n, double[] row, Quantity[][] axes) {
        return new Quantity[][] {
            times(axes[0], n.of(row[3])), times(axes[1], n.of(row[4])), times(axes[2], n.of(row[5]))
        };
    }

    /** A quarter turn in the plane. */
    private static Quantity[] aside(Arithmetic n, Quantity[] a) {
        return new Quantity[] {a[2].negate(), n.of(0), a[0]};
    }

    /** The direction of an edge. */
    Quantity[] edge(int k) {
        return directions.get(k);
    }

    boolean meets(Hull that) {
        Clip mine = new Clip(corners, that.slabs);
        if (mine.isBeyond()) {
            return false;
        }
        Clip theirs = new Clip(that.corners, slabs);
        if (theirs.isBeyond()) {
            return false;
        }
        return mine.anyMeets(edges) || theirs.anyMeets(that.edges);
    }

    boolean holds(Quantity[] point) {
        return !new Clip(List.<Quantity[]>of(point), slabs).isBeyond();
    }

    /** Whether the segment between two points meets it. */
    boolean meetsSegment(Quantity[] from, Quantity[] to) {
        return new Clip(List.of(from, to), slabs).segmentMeets(0, 1);
    }

    /** Whether a point is in it or no farther from it than a radius. */
    boolean isWithin(Quantity[] point, Quantity radius) {
        if (holds(point)) {
            return true;
        }
        Quantity most = radius.times(radius);
        for (Side side : sides) {
            if (isNear(minus(point, side.corner), side, most)) {
                return true;
            }
        }
        for (int k = 0; k < edges.size(); k++) {
            Quantity[] from = corners.get(edges.get(k)[0]);
            if (isNearSegment(minus(point, from), edge(k), most)) {
                return true;
            }
        }
        return false;
    }

    /** By the foot of the point on the plane, where that is in the side. */
    private static boolean isNear(Quantity[] w, Side side, Quantity most) {
        Quantity[] normal = cross(side.first, side.second);
        if (Vectors.isZero(normal)) {
            return false;
        }
        Quantity height = dot(w, normal);
        if (!Vectors.atMost(height.times(height), most.times(dot(normal, normal)))) {
            return false;
        }
        Quantity whole = dot(normal, normal);
        Quantity share = dot(cross(w, side.second), normal);
        Quantity otherShare = dot(cross(side.first, w), normal);
        if (share.signum() < 0 || otherShare.signum() < 0) {
            return false;
        }
        return side.whole
                ? Vectors.atMost(share, whole) && Vectors.atMost(otherShare, whole)
                : Vectors.atMost(share.plus(otherShare), whole);
    }

    /** Whether the point at w from the start of a segment e is within the root of {@code most} of it. */
    static boolean isNearSegment(Quantity[] w, Quantity[] e, Quantity most) {
        Quantity along = dot(w, e);
        if (along.signum() <= 0) {
            return Vectors.atMost(dot(w, w), most);
        }
        Quantity length = dot(e, e);
        if (along.minus(length).signum() >= 0) {
            Quantity[] rest = minus(w, e);
            return Vectors.atMost(dot(rest, rest), most);
        }
        return Vectors.atMost(dot(w, w).minus(most).times(length), along.times(along));
    }
}
