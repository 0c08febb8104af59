package robosim.geometry.bench;

import java.util.Arrays;
import java.util.SplittableRandom;
import robosim.geometry.exact.Rotations;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.distance.SpatialDistance;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;

/**
 * Two leaves, or a leaf and a ray, somewhere between far apart and deep inside each other, most often within a few last
 * bits of touching: coarse and fine coordinates, parallel and nearly parallel attitudes, flat and empty things, tiny and
 * large ones, far from the origin.
 */
final class NearContacts {
    private static final int STRIDE = Leaf.STRIDE;

    final double[] a = new double[STRIDE];
    final double[] b = new double[STRIDE];

    /** A ray's start. */
    final double[] start = new double[3];

    /** A ray's direction, or the way of the first leaf. */
    final double[] way = new double[3];

    private final double[] n = new double[3];
    private final double[] p = new double[3];
    private final double[] q = new double[3];
    private SplittableRandom random = new SplittableRandom(0);
    private boolean coarse;
    private double scale;

    void pair(LeafKind kindA, LeafKind kindB, boolean planar, SplittableRandom source) {
        begin(source);
        fill(kindA, a);
        fill(kindB, b);
        if (random.nextInt(3) == 0) {
            align(kindA, kindB);
        }
        scaleAndMove(kindA, a, kindB, b);
        if (random.nextInt(5) > 0) {
            touch(kindA, kindB, planar);
        }
    }

    /** The first leaf may come to a contact from afar, slide along in contact, or pass through. */
    void motion(LeafKind kindA, LeafKind kindB, boolean planar, SplittableRandom source) {
        pair(kindA, kindB, planar, source);
        for (int k = 0; k < 3; k++) {
            way[k] = scale * (coarse ? random.nextInt(-8, 9) / 4.0 : random.nextDouble(-2, 2));
        }
        if (planar) {
            way[1] = 0;
        }
        int variant = random.nextInt(6);
        if (variant == 0) {
            Arrays.fill(way, 0);
            way[2 * random.nextInt(2)] = scale;
        }
        if (variant == 1) {
            across(way);
        }
        if (variant < 5) {
            LeafRows.shift(kindA, a, -1, way);
            double far = variant % 2 == 0 ? 1 : 2;
            for (int k = 0; k < 3; k++) {
                way[k] *= far;
            }
        }
    }

    /** A ray at, along, past or out of a leaf. */
    void ray(LeafKind kind, boolean planar, SplittableRandom source) {
        begin(source);
        fill(kind, a);
        scaleAndMove(kind, a, kind, b);
        direction(kind, a, kind, a, planar);
        LeafRows.support(kind, a, n, p);
        for (int k = 0; k < 3; k++) {
            way[k] = coarse ? random.nextInt(-4, 5) : random.nextDouble(-1, 1);
        }
        if (random.nextInt(2) == 0) {
            across(way);
        }
        if (planar) {
            way[1] = 0;
        }
        if (way[0] == 0 && way[2] == 0) {
            way[0] = 1;
        }
        int variant = random.nextInt(5);
        double back = variant == 0 ? 0 : variant == 1 ? 1024 : random.nextInt(1, 9);
        for (int k = 0; k < 3; k++) {
            start[k] = p[k] - scale * back * way[k];
            start[k] += (random.nextInt(3) == 0 ? random.nextInt(-4, 5) : 0) * Math.ulp(p[k]);
            if (variant == 4) {
                way[k] = p[k] - start[k]; // straight at it, as far as doubles allow
            }
            if (variant == 3) {
                start[k] += scale * random.nextDouble(-1, 1);
            }
        }
        if (way[0] == 0 && way[2] == 0) {
            way[0] = scale;
        }
    }

    /** A leaf that all but touches the border of a world, whose sizes are left in the way. */
    void border(LeafKind kind, SplittableRandom source) {
        begin(source);
        fill(kind, a);
        scaleAndMove(kind, a, kind, b);
        int axis = random.nextInt(3);
        Arrays.fill(n, 0);
        n[axis] = a[axis] > 0 ? 1 : -1;
        LeafRows.support(kind, a, n, p);
        Arrays.fill(way, 0x1p60);
        double half = Math.abs(p[axis]);
        way[axis] = 2 * (half + random.nextInt(-3, 4) * Math.ulp(half));
    }

    /** The largest magnitude among the coordinates and sizes of two leaves, or of the first and a ray's start. */
    double size(LeafKind kindA, LeafKind kindB, boolean isRay) {
        double size = isRay ? Math.max(Math.abs(start[0]), Math.max(Math.abs(start[1]), Math.abs(start[2]))) : 0;
        for (int k = 0; k < LeafRows.places(kindA); k++) {
            size = Math.max(size, Math.abs(a[k]));
        }
        for (int k = 0; k < LeafRows.places(kindB) && !isRay; k++) {
            size = Math.max(size, Math.abs(b[k]));
        }
        return size;
    }

