package robosim.geometry.net;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import robosim.geometry.Geometry;
import robosim.geometry.dynamics.Body;
import robosim.geometry.dynamics.DifferentialDrive;
import robosim.geometry.dynamics.Dynamics;
import robosim.geometry.dynamics.StepResult;
import robosim.geometry.dynamics.Surface;
import robosim.geometry.exact.Degrees;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.net.pace.CpuTurn;
import robosim.geometry.net.session.BodyStepper;
import robosim.geometry.net.session.LogBudget;
import robosim.geometry.protocol.BatchRequestBundle;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.MoveRequest;
import robosim.geometry.protocol.Problem;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.StepBundle;
import robosim.geometry.protocol.WorldSettings;
import robosim.geometry.protocol.batch.WorldRequest;
import robosim.geometry.protocol.motion.BodyAnswer;
import robosim.geometry.protocol.motion.BodyRequest;
import robosim.geometry.protocol.motion.ContactAnswer;
import robosim.geometry.protocol.motion.DriveCommand;
import robosim.geometry.protocol.motion.DriveSettings;
import robosim.geometry.protocol.motion.PushRequest;
import robosim.geometry.protocol.motion.StopAnswer;
import robosim.geometry.protocol.motion.SurfaceMixing;
import robosim.geometry.protocol.motion.SurfaceSettings;
import robosim.geometry.protocol.motion.Velocity;

/** Steps of a session are those of {@link Dynamics}, to the bit. */
class StepSessionTest {
    private static final WorldSettings PLANE = new WorldSettings(40, 5, 40, Dimension.PLANAR, Accuracy.EXACT);

    private static final List<GeometryObject> OBJECTS = List.of(
            new BoxObject(new Point(6, 0, 0), 1, 2, 8).turned(0, 5).named("wall"),
            new CylinderObject(new Point(0, 0, 0), 0.5, 1).moveable("cart"),
            new BoxObject(new Point(2, 0, 0.3), 1, 1, 1).moveable("crate"),
            new CylinderObject(new Point(-5, 0, 0), 0.5, 1).moveable("ball"));

    private static Session session() {
        Session session = new Session();
        session.reply(new InitBundle(OBJECTS, PLANE));
        return session;
    }

    private static StepBundle.Answer step(Session session, StepBundle step) {
        return (StepBundle.Answer) reply(session, step).bundle();
    }

    private static Reply reply(Session session, StepBundle step) {
        return Objects.requireNonNull(session.reply(step));
    }

    @Test
    void aVelocityUpwardsIsRefusedWhereThereIsNoUp() {
        BodyRequest crate = BodyRequest.of("crate").withVelocity(new Velocity(1, 0.5, 0, 0));
        Reply reply = reply(session(), new StepBundle(1, List.of(crate), List.of()));
        StepBundle.Answer answer = (StepBundle.Answer) reply.bundle();
        assertThat(answer.bodies()).as("nothing is left of it").isEmpty();
        assertThat(reply.problems().get(0).reason())
                .contains("velocity must have no part upwards in a PLANAR world; set y to 0");
    }

    @Test
    void pushesActOnceAndWhatIsWrongIsLeftOut() {
        Session session = session();
        BodyRequest smooth = BodyRequest.of("crate").withMass(10).withFloorFriction(0);
        Reply reply = reply(
                session,
                new StepBundle(
                        0.5,
                        List.of(smooth),
                        List.of(),
                        null,
                        List.of(
                                PushRequest.impulse("crate", new Point(-5, 0, 0)),
                                PushRequest.force("wall", new Point(1, 0, 0)),
                                PushRequest.impulse("ball", new Point(0, 1, 0)),
                                PushRequest.force("crate", new Point(0, 0, 20)))));
        assertThat(reply.problems()).extracting(Problem::index).containsExactly(2, 3);
        assertThat(reply.problems().get(1).reason()).contains("impulse must be level in a PLANAR world");
        BodyAnswer crate = ((StepBundle.Answer) reply.bundle()).bodies().get(0);
        assertThat(crate.velocity()).isEqualTo(new Velocity(-0.5, 0, 1, 0));
        StepBundle.Answer later = step(session, new StepBundle(0.5, List.of(), List.of()));
        assertThat(later.bodies().get(0).velocity()).isEqualTo(new Velocity(-0.5, 0, 1, 0));
    }

