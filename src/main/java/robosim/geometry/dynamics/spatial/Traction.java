package robosim.geometry.dynamics.spatial;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * Impulses by which drives move what stands on its wheels: forward, to the side and about the normal of the ground, each
 * within the limits of the drive, and all within what Coulomb's friction can give at the contacts below.
 *
 * <p>They act at the height of the centre, as if the mass lay at the wheels, so that no drive tips its body over. On a slope
 * a drive holds its body, and its limits count beyond that. What carries the body takes the opposite impulses.
 */
final class Traction {
    /** A contact is below a body if its normal is within 60 degrees of the body's own up. */
    private static final double BELOW = 0.5;

    private final List<RigidBody> bodies;
    private final double[] gravity;
    private final Clusters cluster;
    private final Driver.Aim aim = new Driver.Aim();
    private final List<Wheels> all = new ArrayList<>();
    private Driver driver = Driver.NONE;

    /** The wheels of a body among those in use, by its index; -1 for none. */
    private int[] wheelsOf = new int[0];

    private int count;

    Traction(List<RigidBody> bodies, double[] gravity, Clusters cluster) {
        this.bodies = bodies;
        this.gravity = gravity;
        this.cluster = cluster;
    }

    void driveBy(Driver by) {
        driver = by;
    }

    /** Notes which bodies have a drive, and wakes those that theirs moves. */
    void begin(double seconds) {
        for (int b = 0; b < bodies.size(); b++) {
            begin(b, seconds);
        }
    }

    /** The same for a cluster. */
    void begin(Clusters of, double seconds) {
        for (int m = 0; m < of.count; m++) {
            begin(of.member[m], seconds);
        }
    }

    private void begin(int b, double seconds) {
        RigidBody body = bodies.get(b);
        aim.set(0, 0, 0);
        body.isDriven = driver.next(b, aim, seconds);
        body.isDriving = body.isDriven && !aim.isStill();
        if (body.isDriving && body.isAsleep) {
            body.wake();
        }
    }

    /** Whether a contact is below a driven body; the sign is 1 for a normal towards it, else -1. */
    static boolean isBelow(RigidBody body, double[] normal, int at, double sign) {
        double[] place = body.place;
        double along = normal[at] * place[4] + normal[at + 1] * place[7] + normal[at + 2] * place[10];
        return body.isDriven && sign * along > BELOW;
    }

    /** Whether a contact is below a body as gravity has it. */
    boolean carries(double[] normal, int at, double sign) {
        double along = -(normal[at] * gravity[0] + normal[at + 1] * gravity[1] + normal[at + 2] * gravity[2]);
        return sign * along > BELOW * RigidBody.length(gravity, 0);
    }

    /**
     * Finds what stands on its wheels, before impulses at the end of a slice.
     *
     * @param wheel of each contact, the body of which it is a wheel, or -1
     * @param only  the one body that matters, or -1 for all
     */
    void prepare(Contacts contacts, int[] wheel, boolean[] isOff, int only, double seconds) {
        count = 0;
        if (wheelsOf.length < bodies.size()) {
            wheelsOf = new int[bodies.size()];
        }
        for (int m = 0; m < cluster.count; m++) {
            wheelsOf[cluster.member[m]] = -1;
        }
        for (int k = 0; k < contacts.count; k++) {
            int b = wheel[k];
            if (b >= 0 && !isOff[k] && (only < 0 || b == only) && cluster.has(b)) {
                if (wheelsOf[b] < 0) {
                    claim(b);
                }
                double sign = contacts.body[k] == b ? 1 : -1;
                double[] up = all.get(wheelsOf[b]).up;
                for (int axis = 0; axis < 3; axis++) {
                    up[axis] += sign * contacts.normal[3 * k + axis];
                }
            }
        }
        for (int m = 0; count > 0 && m < cluster.count; m++) {
            int b = cluster.member[m];
            if (wheelsOf[b] >= 0) {
                RigidBody body = bodies.get(b);
                body.isOnWheels = true;
                Wheels wheels = all.get(wheelsOf[b]);
                wheels.begin(body, support(contacts, wheel, b));
                wheels.aim(b, driver, aim, seconds, gravity);
            }
        }
    }

    private void claim(int b) {
        if (count == all.size()) {
            all.add(new Wheels(bodies.get(b)));
        }
        wheelsOf[b] = count;
        Arrays.fill(all.get(count++).up, 0);
    }

    /** The one moving body on which a body stands; null if anything below it stands still. */
    private @Nullable RigidBody support(Contacts contacts, int[] wheel, int b) {
        @Nullable RigidBody first = null;
        for (int k = 0; k < contacts.count; k++) {
            if (wheel[k] == b) {
                int other = contacts.body[k] == b ? contacts.other[k] : contacts.body[k];
                if (other < 0 || bodies.get(other).isAsleep) {
                    return null;
                }
                first = first == null ? bodies.get(other) : first;
            }
        }
        return first;
    }

    /** Lets all drives act, as far as what presses on their wheels allows; answers by how much that changes a velocity. */
    double roll(Contacts contacts, int[] wheel, double[] pushed, double[] still, double[] slides) {
        for (int w = 0; w < count; w++) {
            all.get(w).grip = 0;
        }
        for (int k = 0; count > 0 && k < contacts.count; k++) {
            if (wheel[k] >= 0 && cluster.has(wheel[k]) && wheelsOf[wheel[k]] >= 0) {
                Wheels wheels = all.get(wheelsOf[wheel[k]]);
                wheels.grip += (wheels.isSliding ? slides[k] : still[k]) * pushed[k];
            }
        }
        double most = 0;
        for (int w = 0; w < count; w++) {
            most = Math.max(most, all.get(w).roll());
        }
        return most;
    }

    /** Notes the work that drives have done. */
    void finish() {
        for (int m = 0; count > 0 && m < cluster.count; m++) {
            int b = cluster.member[m];
            if (wheelsOf[b] >= 0) {
                RigidBody body = bodies.get(b);
                body.lastWork = Math.max(0, all.get(wheelsOf[b]).work());
                body.work += body.lastWork;
            }
        }
    }
}
