package robosim.geometry.sensor;

/**
 * What a sensor reports where an echo is out of its range. In either case such a ray has no point and no intensity, and
 * clouds leave it out.
 */
public enum OutOfRange {
    /** The blind range for an echo nearer than that, and {@code +Infinity} for none within the range. */
    CLAMPED,
    /**
     * The values of ROS (REP 117) and Gazebo: {@code -Infinity} for an echo nearer than the blind range, {@code +Infinity}
     * for none within the range, and NaN for a reading that {@link Noise#dropout} lost.
     */
    REP_117;

    /** What a lost reading is. */
    double lost() {
        return this == REP_117 ? Double.NaN : Double.POSITIVE_INFINITY;
    }

    /** What is reported for an echo nearer than a blind range; the distance is that range where noise left it alone. */
    double near(double distance, double min) {
        return this == REP_117 ? Double.NEGATIVE_INFINITY : Math.max(distance, min);
    }
}