    @Test
    void aDriveOfKindNoneTakesTheDriveFromABody() {
        Session session = session();
        BodyRequest ball = BodyRequest.of("ball").withFloorFriction(0);
        step(
                session,
                new StepBundle(
                        1,
                        List.of(ball.withDrive(DriveSettings.of(DriveSettings.Kind.VELOCITY))),
                        List.of(new DriveCommand("ball", 0, 1, 0))));
        BodyRequest coasts = ball.withDrive(DriveSettings.of(DriveSettings.Kind.NONE));
        StepBundle.Answer answer = step(
                session,
                new StepBundle(
                        1, List.of(coasts), List.of(), null, List.of(PushRequest.impulse("ball", new Point(0, 0, 0)))));
        assertThat(answer.bodies().get(0).velocity().z()).isEqualTo(1);
        assertThat(answer.bodies().get(0).center().z()).isEqualTo(2);
    }

    @Test
    void aBodyPassesThroughWhatItIgnoresAndAnUnknownNameIsRefused() {
        Session session = session();
        BodyRequest crate = BodyRequest.of("crate").withFloorFriction(0).withVelocity(new Velocity(8, 0, 0, 0));
        Reply refused = reply(session, new StepBundle(0, List.of(crate.ignoring(List.of("wal"))), List.of()));
        assertThat(refused.problems().get(0).reason()).contains("perhaps \"wall\" (got: \"wal\")");
        StepBundle.Answer answer =
                step(session, new StepBundle(1, List.of(crate.ignoring(List.of("wall", "cart"))), List.of()));
        assertThat(answer.contacts()).isEmpty();
        assertThat(answer.bodies().get(0).center().x()).isEqualTo(10, within(1e-9));
    }

    @Test
    void aSessionStepsAsDynamicsDo() {
        Session session = session();
        StepBundle.Answer first = step(
                session,
                new StepBundle(
                        0,
                        List.of(
                                new BodyRequest(
                                        "crate",
                                        5,
                                        1,
                                        new SurfaceSettings(0.5, 0.5, 0.25),
                                        1,
                                        2,
                                        3,
                                        Math.PI,
                                        0.125,
                                        null,
                                        null,
                                        0,
                                        0,
                                        List.of()),
                                BodyRequest.of("cart").withMass(20).withDrive(DriveSettings.DEFAULT),
                                BodyRequest.of("wall").withSurface(new SurfaceSettings(0.25, 0, 0))),
                        List.of()));
        assertThat(first.bodies()).extracting(BodyAnswer::objectName).containsExactly("crate", "cart");

        Geometry twin = new Geometry(40, 5, 40, Dimension.PLANAR, Accuracy.EXACT);
        OBJECTS.forEach(twin::addObjectUnchecked);
        Dynamics dynamics = new Dynamics(twin, Surface.SMOOTH);
        dynamics.add(
                "crate",
                Body.of(5, 1)
                        .withSurface(new Surface(0.5, 0.5, 0.25))
                        .withDamping(1, 2)
                        .withLimits(3, 180)
                        .withFloorFriction(0.125));
        dynamics.add("cart", Body.ofMass(OBJECTS.get(1), 20).withFloorFriction(0.5));
        dynamics.surface("wall", new Surface(0.25, 0, 0));
        DifferentialDrive drive = new DifferentialDrive(1, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY);
        dynamics.drive("cart", drive);
        int met = 0;
        Set<ContactAnswer.Phase> phases = EnumSet.noneOf(ContactAnswer.Phase.class);
        for (int k = 0; k < 200; k++) {
            double turn = 0.3 * Math.sin(k * 0.1);
            StepBundle.Answer answer =
                    step(session, new StepBundle(0.05, List.of(), List.of(new DriveCommand("cart", 1.5, turn))));
            dynamics.drive("cart", drive.driving(1.5, Degrees.toDegrees(turn)));
            StepResult result = dynamics.step(0.05);
            for (BodyAnswer body : answer.bodies()) {
                GeometryObject object = twin.getObject(body.objectName());
                assertThat(body.center()).isEqualTo(object.center());
                assertThat(body.heading()).isEqualTo(Degrees.toRadians(object.heading()));
                assertThat(body.velocity().x())
                        .isEqualTo(dynamics.velocity(body.objectName()).x());
                assertThat(Objects.requireNonNull(session.world()).getObject(body.objectName()))
                        .isEqualTo(object);
            }
            assertThat(answer.contacts())
                    .extracting(ContactAnswer::impulse)
                    .isEqualTo(Stream.concat(result.contacts().stream(), result.ended().stream())
                            .map(each -> each.impulse())
                            .toList());
            answer.contacts().forEach(each -> phases.add(each.phase()));
            assertThat(answer.stopped()).isEqualTo(result.stopped());
            assertThat(answer.stops()).hasSameSizeAs(result.stops());
            met += answer.contacts().size();
        }
        assertThat(met).isGreaterThan(3);
        assertThat(phases).containsExactlyInAnyOrder(ContactAnswer.Phase.values());
    }

