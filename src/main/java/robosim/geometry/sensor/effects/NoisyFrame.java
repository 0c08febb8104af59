package robosim.geometry.sensor.effects;

/** What the effects of a noise work on: the distances of a frame, and what is known of their rays. */
public final class NoisyFrame {
    private static final double[] NONE = new double[0];

    /** Distances, +Infinity where nothing echoes; changed in place. */
    public double[] distances = NONE;

    public int count;

    /** The cosine of each ray's angle of incidence, from 0 to 1, -1 for no surface; empty where no effect needs it. */
    public double[] incidence = NONE;

    /** The nearest distance in the cone around each ray; empty where no effect needs it. */
    public double[] cones = NONE;

    public double min;
    public double max;

    /** What a reading that got lost is: +Infinity, or NaN. */
    public double lost = Double.POSITIVE_INFINITY;

    /** Puts distances into the sensor's range: below it they are its least, beyond it they are none. */
    public void clamp() {
        for (int k = 0; k < count; k++) {
            double distance = distances[k];
            distances[k] = distance < min ? min : distance > max ? Double.POSITIVE_INFINITY : distance;
        }
    }
}
