package robosim.geometry.narrow.gjk;

import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;

/**
 * The support function of one leaf: its point furthest in a direction.
 *
 * <p>A leaf is loaded once, relative to an origin and multiplied by a scale, and then asked for many directions. Loaded
 * {@linkplain #spatial in space} it is itself; loaded {@linkplain #planar in the plane} it is its projection on XZ,
 * with y = 0 throughout, and must be asked for directions with y = 0 only. Spheres, and upright cylinders and
 * capsules in the plane, are loaded as their centre with a {@link #margin} around it, other capsules as their segment with one.
 *
 * <p>The error of coordinates found is at most 8u (u = 2^-53) of {@link #extent}, a prism's 11u. The point found may be
 * short of the furthest by about as much; {@link Gjk#ROUNDOFF} covers both.
 */
public final class Support {
    private static final int POINTS = 0;
    private static final int PARALLELEPIPED = 1;
    private static final int ROUND = 2;

    private static final int MOST_POINTS = 16;

    /**
     * A direction with at most this sine counts as along the axis: below it squares underflow, and a point of the rim
     * would be found at another radius. The cap's centre is short of the rim by less than this fraction of the radius.
     */
    private static final double STRAIGHT = 0x1p-500;

    /** The sine below which a direction may lead to a cap. */
    private static final double NEARLY_STRAIGHT = 0.3;

    /** The sine below which a direction is along the axis to within rounding. */
    private static final double ALONG = 0x1p-48;

    /** The point found by {@link #find}. */
    public double x;

    public double y;
    public double z;

    /** Which of the leaf's corners the point found belongs to; of a cylinder, which cap. */
    int corner;

    /** From there to the point found on a cylinder's rim, else 0. */
    double rimX;

    double rimY;
    double rimZ;

    /** Along the rim where the point found is; 0 for features without a rim. */
    double tangentX;

    double tangentY;
    double tangentZ;

    private double across;
    private double outward;

    /** A point of the leaf: its centre if it has one. */
    double centreX;

    double centreY;
    double centreZ;

    /** Radius around all points found that belongs to the leaf too; 0 for all but spheres, capsules and discs. */
    public double margin;

    /** An upper bound of the sum of the magnitudes of the terms of any coordinate found, margin included. */
    public double extent;

    private int form;
    private int count;
    private final double[] px = new double[MOST_POINTS];
    private final double[] py = new double[MOST_POINTS];
    private final double[] pz = new double[MOST_POINTS];

    // A parallelepiped's half vectors; for a cylinder the first is its axis from the centre to a cap.
    private double ux;
    private double uy;
    private double uz;
    private double vx;
    private double vy;
    private double vz;
    private double wx;
    private double wy;
    private double wz;

    // A cylinder's unit axis, its radius, and 0 if heights are ignored, else 1.
    double axisX;
    double axisY;
    double axisZ;
    private double radius;
    private double heights;

    /** The x of a leaf's reference point, the origin for both leaves: its centre, or a triangle's first corner. */
    public static double originX(LeafKind kind, double[] row, int at) {
        return switch (kind.layout()) {
            case CENTRE, CORNERS -> row[at];
            case RANGES -> 0.5 * row[at] + 0.5 * row[at + 1];
        };
    }

    /** The y of that point. */
    public static double originY(LeafKind kind, double[] row, int at) {
        return switch (kind.layout()) {
            case CENTRE, CORNERS -> row[at + 1];
            case RANGES -> 0.5 * row[at + 8] + 0.5 * row[at + 9];
        };
    }

    /** The z of that point. */
    public static double originZ(LeafKind kind, double[] row, int at) {
        return switch (kind.layout()) {
            case CENTRE, CORNERS -> row[at + 2];
            case RANGES -> 0.5 * row[at + 2] + 0.5 * row[at + 3];
        };
    }

