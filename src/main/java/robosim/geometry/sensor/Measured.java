package robosim.geometry.sensor;

/** What the effects of a noise work on: the distances of a frame, and what is known of their rays. */
final class Measured {
    private static final double[] NONE = new double[0];

    /** Distances, +Infinity where nothing echoes; changed in place. */
    double[] distances = NONE;

    int count;

    /** The cosine of each ray's angle of incidence, from 0 to 1, -1 for no surface; empty where no effect needs it. */
    double[] incidence = NONE;

    /** The nearest distance in the cone around each ray; empty where no effect needs it. */
    double[] cones = NONE;

    double min;
    double max;

    /** Puts distances into the sensor's range: below it they are its least, beyond it they are none. */
    void clamp() {
        for (int k = 0; k < count; k++) {
            double distance = distances[k];
            distances[k] = distance < min ? min : distance > max ? Double.POSITIVE_INFINITY : distance;
        }
    }
}
