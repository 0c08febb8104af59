package robosim.geometry.narrow.packet;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CapsuleObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;
import robosim.geometry.narrow.Cast;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.leaf.LocalLeaves;

/** What the sieve says of a leaf against the kernel that is asked for each ray. */
class RayPacketTest {
    private final SplittableRandom random = new SplittableRandom(64);
    private final RayPacket packet = new RayPacket();
    private final Cast cast = new Cast(new Scratch());
    private final double[] directions = new double[3 * RayPacket.MOST];

    private double ox;
    private double oy;
    private double oz;

    /** Whether all rays stay at one height. */
    private boolean isLevel;

    // Of all rays: those that were passed over, those that were sure, and those that were left to the kernel.
    private int passed;
    private int sure;
    private int left;

    private double any(double within) {
        return random.nextDouble(-within, within);
    }

    private double dyadic(double within) {
        return Math.rint(8 * any(within)) / 8;
    }

    private GeometryObject solid(int kind, boolean isOnGrid) {
        double a = isOnGrid ? random.nextInt(9) / 8.0 : random.nextDouble(0.1, 1);
        double b = isOnGrid ? random.nextInt(9) / 8.0 : random.nextDouble(0.1, 1);
        double c = isOnGrid ? random.nextInt(9) / 8.0 : random.nextDouble(0.1, 1);
        Point center = isOnGrid ? new Point(dyadic(3), dyadic(3), dyadic(3)) : new Point(any(3), any(3), any(3));
        GeometryObject solid = switch (kind) {
            case 0 -> new BoxObject(center, 2 * a, 2 * b, 2 * c);
            case 1 -> new CylinderObject(center, a, 2 * b);
            case 2 -> new SphereObject(center, a);
            default -> new CapsuleObject(center, a, 2 * b);
        };
        return switch (random.nextInt(4)) {
            case 0 -> solid;
            case 1 -> solid.turned(0, isOnGrid ? 45 : any(180));
            case 2 -> solid.turned(90, 0);
            default -> solid.turned(any(180), any(180));
        };
    }

    /** Rays from a place towards and about another one, those on the grid with components that are 0 or equal. */
    private void aim(boolean isOnGrid, double scale, int count, Point target) {
        double x = isOnGrid ? dyadic(3) : any(3);
        double y = isOnGrid ? dyadic(3) : any(3);
        double z = isOnGrid ? dyadic(3) : any(3);
        for (int k = 0; k < count; k++) {
            double dx = target.x() - x + (isOnGrid ? dyadic(1) : any(0.8));
            double dy = isLevel ? 0 : target.y() - y + (isOnGrid ? dyadic(1) : any(0.8));
            double dz = target.z() - z + (isOnGrid ? dyadic(1) : any(0.8));
            boolean isNone = dx == 0 && dy == 0 && dz == 0;
            double length = random.nextInt(3) == 0 ? 1 / Math.sqrt(dx * dx + dy * dy + dz * dz) : 1;
            directions[3 * k] = isNone ? 1 : dx * length;
            directions[3 * k + 1] = dy * (isNone ? 1 : length);
            directions[3 * k + 2] = dz * (isNone ? 1 : length);
        }
        ox = scale * x;
        oy = scale * y;
        oz = scale * z;
        packet.aim(ox, oy, oz, directions, 0, count);
    }

    private static GeometryObject scaled(GeometryObject object, double scale) {
        Point c = object.center();
        Point center = new Point(scale * c.x(), scale * c.y(), scale * c.z());
        GeometryObject larger = object;
        if (object instanceof BoxObject box) {
            larger = new BoxObject(center, scale * box.width(), scale * box.height(), scale * box.length());
        } else if (object instanceof CylinderObject one) {
            larger = new CylinderObject(center, scale * one.radius(), scale * one.height());
        } else if (object instanceof SphereObject one) {
            larger = new SphereObject(center, scale * one.radius());
        }
        return larger.oriented(object.rotation());
    }

    @ParameterizedTest
    @CsvSource({"false, 0", "true, 0", "false, -60", "true, 60", "false, -200", "true, -95"})
    void isNeverWrong(boolean isOnGrid, int power) {
        double scale = Math.scalb(1.0, power);
        sift(isOnGrid, scale);
        int all = passed + sure + left;
        if (scale > 0x1p-100) {
            assertThat(passed).as("passed over of " + all).isGreaterThan(all / 5);
            assertThat(sure).as("sure of " + all).isGreaterThan(all / 5);
            assertThat(left).as("left of " + all).isBetween(all / 1000, all / 4);
        } else {
            assertThat(left).isEqualTo(all);
        }
    }

    /** Level rays, of which all or none are within the heights of what is upright. */
    @ParameterizedTest
    @CsvSource({"false, 0", "true, 0", "true, 60"})
    void isNeverWrongAtOneHeight(boolean isOnGrid, int power) {
        isLevel = true;
        sift(isOnGrid, Math.scalb(1.0, power));
        int all = passed + sure + left;
        assertThat(passed).as("passed over of " + all).isGreaterThan(all / 2);
        assertThat(sure).as("sure of " + all).isGreaterThan(all / 20);
        assertThat(left).as("left of " + all).isBetween(all / 1000, all / 4);
    }

