package robosim.geometry.narrow.cone;

import robosim.geometry.exact.FilterBound;
import robosim.geometry.narrow.leaf.Leaf;

/**
 * Where a box is nearest within a cone, in plain doubles and in the box's own frame, with a proof of how near that is. It
 * tells which of the box's features {@link ConePolytope} has to compute: those near that point.
 *
 * <p>Let K be all points of box and cone, both taken larger by an error e. K is convex. For a vector n let k be its least
 * product with a point of the box, s its greatest with a unit vector of the cone, and {@code q = |n| / s}. Then no point of
 * K is nearer than {@code k / s - (2q + 1) e}. The plain solution p, a point of K, comes with an n for which k / s is its own
 * distance: its own direction where the cone holds the box's nearest point; the normal of a face whose plane is nearest within
 * the face; or, where the cone's border crosses an edge, p plus as much of the border's normal as makes it perpendicular to
 * the edge.
 *
 * <p>A convex set has only one nearest point p', and {@code |x|^2 >= |p'|^2 + |x - p'|^2} for all its points x. So with
 * {@code L = |p| - (2q + 2) e}, a bound of the nearest, p is within {@code sqrt(|p|^2 - L^2)} of p', and a point of K that is
 * {@link #apart} from p, by {@code sqrt(48 q e size)}, is more than 2e farther than p. What a feature's kernel answers is the
 * distance of a point of K, within e. So features that are apart from p do not matter.
 *
 * <p>The error e. A corner in pairs, rounded to doubles, is off by u of the size, the sum of all coordinates and sizes; the
 * own frame by some 2^-43 of it, where the columns are orthonormal within 2^-46. What an edge's kernel takes for a point in
 * the cone may have a depth of -48u of the size, which is at most 2^-41 of the size outside a cone with a sine of 2^-6:
 * together 2^-40. The normal of a face, from differences of corners, is off by 6u of the size over the least half size h, at
 * most 2^-50 size / h. It gives the foot, the nearest point of the plane in the cone, within 32 times that of the size over
 * the rate, the sine at which the cone's border meets the plane: 2^-45; and whether the foot is in the face within less:
 * together 2^-44.
 */
final class PlainConeBox {
    static final int UNSURE = 0;
    static final int BEYOND = 1;
    static final int FOUND = 2;

    private static final double ERROR = FilterBound.bound(0x1p-40);
    private static final double FACE_ERROR = FilterBound.bound(0x1p-44);

    /** How far columns may be from orthonormal, in each product of two. */
    private static final double ASKEW = 0x1p-46;

    /** The least sine and cosine of a cone. */
    private static final double LEAST_SINE = 0x1p-6;

    /** The least rate at which the border may meet a plane that the box has a face on. */
    private static final double LEAST_RATE = 0x1p-12;

    /** The least difference of the squared cosines of an edge and of the border. */
    private static final double LEAST_SLANT = 0x1p-7;

    /** How far a box must be from a plane to be beyond it for certain, as a share of the size. */
    private static final double CLEAR = FilterBound.bound(0x1p-30);

    /** The most places that are tried for such a plane. */
    private static final int STEPS = 6;

    /** The greatest q. */
    private static final double STEEPEST = 32;

    /** The box in its own frame, about the apex: low and high bounds by axis; and the cone's axis. */
    private final double[] low = new double[3];

    private final double[] high = new double[3];
    private final double[] u = new double[3];

    /** By axis, the sine of its angle to the cone's axis. */
    private final double[] aside = new double[3];

    private final double[] p = new double[3];
    private double cos;
    private double sin;
    private double size;
    private double error;
    private double most;
    private double q;
    private double apart;

    /** The distance of the solution. */
    private double least;

