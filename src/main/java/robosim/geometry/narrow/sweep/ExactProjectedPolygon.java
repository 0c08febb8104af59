package robosim.geometry.narrow.sweep;

import java.util.ArrayList;
import java.util.List;
import robosim.geometry.exact.Dyadic;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.ProjectedPolygon;

/** The exact twin of {@link ProjectedPolygon}; a disc is its centre, one corner without normals. */
record ExactProjectedPolygon(List<Dyadic[]> corners, List<Dyadic[]> normals) {
    static ExactProjectedPolygon of(Leaf leaf) {
        return switch (leaf.kind) {
            case UPRIGHT_CYLINDER, SPHERE, UPRIGHT_CAPSULE ->
                new ExactProjectedPolygon(
                        List.<Dyadic[]>of(pair(Dyadic.of(leaf.get(0)), Dyadic.of(leaf.get(2)))), List.of());
            case UPRIGHT_BOX, BOX -> zonogon(leaf.row, leaf.at);
            case TRIANGLE -> triangle(leaf.row, leaf.at);
            case CYLINDER, PRISM, CAPSULE, MESH, SOLID_MESH, GRID -> throw leaf.kind.refused();
        };
    }

    int size() {
        return corners.size();
    }

    Dyadic[] corner(int k) {
        return corners.get(k % corners.size());
    }

    /** Seen from another origin, and with all lengths multiplied. */
    ExactProjectedPolygon relative(Dyadic[] origin, Dyadic factor) {
        List<Dyadic[]> moved = new ArrayList<>();
        for (Dyadic[] corner : corners) {
            moved.add(pair(
                    corner[0].subtract(origin[0]).multiply(factor),
                    corner[1].subtract(origin[1]).multiply(factor)));
        }
        return new ExactProjectedPolygon(moved, normals);
    }

    static Dyadic[] pair(Dyadic x, Dyadic z) {
        return new Dyadic[] {x, z};
    }

    static Dyadic dot(Dyadic[] a, Dyadic[] b) {
        return a[0].multiply(b[0]).add(a[1].multiply(b[1]));
    }

    static Dyadic cross(Dyadic[] a, Dyadic[] b) {
        return a[0].multiply(b[1]).subtract(a[1].multiply(b[0]));
    }

    static Dyadic[] subtract(Dyadic[] a, Dyadic[] b) {
        return pair(a[0].subtract(b[0]), a[1].subtract(b[1]));
    }

    static Dyadic[] scale(Dyadic[] a, Dyadic factor) {
        return pair(a[0].multiply(factor), a[1].multiply(factor));
    }

    // The outward normal of an edge that has the inside on its left.
    private static Dyadic[] right(Dyadic[] edge) {
        return pair(edge[1], edge[0].negate());
    }

    private static ExactProjectedPolygon zonogon(double[] row, int at) {
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
        return new ExactProjectedPolygon(corners, normals);
    }

    private static ExactProjectedPolygon triangle(double[] row, int at) {
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
        return new ExactProjectedPolygon(p, normals);
    }

    private static ExactProjectedPolygon segment(Dyadic[] p, Dyadic[] q) {
        Dyadic[] edge = subtract(q, p);
        if (edge[0].signum() == 0 && edge[1].signum() == 0) {
            edge = pair(Dyadic.ONE, Dyadic.ZERO);
        }
        Dyadic[] back = scale(edge, Dyadic.ONE.negate());
        return new ExactProjectedPolygon(List.of(p, q, q, p), List.of(right(edge), edge, right(back), back));
    }
}
