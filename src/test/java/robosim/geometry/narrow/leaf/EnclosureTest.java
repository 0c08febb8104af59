package robosim.geometry.narrow.leaf;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.Effort;
import robosim.geometry.exact.Attitude;
import robosim.geometry.exact.WorkCounter;
import robosim.geometry.index.meshes.TriangleMesh;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CapsuleObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;

/** Enclosures hold what they stand for and are no wider than they must; however they were placed, they are the same. */
class EnclosureTest {
    private static final List<Accuracy> LEVELS = List.of(Accuracy.SPHERE, Accuracy.AABB, Accuracy.OBB, Accuracy.DOP);

    private final SplittableRandom random = new SplittableRandom(31);

    @ParameterizedTest
    @EnumSource(Dimension.class)
    void ofObjectsGivenBySizesAreTheSameFromAForm(Dimension dimension) {
        for (Accuracy level : LEVELS) {
            Enclosure reused = new Enclosure(level, LocalLeaves.of(new SphereObject(new Point(), 1)));
            for (int k = 0; k < Effort.cases(400); k++) {
                GeometryObject object = turned(sized(k), k).movedTo(place());
                LeafColumn quick = new LeafColumn(1);
                reused.placeSized(dimension, object, quick, quick.append(1));
                LeafColumn placed = placed(new Enclosure(level, LocalLeaves.of(object)), dimension, object);
                assertThat(quick.kind(0)).as("%s %s", level, object).isEqualTo(placed.kind(0));
                assertThat(row(quick)).as("%s %s", level, object).isEqualTo(row(placed));
            }
        }
    }

    @ParameterizedTest
    @EnumSource(Dimension.class)
    void ofObjectsGivenBySizesHoldTheirPointsAboutTheirCentre(Dimension dimension) {
        double[] most = new double[Accuracy.values().length];
        for (Accuracy level : LEVELS) {
            for (int k = 0; k < Effort.cases(400); k++) {
                GeometryObject object = turned(sized(k), k).movedTo(place());
                LeafColumn placed = placed(new Enclosure(level, LocalLeaves.of(object)), dimension, object);
                // The ball around an upright object need not hold its heights where these do not count.
                boolean isFlat = dimension == Dimension.PLANAR
                        && level == Accuracy.SPHERE
                        && object.pose().isUpright();
                Point c = object.center();
                if (placed.kind(0) != LeafKind.PRISM) {
                    assertThat(Arrays.copyOf(placed.rows(), 3)).containsExactly(c.x(), c.y(), c.z());
                }
                if (level == Accuracy.OBB && object.kind() != GeometryObject.Kind.BOX) {
                    // Its axes are rounded, so that a box of just the sizes would miss some of the shape.
                    double radius = object.roundedBox().radius();
                    assertThat(placed.rows()[3]).isGreaterThan(radius * (1 + 0x1p-46));
                    assertThat(placed.rows()[5]).isGreaterThan(radius * (1 + 0x1p-46));
                }
                for (int sample = 0; sample < 40; sample++) {
                    double[] p = pointOf(object);
                    double in = share(placed, p, isFlat);
                    assertThat(in).as("%s %s", level, object).isLessThan(1 + 1e-13);
                    most[level.ordinal()] = Math.max(most[level.ordinal()], in);
                }
            }
            assertThat(most[level.ordinal()]).as("%s", level).isGreaterThan(0.99);
        }
    }

    /** Each pair of an octagon's bounds is widened by what it is computed from: heights do not change the others. */
    @Test
    void anOctagonHasTheSameSidesAtAllHeights() {
        for (int k = 0; k < 40; k++) {
            GeometryObject object = turned(sized(k), k).movedTo(new Point(1e-3, 0, 2e-3));
            double[] low = row(placed(new Enclosure(Accuracy.DOP, LocalLeaves.of(object)), Dimension.SPATIAL, object));
            GeometryObject lifted = object.movedTo(new Point(1e-3, 1e9, 2e-3));
            double[] high = row(placed(new Enclosure(Accuracy.DOP, LocalLeaves.of(lifted)), Dimension.SPATIAL, lifted));
            assertThat(Arrays.copyOf(high, 8)).as("%s", object).containsExactly(Arrays.copyOf(low, 8));
        }
    }

