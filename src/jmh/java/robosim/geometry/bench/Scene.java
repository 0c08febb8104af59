package robosim.geometry.bench;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;

/**
 * Random static objects at constant density: n of them in a square of side 10 sqrt(n), 70 % boxes (half of them turned)
 * of 1 to 6 units a side and 30 % cylinders of radius 0.5 to 2.
 */
final class Scene {
    private final double side;
    private final SplittableRandom random;

    Scene(int n, long seed) {
        side = 10 * Math.sqrt(n);
        random = new SplittableRandom(seed + n);
    }

    double side() {
        return side;
    }

    SplittableRandom random() {
        return random;
    }

    double coordinate() {
        return random.nextDouble(-side / 2, side / 2);
    }

    /** A number of objects, which may overlap. */
    List<GeometryObject> objects(int count) {
        List<GeometryObject> objects = new ArrayList<>(count);
        for (int k = 0; k < count; k++) {
            objects.add(object());
        }
        return objects;
    }

    private GeometryObject object() {
        Point center = new Point(coordinate(), 0, coordinate());
        if (random.nextDouble() < 0.7) {
            double yaw = random.nextBoolean() ? 0 : random.nextDouble(-180, 180);
            return new BoxObject(center, random.nextDouble(1, 6), 2, random.nextDouble(1, 6)).turned(0, yaw);
        }
        return new CylinderObject(center, random.nextDouble(0.5, 2), 2);
    }
}
