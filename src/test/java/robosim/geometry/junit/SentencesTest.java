package robosim.geometry.junit;

import java.util.random.RandomGenerator;
import org.junit.jupiter.api.Test;

/** The examples of docs/scenario-tests.md and of the README. */
@World("worlds/rooms.xml")
class SentencesTest {
    @Test
    void drumOneLeavesItsCorner(RobotWorld world) {
        world.robot("drum 1")
                .neverTouches("plant 1")
                .drives(2.0)
                .turns(90)
                .senses(0, 3.0)
                .rangeTo("bench 1")
                .isAtLeast(0.5);
    }

    @Test
    void wanders(RobotWorld world, RandomGenerator random) {
        world.robot("drum 1")
                .follows(robot -> {
                    if (!robot.triesToDrive(0.1)) {
                        robot.triesToTurn(random.nextDouble() * 360);
                    }
                })
                .reaches(Goal.at(-9, 0, 0.5))
                .within(2000);
    }
}