    /** A point of the surface of a box, cylinder, sphere or capsule. */
    private double[] pointOf(GeometryObject object) {
        GeometryObject.RoundedBox sizes = object.roundedBox();
        double angle = random.nextDouble(2 * Math.PI);
        double end = random.nextBoolean() ? 1 : -1;
        boolean isBox = object.kind() == GeometryObject.Kind.BOX;
        boolean isCylinder = object.kind() == GeometryObject.Kind.CYLINDER;
        double rise = isCylinder || isBox ? 0 : random.nextDouble(-Math.PI / 2, Math.PI / 2);
        double level = Math.cos(rise) * sizes.radius();
        double[] own = isBox
                ? new double[] {
                    end * sizes.halfWidth(),
                    random.nextBoolean() ? sizes.halfHeight() : -sizes.halfHeight(),
                    random.nextBoolean() ? sizes.halfLength() : -sizes.halfLength()
                }
                : new double[] {
                    level * Math.cos(angle),
                    Math.sin(rise) * sizes.radius() + Math.copySign(sizes.halfHeight(), isCylinder ? end : rise),
                    level * Math.sin(angle)
                };
        double[] r = object.rotation();
        Point c = object.center();
        return new double[] {
            r[0] * own[0] + r[1] * own[1] + r[2] * own[2] + c.x(),
            r[3] * own[0] + r[4] * own[1] + r[5] * own[2] + c.y(),
            r[6] * own[0] + r[7] * own[1] + r[8] * own[2] + c.z()
        };
    }

    /** How far out a point lies in an enclosure, as a share of the distance from its middle to its surface. */
    private static double share(LeafColumn enclosure, double[] p, boolean isFlat) {
        double[] row = enclosure.rows();
        double[] d = {p[0] - row[0], isFlat ? 0 : p[1] - row[1], p[2] - row[2]};
        return switch (enclosure.kind(0)) {
            case SPHERE -> Math.hypot(Math.hypot(d[0], d[1]), d[2]) / row[3];
            case UPRIGHT_BOX, BOX -> {
                double most = 0;
                for (int k = 0; k < 3; k++) {
                    int r = Leaf.ROTATION + k;
                    most = Math.max(most, Math.abs(d[0] * row[r] + d[1] * row[r + 3] + d[2] * row[r + 6]) / row[3 + k]);
                }
                yield most;
            }
            case PRISM -> {
                double[] along = {p[0], p[2], p[0] + p[2], p[0] - p[2], isFlat ? row[8] / 2 + row[9] / 2 : p[1]};
                double most = 0;
                for (int k = 0; k < 5; k++) {
                    double middle = row[2 * k] / 2 + row[2 * k + 1] / 2;
                    most = Math.max(most, Math.abs(along[k] - middle) / (row[2 * k + 1] - middle));
                }
                yield most;
            }
            default -> throw new IllegalStateException("no enclosure: " + enclosure.kind(0));
        };
    }

    @ParameterizedTest
    @EnumSource(Dimension.class)
    void holdTheCornersOfMembers(Dimension dimension) {
        double most = 0;
        for (int k = 0; k < Effort.cases(400); k++) {
            GeometryObject member = turned(sized(0), k).movedTo(k % 3 == 0 ? new Point() : place());
            ObjectGroup group = new ObjectGroup(List.of(k % 2 == 0 ? member : new ObjectGroup(List.of(member))));
            GeometryObject object = turned(group, k + k / 7).movedTo(place());
            LeafColumn own = LocalLeaves.placed(object);
            double[] ball = placed(new Enclosure(Accuracy.SPHERE, LocalLeaves.of(object)), dimension, object)
                    .rows();
            for (int corner = 0; corner < 8; corner++) {
                double[] p = corner(own.rows(), corner);
                double rise = dimension == Dimension.PLANAR ? 0 : p[1] - ball[1];
                double far = Math.hypot(Math.hypot(p[0] - ball[0], rise), p[2] - ball[2]);
                assertThat(far).as(object + " " + member).isLessThanOrEqualTo(ball[3]);
                most = Math.max(most, far / ball[3]);
            }
        }
        assertThat(most).isGreaterThan(0.999);
    }

    private static double[] corner(double[] row, int corner) {
        double[] p = new double[3];
        for (int axis = 0; axis < 3; axis++) {
            p[axis] = row[axis];
            for (int k = 0; k < 3; k++) {
                double half = row[Leaf.SIZE + k] * row[Leaf.ROTATION + 3 * axis + k];
                p[axis] += (corner >> k & 1) == 0 ? half : -half;
            }
        }
        return p;
    }