    @Test
    void whatCannotBeGivenIsLeftOutAndTheRestIsDone() {
        Session session = session();
        Reply reply = reply(
                session,
                new StepBundle(
                        1,
                        List.of(
                                BodyRequest.of("nobody"),
                                BodyRequest.of("ball").withFloorFriction(0).withVelocity(new Velocity(1, 0, 0, 0))),
                        List.of(new DriveCommand("wall", 1, 0), new DriveCommand("cart", -1, 0))));
        assertThat(reply.problems()).extracting(problem -> problem.index()).containsExactly(0, 2);
        assertThat(reply.problems().get(0).reason()).contains("\"nobody\"");
        assertThat(reply.problems().get(1).reason()).contains("moveable");
        StepBundle.Answer answer = (StepBundle.Answer) reply.bundle();
        assertThat(answer.bodies()).extracting(BodyAnswer::objectName).containsExactly("ball", "cart");
        assertThat(answer.bodies().get(0).center().x()).isEqualTo(-4);
        assertThat(answer.bodies().get(1).center().x()).isEqualTo(-1);
    }

    /** Boxes stand for two discs that miss each other: each step is answered with the reason, and the first of a world is logged. */
    @Test
    void aStopIsAnsweredWithItsReasonAndLoggedOnce() {
        List<GeometryObject> objects = List.of(
                new CylinderObject(new Point(), 1, 1).moveable("disc"),
                new CylinderObject(new Point(2.1, 0, 1.7), 1, 1).named("post"));
        WorldSettings boxes = new WorldSettings(40, 5, 40, Dimension.PLANAR, Accuracy.AABB);
        BodyRequest going = BodyRequest.of("disc").withFloorFriction(0).withVelocity(new Velocity(1, 0, -0.2, 0));
        Session session = new Session();
        try (LogCapture log = new LogCapture()) {
            for (int world = 1; world <= 2; world++) {
                session.reply(new InitBundle(objects, boxes));
                for (int step = 0; step < 2; step++) {
                    assertThat(step(session, new StepBundle(2, List.of(going), List.of()))
                                    .stops())
                            .containsExactly(new StopAnswer("disc", StopAnswer.Reason.BLOCKED, "post"));
                }
                assertThat(log.linesWith("\"disc\" (BLOCKED by \"post\")")).hasSize(world);
            }
        }
    }

    /** A body or a command that is refused leaves no body behind: here two wheels without a distance between them. */
    @Test
    void whatIsRefusedIsNoBody() {
        Geometry world = new Geometry(40, 5, 40, Dimension.PLANAR, Accuracy.EXACT);
        world.addObject(new BoxObject(new Point(), 1, 1, 0).moveable("sheet"));
        BodyStepper motion = new BodyStepper(world);
        BodyRequest heavy = BodyRequest.of("sheet").withMass(5);
        List<StepBundle> steps = List.of(
                new StepBundle(1, List.of(heavy.withDrive(DriveSettings.DEFAULT)), List.of()),
                new StepBundle(1, List.of(), List.of(new DriveCommand("sheet", 1, 0))));
        for (StepBundle step : steps) {
            List<String> reasons = new ArrayList<>();
            assertThat(motion.step(step, (index, reason) -> reasons.add(reason)).bodies())
                    .isEmpty();
            assertThat(reasons).hasSize(1);
            assertThat(motion.has("sheet")).isFalse();
        }
        assertThat(motion.step(new StepBundle(1, List.of(heavy), List.of()), (index, reason) -> {})
                        .bodies())
                .hasSize(1);
    }

