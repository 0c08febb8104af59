package robosim.geometry.dynamics;

import robosim.geometry.exact.Degrees;

/** Drives on plain numbers, which allocate nothing: metres a second forward, up and to the right, degrees a second. */
final class Drives {
    private Drives() {}

    /** What {@link Drive#next} answers, in place. */
    static void next(Drive drive, double[] v, Body body, double seconds) {
        if (drive instanceof DifferentialDrive of) {
            of.next(v, body, seconds);
        } else if (drive instanceof OmnidirectionalDrive of) {
            of.next(v, body, seconds);
        } else if (drive instanceof AckermannDrive of) {
            of.next(v, body, seconds);
        } else if (drive instanceof SwerveDrive of) {
            of.next(v, body, seconds);
        } else if (drive instanceof VelocityDrive of) {
            of.next(v, body);
        } else if (drive instanceof ForceDrive of) {
            of.next(v, body, seconds);
        }
    }

    /** The most acceleration along the ground, m/s^2; infinite for no limit. */
    static double acceleration(Drive drive, Body body) {
        if (drive instanceof SwerveDrive of) {
            return of.acceleration(body);
        }
        if (drive instanceof DifferentialDrive of) {
            return of.maxAcceleration();
        }
        if (drive instanceof OmnidirectionalDrive of) {
            return of.maxAcceleration();
        }
        return drive instanceof AckermannDrive of ? of.maxAcceleration() : Double.POSITIVE_INFINITY;
    }

    /** Metres from the middle to each of two wheels; 0 for other drives. */
    static double rim(Drive drive) {
        return drive instanceof DifferentialDrive of ? of.track() / 2 : 0;
    }

    /** The most angular acceleration, radians/s^2; infinite for no limit. */
    static double turnAcceleration(Drive drive) {
        if (drive instanceof OmnidirectionalDrive of && of.maxTurnAcceleration() < Double.POSITIVE_INFINITY) {
            return Degrees.toRadians(of.maxTurnAcceleration());
        }
        return Double.POSITIVE_INFINITY;
    }

    /** Whether it may go sideways. */
    static boolean isAnyWay(Drive drive) {
        return drive instanceof OmnidirectionalDrive
                || drive instanceof SwerveDrive
                || drive instanceof VelocityDrive
                || drive instanceof ForceDrive;
    }
}
