package robosim.geometry.narrow.cone;

import static robosim.geometry.exact.VectorMath.U;

import robosim.geometry.exact.DoubleDoubles;
import robosim.geometry.exact.FilterBound;
import robosim.geometry.exact.StageCounters;
import robosim.geometry.exact.VectorMath;

/**
 * The distances of a polytope's faces for {@link ConePolytope}: in doubles, and in exact numbers
 * where these leave it open, whether a face has its plane's nearest point; the distance itself in pairs.
 */
final class ConeFaces {
    // Where the pairs of doubles stand.
    private static final int A = ConePolytope.A;
    private static final int B = ConePolytope.B;
    private static final int C = ConePolytope.C;
    private static final int D = ConePolytope.D;
    private static final int EDGE = ConePolytope.EDGE;
    private static final int NORMAL = ConePolytope.NORMAL;
    private static final int OTHER = ConePolytope.OTHER;
    private static final int POINT = ConePolytope.POINT;
    private static final int TEMPORARY = ConePolytope.TEMPORARY;

    /**
     * Roundoff, in u = 2^-53 and of the distance R of the face's farthest point from the apex. A corner is off by u of R, an
     * edge e by 2u, so the product of e and f by 4u R (|e| + |f|), as |e| is at most 2 R, and 4u of itself: the unit normal
     * tilts by less than 8u R (|e| + |f|) / |e x f| and 8u. The height is off by as much of the distance of a corner, the slope
     * of the way to the plane by three times as much, each product of two vectors by 4u of their lengths.
     */
    private static final double TILT = FilterBound.bound(8 * U);

    /** The error of a height in pairs of doubles, as a share of its terms: some ten steps of 2^-102 to 2^-100. */
    private static final double PAIRS_ERROR = FilterBound.bound(0x1p-94);

    /** No corner of a face is farther from another than this many of the two edges that span it: an octagon has eight. */
    private static final double DIAMETER = 8;

    private static final int SURE = 2;

    private static final StageCounters.Counter EXACT = StageCounters.counter("ConeFaces");

    private final ConeCorners corners;

    /** The unit normal of a face, from the first and the second of its edges, whose product is the largest. */
    private double nx;

    private double ny;
    private double nz;
    private double largest;

    /** Whether two edges span something, but so little that their product may be all roundoff. */
    private boolean isThin;

    /** The length of the two edges together. */
    private double edges;

    /** At least the distance of the farthest corner from the apex. */
    private double reach;

    private int first;
    private int second;

    ConeFaces(ConeCorners corners) {
        this.corners = corners;
    }

    /**
     * The distance to a face's plane within the cone, if the nearest point is in the face; else +Infinity.
     *
     * @param extent the largest coordinate or size
     * @param best   the distance of all edges
     */
    double distance(Cone cone, int[] face, double extent, double best) {
        clearNormal();
        // Neighbours may be degenerate, so the two edges with the largest product define the plane.
        for (int i = 0; i < face.length; i += 2) {
            for (int k = i + 2; k < face.length; k += 2) {
                tryPair(face, i, k, extent);
            }
        }
        if (largest > 0) {
            return inPlane(cone, face, extent, best);
        }
        // Almost a segment.
        return isThin && !corners.isEnclosure() ? exactly(cone, face, extent) : Double.POSITIVE_INFINITY;
    }

    private void clearNormal() {
        largest = 0;
        isThin = false;
        first = 0;
        second = 2;
        nx = 0;
        ny = 0;
        nz = 0;
    }

    private void tryPair(int[] face, int i, int k, double extent) {
        double[] v = corners.hi;
        int a = 3 * face[i];
        int b = 3 * face[i + 1];
        int c = 3 * face[k];
        int d = 3 * face[k + 1];
        double ex = v[b] - v[a];
        double ey = v[b + 1] - v[a + 1];
        double ez = v[b + 2] - v[a + 2];
        double fx = v[d] - v[c];
        double fy = v[d + 1] - v[c + 1];
        double fz = v[d + 2] - v[c + 2];
        double x = ey * fz - ez * fy;
        double y = ez * fx - ex * fz;
        double z = ex * fy - ey * fx;
        double size = VectorMath.length(x, y, z);
        if (size > largest) {
            double both = VectorMath.length(ex, ey, ez) + VectorMath.length(fx, fy, fz);
            if (!(size > 64 * U * extent * both)) {
                isThin = true;
            } else {
                largest = size;
                edges = both;
                nx = x / size;
                ny = y / size;
                nz = z / size;
                first = i;
                second = k;
            }
        }
    }

