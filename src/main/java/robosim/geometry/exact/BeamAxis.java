package robosim.geometry.exact;

/**
 * Where a query looks: along a ray, or into a cone about one. An instance belongs to one owner of queries and is set once for
 * each beam, whatever number of shapes it is shown to.
 */
public final class BeamAxis {
    /** The start. */
    public double ox;

    public double oy;
    public double oz;

    /** The direction that decides: as it was given, but for a power of two; its greatest number is within 2^-100 and 2^100. */
    public double dx;

    public double dy;
    public double dz;

    /** Whether the beam has a width. */
    public boolean isCone;

    /** Of half the opening angle, which is above 0 and below 90 degrees where the beam has a width; the cosine decides. */
    public double cos = 1;

    public double sin;

    private double ux;
    private double uy;
    private double uz;
    private boolean hasUnit;

    /** Sets a ray. The direction is of any length but zero. */
    public BeamAxis line(double x, double y, double z, double wayX, double wayY, double wayZ) {
        ox = x;
        oy = y;
        oz = z;
        double sum = Math.abs(wayX) + Math.abs(wayY) + Math.abs(wayZ);
        // Scaling by a power of two near the greatest prevents overflow; if none is possible, the numbers stay, so that
        // a coordinate near zero keeps its bits.
        double scale = sum >= 0x1p-98 && sum <= 0x1p100 ? 1 : scale(VectorMath.largest(wayX, wayY, wayZ));
        dx = wayX * scale;
        dy = wayY * scale;
        dz = wayZ * scale;
        hasUnit = false;
        isCone = false;
        return this;
    }

    private static double scale(double greatest) {
        return greatest >= 0x1p-100 && greatest <= 0x1p100 ? 1 : Math.scalb(1.0, -Math.getExponent(greatest));
    }

    /** Makes the ray the axis of a cone. */
    public BeamAxis widen(double cosine, double sine) {
        isCone = true;
        cos = cosine;
        sin = sine;
        return this;
    }

    /** Sets the same beam from another start. */
    public BeamAxis from(BeamAxis beam, double x, double y, double z) {
        ox = x;
        oy = y;
        oz = z;
        dx = beam.dx;
        dy = beam.dy;
        dz = beam.dz;
        isCone = beam.isCone;
        cos = beam.cos;
        sin = beam.sin;
        hasUnit = beam.hasUnit;
        ux = beam.ux;
        uy = beam.uy;
        uz = beam.uz;
        return this;
    }

    /** The length of the direction. */
    public double length() {
        return VectorMath.length(dx, dy, dz);
    }

    /** The reciprocal of the {@link #length}, or slightly more. */
    public double inverseLength() {
        double square = dx * dx + dy * dy + dz * dz;
        return Math.abs(square - 1) < 0x1p-40 ? 1 + 0x1p-40 : 1 / Math.sqrt(square);
    }

    /** The largest magnitude of a coordinate of the start. */
    public double largest() {
        return VectorMath.largest(ox, oy, oz);
    }

    /** The distance at a parameter, see {@link VectorMath#along}. */
    public double along(double t, double tail) {
        return VectorMath.along(t, tail, dx, dy, dz);
    }

    /** X of the unit direction, which is computed when it is first asked for. */
    public double ux() {
        takeUnit();
        return ux;
    }

    public double uy() {
        takeUnit();
        return uy;
    }

    public double uz() {
        takeUnit();
        return uz;
    }

    private void takeUnit() {
        if (!hasUnit) {
            double length = length();
            ux = dx / length;
            uy = dy / length;
            uz = dz / length;
            hasUnit = true;
        }
    }
}