    /** Another object of a body's name has neither its body nor the drive that it was given. */
    @Test
    void anotherObjectOfTheNameIsNoBody() {
        Geometry world = new Geometry(40, 5, 40, Dimension.PLANAR, Accuracy.EXACT);
        CylinderObject cart = new CylinderObject(new Point(), 0.5, 1).moveable("cart");
        world.addObject(cart);
        BodyStepper motion = new BodyStepper(world);
        BodyRequest given = BodyRequest.of("cart").withDrive(DriveSettings.of(DriveSettings.Kind.OMNIDIRECTIONAL));
        List<DriveCommand> aside = List.of(new DriveCommand("cart", 0, 1, 0));
        List<String> reasons = new ArrayList<>();
        motion.step(new StepBundle(1, List.of(given), aside), (index, reason) -> reasons.add(reason));
        assertThat(world.getObject("cart").center().z()).isEqualTo(1);
        world.removeObject("cart");
        world.addObject(cart);
        StepBundle.Answer answer = motion.step(new StepBundle(1, List.of(), List.of()), (index, reason) -> {});
        assertThat(answer.bodies()).isEmpty();
        assertThat(world.getObject("cart").center().z()).isZero();
        assertThat(reasons).isEmpty();
        motion.step(new StepBundle(1, List.of(), aside), (index, reason) -> reasons.add(reason));
        assertThat(reasons.get(0)).contains("right must be 0 for a drive of kind DIFFERENTIAL");
    }

    /** Wheels that do not swivel cannot go to the right: nobody is told that they do. */
    @Test
    void aCommandThatItsDriveCannotFollowIsRefused() {
        Session session = session();
        for (DriveSettings.Kind kind : DriveSettings.Kind.values()) {
            if (kind == DriveSettings.Kind.NONE) {
                continue; // without a drive, a command gives it a differential one
            }
            Reply reply = reply(
                    session,
                    new StepBundle(
                            0,
                            List.of(BodyRequest.of("ball").withDrive(DriveSettings.of(kind))),
                            List.of(new DriveCommand("ball", 0, 0.3, 0))));
            if (kind == DriveSettings.Kind.DIFFERENTIAL || kind == DriveSettings.Kind.ACKERMANN) {
                assertThat(reply.problems()).singleElement().satisfies(problem -> {
                    assertThat(problem.index()).isEqualTo(1);
                    assertThat(problem.reason())
                            .isEqualTo("right must be 0 for a drive of kind " + kind
                                    + "; give \"ball\" a body with a drive"
                                    + " of kind OMNIDIRECTIONAL, SWERVE, VELOCITY or FORCE (got: 0.3)");
                });
            } else {
                assertThat(reply.problems()).isEmpty();
            }
        }
        Reply unseen = reply(session, new StepBundle(0, List.of(), List.of(new DriveCommand("cart", 1, -0.1, 0))));
        assertThat(unseen.problems()).hasSize(1);
        assertThat(((StepBundle.Answer) unseen.bundle()).bodies())
                .as("what is refused makes no body")
                .extracting(BodyAnswer::objectName)
                .doesNotContain("cart");
    }

    @Test
    void aMoveBetweenStepsCounts() {
        Session session = session();
        step(session, new StepBundle(0, List.of(BodyRequest.of("ball")), List.of()));
        session.reply(new MoveBundle(List.of(new MoveRequest("ball", 0, 0, 2, 0, 0))));
        assertThat(step(session, new StepBundle(1, List.of(), List.of()))
                        .bodies()
                        .get(0)
                        .center())
                .isEqualTo(new Point(-5, 0, 2));
    }

    @Test
    void aNewWorldHasNoBodies() {
        Session session = session();
        step(session, new StepBundle(0, List.of(BodyRequest.of("ball")), List.of()));
        session.reply(new InitBundle(OBJECTS, PLANE));
        assertThat(step(session, new StepBundle(1, List.of(), List.of())).bodies())
                .isEmpty();
    }

    @Test
    void withoutAWorldNothingMoves() {
        Reply reply = reply(new Session(), new StepBundle(1, List.of(BodyRequest.of("ball")), List.of()));
        assertThat(((StepBundle.Answer) reply.bundle()).bodies()).isEmpty();
        assertThat(reply.problems().get(0).reason()).isEqualTo("there is no world yet");
    }

