package robosim.geometry.narrow;

import java.util.ArrayList;
import java.util.List;
import robosim.geometry.narrow.leaf.LeafKind;

/** Outlines as many points, straight from the definition of each leaf: for what no exact twin can be had. */
public final class PlanarSampling {
    private static final int RIM = 360;

    private PlanarSampling() {}

    /** Points of the leaf whose hull is its projection, to within a part in a million of its size. */
    public static List<double[]> points(LeafKind kind, double[] row) {
        List<double[]> points = new ArrayList<>();
        switch (kind) {
            case TRIANGLE -> {
                for (int k = 0; k < 9; k += 3) {
                    points.add(new double[] {row[k], row[k + 2]});
                }
            }
            case SPHERE, UPRIGHT_CYLINDER, UPRIGHT_CAPSULE -> {
                for (int k = 0; k < RIM; k++) {
                    double t = 2 * Math.PI * k / RIM;
                    points.add(new double[] {row[0] + row[3] * Math.cos(t), row[2] + row[3] * Math.sin(t)});
                }
            }
            case CYLINDER -> {
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
            case CAPSULE -> {
                for (int side = -1; side <= 1; side += 2) {
                    for (int k = 0; k < RIM; k++) {
                        double t = 2 * Math.PI * k / RIM;
                        points.add(new double[] {
                            row[0] + side * row[4] * row[7] + row[3] * Math.cos(t),
                            row[2] + side * row[4] * row[13] + row[3] * Math.sin(t)
                        });
                    }
                }
            }
            case PRISM -> {
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
    public static double gap(LeafKind kindA, double[] a, LeafKind kindB, double[] b) {
        List<double[]> p = points(kindA, a);
        List<double[]> q = points(kindB, b);
        double widest = Double.NEGATIVE_INFINITY;
        for (int k = 0; k < 720; k++) {
            double nx = Math.cos(Math.PI * k / 360);
            double nz = Math.sin(Math.PI * k / 360);
            widest = Math.max(widest, -support(q, -nx, -nz) - support(p, nx, nz) - 1e-4 * isCurved(kindA, kindB));
        }
        return widest;
    }

    private static int isCurved(LeafKind kindA, LeafKind kindB) {
        boolean curved = kindA.isRound() || kindB.isRound();
        return curved ? 1 : 0;
    }

    public static double support(List<double[]> points, double nx, double nz) {
        double most = Double.NEGATIVE_INFINITY;
        for (double[] p : points) {
            most = Math.max(most, nx * p[0] + nz * p[1]);
        }
        return most;
    }

    /** Where a ray first meets the hull of points; they have some area. */
    public static double ray(double ox, double oz, double ux, double uz, List<double[]> points) {
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
    public static double depth(double x, double z, List<double[]> points) {
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
    public static List<double[]> hull(List<double[]> points) {
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

    /** The least distance from (ox, oz) to the hull of points within a sector: what is left of the hull when cut by it. */
    public static double cone(double ox, double oz, double aim, double half, List<double[]> points) {
        List<double[]> left = points.size() > 2 ? hull(points) : points;
        left = cut(left, ox, oz, StrictMath.sin(aim + half), -StrictMath.cos(aim + half));
        left = cut(left, ox, oz, -StrictMath.sin(aim - half), StrictMath.cos(aim - half));
        return left.isEmpty() ? Double.POSITIVE_INFINITY : distance(ox, oz, left);
    }

    // What is left of a polygon on the side of a line through (ox, oz) to which n points.
    private static List<double[]> cut(List<double[]> polygon, double ox, double oz, double nx, double nz) {
        List<double[]> kept = new ArrayList<>();
        for (int k = 0; k < polygon.size(); k++) {
            double[] a = polygon.get(k);
            double[] b = polygon.get((k + 1) % polygon.size());
            double p = nx * (a[0] - ox) + nz * (a[1] - oz);
            double q = nx * (b[0] - ox) + nz * (b[1] - oz);
            if (p >= 0) {
                kept.add(a);
            }
            if ((p < 0 && q > 0) || (p > 0 && q < 0)) {
                double t = p / (p - q);
                kept.add(new double[] {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])});
            }
        }
        return kept;
    }

    /** The least distance from a point to a polygon, 0 inside. */
    public static double distance(double x, double z, List<double[]> polygon) {
        double least = Double.POSITIVE_INFINITY;
        boolean inside = polygon.size() > 2;
        for (int k = 0; k < polygon.size(); k++) {
            double[] a = polygon.get(k);
            double[] b = polygon.get((k + 1) % polygon.size());
            double ex = b[0] - a[0];
            double ez = b[1] - a[1];
            double square = ex * ex + ez * ez;
            double t = square > 0 ? ((x - a[0]) * ex + (z - a[1]) * ez) / square : 0;
            t = Math.max(0, Math.min(1, t));
            least = Math.min(least, StrictMath.hypot(a[0] + t * ex - x, a[1] + t * ez - z));
            inside &= ex * (z - a[1]) - ez * (x - a[0]) >= 0;
        }
        return inside ? 0 : least;
    }

    /** The least distance of two hulls. */
    public static double between(List<double[]> a, List<double[]> b) {
        List<double[]> p = hull(a);
        List<double[]> q = hull(b);
        for (double[] n : p) {
            if (isInside(n, q)) {
                return 0;
            }
        }
        for (double[] n : q) {
            if (isInside(n, p)) {
                return 0;
            }
        }
        for (int k = 0; k < p.size(); k++) {
            for (int m = 0; m < q.size(); m++) {
                if (isCrossing(p.get(k), p.get((k + 1) % p.size()), q.get(m), q.get((m + 1) % q.size()))) {
                    return 0;
                }
            }
        }
        double least = Double.POSITIVE_INFINITY;
        for (double[] n : p) {
            least = Math.min(least, distance(n[0], n[1], q));
        }
        for (double[] n : q) {
            least = Math.min(least, distance(n[0], n[1], p));
        }
        return least;
    }

    private static boolean isInside(double[] n, List<double[]> hull) {
        return distance(n[0], n[1], hull) == 0;
    }

    private static boolean isCrossing(double[] a, double[] b, double[] c, double[] d) {
        return isLeft(a, b, c) != isLeft(a, b, d) && isLeft(c, d, a) != isLeft(c, d, b);
    }
}
