package robosim.geometry.dynamics.spatial;

import robosim.geometry.narrow.gjk.Gjk;
import robosim.geometry.narrow.gjk.Support;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;

/**
 * How a convex piece of a body is near one of something else: the direction in which they are apart, by how much, and the
 * points at which they touch. The direction is that of the algorithm of Gilbert, Johnson and Keerthi (1988), made that of a
 * face where it is one but for rounding.
 */
final class ContactGeometry {
    /** A direction that is off by less than so many radians is that of the face. */
    private static final double ALONG = 1e-5;

    /** A direction separates two pieces as well as another one if it does so by this share of the distance. */
    private static final double AS_WELL = 0.9;

    /** Edges are parallel where the sine of their angle is below this. */
    private static final double PARALLEL = 1e-3;

    private final Gjk gjk = new Gjk();
    private final Leaf first = new Leaf();
    private final Leaf second = new Leaf();
    private final Support own = new Support();
    private final Support others = new Support();
    private final Feature mine = new Feature();
    private final Feature theirs = new Feature();
    private final double[] origin = new double[3];
    private final double[] frame = new double[9];

    double nx;
    double ny;
    double nz;

    /** How far they are apart, at least and at most. */
    double apart;

    double most;

    // A point midway between them where they are nearest.
    private double pointX;
    private double pointY;
    private double pointZ;

    /** Measures two pieces; false where they touch. */
    boolean measure(LeafKind kind, double[] row, int at, LeafKind otherKind, double[] other, int otherAt) {
        first.set(kind, row, at);
        second.set(otherKind, other, otherAt);
        if (otherKind.isBox() && isBesideFace(kind, row, at, otherKind, other, otherAt)) {
            return true;
        }
        apart = gjk.spatial(first, second);
        if (!(apart > 0) && !gjk.isClosed()) {
            apart = gjk.close();
        }
        if (!(apart > 0)) {
            return false;
        }
        most = gjk.upper() + gjk.error();
        nx = gjk.nx();
        ny = gjk.ny();
        nz = gjk.nz();
        pointX = 0.5 * (gjk.ax() + gjk.bx());
        pointY = 0.5 * (gjk.ay() + gjk.by());
        pointZ = 0.5 * (gjk.az() + gjk.bz());
        chooseFace(kind, row, at, otherKind, other, otherAt);
        return true;
    }

    /**
     * Makes the direction that of a face, if it is one but for rounding and separates the two as well. Of a body that tips over
     * an edge that is its own face: what overhangs is below the other one.
     */
    private void chooseFace(LeafKind kind, double[] row, int at, LeafKind otherKind, double[] other, int otherAt) {
        double x = nx;
        double y = ny;
        double z = nz;
        for (int which = 0; which < 2; which++) {
            if (which == 0 ? takeFace(otherKind, other, otherAt) : takeFace(kind, row, at)) {
                if (along(kind, row, at, otherKind, other, otherAt, nx, ny, nz) > AS_WELL * apart) {
                    return;
                }
                nx = x;
                ny = y;
                nz = z;
            }
        }
    }

