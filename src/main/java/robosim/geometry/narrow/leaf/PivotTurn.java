package robosim.geometry.narrow.leaf;

/** A turn about an axis through a pivot, counter-clockwise. An instance belongs to the query that sets it. */
public final class PivotTurn {
    /** The pivot. */
    public double px;

    public double py;
    public double pz;

    /** The axis, of length 1. */
    public double wx;

    public double wy = 1;
    public double wz;

    /** The angle, of any size and sign. */
    public double degrees;

    /** Sets the pivot. */
    public PivotTurn about(double pivotX, double pivotY, double pivotZ) {
        px = pivotX;
        py = pivotY;
        pz = pivotZ;
        return this;
    }

    /** Sets the axis and the angle. */
    public PivotTurn by(double axisX, double axisY, double axisZ, double angle) {
        wx = axisX;
        wy = axisY;
        wz = axisZ;
        degrees = angle;
        return this;
    }

    /** Whether the axis is vertical, so that heights stay. */
    public boolean isLevel() {
        return wx == 0 && wz == 0;
    }
}