    /** Loads a leaf relative to an origin, multiplied by a scale (a power of two). */
    public void spatial(LeafKind kind, double[] row, int at, double ox, double oy, double oz, double scale) {
        load(kind, row, at, ox, oy, oz, scale, 1);
    }

    /** Loads a leaf's projection on XZ relative to an origin, multiplied by a scale (a power of two). */
    public void planar(LeafKind kind, double[] row, int at, double ox, double oz, double scale) {
        load(kind, row, at, ox, 0, oz, scale, 0);
    }

    private void load(
            LeafKind kind, double[] row, int at, double ox, double oy, double oz, double scale, double heightsCounted) {
        heights = heightsCounted;
        margin = 0;
        count = 0;
        rimX = 0;
        rimY = 0;
        rimZ = 0;
        tangentX = 0;
        tangentY = 0;
        tangentZ = 0;
        across = 1;
        outward = 0;
        switch (kind) {
            case UPRIGHT_BOX, BOX -> {
                centre(row, at, ox, oy, oz, scale);
                box(row, at, scale);
            }
            case UPRIGHT_CYLINDER -> {
                centre(row, at, ox, oy, oz, scale);
                uprightCylinder(row, at, scale);
            }
            case CYLINDER -> {
                centre(row, at, ox, oy, oz, scale);
                cylinder(row, at, row[at + 7], row[at + 10], row[at + 13], scale);
            }
            case UPRIGHT_CAPSULE -> {
                centre(row, at, ox, oy, oz, scale);
                capsule(row, at, 0, 1, 0, scale);
            }
            case CAPSULE -> {
                centre(row, at, ox, oy, oz, scale);
                capsule(row, at, row[at + 7], row[at + 10], row[at + 13], scale);
            }
            case SPHERE -> {
                centre(row, at, ox, oy, oz, scale);
                ball(row[at + Leaf.SIZE] * scale);
            }
            case TRIANGLE -> {
                form = POINTS;
                for (int k = at; k < at + 9; k += 3) {
                    point((row[k] - ox) * scale, heights * (row[k + 1] - oy) * scale, (row[k + 2] - oz) * scale);
                }
                surround();
            }
            case PRISM -> {
                form = POINTS;
                prism(row, at, ox, oy, oz, scale);
                surround();
                extent *= 2; // its corners have larger errors
            }
            case MESH, SOLID_MESH, GRID -> throw kind.refused();
        }
    }

    private void centre(double[] row, int at, double ox, double oy, double oz, double scale) {
        centreX = (row[at] - ox) * scale;
        centreY = heights * (row[at + 1] - oy) * scale;
        centreZ = (row[at + 2] - oz) * scale;
    }

    /** Finds the point furthest in a direction of any length except zero. */
    public void find(double dx, double dy, double dz) {
        switch (form) {
            case PARALLELEPIPED -> {
                double s = dx * ux + dy * uy + dz * uz < 0 ? -1 : 1;
                double t = dx * vx + dy * vy + dz * vz < 0 ? -1 : 1;
                double q = dx * wx + dy * wy + dz * wz < 0 ? -1 : 1;
                corner = (s < 0 ? 1 : 0) | (t < 0 ? 2 : 0) | (q < 0 ? 4 : 0);
                x = centreX + (s * ux + t * vx + q * wx);
                y = centreY + (s * uy + t * vy + q * wy);
                z = centreZ + (s * uz + t * vz + q * wz);
            }
            case ROUND -> findRound(dx, dy, dz);
            default -> {
                int best = 0;
                double furthest = dx * px[0] + dy * py[0] + dz * pz[0];
                for (int k = 1; k < count; k++) {
                    double reach = dx * px[k] + dy * py[k] + dz * pz[k];
                    if (reach > furthest) {
                        furthest = reach;
                        best = k;
                    }
                }
                corner = best;
                x = px[best];
                y = py[best];
                z = pz[best];
            }
        }
    }

