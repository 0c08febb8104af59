package robosim.geometry.index.meshes;

/**
 * The keys by which a ray or point query orders boxes of four numbers: a lower bound of the parameter or distance at
 * which a box begins, infinite if the query misses it.
 */
public final class PlaneKeys {
    private final Slab slabX = new Slab();
    private final Slab slabZ = new Slab();
    private boolean isRay;
    private double fromX;
    private double fromZ;
    private double unit = 1;
    private final double[] flat = new double[4];

    public void startRay(double ox, double oz, double dx, double dz) {
        unit = Slab.scale(Math.max(Math.abs(dx), Math.abs(dz)));
        slabX.start(ox, dx * unit, dx);
        slabZ.start(oz, dz * unit, dz);
        isRay = true;
    }

    public void startPoint(double x, double z) {
        if (!Double.isFinite(x) || !Double.isFinite(z)) {
            throw new IllegalArgumentException("point must be finite (got: " + x + ", " + z + ")");
        }
        unit = 1;
        fromX = x;
        fromZ = z;
        isRay = false;
    }

    /** Converts the caller's parameter to a key, rounded up. */
    public double inner(double limit) {
        return Slab.inner(limit, unit);
    }

    /** Converts a key to the caller's parameter, rounded down. */
    public double outer(double key) {
        return Slab.outer(key, unit);
    }

    public double key(double[] boxes, int at) {
        return isRay ? rayKey(boxes, at) : pointKey(boxes, at);
    }

    /** The key of one box of six numbers, whose heights are ignored. */
    public double keyOfObject(double[] boxes, int at) {
        flat[0] = boxes[at];
        flat[1] = boxes[at + 2];
        flat[2] = boxes[at + 3];
        flat[3] = boxes[at + 5];
        return key(flat, 0);
    }

    private double rayKey(double[] boxes, int at) {
        double x0 = boxes[at];
        double z0 = boxes[at + 1];
        double x1 = boxes[at + 2];
        double z1 = boxes[at + 3];
        if (slabX.misses(x0, x1) || slabZ.misses(z0, z1)) {
            return Double.POSITIVE_INFINITY;
        }
        double enter = Math.max(0, Math.max(slabX.entry(x0, x1), slabZ.entry(z0, z1)));
        double leave = Math.min(slabX.exit(x0, x1), slabZ.exit(z0, z1));
        return enter <= leave ? enter : Double.POSITIVE_INFINITY;
    }

    private double pointKey(double[] boxes, int at) {
        double dx = Math.max(0, Math.max(boxes[at] - fromX, fromX - boxes[at + 2]));
        double dz = Math.max(0, Math.max(boxes[at + 1] - fromZ, fromZ - boxes[at + 3]));
        double square = dx * dx + dz * dz;
        // If squares lose bits or overflow, the longer leg is used as the lower bound.
        double distance = square > 0x1p-960 && square < 0x1p1000 ? Math.sqrt(square) : Math.max(dx, dz);
        return Math.max(0, distance * Slab.DOWN - Double.MIN_VALUE);
    }
}
