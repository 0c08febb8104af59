package robosim.geometry.census;

import java.util.SplittableRandom;
import robosim.geometry.narrow.leaf.LeafKind;

/** A convex leaf as the twins see it: corners with edges and sides, or a centre, an axis and a radius; a capsule is an edge with one. */
final class Solid {
    private static final int[][] BOX_EDGES = {
        {0, 1}, {2, 3}, {4, 5}, {6, 7}, {0, 2}, {1, 3}, {4, 6}, {5, 7}, {0, 4}, {1, 5}, {2, 6}, {3, 7}
    };
    private static final int[][] TRIANGLE_EDGES = {{0, 1}, {1, 2}, {2, 0}};
    private static final int[][] SEGMENT = {{0, 1}};
    private static final int[][] BOX_SIDES = {{0, 2, 4}, {1, 3, 5}, {0, 1, 4}, {2, 3, 6}, {0, 1, 2}, {4, 5, 6}};
    private static final int[][] TRIANGLE_SIDES = {{0, 1, 2}};

    final LeafKind kind;
    final double[][] corners;
    final int[][] edges;

    /** Of each side a corner and the two that its edges lead to; a box's sides go on to a fourth. */
    final int[][] sides;

    final double[] centre;
    final double[] axis;
    final double radius;
    final double half;

    /** Of each edge and each side a point and how far they reach from it. */
    final double[][] edgeMiddles;

    final double[] edgeReaches;
    final double[][] sideMiddles;
    final double[] sideReaches;

    private Solid(LeafKind kind, double[][] corners, double[] centre, double[] axis, double radius, double half) {
        this.kind = kind;
        this.corners = corners;
        edges = switch (kind) {
            case BOX -> BOX_EDGES;
            case TRIANGLE -> TRIANGLE_EDGES;
            case CAPSULE -> SEGMENT;
            default -> new int[0][];
        };
        sides = kind == LeafKind.BOX ? BOX_SIDES : kind == LeafKind.TRIANGLE ? TRIANGLE_SIDES : new int[0][];
        this.centre = centre;
        this.axis = axis;
        this.radius = radius;
        this.half = half;
        edgeMiddles = new double[edges.length][];
        edgeReaches = new double[edges.length];
        sideMiddles = new double[sides.length][];
        sideReaches = new double[sides.length];
        for (int k = 0; k < edges.length; k++) {
            edgeMiddles[k] = middle(edges[k][0], edges[k][1]);
            edgeReaches[k] = Vec.between(edgeMiddles[k], corners[edges[k][0]]);
        }
        for (int k = 0; k < sides.length; k++) {
            // Of a triangle the middle of one edge reaches no further than the longest.
            sideMiddles[k] = middle(sides[k][1], sides[k][2]);
            sideReaches[k] = Math.max(
                    Vec.between(sideMiddles[k], corners[sides[k][0]]),
                    Vec.between(sideMiddles[k], corners[sides[k][1]]));
        }
    }

    private double[] middle(int p, int q) {
        return new double[] {
            0.5 * (corners[p][0] + corners[q][0]),
            0.5 * (corners[p][1] + corners[q][1]),
            0.5 * (corners[p][2] + corners[q][2])
        };
    }

    /** A row's solid, seen from an origin. */
    static Solid of(LeafKind kind, double[] row, double[] origin) {
        double[] c = {row[0] - origin[0], row[1] - origin[1], row[2] - origin[2]};
        return switch (kind) {
            case BOX -> {
                double[][] corners = new double[8][3];
                for (int m = 0; m < 8; m++) {
                    for (int k = 0; k < 3; k++) {
                        corners[m][k] = c[k];
                        for (int e = 0; e < 3; e++) {
                            corners[m][k] += ((m >> e & 1) == 0 ? -1 : 1) * row[3 + e] * row[6 + 3 * k + e];
                        }
                    }
                }
                yield new Solid(kind, corners, c, new double[3], 0, 0);
            }
            case TRIANGLE -> {
                double[][] corners = new double[3][3];
                for (int m = 0; m < 9; m++) {
                    corners[m / 3][m % 3] = row[m] - origin[m % 3];
                }
                yield new Solid(kind, corners, c, new double[3], 0, 0);
            }
            case CYLINDER -> {
                double[] axis = Vec.unit(new double[] {row[7], row[10], row[13]});
                yield new Solid(kind, new double[0][], c, axis, row[3], row[4]);
            }
            case UPRIGHT_BOX, UPRIGHT_CYLINDER, SPHERE, PRISM ->
                new Solid(kind, new double[0][], c, new double[3], row[3], 0);
            case CAPSULE -> {
                double[] arm = {row[4] * row[7], row[4] * row[10], row[4] * row[13]};
                yield new Solid(
                        kind, new double[][] {Vec.plus(c, -1, arm), Vec.plus(c, 1, arm)}, c, new double[3], row[3], 0);
            }
            case UPRIGHT_CAPSULE, MESH, SOLID_MESH, GRID -> throw kind.refused();
        };
    }

