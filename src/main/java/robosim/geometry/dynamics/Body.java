package robosim.geometry.dynamics;

import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.Set;
import robosim.geometry.check.Checks;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Twist;

/**
 * What a moveable object weighs and how it resists: its mass is centred where the object is.
 *
 * <pre>{@code
 * Body ball = Body.ofMass(new SphereObject(new Point(), 0.5), 10);
 * ball.inertia();                                                          // 1.0
 * Body crate = Body.ofDensity(new BoxObject(new Point(), 1, 0.5, 2), 600);
 * crate.mass();                                                            // 600.0
 * crate.withLimits(2, 90).limited(new Twist(3, 0, 4, -120));               // Twist[x=1.2, y=0.0, z=1.6, ry=-90.0]
 * }</pre>
 *
 * @param mass        kg; above 0
 * @param inertia     moment of inertia about the vertical through the centre, kg m<sup>2</sup>; above 0. About the own Y where
 *                    the other two moments are given
 * @param surface     how it bounces and rubs
 * @param damping     the rate at which the speed falls, as a share of what it is, each second: 0 for not at all, and above 1 is allowed
 * @param turnDamping the same of the speed of turning
 * @param maxSpeed    m/s; infinite for no limit
 * @param maxTurn     degrees a second; infinite for no limit
 * @param floorFriction sliding friction on the floor of a PLANAR world: what slides over it without a drive slows by
 *                    {@code floorFriction * g} until it rests, and turns more slowly as a disc of its mass and inertia does;
 *                    0 for none. In a SPATIAL world its own friction, static and sliding, with what is below it, unless that of
 *                    its surface is more
 * @param inertiaX    moment of inertia about the own X, where {@code inertia} is about the own Y, as in any SPATIAL world; 0 for
 *                    that of a solid of the object's shape which has {@code inertia} about the own Y
 * @param inertiaZ    the same about the own Z
 * @param drag        quadratic drag, kg/m: a speed v meets a force of {@code drag * v * v}, as in the air; for a ball of radius r
 *                    in air {@code 0.5 * 1.2 * 0.47 * pi * r * r}. It does not act on what is driven on the ground. Linear drag is
 *                    {@code damping}: a force of {@code mass * damping * v}
 * @param rolling     rolling resistance, a share of the load: in a SPATIAL world a torque of {@code rolling} times load times the
 *                    distance of the contact from the centre acts against rolling. In a PLANAR world, where nothing rolls, it adds to
 *                    {@code floorFriction} and slows the turn as that does
 * @param ignored    names of objects, or of layers, that it passes through in a step, and they through it, whichever of the two bodies
 *                   names the other. A name that is no longer in the world stands for nothing
 */