    private void findRound(double dx, double dy, double dz) {
        double along = dx * axisX + dy * axisY + dz * axisZ;
        double s = along < 0 ? -1 : 1;
        // axis x (d x axis) is perpendicular to the axis even if d is along it and all of this is rounding error.
        double qx = dy * axisZ - dz * axisY;
        double qy = dz * axisX - dx * axisZ;
        double qz = dx * axisY - dy * axisX;
        double rx = axisY * qz - axisZ * qy;
        double ry = axisZ * qx - axisX * qz;
        double rz = axisX * qy - axisY * qx;
        double length = Math.sqrt(rx * rx + ry * ry + rz * rz);
        double reach = length > STRAIGHT ? radius / length : 0;
        corner = along < 0 ? 1 : 0;
        rimX = reach * rx;
        rimY = heights * reach * ry;
        rimZ = reach * rz;
        tangentX = qx;
        tangentY = heights * qy;
        tangentZ = qz;
        across = length;
        outward = reach;
        x = centreX + (s * ux + reach * rx);
        y = centreY + heights * (s * uy + reach * ry);
        z = centreZ + (s * uz + reach * rz);
    }

    /** A coordinate of a corner, without the rim about it. */
    double corner(int k, int axis) {
        double s = (k & 1) == 0 ? 1 : -1;
        if (form == POINTS) {
            return axis == 0 ? px[k] : axis == 1 ? py[k] : pz[k];
        }
        double t = form == ROUND ? 0 : (k & 2) == 0 ? 1 : -1;
        double q = form == ROUND ? 0 : (k & 4) == 0 ? 1 : -1;
        return switch (axis) {
            case 0 -> centreX + (s * ux + t * vx + q * wx);
            case 1 -> centreY + heights * (s * uy + t * vy + q * wy);
            default -> centreZ + (s * uz + t * vz + q * wz);
        };
    }

    /**
     * Whether a point is inside a box or a cylinder by more than a distance, which is to cover the rounding of half vectors, of
     * normals and of products with them, 16u of {@link #extent}.
     */
    boolean holds(double qx, double qy, double qz, double by) {
        double ox = qx - centreX;
        double oy = qy - centreY;
        double oz = qz - centreZ;
        if (form == ROUND) {
            double along = ox * axisX + oy * axisY + oz * axisZ;
            double cx = oy * axisZ - oz * axisY;
            double cy = oz * axisX - ox * axisZ;
            double cz = ox * axisY - oy * axisX;
            return Math.abs(along) + by < ux * axisX + uy * axisY + uz * axisZ
                    && Math.sqrt(cx * cx + cy * cy + cz * cz) + by < radius;
        }
        return form == PARALLELEPIPED
                && inward(0, ox, oy, oz) > by
                && inward(1, ox, oy, oz) > by
                && inward(2, ox, oy, oz) > by;
    }

    /** How far a vector from the centre ends inside the two sides of a parallelepiped across a half vector. */
    private double inward(int k, double ox, double oy, double oz) {
        double px = k == 0 ? vx : k == 1 ? wx : ux;
        double py = k == 0 ? vy : k == 1 ? wy : uy;
        double pz = k == 0 ? vz : k == 1 ? wz : uz;
        double qx = k == 0 ? wx : k == 1 ? ux : vx;
        double qy = k == 0 ? wy : k == 1 ? uy : vy;
        double qz = k == 0 ? wz : k == 1 ? uz : vz;
        double nx = py * qz - pz * qy;
        double ny = pz * qx - px * qz;
        double nz = px * qy - py * qx;
        double half = k == 0
                ? nx * ux + ny * uy + nz * uz
                : k == 1 ? nx * vx + ny * vy + nz * vz : nx * wx + ny * wy + nz * wz;
        double reach = Math.abs(half) - Math.abs(nx * ox + ny * oy + nz * oz);
        return reach / Math.sqrt(nx * nx + ny * ny + nz * nz);
    }

