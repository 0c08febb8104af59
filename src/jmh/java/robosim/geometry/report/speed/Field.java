package robosim.geometry.report.speed;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import robosim.geometry.Geometry;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;

/**
 * Random static objects at constant density: n of them in a square of side 10 sqrt(n), 70 % boxes (half of them turned)
 * of 1 to 6 units a side and 30 % cylinders of radius 0.5 to 2, all 1 to 4 high on one floor; and questions among them.
 */
final class Field {
    /** How far rays look. */
    static final double RAY_RANGE = 100;

    static final double CONE_RANGE = 20;
    static final double CONE_DEGREES = 15;

    private static final double FLOOR = -2;

    final double side;
    final List<GeometryObject> objects;
    private final SplittableRandom random;

    Field(int count, long seed) {
        side = 10 * Math.sqrt(count);
        random = new SplittableRandom(seed + count);
        objects = new ArrayList<>(count);
        for (int k = 0; k < count; k++) {
            objects.add(object());
        }
    }

    private double coordinate() {
        return random.nextDouble(-side / 2, side / 2);
    }

    private GeometryObject object() {
        double height = random.nextDouble(1, 4);
        Point center = new Point(coordinate(), FLOOR + height / 2, coordinate());
        if (random.nextDouble() < 0.7) {
            double yaw = random.nextBoolean() ? 0 : random.nextDouble(-180, 180);
            return new BoxObject(center, random.nextDouble(1, 6), height, random.nextDouble(1, 6)).turned(0, yaw);
        }
        return new CylinderObject(center, random.nextDouble(0.5, 2), height);
    }

    /** A world that holds them. */
    Geometry geometry(Dimension dimension) {
        Geometry geometry = new Geometry(side + 20, 10, side + 20, dimension, Accuracy.EXACT);
        for (GeometryObject object : objects) {
            geometry.addObjectUnchecked(object);
        }
        return geometry;
    }

    /** Level rays from anywhere to anywhere, half a unit to three above the floor. */
    Ray[] rays(int count) {
        Ray[] rays = new Ray[count];
        for (int k = 0; k < count; k++) {
            double angle = random.nextDouble(2 * Math.PI);
            rays[k] = new Ray(
                    new Point(coordinate(), FLOOR + random.nextDouble(0.5, 3), coordinate()),
                    new Point(StrictMath.cos(angle), 0, StrictMath.sin(angle)));
        }
        return rays;
    }

    /** Discs of radius 0.5, one high, to be tested. */
    CylinderObject[] probes(int count) {
        CylinderObject[] probes = new CylinderObject[count];
        for (int k = 0; k < count; k++) {
            probes[k] = new CylinderObject(new Point(coordinate(), FLOOR + 1, coordinate()), 0.5, 1);
        }
        return probes;
    }
}
