package robosim.geometry.narrow.normal;

import robosim.geometry.exact.VectorMath;

/** The face of a leaf that a point belongs to. Faces are offered in turn, each with the point's height above it. */
final class NearestFace {
    /** Below this, the rest of a unit normal that points straight ahead is rounding error. */
    private static final double BACK = 0x1p-40;

    double px;
    double py;
    double pz;
    double ux;
    double uy;
    double uz;
    private double facingHeight;
    private double facingX;
    private double facingY;
    private double facingZ;
    private double height;
    private double x;
    private double y;
    private double z;

    void reset(double px, double py, double pz, double ux, double uy, double uz) {
        this.px = px;
        this.py = py;
        this.pz = pz;
        this.ux = ux;
        this.uy = uy;
        this.uz = uz;
        facingHeight = Double.NEGATIVE_INFINITY;
        height = Double.NEGATIVE_INFINITY;
    }

    /** Offers both sides of a slab of width {@code 2 half}: the point is {@code offset / |n|} from its middle plane. */
    void offerSlab(double offset, double half, double nx, double ny, double nz) {
        double length = VectorMath.length(nx, ny, nz);
        if (length > 0) {
            offer((offset - half) / length, nx / length, ny / length, nz / length);
            offer((-offset - half) / length, -nx / length, -ny / length, -nz / length);
        }
    }

    /** Offers a face or a round side: the height of the point above it and the outward unit normal there. */
    void offer(double above, double nx, double ny, double nz) {
        if (nx * ux + ny * uy + nz * uz < 0 && above > facingHeight) {
            facingHeight = above;
            facingX = nx;
            facingY = ny;
            facingZ = nz;
        }
        if (above > height) {
            height = above;
            x = nx;
            y = ny;
            z = nz;
        }
    }

    /**
     * Writes the normal of the face at or above which the point lies; a point below the limit is inside.
     *
     * @param outside whether the ray came from outside, so that the normal must not point ahead
     */
    void answer(double limit, boolean outside, double[] normal) {
        if (facingHeight >= limit) {
            write(facingX, facingY, facingZ, normal);
        } else if (height >= limit && !(outside && leanBack())) {
            write(x, y, z, normal);
        } else {
            double length = VectorMath.length(ux, uy, uz);
            write(-ux / length, -uy / length, -uz / length, normal);
        }
    }

    /** Removes the part of the normal that points ahead; answers whether nothing is left. */
    private boolean leanBack() {
        double ahead = x * ux + y * uy + z * uz;
        if (!(ahead > 0)) {
            return false;
        }
        double share = ahead / (ux * ux + uy * uy + uz * uz);
        x -= share * ux;
        y -= share * uy;
        z -= share * uz;
        double length = VectorMath.length(x, y, z);
        x /= length;
        y /= length;
        z /= length;
        return !(length > BACK);
    }

    private static void write(double x, double y, double z, double[] normal) {
        normal[0] = x + 0.0; // turns -0.0 into +0.0
        normal[1] = y + 0.0;
        normal[2] = z + 0.0;
    }
}
