package robosim.geometry.narrow.mesh;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.exact.BeamAxis;
import robosim.geometry.exact.VectorMath;
import robosim.geometry.index.meshes.TriangleMesh;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;
import robosim.geometry.narrow.Cast;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.leaf.LocalLeaves;
import robosim.geometry.narrow.leaf.UnderflowScaling;
import robosim.geometry.narrow.ray.SpatialRay;

/** Rays through a mesh's tree against every triangle of it, one by one. */
class MeshRayTest {
    private final Scratch scratch = new Scratch();
    private final Cast cast = new Cast(scratch);

    enum Family {
        ANYWHERE,
        LATTICE,
        SLIVERS,
        COPLANAR,
        DOUBLED,
        SINGLE,
        DOTS,
        FAR_FROM_ITS_ORIGIN,
        HUGE_AND_TINY,
        TINY,
        HUGE;

        MeshObject mesh(SplittableRandom random) {
            int faces = this == SINGLE ? 1 : this == DOTS ? 3 : 120;
            List<Point> vertices = new ArrayList<>();
            int[][] given = new int[faces][];
            for (int f = 0; f < faces; f++) {
                if (this == DOUBLED && f % 2 == 1) {
                    int[] last = given[f - 1];
                    given[f] = new int[] {last[1], last[2], last[0]};
                    continue;
                }
                double size = this == HUGE_AND_TINY ? (f % 10 == 0 ? 20 : 0x1p-12) : this == DOTS ? 0x1p-44 : 2;
                double[] at = {coordinate(random, 8), coordinate(random, 8), coordinate(random, 8)};
                given[f] = new int[] {vertices.size(), vertices.size() + 1, vertices.size() + 2};
                for (int corner = 0; corner < 3; corner++) {
                    double thin = this == SLIVERS ? 0x1p-30 : 1;
                    vertices.add(point(
                            at[0] + coordinate(random, size),
                            at[1] + thin * coordinate(random, size),
                            at[2] + thin * coordinate(random, size)));
                }
            }
            return new MeshObject(vertices, given);
        }

        private double coordinate(SplittableRandom random, double size) {
            return this == LATTICE || this == COPLANAR ? random.nextInt(-4, 5) * 0.5 : random.nextDouble(-size, size);
        }

        private Point point(double x, double y, double z) {
            return switch (this) {
                case COPLANAR -> new Point(x, 1, z);
                case FAR_FROM_ITS_ORIGIN -> new Point(x + 1e7, y - 1e7, z + 1e7);
                case TINY -> new Point(x * 0x1p-300, y * 0x1p-300, z * 0x1p-300);
                case HUGE -> new Point(x * 0x1p90, y * 0x1p90, z * 0x1p90);
                default -> new Point(x, y, z);
            };
        }

        double size() {
            return this == TINY ? 0x1p-300 : this == HUGE ? 0x1p90 : 1;
        }
    }

    static MeshObject placed(MeshObject mesh, int way, double size, SplittableRandom random) {
        Point far = new Point(
                random.nextDouble(-100, 100) * size,
                random.nextDouble(-100, 100) * size,
                random.nextDouble(-100, 100) * size);
        return switch (way) {
            case 0 -> mesh;
            case 1 -> mesh.movedTo(far);
            case 2 -> mesh.turned(90, 180).movedTo(far);
            case 3 ->
                mesh.turned(random.nextDouble(360), random.nextDouble(360)).movedTo(far);
            default ->
                mesh.oriented(new double[] {1 + 4e-10, 0, 0, 0, 1, 0, 0, 0, 1 - 4e-10})
                        .movedTo(far);
        };
    }

