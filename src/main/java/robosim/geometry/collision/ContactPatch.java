package robosim.geometry.collision;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import robosim.geometry.model.Point;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;

/**
 * Where the faces of two convex pieces in contact lie on each other: the common part of both, seen along the contact's normal.
 * All in plain doubles. A face, an edge or a corner is what is foremost against the other piece, to within {@link #LEVEL}: the contact
 * points of physics engines (Gregorius 2015).
 */
final class ContactPatch {
    /** The most points of a patch. */
    static final int MOST = 4;

    /** A corner belongs to a face that it is this far behind for each unit of distance: 6 degrees. */
    private static final double LEVEL = 0.1;

    /** What is farther apart than this part of the patch's size is not one point. */
    private static final double NEAR = 0x1p-40;

    /** Corners of the polygon for a disc. */
    private static final int ROUND = 8;

    /** A point in the frame of the patch: along two directions across the normal, and along it. */
    private record Spot(double u, double v, double height) {}

    private final double[] n;
    private final double[] u;
    private final double[] v;

    ContactPatch(Point normal) {
        n = new double[] {normal.x(), normal.y(), normal.z()};
        int least = Math.abs(n[0]) <= Math.abs(n[1])
                ? (Math.abs(n[0]) <= Math.abs(n[2]) ? 0 : 2)
                : (Math.abs(n[1]) <= Math.abs(n[2]) ? 1 : 2);
        double[] axis = new double[3];
        axis[least] = 1;
        u = unit(cross(axis, n));
        v = cross(n, u);
    }

    /** The points of the patch, deepest first. */
    List<Contact.Spot> of(Leaf a, Leaf b) {
        List<Spot> under = face(a, -1);
        List<Spot> over = face(b, 1);
        List<Spot> common = under.size() < 3 ? clip(under, over) : clip(over, under);
        List<Contact.Spot> spots = new ArrayList<>();
        for (Spot each : common) {
            double low = height(under, each);
            double high = height(over, each);
            if (high >= low) {
                spots.add(new Contact.Spot(point(each.u, each.v, low / 2 + high / 2), high - low));
            }
        }
        return few(spots);
    }

    private Point point(double along, double across, double height) {
        return new Point(
                along * u[0] + across * v[0] + height * n[0],
                along * u[1] + across * v[1] + height * n[1],
                along * u[2] + across * v[2] + height * n[2]);
    }

    // The foremost corners of a piece.

    /** The foremost face, edge or corner along the normal, or against it for a sign of -1: in order around its middle. */
    private List<Spot> face(Leaf leaf, int sign) {
        List<Spot> found = new ArrayList<>();
        switch (leaf.kind) {
            case UPRIGHT_BOX, BOX -> box(leaf, towards(leaf, sign), found);
            case TRIANGLE -> triangle(leaf, sign, found);
            case UPRIGHT_CYLINDER, CYLINDER -> cylinder(leaf, towards(leaf, sign), found);
            case SPHERE, UPRIGHT_CAPSULE, CAPSULE -> capsule(leaf, sign, found);
            case PRISM, MESH, SOLID_MESH, GRID ->
                throw new IllegalArgumentException("leaf must be a convex piece (got: " + leaf.kind + ")");
        }
        List<Spot> corners = new ArrayList<>(new LinkedHashSet<>(found));
        double middleU = corners.stream().mapToDouble(Spot::u).average().orElseThrow();
        double middleV = corners.stream().mapToDouble(Spot::v).average().orElseThrow();
        corners.sort(Comparator.comparingDouble(each -> StrictMath.atan2(each.v - middleV, each.u - middleU)));
        return corners;
    }

    /** The direction to the other piece in the own frame of one. */
    private double[] towards(Leaf leaf, int sign) {
        double[] towards = new double[3];
        for (int axis = 0; axis < 3; axis++) {
            for (int k = 0; k < 3; k++) {
                towards[axis] += sign * rotation(leaf, k, axis) * n[k];
            }
        }
        return towards;
    }

    /** Whether one of two ends is foremost; both are if the other piece is beside them. */
    private static boolean isForemost(double towards, boolean isEnd) {
        return Math.abs(towards) <= LEVEL || (towards > 0) == isEnd;
    }

    private void box(Leaf leaf, double[] towards, List<Spot> corners) {
        for (int corner = 0; corner < 8; corner++) {
            boolean isForemost = true;
            double[] at = new double[3];
            for (int axis = 0; axis < 3; axis++) {
                boolean isEnd = (corner >> axis & 1) == 1;
                isForemost &= isForemost(towards[axis], isEnd);
                at[axis] = isEnd ? leaf.get(Leaf.SIZE + axis) : -leaf.get(Leaf.SIZE + axis);
            }
            if (isForemost) {
                add(leaf, corners, at[0], at[1], at[2]);
            }
        }
    }

