package robosim.geometry.model;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.LocalLeaves;

/** Against points of the objects' surfaces, placed one by one. */
class BoundsTest {
    private final SplittableRandom random = new SplittableRandom(42);

    private double some(double size) {
        return random.nextDouble(-size, size);
    }

    private Point point(double size) {
        return new Point(some(size), some(size), some(size));
    }

    private GeometryObject any(int depth) {
        GeometryObject shape = switch (random.nextInt(depth > 0 ? 5 : 4)) {
            case 0 -> new BoxObject(point(9), random.nextDouble(5), random.nextDouble(5), random.nextDouble(5));
            case 1 -> new CylinderObject(point(9), random.nextDouble(5), random.nextDouble(5));
            case 2 -> new SphereObject(point(9), random.nextDouble(5));
            case 3 -> new MeshObject(List.of(point(5), point(5), point(5)), new int[][] {{0, 1, 2}});
            default -> new ObjectGroup(List.of(any(depth - 1), any(depth - 1)));
        };
        return random.nextBoolean() ? shape : shape.turned(some(180), some(180)).movedTo(point(20));
    }

    /** Corners, and points of rims and spheres, in the own frame, then through the pose. */
    private static List<double[]> points(GeometryObject object) {
        List<double[]> own = new ArrayList<>();
        if (object instanceof BoxObject box) {
            for (int k = 0; k < 8; k++) {
                own.add(new double[] {
                    (k & 1) == 0 ? box.width() / 2 : -box.width() / 2,
                    (k & 2) == 0 ? box.height() / 2 : -box.height() / 2,
                    (k & 4) == 0 ? box.length() / 2 : -box.length() / 2
                });
            }
        } else if (object instanceof CylinderObject cylinder) {
            for (int k = 0; k < 720; k++) {
                own.add(new double[] {
                    cylinder.radius() * Math.cos(k * Math.PI / 360),
                    k % 2 == 0 ? cylinder.height() / 2 : -cylinder.height() / 2,
                    cylinder.radius() * Math.sin(k * Math.PI / 360)
                });
            }
        } else if (object instanceof SphereObject sphere) {
            int count = 2000; // along a spiral from pole to pole
            for (int k = 0; k < count; k++) {
                double y = (2 * k + 1.0) / count - 1;
                double across = sphere.radius() * Math.sqrt(1 - y * y);
                double turn = k * 2.399963229728653; // the golden angle
                own.add(new double[] {across * Math.cos(turn), sphere.radius() * y, across * Math.sin(turn)});
            }
        } else if (object instanceof MeshObject mesh) {
            for (Point vertex : mesh.vertices()) {
                own.add(new double[] {vertex.x(), vertex.y(), vertex.z()});
            }
        } else if (object instanceof ObjectGroup group) {
            group.members().forEach(member -> own.addAll(points(member)));
        }
        double[] r = object.rotation();
        List<double[]> placed = new ArrayList<>();
        for (double[] p : own) {
            placed.add(new double[] {
                r[0] * p[0] + r[1] * p[1] + r[2] * p[2] + object.center().x(),
                r[3] * p[0] + r[4] * p[1] + r[5] * p[2] + object.center().y(),
                r[6] * p[0] + r[7] * p[1] + r[8] * p[2] + object.center().z()
            });
        }
        return placed;
    }

    /** Points of surfaces, apart from rims and poles, are as near to the bounds as they were sampled. */
    @Test
    void boundsHoldEveryPointAndHardlyMore() {
        for (int round = 0; round < 1000; round++) {
            GeometryObject object = any(2);
            double[] seen = {1 / 0.0, 1 / 0.0, 1 / 0.0, -1 / 0.0, -1 / 0.0, -1 / 0.0};
            for (double[] p : points(object)) {
                for (int axis = 0; axis < 3; axis++) {
                    seen[axis] = Math.min(seen[axis], p[axis]);
                    seen[3 + axis] = Math.max(seen[3 + axis], p[axis]);
                }
            }
            double[] bounds = numbers(object.bounds());
            for (int axis = 0; axis < 3; axis++) {
                double room = 2e-3 * (seen[3 + axis] - seen[axis]) + 1e-12;
                assertThat(bounds[axis]).as(object.toString()).isBetween(seen[axis] - room, seen[axis] + 1e-12);
                assertThat(bounds[3 + axis])
                        .as(object.toString())
                        .isBetween(seen[3 + axis] - 1e-12, seen[3 + axis] + room);
            }
        }
    }

