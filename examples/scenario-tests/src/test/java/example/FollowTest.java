package example;

import org.junit.jupiter.api.Test;
import robosim.geometry.junit.Robot;
import robosim.geometry.junit.RobotWorld;
import robosim.geometry.junit.VirtualClock;
import robosim.geometry.junit.World;

/** The robot of docs/tutorial.md follows a wall on a map. */
@World("worlds/flat.xml")
class FollowTest {
    @Test
    void aMinuteAlongTheWall(RobotWorld world, VirtualClock clock) {
        Robot scout = world.robot("scout");
        scout.follows(robot -> {
            boolean isNear = robot.range(0, 60) < 0.45;
            double error = 0.5 - robot.range(-60) * Math.sin(Math.PI / 3);
            robot.drives(isNear ? 0 : 0.4, isNear ? 57 : Math.max(-46, Math.min(46, 115 * error)));
        });
        clock.advance(600);
        scout.hitsNothing();
    }
}