    private void triangle(Leaf leaf, int sign, List<Spot> corners) {
        for (int k = 0; k < 9; k += 3) {
            corners.add(spot(leaf.get(k), leaf.get(k + 1), leaf.get(k + 2)));
        }
        Spot first = corners.stream()
                .max(Comparator.comparingDouble(each -> sign * each.height))
                .orElseThrow();
        corners.removeIf(each -> sign * (first.height - each.height) > LEVEL * distance(first, each));
    }

    /** The ends of a sphere's or capsule's segment, as far as the ball around them reaches. */
    private void capsule(Leaf leaf, int sign, List<Spot> corners) {
        double along = towards(leaf, sign)[1];
        double half = leaf.kind == LeafKind.SPHERE ? 0 : leaf.get(Leaf.SIZE + 1);
        for (int end = -1; end <= 1; end += 2) {
            if (isForemost(along, end > 0)) {
                add(leaf, corners, 0, end * half, 0);
            }
        }
        double reach = sign * leaf.get(Leaf.SIZE);
        corners.replaceAll(each -> new Spot(each.u, each.v, each.height + reach));
    }

    private void cylinder(Leaf leaf, double[] towards, List<Spot> corners) {
        double radius = leaf.get(Leaf.SIZE);
        double across = StrictMath.hypot(towards[0], towards[2]);
        double turn = across == 0 ? 0 : StrictMath.atan2(towards[2], towards[0]);
        int rim = across <= LEVEL ? ROUND : 1;
        for (int end = -1; end <= 1; end += 2) {
            for (int k = 0; k < rim && isForemost(towards[1], end > 0); k++) {
                double at = turn + 2 * Math.PI * k / rim;
                add(
                        leaf,
                        corners,
                        radius * StrictMath.cos(at),
                        end * leaf.get(Leaf.SIZE + 1),
                        radius * StrictMath.sin(at));
            }
        }
    }

    private static double rotation(Leaf leaf, int row, int column) {
        return switch (leaf.kind) {
            case BOX, UPRIGHT_BOX, CYLINDER, CAPSULE -> leaf.get(Leaf.ROTATION + 3 * row + column);
            case UPRIGHT_CYLINDER, SPHERE, TRIANGLE, PRISM, UPRIGHT_CAPSULE, MESH, SOLID_MESH, GRID ->
                row == column ? 1 : 0;
        };
    }

    private void add(Leaf leaf, List<Spot> corners, double x, double y, double z) {
        double[] at = new double[3];
        for (int k = 0; k < 3; k++) {
            at[k] = leaf.get(k) + rotation(leaf, k, 0) * x + rotation(leaf, k, 1) * y + rotation(leaf, k, 2) * z;
        }
        corners.add(spot(at[0], at[1], at[2]));
    }

    private Spot spot(double x, double y, double z) {
        return new Spot(x * u[0] + y * u[1] + z * u[2], x * v[0] + y * v[1] + z * v[2], x * n[0] + y * n[1] + z * n[2]);
    }

    private static double distance(Spot a, Spot b) {
        return StrictMath.hypot(StrictMath.hypot(a.u - b.u, a.v - b.v), a.height - b.height);
    }

    // What two of them have in common, seen along the normal.

    /** The part of a point, segment or polygon that is on a polygon, or on a point or segment that crosses it. */
    private static List<Spot> clip(List<Spot> subject, List<Spot> region) {
        if (region.size() < 3) {
            return crossing(subject, region);
        }
        List<Spot> left = subject;
        for (int k = 0; k < region.size() && !left.isEmpty(); k++) {
            left = clip(left, region.get(k), region.get((k + 1) % region.size()));
        }
        return left;
    }

    /** The part to the left of an edge, by Sutherland and Hodgman (1974). */
    private static List<Spot> clip(List<Spot> subject, Spot from, Spot to) {
        List<Spot> left = new ArrayList<>();
        double slack = NEAR
                * (Math.abs(to.u - from.u) + Math.abs(to.v - from.v))
                * (Math.abs(from.u) + Math.abs(from.v) + Math.abs(to.u) + Math.abs(to.v));
        for (int k = 0; k < subject.size(); k++) {
            Spot here = subject.get(k);
            Spot next = subject.get((k + 1) % subject.size());
            double side = side(from, to, here);
            double other = side(from, to, next);
            if (side >= -slack) {
                left.add(here);
            }
            boolean isEdge = subject.size() > 2 || k + 1 < subject.size();
            if (isEdge && ((side > slack && other < -slack) || (side < -slack && other > slack))) {
                double t = side / (side - other);
                left.add(new Spot(here.u + t * (next.u - here.u), here.v + t * (next.v - here.v), 0));
            }
        }
        return left;
    }

