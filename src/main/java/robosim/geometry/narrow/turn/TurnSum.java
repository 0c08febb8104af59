package robosim.geometry.narrow.turn;

/** Sinusoids {@code k + a cos t + b sin t}, one for each point of a leaf. */
final class TurnSum {
    int count;
    private double wx;
    private double wy;
    private double wz;
    final double[] k = new double[TurnBody.MOST_POINTS];
    final double[] a = new double[TurnBody.MOST_POINTS];
    final double[] b = new double[TurnBody.MOST_POINTS];

    /** Begins with sinusoids of turns about a unit axis. */
    void clear(double axisX, double axisY, double axisZ) {
        wx = axisX;
        wy = axisY;
        wz = axisZ;
        count = 0;
    }

    /** Adds {@code constant + u.Rv}, R being the turn by t about the unit axis w. */
    void add(double constant, double ux, double uy, double uz, double vx, double vy, double vz) {
        double along = (ux * wx + uy * wy + uz * wz) * (wx * vx + wy * vy + wz * vz);
        k[count] = constant + along;
        a[count] = ux * vx + uy * vy + uz * vz - along;
        b[count] = ux * (wy * vz - wz * vy) + uy * (wz * vx - wx * vz) + uz * (wx * vy - wy * vx);
        count++;
    }

    /** The least of them at the angle of this cosine and sine. */
    double least(double cos, double sin) {
        double least = Double.POSITIVE_INFINITY;
        for (int m = 0; m < count; m++) {
            least = Math.min(least, k[m] + a[m] * cos + b[m] * sin);
        }
        return least;
    }
}
