package robosim.geometry.junit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.Point;
import robosim.geometry.scenario.Mismatch;
import robosim.geometry.scenario.Replay;
import robosim.geometry.scenario.Scenario;
import robosim.geometry.scenario.Step;

/** What holds passes, and what does not says where and why. */
class RobotTest {
    private final RobotWorld world = RobotWorld.of(Worlds.wallAhead());
    private final Robot r1 = world.robot("r1");

    @Test
    void itDrivesAndTurns() {
        r1.drives(2.0).turns(90).drives(1.0);
        assertThat(r1.center()).isEqualTo(new Point(2, 0, -1));
        assertThat(r1.heading()).isEqualTo(90);
    }

    @Test
    void aBlockedDriveTellsWhereAndWhy() {
        assertThatThrownBy(() -> r1.drives(1).drives(2.5))
                .isInstanceOf(AssertionError.class)
                .hasMessage("robot \"r1\" was to drive 2.5, but is blocked after 2 of 2.5 by box \"wall\" at (4, 0, 0),"
                        + " where it touches (3.5, 0, 0); it stands at (1, 0, 0), heading 0");
        assertThat(r1.center()).isEqualTo(new Point(1, 0, 0));
        assertThatThrownBy(() -> r1.drives(-30)).hasMessageContaining("by the border of the world");
    }

    @Test
    void toTryIsNoFailure() {
        assertThat(r1.triesToDrive(4)).isFalse();
        assertThat(r1.triesToDrive(2)).isTrue();
        assertThat(r1.triesToTurn(30)).isTrue();
        assertThat(r1.heading()).isCloseTo(30, within(1e-14));
    }

    /** A mistyped name is an error wherever one is given, and what there is is named. */
    @Test
    void aMistypedNameIsAnError() {
        Runnable[] sentences = {
            () -> world.robot("r9"),
            () -> world.robot("wall"),
            () -> r1.isBlockedBy("wal", 4),
            () -> r1.rangeTo("wal"),
            () -> r1.neverTouches("wal"),
            () -> r1.follows(each -> {}).reaches(Goal.near("wal", 1)).within(0)
        };
        for (Runnable sentence : sentences) {
            assertThatThrownBy(sentence::run)
                    .isInstanceOf(IllegalArgumentException.class)
                    .hasMessageContaining("name must be that of")
                    .hasMessageContaining("\"r1\"");
        }
    }

    @Test
    void itIsBlockedByWhatIsNamed() {
        r1.isBlockedBy("wall", 4);
        assertThatThrownBy(() -> r1.isBlockedBy("wall", 1)).hasMessageContaining("but nothing is in its way");
        assertThatThrownBy(() -> r1.isBlockedBy("r2", 4))
                .hasMessageContaining("was to be blocked by \"r2\"")
                .hasMessageContaining("by box \"wall\" at (4, 0, 0)");
    }

