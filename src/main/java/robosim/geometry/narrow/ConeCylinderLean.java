package robosim.geometry.narrow;

/** Planes that tell a cylinder from a cone beside whose apex it lies, partly behind. */
final class ConeCylinderLean {
    /** The share of a golden section, and how many of them; and the largest cotangent for which they are fine enough. */
    private static final double GOLDEN = 0.6180339887498949;

    private static final int SECTIONS = 40;
    private static final double LEAST_LEAN = 1024;

    private ConeCylinderFrame frame = new ConeCylinderFrame();
    private boolean isApart;

    /**
     * What lies partly behind the apex may be apart by no plane along the border, but by one that leans away from it:
     * with the normal n = (-1, y, z) in the frame of the cone, y and z in a disc with the cotangent of the half angle for
     * its radius. There k(n) is concave: its top is looked for by golden sections, and any place above 0 is proof.
     */
    boolean isApart(ConeCylinderFrame body) {
        frame = body;
        isApart = false;
        double reach = Math.min(frame.cone.cos / frame.cone.sin, LEAST_LEAN);
        double low = -reach;
        double high = reach;
        double left = high - GOLDEN * (high - low);
        double right = low + GOLDEN * (high - low);
        double atLeft = topAlong(left, reach);
        double atRight = topAlong(right, reach);
        for (int i = 0; i < SECTIONS && !isApart; i++) {
            if (atLeft >= atRight) {
                high = right;
                right = left;
                atRight = atLeft;
                left = high - GOLDEN * (high - low);
                atLeft = topAlong(left, reach);
            } else {
                low = left;
                left = right;
                atLeft = atRight;
                right = low + GOLDEN * (high - low);
                atRight = topAlong(right, reach);
            }
        }
        return isApart;
    }

    /** The greatest k(-1, y, z) over the z of the disc; apart where it is certainly above 0. */
    private double topAlong(double y, double reach) {
        double high = Math.sqrt(Math.max(0, (reach - y) * (reach + y)));
        double low = -high;
        double left = high - GOLDEN * (high - low);
        double right = low + GOLDEN * (high - low);
        double atLeft = behind(y, left);
        double atRight = behind(y, right);
        for (int i = 0; i < SECTIONS && !isApart; i++) {
            if (atLeft >= atRight) {
                high = right;
                right = left;
                atRight = atLeft;
                left = high - GOLDEN * (high - low);
                atLeft = behind(y, left);
            } else {
                low = left;
                left = right;
                atLeft = atRight;
                right = low + GOLDEN * (high - low);
                atRight = behind(y, right);
            }
        }
        return Math.max(atLeft, atRight);
    }

    private double behind(double y, double z) {
        double along = y * frame.ay + z * frame.az - frame.ax;
        double across = RayMath.length(y * frame.az - z * frame.ay, z * frame.ax + frame.az, -frame.ay - y * frame.ax);
        double least = y * frame.cy + z * frame.cz - frame.cx - frame.radius * across - frame.half * Math.abs(along);
        isApart |= least > ConeCylinder.BOUND_ERROR * frame.extent * (1 + Math.abs(y) + Math.abs(z));
        return least;
    }
}
