package robosim.geometry.census;

import java.util.Arrays;
import java.util.SplittableRandom;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.PivotTurn;
import robosim.geometry.narrow.sweep.SpatialSweep;

/** Turns about any axis through the origin. */
final class SpatialTurn extends SpatialMotion {
    private double[] axis = {0, 1, 0};
    private double degrees = 1;

    @Override
    public String name() {
        return "turn of a box, triangle, cylinder, sphere or capsule against another, in space";
    }

    @Override
    void draw(SplittableRandom random, boolean aimed, double contact) {
        axis = Vec.direction(random);
        if (aimed && contact > 0 && random.nextInt(5) > 1) {
            // Tangent: the velocity w x p has nothing of the normal.
            axis = Vec.unit(Vec.plus(
                    Vec.plus(new double[3], random.nextDouble(-1, 1), normal), random.nextDouble(-1, 1), point));
        }
        degrees = random.nextInt(4) == 0 ? random.nextDouble(5, 800) : random.nextDouble(5, 120);
        double along = Vec.dot(Vec.cross(axis, point), normal);
        // Against the normal at the contact, or with it where it starts there to go away.
        boolean against = contact >= 0;
        if (along > 0 == against && (contact <= 0 || random.nextInt(5) > 0)) {
            degrees = -degrees;
        }
        if (contact <= 0 && Math.abs(along) < 1e-3) {
            axis = Vec.unit(Vec.cross(point, normal));
            degrees = against ? -Math.abs(degrees) : Math.abs(degrees);
        }
    }

    @Override
    double[] turn(double share) {
        return Vec.turn(axis, share * degrees);
    }

    @Override
    double[] shift(double share) {
        return new double[3];
    }

    @Override
    double speed(double reach) {
        return reach * Math.toRadians(Math.abs(degrees));
    }

    @Override
    double free() {
        return SpatialSweep.turn(
                new Leaf(kindA, a, 0),
                new PivotTurn().about(origin[0], origin[1], origin[2]).by(axis[0], axis[1], axis[2], degrees),
                new Leaf(kindB, b, 0),
                scratch.sweep);
    }

    @Override
    double before() {
        return 1;
    }

    @Override
    double bound(double reach, double sizes) {
        return 0x1p-30 * reach + 0x1p-43 * sizes;
    }

    @Override
    String paste() {
        return "turned by " + degrees + " about " + Arrays.toString(axis);
    }
}
