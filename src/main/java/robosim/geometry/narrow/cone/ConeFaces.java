package robosim.geometry.narrow.cone;

import static robosim.geometry.exact.VectorMath.U;

import robosim.geometry.exact.DoubleDoubles;
import robosim.geometry.exact.VectorMath;

/** The distances of a polytope's faces for {@link ConePolytope}: in doubles whether a face has its plane's nearest point, else in pairs. */
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

    private final ConeCorners corners;

    /** The unit normal of a face, from the first and the second of its edges, whose product is the largest. */
    private double nx;

    private double ny;
    private double nz;
    private double largest;
    private int first;
    private int second;

    ConeFaces(ConeCorners corners) {
        this.corners = corners;
    }

    /**
     * The distance to a face's plane within the cone, if the nearest point is in the face; else +Infinity.
     *
     * @param extent the largest coordinate or size
     */
    double distance(Cone cone, int[] face, double extent) {
        clearNormal();
        // Neighbours may be degenerate, so the two edges with the largest product define the plane.
        for (int i = 0; i < face.length; i += 2) {
            for (int k = i + 2; k < face.length; k += 2) {
                tryPair(face, i, k, extent);
            }
        }
        return largest > 0 ? inPlane(cone, face) : Double.POSITIVE_INFINITY;
    }

    private void clearNormal() {
        largest = 0;
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
            double noise = 64 * U * extent * (VectorMath.length(ex, ey, ez) + VectorMath.length(fx, fy, fz));
            if (size > noise) {
                largest = size;
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

    private double inPlane(Cone cone, int[] face) {
        double height = height(face);
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
        if (!(rate > 0)) {
            return Double.POSITIVE_INFINITY;
        }
        double t = Math.abs(height) / rate;
        double share = isSquare ? 0 : cone.sin / aside;
        double x = isSquare ? sign * nx * t : t * (cone.cos * cone.ux + share * sx);
        double y = isSquare ? sign * ny * t : t * (cone.cos * cone.uy + share * sy);
        double z = isSquare ? sign * nz * t : t * (cone.cos * cone.uz + share * sz);
        return isInside(face, x, y, z) ? plane(cone, face, first, second, isSquare) : Double.POSITIVE_INFINITY;
    }

    private boolean isInside(int[] face, double x, double y, double z) {
        double[] v = corners.hi;
        boolean isLeft = true;
        boolean isRight = true;
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
            isLeft &= side >= 0;
            isRight &= side <= 0;
        }
        return isLeft || isRight;
    }

    /** The distance to the plane of two edges within the cone. */
    private double plane(Cone cone, int[] face, int first, int second, boolean isSquare) {
        DoubleDoubles p = cone.pairs;
        edge(p, EDGE, face[first], face[first + 1]);
        edge(p, OTHER, face[second], face[second + 1]);
        p.cross(NORMAL, EDGE, OTHER, TEMPORARY);
        corners.load(p, POINT, face[0]);
        p.dot(A, NORMAL, POINT, TEMPORARY); // height times the normal's length
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
    double near(Cone cone, int[] face, boolean isInside, double extent) {
        for (int k = 0; k < face.length; k += 2) {
            corners.take(face[k]);
        }
        clearNormal();
        // All but the pairs of parallel edges, which give nothing.
        tryPair(face, 0, 2, extent);
        tryPair(face, 0, 6, extent);
        tryPair(face, 2, 4, extent);
        tryPair(face, 4, 6, extent);
        return isInside ? plane(cone, face, first, second, isSquare(cone, face)) : inPlane(cone, face);
    }
}
