package robosim.geometry.world.body;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.BiConsumer;
import org.jspecify.annotations.Nullable;
import robosim.geometry.dynamics.AckermannDrive;
import robosim.geometry.dynamics.DifferentialDrive;
import robosim.geometry.dynamics.Drive;
import robosim.geometry.dynamics.ForceDrive;
import robosim.geometry.dynamics.Motor;
import robosim.geometry.dynamics.OmnidirectionalDrive;
import robosim.geometry.dynamics.Surface;
import robosim.geometry.dynamics.SwerveDrive;
import robosim.geometry.dynamics.VelocityDrive;
import robosim.geometry.model.Bounds;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Twist;
import robosim.geometry.world.shared.Decimal;
import robosim.geometry.world.shared.Numbers;

/** Bodies and drives as attributes of a world file's elements; what is left out has its default. */
public final class BodyXml {
    private static final double NONE = Double.POSITIVE_INFINITY;

    /** The angle of a car's front wheels if a file does not say it, degrees. */
    private static final double STEERING = 60;

    /** The value of an attribute; null if it was left out. */
    @FunctionalInterface
    public interface Attributes {
        @Nullable
        String get(String name);
    }

    private BodyXml() {}

    /** Reads a {@code <body>} without its drive. */
    public static ObjectBody body(Attributes from, @Nullable Drive drive) {
        String ignored = from.get("ignored");
        double sliding = number(from, "slidingFriction", number(from, "friction", 0));
        return new ObjectBody(
                number(from, "mass", 0),
                number(from, "inertia", 0),
                new Surface(number(from, "restitution", 0), number(from, "friction", 0), sliding),
                number(from, "floorFriction", ObjectBody.FLOOR_FRICTION),
                number(from, "damping", 0),
                number(from, "turnDamping", 0),
                number(from, "maxSpeed", NONE),
                number(from, "maxTurn", NONE),
                number(from, "drag", 0),
                number(from, "rolling", 0),
                ignored == null
                        ? Set.of()
                        : Set.copyOf(Arrays.asList(ignored.strip().split("\\s+", -1))),
                drive);
    }

    /**
     * Reads a {@code <drive>}.
     *
     * @param shape of the object, whose width or length stands for a base that is left out
     */
    public static Drive drive(Attributes from, GeometryObject shape) {
        String kind = String.valueOf(from.get("kind")).strip();
        Bounds box = shape.turned(0, -shape.heading()).bounds();
        double speed = number(from, "maxSpeed", NONE);
        double acceleration = number(from, "maxAcceleration", NONE);
        double turn = number(from, "maxTurn", NONE);
        return switch (kind) {
            case "differential" -> {
                refuse(from, kind, "maxTurn", "maxTurnAcceleration");
                yield new DifferentialDrive(number(from, "base", box.length()), speed, acceleration);
            }
            case "omnidirectional" -> {
                refuse(from, kind, "base");
                yield new OmnidirectionalDrive(speed, acceleration, turn, number(from, "maxTurnAcceleration", NONE));
            }
            case "ackermann" -> {
                refuse(from, kind, "maxTurnAcceleration");
                yield new AckermannDrive(
                        number(from, "base", box.width()), turn == NONE ? STEERING : turn, speed, acceleration);
            }
            case "swerve" -> {
                refuse(from, kind, "base", "maxSpeed", "maxAcceleration", "maxTurn", "maxTurnAcceleration");
                yield swerve(from, box);
            }
            case "velocity", "force" -> {
                refuse(from, kind, "base", "maxSpeed", "maxAcceleration", "maxTurn", "maxTurnAcceleration");
                yield kind.equals("force") ? new ForceDrive(0, 0, 0) : new VelocityDrive(new Twist(0, 0, 0, 0));
            }
            default ->
                throw new IllegalArgumentException(
                        "kind must be differential, omnidirectional, ackermann, swerve, velocity or force (got: " + kind
                                + ")");
        };
    }

    /** Wheels where the file has them, or in the corners of the object. */
    private static SwerveDrive swerve(Attributes from, Bounds box) {
        String wheels = from.get("wheels");
        List<SwerveDrive.Module> modules = new ArrayList<>();
        if (wheels == null) {
            modules.addAll(SwerveDrive.of(box.width(), box.length(), null, 0).modules());
        } else {
            String[] numbers = wheels.strip().split("\\s+", -1);
            if (numbers.length % 2 != 0) {
                throw new IllegalArgumentException(
                        "wheels must have two numbers for each, forward and to the right (got: " + wheels + ")");
            }
            for (int k = 0; k < numbers.length; k += 2) {
                modules.add(new SwerveDrive.Module(Numbers.parse(numbers[k]), Numbers.parse(numbers[k + 1])));
            }
        }
        Motor motor = from.get("stallTorque") == null
                ? null
                : new Motor(
                        number(from, "stallTorque", 0),
                        number(from, "freeTurns", 0),
                        number(from, "stallCurrent", 0),
                        number(from, "gearRatio", 1),
                        number(from, "wheelRadius", 0),
                        number(from, "currentLimit", NONE),
                        number(from, "supplyResistance", 0));
        return new SwerveDrive(modules, motor, number(from, "grip", 1), number(from, "maxSteering", NONE));
    }

