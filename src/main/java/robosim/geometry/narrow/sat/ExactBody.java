package robosim.geometry.narrow.sat;

import java.util.ArrayList;
import java.util.List;
import robosim.geometry.exact.Dyadic;
import robosim.geometry.narrow.leaf.LeafKind;

/** The exact counterpart of {@link AxisBody}: a polytope of the stored numbers, without rounding. */
public final class ExactBody {
    final List<Dyadic[]> normals = new ArrayList<>();
    final List<Dyadic[]> edges = new ArrayList<>();

    /** Corners, or only a centre, with half vectors. */
    final List<Dyadic[]> points = new ArrayList<>();

    private final List<Dyadic[]> halves = new ArrayList<>();

    private ExactBody() {}

    static ExactBody of(int mode, LeafKind kind, double[] row, int at) {
        ExactBody body = new ExactBody();
        boolean flat = mode == AxisBody.PLANAR;
        switch (kind) {
            case TRIANGLE -> body.triangle(row, at, flat);
            case UPRIGHT_BOX, BOX -> body.box(row, at, mode);
            case UPRIGHT_CYLINDER, SPHERE, CYLINDER, PRISM, UPRIGHT_CAPSULE, CAPSULE, MESH, SOLID_MESH ->
                throw kind.refused();
        }
        return body;
    }

    /** The extent along an axis. */
    Dyadic[] project(Dyadic[] axis) {
        Dyadic lo = dot(axis, points.get(0));
        Dyadic hi = lo;
        for (Dyadic[] point : points) {
            Dyadic reach = dot(axis, point);
            lo = lo.min(reach);
            hi = hi.max(reach);
        }
        for (Dyadic[] half : halves) {
            Dyadic reach = dot(axis, half).abs();
            lo = lo.subtract(reach);
            hi = hi.add(reach);
        }
        return new Dyadic[] {lo, hi};
    }

    private void triangle(double[] row, int at, boolean flat) {
        for (int k = at; k < at + 9; k += 3) {
            points.add(vector(row[k], flat ? 0 : row[k + 1], row[k + 2]));
        }
        for (int k = 0; k < 3; k++) {
            Dyadic[] edge = subtract(points.get((k + 1) % 3), points.get(k));
            if (flat) {
                normals.add(new Dyadic[] {edge[2].negate(), Dyadic.ZERO, edge[0]});
                normals.add(edge);
            } else {
                edges.add(edge);
            }
        }
        if (flat) {
            normals.add(vector(1, 0, 0));
            normals.add(vector(0, 0, 1));
        } else {
            normals.add(cross(edges.get(0), edges.get(1)));
        }
    }

    private void box(double[] row, int at, int mode) {
        boolean spatial = mode == AxisBody.SPATIAL;
        points.add(vector(row[at], mode == AxisBody.PLANAR ? 0 : row[at + 1], row[at + 2]));
        for (int k = 0; k < 3; k++) {
            Dyadic[] column = vector(row[at + 6 + k], spatial ? row[at + 9 + k] : 0, row[at + 12 + k]);
            halves.add(scale(column, Dyadic.of(row[at + 3 + k])));
            edges.add(column);
        }
        if (spatial) {
            for (int k = 0; k < 3; k++) {
                normals.add(cross(edges.get((k + 1) % 3), edges.get((k + 2) % 3)));
            }
            return;
        }
        for (Dyadic[] column : edges) {
            normals.add(new Dyadic[] {column[2].negate(), Dyadic.ZERO, column[0]});
        }
        edges.clear();
        if (mode == AxisBody.UPRIGHT) {
            halves.add(vector(0, row[at + 4], 0));
            normals.add(vector(0, 1, 0));
        }
    }

    static Dyadic[] vector(double x, double y, double z) {
        return new Dyadic[] {Dyadic.of(x), Dyadic.of(y), Dyadic.of(z)};
    }

    static Dyadic dot(Dyadic[] a, Dyadic[] b) {
        return a[0].multiply(b[0]).add(a[1].multiply(b[1])).add(a[2].multiply(b[2]));
    }

    static Dyadic[] cross(Dyadic[] a, Dyadic[] b) {
        return new Dyadic[] {
            a[1].multiply(b[2]).subtract(a[2].multiply(b[1])),
            a[2].multiply(b[0]).subtract(a[0].multiply(b[2])),
            a[0].multiply(b[1]).subtract(a[1].multiply(b[0]))
        };
    }

    static Dyadic[] subtract(Dyadic[] a, Dyadic[] b) {
        return new Dyadic[] {a[0].subtract(b[0]), a[1].subtract(b[1]), a[2].subtract(b[2])};
    }

    static Dyadic[] scale(Dyadic[] a, Dyadic factor) {
        return new Dyadic[] {a[0].multiply(factor), a[1].multiply(factor), a[2].multiply(factor)};
    }

    static boolean isZero(Dyadic[] a) {
        return a[0].signum() == 0 && a[1].signum() == 0 && a[2].signum() == 0;
    }
}