public record Body(
        double mass,
        double inertia,
        Surface surface,
        double damping,
        double turnDamping,
        double maxSpeed,
        double maxTurn,
        double floorFriction,
        double inertiaX,
        double inertiaZ,
        double drag,
        double rolling,
        Set<String> ignored) {
    /** Standard gravity, m/s<sup>2</sup>: 9.80665. */
    public static final double GRAVITY = 9.80665;

    /** Refuses values that are out of range or not a number. */
    public Body {
        mass = QuantityChecks.positive("mass", mass);
        inertia = QuantityChecks.positive("inertia", inertia);
        Checks.present("surface", surface);
        damping = QuantityChecks.atLeastZero("damping", damping);
        turnDamping = QuantityChecks.atLeastZero("turnDamping", turnDamping);
        maxSpeed = QuantityChecks.limit("maxSpeed", maxSpeed);
        maxTurn = QuantityChecks.limit("maxTurn", maxTurn);
        floorFriction = QuantityChecks.atLeastZero("floorFriction", floorFriction);
        inertiaX = QuantityChecks.atLeastZero("inertiaX", inertiaX);
        inertiaZ = QuantityChecks.atLeastZero("inertiaZ", inertiaZ);
        drag = QuantityChecks.atLeastZero("drag", drag);
        rolling = QuantityChecks.atLeastZero("rolling", rolling);
        ignored = Checks.names("ignored", ignored);
        if (inertiaX > 0 && inertiaZ > 0) {
            QuantityChecks.moments(inertiaX, inertia, inertiaZ);
        }
    }

    /** A body without drag and rolling resistance. */
    public Body(
            double mass,
            double inertia,
            Surface surface,
            double damping,
            double turnDamping,
            double maxSpeed,
            double maxTurn,
            double floorFriction,
            double inertiaX,
            double inertiaZ) {
        this(
                mass,
                inertia,
                surface,
                damping,
                turnDamping,
                maxSpeed,
                maxTurn,
                floorFriction,
                inertiaX,
                inertiaZ,
                0,
                0,
                Set.of());
    }

    /** A smooth body that nothing slows or limits. */
    public static Body of(double mass, double inertia) {
        double none = Double.POSITIVE_INFINITY;
        return new Body(mass, inertia, Surface.SMOOTH, 0, 0, none, none, 0, 0, 0);
    }

    /**
     * A solid body of a shape, of the same density everywhere. That of a shape that is not upright has its three moments of
     * inertia, so that it turns rightly about the vertical of a PLANAR world too.
     *
     * @param shape a sphere, box, cylinder or capsule; its sizes are metres
     * @param mass  kg
     * @throws IllegalArgumentException for another shape, whose inertia has to be given, or a shape that is a point or a line
     *     along its own Y
     */
    public static Body ofMass(GeometryObject shape, double mass) {
        QuantityChecks.positive("mass", mass);
        checkSized(shape);
        double square = Inertia.gyrationSquare(shape);
        if (square == 0) {
            throw new IllegalArgumentException(
                    "shape must not be a point or a line along its own Y, which resists no turn; give it a"
                            + " volume, or use Body.of(mass, inertia) (got: " + shape + ")");
        }
        Body body = of(mass, mass * square);
        if (shape.kind() == GeometryObject.Kind.SPHERE || shape.pose().isUpright()) {
            return body;
        }
        double[] moments = Inertia.moments(shape, 0, body.inertia(), 0);
        return body.withInertia(moments[0], moments[1], moments[2]);
    }

    /**
     * A solid body of a shape and a density.
     *
     * @param shape   as in {@link #ofMass}; of a volume above 0
     * @param density kg/m<sup>3</sup>
     */
    public static Body ofDensity(GeometryObject shape, double density) {
        QuantityChecks.positive("density", density);
        checkSized(shape);
        double volume = Inertia.volume(shape);
        if (volume == 0) {
            throw new IllegalArgumentException(
                    "shape must have a volume; give it one, or a mass by Body.ofMass (got: " + shape + ")");
        }
        return ofMass(shape, density * volume);
    }

    private static void checkSized(GeometryObject shape) {
        if (!Checks.present("shape", shape).kind().isSized()) {
            throw new IllegalArgumentException(
                    "shape must be a sphere, box, cylinder or capsule; for other shapes, give mass and inertia by"
                            + " Body.of(mass, inertia) (got: " + shape + ")");
        }
    }

    /** This body with another surface. */
    public Body withSurface(Surface other) {
        return with(other, damping, turnDamping, maxSpeed, maxTurn, floorFriction);
    }

    /** This body with other dampings: shares of the speed and of the speed of turning, each second. */
    public Body withDamping(double ofSpeed, double ofTurn) {
        return with(surface, ofSpeed, ofTurn, maxSpeed, maxTurn, floorFriction);
    }

    /** This body with other limits: m/s and degrees a second. */
    public Body withLimits(double speed, double turn) {
        return with(surface, damping, turnDamping, speed, turn, floorFriction);
    }

    /** This body with friction on the floor: of a PLANAR world, or on whatever is below it in a SPATIAL one. */
    public Body withFloorFriction(double friction) {
        return with(surface, damping, turnDamping, maxSpeed, maxTurn, friction);
    }

    private Body with(Surface by, double ofSpeed, double ofTurn, double speed, double turn, double friction) {
        return new Body(
                mass, inertia, by, ofSpeed, ofTurn, speed, turn, friction, inertiaX, inertiaZ, drag, rolling, ignored);
    }

    /** This body with quadratic drag, kg/m, and rolling resistance, a share of the load. */
    public Body withDrag(double quadratic, double ofRolling) {
        return new Body(
                mass,
                inertia,
                surface,
                damping,
                turnDamping,
                maxSpeed,
                maxTurn,
                floorFriction,
                inertiaX,
                inertiaZ,
                quadratic,
                ofRolling,
                ignored);
    }

    /** This body passing through the objects of some names or layers, and no longer through those that it had. */
    public Body ignoring(Collection<String> names) {
        return new Body(
                mass,
                inertia,
                surface,
                damping,
                turnDamping,
                maxSpeed,
                maxTurn,
                floorFriction,
                inertiaX,
                inertiaZ,
                drag,
                rolling,
                new LinkedHashSet<>(Checks.present("names", names)));
    }

    /**
     * This body with other moments of inertia, kg m<sup>2</sup>: about the own axes of the object, which have to be its
     * principal axes. In a PLANAR world that of an upright object about the vertical is {@code aboutY}; that of a tipped one
     * comes from all three.
     *
     * @throws IllegalArgumentException if one of them is more than the sum of the other two, which it is in no body; a millionth
     *     more is taken for rounding
     */
    public Body withInertia(double aboutX, double aboutY, double aboutZ) {
        return new Body(
                mass,
                aboutY,
                surface,
                damping,
                turnDamping,
                maxSpeed,
                maxTurn,
                floorFriction,
                QuantityChecks.positive("aboutX", aboutX),
                QuantityChecks.positive("aboutZ", aboutZ),
                drag,
                rolling,
                ignored);
    }

    /** The moments of a solid of a shape that has this body, about its own axes. */
    double[] moments(GeometryObject shape) {
        return Inertia.moments(shape, inertiaX, inertia, inertiaZ);
    }

    /** Whether all three moments were given. */
    boolean hasMoments() {
        return inertiaX > 0 && inertiaZ > 0;
    }

    /** The moment about the vertical; the rotation of its object stands in places from an index on, row by row. */
    double aboutVertical(double[] places, int at) {
        if (!hasMoments()) {
            return inertia;
        }
        double x = places[at + 3];
        double y = places[at + 4];
        double z = places[at + 5];
        return inertiaX * x * x + inertia * y * y + inertiaZ * z * z;
    }

    /** This body with one moment of inertia, about the vertical. */
    Body about(double vertical) {
        return with(mass, vertical);
    }

    /** This body with the mass and the moment of inertia about the vertical of all that is attached to it. */
    Body with(double total, double vertical) {
        return new Body(
                total,
                vertical,
                surface,
                damping,
                turnDamping,
                maxSpeed,
                maxTurn,
                floorFriction,
                0,
                0,
                drag,
                rolling,
                ignored);
    }

    /** By how much the floor slows it, m/s<sup>2</sup>. */
    double slowing() {
        return (floorFriction + rolling) * GRAVITY;
    }

    /**
     * By how much the floor slows its turning, rad/s<sup>2</sup>: of a disc of its mass and inertia, which has the radius
     * {@code r = sqrt(2 I / m)} and rubs with a torque of {@code 2/3 friction m g r}.
     */
    double spinSlowing() {
        return slowing() * (2.0 / 3) * Math.sqrt(2 * mass / inertia);
    }

    /** A velocity within the limits of this body, in the same direction; the speed and the speed of turning each by itself. */
    public Twist limited(Twist velocity) {
        Checks.present("velocity", velocity);
        double[] v = {velocity.x(), velocity.y(), velocity.z(), velocity.ry()};
        limit(v);
        return new Twist(v[0], v[1], v[2], v[3]);
    }

    /** The same in place. */
    void limit(double[] v) {
        double speed = Math.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
        double share = speed > maxSpeed ? maxSpeed / speed : 1;
        v[0] *= share;
        v[1] *= share;
        v[2] *= share;
        v[3] = QuantityChecks.clamp(v[3], maxTurn);
    }
}
