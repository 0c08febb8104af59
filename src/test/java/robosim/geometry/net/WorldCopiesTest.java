package robosim.geometry.net;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import robosim.geometry.WorkLimit;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.net.session.LogBudget;
import robosim.geometry.protocol.BatchAnswerBundle;
import robosim.geometry.protocol.BatchRequestBundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.StepBundle;
import robosim.geometry.protocol.batch.BatchAnswer;
import robosim.geometry.protocol.batch.BatchRequest;
import robosim.geometry.protocol.batch.BeamPattern;
import robosim.geometry.protocol.batch.CopyRequest;
import robosim.geometry.protocol.batch.NoAnswer;
import robosim.geometry.protocol.batch.Numbers;
import robosim.geometry.protocol.batch.SenseAnswer;
import robosim.geometry.protocol.batch.SenseRequest;
import robosim.geometry.protocol.batch.TickAnswer;
import robosim.geometry.protocol.batch.WorldAnswer;
import robosim.geometry.protocol.batch.WorldRequest;
import robosim.geometry.protocol.motion.BodyAnswer;
import robosim.geometry.protocol.motion.BodyRequest;
import robosim.geometry.protocol.motion.ContactAnswer;
import robosim.geometry.protocol.motion.DriveCommand;
import robosim.geometry.protocol.motion.SurfaceMixing;

/** Copies of a session's world have the bits of sessions of their own. */
class WorldCopiesTest {
    private static final int COPIES = 5;
    private static final SenseRequest LASER = new SenseRequest("robot", new BeamPattern.Fan(-1, 0.1, 21));

    private static InitBundle world() {
        List<GeometryObject> objects = new ArrayList<>();
        objects.add(new BoxObject(new Point(2, 0, 0), 0.4, 1, 4).named("wall"));
        objects.add(new CylinderObject(new Point(-1, 0, 2), 0.3, 1).moveable("crate"));
        objects.add(new CylinderObject(new Point(), 0.25, 1).moveable("robot"));
        objects.add(new CylinderObject(new Point(-9, 0, 9), 0.25, 1));
        return new InitBundle(objects);
    }

    private static StepBundle bodies() {
        return new StepBundle(
                0,
                List.of(BodyRequest.of("robot"), BodyRequest.of("crate")),
                List.of(),
                new SurfaceMixing(SurfaceMixing.Rule.LARGER, SurfaceMixing.Rule.SMALLER),
                List.of());
    }

    private static Session begun(int start) {
        Session session = new Session();
        session.answer(world());
        answers(session, new WorldRequest.Place("robot", new Point(0, 0, 0.2 * start), 0.5 * start));
        session.answer(bodies());
        return session;
    }

    private static List<BatchAnswer> answers(Session session, BatchRequest... requests) {
        return ((BatchAnswerBundle) session.answer(new BatchRequestBundle(List.of(requests)))).answers();
    }

    private static CopyRequest.Tick tick(double... commands) {
        return new CopyRequest.Tick("robot", Numbers.of(commands), List.of("robot", "crate"), List.of(LASER), false);
    }

    @Test
    void copiesGoOnAsSessionsOfTheirOwn() {
        Session many = new Session();
        List<Session> single = new ArrayList<>();
        for (int k = 0; k < COPIES; k++) {
            many.answer(world()); // the earlier copies stay
            answers(many, new WorldRequest.Place("robot", new Point(0, 0, 0.2 * k), 0.5 * k));
            many.answer(bodies());
            assertThat(answers(many, new CopyRequest.Make(k))).containsExactly(new WorldAnswer.Changed(true, null));
            single.add(begun(k));
        }
        SplittableRandom random = new SplittableRandom(6);
        int touching = 0;
        for (int round = 0; round < 60; round++) {
            double[] commands = new double[4 * COPIES];
            for (int k = 0; k < COPIES; k++) {
                commands[4 * k] = (round + k) % 7 == 0 ? 0 : 0.1;
                commands[4 * k + 1] = random.nextDouble(-1, 3);
                commands[4 * k + 3] = random.nextDouble(-1, 1);
            }
            TickAnswer answer = (TickAnswer) answers(many, tick(commands)).get(0);
            assertThat(answer.fits(tick(commands))).isTrue();
            for (int k = 0; k < COPIES; k++) {
                touching += check(answer, k, single.get(k), commands);
            }
        }
        assertThat(touching).isBetween(20, 280);
    }

    /** Compares a copy with a session; returns the number of touches of its robot. */
    private static int check(TickAnswer answer, int k, Session session, double[] commands) {
        double seconds = commands[4 * k];
        List<DriveCommand> command = seconds == 0
                ? List.of()
                : List.of(new DriveCommand("robot", commands[4 * k + 1], 0, commands[4 * k + 3]));
        StepBundle.Answer step = (StepBundle.Answer) session.answer(new StepBundle(seconds, List.of(), command));
        for (int body = 0; body < 2; body++) {
            BodyAnswer one = step.bodies().get(body);
            double[] state = new double[8];
            answer.states().copy(8 * (2 * k + body), 8, state);
            assertThat(state)
                    .containsExactly(
                            one.center().x(),
                            one.center().y(),
                            one.center().z(),
                            one.heading(),
                            one.velocity().x(),
                            one.velocity().y(),
                            one.velocity().z(),
                            one.velocity().ry());
        }
        Numbers distances = ((SenseAnswer) answers(session, LASER).get(0)).distances();
        double[] beams = new double[21];
        answer.distances().copy(21 * k, 21, beams);
        assertThat(new Numbers(beams)).isEqualTo(distances);
        long touches = step.contacts().stream()
                .filter(each -> each.phase() != ContactAnswer.Phase.END)
                .filter(each -> each.objectName().equals("robot") && !"crate".equals(each.other()))
                .count();
        assertThat(answer.touches().get(2 * k)).isEqualTo((int) touches);
        return (int) touches;
    }

