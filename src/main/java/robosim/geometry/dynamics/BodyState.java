package robosim.geometry.dynamics;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import robosim.geometry.engine.World;
import robosim.geometry.engine.objects.Attachments;
import robosim.geometry.engine.objects.ObjectTable;
import robosim.geometry.exact.Degrees;
import robosim.geometry.exact.DoubleDouble;
import robosim.geometry.model.Twist;

/** A body, what drives it, and its velocity between steps. */
final class BodyState implements Cloneable {
    private static final Twist STILL = new Twist(0, 0, 0, 0);

    /** A drive does not push for less than this share of its speed. */
    private static final double LITTLE = 1e-7;

    final String name;
    final Body body;

    /** The same with the moment of inertia about the vertical in its present attitude, in a PLANAR world. */
    Body acting;

    /** When its object came into the world at first, which no other object of its name shares. */
    private final long birth;

    /** The body that it is a part of while it is attached; null for one that moves by itself. */
    @Nullable
    String root;

    /** Whether others are attached to it: its acting mass and inertia are those of all, its velocity that of their common centre. */
    boolean isLoaded;

    /** Where its object's centre is as seen from the centre of mass of all that is attached, in axes that turn with its heading. */
    double armX;

    double armZ;

    @Nullable
    Drive drive;

    /** What the modules of a swerve drive are to do, while {@link #drive} has their present angles; null for other drives. */
    private @Nullable SwerveDrive steered;

    // m/s along the world's axes, and radians a second.
    double vx;
    double vz;
    double w;

    // What it goes on with for a time, likewise, and what the drive aims at for the end of that.
    double goesX;
    double goesZ;
    double turns;
    private Twist aim = STILL;

    /** The heading along which that is, of a force. */
    private double aimHeading;

    private double aimRest;

    // What damping leaves of the velocity at the end of that, where there is no drive, also as a share of what it goes
    // on with.
    private double keptX;
    private double keptZ;
    private double keptTurn;
    private double keptShare;
    private double keptTurnShare;

    /** For how long a drive still has to push to get from what it goes on with to what it aims at; of a force, the whole time. */
    private double toGo;

    // For how long the drive may still push at its greatest acceleration, and whether something was in its way before.
    private double left;
    private boolean isHindered;

    private PushExtrapolation response = new PushExtrapolation();

    /** A force and a torque, along and about the world's axes, that act in the next step: newtons and newton metres. */
    private double[] push = new double[6];

    private boolean isPushed;

    // What a force in a PLANAR world gives in the rest of a time, where something was in the way.
    private double restX;
    private double restZ;
    private double restTurn;

    /** In a SPATIAL world: m/s along the world's axes, then radians a second about them. */
    double[] spatial = new double[6];

    BodyState(String name, Body body, World world) {
        this.name = name;
        this.body = body;
        acting = body;
        birth = birth(world);
    }

    /** Drives it from now on; the modules of a swerve drive turn from where they are. */
    void drive(@Nullable Drive by) {
        steered = by instanceof SwerveDrive swerve ? swerve : null;
        drive = by instanceof SwerveDrive to && drive instanceof SwerveDrive from ? to.turnedFrom(from, 0) : by;
    }

    /** Takes over what drives another body. */
    void driveAs(BodyState other) {
        drive = other.drive;
        steered = other.steered;
    }

    /** Turns the modules of a swerve drive for a time. */
    void steer(double seconds) {
        SwerveDrive to = steered;
        if (to != null && drive != to && drive instanceof SwerveDrive from) {
            drive = to.turnedFrom(from, seconds);
        }
    }

    /** Whether its object is still in the world, by itself or attached to another one. */
    boolean isThere(World world) {
        return (world.objects.find(name) >= 0 || world.registry.attachments.root(name) != null)
                && birth(world) == birth;
    }