    private static void write(SwerveDrive drive, BiConsumer<String, String> to) {
        to.accept("kind", "swerve");
        List<String> wheels = new ArrayList<>();
        drive.modules().forEach(each -> {
            wheels.add(Decimal.of(each.x()));
            wheels.add(Decimal.of(each.z()));
        });
        to.accept("wheels", String.join(" ", wheels));
        to.accept("grip", Decimal.of(drive.grip()));
        unless(NONE, "maxSteering", drive.maxSteering(), to);
        Motor motor = drive.motor();
        if (motor != null) {
            to.accept("stallTorque", Decimal.of(motor.stallTorque()));
            to.accept("freeTurns", Decimal.of(motor.freeTurns()));
            to.accept("stallCurrent", Decimal.of(motor.stallCurrent()));
            to.accept("gearRatio", Decimal.of(motor.gearRatio()));
            to.accept("wheelRadius", Decimal.of(motor.wheelRadius()));
            unless(NONE, "currentLimit", motor.currentLimit(), to);
            unless(0, "supplyResistance", motor.supplyResistance(), to);
        }
    }

    private static void refuse(Attributes from, String kind, String... names) {
        for (String name : names) {
            if (from.get(name) != null) {
                throw new IllegalArgumentException(
                        name + " must be left out for a drive of kind " + kind + " (got: " + from.get(name) + ")");
            }
        }
    }

    private static double number(Attributes from, String name, double otherwise) {
        String text = from.get(name);
        if (text == null) {
            return otherwise;
        }
        try {
            return Numbers.parse(text.strip());
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException(name + ": " + e.getMessage(), e);
        }
    }

    /** Writes a body without its drive. */
    public static void write(ObjectBody body, BiConsumer<String, String> to) {
        unless(0, "mass", body.mass(), to);
        unless(0, "inertia", body.inertia(), to);
        unless(0, "restitution", body.surface().restitution(), to);
        unless(0, "friction", body.surface().staticFriction(), to);
        unless(
                body.surface().staticFriction(),
                "slidingFriction",
                body.surface().slidingFriction(),
                to);
        unless(ObjectBody.FLOOR_FRICTION, "floorFriction", body.floorFriction(), to);
        unless(0, "damping", body.damping(), to);
        unless(0, "turnDamping", body.turnDamping(), to);
        unless(NONE, "maxSpeed", body.maxSpeed(), to);
        unless(NONE, "maxTurn", body.maxTurn(), to);
        unless(0, "drag", body.drag(), to);
        unless(0, "rolling", body.rolling(), to);
        if (!body.ignored().isEmpty()) {
            to.accept("ignored", String.join(" ", new TreeSet<>(body.ignored())));
        }
    }

    /** Writes a drive, without its command. */
    public static void write(Drive drive, BiConsumer<String, String> to) {
        if (drive instanceof DifferentialDrive wheels) {
            to.accept("kind", "differential");
            to.accept("base", Decimal.of(wheels.track()));
            unless(NONE, "maxSpeed", wheels.maxSpeed(), to);
            unless(NONE, "maxAcceleration", wheels.maxAcceleration(), to);
        } else if (drive instanceof OmnidirectionalDrive any) {
            to.accept("kind", "omnidirectional");
            unless(NONE, "maxSpeed", any.maxSpeed(), to);
            unless(NONE, "maxAcceleration", any.maxAcceleration(), to);
            unless(NONE, "maxTurn", any.maxTurn(), to);
            unless(NONE, "maxTurnAcceleration", any.maxTurnAcceleration(), to);
        } else if (drive instanceof AckermannDrive car) {
            to.accept("kind", "ackermann");
            to.accept("base", Decimal.of(car.wheelbase()));
            unless(STEERING, "maxTurn", car.maxSteering(), to);
            unless(NONE, "maxSpeed", car.maxSpeed(), to);
            unless(NONE, "maxAcceleration", car.maxAcceleration(), to);
        } else if (drive instanceof SwerveDrive swerve) {
            write(swerve, to);
        } else {
            to.accept("kind", drive instanceof ForceDrive ? "force" : "velocity");
        }
    }

    private static void unless(double left, String name, double value, BiConsumer<String, String> to) {
        if (value != left) {
            to.accept(name, Decimal.of(value));
        }
    }
}
