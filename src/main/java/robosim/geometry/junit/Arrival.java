package robosim.geometry.junit;

import robosim.geometry.check.Checks;
import robosim.geometry.model.GeometryObject;

/** An assertion that a robot reaches a goal. */
public final class Arrival {
    private final RobotWorld world;
    private final Robot robot;
    private final Goal goal;

    Arrival(RobotWorld world, Robot robot, Goal goal) {
        this.world = world;
        this.robot = robot;
        this.goal = goal;
    }

    /**
     * Advances the clock until the robot is there; fails if it is not after the given number of steps.
     *
     * @throws IllegalStateException if nothing would happen in a step, because no robot {@linkplain Robot#follows
     *     follows} a behaviour
     */
    public Robot within(int steps) {
        Checks.refuse(steps < 0, "steps must be at least 0", steps);
        world.seek(goal);
        long start = world.clock().steps();
        Goal.Pursuit pursuit = goal.pursue();
        Goal.Shortfall nearest = pursuit.missing(robot);
        GeometryObject best = robot.object();
        long bestStep = 0;
        for (int k = 1; k <= steps && !nearest.isNone(); k++) {
            if (world.clock().isIdle()) {
                throw new IllegalStateException(
                        "a robot must follow a behaviour before one can reach anything in steps;"
                                + " give it one by robot(...).follows(...) (got: none)");
            }
            world.clock().advance();
            Goal.Shortfall missing = pursuit.missing(robot);
            if (missing.isLessThan(nearest)) {
                nearest = missing;
                best = robot.object();
                bestStep = world.clock().steps() - start;
            }
        }
        if (!nearest.isNone()) {
            throw robot.failure(
                    " was to reach " + goal + " in " + FailureFormat.steps(steps) + ", but came no nearer than "
                            + nearest + ", after " + FailureFormat.steps(bestStep) + " at "
                            + FailureFormat.center(best)
                            + "; it stands " + FailureFormat.place(robot.object()) + world.lastHindrance(robot.name()));
        }
        world.seek(null);
        return robot;
    }
}