    private long birth(World world) {
        int id = world.objects.find(name);
        long arrival = id < 0 ? -1 : world.objects.arrival(id);
        Attachments attachments = world.registry.attachments;
        return attachments.isEmpty() ? arrival : attachments.birth(name, arrival);
    }

    /** It moves by itself, with the velocity of the place where it is in what it was attached to. */
    void part(double heading, double rest) {
        Twist own = velocity(heading, rest);
        armX = 0;
        armZ = 0;
        root = null;
        isLoaded = false;
        acting = body;
        setVelocity(heading, rest, own);
    }

    /** It goes as another one goes, to which it is attached. */
    void follow(BodyState other) {
        vx = other.vx;
        vz = other.vz;
        w = other.w;
    }

    /** The same state of the same body, which goes on by itself. */
    BodyState copy() {
        try {
            BodyState copy = (BodyState) clone();
            copy.spatial = spatial.clone();
            copy.push = push.clone();
            copy.response = response.copy();
            return copy;
        } catch (CloneNotSupportedException e) {
            throw new IllegalStateException(e);
        }
    }

    /** The velocity along its own axes; the heading, in degrees, and its rounding error stand at an index of places. */
    Twist velocity(double[] places, int at) {
        return velocity(places[at], places[at + 1]);
    }

    Twist velocity(double heading, double rest) {
        return velocity(heading, rest, armX, armZ);
    }

    /** The velocity of a point at rest in its own frame, which is given as seen from the centre of mass. */
    private Twist velocity(double heading, double rest, double atX, double atZ) {
        double sin = Degrees.sin(heading, rest);
        double cos = Degrees.cos(heading, rest);
        double x = vx * cos - vz * sin;
        double z = vx * sin + vz * cos;
        return atX == 0 && atZ == 0
                ? new Twist(x, 0, z, Degrees.toDegrees(w))
                : new Twist(x + w * atZ, 0, z - w * atX, Degrees.toDegrees(w));
    }

    void setVelocity(double[] places, int at, Twist velocity) {
        setVelocity(places[at], places[at + 1], velocity);
    }

    void setVelocity(double heading, double rest, Twist velocity) {
        setVelocity(heading, rest, velocity, armX, armZ);
    }

    private void setVelocity(double heading, double rest, Twist velocity, double atX, double atZ) {
        double sin = Degrees.sin(heading, rest);
        double cos = Degrees.cos(heading, rest);
        w = Degrees.toRadians(velocity.ry());
        double x = atZ == 0 ? velocity.x() : velocity.x() - w * atZ;
        double z = atX == 0 ? velocity.z() : velocity.z() + w * atX;
        vx = x * cos + z * sin;
        vz = z * cos - x * sin;
    }

    /**
     * Works out the velocity that it keeps for a time but for collisions, and whether that is any: what the drive makes of it
     * on the way, along the chord of its arc, or what damping and the limits leave of it.
     */
    boolean begin(double[] places, int at, double seconds) {
        double heading = places[at];
        double rest = places[at + 1];
        Drive driven = drive;
        if (driven instanceof ForceDrive force) {
            beginForced(isPushed ? pushed(force, heading, rest) : force, heading, rest, seconds);
        } else if (driven != null) {
            Twist now = pushed(heading, rest, seconds);
            aim = driven.next(now, acting, seconds);
            double spent = spent(driven, now, aim, seconds);
            left = seconds - spent;
            // What is pressed against something is not to lose the speed that it would have gained on the way.
            double gaining = isHindered ? 0 : Math.min(seconds, spent);
            // The mean: of a speed that is gained evenly that at half of its time, then what the drive aims at.
            Twist halfway = isPushed ? pushed(heading, rest, 0.5 * gaining) : now;
            Twist gained = gaining > 0 ? driven.next(halfway, acting, 0.5 * gaining) : aim;
            double share = gaining / seconds;
            toGo = 0.5 * gaining * share; // of the time in which it gains speed, what is not in the mean
            double turn = mean(gained.ry(), aim.ry(), share);
            turns = Degrees.toRadians(turn);
            double chord = chord(0.5 * turns * seconds);
            go(
                    heading,
                    rest,
                    0.5 * turn * seconds,
                    (mean(gained.x(), aim.x(), share) - (armZ == 0 ? 0 : turns * armZ)) * chord,
                    (mean(gained.z(), aim.z(), share) + (armX == 0 ? 0 : turns * armX)) * chord);
        } else if (isPushed || acting.drag() > 0) {
            beginPushed(heading, rest, seconds);
        } else {
            beginFree(seconds);
        }
        return goesX != 0 || goesZ != 0 || turns != 0;
    }

