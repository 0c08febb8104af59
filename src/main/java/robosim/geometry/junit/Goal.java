package robosim.geometry.junit;

import java.util.List;
import java.util.function.Function;
import java.util.function.ToDoubleFunction;
import robosim.geometry.Geometry;
import robosim.geometry.exact.Checks;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.protocol.Text;

/** A place that a robot is to reach. */
public final class Goal {
    private final String words;
    private final ToDoubleFunction<Robot> missing;
    private final Function<Geometry, List<GeometryObject>> objects;

    private Goal(String words, ToDoubleFunction<Robot> missing, Function<Geometry, List<GeometryObject>> objects) {
        this.words = words;
        this.missing = missing;
        this.objects = objects;
    }

    /**
     * A disc on the floor.
     *
     * @param radius how close the robot's centre must come to the point, seen from above
     */
    public static Goal at(double x, double z, double radius) {
        Robot.check("radius", radius);
        Point goal = new Point(x, 0, z);
        String words = "(" + Words.number(x) + ", " + Words.number(z) + ") to within " + Words.number(radius);
        return new Goal(
                words,
                robot -> {
                    double dx = robot.center().x() - goal.x();
                    double dz = robot.center().z() - goal.z();
                    return Math.max(0, Math.sqrt(dx * dx + dz * dz) - radius);
                },
                world -> List.of(new CylinderObject(goal, radius, 0).named("goal " + words)));
    }

    /**
     * A place near an object.
     *
     * @param distance how close the robot's surface must come to the object's
     */
    public static Goal near(String object, double distance) {
        Checks.present("object", object);
        Robot.check("distance", distance);
        return new Goal(
                Text.quoted(object) + " to within " + Words.number(distance),
                robot -> Math.max(0, robot.rangeTo(object).value() - distance),
                world -> world.hasObject(object) ? List.of(world.getObject(object)) : List.of());
    }

    /** How far the robot still is from it; 0 if it is there. */
    double missing(Robot robot) {
        return missing.applyAsDouble(robot);
    }

    /** Objects that mark the goal in a picture. */
    List<GeometryObject> objects(Geometry world) {
        return objects.apply(world);
    }

    @Override
    public String toString() {
        return words;
    }
}
