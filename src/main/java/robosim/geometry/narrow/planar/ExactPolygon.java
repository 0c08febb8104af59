package robosim.geometry.narrow.planar;

import java.util.ArrayList;
import java.util.List;
import robosim.geometry.exact.Dyadic;
import robosim.geometry.narrow.leaf.LeafKind;

/**
 * The exact projection of a box or a triangle, or a disc's centre as one corner without normals, for cases that a filter
 * leaves in doubt; slow. Corners are ordered with the inside on the left, each with the outward normal of the side that starts
 * there; what is flat has a side for either face. Points and directions are pairs of numbers.
 */
public record ExactPolygon(List<Dyadic[]> corners, List<Dyadic[]> normals) {
    private static final List<Dyadic[]> AXES =
            List.<Dyadic[]>of(pair(Dyadic.ONE, Dyadic.ZERO), pair(Dyadic.ZERO, Dyadic.ONE));

    public static ExactPolygon of(LeafKind kind, double[] row, int at) {
        return switch (kind) {
            case UPRIGHT_CYLINDER, SPHERE, UPRIGHT_CAPSULE ->
                new ExactPolygon(List.<Dyadic[]>of(pair(Dyadic.of(row[at]), Dyadic.of(row[at + 2]))), List.of());
            case UPRIGHT_BOX, BOX -> zonogon(row, at);
            case TRIANGLE -> triangle(row, at);
            case CYLINDER, PRISM, CAPSULE, MESH, SOLID_MESH, GRID -> throw kind.refused();
        };
    }

    public int size() {
        return corners.size();
    }

    public Dyadic[] corner(int k) {
        return corners.get(k % corners.size());
    }

    /** Seen from another origin, and with all lengths multiplied. */
    public ExactPolygon relative(Dyadic[] origin, Dyadic factor) {
        List<Dyadic[]> moved = new ArrayList<>();
        for (Dyadic[] corner : corners) {
            moved.add(scale(subtract(corner, origin), factor));
        }
        return new ExactPolygon(moved, normals);
    }

    /** Whether it touches or overlaps another one: no normal of either separates them, nor an axis if they are degenerate. */
    public boolean touches(ExactPolygon other) {
        return !isApartAlong(normals, other) && !isApartAlong(other.normals, other) && !isApartAlong(AXES, other);
    }

    private boolean isApartAlong(List<Dyadic[]> directions, ExactPolygon other) {
        for (Dyadic[] n : directions) {
            if (least(n).compareTo(other.most(n)) > 0 || other.least(n).compareTo(most(n)) > 0) {
                return true;
            }
        }
        return false;
    }

    /** Whether it touches or overlaps a disc. */
    boolean touchesDisc(double px, double pz, double radius) {
        return isWithin(pair(Dyadic.of(px), Dyadic.of(pz)), Dyadic.of(radius));
    }

    public boolean contains(double px, double pz) {
        return contains(pair(Dyadic.of(px), Dyadic.of(pz)));
    }

    /** Whether a point is inside of it or on its outline. */
    public boolean contains(Dyadic[] p) {
        for (int k = 0; k < normals.size(); k++) {
            if (dot(normals.get(k), subtract(p, corner(k))).signum() > 0) {
                return false;
            }
        }
        return !normals.isEmpty();
    }

    /** Whether a point is inside, or no farther from it than a radius. */
    public boolean isWithin(Dyadic[] p, Dyadic radius) {
        return contains(p) || comesNear(p, p, radius);
    }

    /** Whether a segment comes within a radius of a side. */
    public boolean comesNear(Dyadic[] from, Dyadic[] to, Dyadic radius) {
        Dyadic square = radius.square();
        for (int k = 0; k < corners.size(); k++) {
            Dyadic[] p = corner(k);
            Dyadic[] q = corner(k + 1);
            if (isNear(p, from, to, square)
                    || isNear(from, p, q, square)
                    || isNear(to, p, q, square)
                    || cross(from, to, p, q)) {
                return true;
            }
        }
        return false;
    }

    /** Whether a point is no farther than the root of {@code square} from a segment. */
    private static boolean isNear(Dyadic[] point, Dyadic[] from, Dyadic[] to, Dyadic square) {
        Dyadic[] along = subtract(to, from);
        Dyadic[] away = subtract(point, from);
        Dyadic length = dot(along, along);
        Dyadic share = dot(along, away);
        if (share.signum() <= 0 || length.signum() == 0) {
            return dot(away, away).compareTo(square) <= 0;
        }
        if (share.compareTo(length) >= 0) {
            Dyadic[] rest = subtract(point, to);
            return dot(rest, rest).compareTo(square) <= 0;
        }
        return cross(along, away).square().compareTo(square.multiply(length)) <= 0;
    }

    private static boolean cross(Dyadic[] a, Dyadic[] b, Dyadic[] p, Dyadic[] q) {
        return side(a, b, p) * side(a, b, q) < 0 && side(p, q, a) * side(p, q, b) < 0;
    }

    private static int side(Dyadic[] a, Dyadic[] b, Dyadic[] p) {
        return cross(subtract(b, a), subtract(p, a)).signum();
    }

