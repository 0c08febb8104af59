package robosim.geometry.narrow;

import java.math.BigDecimal;
import java.math.BigInteger;
import java.util.ArrayList;
import java.util.List;

/**
 * All differences of two solid hulls of whole-numbered points, and the planes through three of them that have all others
 * on one side: how deep the two are in each other, and whether a motion goes deeper.
 */
final class GridHull {
    private record Plane(long[] normal, long reach) {
        BigInteger reachSquare() {
            return BigInteger.valueOf(reach).pow(2);
        }

        BigInteger square() {
            return BigInteger.valueOf(dot(normal, normal));
        }
    }

    private final List<Plane> planes = new ArrayList<>();

    GridHull(List<BigDecimal[]> mover, List<BigDecimal[]> rest) {
        List<long[]> points = new ArrayList<>();
        for (BigDecimal[] p : mover) {
            for (BigDecimal[] q : rest) {
                long[] point = new long[3];
                for (int k = 0; k < 3; k++) {
                    point[k] = q[k].subtract(p[k]).longValueExact();
                }
                if (points.stream().noneMatch(known -> java.util.Arrays.equals(known, point))) {
                    points.add(point);
                }
            }
        }
        for (int i = 0; i < points.size(); i++) {
            for (int j = 0; j < i; j++) {
                for (int k = 0; k < j; k++) {
                    long[] normal = cross(minus(points.get(j), points.get(i)), minus(points.get(k), points.get(i)));
                    add(normal, points.get(i), points);
                    add(new long[] {-normal[0], -normal[1], -normal[2]}, points.get(i), points);
                }
            }
        }
    }

    private void add(long[] normal, long[] through, List<long[]> points) {
        long reach = dot(normal, through);
        if (dot(normal, normal) == 0) {
            return;
        }
        for (long[] point : points) {
            if (dot(normal, point) > reach) {
                return;
            }
        }
        planes.add(new Plane(normal, reach));
    }

    /** Whether the origin is in the hull. */
    boolean touches() {
        return planes.stream().allMatch(plane -> plane.reach >= 0);
    }

    /** Whether a motion of the mover is strictly against all the least ways out. */
    boolean goesDeeper(double[] move) {
        Plane least = planes.stream()
                .min((p, q) -> p.reachSquare()
                        .multiply(q.square())
                        .compareTo(q.reachSquare().multiply(p.square())))
                .orElseThrow();
        return planes.stream()
                .filter(p -> p.reachSquare()
                        .multiply(least.square())
                        .equals(least.reachSquare().multiply(p.square())))
                .allMatch(p -> p.normal[0] * move[0] + p.normal[1] * move[1] + p.normal[2] * move[2] < 0);
    }

    private static long dot(long[] p, long[] q) {
        return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
    }

    private static long[] minus(long[] p, long[] q) {
        return new long[] {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
    }

    private static long[] cross(long[] p, long[] q) {
        return new long[] {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
    }
}