    /** It goes on at the mean of the speed that damping leaves, and has at the end what is left then. */
    private void beginFree(double seconds) {
        double speed = Math.sqrt(vx * vx + vz * vz);
        double share = speed > acting.maxSpeed() ? acting.maxSpeed() / speed : 1;
        double most = acting.maxTurn();
        double turn = most < Double.POSITIVE_INFINITY ? QuantityChecks.clamp(w, Degrees.toRadians(most)) : w;
        double kept = Decay.kept(acting.damping() * seconds);
        double turnKept = Decay.kept(acting.turnDamping() * seconds);
        keptX = vx * share * kept;
        keptZ = vz * share * kept;
        keptTurn = turn * turnKept;
        // What something was in the way of loses all of it at once, since it is not to keep the mean for good.
        double mean = isHindered ? kept : Decay.mean(acting.damping() * seconds);
        goesX = vx * share * mean;
        goesZ = vz * share * mean;
        turns = turn * (isHindered ? turnKept : Decay.mean(acting.turnDamping() * seconds));
        keptShare = isHindered ? 1 : Decay.rest(acting.damping() * seconds);
        keptTurnShare = isHindered ? 1 : Decay.rest(acting.turnDamping() * seconds);
    }

    /**
     * The same under a force or quadratic drag: linear drag is solved exactly, and quadratic drag too where no force acts.
     * Otherwise it is linear drag at the speed halfway. Under a force the floor is a part of it: what is pushed by less than
     * its friction stands still.
     */
    private void beginPushed(double heading, double rest, double seconds) {
        double speed = Math.sqrt(vx * vx + vz * vz);
        double share = speed > acting.maxSpeed() ? acting.maxSpeed() / speed : 1;
        double x = vx * share;
        double z = vz * share;
        double ax = push[0] / acting.mass();
        double az = push[2] / acting.mass();
        double linear = acting.damping() * seconds;
        double quadratic = acting.drag() / acting.mass() * seconds;
        double kept = Decay.kept(linear);
        double mean = Decay.mean(linear);
        if (ax == 0 && az == 0) {
            double slowing = quadratic * speed * share * mean; // v' = -c v - k v^2, solved by substitution of 1/v
            kept /= 1 + slowing;
            mean *= slowing == 0 ? 1 : StrictMath.log1p(slowing) / slowing;
        } else {
            double midX = x + 0.5 * ax * seconds;
            double midZ = z + 0.5 * az * seconds;
            linear += quadratic * Math.sqrt(midX * midX + midZ * midZ);
            kept = Decay.kept(linear);
            mean = Decay.mean(linear);
        }
        double gain = seconds * Decay.mean(linear);
        double meanGain = seconds * Decay.meanGain(linear);
        floored(
                new double[] {x, z, x * kept + ax * gain, z * kept + az * gain},
                new double[] {x * mean + ax * meanGain, z * mean + az * meanGain},
                isPushed ? acting.slowing() * seconds : 0);
        double limit = acting.maxTurn();
        double turn = limit < Double.POSITIVE_INFINITY ? QuantityChecks.clamp(w, Degrees.toRadians(limit)) : w;
        double turnSlowed = acting.turnDamping() * seconds;
        double alpha = torque(push, heading, rest) / acting.inertia();
        double most = isPushed ? acting.spinSlowing() * seconds : 0;
        double end = turn * Decay.kept(turnSlowed) + alpha * seconds * Decay.mean(turnSlowed);
        keptTurn = QuantityChecks.toward(end, 0, most);
        turns = turn * Decay.mean(turnSlowed) + alpha * seconds * Decay.meanGain(turnSlowed) - 0.5 * (end - keptTurn);
        if (keptTurn == 0 && most > 0) {
            turns = 0.5 * turn * Math.min(1, Math.abs(turn) / most);
        }
        if (isHindered) {
            goesX = keptX;
            goesZ = keptZ;
            turns = keptTurn;
        }
        keptShare = isHindered ? 1 : kept / mean;
        keptTurnShare = isHindered ? 1 : Decay.rest(turnSlowed);
        restX = keptX - goesX;
        restZ = keptZ - goesZ;
        restTurn = keptTurn - turns;
    }

