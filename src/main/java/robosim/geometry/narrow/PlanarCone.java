package robosim.geometry.narrow;

/** A sector of the XZ plane (the beam of a sonar) and the projection of a leaf. */
public final class PlanarCone {
    // Products with the two edges of the sector are off by six roundings of the magnitudes; who is closer to an edge
    // than that counts as within.
    private static final double FILTER = 8 * 0x1p-53;
    private static final double LEAST = 0x1p-200;
    private static final double MOST = 0x1p200;

    private PlanarCone() {}

    /**
     * Distance from (ox, oz) to the nearest point of the leaf's projection within the sector of the given half angle
     * about (ux, uz).
     *
     * <p>The shape and the sector are convex: it is the shape's nearest point if the sector holds that, and otherwise lies
     * on one of the two edges, where these first meet the shape.
     *
     * @param halfCos cosine of the half angle, which is in (0, 90) degrees
     * @param halfSin its sine
     * @return world units; 0 where the apex is inside or on it, {@code +Infinity} where nothing is within
     */
    public static double distance(
            double ox,
            double oz,
            double ux,
            double uz,
            double halfCos,
            double halfSin,
            int kind,
            double[] b,
            int j,
            Scratch s) {
        double size = Math.max(Math.abs(ux), Math.abs(uz));
        if (!(size >= LEAST && size <= MOST)) {
            int shift = -Math.getExponent(size);
            ux = Math.scalb(Math.scalb(ux, shift / 2), shift - shift / 2);
            uz = Math.scalb(Math.scalb(uz, shift / 2), shift - shift / 2);
        }
        double leftX = ux * halfCos - uz * halfSin;
        double leftZ = ux * halfSin + uz * halfCos;
        double rightX = ux * halfCos + uz * halfSin;
        double rightZ = uz * halfCos - ux * halfSin;
        return switch (kind) {
            case Leaf.UPRIGHT_CYLINDER, Leaf.SPHERE ->
                disc(ox, oz, leftX, leftZ, rightX, rightZ, b[j], b[j + 2], b[j + Leaf.SIZE]);
            case Leaf.CYLINDER -> oval(ox, oz, leftX, leftZ, rightX, rightZ, b, j, s);
            default -> polygon(ox, oz, leftX, leftZ, rightX, rightZ, kind, b, j, s);
        };
    }

    /** Whether a point, seen from the apex, lies within the closed sector. */
    private static boolean holds(double leftX, double leftZ, double rightX, double rightZ, double wx, double wz) {
        double slack = FILTER
                * (Math.abs(leftX) + Math.abs(leftZ) + Math.abs(rightX) + Math.abs(rightZ))
                * (Math.abs(wx) + Math.abs(wz));
        return wx * leftZ - wz * leftX >= -slack
                && rightX * wz - rightZ * wx >= -slack
                // not behind: with a narrow sector both products are small there too
                && wx * (leftX + rightX) + wz * (leftZ + rightZ) >= 0;
    }

    private static double disc(
            double ox,
            double oz,
            double leftX,
            double leftZ,
            double rightX,
            double rightZ,
            double cx,
            double cz,
            double r) {
        double mx = cx - ox;
        double mz = cz - oz;
        if (holds(leftX, leftZ, rightX, rightZ, mx, mz)) {
            return DiscDisc.distance(ox, oz, 0, cx, cz, r);
        }
        return Math.min(
                RayDisc.distance(ox, oz, leftX, leftZ, cx, cz, r), RayDisc.distance(ox, oz, rightX, rightZ, cx, cz, r));
    }

    private static double polygon(
            double ox,
            double oz,
            double leftX,
            double leftZ,
            double rightX,
            double rightZ,
            int kind,
            double[] b,
            int j,
            Scratch s) {
        PlanarShape q = s.planarB;
        q.set(kind, b, j, ox, oz);
        if (nearest(q)) {
            return 0;
        }
        if (holds(leftX, leftZ, rightX, rightZ, q.pointX, q.pointZ)) {
            return Math.sqrt(q.pointX * q.pointX + q.pointZ * q.pointZ);
        }
        // On an edge of the sector; a corner there may be all that it meets.
        double best = Double.POSITIVE_INFINITY;
        for (int k = 0; k < q.count; k++) {
            if (holds(leftX, leftZ, rightX, rightZ, q.x[k], q.z[k])) {
                best = Math.min(best, Math.sqrt(q.x[k] * q.x[k] + q.z[k] * q.z[k]));
            }
        }
        // The rays' distances come from the row itself, and write over q.
        double left = PlanarRay.scaled(ox, oz, leftX, leftZ, kind, b, j, s);
        double right = PlanarRay.scaled(ox, oz, rightX, rightZ, kind, b, j, s);
        return Math.min(best, Math.min(left, right));
    }

    // The point nearest to the apex is left in q's point; true where the apex is inside.
    private static boolean nearest(PlanarShape q) {
        q.pointX = q.x[0];
        q.pointZ = q.z[0];
        double least = q.pointX * q.pointX + q.pointZ * q.pointZ;
        // A blurred side does not tell, so what only such sides bound is judged by the bounds as well.
        boolean inside = q.count > 2 && !PointPolygon.isBeyond(0, 0, q, q.error);
        int last = q.count - 1;
        for (int k = 0; k <= last; k++) {
            int previous = k == 0 ? last : k - 1;
            double ax = q.x[previous];
            double az = q.z[previous];
            double bx = q.x[k];
            double bz = q.z[k];
            double square = bx * bx + bz * bz;
            if (square < least) {
                least = square;
                q.pointX = bx;
                q.pointZ = bz;
            }
            double ex = bx - ax;
            double ez = bz - az;
            double across = ax * bz - az * bx;
            inside &= across >= 0 || q.isBlurred(ex, ez);
            double along = -(ex * ax + ez * az);
            double length = ex * ex + ez * ez;
            // The foot of the apex on the side's line, where that is on the side.
            if (along > 0 && along < length) {
                double turn = across / length;
                if (across * turn < least) {
                    least = across * turn;
                    q.pointX = ez * turn;
                    q.pointZ = -ex * turn;
                }
            }
        }
        return inside;
    }

    private static double oval(
            double ox,
            double oz,
            double leftX,
            double leftZ,
            double rightX,
            double rightZ,
            double[] b,
            int j,
            Scratch s) {
        PlanarShape apex = s.planarA;
        PlanarShape q = s.planarB;
        apex.point();
        q.set(Leaf.CYLINDER, b, j, ox, oz);
        PlanarBracket bracket = s.planarBracket;
        bracket.find(apex, q, false);
        if (!bracket.isApart()) {
            return 0;
        }
        // Seen from the apex, the nearest point lies along the best normal.
        if (holds(leftX, leftZ, rightX, rightZ, bracket.normalX, bracket.normalZ)) {
            return bracket.distance();
        }
        return Math.min(
                RayOval.distance(ox, oz, leftX, leftZ, b, j, q), RayOval.distance(ox, oz, rightX, rightZ, b, j, q));
    }
}
