package robosim.geometry.index.hierarchy;

/** A plane that nothing of a beam is beyond, in floats: told by the corner of a node's bounds that is least along its normal. */
final class BoundsPlane {
    private float x;
    private float y;
    private float z;
    private float at;
    private int fromX;
    private int fromY;
    private int fromZ;

    /** Takes the plane's outward normal, a point of it, and how much farther out it is to be. */
    void set(double nx, double ny, double nz, double ox, double oy, double oz, double pad) {
        x = (float) nx;
        y = (float) ny;
        z = (float) nz;
        at = (float) (-(nx * ox + ny * oy + nz * oz) - pad);
        fromX = x > 0 ? 0 : 3;
        fromY = y > 0 ? 1 : 4;
        fromZ = z > 0 ? 2 : 5;
    }

    /** The bits of how far bounds are beyond the plane, roughly; those of a negative number are below 0. */
    int beyond(float[] n, int k) {
        return Float.floatToRawIntBits(Math.fma(
                n[k + fromX], x, Math.fma(n[k + fromY], y, Math.fma(n[k + fromZ], z, at))));
    }
}
