package robosim.geometry.sensor;

/** What a sensor reports where an echo is out of its range. */
enum OutOfRange {
    /** See {@link RaySensor#withClampedRanges}. */
    CLAMPED,
    /** See {@link RaySensor#withRep117}. */
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