    private static double side(Spot from, Spot to, Spot at) {
        return (to.u - from.u) * (at.v - from.v) - (to.v - from.v) * (at.u - from.u);
    }

    /** Where two segments or points touch each other; of parallel segments, the ends of what they share. */
    private static List<Spot> crossing(List<Spot> one, List<Spot> other) {
        if (one.size() < 2 || other.size() < 2) {
            return one.size() < 2 ? one : other;
        }
        Spot a = one.get(0);
        Spot b = one.get(1);
        Spot c = other.get(0);
        Spot d = other.get(1);
        double start = side(c, d, a);
        double end = side(c, d, b);
        double length = StrictMath.hypot(b.u - a.u, b.v - a.v);
        double width = StrictMath.hypot(d.u - c.u, d.v - c.v);
        if (Math.abs(start - end) > LEVEL * length * width) {
            double t = Math.max(0, Math.min(1, start / (start - end)));
            return List.of(new Spot(a.u + t * (b.u - a.u), a.v + t * (b.v - a.v), 0));
        }
        double first = Math.max(0, Math.min(along(a, b, c), along(a, b, d)) / (length * length));
        double last = Math.min(1, Math.max(along(a, b, c), along(a, b, d)) / (length * length));
        List<Spot> shared = new ArrayList<>();
        for (double t : first < last ? new double[] {first, last} : new double[] {Math.min(1, first)}) {
            shared.add(new Spot(a.u + t * (b.u - a.u), a.v + t * (b.v - a.v), 0));
        }
        return shared;
    }

    private static double along(Spot a, Spot b, Spot p) {
        return (b.u - a.u) * (p.u - a.u) + (b.v - a.v) * (p.v - a.v);
    }

    /** The height of a face at a place: that of its plane, or of the nearest point of an edge or a corner. */
    private static double height(List<Spot> face, Spot at) {
        Spot a = face.get(0);
        if (face.size() == 1) {
            return a.height;
        }
        Spot b = face.get(1);
        if (face.size() == 2) {
            double squared = along(a, b, b);
            double t = squared == 0 ? 0 : Math.max(0, Math.min(1, along(a, b, at) / squared));
            return a.height + t * (b.height - a.height);
        }
        Spot c = face.get(2);
        double area = side(a, b, c);
        double ofB = side(a, at, c) / area;
        double ofC = side(a, b, at) / area;
        return area == 0 ? a.height : a.height + ofB * (b.height - a.height) + ofC * (c.height - a.height);
    }

    // No more points than needed.

    /** At most four of the points, so that the patch that they span is as large as theirs, almost. */
    private List<Contact.Spot> few(List<Contact.Spot> spots) {
        spots.sort(Comparator.comparingDouble(Contact.Spot::depth).reversed());
        if (spots.size() <= MOST) {
            return spots;
        }
        Contact.Spot first = spots.get(0);
        Contact.Spot far = spots.stream()
                .max(Comparator.comparingDouble(each -> squared(first, each)))
                .orElseThrow();
        List<Contact.Spot> kept = new ArrayList<>(List.of(first, far));
        for (int sign = -1; sign <= 1; sign += 2) {
            int of = sign;
            Contact.Spot most = spots.stream()
                    .max(Comparator.comparingDouble(each -> of * area(first, far, each)))
                    .orElseThrow();
            if (sign * area(first, far, most) > 0) {
                kept.add(most);
            }
        }
        kept.sort(Comparator.comparingDouble(Contact.Spot::depth).reversed());
        return kept;
    }

    private static double squared(Contact.Spot a, Contact.Spot b) {
        double x = b.point().x() - a.point().x();
        double y = b.point().y() - a.point().y();
        double z = b.point().z() - a.point().z();
        return x * x + y * y + z * z;
    }

    private double area(Contact.Spot a, Contact.Spot b, Contact.Spot c) {
        return side(spot(a), spot(b), spot(c));
    }

    private Spot spot(Contact.Spot spot) {
        return spot(spot.point().x(), spot.point().y(), spot.point().z());
    }

    private static double[] cross(double[] a, double[] b) {
        return new double[] {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    }

    private static double[] unit(double[] of) {
        double length = Math.sqrt(of[0] * of[0] + of[1] * of[1] + of[2] * of[2]);
        return new double[] {of[0] / length, of[1] / length, of[2] / length};
    }
}
