package robosim.geometry.narrow.gjk;

/**
 * Newton's method on the direction between the nearest points of two leaves, one of them a cylinder, where {@link Gjk} alone
 * comes closer by the same factor in each step only.
 *
 * <p>The points of a simplex show which corners the nearest features join: one, or the ends of an edge, or of a side. Along a
 * rim the point farthest in a direction d moves by {@code bend t (t.d')} as d turns by d', so the difference p(d) of the
 * two that are farthest is parallel to d, less a combination of the edges, at a d that solves a system of two unknowns.
 *
 * <p>Of leaves that overlap it finds the direction of least depth in the same way ({@link DepthSearch}).
 *
 * <p>A guess only: what it proposes is tried as any other direction, and the points it gives belong to the leaves.
 */
final class RimStep {
    /** Edges whose directions span a smaller sine, squared, are one edge. */
    private static final double PARALLEL = 0x1p-60;

    private final Support first;
    private final Support second;

    /** The direction proposed, of unit length. */
    double dx;

    double dy;
    double dz;

    /** The points in which the features are nearest, set by {@link #meet}. */
    final double[] onA = new double[3];

    final double[] onB = new double[3];

    private final int[] corners = new int[3];
    private final double[] base = new double[3];
    private final double[] edge = new double[3];
    private final double[] other = new double[3];
    int edges;

    /** Whether the direction proposed is near one where the reach is greatest, not least or neither. */
    boolean isMost;

    RimStep(Support first, Support second) {
        this.first = first;
        this.second = second;
    }

    /**
     * Proposes the next direction from a unit direction, in which both leaves' points were found last; false if these are not
     * at the simplex's corners, or if there is nothing to propose.
     */
    boolean propose(Simplex simplex, double nx, double ny, double nz) {
        int now = Simplex.corners(first, second);
        boolean isKnown = false;
        begin(now);
        for (int k = 0; k < simplex.count(); k++) {
            isKnown |= simplex.corners(k) == now;
            if (!addCorner(simplex.corners(k))) {
                return false;
            }
        }
        return isKnown && propose(nx, ny, nz);
    }

    /** Begins with the corners of the points found last; others that are as near follow by {@link #addCorner}. */
    void begin(int now) {
        corners[0] = now;
        edges = 0;
    }

    /** Adds a corner unless it is known; false if it is one too many. */
    boolean addCorner(int each) {
        for (int k = 0; k <= edges; k++) {
            if (each == corners[k]) {
                return true;
            }
        }
        if (edges == (first.isFlat() ? 1 : 2)) {
            return false;
        }
        corners[++edges] = each;
        return true;
    }

    /** Proposes the next direction from that in which the points were found, for the corners added. */
    boolean propose(double nx, double ny, double nz) {
        for (int axis = 0; axis < 3; axis++) {
            base[axis] = corner(corners[0], axis);
            edge[axis] = edges > 0 ? corner(corners[1], axis) - base[axis] : 0;
            other[axis] = edges > 1 ? corner(corners[2], axis) - base[axis] : 0;
        }
        return switch (edges) {
            case 0 -> free(nx, ny, nz);
            case 1 -> acrossEdge(nx, ny, nz);
            default -> acrossSide(nx, ny, nz);
        };
    }

    /** Proposes the axis of a cylinder that is nearly along the direction in which the points were found; false if it is not. */
    boolean proposeCap(boolean ofFirst, double nx, double ny, double nz) {
        Support leaf = ofFirst ? first : second;
        if (!leaf.isNearCap()) {
            return false;
        }
        double sign = leaf.axisX * nx + leaf.axisY * ny + leaf.axisZ * nz < 0 ? -1 : 1;
        return point(sign * leaf.axisX, sign * leaf.axisY, sign * leaf.axisZ);
    }

    /**
     * Finds the nearest points of two points or segments, or of a box and a point, and their direction; returns their distance,
     * +Infinity for other leaves. Points that belong to the leaves, which rounding may keep from being the nearest.
     */
    double meetAtOnce() {
        if (first.ends() > 0 && second.ends() > 0) {
            meetSegments();
        } else if (first.isBox() && second.ends() == 1) {
            meetBox(first, onA, second, onB);
        } else if (second.isBox() && first.ends() == 1) {
            meetBox(second, onB, first, onA);
        } else {
            return Double.POSITIVE_INFINITY;
        }
        double x = onA[0] - onB[0];
        double y = onA[1] - onB[1];
        double z = onA[2] - onB[2];
        double length = Math.sqrt(x * x + y * y + z * z);
        dx = x / length;
        dy = y / length;
        dz = z / length;
        return length;
    }

    private static void meetBox(Support box, double[] onBox, Support point, double[] on) {
        for (int axis = 0; axis < 3; axis++) {
            on[axis] = point.corner(0, axis);
        }
        box.approach(on[0], on[1], on[2]);
        onBox[0] = box.x;
        onBox[1] = box.y;
        onBox[2] = box.z;
    }

