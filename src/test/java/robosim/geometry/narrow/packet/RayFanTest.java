package robosim.geometry.narrow.packet;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.narrow.Cast;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.LocalLeaves;

/** The rays of a fan that may meet a box against the kernel, which is asked for each ray. */
class RayFanTest {
    private static final int MOST = 64;

    private final SplittableRandom random = new SplittableRandom(39);
    private final RayFan fan = new RayFan();
    private final Cast cast = new Cast(new Scratch());
    private final double[] directions = new double[3 * MOST];
    private final double[] bounds = new double[6];

    /** Rays to one side of a first one, in order, some of which are equal. */
    private int aim(boolean isOnGrid, double ox, double oz) {
        int count = random.nextInt(3) == 0 ? random.nextInt(1, MOST + 1) : MOST;
        double from = isOnGrid ? 45 * random.nextInt(8) : random.nextDouble(360);
        double step = (random.nextBoolean() ? 1 : -1) * (isOnGrid ? 0.5 : random.nextDouble(1.8));
        for (int k = 0; k < count; k++) {
            double angle = StrictMath.toRadians(from + step * (random.nextInt(8) == 0 ? k & ~1 : k));
            boolean isUnit = random.nextBoolean();
            directions[3 * k] = (isUnit ? 1 : 4) * StrictMath.cos(angle);
            directions[3 * k + 1] = random.nextDouble();
            directions[3 * k + 2] = (isUnit ? 1 : 4) * StrictMath.sin(angle);
        }
        boolean isInOrder = true;
        for (int k = 1; k < count; k++) {
            double turn = directions[3 * k - 3] * directions[3 * k + 2] - directions[3 * k - 1] * directions[3 * k];
            isInOrder &= Math.signum(turn) * step >= 0;
        }
        return isInOrder && fan.aim(ox, oz, directions, 0, count) ? count : 0;
    }

    private GeometryObject object(boolean isOnGrid, double scale) {
        double width = scale * (isOnGrid ? random.nextInt(5) / 2.0 : Math.exp(random.nextDouble(-6, 2)));
        double length = scale * (isOnGrid ? random.nextInt(5) / 2.0 : Math.exp(random.nextDouble(-6, 2)));
        double x = scale * (isOnGrid ? random.nextInt(-6, 7) / 2.0 : random.nextDouble(-4, 4));
        double z = scale * (isOnGrid ? random.nextInt(-6, 7) / 2.0 : random.nextDouble(-4, 4));
        return random.nextBoolean()
                ? new CylinderObject(new Point(x, 0, z), width / 2, 1)
                : new BoxObject(new Point(x, 0, z), width, 1, length)
                        .turned(0, isOnGrid ? 45 * random.nextInt(4) : random.nextDouble(360));
    }

    /** Whether the middle of a box is before a line across the fan. */
    private boolean isAhead(Point middle, double ox, double oz) {
        return (middle.x() - ox) * fan.sector().ux()
                        + (middle.z() - oz) * fan.sector().uz()
                > 0;
    }

    @ParameterizedTest
    @CsvSource({"false, 0", "true, 0", "false, 60", "true, -100"})
    void leavesOutNoRayThatMeetsIt(boolean isOnGrid, int power) {
        double scale = Math.scalb(1.0, power);
        int fans = 0;
        int within = 0;
        int met = 0;
        int rays = 0;
        for (int round = 0; round < 4000; round++) {
            double ox = isOnGrid ? 0 : scale * random.nextDouble(-1, 1);
            double oz = isOnGrid ? 0 : scale * random.nextDouble(-1, 1);
            int count = aim(isOnGrid, ox, oz);
            GeometryObject object = object(isOnGrid, scale);
            LeafColumn column = LocalLeaves.placed(object);
            column.bounds(0, bounds);
            fans += count > 0 ? 1 : 0;
            boolean isMet = count > 0 && fan.find(bounds, 0, object instanceof CylinderObject);
            boolean isAhead = count > 0 && isAhead(object.center(), ox, oz);
            for (int ray = 0; ray < count; ray++) {
                cast.line(Dimension.PLANAR, ox, 0, oz, directions[3 * ray], 0, directions[3 * ray + 2]);
                double distance = cast.distance(column, 0, Double.POSITIVE_INFINITY);
                boolean isWithin = isMet && ray >= fan.first() && ray <= fan.last();
                rays++;
                within += isWithin && isAhead ? 1 : 0;
                met += distance < Double.POSITIVE_INFINITY ? 1 : 0;
                if (distance < Double.POSITIVE_INFINITY && !(isWithin && fan.nearest() <= distance)) {
                    throw new AssertionError("ray %d of %d from %s %s at %s meets %s, not %d to %d from %s on: %s"
                            .formatted(
                                    ray,
                                    count,
                                    ox,
                                    oz,
                                    distance,
                                    object,
                                    fan.first(),
                                    fan.last(),
                                    fan.nearest(),
                                    Arrays.toString(directions)));
                }
            }
        }
        assertThat(fans).isGreaterThan(1500);
        assertThat(met).as("met of " + rays).isBetween(rays / 20, rays / 2);
        assertThat(within).as("within, of which " + met + " are met").isLessThan(2 * met + rays / 5);
    }

    @Test
    void refusesWhatIsNoFan() {
        double[] wide = {1, 0, 0, -1, 0, 1};
        double[] mixed = {1, 0, 0.1, 1, 0, 0.3, 1, 0, 0.2};
        double[] ordered = {1, 0, 0.1, 1, 0, 0.2, 1, 0, 0.3};
        assertThat(fan.aim(0, 0, wide, 0, 2)).isFalse();
        assertThat(fan.aim(0, 0, mixed, 0, 3)).isFalse();
        assertThat(fan.aim(0, 0, ordered, 0, 3)).isTrue();
        assertThat(fan.count()).isEqualTo(3);
        assertThat(fan.aim(0, 0, ordered, 3, 2)).isTrue();
    }
}
