package robosim.geometry.dynamics;

import org.jspecify.annotations.Nullable;
import robosim.geometry.model.Point;

/**
 * Two bodies, or a body and what stands still, that meet at a point: the impulse by Newton's restitution and Coulomb's friction
 * (Mirtich 1996).
 */
final class Impact {
    final BodyState a;

    /** Null for what stands still. */
    final @Nullable BodyState b;

    /** What stands still; null for the border of the world, or where there is another body. */
    final @Nullable String other;

    private final Surface surface;
    private final Point point;

    /** From b, or what stands still, towards a. */
    private final Point normal;

    /** Where a was from b, or in the world, when the two met. */
    private Point apart;

    /** The impulse given to a along the normal at this time, newton seconds. */
    private double impulse;

    Impact(BodyState a, @Nullable BodyState b, @Nullable String other, Surface surface, Point point, Point normal) {
        this.a = a;
        this.b = b;
        this.other = other;
        this.surface = surface;
        this.point = point;
        this.normal = normal;
        apart = new Point();
    }

    /** The bodies have come to where they meet. */
    void arrive() {
        apart = apart();
    }

    private Point apart() {
        Point from = a.object.center();
        Point to = b == null ? new Point() : b.object.center();
        return new Point(from.x() - to.x(), 0, from.z() - to.z());
    }

    /** Whether the two are still within a distance of where they were when they met; then its impulse counts anew. */
    boolean lasts(double distance) {
        Point now = apart();
        impulse = 0;
        return Math.abs(now.x() - apart.x()) <= distance && Math.abs(now.z() - apart.z()) <= distance;
    }

    /** Resolves the contact if the two approach each other there; answers whether they did. */
    boolean resolve() {
        double nx = normal.x();
        double nz = normal.z();
        double approach = relative(nx, nz);
        if (!(approach < 0)) {
            return false;
        }
        double before = energy();
        double j = -(1 + surface.restitution()) * approach / softness(nx, nz);
        double aside = -relative(-nz, nx) / softness(-nz, nx);
        push(j * nx, j * nz);
        boolean sticks = Math.abs(aside) <= surface.staticFriction() * j;
        double rub = sticks ? aside : Math.copySign(surface.slidingFriction() * j, aside);
        push(rub * -nz, rub * nx);
        if (energy() > before) {
            // Newton's restitution with friction may add energy (Kane and Levinson 1985); without friction it does not.
            push(rub * nz, rub * -nx);
        }
        impulse += j;
        return true;
    }

    /** How fast the two part at the point along a direction; below 0 where they approach. */
    private double relative(double x, double z) {
        double speed = speed(a, x, z);
        return b == null ? speed : speed - speed(b, x, z);
    }

    private double speed(BodyState of, double x, double z) {
        return of.vx * x + of.vz * z + of.w * lever(of, x, z);
    }

    /** The torque about the vertical of a unit force at the point. */
    private double lever(BodyState of, double x, double z) {
        Point c = of.object.center();
        return (point.z() - c.z()) * x - (point.x() - c.x()) * z;
    }

    /** The change of the relative speed along a direction by a unit impulse along it. */
    private double softness(double x, double z) {
        double soft = softness(a, x, z);
        return b == null ? soft : soft + softness(b, x, z);
    }

    private double softness(BodyState of, double x, double z) {
        double lever = lever(of, x, z);
        return 1 / of.body.mass() + lever * lever / of.body.inertia();
    }

    private void push(double x, double z) {
        push(a, x, z);
        if (b != null) {
            push(b, -x, -z);
        }
    }

    private void push(BodyState of, double x, double z) {
        of.vx += x / of.body.mass();
        of.vz += z / of.body.mass();
        of.w += lever(of, x, z) / of.body.inertia();
    }

    private double energy() {
        return b == null ? a.energy() : a.energy() + b.energy();
    }

    BodyContact contact() {
        return new BodyContact(a.name, b == null ? other : b.name, point, normal, impulse);
    }
}
