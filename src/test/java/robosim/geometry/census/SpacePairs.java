package robosim.geometry.census;

import java.util.SplittableRandom;

/** Pairs of bodies in space: anywhere, or with features of a kind facing each other across a gap of a size. */
final class SpacePairs {
    private static final double[] UP = {0, 1, 0};

    private final SplittableRandom random;

    /** Whether sizes may be small beside others. */
    private final boolean thin;

    Body a;
    Body b;

    /** The direction from a to b across which they face each other. */
    double[] n = {};

    SpacePairs(SplittableRandom random, boolean thin) {
        this.random = random;
        this.thin = thin;
    }

    /** Both anywhere. */
    void apart(Body.Type typeA, Body.Type typeB) {
        a = any(typeA);
        b = any(typeB);
        double[] way = Vec.direction(random);
        b = b.movedBy(Vec.plus(new double[3], random.nextDouble(0, 2) * (a.size() + b.size()), way));
    }

    /**
     * Features of some dimension in front of each other: 0 a corner or a rim, 1 an edge or a mantle, 2 a face or a cap.
     *
     * @param gap as a share of the sizes
     */
    void facing(Body.Type typeA, int featureA, Body.Type typeB, int featureB, double gap) {
        if (canStand(typeA) && canStand(typeB) && random.nextInt(8) == 0) {
            n = random.nextInt(3) == 0 ? UP : level();
            a = upright(typeA, n);
            b = upright(typeB, n);
        } else {
            boolean upright = random.nextInt(4) == 0 && canStand(typeA);
            n = upright ? normalOfUpright(featureA) : Vec.direction(random);
            a = upright ? upright(typeA, n) : turned(typeA, featureA, n);
            b = turned(typeB, featureB, Vec.plus(new double[3], -1, n));
        }
        double[] back = Vec.plus(new double[3], -1, n);
        double[] from = a.furthest(n, random);
        double[] to = b.furthest(back, random);
        b = b.movedBy(Vec.plus(Vec.minus(from, to), gap * (a.size() + b.size()), n));
    }

    /** One body near the origin with such a feature in front along n. */
    Body showing(Body.Type type, int feature, double[] n) {
        return turned(type, feature, n);
    }

    private static boolean canStand(Body.Type type) {
        return type == Body.Type.BOX || type == Body.Type.CYLINDER || type == Body.Type.CAPSULE;
    }

    private double[] level() {
        double angle = random.nextDouble(0, 2 * Math.PI);
        return new double[] {StrictMath.cos(angle), 0, StrictMath.sin(angle)};
    }

    /** A direction in which something upright has such a feature in front. */
    private double[] normalOfUpright(int feature) {
        return switch (feature) {
            case 0 -> Vec.direction(random);
            case 1 -> level();
            default -> UP;
        };
    }

    private Body any(Body.Type type) {
        double[] n = Vec.direction(random);
        return random.nextBoolean() ? upright(type, n) : turned(type, 0, n);
    }

    /** Upright where its type can be; one in two boxes has a side in front along n where that is level. */
    private Body upright(Body.Type type, double[] n) {
        double[] ahead = n[1] == 0 && random.nextBoolean() ? n : level();
        double[] r = {ahead[0], 0, -ahead[2], 0, 1, 0, ahead[2], 0, ahead[0]};
        double[] origin = new double[3];
        return switch (type) {
            case BOX -> Body.box(origin, new double[] {length(), length(), length()}, r, true);
            case CYLINDER -> Body.cylinder(origin, length(), length(), new double[] {1, 0, 0, 0, 1, 0, 0, 0, 1}, true);
            case CAPSULE -> Body.capsule(origin, length(), length(), new double[] {1, 0, 0, 0, 1, 0, 0, 0, 1}, true);
            default -> turned(type, random.nextInt(3), n);
        };
    }

    /** With a feature in front along n. */
    private Body turned(Body.Type type, int feature, double[] n) {
        double[] other = Vec.direction(random);
        double[] origin = new double[3];
        double[] across = Vec.unit(Vec.squareTo(n, other));
        double[] r = switch (feature) {
            case 0 -> Vec.rotation(other, Vec.direction(random));
            case 1 -> Vec.rotation(across, Vec.direction(random));
            default -> Vec.rotation(n, other);
        };
        return switch (type) {
            case BOX ->
                Body.box(
                        origin,
                        new double[] {length(), length(), length()},
                        Vec.turnedRound(r, random.nextInt(3)),
                        false);
            // The axis is its second column.
            case CYLINDER -> Body.cylinder(origin, length(), length(), Vec.turnedRound(r, 1), false);
            case CAPSULE -> Body.capsule(origin, length(), length(), Vec.turnedRound(r, 1), false);
            case SPHERE -> Body.sphere(origin, length());
            case TRIANGLE -> triangle(feature, n, across);
        };
    }

    /** A corner, an edge or the whole of it is furthest along n. */
    private Body triangle(int feature, double[] n, double[] across) {
        double[] side = Vec.cross(n, across);
        double low = feature == 2 ? 0 : 1;
        double tilt = feature == 0 ? random.nextDouble(0.1, 1) : 0;
        double[] p = Vec.plus(Vec.plus(new double[3], 1, across), -tilt, n);
        double[] q = Vec.plus(
                Vec.plus(Vec.plus(new double[3], random.nextDouble(-0.3, 1.3), across), 1, side),
                -low * random.nextDouble(0.1, 1),
                n);
        double lengthP = length();
        double lengthQ = length();
        double[] corners = new double[9];
        for (int k = 0; k < 3; k++) {
            corners[3 + k] = lengthP * p[k];
            corners[6 + k] = lengthQ * q[k];
        }
        return Body.triangle(corners);
    }

    private double length() {
        return thin && random.nextInt(4) == 0
                ? StrictMath.pow(10, random.nextDouble(-5, 0))
                : random.nextDouble(0.2, 1.2);
    }
}