    /** Whether the direction in which the point was found is nearly along the axis of a cylinder in space, but not quite. */
    boolean isNearCap() {
        return form == ROUND && heights > 0 && across < NEARLY_STRAIGHT && across > 0;
    }

    /** Whether it is along the axis, so that all of a cap is as far. */
    boolean isAtCap() {
        return form == ROUND && heights > 0 && across < ALONG;
    }

    /** The number of ends of a point or a segment with a margin, else 0. */
    int ends() {
        return form == POINTS && count < 3 ? count : 0;
    }

    /** Whether it is a box in space. */
    boolean isBox() {
        return form == PARALLELEPIPED && heights > 0;
    }

    /** Finds a box's point nearest to a point, to within rounding. */
    void approach(double qx, double qy, double qz) {
        double ox = qx - centreX;
        double oy = qy - centreY;
        double oz = qz - centreZ;
        double s = part(ox * ux + oy * uy + oz * uz, ux * ux + uy * uy + uz * uz);
        double t = part(ox * vx + oy * vy + oz * vz, vx * vx + vy * vy + vz * vz);
        double q = part(ox * wx + oy * wy + oz * wz, wx * wx + wy * wy + wz * wz);
        x = centreX + (s * ux + t * vx + q * wx);
        y = centreY + (s * uy + t * vy + q * wy);
        z = centreZ + (s * uz + t * vz + q * wz);
    }

    private static double part(double along, double square) {
        return square > 0 ? Math.max(-1, Math.min(1, along / square)) : 0;
    }

    /** Whether it is loaded in the plane. */
    boolean isFlat() {
        return heights == 0;
    }

    /** Whether a vector from a cap's centre ends above the cap. */
    boolean isOnCap(double ox, double oy, double oz) {
        double cx = oy * axisZ - oz * axisY;
        double cy = oz * axisX - ox * axisZ;
        double cz = ox * axisY - oy * axisX;
        return cx * cx + cy * cy + cz * cz <= radius * radius;
    }

    /**
     * How fast the point found moves along the rim as a unit direction turns: by so much times the tangent times its product
     * with the turn.
     */
    double bend() {
        return outward / (across * across);
    }

    /** Whether the leaf has no curved part other than its margin, so that few points can be found. */
    boolean isPolytope() {
        return form != ROUND;
    }

    private void box(double[] row, int at, double scale) {
        form = PARALLELEPIPED;
        double p = row[at + 3] * scale;
        double q = row[at + 4] * scale;
        double r = row[at + 5] * scale;
        ux = p * row[at + 6];
        uy = heights * p * row[at + 9];
        uz = p * row[at + 12];
        vx = q * row[at + 7];
        vy = heights * q * row[at + 10];
        vz = q * row[at + 13];
        wx = r * row[at + 8];
        wy = heights * r * row[at + 11];
        wz = r * row[at + 14];
        extent = Math.max(
                Math.abs(centreX) + Math.abs(ux) + Math.abs(vx) + Math.abs(wx),
                Math.max(
                        Math.abs(centreY) + Math.abs(uy) + Math.abs(vy) + Math.abs(wy),
                        Math.abs(centreZ) + Math.abs(uz) + Math.abs(vz) + Math.abs(wz)));
    }

    private void cylinder(double[] row, int at, double ax, double ay, double az, double scale) {
        form = ROUND;
        radius = row[at + 3] * scale;
        double h = row[at + 4] * scale;
        ux = h * ax;
        uy = h * ay;
        uz = h * az;
        double length = Math.sqrt(ax * ax + ay * ay + az * az);
        axisX = ax / length;
        axisY = ay / length;
        axisZ = az / length;
        extent = radius
                + Math.max(
                        Math.abs(centreX) + Math.abs(ux),
                        Math.max(Math.abs(centreY) + Math.abs(uy), Math.abs(centreZ) + Math.abs(uz)));
    }

