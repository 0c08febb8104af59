package robosim.geometry.sweep;

import java.io.Serial;
import java.io.Serializable;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Pattern;
import robosim.geometry.Geometry;
import robosim.geometry.check.Text;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.StepBundle;

/** Where the robots of one replicate end, and when they reach their goals. */
final class RobotArrivals {
    /** The most robots whose end is part of a result. */
    static final int MOST_ROBOTS = 10;

    private static final Pattern END = Pattern.compile("end (x|y|z|heading) of ");

    /** The longest name that is part of the name of a number. */
    private static final int LONGEST = 100;

    private final Geometry world;
    private final List<String> robots;
    private final List<Goal> goals;
    private final boolean isTimed;
    private final double[] reached;
    private double time;

    /** What rounding took from the time so far. */
    private double lost;

    /**
     * A disc on the floor that the centre of a robot is to reach.
     *
     * @param robot its name
     */
    record Goal(String robot, double x, double z, double radius) implements Serializable {
        @Serial
        private static final long serialVersionUID = 1;

        private boolean isReachedIn(Geometry world) {
            if (!world.hasObject(robot)) {
                return false;
            }
            Point at = world.getObject(robot).center();
            return StrictMath.hypot(at.x() - x, at.z() - z) <= radius;
        }
    }

    /**
     * Begins in the starting places.
     *
     * @param isTimed whether steps of time are requested; otherwise the time is the number of requests
     */
    RobotArrivals(Geometry world, List<String> robots, List<Goal> goals, boolean isTimed) {
        this.world = world;
        this.robots = robots;
        this.goals = goals;
        this.isTimed = isTimed;
        reached = new double[goals.size()];
        Arrays.fill(reached, Double.POSITIVE_INFINITY);
        look();
    }

    /** Looks where the robots are after a request. */
    void after(Bundle request) {
        // Kahan's sum: after 48 steps of 0.05 s it is 2.4 s.
        double more = (isTimed ? request instanceof StepBundle step ? step.seconds() : 0 : 1) - lost;
        double sum = time + more;
        lost = sum - time - more;
        time = sum;
        look();
    }

    private void look() {
        for (int k = 0; k < reached.length; k++) {
            if (time < reached[k] && goals.get(k).isReachedIn(world)) {
                reached[k] = time;
            }
        }
    }

    /** A result with the ends and the times; a goal that was not reached has none. */
    Result end(Result result) {
        Result all = result;
        for (int k = 0; k < goals.size(); k++) {
            all = all.and(
                    "time to goal" + (goals.size() == 1 ? "" : " " + (k + 1)) + " of "
                            + label(goals.get(k).robot(), k) + (isTimed ? " [s]" : " [requests]"),
                    reached[k]);
        }
        for (int k = 0; k < robots.size(); k++) {
            String robot = robots.get(k);
            if (!world.hasObject(robot)) {
                continue;
            }
            GeometryObject object = world.getObject(robot);
            Point at = object.center();
            String of = " of " + label(robot, k);
            all = all.and("end x" + of + " [world units]", at.x());
            if (world.dimension() == Dimension.SPATIAL) {
                all = all.and("end y" + of + " [world units]", at.y());
            }
            all = all.and("end z" + of + " [world units]", at.z())
                    .and("end heading" + of + " [degrees]", object.heading());
        }
        return all;
    }

    /** Whether a number is part of the end of a robot, which has its place in rows, not in tables and charts. */
    static boolean isEnd(String number) {
        return END.matcher(number).lookingAt();
    }

    private static String label(String robot, int number) {
        String line = Text.line(robot);
        return line.length() > LONGEST ? "robot " + (number + 1) : line;
    }
}