    /**
     * What is known of a box: {@link #BEYOND} where nothing of it is in the cone within the limit, {@link #FOUND} where the
     * rest can be asked.
     */
    int look(Cone cone, double[] row, int j, double limit) {
        if (!take(cone, row, j)) {
            return UNSURE;
        }
        most = limit;
        double square = 0;
        double ahead = 0;
        for (int i = 0; i < 3; i++) {
            double x = low[i] > 0 ? low[i] : high[i] < 0 ? high[i] : 0;
            p[i] = x;
            square += x * x;
            ahead += x * u[i];
        }
        double length = Math.sqrt(square);
        if (!(length > 0x1p-10 * size)) {
            return UNSURE;
        }
        if (isBeyond(length, 1)) {
            return BEYOND;
        }
        if (ahead >= cos * length) {
            return found(length, 1);
        }
        return onBorder();
    }

    private boolean take(Cone cone, double[] row, int j) {
        cos = cone.cos;
        sin = cone.sin;
        int r = j + Leaf.ROTATION;
        double x0 = row[r];
        double x1 = row[r + 3];
        double x2 = row[r + 6];
        double y0 = row[r + 1];
        double y1 = row[r + 4];
        double y2 = row[r + 7];
        double z0 = row[r + 2];
        double z1 = row[r + 5];
        double z2 = row[r + 8];
        if (!(isSmall(x0 * x0 + x1 * x1 + x2 * x2 - 1)
                && isSmall(y0 * y0 + y1 * y1 + y2 * y2 - 1)
                && isSmall(z0 * z0 + z1 * z1 + z2 * z2 - 1)
                && isSmall(x0 * y0 + x1 * y1 + x2 * y2)
                && isSmall(x0 * z0 + x1 * z1 + x2 * z2)
                && isSmall(y0 * z0 + y1 * z1 + y2 * z2))) {
            return false;
        }
        double mx = row[j] - cone.ox;
        double my = row[j + 1] - cone.oy;
        double mz = row[j + 2] - cone.oz;
        size = 0;
        put(0, mx * x0 + my * x1 + mz * x2, row[j + 3]);
        put(1, mx * y0 + my * y1 + mz * y2, row[j + 4]);
        put(2, mx * z0 + my * z1 + mz * z2, row[j + 5]);
        u[0] = cone.ux * x0 + cone.uy * x1 + cone.uz * x2;
        u[1] = cone.ux * y0 + cone.uy * y1 + cone.uz * y2;
        u[2] = cone.ux * z0 + cone.uy * z1 + cone.uz * z2;
        double thin = Math.min(row[j + 3], Math.min(row[j + 4], row[j + 5]));
        double rate = Math.min(turn(0), Math.min(turn(1), turn(2)));
        error = size * (ERROR + FACE_ERROR * size / (thin * rate));
        double place = Math.abs(cone.ox) + Math.abs(cone.oy) + Math.abs(cone.oz);
        return cos > LEAST_SINE
                && sin > LEAST_SINE
                && rate > LEAST_RATE
                && thin > 0x1p-20 * size
                && thin > 0x1p-40 * place
                && size > 0x1p-100
                && size < 0x1p100
                && error < 0x1p-20 * size;
    }

    private static boolean isSmall(double x) {
        return Math.abs(x) < ASKEW;
    }

    private void put(int i, double middle, double half) {
        low[i] = middle - half;
        high[i] = middle + half;
        size += Math.abs(middle) + half;
    }

    /** The rate of a plane across an axis from behind, or how far it is beyond reach. */
    private double turn(int i) {
        aside[i] = Math.sqrt(Math.max(0, (1 - u[i]) * (1 + u[i])));
        return Math.abs(cos * Math.abs(u[i]) - sin * aside[i]);
    }

    private boolean isBeyond(double distance, double itsQ) {
        return distance - 4 * (itsQ + 1) * error > most;
    }

    private int found(double distance, double itsQ) {
        if (isBeyond(distance, itsQ)) {
            return BEYOND;
        }
        least = distance;
        q = itsQ;
        apart = 48 * q * error * size;
        return FOUND;
    }

