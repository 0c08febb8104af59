package robosim.geometry.scenario;

import static org.assertj.core.api.Assertions.assertThat;
import static robosim.geometry.scenario.Conversation.move;
import static robosim.geometry.scenario.Conversation.sonar;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import robosim.geometry.protocol.DistanceBundle;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.MoveRequest;
import robosim.geometry.protocol.Problem;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.SonarRequest;
import robosim.geometry.protocol.SonarRequestBundle;
import robosim.geometry.protocol.StepBundle;
import robosim.geometry.protocol.motion.StopAnswer;

class MismatchTest {
    private static Mismatch distances(List<Double> expected, List<Double> got) {
        List<SonarRequest> requests = List.of(sonar("a", 1, 0), sonar("b", 0, 1, 0.5, 4, 0.25), sonar("c", 1, 1));
        Step step =
                new Step(7, List.of(), new SonarRequestBundle(requests), new Reply(new DistanceBundle(expected)), null);
        return Mismatch.of(3, step, new Reply(new DistanceBundle(got), List.of(Problem.of(2, "no such"))));
    }

    @Test
    void distancesAreTheSameByTheirBits() {
        double nan = Double.longBitsToDouble(0x7ff8_0000_dead_beefL);
        double none = Double.POSITIVE_INFINITY;
        assertThat(distances(List.of(1.5, none, Double.NaN), List.of(1.5, none, nan)))
                .isNull();
        assertThat(distances(List.of(0.0, 1.0, 1.0), List.of(-0.0, 1.0, 1.0))).isNotNull();
        assertThat(distances(List.of(1.0, 2.5, none), List.of(1.0, Math.nextUp(2.5), 3.0)))
                .hasToString("step 3 (line 7), request 1, a sonar of \"b\" towards (0.0, 0, 1.0) in [0.5, 4.0], 0.25"
                        + " wide: expected 2.5 (0x1.4p1), got 2.5000000000000004 (0x1.4000000000001p1), longer by"
                        + " 4.440892098500626E-16; and 1 more of this step");
        assertThat(distances(List.of(1.0, 1.0, none), List.of(1.0, 1.0, Double.NaN)))
                .hasToString("step 3 (line 7), request 2, a sonar of \"c\" towards (1.0, 0, 1.0): expected no echo, got"
                        + " no such object (NaN), no such");
    }

    private static Mismatch moves(List<MoveRequest> expected, List<MoveRequest> got) {
        List<MoveRequest> asked = List.of(move("a", 1, 0), move("b", 2, 0), move("a", 1, 0));
        Step step = new Step(0, List.of(), new MoveBundle(asked), new Reply(new MoveBundle(expected)), null);
        return Mismatch.of(1, step, new Reply(new MoveBundle(got), List.of(Problem.of(1, "blocked by a \"wall\""))));
    }

    @Test
    void movesAreTheSameInTheirOrder() {
        MoveRequest a = move("a", 1, 0);
        MoveRequest b = move("b", 2, 0);
        assertThat(moves(List.of(a, b, a), List.of(a, b, a))).isNull();
        assertThat(moves(List.of(), List.of())).isNull();
        assertThat(moves(List.of(a, b), List.of(a)))
                .hasToString(
                        "step 1, request 1, a move of \"b\" by (2.0, 0.0, 0.0): expected made, got refused, blocked"
                                + " by a \"wall\"");
        assertThat(moves(List.of(a), List.of(a, b, a)))
                .hasToString("step 1, request 1, a move of \"b\" by (2.0, 0.0, 0.0): expected refused, got made; and 1"
                        + " more of this step");
        assertThat(moves(List.of(move("a", 1, -0.0)), List.of(a)).others()).isZero();
        assertThat(moves(List.of(b, a, a), List.of(b, a)))
                .hasToString(
                        "step 1, 3 moves: expected among those made a move of \"a\" by (1.0, 0.0, 0.0), got no such"
                                + " request in its place");
    }

    /** A recording may be older than the reasons why bodies are stopped. */
    @Test
    void reasonsCountWhereTheyAreExpected() {
        List<StopAnswer> reasons = List.of(new StopAnswer("a", StopAnswer.Reason.BLOCKED, "wall"));
        StepBundle.Answer without = new StepBundle.Answer(List.of(), List.of(), List.of("a"));
        StepBundle.Answer with = new StepBundle.Answer(List.of(), List.of(), List.of("a"), reasons);
        assertThat(steps(without, with)).isNull();
        assertThat(steps(with, with)).isNull();
        assertThat(steps(with, without)).asString().contains("stops[0]", "wall", "got no more");
        assertThat(steps(without, new StepBundle.Answer(List.of(), List.of(), List.of())))
                .asString()
                .contains("stopped[0]");
    }

    private static @Nullable Mismatch steps(StepBundle.Answer expected, StepBundle.Answer got) {
        Step step = new Step(new StepBundle(1, List.of(), List.of()), new Reply(expected));
        return Mismatch.of(1, step, new Reply(got));
    }

    @Test
    void wordsDoNotCount() {
        Step step = new Step(
                new MoveBundle(List.of(move("a", 1, 0))),
                new Reply(new MoveBundle(List.of()), List.of(Problem.of(0, "some words"))));
        assertThat(Mismatch.of(1, step, new Reply(new MoveBundle(List.of())))).isNull();
        assertThat(new Replay(ScenarioReaderTest.OPTIONS).step(step)).isNull();
    }

    /** Of two equal moves one was made: which one, the moves themselves do not tell. */
    @Test
    void whichOfEqualMovesWereRefusedCounts() {
        MoveRequest a = move("a", 1, 0);
        MoveBundle asked = new MoveBundle(List.of(a, a, move("b", 0, 0)));
        MoveBundle made = new MoveBundle(List.of(a, move("b", 0, 0)));
        Step step = new Step(4, List.of(), asked, new Reply(made, List.of(Problem.of(1, "the wall"))), null);
        assertThat(Mismatch.of(2, step, new Reply(made, List.of(Problem.of(1, "other words")))))
                .isNull();
        assertThat(Mismatch.of(2, step, new Reply(made))).as("nothing told").isNull();
        assertThat(Mismatch.of(2, step, new Reply(made, List.of(Problem.of(0, "it")))))
                .hasToString(
                        "step 2 (line 4), request 0, a move of \"a\" by (1.0, 0.0, 0.0): expected made, got refused,"
                                + " it; and 1 more of this step");
        Step stray = new Step(4, List.of(), asked, new Reply(asked, List.of(Problem.of(7, "none"))), null);
        assertThat(Mismatch.of(2, stray, new Reply(asked)))
                .hasToString("step 2 (line 4), 3 moves: expected move 7 refused, got no such move");
        Step allMade = new Step(4, List.of(), asked, new Reply(asked, List.of(Problem.of(2, "wall"))), null);
        assertThat(Mismatch.of(2, allMade, new Reply(asked)))
                .hasToString(
                        "step 2 (line 4), request 2, a move of \"b\" by (0.0, 0.0, 0.0): expected refused, got made");
    }

    @Test
    void whatIsNotExpectedIsNotCompared() {
        Replay replay = new Replay(ScenarioReaderTest.OPTIONS);
        assertThat(replay.step(new Step(new MoveBundle(List.of(move("a", 1, 0))), null)))
                .isNull();
        assertThat(replay.reply()).isNotNull();
        assertThat(replay.steps()).isEqualTo(1);
        assertThat(replay.compared()).isZero();
    }
}