    /** The same turned about the origin by a matrix, then moved on. */
    Solid placed(double[] turn, double[] shift) {
        double[][] moved = new double[corners.length][];
        for (int m = 0; m < corners.length; m++) {
            moved[m] = Vec.plus(Vec.times(turn, corners[m]), 1, shift);
        }
        return new Solid(kind, moved, Vec.plus(Vec.times(turn, centre), 1, shift), Vec.times(turn, axis), radius, half);
    }

    /** How far it reaches around its corners and edges. */
    double around() {
        return kind == LeafKind.CAPSULE ? radius : 0;
    }

    boolean isPolytope() {
        return corners.length > 0;
    }

    /** The largest distance of a point of it from the origin, rounded up a little. */
    double reach() {
        double reach = isPolytope() ? 0 : Vec.length(centre) + radius + half;
        for (double[] corner : corners) {
            reach = Math.max(reach, Vec.length(corner) + radius);
        }
        return reach;
    }

    /** A point that lies furthest in a direction; any of those that do. */
    double[] furthest(double[] n, SplittableRandom random) {
        if (!isPolytope()) {
            double along = Vec.dot(n, axis);
            double[] across = Vec.plus(n, -along, axis);
            double length = Vec.length(across);
            double[] p = Vec.plus(centre, radius / Math.max(length, 1e-300), kind == LeafKind.SPHERE ? n : across);
            if (kind == LeafKind.SPHERE) {
                return Vec.plus(centre, radius, n);
            }
            if (length < 1e-9) {
                double[] any = Vec.unit(Vec.cross(axis, Vec.direction(random)));
                p = Vec.plus(centre, radius * random.nextDouble(), any);
            }
            double height = Math.abs(along) < 1e-9 ? random.nextDouble(-1, 1) : Math.signum(along);
            return Vec.plus(p, half * height, axis);
        }
        double most = Double.NEGATIVE_INFINITY;
        for (double[] corner : corners) {
            most = Math.max(most, Vec.dot(n, corner));
        }
        double[] sum = new double[3];
        double weights = 0;
        for (double[] corner : corners) {
            if (Vec.dot(n, corner) > most - 1e-9 * (1 + reach())) {
                double weight = random.nextDouble(0.05, 1);
                weights += weight;
                sum = Vec.plus(sum, weight, corner);
            }
        }
        return Vec.plus(Vec.plus(new double[3], 1 / weights, sum), around(), n);
    }

    /** The direction of an edge, a cylinder's axis; of a sphere any. */
    double[] edge(SplittableRandom random) {
        if (isPolytope()) {
            int[] edge = edges[random.nextInt(edges.length)];
            return Vec.unit(Vec.plus(corners[edge[1]], -1, corners[edge[0]]));
        }
        return kind == LeafKind.CYLINDER ? axis : Vec.direction(random);
    }

    /** The normal of a side or a cap, one way or the other; of a sphere or a capsule any direction. */
    double[] normal(SplittableRandom random) {
        double way = random.nextBoolean() ? 1 : -1;
        double[] n = kind == LeafKind.CYLINDER ? axis : Vec.direction(random);
        if (sides.length > 0) {
            int[] side = sides[random.nextInt(sides.length)];
            n = Vec.cross(
                    Vec.plus(corners[side[1]], -1, corners[side[0]]), Vec.plus(corners[side[2]], -1, corners[side[0]]));
        }
        return Vec.unit(Vec.plus(new double[3], way, n));
    }
}
