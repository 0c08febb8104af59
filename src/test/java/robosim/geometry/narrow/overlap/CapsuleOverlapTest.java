package robosim.geometry.narrow.overlap;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.Effort;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CapsuleObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.distance.SpatialDistance;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.LocalLeaves;
import robosim.geometry.reference.Gaps;
import robosim.geometry.reference.Reference;

/** A capsule beside everything, against rational numbers: at random, in touch, an ulp from it, thin, tiny and far away. */
class CapsuleOverlapTest {
    /** What is beside the capsule. */
    private enum Other {
        BOX,
        TRIANGLE,
        SPHERE,
        CAPSULE,
        CYLINDER
    }

    private final Scratch scratch = new Scratch();

    @ParameterizedTest
    @EnumSource(Other.class)
    void agreesWithRationals(Other other) {
        SplittableRandom random = new SplittableRandom(41 + other.ordinal());
        int count = Effort.cases(240, 150);
        int hits = 0;
        int near = 0;
        int thin = 0;
        int doubtful = 0;
        for (int n = 0; n < count; n++) {
            boolean isGrid = n % 3 == 0;
            GeometryObject a = placed(capsule(random, isGrid), random, isGrid, false);
            GeometryObject b = placed(shape(other, random, isGrid), random, isGrid, other == Other.CYLINDER);
            if (n % 3 == 1) {
                if (random.nextInt(3) == 0) {
                    b = parallel(a, b, random);
                }
                a = nearly(a, b, random);
                near++;
            }
            thin += isThin(a) ? 1 : 0;
            if (n % 5 == 0) {
                int power = new int[] {-300, -1000, -30, 60}[random.nextInt(4)];
                a = scaled(a, power);
                b = scaled(b, power);
            }
            boolean truth = Reference.overlap(a, b, Dimension.SPATIAL);
            boolean answer = overlap(a, b);
            String pair = a + " | " + b;
            assertThat(overlap(b, a)).as(pair + ", swapped").isEqualTo(answer);
            if (other == Other.CYLINDER && answer && !truth) {
                double size = VectorSize.of(a, b);
                assertThat(Gaps.distance(a, b, Dimension.SPATIAL).doubleValue())
                        .as(pair)
                        .isLessThanOrEqualTo(0x1p-40 * size);
                doubtful++;
            } else {
                assertThat(answer).as(pair).isEqualTo(truth);
            }
            hits += answer ? 1 : 0;
        }
        assertThat(hits).isBetween(count * 15 / 100, count * 8 / 10);
        assertThat(near).isGreaterThan(count / 4);
        assertThat(thin).isGreaterThan(count / 15);
        assertThat(doubtful).isLessThan(count / 10);
    }

    /** The distance is never above the truth where it is a bracket's lower end, and off by no more than is said. */
    @ParameterizedTest
    @EnumSource(Other.class)
    void distancesAreAsTold(Other other) {
        SplittableRandom random = new SplittableRandom(61 + other.ordinal());
        int apart = 0;
        int count = Effort.cases(100, 40);
        for (int n = 0; n < count; n++) {
            boolean isGrid = n % 3 == 0;
            GeometryObject a = placed(capsule(random, isGrid), random, isGrid, false);
            GeometryObject b = placed(shape(other, random, isGrid), random, isGrid, other == Other.CYLINDER);
            double truth = Gaps.distance(a, b, Dimension.SPATIAL).doubleValue();
            double answer = distance(a, b);
            String pair = a + " | " + b;
            assertThat(distance(b, a)).as(pair).isEqualTo(answer);
            double slack = 0x1p-44 * truth + 0x1p-46 * VectorSize.of(a, b);
            assertThat(answer).as(pair).isBetween(truth - slack, truth + slack);
            apart += answer > 0 ? 1 : 0;
        }
        assertThat(apart).isBetween(count * 3 / 10, count * 95 / 100);
    }

