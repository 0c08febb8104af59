package robosim.geometry.narrow.sat;

import java.util.ArrayList;
import java.util.List;
import robosim.geometry.exact.Dyadic;
import robosim.geometry.exact.ExactVector;
import robosim.geometry.narrow.leaf.Leaf;

/** The exact counterpart of {@link AxisBody}: a polytope of the stored numbers, without rounding. */
final class ExactBody {
    final List<ExactVector> normals = new ArrayList<>();
    final List<ExactVector> edges = new ArrayList<>();

    /** Corners, or only a centre, with half vectors. */
    final List<ExactVector> points = new ArrayList<>();

    private final List<ExactVector> halves = new ArrayList<>();

    /** The least and the greatest place along an axis. */
    record Extent(Dyadic lo, Dyadic hi) {}

    private ExactBody() {}

    static ExactBody of(AxisBody.Mode mode, Leaf leaf) {
        ExactBody body = new ExactBody();
        boolean flat = mode == AxisBody.Mode.PLANAR;
        switch (leaf.kind.polytope()) {
            case TRIANGLE -> body.triangle(leaf.row, leaf.at, flat);
            case BOX -> body.box(leaf.row, leaf.at, mode);
        }
        return body;
    }

    /** The extent along an axis. */
    Extent project(ExactVector axis) {
        Dyadic lo = axis.dot(points.get(0));
        Dyadic hi = lo;
        for (ExactVector point : points) {
            Dyadic reach = axis.dot(point);
            lo = lo.min(reach);
            hi = hi.max(reach);
        }
        for (ExactVector half : halves) {
            Dyadic reach = axis.dot(half).abs();
            lo = lo.subtract(reach);
            hi = hi.add(reach);
        }
        return new Extent(lo, hi);
    }

    private void triangle(double[] row, int at, boolean flat) {
        for (int k = at; k < at + 9; k += 3) {
            points.add(ExactVector.of(row[k], flat ? 0 : row[k + 1], row[k + 2]));
        }
        for (int k = 0; k < 3; k++) {
            ExactVector edge = points.get((k + 1) % 3).minus(points.get(k));
            if (flat) {
                normals.add(across(edge));
                normals.add(edge);
            } else {
                edges.add(edge);
            }
        }
        if (flat) {
            normals.add(ExactVector.of(1, 0, 0));
            normals.add(ExactVector.of(0, 0, 1));
        } else {
            normals.add(edges.get(0).cross(edges.get(1)));
        }
    }

    private void box(double[] row, int at, AxisBody.Mode mode) {
        boolean spatial = mode == AxisBody.Mode.SPATIAL;
        points.add(ExactVector.of(row[at], mode == AxisBody.Mode.PLANAR ? 0 : row[at + 1], row[at + 2]));
        for (int k = 0; k < 3; k++) {
            ExactVector column = ExactVector.of(row[at + 6 + k], spatial ? row[at + 9 + k] : 0, row[at + 12 + k]);
            halves.add(column.times(Dyadic.of(row[at + 3 + k])));
            edges.add(column);
        }
        if (spatial) {
            for (int k = 0; k < 3; k++) {
                normals.add(edges.get((k + 1) % 3).cross(edges.get((k + 2) % 3)));
            }
            return;
        }
        for (ExactVector column : edges) {
            normals.add(across(column));
        }
        edges.clear();
        if (mode == AxisBody.Mode.UPRIGHT) {
            halves.add(ExactVector.of(0, row[at + 4], 0));
            normals.add(ExactVector.of(0, 1, 0));
        }
    }

    /** The horizontal normal of an edge. */
    private static ExactVector across(ExactVector edge) {
        return new ExactVector(edge.z().negate(), Dyadic.ZERO, edge.x());
    }
}