    /** Whether the foremost point of a piece is above a face of a box: the direction is that of the face. */
    private boolean isBesideFace(LeafKind kind, double[] row, int at, LeafKind otherKind, double[] other, int otherAt) {
        double x = Support.originX(kind, row, at) - other[otherAt];
        double y = Support.originY(kind, row, at) - other[otherAt + 1];
        double z = Support.originZ(kind, row, at) - other[otherAt + 2];
        int face = 0;
        double farthest = Double.NEGATIVE_INFINITY;
        boolean isBelow = false;
        for (int axis = 0; axis < 3; axis++) {
            int r = otherAt + Leaf.ROTATION + axis;
            double along = other[r] * x + other[r + 3] * y + other[r + 6] * z;
            double beyond = Math.abs(along) - other[otherAt + Leaf.SIZE + axis];
            if (beyond > farthest) {
                farthest = beyond;
                face = axis;
                isBelow = along < 0;
            }
        }
        int r = otherAt + Leaf.ROTATION + face;
        double dx = isBelow ? -other[r] : other[r];
        double dy = isBelow ? -other[r + 3] : other[r + 3];
        double dz = isBelow ? -other[r + 6] : other[r + 6];
        double gap = along(kind, row, at, otherKind, other, otherAt, dx, dy, dz);
        if (!(gap > 0)) {
            return false;
        }
        for (int axis = 0; axis < 3; axis++) {
            int a = otherAt + Leaf.ROTATION + axis;
            double along = other[a] * own.x + other[a + 3] * own.y + other[a + 6] * own.z;
            if (axis != face && Math.abs(along) > other[otherAt + Leaf.SIZE + axis]) {
                return false;
            }
        }
        apart = gap;
        most = gap + 2 * Gjk.ROUNDOFF * (own.extent + others.extent);
        nx = dx;
        ny = dy;
        nz = dz;
        double back = own.margin + 0.5 * gap;
        pointX = other[otherAt] + own.x - back * dx;
        pointY = other[otherAt + 1] + own.y - back * dy;
        pointZ = other[otherAt + 2] + own.z - back * dz;
        return true;
    }

    /** A lower bound of how far two pieces are apart along a unit direction towards the first. */
    double along(
            LeafKind kind,
            double[] row,
            int at,
            LeafKind otherKind,
            double[] other,
            int otherAt,
            double dx,
            double dy,
            double dz) {
        double ox = Support.originX(otherKind, other, otherAt);
        double oy = Support.originY(otherKind, other, otherAt);
        double oz = Support.originZ(otherKind, other, otherAt);
        own.spatial(kind, row, at, ox, oy, oz, 1);
        others.spatial(otherKind, other, otherAt, ox, oy, oz, 1);
        own.find(-dx, -dy, -dz);
        others.find(dx, dy, dz);
        double gap = dx * (own.x - others.x) + dy * (own.y - others.y) + dz * (own.z - others.z);
        double size = Math.sqrt(dx * dx + dy * dy + dz * dz);
        return gap / size - own.margin - others.margin - Gjk.ROUNDOFF * (own.extent + others.extent);
    }

    /** How far a piece rises above a plane through a point, along its unit normal. */
    double height(LeafKind kind, double[] row, int at, double[] point, double[] normal, int of) {
        others.spatial(kind, row, at, point[of], point[of + 1], point[of + 2], 1);
        others.find(normal[of], normal[of + 1], normal[of + 2]);
        return others.x * normal[of] + others.y * normal[of + 1] + others.z * normal[of + 2] + others.margin;
    }

    /** Adds the points at which two pieces touch that were measured last, or are nearer than a reach. */
    void points(int body, int otherBody, int object, double within, Contacts out) {
        origin[0] = pointX;
        origin[1] = pointY;
        origin[2] = pointZ;
        makeFrame();
        mine.find(first.kind, first.row, first.at, origin, frame, -1, within);
        theirs.find(second.kind, second.row, second.at, origin, frame, 1, within);
        int m = mine.count;
        int k = theirs.count;
        if (m > 1 && k > 2) {
            mine.clip(theirs, 1e-9);
            add(mine, theirs, 1, body, otherBody, object, within, out);
        } else if (m > 2 && k == 2) {
            theirs.clip(mine, 1e-9);
            add(theirs, mine, -1, body, otherBody, object, within, out);
        } else if (m == 2 && k == 2 && isParallel()) {
            mine.clipAlong(theirs, 1e-9);
            add(mine, theirs, 1, body, otherBody, object, within, out);
        } else {
            mine.count = 0;
            add(mine, theirs, 1, body, otherBody, object, within, out);
        }
    }

