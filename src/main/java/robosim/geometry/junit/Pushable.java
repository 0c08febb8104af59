package robosim.geometry.junit;

import robosim.geometry.dynamics.Body;
import robosim.geometry.dynamics.Surface;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.net.session.BodyRequests;
import robosim.geometry.protocol.motion.BodyRequest;

/** An object of a {@link RobotWorld} that robots may push: a moveable object that is given a mass is a body. */
public final class Pushable {
    private final RobotWorld world;
    private final String name;

    Pushable(RobotWorld world, String name) {
        this.world = world;
        this.name = name;
    }

    /** Its name in the world. */
    public String name() {
        return name;
    }

    /** The object at its present place. */
    public GeometryObject object() {
        return world.known(name);
    }

    /** Gives it a body of so many kilograms, in the shape of a solid. */
    public Pushable hasMass(double kilograms) {
        BodyRequest body = world.body(name);
        world.give(body.withMass(kilograms));
        return this;
    }

    /** Lets it bounce and rub; see {@link Surface}. */
    public Pushable hasSurface(Surface surface) {
        world.give(world.body(name).withSurface(BodyRequests.of(surface)));
        return this;
    }

    /** Gives it sliding friction on the floor, 0 for what rolls; {@value BodyRequest#FLOOR_FRICTION} otherwise. */
    public Pushable hasFloorFriction(double friction) {
        world.give(world.body(name).withFloorFriction(friction));
        return this;
    }

    /** Lets its speed, and its speed of turning, fall by shares each second, as on a floor that resists. */
    public Pushable hasDamping(double ofSpeed, double ofTurn) {
        world.give(world.body(name).withDamping(ofSpeed, ofTurn));
        return this;
    }

    /** Gives it a body. */
    public Pushable hasBody(Body body) {
        world.give(BodyRequests.of(name, body, null));
        return this;
    }

    /** Fails if it is not within a distance of a place on the ground. */
    public Pushable endsNear(double x, double z, double within) {
        world.checkNear("object", name, x, z, within);
        return this;
    }

    @Override
    public String toString() {
        return "object \"" + name + "\"";
    }
}
