package robosim.geometry.cli.worlds;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.collision.CollisionDetection;
import robosim.geometry.index.meshes.TriangleMesh;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CapsuleObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;
import robosim.geometry.world.World;
import robosim.geometry.world.WorldObject;

/** Sections of objects for a plan, against the objects themselves. */
class PlanSliceTest {
    private static List<GeometryObject> sliced(double height, GeometryObject... objects) {
        List<WorldObject> all = List.of(objects).stream().map(WorldObject::new).toList();
        World world = new World(40, 20, 40, null, Dimension.SPATIAL, Accuracy.EXACT, all);
        return PlanSlice.of(world, height).objects().stream()
                .map(WorldObject::object)
                .toList();
    }

    /** A point of the plane is in the section where it is in the object; round sections of tilted objects have corners. */
    @Test
    void aSectionIsWhereThePlaneIsInTheObject() {
        SplittableRandom random = new SplittableRandom(30);
        GeometryObject[] shapes = {
            new BoxObject(new Point(1, 0.2, 0), 2, 1, 3),
            new BoxObject(new Point(1, 0.2, 0), 2, 1, 3).turned(35, 70),
            new CylinderObject(new Point(0, 0, 1), 1.5, 1.2),
            new CylinderObject(new Point(0, 0, 1), 1.5, 1.2).turned(50, 20),
            new SphereObject(new Point(-1, 0.3, 0), 2),
            new CapsuleObject(new Point(), 0.8, 1),
            new CapsuleObject(new Point(), 0.8, 3).turned(65, 10),
            GridObject.of(new Point(), 0.5, 1, 4, 4, new byte[] {(byte) 0xa5, 0x0f}),
            new ObjectGroup(List.of(
                            new BoxObject(new Point(0.5, 0, 0), 1, 2, 1).turned(20, 0),
                            new SphereObject(new Point(-1, 0.2, 0), 0.7)))
                    .turned(0, 40)
                    .movedTo(new Point(0, 0.1, 0.5)),
        };
        for (GeometryObject shape : shapes) {
            int inside = 0;
            int wrong = 0;
            int empty = 0;
            for (int round = 0; round < 20; round++) {
                double height = 3 * random.nextDouble() - 1.5;
                List<GeometryObject> section = sliced(height, shape);
                empty += section.isEmpty() ? 1 : 0;
                for (int k = 0; k < 100; k++) {
                    Point at = new Point(6 * random.nextDouble() - 3, height, 6 * random.nextDouble() - 3);
                    SphereObject point = new SphereObject(at, 0);
                    boolean truth = CollisionDetection.intersects(shape, point);
                    boolean got = !section.isEmpty() && CollisionDetection.intersects(section.get(0), point);
                    inside += truth ? 1 : 0;
                    wrong += truth == got ? 0 : 1;
                }
            }
            assertThat(inside).as("%s", shape).isBetween(20, 1200);
            assertThat(empty).as("%s", shape).isLessThan(20);
            assertThat(wrong).as("%s", shape).isLessThanOrEqualTo(shape.pose().isUpright() ? 0 : 8);
        }
    }

    @Test
    void aMeshIsTheLinesOfItsFaces() {
        MeshObject wedge = new MeshObject(
                List.of(
                        new Point(-1, -1, -1),
                        new Point(1, -1, -1),
                        new Point(1, -1, 1),
                        new Point(-1, -1, 1),
                        new Point(0, 1, 0)),
                new int[][] {{0, 1, 2, 3}, {0, 4, 1}, {1, 4, 2}, {2, 4, 3}, {3, 4, 0}});
        for (double height : new double[] {-0.5, 0, 0.9}) {
            TriangleMesh lines =
                    ((MeshObject) sliced(height, wedge.named("wedge")).get(0)).triangles();
            double length = 0;
            for (int t = 0; t < lines.size(); t++) {
                int a = lines.vertex(t, 0);
                int b = lines.vertex(t, 1);
                length += Math.hypot(
                        lines.coordinate(a, 0) - lines.coordinate(b, 0),
                        lines.coordinate(a, 2) - lines.coordinate(b, 2));
                assertThat(lines.coordinate(a, 1)).isEqualTo(height);
            }
            assertThat(length).as("around a square").isCloseTo(4 * (1 - height), within(1e-9));
        }
        assertThat(sliced(1.5, wedge)).isEmpty();
    }

    @Test
    void namesAndColoursStay() {
        GeometryObject ball = new SphereObject(new Point(0, 1, 0), 0.5).moveable("ball");
        List<GeometryObject> section = sliced(1.3, ball, new BoxObject(new Point(4, 0, 0), 1, 1, 1).named("low"));
        assertThat(section).singleElement().satisfies(disc -> {
            assertThat(disc.name()).isEqualTo("ball");
            assertThat(disc.isMoveable()).isTrue();
            assertThat(((CylinderObject) disc).radius()).isCloseTo(0.4, within(1e-12));
        });
    }
}