    /** Pythagorean contacts, exact at any power of two. */
    @Test
    void wholeNumbersTouch() {
        for (double unit : new double[] {1, 0x1p-300, 0x1p60}) {
            CapsuleObject capsule = new CapsuleObject(new Point(), 5 * unit, 8 * unit);
            touches(capsule, new SphereObject(new Point(3 * unit, 4 * unit + 4 * unit, 0), 0), unit);
            touches(capsule, new SphereObject(new Point(6 * unit, 12 * unit, 0), 5 * unit), unit);
            touches(capsule, new CapsuleObject(new Point(6 * unit, 15 * unit, 0), 5 * unit, 6 * unit), unit);
            touches(
                    capsule,
                    new CapsuleObject(new Point(7 * unit, 0, 24 * unit), 20 * unit, 2 * unit).turned(90, 0),
                    unit);
            touches(capsule, new BoxObject(new Point(3.5 * unit, 8.5 * unit, 0), unit, unit, unit), unit);
            touches(capsule, new BoxObject(new Point(0, 9.5 * unit, 0), 9 * unit, unit, 9 * unit), unit);
            // By its side, along all of it.
            touches(capsule, new BoxObject(new Point(5.5 * unit, 0, 0), unit, 30 * unit, unit), unit);
            // Through the segment, with all of the surface far away.
            assertThat(overlap(capsule, new BoxObject(new Point(), 100 * unit, 0, 100 * unit)))
                    .isTrue();
            assertThat(overlap(capsule, new SphereObject(new Point(), 100 * unit)))
                    .isTrue();
        }
    }

    private void touches(GeometryObject a, GeometryObject b, double unit) {
        assertThat(Reference.overlap(a, b, Dimension.SPATIAL)).as(a + " | " + b).isTrue();
        assertThat(overlap(a, b)).as(a + " | " + b).isTrue();
        for (int axis = 0; axis < 3; axis++) {
            for (int side = -1; side <= 1; side += 2) {
                Point c = b.center();
                double step = side * 0x1p-50 * 8 * unit;
                GeometryObject moved = b.movedTo(new Point(
                        c.x() + (axis == 0 ? step : 0),
                        c.y() + (axis == 1 ? step : 0),
                        c.z() + (axis == 2 ? step : 0)));
                assertThat(overlap(a, moved))
                        .as(a + " | " + moved)
                        .isEqualTo(Reference.overlap(a, moved, Dimension.SPATIAL));
            }
        }
    }

    private boolean overlap(GeometryObject a, GeometryObject b) {
        LeafColumn one = LocalLeaves.placed(a);
        LeafColumn two = LocalLeaves.placed(b);
        if (two.kind(0).isMesh() || one.kind(0).isMesh()) {
            return robosim.geometry.collision.CollisionDetection.intersects(a, b);
        }
        return SpatialOverlap.test(
                new Leaf(one.kind(0), one.rows(), 0), new Leaf(two.kind(0), two.rows(), 0), scratch.overlap);
    }

    private double distance(GeometryObject a, GeometryObject b) {
        LeafColumn one = leaf(a);
        LeafColumn two = leaf(b);
        return SpatialDistance.between(
                new Leaf(one.kind(0), one.rows(), 0), new Leaf(two.kind(0), two.rows(), 0), scratch.distance);
    }

    private static LeafColumn leaf(GeometryObject object) {
        if (!(object instanceof MeshObject mesh)) {
            return LocalLeaves.placed(object);
        }
        LeafColumn leaf = new LeafColumn(1);
        leaf.append(1);
        for (int k = 0; k < 3; k++) {
            Point p = mesh.vertices().get(k);
            leaf.rows()[3 * k] = p.x();
            leaf.rows()[3 * k + 1] = p.y();
            leaf.rows()[3 * k + 2] = p.z();
        }
        leaf.setKind(0, robosim.geometry.narrow.leaf.LeafKind.TRIANGLE);
        return leaf;
    }

    private static boolean isThin(GeometryObject object) {
        return object instanceof CapsuleObject capsule && (capsule.radius() == 0 || capsule.segment() == 0);
    }

    private static double size(SplittableRandom random, boolean isGrid) {
        if (random.nextInt(8) == 0) {
            return random.nextBoolean() ? 0 : 0x1p-30;
        }
        return isGrid ? random.nextInt(1, 5) / 4.0 : random.nextDouble(0.05, 1);
    }

    private static CapsuleObject capsule(SplittableRandom random, boolean isGrid) {
        return new CapsuleObject(new Point(), size(random, isGrid), 2 * size(random, isGrid));
    }

    private static GeometryObject shape(Other other, SplittableRandom random, boolean isGrid) {
        double p = size(random, isGrid);
        double q = size(random, isGrid);
        return switch (other) {
            case BOX -> new BoxObject(new Point(), 2 * p, 2 * q, 2 * size(random, isGrid));
            case SPHERE -> new SphereObject(new Point(), p);
            case CAPSULE -> new CapsuleObject(new Point(), p, 2 * q);
            case CYLINDER -> new CylinderObject(new Point(), p, 2 * q);
            case TRIANGLE -> {
                List<Point> corners =
                        List.of(place(random, isGrid, 1), place(random, isGrid, 1), place(random, isGrid, 1));
                yield new MeshObject(corners, new int[][] {{0, 1, 2}});
            }
        };
    }

