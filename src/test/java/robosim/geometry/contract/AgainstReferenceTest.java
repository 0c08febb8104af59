package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigDecimal;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.Effort;
import robosim.geometry.Geometry;
import robosim.geometry.collision.CollisionDetection;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;
import robosim.geometry.model.SphereObject;
import robosim.geometry.reference.Gaps;
import robosim.geometry.reference.Reference;

/** Verdicts and distances as they are in exact arithmetic, apart, in touch and an ulp from it. */
class AgainstReferenceTest {
    private static final double INFINITE = Double.POSITIVE_INFINITY;

    private static Geometry world(Dimension dimension, GeometryObject object) {
        Geometry world = new Geometry(1000, 1000, 1000, dimension, Accuracy.EXACT);
        assertThat(world.addObjectUnchecked(object)).isTrue();
        return world;
    }

    private static boolean check(GeometryObject a, GeometryObject b, Dimension dimension) {
        boolean truth = Reference.overlap(a, b, dimension);
        String pair = dimension + " " + text(a) + " | " + text(b);
        if (!truth && isCertified(a, b, dimension) && world(dimension, a).testObject(b)) {
            assertThat(Gaps.distance(a, b, dimension).doubleValue()).as(pair).isLessThan(0x1p-44);
            truth = true;
        }
        assertThat(world(dimension, a).testObject(b)).as(pair).isEqualTo(truth);
        assertThat(world(dimension, b).testObject(a)).as(pair + ", swapped").isEqualTo(truth);
        if (dimension == Dimension.SPATIAL) {
            assertThat(CollisionDetection.intersects(a, b)).as(pair).isEqualTo(truth);
        }
        return truth;
    }

    /** Whether a near miss may be told as a touch: ovals in the plane, and in space a capsule and a cylinder. */
    private static boolean isCertified(GeometryObject a, GeometryObject b, Dimension dimension) {
        if (dimension == Dimension.PLANAR) {
            return isOval(a) || isOval(b);
        }
        return (isOval(a) && hasCylinder(b)) || (isOval(b) && hasCylinder(a));
    }

    private static boolean isOval(GeometryObject object) {
        return object.kind() == GeometryObject.Kind.CAPSULE;
    }

    private static boolean hasCylinder(GeometryObject object) {
        return object.kind() == GeometryObject.Kind.CYLINDER || object.kind() == GeometryObject.Kind.GROUP;
    }

    private static String text(GeometryObject object) {
        return object.kind() == GeometryObject.Kind.MESH
                ? object + " " + ((robosim.geometry.model.MeshObject) object).vertices()
                : object.toString();
    }

    @ParameterizedTest
    @EnumSource(Dimension.class)
    void pairsAtRandom(Dimension dimension) {
        RandomObjects objects = new RandomObjects(new SplittableRandom(11), 1.2);
        int count = Effort.cases(1000);
        int hits = 0;
        for (int k = 0; k < count; k++) {
            hits += check(objects.plain(), objects.plain(), dimension) ? 1 : 0;
        }
        assertThat(hits).isBetween(count * 3 / 10, count * 8 / 10);
    }

    /** The last place along X at which two things still touch, found by halving, and its neighbours. */
    @ParameterizedTest
    @EnumSource(Dimension.class)
    void pairsWithinUlpsOfContact(Dimension dimension) {
        RandomObjects objects = new RandomObjects(new SplittableRandom(12), 0.6);
        int met = 0;
        int count = Effort.cases(100, 40);
        for (int k = 0; k < count; k++) {
            GeometryObject a = objects.plain();
            GeometryObject b = objects.plain();
            if (a.kind() == GeometryObject.Kind.GROUP) {
                continue;
            }
            double in = a.center().x();
            double out = in + 8;
            if (!Reference.overlap(a, b, dimension)) {
                continue;
            }
            while (Math.nextUp(in) < out) {
                double middle = in + (out - in) / 2;
                // Asked of the product, which is quicker; whether that is the place, the reference says below.
                if (world(dimension, b).testObject(at(a, middle))) {
                    in = middle;
                } else {
                    out = middle;
                }
            }
            assertThat(check(at(a, in), b, dimension)).isTrue();
            assertThat(check(at(a, out), b, dimension)).isFalse();
            check(at(a, Math.nextDown(in)), b, dimension);
            check(at(a, Math.nextUp(out)), b, dimension);
            met++;
        }
        assertThat(met).isGreaterThan(count / 4);
    }

    private static GeometryObject at(GeometryObject object, double x) {
        return object.movedTo(new Point(x, object.center().y(), object.center().z()));
    }

    @ParameterizedTest
    @EnumSource(Dimension.class)
    void exactContacts(Dimension dimension) {
        int[][] whole = {{3, 0, 4, 5}, {0, 0, 5, 5}, {4, 0, -3, 5}, {-5, 0, 12, 13}, {8, 0, 15, 17}, {2, 0, 0, 2}};
        int[][] inSpace = {{1, 2, 2, 3}, {2, 3, 6, 7}, {-4, 4, 7, 9}, {6, -6, 7, 11}};
        for (double unit : new double[] {1, 0x1p-3, 0x1p-30, 0x1p-200, 0x1p30}) {
            double size = 1000 * Math.max(1, unit);
            for (int[] w : whole) {
                contacts(dimension, w, unit, size);
            }
            if (dimension == Dimension.SPATIAL) {
                for (int[] w : inSpace) {
                    contacts(dimension, w, unit, size);
                }
            }
        }
    }