    /** Gives it an impulse at once: newton seconds along the world's axes, and those times metres about its own centre. */
    void kick(double[] by, double[] places, int at) {
        Body whole = isLoaded ? acting : body;
        vx += by[0] / whole.mass();
        vz += by[2] / whole.mass();
        double inertia = isLoaded ? whole.inertia() : whole.aboutVertical(places, at + ObjectTable.ROTATION);
        w += torque(by, places[at + ObjectTable.HEADING], places[at + ObjectTable.HEADING + 1]) / inertia;
    }

    /** The torque of a push about the centre of mass, which is not its own where something is attached to it. */
    private double torque(double[] by, double heading, double rest) {
        if (armX == 0 && armZ == 0) {
            return by[4];
        }
        double sin = Degrees.sin(heading, rest);
        double cos = Degrees.cos(heading, rest);
        return by[4] + armZ * (by[0] * cos - by[2] * sin) - armX * (by[0] * sin + by[2] * cos);
    }

    /** Takes from a motion what the floor does, which may bring it to rest. */
    private void floored(double[] motion, double[] mean, double slowing) {
        double end = Math.sqrt(motion[2] * motion[2] + motion[3] * motion[3]);
        double left = slowing == 0 ? 1 : Math.max(0, 1 - slowing / end);
        keptX = end == 0 ? 0 : motion[2] * left;
        keptZ = end == 0 ? 0 : motion[3] * left;
        goesX = mean[0] - 0.5 * (motion[2] - keptX);
        goesZ = mean[1] - 0.5 * (motion[3] - keptZ);
        if (left == 0 || (end == 0 && slowing > 0)) {
            double speed = Math.sqrt(motion[0] * motion[0] + motion[1] * motion[1]);
            double share = 0.5 * Math.min(1, speed / slowing);
            goesX = motion[0] * share;
            goesZ = motion[1] * share;
        }
    }

    /** Lets a force and a torque act in the next step, added to what acts then already. */
    void push(double[] by) {
        for (int k = 0; k < 6; k++) {
            push[k] += by[k];
        }
        isPushed = true;
    }

    /** What pushes in the next step, six numbers; null for nothing. */
    double @Nullable [] push() {
        return isPushed ? push : null;
    }

    /** Ends what pushed in a step. */
    void endPush() {
        if (isPushed) {
            Arrays.fill(push, 0);
            isPushed = false;
        }
    }

    /** Whether the floor slows it by itself: nothing drives it, and no force pushes it, of which the floor takes its part. */
    boolean isSlowed() {
        return drive == null && !isPushed;
    }

    /** The velocity along its own axes that a force alone would give in a time. */
    private Twist pushed(double heading, double rest, double seconds) {
        if (!isPushed) {
            return velocity(heading, rest);
        }
        double x = vx;
        double z = vz;
        double turn = w;
        vx += push[0] / acting.mass() * seconds;
        vz += push[2] / acting.mass() * seconds;
        w += torque(push, heading, rest) / acting.inertia() * seconds;
        Twist pushed = velocity(heading, rest);
        vx = x;
        vz = z;
        w = turn;
        return pushed;
    }

