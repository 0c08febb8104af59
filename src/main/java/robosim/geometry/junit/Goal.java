package robosim.geometry.junit;

import java.util.function.ToDoubleFunction;
import robosim.geometry.model.Point;
import robosim.geometry.protocol.Text;

/** Where a robot is to come. */
public final class Goal {
    private final String words;
    private final ToDoubleFunction<Robot> missing;

    private Goal(String words, ToDoubleFunction<Robot> missing) {
        this.words = words;
        this.missing = missing;
    }

    /**
     * A disc on the floor.
     *
     * @param radius how near to the point the robot's centre must come, seen from above
     */
    public static Goal at(double x, double z, double radius) {
        Robot.check("radius", radius);
        Point goal = new Point(x, 0, z);
        return new Goal(
                "(" + Words.number(x) + ", " + Words.number(z) + ") to within " + Words.number(radius), robot -> {
                    double dx = robot.center().x() - goal.x();
                    double dz = robot.center().z() - goal.z();
                    return Math.max(0, Math.sqrt(dx * dx + dz * dz) - radius);
                });
    }

    /**
     * Beside an object.
     *
     * @param distance how near the robot's surface must come to the object's
     */
    public static Goal near(String object, double distance) {
        Robot.check("distance", distance);
        return new Goal(
                Text.quoted(object) + " to within " + Words.number(distance),
                robot -> Math.max(0, robot.rangeTo(object).value() - distance));
    }

    /** How far the robot still is from it; 0 where it is there. */
    double missing(Robot robot) {
        return missing.applyAsDouble(robot);
    }

    @Override
    public String toString() {
        return words;
    }
}