    @ParameterizedTest
    @EnumSource(Dimension.class)
    void holdMeshesTightlyAndDoNotDependOnEarlierPlaces(Dimension dimension) {
        for (int k = 0; k < Effort.cases(60); k++) {
            MeshObject mesh = mesh(random.nextInt(1, 200));
            GeometryObject shape = k % 3 == 0 ? new ObjectGroup(List.of(mesh, sized(k).movedTo(place()))) : mesh;
            for (Accuracy level : List.of(Accuracy.AABB, Accuracy.DOP)) {
                Enclosure used = new Enclosure(level, LocalLeaves.of(shape));
                GeometryObject object = turned(shape, k);
                for (int step = 0; step < 4; step++) {
                    object = (step == 2 ? turned(object, k + 1) : object).movedTo(place());
                    LeafColumn placed = placed(used, dimension, object);
                    LeafColumn fresh = placed(new Enclosure(level, LocalLeaves.of(shape)), dimension, object);
                    assertThat(row(placed)).as("%s %s", level, object).isEqualTo(row(fresh));
                    if (shape == mesh) {
                        holdsTightly(level, placed, object);
                    }
                }
            }
        }
    }

    /** Compares with all corners, one by one. */
    private void holdsTightly(Accuracy level, LeafColumn enclosure, GeometryObject object) {
        LeafColumn own = LocalLeaves.placed(object);
        double[][] ways = {{1, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, -1}, {0, 1, 0}};
        double[] bounds = new double[6];
        enclosure.bounds(0, bounds);
        double[] row = enclosure.rows();
        double[] box = {bounds[0], bounds[3], bounds[2], bounds[5], 0, 0, 0, 0, bounds[1], bounds[4]};
        for (int k = 0; k < ways.length; k++) {
            if (level == Accuracy.DOP || k < 2 || k == 4) {
                double[] range = range(own, ways[k]);
                double least = level == Accuracy.DOP ? row[2 * k] : box[2 * k];
                double most = level == Accuracy.DOP ? row[2 * k + 1] : box[2 * k + 1];
                assertThat(least).isLessThanOrEqualTo(range[0]).isGreaterThan(range[0] - 1e-10);
                assertThat(most).isGreaterThanOrEqualTo(range[1]).isLessThan(range[1] + 1e-10);
                MeshWalk walk = new MeshWalk(new WorkCounter());
                assertThat(walk.farthest(own, 0, ways[k][0], ways[k][1], ways[k][2]))
                        .isGreaterThanOrEqualTo(range[1])
                        .isLessThan(range[1] + 1e-10);
            }
        }
    }

    private static double[] range(LeafColumn own, double[] way) {
        TriangleMesh mesh = own.mesh(0);
        double[] range = {Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY};
        for (int t = 0; t < mesh.size(); t++) {
            for (int corner = 0; corner < 3; corner++) {
                int v = mesh.vertex(t, corner);
                double along = 0;
                for (int axis = 0; axis < 3; axis++) {
                    along += way[axis] * mesh.placed(v, axis, own.rows(), 0);
                }
                range[0] = Math.min(range[0], along);
                range[1] = Math.max(range[1], along);
            }
        }
        return range;
    }

    private static double[] row(LeafColumn column) {
        int numbers = column.kind(0).numbers();
        return Arrays.copyOf(column.rows(), numbers);
    }

    private static LeafColumn placed(Enclosure enclosure, Dimension dimension, GeometryObject object) {
        LeafColumn column = new LeafColumn(1);
        column.append(1);
        double[] attitude = new double[Attitude.STRIDE];
        object.pose().attitude(attitude, 0);
        Point c = object.center();
        enclosure.place(dimension, c.x(), c.y(), c.z(), attitude, 0, column, 0);
        return column;
    }

    private Point place() {
        return new Point(random.nextDouble(-9, 9), random.nextDouble(-9, 9), random.nextDouble(-9, 9));
    }

    private GeometryObject turned(GeometryObject object, int k) {
        return object.turned(k % 2 == 0 ? 0 : random.nextDouble(360), k % 5 == 0 ? 90 : random.nextDouble(360));
    }

    private GeometryObject sized(int k) {
        double a = random.nextDouble(0.1, 3);
        double b = random.nextDouble(0.1, 3);
        return switch (k % 4) {
            case 0 -> new BoxObject(new Point(), a, b, random.nextDouble(0.1, 3));
            case 1 -> new CylinderObject(new Point(), a, b);
            case 2 -> new SphereObject(new Point(), a);
            default -> new CapsuleObject(new Point(), a, b);
        };
    }

    private MeshObject mesh(int triangles) {
        List<Point> vertices = new ArrayList<>();
        for (int v = 0; v < triangles + 2; v++) {
            vertices.add(place());
        }
        int[][] faces = new int[triangles][];
        Arrays.setAll(faces, t -> new int[] {t, t + 1, t + 2});
        return new MeshObject(vertices, faces);
    }
}