    @Test
    void anAnswerIsNoRequest() {
        StepBundle.Answer answer = new StepBundle.Answer(List.of(), List.of(), List.of());
        assertThatThrownBy(() -> new Session().reply(answer))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("a StepBundle");
    }

    @Test
    void everyShapeHasABodyOfItsOwn() {
        Session session = session();
        StepBundle.Answer answer = step(
                session,
                new StepBundle(
                        0.5,
                        List.of(BodyRequest.of("cart").withDrive(DriveSettings.of(DriveSettings.Kind.FORCE))),
                        List.of(new DriveCommand("cart", 100, 0))));
        // 200 kg/m^3 of a cylinder of radius 0.5 m and height 1 m.
        double mass = 200 * Math.PI * 0.25;
        assertThat(answer.bodies().get(0).velocity().x())
                .isCloseTo(100 * 0.5 / mass, org.assertj.core.data.Offset.offset(1e-12));
    }

    @Test
    void bodiesFallWhereHeightsCount() {
        Session session = new Session();
        session.reply(new InitBundle(
                List.of(
                        new BoxObject(new Point(0, -0.5, 0), 10, 1, 10).named("floor"),
                        new BoxObject(new Point(0, 2, 0), 1, 0.5, 0.5)
                                .turned(0, 40)
                                .moveable("crate"),
                        new CylinderObject(new Point(3, 0.5001, 0), 0.5, 1).moveable("cart")),
                new WorldSettings(40, 20, 40, Dimension.SPATIAL, Accuracy.EXACT)));
        int[] breaths = new int[1];
        session.pausing(() -> breaths[0]++, new LogBudget(System::nanoTime));
        StepBundle.Answer fallen =
                step(session, new StepBundle(2, List.of(BodyRequest.of("crate"), BodyRequest.of("cart")), List.of()));
        assertThat(fallen.bodies().get(0).center().y()).isCloseTo(0.25, within(1e-6));
        assertThat(breaths[0]).as("parts of the step").isGreaterThan(100);
        assertThat(fallen.contacts().get(0).other()).isEqualTo("floor");
        double from = fallen.bodies().get(1).center().x();
        StepBundle.Answer driven =
                step(session, new StepBundle(1, List.of(), List.of(new DriveCommand("cart", 1, 0, 0))));
        // Friction of half a g takes it to its speed.
        double gain = 0.5 * 9.80665;
        assertThat(driven.bodies().get(1).center().x() - from).isCloseTo(1 - 0.5 / gain, within(1e-3));
        assertThat(driven.bodies().get(1).velocity().x()).isCloseTo(1, within(1e-6));
    }

    /** However many bodies a step has and however long it is, others wait for no more than a part of it. */
    @Test
    void aStepIsDoneInParts() {
        Session session = new Session();
        List<GeometryObject> discs = new ArrayList<>();
        List<BodyRequest> bodies = new ArrayList<>();
        for (int k = 0; k < 400; k++) {
            Point place = new Point(k % 20 - 10, 0, k / 20 - 10);
            discs.add(new CylinderObject(place, 0.3, 1).moveable("disc " + k));
            bodies.add(BodyRequest.of("disc " + k)
                    .withFloorFriction(0)
                    .withVelocity(new Velocity(Math.cos(k), 0, Math.sin(k), 0)));
        }
        session.reply(new InitBundle(discs, PLANE));
        int[] breaths = new int[1];
        session.pausing(() -> breaths[0]++, new LogBudget(System::nanoTime));
        step(session, new StepBundle(0, bodies, List.of()));
        assertThat(breaths[0]).as("bodies are given, and told").isGreaterThanOrEqualTo(2 * 400);
        breaths[0] = 0;
        StepBundle.Answer answer = step(session, new StepBundle(2, List.of(), List.of()));
        // Each is paired up with others, meets some of them, is carried in the world, and told.
        assertThat(answer.contacts()).hasSizeGreaterThan(100);
        assertThat(breaths[0]).isGreaterThan(5 * 400);
    }

    /** A server that closes does not wait for the end of a step. */
    @Test
    void aStepEndsWhereItsSessionIsCutOff() {
        Session session = session();
        step(session, new StepBundle(0, List.of(BodyRequest.of("ball")), List.of(new DriveCommand("ball", 1, 0))));
        int[] left = {5};
        session.pausing(
                () -> {
                    if (--left[0] < 0) {
                        throw new CpuTurn.CutOff();
                    }
                },
                new LogBudget(System::nanoTime));
        StepBundle hour = new StepBundle(3600, List.of(), List.of());
        assertThatThrownBy(() -> session.reply(hour)).isInstanceOf(CpuTurn.CutOff.class);
    }

