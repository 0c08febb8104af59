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
                                points.add(new double[] {x, z});
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
        List<double[]> p = corners(points(kindA, a));
        List<double[]> q = corners(points(kindB, b));
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

    private static List<double[]> corners(List<double[]> points) {
        return points;
    }

    static double support(List<double[]> points, double nx, double nz) {
        double most = Double.NEGATIVE_INFINITY;
        for (double[] p : points) {
            most = Math.max(most, nx * p[0] + nz * p[1]);
        }
        return most;
    }
}