    /** The cone does not hold the box's nearest point, so its border has the nearest: in a face that is seen, or on an edge of it. */
    private int onBorder() {
        int last = -1;
        double farthest = 0;
        for (int i = 0; i < 3; i++) {
            double at = low[i] > 0 ? low[i] : high[i] < 0 ? high[i] : 0;
            if (at == 0) {
                continue;
            }
            double toward = at > 0 ? u[i] : -u[i];
            double rate = rate(toward, aside[i]);
            if (rate < 0) {
                return BEYOND;
            }
            double distance = Math.abs(at) / rate;
            if (isBeyond(distance, 1 / rate)) {
                return BEYOND;
            }
            if (isInFace(i, at, toward, distance)) {
                return 1 / rate <= STEEPEST ? found(distance, 1 / rate) : UNSURE;
            }
            if (distance > farthest) {
                farthest = distance;
                last = i;
            }
        }
        int found = onEdges(last);
        for (int i = 0; i < 3 && found == UNSURE; i++) {
            if (i != last && (low[i] > 0 || high[i] < 0)) {
                found = onEdges(i);
            }
        }
        return found == UNSURE && isAside() ? BEYOND : found;
    }

    /** The greatest product of a unit normal with a unit vector of the cone. */
    private double rate(double toward, double side) {
        return toward >= cos ? 1 : cos * toward + sin * side;
    }

    /** Computes the foot, the nearest point of a plane in the cone, and answers whether it is in the face. */
    private boolean isInFace(int i, double at, double toward, double distance) {
        double share = toward >= cos ? 0 : distance * (cos - sin * toward / aside[i]);
        boolean isIn = true;
        for (int k = 0; k < 3; k++) {
            double x = k == i ? at : share * u[k];
            p[k] = x;
            isIn &= k == i || (x >= low[k] && x <= high[k]);
        }
        return isIn;
    }

    /** Tries the edges of a face that is seen, between it and the foot. */
    private int onEdges(int i) {
        double at = low[i] > 0 ? low[i] : high[i];
        double toward = at > 0 ? u[i] : -u[i];
        isInFace(i, at, toward, Math.abs(at) / rate(toward, aside[i]));
        double footX = p[(i + 1) % 3];
        double footZ = p[(i + 2) % 3];
        int found = onEdge(i, (i + 1) % 3, (i + 2) % 3, at, footX);
        return found == UNSURE ? onEdge(i, (i + 2) % 3, (i + 1) % 3, at, footZ) : found;
    }

    /**
     * Where the border crosses the edge that is at one bound of the first axis, and at the one of the second that the foot is
     * beyond. With the share t along the third, {@code g + t u} ahead, and r from the apex to the edge's line: {@code g + t u =
     * cos sqrt(r^2 + t^2)}.
     */
    private int onEdge(int i, int j, int k, double at, double foot) {
        double bound = foot < low[j] ? low[j] : high[j];
        if (foot >= low[j] && foot <= high[j]) {
            return UNSURE;
        }
        double g = at * u[i] + bound * u[j];
        double r = at * at + bound * bound;
        double a = (cos - u[k]) * (cos + u[k]);
        double d = g * g - a * r;
        if (!(d > 0) || !(Math.abs(a) > LEAST_SLANT)) {
            return UNSURE;
        }
        double root = cos * Math.sqrt(d);
        // Of two roots ahead, the one nearer to the foot of the apex; of one ahead and one behind, the former.
        double way = a > 0 ? -g * u[k] : -u[k];
        double t = (g * u[k] + (way > 0 ? root : -root)) / a;
        if (!(t > low[k] && t < high[k])) {
            return UNSURE;
        }
        double length = Math.sqrt(r + t * t);
        double c = cos / length;
        // The border's normal, times the sine: x cos / |x| - u.
        double out = -t / (t * c - u[k]);
        double ni = at + out * (at * c - u[i]);
        double nj = bound + out * (bound * c - u[j]);
        double square = ni * ni + nj * nj;
        if (!(g + t * u[k] > 0 && out >= 0 && ni * at >= 0 && (bound == low[j] ? nj >= 0 : nj <= 0))
                || !(square <= STEEPEST * STEEPEST * length * length)) {
            return UNSURE;
        }
        p[i] = at;
        p[j] = bound;
        p[k] = t;
        return found(length, Math.sqrt(square) / length);
    }