    private void uprightCylinder(double[] row, int at, double scale) {
        if (heights == 0) {
            ball(row[at + Leaf.SIZE] * scale);
        } else {
            cylinder(row, at, 0, 1, 0, scale);
        }
    }

    private void capsule(double[] row, int at, double ax, double ay, double az, double scale) {
        if (heights == 0 && ax == 0 && az == 0) {
            ball(row[at + Leaf.SIZE] * scale);
            return;
        }
        form = POINTS;
        double h = row[at + 4] * scale;
        double x0 = h * ax;
        double y0 = heights * h * ay;
        double z0 = h * az;
        point(centreX + x0, centreY + y0, centreZ + z0);
        point(centreX - x0, centreY - y0, centreZ - z0);
        margin = row[at + Leaf.SIZE] * scale;
        extent = margin
                + Math.max(
                        Math.abs(centreX) + Math.abs(x0),
                        Math.max(Math.abs(centreY) + Math.abs(y0), Math.abs(centreZ) + Math.abs(z0)));
    }

    private void ball(double r) {
        form = POINTS;
        point(centreX, centreY, centreZ);
        margin = r;
        extent = r + Math.max(Math.abs(centreX), Math.max(Math.abs(centreY), Math.abs(centreZ)));
    }

    private void point(double qx, double qy, double qz) {
        px[count] = qx;
        py[count] = qy;
        pz[count] = qz;
        count++;
    }

    /** Sets centre and extent from the points. */
    private void surround() {
        extent = 0;
        centreX = 0;
        centreY = 0;
        centreZ = 0;
        for (int k = 0; k < count; k++) {
            centreX += px[k] / count;
            centreY += py[k] / count;
            centreZ += pz[k] / count;
            extent = Math.max(extent, Math.max(Math.abs(px[k]), Math.max(Math.abs(py[k]), Math.abs(pz[k]))));
        }
    }

    /** The corners of the octagon at both heights, after each bound is tightened to what the others allow. */
    private void prism(double[] row, int at, double ox, double oy, double oz, double scale) {
        double x0 = row[at] - ox;
        double x1 = row[at + 1] - ox;
        double z0 = row[at + 2] - oz;
        double z1 = row[at + 3] - oz;
        double s0 = lessSum(row[at + 4], ox, oz);
        double s1 = lessSum(row[at + 5], ox, oz);
        double d0 = lessSum(row[at + 6], ox, -oz);
        double d1 = lessSum(row[at + 7], ox, -oz);
        double left = Math.max(x0, Math.max(0.5 * (s0 + d0), Math.max(s0 - z1, d0 + z0)));
        double right = Math.min(x1, Math.min(0.5 * (s1 + d1), Math.min(s1 - z0, d1 + z1)));
        double near = Math.max(z0, Math.max(0.5 * (s0 - d1), Math.max(s0 - x1, x0 - d1)));
        double far = Math.min(z1, Math.min(0.5 * (s1 - d0), Math.min(s1 - x0, x1 - d0)));
        s0 = Math.max(s0, left + near);
        s1 = Math.min(s1, right + far);
        d0 = Math.max(d0, left - far);
        d1 = Math.min(d1, right - near);
        for (int level = 8; level <= 9; level++) {
            double h = heights * (row[at + level] - oy) * scale;
            point(right * scale, h, (s1 - right) * scale);
            point((s1 - far) * scale, h, far * scale);
            point((d0 + far) * scale, h, far * scale);
            point(left * scale, h, (left - d0) * scale);
            point(left * scale, h, (s0 - left) * scale);
            point((s0 - near) * scale, h, near * scale);
            point((d1 + near) * scale, h, near * scale);
            point(right * scale, h, (right - d1) * scale);
        }
    }

    /** The number v - (p + q), with a rounding error relative to the result, not to the numbers that cancel. */
    private static double lessSum(double v, double p, double q) {
        double sum = p + q;
        double part = sum - p;
        double lost = (p - (sum - part)) + (q - part);
        return (v - sum) - lost;
    }
}