    @ParameterizedTest
    @EnumSource
    void findsWhatTheListFinds(Family family) {
        SplittableRandom random = new SplittableRandom(611 + family.ordinal());
        int hits = 0;
        int ties = 0;
        int rays = 0;
        for (int trial = 0; trial < 10; trial++) {
            MeshObject mesh = placed(family.mesh(random), trial % 5, family.size(), random);
            LeafColumn column = LocalLeaves.placed(mesh);
            double[][] rows = rows(column);
            for (int k = 0; k < 150; k++) {
                double[] ray = ray(rows, k, family.size(), random);
                cast.line(Dimension.SPATIAL, ray[0], ray[1], ray[2], ray[3], ray[4], ray[5]);
                String what = mesh + " seen along " + Arrays.toString(ray);
                int nearest = -1;
                double least = Double.POSITIVE_INFINITY;
                for (int t = 0; t < rows.length; t++) {
                    double distance = alone(rows[t], ray);
                    ties += distance == least && distance < Double.POSITIVE_INFINITY ? 1 : 0;
                    if (distance < least) {
                        least = distance;
                        nearest = t;
                    }
                }
                double found = cast.distance(column, 0, Double.POSITIVE_INFINITY);
                assertThat(found).as(what).isEqualTo(least);
                if (nearest >= 0) {
                    assertThat(cast.face(column, 0, cast.piece())).as(what).isEqualTo(nearest);
                    // What is as near as the limit still counts; beyond it nothing has to.
                    assertThat(cast.distance(column, 0, least)).as(what).isEqualTo(least);
                    assertThat(cast.distance(column, 0, least / 2)).as(what).isGreaterThanOrEqualTo(least);
                    hits++;
                }
                rays++;
            }
        }
        assertThat(hits).isBetween(rays / 20, rays * 19 / 20);
        if (family == Family.DOUBLED || family == Family.LATTICE) {
            assertThat(ties).isGreaterThan(50);
        }
    }

    /** Directions of unit length, which are taken as they are, and starts from within the mesh to a million times its size. */
    @ParameterizedTest
    @EnumSource
    void unitDirectionsFromNearAndFarFindTheSame(Family family) {
        SplittableRandom random = new SplittableRandom(617 + family.ordinal());
        int hits = 0;
        for (int trial = 0; trial < 5; trial++) {
            MeshObject mesh = placed(family.mesh(random), trial, family.size(), random);
            LeafColumn column = LocalLeaves.placed(mesh);
            double[][] rows = rows(column);
            double half = 1 / column.mesh(0).tree().scale();
            for (int k = 0; k < 200; k++) {
                double[] ray = ray(rows, k, family.size(), random);
                double length = Math.sqrt(ray[3] * ray[3] + ray[4] * ray[4] + ray[5] * ray[5]);
                // Around 4, where starts begin to be advanced, and far beyond.
                double back = half * (k % 3 == 0 ? random.nextDouble(3.5, 5) : Math.scalb(1.0, random.nextInt(-5, 21)));
                for (int axis = 0; axis < 3; axis++) {
                    ray[3 + axis] /= length;
                    ray[axis] -= back * ray[3 + axis];
                }
                cast.line(Dimension.SPATIAL, ray[0], ray[1], ray[2], ray[3], ray[4], ray[5]);
                double least = Double.POSITIVE_INFINITY;
                for (double[] row : rows) {
                    least = Math.min(least, alone(row, ray));
                }
                assertThat(cast.distance(column, 0, Double.POSITIVE_INFINITY))
                        .as("%s seen along %s", mesh, Arrays.toString(ray))
                        .isEqualTo(least);
                hits += least < Double.POSITIVE_INFINITY ? 1 : 0;
            }
        }
        assertThat(hits).isBetween(50, 950);
    }

    /** The triangle as a mesh of its own, which has no tree to speak of, through the kernel alone. */
    private double alone(double[] row, double[] ray) {
        UnderflowScaling m = new UnderflowScaling();
        double largest = VectorMath.largest(ray[0], ray[1], ray[2]);
        if (!m.take(Dimension.SPATIAL, largest, LeafKind.TRIANGLE, row, 0)) {
            return SpatialRay.distance(
                    new BeamAxis().line(ray[0], ray[1], ray[2], ray[3], ray[4], ray[5]),
                    LeafKind.TRIANGLE,
                    row,
                    0,
                    scratch.ray);
        }
        return m.down(SpatialRay.distance(
                new BeamAxis().line(m.up(ray[0]), m.up(ray[1]), m.up(ray[2]), ray[3], ray[4], ray[5]),
                LeafKind.TRIANGLE,
                m.a,
                0,
                scratch.ray));
    }