    /**
     * Whether a plane that touches the cone has the box on its other side. The box is outside the cone by {@code cos |x - (x.u)
     * u| - sin x.u} at least, for a point x of it; this has the least value where it is to be sought, along one axis at a time.
     */
    private boolean isAside() {
        for (int k = 0; k < 3; k++) {
            p[k] = Math.max(low[k], Math.min(high[k], p[k]));
        }
        for (int step = 0; step < STEPS; step++) {
            double ahead = p[0] * u[0] + p[1] * u[1] + p[2] * u[2];
            double square = p[0] * p[0] + p[1] * p[1] + p[2] * p[2];
            double off = Math.sqrt(Math.max(0, square - ahead * ahead));
            if (!(cos * off > sin * ahead + CLEAR * size)) {
                return false;
            }
            // The gradient, and the normal of the plane that touches the cone beside the point.
            double c = cos / off;
            double out = sin + c * ahead;
            double beyond = 0;
            double farthest = 0;
            int axis = 0;
            for (int k = 0; k < 3; k++) {
                double w = c * p[k] - out * u[k];
                double end = w > 0 ? low[k] : high[k];
                beyond += w * end;
                double way = w * (p[k] - end);
                if (way > farthest) {
                    farthest = way;
                    axis = k;
                }
            }
            if (beyond > CLEAR * size) {
                return true;
            }
            p[axis] = outermost(axis, ahead - p[axis] * u[axis], square - p[axis] * p[axis]);
        }
        return false;
    }

    /**
     * Where a line along an axis is least outside the cone, within the bounds: past its place nearest to the cone's axis, with
     * g ahead at its own place nearest to the apex, and r the square of that distance.
     */
    private double outermost(int k, double g, double r) {
        double a = (cos - u[k]) * (cos + u[k]);
        double level = aside[k] * aside[k];
        if (!(a > 0 && level > 0)) {
            return u[k] > 0 ? high[k] : low[k];
        }
        double nearest = g * u[k] / level;
        double h = Math.sqrt(Math.max(0, r - g * g - nearest * g * u[k]) / (level * a));
        return Math.max(low[k], Math.min(high[k], nearest + h * sin * u[k]));
    }

    double least() {
        return least;
    }

    /** What the nearest of the features that are near must not exceed. */
    double atMost() {
        return least + 2 * error;
    }

    /** Whether the low (0) or the high (1) face across an axis is not apart from the solution. */
    boolean isNear(int axis, int side) {
        double gap = side == 0 ? p[axis] - low[axis] : high[axis] - p[axis];
        return gap * gap <= apart;
    }

    /** Whether the nearest point in the cone of the plane of such a face is not apart from the solution. */
    boolean isFootNear(int axis, int side) {
        double at = side == 0 ? low[axis] : high[axis];
        double toward = at > 0 ? u[axis] : -u[axis];
        double rate = rate(toward, aside[axis]);
        if (rate < 0) {
            return false;
        }
        double share = toward >= cos ? 0 : Math.abs(at) / rate * (cos - sin * toward / aside[axis]);
        double square = 0;
        for (int k = 0; k < 3; k++) {
            double gap = (k == axis ? at : share * u[k]) - p[k];
            square += gap * gap;
        }
        return square <= apart;
    }

    /** Whether the cone's axis is not apart from the solution. */
    boolean isAxisNear() {
        double ahead = p[0] * u[0] + p[1] * u[1] + p[2] * u[2];
        double x = p[0] - ahead * u[0];
        double y = p[1] - ahead * u[1];
        double z = p[2] - ahead * u[2];
        return x * x + y * y + z * z <= apart;
    }
}