    @Test
    void itSensesAtTheDistanceThatThereIs() {
        assertThat(r1.range(0)).isEqualTo(3.5);
        assertThat(r1.range(90)).isEqualTo(3.5);
        assertThat(r1.range(180)).isInfinite();
        r1.senses(0, 3.5).sensesNothing(0, 3.4).sensesNothing(180, 100);
        assertThatThrownBy(() -> r1.senses(0, 3.4))
                .hasMessage(
                        "robot \"r1\" was to sense something within 3.4 at 0 degrees, but the first echo is 3.5 away,"
                                + " at about (3.5, 0, 0); it stands at (0, 0, 0), heading 0");
        assertThatThrownBy(() -> r1.senses(180, 9)).hasMessageContaining("nothing echoes there at any distance");
        assertThatThrownBy(() -> r1.sensesNothing(90, 3.5)).hasMessageContaining("at about (0, 0, -3.5)");
        assertThatThrownBy(() -> r1.senses(0, Double.NaN)).isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    void itIsAsFarFromOthersAsTheirSurfacesAre() {
        assertThat(r1.rangeTo("wall").value()).isCloseTo(3, within(1e-12)).isLessThanOrEqualTo(3);
        r1.rangeTo("wall")
                .isAtLeast(3)
                .rangeTo("wall")
                .isAtMost(3)
                .rangeTo("r2")
                .isAtMost(3);
        r1.rangeTo("wall").isAtLeast(2).isAtMost(4).isAtLeast(3).turns(0);
        assertThatThrownBy(() -> r1.rangeTo("wall").isAtLeast(2).isAtMost(2.5))
                .hasMessageContaining("at most 2.5 from \"wall\"");
        assertThatThrownBy(() -> r1.rangeTo("wall").isAtLeast(3.5))
                .hasMessage(
                        "robot \"r1\" was to be at least 3.5 from \"wall\", but is 3 from it; it stands at (0, 0, 0),"
                                + " heading 0");
        assertThatThrownBy(() -> r1.rangeTo("wall").isAtMost(2.5)).hasMessageContaining("at most 2.5 from \"wall\"");
    }

    @Test
    void itNeverTouchesLooksBackAndForth() {
        r1.neverTouches("wall").drives(2);
        assertThatThrownBy(() -> r1.triesToDrive(2))
                .hasMessageStartingWith(
                        "robot \"r1\" must never touch \"wall\", but robot \"r1\" was to drive 2 and was"
                                + " blocked after 1 of 2 by box \"wall\"");
        assertThatThrownBy(() -> r1.neverTouches("wall")).isInstanceOf(AssertionError.class);
        assertThatCode(() -> r1.neverTouches("r2")).doesNotThrowAnyException();
    }

    @Test
    void whatTouchesWithoutAMoveIsSeenToo() {
        world.geometry().addObjectUnchecked(new BoxObject(new Point(0.5, 0, 0), 0.1, 1, 0.1).named("thing"));
        assertThatThrownBy(() -> r1.neverTouches("thing"))
                .hasMessage(
                        "robot \"r1\" must never touch \"thing\", but they touch: cylinder \"r1\" at (0, 0, 0) and box"
                                + " \"thing\" at (0.5, 0, 0)");
    }

    /** Turned and back, it stands a few last bits off: nobody is told them as a place. */
    @Test
    void theNoiseOfRoundingIsNotTold() {
        r1.drives(0.1 + 0.2)
                .turns(30)
                .turns(30)
                .turns(30)
                .drives(1.1)
                .turns(-0.1)
                .turns(0.1)
                .turns(-90);
        r1.drives(0.1).turns(90).drives(-1.1).turns(-90).drives(0.2);
        assertThat(r1.heading()).isNotZero().isCloseTo(0, within(1e-12));
        assertThat(r1.center().z()).isNotZero().isCloseTo(0, within(1e-12));
        assertThatThrownBy(() -> r1.drives(0.1 + 0.2).drives(3))
                .hasMessage("robot \"r1\" was to drive 3, but is blocked after 2.1 of 3 by box \"wall\" at (4, 0, 0),"
                        + " where it touches (3.5, 0, 0); it stands at (0.9, 0, 0), heading 0");
        assertThatThrownBy(() -> r1.sensesNothing(0, 4))
                .hasMessageContaining("the first echo is 2.6 away, at about (3.5,");
        r1.follows(robot -> robot.triesToDrive(0.1));
        assertThatThrownBy(() -> r1.reaches(Goal.at(2, 0, 0.1 + 0.2)).within(1))
                .hasMessageContaining(
                        "was to reach (2, 0) to within 0.3 in 1 step, but came no nearer than 0.7 short of it,"
                                + " after 1 step at (1, 0, 0); it stands at (1, 0, 0), heading 0");
    }

    @Test
    void whatIsComparedNeverLooksTheSame() {
        double gap = r1.rangeTo("wall").value();
        assertThatThrownBy(() -> r1.rangeTo("wall").isAtLeast(3.000000000001))
                .hasMessageContaining("at least 3 from \"wall\", but is just under 3 (by 9.7e-13) from it");
        assertThatThrownBy(() -> r1.rangeTo("wall").isAtLeast(3.00000000001))
                .hasMessageContaining("at least 3.00000000001 from \"wall\", but is 3 from it");
        assertThatThrownBy(() -> r1.rangeTo("wall").isAtMost(Math.nextDown(gap)))
                .hasMessageContaining("at most 3 from \"wall\", but is just over 3 (by 4.4e-16) from it");
        assertThatThrownBy(() -> r1.senses(0, Math.nextDown(3.5)))
                .hasMessageContaining("within 3.5 at 0 degrees, but the first echo is just over 3.5 (by 4.4e-16) away");
        assertThatThrownBy(() -> r1.drives(3.0000000001))
                .hasMessageContaining("drive 3.0000000001, but is blocked after 3 of 3.0000000001 by");
        assertThatThrownBy(() -> r1.drives(3))
                .hasMessageContaining("drive 3, but is blocked after just under 3 of 3 by");
    }

    /** Found and asked for, at every distance from each other: told in the order that they have. */
    @Test
    void whatIsToldHasTheOrderOfTheNumbers() {
        SplittableRandom random = new SplittableRandom(11);
        int close = 0;
        for (int k = 0; k < 20_000; k++) {
            double asked = random.nextInt(4) == 0 ? random.nextInt(100) / 10.0 : random.nextDouble() * 10;
            double off = Math.pow(10, -17 * random.nextDouble()) * (random.nextBoolean() ? 1 : -1);
            double found = random.nextInt(9) == 0 ? Math.nextUp(asked) : Math.max(0, asked + off);
            String told = FailureFormat.apart(found, asked);
            String beside = FailureFormat.number(asked);
            if (found == asked) {
                continue;
            }
            if (told.startsWith("just ")) {
                close++;
                assertThat(told).startsWith(found < asked ? "just under " + beside : "just over " + beside);
                assertThat(Math.abs(found - asked)).isLessThan(1e-8 * Math.max(1, asked));
            } else {
                assertThat(Double.compare(Double.parseDouble(told), Double.parseDouble(beside)))
                        .as("%s and %s", found, asked)
                        .isEqualTo(Double.compare(found, asked));
                assertThat(told.length()).isLessThanOrEqualTo(17);
            }
        }
        assertThat(close).isBetween(2_000, 18_000);
    }

    @Test
    void itReachesAGoalInSteps() {
        r1.follows(robot -> robot.triesToDrive(0.5));
        r1.reaches(Goal.at(2, 0, 0.25)).within(4);
        assertThat(world.clock().steps()).isEqualTo(4);
        r1.reaches(Goal.near("wall", 0.5)).within(1);
        assertThatThrownBy(() -> r1.reaches(Goal.at(3, 1, 0.5)).within(3))
                .hasMessageStartingWith(
                        "robot \"r1\" was to reach (3, 1) to within 0.5 in 3 steps, but came no nearer than ")
                .hasMessageContaining(
                        "it stands at (2.5, 0, 0), heading 0; the last that stopped it: robot \"r1\" was to"
                                + " drive 0.5 in step 8 and was blocked after just under 0.5 of 0.5 by box \"wall\"");
    }

    @Test
    void stepsInWhichNothingHappensAreRefused() {
        r1.reaches(Goal.at(0, 0, 0)).within(0);
        assertThatThrownBy(() -> r1.reaches(Goal.at(1, 0, 0)).within(10))
                .isInstanceOf(IllegalStateException.class)
                .hasMessageContaining("follows");
    }

    @Test
    void aStrangeNameIsToldWhichThereAre() {
        assertThatThrownBy(() -> world.robot("wall"))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("name must be that of a moveable object, one of [\"r1\", \"r2\"] (got: \"wall\")");
        assertThatThrownBy(() -> r1.rangeTo("walls")).hasMessageContaining("[\"r1\", \"wall\", \"r2\"]");
        assertThat(world.robots()).extracting(Robot::name).containsExactly("r1", "r2");
    }

    @Test
    void whatItDidReplaysToTheBitWhateverElseChangesTheWorld() {
        r1.drives(1).turns(33.3).triesToDrive(9);
        r1.range(17);
        world.geometry().placeObject("r2", new Point(-3, 0, 3), 12.5);
        world.robot("r2").turns(-0.1).drives(0.7).range(99);
        Scenario scenario = world.scenario("what it did");
        assertThat(Replay.of(scenario)).extracting(Mismatch::toString).isEmpty();
        assertThat(scenario.steps()).hasSize(9);
        assertThat(scenario.steps().stream().filter(step -> step.expected() != null))
                .hasSize(7);
        assertThat(scenario.steps().get(5).notes()).containsExactly("the test changed the world by other means");
        Step last = scenario.steps().get(8);
        assertThat(last.expected()).isNotNull();
    }
}
