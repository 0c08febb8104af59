package example;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.random.RandomGenerator;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import robosim.geometry.junit.Goal;
import robosim.geometry.junit.RobotWorld;
import robosim.geometry.junit.ScenarioTest;
import robosim.geometry.junit.Scenarios;
import robosim.geometry.junit.Seed;
import robosim.geometry.junit.VirtualClock;
import robosim.geometry.junit.World;

/** A robot goes through a door to its dock. */
@World("worlds/two-rooms.xml")
class DoorTest {
    @Test
    void itDrivesThroughTheDoor(RobotWorld world) {
        world.robot("robot")
                .neverTouches("wall north")
                .neverTouches("wall south")
                .drives(6)
                .senses(0, 2)
                .rangeTo("dock")
                .isAtMost(1);
    }

    @Test
    void itDoesNotFitBesideTheDoor(RobotWorld world) {
        world.robot("robot").turns(90).drives(0.5).turns(-90).isBlockedBy("wall north", 6);
    }

    @Test
    void itDocksInTime(RobotWorld world, VirtualClock clock) {
        world.robot("robot")
                .follows(robot -> robot.triesToDrive(0.1))
                .reaches(Goal.near("dock", 0.2))
                .within(80);
        assertEquals(68, clock.steps());
    }

    @ScenarioTest
    @Seed({1, 2, 3, 4})
    void itFindsTheOtherRoomByChance(RobotWorld world, RandomGenerator random) {
        world.robot("robot")
                .follows(robot -> {
                    if (random.nextInt(10) == 0 || !robot.triesToDrive(0.2)) {
                        robot.triesToTurn(random.nextDouble() * 360);
                    }
                })
                .reaches(Goal.at(2.5, 0, 1.5))
                .within(20_000);
    }

    @TestFactory
    Stream<DynamicTest> scenarios() {
        return Scenarios.in(Path.of("src", "test", "scenarios"));
    }
}
