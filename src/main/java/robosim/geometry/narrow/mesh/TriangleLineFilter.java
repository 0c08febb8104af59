package robosim.geometry.narrow.mesh;

import robosim.geometry.exact.FilterBound;
import robosim.geometry.index.meshes.TriangleMesh;

/**
 * Rules out the triangles that a line certainly misses, or certainly meets farther away than another one; the others are
 * passed to the exact kernel, mostly one per line.
 *
 * <p>A corner is moved along the line onto the plane where the main coordinate of the line, the one that changes the most
 * along it, is 0; there the other two coordinates, relative to the line's, are {@code one + slope * main - line}, with
 * slopes of at most 1. The line misses the triangle if two of the areas that its corners, two at a time, span with the
 * line have opposite signs. An instance belongs to one owner of queries and allocates nothing.
 */
final class TriangleLineFilter {
    /**
     * The least area that is trusted. It is spanned by coordinates of some 2^-300, whose pad is above 2^-350, and what
     * underflows of its product with another coordinate adds less than 2^-470 to a distance.
     */
    private static final double UNDERFLOW = 0x1p-600;

    /** The coordinate that changes the most along the line (0 to 2), and the other two. */
    private int main;

    private int one;
    private int two;

    // The line in the own frame.
    private double slopeOne;
    private double slopeTwo;
    private double lineOne;
    private double lineTwo;
    private double lineMain;
    private double inverseMain;
    private double pad;

    /** Whether heights do not count. The line's way from above is then {@link #wayX} and {@link #wayZ}. */
    private boolean isFlat;

    private double wayX;
    private double wayZ;
    private double startAhead;
    private double startAside;

    private double leastDoubt;

    /** An upper bound of any triangle's {@link #doubt}. */
    private double mostDoubt;

    private double[] corners = {};
    private MeshRay.Judge judge = place -> Double.POSITIVE_INFINITY;

    // The nearest triangle so far that is certainly hit, between two bounds, and has not been passed to the exact
    // kernel.
    private int pending;
    private double pendingFrom;

    private double reach;

    /** Sets the triangles, where their hits go, and how far to look. */
    void open(TriangleMesh mesh, double limit, MeshRay.Judge to) {
        double[] of = mesh.leafCorners();
        if (corners != of) { // writing a reference is slow
            corners = of;
        }
        if (judge != to) {
            judge = to;
        }
        reach = limit;
        pending = -1;
    }

    /**
     * Sets the line, as {@link MeshRay} keeps it.
     *
     * @param error an upper bound of the error of any coordinate of the line or of a placed corner transformed to the own
     *     frame
     * @param size an upper bound of the distance of any point of the mesh from the start, on any axis
     */
    void aim(double[] line, double error, double size) {
        isFlat = false;
        main = longest(line[MeshRay.WAY], line[MeshRay.WAY + 1], line[MeshRay.WAY + 2]);
        one = (0b00_10_01 >> (2 * main)) & 3;
        two = (0b01_00_10 >> (2 * main)) & 3;
        pad = error;
        inverseMain = line[MeshRay.INVERSE + main];
        slopeOne = -line[MeshRay.WAY + one] * inverseMain;
        slopeTwo = -line[MeshRay.WAY + two] * inverseMain;
        lineMain = line[main];
        lineOne = line[one] + slopeOne * lineMain;
        lineTwo = line[two] + slopeTwo * lineMain;
        leastDoubt = 32 * pad * pad + UNDERFLOW;
        mostDoubt = doubt(12 * size);
    }

    /** Sets a line seen from above. */
    void aimInPlane(double[] line, double error) {
        isFlat = true;
        pad = error;
        wayX = line[MeshRay.WAY];
        wayZ = line[MeshRay.WAY + 2];
        startAhead = line[0] * wayX + line[2] * wayZ;
        startAside = line[2] * wayX - line[0] * wayZ;
    }

    /** The axis along which a direction goes the farthest, by integers, which are compared without branches. */
    private static int longest(double x, double y, double z) {
        long ofX = Double.doubleToRawLongBits(Math.abs(x));
        long ofY = Double.doubleToRawLongBits(Math.abs(y));
        long ofZ = Double.doubleToRawLongBits(Math.abs(z));
        long most = Math.max(ofX, Math.max(ofY, ofZ));
        return most == ofZ ? 2 : most == ofY ? 1 : 0;
    }

    /** How far to look from now on. */
    double reach() {
        return reach;
    }

    /** Tries the triangles from one position in the order of the leaves to another. */
    void sift(int first, int last) {
        if (isFlat) {
            siftInPlane(first, last);
            return;
        }
        for (int place = first; place <= last; place++) {
            tryTriangle(place);
        }
    }

    private static long bits(double value) {
        return Double.doubleToRawLongBits(value);
    }