    @Test
    void whatIsAttachedIsSoInACopy() {
        Session many = begun(1);
        Session single = begun(1);
        WorldRequest.Attach attach = new WorldRequest.Attach("crate", "robot", null);
        answers(many, attach);
        answers(single, attach);
        answers(many, new CopyRequest.Make(0));
        answers(many, new WorldRequest.Detach("crate"));
        for (int round = 0; round < 20; round++) {
            double[] commands = {0.1, 1.5, 0, 0.1 * round - 1};
            check((TickAnswer) answers(many, tick(commands)).get(0), 0, single, commands);
        }
    }

    @Test
    void aCopyIsReplacedAndTheWorldStays() {
        Session session = begun(0);
        answers(session, new CopyRequest.Make(0));
        answers(session, tick(1, 1, 0, 0));
        assertThat(answers(session, new WorldRequest.Locate("robot")).toString())
                .contains("x=0.0");
        TickAnswer moved = (TickAnswer) answers(session, tick(0, 0, 0, 0)).get(0);
        assertThat(moved.states().get(0)).isGreaterThan(0.9);
        answers(session, new CopyRequest.Make(0));
        assertThat(((TickAnswer) answers(session, tick(0, 0, 0, 0)).get(0))
                        .states()
                        .get(0))
                .isZero();
    }

    @Test
    void distancesInSinglePrecisionAreThoseRounded() {
        Session session = begun(0);
        answers(session, new CopyRequest.Make(0));
        CopyRequest.Tick exact = tick(0, 0, 0, 0);
        CopyRequest.Tick single = new CopyRequest.Tick("robot", exact.commands(), exact.bodies(), exact.senses(), true);
        TickAnswer rounded = (TickAnswer) answers(session, single).get(0);
        TickAnswer answer = (TickAnswer) answers(session, exact).get(0);
        assertThat(rounded.fits(single)).isTrue();
        assertThat(rounded.fits(exact)).isFalse();
        assertThat(rounded.distances().size()).isZero();
        for (int k = 0; k < 21; k++) {
            assertThat(Float.intBitsToFloat(rounded.singles().get(k)))
                    .isEqualTo((float) answer.distances().get(k));
        }
    }

    @Test
    void whatCannotBeIsRefusedWithItsRemedy() {
        Session session = begun(0);
        refused(session, new CopyRequest.Make(1), "index must be that of a copy, or of the next one, 0 (got: 1)");
        refused(session, tick(0.1, 0, 0, 0), "make more by requests of kind copy (got: for 1)");
        answers(session, new CopyRequest.Make(0));
        refused(session, new CopyRequest.Tick("robot", Numbers.of(), List.of(), List.of(), true), "");
        refused(
                session,
                new CopyRequest.Tick("robot", Numbers.of(0, 0, 0, 0), List.of("nobody"), List.of(), false),
                "bodies must have a body");
        refused(
                session,
                new CopyRequest.Tick("nobody", Numbers.of(1, 0, 0, 0), List.of(), List.of(), false),
                "no body of \"nobody\"");
        SenseRequest missing = new SenseRequest("nobody", new BeamPattern.Fan(-1, 0.1, 21));
        SenseRequest still = new SenseRequest("wall", new BeamPattern.Fan(-1, 0.1, 21));
        for (SenseRequest wrong : List.of(missing, still)) {
            refused(
                    session,
                    new CopyRequest.Tick("robot", Numbers.of(1, 1, 0, 0), List.of(), List.of(LASER, wrong), false),
                    "senses must be on moveable objects, or stand in the world");
        }
        TickAnswer answer = (TickAnswer) answers(session, tick(0, 0, 0, 0)).get(0);
        assertThat(answer.states().get(0))
                .as("what is refused leaves the copies as they were")
                .isZero();
    }

    private static void refused(Session session, BatchRequest request, String reason) {
        Reply reply = session.reply(new BatchRequestBundle(List.of(request)));
        if (reason.isEmpty()) {
            assertThat(reply.problems()).isEmpty();
            return;
        }
        assertThat(((BatchAnswerBundle) reply.bundle()).answers()).containsExactly(new NoAnswer());
        assertThat(reply.problems().get(0).reason()).contains(reason);
    }

    @Test
    void aTickThatIsEndedLeavesNoHalf() {
        AtomicInteger left = new AtomicInteger(Integer.MAX_VALUE);
        WorkLimit limit = WorkLimit.of(Long.MAX_VALUE).pausing(() -> {
            if (left.getAndDecrement() == 0) {
                throw new IllegalStateException("ended");
            }
        });
        Session session = begun(0).pausing(() -> limitTo(left), new LogBudget(System::nanoTime))
                .within(limit);
        answers(session, new CopyRequest.Make(0));
        answers(session, new CopyRequest.Make(1));
        left.set(3);
        try {
            answers(session, tick(1, 1, 0, 0, 1, 1, 0, 0));
        } catch (IllegalStateException e) {
            assertThat(e).hasMessage("ended");
        }
        left.set(Integer.MAX_VALUE);
        refused(session, tick(0.1, 0, 0, 0), "the 0 copies");
        assertThat(answers(session, new CopyRequest.Make(0))).containsExactly(new WorldAnswer.Changed(true, null));
    }

    private static void limitTo(AtomicInteger left) {
        if (left.getAndDecrement() <= 0) {
            throw new IllegalStateException("ended");
        }
    }
}
