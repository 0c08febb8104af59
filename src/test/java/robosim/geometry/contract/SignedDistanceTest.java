package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.math.BigDecimal;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.Effort;
import robosim.geometry.collision.Budget;
import robosim.geometry.collision.Certainty;
import robosim.geometry.collision.CollisionDetection;
import robosim.geometry.collision.ContactQuery;
import robosim.geometry.collision.SignedDistance;
import robosim.geometry.collision.Verdict;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GeometryObject.Kind;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;
import robosim.geometry.reference.SignedTruth;

/** Signed distances against exact arithmetic: both ends of the bracket, the direction and the points. */
class SignedDistanceTest {
    /** What a direction may be off, times the sizes over the distance of the hulls. */
    private static final double OFF = 1e-13;

    private int apart;
    private int overlapping;
    private int unique;

    @Test
    void convexPairsAreWithinTheBracket() {
        SplittableRandom random = new SplittableRandom(7001);
        RandomObjects objects = new RandomObjects(random, 1.5, 1);
        int count = Effort.cases(800, 200);
        for (int n = 0; n < count; n++) {
            GeometryObject a = convex(objects, random);
            GeometryObject b = convex(objects, random);
            compare(a, b, Dimension.SPATIAL);
            compare(a, b, Dimension.PLANAR);
        }
        assertThat(apart).isGreaterThan(count / 3);
        assertThat(overlapping).isGreaterThan(count / 3);
        assertThat(unique).isGreaterThan(count);
    }

    @Test
    void uprightCylindersToo() {
        SplittableRandom random = new SplittableRandom(7002);
        RandomObjects objects = new RandomObjects(random, 1.2, 1);
        int count = Effort.cases(800, 200);
        for (int n = 0; n < count; n++) {
            GeometryObject a = prism(objects);
            GeometryObject b = prism(objects);
            compare(a, b, Dimension.SPATIAL);
            compare(a, b, Dimension.PLANAR);
        }
        assertThat(apart).isGreaterThan(count / 3);
        assertThat(overlapping).isGreaterThan(count / 3);
        assertThat(unique).isGreaterThan(count);
    }

    private static GeometryObject prism(RandomObjects objects) {
        GeometryObject object = objects.upright();
        return object.kind() == Kind.CYLINDER || object.kind() == Kind.BOX ? object : prism(objects);
    }

    private static GeometryObject convex(RandomObjects objects, SplittableRandom random) {
        if (random.nextInt(5) == 0) {
            return new MeshObject(List.of(objects.place(), objects.place(), objects.place()), new int[][] {{0, 1, 2}});
        }
        GeometryObject object = objects.primitive();
        return object.kind() == Kind.CYLINDER ? convex(objects, random) : object;
    }

    private void compare(GeometryObject a, GeometryObject b, Dimension dimension) {
        SignedDistance found = ContactQuery.signedDistance(a, b, dimension, Budget.UNLIMITED);
        SignedTruth truth = SignedTruth.of(a, b, dimension);
        String pair = "%s, %s %s: %s but %s"
                .formatted(a, b, dimension, found, truth.signed().doubleValue());
        assertThat(new BigDecimal(found.low())).as(pair).isLessThanOrEqualTo(truth.signed());
        assertThat(new BigDecimal(found.high())).as(pair).isGreaterThanOrEqualTo(truth.signed());
        assertThat(found.high() - found.low())
                .as(pair)
                .isLessThan(truth.signed().signum() > 0 ? 1e-12 : 1e-9);
        Verdict verdict = ContactQuery.decide(a, b, dimension, Budget.UNLIMITED);
        boolean touches = verdict.answer() == Verdict.Answer.YES;
        boolean isUncertain = touches && verdict.certainty() == Certainty.UNCERTAIN; // round, and closer than 2^-43
        assertThat(touches ? found.high() <= 0 || isUncertain : found.low() >= 0)
                .as(pair)
                .isTrue();
        apart += touches ? 0 : 1;
        overlapping += touches ? 1 : 0;
        direction(found, truth, dimension, pair);
        between(a, b, found, dimension, pair);
        SignedDistance swapped = ContactQuery.signedDistance(b, a, dimension, Budget.UNLIMITED);
        assertThat(swapped)
                .as(pair)
                .isEqualTo(new SignedDistance(
                        found.low(),
                        found.high(),
                        found.onB(),
                        found.onA(),
                        new Point(
                                0 - found.direction().x(),
                                0 - found.direction().y(),
                                0 - found.direction().z()),
                        found.steps()));
    }