    private void tryTriangle(int place) {
        double[] c = corners;
        int k = 9 * place;
        double az = c[k + main];
        double bz = c[k + 3 + main];
        double cz = c[k + 6 + main];
        double ax = c[k + one] + slopeOne * az - lineOne;
        double ay = c[k + two] + slopeTwo * az - lineTwo;
        double bx = c[k + 3 + one] + slopeOne * bz - lineOne;
        double by = c[k + 3 + two] + slopeTwo * bz - lineTwo;
        double cx = c[k + 6 + one] + slopeOne * cz - lineOne;
        double cy = c[k + 6 + two] + slopeTwo * cz - lineTwo;
        double u = bx * cy - by * cx;
        double v = cx * ay - cy * ax;
        double w = ax * by - ay * bx;
        double most = mostDoubt;
        long below = bits(u + most) | bits(v + most) | bits(w + most); // one is certainly below 0
        long above = bits(most - u) | bits(most - v) | bits(most - w);
        if ((below & above) < 0) {
            return;
        }
        double doubt = doubt(Math.abs(ax) + Math.abs(ay) + Math.abs(bx) + Math.abs(by) + Math.abs(cx) + Math.abs(cy));
        boolean isBelow = u < -doubt || v < -doubt || w < -doubt;
        boolean isAbove = u > doubt || v > doubt || w > doubt;
        if (isBelow && isAbove) {
            return;
        }
        boolean isMet = (u > doubt && v > doubt && w > doubt) || (u < -doubt && v < -doubt && w < -doubt);
        if (!isMet) {
            judge(place);
            return;
        }
        // The main coordinate of the hit is a mean of the corners', off by a pad, as the line's is, and by what the
        // doubt
        // makes of the weights, 4 doubts of the whole each; the inverse is at most 2.
        double whole = u + v + w;
        double distance = ((u * az + v * bz + w * cz) / whole - lineMain) * inverseMain;
        double spread = Math.abs(az - bz) + Math.abs(bz - cz) + Math.abs(cz - az);
        take(place, distance, FilterBound.bound(16 * pad + spread * (32 * doubt / Math.abs(whole))), distance);
    }

    private void siftInPlane(int first, int last) {
        for (int place = first; place <= last; place++) {
            tryProjection(place);
        }
    }

    /**
     * Tries the projection of a triangle: the line crosses it where it crosses the two sides at the corner that is on a side
     * of its own. Numbers are off by a pad.
     */
    private void tryProjection(int place) {
        double[] c = corners;
        int k = 9 * place;
        double a = aside(c[k], c[k + 2]);
        double b = aside(c[k + 3], c[k + 5]);
        double d = aside(c[k + 6], c[k + 8]);
        if (Math.min(a, Math.min(b, d)) > pad || Math.max(a, Math.max(b, d)) < -pad) {
            return;
        }
        double aheadA = ahead(c[k], c[k + 2]);
        double aheadB = ahead(c[k + 3], c[k + 5]);
        double aheadD = ahead(c[k + 6], c[k + 8]);
        if (Math.min(aheadA, Math.min(aheadB, aheadD)) - pad > reach
                || Math.max(aheadA, Math.max(aheadB, aheadD)) < -pad) {
            return;
        }
        double doubt = FilterBound.bound(2 * pad);
        if (!(Math.abs(a) > doubt && Math.abs(b) > doubt && Math.abs(d) > doubt)) {
            judge(place);
        } else if (a > 0 != b > 0 && a > 0 != d > 0) {
            cross(place, a, aheadA, b, aheadB, d, aheadD);
        } else if (b > 0 != d > 0) { // and so from the first corner too, as there are two sides
            if (a > 0 == d > 0) {
                cross(place, b, aheadB, a, aheadA, d, aheadD);
            } else {
                cross(place, d, aheadD, a, aheadA, b, aheadB);
            }
        }
    }

    private double ahead(double x, double z) {
        return x * wayX + z * wayZ - startAhead;
    }

    private double aside(double x, double z) {
        return z * wayX - x * wayZ - startAside;
    }

    /**
     * Takes a triangle of whose corners, given by how far they are aside and ahead, the first is on one side of the line and
     * the other two on the other. With distances aside of at least 2 pads, the share of a side at which it is crossed is off by
     * at most 2 pads of what the side goes across.
     */
    private void cross(int place, double a, double aheadA, double b, double aheadB, double d, double aheadD) {
        double acrossB = a - b;
        double acrossD = a - d;
        double alongB = (aheadB - aheadA) / acrossB;
        double alongD = (aheadD - aheadA) / acrossD;
        double atB = aheadA + alongB * a;
        double atD = aheadA + alongD * a;
        double error = FilterBound.bound(16 * pad + 4 * pad * (Math.abs(alongB) + Math.abs(alongD)));
        take(place, Math.min(atB, atD), error, Math.max(atB, atD));
    }

    /** Takes a triangle that the line certainly meets from one distance to another, both with an error. */
    private void take(int place, double distance, double error, double last) {
        if (distance - error > reach || last + error < 0) {
            return;
        }
        if (!(distance - error >= 0)) { // the line may start beyond it
            judge(place);
            return;
        }
        if (pending >= 0 && distance + error >= pendingFrom) {
            finish();
            judge(place);
            return;
        }
        pending = place;
        pendingFrom = distance - error;
        reach = Math.min(reach, distance + error);
    }

    private void judge(int place) {
        reach = Math.min(reach, judge.judge(place));
    }

    /** Passes on what has been kept back. */
    void finish() {
        if (pending >= 0) {
            judge(pending);
            pending = -1;
        }
    }

    /**
     * The error of the area spanned by two of a triangle's corners, given the sum of all six coordinates relative to the
     * line. Each of these is off by 4 pads at most: by one for the corner and one for the line, and, as slopes are at most 1,
     * by as much for their main coordinates; the roundings here are less than 16u of the sizes of which the pad is 128u and
     * uses 32u. The two products and their difference are off by 3u of a quarter of the sum's square. Areas below {@link
     * #UNDERFLOW} are not trusted at all.
     */
    private double doubt(double sum) {
        return FilterBound.bound(sum * (4 * pad + 0x1p-51 * sum) + leastDoubt);
    }
}
