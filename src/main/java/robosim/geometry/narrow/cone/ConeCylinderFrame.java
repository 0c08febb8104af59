package robosim.geometry.narrow.cone;

import robosim.geometry.exact.DoubleDoubles;
import robosim.geometry.exact.VectorMath;

/**
 * A solid cylinder relative to a cone's apex, in the cylinder's own frame: along its axis, away from the axis's nearest
 * point, and perpendicular to both. The axis is oriented so that the centre is not behind, the third direction so that
 * the cone's axis is not: then the nearest point in the cone is on that side too.
 *
 * <p>Values that the distance may be small against are computed in pairs of doubles and rounded once, all else in
 * doubles.
 */
final class ConeCylinderFrame {
    /**
     * Indices of the unit axis, the centre relative to the apex, its part across the axis, its length, half the height.
     */
    static final int BODY = Cone.FREE;

    static final int CENTER = BODY + 3;
    static final int ACROSS = CENTER + 3;
    static final int AWAY = ACROSS + 3;
    static final int NEAR = AWAY + 1;
    static final int FAR = NEAR + 1;
    static final int HALF = FAR + 1;

    /** The first free pair of the cone. */
    static final int FREE = HALF + 1;

    private static final int TEMPORARY = FREE;
    private static final int MIDDLE = TEMPORARY + 2;

    Cone cone = new Cone();
    double radius;

    /** The largest offset from the apex plus the sizes. */
    double extent;

    /** More than the distance of every point of the cylinder from the apex. */
    double farthest;

    /** The heights of the cylinder's ends above the apex; the lower is negative if the apex is between them. */
    double near;

    double far;

    /** The distance from the cylinder's axis to the apex, and how far the apex is outside the mantle. */
    double away;

    double gap;

    // The three directions in world coordinates.
    private double ax;
    private double ay;
    private double az;
    private double px;
    private double py;
    private double pz;
    private double qx;
    private double qy;
    private double qz;

    /** The cone's axis: along the cylinder's, away from it, and perpendicular to both. */
    double ua;

    double up;
    double uq;

    /** The length of the cone's axis perpendicular to the cylinder's. */
    double across;

    void set(Cone cone, double[] b, int j, double axisX, double axisY, double axisZ) {
        this.cone = cone;
        DoubleDoubles p = cone.pairs;
        p.difference(CENTER, b[j], cone.ox);
        p.difference(CENTER + 1, b[j + 1], cone.oy);
        p.difference(CENTER + 2, b[j + 2], cone.oz);
        p.set(BODY, axisX);
        p.set(BODY + 1, axisY);
        p.set(BODY + 2, axisZ);
        p.set(HALF, b[j + 4]);
        if (!(axisX == 0 && axisZ == 0 && axisY == 1)) {
            p.dot(MIDDLE, BODY, BODY, TEMPORARY);
            p.root(MIDDLE, MIDDLE);
            p.multiply(HALF, HALF, MIDDLE);
            for (int k = 0; k < 3; k++) {
                p.divide(BODY + k, BODY + k, MIDDLE);
            }
        }
        p.dot(MIDDLE, CENTER, BODY, TEMPORARY);
        if (p.get(MIDDLE) < 0) {
            p.negate(MIDDLE);
            for (int k = 0; k < 3; k++) {
                p.negate(BODY + k);
            }
        }
        p.subtract(NEAR, MIDDLE, HALF);
        p.add(FAR, MIDDLE, HALF);
        near = p.get(NEAR);
        far = p.get(FAR);
        p.negate(MIDDLE);
        p.advance(ACROSS, CENTER, MIDDLE, BODY, TEMPORARY);
        p.dot(AWAY, ACROSS, ACROSS, TEMPORARY);
        p.root(AWAY, AWAY);
        radius = b[j + 3];
        away = p.get(AWAY);
        gap = away - radius + p.rest(AWAY);
        double mx = p.get(CENTER);
        double my = p.get(CENTER + 1);
        double mz = p.get(CENTER + 2);
        extent = VectorMath.largest(mx, my, mz) + radius + p.get(HALF);
        farthest = 2 * (Math.abs(mx) + Math.abs(my) + Math.abs(mz) + radius + p.get(HALF));
        ax = p.get(BODY);
        ay = p.get(BODY + 1);
        az = p.get(BODY + 2);
        turn(p);
    }

    private void turn(DoubleDoubles p) {
        if (away > 0x1p-90 * extent) {
            px = p.get(ACROSS) / away;
            py = p.get(ACROSS + 1) / away;
            pz = p.get(ACROSS + 2) / away;
        } else {
            // Any direction perpendicular to the axis, made from the world axis farthest from it.
            boolean isX = Math.abs(ax) < 0.6;
            boolean isY = !isX && Math.abs(ay) < 0.8;
            px = isX ? 1 : 0;
            py = isY ? 1 : 0;
            pz = isX || isY ? 0 : 1;
        }
        double askew = px * ax + py * ay + pz * az;
        px -= askew * ax;
        py -= askew * ay;
        pz -= askew * az;
        double size = VectorMath.length(px, py, pz);
        px /= size;
        py /= size;
        pz /= size;
        qx = ay * pz - az * py;
        qy = az * px - ax * pz;
        qz = ax * py - ay * px;
        ua = cone.ux * ax + cone.uy * ay + cone.uz * az;
        up = cone.ux * px + cone.uy * py + cone.uz * pz;
        uq = cone.ux * qx + cone.uy * qy + cone.uz * qz;
        if (uq < 0) {
            uq = -uq;
            qx = -qx;
            qy = -qy;
            qz = -qz;
        }
        across = VectorMath.length(0, up, uq);
    }

    /** Writes a vector of this frame, in world coordinates, into the cone's pairs. */
    void put(int vector, double along, double p, double q) {
        DoubleDoubles pairs = cone.pairs;
        pairs.set(vector, along * ax + p * px + q * qx);
        pairs.set(vector + 1, along * ay + p * py + q * qy);
        pairs.set(vector + 2, along * az + p * pz + q * qz);
    }

    /**
     * How far a point of this frame, relative to the apex, is outside the plane that touches the cone nearest to it.
     */
    double outside(double along, double p, double q) {
        double ahead = along * ua + p * up + q * uq;
        double aside = VectorMath.length(p * uq - q * up, q * ua - along * uq, along * up - p * ua);
        return cone.cos * aside - cone.sin * ahead;
    }
}