    private boolean isParallel() {
        double as = mine.s[1] - mine.s[0];
        double at = mine.t[1] - mine.t[0];
        double bs = theirs.s[1] - theirs.s[0];
        double bt = theirs.t[1] - theirs.t[0];
        double lengths = Math.sqrt((as * as + at * at) * (bs * bs + bt * bt));
        return lengths > 0 && Math.abs(as * bt - at * bs) < PARALLEL * lengths;
    }

    private void add(
            Feature of, Feature beside, int sign, int body, int otherBody, int object, double within, Contacts out) {
        boolean any = false;
        for (int k = 0; k < of.count; k++) {
            double high = beside.heightAt(of.s[k], of.t[k]);
            double gap = sign * (of.height[k] - high);
            if (gap <= within) {
                any = true;
                double middle = 0.5 * (of.height[k] + high);
                out.add(
                        body,
                        otherBody,
                        object,
                        origin[0] + of.s[k] * frame[0] + of.t[k] * frame[3] + middle * nx,
                        origin[1] + of.s[k] * frame[1] + of.t[k] * frame[4] + middle * ny,
                        origin[2] + of.s[k] * frame[2] + of.t[k] * frame[5] + middle * nz,
                        nx,
                        ny,
                        nz,
                        gap);
            }
        }
        if (!any) {
            out.add(body, otherBody, object, pointX, pointY, pointZ, nx, ny, nz, apart);
        }
    }

    /** Makes the direction that of a face of a piece, if it is one but for rounding. */
    private boolean takeFace(LeafKind kind, double[] row, int at) {
        int r = at + Leaf.ROTATION;
        return switch (kind) {
            case UPRIGHT_BOX, BOX ->
                takeAxis(row[r], row[r + 3], row[r + 6])
                        || takeAxis(row[r + 1], row[r + 4], row[r + 7])
                        || takeAxis(row[r + 2], row[r + 5], row[r + 8]);
            case UPRIGHT_CYLINDER -> takeAxis(0, 1, 0);
            case CYLINDER -> takeAxis(row[r + 1], row[r + 4], row[r + 7]);
            case TRIANGLE -> {
                double ax = row[at + 3] - row[at];
                double ay = row[at + 4] - row[at + 1];
                double az = row[at + 5] - row[at + 2];
                double bx = row[at + 6] - row[at];
                double by = row[at + 7] - row[at + 1];
                double bz = row[at + 8] - row[at + 2];
                yield takeAxis(ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx);
            }
            case SPHERE, UPRIGHT_CAPSULE, CAPSULE -> false;
            case PRISM, MESH, SOLID_MESH, GRID -> throw kind.refused();
        };
    }

    private boolean takeAxis(double ax, double ay, double az) {
        double size = Math.sqrt(ax * ax + ay * ay + az * az);
        double along = ax * nx + ay * ny + az * nz;
        double cx = ay * nz - az * ny;
        double cy = az * nx - ax * nz;
        double cz = ax * ny - ay * nx;
        if (!(size > 0) || !(Math.sqrt(cx * cx + cy * cy + cz * cz) < ALONG * size)) {
            return false;
        }
        double sign = along < 0 ? -1 : 1;
        nx = sign * ax / size;
        ny = sign * ay / size;
        nz = sign * az / size;
        return true;
    }

    /** Two unit vectors across the normal, and it. */
    private void makeFrame() {
        double sx;
        double sy;
        double sz;
        if (Math.abs(nx) < 0.6) {
            sx = 0;
            sy = nz;
            sz = -ny;
        } else {
            sx = -nz;
            sy = 0;
            sz = nx;
        }
        double size = Math.sqrt(sx * sx + sy * sy + sz * sz);
        frame[0] = sx / size;
        frame[1] = sy / size;
        frame[2] = sz / size;
        frame[3] = ny * frame[2] - nz * frame[1];
        frame[4] = nz * frame[0] - nx * frame[2];
        frame[5] = nx * frame[1] - ny * frame[0];
        frame[6] = nx;
        frame[7] = ny;
        frame[8] = nz;
    }
}