    /** Whether the ray from (ox, oz) along (ux, uz) hits it. */
    public boolean isHitBy(double ox, double oz, double ux, double uz) {
        Dyadic[] start = pair(Dyadic.of(ox), Dyadic.of(oz));
        Dyadic[] along = pair(Dyadic.of(ux), Dyadic.of(uz));
        Dyadic[] across = right(along);
        Dyadic line = dot(across, start);
        if (least(across).compareTo(line) > 0
                || most(across).compareTo(line) < 0
                || most(along).compareTo(dot(along, start)) < 0) { // beside the line, or behind the start
            return false;
        }
        return !isPassedAlong(normals, start, along) && !isPassedAlong(AXES, start, along);
    }

    private boolean isPassedAlong(List<Dyadic[]> directions, Dyadic[] start, Dyadic[] along) {
        for (Dyadic[] n : directions) {
            Dyadic here = dot(n, start);
            int way = dot(n, along).signum();
            if ((way <= 0 && here.compareTo(least(n)) < 0) || (way >= 0 && here.compareTo(most(n)) > 0)) {
                return true;
            }
        }
        return false;
    }

    private Dyadic least(Dyadic[] n) {
        Dyadic least = dot(n, corners.get(0));
        for (Dyadic[] corner : corners) {
            least = least.min(dot(n, corner));
        }
        return least;
    }

    private Dyadic most(Dyadic[] n) {
        Dyadic most = dot(n, corners.get(0));
        for (Dyadic[] corner : corners) {
            most = most.max(dot(n, corner));
        }
        return most;
    }

    public static Dyadic[] pair(Dyadic x, Dyadic z) {
        return new Dyadic[] {x, z};
    }

    public static Dyadic dot(Dyadic[] a, Dyadic[] b) {
        return a[0].multiply(b[0]).add(a[1].multiply(b[1]));
    }

    public static Dyadic cross(Dyadic[] a, Dyadic[] b) {
        return a[0].multiply(b[1]).subtract(a[1].multiply(b[0]));
    }

    public static Dyadic[] subtract(Dyadic[] a, Dyadic[] b) {
        return pair(a[0].subtract(b[0]), a[1].subtract(b[1]));
    }

    public static Dyadic[] scale(Dyadic[] a, Dyadic factor) {
        return pair(a[0].multiply(factor), a[1].multiply(factor));
    }

    // The outward normal of an edge that has the inside on its left.
    private static Dyadic[] right(Dyadic[] edge) {
        return pair(edge[1], edge[0].negate());
    }

    private static ExactPolygon zonogon(double[] row, int at) {
        List<Dyadic[]> directions = new ArrayList<>();
        List<Dyadic> sizes = new ArrayList<>();
        Dyadic[] start = pair(Dyadic.of(row[at]), Dyadic.of(row[at + 2]));
        for (int k = 0; k < 3; k++) {
            Dyadic[] u = pair(Dyadic.of(row[at + 6 + k]), Dyadic.of(row[at + 12 + k]));
            if (u[0].signum() == 0 && u[1].signum() == 0) {
                continue;
            }
            if (u[1].signum() < 0 || (u[1].signum() == 0 && u[0].signum() < 0)) {
                u = scale(u, Dyadic.ONE.negate());
            }
            int place = directions.size();
            while (place > 0 && cross(directions.get(place - 1), u).signum() < 0) {
                place--;
            }
            directions.add(place, u);
            sizes.add(place, Dyadic.of(row[at + 3 + k]));
            start = subtract(start, scale(u, sizes.get(place)));
        }
        List<Dyadic[]> corners = new ArrayList<>();
        List<Dyadic[]> normals = new ArrayList<>();
        Dyadic[] corner = start;
        for (int k = 0; k < 2 * directions.size(); k++) {
            Dyadic[] u = directions.get(k % directions.size());
            Dyadic step = sizes.get(k % directions.size()).scale(1);
            Dyadic sign = k < directions.size() ? Dyadic.ONE : Dyadic.ONE.negate();
            corners.add(corner);
            normals.add(right(scale(u, sign)));
            corner = subtract(corner, scale(u, step.multiply(sign).negate()));
        }
        return new ExactPolygon(corners, normals);
    }

    private static ExactPolygon triangle(double[] row, int at) {
        List<Dyadic[]> p = new ArrayList<>();
        for (int k = at; k < at + 9; k += 3) {
            p.add(pair(Dyadic.of(row[k]), Dyadic.of(row[k + 2])));
        }
        int side = cross(subtract(p.get(1), p.get(0)), subtract(p.get(2), p.get(0)))
                .signum();
        if (side == 0) {
            p.sort((a, b) -> a[0].compareTo(b[0]) != 0 ? a[0].compareTo(b[0]) : a[1].compareTo(b[1]));
            return segment(p.get(0), p.get(2));
        }
        if (side < 0) {
            p = List.of(p.get(0), p.get(2), p.get(1));
        }
        List<Dyadic[]> normals = new ArrayList<>();
        for (int k = 0; k < 3; k++) {
            normals.add(right(subtract(p.get((k + 1) % 3), p.get(k))));
        }
        return new ExactPolygon(p, normals);
    }

    private static ExactPolygon segment(Dyadic[] p, Dyadic[] q) {
        Dyadic[] edge = subtract(q, p);
        if (edge[0].signum() == 0 && edge[1].signum() == 0) {
            edge = pair(Dyadic.ONE, Dyadic.ZERO);
        }
        Dyadic[] back = scale(edge, Dyadic.ONE.negate());
        return new ExactPolygon(List.of(p, q, q, p), List.of(right(edge), edge, right(back), back));
    }
}
