package robosim.geometry.narrow;

import java.util.ArrayList;
import java.util.List;

/** Outlines as many points, straight from the definition of each leaf: for what no exact twin can be had. */
final class PlanarSampling {
    private static final int RIM = 1440;

    private PlanarSampling() {}

    /** Points of the leaf whose hull is its projection, to within a part in a million of its size. */
    static List<double[]> points(int kind, double[] row) {
        List<double[]> points = new ArrayList<>();
        switch (kind) {
            case Leaf.TRIANGLE -> {
                for (int k = 0; k < 9; k += 3) {
                    points.add(new double[] {row[k], row[k + 2]});
                }
            }
            case Leaf.SPHERE, Leaf.UPRIGHT_CYLINDER -> {
                for (int k = 0; k < RIM; k++) {
                    double t = 2 * Math.PI * k / RIM;
                    points.add(new double[] {row[0] + row[3] * Math.cos(t), row[2] + row[3] * Math.sin(t)});
                }
            }
            case Leaf.CYLINDER -> {
                for (int side = -1; side <= 1; side += 2) {
                    for (int k = 0; k < RIM; k++) {
                        double t = 2 * Math.PI * k / RIM;
                        double x = row[3] * Math.cos(t);
                        double z = row[3] * Math.sin(t);
                        double y = side * row[4];
                        points.add(new double[] {
                            row[0] + row[6] * x + row[7] * y + row[8] * z,
                            row[2] + row[12] * x + row[13] * y + row[14] * z
                        });
                    }
                }
            }
            case Leaf.PRISM -> {
                // all crossings of two planes that the other planes allow
                double[][] lines = {
                    {1, 0, row[0]}, {1, 0, row[1]}, {0, 1, row[2]}, {0, 1, row[3]},
                    {1, 1, row[4]}, {1, 1, row[5]}, {1, -1, row[6]}, {1, -1, row[7]}
                };
                for (double[] p : lines) {
                    for (double[] q : lines) {
                        double det = p[0] * q[1] - p[1] * q[0];
                        if (det != 0) {
                            double x = (p[2] * q[1] - p[1] * q[2]) / det;
                            double z = (p[0] * q[2] - p[2] * q[0]) / det;
                            if (isWithin(row, x, z)) {
                                // one corner, however often its planes meet
                                points.add(
                                        new double[] {Math.rint(x * 0x1p40) / 0x1p40, Math.rint(z * 0x1p40) / 0x1p40});
                            }
                        }
                    }
                }
            }
            default -> {
                for (int k = 0; k < 8; k++) {
                    double x = (k & 1) == 0 ? row[3] : -row[3];
                    double y = (k & 2) == 0 ? row[4] : -row[4];
                    double z = (k & 4) == 0 ? row[5] : -row[5];
                    points.add(new double[] {
                        row[0] + row[6] * x + row[7] * y + row[8] * z, row[2] + row[12] * x + row[13] * y + row[14] * z
                    });
                }
            }
        }
        return points;
    }

    private static boolean isWithin(double[] row, double x, double z) {
        double slack = 1e-13;
        return x >= row[0] - slack
                && x <= row[1] + slack
                && z >= row[2] - slack
                && z <= row[3] + slack
                && x + z >= row[4] - slack
                && x + z <= row[5] + slack
                && x - z >= row[6] - slack
                && x - z <= row[7] + slack;
    }

    /** The widest gap between the two along 720 directions; not below the truth by more than a share of the distance. */
    static double gap(int kindA, double[] a, int kindB, double[] b) {
        List<double[]> p = points(kindA, a);
        List<double[]> q = points(kindB, b);
        double widest = Double.NEGATIVE_INFINITY;
        for (int k = 0; k < 720; k++) {
            double nx = Math.cos(Math.PI * k / 360);
            double nz = Math.sin(Math.PI * k / 360);
            widest = Math.max(widest, -support(q, -nx, -nz) - support(p, nx, nz) - 4e-6 * isCurved(kindA, kindB));
        }
        return widest;
    }

    private static int isCurved(int kindA, int kindB) {
        boolean curved = kindA == Leaf.CYLINDER || kindB == Leaf.CYLINDER || kindB == 1 || kindB == 2;
        return curved ? 1 : 0;
    }

    static double support(List<double[]> points, double nx, double nz) {
        double most = Double.NEGATIVE_INFINITY;
        for (double[] p : points) {
            most = Math.max(most, nx * p[0] + nz * p[1]);
        }
        return most;
    }

    /** Where a ray first meets the hull of points; they have some area. */
    static double ray(double ox, double oz, double ux, double uz, List<double[]> points) {
        // The hull, as seen by its lines: the ray enters behind the last of those that it crosses inward.
        List<double[]> hull = hull(points);
        double in = 0;
        double out = Double.POSITIVE_INFINITY;
        for (int k = 0; k < hull.size(); k++) {
            double[] a = hull.get(k);
            double[] b = hull.get((k + 1) % hull.size());
            double nx = b[1] - a[1];
            double nz = a[0] - b[0];
            double beyond = nx * (ox - a[0]) + nz * (oz - a[1]);
            double way = nx * ux + nz * uz;
            if (way < 0) {
                in = Math.max(in, -beyond / way);
            } else if (way > 0) {
                out = Math.min(out, -beyond / way);
            } else if (beyond > 0) {
                return Double.POSITIVE_INFINITY;
            }
        }
        return in <= out ? in : Double.POSITIVE_INFINITY;
    }

    /** How far a point is inside the hull; negative outside. */
    static double depth(double x, double z, List<double[]> points) {
        List<double[]> hull = hull(points);
        double depth = Double.POSITIVE_INFINITY;
        for (int k = 0; k < hull.size(); k++) {
            double[] a = hull.get(k);
            double[] b = hull.get((k + 1) % hull.size());
            double length = StrictMath.hypot(b[0] - a[0], b[1] - a[1]);
            depth = Math.min(depth, ((b[0] - a[0]) * (z - a[1]) - (b[1] - a[1]) * (x - a[0])) / length);
        }
        return depth;
    }

    // Andrew's chain.
    static List<double[]> hull(List<double[]> points) {
        List<double[]> sorted = new ArrayList<>(points);
        sorted.sort((a, b) -> a[0] != b[0] ? Double.compare(a[0], b[0]) : Double.compare(a[1], b[1]));
        List<double[]> hull = new ArrayList<>();
        for (int side = 0; side < 2; side++) {
            int from = hull.size();
            for (int k = 0; k < sorted.size(); k++) {
                double[] p = sorted.get(side == 0 ? k : sorted.size() - 1 - k);
                while (hull.size() >= from + 2 && !isLeft(hull.get(hull.size() - 2), hull.get(hull.size() - 1), p)) {
                    hull.remove(hull.size() - 1);
                }
                hull.add(p);
            }
            hull.remove(hull.size() - 1);
        }
        return hull;
    }

    private static boolean isLeft(double[] a, double[] b, double[] p) {
        return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]) > 0;
    }
}
