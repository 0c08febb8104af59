package robosim.geometry.dynamics.planar;

/** The points at which two pieces touch that have just been measured: one, or both ends of a common edge. */
final class Manifold {
    int count;
    final double[] x = new double[2];
    final double[] z = new double[2];
    private final int[] ofA = new int[2];
    private final int[] ofB = new int[2];

    /**
     * Takes the points where the two are next to each other.
     *
     * @param slack corners that are further behind by no more than this count as on the same edge
     */
    void take(PieceSeparation s, double radiusA, double radiusB, double distance, double slack) {
        double nx = s.nx;
        double nz = s.nz;
        int na = PieceSeparation.support(s.ax, s.az, s.an, -nx, -nz, slack, ofA);
        int nb = PieceSeparation.support(s.bx, s.bz, s.bn, nx, nz, slack, ofB);
        count = 1;
        if (na == 1 && nb == 1) {
            x[0] = 0.5
                    * ((s.ax[ofA[0]] - nx * (radiusA + 0.5 * distance))
                            + (s.bx[ofB[0]] + nx * (radiusB + 0.5 * distance)));
            z[0] = 0.5
                    * ((s.az[ofA[0]] - nz * (radiusA + 0.5 * distance))
                            + (s.bz[ofB[0]] + nz * (radiusB + 0.5 * distance)));
            return;
        }
        if (na == 1) {
            x[0] = s.ax[ofA[0]] - nx * (radiusA + 0.5 * distance);
            z[0] = s.az[ofA[0]] - nz * (radiusA + 0.5 * distance);
            return;
        }
        if (nb == 1) {
            x[0] = s.bx[ofB[0]] + nx * (radiusB + 0.5 * distance);
            z[0] = s.bz[ofB[0]] + nz * (radiusB + 0.5 * distance);
            return;
        }
        // Along (-nz, nx); the points of a were sorted the other way round.
        double a0 = along(nx, nz, s.ax[ofA[0]], s.az[ofA[0]]);
        double a1 = along(nx, nz, s.ax[ofA[1]], s.az[ofA[1]]);
        double b0 = along(nx, nz, s.bx[ofB[0]], s.bz[ofB[0]]);
        double b1 = along(nx, nz, s.bx[ofB[1]], s.bz[ofB[1]]);
        double from = Math.max(Math.min(a0, a1), Math.min(b0, b1));
        double to = Math.min(Math.max(a0, a1), Math.max(b0, b1));
        double heightA = 0.5 * ((s.ax[ofA[0]] * nx + s.az[ofA[0]] * nz) + (s.ax[ofA[1]] * nx + s.az[ofA[1]] * nz));
        double heightB = 0.5 * ((s.bx[ofB[0]] * nx + s.bz[ofB[0]] * nz) + (s.bx[ofB[1]] * nx + s.bz[ofB[1]] * nz));
        double height = 0.5 * ((heightA - radiusA) + (heightB + radiusB));
        if (to - from <= slack) {
            put(0, height, 0.5 * (from + to), nx, nz);
            return;
        }
        count = 2;
        // In an order that a mirror keeps.
        boolean isFromFirst = Math.abs(from) <= Math.abs(to);
        put(0, height, isFromFirst ? from : to, nx, nz);
        put(1, height, isFromFirst ? to : from, nx, nz);
    }

    private void put(int k, double height, double along, double nx, double nz) {
        x[k] = nx * height - nz * along;
        z[k] = nz * height + nx * along;
    }

    private static double along(double nx, double nz, double x, double z) {
        return nx * z - nz * x;
    }
}
