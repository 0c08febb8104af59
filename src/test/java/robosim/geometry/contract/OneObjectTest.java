package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.Geometry;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;

/** A ray in a world of one object, which is looked for in no index, sees what it sees beside another one far away. */
class OneObjectTest {
    private static final Point CENTER = new Point(0, 0, 0);

    private static final List<GeometryObject> OBJECTS = List.of(
            new BoxObject(CENTER, 3, 4, 5).turned(20, 30),
            new CylinderObject(CENTER, 2, 4),
            new MeshObject(
                    List.of(new Point(-3, -1, 0), new Point(3, -2, 1), new Point(0, 3, 2)), new int[][] {{0, 1, 2}}),
            new ObjectGroup(
                    List.of(new BoxObject(new Point(-2, 0, 0), 1, 1, 1), new BoxObject(new Point(2, 0, 0), 1, 1, 1))));

    @Test
    void seesTheSameAlone() {
        SplittableRandom random = new SplittableRandom(631);
        for (GeometryObject object : OBJECTS) {
            for (boolean isMoveable : new boolean[] {false, true}) {
                GeometryObject named = isMoveable ? object.moveable("one") : object.named("one");
                Geometry alone = new Geometry();
                alone.addObjectUnchecked(new BoxObject(new Point(9, 9, 9), 1, 1, 1).named("gone"));
                alone.addObjectUnchecked(named);
                alone.removeObject("gone");
                Geometry beside = new Geometry();
                beside.addObjectUnchecked(named);
                beside.addObjectUnchecked(new BoxObject(new Point(450, 450, 450), 1, 1, 1));
                int hits = 0;
                for (int k = 0; k < 500; k++) {
                    Point start = point(random, 10);
                    Point at = point(random, 3);
                    Ray ray = new Ray(start, new Point(at.x() - start.x(), at.y() - start.y(), at.z() - start.z()));
                    double max = k % 4 == 0 ? random.nextDouble(10) : 50;
                    double seen = alone.getRayDistance(ray, 0, max, 0);
                    assertThat(seen).isEqualTo(beside.getRayDistance(ray, 0, max, 0));
                    assertThat(alone.getRayDistance(ray, 0, max, 0, "one")).isInfinite();
                    hits += seen < Double.POSITIVE_INFINITY ? 1 : 0;
                }
                assertThat(hits).isBetween(25, 475);
            }
        }
    }

    private static Point point(SplittableRandom random, double size) {
        return new Point(
                random.nextDouble(-size, size), random.nextDouble(-size, size), random.nextDouble(-size, size));
    }
}
