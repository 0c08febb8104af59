package robosim.geometry.census;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.jspecify.annotations.Nullable;
import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.overlap.SpatialOverlap;
import robosim.geometry.narrow.sweep.SpatialSweep;
import robosim.geometry.proof.Witnesses;

/** Straight translations. */
final class SpatialWay extends SpatialMotion {
    private double[] way = {1, 0, 0};

    @Override
    public String name() {
        return "translation of a box, triangle, cylinder, sphere or capsule against another, in space";
    }

    @Override
    void draw(SplittableRandom random, boolean aimed, double contact) {
        double[] d = Vec.direction(random);
        if (aimed && contact > 0 && random.nextBoolean()) {
            d = Vec.unit(Vec.plus(d, -Vec.dot(d, normal), normal)); // tangent
        }
        double along = Vec.dot(d, normal);
        boolean against = contact >= 0;
        if (along > 0 == against && (contact <= 0 || random.nextInt(5) > 0)) {
            d = Vec.plus(new double[3], -1, d);
        }
        if (contact <= 0 && Math.abs(along) < 1e-3) {
            d = Vec.plus(new double[3], against ? -1 : 1, normal);
        }
        way = Vec.plus(new double[3], StrictMath.pow(10, random.nextDouble(-1, 1)), d);
    }

    @Override
    double[] turn(double share) {
        return new double[] {1, 0, 0, 0, 1, 0, 0, 0, 1};
    }

    @Override
    double[] shift(double share) {
        return Vec.plus(new double[3], share, way);
    }

    @Override
    double speed(double reach) {
        return Vec.length(way);
    }

    @Override
    double free() {
        return SpatialSweep.translation(
                new Leaf(kindA, a, 0), way[0], way[1], way[2], new Leaf(kindB, b, 0), scratch.sweep);
    }

    @Override
    public @Nullable String proof(Witnesses witnesses) {
        boolean touches = SpatialOverlap.test(new Leaf(kindA, a, 0), new Leaf(kindB, b, 0), scratch.overlap);
        return touches
                ? null
                : witnesses.translation(
                        Witnesses.object(kindA, a), way, Witnesses.object(kindB, b), Dimension.SPATIAL, free());
    }

    @Override
    double before() {
        return 1 - 1e-9;
    }

    @Override
    double bound(double reach, double sizes) {
        return 0x1p-42 * (sizes + Vec.length(way));
    }

    @Override
    String paste() {
        return "by " + Arrays.toString(way);
    }
}