    /** The sum of the magnitudes of the coordinates and sizes of two leaves, and of the way. */
    double sum(LeafKind kindA, LeafKind kindB) {
        double sum = Math.abs(way[0]) + Math.abs(way[1]) + Math.abs(way[2]);
        for (int k = 0; k < 10; k++) {
            sum += (k < LeafRows.places(kindA) ? Math.abs(a[k]) : 0)
                    + (k < LeafRows.places(kindB) ? Math.abs(b[k]) : 0);
        }
        return sum;
    }

    /** How far apart the leaves are in space after a share of the way. */
    double gap(LeafKind kindA, LeafKind kindB, double share, Scratch scratch) {
        double[] moved = a.clone();
        LeafRows.shift(kindA, moved, share, way);
        return SpatialDistance.between(new Leaf(kindA, moved, 0), new Leaf(kindB, b, 0), scratch.distance);
    }

    private void begin(SplittableRandom source) {
        random = source;
        coarse = random.nextInt(3) == 0;
        scale = 1;
        LeafRows.set(n, 1, 0, 0); // what is not made to touch asks for a direction too, and not for the last question's
    }

    private double coordinate(double reach) {
        return coarse ? random.nextInt(-16, 17) / 8.0 : random.nextDouble(-reach, reach);
    }

    private double length() {
        if (random.nextInt(12) == 0) {
            return 0;
        }
        return coarse ? random.nextInt(1, 12) / 8.0 : random.nextDouble() * (random.nextInt(4) == 0 ? 0.01 : 1);
    }

    private double degrees() {
        int variant = random.nextInt(coarse ? 3 : 8);
        return variant < 2 ? 90 * random.nextInt(4) : variant == 2 ? 45 : random.nextDouble(-180, 180);
    }

    private void fill(LeafKind kind, double[] row) {
        Arrays.fill(row, 0);
        switch (kind) {
            case TRIANGLE -> triangle(row);
            case PRISM -> prism(row);
            default -> {
                for (int k = 0; k < 3; k++) {
                    row[k] = coordinate(1.5);
                    row[3 + k] = length();
                }
                if (kind == LeafKind.SPHERE || kind == LeafKind.UPRIGHT_CYLINDER) {
                    row[5] = 0;
                    row[4] = kind == LeafKind.SPHERE ? 0 : row[4];
                } else {
                    Rotations.yaw(degrees(), 0, row, Leaf.ROTATION);
                    if (kind != LeafKind.UPRIGHT_BOX) {
                        Rotations.turnOwnX(row, Leaf.ROTATION, random.nextDouble(1, 89));
                        Rotations.turnOwnY(row, Leaf.ROTATION, degrees());
                    }
                }
            }
        }
    }

    private void triangle(double[] row) {
        for (int k = 0; k < 9; k++) {
            row[k] = coordinate(1.5);
        }
        int variant = random.nextInt(10);
        if (variant == 0) {
            System.arraycopy(row, 0, row, 3, 3);
        } else if (variant == 1) {
            for (int k = 0; k < 3; k++) {
                row[6 + k] = (row[k] + row[3 + k]) / 2;
            }
        } else if (variant == 2) {
            row[1] = row[4] = row[7];
        }
    }

    private void prism(double[] row) {
        for (int k = 0; k < 10; k += 2) {
            row[k] = Double.POSITIVE_INFINITY;
            row[k + 1] = Double.NEGATIVE_INFINITY;
        }
        for (int k = 0; k < 5; k++) {
            double x = coordinate(1);
            double z = coordinate(1);
            double[] reach = {x, z, x + z, x - z, coordinate(1)};
            for (int m = 0; m < 5; m++) {
                row[2 * m] = Math.min(row[2 * m], Math.nextDown(reach[m]));
                row[2 * m + 1] = Math.max(row[2 * m + 1], Math.nextUp(reach[m]));
            }
        }
    }

    // Gives both the same attitude, or nearly.
    private void align(LeafKind kindA, LeafKind kindB) {
        boolean turned = kindA == LeafKind.BOX || kindA == LeafKind.CYLINDER;
        if (turned && (kindB == LeafKind.BOX || kindB == LeafKind.CYLINDER)) {
            System.arraycopy(a, Leaf.ROTATION, b, Leaf.ROTATION, 9);
            if (random.nextBoolean()) {
                Rotations.turnOwnX(b, Leaf.ROTATION, StrictMath.pow(10, -random.nextInt(2, 16)));
            }
        } else if (kindA == LeafKind.UPRIGHT_BOX && kindB == LeafKind.UPRIGHT_BOX) {
            System.arraycopy(a, Leaf.ROTATION, b, Leaf.ROTATION, 9);
            if (random.nextBoolean()) {
                Rotations.turnOwnY(b, Leaf.ROTATION, StrictMath.pow(10, -random.nextInt(2, 16)));
            }
        }
    }