    private double height(int[] face) {
        double[] v = corners.hi;
        int at = 3 * face[0];
        return nx * v[at] + ny * v[at + 1] + nz * v[at + 2];
    }

    /** Whether the axis leads into the plane so squarely that the plane's own nearest point is in the cone. */
    private boolean isSquare(Cone cone, int[] face) {
        double sign = height(face) < 0 ? -1 : 1;
        return sign * (nx * cone.ux + ny * cone.uy + nz * cone.uz) >= cone.cos;
    }

    private double inPlane(Cone cone, int[] face, double extent, double best) {
        double[] v = corners.hi;
        int at = 3 * face[0];
        double start = VectorMath.length(v[at], v[at + 1], v[at + 2]);
        reach = start + DIAMETER * edges;
        // An enclosure is larger than what it encloses by more than all that is in doubt here.
        double unit = corners.isEnclosure() ? 0 : TILT;
        double tilt = unit * reach * edges / largest;
        double rateError = 3 * tilt + 2 * unit;
        double pointError = reach * (tilt + 2 * unit);
        double height = height(face);
        double heightError = start * (tilt + unit);
        if (unit > 0 && !(Math.abs(height) > heightError)) {
            if (isElsewhere(cone, face, heightError, rateError, pointError)) {
                return Double.POSITIVE_INFINITY;
            }
            height = heightInPairs(cone, face, reach * edges * start);
            heightError = Math.abs(height) * (tilt + unit);
            if (height == 0) {
                return exactly(cone, face, extent);
            }
        }
        if (height == 0) {
            return Double.POSITIVE_INFINITY; // edge on: the edges decide
        }
        double sign = height < 0 ? -1 : 1;
        double ahead = sign * (nx * cone.ux + ny * cone.uy + nz * cone.uz);
        double sx = sign * nx - ahead * cone.ux;
        double sy = sign * ny - ahead * cone.uy;
        double sz = sign * nz - ahead * cone.uz;
        double aside = VectorMath.length(sx, sy, sz);
        boolean isSquare = ahead >= cone.cos;
        double rate = isSquare ? 1 : cone.cos * ahead + cone.sin * aside;
        if (!(rate > rateError)) {
            boolean isBeyond = rate < -rateError || Math.abs(height) > 2 * rateError * reach;
            return isBeyond ? Double.POSITIVE_INFINITY : exactly(cone, face, extent);
        }
        double t = Math.abs(height) / rate;
        double share = isSquare ? 0 : cone.sin / aside;
        double x = isSquare ? sign * nx * t : t * (cone.cos * cone.ux + share * sx);
        double y = isSquare ? sign * ny * t : t * (cone.cos * cone.uy + share * sy);
        double z = isSquare ? sign * nz * t : t * (cone.cos * cone.uz + share * sz);
        double off = (heightError + t * rateError) / rate + t * (1 + share) * rateError + pointError;
        int side = side(face, x, y, z, off, unit * (reach + t) * (reach + t));
        double found = side == -SURE ? Double.POSITIVE_INFINITY : plane(cone, face, isSquare);
        // Where it is no nearer than the edges, it does not matter whether it is in the face.
        if (Math.abs(side) < SURE && unit > 0 && found < best * (1 - 4 * U)) {
            return exactly(cone, face, extent);
        }
        return side > 0 ? found : Double.POSITIVE_INFINITY;
    }

    /**
     * Whether a face is certainly elsewhere than the nearest point of its plane in the cone, where the plane passes the apex so
     * closely that its side is open.
     */
    private boolean isElsewhere(Cone cone, int[] face, double heightError, double rateError, double pointError) {
        double ahead = Math.abs(nx * cone.ux + ny * cone.uy + nz * cone.uz);
        double aside = Math.sqrt(Math.max(0, (1 - ahead) * (1 + ahead)));
        double away = cone.sin * aside - cone.cos * ahead;
        double towards = cone.sin * aside + cone.cos * ahead;
        double least = away > 2 * rateError ? away : away < -2 * rateError ? towards : 0;
        double most = 2 * heightError / least + pointError;
        return side(face, 0, 0, 0, most, pointError * reach) == -SURE;
    }

