package robosim.geometry.narrow;

import java.math.BigDecimal;
import java.util.List;
import robosim.geometry.narrow.leaf.LeafKind;

/** Two convex shapes in the plane, one of which can be turned: their gap, below 0 their depth, in plain doubles. */
public final class FlatPair {
    private final double[][] mover;
    private final double[][] rest;
    private final double radius;
    private final double px;
    private final double pz;

    public FlatPair(LeafKind kindA, double[] a, double px, double pz, LeafKind kindB, double[] b) {
        mover = points(FlatTwin.corners(kindA, a));
        rest = points(FlatTwin.corners(kindB, b));
        radius = radius(kindA, a) + radius(kindB, b);
        this.px = px;
        this.pz = pz;
    }

    /** Distance of the two, or less the depth, when the mover is turned about the upward vertical. */
    public double gap(double degrees) {
        double cos = StrictMath.cos(Math.toRadians(degrees));
        double sin = StrictMath.sin(Math.toRadians(degrees));
        double[][] differences = new double[mover.length * rest.length][];
        int count = 0;
        for (double[] p : mover) {
            double x = px + (p[0] - px) * cos + (p[1] - pz) * sin;
            double z = pz - (p[0] - px) * sin + (p[1] - pz) * cos;
            for (double[] q : rest) {
                differences[count++] = new double[] {q[0] - x, q[1] - z};
            }
        }
        return core(differences) - radius;
    }

    // The signed distance of the origin from a hull: for each pair of points that is an edge, its line, or its segment.
    private static double core(double[][] points) {
        double greatest = Double.NEGATIVE_INFINITY;
        double nearest = Double.POSITIVE_INFINITY;
        for (double[] p : points) {
            nearest = Math.min(nearest, Math.hypot(p[0], p[1]));
            for (double[] q : points) {
                double ex = q[0] - p[0];
                double ez = q[1] - p[1];
                double length = Math.hypot(ex, ez);
                if (length < 1e-9 || !isEdge(p, ex / length, ez / length, points)) {
                    continue;
                }
                // The inside lies on the left; the origin is outside by so much.
                double beyond = (ex * p[1] - ez * p[0]) / length;
                greatest = Math.max(greatest, beyond);
                double share = -(p[0] * ex + p[1] * ez) / (length * length);
                if (share > 0 && share < 1) {
                    nearest = Math.min(nearest, Math.abs(beyond));
                }
            }
        }
        return greatest > 0 || greatest == Double.NEGATIVE_INFINITY ? nearest : greatest;
    }

    private static boolean isEdge(double[] p, double ux, double uz, double[][] points) {
        for (double[] r : points) {
            if (ux * (r[1] - p[1]) - uz * (r[0] - p[0]) < -1e-14) {
                return false;
            }
        }
        return true;
    }

    private static double radius(LeafKind kind, double[] row) {
        return kind == LeafKind.UPRIGHT_CYLINDER || kind == LeafKind.SPHERE ? row[3] : 0;
    }

    private static double[][] points(List<BigDecimal[]> corners) {
        double[][] points = new double[corners.size()][];
        for (int k = 0; k < points.length; k++) {
            points[k] = new double[] {corners.get(k)[0].doubleValue(), corners.get(k)[1].doubleValue()};
        }
        return points;
    }
}