    static double[][] rows(LeafColumn column) {
        TriangleMesh mesh = column.mesh(0);
        double[][] rows = new double[mesh.size()][Leaf.STRIDE];
        for (int t = 0; t < mesh.size(); t++) {
            for (int k = 0; k < 9; k++) {
                rows[t][k] = mesh.placed(mesh.vertex(t, k / 3), k % 3, column.rows(), 0);
            }
        }
        return rows;
    }

    /** Some aimed at corners, at points of edges, along axes, from a corner, in a triangle's plane; some anywhere. */
    static double[] ray(double[][] rows, int way, double size, SplittableRandom random) {
        double[] t = rows[random.nextInt(rows.length)];
        double[] u = rows[random.nextInt(rows.length)];
        int corner = 3 * random.nextInt(3);
        int next = (corner + 3) % 9;
        double share = way % 2 == 0 ? 0 : random.nextInt(9) / 8.0;
        double[] ray = new double[6];
        for (int axis = 0; axis < 3; axis++) {
            double target = t[corner + axis] + share * (t[next + axis] - t[corner + axis]);
            ray[3 + axis] = switch (way % 5) {
                case 0, 1 -> random.nextDouble(-1, 1);
                case 2 -> axis == way / 5 % 3 ? (way % 2 == 0 ? 1 : -1) : way % 7 == 0 ? 0x1p-70 : 0;
                case 3 -> u[axis] - target;
                default -> t[next + axis] - t[corner + axis];
            };
            double back = way % 5 >= 3 ? random.nextInt(3) : way % 3 * 10 * size;
            ray[axis] = target - back * ray[3 + axis];
            if (way % 5 == 1 && way % 2 == 0) {
                ray[axis] += random.nextDouble(-20, 20) * size;
            }
        }
        if (ray[3] == 0 && ray[4] == 0 && ray[5] == 0) {
            ray[3] = 1;
        }
        return ray;
    }

    /** From inside of a closed surface no ray gets out, wherever it is aimed: at its corners and edges too. */
    @Test
    void aClosedSurfaceLetsNothingThrough() {
        SplittableRandom random = new SplittableRandom(613);
        int n = 24;
        List<Point> vertices = new ArrayList<>();
        List<int[]> faces = new ArrayList<>();
        for (int i = 0; i <= n; i++) {
            for (int j = 0; j < n; j++) {
                double up = Math.PI * i / n;
                double around = 2 * Math.PI * j / n;
                double out = 3 + random.nextDouble();
                vertices.add(new Point(
                        out * StrictMath.sin(up) * StrictMath.cos(around),
                        i == 0 ? 3 : i == n ? -3 : out * StrictMath.cos(up),
                        out * StrictMath.sin(up) * StrictMath.sin(around)));
            }
        }
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < n; j++) {
                int a = i == 0 ? 0 : i * n + j;
                int b = i == 0 ? 0 : i * n + (j + 1) % n;
                int c = i == n - 1 ? n * n : (i + 1) * n + (j + 1) % n;
                int d = i == n - 1 ? n * n : (i + 1) * n + j;
                faces.add(new int[] {a, b, c});
                faces.add(new int[] {a, c, d});
            }
        }
        MeshObject mesh = new MeshObject(vertices, faces.toArray(new int[0][])).turned(21, 37);
        for (MeshObject surface : List.of(mesh, mesh.movedTo(new Point(1000, -300, 7)))) {
            LeafColumn column = LocalLeaves.placed(surface);
            double[][] rows = rows(column);
            Point c = surface.center();
            for (int k = 0; k < 20_000; k++) {
                double[] t = rows[random.nextInt(rows.length)];
                int corner = 3 * random.nextInt(3);
                int next = (corner + 3) % 9;
                double share = random.nextInt(5) / 4.0;
                double[] d = new double[3];
                for (int axis = 0; axis < 3; axis++) {
                    double middle = axis == 0 ? c.x() : axis == 1 ? c.y() : c.z();
                    d[axis] = t[corner + axis] + share * (t[next + axis] - t[corner + axis]) - middle;
                }
                cast.line(Dimension.SPATIAL, c.x(), c.y(), c.z(), d[0], d[1], d[2]);
                assertThat(cast.distance(column, 0, Double.POSITIVE_INFINITY)).isBetween(2.0, 4.1);
            }
        }
    }
}