    /** Onto the border and onto a floor, in the contact that ends it; the border's is logged too, once. */
    @Test
    void aFallIsAnsweredAndLogged() {
        try (LogCapture log = new LogCapture()) {
            Session session = new Session();
            List<GeometryObject> objects = List.of(
                    new BoxObject(new Point(0, 0, 6), 20, 0.5, 2).named("table"),
                    new CylinderObject(new Point(0, 0.5, 6), 0.5, 0.5).moveable("cart"),
                    new CylinderObject(new Point(0, 0.5, 0), 0.5, 0.5).moveable("ball"),
                    new CylinderObject(new Point(5, 1.5, 6), 0.5, 0.5).moveable("jar"));
            session.reply(new InitBundle(objects, new WorldSettings(40, 5, 40, Dimension.SPATIAL, Accuracy.EXACT)));
            List<BodyRequest> bodies = List.of(BodyRequest.of("cart"), BodyRequest.of("ball"), BodyRequest.of("jar"));
            Map<String, Double> falls = new TreeMap<>();
            falls(step(session, new StepBundle(0.1, bodies, List.of())), falls);
            for (int k = 0; k < 20; k++) {
                falls(step(session, new StepBundle(0.1, List.of(), List.of())), falls);
            }
            assertThat(falls).containsOnlyKeys("ball onto null", "jar onto table");
            assertThat(falls.get("ball onto null")).isCloseTo(2.75, within(0.01));
            assertThat(falls.get("jar onto table")).isCloseTo(1, within(0.01));
            assertThat(log.lines().stream().filter(line -> line.contains("has fallen")))
                    .singleElement()
                    .asString()
                    .containsPattern(
                            "\"ball\" has fallen 2\\.7.* onto the lower border of the world; if it should stand on a"
                                    + " floor, add one");
        }
    }

    /** A car turns about its rear axle, so what is ahead of it goes sideways: v = w * ahead, with w = v * tan(steering) / base. */
    @Test
    void theCentreOfACarMayBeAheadOfItsRearAxle() {
        for (double ahead : new double[] {0, 1.25}) {
            Session session = new Session();
            session.reply(new InitBundle(
                    List.of(new BoxObject(new Point(), 3, 1, 1.5).moveable("car")),
                    new WorldSettings(90, 5, 90, Dimension.PLANAR, Accuracy.EXACT)));
            DriveSettings drive =
                    new DriveSettings(DriveSettings.Kind.ACKERMANN, 2.5, 9, 1e6, 1, 1.0 / 0).withCentreAhead(ahead);
            StepBundle.Answer answer = step(
                    session,
                    new StepBundle(
                            0.1,
                            List.of(BodyRequest.of("car").withDrive(drive)),
                            List.of(new DriveCommand("car", 2, 0, 0.5))));
            double turn = 2 * Math.tan(0.5) / 2.5;
            assertThat(answer.bodies().get(0).velocity().ry()).isCloseTo(turn, within(1e-9));
            assertThat(answer.bodies().get(0).velocity().z()).isCloseTo(-turn * ahead, within(1e-9));
        }
    }

    /** By the geometric mean a surface that does not bounce makes none that does; by the larger of two the other counts. */
    @Test
    void rulesForSurfacesHoldUntilOthersAreGiven() {
        Session session = new Session();
        session.reply(new InitBundle(
                List.of(
                        new CylinderObject(new Point(), 0.5, 1).moveable("ball"),
                        new BoxObject(new Point(3, 0, 0), 1, 1, 5)),
                PLANE));
        BodyRequest ball =
                BodyRequest.of("ball").withSurface(new SurfaceSettings(1, 0, 0)).withVelocity(new Velocity(1, 0, 0, 0));
        SurfaceMixing larger = new SurfaceMixing(SurfaceMixing.Rule.LARGER, SurfaceMixing.Rule.GEOMETRIC_MEAN);
        SurfaceMixing mean = new SurfaceMixing(SurfaceMixing.Rule.GEOMETRIC_MEAN, SurfaceMixing.Rule.GEOMETRIC_MEAN);
        SurfaceMixing[] given = {null, larger, null, mean};
        double[] after = {0, -1, -1, 0};
        for (int k = 0; k < given.length; k++) {
            session.reply(new BatchRequestBundle(List.of(new WorldRequest.Place("ball", new Point(), 0))));
            StepBundle.Answer answer = step(
                    session, new StepBundle(3, List.of(ball.withFloorFriction(0)), List.of(), given[k], List.of()));
            assertThat(answer.bodies().get(0).velocity().x()).as("step " + k).isCloseTo(after[k], within(1e-9));
        }
    }