    /** Never more than the bounds of the leaves that a world makes of an object, and less by roundings at most. */
    @Test
    void boundsAreThoseOfTheLeaves() {
        for (int round = 0; round < 1000; round++) {
            GeometryObject object = any(2);
            double[] bounds = numbers(object.bounds());
            double[] leaves = {1 / 0.0, 1 / 0.0, 1 / 0.0, -1 / 0.0, -1 / 0.0, -1 / 0.0};
            LeafColumn placed = LocalLeaves.placed(object);
            double[] one = new double[6];
            for (int leaf = 0; leaf < placed.size(); leaf++) {
                placed.bounds(leaf, one);
                for (int axis = 0; axis < 3; axis++) {
                    leaves[axis] = Math.min(leaves[axis], one[axis]);
                    leaves[3 + axis] = Math.max(leaves[3 + axis], one[3 + axis]);
                }
            }
            boolean hasMesh = LocalLeaves.of(object).hasMesh();
            for (int k = 0; k < 6; k++) {
                double further = k < 3 ? leaves[k] - bounds[k] : bounds[k] - leaves[k];
                assertThat(further).as(object.toString()).isLessThanOrEqualTo(0);
                if (!hasMesh) {
                    assertThat(further).as(object.toString()).isGreaterThan(-1e-13);
                }
            }
        }
    }

    @Test
    void exactWhereNothingNeedsRounding() {
        GeometryObject box = new BoxObject(new Point(0.1, 0, 3), 1.4, 4, 6);
        assertThat(box.bounds()).isEqualTo(new Bounds(0.1 - 0.7, -2, 0, Math.nextUp(0.1 + 0.7), 2, 6));
        GeometryObject turned = new BoxObject(new Point(1, 1, 1), 2, 4, 6).turned(90, 90);
        assertThat(turned.bounds()).isEqualTo(new Bounds(-1, -2, 0, 3, 4, 2));
        GeometryObject lying =
                new CylinderObject(new Point(), 1, 8).turned(0, 90).turned(90, 0);
        assertThat(lying.bounds()).isEqualTo(new Bounds(-4, -1, -1, 4, 1, 1));
        GeometryObject group = new ObjectGroup(List.of(box, new SphereObject(new Point(0, 9, 0), 1)));
        assertThat(group.bounds().maxY()).isEqualTo(10);
        assertThat(group.movedTo(new Point(0, -10, 0)).bounds().maxY()).isEqualTo(0);
        GeometryObject far = new SphereObject(new Point(0x1p100, 0, 0), 0x1p100);
        assertThat(far.bounds().maxX()).isEqualTo(0x1p101);
    }

    @Test
    void aVertexThatNoFaceUsesIsNoPartOfAMesh() {
        List<Point> vertices = List.of(new Point(), new Point(1, 0, 0), new Point(0, 0, 1), new Point(9, 9, 9));
        assertThat(new MeshObject(vertices, new int[][] {{0, 1, 2}}).bounds()).isEqualTo(new Bounds(0, 0, 0, 1, 0, 1));
    }

    @Test
    void ofSeveral() {
        Bounds all = new Bounds(0, 1, 2, 3, 4, 5).and(new Bounds(-1, 2, 0, 1, 9, 3));
        assertThat(all).isEqualTo(new Bounds(-1, 1, 0, 3, 9, 5));
        assertThat(List.of(all.width(), all.height(), all.length(), all.size())).containsExactly(4.0, 8.0, 5.0, 8.0);
        assertThat(List.of(all.middleX(), all.middleY(), all.middleZ())).containsExactly(1.0, 5.0, 2.5);
        assertThat(Bounds.reach(List.of())).containsExactly(0, 0, 0);
        assertThat(Bounds.reach(List.of(new SphereObject(new Point(-3, 1, 0), 1), new SphereObject(new Point(), 1))))
                .containsExactly(4, 2, 1);
    }

    private static double[] numbers(Bounds bounds) {
        return new double[] {bounds.minX(), bounds.minY(), bounds.minZ(), bounds.maxX(), bounds.maxY(), bounds.maxZ()};
    }
}