    private static void contacts(Dimension dimension, int[] w, double unit, double size) {
        Point apart = new Point(w[0] * unit, w[1] * unit, w[2] * unit);
        double length = w[3] * unit;
        SphereObject ball = new SphereObject(new Point(), length - unit);
        touching(dimension, ball, new SphereObject(apart, unit), size);
        touching(dimension, new SphereObject(new Point(), length), new SphereObject(apart, 0), size);
        // A box whose corner is there, and which lies beyond it.
        Point beyond = new Point(
                apart.x() + Math.signum(apart.x()) * unit,
                apart.y() + Math.signum(apart.y()) * unit,
                apart.z() + Math.signum(apart.z()) * unit);
        BoxObject box = new BoxObject(beyond, 2 * unit, 2 * unit, 2 * unit);
        touching(dimension, new SphereObject(new Point(), length), box, size);
        touching(dimension, new SphereObject(new Point(), length), RandomObjects.surfaceOf(box), size);
        if (w[1] == 0) {
            touching(dimension, new CylinderObject(new Point(), length, unit), box, size);
            touching(dimension, new CylinderObject(new Point(), length, unit), RandomObjects.surfaceOf(box), size);
            touching(
                    dimension,
                    new CylinderObject(new Point(), length - unit, unit),
                    new CylinderObject(apart, unit, unit),
                    size);
        }
        BoxObject twin =
                new BoxObject(apart, Math.abs(w[0]) * unit, 2 * Math.abs(w[1]) * unit + unit, Math.abs(w[2]) * unit);
        touching(dimension, new BoxObject(new Point(), Math.abs(w[0]) * unit, unit, Math.abs(w[2]) * unit), twin, size);
    }

    private static void touching(Dimension dimension, GeometryObject a, GeometryObject b, double size) {
        String pair = dimension + " " + a + " | " + b;
        Geometry world = new Geometry(size, size, size, dimension, Accuracy.EXACT);
        assertThat(world.addObjectUnchecked(a)).isTrue();
        assertThat(world.testObject(b)).as(pair).isTrue();
        assertThat(Reference.overlap(a, b, dimension)).as(pair).isTrue();
        Point c = b.center();
        for (Point near : List.of(
                new Point(Math.nextUp(c.x()), c.y(), c.z()),
                new Point(Math.nextDown(c.x()), c.y(), c.z()),
                new Point(c.x(), c.y(), Math.nextUp(c.z())),
                new Point(c.x(), c.y(), Math.nextDown(c.z())))) {
            GeometryObject moved = b.movedTo(near);
            assertThat(world.testObject(moved))
                    .as(pair + " moved to " + near)
                    .isEqualTo(Reference.overlap(a, moved, dimension));
        }
    }

    @ParameterizedTest
    @EnumSource(Dimension.class)
    void raysAtRandom(Dimension dimension) {
        SplittableRandom random = new SplittableRandom(13);
        RandomObjects objects = new RandomObjects(random, 1);
        RandomObjects starts = new RandomObjects(random, 4);
        int count = Effort.cases(2000);
        int hits = 0;
        for (int k = 0; k < count; k++) {
            GeometryObject object = objects.plain();
            Point start = starts.place();
            Point aim = random.nextInt(3) == 0 ? corner(object, random) : objects.place();
            Point direction = k % 5 == 0
                    ? objects.direction()
                    : new Point(aim.x() - start.x(), aim.y() - start.y(), aim.z() - start.z());
            if (direction.x() == 0 && direction.z() == 0) {
                continue;
            }
            hits += check(new Ray(start, direction), object, dimension) ? 1 : 0;
        }
        assertThat(hits).isBetween(count * 3 / 10, count * 8 / 10);
    }

    private static Point corner(GeometryObject object, SplittableRandom random) {
        if (object instanceof robosim.geometry.model.MeshObject mesh) {
            Point own = mesh.vertices().get(random.nextInt(mesh.vertices().size()));
            double[] r = mesh.rotation();
            return new Point(
                    r[0] * own.x()
                            + r[1] * own.y()
                            + r[2] * own.z()
                            + mesh.center().x(),
                    r[3] * own.x()
                            + r[4] * own.y()
                            + r[5] * own.z()
                            + mesh.center().y(),
                    r[6] * own.x()
                            + r[7] * own.y()
                            + r[8] * own.z()
                            + mesh.center().z());
        }
        return object.center();
    }

    private static boolean check(Ray ray, GeometryObject object, Dimension dimension) {
        BigDecimal truth = Reference.distance(ray, object, dimension);
        double answer = world(dimension, object).getRayDistance(ray, 0, INFINITE, 0);
        String what = dimension + " " + ray + " on " + text(object);
        if (dimension == Dimension.SPATIAL) {
            assertThat(CollisionDetection.rayDistance(ray, object)).as(what).isEqualTo(answer);
        }
        if (truth == null) {
            assertThat(answer).as(what).isEqualTo(INFINITE);
            return false;
        }
        double scale = Math.max(truth.doubleValue(), Math.max(size(ray.start()), size(object.center()) + 2));
        assertThat(answer).as(what + ": " + truth).isFinite();
        assertThat(new BigDecimal(answer).subtract(truth).abs().doubleValue())
                .as(what + ": " + answer + " for " + truth)
                .isLessThanOrEqualTo(4 * Math.ulp(scale));
        if (truth.signum() == 0) {
            assertThat(answer).as(what).isEqualTo(0);
        }
        return true;
    }

    private static double size(Point p) {
        return Math.max(Math.abs(p.x()), Math.max(Math.abs(p.y()), Math.abs(p.z())));
    }
}
