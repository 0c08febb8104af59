package robosim.geometry.junit;

import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.opentest4j.AssertionFailedError;
import robosim.geometry.Geometry;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;

/** Goals by place, heading and path. */
class GoalTest {
    private static Robot robot() {
        Geometry world = new Geometry(20, 2, 20);
        world.addObject(new BoxObject(new Point(0, 0, 0), 0.2, 0.2, 0.2).moveable("r"));
        return RobotWorld.of(world).robot("r");
    }

    @Test
    void aHeading() {
        Robot robot = robot().follows(each -> each.turns(30));
        assertThatCode(() -> robot.reaches(Goal.heading(-270, 0.5)).within(3)).doesNotThrowAnyException();
        assertThatThrownBy(() -> robot.reaches(Goal.heading(0, 0.5)).within(2))
                .isInstanceOf(AssertionFailedError.class)
                .hasMessageContaining("was to reach heading 0 to within 0.5 in 2 steps")
                .hasMessageContaining("89.5 degrees short of its heading, after 0 steps");
    }

    /** Both at the same time: a robot that only passes the place is not there. */
    @Test
    void aPlaceAndAHeading() {
        Robot robot = robot().follows(each -> each.moves(new Move(0.5, 0, 0, 0, 0)));
        assertThatThrownBy(
                        () -> robot.reaches(Goal.at(2, 0, 0.1).facing(90, 10)).within(6))
                .isInstanceOf(AssertionFailedError.class)
                .hasMessageContaining("(2, 0) to within 0.1, heading 90 to within 10")
                .hasMessageContaining("came no nearer than 80 degrees short of its heading, after 4 steps");
        Robot other = robot().follows(each -> {
            if (!each.tries(new Move(
                    each.center().x() < 2 ? 0.5 : 0, 0, 0, 0, each.center().x() < 2 ? 0 : 45))) {
                throw new AssertionError("nothing is in the way");
            }
        });
        assertThatCode(() -> other.reaches(Goal.at(2, 0, 0.1).facing(90, 10)).within(6))
                .doesNotThrowAnyException();
    }

    /** Its places are passed between steps too, in their order only. */
    @Test
    void aPath() {
        List<Point> path = List.of(new Point(0.7, 9, 0.1), new Point(1.4, -9, 0), new Point(3, 0, 0));
        assertThatCode(() -> robot().follows(each -> each.drives(1))
                        .reaches(Goal.path(0.15, path))
                        .within(3))
                .doesNotThrowAnyException();
        List<Point> back = List.of(new Point(1.4, 0, 0), new Point(0.7, 0, 0));
        assertThatThrownBy(() -> robot().follows(each -> each.drives(2))
                        .reaches(Goal.path(0.15, back))
                        .within(3))
                .isInstanceOf(AssertionFailedError.class)
                .hasMessageContaining("(1.4, 0), then (0.7, 0), each to within 0.15")
                .hasMessageContaining("1.15 short of place 2 of 2, after 1 step ");
        // There and back: the second is passed on the way back.
        assertThatCode(() -> {
                    Robot robot = robot();
                    robot.follows(each -> each.drives(each.center().x() > 1 ? -2 : 2))
                            .reaches(Goal.path(0.15, back))
                            .within(2);
                })
                .doesNotThrowAnyException();
    }

    /** A path is followed anew in each assertion. */
    @Test
    void aGoalRemembersNothing() {
        Goal goal = Goal.path(0.1, List.of(new Point(1, 0, 0), new Point(2, 0, 0)));
        robot().follows(each -> each.drives(1)).reaches(goal).within(2);
        assertThatThrownBy(() ->
                        robot().follows(each -> each.drives(-1)).reaches(goal).within(2))
                .hasMessageContaining("0.9 short of place 1 of 2, after 0 steps");
    }

    @Test
    void whatIsNoGoal() {
        assertThatThrownBy(() -> Goal.heading(Double.NaN, 1)).hasMessageContaining("heading must be a finite angle");
        assertThatThrownBy(() -> Goal.heading(0, 181)).hasMessageContaining("tolerance must be 0 to 180 degrees");
        assertThatThrownBy(() -> Goal.at(0, 0, 1).facing(0, Double.NaN)).hasMessageContaining("tolerance must be");
        assertThatThrownBy(() -> Goal.path(1, List.of())).hasMessageContaining("places must hold at least one place");
        assertThatThrownBy(() -> Goal.path(-1, List.of(new Point()))).hasMessageContaining("radius must be at least 0");
    }
}