    private void direction(SignedDistance found, SignedTruth truth, Dimension dimension, String pair) {
        double[] way = truth.direction();
        Point d = found.direction();
        assertThat(Math.sqrt(d.x() * d.x() + d.y() * d.y() + d.z() * d.z()))
                .as(pair)
                .isEqualTo(1, within(1e-15));
        if (way == null || (truth.apart() > 0 && truth.apart() < 1e-4)) {
            return;
        }
        unique++;
        double[] told = way.length == 2 ? new double[] {d.x(), d.z()} : new double[] {d.x(), d.y(), d.z()};
        double allowed = Math.min(1e-9, OFF * Math.max(1, 10 / Math.max(truth.apart(), 1e-4)));
        for (int k = 0; k < way.length; k++) {
            assertThat(told[k]).as(pair + dimension).isEqualTo(way[k], within(allowed));
        }
    }

    /** Each point belongs to its object, and the two are as far apart as stated, along the direction. */
    private static void between(
            GeometryObject a, GeometryObject b, SignedDistance found, Dimension dimension, String pair) {
        double signed = (found.low() + found.high()) / 2;
        Point d = found.direction();
        assertThat(found.onA().x() - found.onB().x()).as(pair).isEqualTo(signed * d.x(), within(1e-9));
        assertThat(found.onA().z() - found.onB().z()).as(pair).isEqualTo(signed * d.z(), within(1e-9));
        if (dimension == Dimension.SPATIAL) {
            assertThat(found.onA().y() - found.onB().y()).as(pair).isEqualTo(signed * d.y(), within(1e-9));
        }
        assertThat(off(found.onA(), a, dimension)).as(pair).isLessThan(1e-10);
        assertThat(off(found.onB(), b, dimension)).as(pair).isLessThan(1e-10);
    }

    private static double off(Point point, GeometryObject object, Dimension dimension) {
        return ContactQuery.distance(new SphereObject(point, 0), object, dimension, Budget.UNLIMITED)
                .high();
    }

    /** Of several pieces: no translation shorter than the upper end separates them, and one as long as the lower end does. */
    @Test
    void theWayOutOfGroupsAndMeshesSeparatesThem() {
        SplittableRandom random = new SplittableRandom(7003);
        RandomObjects objects = new RandomObjects(random, 1, 1);
        int deep = 0;
        for (int n = 0; n < Effort.cases(800, 200); n++) {
            GeometryObject a = objects.next();
            GeometryObject b = objects.next();
            SignedDistance found = ContactQuery.signedDistance(a, b);
            String pair = "%s, %s: %s".formatted(a, b, found);
            Verdict distance = ContactQuery.distance(a, b, Budget.UNLIMITED);
            if (distance.answer() == Verdict.Answer.NO) {
                assertThat(found.low()).as(pair).isBetween(distance.low() - 1e-12, distance.high());
                assertThat(found.high()).as(pair).isBetween(distance.low(), distance.high() + 1e-12);
                continue;
            }
            assertThat(found.high()).as(pair).isLessThanOrEqualTo(0x1p-40);
            assertThat(found.low()).as(pair).isLessThanOrEqualTo(found.high());
            if (found.high() < -1e-3) {
                deep++;
                for (int k = 0; k < 20; k++) {
                    GeometryObject moved = a.movedTo(shifted(a.center(), unit(random), -found.high() * 0.9999));
                    assertThat(CollisionDetection.intersects(moved, b)).as(pair).isTrue();
                }
            }
            assertThat(isSeparable(a, b, found)).as(pair).isTrue();
        }
        assertThat(deep).isGreaterThan(Effort.cases(800, 200) / 8);
    }

    /** Along the direction, or out of each other's boxes along an axis. */
    private static boolean isSeparable(GeometryObject a, GeometryObject b, SignedDistance found) {
        double way = -found.low() * (1 + 1e-9) + 1e-9;
        for (Point d : List.of(
                found.direction(),
                new Point(1, 0, 0),
                new Point(-1, 0, 0),
                new Point(0, 1, 0),
                new Point(0, -1, 0),
                new Point(0, 0, 1),
                new Point(0, 0, -1))) {
            if (!CollisionDetection.intersects(a.movedTo(shifted(a.center(), d, way)), b)) {
                return true;
            }
        }
        return false;
    }

