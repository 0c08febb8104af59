package robosim.geometry.dynamics;

import org.jspecify.annotations.Nullable;
import robosim.geometry.exact.Degrees;
import robosim.geometry.model.Bounds;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Twist;

/** A body on its way: its velocity in the world's axes, and where it is. */
final class BodyState {
    final String name;
    final Body body;

    @Nullable
    Drive drive;

    /** Where it is at the time that the step has come to. */
    GeometryObject object;

    // m/s along the world's axes, and radians a second.
    double vx;
    double vz;
    double w;

    BodyState(String name, Body body, GeometryObject object) {
        this.name = name;
        this.body = body;
        this.object = object;
    }

    /** The velocity along its own axes as they are now. */
    Twist velocity() {
        double sin = Degrees.sin(object.heading());
        double cos = Degrees.cos(object.heading());
        return new Twist(vx * cos - vz * sin, 0, vx * sin + vz * cos, Degrees.toDegrees(w));
    }

    void setVelocity(Twist velocity) {
        double sin = Degrees.sin(object.heading());
        double cos = Degrees.cos(object.heading());
        vx = velocity.x() * cos + velocity.z() * sin;
        vz = velocity.z() * cos - velocity.x() * sin;
        w = Degrees.toRadians(velocity.ry());
    }

    void stop() {
        vx = 0;
        vz = 0;
        w = 0;
    }

    /** Whether the boxes around the two come nearer than a gap while this one goes by a displacement. */
    boolean mayMeet(BodyState other, double dx, double dz, double gap) {
        Bounds own = object.bounds();
        Bounds its = other.object.bounds();
        // Rounded outward by more than the sums of these coordinates lose.
        double slack = gap
                + 0x1p-40
                        * (Math.abs(own.minX())
                                + Math.abs(own.maxX())
                                + Math.abs(own.minZ())
                                + Math.abs(own.maxZ())
                                + Math.abs(dx)
                                + Math.abs(dz));
        return own.minX() + Math.min(0, dx) - slack <= its.maxX()
                && own.maxX() + Math.max(0, dx) + slack >= its.minX()
                && own.minZ() + Math.min(0, dz) - slack <= its.maxZ()
                && own.maxZ() + Math.max(0, dz) + slack >= its.minZ();
    }

    double energy() {
        return 0.5 * body.mass() * (vx * vx + vz * vz) + 0.5 * body.inertia() * w * w;
    }
}
