package robosim.geometry.protocol;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import robosim.geometry.model.Point;
import robosim.geometry.protocol.batch.Numbers;
import robosim.geometry.protocol.motion.BodyAnswer;
import robosim.geometry.protocol.motion.BodyRequest;
import robosim.geometry.protocol.motion.ContactAnswer;
import robosim.geometry.protocol.motion.DriveCommand;
import robosim.geometry.protocol.motion.DriveSettings;
import robosim.geometry.protocol.motion.PushRequest;
import robosim.geometry.protocol.motion.StopAnswer;
import robosim.geometry.protocol.motion.SurfaceSettings;
import robosim.geometry.protocol.motion.SwerveSettings;
import robosim.geometry.protocol.motion.Velocity;

/** Steps with everything that they may have. */
public final class StepSamples {
    private static final double NONE = Double.POSITIVE_INFINITY;

    /** The kinds that the stored requests have. */
    private static final List<DriveSettings.Kind> STORED = List.of(
            DriveSettings.Kind.DIFFERENTIAL,
            DriveSettings.Kind.OMNIDIRECTIONAL,
            DriveSettings.Kind.ACKERMANN,
            DriveSettings.Kind.VELOCITY,
            DriveSettings.Kind.FORCE);

    private StepSamples() {}

    public static List<StepBundle> requests() {
        List<BodyRequest> bodies = new ArrayList<>();
        bodies.add(BodyRequest.of("a"));
        bodies.add(new BodyRequest(
                "b",
                5,
                0.25,
                new SurfaceSettings(0.5, 0.75, 0.5),
                1,
                2,
                3,
                4,
                0.25,
                DriveSettings.DEFAULT,
                new Velocity(1, 0, -2, 0.5),
                0,
                0,
                List.of()));
        for (DriveSettings.Kind kind : STORED) {
            bodies.add(BodyRequest.of("robot " + kind).withDrive(DriveSettings.of(kind)));
        }
        bodies.add(BodyRequest.of("d")
                .withDrive(new DriveSettings(DriveSettings.Kind.DIFFERENTIAL, 0.3, 1, 2, NONE, NONE)));
        bodies.add(BodyRequest.of("o").withDrive(new DriveSettings(DriveSettings.Kind.OMNIDIRECTIONAL, 0, 1, 2, 3, 4)));
        bodies.add(
                BodyRequest.of("c").withDrive(new DriveSettings(DriveSettings.Kind.ACKERMANN, 2.5, 30, 4, 0.5, NONE)));
        return List.of(
                new StepBundle(0, List.of(), List.of()),
                new StepBundle(
                        0.05, bodies, List.of(new DriveCommand("a", 1, 0.25), new DriveCommand("b", -1, 2, -3))));
    }

    /** A step with a body that passes through others. */
    public static StepBundle ignoring() {
        return new StepBundle(0.05, List.of(BodyRequest.of("n").ignoring(List.of("cloth", "layer"))), List.of());
    }

    /** A step with pushes, which the stored ones lack. */
    public static StepBundle pushing() {
        return new StepBundle(
                0.05,
                List.of(
                        BodyRequest.of("a").withDrag(0.25, 0.5),
                        BodyRequest.of("n").withDrive(DriveSettings.of(DriveSettings.Kind.NONE)),
                        BodyRequest.of("t")
                                .withDrive(DriveSettings.of(
                                        new SwerveSettings(List.of(new Point(0.25, 0, -0.5)), 1.5, 0, null))),
                        BodyRequest.of("s")
                                .withDrive(DriveSettings.of(new SwerveSettings(
                                        List.of(new Point(0.25, 0, -0.5), new Point(-0.25, 0, 0.5)),
                                        1,
                                        NONE,
                                        new SwerveSettings.Motor(7, 6000, 366, 6.75, 0.05, 80, 0.125))))),
                List.of(),
                null,
                List.of(
                        PushRequest.impulse("a", new Point(1, 2, -3)),
                        new PushRequest("b", new Point(), new Point(0, -4, 0.5), new Point(7, 8, 9)),
                        PushRequest.force("a", new Point(0.25, 0, 0))));
    }