    /** The height in pairs of doubles; 0 where they leave its sign open. */
    private double heightInPairs(Cone cone, int[] face, double size) {
        DoubleDoubles p = cone.pairs;
        normal(p, face);
        double height = p.get(A);
        return Math.abs(height) > PAIRS_ERROR * size ? height / largest : 0;
    }

    private double exactly(Cone cone, int[] face, double extent) {
        EXACT.count();
        return new ExactCone(cone, extent).face(corners, face, first, second);
    }

    /**
     * Whether a point of the plane is in the face: above 0 if it is, below if it is not; {@link #SURE} or minus that if this is
     * certain.
     *
     * @param off  the error of the point
     * @param more the error of its product with a side that does not go with the side's length
     */
    private int side(int[] face, double x, double y, double z, double off, double more) {
        double[] v = corners.hi;
        double least = Double.POSITIVE_INFINITY;
        double most = Double.NEGATIVE_INFINITY;
        boolean isLeft = false;
        boolean isRight = false;
        boolean isOpen = false;
        for (int i = 0; i < face.length; i += 2) {
            int a = 3 * face[i];
            int b = 3 * face[i + 1];
            if (!corners.isThere(face[i])) {
                continue;
            }
            double ex = v[b] - v[a];
            double ey = v[b + 1] - v[a + 1];
            double ez = v[b + 2] - v[a + 2];
            double qx = x - v[a];
            double qy = y - v[a + 1];
            double qz = z - v[a + 2];
            double side = nx * (ey * qz - ez * qy) + ny * (ez * qx - ex * qz) + nz * (ex * qy - ey * qx);
            double error = (Math.abs(ex) + Math.abs(ey) + Math.abs(ez)) * off + more;
            least = Math.min(least, side);
            most = Math.max(most, side);
            isLeft |= side > error;
            isRight |= side < -error;
            isOpen |= !(Math.abs(side) > error);
        }
        if (isLeft && isRight) {
            return -SURE;
        }
        int sign = least >= 0 || most <= 0 ? 1 : -1;
        return isOpen ? sign : sign * SURE;
    }

    /** The normal and the height, times the length of the normal. */
    private void normal(DoubleDoubles p, int[] face) {
        edge(p, EDGE, face[first], face[first + 1]);
        edge(p, OTHER, face[second], face[second + 1]);
        p.cross(NORMAL, EDGE, OTHER, TEMPORARY);
        corners.load(p, POINT, face[0]);
        p.dot(A, NORMAL, POINT, TEMPORARY);
    }

    /** The distance to the plane of two edges within the cone. */
    private double plane(Cone cone, int[] face, boolean isSquare) {
        DoubleDoubles p = cone.pairs;
        normal(p, face);
        p.dot(B, NORMAL, NORMAL, TEMPORARY);
        if (isSquare) {
            p.root(B, B);
        } else {
            p.dot(C, NORMAL, Cone.AXIS, TEMPORARY);
            p.multiply(D, C, C);
            p.subtract(B, B, D);
            p.root(B, B);
            p.multiply(B, B, Cone.SIN);
            p.multiply(C, C, Cone.COS);
            if (p.get(A) < 0) {
                p.subtract(B, B, C);
            } else {
                p.add(B, B, C);
            }
        }
        p.divide(A, A, B);
        double distance = Math.abs(p.get(A));
        return p.get(B) > 0 ? distance : Double.POSITIVE_INFINITY;
    }

    private void edge(DoubleDoubles p, int out, int from, int to) {
        corners.load(p, POINT, from);
        corners.load(p, out, to);
        p.subtractVector(out, out, POINT);
    }

    /**
     * The same as {@link #distance} of a box's face, none of whose sides is short.
     *
     * @param isInside whether the foot is known to be in the face
     */
    double near(Cone cone, int[] face, boolean isInside, double extent, double best) {
        for (int k = 0; k < face.length; k += 2) {
            corners.take(face[k]);
        }
        clearNormal();
        // All but the pairs of parallel edges, which give nothing.
        tryPair(face, 0, 2, extent);
        tryPair(face, 0, 6, extent);
        tryPair(face, 2, 4, extent);
        tryPair(face, 4, 6, extent);
        return isInside ? plane(cone, face, isSquare(cone, face)) : inPlane(cone, face, extent, best);
    }
}