    /** Turns in degrees are told of once in a world, whichever request has them; those of forces are none. */
    @Test
    void turnsThatLookLikeDegreesAreToldOnce() {
        BatchRequestBundle slide =
                new BatchRequestBundle(List.of(new WorldRequest.GoAndSlide("cart", 0, 0, 0, 0, -90, 0, 4)));
        BatchRequestBundle dock =
                new BatchRequestBundle(List.of(new WorldRequest.GoToContact("cart", 0, 0, 0, 0, 90, 0)));
        WorldRequest.Go go = new WorldRequest.Go("cart", 0, 0, 0, 0, 6.3);
        List<BodyRequest> none = List.of();
        Map<Bundle, String> asked = new LinkedHashMap<>();
        asked.put(
                new StepBundle(0, none, List.of(new DriveCommand("cart", 0, 90))),
                "turn of \"cart\" is 90.0 radians a second, more than a whole turn; angles are in radians, and 90.0"
                        + " degrees are 1.5707963267948966 of them. Others in this world are not logged");
        asked.put(
                new MoveBundle(List.of(new MoveRequest("cart", 0, 0, 0, 0, 360))), "ry of \"cart\" is 360.0 radians,");
        asked.put(slide, "ry of \"cart\" is -90.0 radians,");
        asked.put(dock, "ry of \"cart\" is 90.0 radians,");
        asked.put(new BatchRequestBundle(List.of(new WorldRequest.Identify(go))), "ry of \"cart\" is 6.3 radians,");
        asked.put(
                new BatchRequestBundle(List.of(new WorldRequest.Place("cart", new Point(), 45))),
                "heading of \"cart\" is 45.0 radians,");
        BodyRequest pushed = BodyRequest.of("cart").withDrive(DriveSettings.of(DriveSettings.Kind.FORCE));
        asked.put(new StepBundle(0, List.of(pushed), List.of(new DriveCommand("cart", 0, 90))), "");
        asked.put(new StepBundle(0, none, List.of(new DriveCommand("cart", 0, 6.25))), "");
        asked.put(new MoveBundle(List.of(new MoveRequest("cart", 0, 0, 0, 0, -2 * Math.PI))), "");
        asked.forEach((request, words) -> {
            try (LogCapture log = new LogCapture()) {
                Session session = session();
                for (int k = 0; k < 3; k++) {
                    session.reply(request);
                }
                session.reply(new InitBundle(OBJECTS, PLANE));
                session.reply(request);
                List<String> told = log.lines().stream()
                        .filter(line -> line.contains(" radians"))
                        .toList();
                assertThat(told).as(request.toString()).hasSize(words.isEmpty() ? 0 : 2);
                assertThat(told).allMatch(line -> line.contains(words));
            }
        });
    }

    /** What a user means in degrees is refused in the unit of the request. */
    @Test
    void theWheelsOfACarAreRefusedInRadians() {
        BodyRequest car = BodyRequest.of("cart").withDrive(DriveSettings.of(DriveSettings.Kind.ACKERMANN));
        Reply reply = reply(session(), new StepBundle(1, List.of(car), List.of(new DriveCommand("cart", 1, 30))));
        assertThat(reply.problems())
                .extracting(Object::toString)
                .containsExactly(
                        "1: turn of a car must be an angle of its front wheels between -pi/2 and pi/2, in radians"
                                + " (got: 30.0)");
    }

    private static void falls(StepBundle.Answer answer, Map<String, Double> falls) {
        for (ContactAnswer contact : answer.contacts()) {
            if (contact.fall() > 0) {
                assertThat(falls.put(contact.objectName() + " onto " + contact.other(), contact.fall()))
                        .as("the same fall in two steps: %s", contact)
                        .isNull();
            }
        }
    }
}