    private static Point shifted(Point from, Point direction, double by) {
        return new Point(from.x() + by * direction.x(), from.y() + by * direction.y(), from.z() + by * direction.z());
    }

    private static Point unit(SplittableRandom random) {
        double x = random.nextDouble(-1, 1);
        double y = random.nextDouble(-1, 1);
        double z = random.nextDouble(-1, 1);
        double length = Math.sqrt(x * x + y * y + z * z);
        return length > 1 || length < 0.1 ? unit(random) : new Point(x / length, y / length, z / length);
    }

    /** A ball that goes through the surface of a solid mesh gets deeper all the time. */
    @Test
    void aSolidMeshIsAsDeepAsItsBox() {
        BoxObject box = new BoxObject(new Point(1, 2, 3), 4, 6, 8);
        MeshObject mesh = RandomObjects.meshOf(box);
        for (int k = 0; k < 40; k++) {
            double x = 3.5 - k * 0.05;
            SphereObject ball = new SphereObject(new Point(x, 2, 3), 0.25);
            SignedDistance found = ContactQuery.signedDistance(ball, mesh);
            assertThat(found.high()).as("at " + x).isEqualTo(x - 3 - 0.25, within(1e-12));
            assertThat(found.low()).as("at " + x).isEqualTo(x - 3 - 0.25, within(1e-12));
            assertThat(found.direction()).as("at " + x).isEqualTo(new Point(1, 0, 0));
            assertThat(found.onA().x()).isEqualTo(x - 0.25, within(1e-12));
            assertThat(found.onB().x()).isEqualTo(3, within(1e-12));
            SignedDistance swapped = ContactQuery.signedDistance(mesh, ball);
            assertThat(swapped.high()).isEqualTo(found.high());
            assertThat(swapped.direction()).isEqualTo(new Point(-1, 0, 0));
        }
    }

    /** After any number of steps the bracket holds what the last one holds. */
    @Test
    void aSpentBudgetLeavesATrueBracket() {
        SplittableRandom random = new SplittableRandom(7004);
        RandomObjects objects = new RandomObjects(random, 1.5, 1);
        for (int n = 0; n < 60; n++) {
            GeometryObject a = new ObjectGroup(List.of(objects.primitive(), objects.primitive(), objects.primitive()));
            GeometryObject b = new ObjectGroup(List.of(objects.primitive(), objects.primitive(), objects.primitive()));
            SignedDistance last = ContactQuery.signedDistance(a, b);
            double low = Double.NEGATIVE_INFINITY;
            double high = Double.POSITIVE_INFINITY;
            for (int steps = 0; steps <= last.steps(); steps++) {
                SignedDistance found = ContactQuery.signedDistance(a, b, Budget.steps(steps));
                String pair = "%s, %s after %d: %s, at last %s".formatted(a, b, steps, found, last);
                assertThat(found.low()).as(pair).isBetween(low, last.low());
                assertThat(found.high()).as(pair).isBetween(last.high(), high);
                low = found.low();
                high = found.high();
            }
        }
    }

    /** A tipped cylinder beside a box: the direction is good to half the digits, the bracket to all. */
    @Test
    void tippedCylindersAreWithinTheBracketOfTheirDistance() {
        SplittableRandom random = new SplittableRandom(7005);
        for (int n = 0; n < 200; n++) {
            double tilt = random.nextDouble(5, 85);
            CylinderObject rim = new CylinderObject(new Point(0, 3, 0), 0.5, 1).turned(tilt, random.nextDouble(360));
            BoxObject floor = new BoxObject(new Point(0, 0, 0), 20, 2, 20);
            SignedDistance found = ContactQuery.signedDistance(rim, floor);
            double down = 0.5 * Math.abs(rim.rotation()[4]) + 0.5 * Math.hypot(rim.rotation()[3], rim.rotation()[5]);
            assertThat(found.low()).isEqualTo(2 - down, within(1e-12));
            assertThat(found.high()).isEqualTo(2 - down, within(1e-12));
            assertThat(found.direction().y()).isEqualTo(1, within(1e-9));
            assertThat(found.direction().x()).isEqualTo(0, within(1e-6));
            SignedDistance deep = ContactQuery.signedDistance(rim.movedTo(new Point(0, 1.25, 0)), floor);
            assertThat(deep.low()).isEqualTo(0.25 - down, within(1e-9));
            assertThat(deep.high()).isEqualTo(0.25 - down, within(1e-9));
        }
    }
}