    /** By the two positions along the segments at which the derivatives of the distance are 0, or an end. */
    private void meetSegments() {
        int lastA = first.ends() - 1;
        int lastB = second.ends() - 1;
        double aa = 0;
        double ab = 0;
        double bb = 0;
        double aw = 0;
        double bw = 0;
        for (int axis = 0; axis < 3; axis++) {
            onA[axis] = first.corner(0, axis);
            onB[axis] = second.corner(0, axis);
            edge[axis] = first.corner(lastA, axis) - onA[axis];
            other[axis] = second.corner(lastB, axis) - onB[axis];
            double way = onA[axis] - onB[axis];
            aa += edge[axis] * edge[axis];
            ab += edge[axis] * other[axis];
            bb += other[axis] * other[axis];
            aw += edge[axis] * way;
            bw += other[axis] * way;
        }
        double s = share(ab * bw - aw * bb, aa * bb - ab * ab);
        double t = share(ab * s + bw, bb);
        s = share(ab * t - aw, aa);
        for (int axis = 0; axis < 3; axis++) {
            onA[axis] += s * edge[axis];
            onB[axis] += t * other[axis];
        }
    }

    private static double share(double part, double whole) {
        return part > 0 && whole > 0 ? Math.min(1, part / whole) : 0;
    }

    /** Whether the other leaf's point, found along a cylinder's axis, is above the cap. */
    boolean isAboveCap(boolean ofFirst) {
        Support leaf = ofFirst ? first : second;
        Support from = ofFirst ? second : first;
        return leaf.isOnCap(
                from.x - leaf.corner(leaf.corner, 0),
                from.y - leaf.corner(leaf.corner, 1),
                from.z - leaf.corner(leaf.corner, 2));
    }

    /** The same as {@link #meet} for a cap and the point of the other leaf that was found along its axis. */
    double meetCap(boolean ofFirst) {
        Support leaf = ofFirst ? first : second;
        Support other = ofFirst ? second : first;
        double[] on = ofFirst ? onA : onB;
        double[] from = ofFirst ? onB : onA;
        from[0] = other.x;
        from[1] = other.y;
        from[2] = other.z;
        double ox = other.x - leaf.corner(leaf.corner, 0);
        double oy = other.y - leaf.corner(leaf.corner, 1);
        double oz = other.z - leaf.corner(leaf.corner, 2);
        double height = ox * dx + oy * dy + oz * dz;
        on[0] = other.x - height * dx;
        on[1] = other.y - height * dy;
        on[2] = other.z - height * dz;
        return leaf.isOnCap(ox, oy, oz) ? Math.abs(height) : Double.POSITIVE_INFINITY;
    }

    private double corner(int both, int axis) {
        return first.corner(both >> 4, axis) - second.corner(both & 15, axis);
    }

    /** The difference of the points found, at the first corner. */
    private double found(int axis) {
        return switch (axis) {
            case 0 -> base[0] + (first.rimX - second.rimX);
            case 1 -> base[1] + (first.rimY - second.rimY);
            default -> base[2] + (first.rimZ - second.rimZ);
        };
    }

    /** Between two corners or rims: (reach I + the bends) d' = the part of p across d, in the plane across d. */
    private boolean free(double nx, double ny, double nz) {
        double px = found(0);
        double py = found(1);
        double pz = found(2);
        double reach = px * nx + py * ny + pz * nz;
        px -= reach * nx;
        py -= reach * ny;
        pz -= reach * nz;
        double a = first.bend();
        double b = second.bend();
        double ax = first.tangentX;
        double ay = first.tangentY;
        double az = first.tangentZ;
        double bx = second.tangentX;
        double by = second.tangentY;
        double bz = second.tangentZ;
        double bendA = a * (ax * ax + ay * ay + az * az);
        double bendB = b * (bx * bx + by * by + bz * bz);
        double spanned = nx * (ay * bz - az * by) + ny * (az * bx - ax * bz) + nz * (ax * by - ay * bx);
        double whole = reach * (reach + bendA + bendB) + a * b * spanned * spanned;
        double all = (reach + bendA + bendB) / whole;
        isMost = first.isFlat() ? all * whole > 0 : whole > 0 && all * whole + reach > 0;
        double alongA = a * (ax * px + ay * py + az * pz) / whole;
        double alongB = b * (bx * px + by * py + bz * pz) / whole;
        return point(
                nx + (all * px - alongA * ax - alongB * bx),
                ny + (all * py - alongA * ay - alongB * by),
                nz + (all * pz - alongA * az - alongB * bz));
    }