    private static Point place(SplittableRandom random, boolean isGrid, double spread) {
        return new Point(
                coordinate(random, isGrid, spread),
                coordinate(random, isGrid, spread),
                coordinate(random, isGrid, spread));
    }

    private static double coordinate(SplittableRandom random, boolean isGrid, double spread) {
        double any = random.nextDouble(-spread, spread);
        return isGrid ? Math.rint(4 * any) / 4 : any;
    }

    private static GeometryObject placed(
            GeometryObject shape, SplittableRandom random, boolean isGrid, boolean isUpright) {
        if (shape instanceof MeshObject) {
            return shape;
        }
        GeometryObject there = shape.movedTo(place(random, isGrid, 1.3));
        if (isUpright || random.nextInt(4) == 0) {
            return there;
        }
        return isGrid
                ? there.turned(90 * random.nextInt(4), 90 * random.nextInt(4))
                : there.turned(random.nextDouble(-180, 180), random.nextDouble(-180, 180));
    }

    /** The second with the attitude of the first, or all but that. */
    private static GeometryObject parallel(GeometryObject a, GeometryObject b, SplittableRandom random) {
        if (b.kind() == GeometryObject.Kind.MESH || b.kind() == GeometryObject.Kind.CYLINDER) {
            return b;
        }
        double[] r = a.rotation();
        if (random.nextBoolean()) {
            for (int k = 0; k < 9; k++) {
                r[k] += random.nextInt(-2, 3) * 0x1p-52;
            }
        }
        return b.oriented(r);
    }

    /** Moved along X to where it all but touches: the last place of some where it does, give or take a few ulp. */
    private GeometryObject nearly(GeometryObject a, GeometryObject b, SplittableRandom random) {
        if (!overlap(a, b)) {
            return a;
        }
        double in = a.center().x();
        double out = in + 8;
        while (Math.nextUp(in) < out) {
            double middle = in + (out - in) / 2;
            if (overlap(at(a, middle), b)) {
                in = middle;
            } else {
                out = middle;
            }
        }
        return at(a, in + random.nextInt(-2, 4) * Math.ulp(in));
    }

    private static GeometryObject at(GeometryObject object, double x) {
        return object.movedTo(new Point(x, object.center().y(), object.center().z()));
    }

    private static GeometryObject scaled(GeometryObject object, int power) {
        GeometryObject scaled = switch (object.kind()) {
            case BOX -> {
                BoxObject box = (BoxObject) object;
                yield new BoxObject(
                        new Point(),
                        Math.scalb(box.width(), power),
                        Math.scalb(box.height(), power),
                        Math.scalb(box.length(), power));
            }
            case CYLINDER -> {
                CylinderObject cylinder = (CylinderObject) object;
                yield new CylinderObject(
                        new Point(), Math.scalb(cylinder.radius(), power), Math.scalb(cylinder.height(), power));
            }
            case SPHERE -> new SphereObject(new Point(), Math.scalb(((SphereObject) object).radius(), power));
            case CAPSULE -> {
                CapsuleObject capsule = (CapsuleObject) object;
                yield new CapsuleObject(
                        new Point(), Math.scalb(capsule.radius(), power), Math.scalb(capsule.segment(), power));
            }
            case MESH -> {
                MeshObject mesh = (MeshObject) object;
                yield new MeshObject(
                        mesh.vertices().stream().map(p -> scaled(p, power)).toList(), mesh.faces());
            }
            case GROUP, GRID -> throw new IllegalArgumentException("no groups and grids here (got: " + object + ")");
        };
        return scaled.oriented(object.rotation()).movedTo(scaled(object.center(), power));
    }

    private static Point scaled(Point p, int power) {
        return new Point(Math.scalb(p.x(), power), Math.scalb(p.y(), power), Math.scalb(p.z(), power));
    }

    /** All that goes into a pair's roundings. */
    private static final class VectorSize {
        static double of(GeometryObject a, GeometryObject b) {
            return size(a) + size(b);
        }

        private static double size(GeometryObject object) {
            Point c = object.center();
            double sizes = switch (object.kind()) {
                case BOX -> {
                    BoxObject box = (BoxObject) object;
                    yield box.width() + box.height() + box.length();
                }
                case CYLINDER -> ((CylinderObject) object).radius() + ((CylinderObject) object).height();
                case SPHERE -> ((SphereObject) object).radius();
                case CAPSULE -> ((CapsuleObject) object).radius() + ((CapsuleObject) object).segment();
                case MESH, GROUP, GRID -> 4;
            };
            return sizes + Math.abs(c.x()) + Math.abs(c.y()) + Math.abs(c.z());
        }
    }
}