    /** A force that drives, and another one that pushes. */
    private ForceDrive pushed(ForceDrive force, double heading, double rest) {
        double sin = Degrees.sin(heading, rest);
        double cos = Degrees.cos(heading, rest);
        return new ForceDrive(
                force.x() + (push[0] * cos - push[2] * sin),
                force.z() + (push[0] * sin + push[2] * cos),
                force.torque() + push[4]);
    }

    private static double mean(double first, double then, double share) {
        return share == 1 ? first : then + (first - then) * share;
    }

    /** A force has the direction that the body has halfway; nothing but it turns the velocity, as wheels do. */
    private void beginForced(ForceDrive given, double heading, double rest, double seconds) {
        ForceDrive force = aboutMass(given);
        double turn =
                force.next(velocity(heading, rest, 0, 0), acting, 0.5 * seconds).ry();
        double by = 0.5 * turn * seconds;
        aimHeading = heading + by;
        aimRest = rest + DoubleDouble.sumTail(heading, by, aimHeading);
        Twist now = velocity(aimHeading, aimRest, 0, 0);
        aim = force.next(now, acting, seconds);
        left = 0;
        toGo = isHindered ? 0 : seconds;
        Twist halfway = isHindered ? aim : force.mean(now, acting, seconds);
        turns = Degrees.toRadians(halfway.ry());
        go(aimHeading, aimRest, 0, halfway.x(), halfway.z());
    }

    /** A force at the object's centre as one at the centre of mass, and the torque that it has about that. */
    private ForceDrive aboutMass(ForceDrive force) {
        return armX == 0 && armZ == 0
                ? force
                : new ForceDrive(force.x(), force.z(), force.torque() + (armZ * force.x() - armX * force.z()));
    }

    /** The chord of an arc as a share of the arc, which turns by twice an angle in radians. */
    private static double chord(double half) {
        return Math.abs(half) < 1e-4 ? 1 - half * half / 6 : Degrees.sin(Degrees.toDegrees(half)) / half;
    }

    /** Goes on along axes that are turned by an angle from a heading; the sum keeps its rounding error, as headings do. */
    private void go(double heading, double rest, double by, double x, double z) {
        double sum = heading + by;
        double sumRest = rest + DoubleDouble.sumTail(heading, by, sum);
        double sin = Degrees.sin(sum, sumRest);
        double cos = Degrees.cos(sum, sumRest);
        goesX = x * cos + z * sin;
        goesZ = z * cos - x * sin;
    }

    /**
     * Takes the velocity that the time has left it with. Where that is the one it was given, nothing was in the way, and a
     * body has at the end what its drive aimed at, or what damping has left. Else drive and damping have acted for half of the
     * time only, and act now for the rest of it.
     *
     * @return whether that changes the velocity of a body which something was in the way of: it may press against that
     */
    boolean end(double endX, double endZ, double endTurn, double[] places, int at) {
        vx = endX;
        vz = endZ;
        w = endTurn;
        isHindered = endX != goesX || endZ != goesZ || endTurn != turns;
        if (isHindered) {
            return goOn(places, at) && (vx != endX || vz != endZ || w != endTurn);
        }
        if (drive == null) {
            vx = keptX;
            vz = keptZ;
            w = keptTurn;
        } else {
            if (drive instanceof ForceDrive) {
                setVelocity(aimHeading, aimRest, aim, 0, 0);
            } else {
                setVelocity(places, at, aim);
            }
        }
        return false;
    }

