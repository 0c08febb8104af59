package robosim.geometry.dynamics;

import org.jspecify.annotations.Nullable;
import robosim.geometry.exact.Degrees;
import robosim.geometry.model.Twist;

/** A body, what drives it, and its velocity between steps. */
final class BodyState {
    final String name;
    final Body body;

    @Nullable
    Drive drive;

    // m/s along the world's axes, and radians a second.
    double vx;
    double vz;
    double w;

    /** In a SPATIAL world: m/s along the world's axes, then radians a second about them. */
    final double[] spatial = new double[6];

    BodyState(String name, Body body) {
        this.name = name;
        this.body = body;
    }

    /** The velocity along its own axes, at a heading in degrees. */
    Twist velocity(double heading) {
        double sin = Degrees.sin(heading);
        double cos = Degrees.cos(heading);
        return new Twist(vx * cos - vz * sin, 0, vx * sin + vz * cos, Degrees.toDegrees(w));
    }

    void setVelocity(double heading, Twist velocity) {
        double sin = Degrees.sin(heading);
        double cos = Degrees.cos(heading);
        vx = velocity.x() * cos + velocity.z() * sin;
        vz = velocity.z() * cos - velocity.x() * sin;
        w = Degrees.toRadians(velocity.ry());
    }

    boolean isStill() {
        return vx == 0 && vz == 0 && w == 0;
    }

    /** The velocity before a step: what the drive makes of it, or what damping and the limits leave. */
    void begin(double heading, double seconds) {
        Drive driven = drive;
        if (driven != null) {
            setVelocity(heading, driven.next(velocity(heading), body, seconds));
            return;
        }
        // One step of the implicit Euler method, as of ForceDrive.
        double slower = 1 + body.damping() * seconds;
        vx /= slower;
        vz /= slower;
        w /= 1 + body.turnDamping() * seconds;
        double speed = Math.sqrt(vx * vx + vz * vz);
        if (speed > body.maxSpeed()) {
            vx *= body.maxSpeed() / speed;
            vz *= body.maxSpeed() / speed;
        }
        if (body.maxTurn() < Double.POSITIVE_INFINITY) {
            w = Quantity.clamp(w, Degrees.toRadians(body.maxTurn()));
        }
    }
}
