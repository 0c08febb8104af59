package robosim.geometry.net.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;

/** Against points of the objects' surfaces, placed one by one. */
class ExtentTest {
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

    @Test
    void theWorldHoldsEveryPointWithAQuarterOfRoom() {
        for (int round = 0; round < 300; round++) {
            List<GeometryObject> objects = new ArrayList<>();
            for (int k = random.nextInt(4); k >= 0; k--) {
                objects.add(any(2));
            }
            double[] reach = new double[3];
            for (GeometryObject object : objects) {
                for (double[] p : points(object)) {
                    for (int axis = 0; axis < 3; axis++) {
                        reach[axis] = Math.max(reach[axis], Math.abs(p[axis]));
                    }
                }
            }
            double room = Math.max(1, 0.25 * Math.max(reach[0], Math.max(reach[1], reach[2])));
            double[] sizes = Extent.worldFor(objects);
            for (int axis = 0; axis < 3; axis++) {
                double exact = 2 * (reach[axis] + room);
                assertThat(sizes[axis]).as(objects.toString()).isBetween(exact * (1 - 1e-12), exact * (1 + 3e-3));
            }
        }
    }

    @Test
    void aWorldIsNeverTooLargeNorNothing() {
        assertThat(Extent.worldFor(List.of())).containsExactly(2, 2, 2);
        GeometryObject far = new SphereObject(new Point(0x1p100, 0, -0x1p100), 0x1p100);
        assertThat(Extent.worldFor(List.of(far))).containsExactly(0x1p101, 0x1p101, 0x1p101);
    }
}