    /** Lets drive and damping act for what is left of the time after a collision; whether there is any. */
    private boolean goOn(double[] places, int at) {
        Drive driven = drive;
        if (driven == null) {
            if (isPushed) {
                vx += restX;
                vz += restZ;
                w += restTurn;
                return true;
            }
            vx *= keptShare;
            vz *= keptShare;
            w *= keptTurnShare;
            return keptShare != 1 || keptTurnShare != 1;
        }
        if (toGo == 0) {
            return false;
        }
        if (driven instanceof ForceDrive force) {
            ForceDrive all = isPushed ? pushed(force, aimHeading, aimRest) : force;
            Twist now = velocity(aimHeading, aimRest, 0, 0);
            setVelocity(aimHeading, aimRest, aboutMass(all).rest(now, isLoaded ? acting : body, toGo), 0, 0);
        } else {
            Twist now = pushed(places[at], places[at + 1], toGo);
            Twist next = driven.next(now, body, toGo);
            left += toGo - spent(driven, now, next, toGo);
            setVelocity(places, at, next);
        }
        return true;
    }

    /** Takes the velocity that what it presses against has left of that at the end. */
    void settle(double endX, double endZ, double endTurn) {
        vx = endX;
        vz = endZ;
        w = endTurn;
    }

    /**
     * Lets the drive use the acceleration that it has left, turned by degrees since; answers whether that changes the velocity.
     *
     * @param round the number of the round of pushes; one above the last in the same collision
     */
    boolean push(double[] places, int at, double turned, long round) {
        Drive driven = drive;
        if (driven == null || left <= 0 || response.isOf(round)) {
            return false;
        }
        double heading = places[at] + turned;
        double rest = places[at + 1] + DoubleDouble.sumTail(places[at], turned, heading);
        Twist now = velocity(heading, rest);
        Twist next = driven.next(now, acting, left);
        double change = Math.abs(next.x() - now.x())
                + Math.abs(next.z() - now.z())
                + Degrees.toRadians(Math.abs(next.ry() - now.ry()));
        if (change <= LITTLE * (Math.abs(aim.x()) + Math.abs(aim.z()) + Degrees.toRadians(Math.abs(aim.ry())))) {
            return false;
        }
        double spent = spent(driven, now, next, left);
        double stretch = response.stretch(now, round, acting.inertia() / acting.mass());
        if (stretch > 1 && spent < left) {
            stretch = spent > 0 ? Math.min(stretch, left / spent) : stretch;
            next = stretched(now, next, stretch);
            spent *= stretch;
        }
        left -= spent;
        response.pushed(now, next, round);
        setVelocity(heading, rest, next);
        return true;
    }

    private static Twist stretched(Twist from, Twist to, double by) {
        return new Twist(
                from.x() + by * (to.x() - from.x()),
                0,
                from.z() + by * (to.z() - from.z()),
                from.ry() + by * (to.ry() - from.ry()));
    }

    /** How long a drive needs for a change of the velocity, out of a time that it has. */
    private static double spent(Drive drive, Twist from, Twist to, double seconds) {
        double dx = to.x() - from.x();
        double dz = to.z() - from.z();
        double dTurn = to.ry() - from.ry();
        if (drive instanceof DifferentialDrive of) {
            return time(Math.abs(dx) + Degrees.toRadians(Math.abs(dTurn)) * (of.track() / 2), of.maxAcceleration());
        }
        if (drive instanceof AckermannDrive of) {
            return time(Math.abs(dx), of.maxAcceleration());
        }
        if (drive instanceof OmnidirectionalDrive of) {
            return Math.max(
                    time(Math.sqrt(dx * dx + dz * dz), of.maxAcceleration()),
                    time(Math.abs(dTurn), of.maxTurnAcceleration()));
        }
        return drive instanceof VelocityDrive ? 0 : seconds;
    }

    private static double time(double change, double acceleration) {
        return change == 0 ? 0 : change / acceleration;
    }

    /** How fast it turns while nothing hits it, radians a second. */
    double turning() {
        return Math.abs(turns);
    }

    /** Whether a drive, damping or the floor changes its velocity. */
    boolean isForced() {
        return drive != null
                || acting.slowing() > 0
                || acting.spinSlowing() > 0
                || acting.damping() > 0
                || acting.turnDamping() > 0
                || acting.drag() > 0
                || isPushed;
    }
}
