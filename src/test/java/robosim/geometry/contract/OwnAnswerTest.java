package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.Geometry;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;
import robosim.geometry.model.SphereObject;

/** What a beam finds it finds again with the distance itself as its range. */
class OwnAnswerTest {
    private final SplittableRandom random = new SplittableRandom(30053);

    @Test
    void anAnswerIsFoundAgainWithItselfAsTheRange() {
        int hits = 0;
        for (int k = 0; k < 6000; k++) {
            Dimension dimension = k % 2 == 0 ? Dimension.PLANAR : Dimension.SPATIAL;
            Geometry world = new Geometry(1e6, 1e6, 1e6, dimension, Accuracy.EXACT);
            GeometryObject object = object(k);
            world.addObjectUnchecked(object);
            Point centre = object.center();
            double x = k % 3 == 0 ? centre.x() : random.nextDouble(-9000, 9000);
            double z = k % 3 == 1 ? centre.z() : random.nextDouble(-9000, 9000);
            Point start = new Point(x, k % 5 == 0 ? centre.y() : random.nextDouble(-100, 100), z);
            Point way = new Point(centre.x() - x, centre.y() - start.y(), centre.z() - z);
            if (way.x() == 0 && way.z() == 0) {
                continue;
            }
            Ray ray = new Ray(start, way);
            double width = k % 7 < 2 ? random.nextDouble(1, 90) : 0;
            double distance = world.getRayDistance(ray, 0, Double.POSITIVE_INFINITY, width);
            if (distance < Double.POSITIVE_INFINITY) {
                hits++;
                assertThat(world.getRayDistance(ray, 0, distance, width))
                        .as("%s from %s, width %s", object, ray, width)
                        .isEqualTo(distance);
            }
        }
        assertThat(hits).isGreaterThan(5000);
    }

    private GeometryObject object(int k) {
        Point centre =
                new Point(random.nextDouble(-100, 100), random.nextDouble(-100, 100), random.nextDouble(-100, 100));
        double big = Math.scalb(1.0, random.nextInt(12));
        double p = random.nextDouble(0.1, 1) * big;
        double q = random.nextDouble(0.1, 1) * big;
        double turn = k % 4 == 0 ? random.nextDouble(-1e-7, 1e-7) : random.nextDouble(-180, 180);
        return switch (k % 11) {
            case 0 -> new SphereObject(centre, p);
            case 1, 2 -> new BoxObject(centre, p, q, 1).turned(turn, 30);
            case 3 -> new CylinderObject(centre, p, q);
            default -> new CylinderObject(centre, p, q).turned(turn, random.nextInt(4) * 90);
        };
    }
}
