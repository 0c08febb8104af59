package robosim.geometry.dynamics.proof;

/**
 * A disc with a differential drive that pushes a square box over a floor that rubs, by little steps in each of which all
 * impulses are found in turns: those of the two rims, of the wheels against going sideways, of the floor and of the one
 * contact. Nothing of it is shared with the step.
 */
public final class PushTwin {
    private static final double GRAVITY = 9.80665;
    private static final int TURNS = 400;

    private final double discMass;
    private final double discInertia;
    private final double radius;
    private final double boxMass;
    private final double boxInertia;
    private final double half;
    private final double still;
    private final double sliding;

    // Most impulses of a step: of the drive as a change of a rim's speed, of the floor as changes of the box's
    // velocity.
    private double drive;
    private double drag;
    private double spinDrag;

    public double x;
    public double z;
    public double angle;
    public double vx;
    public double vz;
    private double w;
    private double boxX;
    private double boxZ;
    private double boxAngle;
    private double boxVx;
    private double boxVz;
    private double boxW;

    /** A disc at the origin that goes along X with a speed, and a box. */
    public PushTwin(
            double discMass,
            double radius,
            double speed,
            double boxMass,
            double side,
            double[] boxPlace,
            double still,
            double sliding) {
        this.discMass = discMass;
        this.radius = radius;
        this.boxMass = boxMass;
        this.still = still;
        this.sliding = sliding;
        half = side / 2;
        discInertia = discMass * radius * radius / 2;
        boxInertia = boxMass * side * side / 6;
        vx = speed;
        boxX = boxPlace[0];
        boxZ = boxPlace[1];
        boxAngle = boxPlace[2];
    }

    /** Lets a little time pass; tells whether the two press each other. */
    public boolean step(double seconds, double friction, double track, double acceleration, double command) {
        drive = acceleration * seconds;
        drag = friction * GRAVITY * seconds;
        spinDrag = drag * (2.0 / 3) * Math.sqrt(2 * boxMass / boxInertia);
        double pushed = solve(track, command);
        x += vx * seconds;
        z += vz * seconds;
        angle += w * seconds;
        boxX += boxVx * seconds;
        boxZ += boxVz * seconds;
        boxAngle += boxW * seconds;
        return pushed > 0;
    }

    private double solve(double track, double command) {
        double aheadX = Math.cos(angle);
        double aheadZ = -Math.sin(angle);
        // The point of the box nearest to the disc, in the box's axes and then in the world's.
        double cos = Math.cos(boxAngle);
        double sin = Math.sin(boxAngle);
        double ownX = (x - boxX) * cos - (z - boxZ) * sin;
        double ownZ = (x - boxX) * sin + (z - boxZ) * cos;
        double fromX = ownX - Math.max(-half, Math.min(half, ownX));
        double fromZ = ownZ - Math.max(-half, Math.min(half, ownZ));
        double distance = Math.hypot(fromX, fromZ);
        double nx = (fromX * cos + fromZ * sin) / distance;
        double nz = (fromZ * cos - fromX * sin) / distance;
        boolean isTouching = distance < radius + 1e-6;
        if (isTouching && distance < radius) {
            boxX -= (radius - distance) * nx;
            boxZ -= (radius - distance) * nz;
        }
        double px = x - radius * nx - boxX;
        double pz = z - radius * nz - boxZ;
        double leverBox = pz * nx - px * nz;
        double asideBox = pz * -nz - px * nx;
        double soft = 1 / discMass + 1 / boxMass + leverBox * leverBox / boxInertia;
        double softAside =
                1 / discMass + 1 / boxMass + radius * radius / discInertia + asideBox * asideBox / boxInertia;
        double left = 0;
        double right = 0;
        double floorX = 0;
        double floorZ = 0;
        double floorTurn = 0;
        double push = 0;
        double rub = 0;
        for (int turn = 0; turn < TURNS; turn++) {
            double aside = vz * aheadX - vx * aheadZ;
            vx += aside * aheadZ;
            vz -= aside * aheadX;
            double ahead = vx * aheadX + vz * aheadZ;
            double nextLeft = limit(left + command - (ahead - w * track / 2), drive);
            double nextRight = limit(right + command - (ahead + w * track / 2), drive);
            double gain = ((nextLeft - left) + (nextRight - right)) / 2;
            vx += gain * aheadX;
            vz += gain * aheadZ;
            w += ((nextRight - right) - (nextLeft - left)) / track;
            left = nextLeft;
            right = nextRight;
            double holdX = floorX - boxVx;
            double holdZ = floorZ - boxVz;
            double hold = Math.hypot(holdX, holdZ);
            double share = hold > drag ? drag / hold : 1;
            double holdTurn = limit(floorTurn - boxW, spinDrag);
            boxVx += share * holdX - floorX;
            boxVz += share * holdZ - floorZ;
            boxW += holdTurn - floorTurn;
            floorX = share * holdX;
            floorZ = share * holdZ;
            floorTurn = holdTurn;
            if (isTouching) {
                double parting = (vx - boxVx) * nx + (vz - boxVz) * nz - boxW * leverBox;
                double pushed = Math.max(0, push - parting / soft);
                give(pushed - push, nx, nz, 0, leverBox);
                push = pushed;
                // A force along the contact has the disc's radius as its lever.
                double slip = (vx - boxVx) * -nz + (vz - boxVz) * nx + w * radius - boxW * asideBox;
                double rubbed = rub - slip / softAside;
                rubbed = Math.abs(rubbed) > still * push ? Math.copySign(sliding * push, rubbed) : rubbed;
                give(rubbed - rub, -nz, nx, radius, asideBox);
                rub = rubbed;
            }
        }
        return push;
    }

    private void give(double by, double dx, double dz, double leverDisc, double leverBox) {
        vx += by * dx / discMass;
        vz += by * dz / discMass;
        w += by * leverDisc / discInertia;
        boxVx -= by * dx / boxMass;
        boxVz -= by * dz / boxMass;
        boxW -= by * leverBox / boxInertia;
    }

    private static double limit(double value, double most) {
        return Math.max(-most, Math.min(most, value));
    }
}