    public static StepBundle.Answer answer() {
        return new StepBundle.Answer(
                List.of(
                        new BodyAnswer("a", new Point(1, 2, 3), Math.PI, Numbers.NONE, new Velocity(1, 2, 3, 4)),
                        new BodyAnswer(
                                "b", new Point(), 0, Numbers.of(1, 0, 0, 0, 0, -1, 0, 1, 0), new Velocity(0, 0, 0, 0))),
                List.of(
                        new ContactAnswer(
                                "a", "b", new Point(0.5, 0, 0), new Point(1, 0, 0), 2.5, ContactAnswer.Phase.LAST),
                        new ContactAnswer("a", null, new Point(), new Point(0, 0, -1), 0, ContactAnswer.Phase.END)),
                List.of("b"));
    }

    /** A car whose centre is not on its rear axle, and an answer with reasons; apart from the others, as stored bytes are. */
    public static List<Bundle> later() {
        return List.of(
                new StepBundle(
                        0,
                        List.of(BodyRequest.of("car")
                                .withDrive(DriveSettings.of(DriveSettings.Kind.ACKERMANN)
                                        .withCentreAhead(-1.25))),
                        List.of()),
                new StepBundle.Answer(
                        List.of(),
                        List.of(),
                        List.of("b", "a"),
                        List.of(
                                new StopAnswer("b", StopAnswer.Reason.BLOCKED, "a"),
                                new StopAnswer("a", StopAnswer.Reason.OVERLAP, null))));
    }

    /** An answer whose contact has ended a fall; apart from the others, which stored bytes have. */
    public static StepBundle.Answer landing() {
        return new StepBundle.Answer(
                List.of(),
                List.of(new ContactAnswer(
                        "b", null, new Point(), new Point(0, 1, 0), 3, ContactAnswer.Phase.BEGIN, 1.25)),
                List.of());
    }

    public static List<Bundle> everyBundle() {
        List<Bundle> all = new ArrayList<>(requests());
        all.add(answer());
        return all;
    }

    /** A number of any size within the limits, now and then a special one. */
    private static double number(SplittableRandom random, double least, double most) {
        return switch (random.nextInt(6)) {
            case 0 -> least;
            case 1 -> most;
            default -> least + (most - least) * random.nextDouble();
        };
    }

    private static double limit(SplittableRandom random) {
        return random.nextInt(3) == 0 ? NONE : number(random, 0, 1e9);
    }

    /** A request of random numbers. */
    public static StepBundle random(SplittableRandom random) {
        List<BodyRequest> bodies = new ArrayList<>();
        List<DriveCommand> commands = new ArrayList<>();
        List<PushRequest> pushes = new ArrayList<>();
        for (int k = random.nextInt(4); k > 0; k--) {
            double friction = number(random, 0, 2);
            bodies.add(new BodyRequest(
                    "body " + random.nextInt(9),
                    random.nextBoolean() ? 0 : number(random, 1e-9, 1e9),
                    random.nextBoolean() ? 0 : number(random, 1e-9, 1e9),
                    new SurfaceSettings(number(random, 0, 1), friction, friction * random.nextDouble()),
                    number(random, 0, 9),
                    number(random, 0, 9),
                    limit(random),
                    limit(random),
                    number(random, 0, 2),
                    random.nextBoolean() ? null : DriveSettings.DEFAULT,
                    random.nextBoolean()
                            ? null
                            : new Velocity(number(random, -9, 9), 0, number(random, -1e9, 9), number(random, -1, 1)),
                    random.nextBoolean() ? 0 : number(random, 0, 1e9),
                    random.nextBoolean() ? 0 : number(random, 0, 1),
                    random.nextBoolean() ? List.of() : List.of("cloth", "body 1")));
            Point push = new Point(number(random, -9, 9), number(random, -1e9, 1e9), 0);
            pushes.add(new PushRequest(
                    "body " + random.nextInt(9),
                    push,
                    random.nextBoolean() ? null : push,
                    random.nextBoolean() ? null : push));
            commands.add(new DriveCommand(
                    "body " + random.nextInt(9),
                    number(random, -9, 9),
                    number(random, -1e9, 1e9),
                    number(random, -0.5, 3)));
        }
        return new StepBundle(number(random, 0, 3600), bodies, commands, null, pushes);
    }
}
