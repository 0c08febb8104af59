package robosim.geometry.dynamics.planar;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.geom.Line2D;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** How far two pieces are apart and along which direction, beside all pairs of edges and corners. */
class PieceSeparationTest {
    private final SplittableRandom random = new SplittableRandom(41);
    private final PieceSeparation s = new PieceSeparation();

    /** Corners in the order that the pieces have. */
    private static void put(double[] x, double[] z, double[][] corners) {
        for (int k = 0; k < corners.length; k++) {
            x[k] = corners[k][0];
            z[k] = corners[k][1];
        }
    }

    private void put(double[][] a, double[][] b) {
        s.an = a.length;
        s.bn = b.length;
        put(s.ax, s.az, a);
        put(s.bx, s.bz, b);
        s.radius = 0;
    }

    /** A box whose side towards +x is at x. */
    private static double[][] box(double x, double depth, double from, double to) {
        return new double[][] {{x - depth, from}, {x, from}, {x, to}, {x - depth, to}};
    }

    private static double[][] turned(double[][] corners, double angle, double dx, double dz) {
        double[][] all = new double[corners.length][];
        for (int k = 0; k < all.length; k++) {
            double x = corners[k][0];
            double z = corners[k][1];
            all[k] = new double[] {
                dx + x * StrictMath.cos(angle) - z * StrictMath.sin(angle),
                dz + x * StrictMath.sin(angle) + z * StrictMath.cos(angle)
            };
        }
        return all;
    }

    private static double brute(double[][] a, double[][] b) {
        double least = Double.POSITIVE_INFINITY;
        for (double[][][] pair : new double[][][][] {{a, b}, {b, a}}) {
            for (double[] corner : pair[0]) {
                for (int k = 0; k < pair[1].length; k++) {
                    double[] from = pair[1][k];
                    double[] to = pair[1][(k + 1) % pair[1].length];
                    least = Math.min(least, Line2D.ptSegDist(from[0], from[1], to[0], to[1], corner[0], corner[1]));
                }
            }
        }
        return least;
    }

    /** Sides that face each other squarely and overlap anywhere: the direction is across them, however near they are. */
    @Test
    void parallelSidesMeetAlongTheirNormal() {
        for (int k = 0; k < 20_000; k++) {
            double gap = StrictMath.pow(10, random.nextDouble(-12, 1));
            double from = random.nextDouble(-3, 1);
            double to = random.nextDouble(from + 0.1, 4);
            double low = random.nextDouble(from - 3, to - 0.01);
            double high = random.nextDouble(Math.max(low, from) + 0.01, to + 3);
            double angle = random.nextInt(4) == 0 ? 0 : random.nextDouble(2 * Math.PI);
            double dx = random.nextDouble(-5, 5);
            double dz = random.nextDouble(-5, 5);
            double[][] a = turned(box(0, random.nextDouble(0.1, 2), from, to), angle, dx, dz);
            double depth = random.nextDouble(0.1, 2);
            double[][] b = turned(box(gap + depth, depth, low, high), angle, dx, dz);
            put(a, b);
            double distance = s.distance();
            assertThat(distance).as("distance").isEqualTo(gap, within(1e-14));
            assertThat(s.nx).as("gap %s", gap).isEqualTo(-StrictMath.cos(angle), within(1e-13));
            assertThat(s.nz).as("gap %s", gap).isEqualTo(-StrictMath.sin(angle), within(1e-13));
        }
    }

    @Test
    void distancesAreThoseOfAllEdgesAndCorners() {
        int acrossEdges = 0;
        int betweenCorners = 0;
        for (int k = 0; k < 20_000; k++) {
            double[][] a = turned(
                    box(0, random.nextDouble(0.1, 2), -1, random.nextDouble(2)),
                    random.nextDouble(7),
                    random.nextDouble(-5, 5),
                    random.nextDouble(-5, 5));
            double[][] b = turned(
                    box(0, random.nextDouble(0.1, 2), -1, random.nextDouble(2)),
                    random.nextDouble(7),
                    random.nextDouble(-5, 5),
                    random.nextDouble(-5, 5));
            put(a, b);
            double distance = s.distance();
            if (distance > 0) {
                assertThat(distance).isEqualTo(brute(a, b), within(1e-9));
                if (isNormal(a) || isNormal(b)) {
                    acrossEdges++;
                } else {
                    betweenCorners++;
                }
            }
        }
        assertThat(acrossEdges).as("across edges").isGreaterThan(5000);
        assertThat(betweenCorners).as("between corners").isGreaterThan(3000);
    }

    /** Whether the direction is that of the normal of a side. */
    private boolean isNormal(double[][] corners) {
        for (int k = 0; k < corners.length; k++) {
            double[] from = corners[k];
            double[] to = corners[(k + 1) % corners.length];
            double length = StrictMath.hypot(to[0] - from[0], to[1] - from[1]);
            if (Math.abs(s.nx * (to[0] - from[0]) + s.nz * (to[1] - from[1])) < 1e-12 * length) {
                return true;
            }
        }
        return false;
    }
}