    private void sift(boolean isOnGrid, double scale) {
        passed = 0;
        sure = 0;
        left = 0;
        for (int round = 0; round < 6000; round++) {
            int count = random.nextInt(4) == 0 ? random.nextInt(1, RayPacket.MOST + 1) : RayPacket.MOST;
            GeometryObject solid = solid(random.nextInt(3), isOnGrid);
            aim(isOnGrid, scale, count, solid.center());
            LeafColumn column = LocalLeaves.placed(scaled(solid, scale));
            packet.look(random.nextBoolean() ? Double.POSITIVE_INFINITY : scale * random.nextDouble(5));
            assertRight(column, count);
        }
    }

    private void assertRight(LeafColumn column, int count) {
        long met = packet.sift(column, 0);
        assertThat(met & ~packet.rays()).isZero();
        for (int ray = 0; ray < count; ray++) {
            cast.line(
                    Dimension.SPATIAL,
                    ox,
                    oy,
                    oz,
                    directions[3 * ray],
                    directions[3 * ray + 1],
                    directions[3 * ray + 2]);
            double distance = cast.distance(column, 0, Double.POSITIVE_INFINITY);
            if ((met >>> ray & 1) == 0) {
                passed++;
                if (distance < Double.POSITIVE_INFINITY && distance <= packet.near(ray)) {
                    throw new AssertionError(paste("passed over", column, ray, distance));
                }
            } else if (packet.isSure(ray)) {
                sure++;
                if (!(packet.low(ray) > 0 && packet.low(ray) <= distance && distance <= packet.high(ray))) {
                    throw new AssertionError(
                            paste("between " + packet.low(ray) + " and " + packet.high(ray), column, ray, distance));
                }
            } else {
                left++;
            }
        }
    }

    private String paste(String what, LeafColumn column, int ray, double distance) {
        return "%s at %s: %s from %s %s %s towards %s %s %s, leaf %s"
                .formatted(
                        what,
                        distance,
                        column.kind(0),
                        ox,
                        oy,
                        oz,
                        directions[3 * ray],
                        directions[3 * ray + 1],
                        directions[3 * ray + 2],
                        Arrays.toString(column.rows(0)));
    }

    /** A box that a leaf fills is met by each ray that meets the leaf. */
    @Test
    void boxesRejectNothingInThem() {
        double[] bounds = new double[6];
        int met = 0;
        int apart = 0;
        for (int round = 0; round < 6000; round++) {
            boolean isOnGrid = round % 2 == 0;
            GeometryObject solid = solid(random.nextInt(4), isOnGrid);
            aim(isOnGrid, 1, RayPacket.MOST, solid.center());
            LeafColumn column = LocalLeaves.placed(solid);
            column.bounds(0, bounds);
            double limit = random.nextDouble(6);
            packet.look(limit);
            long rays = packet.box(bounds, 0);
            for (int ray = 0; ray < RayPacket.MOST; ray++) {
                cast.line(
                        Dimension.SPATIAL,
                        ox,
                        oy,
                        oz,
                        directions[3 * ray],
                        directions[3 * ray + 1],
                        directions[3 * ray + 2]);
                boolean isMet = cast.distance(column, 0, Double.POSITIVE_INFINITY) <= limit;
                met += isMet ? 1 : 0;
                apart += (rays >>> ray & 1) == 0 ? 1 : 0;
                assertThat(isMet && (rays >>> ray & 1) == 0).isFalse();
            }
        }
        assertThat(met).as("met").isGreaterThan(10_000);
        assertThat(apart).as("apart").isGreaterThan(50_000);
    }

    /** A ray that looks less far passes over what is beyond. */
    @Test
    void looksNoFartherThanItMust() {
        directions[0] = 1;
        packet.aim(0, 0, 0, directions, 0, 1);
        packet.look(100);
        assertThat(packet.rays()).isEqualTo(1);
        assertThat(packet.reach()).isEqualTo(100);
        LeafColumn box = LocalLeaves.placed(new BoxObject(new Point(6, 0, 0), 2, 2, 2));
        assertThat(packet.sift(box, 0)).isEqualTo(1);
        assertThat(packet.isSure(0)).isTrue();
        assertThat(packet.low(0)).isBetween(4.99999, 5.0);
        assertThat(packet.high(0)).isBetween(5.0, 5.00001);
        packet.shorten(0, 4);
        assertThat(packet.near(0)).isEqualTo(4);
        assertThat(packet.sift(box, 0)).isZero();
        assertThat(packet.reach()).isEqualTo(4);
        LeafColumn around = LocalLeaves.placed(new SphereObject(new Point(0.5, 0, 0), 2));
        assertThat(packet.sift(around, 0)).isEqualTo(1);
        assertThat(packet.isSure(0)).isFalse();
    }

    @Test
    void knowsWhatItTells() {
        assertThat(RayPacket.knows(LeafKind.CYLINDER)).isTrue();
        assertThat(RayPacket.knows(LeafKind.CAPSULE)).isFalse();
        directions[0] = 1;
        packet.aim(0, 0, 0, directions, 0, 1);
        packet.look(1);
        LeafColumn capsule = LocalLeaves.placed(new CapsuleObject(new Point(60, 50, 0), 0.5, 2));
        assertThat(packet.sift(capsule, 0)).isEqualTo(packet.rays());
    }
}
