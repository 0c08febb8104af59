package robosim.geometry.index.boxes;

/**
 * The keys by which a query orders boxes of six numbers: a lower bound of the parameter or distance at which a box
 * begins, infinite if the query misses it.
 */
public final class SpaceKeys {
    private enum Query {
        BOX,
        RAY,
        POINT,
        CONE
    }

    private Query query = Query.BOX;
    private final Slab slabX = new Slab();
    private final Slab slabY = new Slab();
    private final Slab slabZ = new Slab();
    private final double[] box = new double[6];
    private double x;
    private double y;
    private double z;
    private double ux;
    private double uy;
    private double uz;
    private double cos;
    private double sin;
    private double away;

    /** Starts a box query: all boxes that meet this one begin at 0. */
    public void startBox(double[] of) {
        query = Query.BOX;
        System.arraycopy(of, 0, box, 0, 6);
    }

    /** Starts a ray query: a box begins at a parameter of the direction, whose length is about 1. */
    public void startRay(double ox, double oy, double oz, double dx, double dy, double dz) {
        query = Query.RAY;
        slabX.start(ox, dx, dx);
        slabY.start(oy, dy, dy);
        slabZ.start(oz, dz, dz);
    }

    /** Starts a point query: a box begins at its distance. */
    public void startPoint(double px, double py, double pz) {
        query = Query.POINT;
        x = px;
        y = py;
        z = pz;
        away = Math.abs(px) + Math.abs(py) + Math.abs(pz);
    }

    /**
     * Starts a cone query: a box begins at its distance from the apex, and is missed if it lies wholly outside the cone
     * around a unit vector.
     */
    public void startCone(
            double px, double py, double pz, double ax, double ay, double az, double halfCos, double halfSin) {
        startPoint(px, py, pz);
        query = Query.CONE;
        ux = ax;
        uy = ay;
        uz = az;
        cos = halfCos;
        sin = halfSin;
    }

    /** The key of the box whose six numbers begin at {@code at}. */
    public double key(double[] of, int at) {
        return switch (query) {
            case BOX -> boxKey(of, at);
            case RAY -> rayKey(of, at);
            case POINT -> pointKey(of, at);
            case CONE -> isBeyondCone(of, at) ? Double.POSITIVE_INFINITY : pointKey(of, at);
        };
    }

    private double boxKey(double[] of, int at) {
        boolean meets = of[at] <= box[3]
                && box[0] <= of[at + 3]
                && of[at + 1] <= box[4]
                && box[1] <= of[at + 4]
                && of[at + 2] <= box[5]
                && box[2] <= of[at + 5];
        return meets ? 0 : Double.POSITIVE_INFINITY;
    }

    private double rayKey(double[] of, int at) {
        if (slabX.misses(of[at], of[at + 3])
                || slabY.misses(of[at + 1], of[at + 4])
                || slabZ.misses(of[at + 2], of[at + 5])) {
            return Double.POSITIVE_INFINITY;
        }
        double enter = Math.max(
                Math.max(0, slabX.entry(of[at], of[at + 3])),
                Math.max(slabY.entry(of[at + 1], of[at + 4]), slabZ.entry(of[at + 2], of[at + 5])));
        double leave = Math.min(
                slabX.exit(of[at], of[at + 3]),
                Math.min(slabY.exit(of[at + 1], of[at + 4]), slabZ.exit(of[at + 2], of[at + 5])));
        return enter <= leave ? enter : Double.POSITIVE_INFINITY;
    }

    private double pointKey(double[] of, int at) {
        double dx = Math.max(0, Math.max(of[at] - x, x - of[at + 3]));
        double dy = Math.max(0, Math.max(of[at + 1] - y, y - of[at + 4]));
        double dz = Math.max(0, Math.max(of[at + 2] - z, z - of[at + 5]));
        double square = dx * dx + dy * dy + dz * dz;
        // If squares lose bits or overflow, the longest leg is used as the lower bound.
        double distance = square > 0x1p-960 && square < 0x1p1000 ? Math.sqrt(square) : Math.max(dx, Math.max(dy, dz));
        return Math.max(0, distance * Slab.DOWN - Double.MIN_VALUE);
    }

    /**
     * Whether a box lies beyond the plane that touches the cone along the line nearest to the box's centre. With e the
     * unit vector from the axis to the centre, the plane's normal is {@code e cos - u sin}; no point of the cone is in
     * front of it, as its distance from the axis is at most {@code sin / cos} times its position along the axis.
     */
    private boolean isBeyondCone(double[] of, int at) {
        double hx = 0.5 * (of[at + 3] - of[at]);
        double hy = 0.5 * (of[at + 4] - of[at + 1]);
        double hz = 0.5 * (of[at + 5] - of[at + 2]);
        double mx = of[at] + hx - x;
        double my = of[at + 1] + hy - y;
        double mz = of[at + 2] + hz - z;
        double ahead = mx * ux + my * uy + mz * uz;
        double ex = mx - ahead * ux;
        double ey = my - ahead * uy;
        double ez = mz - ahead * uz;
        double aside = Math.sqrt(ex * ex + ey * ey + ez * ez);
        double size = Math.abs(mx) + Math.abs(my) + Math.abs(mz) + hx + hy + hz;
        if (!(aside > 0x1p-20 * size)) {
            return false;
        }
        double nx = ex / aside * cos - ux * sin;
        double ny = ey / aside * cos - uy * sin;
        double nz = ez / aside * cos - uz * sin;
        double gap = nx * mx + ny * my + nz * mz - (Math.abs(nx) * hx + Math.abs(ny) * hy + Math.abs(nz) * hz);
        // e is off by at most 2^-30 of its length along the axis, and otherwise by roundings of 2^-53.
        return gap > 0x1p-28 * size + 0x1p-40 * away;
    }
}
