package robosim.geometry.junit;

/** A robot that was told to drive; completed by how long. */
public final class Driving {
    private final RobotWorld world;
    private final Robot robot;

    Driving(RobotWorld world, Robot robot) {
        this.world = world;
        this.robot = robot;
    }

    /**
     * Lets time pass for the whole world, in steps of its clock: every body moves as it is driven and pushed. Then tells the
     * robot to stand, which it does as soon as its drive can.
     *
     * @param seconds a multiple of the clock's step
     */
    public Robot forSeconds(double seconds) {
        world.elapse(seconds);
        world.tell(robot.name(), 0, 0, 0);
        return robot;
    }
}
