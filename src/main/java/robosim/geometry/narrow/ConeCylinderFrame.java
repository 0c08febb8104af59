package robosim.geometry.narrow;

/** A solid cylinder as a cone's apex sees it, in a frame of which the cone's axis is the first. */
final class ConeCylinderFrame {
    Cone cone = new Cone();

    /** The largest offset from the apex and the sizes together. */
    double extent;

    double radius;
    double half;

    // The centre seen from the apex, and the unit axis, in the frame of the cone: its axis first.
    double cx;
    double cy;
    double cz;
    double ax;
    double ay;
    double az;

    // The other two axes of that frame in the world.
    double ex;
    double ey;
    double ez;
    double fx;
    double fy;
    double fz;

    /** About the distance of the nearest point of the whole cylinder, and whether the cone holds that point. */
    double nearest;

    boolean isNearestInside;

    void set(Cone cone, double[] b, int j, double axisX, double axisY, double axisZ) {
        this.cone = cone;
        double mx = b[j] - cone.ox;
        double my = b[j + 1] - cone.oy;
        double mz = b[j + 2] - cone.oz;
        double length = RayMath.length(axisX, axisY, axisZ);
        double px = axisX / length;
        double py = axisY / length;
        double pz = axisZ / length;
        radius = b[j + 3];
        half = b[j + 4] * length;
        // The differences are off by half an ulp of their own, however far from the origin the two are.
        extent = RayMath.largest(mx, my, mz) + radius + half;
        double middle = mx * px + my * py + mz * pz;
        double along = Math.max(-half, Math.min(half, -middle));
        double wx = middle * px - mx;
        double wy = middle * py - my;
        double wz = middle * pz - mz;
        double away = RayMath.length(wx, wy, wz);
        double inward = away > radius ? radius / away : 1;
        double nx = mx + along * px + inward * wx;
        double ny = my + along * py + inward * wy;
        double nz = mz + along * pz + inward * wz;
        nearest = RayMath.length(nx, ny, nz);
        isNearestInside = cone.depth(nx, ny, nz) >= 0;
        if (!isNearestInside) {
            turn(mx, my, mz, px, py, pz);
        }
    }

    // A frame with the cone's axis first and the centre in the half plane of the second.
    private void turn(double mx, double my, double mz, double px, double py, double pz) {
        cx = mx * cone.ux + my * cone.uy + mz * cone.uz;
        ex = mx - cx * cone.ux;
        ey = my - cx * cone.uy;
        ez = mz - cx * cone.uz;
        double size = RayMath.length(ex, ey, ez);
        if (!(size > 0x1p-40 * extent)) {
            // On the axis to speak of: any direction across it.
            boolean isX = Math.abs(cone.ux) < 0.7;
            ex = (isX ? 1 : 0) - (isX ? cone.ux : cone.uy) * cone.ux;
            ey = (isX ? 0 : 1) - (isX ? cone.ux : cone.uy) * cone.uy;
            ez = -(isX ? cone.ux : cone.uy) * cone.uz;
            size = RayMath.length(ex, ey, ez);
        }
        ex /= size;
        ey /= size;
        ez /= size;
        // Once more: what cancelled above has left it a little askew.
        double askew = ex * cone.ux + ey * cone.uy + ez * cone.uz;
        ex -= askew * cone.ux;
        ey -= askew * cone.uy;
        ez -= askew * cone.uz;
        size = RayMath.length(ex, ey, ez);
        ex /= size;
        ey /= size;
        ez /= size;
        fx = cone.uy * ez - cone.uz * ey;
        fy = cone.uz * ex - cone.ux * ez;
        fz = cone.ux * ey - cone.uy * ex;
        cy = mx * ex + my * ey + mz * ez;
        cz = mx * fx + my * fy + mz * fz;
        ax = px * cone.ux + py * cone.uy + pz * cone.uz;
        ay = px * ex + py * ey + pz * ez;
        az = px * fx + py * fy + pz * fz;
    }
}