    private void scaleAndMove(LeafKind kindA, double[] first, LeafKind kindB, double[] second) {
        int variant = random.nextInt(10);
        scale = variant == 0 ? 0x1p-40 : variant == 1 ? 0x1p40 : 1;
        for (int k = 0; k < 10; k++) {
            first[k] *= k < LeafRows.places(kindA) ? scale : 1;
            second[k] *= k < LeafRows.places(kindB) ? scale : 1;
        }
        if (variant == 2) {
            double[] offset = {random.nextDouble(-1e6, 1e6), random.nextDouble(-1e3, 1e3), random.nextDouble(-1e9, 1e9)
            };
            LeafRows.shift(kindA, first, 1, offset);
            LeafRows.shift(kindB, second, 1, offset);
        }
    }

    /** Moves b so that the two touch along a direction, but for rounding, and aside by as much as may be. */
    private void touch(LeafKind kindA, LeafKind kindB, boolean planar) {
        direction(kindA, a, kindB, b, planar);
        LeafRows.support(kindA, a, n, p);
        for (int k = 0; k < 3; k++) {
            n[k] = -n[k];
        }
        LeafRows.support(kindB, b, n, q);
        double[] aside = new double[3];
        if (random.nextInt(4) > 0) {
            double reach = random.nextBoolean() ? 0.3 * scale : scale;
            for (int k = 0; k < 3; k++) {
                aside[k] = random.nextDouble(-reach, reach);
            }
            across(aside);
        }
        double[] by = new double[3];
        for (int k = 0; k < 3; k++) {
            by[k] = p[k] - q[k] + aside[k];
            if (random.nextInt(3) == 0) {
                by[k] += random.nextInt(-4, 5) * Math.ulp(Math.max(Math.abs(p[k]), Math.abs(b[k])));
            }
        }
        if (planar) {
            by[1] = 0;
        }
        LeafRows.shift(kindB, b, 1, by);
    }

    // Takes out of a vector what it has along n.
    private void across(double[] v) {
        double square = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
        double share = (v[0] * n[0] + v[1] * n[1] + v[2] * n[2]) / square;
        for (int k = 0; k < 3; k++) {
            v[k] -= share * n[k];
        }
    }

    // A direction of contact: a side's normal, across two edges, or anywhere.
    private void direction(LeafKind kindA, double[] first, LeafKind kindB, double[] second, boolean planar) {
        int variant = random.nextInt(5);
        double[] u = new double[3];
        double[] v = new double[3];
        axis(kindA, first, u);
        axis(kindB, second, v);
        if (variant == 0) {
            System.arraycopy(u, 0, n, 0, 3);
        } else if (variant == 1) {
            System.arraycopy(v, 0, n, 0, 3);
        } else if (variant < 4) {
            double[] other = planar ? new double[] {0, 1, 0} : v;
            LeafRows.cross(variant == 2 ? u : v, variant == 2 ? other : planar ? other : u, n);
        } else {
            anywhere(n);
        }
        if (planar) {
            n[1] = 0;
        }
        if (!(n[0] * n[0] + n[1] * n[1] + n[2] * n[2] > 1e-6)) {
            n[0] = 1;
            n[1] = 0;
            n[2] = 0;
        }
        int sign = random.nextBoolean() ? 1 : -1;
        double size = Math.sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
        for (int k = 0; k < 3; k++) {
            n[k] *= sign / size;
        }
    }

    private void anywhere(double[] v) {
        for (int k = 0; k < 3; k++) {
            v[k] = random.nextDouble(-1, 1);
        }
    }

    // An axis of a leaf: an edge or a side's normal.
    private void axis(LeafKind kind, double[] row, double[] v) {
        switch (kind) {
            case UPRIGHT_BOX, BOX -> {
                int k = Leaf.ROTATION + random.nextInt(3);
                LeafRows.set(v, row[k], row[k + 3], row[k + 6]);
            }
            case CYLINDER -> {
                if (random.nextBoolean()) {
                    LeafRows.set(v, row[7], row[10], row[13]);
                } else {
                    double[] away = new double[3];
                    anywhere(away);
                    LeafRows.cross(new double[] {row[7], row[10], row[13]}, away, v);
                }
            }
            case TRIANGLE -> {
                double[] e = new double[3];
                double[] f = new double[3];
                int k = 3 * random.nextInt(3);
                for (int m = 0; m < 3; m++) {
                    e[m] = row[(k + 3) % 9 + m] - row[k + m];
                    f[m] = row[(k + 6) % 9 + m] - row[k + m];
                }
                if (random.nextBoolean()) {
                    System.arraycopy(e, 0, v, 0, 3);
                } else {
                    LeafRows.cross(e, f, v);
                }
            }
            case SPHERE -> anywhere(v);
            default -> {
                if (random.nextBoolean()) {
                    LeafRows.set(v, 0, 1, 0);
                } else {
                    anywhere(v);
                    v[1] = 0;
                }
            }
        }
        double size = Math.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
        if (size > 0) {
            LeafRows.set(v, v[0] / size, v[1] / size, v[2] / size);
        }
    }
}
