package robosim.geometry.narrow.cone;

import robosim.geometry.exact.BeamAxis;
import robosim.geometry.exact.FilterBound;
import robosim.geometry.narrow.planar.PlanarShape;

/** The two edges of a sector of the plane in doubles; decides what is certainly inside or outside. */
final class PlanarSector {
    /**
     * Roundoff of a product with an edge in units of the magnitudes: 3u for the edge, u for the coordinates, 2u for the
     * product; taken as 8u. No test distinguishes a tenth of it from the whole: the error of the sine is added, at
     * least 4u of itself, and that alone covers the observed sum of these roundings.
     */
    private static final double EDGE_ERROR = 8 * 0x1p-53;

    private static final double FILTER = FilterBound.bound(EDGE_ERROR);

    double leftX;
    double leftZ;
    double rightX;
    double rightZ;

    /** The error bound of a product with an edge, as a share of the other vector's size. */
    private double doubt;

    /** At least the length of either edge. */
    private double most;

    /** Sets a sector about a level beam. The cosine decides: the error of the sine relative to it is added to the doubt. */
    void set(BeamAxis beam) {
        double ux = beam.dx;
        double uz = beam.dz;
        double halfCos = beam.cos;
        double halfSin = beam.sin;
        leftX = ux * halfCos - uz * halfSin;
        leftZ = ux * halfSin + uz * halfCos;
        rightX = ux * halfCos + uz * halfSin;
        rightZ = uz * halfCos - ux * halfSin;
        most = Math.abs(ux) + Math.abs(uz);
        double sineOff = (Math.abs(halfCos * halfCos + halfSin * halfSin - 1) + 4 * 0x1p-53) / halfSin;
        doubt = (FILTER + sineOff) * most;
    }

    /** Whether a point is certainly in the sector, with all points of a square of the given error around it. */
    boolean surelyHolds(double wx, double wz, double error) {
        double slack = slack(wx, wz, error);
        return wx * leftZ - wz * leftX > slack
                && rightX * wz - rightZ * wx > slack
                && wx * (leftX + rightX) + wz * (leftZ + rightZ) > 2 * slack;
    }

    /** Whether a disc certainly lies beyond the line of one edge. */
    boolean isSurelyBeyond(double wx, double wz, double r) {
        double slack = slack(wx, wz, r * 0x1p-50) + r * Math.sqrt(leftX * leftX + leftZ * leftZ);
        if (wx * leftZ - wz * leftX < -slack) {
            return true;
        }
        slack = slack(wx, wz, r * 0x1p-50) + r * Math.sqrt(rightX * rightX + rightZ * rightZ);
        return rightX * wz - rightZ * wx < -slack;
    }

    /** Whether all corners certainly lie beyond one edge, or behind the apex. */
    boolean isSurelyBeyond(PlanarShape q) {
        boolean left = true;
        boolean right = true;
        boolean behind = true;
        for (int k = 0; k < q.count; k++) {
            double x = q.x[k];
            double z = q.z[k];
            double slack = slack(x, z, q.error);
            left &= x * leftZ - z * leftX < -slack;
            right &= rightX * z - rightZ * x < -slack;
            behind &= x * (leftX + rightX) + z * (leftZ + rightZ) < -2 * slack;
        }
        return left || right || behind;
    }

    // The error of the product of an edge and a point that is off by the given error in both coordinates.
    private double slack(double wx, double wz, double error) {
        return doubt * (Math.abs(wx) + Math.abs(wz)) + 4 * most * error;
    }
}
