package robosim.geometry.dynamics.spatial;

/** What drives bodies that stand on something. */
public interface Driver {
    /** Drives nothing. */
    Driver NONE = (b, aim, seconds) -> false;

    /**
     * Works out what the drive of a body makes of its velocity in a time, and what it can.
     *
     * @param aim has the velocity, and takes the answer
     * @return whether the body has a drive; if not, nothing is written
     */
    boolean next(int b, Aim aim, double seconds);

    /** A velocity along the ground, and the limits of a drive. */
    final class Aim {
        /** m/s forward. */
        public double forward;

        /** m/s to the right. */
        public double right;

        /** Radians a second, counter-clockwise. */
        public double turn;

        /** The most acceleration along the ground, m/s^2, and radians/s^2; infinite for no limit. */
        public double acceleration;

        public double turnAcceleration;

        /** Metres from the middle to each of two wheels, whose rims share the limit of acceleration; 0 for other drives. */
        public double rim;

        /** Whether wheels let it roll sideways too. */
        public boolean isAnyWay;

        /** Whether it is the force that is given, and not the velocity. */
        public boolean isForce;

        void set(double toForward, double toRight, double toTurn) {
            forward = toForward;
            right = toRight;
            turn = toTurn;
        }

        boolean isStill() {
            return forward == 0 && right == 0 && turn == 0;
        }
    }
}