    /** The same across an edge, where d may turn about it only. */
    private boolean acrossEdge(double nx, double ny, double nz) {
        double square = edge[0] * edge[0] + edge[1] * edge[1] + edge[2] * edge[2];
        double slip = (nx * edge[0] + ny * edge[1] + nz * edge[2]) / square;
        if (!point(nx - slip * edge[0], ny - slip * edge[1], nz - slip * edge[2])) {
            return false;
        }
        double length = Math.sqrt(square);
        double ex = (dy * edge[2] - dz * edge[1]) / length;
        double ey = (dz * edge[0] - dx * edge[2]) / length;
        double ez = (dx * edge[1] - dy * edge[0]) / length;
        double px = found(0);
        double py = found(1);
        double pz = found(2);
        double reach = px * dx + py * dy + pz * dz;
        double a = first.bend() * (first.tangentX * ex + first.tangentY * ey + first.tangentZ * ez);
        double b = second.bend() * (second.tangentX * ex + second.tangentY * ey + second.tangentZ * ez);
        double whole = reach
                + a * (first.tangentX * ex + first.tangentY * ey + first.tangentZ * ez)
                + b * (second.tangentX * ex + second.tangentY * ey + second.tangentZ * ez);
        isMost = whole > 0 || first.isFlat();
        double fx = dx - nx;
        double fy = dy - ny;
        double fz = dz - nz;
        // The points were found for the direction before it was put across the edge.
        double moved = a * (first.tangentX * fx + first.tangentY * fy + first.tangentZ * fz)
                + b * (second.tangentX * fx + second.tangentY * fy + second.tangentZ * fz);
        double turn = (px * ex + py * ey + pz * ez - moved) / whole;
        return point(dx + turn * ex, dy + turn * ey, dz + turn * ez);
    }

    /** The same for a circle of directions, those across an edge of any length, on which all turn. */
    boolean proposeAround(double ex, double ey, double ez, double nx, double ny, double nz) {
        int now = Simplex.corners(first, second);
        for (int axis = 0; axis < 3; axis++) {
            base[axis] = corner(now, axis);
        }
        edge[0] = ex;
        edge[1] = ey;
        edge[2] = ez;
        return acrossEdge(nx, ny, nz);
    }

    private boolean acrossSide(double nx, double ny, double nz) {
        double cx = edge[1] * other[2] - edge[2] * other[1];
        double cy = edge[2] * other[0] - edge[0] * other[2];
        double cz = edge[0] * other[1] - edge[1] * other[0];
        double square = edge[0] * edge[0] + edge[1] * edge[1] + edge[2] * edge[2];
        double otherSquare = other[0] * other[0] + other[1] * other[1] + other[2] * other[2];
        if (!(cx * cx + cy * cy + cz * cz > PARALLEL * square * otherSquare)) {
            return false;
        }
        isMost = true;
        double sign = cx * nx + cy * ny + cz * nz < 0 ? -1 : 1;
        return point(sign * cx, sign * cy, sign * cz);
    }

    private boolean point(double x, double y, double z) {
        double length = Math.sqrt(x * x + y * y + z * z);
        dx = x / length;
        dy = y / length;
        dz = z / length;
        return length > 0 && length < Double.POSITIVE_INFINITY;
    }

    /**
     * Finds the nearest points of the features, after the points of both leaves were found in the direction proposed; returns
     * their distance, +Infinity if they are beyond an end of an edge.
     */
    double meet() {
        double px = found(0);
        double py = found(1);
        double pz = found(2);
        double u = 0;
        double v = 0;
        if (edges > 0) {
            double uu = edge[0] * edge[0] + edge[1] * edge[1] + edge[2] * edge[2];
            double up = -(edge[0] * px + edge[1] * py + edge[2] * pz);
            if (edges == 1) {
                u = up / uu;
            } else {
                double uv = edge[0] * other[0] + edge[1] * other[1] + edge[2] * other[2];
                double vv = other[0] * other[0] + other[1] * other[1] + other[2] * other[2];
                double vp = -(other[0] * px + other[1] * py + other[2] * pz);
                double whole = uu * vv - uv * uv;
                u = (up * vv - vp * uv) / whole;
                v = (vp * uu - up * uv) / whole;
            }
        }
        double rest = 1 - u - v;
        if (!(u >= 0 && v >= 0 && rest >= 0)) {
            return Double.POSITIVE_INFINITY;
        }
        double square = 0;
        for (int axis = 0; axis < 3; axis++) {
            onA[axis] = rest * first.corner(corners[0] >> 4, axis);
            onB[axis] = rest * second.corner(corners[0] & 15, axis);
            if (edges > 0) {
                onA[axis] += u * first.corner(corners[1] >> 4, axis);
                onB[axis] += u * second.corner(corners[1] & 15, axis);
            }
            if (edges > 1) {
                onA[axis] += v * first.corner(corners[2] >> 4, axis);
                onB[axis] += v * second.corner(corners[2] & 15, axis);
            }
        }
        onA[0] += first.rimX;
        onA[1] += first.rimY;
        onA[2] += first.rimZ;
        onB[0] += second.rimX;
        onB[1] += second.rimY;
        onB[2] += second.rimZ;
        for (int axis = 0; axis < 3; axis++) {
            square += (onA[axis] - onB[axis]) * (onA[axis] - onB[axis]);
        }
        return Math.sqrt(square);
    }
}
